#![doc = include_str!("../README.md")]
#![deny(clippy::expect_used, clippy::indexing_slicing, clippy::panic, clippy::unwrap_used)]

mod cells;
mod checks;
mod claims;
mod failure;
mod falsehood;
mod name;
mod plane;
mod proof;
mod rows;
mod scope;
mod shape;
mod sides;
mod statements;
mod whole_set;

pub use checks::{Extent, Found, SetFound, Statement};
pub use failure::{DataLimits, Failure, Refusal};
pub use falsehood::Falsehood;
pub use name::{End, Name};
pub use proof::{About, Proof};
pub use scope::{ErrorScale, Scope, Side};
pub use shape::{NotAProof, Quantity};
pub use statements::{Claim, ClaimKind};
