//! `boundfit predict`.

mod values;

use std::io::{self, BufWriter, Write};

use boundfit_estimation::{AskedBound, Law, Problem, fit};
use boundfit_exact::{Limits, Reading};
use boundfit_questions::times::bits_of_corner;
use boundfit_questions::{FurtherError, NoFurtherError};
use boundfit_report::{
    AskedValues, Prediction, Style, prediction_document, prediction_proof, write_prediction_csv,
    write_prediction_json,
};

use super::proof_file;
use crate::CommandResult;
use crate::arguments::{PredictArguments, TableFormat};
use crate::exit::{Exit, Failure};
use crate::input;
use crate::output::{self, Output, Stop};
use crate::progress::while_working;
use crate::work::{refuse_long, times};
use values::{Asked, ValueOption, Values};

/// Values that a proof may be about.
const MOST_PROVED: usize = 1_000;

/// Reads the data, fits, and writes what is predicted.
pub(crate) fn run(arguments: &PredictArguments) -> CommandResult {
    arguments.threads.set()?;
    let format = arguments.output.format()?;
    let limits = arguments.data.table.limits.number();
    let given = further_law(arguments, &limits)?;
    let questions = questions(arguments, &limits)?;
    check_usage(arguments, format, &questions)?;
    let output = arguments.output.file.output.as_deref();
    let files = [&questions.at, &questions.from].into_iter().flatten().filter_map(|asked| match asked {
        Asked::File { path, .. } => Some(path.as_str()),
        Asked::Numbers(_) => None,
    });
    let mut guard = arguments.output.file.replace.guard([arguments.data.path()].into_iter().chain(files));
    guard.check(output)?;
    guard.check(arguments.proof.as_deref())?;
    let (at, from) = read_values(arguments, questions, &limits)?;
    let data = arguments.data.open();
    let origin = data.origin();
    let has_proof = arguments.proof.is_some();
    let is_hash_shown = format == TableFormat::Json || has_proof;
    let problem = data.scanned_problem(false, is_hash_shown, has_proof, false)?;
    refuse_long_values(arguments, &problem, [&at, &from])?;
    if format == TableFormat::Csv {
        input::say_table(arguments.data.file_name(), problem.measurements.table());
    }
    let fit = while_working("fitting", || fit(&problem));
    let error = match &given {
        None => FurtherError::of(&problem.measurements),
        Some(law) => FurtherError::by_law(law, &problem.measurements),
    };
    check_error(arguments, &error)?;
    let prediction = Prediction {
        problem: &problem,
        fit: &fit,
        origin,
        error,
        given,
        at: AskedValues { count: at.len(), values: &|| at.iter() },
        from: AskedValues { count: from.len(), values: &|| from.iter() },
    };
    let style = arguments.output.style();
    let exit = if fit.is_empty() { Exit::Empty } else { Exit::Answer };
    if arguments.proof.is_none() && matches!(format, TableFormat::Json | TableFormat::Csv) {
        // There may be a million of them.
        output::write_parts(|output| write_streamed(&prediction, format, &style, output), output, &guard)?;
        return Ok(exit);
    }
    let report = report(&prediction, arguments, format, &style)?;
    let proof = match &arguments.proof {
        None => None,
        Some(file) => Some((proof(&prediction, arguments, origin.reading)?, file.as_str())),
    };
    proof_file::write(&report, output, proof, &mut guard)?;
    Ok(exit)
}

/// What is asked, before any file is read.
struct Questions {
    at: Vec<Asked>,
    from: Vec<Asked>,
}

/// Understands the options of values.
fn questions(arguments: &PredictArguments, limits: &Limits) -> Result<Questions, Failure> {
    let numbers = if arguments.data.has_two_regressors() { 2 } else { 1 };
    let at = ValueOption { name: "--at <X,...|FILE:COL>", numbers, second: 1 };
    let from = ValueOption { name: "--from <Y,...|FILE:COL>", numbers: 1, second: 0 };
    let parse = |option: ValueOption, texts: &[String]| {
        texts.iter().map(|text| option.parse(text, limits)).collect::<Result<Vec<Asked>, Failure>>()
    };
    if numbers == 2 {
        for (option, is_asked) in
            [("--from", !arguments.from.is_empty()), ("--grid", arguments.grid.is_some())]
        {
            if is_asked {
                return Err(Failure::Usage(format!(
                    "'{option}' is about a line: with two regressors there is no single x (ask '--at' for pairs)"
                )));
            }
        }
    }
    Ok(Questions { at: parse(at, &arguments.at)?, from: parse(from, &arguments.from)? })
}

/// The values themselves.
fn read_values(
    arguments: &PredictArguments,
    questions: Questions,
    limits: &Limits,
) -> Result<(Values, Values), Failure> {
    let (mut at, mut from) = (Values::beside(1), Values::beside(0));
    if let Some(grid) = &arguments.grid {
        at.add_grid(grid, limits, arguments.data.table.limits.sizes().rows)?;
    }
    questions.at.into_iter().try_for_each(|asked| at.add(asked, &arguments.data))?;
    questions.from.into_iter().try_for_each(|asked| from.add(asked, &arguments.data))?;
    Ok((at, from))
}

