#![doc = include_str!("../README.md")]
#![deny(clippy::expect_used, clippy::indexing_slicing, clippy::panic, clippy::unwrap_used)]

mod about;
mod cells;
mod checks;
mod claims;
mod data;
mod failure;
mod falsehood;
mod found;
mod half_planes;
mod name;
mod numbers;
mod plane;
mod probes;
mod proof;
mod rows;
mod scope;
mod shape;
mod sides;
mod statements;
mod theorem;
mod whole_set;

pub use about::About;
pub use checks::{Found, Statement};
pub use failure::{DataLimits, Failure, Refusal};
pub use falsehood::{Falsehood, OtherNumber};
pub use found::{Extent, SetFound};
pub use name::{End, Name};
pub use proof::Proof;
pub use scope::{ErrorScale, Scope, Side};
pub use shape::{NotAProof, Quantity};
pub use statements::{Claim, ClaimKind};
pub use theorem::THEORIES;
