//! What is done with arbitrary bytes: the bodies of the fuzz targets, each of which panics when something is wrong.
//!
//! `fuzz/` runs them under libFuzzer, `tests/tests/fuzz_smoke.rs` on mutations of the seeds.

mod claims;
mod half_planes;
mod number;
mod table;

pub use claims::claim_files;
pub use half_planes::{ine_parser, polygon_against_oracle};
pub use number::number_parser;
pub use table::{csv_reader, mat_reader};

/// A target: its name, which is also that of the folder with its seeds, and its body.
pub type Target = (&'static str, fn(&[u8]));

/// All targets.
pub const TARGETS: [Target; 6] = [
    ("csv_reader", csv_reader),
    ("number_parser", number_parser),
    ("ine_parser", ine_parser),
    ("mat_reader", mat_reader),
    ("claim_files", claim_files),
    ("polygon_against_oracle", polygon_against_oracle),
];
