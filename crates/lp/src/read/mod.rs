//! Linear programs out of files, every number exactly as it is spelled.
//!
//! The sources of the MPS format, in free form and in the columns of the fixed one, are the CPLEX, HiGHS and GLPK
//! manuals. The source of the LP format is "CPLEX file formats" (IBM). Where readers differ, `docs/lp-files.md` says
//! what is done here.

mod bounds;
mod error;
mod lp_format;
mod mps;
mod names;
mod text;

#[cfg(test)]
mod tests;

use std::str;

use boundfit_exact::Limits;

use crate::format::ExchangeFormat;
use crate::model::Model;

pub(crate) use lp_format::{ends_name, is_keyword};

pub use error::{ModelError, ModelErrorKind, ModelPlace};

/// The limits of a file. A file beyond a limit is refused before memory is taken for it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ModelLimits {
    /// The limits of one number.
    pub number: Limits,
    /// Bytes of one line.
    pub line: usize,
    /// Rows, those of type N included.
    pub rows: usize,
    /// Columns.
    pub columns: usize,
    /// Coefficients, those in rows of type N included.
    pub entries: usize,
}

impl Default for ModelLimits {
    /// The default limits of numbers, 16,777,216 bytes, 10,000,000 rows, 100,000 columns and 100,000,000 coefficients.
    fn default() -> Self {
        ModelLimits {
            number: Limits::default(),
            line: 1 << 24,
            rows: 10_000_000,
            columns: 100_000,
            entries: 100_000_000,
        }
    }
}

/// Reads a linear program. Exact: no number is rounded. Cost: linear in the text, but for the digits of single numbers.
///
/// ```
/// use boundfit_lp::{ExchangeFormat, ModelLimits, read_model};
///
/// let text = "ROWS\n N cost\n G demand\nCOLUMNS\n x cost 0.1 demand 1\nRHS\n RHS demand 3\nENDATA\n";
/// let model = read_model(text, ExchangeFormat::Mps, &ModelLimits::default())?;
/// assert_eq!(model.columns[0].cost.to_string(), "1/10");
/// # Ok::<(), boundfit_lp::ModelError>(())
/// ```
///
/// # Errors
/// With line, column and text of what is not understood, is no linear program, or passes a limit.
pub fn read_model(text: &str, format: ExchangeFormat, limits: &ModelLimits) -> Result<Model, ModelError> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    match format {
        ExchangeFormat::Mps => mps::read(text, limits),
        ExchangeFormat::Lp => lp_format::read(text, limits),
    }
}

/// The bytes of a file as text.
///
/// # Errors
/// For bytes that are not UTF-8, with their place, and for UTF-16, which begins with a mark.
pub fn model_text(bytes: &[u8]) -> Result<&str, ModelError> {
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        return Err(ModelError::of_file(ModelErrorKind::Utf16));
    }
    str::from_utf8(bytes).map_err(|error| {
        let (valid, _) = bytes.split_at_checked(error.valid_up_to()).unwrap_or((bytes, &[]));
        let valid = str::from_utf8(valid).unwrap_or_default();
        let before = valid.rsplit('\n').next().unwrap_or_default();
        let place = ModelPlace {
            line: valid.matches('\n').count() as u64 + 1,
            column: before.chars().count() + 1,
            text: before.into(),
        };
        ModelError { place: Some(Box::new(place)), kind: ModelErrorKind::NotUtf8 }
    })
}
