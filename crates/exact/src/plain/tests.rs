use super::*;
use crate::{Limits, Rational, Reading};

#[test]
fn edges_of_plain_decimals() {
    for (text, expected) in [
        ("0", Some((0, 0))),
        ("-0.000e50", Some((0, 0))),
        ("1.50", Some((150, -2))),
        ("-.5", Some((-5, -1))),
        ("5.", Some((5, 0))),
        (" \t+12.5e-3 ", Some((125, -4))),
        ("2E+3", Some((2, 3))),
        ("12345678", Some((12_345_678, 0))),
        ("12345678.12345678", Some((1_234_567_812_345_678, -8))),
        ("123456789012345678", Some((123_456_789_012_345_678, 0))),
        ("9223372036854775807", Some((i64::MAX, 0))),
        ("9223372036854775808", None),
        ("-9223372036854775808", Some((i64::MIN, 0))),
        ("-9223372036854775809", None),
        ("18446744073709551616", None),
        ("9.999999999999999999", None),
        ("-9.999999999999999999", None),
        ("1.999999999999999999", Some((1_999_999_999_999_999_999, -18))),
        ("0.000000000000000000000000000000000000001", Some((1, -39))),
        ("0.0000000000000000000000000000000000000001", None),
        ("1e999", Some((1, 999))),
        ("1e1000", None),
        ("1e-00000009", Some((1, -9))),
        ("", None),
        ("-", None),
        (".", None),
        ("+-1", None),
        ("--1", None),
        ("1e", None),
        ("1e+-1", None),
        ("1.2.3", None),
        ("12345678.1.1", None),
        ("1/2", None),
        ("1 2", None),
        ("\u{660}1", None),
    ] {
        assert_eq!(plain_decimal(text.as_bytes()), expected, "{text}");
        if let (Some((mantissa, exponent)), Ok(number)) =
            (expected, Reading::Decimal.read(text, &Limits::default()))
        {
            assert_eq!(Rational::scientific(mantissa, exponent), number, "{text}");
        }
    }
}

#[test]
fn a_point_may_stand_anywhere_among_the_digits() {
    let digits = "918273645546372819";
    for count in 1..=digits.len() {
        for before in 0..=count {
            let text = format!("{}.{}", &digits[..before], &digits[before..count]);
            let expected = PlainPrefix {
                mantissa: digits[..count].parse().unwrap(),
                fraction_digits: (count - before) as i32,
                length: count + 1,
            };
            assert_eq!(plain_prefix(text.as_bytes()), Some(expected), "{text}");
            let negative = PlainPrefix { mantissa: -expected.mantissa, length: count + 2, ..expected };
            assert_eq!(plain_prefix(format!("-{text}").as_bytes()), Some(negative), "-{text}");
        }
    }
}

#[test]
fn long_words_are_what_their_digits_spell() {
    let mut state = 1_u64;
    let mut word = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize
    };
    let mut found = 0;
    for _ in 0..100_000 {
        let (count, point, is_negative) = (14 + word() % 12, word() % 10, word() % 2 == 0);
        let zeros = word() % 10;
        let mut digit = |place| if place < zeros { '0' } else { char::from(b'0' + (word() % 10) as u8) };
        let digits: String = (0..count).map(&mut digit).collect();
        let [sign, mark] = [if is_negative { "-" } else { "" }, if point < 9 { "." } else { "" }];
        let text = format!("{sign}{}{mark}{}", &digits[..point], &digits[point..]);
        let behind = [",123456789012345678", "\n123456789012345678", "e-30000000000000000"][word() % 3];
        let bytes = format!("{text}{behind}").into_bytes();
        let read = long_word_prefix(bytes.first_chunk().unwrap());
        let most = if point < 9 { 22 } else { 23 };
        let is_read = (16..=most).contains(&count) && point != 8;
        let magnitude = digits.parse::<u64>().ok().filter(|_| is_read);
        let expected = magnitude.map(|magnitude| PlainPrefix {
            mantissa: if is_negative { -i128::from(magnitude) } else { magnitude.into() },
            fraction_digits: if point < 9 { (count - point) as i32 } else { 0 },
            length: text.len(),
        });
        assert_eq!(read, expected, "{text}");
        assert!(read.is_none() || count > 19 || long_plain_prefix(&bytes) == digits_prefix(&bytes), "{text}");
        found += usize::from(read.is_some());
    }
    assert!(found > 30_000, "{found}");
}

