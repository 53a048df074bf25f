//! The `boundfit` program, started as a user would start it.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::OnceLock;

/// The end of a run.
#[derive(Debug)]
pub struct Run {
    /// Exit status.
    pub status: i32,
    /// Standard output.
    pub stdout: String,
    /// Standard error.
    pub stderr: String,
}

/// The top of the repository.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("tests/ has a parent").to_owned()
}

/// The program's file: the one that `BOUNDFIT_PROGRAM` names, or that which Cargo builds along with the tests of this package, beside
/// the folder with their programs.
pub fn binary() -> &'static Path {
    static BINARY: OnceLock<PathBuf> = OnceLock::new();
    BINARY.get_or_init(|| {
        if let Some(named) = std::env::var_os("BOUNDFIT_PROGRAM") {
            return named.into();
        }
        let own = std::env::current_exe().expect("a running test has a file");
        let folder = own.ancestors().nth(2).expect("tests are built two folders deep");
        folder.join(format!("boundfit-for-tests{}", std::env::consts::EXE_SUFFIX))
    })
}

/// Runs the program at the top of the repository.
pub fn run(arguments: &[&str]) -> Run {
    run_with_input(arguments, b"")
}

/// Runs the program at the top of the repository with bytes on standard input.
pub fn run_with_input(arguments: &[&str], input: &[u8]) -> Run {
    let mut command = Command::new(binary());
    command.args(arguments).current_dir(root());
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("boundfit starts");
    let mut stdin = child.stdin.take().expect("standard input is piped");
    let input = input.to_owned();
    // Written from a thread of its own: the program may answer before it has read everything, or not read at all.
    let writer = std::thread::spawn(move || stdin.write_all(&input));
    let output = child.wait_with_output().expect("boundfit ends");
    let _ = writer.join();
    Run {
        status: output.status.code().unwrap_or(-1),
        stdout: String::from_utf8(output.stdout).expect("standard output is UTF-8"),
        stderr: String::from_utf8(output.stderr).expect("standard error is UTF-8"),
    }
}
