//! The line that a report about a fleet has for each group.

use boundfit_exact::{Interval, Rational, WideQuotient};
use boundfit_geometry::RegionKind;

use crate::bounds::{Central, ParameterInterval};
use crate::fit::Fit;
use crate::problem::Problem;

/// The parts of a fit that are a line of a table: numbers without their proofs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct GroupFit {
    /// The number of readings there are.
    pub rows: usize,
    /// The row of the first of them in the file.
    pub first_row: Option<usize>,
    /// The kind of set that the FPS is.
    pub kind: RegionKind,
    /// The parameter uncertainty intervals; `None` when the FPS is empty.
    pub pui: Option<[Interval; 2]>,
    /// The central estimate; `None` unless both intervals are bounded.
    pub central: Option<Central>,
    /// The least-squares estimate, if there is one.
    pub least_squares: Option<[Rational; 2]>,
    /// ε_min, or the least factor where every reading has its own error bound; `None` when none leaves anything.
    pub least: Option<Rational>,
}

impl GroupFit {
    /// These parts of a fit.
    pub fn of(problem: &Problem, fit: &Fit) -> Self {
        GroupFit {
            rows: problem.measurements.fitted(),
            first_row: problem.measurements.kept().first().map(|measurement| measurement.row),
            kind: fit.fps.polyhedron().region().kind(),
            pui: fit.pui.as_ref().map(|pui| pui.each_ref().map(ParameterInterval::interval)),
            central: fit.central.clone(),
            least_squares: fit.least_squares.as_ref().ok().map(|estimate| estimate.theta.clone()),
            least: fit.minimax.as_ref().map(|minimax| minimax.least.clone()),
        }
    }
}

/// The parts of a fit whose FPS is a polygon, as quotients that nobody has reduced: to be rounded only. The central estimate and its error
/// bounds are those of [`WideQuotient::middle`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct GroupLine {
    /// The number of readings there are.
    pub rows: usize,
    /// The row of the first of them in the file.
    pub first_row: Option<usize>,
    /// The lower and upper ends of the parameter uncertainty intervals.
    pub pui: [[WideQuotient; 2]; 2],
    /// The least-squares estimate.
    pub least_squares: [WideQuotient; 2],
    /// ε_min.
    pub least: WideQuotient,
}

impl GroupLine {
    /// The kind of set that the FPS is.
    pub const KIND: RegionKind = RegionKind::Polygon;
}
