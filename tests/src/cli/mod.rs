//! Code that the tests of the program share.

pub mod fits;
pub mod half_plane_files;
pub mod numbers;
pub mod proofs;
pub mod refusals;
pub mod regions;
pub mod schema;

use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

use crate::program::{Run, binary, root};
use serde_json::Value;
use tempfile::TempDir;

/// The position transducer's data, from the top of the repository.
pub const TRANSDUCER: &str = "fixtures/transducer/transducer.csv";

/// A command line that fits its linearity interval.
pub const FIT_TRANSDUCER: &str =
    "fit fixtures/transducer/transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3";

/// The text of a fixture.
pub fn fixture(path: &str) -> String {
    std::fs::read_to_string(root().join("fixtures").join(path)).unwrap()
}

/// A directory of its own for a test, with these files in it.
pub fn directory_with(files: &[(&str, &[u8])]) -> TempDir {
    let directory = tempfile::tempdir().unwrap();
    for (name, bytes) in files {
        std::fs::write(directory.path().join(name), bytes).unwrap();
    }
    directory
}

/// A report with lines that were broken to fit put together again, and its tables with single blanks.
pub fn unbroken(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The words of a command line; what stands between single quotes is one word.
pub fn words(line: &str) -> Vec<String> {
    let mut words = Vec::new();
    for (index, part) in line.split('\'').enumerate() {
        if index % 2 == 1 {
            words.push(part.to_owned());
        } else {
            words.extend(part.split_whitespace().map(ToOwned::to_owned));
        }
    }
    words
}

/// The program, about to be started in a directory; no variable changes the layout of its messages.
pub fn command(directory: &Path) -> Command {
    let mut command = Command::new(binary());
    command.current_dir(directory).env_remove("COLUMNS").env_remove("CLICOLOR_FORCE");
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

/// Runs a command with bytes on standard input.
pub fn finish(command: &mut Command, input: &[u8]) -> Run {
    let mut child = command.spawn().unwrap();
    let mut stdin = child.stdin.take().unwrap();
    let input = input.to_owned();
    // Written from a thread of its own: the program may answer before it has read everything, or not read at all.
    let writer = std::thread::spawn(move || stdin.write_all(&input));
    let output = child.wait_with_output().unwrap();
    let _ = writer.join();
    Run {
        status: output.status.code().unwrap_or(-1),
        stdout: String::from_utf8(output.stdout).unwrap(),
        stderr: String::from_utf8(output.stderr).unwrap(),
    }
}

/// Runs `boundfit` with the words of a line in a directory, with bytes on standard input.
pub fn boundfit_with_input(directory: &Path, line: &str, input: &[u8]) -> Run {
    finish(command(directory).args(words(line)), input)
}

/// Runs `boundfit` with the words of a line in a directory.
pub fn boundfit(directory: &Path, line: &str) -> Run {
    boundfit_with_input(directory, line, b"")
}

/// Returns what `boundfit` prints when all is well.
pub fn printed(directory: &Path, line: &str) -> String {
    printed_with_input(directory, line, b"")
}

/// Returns what `boundfit` prints for bytes on standard input when all is well.
pub fn printed_with_input(directory: &Path, line: &str, input: &[u8]) -> String {
    let run = boundfit_with_input(directory, line, input);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{line}");
    run.stdout
}

/// The JSON report that a command line ends with, with status 0, or 3 for an empty set.
pub fn report(directory: &Path, line: &str, input: &[u8]) -> Value {
    let run = boundfit_with_input(directory, &format!("{line} --format json"), input);
    let report: Value =
        serde_json::from_str(&run.stdout).unwrap_or_else(|error| panic!("{line}: {error} {run:?}"));
    let region = report.get("fps").unwrap_or(&report["region"]);
    let status = if region["kind"] == "empty" { 3 } else { 0 };
    assert_eq!((run.status, run.stderr.as_str()), (status, ""), "{line}");
    report
}

/// The names of the files in a directory, sorted.
pub fn files_in(directory: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(directory).unwrap();
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}
