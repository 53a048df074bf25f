//! The one door between exact numbers and IEEE 754 binary64.

use std::cmp::Ordering;

use crate::{Fraction, Integer, Rational, plain_decimal};

/// Binary exponent of the smallest positive binary64.
pub(crate) const LEAST_EXPONENT: i64 = -1074;
/// Bits of a binary64 significand.
const SIGNIFICAND_BITS: i64 = 53;

/// Significand and exponent of a finite binary64: `significand * 2^exponent`, exactly. They mean nothing for an infinity or NaN.
#[inline]
pub fn significand_and_exponent(value: f64) -> (i64, i32) {
    let bits = value.to_bits();
    let fraction = (bits & ((1 << 52) - 1)) as i64;
    let biased = ((bits >> 52) & 0x7ff) as i32;
    let (significand, exponent) =
        if biased == 0 { (fraction, LEAST_EXPONENT as i32) } else { (fraction | (1 << 52), biased - 1075) };
    (if value.is_sign_negative() { -significand } else { significand }, exponent)
}

impl Rational {
    /// The exact value of a finite binary64, or `None` for an infinity or NaN.
    ///
    /// ```
    /// # use boundfit_exact::Rational;
    /// assert_eq!(Rational::from_f64(0.1).unwrap().to_string(), "3602879701896397/36028797018963968");
    /// ```
    pub fn from_f64(value: f64) -> Option<Self> {
        if !value.is_finite() {
            return None;
        }
        let (significand, exponent) = significand_and_exponent(value);
        Some(Rational::dyadic(significand, exponent))
    }

    /// The nearest binary64, ties to even, as IEEE 754 rounds: overflows to an infinity, underflows to 0.
    /// Correctly rounded in every case.
    pub fn to_f64(&self) -> f64 {
        self.nearest_f64().0
    }

    /// The binary64 of [`Rational::to_f64`] and how it compares with this number. Exact. Cost: one division of machine words for
    /// numbers of up to 63 bits, and for most others.
    pub fn nearest_f64(&self) -> (f64, Ordering) {
        let (numerator, denominator) = self.terms();
        nearest(numerator, denominator)
    }

    /// The largest binary64 that is not above this number; −∞ where every finite one is.
    ///
    /// A double is above the number when it is above this one. Exact.
    pub fn floor_to_f64(&self) -> f64 {
        floor(self.nearest_f64())
    }

    /// The least binary64 that is not below this number; ∞ where every finite one is. Exact.
    pub fn ceil_to_f64(&self) -> f64 {
        ceil(self.nearest_f64())
    }

    /// The least binary64 that is not below this error bound plus the distance of its estimate from [`Rational::to_f64`]. Around that
    /// double it covers what the error bound covers around the estimate. Exact.
    pub fn ceil_to_f64_beside(&self, estimate: &Self) -> f64 {
        let (double, side) = estimate.nearest_f64();
        if side.is_eq() || double.is_infinite() {
            return self.ceil_to_f64();
        }
        let (significand, exponent) = significand_and_exponent(double);
        let power = Integer::power_of_two(exponent.unsigned_abs().into());
        let ((error, below), (own, weight)) = (self.terms(), estimate.terms());
        let (double, one) = (Integer::from(significand), Integer::one());
        let (double, scale) = if exponent < 0 { (double, power) } else { (double * power, one) };
        // Over the product of all three denominators.
        let distance = (double * weight - own * &scale).abs();
        let sum = distance * below + error * weight * &scale;
        ceil(nearest(&sum, &(scale * weight * below)))
    }

    /// The number to within three roundings, several times faster than the nearest where numerator and denominator are words.
    #[inline]
    pub fn near_f64(&self) -> f64 {
        match self.to_words() {
            Some((numerator, denominator)) => numerator as f64 / denominator as f64,
            None => self.to_f64(),
        }
    }

    /// The number that [`Rational::to_f64`] gives, if it is a finite one.
    pub fn to_finite_f64(&self) -> Option<f64> {
        Some(self.to_f64()).filter(|double| double.is_finite())
    }
}

