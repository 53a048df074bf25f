//! What a solution file says, whatever its format.

use boundfit_exact::{Limits, Rational, Reading};
use boundfit_lp::{BoundClaim, Claimed, PuiEnd};

use super::error::{ClaimError, quoted};

/// One solver's answer to one program.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Solution {
    /// Who writes such files.
    pub(super) format: &'static str,
    /// The program that the content names.
    pub(super) target: Option<PuiEnd>,
    /// How it ended.
    pub(super) status: Status,
    /// θ1 and θ2, where the status is optimal; `None` where one is infinite or not a number.
    pub(super) point: Option<[Rational; 2]>,
    /// The size of each row's dual, in the order of the file. Signs differ between solvers and are left out: each row is a
    /// bound on one side only.
    pub(super) duals: Option<Vec<f64>>,
}

/// How a solver ended.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Status {
    Optimal,
    Infeasible,
    Unbounded,
    InfeasibleOrUnbounded,
    /// Without an answer, in its own words.
    Other(String),
}

impl Status {
    /// The status that words say, as far as solvers agree on them.
    pub(super) fn of_words(words: &str) -> Self {
        let lower = words.trim().to_ascii_lowercase();
        let is_infeasible = lower.contains("infeasible");
        match lower.as_str() {
            // GLPK calls a point of its way there so.
            "infeasible (intermediate)" => Status::Other(words.trim().to_owned()),
            _ if is_infeasible && lower.contains("unbounded") => Status::InfeasibleOrUnbounded,
            _ if lower.starts_with("optimal") => Status::Optimal,
            _ if lower.starts_with("unbounded") => Status::Unbounded,
            _ if lower.starts_with("infeasible") || lower == "integer infeasible" => Status::Infeasible,
            _ => Status::Other(words.trim().to_owned()),
        }
    }
}

impl Solution {
    /// What the solution claims about the end that its program is about.
    pub(super) fn claim(self, target: PuiEnd) -> BoundClaim {
        match (self.status, self.point) {
            (Status::Infeasible, _) => BoundClaim::bare(Claimed::Infeasible),
            (Status::Unbounded, _) => BoundClaim::bare(Claimed::Unbounded),
            (Status::InfeasibleOrUnbounded, _) => BoundClaim::bare(Claimed::InfeasibleOrUnbounded),
            (Status::Other(words), _) => {
                BoundClaim::nothing(&format!("the solver's status is {}", quoted(&words)))
            }
            (Status::Optimal, None) => BoundClaim::nothing("an optimum that is not finite"),
            (Status::Optimal, Some(point)) => BoundClaim::attained(target, point, self.duals),
        }
    }
}

/// A number as a solver prints it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Printed {
    Finite(Rational),
    /// `inf`, `nan` or a relative of theirs.
    NotFinite,
}

/// The two variables as far as they were met.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct PrintedPoint([Option<Printed>; 2]);

impl PrintedPoint {
    /// Takes the value of a variable. Others than θ1 and θ2 are passed over.
    pub(super) fn set(&mut self, name: &str, value: Printed) {
        let [first, second] = &mut self.0;
        match name {
            "theta1" => *first = Some(value),
            "theta2" => *second = Some(value),
            _ => {}
        }
    }

    /// Takes 0 for what was not met, as solvers do that leave zeros out.
    pub(super) fn or_zero(self) -> Self {
        PrintedPoint(self.0.map(|value| value.or_else(|| Some(Printed::Finite(Rational::zero())))))
    }

    /// Both values if they are finite, and `None` otherwise.
    ///
    /// # Errors
    /// With the name of a variable that was not met.
    pub(super) fn finish(self) -> Result<Option<[Rational; 2]>, &'static str> {
        match self.0 {
            [None, _] => Err("a value of theta1"),
            [_, None] => Err("a value of theta2"),
            [Some(Printed::Finite(theta1)), Some(Printed::Finite(theta2))] => Ok(Some([theta1, theta2])),
            _ => Ok(None),
        }
    }
}

/// A line of a solution file, for its words and for what is wrong with them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Line<'a> {
    pub(super) format: &'static str,
    /// From 1.
    pub(super) number: usize,
    pub(super) text: &'a str,
}

impl<'a> Line<'a> {
    /// The lines of a file.
    pub(super) fn all(format: &'static str, text: &'a str) -> impl Iterator<Item = Line<'a>> + Clone {
        (1..).zip(text.lines()).map(move |(number, text)| Line { format, number, text })
    }

    pub(super) fn words(&self) -> Vec<&'a str> {
        self.text.split_whitespace().collect()
    }

    /// The line is not what it should be.
    pub(super) fn expected(&self, expected: &'static str) -> ClaimError {
        ClaimError::Line { format: self.format, line: self.number, text: quoted(self.text), expected }
    }

    /// Reads a number, exactly as it is printed.
    pub(super) fn number(&self, text: &str, limits: &Limits) -> Result<Printed, ClaimError> {
        let lower = text.trim_start_matches(['+', '-']).to_ascii_lowercase();
        if ["inf", "infinity", "nan", "1.#inf", "1.#ind"].contains(&lower.as_str()) {
            return Ok(Printed::NotFinite);
        }
        let read = Reading::Decimal.read(text, limits);
        read.map(Printed::Finite).map_err(|error| ClaimError::NumberAt {
            format: self.format,
            line: self.number,
            text: quoted(text),
            error,
        })
    }

    /// Reads the size of a dual. Only which is larger matters.
    pub(super) fn dual(&self, text: &str, limits: &Limits) -> Result<f64, ClaimError> {
        Ok(match self.number(text, limits)? {
            Printed::Finite(value) => value.to_f64().abs(),
            Printed::NotFinite => 0.0,
        })
    }
}
