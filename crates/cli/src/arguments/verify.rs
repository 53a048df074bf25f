//! The arguments of `boundfit verify`.

use clap::Args;

use super::notes::{BAD_USAGE, Notes};
use super::shared::LIMITS;
use super::{FileArguments, Format, LimitArguments};

pub(super) const NOTES: Notes = Notes {
    examples: &[
        (
            "A proof that somebody made, against the data that it is about",
            "boundfit fit transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --proof proof.json\n\
             boundfit verify proof.json transducer.csv",
        ),
        ("The same without boundfit", "python3 tests/verify.py proof.json transducer.csv"),
    ],
    statuses: &[
        (0, "every statement of the proof is true of these data"),
        (1, "a file that cannot be read or written, or is not a proof"),
        BAD_USAGE,
        (4, "a statement is false; the first one is named"),
    ],
};

/// Check a proof that 'boundfit fit --proof' wrote: is every statement in it true of these data?
///
/// The data are read anew and every statement is checked by exact arithmetic, with nothing of the program that found the
/// answer but its numbers. docs/proof.md says what a proof states and why the checks suffice.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string())]
pub(crate) struct VerifyArguments {
    /// The proof, or - for standard input
    pub(crate) proof: String,
    /// The data, or - for standard input
    pub(crate) data: String,
    /// Format of the verdict; told by the end of the output file's name when left out, else text
    #[arg(long, value_enum)]
    pub(crate) format: Option<Format>,
    #[command(flatten)]
    pub(crate) limits: LimitArguments,
    /// Bytes that a proof may have
    #[arg(long, value_name = "BYTES", default_value_t = 1 << 28, help_heading = LIMITS, hide_short_help = true)]
    pub(crate) max_proof_size: u64,
    #[command(flatten)]
    pub(crate) file: FileArguments,
}
