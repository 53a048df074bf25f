//! The end of the program.

use std::borrow::Borrow;
use std::fmt::Display;

use boundfit_ask::{Refusal, Surface};
use boundfit_exact::{Foreign, Limit};
use boundfit_formats::{InputError, InputErrorKind, Setting, Way};
use boundfit_lp::ExchangeFormat;
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

/// The end of a command: its exit status, or the reason why there is none.
pub(crate) type CommandResult = Result<Exit, Failure>;

/// Returns the command that reads files with the ending of this name, with what it reads.
fn command_for(name: &str) -> Option<&'static str> {
    match name.rsplit_once('.')?.1.to_ascii_lowercase().as_str() {
        "mps" | "lp" => Some("'boundfit judge' solves the linear program in such a file"),
        "ine" | "ext" => Some("'boundfit polygon' reads the half-planes or generators in such a file"),
        _ => None,
    }
}

/// Returns the command for a file that is no table, if another one reads it.
fn instead_of_table(error: &InputError) -> Option<&'static str> {
    matches!(error.kind, InputErrorKind::NoDelimiter { .. }).then(|| command_for(error.file.raw()))?
}

/// Returns the command for a file that is no linear program and does not claim to be one.
fn instead_of_program(file: &str, is_table: bool) -> Option<&'static str> {
    /// Most files without a name of their own are tables.
    const READS_TABLES: &str =
        "'boundfit fit' fits the readings of a table; MPS and LP are the formats of linear programs";
    let command = command_for(file).or(is_table.then_some(READS_TABLES));
    command.filter(|_| ExchangeFormat::of_name(file).is_none())
}

/// A way out as this program has it: `--decimal comma reads 1,5`.
pub(crate) fn words(way: &Way) -> String {
    let Way { setting, value, effect } = way;
    match setting {
        Setting::Limit(limit) => format!("--limit {}={value} {effect}", limit.name()),
        setting => {
            let value = if value.is_empty() { String::new() } else { format!(" {value}") };
            format!("--{}{value} {effect}", setting.name().replace(' ', "-"))
        }
    }
}

/// Returns the option with which this program raises a limit.
pub(crate) fn raises(limit: Limit) -> String {
    words(&Way::raises(limit))
}

/// The names of settings in the words of options.
struct Options;

impl Surface for Options {
    fn key(&self, key: &str) -> String {
        format!("'--{}'", key.replace('_', "-"))
    }

    fn value(&self, key: &str, text: &str) -> String {
        // As the help shows it.
        let placeholder = match key {
            "x" | "y" | "eps_column" | "lower" | "upper" | "x_eps_column" => "COL",
            "x_eps" => "NUM|COL",
            "where" => "CONDITION",
            "rows" | "without" => "ROWS",
            "where_row" => "COMPARISON",
            "encoding" => "NAME",
            "thousands" | "comment" => "MARK",
            "block" => "N|NAME",
            "window" | "step" => "N",
            "claim_pui" => "LO1,HI1,LO2,HI2",
            "through" => "X,Y",
            "sweep" => "FROM..TO",
            "at" => "X,...|FILE:COL",
            "from" => "Y,...|FILE:COL",
            "grid" => "FROM..TO/N",
            "within" => "LO..HI",
            "goal" => "GOAL",
            "reading" => "READING",
            _ => "NUM",
        };
        value(&format!("--{} <{placeholder}>", key.replace('_', "-")), text)
    }

    fn way(&self, way: &Way) -> String {
        words(way)
    }
}

/// A bad value of an option. A long value is cut.
fn value(option: &str, value: &str) -> String {
    const LONGEST: usize = 60;
    let shown = match value.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}...", &value[..end]),
        None => value.to_owned(),
    };
    format!("invalid value '{}' for '{option}'", Foreign::from(shown))
}

/// The reason why there is no answer.
#[derive(Debug)]
pub(crate) enum Failure {
    /// Status 1: bad data, or a file that cannot be read or written.
    Data(String),
    /// Status 2: a wrong command line.
    Usage(String),
}

impl Failure {
    /// Bad data or input/output.
    pub(crate) fn data(problem: impl Display) -> Self {
        Failure::Data(problem.to_string())
    }

    /// Reports a refusal of a file, with this program's remedy.
    pub(crate) fn refused(problem: impl Borrow<InputError>) -> Self {
        let problem = problem.borrow();
        if let Some(command) = instead_of_table(problem) {
            return Failure::Data(format!("{problem}; {command}"));
        }
        let ways: Vec<String> = problem.ways().iter().map(words).collect();
        let ways = if ways.is_empty() { String::new() } else { format!("; {}", ways.join(", ")) };
        Failure::Data(format!("{problem}{ways}"))
    }

    /// Returns the reason why a question about a file has no answer.
    pub(crate) fn of(refusal: &Refusal, file: Foreign<&str>) -> Self {
        let words = refusal.words(&Options);
        if let Refusal::Model { is_other, .. } = refusal
            && let Some(command) = instead_of_program(file.raw(), *is_other)
        {
            return Failure::Data(format!("{file}: no linear program; {command}"));
        }
        match refusal {
            Refusal::Input(error) => Failure::refused(error),
            refusal if refusal.names_file() => Failure::Data(words),
            refusal if refusal.is_misuse() => Failure::Usage(words),
            _ => Failure::Data(format!("{file}: {words}")),
        }
    }

    /// Mistakes of options, whatever the data.
    pub(crate) fn misused(refusal: Refusal) -> Self {
        Failure::Usage(refusal.words(&Options))
    }

    /// A bad value of an option.
    pub(crate) fn value(option: &str, text: &str, problem: impl Display) -> Self {
        Failure::Usage(format!("{}: {problem}", value(option, text)))
    }

    /// Writes the message to standard error and gives the status. Names of texts from outside have been made visible
    /// already; in all other texts only line ends are left as they are.
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

#[cfg(test)]
mod tests {
    use boundfit_ask::{Readings, RowWords, TableWords};

    use super::*;

    #[test]
    fn refused_values_are_named_as_in_the_help() {
        // Any value of these makes sense.
        let never_refused = ["skip_lines", "missing_as", "sheet"];
        let command = crate::command();
        for key in [Readings::KEYS, RowWords::KEYS, TableWords::KEYS].concat() {
            let option = key.replace('_', "-");
            let arguments = command.get_subcommands().flat_map(clap::Command::get_arguments);
            let own = arguments.filter(|argument| argument.get_long() == Some(&option));
            let free = own.filter(|argument| argument.get_possible_values().is_empty());
            let names: Vec<_> = free.filter_map(clap::Arg::get_value_names).flatten().collect();
            let shown = Options.value(key, "a");
            let is_named =
                |name: &&clap::builder::Str| shown == format!("invalid value 'a' for '--{option} <{name}>'");
            assert!(
                names.is_empty() || never_refused.contains(&key) || names.iter().any(is_named),
                "{shown}: {names:?}"
            );
        }
    }
}
