//! The command line of boundfit as a library, so that tests can start it from a program of their own.
//!
//! | module | what it has |
//! |---|---|
//! | `arguments` | options of every command, with their help |
//! | `usage` | command lines that are not understood, with a tip |
//! | `commands` | one file per command: from arguments to the answer |
//! | `readings` | readings of a file, asked for in the words that every surface has |
//! | `input`, `output` | files that are read, and files that are written whole or not at all |
//! | `work`, `memory` | limits of work and memory of each command |
//! | `exit`, `interrupt`, `progress` | exit statuses, a clean stop, progress on a terminal |
//!
//! A command reads its arguments, asks a library crate, and hands the answer to `boundfit-report` or `boundfit-figures`.

// Code that reads input never panics on it; exceptions stand at the smallest item, with the proof that it holds.
#![deny(clippy::expect_used, clippy::indexing_slicing, clippy::panic, clippy::unwrap_used)]

mod arguments;
mod commands;
mod exit;
mod input;
mod interrupt;
mod memory;
mod output;
mod progress;
mod readings;
mod usage;
mod work;

use std::process::ExitCode;

use clap::CommandFactory;

use crate::arguments::{Arguments, Command};
use crate::exit::Exit;

/// Runs the command that the program's arguments ask for and returns the exit status.
/// - 0: an answer
/// - 1: bad data or I/O
/// - 2: bad usage
/// - 3: an empty set
/// - 4: a refuted claim or proof
/// - 130: an interruption
pub fn main() -> ExitCode {
    let arguments = usage::parse();
    interrupt::leave_nothing_behind();
    let result = match arguments.command {
        Command::Fit(arguments) => commands::fit::run(&arguments),
        Command::Predict(arguments) => commands::predict::run(&arguments),
        Command::Next(arguments) => commands::next::run(&arguments),
        Command::Linearity(arguments) => commands::linearity::run(&arguments),
        Command::Check(arguments) => commands::check::run(&arguments),
        Command::Verify(arguments) => commands::verify::run(&arguments),
        Command::Judge(arguments) => commands::judge::run(&arguments),
        Command::Convert(arguments) => commands::convert::run(&arguments),
        Command::Range(arguments) => commands::range::run(&arguments),
        Command::Status(arguments) => commands::status::run(&arguments),
        Command::Outliers(arguments) => commands::outliers::run(&arguments),
        Command::Reduce(arguments) => commands::reduce::run(&arguments),
        Command::Polygon(arguments) => commands::polygon::run(&arguments),
        Command::Plot(arguments) => commands::plot::run(&arguments),
        Command::Lesson(arguments) => commands::lesson::run(&arguments),
        Command::Playground(arguments) => commands::playground::run(&arguments),
        Command::Completions { shell, file } => commands::completions::run(shell, &file),
        Command::Man { topic, file } => commands::man::run(topic.as_deref(), &file),
    };
    match result {
        Ok(exit) => exit.into(),
        Err(failure) => failure.report(),
    }
}

/// The command line with all commands and options, of which the reference in docs is made.
pub fn command() -> clap::Command {
    Arguments::command()
}

/// A failure that ends the program.
type CommandResult = Result<Exit, exit::Failure>;
