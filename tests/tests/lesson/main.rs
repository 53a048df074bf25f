//! The lesson page: every number in its data against the engine, and the page as the program writes it.

mod cells;
mod corridor;
mod decimals;
mod document;
mod keys;
mod layers;
mod leave_one_out;
mod orders;
mod outliers;
mod page;
mod polytope;
mod questions;
mod statements;
mod sweep;
