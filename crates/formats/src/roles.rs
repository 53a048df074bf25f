//! The values that a column takes from its cells when it is not their number.

use boundfit_exact::{Column, DecimalMark, Rational, Reading, WrittenDigits};

use crate::columns::{ColumnSelector, Role, decode};
use crate::dialect::MissingWords;
use crate::error::InputErrorKind;

/// The values that a column takes from a cell instead of its number, as a mantissa and an exponent of ten; `None` where it takes the
/// number. The decimal mark is not known where no cell has told it.
pub(crate) fn instead_of_number(
    cell: &[u8],
    selector: &ColumnSelector,
    mark: Option<DecimalMark>,
    words: &MissingWords,
) -> Result<Option<(i64, i64)>, InputErrorKind> {
    let is_missing = || Ok::<_, InputErrorKind>(words.are_in(decode(cell)?));
    Ok(match selector.role() {
        Role::Number | Role::NonNegative => None,
        Role::Optional => is_missing()?.then_some((0, 0)),
        Role::Presence => Some((i64::from(!is_missing()?), 0)),
        Role::HalfUnit => Some((5, place_of_last_digit(decode(cell)?, mark)? - 1)),
    })
}

/// Adds what a column takes from a cell instead of its number.
pub(crate) fn add(column: &mut Column, (mantissa, exponent): (i64, i64), reading: Reading, role: Role) {
    match (reading, i32::try_from(exponent)) {
        // These stand among doubles.
        (Reading::Binary64, _) if role == Role::Optional => column.push_double(mantissa as f64),
        (_, Ok(exponent @ -300..=300)) => column.push_decimal(mantissa, exponent),
        _ => column.push(Rational::scientific(mantissa, exponent)),
    }
}

/// The power of ten that the last digit of a number stands for.
fn place_of_last_digit(text: &str, mark: Option<DecimalMark>) -> Result<i64, InputErrorKind> {
    WrittenDigits::of(text, mark).map(|digits| digits.last_place).ok_or(InputErrorKind::NoLastDigit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_a_unit_of_the_last_digit_is_taken_as_it_is_written() {
        let column = ColumnSelector::name_or_number("y").half_unit();
        for (text, expected) in [
            ("12.30", (5, -3)),
            ("12", (5, -1)),
            ("1e3", (5, 2)),
            (" -1.50E-2 ", (5, -5)),
            ("+.5", (5, -2)),
            ("5.", (5, -1)),
            ("0", (5, -1)),
            ("0.000", (5, -4)),
        ] {
            let found = instead_of_number(
                text.as_bytes(),
                &column,
                Some(DecimalMark::Point),
                &MissingWords::default(),
            )
            .unwrap();
            assert_eq!(found, Some(expected), "{text}");
        }
        for (text, mark, expected) in [
            ("12,30", Some(DecimalMark::Comma), (5, -3)),
            ("1.234", Some(DecimalMark::Comma), (5, -1)),
            ("12,30", None, (5, -3)),
            ("1,5D\u{2212}03", None, (5, -5)),
        ] {
            assert_eq!(
                instead_of_number(text.as_bytes(), &column, mark, &MissingWords::default()).unwrap(),
                Some(expected),
                "{text}"
            );
        }
        let fraction = instead_of_number(b"1/3", &column, None, &MissingWords::default()).unwrap_err();
        assert!(matches!(fraction, InputErrorKind::NoLastDigit));
    }

    #[test]
    fn a_missing_side_is_told_from_zero() {
        let side = ColumnSelector::name_or_number("lower");
        for (text, number, presence) in [
            ("", Some((0, 0)), 0),
            (" NA ", Some((0, 0)), 0),
            ("nan", Some((0, 0)), 0),
            ("0", None, 1),
            ("x", None, 1),
        ] {
            assert_eq!(
                instead_of_number(text.as_bytes(), &side.clone().optional(), None, &MissingWords::default())
                    .unwrap(),
                number,
                "{text}"
            );
            let found =
                instead_of_number(text.as_bytes(), &side.clone().presence(), None, &MissingWords::default())
                    .unwrap();
            assert_eq!(found, Some((presence, 0)), "{text}");
        }
    }
}
