//! The place where the two witnesses meet: a fit's half-planes as linear programs, solved the way a lab would, and every
//! answer judged exactly.
//!
//! [`check`] runs solvers and judges them together with [`Answer`]s brought from elsewhere ([`parse_claim_file`],
//! [`parse_claim_pui`]), against the data as written and against the binary64 numbers that a float solver receives.
//! [`directions`] compares the hull of the optimisers of many programs with the set itself.

mod answer;
mod claim_file;
mod directions;
mod judge;
mod rows;

pub use answer::{Answer, EXACT_SIMPLEX, SourceError, answer_of, source_names};
pub use claim_file::{ClaimError, parse_claim_file, parse_claim_pui};
pub use directions::{Approximation, Directions, directions};
pub use judge::{Check, CheckOptions, JudgedAnswer, check};
pub use rows::ProgramRows;
