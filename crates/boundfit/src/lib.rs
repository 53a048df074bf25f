//! Exact bounded-error (set-membership) estimation in two parameters: every parameter pair that agrees with all readings.
//!
//! Readings y_i at known x_i follow a line, up to errors of which nothing is known but a bound:
//!
//! ```text
//! y_i = θ1·x_i + θ2 + e_i,   |e_i| ≤ ε
//! ```
//!
//! Each reading leaves a strip of the (θ1, θ2) plane. The strips meet in a convex polygon, the *feasible parameter set*
//! (FPS): the parameters in it agree with every reading, and no others do. [`fit`](fn@fit) computes it, exactly:
//!
//! ```
//! let fit = boundfit::fit(&[0, 1, 2], &["0", "1.5", "2"], "1/2")?;
//!
//! // The polygon, as fractions.
//! assert_eq!(fit.vertices().len(), 3);
//! // The interval of each parameter: its smallest and its largest value over the polygon.
//! let [slope, offset] = fit.pui_intervals().unwrap();
//! assert_eq!(slope.to_string(), "[1/2, 3/2]");
//! assert_eq!(offset.to_string(), "[-1/2, 1/2]");
//! // The smallest error bound that leaves any parameters at all.
//! assert_eq!(fit.minimax.as_ref().unwrap().least.to_string(), "1/4");
//! # Ok::<(), boundfit::Error>(())
//! ```
//!
//! # Numbers
//!
//! Nothing is rounded, and there is no tolerance. Numbers come in as whatever is a [`Number`]: integers, floats (each the
//! dyadic fraction that it is), decimals and fractions as text, or fractions of `num-rational`. Numbers come out as
//! [`Rational`]s, which print as `p/q`, as decimals rounded in a stated direction, or go on into other exact arithmetic:
//!
//! ```
//! use boundfit::Rounding;
//! use boundfit::num_rational::BigRational;
//!
//! let fit = boundfit::fit(&[1.0, 2.0, 4.0], &[0.9, 2.1, 3.9], 0.25)?;
//! let [slope, _] = fit.central.as_ref().unwrap().theta.each_ref();
//! assert_eq!(slope.to_decimal(5, Rounding::Nearest), "0.99167");
//! let twice: BigRational = BigRational::from(slope) * BigRational::from_integer(2.into());
//! assert!(twice < BigRational::from_integer(2.into()));
//! # Ok::<(), boundfit::Error>(())
//! ```
//!
//! With the feature `nalgebra` a regressor matrix and a vector of doubles are a problem ([`Observations::from_matrix`]), and vertices
//! are points of fractions ([`exact_points`]) or, rounded, of doubles ([`rounded_points`]):
//!
//! ```
//! # #[cfg(feature = "nalgebra")] {
//! use boundfit::nalgebra::{DMatrix, DVector};
//! use boundfit::{Observations, exact_points, rounded_points};
//!
//! // y = theta1*phi1 + theta2*phi2 + e with |e| ≤ 1/4.
//! let phi = DMatrix::from_row_slice(3, 2, &[1.0, 0.0, 0.0, 1.0, 1.0, 1.0]);
//! let fit = Observations::from_matrix(&phi, &DVector::from_vec(vec![2.0, 3.0, 5.0]))?.error_bound(0.25)?.fit();
//! let points = exact_points(&fit.vertices());
//! assert_eq!(points[0].x.to_string(), "7/4");
//! assert_eq!(rounded_points(&fit.vertices())[0].x, 1.75);
//! # }
//! # Ok::<(), boundfit::Error>(())
//! ```
//!
//! Many readings in slices of doubles have a function of their own: [`fit_doubles`] takes 10⁶ of them in a few
//! hundredths of a second. Each double stands for itself or for the shortest decimal that is read as it.
//!
//! # Models, bounds and prior knowledge
//!
//! [`Observations`] are readings of a line or of a model with two regressors. With one error bound, or with one for
//! each reading, they become a [`Problem`], to which linear conditions on the parameters can be added:
//!
//! ```
//! use boundfit::Observations;
//!
//! let fit = Observations::regressors(&[1, 0, 1], &[0, 1, 1], &["2", "3", "5.1"])?
//!     .error_bounds(&["0.1", "0.1", "0.2"])?
//!     .condition("theta1 + theta2 >= 5")?
//!     .fit();
//! assert_eq!(fit.vertices().len(), 3);
//! # Ok::<(), boundfit::Error>(())
//! ```
//!
//! # Answers are proved
//!
//! An empty set is an answer, with at most three readings or conditions that contradict each other. So is an unbounded
//! one. Every end of an interval carries the readings that prove it, and [`Fit::verify`] recomputes each proof from the
//! readings:
//!
//! ```
//! use boundfit::{BoundName, Observations};
//!
//! let problem = Observations::line(&[0, 1, 2], &[0, 1, 0])?.error_bound("0.4")?;
//! let fit = problem.fit();
//! assert!(fit.is_empty());
//! let contradiction = fit.contradiction(problem.measurements.error_bound()).unwrap();
//! let names: Vec<BoundName> = contradiction.into_iter().map(|(name, _)| name).collect();
//! assert_eq!(names, [BoundName::Upper(1), BoundName::Lower(2), BoundName::Upper(3)]);
//! assert_eq!(fit.verify(&problem), Ok(()));
//! # Ok::<(), boundfit::Error>(())
//! ```
//!
//! # Features
//!
//! `cargo add --path CLONE/crates/boundfit --features questions,report` adds this crate from a clone of its repository to a
//! program, with two of these features:
//!
//! | feature | what it adds |
//! |---|---|
//! | none | all of the above, and [`polygon`] for any half-planes |
//! | `files` (default) | the module `files`: tables of text, files of half-planes |
//! | `matlab`, `packed` (default) | MATLAB's `.mat` and Octave's text; files packed by gzip or Zstandard |
//! | `nalgebra` (default) | readings in matrices of nalgebra, vertices as its points; without it no linear algebra is compiled |
//! | `parallel` (default) | all processors at once for large files |
//! | `spreadsheets` | sheets of `.xlsx` and `.ods` workbooks |
//! | `arrow` | Parquet and Arrow IPC files |
//! | `lp` | the module `check`: claims about the intervals, judged exactly |
//! | `judge` | the module `judge`: linear programs of any two variables, read from MPS and LP and solved exactly |
//! | `float-solvers` | solvers whose answers are judged (microlp, Clarabel) |
//! | `questions` | the module `questions`: statuses of readings, prediction, the next reading, linearity, outliers, linear range, errors in x |
//! | `ask` | the module `ask`: a question as JSON says it, answered in any form |
//! | `verify` | the module `verify`: the checker of proofs |
//! | `report` | the module `report`: answers as text, JSON, LaTeX, Markdown |
//! | `figures` | the module `figures`: both planes as SVG and PNG |
//! | `tikz` | source for LaTeX's TikZ among them |
//! | `lesson` | the module `lesson`: the web page that teaches |
//! | `engine` (default) | the engine inside that page, for readings that are changed there |
//!
//! Everything that this documentation shows at the root of this crate, and in its feature modules, follows the versions of this
//! crate. The module [`engine`] has the crates underneath, for whoever needs more; they may change in any release.

