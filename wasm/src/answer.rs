//! From a table and a question to the words of the answer.

use std::io::Cursor;

use boundfit::ask::{self, FitXErrors, Form, Misuse, NoProof, Request};
use boundfit::engine::estimation::Selection;
use boundfit::engine::exact::Foreign;
use boundfit::engine::formats::{InputError, ReductionError};
use boundfit::files::{
    InputErrorKind, Keep, Measurements, Question, ScanOptions, SizeLimits, Source, TableOptions,
};
use boundfit::lesson::{check_work, lesson_json};
use boundfit::report::{InverseLine, Origin, fit_csv, fit_document, fit_json, proof_json, region_wkt};
use boundfit::{Problem, Reading};

use crate::options::Options;
use crate::refusal::Refusal;

/// An answer of the program, or what is wrong.
pub(crate) fn run(table: Vec<u8>, options: &str) -> Result<String, Refusal> {
    let options = Options::parse(options)?;
    options.refuse_words_of_page()?;
    let (form, style, request) = (options.form()?, options.style()?, options.request()?);
    let Asked { source, reading, question } = Asked::new(table, &options)?;
    let origin =
        Origin { file: options.file.as_deref().map(Foreign::of), reading, is_stored: source.is_stored() };
    let scan = ScanOptions { table: options.table(reading)?, ..ScanOptions::default() };
    let x_errors = options.x_errors(reading)?;
    let request = match request {
        None if x_errors.is_some() => Some(Request::FitXErrors(FitXErrors {})),
        request => request,
    };
    if options.numbering()?.is_some() && (request.is_some() || form == Form::Proof) {
        let what = if request.is_some() { "the question" } else { "a proof" };
        return Err(format!("row_numbers: {what} is about the rows of a table as they stand there").into());
    }
    if let Some(request) = request {
        let asked = ask::Asked { question, x_errors, options: scan };
        return Ok(request.answer(&asked, source, form, Some(origin), &style)?.text);
    }
    let measurements = match options.numbering()? {
        Some(_) => readings(source, &question, &options, &scan.table, false)?,
        None => {
            let scan = ScanOptions { list_rows: form == Form::Proof, ..scan };
            let keep = Keep { eui: !options.no_eui, ..Keep::default() };
            question.measurements(source, &scan, keep)?
        }
    };
    let problem = short_problem(&question, measurements)?;
    let fit = problem.fit();
    let document = || fit_document(&problem, &fit, &origin, InverseLine::default(), &style);
    match form {
        Form::Json => Ok(fit_json(&problem, &fit, None, None, &origin, &style)),
        Form::Text => Ok(document().to_text()),
        Form::Latex => Ok(document().to_latex()),
        Form::Markdown => Ok(document().to_markdown()),
        Form::Csv => Ok(fit_csv(&problem, &fit)),
        Form::Wkt => region_wkt(fit.fps.polyhedron(), &style).map_err(Into::into),
        Form::Proof => {
            proof_json(&problem, &fit, reading).ok_or_else(|| ask::Refusal::NoProof(NoProof::NoText).into())
        }
    }
}

/// What the page of `boundfit lesson` shows, or what is wrong.
pub(crate) fn lesson(table: Vec<u8>, options: &str) -> Result<String, Refusal> {
    let options = Options::parse(options)?;
    options.refuse_words_of_report()?;
    let Asked { source, reading, question } = Asked::new(table, &options)?;
    let table = TableOptions { keep_others: true, keep_cells: true, ..options.table(reading)? };
    let measurements = readings(source, &question, &options, &table, true)?;
    if measurements.is_of_reductions() {
        return Err(InputError::of_file(options.file(), ReductionError::NotHere).into());
    }
    let problem = short_problem(&question, measurements)?;
    let long = |error| format!("{}: {error}", options.file());
    check_work(&problem, SizeLimits::default().work).map_err(long)?;
    let page = options.lesson(&problem.measurements)?;
    lesson_json(&problem, &problem.fit(), reading, &page)
        .map_err(|error| Refusal::of_lesson(options.file(), &error))
}

/// A table, and what is asked of it.
struct Asked {
    source: Source,
    reading: Reading,
    question: Question,
}

impl Asked {
    fn new(table: Vec<u8>, options: &Options) -> Result<Self, Refusal> {
        let source = Source::new(options.file(), Cursor::new(table));
        let reading = if source.is_stored() { Reading::Binary64 } else { options.reading()? };
        let question = options.question(reading)?;
        if question.moves_fixed_bounds(&source) {
            return Err(ask::Refusal::Misuse(Misuse::LeastOfFixed).into());
        }
        Ok(Asked { source, reading, question })
    }
}

/// Every reading, with its number; there may be none, where that is no mistake.
fn readings(
    source: Source,
    question: &Question,
    options: &Options,
    table: &TableOptions,
    may_be_none: bool,
) -> Result<Measurements, Refusal> {
    let measurements = match Measurements::read(source, &question.columns, table) {
        Err(error) if may_be_none && matches!(error.kind, InputErrorKind::NoRows) => {
            return Ok(question.columns.without_rows());
        }
        read => read?,
    };
    let Some(numbering) = options.numbering()? else { return Ok(measurements) };
    let (numbers, rows) = (&numbering.numbers, measurements.rows_total());
    let asked = Selection::of(&TableOptions { rows: options.row_set()?, ..table.clone() });
    measurements
        .numbered(numbers, asked)
        .ok_or_else(|| format!("row_numbers: {} numbers for a table of {rows} rows", numbers.len()).into())
}

/// The problem of readings, which are not too long for a fit.
fn short_problem(question: &Question, measurements: Measurements) -> Result<Problem, Refusal> {
    let problem = question.problem_within(measurements, SizeLimits::default().work);
    Ok(problem.map_err(ask::Refusal::from)?)
}
