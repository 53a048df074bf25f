//! The text below the options in a command's help, and at the end of its manual page: examples and exit statuses.

use std::fmt::{self, Display, Formatter};

/// Exit status 1, which every command has.
pub(crate) const BAD_DATA: (u8, &str) = (1, "bad data, or a file that cannot be read or written");

/// Exit status 2, which every command has.
pub(crate) const BAD_USAGE: (u8, &str) = (2, "a wrong command line");

/// Examples and exit statuses of a command.
pub(crate) struct Notes {
    /// The purpose of each example, and the lines that a shell takes.
    pub(crate) examples: &'static [(&'static str, &'static str)],
    /// The meaning of each exit status. A command without a list has the usual ones.
    pub(crate) statuses: &'static [(u8, &'static str)],
}

impl Display for Notes {
    /// Writes them as the help shows them.
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        formatter.write_str("Examples:")?;
        for (what, command) in self.examples {
            write!(formatter, "\n  {what}:")?;
            for line in command.lines() {
                write!(formatter, "\n    {line}")?;
            }
        }
        if !self.statuses.is_empty() {
            formatter.write_str("\n\nExit status:")?;
        }
        for (status, meaning) in self.statuses {
            write!(formatter, "\n  {status}  {meaning}")?;
        }
        Ok(())
    }
}
