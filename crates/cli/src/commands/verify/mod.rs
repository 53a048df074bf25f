//! `boundfit verify`.

mod question;

use std::fs::{self, File};
use std::io::{self, Read, Seek, Write};

use boundfit_ask::{Readings, Regressors, TableWords};
use boundfit_check::nested_beyond;
use boundfit_exact::{Foreign, Limit, Reading, Work};
use boundfit_formats::{DELIMITERS, Header, SizeLimits};
use boundfit_report::{Verdict, verify_json, verify_text};
use boundfit_verify::{DataLimits, Failure as Unverified, Proof};
use clap::builder::PossibleValuesParser;
use clap::{Arg, Args};

use crate::exit::{CommandResult, Exit, Failure, raises};
use crate::input::{named, read_text};
use crate::options::{
    BAD_USAGE, EpsilonArguments, FileArguments, Format, LimitArguments, LineArguments, Notes, RowArguments,
    XErrorArguments, given, parse_regressors, words_or_auto,
};
use crate::output;
use crate::progress::while_working;
use crate::work::{refuse_long, times};

pub(super) const NOTES: Notes = Notes {
    examples: &[
        (
            "A proof, checked against the data that it is about",
            "boundfit fit transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --proof proof.json\n\
             boundfit verify proof.json transducer.csv",
        ),
        (
            "The same, if the proof must answer this very question",
            "boundfit verify proof.json transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3",
        ),
        (
            "The rows of a theorem for Coq, compared with the data",
            "boundfit fit transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --proof answer.v\n\
             boundfit verify answer.v transducer.csv",
        ),
        ("The check without boundfit", "python3 tests/verify.py proof.json transducer.csv"),
    ],
    statuses: &[
        (0, "every statement of the proof is true of these data, or the theorem has the rows of these data"),
        (1, "a file that cannot be read or written, is not a proof, or is beyond a limit"),
        BAD_USAGE,
        (
            4,
            "a statement is false, or the proof answers another question than was asked; the first one is named",
        ),
    ],
};

/// Check a proof that '--proof' wrote: is every statement in it true of these data?
///
/// The checker reads the data again and checks every statement by exact arithmetic; it shares only its numbers with
/// the program that found the answer. It also says which question the proof answers: model, columns, error bound,
/// conditions and rows. With options of 'fit' the question must be theirs. With --x and an error bound everything is
/// compared. An omitted option then means what it means in 'fit': every row, no conditions, no errors in x. Otherwise
/// only the given options are compared. docs/proof.md defines the proof and explains why the checks suffice.
///
/// PROOF may also be a theorem for Coq. boundfit then compares its rows and conditions with the data, number by number; coqc checks
/// what follows from them.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string(), mut_group("EpsilonArguments", |group| group.required(false)),
    mut_args(comparable))]
pub(crate) struct VerifyArguments {
    /// The proof, or - for standard input
    proof: String,
    /// The data, or - for standard input
    data: String,
    /// Format of the verdict. Default: the ending of the output file's name, else text
    #[arg(long, value_enum)]
    format: Option<Format>,
    #[command(flatten)]
    limits: LimitArguments,
    #[command(flatten)]
    file: FileArguments,
    /// Column of x by header name or number from 1; two for the model y = theta1*COL + theta2*COL2 + e
    #[arg(long, value_name = "COL[,COL2]", value_parser = parse_regressors, help_heading = QUESTION)]
    x: Option<Regressors>,
    /// Column of y
    #[arg(long, value_name = "COL", help_heading = QUESTION)]
    y: Option<String>,
    #[command(flatten, next_help_heading = QUESTION)]
    epsilon: EpsilonArguments,
    #[command(flatten)]
    x_errors: XErrorArguments,
    #[command(flatten)]
    rows: RowArguments,
    /// A linear inequality or equation that the parameters satisfy; repeatable
    #[arg(long = "where", value_name = "CONDITION", allow_hyphen_values = true)]
    conditions: Vec<String>,
    #[command(flatten)]
    line: LineArguments,
    /// Read numbers exactly as written, or as the nearest double, exactly
    #[arg(long, value_parser = PossibleValuesParser::new(Reading::ALL.map(Reading::name)))]
    reading: Option<String>,
    /// Say whether the first row names the columns
    #[arg(long, default_value = Header::Auto.name(),
          value_parser = PossibleValuesParser::new(Header::ALL.map(Header::name)))]
    header: String,
    /// Separator of columns
    #[arg(long, default_value = "auto", value_parser = words_or_auto(DELIMITERS.map(|(name, _)| name)))]
    delimiter: String,
}

/// The help of the error bound, without multiples of `min` and `range(y)`, which depend on the readings.
const EPS: &str = "Error bound of every reading: a number such as 0.5e-3, or a law such as '0.05%*|y| + 2e-3'. 'written' is half a unit \
                   of the last digit written. '+0.2/-0.1' says that the truth lies in [y - 0.1, y + 0.2]. For 'min' and \
                   range(y) give the number that the report of 'fit' names";

/// Leaves out of the help what depends on the readings, so that it cannot be compared.
fn comparable(argument: Arg) -> Arg {
    match argument.get_id().as_str() {
        "eps" => argument.help(EPS).long_help(EPS),
        "where_row" => argument.hide(true),
        _ => argument,
    }
}

impl VerifyArguments {
    /// The readings, as far as they are said.
    fn words(&self) -> Readings {
        let table = TableWords {
            reading: self.reading.clone(),
            header: Some(self.header.clone()),
            delimiter: Some(self.delimiter.clone()),
            limits: self.limits.words(),
            ..TableWords::default()
        };
        let readings = Readings {
            x: self.x.clone(),
            y: self.y.clone(),
            conditions: given(&self.conditions),
            rows: self.rows.words(),
            table,
            ..self.line.beside(self.epsilon.words())
        };
        self.x_errors.beside(readings)
    }
}

/// The heading of what asks the question that the proof must answer.
const QUESTION: &str = "The question that the proof must answer (options of 'fit')";

/// Reads the proof and the data, checks one against the other and writes the verdict.
pub(super) fn run(arguments: &VerifyArguments) -> CommandResult {
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
        Failure::data(format_args!("{}: not a proof: {problem}{raised}", Foreign::of(named(proof_file))))
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
    let differences = verdict.as_ref().map(|statement| question.differences(named(data_file), statement));
    let differences = differences.unwrap_or_else(|_| Ok(Vec::new()))?;
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
