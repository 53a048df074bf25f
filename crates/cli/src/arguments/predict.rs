//! The arguments of `boundfit predict`.
use clap::Args;
use super::notes::{BAD_DATA, BAD_USAGE, Notes};
use super::DataArguments;
pub(super) const NOTES: Notes = Notes { examples: &[], statuses: &[(0, "an answer was found"), BAD_DATA, BAD_USAGE] };
/// Predict
#[derive(Debug, Args)]
pub(crate) struct PredictArguments {
    #[command(flatten)]
    pub(crate) data: DataArguments,
}
