//! The file of `--proof`, beside a report.

use crate::exit::Failure;
use crate::output;

/// Refuses a proof that would have no file of its own.
pub(super) fn check(proof: Option<&str>, output: Option<&str>) -> Result<(), Failure> {
    let Some(file) = proof else { return Ok(()) };
    match output.unwrap_or("-") {
        "-" if file == "-" => Err(Failure::Usage(
            "'--proof -' and the report would both go to standard output: give one of them a file".to_owned(),
        )),
        output if output != "-" && file != "-" && output::is_one_file(output, file) => {
            Err(Failure::Usage("'--proof' and '--output' name the same file".to_owned()))
        }
        _ => Ok(()),
    }
}
