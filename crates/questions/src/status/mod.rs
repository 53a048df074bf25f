//! Statuses: what readings and a set say of each other.

mod descent;
mod leave_one_out;
#[cfg(feature = "files")]
mod others;
mod ranking;
mod repair;
mod standing;
mod zonotope;

pub use leave_one_out::{Deciding, RowStatus, Statuses};
#[cfg(feature = "files")]
pub use others::Others;
pub use ranking::{Judged, Ranking};
pub use repair::{NoRepair, Repair, Widened};
pub use standing::{Standing, Status};
