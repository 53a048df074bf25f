//! The proof of independent linearity, about the data as they are read once more.

use boundfit_exact::{Foreign, Reading};
use boundfit_questions::Linearity;
use boundfit_report::{linearity_proof, linearity_question};

use crate::arguments::LinearityArguments;
use crate::exit::Failure;
use crate::input;
use crate::output;

/// Refuses a proof that cannot be about rows, or has no file of its own.
pub(super) fn check_usage(arguments: &LinearityArguments) -> Result<(), Failure> {
    let Some(proof) = arguments.proof.as_deref() else { return Ok(()) };
    let refuse = |problem: &str| Err(Failure::Usage(problem.to_owned()));
    if arguments.direction.is_some() {
        return refuse(
            "'--proof' is about rows of which each is a point, and with '--direction' several are averaged",
        );
    }
    if arguments.data == "-" {
        return refuse(
            "'--proof' reads the data once more, which standard input does not allow: give it a file",
        );
    }
    let others =
        [arguments.output.file.output.as_deref().unwrap_or("-"), arguments.figure.as_deref().unwrap_or("-")];
    match others.iter().any(|other| *other == proof || (*other != "-" && output::is_one_file(other, proof))) {
        true => refuse("'--proof' needs a file of its own"),
        false => Ok(()),
    }
}

/// The proof.
pub(super) fn written(
    arguments: &LinearityArguments,
    linearity: &Linearity,
    reading: Reading,
) -> Result<String, Failure> {
    let options = arguments.table.options(reading, Some(&arguments.rows))?;
    let open = || input::open(&arguments.data);
    let question =
        linearity_question(&arguments.columns(), &options, reading, open).map_err(Failure::refused)?;
    let proof = question.and_then(|question| linearity_proof(linearity, &question));
    proof.ok_or_else(|| {
        let file = Foreign::of(&arguments.data);
        Failure::Usage(format!(
            "'--proof' is about the rows of delimited text of which each is a point of its own, with a reading in every column, and \
             those of {file} are not (docs/proof.md)"
        ))
    })
}
