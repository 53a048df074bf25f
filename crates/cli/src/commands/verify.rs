//! `boundfit verify`.

use std::fs::{self, File};
use std::io::{self, Read, Seek, Write};

use boundfit_check::nested_beyond;
use boundfit_exact::{Foreign, Limit, Work};
use boundfit_formats::SizeLimits;
use boundfit_report::{Verdict, verify_json, verify_text};
use boundfit_verify::{DataLimits, Failure as Unverified, Proof};

use crate::CommandResult;
use crate::arguments::{Format, LimitArguments, VerifyArguments};
use crate::exit::{Exit, Failure, raises};
use crate::input::{named, read_text};
use crate::output;
use crate::progress::while_working;
use crate::work::{refuse_long, times};

/// Reads the proof and the data, checks one against the other and writes the verdict.
pub(crate) fn run(arguments: &VerifyArguments) -> CommandResult {
    let VerifyArguments { proof: proof_file, data: data_file, format, limits, file, .. } = arguments;
    let format = file.format(*format)?;
    if proof_file == "-" && data_file == "-" {
        return Err(Failure::Usage("the proof and the data cannot both be standard input".to_owned()));
    }
    let guard = file.replace.guard([proof_file.as_str(), data_file]);
    guard.check(file.output.as_deref())?;
    let text = read_proof(proof_file, limits)?;
    let proof = Proof::read(text.as_bytes(), &limits.number()).map_err(|problem| {
        let raised = problem.limit().map(|limit| format!("; {}", raises(limit))).unwrap_or_default();
        Failure::data(format_args!(
            "{}: not a proof: {problem} (expected JSON of schema boundfit/proof/1 or boundfit/proof/2, or a theorem of boundfit for Coq){raised}",
            Foreign::of(named(proof_file))
        ))
    })?;
    let question = arguments.question(proof.about())?;
    let mut data = Data::new(data_file);
    let SizeLimits { line: row, columns, work, .. } = limits.sizes();
    let data_limits = DataLimits { number: limits.number(), row, columns, work };
    let verdict = while_working("verifying", || proof.verify(|| data.open(), &data_limits));
    let verdict = match verdict {
        Ok(statement) => Ok(statement),
        Err(Unverified::False(falsehood)) => Err(falsehood),
        // A refusal tells nothing about the proof.
        Err(other) => {
            let raised = match &other {
                Unverified::Refused(refusal) => refusal.limit().map(|limit| format!("; {}", raises(limit))),
                _ => None,
            };
            let data = Foreign::of(named(data_file));
            return Err(Failure::data(format_args!("{data}: {other}{}", raised.unwrap_or_default())));
        }
    };
    let differences =
        verdict.as_ref().map_or_else(|_| Vec::new(), |statement| question.differences(statement));
    let is_verified = verdict.is_ok() && differences.is_empty();
    let verdict = Verdict { found: verdict, differences };
    let report = match format {
        Format::Text => verify_text(&verdict, named(proof_file), named(data_file)),
        Format::Json => verify_json(&verdict, proof.about(), file_name(proof_file), file_name(data_file)),
    };
    output::write(&report, file.output.as_deref(), &guard)?;
    Ok(if is_verified { Exit::Answer } else { Exit::Refuted })
}

fn file_name(file: &str) -> Option<&str> {
    Some(file).filter(|file| *file != "-")
}

/// Data that are read twice, in memory that does not grow with them.
enum Data<'a> {
    /// A file, which can be opened again.
    File(&'a str),
    /// Data that can be read only once, kept in a temporary file without a name.
    Once { source: &'a str, kept: Option<File> },
}

impl<'a> Data<'a> {
    fn new(file: &'a str) -> Self {
        match file != "-" && fs::metadata(file).is_ok_and(|metadata| metadata.is_file()) {
            true => Data::File(file),
            false => Data::Once { source: file, kept: None },
        }
    }

    fn open(&mut self) -> io::Result<Box<dyn Read>> {
        match self {
            Data::File(file) => Ok(Box::new(File::open(file)?)),
            Data::Once { kept: Some(kept), .. } => {
                kept.rewind()?;
                Ok(Box::new(kept.try_clone()?))
            }
            Data::Once { source, kept } => {
                let from: Box<dyn Read> =
                    if *source == "-" { Box::new(io::stdin()) } else { Box::new(File::open(source)?) };
                let copy = kept.insert(tempfile::tempfile()?).try_clone()?;
                Ok(Box::new(Copied { from, copy }))
            }
        }
    }
}

/// Keeps what is read.
struct Copied {
    from: Box<dyn Read>,
    copy: File,
}

impl Read for Copied {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.from.read(buffer)?;
        self.copy.write_all(buffer.get(..count).unwrap_or_default())?;
        Ok(count)
    }
}

/// The text of a proof that keeps to the limits.
fn read_proof(file: &str, limits: &LimitArguments) -> Result<String, Failure> {
    let text = read_text(file, limits.statement())?;
    let nesting = limits.sizes().nesting;
    if let Some((line, column)) = nested_beyond(&text, nesting) {
        return Err(Failure::data(format_args!(
            "{}: not a proof: refused: nested deeper than {nesting} levels (the limit; {raises}) at line \
             {line} column {column}",
            Foreign::of(named(file)),
            raises = raises(Limit::Nesting)
        )));
    }
    refuse_long(Foreign::of(named(file)), &Work::of_digits(&text), times::FIT, limits)?;
    Ok(text)
}
