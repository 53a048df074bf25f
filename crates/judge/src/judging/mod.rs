//! Judging what a solver answers about a model: each aspect on its own, exactly.

mod certificates;
mod dual;
mod ground;
mod measure;
mod primal;
#[cfg(test)]
mod tests;

use boundfit_exact::{Foreign, Rational};
use boundfit_lp::Model;

use crate::answer::{Answer, Item, Side};
use crate::solution::{Solution, SolverStatus};

pub use ground::Ground;
pub use measure::Excuse;
use measure::Measure;

/// How far an answer may be from the truth.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Tolerances {
    /// An error counts as within tolerance up to this part of what it is measured by.
    pub relative: Rational,
    /// Whether a number may be half a unit of its last printed digit away from the one that was meant.
    pub digits_as_printed: bool,
}

/// What is judged on its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Aspect {
    /// Optimal, infeasible or unbounded.
    Status,
    /// The optimum that is claimed.
    Objective,
    /// Whether the point fulfils rows and bounds.
    Primal,
    /// Whether the objective at the point is the optimum.
    Optimality,
    /// Whether prices lean on bounds that are there, and reduced costs are what duals leave of the costs.
    Dual,
    /// Whether each price belongs to a bound that the point attains.
    ComplementarySlackness,
    /// Whether the prices prove what the objective is at the point.
    DualityGap,
    /// Whether the ray stays feasible and improves.
    Ray,
    /// Whether the multipliers prove that there is no feasible point.
    Farkas,
}

impl Aspect {
    /// All of them, in the order of reports.
    pub const ALL: [Aspect; 9] = [
        Aspect::Status,
        Aspect::Objective,
        Aspect::Primal,
        Aspect::Optimality,
        Aspect::Dual,
        Aspect::ComplementarySlackness,
        Aspect::DualityGap,
        Aspect::Ray,
        Aspect::Farkas,
    ];

    /// The name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Aspect::Status => "status",
            Aspect::Objective => "objective",
            Aspect::Primal => "primal",
            Aspect::Optimality => "optimality",
            Aspect::Dual => "dual",
            Aspect::ComplementarySlackness => "complementary-slackness",
            Aspect::DualityGap => "duality-gap",
            Aspect::Ray => "ray",
            Aspect::Farkas => "farkas",
        }
    }

    /// What it asks, as a sentence without its end.
    pub fn question(self) -> &'static str {
        match self {
            Aspect::Status => "the status is that of the program",
            Aspect::Objective => "the objective is the optimum",
            Aspect::Primal => "the point fulfils all rows and bounds",
            Aspect::Optimality => "the objective at the point is the optimum",
            Aspect::Dual => "the prices add up to the costs and lean on bounds that are there",
            Aspect::ComplementarySlackness => "each price belongs to a bound that the point attains",
            Aspect::DualityGap => "the prices prove the objective at the point",
            Aspect::Ray => "the ray stays feasible and improves the objective",
            Aspect::Farkas => "the multipliers prove that there is no feasible point",
        }
    }
}

/// What one aspect is worth, from best to worst.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Worth {
    /// There is no error.
    Exact,
    /// What rounding explains: 4 units in the last place of binary64, or half a unit of the last printed digit, of each number.
    Rounded,
    /// Beyond rounding, by no more than the tolerance.
    WithinTolerance,
    /// Nothing was claimed, or one of two statuses, of which one is right.
    NoAnswer,
    /// False by more than the tolerance.
    Refuted,
}

impl Worth {
    /// The name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Worth::Exact => "exact",
            Worth::Rounded => "rounded",
            Worth::WithinTolerance => "within tolerance",
            Worth::NoAnswer => "no answer",
            Worth::Refuted => "refuted",
        }
    }
}

/// What is wrong, where that is known.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Fault {
    /// The status is another one.
    Status {
        /// What is claimed, in the solver's words where it is no answer.
        claimed: Foreign,
        /// `optimal`, `infeasible` or `unbounded`.
        exact: &'static str,
    },
    /// A number is another one.
    Value {
        /// What is claimed.
        claimed: Rational,
        /// What is true.
        exact: Rational,
    },
    /// The point is beyond a bound.
    Beyond {
        /// The bound.
        side: Side,
        /// Its value.
        bound: Rational,
        /// The value of the row or column at the point.
        value: Rational,
    },
    /// A price or a multiplier leans on a bound that is not there.
    NoSuchBound {
        /// The bound.
        side: Side,
        /// The price.
        price: Rational,
    },
    /// A reduced cost is not what the duals leave of the cost.
    ReducedCost {
        /// The column.
        column: usize,
        /// What is claimed.
        claimed: Rational,
        /// What the duals leave.
        exact: Rational,
    },
    /// A bound has a price though the point does not attain it.
    Slack {
        /// The bound.
        side: Side,
        /// Its price.
        price: Rational,
        /// How far away the point is.
        slack: Rational,
    },
    /// A direction leaves the values that a row or column may have.
    Leaves {
        /// The bound that it passes in the end.
        side: Side,
        /// What the row or column gains along the direction.
        change: Rational,
    },
    /// The objective does not improve along the direction, but changes by this, in the direction of the objective.
    DoesNotImprove {
        /// The change.
        change: Rational,
    },
    /// The multiplied bounds do not contradict each other.
    NoContradiction {
        /// What they add up to, which should be positive.
        total: Rational,
    },
}

/// What was found about one aspect.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// Which one.
    pub aspect: Aspect,
    /// What it is worth.
    pub worth: Worth,
    /// The line of the file that is to blame, from 1.
    pub line: usize,
    /// The largest error, in units of its own; 0 where there is none. `None` for statuses.
    pub error: Option<Rational>,
    /// The error in units of what it is measured by.
    pub relative: Option<Rational>,
    /// What is wrong with the worst row or column; `None` where nothing is.
    pub fault: Option<Fault>,
    /// The smallest tolerance that excuses all errors of the aspect, as solvers define theirs; where there is one.
    pub excuse: Option<Excuse>,
}

/// What was found about one solution.
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
    /// What it says.
    pub solution: Solution,
    /// What that is worth.
    pub findings: Findings,
}

/// What a solver of this build is worth on a model.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct JudgedSolver {
    /// The solver with its version; `exact-simplex` for the exact one.
    pub source: Foreign,
    /// Judged by the program as it is.
    pub as_read: Findings,
    /// Judged by the program whose rows and costs are rounded to binary64, which is what the solver received.
    pub received: Findings,
}

impl Findings {
    /// The worst of all; [`Worth::NoAnswer`] where there is none.
    pub fn worst(&self) -> Worth {
        self.findings.iter().map(|finding| finding.worth).max().unwrap_or(Worth::NoAnswer)
    }

    /// Whether something is refuted.
    pub fn is_refuted(&self) -> bool {
        self.worst() == Worth::Refuted
    }

    /// What was found about an aspect, if the solution says something about it.
    pub fn about(&self, aspect: Aspect) -> Option<&Finding> {
        self.findings.iter().find(|finding| finding.aspect == aspect)
    }
}

impl Ground<'_> {
    /// Judges a solution: status, objective, primal and dual feasibility, complementary slackness, gap and certificates, each
    /// on its own. Exact. Cost: a pass over the coefficients for each aspect.
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
        Findings { findings }
    }

    /// The status. What excuses a wrong one is what excuses the point or the prices that come with it.
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
            excuse: excuse.and_then(|other| other.excuse.clone()),
        }
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
