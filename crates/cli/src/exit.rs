//! How the program ends.

use std::fmt::Display;
use std::io::Write;
use std::process::ExitCode;

use clap::CommandFactory;
use clap::error::ErrorKind;

use crate::arguments::Arguments;

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

    /// A bad value of an option.
    pub(crate) fn value(option: &str, value: &str, problem: impl Display) -> Self {
        Failure::Usage(format!("invalid value {value:?} for '{option}': {problem}"))
    }

    /// Writes the message to standard error and gives the status.
    pub(crate) fn report(self) -> ExitCode {
        match self {
            Failure::Data(message) => {
                // Nothing is left to do when even the message cannot be written.
                let _ = writeln!(std::io::stderr(), "error: {message}");
                ExitCode::from(1)
            }
            Failure::Usage(message) => {
                let error = Arguments::command().error(ErrorKind::ValueValidation, message);
                let _ = error.print();
                ExitCode::from(2)
            }
        }
    }
}
