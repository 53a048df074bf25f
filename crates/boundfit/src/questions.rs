//! The questions about readings beyond the set of all parameters that agree with them, each answered exactly.
//!
//! ```
//! use boundfit::Observations;
//! use boundfit::questions::{LinearRange, Order};
//!
//! // The last reading leaves the line of the others.
//! let problem = Observations::line(&[0, 1, 2, 3], &[0, 1, 2, 9])?.error_bound("1/2")?;
//! let range = LinearRange::of(&problem, Order::natural(problem.measurements.model()));
//! assert_eq!(range.longest().map(|run| run.len()), Some(3));
//! # Ok::<(), boundfit::Error>(())
//! ```

#[doc(hidden)]
pub use boundfit_questions::times;
pub use boundfit_questions::{
    Agreement, AlternatingPoint, Best, BoxBound, CalibrationPoint, CalibrationReading, Characteristic,
    Contradiction, Corner, Deciding, Demand, Difference, Extent, FurtherError, Goal, Growth, Guarantee,
    Judged, LeastFactor, LinearRange, Linearity, LinearityInput, LinearityLine, LinearityOptions, Moved,
    Moving, Next, NextReading, NoFurtherError, NoLeastFactor, NoLine, NoOutliers, NoRepair, NoXErrors, Order,
    OutlierLimits, Outliers, Pass, Piece, PossibleEnd, PossibleX, Predictor, Ranking, Repair,
    ResponseColumns, RowStatus, Run, Side, SideSet, SlopeDemand, SlopeEnd, Standing, Status, Statuses, Turn,
    Widened, Window, WindowFit, WindowSet, XBounds, XErrorFit, XErrorProblem, guaranteed_share,
};
#[cfg(feature = "files")]
pub use boundfit_questions::{Calibration, CalibrationColumns, CalibrationError, CalibrationResponse};
