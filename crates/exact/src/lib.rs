//! Exact numbers: the only arithmetic that decides anything in boundfit.
//!
//! A [`Rational`] is read from decimal text or a fraction ([`Reading::read`]) and computed with exactly. It leaves
//! exactly (its [`Display`](std::fmt::Display) form `p/q`) or as a decimal rounded in a stated direction
//! ([`Rational::to_decimal`]). The nearest binary64 ([`Rational::to_f64`]) is the one door to floating point.
//!
//! | to | modules |
//! |---|---|
//! | hold numbers | `number`, `decimal`, `dyadic`, `wide`, `interval`, `column` |
//! | read text | `parse`, `plain`, `long_decimal`, `notation`, `written`, `limit` |
//! | write decimals | `decimal`, `shortest`, `serial`, `latex` |
//! | add many numbers | `sum`, `long_sum`, `decimal_sum`, `double_sum`, `wide_sum`, `multiples`, `work` |
//! | convert to and from doubles | `binary64` |
//! | print texts from outside, and English | `foreign`, `english` |
//!
//! ```
//! use boundfit_exact::{Limits, Rational, Reading, Rounding};
//!
//! let epsilon = Reading::Decimal.read("5e-4", &Limits::default())?;
//! assert_eq!(epsilon, Rational::ratio(1, 2000));
//! let third = Rational::ratio(1, 3);
//! assert_eq!(third.to_decimal(3, Rounding::Up), "0.334");
//! # Ok::<(), boundfit_exact::ParseNumberError>(())
//! ```

// Code that reads input never panics on it; exceptions stand at the smallest item, with the proof that it holds.
#![deny(clippy::expect_used, clippy::indexing_slicing, clippy::panic, clippy::unwrap_used)]

mod binary64;
mod column;
mod decimal;
mod decimal_sum;
mod double_sum;
mod dyadic;
pub mod english;
mod foreign;
mod interval;
pub mod latex;
mod limit;
mod long_decimal;
mod long_sum;
mod multiples;
mod notation;
mod number;
mod parse;
mod plain;
mod powers_of_ten;
mod serial;
mod shortest;
mod sum;
mod wide;
mod wide_sum;
mod work;
mod written;

pub use binary64::{nearest_double, nearest_long_double, plain_double, significand_and_exponent};
pub use column::{
    Column, Count, Long, LongProducts, LongTotal, NarrowCount, NarrowUnit, Scaled, Scattered, Unit,
    compare_words,
};
pub use decimal::{Decimal, PlacedDecimal, PlusMinus, Rounding, WideQuotient};
pub use decimal_sum::DecimalSum;
pub use double_sum::DoubleSum;
pub use dyadic::Dyadic;
pub use foreign::Foreign;
pub use interval::{Endpoint, Interval, fewest_digits};
pub use limit::Limit;
pub use long_decimal::{LONG_DIGITS, LongPrefix, long_prefix};
pub use long_sum::LongSum;
pub use multiples::multiples;
pub use notation::{DecimalMark, MISSING_WORDS, Notation, Thousands, is_missing, trim_number};
pub use number::{Fraction, Integer, Rational, Sign, TooWide};
pub use parse::{Limits, ParseNumberError, ParseNumberErrorKind, Reading, characters_before};
pub use plain::{
    Others, PLAIN_DIGITS, PLAIN_EXPONENT, PlainPrefix, ShortPrefix, exponent_prefix, long_plain_prefix,
    plain_decimal, plain_prefix, short_prefix,
};
pub use shortest::{Shortest, shortest_decimal, shortest_decimal_of_f32};
pub use sum::Sum;
pub use wide::Wide;
pub use wide_sum::{WideProducts, WideSum};
pub use work::{LongNumbers, MOST_WORK, TooMuchWork, Work, WorkMeter};
pub use written::WrittenDigits;
