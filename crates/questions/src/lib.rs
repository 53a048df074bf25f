//! What is asked of readings beyond the set of all parameters that agree with them, each answered exactly.

mod guarantee;
mod linearity;
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
pub use outliers::{Growth, NoOutliers, OutlierLimits, Outliers, Piece};
pub use predict::{FurtherError, NoFurtherError, PossibleEnd, PossibleX, Predictor};
pub use range::{LinearRange, Order, Run};
pub use status::{
    Deciding, Judged, NoRepair, Ranking, Repair, RowStatus, Standing, Status, Statuses, Widened,
};
pub use window::{Contradiction, Extent, Moved, Moving, Turn, Window, WindowFit, WindowSet};
pub use x_errors::{
    Agreement, BoxBound, Corner, Demand, LeastFactor, NoLeastFactor, NoXErrors, Side, SideSet, SlopeDemand,
    SlopeEnd, XBounds, XErrorFit, XErrorProblem,
};
