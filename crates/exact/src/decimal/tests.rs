//! Tests of decimals that are written.

use super::*;
use crate::{Limits, Reading};

fn value(text: &str) -> Rational {
    Reading::Decimal.read(text, &Limits::default()).unwrap()
}

#[test]
fn rounds_in_the_direction_asked() {
    for (text, digits, nearest, down, up) in [
        ("1/3", 3, "0.333", "0.333", "0.334"),
        ("-1/3", 3, "-0.333", "-0.334", "-0.333"),
        ("2/3", 5, "0.66667", "0.66666", "0.66667"),
        ("0.0018194243", 5, "0.0018194", "0.0018194", "0.0018195"),
        ("0.00099996", 4, "0.001000", "0.0009999", "0.001000"),
        ("0.000099996", 4, "0.0001000", "9.999e-5", "0.0001000"),
        ("549.6238", 5, "549.62", "549.62", "549.63"),
        ("0.99999", 3, "1.00", "0.999", "1.00"),
        ("-0.99999", 3, "-1.00", "-1.00", "-0.999"),
        ("999.96", 4, "1000", "999.9", "1000"),
        ("123456", 5, "1.2346e5", "1.2345e5", "1.2346e5"),
        ("0.125", 2, "0.12", "0.12", "0.13"),
        ("0.135", 2, "0.14", "0.13", "0.14"),
    ] {
        let value = value(text);
        let printed = |rounding| value.to_decimal(digits, rounding);
        assert_eq!(printed(Rounding::Nearest), nearest, "{text}");
        assert_eq!(printed(Rounding::Down), down, "{text}");
        assert_eq!(printed(Rounding::Up), up, "{text}");
    }
}

/// The code for numbers of any size is the reference: on both sides of a word, and where digits are not enough.
#[test]
fn decimals_that_end_are_told_by_the_factors_of_their_denominators() {
    let numerators = [1, 2, 3, 5, 10, 123, 1000, 999_999_999, 10_i64.pow(17), 10_i64.pow(18), i64::MAX];
    let mut found = 0;
    for (twos, fives, other) in (0..62).step_by(3).flat_map(|twos| {
        (0..27).step_by(2).flat_map(move |fives| [1, 3, 7].map(|other| (twos, fives, other)))
    }) {
        let power = |base: u64, exponent| Integer::from(base.pow(exponent) as i64);
        let denominator = Integer::power_of_two(twos) * power(5, fives) * Integer::from(other);
        for numerator in numerators.into_iter().flat_map(|n| [n, -n]) {
            let value = Rational::new(numerator.into(), denominator.clone()).unwrap();
            for digits in [1, 5, 18, 40] {
                let rounded = long_significand(value.terms(), digits, Rounding::Down);
                let decimal = value.exact_decimal(digits);
                assert_eq!(decimal.is_some(), rounded.exact, "{value} {digits}");
                let expected = value.decimal(digits, Rounding::Down);
                let Some(decimal) = decimal else { continue };
                found += usize::from(decimal.known.is_some());
                assert_eq!(decimal.to_string(), expected.to_string(), "{value} {digits}");
                assert_eq!(decimal.compact().to_string(), expected.compact().to_string(), "{value}");
            }
        }
    }
    assert!(found > 5000, "only {found}");
}

#[test]
fn exact_values_are_short() {
    for (text, printed) in [
        ("0", "0"),
        ("1/2", "0.5"),
        ("-1/2000", "-0.0005"),
        ("1/20000", "5e-5"),
        ("20", "20"),
        ("100000", "100000"),
        ("1e6", "1e6"),
        ("1200000", "1.2e6"),
        ("0.05", "0.05"),
        ("0.0725", "0.0725"),
        ("12.5", "12.5"),
        ("12345", "12345"),
    ] {
        for rounding in [Rounding::Nearest, Rounding::Down, Rounding::Up] {
            assert_eq!(value(text).to_decimal(5, rounding), printed, "{text}");
        }
    }
}

#[test]
fn a_directed_decimal_encloses_the_value_and_is_tight() {
    for numerator in -400_i64..400 {
        for denominator in [1, 3, 7, 10, 64, 999, 100_000] {
            let exact = Rational::ratio(numerator, denominator);
            for digits in 1..6 {
                let down = value(&exact.to_decimal(digits, Rounding::Down));
                let up = value(&exact.to_decimal(digits, Rounding::Up));
                let nearest = value(&exact.to_decimal(digits, Rounding::Nearest));
                assert!(down <= exact && exact <= up);
                assert!(nearest == down || nearest == up);
                let error = (&exact - &nearest).abs();
                assert!(error <= (&exact - &down).abs() && error <= (&exact - &up).abs());
            }
        }
    }
}

