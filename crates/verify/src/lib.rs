#![doc = include_str!("../README.md")]
#![deny(clippy::expect_used, clippy::indexing_slicing, clippy::panic, clippy::unwrap_used)]

mod checks;
mod falsehood;
mod plane;
mod proof;
mod sides;
mod table;

pub use checks::{Extent, Statement};
pub use falsehood::Falsehood;
pub use proof::Proof;
