//! The numbers of a row over one denominator: in machine words, or in integers of any size.

use std::borrow::Cow;

use boundfit_exact::{Integer, Rational};

/// The numbers of a row over one denominator.
pub(crate) struct Exact {
    pub(crate) integers: Vec<Integer>,
    pub(crate) one: Integer,
}

/// The number that a cell spells.
pub(crate) enum Number {
    /// mantissa / 10^places.
    Decimal { mantissa: i64, places: u32 },
    /// Anything else.
    Fraction(Rational),
}

impl Number {
    /// mantissa · 10^exponent.
    pub(crate) fn decimal(mantissa: i64, exponent: i64) -> Self {
        match u32::try_from(-exponent) {
            Ok(places) => Number::Decimal { mantissa, places },
            Err(_) => Number::Fraction(Rational::scientific(mantissa, exponent)),
        }
    }

    pub(crate) fn abs(self) -> Self {
        match self {
            Number::Decimal { mantissa: mantissa @ 0.., places } => Number::Decimal { mantissa, places },
            Number::Decimal { mantissa, places } => {
                Number::Fraction(Rational::scientific(mantissa, -i64::from(places)).abs())
            }
            Number::Fraction(number) => Number::Fraction(number.abs()),
        }
    }
}

/// Multiplies decimals by a power of ten with which they are machine words; `None` where there is none.
pub(crate) fn words_over_one_denominator(
    plain: &[(i64, u32)],
    powers: &[i64],
    words: &mut Vec<i64>,
) -> Option<()> {
    let most = plain.iter().map(|(_, places)| *places).max()?;
    words.clear();
    for (mantissa, places) in plain {
        words.push(mantissa.checked_mul(*powers.get((most - places) as usize)?)?);
    }
    Some(())
}

/// Multiplies numbers, 0 in place of one that is not there, by a common denominator.
pub(crate) fn over_one_denominator(numbers: &[Option<Number>], powers: &[Integer]) -> Exact {
    let power = |places: u32| match powers.get(places as usize) {
        Some(power) => Cow::Borrowed(power),
        None => Cow::Owned(Integer::power_of_ten(places)),
    };
    let (mut places, mut divisor) = (0, Integer::one());
    for number in numbers.iter().flatten() {
        match number {
            Number::Decimal { places: own, .. } => places = places.max(*own),
            Number::Fraction(number) => divisor = divisor.lcm(&number.denominator()),
        }
    }
    let is_whole = divisor == Integer::one();
    let integers = numbers.iter().map(|number| match number {
        None => Integer::zero(),
        Some(Number::Decimal { mantissa, places: own }) => {
            let integer = Integer::from(*mantissa) * &*power(places - own);
            if is_whole { integer } else { integer * &divisor }
        }
        Some(Number::Fraction(number)) => {
            number.numerator() * &*power(places) * divisor.quotient(&number.denominator())
        }
    });
    Exact { integers: integers.collect(), one: &*power(places) * &divisor }
}
