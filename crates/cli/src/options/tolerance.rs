//! The deviation up to which an answer is not refuted.

use boundfit_ask::Given;
use clap::{Args, ValueEnum};

/// A choice whether something is done.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Switch {
    On,
    Off,
}

/// The distance that an answer may be off.
#[derive(Debug, Args)]
pub(crate) struct ToleranceArguments {
    /// Allowed error of an answer on either side, relative to its size: of an optimum, a row, a price
    #[arg(long, value_name = "NUM", default_value = "1e-6", allow_hyphen_values = true)]
    tolerance: String,
    /// Excuse only rounding, for users who need safe bounds: a tolerance of 0
    #[arg(long, conflicts_with = "tolerance")]
    strict: bool,
    /// Take numbers in texts as precise as printed; off: as exact
    #[arg(long, value_name = "on|off", value_enum, default_value_t = Switch::On, hide_possible_values = true)]
    pub(crate) digits_as_printed: Switch,
}

impl ToleranceArguments {
    /// The tolerance in the words of a request.
    pub(crate) fn given(&self) -> Given {
        if self.strict { Given::Integer(0) } else { Given::Read(self.tolerance.clone()) }
    }
}
