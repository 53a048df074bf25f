//! The place where the two witnesses meet: a fit's half-planes as linear programs, solved the way a lab would, and every
//! answer judged exactly.
//!
//! [`check`] runs solvers and judges them together with [`Answer`]s brought from elsewhere ([`read_claims`],
//! [`parse_claim_pui`]), against the data as written and against the binary64 numbers that a float solver receives.
//! [`directions`] compares the hull of the optimisers of many programs with the set itself. [`ExchangeRows`] writes the four
//! programs ([`Target`]) as files for solvers elsewhere.

// What reads input never panics on it; exceptions stand at the smallest item, with the proof that it holds.
#![deny(clippy::expect_used, clippy::indexing_slicing, clippy::panic, clippy::unwrap_used)]

mod answer;
mod claim_file;
mod claims;
mod directions;
mod judge;
mod rows;
mod target;

pub use answer::{Answer, EXACT_SIMPLEX, SourceError, answer_of, source_names};
pub use claim_file::{nested_beyond, parse_claim_pui};
pub use claims::{ClaimError, ClaimFileError, ClaimLimits, ClaimText, is_solution_name, read_claims};
pub use directions::{Approximation, Directions, directions};
pub use judge::{Check, CheckOptions, JudgedAnswer, check};
pub use rows::ProgramRows;
pub use target::{ExchangeRows, Target};
