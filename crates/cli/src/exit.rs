//! How the program ends.

use std::fmt::Display;
use std::io::Write;
use std::process::ExitCode;

/// An answer was found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Exit {
    /// Status 0.
    Answer = 0,
    /// Status 3: the set is empty, and the answer proves it.
    Empty = 3,
    /// Status 4: a claim is refuted.
    Refuted = 4,
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        ExitCode::from(exit as u8)
    }
}

/// Why there is no answer.
#[derive(Debug)]
pub(crate) enum Failure {
    /// Status 1: bad data, or a file that cannot be read or written.
    Data(String),
    /// Status 2: bad usage.
    Usage(String),
}

impl Failure {
    /// Bad data or input/output.
    pub(crate) fn data(problem: impl Display) -> Self {
        Failure::Data(problem.to_string())
    }

    /// A bad value of an option. A long value is cut.
    pub(crate) fn value(option: &str, value: &str, problem: impl Display) -> Self {
        const LONGEST: usize = 60;
        let shown = match value.char_indices().nth(LONGEST) {
            Some((end, _)) => format!("{}...", &value[..end]),
            None => value.to_owned(),
        };
        Failure::Usage(format!("invalid value '{}' for '{option}': {problem}", shown.escape_debug()))
    }

    /// Writes the message to standard error and gives the status.
    pub(crate) fn report(self) -> ExitCode {
        let (message, hint, status) = match self {
            Failure::Data(message) => (message, "", 1),
            Failure::Usage(message) => (message, "\n\nFor more information, try '--help'.", 2),
        };
        // Nothing is left to do when even the message cannot be written.
        let _ = writeln!(std::io::stderr(), "error: {message}{hint}");
        ExitCode::from(status)
    }
}
