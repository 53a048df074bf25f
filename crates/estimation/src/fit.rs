//! The whole set-membership answer for a set of readings.

use boundfit_exact::{Interval, Rational};
use boundfit_geometry::{Measure, Measures, ProofError, System, verify_membership};

use crate::bound_name::BoundName;
use crate::bounds::{Central, ParameterInterval, central, guaranteed_error, parameter_intervals};
use crate::fps::{Fps, contradiction_among, every_half_plane};
use crate::grid::Grid;
use crate::hulls::Extremes;
use crate::inverse::Inverse;
use crate::least_squares::LeastSquares;
use crate::meaning::{ErrorBound, Model};
use crate::minimax::Minimax;
use crate::problem::Problem;
use crate::reduction::NoLeastSquares;
use crate::sieve;

/// The answer. A part that does not exist for a problem is `None`; [`Fit::least_squares`] says why.
#[derive(Debug, Clone)]
pub struct Fit {
    /// The least-squares estimate with its EUI.
    pub least_squares: Result<LeastSquares, NoLeastSquares>,
    /// The feasible parameter set. It lacks half-planes that cannot be active; [`Fit::with_every_half_plane`] has all of them.
    pub fps: Fps,
    /// The parameter uncertainty intervals; `None` when the FPS is empty.
    pub pui: Option<[ParameterInterval; 2]>,
    /// The central estimate; `None` unless both intervals are bounded.
    pub central: Option<Central>,
    /// The least error bound and the minimax estimate; `None` when no error bound leaves anything.
    pub minimax: Option<Minimax>,
}

/// Computes everything. Exact. Cost: O(N log N).
///
/// Sums and hulls are decided on machine integers where the readings, as integers on common denominators, fit into them.
///
/// ```
/// use boundfit_estimation::{Columns, EpsilonColumn, LineForm, Measurements, Problem, fit};
/// use boundfit_exact::{Interval, Rational};
/// use boundfit_formats::{ColumnSelector, Source, TableOptions};
///
/// let table = Source::new("readings.csv", "x,y\n0,0\n1,1.5\n2,2\n".as_bytes());
/// let columns = Columns {
///     first: ColumnSelector::name_or_number("x"),
///     second: None,
///     response: Some(ColumnSelector::name_or_number("y")),
///     epsilon: EpsilonColumn::Uniform(Rational::ratio(1, 2)),
///     form: LineForm::default(),
/// };
/// let measurements = Measurements::read(table, &columns, &TableOptions::default())?;
/// let fit = fit(&Problem { measurements, conditions: Vec::new() });
/// let [slope, _] = fit.pui.unwrap();
/// assert_eq!(Some(slope.interval()), Interval::around(&Rational::one(), &Rational::ratio(1, 2)));
/// # Ok::<(), boundfit_formats::InputError>(())
/// ```
pub fn fit(problem: &Problem) -> Fit {
    let Problem { measurements, conditions } = problem;
    let deciding = measurements.on_grid();
    let grid = if deciding.is_some() { None } else { Grid::new(measurements) };
    let least_squares = LeastSquares::with_grid(measurements, grid.as_ref());
    let extremes = measurements.has_hulls().then(|| match deciding {
        Some(own) => Extremes::of_deciding(own),
        None => Extremes::new(measurements.kept(), grid.as_ref()),
    });
    let (fps, minimax) = match extremes {
        Some(extremes) => {
            let minimax = Minimax::with_extremes(measurements, conditions, Some(&extremes), None);
            (Fps::of_extremes(measurements, conditions, extremes), minimax)
        }
        None => {
            let estimate = least_squares.as_ref().ok().map(|estimate| &estimate.theta);
            let positions = sieve::deciding(measurements.kept(), estimate);
            let minimax = Minimax::with_extremes(measurements, conditions, None, Some(&positions));
            (Fps::of_deciding(measurements, conditions, &positions), minimax)
        }
    };
    let pui = parameter_intervals(fps.polyhedron());
    let central = pui.as_ref().and_then(central);
    Fit { least_squares, fps, pui, central, minimax }
}

impl Problem {
    /// Computes everything, as [`fit`](fn@fit) does.
    pub fn fit(&self) -> Fit {
        fit(self)
    }
}

impl Fit {
    /// This answer with all half-planes of the readings in its FPS, also those that cannot be active.
    pub fn with_every_half_plane(&self, problem: &Problem) -> Fit {
        let fps = Fps::of_every_half_plane(&problem.measurements, &problem.conditions);
        // The proofs name half-planes by their position.
        let pui = parameter_intervals(fps.polyhedron());
        Fit { fps, pui, ..self.clone() }
    }

    /// Returns whether no parameters agree with all readings. [`Fit::contradiction`] says why.
    pub fn is_empty(&self) -> bool {
        self.fps.polyhedron().is_empty()
    }

    /// The vertices (θ1, θ2) of the FPS, counter-clockwise from the lexicographically smallest. Exact.
    pub fn vertices(&self) -> Vec<[Rational; 2]> {
        let vertices = self.fps.polyhedron().region().vertices();
        vertices.iter().map(|vertex| vertex.point().coordinates()).collect()
    }

    /// The parameter uncertainty intervals without their proofs.
    pub fn pui_intervals(&self) -> Option<[Interval; 2]> {
        self.pui.as_ref().map(|pui| pui.each_ref().map(ParameterInterval::interval))
    }

    /// Gain and offset of the inverse line, x as a function of y; `None` unless the model is a line. Exact. Cost: that of
    /// [`Inverse::new`].
    pub fn inverse(&self, model: &Model) -> Option<Inverse> {
        let Model::Line { .. } = model else { return None };
        let estimate = self.least_squares.as_ref().ok();
        Some(Inverse::new(
            self.fps.polyhedron(),
            self.pui_intervals().as_ref(),
            self.eui(),
            self.central.as_ref().map(|central| &central.theta),
            estimate.map(|estimate| &estimate.theta),
        ))
    }

