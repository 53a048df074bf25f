//! The way from a table and a question to the words of the answer.

use boundfit::Problem;
use boundfit::ask::{self, Ask, Asked, Fittable, Form, Misuse, Request};
use boundfit::engine::estimation::Selection;
use boundfit::engine::exact::Foreign;
use boundfit::engine::formats::{InputError, ReductionError};
use boundfit::files::{InputErrorKind, Measurements, Question, Source, TableOptions};
use boundfit::lesson::{check_work, lesson_json};
use boundfit::report::{Origin, Style};

use crate::options::{Options, no_other};
use crate::refusal::Refusal;

/// An answer of the program, or what is wrong.
pub(crate) fn run(table: Vec<u8>, options: &str) -> Result<String, Refusal> {
    let options = Options::parse(options)?;
    options.refuse_words_of_page()?;
    let (form, style, request) = (options.form()?, options.style()?, options.request()?);
    request.refuse_vain(form, &style)?;
    let (source, asked) = options.asked(table, Some(&request))?;
    let file = options.answer.file.as_deref().map(Foreign::of);
    let origin = Origin { file, reading: asked.options.table.reading, is_stored: source.is_stored() };
    let refused = |refusal| Refusal::of_file(options.file(), refusal);
    if options.numbering()?.is_some() {
        return numbered(&request, &asked, source, &options, form, (origin, style));
    }
    // Unreachable code is left out of the module; both modules have the same names, and one script of JavaScript.
    let answer = match &request {
        _ if cfg!(feature = "questions") => request.answer(&asked, source, form, Some(origin), &style),
        Request::Fit(fit) => ask::ask(fit, &asked, source, form, Some(origin), &style),
        other => return Err(no_other(other.name()).into()),
    };
    Ok(answer.map_err(refused)?.text)
}

/// The fit of readings whose rows have numbers of their own.
fn numbered(
    request: &Request,
    asked: &Asked,
    source: Source,
    options: &Options,
    form: Form,
    (origin, style): (Origin<'_>, Style),
) -> Result<String, Refusal> {
    let refuse =
        |what| format!("row_numbers: {what} is about the rows of a table as they stand there").into();
    let fit = match request {
        _ if form == Form::Proof => return Err(refuse("a proof")),
        Request::Fit(fit) if fit.sweep.is_some() => return Err(refuse("sweep")),
        Request::Fit(fit) if fit.confidence.is_some() => return Err(refuse("confidence")),
        Request::Fit(fit) => fit,
        other => return Err(refuse(other.name())),
    };
    refuse_moving(&asked.question, &source)?;
    let measurements = readings(source, asked, options, &asked.options.table, false)?;
    let answered = || {
        let problem = Fittable::from(short_problem(asked, measurements)?);
        Ok(fit.text(&problem, &fit.answer(&problem)?, form, origin, style)?.text)
    };
    answered().map_err(|refusal| Refusal::of_file(options.file(), refusal))
}

/// Returns the content of the page of `boundfit lesson`, or the refusal.
pub(crate) fn lesson(table: Vec<u8>, options: &str) -> Result<String, Refusal> {
    let options = Options::parse(options)?;
    options.refuse_words_of_report()?;
    let (source, asked) = options.asked(table, None)?;
    refuse_moving(&asked.question, &source)?;
    let table = TableOptions { keep_others: true, keep_cells: true, ..asked.options.table.clone() };
    let measurements = readings(source, &asked, &options, &table, true)?;
    if measurements.is_of_reductions() {
        return Err(InputError::of_file(options.file(), ReductionError::NotHere).into());
    }
    let refused = |refusal| Refusal::of_file(options.file(), refusal);
    let problem = short_problem(&asked, measurements).map_err(refused)?;
    check_work(&problem, asked.most_work()).map_err(|error| refused(error.into()))?;
    let page = options.lesson(&problem.measurements)?;
    lesson_json(&problem, &problem.fit(), table.reading, &page)
        .map_err(|error| Refusal::of_lesson(options.file(), &error))
}

/// Refuses a multiple of the least bound of readings that were reduced under others.
fn refuse_moving(question: &Question, source: &Source) -> Result<(), Refusal> {
    match question.moves_fixed_bounds(source) {
        true => Err(ask::Refusal::Misuse(Misuse::LeastOfFixed).into()),
        false => Ok(()),
    }
}

/// Every reading, with its number; there may be none, where that is no mistake.
fn readings(
    source: Source,
    asked: &Asked,
    options: &Options,
    table: &TableOptions,
    may_be_none: bool,
) -> Result<Measurements, Refusal> {
    let (columns, numbering) = (&asked.question.columns, options.numbering()?);
    let placed = match &numbering {
        Some(numbering) => TableOptions { rows: numbering.positions(&table.rows)?, ..table.clone() },
        None => table.clone(),
    };
    let measurements = match Measurements::read(source, columns, &placed) {
        Err(error) if may_be_none && matches!(error.kind, InputErrorKind::NoRows) => {
            return Ok(columns.without_rows());
        }
        read => read?,
    };
    let Some(numbering) = numbering else { return Ok(measurements) };
    let (numbers, rows) = (&numbering.numbers, measurements.rows_total());
    measurements
        .numbered(numbers, Selection::of(table))
        .ok_or_else(|| format!("row_numbers: {} numbers for a table of {rows} rows", numbers.len()).into())
}

/// The problem of readings, which are not too long for a fit.
fn short_problem(asked: &Asked, measurements: Measurements) -> Result<Problem, ask::Refusal> {
    Ok(asked.question.problem_within(measurements, asked.most_work())?)
}
