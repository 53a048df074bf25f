//! The options about errors in x.

use boundfit_ask::{Given, Readings};
use clap::Args;

/// Errors in x.
#[derive(Debug, Args)]
pub(crate) struct XErrorArguments {
    /// Bound on the errors of x as well: a number, or else the column with the bound of each reading. A line then
    /// agrees with a reading if it meets its box
    #[arg(long, value_name = "NUM|COL", allow_hyphen_values = true)]
    pub(super) x_eps: Option<String>,
    /// Column with the bound on the error of each x, by name or by number
    #[arg(long, value_name = "COL")]
    pub(super) x_eps_column: Option<String>,
    /// With errors in x: a line must agree for every x within the errors, and not only for some
    #[arg(long)]
    pub(super) strong: bool,
}

impl XErrorArguments {
    /// These readings, with what is said of the errors of their x.
    pub(crate) fn beside(&self, readings: Readings) -> Readings {
        Readings {
            x_eps: self.x_eps.clone().map(Given::Read),
            x_eps_column: self.x_eps_column.clone(),
            strong: self.strong,
            ..readings
        }
    }

    /// The errors of x.
    pub(crate) fn are_asked(&self) -> bool {
        self.x_eps.is_some() || self.x_eps_column.is_some()
    }
}
