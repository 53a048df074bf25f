//! Linear programs in two variables: the exact answer with its proof, and the answers of solvers, judged exactly.
//!
//! | module | what it has |
//! |---|---|
//! | `plane` | a model as half-planes that know their rows and bounds |
//! | `solve` | the way to an [`Answer`]: polygon engine, exact simplex, proof |
//! | `answer` | status, optimum, all optimal points, prices and basis |
//! | `certificate` | [`Answer::verify`], which multiplies a proof out in the model itself |
//! | `solution` | [`read_solution`]: files of CBC, CPLEX, GLPK, Gurobi, HiGHS, SCIP, and JSON |
//! | `judging` | [`Ground::judge`]: one [`Finding`] for each aspect of a solution, with its worth |
//!
//! A [`Model`](boundfit_lp::Model) may have any number of columns as long as bounds fix all but two of them.

// Code that reads input never panics on it; exceptions stand at the smallest item, with the proof that it holds.
#![deny(clippy::expect_used, clippy::indexing_slicing, clippy::panic, clippy::unwrap_used)]

mod answer;
mod certificate;
mod error;
mod judging;
mod plane;
mod solution;
mod solve;

pub use answer::{Answer, Basis, BasisStatus, Face, Item, Prices, Side, SideMultiplier};
pub use error::SolveError;
pub use judging::{
    Aspect, Excuse, Fault, Finding, Findings, Ground, JudgedSolution, OtherProgram, Tolerances, Worth,
};
pub use plane::Plane;
pub use solution::{
    Announced, Entry, Figure, Given, NotFinite, Part, Reference, Solution, SolutionError, SolutionFile,
    SolverStatus, quoted, read_solution,
};
