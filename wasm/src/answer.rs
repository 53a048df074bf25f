//! From a table and a question to the words of the answer.

use std::io::Cursor;

use boundfit::engine::exact::Foreign;
use boundfit::files::{Keep, ScanOptions, SizeLimits, Source};
use boundfit::report::{InverseLine, Origin, fit_document, fit_json, proof_json};
use boundfit::{Problem, Reading};

use crate::options::{Format, Options};

/// How many times the work that is estimated of the numbers a fit may take.
const LOOKS: u64 = 4;

/// The answer, or what is wrong.
pub(crate) fn answer(table: Vec<u8>, options: &str) -> Result<String, String> {
    let options = Options::parse(options)?;
    let (format, style) = (options.format()?, options.style()?);
    let source = Source::new(options.file.as_deref().unwrap_or("standard input"), Cursor::new(table));
    let is_stored = source.is_stored();
    let reading = if is_stored { Reading::Binary64 } else { options.reading()? };
    let problem = problem(source, &options, reading, format == Format::Proof)?;
    let fit = problem.fit();
    let origin = Origin { file: options.file.as_deref().map(Foreign::of), reading, is_stored };
    match format {
        Format::Json => Ok(fit_json(&problem, &fit, None, None, &origin, &style)),
        Format::Text => Ok(fit_document(&problem, &fit, &origin, InverseLine::default(), &style).to_text()),
        Format::Proof => proof_json(&problem, &fit, reading).ok_or_else(|| {
            "a proof is about the rows of plain delimited text, and the table is none".to_owned()
        }),
    }
}

/// The readings with their bounds, whose numbers are not too long for a fit.
fn problem(source: Source, options: &Options, reading: Reading, list_rows: bool) -> Result<Problem, String> {
    let question = options.question(reading)?;
    if question.multiple_of_least.is_some() && question.columns.second.is_some() && source.is_reduction() {
        return Err("eps: a multiple of the least bound moves the bounds, and the table is a reduction under bounds that are \
                    fixed: fit the table that it was made from"
            .to_owned());
    }
    let scan = ScanOptions { table: options.table(reading)?, list_rows, ..ScanOptions::default() };
    let keep = Keep { eui: !options.no_eui, ..Keep::default() };
    let problem = question.problem(source, &scan, keep).map_err(|error| error.to_string())?;
    let work = problem.work(&[]).check(LOOKS, SizeLimits::default().work);
    work.map_err(|error| error.to_string())?;
    Ok(problem)
}
