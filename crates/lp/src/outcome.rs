//! The answers of solvers.

use boundfit_exact::Rational;

/// A solver's answer in binary64.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    /// An optimum is claimed.
    Optimal(Optimum),
    /// The rows are said to contradict each other.
    Infeasible,
    /// The objective is said to fall without end.
    Unbounded,
    /// One of the two, without saying which.
    InfeasibleOrUnbounded,
    /// No answer: a limit, a numerical failure, a crash. The reason is the solver's own.
    Failed(String),
}

/// A claimed optimum.
#[derive(Debug, Clone, PartialEq)]
pub struct Optimum {
    /// The point.
    pub theta: [f64; 2],
    /// The objective's value there, as the solver reports it.
    pub objective: f64,
    /// A multiplier per row, at least 0, when the solver gives them.
    pub duals: Option<Vec<f64>>,
}

/// A non-negative multiple of a row.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Multiplier {
    /// The index of the row.
    pub row: usize,
    /// The number of times that the row is taken.
    pub value: Rational,
}

/// The true answer, with its proof.
#[derive(Debug, Clone, PartialEq, Eq)]
#[allow(clippy::large_enum_variant, reason = "one per program")]
pub enum ExactOutcome {
    /// The optimum: `Σ multiplier·(a·θ ≤ b)` is `-objective·θ ≤ -value`, and `theta` attains it.
    Optimal {
        /// An optimal point.
        theta: [Rational; 2],
        /// The objective's value there.
        value: Rational,
        /// The multipliers, at most two, all positive.
        multipliers: Vec<Multiplier>,
        /// The rows of the final basis.
        basis: Vec<usize>,
    },
    /// Rows, at most three, that add up to `0 ≤ negative` (Farkas).
    Infeasible {
        /// The multipliers, all positive.
        multipliers: Vec<Multiplier>,
    },
    /// The objective falls for ever from a feasible point along a direction.
    Unbounded {
        /// A feasible point.
        theta: [Rational; 2],
        /// A recession direction with a negative objective.
        ray: [Rational; 2],
    },
}
