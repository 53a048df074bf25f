//! The four programs behind the parameter uncertainty intervals, by name and as files.

use boundfit_estimation::BoundName;
use boundfit_exact::Rational;
use boundfit_lp::{End, ExchangeFormat, ExchangeProgram, ExchangeRow, Sense};

use crate::rows::ProgramRows;

/// One of the four programs: the minimum or the maximum of one parameter over the FPS.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Target {
    /// The smallest θ1.
    Theta1Min,
    /// The largest θ1.
    Theta1Max,
    /// The smallest θ2.
    Theta2Min,
    /// The largest θ2.
    Theta2Max,
}

impl Target {
    /// All four, in the order of claims.
    pub const ALL: [Target; 4] = [Target::Theta1Min, Target::Theta1Max, Target::Theta2Min, Target::Theta2Max];

    /// The name of the program and of its file: `theta1-min`.
    pub fn name(self) -> &'static str {
        match self {
            Target::Theta1Min => "theta1-min",
            Target::Theta1Max => "theta1-max",
            Target::Theta2Min => "theta2-min",
            Target::Theta2Max => "theta2-max",
        }
    }

    /// The name of the program's objective: `theta1_min`.
    pub fn objective_name(self) -> &'static str {
        match self {
            Target::Theta1Min => "theta1_min",
            Target::Theta1Max => "theta1_max",
            Target::Theta2Min => "theta2_min",
            Target::Theta2Max => "theta2_max",
        }
    }

    /// The parameter: 0 for θ1, 1 for θ2.
    pub fn axis(self) -> usize {
        match self {
            Target::Theta1Min | Target::Theta1Max => 0,
            Target::Theta2Min | Target::Theta2Max => 1,
        }
    }

    /// The end of its interval.
    pub fn end(self) -> End {
        match self {
            Target::Theta1Min | Target::Theta2Min => End::Lower,
            Target::Theta1Max | Target::Theta2Max => End::Upper,
        }
    }

    /// The form to be minimised: ±θ1 or ±θ2.
    pub fn objective(self) -> [Rational; 2] {
        let unit = |theta1: i64, theta2: i64| [Rational::from(theta1), Rational::from(theta2)];
        match self {
            Target::Theta1Min => unit(1, 0),
            Target::Theta1Max => unit(-1, 0),
            Target::Theta2Min => unit(0, 1),
            Target::Theta2Max => unit(0, -1),
        }
    }

    /// The target that a text names last, as `theta1-min` or `theta1_min`, with the text before and after it.
    pub fn find(text: &str) -> Option<(&str, Target, &str)> {
        let names = Target::ALL
            .into_iter()
            .flat_map(|target| [(target, target.name()), (target, target.objective_name())]);
        let found = names.filter_map(|(target, name)| Some((text.rfind(name)?, target, name)));
        let (place, target, name) = found.max_by_key(|(place, ..)| *place)?;
        let (before, rest) = text.split_at_checked(place)?;
        Some((before, target, rest.strip_prefix(name)?))
    }
}

/// The rows of a fit, ready to be written as files for other solvers.
#[derive(Debug, Clone)]
pub struct ExchangeRows(Vec<ExchangeRow>);

impl ExchangeRows {
    /// The rows in their order, named after data row and bound: `row14_upper`, `row14_lower` (written with ≥), `where_1`.
    pub fn new(rows: &ProgramRows) -> Self {
        let named = rows.rows().iter().zip(rows.names()).map(|(row, name)| {
            let (name, sense) = match name {
                BoundName::Upper(row) => (format!("row{row}_upper"), Sense::AtMost),
                BoundName::Lower(row) => (format!("row{row}_lower"), Sense::AtLeast),
                BoundName::Where(number) => (format!("where_{number}"), Sense::AtMost),
            };
            ExchangeRow::new(name, &row.row, sense)
        });
        ExchangeRows(named.collect())
    }

    /// The file of one program, with comments at its top. Exact; see [`ExchangeProgram::text`].
    pub fn text(&self, target: Target, format: ExchangeFormat, comments: &[String]) -> String {
        let program = ExchangeProgram {
            name: target.name(),
            objective_name: target.objective_name(),
            objective: target.objective(),
            rows: &self.0,
            comments,
        };
        program.text(format)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_name_counts() {
        assert_eq!(
            Target::find("out/glpk-theta2-max.mps.sol"),
            Some(("out/glpk-", Target::Theta2Max, ".mps.sol"))
        );
        assert_eq!(Target::find("theta1-min/theta1_max"), Some(("theta1-min/", Target::Theta1Max, "")));
        assert_eq!(Target::find("theta3-min theta1 min"), None);
    }
}
