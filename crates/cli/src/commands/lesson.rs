//! `boundfit lesson`.

use boundfit_estimation::fit;
use boundfit_exact::Limit;
use boundfit_formats::{InputError, ReductionError};
use boundfit_lesson::{Language, LessonOptions, page};
use clap::Args;

use crate::exit::{CommandResult, Exit, Failure};
use crate::options::{
    BAD_DATA, BAD_USAGE, DataArguments, FileArguments, LabelArguments, Notes, limits, named, told_by_name,
};
use crate::output;
use crate::progress::while_working;
use crate::work::refuse_long_lesson;

pub(super) const NOTES: Notes = Notes {
    examples: &[(
        "A page about a line, for every browser",
        "boundfit lesson transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 -o lesson.html",
    )],
    statuses: &[
        (0, "the page is written"),
        BAD_DATA,
        BAD_USAGE,
        (
            3,
            "the feasible parameter set is empty; the page shows why, and the smallest error bound that leaves a set",
        ),
    ],
};

/// Write a web page that explains the feasible parameters of these readings
///
/// The page is one file without outside parts, for every browser. It shows the readings and the parameter plane side by
/// side, clipping step by step, a slider for the error bound, the role of each reading, and questions with answers. All
/// numbers are exact.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string(), mut_arg("limit", |limit| limits::with(&[Limit::Readings])(limit).hide_short_help(false)))]
pub(crate) struct LessonArguments {
    #[command(flatten)]
    data: DataArguments,
    #[command(flatten)]
    labels: LabelArguments,
    /// First language of the page; the reader can change it
    #[arg(long, default_value = Language::English.code(),
          value_parser = named(Language::ALL.map(|language| (language.code(), language))))]
    language: Language,
    #[command(flatten)]
    file: FileArguments,
}

/// Reads the data, fits and writes the page.
pub(super) fn run(arguments: &LessonArguments) -> CommandResult {
    let output = arguments.file.output.as_deref();
    let guard = arguments.file.replace.guard([arguments.data.path()]);
    guard.check(output)?;
    told_by_name(output, &[("html", ()), ("htm", ())], None)?;
    output::refuse_terminal("page", output)?;
    let most = arguments.data.table.limits.readings();
    let data = arguments.data.words().open()?.at_most(most);
    let reading = data.origin.reading;
    let problem = data.problem_with_cells()?;
    if problem.measurements.is_of_reductions() {
        return Err(Failure::refused(InputError::of_file(
            arguments.data.file_name(),
            ReductionError::NotHere,
        )));
    }
    refuse_long_lesson(arguments.data.file_name(), &problem, &arguments.data.table.limits)?;
    let fit = fit(&problem);
    let [x_unit, y_unit] = arguments.labels.units(&problem.measurements);
    let options = LessonOptions {
        file: arguments.data.file_name().to_owned(),
        title: arguments.labels.title.clone(),
        x_unit,
        y_unit,
        language: arguments.language,
        most_rows: most,
    };
    let page = while_working("writing the page", || page(&problem, &fit, reading, &options));
    output::write(page.map_err(Failure::data)?, output, &guard)?;
    Ok(if fit.fps.polyhedron().is_empty() { Exit::Empty } else { Exit::Answer })
}
