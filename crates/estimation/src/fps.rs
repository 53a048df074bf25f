//! The feasible parameter set: the intersection of the 2N half-planes of the readings with the conditions.

use std::cmp::Ordering;
use std::fmt;

use boundfit_exact::Rational;
use boundfit_geometry::{Inequality, Polyhedron, System};

use crate::condition::Condition;
use crate::measurements::{Measurement, Measurements};

/// The name of one half-plane of an FPS.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum BoundName {
    /// φ·θ ≤ y + ε of this data row.
    Upper(usize),
    /// φ·θ ≥ y - ε of this data row.
    Lower(usize),
    /// The condition with this number, from 1.
    Where(usize),
}

impl BoundName {
    /// What reports sort by: rows first, each with its upper bound before its lower one, then conditions.
    fn rank(self) -> (bool, usize, bool) {
        match self {
            BoundName::Upper(row) => (false, row, false),
            BoundName::Lower(row) => (false, row, true),
            BoundName::Where(number) => (true, number, false),
        }
    }
}

impl Ord for BoundName {
    fn cmp(&self, other: &Self) -> Ordering {
        self.rank().cmp(&other.rank())
    }
}

impl PartialOrd for BoundName {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl fmt::Display for BoundName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BoundName::Upper(row) => write!(f, "{row} upper"),
            BoundName::Lower(row) => write!(f, "{row} lower"),
            BoundName::Where(number) => write!(f, "where:{number}"),
        }
    }
}

/// The feasible parameter set {θ : |y_i - φ_i·θ| ≤ ε_i for all i}, cut by the conditions.
#[derive(Debug, Clone)]
pub struct Fps {
    polyhedron: Polyhedron,
    names: Vec<BoundName>,
}

impl Fps {
    /// The FPS of readings and conditions. Exact. Cost: O(N log N).
    pub fn new(measurements: &Measurements, conditions: &[Condition]) -> Self {
        let (names, inequalities): (Vec<BoundName>, Vec<Inequality>) = measurements
            .rows()
            .iter()
            .flat_map(|measurement| strip(measurement, &measurement.epsilon))
            .chain(conditions_by_name(conditions))
            .unzip();
        Fps { polyhedron: Polyhedron::intersect(System::new(inequalities)), names }
    }

    /// The half-planes and their intersection.
    pub fn polyhedron(&self) -> &Polyhedron {
        &self.polyhedron
    }

    /// The name of an inequality of the system.
    ///
    /// # Panics
    /// When the index is out of range.
    pub fn name(&self, index: usize) -> BoundName {
        self.names[index]
    }
}

/// The two half-planes of a reading with an error bound: the strip of all θ whose line passes that close.
pub(crate) fn strip(measurement: &Measurement, epsilon: &Rational) -> [(BoundName, Inequality); 2] {
    let Measurement { row, regressor: [phi1, phi2], response, .. } = measurement;
    [
        (BoundName::Upper(*row), Inequality::new(phi1.clone(), phi2.clone(), response + epsilon)),
        (BoundName::Lower(*row), Inequality::new(-phi1, -phi2, epsilon - response)),
    ]
}

/// The conditions as named inequalities.
pub(crate) fn conditions_by_name(
    conditions: &[Condition],
) -> impl Iterator<Item = (BoundName, Inequality)> + '_ {
    (1..)
        .zip(conditions)
        .map(|(number, condition)| (BoundName::Where(number), condition.inequality().clone()))
}
