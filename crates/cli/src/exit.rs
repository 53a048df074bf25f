//! How the program ends.

use std::fmt::Display;

use boundfit_exact::Foreign;
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
        Failure::Usage(format!("invalid value '{}' for '{option}': {problem}", Foreign::from(shown)))
    }

    /// Writes the message to standard error and gives the status. What names texts from outside has made them visible already; of
    /// what has not, nothing but line ends is left as it is.
    pub(crate) fn report(self) -> ExitCode {
        let (message, hint, status) = match self {
            Failure::Data(message) => (message, "", 1),
            Failure::Usage(message) => (message, "\n\nFor more information, try '--help'.", 2),
        };
        // Nothing is left to do when even the message cannot be written.
        let lines: Vec<String> = message.split('\n').map(|line| Foreign::of(line).to_string()).collect();
        let _ = writeln!(std::io::stderr(), "error: {}{hint}", lines.join("\n"));
        ExitCode::from(status)
    }
}
