//! The values of options that are more than a text or a number.

use boundfit_exact::{Limits, Rational, Reading};
use boundfit_formats::{ColumnSelector, RowRange};

/// The columns of one or two regressors.
#[derive(Debug, Clone)]
pub(crate) struct Regressors {
    pub(crate) first: ColumnSelector,
    pub(crate) second: Option<ColumnSelector>,
}

/// Factors on the error bounds.
#[derive(Debug, Clone)]
pub(crate) struct FactorRange {
    pub(crate) from: Rational,
    pub(crate) to: Rational,
}

/// A row range with the words it was asked for in.
#[derive(Debug, Clone)]
pub(crate) struct AskedRows {
    pub(crate) text: String,
    pub(crate) range: RowRange,
}

pub(super) fn parse_column(text: &str) -> Result<ColumnSelector, String> {
    if text.trim().is_empty() {
        return Err("expected a header name or a column number".to_owned());
    }
    Ok(ColumnSelector::name_or_number(text))
}

pub(super) fn parse_regressors(text: &str) -> Result<Regressors, String> {
    match text.split(',').collect::<Vec<_>>().as_slice() {
        [first] => Ok(Regressors { first: parse_column(first)?, second: None }),
        [first, second] => {
            Ok(Regressors { first: parse_column(first)?, second: Some(parse_column(second)?) })
        }
        _ => Err("expected one column, or two separated by a comma".to_owned()),
    }
}

pub(super) fn parse_factors(text: &str) -> Result<FactorRange, String> {
    let expected = "expected FROM..TO with numbers 0 <= FROM <= TO, such as 0.5..2";
    let number = |text: &str| {
        Reading::Decimal
            .read(text, &Limits::default())
            .map_err(|error| format!("{text:?}: {error} ({expected})"))
    };
    let (from, to) = text.split_once("..").ok_or(expected)?;
    let range = FactorRange { from: number(from.trim())?, to: number(to.trim())? };
    if range.from.is_negative() || range.to < range.from { Err(expected.to_owned()) } else { Ok(range) }
}

pub(super) fn parse_rows(text: &str) -> Result<AskedRows, String> {
    // A row number too large to be counted is beyond the end of any file.
    let number = |text: &str| {
        let digits = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
        digits.then(|| text.parse().unwrap_or(usize::MAX))
    };
    let range = text
        .split_once("..")
        .and_then(|(first, last)| RowRange::new(number(first.trim())?, number(last.trim())?));
    match range {
        Some(range) => Ok(AskedRows { text: text.to_owned(), range }),
        None => Err("expected FIRST..LAST with 1 <= FIRST <= LAST, such as 14..36".to_owned()),
    }
}
