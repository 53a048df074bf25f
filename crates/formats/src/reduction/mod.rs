//! Tables of the few readings that stand for many, with what is known about all of them in front.
//!
//! A reduction is a line `# boundfit/reduced/1 {…}`, or `# boundfit/reduced/2 {…}` for another model, then
//! the header of the table if it has one, then the kept readings as they were written. In formats 3 and 4
//! each reading stands behind the number of readings that it stands for. Several of them one after the other
//! are a reduction of all their readings: `cat` is the union. The reader shows such a text as one table whose
//! lines keep their numbers.

pub(crate) mod error;
mod marks;
mod model;
mod reader;
pub(crate) mod record;

pub use error::ReductionError;
pub use marks::ReducedMarks;
pub use model::{AskedReduction, ReducedBounds, ReducedModel};
pub use reader::{Reductions, open_reduction};
pub use record::{REDUCTION_MARK, ReductionRecord};
