//! The command line of boundfit as a library, so that tests can start it from a program of their own.
//!
//! | module | what it has |
//! |---|---|
//! | `usage` | command lines that are not understood, with a tip |
//! | `commands` | the registry, and one file or folder per command: options, help, from arguments to the answer |
//! | `options` | options that several commands share |
//! | `readings` | readings of a file, asked for in the words that every surface has |
//! | `input`, `output` | files that are read, and files that are written whole or not at all |
//! | `work`, `memory` | limits of work and memory of each command |
//! | `exit`, `interrupt`, `progress` | exit statuses, a clean stop, progress on a terminal |
//!
//! A command reads its arguments, asks a library crate, and hands the answer to `boundfit-report` or `boundfit-figures`.

// Code that reads input never panics on it; exceptions stand at the smallest item, with the proof that it holds.
#![deny(clippy::expect_used, clippy::indexing_slicing, clippy::panic, clippy::unwrap_used)]

mod commands;
mod exit;
mod input;
mod interrupt;
mod memory;
mod options;
mod output;
mod progress;
mod readings;
mod usage;
mod work;

use std::process::ExitCode;

use clap::CommandFactory;

use crate::commands::Arguments;

/// Runs the command that the program's arguments ask for and returns the exit status.
/// - 0: an answer
/// - 1: bad data or I/O
/// - 2: a wrong command line
/// - 3: an empty set
/// - 4: a refuted claim or proof
/// - 130: an interruption
pub fn main() -> ExitCode {
    let arguments = usage::parse();
    interrupt::leave_nothing_behind();
    match arguments.command.run() {
        Ok(exit) => exit.into(),
        Err(failure) => failure.report(),
    }
}

/// The command line with all commands and options, of which the reference in docs is made.
pub fn command() -> clap::Command {
    Arguments::command()
}
