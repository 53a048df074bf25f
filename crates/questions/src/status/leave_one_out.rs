//! Leave-one-out for each reading, without a fit for each.
//!
//! The set S of all readings is the intersection of few of their half-planes, the *spokes* of its normal fan. Whoever
//! has no spoke can be left out without changing S. Leaving out the reading i of a spoke k opens S beyond k only, as
//! far as half-planes allow that were redundant. Each of these half-planes is dominated by the two spokes around its
//! normal, or by one, so it stays redundant unless k is one of these spokes. It has to be tested for two spokes at
//! most. If the opposite bound of i is a spoke l too, the half-planes that l dominates still do not matter. Suppose g
//! ≥ s·l + t·f were part of a proof of max φ_i. Then t·f would prove a value that is no larger, since every point of
//! the others within l already lies above it.
//!
//! So one intersection of all readings without those that have spokes, and one small linear program per spoke, are
//! all that is needed: O(n log n) together. If S is empty, only readings of one contradiction can mend it: a
//! half-plane whose removal makes a contradictory system consistent belongs to every contradiction.

use std::collections::{BTreeMap, BTreeSet};

use boundfit_estimation::{
    BoundName, Condition, Fit, Fps, Measurement, Measurements, Problem, conditions_by_name, half_planes,
};
use boundfit_exact::{Endpoint, Interval, Rational};
use boundfit_geometry::{Constraint, Inequality, Polyhedron, System};

use super::standing::Standing;

/// The readings without which the set may be another one, and the set.
#[derive(Debug, Clone)]
pub struct Deciding {
    fps: Fps,
    conditions: Vec<Condition>,
    readings: Vec<Measurement>,
}

/// A reading against the set of all readings, and against that of the others.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RowStatus {
    /// Number of the data row.
    pub row: usize,
    /// The standing against the set of all readings, inner or boundary; `None` when that set is empty. It cannot be
    /// but inner or boundary.
    pub all: Option<Standing>,
    /// The standing against the set of the other readings; `None` when that set is empty.
    pub without: Option<Standing>,
}

/// The standing of each reading against the set of all readings, and against the set of the others.
#[derive(Debug, Clone)]
pub struct Statuses {
    deciding: Deciding,
    /// The half-planes of the other readings that are not redundant among them, and the conditions that are not.
    others: Vec<(BoundName, Inequality)>,
    /// The values of φ·θ over the set of the others, of the readings that decide; `None` where nothing is left.
    without: BTreeMap<usize, Option<Interval>>,
}

impl Deciding {
    /// Finds the readings whose removal may change the set: readings with a half-plane that is not redundant, at most
    /// as many as the set has sides. An empty set has the readings of one contradiction, at most three. Exact. Cost:
    /// linear in these.
    pub fn new(problem: &Problem, fit: &Fit) -> Self {
        let fps = fit.fps.clone();
        let names: Vec<BoundName> = match fit.contradiction(problem.measurements.error_bound()) {
            Some(contradiction) => contradiction.into_iter().map(|(name, _)| name).collect(),
            None => fps.polyhedron().irredundant().into_iter().map(|index| fps.name(index)).collect(),
        };
        let rows: BTreeSet<usize> = names.into_iter().filter_map(BoundName::row).collect();
        let kept = problem.measurements.kept().iter();
        let readings = kept.filter(|reading| rows.contains(&reading.row)).cloned().collect();
        Deciding { fps, conditions: problem.conditions.clone(), readings }
    }

    /// The rows of these readings, ascending.
    pub fn rows(&self) -> impl Iterator<Item = usize> {
        self.readings.iter().map(|reading| reading.row)
    }

    /// These readings.
    pub fn readings(&self) -> &[Measurement] {
        &self.readings
    }

    /// The set of all readings.
    pub fn set(&self) -> &Polyhedron {
        self.fps.polyhedron()
    }
}

impl Statuses {
    /// The statuses of the readings of a problem; `None` when not all of them are in memory. Exact. Cost: O(n log n).
    pub fn of(problem: &Problem, fit: &Fit) -> Option<Self> {
        let deciding = Deciding::new(problem, fit);
        let all = problem.measurements.all()?;
        let rows: BTreeSet<usize> = deciding.rows().collect();
        let others = all.iter().filter(|reading| !rows.contains(&reading.row)).cloned().collect();
        let own = &problem.measurements;
        let (model, bound) = (own.model().clone(), own.error_bound().clone());
        let others = Measurements::new(model, own.response().to_owned(), bound, others);
        Some(Statuses::new(deciding, &others))
    }

    /// The statuses of readings of which the others than those that decide may be known by their summary only. Exact. Cost:
    /// O(n log n) for n readings in memory.
    pub fn new(deciding: Deciding, others: &Measurements) -> Self {
        let others = Fps::new(others, &deciding.conditions);
        let set = others.polyhedron();
        let named = |index: usize| (others.name(index), set.system().inequalities()[index].clone());
        let others: Vec<_> = set.irredundant().into_iter().map(named).collect();
        let mut statuses = Statuses { deciding, others, without: BTreeMap::new() };
        statuses.without = if statuses.set().region().is_empty() {
            let values = |reading: &Measurement| {
                (reading.row, statuses.set_without(reading.row).0.range(&reading.regressor))
            };
            statuses.deciding.readings.iter().map(values).collect()
        } else {
            opening(&statuses.deciding, &statuses.others)
        };
        statuses
    }

