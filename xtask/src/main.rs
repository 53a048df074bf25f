//! Tasks of those who change boundfit: `cargo xtask TASK`.
//!
//! | task | module | does |
//! |---|---|---|
//! | `ci [STEP…]` | `ci` | runs the steps of continuous integration, all of them or those named |
//! | `prose` | `prose` | counts what STYLE.md asks of prose, per folder; the counts may only fall |
//!
//! The crate has no dependencies, so that it is built within two seconds.
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "a tool for people at a terminal")]

mod ci;
mod prose;

use std::env;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// The text that explains the tasks.
const USAGE: &str = "\
cargo xtask TASK

  ci [STEP…]    run the steps of continuous integration, all or these; `cargo xtask ci --list` explains them
  prose         count long sentences and unclear beginnings per folder; `cargo xtask prose --help` says more";

/// The top of the repository.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().map_or_else(PathBuf::new, Path::to_owned)
}

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let (task, options) = arguments.split_first().map_or(("", &[][..]), |(task, rest)| (task.as_str(), rest));
    match task {
        "ci" => ci::main(options),
        "prose" => prose::main(options),
        "" | "help" | "-h" | "--help" => {
            println!("{USAGE}");
            ExitCode::SUCCESS
        }
        unknown => {
            eprintln!("there is no task {unknown:?}\n\n{USAGE}");
            ExitCode::from(2)
        }
    }
}
