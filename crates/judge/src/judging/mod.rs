//! Judging what a solver answers about a model: each aspect on its own, exactly.

mod certificates;
mod dual;
mod finding;
mod ground;
mod measure;
mod primal;
#[cfg(test)]
mod tests;

use boundfit_exact::{Foreign, Rational};
use boundfit_lp::Model;

use crate::answer::{Answer, Item};
use crate::solution::{NotFinite, Part, Solution, SolverStatus};

pub use finding::{Aspect, Excuse, Fault, Finding, OtherProgram, Tolerances, Worth};
pub use ground::Ground;
use measure::Measure;

/// The findings about one solution.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Findings {
    /// One for each aspect that the solution says something about, in the order of [`Aspect::ALL`].
    pub findings: Vec<Finding>,
}

/// A solution with what was found about it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct JudgedSolution {
    /// The file, as it was named.
    pub file: Foreign,
    /// The solution that the file gives.
    pub solution: Solution,
    /// The findings about it.
    pub findings: Findings,
}

impl Findings {
    /// The worst of all; [`Worth::NoAnswer`] where there is none.
    pub fn worst(&self) -> Worth {
        self.findings.iter().map(|finding| finding.worth).max().unwrap_or(Worth::NoAnswer)
    }

    /// Returns whether something is refuted.
    pub fn is_refuted(&self) -> bool {
        self.worst() == Worth::Refuted
    }

    /// Returns what was found about an aspect, if the solution says something about it.
    pub fn about(&self, aspect: Aspect) -> Option<&Finding> {
        self.findings.iter().find(|finding| finding.aspect == aspect)
    }
}

impl Ground<'_> {
    /// Judges a solution: status, objective, primal and dual feasibility, complementary slackness, gap and certificates, each
    /// on its own. Exact. Numbers beyond the model are passed over and missing ones are 0, which [`Solution::of_size`] refuses.
    /// Cost: a pass over the coefficients for each aspect.
    pub fn judge(&self, solution: &Solution, tolerances: &Tolerances) -> Findings {
        let mut findings: Vec<Finding> = [
            self.objective(solution, tolerances),
            self.primal(solution, tolerances),
            self.optimality(solution, tolerances),
        ]
        .into_iter()
        .chain(self.prices(solution, tolerances))
        .chain([self.ray(solution, tolerances), self.farkas(solution, tolerances)])
        .flatten()
        .collect();
        findings.insert(0, self.status(solution, &findings));
        for not_finite in &solution.not_finite {
            let finding = no_number(not_finite);
            // Duals may be refuted though a reduced cost says nothing.
            let place =
                findings.iter().position(|own| own.aspect >= finding.aspect).unwrap_or(findings.len());
            match findings.get_mut(place).filter(|own| own.aspect == finding.aspect) {
                Some(own) if own.worth < finding.worth => *own = finding,
                Some(_) => {}
                None => findings.insert(place, finding),
            }
        }
        Findings { findings }
    }

    /// The status. A wrong one is excused by whatever excuses the point or the prices that come with it.
    fn status(&self, solution: &Solution, others: &[Finding]) -> Finding {
        let exact = match self.answer {
            Answer::Optimal { .. } => "optimal",
            Answer::Infeasible { .. } => "infeasible",
            Answer::Unbounded { .. } => "unbounded",
        };
        let claimed = match &solution.status {
            SolverStatus::Optimal => "optimal",
            SolverStatus::Infeasible => "infeasible",
            SolverStatus::Unbounded => "unbounded",
            SolverStatus::InfeasibleOrUnbounded => "infeasible or unbounded",
            SolverStatus::Other(words) => words,
        };
        let worth = match &solution.status {
            SolverStatus::Other(_) => Worth::NoAnswer,
            SolverStatus::InfeasibleOrUnbounded if exact != "optimal" => Worth::NoAnswer,
            _ if claimed == exact => Worth::Exact,
            _ => Worth::Refuted,
        };
        let blamed = match self.answer {
            Answer::Infeasible { .. } => Aspect::Primal,
            _ => Aspect::Dual,
        };
        let excuse = others.iter().find(|other| other.aspect == blamed && worth == Worth::Refuted);
        let fault = (worth != Worth::Exact).then(|| Fault::Status { claimed: claimed.into(), exact });
        Finding {
            aspect: Aspect::Status,
            worth,
            line: solution.status_line,
            error: None,
            relative: None,
            fault,
            is_negated: false,
            excuse: excuse.and_then(|other| other.excuse.clone()),
        }
    }
}

/// The finding about a number that is not finite.
fn no_number(not_finite: &NotFinite) -> Finding {
    let aspect = match not_finite.part {
        Part::Objective => Aspect::Objective,
        Part::Point => Aspect::Primal,
        Part::Duals | Part::ReducedCosts => Aspect::Dual,
        Part::Ray => Aspect::Ray,
        Part::Farkas => Aspect::Farkas,
    };
    Finding {
        aspect,
        worth: Worth::NoAnswer,
        line: not_finite.line,
        error: None,
        relative: None,
        fault: Some(Fault::NotFinite { part: not_finite.part, item: not_finite.item }),
        is_negated: false,
        excuse: None,
    }
}

/// The value of a row or a column at a point, or what it gains along a direction.
fn value_at(model: &Model, item: Item, point: &[Rational]) -> Rational {
    match item {
        Item::Row(row) => {
            model.rows.get(row).map(|row| crate::certificate::row_value(row, point)).unwrap_or_default()
        }
        Item::Column(column) => point.get(column).cloned().unwrap_or_default(),
    }
}
