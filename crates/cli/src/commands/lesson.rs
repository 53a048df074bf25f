//! `boundfit lesson`.

use boundfit_estimation::fit;
use boundfit_formats::{InputError, ReductionError};
use boundfit_lesson::{LessonOptions, page};

use crate::CommandResult;
use crate::arguments::{LessonArguments, told_by_name};
use crate::exit::{Exit, Failure};
use crate::output;
use crate::progress::while_working;
use crate::work::refuse_long_lesson;

/// Reads the data, fits and writes the page.
pub(crate) fn run(arguments: &LessonArguments) -> CommandResult {
    let output = arguments.file.output.as_deref();
    let guard = arguments.file.replace.guard([arguments.data.path()]);
    guard.check(output)?;
    told_by_name(output, &[("html", ()), ("htm", ())], None)?;
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
    Ok(if fit.fps.polyhedron().region().is_empty() { Exit::Empty } else { Exit::Answer })
}