#[test]
fn programs_get_powers_of_ten_below_a_tenth() {
    for (text, compact) in [("0.1", "0.1"), ("0.05", "5e-2"), ("-1/2000", "-5e-4"), ("1/30", "3.3333e-2")] {
        assert_eq!(value(text).decimal(5, Rounding::Nearest).compact().to_string(), compact);
    }
}

#[test]
fn a_rounded_number_is_the_one_that_its_decimal_says() {
    for text in
        ["0", "1/3", "-1/3", "0.99999", "-99996", "1.5e-9999", "7/64", "123456789012345678901234567/7"]
    {
        for digits in [1, 2, 4, 17, 40] {
            for rounding in [Rounding::Nearest, Rounding::Down, Rounding::Up] {
                let exact = value(text);
                let said = value(&exact.to_decimal(digits, rounding));
                assert_eq!(exact.rounded(digits, rounding), said, "{text} {digits} {rounding:?}");
                assert_eq!(exact.exact_decimal(digits).is_some(), said == exact, "{text} {digits}");
            }
        }
    }
}

#[test]
fn the_decimal_exponent_is_that_of_the_first_digit() {
    for (text, exponent) in [("1", 0), ("-9.99", 0), ("10", 1), ("0.1", -1), ("0.0999", -2), ("1e-300", -300)]
    {
        assert_eq!(value(text).decimal_exponent(), Some(exponent), "{text}");
    }
    assert_eq!(Rational::zero().decimal_exponent(), None);
}

#[test]
fn far_exponents() {
    let tiny = value("1.5e-9999");
    assert_eq!(tiny.to_decimal(5, Rounding::Nearest), "1.5e-9999");
    let huge = value("12345678e9000");
    assert_eq!(huge.to_decimal(3, Rounding::Up), "1.24e9007");
}

#[test]
fn more_digits_than_words_hold_are_printed_too() {
    for digits in [18, 19, 20, 38, 39, 40, 60] {
        let nines = "9".repeat(digits);
        let threes = "3".repeat(digits);
        assert_eq!(value("1/3").to_decimal(digits, Rounding::Nearest), format!("0.{threes}"));
        assert_eq!(value(&format!("0.{nines}")).to_decimal(digits, Rounding::Up), format!("0.{nines}"));
    }
}

/// The way that takes numbers of any size is the reference.
#[test]
fn leading_bits_tell_the_digits_of_longer_numbers() {
    let long = |power: u32, plus: i64| Integer::power_of_ten(power) + Integer::from(plus);
    let mut in_words = 0;
    for (numerator, denominator) in [
        (long(60, 1), long(57, 0)),
        (long(60, -1), long(57, 0)),
        (long(60, 0), long(57, 3)),
        (Integer::from(5) * long(70, 1), Integer::from(7) * long(66, -9)),
        (Integer::from(12_345) * long(50, 0) + Integer::from(5) * long(49, 0), long(52, 0)),
        (Integer::from(12_345) * long(50, 0) + Integer::from(5) * long(49, 7), long(52, 0)),
        (Integer::from(999_999) * long(80, 1), Integer::from(3) * long(79, 7)),
        (Integer::power_of_two(300), long(90, 1)),
        (long(90, 1), Integer::power_of_two(300)),
        (long(45, 1), Integer::from(3)),
        (Integer::from(7), long(45, 1)),
    ] {
        let value = Rational::new(numerator, denominator).unwrap();
        for value in [-&value, value] {
            for digits in 1..=18 {
                for rounding in [Rounding::Nearest, Rounding::Down, Rounding::Up] {
                    let Some(short) = words::significand(value.terms(), digits, rounding) else { continue };
                    in_words += 1;
                    let long = long_significand(value.terms(), digits, rounding);
                    assert_eq!(Integer::from(short.digits), long.digits, "{value} {digits} {rounding:?}");
                    assert_eq!((short.exponent, short.exact), (long.exponent, long.exact), "{value}");
                }
            }
        }
    }
    assert!(in_words > 400, "only {in_words}");
}

