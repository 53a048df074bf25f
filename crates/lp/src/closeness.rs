//! The distance of a claimed number from the true one, in proportion.

use boundfit_exact::Rational;

use crate::printed::Printed;

/// The verdict about the distance between a claimed number and the true one, from best to worst.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Closeness {
    /// Equal numbers.
    Exact,
    /// Numbers that differ by no more than rounding.
    Rounded(RoundedTo),
    /// Numbers that differ by at most the tolerance.
    WithinTolerance,
    /// Numbers that differ by more.
    Off,
}

/// The rounding that explains a difference.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum RoundedTo {
    /// The closeness of binary64 numbers: [`MOST_ULPS`] units in the last place or fewer.
    Binary64,
    /// Printing with so many significant digits: half a unit of the last one or less. 0 digits are those of a zero.
    Digits(usize),
}

/// The most units in the last place that still count as rounding.
pub const MOST_ULPS: i64 = 4;

/// The quantity that a tolerance is relative to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ToleranceUnit {
    /// The width of the true interval.
    Width,
    /// The size of the true number.
    Value,
    /// The smallest error bound that is not 0.
    Epsilon,
}

impl ToleranceUnit {
    /// The name in reports: an error is so much "of the width".
    pub fn name(self) -> &'static str {
        match self {
            ToleranceUnit::Width => "width",
            ToleranceUnit::Value => "value",
            ToleranceUnit::Epsilon => "eps",
        }
    }

    /// Returns the first of three units that exists and is not 0, with its size. The units are the width that a
    /// number belongs to, the size of the true number itself, and an error bound.
    pub fn choose(
        width: Option<Rational>,
        exact: &Rational,
        epsilon: Option<&Rational>,
    ) -> Option<(Self, Rational)> {
        let sizes = [
            (ToleranceUnit::Width, width),
            (ToleranceUnit::Value, Some(exact.abs())),
            (ToleranceUnit::Epsilon, epsilon.cloned()),
        ];
        sizes.into_iter().find_map(|(unit, size)| Some((unit, size.filter(Rational::is_positive)?)))
    }
}

/// The difference between a claimed number and the true one. Exact.
///
/// ```
/// use boundfit_exact::Rational;
/// use boundfit_lp::{Closeness, Difference, Printed, RoundedTo};
///
/// let (truth, width) = (Rational::ratio(1, 3), Rational::one());
/// let of = |printed: Printed| Difference::new(&printed, &truth, Some(&width), &Rational::scientific(1, -6)).closeness;
/// assert_eq!(of(Printed::typed("0.333", Rational::ratio(333, 1000))), Closeness::Rounded(RoundedTo::Digits(3)));
/// assert_eq!(of(Printed::exact(Rational::ratio(333, 1000))), Closeness::Off);
/// assert_eq!(of(Printed::exact(Rational::ratio(333_333_3, 10_000_000))), Closeness::WithinTolerance);
/// let double = Rational::from_f64(1.0 / 3.0).unwrap();
/// assert_eq!(of(Printed::exact(double)), Closeness::Rounded(RoundedTo::Binary64));
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Difference {
    /// The claimed number less the true one.
    pub by: Rational,
    /// The size in units in the last place of binary64 at the true number; `None` beyond the largest binary64.
    pub in_ulps: Option<Rational>,
    /// The size in the unit of the tolerance: the smallest tolerance that excuses it. `None` without such a unit.
    pub in_units: Option<Rational>,
    /// The verdict about the distance.
    pub closeness: Closeness,
}

impl Difference {
    /// Compares a claimed number with the true one. `unit` is what the tolerance is a multiple of; without one nothing but
    /// rounding is excused.
    pub fn new(claimed: &Printed, exact: &Rational, unit: Option<&Rational>, tolerance: &Rational) -> Self {
        let by = &claimed.value - exact;
        let size = by.abs();
        let in_ulps = ulp(exact).and_then(|ulp| size.checked_div(&ulp));
        let in_units = unit.and_then(|unit| size.checked_div(unit));
        // Binary64 has neither a truth nor a claim that is smaller than its smallest number: their difference is not its rounding.
        let is_double = in_ulps.as_ref().is_some_and(|ulps| *ulps <= Rational::from(MOST_ULPS))
            && !is_below_binary64(exact)
            && !is_below_binary64(&claimed.value);
        let closeness = match &claimed.precision {
            _ if by.is_zero() => Closeness::Exact,
            _ if is_double => Closeness::Rounded(RoundedTo::Binary64),
            Some(precision) if size <= precision.reach => {
                Closeness::Rounded(RoundedTo::Digits(precision.digits))
            }
            _ if in_units.as_ref().is_some_and(|units| units <= tolerance) => Closeness::WithinTolerance,
            _ => Closeness::Off,
        };
        Difference { by, in_ulps, in_units, closeness }
    }
}

/// Returns whether a number is not 0 and yet smaller than the smallest positive binary64 number. Exact.
pub fn is_below_binary64(value: &Rational) -> bool {
    let least = ulp(&Rational::zero());
    !value.is_zero() && least.is_some_and(|least| value.abs() < least)
}