/// What is stated of the error of a further reading.
fn further_law(arguments: &PredictArguments, limits: &Limits) -> Result<Option<Law>, Failure> {
    let Some(text) = &arguments.new_eps else { return Ok(None) };
    let refuse = |problem: String| Failure::value("--new-eps <NUM>", text, problem);
    let law = Law::parse(text, Reading::Decimal, limits);
    let law = law.map_err(|error| match AskedBound::parse(text, Reading::Decimal, limits) {
        Ok(AskedBound::TimesLeast(_)) => refuse(
            "a multiple of the least bound says nothing of a further reading (expected a number such as 0.5, or a law)"
                .to_owned(),
        ),
        _ => refuse(error.to_string()),
    })?;
    if law.needs_x() && arguments.data.has_two_regressors() {
        return Err(refuse("two regressors have no |x| (expected a law of |y| and range(y))".to_owned()));
    }
    Ok(Some(law))
}

/// Refuses what cannot be written or read together.
fn check_usage(
    arguments: &PredictArguments,
    format: TableFormat,
    questions: &Questions,
) -> Result<(), Failure> {
    let refuse = |problem: &str| Err(Failure::Usage(problem.to_owned()));
    let is_at = !questions.at.is_empty() || arguments.grid.is_some();
    if format == TableFormat::Csv && is_at && !questions.from.is_empty() {
        return refuse(
            "'--format csv' writes one table: ask '--at' or '--grid', and '--from', in runs of their own",
        );
    }
    if arguments.proofs && matches!(format, TableFormat::Csv | TableFormat::Json) {
        return refuse(
            "'--proofs' is about text, latex and markdown; JSON has them anyway, and CSV has no room",
        );
    }
    let is_input = |asked: &&Asked| matches!(asked, Asked::File { path, .. } if path == "-");
    let inputs = questions.at.iter().chain(&questions.from).filter(is_input).count();
    if inputs + usize::from(arguments.data.path() == "-") > 1 {
        return refuse("standard input is read once: give one of the tables a file");
    }
    proof_file::check(arguments.proof.as_deref(), arguments.output.file.output.as_deref())
}

/// Refuses to ask where a reading comes from of which nothing is known.
fn check_error(
    arguments: &PredictArguments,
    error: &Result<FurtherError, NoFurtherError>,
) -> Result<(), Failure> {
    match error {
        Err(reason) if arguments.new_eps.is_some() => {
            let text = arguments.new_eps.as_deref().unwrap_or_default();
            Err(Failure::value("--new-eps <NUM>", text, format!("{reason} (expected a number such as 0.5)")))
        }
        Err(reason) if !arguments.from.is_empty() => Err(Failure::Usage(format!(
            "'--from' needs the error bound of the reading, and {reason}: say it with '--new-eps'"
        ))),
        _ => Ok(()),
    }
}

/// Refuses values that are long beside the numbers of the set.
fn refuse_long_values(
    arguments: &PredictArguments,
    problem: &Problem,
    values: [&Values; 2],
) -> Result<(), Failure> {
    let bits = bits_of_corner(problem);
    for values in values {
        let limits = &arguments.data.table.limits;
        refuse_long(arguments.data.file_name(), &values.work(bits), times::PREDICT, limits)?;
    }
    Ok(())
}

/// The report in memory.
fn report(
    prediction: &Prediction,
    arguments: &PredictArguments,
    format: TableFormat,
    style: &Style,
) -> Result<Vec<u8>, Failure> {
    let document = || prediction_document(prediction, arguments.proofs, style);
    Ok(match format {
        TableFormat::Text => document().to_text().into_bytes(),
        TableFormat::Latex => document().to_latex().into_bytes(),
        TableFormat::Markdown => document().to_markdown().into_bytes(),
        TableFormat::Csv | TableFormat::Json => {
            let mut bytes = Vec::new();
            write_table(prediction, format, style, &mut bytes).map_err(Failure::data)?;
            bytes
        }
    })
}

fn write_table(
    prediction: &Prediction,
    format: TableFormat,
    style: &Style,
    to: &mut dyn Write,
) -> io::Result<()> {
    match format {
        TableFormat::Csv => write_prediction_csv(prediction, to),
        _ => write_prediction_json(prediction, style, to),
    }
}

/// Writes a table that need not be in memory.
fn write_streamed(
    prediction: &Prediction,
    format: TableFormat,
    style: &Style,
    output: &mut Output,
) -> Result<(), Stop> {
    let mut sink = Sink { output, stop: None };
    let written = {
        let mut buffer = BufWriter::with_capacity(1 << 16, &mut sink);
        write_table(prediction, format, style, &mut buffer).and_then(|()| buffer.flush())
    };
    match (sink.stop, written) {
        (Some(stop), _) => Err(stop),
        (None, Err(error)) => Err(Stop::Failed(Failure::data(error))),
        (None, Ok(())) => Ok(()),
    }
}

/// An output for writers that know [`io::Write`] only.
struct Sink<'a> {
    output: &'a mut Output,
    /// Why nothing more can be written.
    stop: Option<Stop>,
}

impl Write for Sink<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.stop.is_none()
            && let Err(stop) = self.output.write(bytes)
        {
            self.stop = Some(stop);
        }
        if self.stop.is_some() { Err(io::Error::other("stopped")) } else { Ok(bytes.len()) }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// The proof of every end.
fn proof(prediction: &Prediction, arguments: &PredictArguments, reading: Reading) -> Result<String, Failure> {
    if prediction.at.count + prediction.from.count > MOST_PROVED {
        return Err(Failure::Usage(format!("'--proof' is about {MOST_PROVED} values at most")));
    }
    prediction_proof(prediction, reading).ok_or_else(|| {
        let file = arguments.data.file_name();
        Failure::Usage(format!(
            "'--proof' is about the rows of delimited text, and {file} is none, or a reduction of it (docs/proof.md)"
        ))
    })
}
