//! What is asked of readings beyond the set of all parameters that agree with them, each answered exactly.

mod status;
mod x_errors;

pub use status::{Deciding, RowStatus, Standing, Status, Statuses};
pub use x_errors::{
    Agreement, BoxBound, Corner, LeastFactor, NoLeastFactor, NoXErrors, Side, SideSet, XBounds, XErrorFit,
    XErrorProblem,
};
