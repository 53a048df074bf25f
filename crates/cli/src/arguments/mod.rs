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

use clap::{Parser, Subcommand};
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
