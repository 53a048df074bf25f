//! Tests of the shortest decimals.

use super::*;
use crate::{Integer, Rational};

struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 ^ self.0 >> 32).wrapping_mul(0x9e37_79b9_7f4a_7c15)
    }
}

/// Mantissa and exponent of what the standard library writes.
fn written(text: &str) -> (i64, i32) {
    let (digits, exponent) = text.split_once('e').unwrap();
    let fraction = digits.split_once('.').map_or(0, |(_, fraction)| fraction.len() as i32);
    let mantissa: i64 = digits.replace('.', "").parse().unwrap();
    (mantissa, if mantissa == 0 { 0 } else { exponent.parse::<i32>().unwrap() - fraction })
}

/// The shortest decimal by the standard library, and of two that are equally near the even one.
fn expected(value: f64, text: &str, reads_back: impl Fn(String) -> bool) -> (i64, i32) {
    let (mantissa, exponent) = written(text);
    if mantissa % 2 == 0 || !(-30..0).contains(&exponent) {
        return (mantissa, exponent);
    }
    let below = mantissa - mantissa.signum();
    let middle = Rational::scientific(i128::from(mantissa) + i128::from(below), exponent);
    let is_tie = Rational::from_f64(value).unwrap() * Rational::from(2) == middle;
    // Below a power of two the floats are closer together.
    (if is_tie && reads_back(format!("{below}e{exponent}")) { below } else { mantissa }, exponent)
}

#[track_caller]
fn check(value: f64) {
    for value in [value, value.next_down(), value.next_up()].into_iter().filter(|value| value.is_finite()) {
        let text = format!("{value:e}");
        let own = shortest_decimal(value);
        assert_eq!(own, Some(expected(value, &text, |text| text.parse() == Ok(value))), "{text}");
        for text in [text, format!("{value:?}"), value.to_string()] {
            let own_text = value.in_shortest_digits(text.clone());
            assert_eq!(own_text.len(), text.len(), "{text}");
            assert_eq!(own_text.parse::<f64>().unwrap().to_bits(), value.to_bits(), "{text}");
            assert!(written_any(&own_text).is_none_or(|written| Some(written) == own), "{text}");
        }
    }
}

/// Mantissa and exponent of a text of few digits, the mantissa without zeros at its end.
fn written_any(text: &str) -> Option<(i64, i32)> {
    let (mantissa, exponent) = plain_decimal(text.as_bytes())?;
    let (least, exponent) = without_zeros(mantissa.unsigned_abs().max(1), exponent);
    if mantissa == 0 { Some((0, 0)) } else { signed((least, exponent), mantissa < 0) }
}

#[track_caller]
fn check_single(value: f32) {
    for value in [value, value.next_down(), value.next_up()].into_iter().filter(|value| value.is_finite()) {
        let text = format!("{value:e}");
        assert_eq!(
            shortest_decimal_of_f32(value),
            Some(expected(value.into(), &text, |text| text.parse() == Ok(value))),
            "{text}"
        );
    }
}

// The values are written in full: what is read is the double itself.
#[allow(clippy::excessive_precision)]
#[test]
fn of_two_that_are_equally_near_the_even_one_is_taken() {
    // The texts that Python 3.11 prints.
    for (value, text) in [
        (1_732_372_800_000_000.25, "1732372800000000.2"),
        (1_732_372_800_000_000.75, "1732372800000000.8"),
        (-1_732_372_800_000_001.25, "-1732372800000001.2"),
        (1_000_000_000_000_000.125, "1000000000000000.1"),
        (1_000_000_000_000_000.375, "1000000000000000.4"),
        (1_000_000_000_000_000.625, "1000000000000000.6"),
        (100_000_000_000_000.062_5, "100000000000000.06"),
        (562_949_953_421_312.125, "562949953421312.1"),
        (70_368_744_177_664.015_625, "70368744177664.02"),
        (2_251_799_813_685_248.5, "2251799813685248.5"),
        (1_125_899_906_842_624.25, "1125899906842624.2"),
    ] {
        assert_eq!(f64::in_shortest_digits(value, format!("{value:?}")), text);
        check(value);
    }
    for quarter in 0..40_000_u64 {
        check((6_929_491_200_000_000 + quarter) as f64 / 4.0);
        check((1 << 53 | quarter) as f64 / 8.0);
        check_single((1 << 23 | quarter as u32) as f32 / 8.0);
    }
}

#[test]
fn shortest_decimals_are_those_that_the_standard_library_writes() {
    let mut random = Random(1);
    for _ in 0..300_000 {
        check(f64::from_bits(random.next()));
        check_single(f32::from_bits(random.next() as u32));
        // The next numbers have usual sizes.
        check((random.next() >> 11) as f64 / (1_u64 << (random.next() % 64)) as f64);
        // Few digits, or one more than few.
        let digits = random.next() >> (random.next() % 64);
        let power = (random.next() % 44) as i32 - 22;
        check(format!("{digits}e{power}").parse().unwrap());
        check_single(format!("{}e{power}", digits >> 32).parse().unwrap());
    }
}