impl Fraction {
    /// The nearest binary64, as [`Rational::to_f64`] rounds, without a greatest common divisor.
    pub fn to_f64(&self) -> f64 {
        nearest(self.numerator(), self.denominator()).0
    }
}

/// The largest double that is not above the number to which this one is the nearest.
fn floor((nearest, side): (f64, Ordering)) -> f64 {
    if side.is_gt() { nearest.next_down() } else { nearest }
}

/// The least double that is not below the number to which this one is the nearest; never -0.0.
fn ceil((nearest, side): (f64, Ordering)) -> f64 {
    if side.is_lt() { nearest.next_up() } else { nearest + 0.0 }
}

/// The binary64 nearest to `mantissa · 10^exponent`, when that takes one division or multiplication of numbers that
/// binary64 has: up to 2^53 and 10^22. Correctly rounded (Clinger, *How to read floating point numbers accurately*,
/// 1990, section 3).
#[inline]
pub fn nearest_double(mantissa: i64, exponent: i32) -> Option<f64> {
    const POWERS: [f64; 23] = [
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17,
        1e18, 1e19, 1e20, 1e21, 1e22,
    ];
    let power = *POWERS.get(exponent.unsigned_abs() as usize)?;
    if mantissa.unsigned_abs() > 1 << SIGNIFICAND_BITS {
        return None;
    }
    Some(if exponent < 0 { mantissa as f64 / power } else { mantissa as f64 * power })
}

/// The binary64 nearest to a text that [`plain_decimal`] reads; `None` for other texts and beyond the largest binary64.
/// Correctly rounded.
pub fn plain_double(text: &[u8]) -> Option<f64> {
    let (mantissa, exponent) = plain_decimal(text)?;
    let parsed = || std::str::from_utf8(text.trim_ascii()).ok()?.parse().ok();
    nearest_double(mantissa, exponent).or_else(parsed).filter(|double: &f64| double.is_finite())
}

/// The nearest double of a quotient with a positive denominator, and how the double compares with the quotient.
fn nearest(numerator: &Integer, denominator: &Integer) -> (f64, Ordering) {
    let (magnitude, side) = nearest_of_words(numerator, denominator)
        .or_else(|| nearest_by_leading_bits(numerator, denominator))
        .unwrap_or_else(|| nearest_magnitude(&numerator.abs(), denominator));
    if numerator.is_negative() { (-magnitude, side.reverse()) } else { (magnitude, side) }
}

/// The nearest double of a quotient of words, without its sign; `None` for 0 and longer numbers.
#[inline]
fn nearest_of_words(numerator: &Integer, denominator: &Integer) -> Option<(f64, Ordering)> {
    let numerator = numerator.to_i64()?.unsigned_abs();
    let denominator = denominator.to_i64()?.unsigned_abs();
    if numerator == 0 {
        return None;
    }
    // The quotient of the shifted ones has 55 or 56 bits. So what is cut off is less than a quarter of a double's last bit.
    let shift = 55 + numerator.leading_zeros() as i32 - denominator.leading_zeros() as i32;
    let (above, below) = (u128::from(numerator), u128::from(denominator));
    let (above, below) = if shift < 0 { (above, below << -shift) } else { (above << shift, below) };
    let quotient = above / below;
    let (quotient, is_exact) = (quotient as u64, quotient * below == above);
    let significand = (quotient | u64::from(!is_exact)) as f64;
    let side = match (significand as u64).cmp(&quotient) {
        Ordering::Equal if !is_exact => Ordering::Less,
        side => side,
    };
    // From 2^-63 to 2^63: this multiplication does not round.
    Some((significand * power_of_two(-i64::from(shift)), side))
}

