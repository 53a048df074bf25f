//! Exact numbers as decimal text.

use boundfit_exact::{Decimal, Rational};

/// The decimal that is the number, digit for digit, or `None` where no finite decimal is: `0.5`, `1.25e-20`. Exact.
/// Cost: that of some divisions of numbers as long as the result.
pub(super) fn finite_decimal(value: &Rational) -> Option<String> {
    exact_decimal(value).map(|decimal| decimal.compact().to_string())
}

/// Whether a finite decimal is the number. Exact. Cost: as [`finite_decimal`].
pub(super) fn has_finite_decimal(value: &Rational) -> bool {
    exact_decimal(value).is_some()
}

fn exact_decimal(value: &Rational) -> Option<Decimal<'_>> {
    /// What machine words can write, which is enough for nearly every number that was read.
    const FEW: usize = 18;
    if let Some(short) = value.exact_decimal(FEW) {
        return Some(short);
    }
    // A denominator that divides a power of ten divides that of its length in bits; of a whole number, three bits take less
    // than a digit.
    let digits = value.numerator().bits() / 3 + 1 + value.denominator().bits();
    value.exact_decimal(usize::try_from(digits).ok()?)
}

#[cfg(test)]
mod tests {
    use boundfit_exact::{Limits, Reading};

    use super::*;

    fn number(text: &str) -> Rational {
        Reading::Decimal.read(text, &Limits::default()).unwrap()
    }

    #[test]
    fn decimals_keep_every_digit() {
        for (value, text) in [
            ("0", "0"),
            ("1/2000", "5e-4"),
            ("-1/2000", "-5e-4"),
            ("1700000050.809414445", "1700000050.809414445"),
            ("12300", "12300"),
            ("1e15", "1e15"),
            ("-12e30", "-1.2e31"),
            ("1e9999", "1e9999"),
            ("1e-16", "1e-16"),
            ("1e-17", "1e-17"),
            ("-1.25e-20", "-1.25e-20"),
            ("10", "10"),
            ("7/64", "0.109375"),
            ("3/125", "2.4e-2"),
        ] {
            assert_eq!(finite_decimal(&number(value)).as_deref(), Some(text), "{value}");
        }
        for value in ["1/3", "-5/14", "1/30"] {
            assert_eq!(finite_decimal(&number(value)), None, "{value}");
        }
        let tenth = Rational::from_f64(0.1).unwrap();
        let digits = "0.1000000000000000055511151231257827021181583404541015625";
        assert_eq!(finite_decimal(&tenth).as_deref(), Some(digits));
        for double in [5e-324, 1.7e308, -2.5e-10, 123_456.789, 1e22] {
            let value = Rational::from_f64(double).unwrap();
            assert_eq!(number(&finite_decimal(&value).unwrap()), value, "{double}");
        }
    }
}
