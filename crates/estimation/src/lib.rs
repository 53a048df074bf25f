//! Bounded-error (set-membership) estimation of a model that is linear in two parameters,
//!
//! ```text
//! y_i = φ_i1·θ1 + φ_i2·θ2 + e_i,   |e_i| ≤ ε_i          (line model: φ_i = (x_i, 1))
//! ```
//!
//! with nothing else known about the errors. [`fit`] computes, exactly:
//! - the least-squares estimate and its uncertainty intervals (EUI),
//! - the feasible parameter set (FPS) with its vertices,
//! - the parameter uncertainty intervals (PUI) with the readings that prove them,
//! - the central estimate,
//! - the smallest error bound ε_min with its minimax estimate,
//! - gain and offset of the inverse line.
//!
//! Definitions follow Milanese and Vicino, "Optimal estimation theory for dynamic systems with set membership
//! uncertainty: an overview", *Automatica* 27 (1991).
//!
//! ```
//! use boundfit_estimation::{ErrorBound, Measurement, Measurements, Model, Problem, fit};
//! use boundfit_exact::Rational;
//!
//! let readings = [(1, 1), (2, 3), (3, 4)];
//! let rows = readings.iter().zip(1..).map(|(&(x, y), row)| {
//!     let regressor = [Rational::from(x), Rational::one()];
//!     Measurement::around(row, regressor, Rational::from(y), Rational::ratio(1, 2))
//! });
//! let bound = ErrorBound::Uniform(Rational::ratio(1, 2));
//! let model = Model::Line { x: "x".into() };
//! let measurements = Measurements::new(model, "y".into(), bound, rows.collect());
//! let fit = fit(&Problem { measurements, conditions: Vec::new() });
//! assert_eq!(fit.minimax.as_ref().unwrap().least, Rational::ratio(1, 4));
//! ```

mod asked_bound;
mod bound_name;
mod bounds;
mod condition;
mod corridor;
mod deciding;
mod family;
mod feasibility;
#[cfg(feature = "files")]
mod files;
mod fit;
#[cfg(feature = "float-least-squares")]
mod float_least_squares;
mod fps;
mod grid;
mod group_fit;
mod growing;
mod halves;
mod hulls;
mod inverse;
mod law;
mod least_growth;
mod least_squares;
mod line_form;
mod meaning;
mod measurement;
mod measurements;
mod mending;
mod minimax;
mod moments;
mod one_parameter;
mod places;
mod problem;
mod products;
mod reduction;
mod rounded;
mod scale;
mod scanner;
mod selection;
mod shown;
mod sieve;
mod summary;
mod sums;
mod terms;
mod ties;
mod work;

pub use asked_bound::AskedBound;
pub use bound_name::BoundName;
pub use bounds::{Central, ParameterBound, ParameterInterval, central_of, parameter_intervals};
pub use condition::{Condition, ParseConditionError, ParseConditionErrorKind};
pub use corridor::{Corridor, CorridorEdge};
pub use deciding::DecidingRows;
pub use family::{
    AreaGrowth, Breakpoint, Family, Linear, MovingArea, MovingBoundary, MovingVertex, Piece, Section,
    SectionBoundary, SectionVertex, ShortAreas,
};
pub use feasibility::least_squares_is_feasible;
#[cfg(feature = "files")]
pub use files::{Columns, CountedBatch, CountedRows, EpsilonColumn, Fleet, Question, ReducedTable, Seen};
pub use fit::{Fit, fit};
#[cfg(feature = "float-least-squares")]
pub use float_least_squares::{FloatEstimate, FloatLeastSquares};
pub use fps::{
    Fps, bounds_of_reading, conditions_by_name, contradiction_among, growing_half_planes, half_planes,
    reading_of_bound,
};
pub use group_fit::{GroupAnswer, GroupFit, GroupLine};
pub use inverse::{Inverse, InverseParameter};
pub use law::Law;
pub use least_growth::{GrowingInequality, LeastGrowth, least_growth};
pub use least_squares::LeastSquares;
pub use line_form::LineForm;
pub use meaning::{ErrorBound, Model, MultipleOfLeast};
pub use measurement::{Bounds, Measurement};
pub use measurements::{Measurements, Readings};
pub use mending::mending_rows;
pub use minimax::{Minimax, MinimaxProof};
pub use moments::Sums;
pub use problem::Problem;
pub use reduction::{DecidingMinimax, NoEui, NoLeastSquares, NoMinimax, Reach, Reduction};
pub use scanner::{ParseTextError, TextProblem};
pub use selection::{FractionCells, Selection};
pub use summary::{ColumnsError, Keep};
pub use terms::{ParseBoundError, ParseBoundErrorKind};
pub use ties::{ActiveBounds, Ties};