fn nearest_magnitude(numerator: &Integer, denominator: &Integer) -> (f64, Ordering) {
    if numerator.is_zero() {
        return (0.0, Ordering::Equal);
    }
    // The leading bit of the quotient weighs 2^leading or 2^(leading - 1).
    let leading = numerator.bits() as i64 - denominator.bits() as i64;
    let mut exponent = (leading - SIGNIFICAND_BITS).max(LEAST_EXPONENT);
    let (mut significand, mut side) = rounded_quotient(numerator, denominator, exponent);
    if significand >= 1 << SIGNIFICAND_BITS {
        // One bit too many: round again from the exact quotient, not from the rounded one.
        exponent += 1;
        (significand, side) = rounded_quotient(numerator, denominator, exponent);
    }
    if exponent > 1023 {
        return (f64::INFINITY, Ordering::Greater);
    }
    // Both factors are binary64 numbers and so is their product: this multiplication does not round. A significand of 2^53 at the
    // largest exponent makes an infinity.
    let double = significand as f64 * power_of_two(exponent);
    (double, if double.is_infinite() { Ordering::Greater } else { side })
}

/// The nearest binary64 to a quotient of numbers, without its sign, where their leading bits decide; `None` for 0, for others, and for
/// quotients near the ends of the range.
///
/// The leading 126 and 62 bits say that the numerator is from n to n + 1 and the denominator from d to d + 1. Their quotient is then
/// from n/(d + 1) to (n + 1)/d. Both ends decide if they have one nearest significand on one side of it; a tie is left to others.
fn nearest_by_leading_bits(numerator: &Integer, denominator: &Integer) -> Option<(f64, Ordering)> {
    let (above, dropped) = leading_bits(numerator, 126)?;
    let (below, dropped_below) = leading_bits(denominator, 62)?;
    let [least, most] = [above / (below + 1), (above + 1) / below + 1];
    let left = (u128::BITS - least.leading_zeros()).checked_sub(SIGNIFICAND_BITS as u32)?;
    let half = 1 << left >> 1;
    let (significand, same) = ((least + half) >> left, (most + half) >> left);
    let rounded = significand << left;
    let is_open =
        significand != same || (least + half) & ((1 << left) - 1) == 0 || (least..=most).contains(&rounded);
    let exponent = dropped - dropped_below + i64::from(left);
    // A significand of 54 bits, 2^53, is among those that may be too large.
    (!is_open && (LEAST_EXPONENT..=970).contains(&exponent))
        .then(|| (significand as f64 * power_of_two(exponent), rounded.cmp(&least)))
}

/// The first bits of a number without its sign, that many, and how many it has after them, which is negative where zeros are added;
/// `None` for 0.
fn leading_bits(number: &Integer, bits: u32) -> Option<(u128, i64)> {
    let dropped = number.bits() as i64 - i64::from(bits);
    let leading = number.leading(dropped.max(0) as u64).filter(|leading| *leading > 0)?;
    Some((leading << dropped.min(0).unsigned_abs(), dropped))
}

/// `numerator / (denominator * 2^exponent)` to the nearest integer, ties to even, and how that compares with the quotient; below 2^55 by
/// the choice of the exponent.
fn rounded_quotient(numerator: &Integer, denominator: &Integer, exponent: i64) -> (u64, Ordering) {
    let power = Integer::power_of_two(exponent.unsigned_abs());
    let (scaled_numerator, scaled_denominator) = if exponent >= 0 {
        (numerator.clone(), denominator * &power)
    } else {
        (numerator * &power, denominator.clone())
    };
    let (quotient, remainder) = scaled_numerator.div_rem_floor(&scaled_denominator);
    let odd = !quotient.is_even();
    let twice = &remainder + &remainder;
    let up = twice > scaled_denominator || (twice == scaled_denominator && odd);
    let side = if up { Ordering::Greater } else { Integer::zero().cmp(&remainder) };
    (quotient.to_u64().map_or(u64::MAX, |floor| floor + u64::from(up)), side)
}

