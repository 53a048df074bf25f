//! Tasks of those who change boundfit: `cargo xtask TASK`.
//!
//! | task | module | does |
//! |---|---|---|
//! | `ci [STEP…]` | `ci` | runs the steps of continuous integration, all of them or those named |
//! | `generate` | `generate` | writes what is made of types and options; `--check` names what is stale |
//! | `growth` | `growth` | counts how the cost of each command grows with the rows |
//! | `prose` | `prose` | counts what STYLE.md asks of prose, per folder; the counts may only fall |
//!
//! Without its feature `generate` the crate has no dependencies, so that it is built within two seconds.
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "a tool for people at a terminal")]

mod ci;
mod growth;
mod prose;

use std::env;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// The text that explains the tasks.
const USAGE: &str = "\
cargo xtask TASK

  ci [STEP…]    run the steps of continuous integration, all or these; `cargo xtask ci --list` explains them
  generate      write schemas, declarations and references from the types; with --check, name what is stale
  growth        count instructions per command at N, 2N and 4N rows; `cargo xtask growth --help` says more
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
        "generate" => generate(options),
        "growth" => growth::main(options),
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

/// Writes what follows from types and options, or checks it: `cargo xtask generate [--check]`. The answers and the command line that
/// it needs are built as the tests have them, and for no other task.
fn generate(options: &[String]) -> ExitCode {
    let cargo = env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
    let start = ["run", "--quiet", "--locked", "--package", "tests", "--bin", "references", "--"];
    let status = std::process::Command::new(cargo).args(start).args(options).status();
    if status.is_ok_and(|status| status.success()) { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
