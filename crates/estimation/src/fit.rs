//! The whole set-membership answer for a set of readings.

use boundfit_exact::{Interval, Rational};
use boundfit_geometry::ProofError;

use crate::bounds::{Central, ParameterInterval, central, guaranteed_error, parameter_intervals};
use crate::condition::Condition;
use crate::float_least_squares::FloatLeastSquares;
use crate::fps::{BoundName, Fps};
use crate::inverse::Inverse;
use crate::least_squares::{LeastSquares, SingularRegressors};
use crate::measurements::{ErrorBound, Measurements, Model};
use crate::minimax::Minimax;

/// What is to be fitted.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Problem {
    /// The readings.
    pub measurements: Measurements,
    /// Prior knowledge about θ.
    pub conditions: Vec<Condition>,
}

/// The answer. What does not exist for a problem is `None`; [`Fit::least_squares`] says why.
#[derive(Debug, Clone)]
pub struct Fit {
    /// The least-squares estimate with its EUI.
    pub least_squares: Result<LeastSquares, SingularRegressors>,
    /// The same in binary64, when the exact estimate exists.
    pub float_least_squares: Option<FloatLeastSquares>,
    /// The feasible parameter set.
    pub fps: Fps,
    /// The parameter uncertainty intervals; `None` when the FPS is empty.
    pub pui: Option<[ParameterInterval; 2]>,
    /// The central estimate; `None` unless both intervals are bounded.
    pub central: Option<Central>,
    /// The least error bound and the minimax estimate; `None` when no error bound leaves anything.
    pub minimax: Option<Minimax>,
    /// Gain and offset of the inverse line; `None` unless the model is a line.
    pub inverse: Option<Inverse>,
}

/// Computes everything. Exact, but for the binary64 estimates. Cost: O(N log N).
pub fn fit(problem: &Problem) -> Fit {
    let Problem { measurements, conditions } = problem;
    let least_squares = LeastSquares::new(measurements);
    let float_least_squares =
        least_squares.as_ref().ok().map(|exact| FloatLeastSquares::new(measurements, &exact.theta));
    let fps = Fps::new(measurements, conditions);
    let pui = parameter_intervals(fps.polyhedron());
    let central = pui.as_ref().and_then(central);
    let inverse = matches!(measurements.model(), Model::Line { .. }).then(|| {
        let estimate = least_squares.as_ref().ok();
        Inverse::new(
            fps.polyhedron(),
            pui.as_ref().map(|pui| pui.each_ref().map(ParameterInterval::interval)).as_ref(),
            estimate.map(|estimate| &estimate.eui),
            central.as_ref().map(|central| &central.theta),
            estimate.map(|estimate| &estimate.theta),
        )
    });
    let minimax = Minimax::new(measurements, conditions);
    Fit { least_squares, float_least_squares, fps, pui, central, minimax, inverse }
}

impl Fit {
    /// The parameter uncertainty intervals without their proofs.
    pub fn pui_intervals(&self) -> Option<[Interval; 2]> {
        self.pui.as_ref().map(|pui| pui.each_ref().map(ParameterInterval::interval))
    }

    /// How far the least-squares estimate keeps inside the FPS: the smallest slack over all half-planes and the
    /// half-plane with it. A negative slack means that the estimate is not feasible.
    pub fn least_squares_slack(&self) -> Option<(Rational, BoundName)> {
        let estimate = self.least_squares.as_ref().ok()?;
        let membership = self.fps.polyhedron().membership(&estimate.theta);
        Some((membership.slack?, self.fps.name(membership.tightest?)))
    }

    /// The largest |θ_j - θ̂_j| over the FPS for the least-squares estimate; `None` unless both PUI are bounded.
    pub fn least_squares_guaranteed_error(&self) -> Option<[Rational; 2]> {
        let estimate = self.least_squares.as_ref().ok()?;
        let [first, second] = self.pui_intervals()?;
        Some([guaranteed_error(&estimate.theta[0], &first)?, guaranteed_error(&estimate.theta[1], &second)?])
    }

    /// Area of the FPS over area of the PUI box, between 0 and 1; `None` when the box has no finite positive area.
    pub fn tightness(&self) -> Option<Rational> {
        let [first, second] = self.pui_intervals()?;
        let box_area = first.width()? * second.width()?;
        self.fps.polyhedron().region().area()?.checked_div(&box_area)
    }

    /// For an empty FPS, at most three half-planes with positive multipliers whose sum is `0 ≤ negative`. Where a
    /// larger error bound would leave something, these are the readings that ask for the largest one.
    pub fn contradiction(&self, error_bound: &ErrorBound) -> Option<Vec<(BoundName, Rational)>> {
        let certificate = self.fps.polyhedron().region().certificate()?;
        let in_use = match error_bound {
            ErrorBound::Uniform(epsilon) => epsilon.clone(),
            ErrorBound::PerRow(_) => Rational::one(),
        };
        match &self.minimax {
            Some(minimax) if minimax.least > in_use => Some(minimax.proof.multipliers.clone()),
            _ => Some(
                certificate.multipliers().iter().map(|m| (self.fps.name(m.index), m.value.clone())).collect(),
            ),
        }
    }

    /// Recomputes every proof of the answer from the readings: emptiness, each end of the PUI and ε_min. Exact.
    ///
    /// # Errors
    /// The first statement that is false.
    pub fn verify(&self, problem: &Problem) -> Result<(), ProofError> {
        use crate::bounds::ParameterBound::{Bounded, Unbounded};
        let system = self.fps.polyhedron().system();
        if let Some(certificate) = self.fps.polyhedron().region().certificate() {
            certificate.verify(system)?;
        }
        for interval in self.pui.iter().flatten() {
            for end in [&interval.lower, &interval.upper] {
                match end {
                    Bounded { proof, .. } => proof.verify(system)?,
                    Unbounded(proof) => proof.verify(system)?,
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
