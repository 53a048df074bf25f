//! The command line.

mod check;
mod convert;
mod endings;
mod fit;
mod judge;
mod lesson;
mod limits;
mod linearity;
mod look;
mod next;
mod notes;
mod outliers;
mod playground;
mod plot;
mod polygon;
mod predict;
mod question;
mod range;
mod reading;
mod reduce;
mod rows;
mod shared;
mod short;
mod solutions;
mod status;
mod tolerance;
mod values;
mod verify;
mod x_errors;

use clap::{Args as _, Parser, Subcommand};
use clap_complete::Shell;

pub(crate) use check::CheckArguments;
pub(crate) use convert::ConvertArguments;
pub(crate) use endings::{Format, ReportFormat, TableFormat, ending, told_by_name};
pub(crate) use fit::FitArguments;
pub(crate) use judge::{JudgeArguments, JudgeFormat};
pub(crate) use lesson::LessonArguments;
pub(crate) use limits::LimitArguments;
pub(crate) use linearity::LinearityArguments;
pub(crate) use look::{PictureArguments, refuse_without_picture};
pub(crate) use next::NextArguments;
pub(crate) use notes::Notes;
pub(crate) use outliers::OutliersArguments;
pub(crate) use playground::PlaygroundArguments;
pub(crate) use plot::{Figures, PlotArguments};
pub(crate) use polygon::PolygonArguments;
pub(crate) use predict::PredictArguments;
pub(crate) use range::RangeArguments;
pub(crate) use reading::Words;
pub(crate) use reduce::ReduceArguments;
pub(crate) use rows::RowArguments;
pub(crate) use shared::{
    DataArguments, FileArguments, LabelArguments, OutputArguments, ReplaceArguments, TableArguments,
    ThreadArguments,
};
pub(crate) use short::with_short_help;
pub(crate) use solutions::SolutionArguments;
pub(crate) use status::StatusArguments;
pub(crate) use tolerance::Switch;
pub(crate) use verify::VerifyArguments;
pub(crate) use x_errors::XErrorArguments;

/// Exact bounded-error (set-membership) estimation in two parameters, and exact polygons from half-planes.
///
/// All results are exact rational numbers with proofs; decimals are only for display.
#[derive(Debug, Parser)]
#[command(name = "boundfit", bin_name = "boundfit", version, max_term_width = 100)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Debug, Subcommand)]
#[allow(clippy::large_enum_variant, reason = "one per run")]
pub(crate) enum Command {
    Fit(FitArguments),
    Predict(PredictArguments),
    Next(NextArguments),
    Linearity(LinearityArguments),
    Range(RangeArguments),
    Status(StatusArguments),
    Outliers(OutliersArguments),
    Reduce(ReduceArguments),
    Check(CheckArguments),
    Convert(ConvertArguments),
    Verify(VerifyArguments),
    Judge(JudgeArguments),
    Polygon(PolygonArguments),
    Plot(PlotArguments),
    Lesson(LessonArguments),
    Playground(PlaygroundArguments),
    /// Print a completion script for a shell
    #[command(after_help = COMPLETIONS_NOTES.to_string())]
    Completions {
        /// The shell
        shell: Shell,
        #[command(flatten)]
        file: FileArguments,
    },
    /// Print the manual page (roff) of the program or of one of its commands
    #[command(after_help = MAN_NOTES.to_string())]
    Man {
        /// A command. Default: the program itself
        topic: Option<String>,
        #[command(flatten)]
        file: FileArguments,
    },
}

/// The function that gives a command its options.
type WithOptions = fn(clap::Command) -> clap::Command;

/// The commands whose command line stands by itself, each with the end of its help.
const ALONE: [(&str, WithOptions, &Notes); 16] = [
    ("fit", FitArguments::augment_args, &fit::NOTES),
    ("predict", PredictArguments::augment_args, &predict::NOTES),
    ("next", NextArguments::augment_args, &next::NOTES),
    ("linearity", LinearityArguments::augment_args, &linearity::NOTES),
    ("range", RangeArguments::augment_args, &range::NOTES),
    ("status", StatusArguments::augment_args, &status::NOTES),
    ("outliers", OutliersArguments::augment_args, &outliers::NOTES),
    ("reduce", ReduceArguments::augment_args, &reduce::NOTES),
    ("check", CheckArguments::augment_args, &check::NOTES),
    ("convert", ConvertArguments::augment_args, &convert::NOTES),
    ("verify", VerifyArguments::augment_args, &verify::NOTES),
    ("judge", JudgeArguments::augment_args, &judge::NOTES),
    ("polygon", PolygonArguments::augment_args, &polygon::NOTES),
    ("plot", PlotArguments::augment_args, &plot::NOTES),
    ("lesson", LessonArguments::augment_args, &lesson::NOTES),
    ("playground", PlaygroundArguments::augment_args, &playground::NOTES),
];

/// Returns the command line with this command alone: those of all commands take longer than a fit of some dozen readings.
pub(crate) fn alone(name: &str) -> Option<clap::Command> {
    let (name, with_options, _) = ALONE.iter().find(|(own, ..)| *own == name)?;
    let command = with_options(clap::Command::new(*name));
    Some(clap::Command::new("boundfit").bin_name("boundfit").max_term_width(100).subcommand(command))
}

const COMPLETIONS_NOTES: Notes = Notes {
    examples: &[("For every user of bash", "boundfit completions bash > /etc/bash_completion.d/boundfit")],
    statuses: &[],
};

const MAN_NOTES: Notes = Notes {
    examples: &[("The page of 'fit' as a file", "boundfit man fit > boundfit-fit.1")],
    statuses: &[],
};

/// Returns the end of the help of a command.
pub(crate) fn notes(command: &str) -> Option<&'static Notes> {
    match command {
        "completions" => Some(&COMPLETIONS_NOTES),
        "man" => Some(&MAN_NOTES),
        name => ALONE.iter().find(|(own, ..)| *own == name).map(|(.., notes)| *notes),
    }
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
        assert_eq!(among_all, ["completions", "man", "help"]);
    }
}
