//! The feasible parameter set: the intersection of the 2N half-planes of the readings with the conditions.

use std::cmp::Ordering;
use std::fmt;

use boundfit_exact::Rational;
use boundfit_geometry::{Inequality, Polyhedron, System};

use crate::condition::Condition;
use crate::hulls::Extremes;
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
    /// The FPS of readings and conditions. Of a line under a uniform error bound it has the half-planes that can be active
    /// only: the upper bounds of the readings on the lower hull of (x, y), the lower bounds of those on the upper one, and
    /// the conditions. Vertices, active sets, bounds with their proofs and the tightest half-planes of a point are those of
    /// [`Fps::of_every_half_plane`], by name; what may differ is which of several certificates proves that the set is empty.
    /// Exact. Cost: O(N log N).
    pub fn new(measurements: &Measurements, conditions: &[Condition]) -> Self {
        Fps::with_extremes(measurements, conditions, Extremes::of(measurements).as_ref())
    }

    /// The FPS with all half-planes of the readings, also those that cannot be active. Exact. Cost: O(N log N).
    pub fn of_every_half_plane(measurements: &Measurements, conditions: &[Condition]) -> Self {
        let (names, system) = every_half_plane(measurements, conditions);
        Fps { polyhedron: Polyhedron::intersect(system), names }
    }

    /// [`Fps::new`] with the extremes of a line under a uniform bound.
    pub(crate) fn with_extremes(
        measurements: &Measurements,
        conditions: &[Condition],
        extremes: Option<&Extremes>,
    ) -> Self {
        match extremes {
            Some(extremes) => Fps::of_extremes(measurements, conditions, extremes),
            None => Fps::of_every_half_plane(measurements, conditions),
        }
    }

    fn of_extremes(measurements: &Measurements, conditions: &[Condition], extremes: &Extremes) -> Self {
        let count = 2 * extremes.touching.len() + conditions.len();
        let (mut names, mut inequalities) = (Vec::with_capacity(count), Vec::with_capacity(count));
        let mut add = |(name, inequality): (BoundName, Inequality)| {
            names.push(name);
            inequalities.push(inequality);
        };
        for touching in &extremes.touching {
            let measurement = &measurements.kept()[touching.position];
            if touching.lower {
                add(upper_bound(measurement, &measurement.epsilon));
            }
            if touching.upper {
                add(lower_bound(measurement, &measurement.epsilon));
            }
        }
        conditions_by_name(conditions).for_each(add);
        Fps { polyhedron: Polyhedron::intersect(System::new(inequalities)), names }
    }

    /// The half-planes and their intersection.
    pub fn polyhedron(&self) -> &Polyhedron {
        &self.polyhedron
    }

    /// The names of the inequalities of the system, in order.
    pub fn names(&self) -> &[BoundName] {
        &self.names
    }

    /// The name of an inequality of the system.
    ///
    /// # Panics
    /// When the index is out of range.
    pub fn name(&self, index: usize) -> BoundName {
        self.names[index]
    }
}

/// Where the upper and the lower bound of the reading at a position are among the half-planes of
/// [`Fps::of_every_half_plane`]; the conditions come after those of all readings.
pub fn bounds_of_reading(position: usize) -> [usize; 2] {
    [2 * position, 2 * position + 1]
}

/// The position of the reading that a half-plane of [`Fps::of_every_half_plane`] is a bound of; beyond all readings for a
/// condition.
pub fn reading_of_bound(half_plane: usize) -> usize {
    half_plane / 2
}

/// All half-planes of readings and conditions, with their names.
pub(crate) fn every_half_plane(
    measurements: &Measurements,
    conditions: &[Condition],
) -> (Vec<BoundName>, System) {
    let (names, inequalities): (Vec<BoundName>, Vec<Inequality>) = measurements
        .kept()
        .iter()
        .flat_map(|measurement| strip(measurement, &measurement.epsilon))
        .chain(conditions_by_name(conditions))
        .unzip();
    (names, System::new(inequalities))
}

/// The two half-planes of a reading with an error bound, the upper bound first: the strip of all θ whose line passes that
/// close. This is the model, row by row; whoever needs its half-planes takes them from here. Exact.
pub fn strip(measurement: &Measurement, epsilon: &Rational) -> [(BoundName, Inequality); 2] {
    [upper_bound(measurement, epsilon), lower_bound(measurement, epsilon)]
}

fn upper_bound(measurement: &Measurement, epsilon: &Rational) -> (BoundName, Inequality) {
    let Measurement { row, regressor: [phi1, phi2], response, .. } = measurement;
    (BoundName::Upper(*row), Inequality::new(phi1.clone(), phi2.clone(), response + epsilon))
}

fn lower_bound(measurement: &Measurement, epsilon: &Rational) -> (BoundName, Inequality) {
    let Measurement { row, regressor: [phi1, phi2], response, .. } = measurement;
    (BoundName::Lower(*row), Inequality::new(-phi1, -phi2, epsilon - response))
}

/// The conditions as named inequalities, numbered from 1.
pub fn conditions_by_name(conditions: &[Condition]) -> impl Iterator<Item = (BoundName, Inequality)> + '_ {
    (1..)
        .zip(conditions)
        .map(|(number, condition)| (BoundName::Where(number), condition.inequality().clone()))
}
