//! From a table and a question to the words of the answer.

use std::io::Cursor;

use boundfit::engine::estimation::Selection;
use boundfit::engine::exact::Foreign;
use boundfit::engine::formats::{InputError, ReductionError};
use boundfit::files::{
    InputErrorKind, Keep, Measurements, Question, ScanOptions, SizeLimits, Source, TableOptions,
};
use boundfit::lesson::{check_work, lesson_json};
use boundfit::report::{InverseLine, Origin, fit_document, fit_json, proof_json};
use boundfit::{Problem, Reading};

use crate::options::{Format, Options};
use crate::refusal::Refusal;

/// How many times the work that is estimated of the numbers a fit may take.
const LOOKS: u64 = 4;

/// The answer of `boundfit fit`, or what is wrong.
pub(crate) fn fit(table: Vec<u8>, options: &str) -> Result<String, Refusal> {
    let options = Options::parse(options)?;
    options.refuse_words_of_page()?;
    let (format, style) = (options.format()?, options.style()?);
    let Asked { source, reading, question } = Asked::new(table, &options)?;
    let is_stored = source.is_stored();
    let scan = ScanOptions {
        table: options.table(reading)?,
        list_rows: format == Format::Proof,
        ..ScanOptions::default()
    };
    let problem = match options.numbering()? {
        Some(_) if format == Format::Proof => {
            return Err("row_numbers: a proof is about the rows of a table as they stand there"
                .to_owned()
                .into());
        }
        Some(_) => question.of_measurements(readings(source, &question, &options, &scan.table, false)?),
        None => {
            let keep = Keep { eui: !options.no_eui, ..Keep::default() };
            question.problem(source, &scan, keep)?
        }
    };
    refuse_long(&problem)?;
    let fit = problem.fit();
    let origin = Origin { file: options.file.as_deref().map(Foreign::of), reading, is_stored };
    match format {
        Format::Json => Ok(fit_json(&problem, &fit, None, None, &origin, &style)),
        Format::Text => Ok(fit_document(&problem, &fit, &origin, InverseLine::default(), &style).to_text()),
        Format::Latex => Ok(fit_document(&problem, &fit, &origin, InverseLine::default(), &style).to_latex()),
        Format::Proof => proof_json(&problem, &fit, reading).ok_or_else(|| {
            "a proof is about the rows of plain delimited text, and the table is none".to_owned().into()
        }),
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
    let problem = question.of_measurements(measurements);
    refuse_long(&problem)?;
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
        if question.multiple_of_least.is_some() && question.columns.second.is_some() && source.is_reduction()
        {
            return Err("eps: a multiple of the least bound moves the bounds, and the table is a reduction under bounds \
                        that are fixed: fit the table that it was made from"
                .to_owned()
                .into());
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

/// Refuses numbers that are too long for a fit.
fn refuse_long(problem: &Problem) -> Result<(), Refusal> {
    let work = problem.work(&[]).check(LOOKS, SizeLimits::default().work);
    work.map_err(|error| error.to_string().into())
}
