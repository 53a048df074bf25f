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

/// The commands whose command line stands by itself.
const ALONE: [(&str, WithOptions); 16] = [
    ("fit", FitArguments::augment_args),
    ("predict", PredictArguments::augment_args),
    ("next", NextArguments::augment_args),
    ("linearity", LinearityArguments::augment_args),
    ("range", RangeArguments::augment_args),
    ("status", StatusArguments::augment_args),
    ("outliers", OutliersArguments::augment_args),
    ("reduce", ReduceArguments::augment_args),
    ("check", CheckArguments::augment_args),
    ("convert", ConvertArguments::augment_args),
    ("verify", VerifyArguments::augment_args),
    ("judge", JudgeArguments::augment_args),
    ("polygon", PolygonArguments::augment_args),
    ("plot", PlotArguments::augment_args),
    ("lesson", LessonArguments::augment_args),
    ("playground", PlaygroundArguments::augment_args),
];

/// Returns the command line with this command alone: those of all commands take longer than a fit of some dozen readings.
pub(crate) fn alone(name: &str) -> Option<clap::Command> {
    let (name, with_options) = ALONE.iter().find(|(own, _)| *own == name)?;
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
    Some(match command {
        "fit" => &fit::NOTES,
        "predict" => &predict::NOTES,
        "next" => &next::NOTES,
        "linearity" => &linearity::NOTES,
        "range" => &range::NOTES,
        "status" => &status::NOTES,
        "outliers" => &outliers::NOTES,
        "reduce" => &reduce::NOTES,
        "check" => &check::NOTES,
        "convert" => &convert::NOTES,
        "verify" => &verify::NOTES,
        "judge" => &judge::NOTES,
        "polygon" => &polygon::NOTES,
        "plot" => &plot::NOTES,
        "lesson" => &lesson::NOTES,
        "playground" => &playground::NOTES,
        "completions" => &COMPLETIONS_NOTES,
        "man" => &MAN_NOTES,
        _ => return None,
    })
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
