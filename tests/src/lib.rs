//! Code that the end-to-end and cross-crate tests share: generators with fixed seeds and a brute-force oracle.

pub mod boxes;
#[allow(missing_docs, reason = "fields and variants of what a report says are named as in the report")]
pub mod cli;
pub mod columns;
pub mod conformance;
pub mod deep;
pub mod definitions;
pub mod foreign;
pub mod fuzz_targets;
pub mod generate;
pub mod hostile;
pub mod judged_solvers;
pub mod linearity;
pub mod lp_cases;
pub mod models;
pub mod oracle;
pub mod outliers;
pub mod program;
pub mod proofs;
pub mod readings;
pub mod reducing;
pub mod reference_table;
pub mod representations;
pub mod runs;
pub mod schemas;
pub mod second_judge;
pub mod shape;
pub mod statuses;
pub mod stored;
pub mod streams;
pub mod tables;
pub mod workbooks;

/// Says in the output of `cargo test` what it leaves out.
#[cfg(test)]
#[test]
#[ignore = "left out: seven of eight cases of the longest tests (ONE_CASE_IN=1), other programs (cargo xtask ci peers), Coq (cargo xtask ci kernel), Parquet and Arrow (cargo xtask ci features)"]
fn whatever_needs_more_than_cargo() {}

/// The README, whose example in Rust is compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
pub struct Readme;
