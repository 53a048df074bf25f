//! The arguments of `boundfit verify`.

use boundfit_ask::Regressors;
use boundfit_exact::Reading;
use boundfit_formats::{DELIMITERS, Header};
use clap::Args;
use clap::builder::PossibleValuesParser;

use super::notes::{BAD_USAGE, Notes};
use super::shared::{EpsilonArguments, LineArguments};
use super::values::{parse_regressors, words_or_auto};
use super::{FileArguments, Format, LimitArguments, RowArguments};

pub(super) const NOTES: Notes = Notes {
    examples: &[
        (
            "A proof that somebody made, against the data that it is about",
            "boundfit fit transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --proof proof.json\n\
             boundfit verify proof.json transducer.csv",
        ),
        (
            "Is it about the question that was asked?",
            "boundfit verify proof.json transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3",
        ),
        (
            "Does a theorem for Coq have the readings of these data?",
            "boundfit fit transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --proof answer.v\n\
             boundfit verify answer.v transducer.csv",
        ),
        ("The check without boundfit", "python3 tests/verify.py proof.json transducer.csv"),
    ],
    statuses: &[
        (0, "every statement of the proof is true of these data, or the rows of the theorem are theirs"),
        (1, "a file that cannot be read or written, is not a proof, or is beyond a limit"),
        BAD_USAGE,
        (
            4,
            "a statement is false, or the proof answers another question than was asked; the first one is named",
        ),
    ],
};

/// Check a proof of 'boundfit fit --proof': is every statement in it true of these data?
///
/// The checker reads the data again and checks every statement by exact arithmetic; it shares only its numbers with the
/// program that found the answer. It also says which question the proof answers: model, columns, error bound,
/// conditions and rows. With options of 'fit' the question must be theirs. With --x and an error bound everything is
/// compared, and an omitted option means what it means in 'fit' (every row, no conditions); otherwise only the given
/// options are compared. docs/proof.md defines the proof and explains why the checks suffice.
///
/// A theorem for Coq begins with a comment of Coq. Its rows and conditions are compared with the data, number by number. coqc checks
/// what follows from them.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string(), mut_group("EpsilonArguments", |group| group.required(false)))]
pub(crate) struct VerifyArguments {
    /// The proof, or - for standard input
    pub(crate) proof: String,
    /// The data, or - for standard input
    pub(crate) data: String,
    /// Format of the verdict. Default: the ending of the output file's name, else text
    #[arg(long, value_enum)]
    pub(crate) format: Option<Format>,
    #[command(flatten)]
    pub(crate) limits: LimitArguments,
    #[command(flatten)]
    pub(crate) file: FileArguments,
    /// Column of x by header name or number from 1; two for the model y = theta1*COL + theta2*COL2 + e
    #[arg(long, value_name = "COL[,COL2]", value_parser = parse_regressors, help_heading = QUESTION)]
    pub(super) x: Option<Regressors>,
    /// Column of y
    #[arg(long, value_name = "COL", help_heading = QUESTION)]
    pub(super) y: Option<String>,
    #[command(flatten, next_help_heading = QUESTION)]
    pub(super) epsilon: EpsilonArguments,
    #[command(flatten)]
    pub(super) rows: RowArguments,
    /// A linear inequality or equation that the parameters satisfy; repeatable
    #[arg(long = "where", value_name = "CONDITION", allow_hyphen_values = true)]
    pub(super) conditions: Vec<String>,
    #[command(flatten)]
    pub(super) line: LineArguments,
    /// Read numbers exactly as written, or as the nearest double, exactly
    #[arg(long, value_parser = PossibleValuesParser::new(Reading::ALL.map(Reading::name)))]
    pub(super) reading: Option<String>,
    /// Whether the first row names the columns
    #[arg(long, default_value = Header::Auto.name(),
          value_parser = PossibleValuesParser::new(Header::ALL.map(Header::name)))]
    pub(super) header: String,
    /// Separator of columns
    #[arg(long, default_value = "auto", value_parser = words_or_auto(DELIMITERS.map(|(name, _)| name)))]
    pub(super) delimiter: String,
}

/// The heading of what asks the question that the proof must answer.
const QUESTION: &str = "The question that the proof must answer (options of 'fit')";
