//! Parameter uncertainty intervals and the central estimate, read off the FPS.

use boundfit_exact::{Endpoint, Interval, Rational};
use boundfit_geometry::{BoundProof, Polyhedron, Support, UnboundedProof};

/// One end of a parameter uncertainty interval, with its proof. The proof is about the form +θ_j for an upper end and
/// -θ_j for a lower one.
#[derive(Debug, Clone, PartialEq, Eq)]
#[allow(clippy::large_enum_variant, reason = "four of them per fit")]
pub enum ParameterBound {
    /// The parameter goes no further.
    Bounded {
        /// The end of the interval.
        value: Rational,
        /// The proof of the bound, at most two readings or conditions, and the place where the bound is attained.
        proof: BoundProof,
    },
    /// The parameter goes on without end.
    Unbounded(UnboundedProof),
}

/// PUI_j = [min θ_j, max θ_j] over the FPS (Milanese and Vicino 1991).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ParameterInterval {
    /// The lower end.
    pub lower: ParameterBound,
    /// The upper end.
    pub upper: ParameterBound,
}

/// The central estimate: the mid-point of the PUI box. Its guaranteed error is the half width of the box; no other
/// estimate has a smaller one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Central {
    /// θᶜ.
    pub theta: [Rational; 2],
    /// The largest |θ_j - θᶜ_j| over the FPS, attained on both sides.
    pub guaranteed_error: [Rational; 2],
}

impl ParameterBound {
    /// The end as a number or unbounded.
    pub fn endpoint(&self) -> Endpoint {
        match self {
            ParameterBound::Bounded { value, .. } => Endpoint::Finite(value.clone()),
            ParameterBound::Unbounded(_) => Endpoint::Unbounded,
        }
    }
}

impl ParameterInterval {
    /// The interval without its proofs.
    pub fn interval(&self) -> Interval {
        // Both ends are attained or unbounded over the same non-empty set, so they are in order.
        Interval::new(self.lower.endpoint(), self.upper.endpoint()).expect("ends of an FPS in order")
    }
}

/// Both parameter uncertainty intervals of a set, with their proofs; `None` when it is empty. Exact. Cost: linear in the number of
/// vertices.
pub fn parameter_intervals(polyhedron: &Polyhedron) -> Option<[ParameterInterval; 2]> {
    let (zero, one) = (Rational::zero(), Rational::one());
    let interval = |axis: [Rational; 2]| {
        let opposite = [-&axis[0], -&axis[1]];
        let upper = match polyhedron.support(&axis) {
            Support::Empty(_) => return None,
            Support::Unbounded(proof) => ParameterBound::Unbounded(proof),
            Support::Bounded { proof, .. } => ParameterBound::Bounded { value: proof.value.clone(), proof },
        };
        let lower = match polyhedron.support(&opposite) {
            Support::Empty(_) => return None,
            Support::Unbounded(proof) => ParameterBound::Unbounded(proof),
            Support::Bounded { proof, .. } => ParameterBound::Bounded { value: -&proof.value, proof },
        };
        Some(ParameterInterval { lower, upper })
    };
    Some([interval([one.clone(), zero.clone()])?, interval([zero, one])?])
}

/// The central estimate; `None` unless both intervals are bounded.
pub(crate) fn central(intervals: &[ParameterInterval; 2]) -> Option<Central> {
    central_of(&intervals.each_ref().map(ParameterInterval::interval))
}

/// The middle of a box, and half its widths; `None` unless it is bounded. Exact.
pub fn central_of([first, second]: &[Interval; 2]) -> Option<Central> {
    let middle = |interval: &Interval| {
        let (lower, upper) = interval.ends()?;
        let (twice, width) = upper.sum_and_difference(lower);
        Some([twice.half(), width.half()])
    };
    let ([theta1, error1], [theta2, error2]) = (middle(first)?, middle(second)?);
    Some(Central { theta: [theta1, theta2], guaranteed_error: [error1, error2] })
}

/// The largest |θ_j - estimate_j| over the FPS, whose box has this central estimate: the error that can be guaranteed for an
/// estimate. `None` unless both intervals are bounded.
pub(crate) fn guaranteed_error(
    estimate: &[Rational; 2],
    pui: &[Interval; 2],
    central: &Central,
) -> Option<[Rational; 2]> {
    let error = |axis: usize| {
        let (lower, upper) = pui[axis].ends()?;
        let own = &estimate[axis];
        // Comparing takes no greatest common divisor, a difference takes one or two.
        Some(if *own < central.theta[axis] { upper - own } else { own - lower })
    };
    Some([error(0)?, error(1)?])
}
