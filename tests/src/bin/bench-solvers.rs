//! Runs every LP solver over a folder of cases and prints who is right on which, as a Markdown table: `bench-solvers DIR`.

use std::path::PathBuf;

use clap::Parser;

/// Runs every LP solver over a folder of cases: fits in NAME.csv and NAME.json, linear programs in NAME.mps.
#[derive(Debug, Parser)]
struct Arguments {
    /// The folder
    folder: PathBuf,
}

fn main() {
    print!("{}", boundfit_tests::conformance::conformance_table(&Arguments::parse().folder));
}
