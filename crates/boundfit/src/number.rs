//! Numbers that are taken exactly.

use boundfit_exact::{Integer, Limits, ParseNumberError, Rational, Reading};
use num_rational::{BigRational, Ratio};
use thiserror::Error;

/// A number that has an exact value.
///
/// | type | its value |
/// |---|---|
/// | `i8` to `i128`, `u8` to `u128`, `isize`, `usize` | the integer |
/// | `f32`, `f64` | the dyadic fraction that the float is: 0.1 is 3602879701896397/36028797018963968 |
/// | `str`, `String` | the decimal or fraction as written: "0.1" is 1/10, "5e-4" is 1/2000, "7/19" is 7/19 |
/// | [`Rational`], [`Integer`], `BigRational`, `Ratio<i64>` | itself |
///
/// Readings that were printed as decimals and then parsed as floats are no longer what was printed. Where it matters, hand
/// over the text.
pub trait Number {
    /// The exact value.
    ///
    /// # Errors
    /// When a float is not finite, or a text is not a number or one of too many digits.
    fn exact(&self) -> Result<Rational, NumberError>;

    /// The text of a number that is one, which tells how many digits were written.
    fn text(&self) -> Option<&str> {
        None
    }
}

/// The reason why something has no exact value.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum NumberError {
    /// A float that is NaN or infinite.
    #[error("{0} is not a finite number")]
    NotFinite(f64),
    /// A text that is not a number.
    #[error("{text:?} is not a number: {problem}")]
    Text {
        /// The text.
        text: String,
        /// The problem with it, and its place.
        problem: ParseNumberError,
    },
}

impl<N: Number + ?Sized> Number for &N {
    fn exact(&self) -> Result<Rational, NumberError> {
        (**self).exact()
    }

    fn text(&self) -> Option<&str> {
        (**self).text()
    }
}

impl Number for str {
    fn exact(&self) -> Result<Rational, NumberError> {
        let number = Reading::Decimal.read(self, &Limits::default());
        number.map_err(|problem| NumberError::Text { text: self.to_owned(), problem })
    }

    fn text(&self) -> Option<&str> {
        Some(self)
    }
}

impl Number for String {
    fn exact(&self) -> Result<Rational, NumberError> {
        self.as_str().exact()
    }

    fn text(&self) -> Option<&str> {
        Some(self)
    }
}

impl Number for f64 {
    fn exact(&self) -> Result<Rational, NumberError> {
        Rational::from_f64(*self).ok_or(NumberError::NotFinite(*self))
    }
}

impl Number for f32 {
    fn exact(&self) -> Result<Rational, NumberError> {
        // Every float of 32 bits is one of 64 bits.
        f64::from(*self).exact()
    }
}

macro_rules! integers {
    ($($integer:ty),*) => {
        $(impl Number for $integer {
            fn exact(&self) -> Result<Rational, NumberError> {
                Ok(Rational::from(Integer::from(*self)))
            }
        })*
    };
}

integers!(i8, i16, i32, i64, i128, isize, u8, u16, u32, u64, u128, usize);

impl Number for Rational {
    fn exact(&self) -> Result<Rational, NumberError> {
        Ok(self.clone())
    }
}

impl Number for Integer {
    fn exact(&self) -> Result<Rational, NumberError> {
        Ok(Rational::from(self.clone()))
    }
}

impl Number for BigRational {
    fn exact(&self) -> Result<Rational, NumberError> {
        Ok(Rational::from(self.clone()))
    }
}

impl Number for Ratio<i64> {
    fn exact(&self) -> Result<Rational, NumberError> {
        Ok(Rational::from(*self))
    }
}
