//! The answer about a window.

use boundfit_estimation::{BoundName, Central, ParameterInterval};
use boundfit_exact::Rational;
use boundfit_geometry::{Polyhedron, RegionKind, System};

/// Positive multiples of at most three half-planes, in ≤ form, that add up to 0 ≤ b with b < 0: no θ meets all of them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Contradiction {
    /// Each half-plane with its multiplier, by name.
    pub terms: Vec<(BoundName, Rational)>,
}

impl Contradiction {
    /// The data rows that contradict each other, ascending.
    pub fn rows(&self) -> Vec<usize> {
        let mut rows: Vec<usize> = self.terms.iter().filter_map(|(name, _)| name.row()).collect();
        rows.sort_unstable();
        rows.dedup();
        rows
    }
}

/// The results about the set of a window.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WindowFit {
    /// The kind of the set.
    pub kind: RegionKind,
    /// The parameter uncertainty intervals; `None` when the set is empty. Their proofs are about [`WindowFit::system`].
    pub pui: Option<[ParameterInterval; 2]>,
    /// The central estimate; `None` unless both intervals are bounded.
    pub central: Option<Central>,
    /// The reason why the set is empty, if it is.
    pub contradiction: Option<Contradiction>,
    /// ε_min; `None` unless the readings are of a line under one error bound and there is no condition.
    pub least: Option<Rational>,
    /// The few half-planes that decide all this.
    pub system: System,
    /// The names of the bounds.
    pub names: Vec<BoundName>,
}

/// The irredundant half-planes of a window with the set that they bound.
#[derive(Debug, Clone)]
pub struct WindowSet {
    /// The set.
    pub polyhedron: Polyhedron,
    /// The names of its inequalities, in order; of bounds that coincide the oldest one is there.
    pub names: Vec<BoundName>,
}

/// Returns the reason why a set is empty, by name.
pub(super) fn contradiction_of(polyhedron: &Polyhedron, names: &[BoundName]) -> Option<Contradiction> {
    let certificate = polyhedron.certificate()?;
    let term = |m: &boundfit_geometry::Multiplier| (names[m.index], m.value.clone());
    let mut terms: Vec<_> = certificate.multipliers().iter().map(term).collect();
    terms.sort_by_key(|(name, _)| *name);
    Some(Contradiction { terms })
}
