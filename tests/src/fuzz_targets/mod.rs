//! The bodies of the fuzz targets, each of which takes arbitrary bytes and panics when something is wrong.
//!
//! `fuzz/` runs them under libFuzzer, `tests/tests/formats/fuzz_smoke.rs` on mutations of the seeds.

mod claims;
mod half_planes;
mod models;
mod number;
mod packed;
mod proofs;
mod slow;
mod table;

pub use claims::claim_files;
pub use half_planes::{ine_parser, polygon_against_oracle};
pub use models::model_files;
pub use number::number_parser;
pub use packed::{packed_reader, workbook_reader};
pub use proofs::proof_files;
pub use slow::slow_units;
pub use table::{csv_reader, mat_reader};

/// A fuzz target: its work on bytes, and the place of its first inputs.
#[derive(Clone, Copy)]
pub struct Target {
    /// The name of the target, which is also the name of a folder in `fuzz/seeds`.
    pub name: &'static str,
    /// The work of the target.
    pub body: fn(&[u8]),
    /// Folders of fixtures whose files are seeds too.
    pub fixtures: &'static [&'static str],
}

/// All targets.
pub const TARGETS: [Target; 11] = [
    Target { name: "csv_reader", body: csv_reader, fixtures: &["bad-input", "steam-generator"] },
    Target { name: "number_parser", body: number_parser, fixtures: &[] },
    Target { name: "ine_parser", body: ine_parser, fixtures: &["polygon", "bad-input"] },
    Target { name: "mat_reader", body: mat_reader, fixtures: &["mat"] },
    Target { name: "claim_files", body: claim_files, fixtures: &["claims", "solutions"] },
    Target { name: "polygon_against_oracle", body: polygon_against_oracle, fixtures: &[] },
    Target { name: "proof_files", body: proof_files, fixtures: &[] },
    Target { name: "model_files", body: model_files, fixtures: &["tiny-lp"] },
    Target { name: "slow_units", body: slow_units, fixtures: &[] },
    Target { name: "workbook_reader", body: workbook_reader, fixtures: &["workbooks"] },
    Target { name: "packed_reader", body: packed_reader, fixtures: &[] },
];
