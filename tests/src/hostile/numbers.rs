//! Numbers that are expensive in one way or another.

use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use super::one_of;

/// The style of the numbers of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Written {
    /// One digit.
    Digit,
    /// Integers and decimals of some digits.
    Short,
    /// Sixteen or seventeen digits.
    Double,
    /// Numbers of so many digits that a few fill the file.
    Wide,
    /// Powers of ten up to the limit on exponents.
    Far,
    /// Powers of ten as far apart as doubles can be.
    DoublesApart,
    /// Powers of ten that are all beyond the limit, or at it.
    AtLimit,
    /// Fractions with denominators that have little in common.
    Fraction,
    /// Fractions of many digits.
    WideFraction,
    /// Positions of a strictly convex chain.
    Chain,
    /// Square roots, of which no two differences are alike.
    Root,
    /// Texts that are no numbers.
    Junk,
}

const USUAL: [Written; 11] = [
    Written::Digit,
    Written::Short,
    Written::Double,
    Written::Wide,
    Written::Far,
    Written::DoublesApart,
    Written::AtLimit,
    Written::Fraction,
    Written::WideFraction,
    Written::Chain,
    Written::Root,
];

/// A way of writing that gives numbers.
pub(super) fn written(rng: &mut ChaCha8Rng) -> Written {
    one_of(rng, &USUAL)
}

/// Digits, of which the first is not 0.
pub(super) fn digits(rng: &mut ChaCha8Rng, count: usize) -> String {
    let first = char::from(rng.random_range(b'1'..=b'9'));
    std::iter::once(first).chain((1..count).map(|_| char::from(rng.random_range(b'0'..=b'9')))).collect()
}

/// A number of a row, counted from 0.
pub(super) fn number(rng: &mut ChaCha8Rng, written: Written, row: usize) -> String {
    let sign = if rng.random_bool(0.3) { "-" } else { "" };
    let far = |rng: &mut ChaCha8Rng, most: i32| {
        let places = rng.random_range(1..4);
        format!("{sign}{}e{}", digits(rng, places), rng.random_range(-most..=most))
    };
    match written {
        Written::Digit => rng.random_range(-3..=9).to_string(),
        Written::Short => {
            let places = rng.random_range(1..8);
            format!("{sign}{}.{}", rng.random_range(0..100), digits(rng, places))
        }
        Written::Double => format!("{sign}{}.{}", rng.random_range(0..9), digits(rng, 16)),
        Written::Wide => {
            let (whole, places) = (rng.random_range(1..200), rng.random_range(1..200));
            format!("{sign}{}.{}", digits(rng, whole), digits(rng, places))
        }
        Written::Far => far(rng, 9_990),
        Written::DoublesApart => far(rng, 300),
        Written::AtLimit => {
            let exponent = one_of(rng, &[9_999, 10_000, -10_000, -9_999, 10_001, 999_999_999]);
            format!("{sign}{}e{exponent}", rng.random_range(1..10))
        }
        Written::Fraction => {
            let (above, below) = (rng.random_range(1..10), rng.random_range(1..10));
            format!("{sign}{}/{}", digits(rng, above), digits(rng, below))
        }
        Written::WideFraction => {
            let (above, below) = (rng.random_range(1..300), rng.random_range(1..300));
            format!("{sign}{}/{}", digits(rng, above), digits(rng, below))
        }
        Written::Chain => (row * (row + 1) / 2).to_string(),
        Written::Root => format!("{:.15}", (row as f64 + 0.5).sqrt()),
        Written::Junk => one_of(rng, &["", "NA", "x", "1e", "1/0", "1_000", "nan", "2024-01-01"]).to_owned(),
    }
}

/// An error bound or another number for an option: small beside the readings, as large as they are, or far apart.
pub(super) fn bound(rng: &mut ChaCha8Rng) -> String {
    match rng.random_range(0..14) {
        0 => "0".to_owned(),
        1 | 2 => "0.1".to_owned(),
        3 => "1000000".to_owned(),
        4 => "1e9999".to_owned(),
        5 => "1e-9999".to_owned(),
        6 => "1e300".to_owned(),
        7 => "min".to_owned(),
        8 => format!("{}*min", rng.random_range(1..9)),
        9 => "1/7".to_owned(),
        10 => "0.01*|y| + 1e-3".to_owned(),
        11 => "written".to_owned(),
        12 => {
            let places = rng.random_range(1..400);
            format!("{}/{}", digits(rng, places), digits(rng, places))
        }
        _ => "1".to_owned(),
    }
}
