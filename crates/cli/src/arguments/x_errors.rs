//! The options about errors in x.

use boundfit_ask::{AskedXBounds, Misuse, XErrors};
use boundfit_exact::{Limits, Reading};
use boundfit_formats::ColumnSelector;
use boundfit_questions::Agreement;
use clap::Args;

use super::values::{number_problem, parse_column};
use crate::exit::Failure;

/// Errors in x.
#[derive(Debug, Args)]
pub(crate) struct XErrorArguments {
    /// Bound on the errors of x as well: a number, or else the column with the bound of each reading. A line then
    /// agrees with a reading if it meets its box
    #[arg(long, value_name = "NUM|COL", allow_hyphen_values = true, conflicts_with = "x_eps_column")]
    x_eps: Option<String>,
    /// Column with the bound on the error of each x, by name or by number
    #[arg(long, value_name = "COL", value_parser = parse_column)]
    x_eps_column: Option<ColumnSelector>,
    /// With errors in x: a line must agree for every x within the errors, and not only for some
    #[arg(long)]
    strong: bool,
}

impl XErrorArguments {
    /// Returns whether x has errors.
    ///
    /// # Errors
    /// When strong agreement is asked for without them.
    pub(crate) fn are_asked(&self) -> Result<bool, Failure> {
        match self.x_eps.is_some() || self.x_eps_column.is_some() {
            false if self.strong => Err(Failure::misuse(Misuse::StrongAlone)),
            are_asked => Ok(are_asked),
        }
    }

    /// The errors of x, where they are asked for. A text that is a number is one, and any other the name of a column.
    pub(super) fn asked(&self, reading: Reading, limits: &Limits) -> Result<Option<XErrors>, Failure> {
        let refuse = |text: &str, problem: String| Failure::value("--x-eps <NUM|COL>", text, problem);
        let bounds = match (&self.x_eps, &self.x_eps_column) {
            (None, None) => return Ok(None),
            (None, Some(column)) => AskedXBounds::Column(column.clone()),
            (Some(text), _) => match reading.read(text, limits) {
                Ok(number) if number.is_negative() => {
                    let expected = "expected a number that is at least 0, such as 0.15, or a column";
                    return Err(refuse(text, format!("negative ({expected})")));
                }
                Ok(number) => AskedXBounds::Uniform(number),
                Err(error) if error.kind.is_limit() => return Err(refuse(text, number_problem(&error, ""))),
                Err(_) => AskedXBounds::Column(parse_column(text).map_err(|problem| refuse(text, problem))?),
            },
        };
        let agreement = if self.strong { Agreement::Strong } else { Agreement::Weak };
        Ok(Some(XErrors { bounds, agreement }))
    }
}
