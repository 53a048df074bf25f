//! Statuses: what readings and a set say of each other.

mod descent;
mod leave_one_out;
mod ranking;
mod repair;
mod standing;
mod zonotope;

pub use leave_one_out::{Deciding, RowStatus, Statuses};
pub use ranking::{Judged, Ranking};
pub use repair::{NoRepair, Repair, Widened};
pub use standing::{Standing, Status};
