//! Tests of numbers as people write them.

use super::ParseNumberErrorKind as Kind;
use super::*;
use crate::Thousands;

fn read(text: &str) -> Result<Rational, ParseNumberError> {
    Reading::Decimal.read(text, &Limits::default())
}

#[test]
fn decimals_and_fractions_are_exact() {
    for (text, numerator, denominator) in [
        ("1.30e-2", 13, 1000),
        ("-.5", -1, 2),
        ("+3", 3, 1),
        ("7/19", 7, 19),
        ("-6/4", -3, 2),
        ("0/5", 0, 1),
        ("10/20", 1, 2),
        ("0.1", 1, 10),
        ("5e-4", 1, 2000),
        ("5.", 5, 1),
        ("2E+3", 2000, 1),
        ("-0", 0, 1),
        ("000.00100", 1, 1000),
        (" 1.5\t", 3, 2),
        ("\u{2212}1", -1, 1),
        ("2e\u{2212}1", 1, 5),
        ("\u{a0}1.5\u{202f} \u{2007}", 3, 2),
        ("1.0D+03", 1000, 1),
        ("-.25d1", -5, 2),
    ] {
        assert_eq!(read(text), Ok(Rational::ratio(numerator, denominator)), "{text}");
    }
}

#[test]
fn what_is_not_a_number_is_refused_with_its_place() {
    for (text, position, kind) in [
        ("", 0, Kind::Empty),
        ("  ", 2, Kind::Empty),
        ("1_000", 1, Kind::Underscore),
        ("1,5", 1, Kind::Comma),
        ("0x10", 1, Kind::UnexpectedCharacter('x')),
        ("abc", 0, Kind::UnexpectedCharacter('a')),
        ("nan", 0, Kind::NotFinite),
        ("-inf", 1, Kind::NotFinite),
        ("Infinity", 0, Kind::NotFinite),
        ("-", 1, Kind::MissingDigit),
        (".", 1, Kind::MissingDigit),
        (".e5", 1, Kind::UnexpectedCharacter('e')),
        ("1e", 2, Kind::MissingDigit),
        ("1e+", 3, Kind::MissingDigit),
        ("1e5.5", 3, Kind::UnexpectedCharacter('.')),
        ("1/0", 2, Kind::ZeroDenominator),
        ("1/", 2, Kind::MissingDigit),
        ("/2", 0, Kind::UnexpectedCharacter('/')),
        ("1/-2", 2, Kind::UnexpectedCharacter('-')),
        ("1/2/3", 1, Kind::Date),
        ("2012/01/01", 4, Kind::Date),
        ("2012/01", 4, Kind::Date),
        ("03/04", 2, Kind::Date),
        (" 00/5", 3, Kind::Date),
        ("0/05", 1, Kind::Date),
        ("-1/2/", 2, Kind::Date),
        ("1//2", 2, Kind::UnexpectedCharacter('/')),
        ("1.5/2", 3, Kind::UnexpectedCharacter('/')),
        ("--1", 1, Kind::UnexpectedCharacter('-')),
        ("1 2", 2, Kind::UnexpectedCharacter('2')),
        ("\u{2212}\u{2212}1", 1, Kind::UnexpectedCharacter('\u{2212}')),
        ("1\u{2009}000", 2, Kind::UnexpectedCharacter('0')),
        ("1\u{2003}", 1, Kind::UnexpectedCharacter('\u{2003}')),
        ("1D", 2, Kind::MissingDigit),
    ] {
        assert_eq!(read(text), Err(ParseNumberError { position, kind }), "{text:?}");
    }
}

#[test]
fn other_marks_are_read_strictly() {
    let read = |decimal, thousands, text: &str| {
        let notation = Notation { decimal, thousands };
        Reading::Decimal.read_written(text, notation, &Limits::default())
    };
    use DecimalMark::{Comma, Point};
    for (decimal, thousands, text, numerator, denominator) in [
        (Comma, None, "1,5", 3, 2),
        (Comma, None, "-,5e1", -5, 1),
        (Comma, None, "5,", 5, 1),
        (Comma, None, "7/19", 7, 19),
        (Comma, Some(Thousands::Point), "1.234.567,5", 2_469_135, 2),
        (Comma, Some(Thousands::Point), "999,5", 1999, 2),
        (Comma, Some(Thousands::Point), "0,5", 1, 2),
        (Point, Some(Thousands::Comma), "60,323", 60_323, 1),
        (Point, Some(Thousands::Comma), "60323.25", 241_293, 4),
        (Point, Some(Thousands::Blank), " 12 345.5 ", 24_691, 2),
        (Point, Some(Thousands::Blank), "1\u{202f}000\u{a0}000", 1_000_000, 1),
        (Point, Some(Thousands::Apostrophe), "-1'000", -1000, 1),
        (Comma, Some(Thousands::Apostrophe), "1\u{2019}000,5", 2001, 2),
    ] {
        assert_eq!(read(decimal, thousands, text), Ok(Rational::ratio(numerator, denominator)), "{text}");
    }
    for (decimal, thousands, text, position, kind) in [
        (Comma, None, "1.5", 1, Kind::Point),
        (Comma, None, "1,5,5", 3, Kind::UnexpectedCharacter(',')),
        (Comma, None, "1,5.5", 3, Kind::Point),
        (Comma, Some(Thousands::Point), "1.23", 2, Kind::NotInThrees),
        (Comma, Some(Thousands::Point), "1.2345", 2, Kind::NotInThrees),
        (Comma, Some(Thousands::Point), "1234.567", 0, Kind::NotInThrees),
        (Comma, Some(Thousands::Point), "0.123", 0, Kind::NotInThrees),
        (Comma, Some(Thousands::Point), ".123", 0, Kind::Point),
        (Comma, Some(Thousands::Point), "1,234.567", 5, Kind::Point),
        (Point, Some(Thousands::Comma), "1,,234", 2, Kind::NotInThrees),
        (Point, Some(Thousands::Comma), "1,234,", 6, Kind::NotInThrees),
        (Point, Some(Thousands::Comma), "1.234,567", 5, Kind::Comma),
        (Point, Some(Thousands::Comma), "1,234/5", 5, Kind::UnexpectedCharacter('/')),
        (Point, Some(Thousands::Blank), "1 2", 2, Kind::NotInThrees),
    ] {
        assert_eq!(
            read(decimal, thousands, text),
            Err(ParseNumberError { position, kind }),
            "{text:?} {thousands:?}"
        );
    }
    let digits = format!("1{}", ",000".repeat(3400));
    let too_many = ParseNumberError { position: 13_332 + 2, kind: Kind::TooManyDigits(10_000) };
    assert_eq!(read(Point, Some(Thousands::Comma), &digits).unwrap_err().kind, too_many.kind);
}

