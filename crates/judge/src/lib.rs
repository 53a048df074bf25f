//! Linear programs in two variables: the exact answer with its proof, and what solvers answer about them, judged exactly.
//!
//! A [`Model`](boundfit_lp::Model) may have any number of columns as long as bounds fix all but two of them.

// What reads input never panics on it; exceptions stand at the smallest item, with the proof that it holds.
#![deny(clippy::expect_used, clippy::indexing_slicing, clippy::panic, clippy::unwrap_used)]

mod answer;
mod certificate;
mod error;
mod judging;
mod plane;
mod solution;
mod solve;
#[cfg(feature = "float-solvers")]
mod solvers;

pub use answer::{Answer, Basis, BasisStatus, Face, Item, Prices, Side, SideMultiplier};
pub use error::SolveError;
pub use judging::{
    Aspect, Excuse, Fault, Finding, Findings, Ground, JudgedSolution, JudgedSolver, Tolerances, Worth,
};
pub use plane::Plane;
pub use solution::{
    Announced, Entry, Figure, Given, Reference, Solution, SolutionError, SolutionFile, SolverStatus, quoted,
    read_solution,
};
#[cfg(feature = "float-solvers")]
pub use solvers::judge_solvers;
