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

/// Returns the output of a program in a directory, or its complaint.
pub fn run(directory: &Path, program: &str, arguments: &[&str]) -> Result<String, String> {
    let output = Command::new(program).args(arguments).current_dir(directory).output();
    let output = output.unwrap_or_else(|error| panic!("{program}: {error} (Debian's package is coq)"));
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    if output.status.success() { Ok(text) } else { Err(text + &String::from_utf8_lossy(&output.stderr)) }
}

/// Returns the output of `coqc` for a file that may require the theory.
pub fn compiled(name: &str, text: &str) -> Result<String, String> {
    fs::write(theory().join(format!("{name}.v")), text).unwrap();
    run(theory(), "coqc", &["-q", "-R", ".", "Boundfit", &format!("{name}.v")])
}

/// The lines before the rows of theorems that require the theory.
const PRELUDE: &str = "From Boundfit Require Import Reader Bytes Checker Convex Sound Rationals RealNumbers.\n\
                       From Coq Require Import ZArith QArith Qabs Rbase Rbasic_fun Qreals List.\n\
                       Import ListNotations.\nOpen Scope Q_scope.\n";

/// The line after them in theorems about parts of the rows.
const PARTS: &str = "From Boundfit Require Import Parts.\n";

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
    format!("{PRELUDE}{PARTS}") + &theorems.into_iter().enumerate().map(module).collect::<String>()
}

/// Returns true for each file body all of whose theorems Coq's toplevel accepts, one after the other in one run. A file that is
/// refused leaves nothing behind.
pub fn accepted(name: &str, bodies: &[&str]) -> Vec<bool> {
    let mut text = format!("{PRELUDE}{PARTS}Set Silent.\n");
    for (index, body) in bodies.iter().enumerate() {
        let names = body.lines().filter_map(|line| line.strip_prefix("Theorem ")?.split_once(' '));
        let names: Vec<&str> = names.map(|(name, _)| name).collect();
        // It is there only if all theorems are.
        text += &format!(
            "Definition start{index} := tt.\n{body}\n\
             Definition accepted{index} : unit := (fun _ => tt) ({}).\nCheck accepted{index}.\nAbort All.\nReset start{index}.\n",
            names.join(", ")
        );
    }
    let file = theory().join(format!("{name}.txt"));
    fs::write(&file, &text).unwrap();
    let input = fs::File::open(&file).unwrap();
    let output = Command::new("coqtop")
        .args(["-q", "-R", ".", "Boundfit"])
        .current_dir(theory())
        .stdin(input)
        .output();
    let printed = String::from_utf8_lossy(&output.unwrap().stdout).into_owned();
    (0..bodies.len()).map(|index| printed.contains(&format!("accepted{index}\n     : unit"))).collect()
}
