//! Tests of fractions.

use super::super::library::{BigInt, BigRational};
use super::*;

#[test]
fn lowest_terms_with_positive_denominator() {
    let number = Rational::new(Integer::from(6), Integer::from(-4)).unwrap();
    assert_eq!(number.to_string(), "-3/2");
    assert_eq!(number.denominator(), Integer::from(2));
    assert_eq!(Rational::new(Integer::one(), Integer::zero()), None);
    assert_eq!(Rational::ratio(8, 4).to_string(), "2");
    assert_eq!(format!("{number:>6}|{number:06}|{:+}", number.abs()), "  -3/2|-003/2|+3/2");
}

#[test]
fn quotients_times_powers_of_ten_are_in_lowest_terms() {
    for numerator in [0_i128, 1, -75, 640, 10_i128.pow(30), -(1 << 100)] {
        for denominator in [1_i128, -3, 8, 125, 6_000, 7 * 10_i128.pow(25)] {
            for exponent in [-40, -3, -1, 0, 2, 17, 45] {
                let number = Rational::scaled_quotient(numerator.into(), denominator.into(), exponent);
                let quotient = Rational::new(numerator.into(), denominator.into()).unwrap();
                assert_eq!(number, Some(quotient * Rational::scientific(1, exponent)));
            }
        }
    }
    assert_eq!(Rational::scaled_quotient(Integer::one(), Integer::zero(), 3), None);
}

#[test]
fn decimals_are_in_lowest_terms() {
    let mantissas = [0, 1, -1, 5, 10, -25, 64, 1000, 12_345, 1 << 62, i64::MAX, i64::MIN, -10_i64.pow(18)];
    for mantissa in mantissas {
        for places in 0..=18 {
            let expected = Rational::new(mantissa.into(), Integer::power_of_ten(places)).unwrap();
            assert_eq!(Rational::of_decimal(mantissa, places), expected, "{mantissa}e-{places}");
        }
    }
    let longer = [i128::MAX, i128::MIN, -(1 << 100), 10_i128.pow(38), -3 * 5_i128.pow(54), 7 << 70];
    for mantissa in mantissas.map(i128::from).into_iter().chain(longer) {
        for places in 0..=38 {
            let expected = Rational::new(mantissa.into(), Integer::power_of_ten(places)).unwrap();
            assert_eq!(Rational::of_long_decimal(mantissa, places), expected, "{mantissa}e-{places}");
        }
    }
}

#[test]
fn arithmetic_is_exact() {
    let (a, b) = (Rational::ratio(1, 10), Rational::ratio(2, 10));
    assert_eq!(&a + &b, Rational::ratio(3, 10));
    assert_eq!(&a - &b, Rational::ratio(-1, 10));
    assert_eq!(&a * &b, Rational::ratio(1, 50));
    assert_eq!(a.checked_div(&b), Some(Rational::ratio(1, 2)));
    assert_eq!(a.checked_div(&Rational::zero()), None);
    assert_eq!(b.half(), a);
    assert_eq!((-&a).sign(), Sign::Negative);
}

/// The library's operators are the reference, for terms on both sides of 63 and of 127 bits.
#[test]
fn all_sizes_agree_with_the_library() {
    let edges = [0, 1, -1, 2, -6, 97, i64::MAX.into(), i64::MIN.into(), i128::from(i64::MAX) + 1, 1 << 62]
        .into_iter()
        .chain([-(1 << 40), 1 << 100, i128::MAX, i128::MIN, i128::MAX - 1, i128::MIN + 1])
        .map(BigInt::from)
        .chain([BigInt::from(i128::MAX) + 1, BigInt::from(i128::MIN) - 1, BigInt::from(3) << 200]);
    let numerators: Vec<BigInt> = edges.collect();
    let denominators = [1, 2, 6, 1_000_000_007, i128::from(i64::MAX), i128::MAX - 1].map(BigInt::from);
    let numbers: Vec<BigRational> = numerators
        .iter()
        .flat_map(|n| denominators.iter().map(|d| BigRational::new(n.clone(), d.clone())))
        .collect();
    let own: Vec<Rational> = numbers.iter().cloned().map(Rational::from).collect();
    for (left, own_left) in numbers.iter().zip(&own) {
        assert_eq!(own_left.to_string(), left.to_string());
        assert_eq!(BigRational::from(&own_left.half()), left / BigInt::from(2));
        assert_eq!(BigRational::from(&-own_left), -left);
        assert!(!own_left.abs().is_negative());
        for (right, own_right) in numbers.iter().zip(&own) {
            assert_eq!(own_left + own_right, Rational::from(left + right));
            assert_eq!(own_left - own_right, Rational::from(left - right));
            let both = (own_left + own_right, own_left - own_right);
            assert_eq!(own_left.sum_and_difference(own_right), both);
            assert_eq!(own_left * own_right, Rational::from(left * right));
            assert_eq!(own_left.cmp(own_right), left.cmp(right));
            assert_eq!(own_left == own_right, left == right);
            let quotient = own_left.checked_div(own_right);
            let expected = (!own_right.is_zero()).then(|| Rational::from(left / right));
            assert_eq!(quotient, expected);
        }
    }
}