/// 2 to a power from -1074 to 1023.
pub(crate) fn power_of_two(exponent: i64) -> f64 {
    if exponent >= -1022 {
        f64::from_bits(((exponent + 1023) as u64) << 52)
    } else {
        f64::from_bits(1 << (exponent - LEAST_EXPONENT))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Limits, Reading};

    fn exact(text: &str) -> Rational {
        Reading::Decimal.read(text, &Limits::default()).unwrap()
    }

    /// A small generator is enough here: digits, sign and exponent from one multiplicative sequence.
    fn states(mut state: u64) -> impl FnMut() -> u64 {
        move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            state
        }
    }

    #[test]
    fn agrees_with_the_standard_library_on_decimal_text() {
        let mut states = states(0x9e37_79b9_7f4a_7c15);
        for _ in 0..20_000 {
            let state = states();
            let digits = state >> (state % 60);
            let exponent = (state >> 40) as i64 % 700 - 350;
            let text = format!("{}{digits}e{exponent}", if state & 1 == 0 { "-" } else { "" });
            assert_eq!(exact(&text).to_f64(), text.parse::<f64>().unwrap(), "{text}");
        }
    }

    #[test]
    fn long_numbers_are_rounded_as_their_text_is() {
        let mut states = states(0x1234_5678_9abc_def1);
        let mut word = || states() >> 33;
        for _ in 0..20_000 {
            let digits: String = (0..1 + word() % 60).map(|_| (b'1' + (word() % 9) as u8) as char).collect();
            let text = format!("{digits}e{}", word() as i64 % 700 - 380);
            assert_eq!(exact(&text).to_f64(), text.parse::<f64>().unwrap(), "{text}");
        }
        // Ties, and what is just beside them, over long denominators.
        for shift in [0, 1, 7] {
            for (odd, apart) in (0..200).map(|k| (2 * k + 1, k % 5 - 2)) {
                let tie = Rational::from((1_i128 << 53) + odd) * exact("1e-90");
                let near = tie * exact("1e90") + Rational::from(apart) * exact(&format!("1e-{}", 60 + shift));
                let rounded = Rational::from_f64(near.to_f64()).unwrap();
                let even = Rational::from((1_i128 << 53) + odd / 2 * 2 + if odd % 4 == 3 { 2 } else { 0 });
                let nearest = match apart {
                    0 => even,
                    apart => Rational::from((1_i128 << 53) + odd + if apart < 0 { -1 } else { 1 }),
                };
                assert_eq!(rounded, nearest, "{odd} {apart}");
            }
        }
    }

    #[test]
    fn plain_doubles_are_the_nearest() {
        let mut states = states(0x2545_f491_4f6c_dd1d);
        for _ in 0..20_000 {
            let state = states();
            let digits = (state >> 1) >> (state % 60);
            let exponent = (state >> 40) as i64 % [50, 700][(state >> 33) as usize % 2] - 25;
            let text = format!("{digits}e{exponent}");
            let nearest = exact(&text).to_f64();
            assert_eq!(
                plain_double(text.as_bytes()),
                Some(nearest).filter(|_| nearest.is_finite()),
                "{text}"
            );
        }
        assert_eq!(plain_double(b"1e400"), None);
        assert_eq!(plain_double(b"1/3"), None);
    }

    #[test]
    fn one_operation_reads_up_to_2_to_the_53_and_10_to_the_22() {
        let most = 1_i64 << 53;
        for (mantissa, exponent, double) in [
            (most, 0, Some(9_007_199_254_740_992.0)),
            (-most, 22, Some(-9_007_199_254_740_992e22)),
            (1, -22, Some(1e-22)),
            (3, -1, Some(0.3)),
            (7, 0, Some(7.0)),
            (most + 1, 0, None),
            (-most - 1, 0, None),
            (1, 23, None),
            (1, -23, None),
        ] {
            assert_eq!(nearest_double(mantissa, exponent), double, "{mantissa}e{exponent}");
        }
    }

    #[test]
    fn edges_of_the_format() {
        for text in [
            "0",
            "1",
            "0.1",
            "5e-324",
            "2.4703282292062328e-324",
            "2.4703282292062327e-324",
            "1e-400",
            "2.2250738585072011e-308",
            "2.2250738585072014e-308",
            "1.7976931348623157e308",
            "1.7976931348623158e308",
            "1.797693134862315808e308",
            "1e400",
            "-1e400",
            "9007199254740993",
            "9007199254740992.9999",
            "9007199254740995",
            "18014398509481989",
            "18014398509481990",
            "0.500000000000000166533453693773481063544750213623046875",
        ] {
            assert_eq!(exact(text).to_f64(), text.parse::<f64>().unwrap(), "{text}");
        }
        assert_eq!(Rational::ratio(1, 3).to_f64(), 1.0 / 3.0);
    }

    #[test]
    fn a_double_is_above_a_number_when_it_is_above_its_floor() {
        for text in [
            "0",
            "1",
            "0.1",
            "-0.1",
            "0.3",
            "1e-400",
            "-1e-400",
            "1e400",
            "-1e400",
            "1/3",
            "-1/3",
            "-5e-324",
            "9007199254740993",
            "-9007199254740993",
            "1.7976931348623158e308",
            "-1.7976931348623159e308",
        ] {
            let number = exact(text);
            let floor = number.floor_to_f64();
            let is_above = |double: f64| Rational::from_f64(double).is_some_and(|double| double > number);
            assert!(!is_above(floor), "{text}");
            assert!(floor.next_up() == f64::INFINITY || is_above(floor.next_up()), "{text}");
            assert_eq!(number.ceil_to_f64(), -(-&number).floor_to_f64(), "{text}");
        }
        assert_eq!(exact("1e400").floor_to_f64(), f64::MAX);
        assert_eq!(exact("-1e400").floor_to_f64(), f64::NEG_INFINITY);
        assert_eq!(exact("-1e-400").floor_to_f64(), -f64::from_bits(1));
    }

    #[test]
    fn the_side_of_the_nearest_double_is_that_of_the_exact_one() {
        let mut states = states(0x1234_5678_9abc_def1);
        let mut word = || states() >> 1;
        // Lengths are those at which another algorithm takes over, too, and doubles and ties are among the numbers.
        let mut number = || {
            let bits = |word: u64| Integer::from(word | 1) * Integer::power_of_two(word % 3 * (word % 40));
            let (above, below) = (bits(word()), bits(word()));
            let (above, below) =
                (above * Integer::from(word() >> (word() % 63)), bits(word() >> (word() % 63)) * below);
            let short = [Rational::ratio(1, 1), Rational::ratio(3, 1 << 60)];
            let long = Rational::new(above, below).unwrap();
            match word() % 5 {
                0 => {
                    Rational::ratio(word() as i64 >> (word() % 63), 1 + (word() as i64 >> (word() % 63)) / 2)
                }
                1 => Rational::from((word() >> (word() % 63)) as i64) * &short[(word() % 2) as usize],
                2 => long * Rational::scientific(1, word() as i64 % 600 - 300),
                3 => -long,
                _ => long,
            }
        };
        for _ in 0..20_000 {
            let (value, error) = (number(), number().abs());
            let (double, side) = value.nearest_f64();
            let Some(exact) = Rational::from_f64(double) else {
                assert_eq!(side, if value.is_positive() { Ordering::Greater } else { Ordering::Less });
                continue;
            };
            assert_eq!(side, exact.cmp(&value), "{value}");
            let half =
                |beside: f64| (Rational::from_f64(beside).unwrap() - &exact).abs() * Rational::ratio(1, 2);
            assert!(
                (&exact - &value).abs() <= half(double.next_up()).max(half(double.next_down())),
                "{value}"
            );
            assert_eq!(
                error.ceil_to_f64_beside(&value),
                (&error + (&exact - &value).abs()).ceil_to_f64(),
                "{error} {value}"
            );
        }
        let huge = exact("1e400");
        assert_eq!(Rational::ratio(1, 3).ceil_to_f64_beside(&huge), Rational::ratio(1, 3).ceil_to_f64());
    }

    #[test]
    fn every_finite_double_survives_the_round_trip() {
        for value in [0.0, 0.1, -2.5, f64::MAX, f64::MIN_POSITIVE, 5e-324, 1.0 + f64::EPSILON, 1e300, -1e-300]
        {
            assert_eq!(Rational::from_f64(value).unwrap().to_f64(), value);
        }
        assert_eq!(Rational::from_f64(f64::NAN), None);
        assert_eq!(Rational::from_f64(f64::NEG_INFINITY), None);
    }
}