#[test]
fn at_powers_of_two_and_ten_and_at_the_ends_they_are_too() {
    for exponent in -1074..=1023 {
        check(2_f64.powi(exponent));
        check(-3.0 * 2_f64.powi(exponent.min(1021)));
    }
    for biased in 0..=254 {
        check_single(f32::from_bits(biased << 23));
    }
    for power in -324..=308 {
        for digit in 1..=99 {
            check(format!("{digit}e{power}").parse().unwrap());
        }
    }
    for power in -46..=38 {
        check_single(format!("1e{power}").parse().unwrap());
    }
    for subnormal in 0..5000 {
        check(f64::from_bits(subnormal));
        check(f64::from_bits((1 << 52) - subnormal));
        check(f64::from_bits(f64::MAX.to_bits() - subnormal));
        check_single(f32::from_bits(subnormal as u32));
    }
    // Integers on both sides of those that all are doubles, also those that a power of ten divides.
    for integer in
        (0..200).flat_map(|k| [1 << 53, 10_u64.pow(16), 10_u64.pow(18), 1 << 62].map(|n| n + k * 128))
    {
        check(integer as f64);
    }
    for (value, decimal) in [(0.0, (0, 0)), (-0.0, (0, 0)), (5e-324, (5, -324)), (9e-324, (1, -323))] {
        assert_eq!(shortest_decimal(value), Some(decimal));
    }
    assert_eq!([f64::NAN, f64::INFINITY].map(shortest_decimal), [None; 2]);
    assert_eq!([f32::NAN, f32::NEG_INFINITY].map(shortest_decimal_of_f32), [None; 2]);
}

#[test]
fn scales_are_the_powers_of_ten_below_the_intervals() {
    let ten = |power: i32| {
        let power_of_ten = Rational::scientific(1, power.abs());
        if power < 0 { Rational::one().checked_div(&power_of_ten).unwrap() } else { power_of_ten }
    };
    let two = |power: i32| {
        let power_of_two = Rational::from(Integer::power_of_two(power.unsigned_abs().into()));
        if power < 0 { Rational::one().checked_div(&power_of_two).unwrap() } else { power_of_two }
    };
    for exponent in -1074..=971 {
        for is_power in [false, true] {
            let scale = Scale::new(exponent, is_power);
            let width = two(exponent) * if is_power { Rational::ratio(3, 4) } else { Rational::one() };
            assert!(ten(scale.power) <= width && width < ten(scale.power + 1), "{exponent}");
            // The quantity is 4·10^-power·2^exponent = 4·2^shift·inverse/2^128, rounded down in the last bit at
            // most.
            assert!((1..=4).contains(&scale.shift) && scale.inverse >> 127 == 1, "{exponent}");
            let counted = |inverse: u128| {
                Rational::from(
                    Integer::from(inverse >> 1) * Integer::from(2) + Integer::from((inverse & 1) as i64),
                ) * two(scale.shift - 128)
            };
            let exact = ten(-scale.power) * two(exponent);
            assert!(
                counted(scale.inverse) <= exact && exact < counted(scale.inverse.saturating_add(1)),
                "{exponent}"
            );
            assert_eq!(counted(scale.inverse) == exact, scale.is_exact, "{exponent}");
        }
    }
}

#[test]
fn common_places_are_those_of_the_shortest_decimals() {
    let mut random = Random(3);
    for round in 0..20_000 {
        let (digits, places) = (random.next() % 17, (random.next() % 24) as i32);
        let count = 1 + random.next() % if round % 100 == 0 { 300 } else { 3 };
        let values: Vec<f64> = (0..count)
            .map(|_| {
                let sign = if random.next().is_multiple_of(2) { "-" } else { "" };
                format!("{sign}{}e-{places}", random.next() % 10_u64.pow(digits as u32)).parse().unwrap()
            })
            .collect();
        let shortest: Vec<(i64, i32)> =
            values.iter().map(|&value| shortest_decimal(value).unwrap()).collect();
        let places = shortest.iter().map(|&(_, exponent)| (-exponent).max(0)).max().unwrap_or(0);
        let counts = || -> Option<Vec<i64>> {
            let count = |&(mantissa, exponent): &(i64, i32)| match mantissa {
                0 => Some(0),
                _ => mantissa.checked_mul(10_i64.checked_pow((exponent + places) as u32)?),
            };
            shortest
                .iter()
                .map(|decimal| count(decimal).filter(|count| count.unsigned_abs() < 10_u64.pow(15)))
                .collect()
        };
        let expected = if places <= 22 { counts().map(|counts| (counts, places as usize)) } else { None };
        assert_eq!(on_common_places(&values), expected, "{values:?}");
    }
    assert_eq!(on_common_places(&[]), Some((vec![], 0)));
    assert_eq!(on_common_places(&[-0.0, 0.0]), Some((vec![0, 0], 0)));
    for value in [f64::NAN, f64::INFINITY, 1e300, 1e15, 0.1 + 0.2, 1e-23] {
        assert_eq!(on_common_places(&[0.5, value]), None, "{value}");
    }
}
