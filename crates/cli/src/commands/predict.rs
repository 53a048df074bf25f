//! `boundfit predict`.
use crate::CommandResult;
use crate::arguments::PredictArguments;
pub(crate) fn run(_arguments: &PredictArguments) -> CommandResult {
    Ok(crate::exit::Exit::Answer)
}