/// Returns the unit in the last place of binary64 at a number: the distance of neighbouring binary64 numbers between
/// the powers of two around it. The upper power is excluded, subnormal numbers are included. `None` beyond the
/// largest binary64. Exact.
///
/// ```
/// # use boundfit_exact::Rational;
/// # use boundfit_lp::ulp;
/// assert_eq!(ulp(&Rational::one()), Rational::from_f64(f64::EPSILON));
/// assert_eq!(ulp(&Rational::zero()), Rational::from_f64(5e-324));
/// ```
pub fn ulp(value: &Rational) -> Option<Rational> {
    const MANTISSA_BITS: i64 = 52;
    const LEAST: i64 = -1022;
    let exponent = binary_exponent(value).map_or(LEAST, |exponent| exponent.max(LEAST));
    if exponent > 1023 {
        return None;
    }
    Some(power_of_two(exponent - MANTISSA_BITS))
}

/// `floor(log2 |value|)`; `None` for 0.
fn binary_exponent(value: &Rational) -> Option<i64> {
    if value.is_zero() {
        return None;
    }
    let value = value.abs();
    // The quotient of numbers of so many bits lies between 2^(guess - 1) and 2^(guess + 1).
    let bits = |bits: u64| i64::try_from(bits).unwrap_or(i64::MAX);
    let guess = bits(value.numerator().bits()).saturating_sub(bits(value.denominator().bits()));
    Some(if value < power_of_two(guess) { guess - 1 } else { guess })
}

fn power_of_two(exponent: i64) -> Rational {
    let power = Rational::from(boundfit_exact::Integer::power_of_two(exponent.unsigned_abs()));
    if exponent >= 0 { power } else { power.recip().unwrap_or_default() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn double(value: f64) -> Rational {
        Rational::from_f64(value).unwrap()
    }

    #[test]
    fn units_in_the_last_place_are_distances_of_doubles() {
        for value in [1.0, 1.5, 1.9999999999999998, 2.0, 0.1, 3e-300, 1e-310, 5e-324, 1e300, f64::MAX / 2.0] {
            let above = double(value.next_up()) - double(value);
            for sign in [1, -1] {
                assert_eq!(ulp(&(double(value) * Rational::from(sign))), Some(above.clone()), "{value}");
            }
        }
        // Between two doubles, and just below and above a power of two.
        assert_eq!(ulp(&Rational::ratio(1, 3)), Some(double(2f64.powi(-54))));
        assert_eq!(ulp(&(Rational::one() - Rational::scientific(1, -40))), Some(double(f64::EPSILON / 2.0)));
        assert_eq!(ulp(&(Rational::one() + Rational::scientific(1, -40))), Some(double(f64::EPSILON)));
        assert_eq!(ulp(&double(f64::MAX)), Some(double(2f64.powi(971))));
        assert_eq!(ulp(&(double(f64::MAX) * Rational::from(2))), None);
    }

    #[test]
    fn a_difference_is_named_by_the_best_that_explains_it() {
        let truth = Rational::one();
        let epsilon = double(f64::EPSILON);
        let tolerance = Rational::scientific(1, -6);
        let of = |by: Rational, reach: Option<Rational>| {
            let precision = reach.map(|reach| crate::Precision { digits: 7, reach });
            let claimed = Printed { value: &truth + by, precision };
            Difference::new(&claimed, &truth, Some(&Rational::from(2)), &tolerance).closeness
        };
        let small = Rational::scientific(1, -30);
        for sign in [1, -1].map(Rational::from) {
            assert_eq!(of(Rational::zero(), None), Closeness::Exact);
            let four = &epsilon * Rational::from(4);
            assert_eq!(of(&four * &sign, None), Closeness::Rounded(RoundedTo::Binary64));
            assert_eq!(of((&four + &small) * &sign, None), Closeness::WithinTolerance);
            let reach = || Some(Rational::scientific(5, -8));
            let printed = Closeness::Rounded(RoundedTo::Digits(7));
            assert_eq!(of(&four * &sign, reach()), Closeness::Rounded(RoundedTo::Binary64));
            assert_eq!(of(Rational::scientific(5, -8) * &sign, reach()), printed);
            assert_eq!(
                of((Rational::scientific(5, -8) + &small) * &sign, reach()),
                Closeness::WithinTolerance
            );
            assert_eq!(of(Rational::scientific(2, -6) * &sign, reach()), Closeness::WithinTolerance);
            assert_eq!(of((Rational::scientific(2, -6) + &small) * &sign, reach()), Closeness::Off);
        }
        // Without a unit nothing but rounding is excused.
        let claimed = Printed::exact(&truth + Rational::scientific(1, -12));
        let found = Difference::new(&claimed, &truth, None, &tolerance);
        assert_eq!((found.closeness, found.in_units), (Closeness::Off, None));
    }

    #[test]
    fn the_unit_of_the_tolerance_is_the_first_that_is_not_zero() {
        let [zero, two, three, four] = [0, 2, 3, 4].map(Rational::from);
        let choose = |width: Option<&Rational>, exact: &Rational, epsilon| {
            ToleranceUnit::choose(width.cloned(), exact, epsilon)
        };
        assert_eq!(choose(Some(&two), &three, Some(&four)), Some((ToleranceUnit::Width, two.clone())));
        for width in [None, Some(&zero)] {
            assert_eq!(choose(width, &-&three, Some(&four)), Some((ToleranceUnit::Value, three.clone())));
            assert_eq!(choose(width, &zero, Some(&four)), Some((ToleranceUnit::Epsilon, four.clone())));
            assert_eq!(choose(width, &zero, Some(&zero)), None);
            assert_eq!(choose(width, &zero, None), None);
        }
    }
}
