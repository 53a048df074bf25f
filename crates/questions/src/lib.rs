//! Questions about readings beyond their feasible parameter set, each answered exactly and with a proof.
//!
//! | module | question |
//! |---|---|
//! | `status` | is a reading inner, boundary, outer or an outlier with respect to the others? |
//! | `predict` | where does the line run at an x, where may a reading lie there, and which x has a reading? |
//! | `linearity` | how far is a sensor's characteristic from a straight line, in four definitions of data sheets? |
//! | `outliers` | which are the fewest readings to ignore so that some parameters agree with all others? |
//! | `range` | which runs of readings does a line agree with? |
//! | `window` | what is the set of the last readings, as the window moves on? |
//! | `x_errors` | which lines agree with readings whose x have errors, too? |
//! | `guarantee` | which share of further readings lies in the band of ε_min, for any source? |
//! | [`times`] | how much more work than a fit is each question? |
//!
//! A question takes a problem and returns an answer as data. `boundfit-ask` reads what is asked; `boundfit-report` writes answers.

mod guarantee;
mod linearity;
mod next;
mod outliers;
mod predict;
mod range;
mod status;
pub mod times;
mod window;
mod x_errors;

pub use guarantee::{Guarantee, guaranteed_share};
pub use linearity::{
    AlternatingPoint, CalibrationPoint, CalibrationReading, Characteristic, Difference, Linearity,
    LinearityInput, LinearityLine, LinearityOptions, NoLine, Pass, ResponseColumns,
};
#[cfg(feature = "files")]
pub use linearity::{Calibration, CalibrationColumns, CalibrationError, CalibrationResponse};
pub use next::{Best, Goal, Next, NextReading};
pub use outliers::{Growth, NoOutliers, OutlierLimits, Outliers, Piece};
pub use predict::{FurtherError, NoFurtherError, PossibleEnd, PossibleX, Predictor};
pub use range::{LinearRange, Order, Run};
#[cfg(feature = "files")]
pub use status::Others;
pub use status::{
    Deciding, Judged, NoRepair, Ranking, Repair, RowStatus, Standing, Status, Statuses, Widened,
};
pub use window::{Contradiction, Extent, Moved, Moving, Turn, Window, WindowFit, WindowSet};
pub use x_errors::{
    Agreement, BoxBound, Corner, Demand, LeastFactor, NoLeastFactor, NoXErrors, Side, SideSet, SlopeDemand,
    SlopeEnd, XBounds, XErrorFit, XErrorProblem,
};
