//! What is asked of readings beyond the set of all parameters that agree with them, each answered exactly.

mod status;

pub use status::{Deciding, RowStatus, Standing, Status, Statuses};
