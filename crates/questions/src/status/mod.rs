//! Statuses: what readings and a set say of each other.

mod leave_one_out;
mod standing;

pub use leave_one_out::{Deciding, RowStatus, Statuses};
pub use standing::{Standing, Status};
