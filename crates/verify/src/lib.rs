#![doc = include_str!("../README.md")]
#![deny(clippy::expect_used, clippy::indexing_slicing, clippy::panic, clippy::unwrap_used)]

mod cells;
mod checks;
mod failure;
mod falsehood;
mod name;
mod plane;
mod proof;
mod rows;
mod shape;
mod sides;

pub use checks::{Extent, Statement};
pub use failure::{DataLimits, Failure, Refusal};
pub use falsehood::Falsehood;
pub use name::Name;
pub use proof::{About, Proof};
pub use shape::{NotAProof, Quantity};
