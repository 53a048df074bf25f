//! The command line: one file or folder per command, with its options, its help and what it does.

mod asked;
mod check;
mod completions;
mod convert;
mod fit;
mod judge;
mod lesson;
mod linearity;
mod man;
mod next;
mod outliers;
mod pictures;
mod playground;
mod plot;
mod polygon;
mod predict;
mod proof_file;
mod range;
mod reduce;
mod set_files;
mod short;
mod status;
mod verify;

use clap::{Args as _, Parser, Subcommand};

use crate::exit::CommandResult;
use crate::options::Notes;
pub(crate) use short::with_short_help;

/// Exact bounded-error (set-membership) estimation in two parameters, and exact polygons from half-planes.
///
/// All results are exact rational numbers with proofs; decimals are only for display.
#[derive(Debug, Parser)]
#[command(name = "boundfit", bin_name = "boundfit", version, max_term_width = 100, after_help = BEGIN)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Command,
}

/// The end of the help without a command: the first one to type.
const BEGIN: &str = "A first fit, of columns V and z of a table whose z are right to 0.0005:
  boundfit fit readings.csv --x V --y z --eps 0.5e-3
'boundfit fit -h' lists the options most used, 'boundfit help fit' explains all of them.";

/// A command by its name, for what is not its run.
pub(crate) struct Named {
    name: &'static str,
    /// Gives a command its options.
    with_options: fn(clap::Command) -> clap::Command,
    /// The end of its help.
    pub(crate) notes: &'static Notes,
    /// The line about it in the short help.
    short: &'static str,
}

/// The registry of commands: a module with `NOTES` and `run`, its variant, its arguments, and its line in the short help.
macro_rules! commands {
    ($($module:ident $command:ident $arguments:ident $short:literal)*) => {
        #[derive(Debug, Subcommand)]
        #[allow(clippy::large_enum_variant, reason = "one per run")]
        pub(crate) enum Command {
            $($command($module::$arguments),)*
        }

        impl Command {
            /// Runs the command.
            pub(crate) fn run(&self) -> CommandResult {
                match self {
                    $(Command::$command(arguments) => $module::run(arguments),)*
                }
            }
        }

        /// All of them, in the order of the help.
        const ALL: &[Named] = &[$(Named {
            name: stringify!($module),
            with_options: $module::$arguments::augment_args,
            notes: &$module::NOTES,
            short: $short,
        },)*];
    };
}

commands! {
    fit Fit FitArguments "Compute all lines that agree with every reading"
    predict Predict PredictArguments "Predict y at an x, or x from a reading"
    next Next NextArguments "Find where one more reading certainly helps"
    linearity Linearity LinearityArguments "Compute how far a sensor is from a straight line"
    range Range RangeArguments "Find the runs of readings that one line fits"
    status Status StatusArguments "Judge each reading by the others"
    outliers Outliers OutliersArguments "Find the fewest readings to leave out"
    reduce Reduce ReduceArguments "Keep only the rows that decide"
    check Check CheckArguments "Judge LP answers about a fit"
    convert Convert ConvertArguments "Write the linear programs of a fit for other solvers"
    verify Verify VerifyArguments "Check a proof against the data"
    judge Judge JudgeArguments "Solve a linear program exactly, judge solutions"
    polygon Polygon PolygonArguments "Intersect half-planes"
    plot Plot PlotArguments "Draw readings, intervals and the set"
    lesson Lesson LessonArguments "Write a web page that explains a fit"
    playground Playground PlaygroundArguments "Write a web page to type readings into"
    completions Completions CompletionsArguments "Print a completion script for a shell"
    man Man ManArguments "Print a manual page"
}

/// The command of this name.
pub(crate) fn named(name: &str) -> Option<&'static Named> {
    ALL.iter().find(|own| own.name == name)
}

/// Returns the command line with this command alone: those of all commands take longer than a fit of some dozen readings.
pub(crate) fn alone(name: &str) -> Option<clap::Command> {
    let Named { name, with_options, .. } = named(name)?;
    let command = with_options(clap::Command::new(*name));
    Some(clap::Command::new("boundfit").bin_name("boundfit").max_term_width(100).subcommand(command))
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;

    #[test]
    fn a_command_alone_is_what_it_is_among_all() {
        let mut whole = Arguments::command();
        whole.build();
        let mut among_all = Vec::new();
        for command in whole.get_subcommands_mut() {
            let name = command.get_name().to_owned();
            let Some(mut alone) = alone(&name) else {
                among_all.push(name);
                continue;
            };
            alone.build();
            let alone = alone.find_subcommand_mut(&name).unwrap();
            assert_eq!(
                alone.render_long_help().ansi().to_string(),
                command.render_long_help().ansi().to_string()
            );
            assert_eq!(alone.render_usage().to_string(), command.render_usage().to_string());
        }
        assert_eq!(among_all, ["help"]);
    }
}
