//! Linear programs in two free variables, as bounded-error estimation poses them, and the referee of their answers.
//!
//! [`Program`] is `min c·θ` subject to `a·θ ≤ b`. [`exact_simplex`] solves it in rational arithmetic with a proof of
//! every outcome; it shares nothing with the polygon engine and is its independent witness. [`Solver`] is one interface
//! to floating-point solvers, which receive the program rounded to binary64. [`Referee`] says, exactly and with a named
//! reason, what an answer is worth, whoever gave it. [`ExchangeRows`] writes programs exactly for solvers elsewhere.
//!
//! | to | modules |
//! |---|---|
//! | state a program | `program`, `model` |
//! | read and write files | `read`, `exchange`, `format` |
//! | solve exactly | `simplex`, `standard_form`, `walk`, `outcome` |
//! | ask float solvers | `solvers` |
//! | judge | `claim`, `printed`, `closeness`, `referee`, `verdict` |
//!
//! The feature `float-solvers` (on by default) has the solvers: they alone need threads and a clock, because one that hangs
//! or crashes must not take the program with it.

// Code that reads input never panics on it; exceptions stand at the smallest item, with the proof that it holds.
#![deny(clippy::expect_used, clippy::indexing_slicing, clippy::panic, clippy::unwrap_used)]

mod claim;
mod closeness;
mod exchange;
mod format;
mod model;
mod outcome;
mod printed;
mod program;
mod read;
mod referee;
mod simplex;
#[cfg(feature = "float-solvers")]
mod solvers;
mod standard_form;
mod verdict;
mod walk;

pub use claim::{BoundClaim, Claimed, End, PuiEnd};
pub use closeness::{Closeness, Difference, MOST_ULPS, RoundedTo, ToleranceUnit, is_below_binary64, ulp};
pub use exchange::ExchangeRows;
pub use format::ExchangeFormat;
pub use model::{Bounds, Model, ModelColumn, ModelRow, ObjectiveSense};
pub use outcome::{ExactOutcome, Multiplier, Optimum, Outcome};
pub use printed::{NumberFormat, Precision, Printed};
pub use program::{FloatProgram, Program, Row, spread_objectives};
pub use read::{ModelError, ModelErrorKind, ModelLimits, ModelPlace, model_text, read_model};
pub use referee::{Referee, RefereeRow};
pub use simplex::{ExactSimplex, exact_simplex};
#[cfg(feature = "float-solvers")]
pub use solvers::{Solver, solve_guarded, solver_named, solvers};
pub use verdict::{Judgement, Refutation, Verdict, Violation};
pub use walk::{Basis, Pivot, simplex_path};