/// Next to a power of ten, a logarithm in binary64 is often on the wrong side.
#[test]
fn words_are_enough_next_to_a_power_of_ten() {
    for (numerator, denominator, exponent) in [
        (90_154_674_928_685_911, 9_015_467_492_868_591, 1),
        (90_154_674_928_685_909, 9_015_467_492_868_591, 0),
        (1_000_000_000_000_000_000, 1, 18),
        (999_999_999_999_999_999, 1, 17),
        (999_999_999_999_999_999, 10_000_000_000_000_000, 1),
        (10, 1, 1),
        (1, 1, 0),
        (1, 10, -1),
        (1, 1000, -3),
    ] {
        let value = Rational::ratio(numerator, denominator);
        assert_eq!(words::exponent(value.terms()), Some(exponent), "{value}");
        for digits in 1..=18 {
            let short = words::significand(value.terms(), digits, Rounding::Down).unwrap();
            let long = long_significand(value.terms(), digits, Rounding::Down);
            assert_eq!(Integer::from(short.digits), long.digits, "{value} {digits}");
            assert_eq!((short.exponent, short.exact), (long.exponent, long.exact), "{value} {digits}");
        }
    }
}

/// The way that takes numbers of any size is the reference.
#[test]
fn numbers_of_up_to_128_bits_are_printed_like_longer_ones() {
    let mut seed = 1_u64;
    let mut next = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        u128::from(seed >> 1)
    };
    let edges = (0..38).flat_map(|exponent| {
        let power = 10_i128.pow(exponent);
        [power - 1, power, power + 1, power / 2, 3 * (power / 2)]
    });
    let edges: Vec<i128> = edges.chain([i128::MAX, i128::MAX - 1, 1 << 126, 7]).filter(|n| *n > 0).collect();
    let mut terms: Vec<(i128, i128)> = Vec::new();
    for (index, &numerator) in edges.iter().enumerate() {
        terms.extend(edges.iter().skip(index % 7).step_by(7).map(|&denominator| (numerator, denominator)));
    }
    for _ in 0..3000 {
        let mut wide = || ((next() << 63 | next()) >> (next() % 126)) as i128 + 1;
        terms.push((wide(), wide()));
    }
    let mut in_words = 0;
    for (numerator, denominator) in terms {
        let value = Rational::new(numerator.into(), denominator.into()).unwrap();
        for value in [-&value, value] {
            let exponent = exponent_of(value.terms());
            assert_eq!(value.decimal_exponent(), Some(exponent), "{value}");
            for (digits, rounding) in [
                (1, Rounding::Nearest),
                (5, Rounding::Down),
                (5, Rounding::Up),
                (6, Rounding::Nearest),
                (18, Rounding::Up),
                (18, Rounding::Nearest),
            ] {
                let long = long_significand(value.terms(), digits, rounding);
                let Some(short) = words::significand(value.terms(), digits, rounding) else { continue };
                in_words += 1;
                assert_eq!(Integer::from(short.digits), long.digits, "{value} {digits} {rounding:?}");
                assert_eq!((short.exponent, short.exact), (long.exponent, long.exact), "{value}");
            }
        }
    }
    assert!(in_words > 30_000, "only {in_words}");
}

#[test]
fn quotients_with_common_divisors_are_printed_like_those_in_lowest_terms() {
    let long = |power: u32, rest: i64| Integer::power_of_ten(power) + Integer::from(rest);
    for (numerator, denominator) in [
        (Integer::from(0), Integer::from(7)),
        (Integer::from(21), Integer::from(11_726)),
        (Integer::from(-3), Integer::from(8)),
        (Integer::from(99_995), Integer::from(10)),
        (long(37, 0), long(36, 0)),
        (-long(60, 7), long(41, -1)),
    ] {
        let value = Rational::new(numerator.clone(), denominator.clone()).unwrap();
        for common in [Integer::from(1), Integer::from(6), long(20, 0), long(45, 9)] {
            let [numerator, denominator] = [&numerator * &common, &denominator * &common];
            assert!(value.is_quotient(&numerator, &denominator));
            assert!(!value.is_quotient(&(&numerator + Integer::one()), &denominator));
            for digits in [1, 3, 5, 18, 30] {
                for rounding in [Rounding::Nearest, Rounding::Down, Rounding::Up] {
                    let decimal = Decimal::of_quotient(&numerator, &denominator, digits, rounding);
                    assert_eq!(decimal.to_string(), value.to_decimal(digits, rounding), "{value} {common}");
                }
            }
        }
    }
}