#[test]
fn hostile_numbers_meet_the_limit() {
    let too_large = Kind::ExponentTooLarge(10_000);
    assert_eq!(read("1e999999999"), Err(ParseNumberError { position: 2, kind: too_large.clone() }));
    assert_eq!(read("1e-10001"), Err(ParseNumberError { position: 3, kind: too_large.clone() }));
    let endless = format!("1e{}", "9".repeat(100_000));
    assert_eq!(read(&endless), Err(ParseNumberError { position: 2, kind: too_large }));
    let digits = "7".repeat(20_000);
    let too_many = Err(ParseNumberError { position: 10_000, kind: Kind::TooManyDigits(10_000) });
    assert_eq!(read(&digits), too_many);
    let fraction = format!("0.{digits}");
    let too_many = ParseNumberError { position: 2 + 9_999, kind: Kind::TooManyDigits(10_000) };
    assert_eq!(read(&fraction).unwrap_err(), too_many);
    assert_eq!(too_many.to_string(), "more than 10000 digits (the limit) at character 10002");
    assert!(read(&"7".repeat(10_000)).is_ok());
    assert!(read("1e10000").is_ok());
}

#[test]
fn binary64_is_the_nearest_double_taken_exactly() {
    let read = |text| Reading::Binary64.read(text, &Limits::default());
    assert_eq!(read("0.1"), Ok(Rational::from_f64(0.1).unwrap()));
    assert_eq!(read("1/3"), Ok(Rational::from_f64(1.0 / 3.0).unwrap()));
    assert_eq!(read("0.5"), Ok(Rational::ratio(1, 2)));
    assert_eq!(read("1e-400"), Ok(Rational::zero()));
    assert_eq!(read("1e400").unwrap_err().kind, Kind::Binary64Overflow);
}

#[test]
fn limits_are_told_from_what_is_no_number() {
    for (text, is_limit) in [("1e99999", true), ("x", false), ("", false), ("1/0", false), ("1_0", false)] {
        assert_eq!(read(text).unwrap_err().kind.is_limit(), is_limit, "{text:?}");
    }
    assert!(read(&"7".repeat(20_000)).unwrap_err().kind.is_limit());
    assert!(Reading::Binary64.read("1e400", &Limits::default()).unwrap_err().kind.is_limit());
}

/// Numbers and texts that are nearly numbers, by the one rule for all texts and by the way for plain ones.
#[test]
fn plain_numbers_are_what_the_scanner_reads() {
    let mut state = 1_u64;
    let mut below = |limit: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % limit
    };
    let pieces = [
        "0",
        "00",
        "7",
        "123",
        "99999999999",
        "9223372036854775808",
        ".",
        ".",
        "-",
        "+",
        "e",
        "E",
        "d",
        "e-3",
        "e+2",
        "e999",
        "e1000",
        "e0004",
        " ",
        "\t",
        "\u{c}",
        "\u{b}",
        "\u{a0}",
        "\u{2212}",
        "/",
        "_",
        ",",
        "x",
    ];
    let limits = [Limits::default(), Limits { digits: 3, exponent: 2 }, Limits { digits: 40, exponent: 999 }];
    let mut numbers = 0;
    for _ in 0..60_000 {
        let text: String = (0..below(6)).map(|_| pieces[below(pieces.len())]).collect();
        for limits in &limits {
            let notation = Notation::default();
            let scanner = Scanner { bytes: text.as_bytes(), text: &text, position: 0, notation, limits };
            let expected = scanner.number();
            numbers += usize::from(expected.is_ok());
            assert_eq!(Reading::Decimal.read(&text, limits), expected, "{text:?}");
        }
    }
    assert!(numbers > 10_000, "{numbers}");
}
