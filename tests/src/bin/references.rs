//! `cargo xtask generate`, built with the features that the tests have, so that nothing is compiled twice.

use std::process::ExitCode;

fn main() -> ExitCode {
    let options: Vec<String> = std::env::args().skip(1).collect();
    xtask::generate::run(&options)
}