    /// The EUI, when there is one.
    pub fn eui(&self) -> Option<&[Interval; 2]> {
        self.least_squares.as_ref().ok()?.eui.as_ref().ok()
    }

    /// Returns how far the least-squares estimate keeps inside the FPS: the smallest slack over all half-planes and the
    /// half-plane with it. A negative slack means that the estimate is not feasible. `None` also where the reading that it
    /// misses most is not known; [`least_squares_is_feasible`](crate::least_squares_is_feasible) does without. Exact.
    pub fn least_squares_slack(&self) -> Option<(Rational, BoundName)> {
        if !self.fps.has_tightest() {
            return None;
        }
        let estimate = self.least_squares.as_ref().ok()?;
        let membership = self.fps.polyhedron().membership(&estimate.theta);
        Some((membership.slack?, self.fps.name(membership.tightest?)))
    }

    /// The largest |θ_j - θ̂_j| over the FPS for the least-squares estimate; `None` unless both PUI are bounded.
    pub fn least_squares_guaranteed_error(&self) -> Option<[Rational; 2]> {
        let estimate = self.least_squares.as_ref().ok()?;
        guaranteed_error(&estimate.theta, &self.pui_intervals()?, self.central.as_ref()?)
    }

    /// Area of the FPS over area of the PUI box, between 0 and 1; `None` when the box has no finite positive area.
    /// Exact.
    pub fn tightness(&self) -> Option<Rational> {
        let measures = self.fps.polyhedron().region().measures();
        Some(self.share_of_box(&measures)?.exact())
    }

    /// Returns the value of [`Fit::tightness`] from the measures of the FPS.
    pub fn share_of_box<'a>(&self, measures: &'a Measures) -> Option<Measure<'a>> {
        measures.share_of(&self.box_area()?)
    }

    /// The area of the PUI box; `None` unless both PUI are bounded. Exact.
    fn box_area(&self) -> Option<Rational> {
        let [first, second] = self.pui_intervals()?;
        Some(first.width()? * second.width()?)
    }

    /// Returns whether the PUI box has a finite positive area.
    pub fn has_box_with_area(&self) -> bool {
        self.box_area().is_some_and(|area| area.is_positive())
    }

    /// Returns, for an empty FPS, at most three half-planes with positive multipliers whose sum is `0 ≤ negative`.
    /// For a line under a uniform bound these are the readings that need the largest bound. In all other cases they
    /// are the first half-plane, among those that can be active, that contradicts earlier ones, and the half-planes
    /// that it contradicts. Under a uniform bound conditions that contradict each other come first. So it does not
    /// depend on which half-planes that are never active the FPS has, nor on whether all readings are in memory.
    /// Exact.
    pub fn contradiction(&self, error_bound: &ErrorBound) -> Option<Vec<(BoundName, Rational)>> {
        let certificate = self.fps.polyhedron().certificate()?;
        let Some(epsilon) = error_bound.uniform() else { return self.fps.first_contradiction() };
        if !self.fps.has_hulls() {
            return self.contradiction_of_conditions().or_else(|| self.fps.first_contradiction());
        }
        match &self.minimax {
            Some(minimax) if minimax.least > *epsilon => Some(minimax.proof.multipliers.clone()),
            None => self.contradiction_of_conditions(),
            Some(_) => Some(
                certificate.multipliers().iter().map(|m| (self.fps.name(m.index), m.value.clone())).collect(),
            ),
        }
    }

    /// Returns at most three conditions with positive multipliers whose sum is `0 ≤ negative`, if conditions
    /// contradict each other whatever the readings are. Exact.
    pub fn contradiction_of_conditions(&self) -> Option<Vec<(BoundName, Rational)>> {
        let named = self.fps.names().iter().zip(self.fps.polyhedron().system().inequalities());
        let conditions = named.filter(|(name, _)| name.condition().is_some());
        contradiction_among(conditions.map(|(name, inequality)| (*name, inequality.clone())))
    }

    /// Recomputes every proof of the answer from the readings: emptiness, each end of the PUI and ε_min. Exact.
    ///
    /// # Errors
    /// The first statement that is false.
    pub fn verify(&self, problem: &Problem) -> Result<(), ProofError> {
        use crate::bounds::ParameterBound::{Bounded, Unbounded};
        let system = self.fps.polyhedron().system();
        let (names, every) = every_half_plane(&problem.measurements, &problem.conditions);
        if let Some(index) = first_unknown(&self.fps, &names, &every) {
            return Err(ProofError::UnknownInequality(index));
        }
        if let Some(certificate) = self.fps.polyhedron().certificate() {
            certificate.verify(system)?;
        }
        for interval in self.pui.iter().flatten() {
            for end in [&interval.lower, &interval.upper] {
                match end {
                    Bounded { proof, .. } => {
                        proof.verify(system)?;
                        verify_membership(&every, &proof.attained_at)?;
                    }
                    Unbounded(proof) => proof.verify(&every)?,
                }
            }
        }
        match &self.minimax {
            Some(Minimax { least, proof, .. })
                if !proof.verify(&problem.measurements, &problem.conditions, least) =>
            {
                Err(ProofError::WrongValue)
            }
            _ => Ok(()),
        }
    }
}

/// The first half-plane of a set that is not one of some others, given in the same order.
fn first_unknown(fps: &Fps, names: &[BoundName], system: &System) -> Option<usize> {
    let mut known = names.iter().zip(system.inequalities());
    let mut own = fps.names().iter().zip(fps.polyhedron().system().inequalities());
    own.position(|own| !known.any(|known| known == own))
}
