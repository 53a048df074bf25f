//! The line that a report about a fleet has for each group.

use boundfit_exact::{Interval, Rational, WideQuotient};
use boundfit_geometry::RegionKind;

use crate::bound_name::BoundName;
use crate::bounds::{Central, ParameterBound, ParameterInterval};
use crate::feasibility::least_squares_is_feasible;
use crate::fit::Fit;
use crate::problem::Problem;

/// The parts of a fit that are a line of a table: numbers without their proofs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct GroupFit {
    /// The number of readings there are.
    pub rows: usize,
    /// The row of the first of them in the file; that of a fit, of the first one in memory.
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
            kind: fit.fps.polyhedron().kind(),
            pui: fit.pui.as_ref().map(|pui| pui.each_ref().map(ParameterInterval::interval)),
            central: fit.central.clone(),
            least_squares: fit.least_squares.as_ref().ok().map(|estimate| estimate.theta.clone()),
            least: fit.minimax.as_ref().map(|minimax| minimax.least.clone()),
        }
    }
}

/// Bounds by name with positive multipliers: a proof.
pub(crate) type Terms = Vec<(BoundName, Rational)>;

/// The parts of a fit that a whole report about a group has: its line, and the proofs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct GroupAnswer {
    /// The numbers without their proofs.
    pub fit: GroupFit,
    /// False if every reading has its own error bound.
    pub is_bounded_alike: bool,
    /// The number of vertices of the FPS.
    pub vertex_count: usize,
    /// True if the least-squares estimate is in the FPS.
    pub is_feasible: bool,
    /// The largest distance of each parameter of the least-squares estimate to any in the FPS, if there is one.
    pub guaranteed_error: Option<[Rational; 2]>,
    /// The estimate uncertainty intervals, if they are known.
    pub eui: Option<[Interval; 2]>,
    /// The bounds with the multipliers that prove the lower and the upper end of each parameter; none where nothing bounds.
    pub proofs: Option<[[Terms; 2]; 2]>,
    /// The bounds with the multipliers that prove an FPS to be empty.
    pub contradiction: Option<Terms>,
}

impl GroupAnswer {
    /// These parts of a fit. Exact.
    pub fn of(problem: &Problem, fit: &Fit) -> Self {
        let error_bound = problem.measurements.error_bound();
        let proof = |end: &ParameterBound| match end {
            ParameterBound::Bounded { proof, .. } => {
                proof.multipliers.iter().map(|own| (fit.fps.name(own.index), own.value.clone())).collect()
            }
            ParameterBound::Unbounded(_) => Vec::new(),
        };
        let proofs = |pui: &ParameterInterval| [proof(&pui.lower), proof(&pui.upper)];
        GroupAnswer {
            fit: GroupFit::of(problem, fit),
            is_bounded_alike: error_bound.is_uniform(),
            vertex_count: fit.fps.polyhedron().vertex_count(),
            is_feasible: least_squares_is_feasible(fit).unwrap_or(false),
            guaranteed_error: fit.least_squares_guaranteed_error(),
            eui: fit.eui().cloned(),
            proofs: fit.pui.as_ref().map(|pui| pui.each_ref().map(proofs)),
            contradiction: fit.contradiction(error_bound),
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