#[cfg(feature = "lp")]
pub mod check;
mod doubles;
#[cfg(feature = "files")]
pub mod files;
#[cfg(feature = "judge")]
pub mod judge;
#[cfg(feature = "nalgebra")]
mod matrices;
mod number;
mod observations;
#[cfg(feature = "questions")]
pub mod questions;
#[cfg(feature = "report")]
pub mod report;
#[cfg(feature = "verify")]
pub mod verify;

pub use boundfit_estimation::{
    BoundName, Central, Condition, ErrorBound, Fit, Fps, Inverse, InverseParameter, LeastSquares, Minimax,
    NoLeastSquares, ParameterBound, ParameterInterval, ParseConditionError, Problem,
};
pub use boundfit_exact::{Endpoint, Integer, Interval, ParseNumberError, Rational, Reading, Rounding};
pub use boundfit_geometry::{
    Direction, Inequality, Point, Polyhedron, ProofError, Region, RegionKind, Support, System, Vertex,
};
#[cfg(feature = "nalgebra")]
pub use nalgebra;
pub use num_rational;

pub use doubles::{fit_doubles, problem_of_doubles};
#[cfg(feature = "nalgebra")]
pub use matrices::{exact_points, rounded_points};
pub use number::{Number, NumberError};
pub use observations::{Error, Observations};

#[cfg(feature = "ask")]
pub use boundfit_ask as ask;
#[cfg(feature = "figures")]
pub use boundfit_figures as figures;
#[cfg(feature = "lesson")]
pub use boundfit_lesson as lesson;

/// The crates that this one is made of, with everything that they offer.
pub mod engine {
    #[cfg(feature = "lp")]
    pub use boundfit_check as check;
    pub use boundfit_estimation as estimation;
    pub use boundfit_exact as exact;
    #[cfg(feature = "files")]
    pub use boundfit_formats as formats;
    pub use boundfit_geometry as geometry;
    #[cfg(feature = "judge")]
    pub use boundfit_judge as judge;
    #[cfg(any(feature = "judge", feature = "lp"))]
    pub use boundfit_lp as lp;
    #[cfg(feature = "questions")]
    pub use boundfit_questions as questions;
    #[cfg(feature = "report")]
    pub use boundfit_report as report;
}

/// Fits the line y = theta1*x + theta2 + e with |e| ≤ eps to readings. Exact. Cost: O(N log N).
///
/// # Errors
/// When a number has no exact value, the columns are not equally long, or the error bound is negative.
///
/// ```
/// let fit = boundfit::fit(&[0.0, 1.0, 2.0], &[0.0, 1.5, 2.0], 0.5)?;
/// assert_eq!(fit.vertices()[0].each_ref().map(ToString::to_string), ["1/2", "1/2"]);
/// # Ok::<(), boundfit::Error>(())
/// ```
pub fn fit<X: Number, Y: Number>(x: &[X], y: &[Y], eps: impl Number) -> Result<Fit, Error> {
    Ok(Observations::line(x, y)?.error_bound(eps)?.fit())
}

/// Intersects half-planes: each row (a1, a2, b) means a1·θ1 + a2·θ2 ≤ b. Exact. Cost: O(n log n).
///
/// # Errors
/// When a number has no exact value.
///
/// ```
/// let triangle = boundfit::polygon(&[[-1, 0, 0], [0, -1, 0], [2, 3, 6]])?;
/// assert_eq!(triangle.region().area().unwrap().to_string(), "3");
/// # Ok::<(), boundfit::Error>(())
/// ```
pub fn polygon<N: Number>(rows: &[[N; 3]]) -> Result<Polyhedron, Error> {
    let exact = |row: usize, column: &'static str, number: &N| {
        number.exact().map_err(|problem| Error::Number { column, row, problem })
    };
    let inequality = |(row, [a1, a2, b]): (usize, &[N; 3])| {
        Ok(Inequality::new(exact(row, "a1", a1)?, exact(row, "a2", a2)?, exact(row, "b", b)?))
    };
    let system: Result<Vec<Inequality>, Error> = (1..).zip(rows).map(inequality).collect();
    Ok(Polyhedron::intersect(System::new(system?)))
}
