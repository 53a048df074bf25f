//! The deviation up to which an answer is not refuted.

use boundfit_ask::{Refusal, ValueProblem};
use boundfit_exact::{Limits, Rational, Reading};
use clap::{Args, ValueEnum};

use crate::exit::Failure;

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
    /// The tolerance, at least 0. Limits that are lower than usual are meant for the data: they leave this alone.
    pub(crate) fn value(&self, asked: &Limits) -> Result<Rational, Failure> {
        if self.strict {
            return Ok(Rational::zero());
        }
        let refuse = |problem: ValueProblem| {
            Failure::misused(Refusal::Value { key: "tolerance", text: self.tolerance.clone(), problem })
        };
        let usual = Limits::default();
        let limits =
            Limits { digits: asked.digits.max(usual.digits), exponent: asked.exponent.max(usual.exponent) };
        let expected = "expected a number that is at least 0, such as 1e-6";
        let tolerance = Reading::Decimal.read(&self.tolerance, &limits);
        let tolerance = tolerance.map_err(|error| refuse(ValueProblem::Number { error, expected }))?;
        if tolerance.is_negative() { Err(refuse(ValueProblem::Expected(expected))) } else { Ok(tolerance) }
    }
}
