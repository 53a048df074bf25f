//! One file per command.

mod asked;
pub(crate) mod check;
pub(crate) mod completions;
pub(crate) mod convert;
pub(crate) mod fit;
pub(crate) mod fleet;
pub(crate) mod judge;
pub(crate) mod lesson;
pub(crate) mod linearity;
pub(crate) mod man;
pub(crate) mod next;
pub(crate) mod outliers;
mod pictures;
pub(crate) mod playground;
pub(crate) mod plot;
pub(crate) mod polygon;
pub(crate) mod predict;
mod proof_file;
pub(crate) mod range;
pub(crate) mod reduce;
mod solutions;
pub(crate) mod status;
pub(crate) mod verify;
pub(crate) mod window;
pub(crate) mod x_errors;