    /// The set of the others than a reading that decides, and the names of the half-planes it is made of. Exact. Cost:
    /// O(h log h) for h half-planes that are not redundant among all, or among those of the others.
    pub fn set_without(&self, row: usize) -> (Polyhedron, Vec<BoundName>) {
        let own = self.deciding.readings.iter().filter(|other| other.row != row).flat_map(half_planes);
        let conditions = conditions_by_name(&self.deciding.conditions);
        let all = own.chain(self.others.iter().cloned()).chain(conditions);
        let (names, inequalities): (Vec<BoundName>, Vec<Inequality>) = all.unzip();
        (Polyhedron::intersect(System::new(inequalities)), names)
    }

    /// The set of all readings.
    pub fn set(&self) -> &Polyhedron {
        self.deciding.set()
    }

    /// The set of all readings with the names of its half-planes.
    pub fn fps(&self) -> &Fps {
        &self.deciding.fps
    }

    /// The readings whose set of the others may be another one, by row.
    pub fn deciding_readings(&self) -> &[Measurement] {
        &self.deciding.readings
    }

    /// The statuses of a reading of this set. Exact. Cost: logarithmic in the number of the set's sides.
    pub fn status(&self, reading: &Measurement) -> RowStatus {
        let all = Standing::against(reading, self.set());
        let without = match self.without.get(&reading.row) {
            Some(values) => values.as_ref().map(|values| Standing::within(reading, values)),
            // The set is the same without it, or as empty.
            None => all.clone(),
        };
        RowStatus { row: reading.row, all, without }
    }

    /// The rows whose set of the others may be another one, ascending.
    pub fn deciding(&self) -> impl Iterator<Item = usize> {
        self.without.keys().copied()
    }
}

/// The values over what opens beyond the spokes of each reading.
fn opening(deciding: &Deciding, others: &[(BoundName, Inequality)]) -> BTreeMap<usize, Option<Interval>> {
    let (fps, set) = (&deciding.fps, deciding.fps.polyhedron());
    let spokes = set.irredundant_by_angle();
    let place_of: BTreeMap<usize, usize> =
        spokes.iter().enumerate().map(|(place, &index)| (index, place)).collect();
    let is_spoke: BTreeSet<BoundName> = spokes.iter().map(|&index| fps.name(index)).collect();
    let own = deciding.readings.iter().flat_map(half_planes).filter(|(name, _)| !is_spoke.contains(name));
    // That a condition of the set is among those of the others as well changes nothing.
    let redundant = own.chain(others.iter().cloned()).map(|(name, inequality)| (name.row(), inequality));
    let mut beyond: Vec<Vec<(Option<usize>, Inequality)>> = vec![Vec::new(); spokes.len()];
    for (row, inequality) in redundant {
        let around = match inequality.constraint() {
            Constraint::HalfPlane(half_plane) => set.neighbours_of(&half_plane),
            Constraint::Always | Constraint::Never => None,
        };
        let Some((before, after)) = around else { continue };
        beyond[place_of[&before]].push((row, inequality.clone()));
        if after != before {
            beyond[place_of[&after]].push((row, inequality));
        }
    }
    let neighbours = |place: usize| {
        let count = spokes.len();
        [spokes[(place + count - 1) % count], spokes[(place + 1) % count]]
            .map(|index| (fps.name(index).row(), set.system().inequalities()[index].clone()))
    };
    // Beyond which value of its own form a spoke's reading is held by the others.
    let held = |place: usize, row: usize, form: &[Rational; 2]| {
        let all = beyond[place].iter().cloned().chain(neighbours(place));
        let left = all.filter(|(own, _)| *own != Some(row)).map(|(_, inequality)| inequality);
        let values = Polyhedron::intersect(System::new(left)).range(form);
        values.map_or(Endpoint::Unbounded, |values| values.upper().clone())
    };
    let mut ends: BTreeMap<BoundName, Endpoint> = BTreeMap::new();
    for (place, &index) in spokes.iter().enumerate() {
        let name = fps.name(index);
        if let Some(row) = name.row() {
            ends.insert(name, held(place, row, &set.system().inequalities()[index].a));
        }
    }
    let mut values = |reading: &Measurement| {
        let all = set.range(&reading.regressor)?;
        let upper = ends.remove(&BoundName::Upper(reading.row)).unwrap_or_else(|| all.upper().clone());
        let lower = match ends.remove(&BoundName::Lower(reading.row)) {
            Some(Endpoint::Finite(value)) => Endpoint::Finite(-value),
            Some(Endpoint::Unbounded) => Endpoint::Unbounded,
            None => all.lower().clone(),
        };
        Interval::new(lower, upper)
    };
    deciding.readings.iter().map(|reading| (reading.row, values(reading))).collect()
}
