//! Findings about one aspect of an answer.

use boundfit_exact::{Foreign, Rational};

use crate::answer::{Item, Side};
use crate::solution::Part;

/// The distance that an answer may be from the truth.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Tolerances {
    /// An error counts as within tolerance up to this part of what it is measured by.
    pub relative: Rational,
    /// True if a number may be half a unit of its last printed digit away from the one that was meant.
    pub digits_as_printed: bool,
}

/// An aspect that is judged on its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Aspect {
    /// Optimal, infeasible or unbounded.
    Status,
    /// The optimum that is claimed.
    Objective,
    /// Feasibility of the point: rows and bounds.
    Primal,
    /// Equality of the objective at the point with the optimum.
    Optimality,
    /// Feasibility of the prices: they lean on bounds that are there, and reduced costs are what duals leave of the costs.
    Dual,
    /// Agreement of prices with the point: each belongs to a bound that the point attains.
    ComplementarySlackness,
    /// The prices as a proof of the objective at the point.
    DualityGap,
    /// The ray: it stays feasible and improves.
    Ray,
    /// The multipliers as a proof that there is no feasible point.
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

    /// Returns what it asks, as a sentence without its end.
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

/// The worth of one aspect, from best to worst.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Worth {
    /// No error.
    Exact,
    /// An error that rounding explains: 4 units in the last place of binary64, or half a unit of the last printed digit, of each number.
    Rounded,
    /// An error beyond rounding, by no more than the tolerance.
    WithinTolerance,
    /// Nothing was claimed, or a number that is not finite, or one of two statuses, of which one is right.
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

/// A program for which solvers often take another one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OtherProgram {
    /// The one whose objective has a constant of the other sign, as GLPK and lp_solve read it in MPS.
    OtherConstant,
    /// The one of the opposite sense, which readers of MPS take that ignore `OBJSENSE`.
    OppositeSense,
}

/// The fault, where it is known.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Fault {
    /// The status is another one.
    Status {
        /// The claim, in the solver's words where it is no answer.
        claimed: Foreign,
        /// `optimal`, `infeasible` or `unbounded`.
        exact: &'static str,
    },
    /// A number is none, or infinite.
    NotFinite {
        /// The part of the solution that it belongs to.
        part: Part,
        /// The column or row; `None` for the objective.
        item: Option<Item>,
    },
    /// A number is another one.
    Value {
        /// The claim.
        claimed: Rational,
        /// The truth.
        exact: Rational,
        /// The other question that the claim answers, if one is known.
        answers: Option<OtherProgram>,
    },
    /// The point is beyond a bound.
    Beyond {
        /// The bound.
        side: Side,
        /// The value.
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
        /// The claim.
        claimed: Rational,
        /// The rest that the duals leave.
        exact: Rational,
    },
    /// A bound has a price though the point does not attain it.
    Slack {
        /// The bound.
        side: Side,
        /// The price.
        price: Rational,
        /// The distance of the point.
        slack: Rational,
    },
    /// A direction leaves the values that a row or column may have.
    Leaves {
        /// The bound that it passes in the end.
        side: Side,
        /// The gain of the row or column along the direction.
        change: Rational,
    },
    /// The objective does not improve along the direction, but changes by this, in the direction of the objective.
    DoesNotImprove {
        /// The change.
        change: Rational,
    },
    /// The multiplied bounds do not contradict each other.
    NoContradiction {
        /// The sum, which should be positive.
        total: Rational,
    },
}

/// The finding about one aspect.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// The aspect.
    pub aspect: Aspect,
    /// The worth.
    pub worth: Worth,
    /// The line of the file that is to blame, from 1.
    pub line: usize,
    /// The largest error, in units of its own; 0 where there is none. `None` for statuses.
    pub error: Option<Rational>,
    /// The error in units of what it is measured by.
    pub relative: Option<Rational>,
    /// The fault of the worst row or column; `None` where nothing is.
    pub fault: Option<Fault>,
    /// True if duals and reduced costs with the opposite signs are right: solvers that maximize the negative objective write such.
    pub is_negated: bool,
    /// The smallest tolerance that excuses all errors of the aspect, as solvers define theirs; where there is one.
    pub excuse: Option<Excuse>,
}

/// The smallest tolerances that excuse an error, as solvers define theirs.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Excuse {
    /// The tolerance in the units of the rows and bounds as the file has them: HiGHS `primal_feasibility_tolerance` and
    /// `dual_feasibility_tolerance`, Gurobi `FeasibilityTol` and `OptimalityTol`, SoPlex `feastol` and `opttol`.
    pub absolute: Rational,
    /// The tolerance in units of the larger of 1, the value and the bound: SCIP `numerics/feastol` and `numerics/dualfeastol`, which it
    /// asks of SoPlex.
    pub relative: Rational,
    /// The tolerance after each row is divided by its largest coefficient, as solvers scale: what they test before the scaling is undone.
    pub scaled: Rational,
}

impl Excuse {
    /// The larger of each.
    pub(super) fn or(self, other: Self) -> Self {
        Excuse {
            absolute: self.absolute.max(other.absolute),
            relative: self.relative.max(other.relative),
            scaled: self.scaled.max(other.scaled),
        }
    }
}
