//! `coqc` on files beside the compiled theory.

use std::fs;
use std::path::Path;
use std::process::Command;
use std::sync::OnceLock;

use boundfit_report::THEORY;
use tempfile::TempDir;

/// The theory, compiled once.
pub fn theory() -> &'static Path {
    static THEORY_DIRECTORY: OnceLock<TempDir> = OnceLock::new();
    let directory = THEORY_DIRECTORY.get_or_init(|| {
        let directory = tempfile::tempdir().unwrap();
        for (name, text) in THEORY {
            fs::write(directory.path().join(format!("{name}.v")), text).unwrap();
            let output = run(directory.path(), "coqc", &["-R", ".", "Boundfit", &format!("{name}.v")]);
            assert!(output.is_ok(), "{name}: {output:?}");
        }
        directory
    });
    directory.path()
}

/// What a program prints in a directory, or its complaint.
pub fn run(directory: &Path, program: &str, arguments: &[&str]) -> Result<String, String> {
    let output = Command::new(program).args(arguments).current_dir(directory).output();
    let output = output.unwrap_or_else(|error| panic!("{program}: {error} (Debian's package is coq)"));
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    if output.status.success() { Ok(text) } else { Err(text + &String::from_utf8_lossy(&output.stderr)) }
}

/// What `coqc` prints of a file that may require the theory.
pub fn compiled(name: &str, text: &str) -> Result<String, String> {
    fs::write(theory().join(format!("{name}.v")), text).unwrap();
    run(theory(), "coqc", &["-q", "-R", ".", "Boundfit", &format!("{name}.v")])
}

/// The lines before the rows of theorems that require the theory.
const PRELUDE: &str = "From Boundfit Require Import Reader Checker Convex Sound Rationals RealNumbers.\n\
                       From Coq Require Import ZArith QArith Qabs Reals Qreals List.\n\
                       Import ListNotations.\nOpen Scope Q_scope.\n";

/// A theorem from its rows on, without what the kernel prints of its assumptions. Imports are made once for many theorems.
pub fn body(theorem: &str) -> String {
    assert!(theorem.contains(PRELUDE), "{theorem}");
    let rows = theorem.find("(* Rows: ").unwrap();
    let lines = theorem[rows..].lines().filter(|line| !line.starts_with("Print Assumptions"));
    lines.flat_map(|line| [line, "\n"]).collect()
}

/// Theorems in one file, each in a module of its own.
pub fn modules<'a>(theorems: impl IntoIterator<Item = &'a String>) -> String {
    let module = |(index, text): (usize, &String)| format!("Module M{index}.\n{}End M{index}.\n", body(text));
    PRELUDE.to_owned() + &theorems.into_iter().enumerate().map(module).collect::<String>()
}
