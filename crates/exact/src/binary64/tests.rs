//! Tests of rounding to binary64.

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
        assert_eq!(plain_double(text.as_bytes()), Some(nearest).filter(|_| nearest.is_finite()), "{text}");
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
        assert_eq!(short_double(mantissa, exponent), double, "{mantissa}e{exponent}");
    }
}

/// The standard library reads the same numbers.
#[test]
fn nearest_doubles_are_those_of_the_standard_library() {
    let mut states = states(0x6a09_e667_f3bc_c909);
    let mut told = 0;
    let check = |mantissa: i64, exponent: i32| {
        let text = format!("{mantissa}e{exponent}");
        let double: f64 = text.parse().unwrap();
        let nearest = nearest_double(mantissa, exponent);
        assert!(nearest.is_none_or(|nearest| nearest == double), "{text}: {nearest:?}");
        assert_eq!(plain_double(text.as_bytes()), Some(double).filter(|double| double.is_finite()), "{text}");
        usize::from(nearest.is_some())
    };
    for exponent in -350..=350 {
        for _ in 0..100 {
            let word = (states() >> 1) as i64;
            told += check(word >> (word % 12), exponent);
            told += check(-(word >> (word % 60)), exponent);
        }
        for edge in [1, 1 << 53, (1 << 53) + 1, (1 << 54) + 2, 1 << 62, i64::MAX - 1, i64::MAX, i64::MIN] {
            check(edge, exponent);
        }
        assert_eq!(check(0, exponent), usize::from(exponent.abs() <= 22), "{exponent}");
    }
    // 561 of 701 powers have their leading bits.
    assert!(told > 2 * 561 * 99, "{told}");
    // Odd numbers of 54 bits are half-way between doubles, and so are their quotients by powers of two.
    let mut undecided = 0;
    for _ in 0..2_000 {
        let tie = ((1 << 53) + (states() >> 11) as i64) | 1;
        for places in 0..=22 {
            let power = 5_i64.checked_pow(places).unwrap();
            let ties = [
                tie.checked_mul(power).map(|tie| (tie, -(places as i32))),
                Some(((tie / power) | 1, places as i32)),
            ];
            for (tie, exponent) in ties.into_iter().flatten() {
                undecided += 5 - (-2..=2).map(|apart| check(tie + apart, exponent)).sum::<usize>();
            }
        }
    }
    assert!(undecided > 4_000, "{undecided}");
}

#[test]
fn long_texts_are_read_as_the_nearest_doubles() {
    for text in [
        "0.12345678901234567890123456789",
        "1.7976931348623157e308",
        "1.7976931348623159e308",
        "2.2250738585072011e-308",
        "4.9406564584124654e-324",
        "2.4703282292062327e-324",
        "2.4703282292062328e-324",
        "-9.223372036854775808",
        "9007199254740993.0",
        "9007199254740992.9999999999999999",
        "0.50000000000000000",
        "-0.0",
        " 4503599627370496.5 ",
        "6.8539596194e-289",
        "8.41750e23",
    ] {
        let double: f64 = text.trim().parse().unwrap();
        let plain = plain_double(text.as_bytes());
        assert!(plain.is_none_or(|plain| plain == double), "{text}: {plain:?}");
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
            0 => Rational::ratio(word() as i64 >> (word() % 63), 1 + (word() as i64 >> (word() % 63)) / 2),
            1 => Rational::from((word() >> (word() % 63)) as i64) * &short[(word() % 2) as usize],
            2 => long * Rational::scientific(1, word() as i64 % 600 - 300),
            3 => -long,
            _ => long,
        }
    };
    let mut told = 0;
    for _ in 0..20_000 {
        let (value, error) = (number(), number().abs());
        let (double, side) = value.nearest_f64();
        told += usize::from(!side.is_eq() && ceil_beside_by_leading_bits(&error, &value, double).is_some());
        let Some(exact) = Rational::from_f64(double) else {
            assert_eq!(side, if value.is_positive() { Ordering::Greater } else { Ordering::Less });
            continue;
        };
        assert_eq!(side, exact.cmp(&value), "{value}");
        let half = |beside: f64| (Rational::from_f64(beside).unwrap() - &exact).abs() * Rational::ratio(1, 2);
        assert!((&exact - &value).abs() <= half(double.next_up()).max(half(double.next_down())), "{value}");
        assert_eq!(
            error.ceil_to_f64_beside(&value),
            (&error + (&exact - &value).abs()).ceil_to_f64(),
            "{error} {value}"
        );
    }
    assert!(told > 4_000, "{told}");
    let huge = exact("1e400");
    assert_eq!(Rational::ratio(1, 3).ceil_to_f64_beside(&huge), Rational::ratio(1, 3).ceil_to_f64());
}

#[test]
fn every_finite_double_survives_the_round_trip() {
    for value in [0.0, 0.1, -2.5, f64::MAX, f64::MIN_POSITIVE, 5e-324, 1.0 + f64::EPSILON, 1e300, -1e-300] {
        assert_eq!(Rational::from_f64(value).unwrap().to_f64(), value);
    }
    assert_eq!(Rational::from_f64(f64::NAN), None);
    assert_eq!(Rational::from_f64(f64::NEG_INFINITY), None);
}