#[test]
fn integers_of_all_sizes_agree_with_the_library() {
    use super::super::library::DivisionAndGcd as _;
    let edges: Vec<BigInt> = [0, 1, -1, 2, -3, 12, i64::MAX.into(), i64::MIN.into(), 1 << 64, -(1 << 90)]
        .into_iter()
        .chain([i128::MAX, i128::MIN, i128::MIN + 1])
        .map(BigInt::from)
        .chain([BigInt::from(i128::MAX) + 1, BigInt::from(i128::MIN) - 1, BigInt::from(6) << 150])
        .collect();
    for left in &edges {
        let own_left = Integer::from(left.clone());
        assert_eq!(own_left.bits(), left.bits());
        assert_eq!(own_left.is_even(), left.is_even());
        assert_eq!(own_left.to_string(), left.to_string());
        let digits = left.magnitude().to_string();
        assert_eq!(Integer::from_ascii_digits(digits.as_bytes()), Some(own_left.abs()));
        for right in &edges {
            let own_right = Integer::from(right.clone());
            let of = |value: BigInt| Integer::from(value);
            assert_eq!(&own_left + &own_right, of(left + right));
            assert_eq!(&own_left - &own_right, of(left - right));
            assert_eq!(&own_left * &own_right, of(left * right));
            assert_eq!(own_left.cmp(&own_right), left.cmp(right));
            assert_eq!(own_left.gcd(&own_right), of(left.gcd(right)));
            assert_eq!(own_left.lcm(&own_right), of(left.lcm(right)));
            if !own_right.is_zero() {
                let (quotient, remainder) = left.div_mod_floor(right);
                let is_divisor = remainder == BigInt::from(0);
                assert_eq!(own_left.div_rem_floor(&own_right), (of(quotient.clone()), of(remainder)));
                if is_divisor {
                    assert_eq!(own_left.quotient(&own_right), of(quotient));
                }
            }
        }
    }
}

#[test]
fn floor_division_follows_the_divisor() {
    let (quotient, remainder) = Integer::from(-7).div_rem_floor(&Integer::from(2));
    assert_eq!((quotient, remainder), (Integer::from(-4), Integer::from(1)));
}

#[test]
fn integers_and_words_are_the_same_number() {
    for value in [0, 7, -7, i64::MAX] {
        assert_eq!(Rational::from(&Integer::from(value)), Rational::ratio(value, 1));
        assert_eq!(Rational::from(value).to_words(), Some((value, 1)));
    }
    assert_eq!(Rational::ratio(-3, 4).to_words(), Some((-3, 4)));
    assert_eq!(Rational::from(&Integer::power_of_two(70)).to_words(), None);
}

#[test]
fn fractions_of_all_lengths_are_written_like_those_of_the_library() {
    let (nines, one) = (10_u64.pow(19) - 1, 1);
    for above in [0, one, nines, nines + 1, u64::MAX] {
        let mut numerator = Integer::from(above);
        let mut denominator = Integer::one();
        // Up to 448 bits, with words of zeros between others, and chunks of nineteen digits that begin with zeros.
        for word in [0, one, 0, nines, u64::MAX, 0, one] {
            numerator = numerator * Integer::power_of_two(64) + Integer::from(word);
            denominator = denominator * Integer::power_of_ten(19) + Integer::from(word / 3 * 2 + 1);
            for signed in [numerator.clone(), -&numerator] {
                let value = Rational::new(signed, denominator.clone()).unwrap();
                let [above, below] = [value.numerator(), value.denominator()].map(|term| term.to_big());
                let expected = if below == 1.into() { above.to_string() } else { format!("{above}/{below}") };
                assert_eq!(value.to_string(), expected);
                assert_eq!(format!("{value:>200}"), format!("{expected:>200}"));
            }
        }
    }
}