#[test]
fn nineteen_digits_are_read_as_a_prefix_where_they_fit() {
    let prefix = |text: &str| plain_prefix(text.as_bytes()).map(|prefix| (prefix.mantissa, prefix.length));
    assert_eq!(prefix("12345678.12345678,"), Some((1_234_567_812_345_678, 17)));
    assert_eq!(prefix("-123456789.123456789x"), Some((-123_456_789_123_456_789, 20)));
    assert_eq!(prefix("1.99999999999999999"), Some((199_999_999_999_999_999, 19)));
    assert_eq!(prefix("1.999999999999999999"), Some((1_999_999_999_999_999_999, 20)));
    assert_eq!(prefix("1234567890.123456789"), Some((1_234_567_890_123_456_789, 20)));
    assert_eq!(prefix("9223372036854775807,"), Some((i64::MAX, 19)));
    assert_eq!(prefix("-9223372036854775808"), Some((i64::MIN, 20)));
    for more in [
        "9223372036854775808",
        "-9223372036854775809",
        "9.999999999999999999",
        "000000000000000000000001",
        "12345678901234567890",
        "1234567890.1234567890",
        "1.0000000000000000000000000000001",
        "100000000000000000000000000000000.1",
        "184467440737095516160",
    ] {
        assert_eq!(prefix(more), None, "{more}");
    }
}

/// Looks at several parts of a text, which end anywhere in its numbers.
#[test]
fn numbers_in_a_text_are_those_that_stand_alone() {
    let numbers =
        ["-12.5", "1234567.7654321", "0.12345678", "-", "7", "-.25", "12345678", "3.", "1e5", "-0.0"];
    let mut text = (numbers.join(",") + ",").repeat(200);
    text.push_str(&",".repeat(100));
    let (text, mut others, mut shorts) = (text.as_bytes(), Others::default(), 0);
    for at in (0..text.len() - 32).filter(|&at| at == 0 || text[at - 1] == b',') {
        let short = short_prefix(text[at..].first_chunk().unwrap(), others.behind(text, at));
        if let Some(short) = short {
            assert_eq!(other_prefix(&text[at..]), Some(short.into()), "{at} {short:?}");
            shorts += 1;
        }
    }
    assert_eq!(shorts, 7 * 200);
}

#[test]
fn exponents_end_at_the_first_byte_that_is_no_digit() {
    for (text, expected) in [
        ("e5", Some((5, 2))),
        ("E-01,", Some((-1, 4))),
        ("e+999\n", Some((999, 5))),
        ("e000", Some((0, 4))),
        ("e00001", None),
        ("e12345", None),
        ("E+12345678", None),
        ("e-07;", Some((-7, 4))),
        ("e", None),
        ("e-", None),
        ("e+-1", None),
        ("e 1", None),
        ("5", None),
        ("", None),
    ] {
        assert_eq!(exponent_prefix(text.as_bytes()), expected, "{text}");
    }
}

/// Every byte in every place of a word, and every length.
#[test]
fn a_prefix_ends_at_the_first_byte_that_is_no_digit() {
    for length in 0..=18 {
        let digits = &b"918273645546372819"[..length];
        for byte in 0..=u8::MAX {
            let text = [digits, &[byte], b"55"].concat();
            let expected = match byte {
                b'0'..=b'9' | b'.' => continue,
                _ if length == 0 && byte == b'-' => Some((-55, 3)),
                _ if length == 0 => None,
                _ => std::str::from_utf8(digits).unwrap().parse().ok().map(|value| (value, length)),
            };
            let prefix = plain_prefix(&text).map(|prefix| (prefix.mantissa, prefix.length));
            assert_eq!(prefix, expected, "{text:?}");
        }
    }
}
