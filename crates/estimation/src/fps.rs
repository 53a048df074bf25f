//! The feasible parameter set: the intersection of the 2N half-planes of the readings with the conditions.

use std::borrow::Cow;
use std::ops::Range;

use boundfit_exact::Rational;
use boundfit_geometry::{Inequality, Polyhedron, System, Tally, envelope, touching_an_envelope};

use crate::bound_name::BoundName;
use crate::condition::Condition;
use crate::deciding::OnGrid;
use crate::hulls::{Extremes, Touching};
use crate::least_growth::GrowingInequality;
use crate::measurement::{Bounds, Measurement};
use crate::measurements::Measurements;
use crate::ties::{ActiveBounds, Ties};

/// The feasible parameter set {θ : |y_i - φ_i·θ| ≤ ε_i for all i}, cut by the conditions.
#[derive(Debug, Clone)]
pub struct Fps {
    polyhedron: Polyhedron,
    names: Vec<BoundName>,
    /// The readings that these half-planes stand for beside their own.
    ties: Ties,
    /// True if the readings are of a line under a uniform error bound.
    has_hulls: bool,
    /// True if the half-plane with the least slack at the least-squares estimate is one of these.
    has_tightest: bool,
}

impl Fps {
    /// The FPS of readings and conditions. For a line under a uniform error bound it has only the half-planes that
    /// can be active, and the conditions. These are upper bounds of readings on the lower hull of (x, y) and lower
    /// bounds of readings on the upper hull. The first reading represents readings at one corner or strictly within
    /// one edge. Vertices, [active](Fps::active) names, bounds and the tightest half-planes of a point are the same
    /// as for [`Fps::of_every_half_plane`]. Only the choice among several proofs of a bound or of emptiness may
    /// differ. Exact. Cost: O(N log N).
    pub fn new(measurements: &Measurements, conditions: &[Condition]) -> Self {
        match Extremes::of(measurements) {
            Some(extremes) => Fps::of_extremes(measurements, conditions, extremes),
            None => Fps::of_every_half_plane(measurements, conditions),
        }
    }

    /// The FPS with all half-planes of the readings, also those that cannot be active. Exact. Cost: O(N log N).
    pub fn of_every_half_plane(measurements: &Measurements, conditions: &[Condition]) -> Self {
        let (names, system) = every_half_plane(measurements, conditions);
        Fps::of_system(measurements, names, system)
    }

    fn of_system(measurements: &Measurements, names: Vec<BoundName>, system: System) -> Self {
        Fps {
            polyhedron: Polyhedron::intersect(system),
            names,
            ties: measurements.ties().cloned().unwrap_or_default(),
            has_hulls: measurements.has_hulls(),
            has_tightest: measurements.have_tightest(),
        }
    }

    /// The FPS with the half-planes of the readings at these positions alone, which decide it and the tightest half-plane of the
    /// least-squares estimate.
    pub(crate) fn of_deciding(
        measurements: &Measurements,
        conditions: &[Condition],
        positions: &[usize],
    ) -> Self {
        let rows = measurements.kept();
        let own = positions.iter().flat_map(|&position| half_planes(&rows[position]));
        let (names, inequalities): (_, Vec<Inequality>) = own.chain(conditions_by_name(conditions)).unzip();
        Fps::of_system(measurements, names, System::new(inequalities))
    }

    /// [`Fps::new`] with the extremes of a line under a uniform bound, which are gone before the half-planes are intersected.
    pub(crate) fn of_extremes(
        measurements: &Measurements,
        conditions: &[Condition],
        extremes: Extremes,
    ) -> Self {
        if let Some(grid) = measurements.on_grid() {
            return Fps::on_grid(measurements, grid, conditions, extremes);
        }
        let count = 2 * (extremes.touching.len() + conditions.len());
        let (mut names, mut inequalities) = (Vec::with_capacity(count), Vec::with_capacity(count));
        let mut add = |(name, inequality): (BoundName, Inequality)| {
            names.push(name);
            inequalities.push(inequality);
        };
        let (rows, known) = (measurements.kept(), measurements.ties());
        let mut ties = Ties::default();
        for touching in &extremes.touching {
            let measurement = &rows[touching.position()];
            if touching.tied.count() > 1 || known.is_some_and(|known| !known.is_empty()) {
                let tied = touching.tied.rows().map(|position| {
                    let row = rows[position as usize].row;
                    known.map_or_else(|| Tally::one(row as u64), |known| known.of(row))
                });
                ties.insert(measurement.row, Tally::merged(tied, usize::MAX));
            }
            let above = touching.lower.then(|| upper(measurement, measurement.upper())).flatten();
            let below = touching.upper.then(|| lower(measurement, measurement.lower())).flatten();
            above.into_iter().chain(below).for_each(&mut add);
        }
        conditions_by_name(conditions).for_each(add);
        Fps {
            polyhedron: Polyhedron::intersect(System::new(inequalities)),
            names,
            ties,
            has_hulls: true,
            has_tightest: true,
        }
    }

    /// The same of readings that are integers: their half-planes come from these, and each reading stands for what it is known to
    /// stand for.
    fn on_grid(
        measurements: &Measurements,
        grid: &OnGrid,
        conditions: &[Condition],
        extremes: Extremes,
    ) -> Self {
        let count = extremes.touching.len() + 2;
        let (mut names, mut lines) = (Vec::with_capacity(count), Vec::with_capacity(count));
        for touching in extremes.touching {
            let (position, Touching { lower, upper, .. }) = (touching.position(), touching);
            let row = grid.places()[position].row;
            let above = lower.then(|| grid.upper(position)).flatten().map(|own| (BoundName::Upper(row), own));
            let below = upper.then(|| grid.lower(position)).flatten().map(|own| (BoundName::Lower(row), own));
            for (name, half_plane) in above.into_iter().chain(below) {
                names.push(name);
                lines.push(half_plane);
            }
        }
        let (of_conditions, others): (Vec<BoundName>, Vec<Inequality>) =
            conditions_by_name(conditions).unzip();
        names.extend(of_conditions);
        Fps {
            polyhedron: Polyhedron::intersect(System::of_lines(lines, others)),
            names,
            ties: measurements.ties().cloned().unwrap_or_default(),
            has_hulls: true,
            has_tightest: true,
        }
    }

    /// Returns whether the readings are of a line under a uniform error bound.
    pub(crate) fn has_hulls(&self) -> bool {
        self.has_hulls
    }

    /// Returns whether the half-plane with the least slack at the least-squares estimate is one of these.
    pub(crate) fn has_tightest(&self) -> bool {
        self.has_tightest
    }

    /// Returns the first half-plane of an empty FPS, in the order of rows and then of conditions, that contradicts
    /// earlier half-planes, with these and their multipliers. Only readings' half-planes that touch an envelope
    /// count, so that the answer does not depend on other half-planes. Exact. Cost: O(N log N).
    pub(crate) fn first_contradiction(&self) -> Option<Vec<(BoundName, Rational)>> {
        self.polyhedron.certificate()?;
        let is_condition = |name: &&BoundName| !matches!(name, BoundName::Upper(_) | BoundName::Lower(_));
        let readings = self.names.len() - self.names.iter().filter(is_condition).count();
        let system = self.polyhedron.system();
        let touching = touching_an_envelope(&system.constraints()[..readings]);
        let kept: Vec<usize> = touching.into_iter().chain(readings..self.names.len()).collect();
        let own: System = kept.iter().map(|&index| system.inequalities()[index].clone()).collect();
        let region = envelope::intersect(&own);
        let multipliers = region.certificate()?.multipliers().iter();
        Some(multipliers.map(|m| (self.names[kept[m.index]], m.value.clone())).collect())
    }

    /// The half-planes and their intersection.
    pub fn polyhedron(&self) -> &Polyhedron {
        &self.polyhedron
    }

    /// The names of the inequalities of the system, in order.
    pub fn names(&self) -> &[BoundName] {
        &self.names
    }

    /// Returns the bounds that are active where these inequalities of the system are active, with the bounds that
    /// they stand for. At most `most` bounds appear by name, sorted; the others are counted.
    ///
    /// # Panics
    /// When an index is out of range.
    pub fn active(&self, indices: &[usize], most: usize) -> ActiveBounds {
        self.ties.active(indices.iter().map(|&index| self.names[index]), most)
    }

    /// The name of an inequality of the system.
    ///
    /// # Panics
    /// When the index is out of range.
    pub fn name(&self, index: usize) -> BoundName {
        self.names[index]
    }
}

/// Returns where the bounds of the reading at a position are among the half-planes of [`Fps::of_every_half_plane`], the upper one
/// first; the conditions come after those of all readings. Cost: linear in the position.
///
/// # Panics
/// When there are fewer readings than that.
pub fn bounds_of_reading(rows: &[Measurement], position: usize) -> Range<usize> {
    let count = |row: &Measurement| match &row.bounds {
        Bounds::Around { .. } => 2,
        Bounds::Between { lower, upper, .. } => usize::from(lower.is_some()) + usize::from(upper.is_some()),
    };
    let start = rows[..position].iter().map(count).sum();
    start..start + count(&rows[position])
}

/// The position of the reading that a half-plane of [`Fps::of_every_half_plane`] is a bound of; `None` for a condition.
/// Cost: linear.
pub fn reading_of_bound(rows: &[Measurement], half_plane: usize) -> Option<usize> {
    let mut positions =
        rows.iter().enumerate().flat_map(|(position, row)| half_planes(row).map(move |_| position));
    positions.nth(half_plane)
}

/// All half-planes of readings and conditions, with their names.
pub(crate) fn every_half_plane(
    measurements: &Measurements,
    conditions: &[Condition],
) -> (Vec<BoundName>, System) {
    let (names, inequalities): (Vec<BoundName>, Vec<Inequality>) =
        measurements.kept().iter().flat_map(half_planes).chain(conditions_by_name(conditions)).unzip();
    (names, System::new(inequalities))
}

/// The half-planes of a reading, its upper bound first; the one of a bound that is not there is left out. This is the model,
/// row by row; whoever needs its half-planes takes them from here. Exact.
pub fn half_planes(measurement: &Measurement) -> impl Iterator<Item = (BoundName, Inequality)> {
    [upper(measurement, measurement.upper()), lower(measurement, measurement.lower())].into_iter().flatten()
}

/// The half-planes of a reading as they move with a factor on its error bound: at factor 0, and how fast the
/// right-hand side grows. A reading with both bounds grows about their middle by half of their distance. A reading
/// with a single bound, or with bounds that cross or coincide, says the same at every factor. Exact.
pub fn growing_half_planes(
    measurement: &Measurement,
) -> impl Iterator<Item = (BoundName, GrowingInequality)> {
    let growth = measurement.half_width().filter(|half_width| !half_width.is_negative());
    let at_zero = match &growth {
        Some(_) => [measurement.middle(), measurement.middle()].map(|middle| middle.map(Cow::into_owned)),
        None => [measurement.upper(), measurement.lower()],
    };
    let growth = growth.map_or_else(Rational::zero, Cow::into_owned);
    let [at_most, at_least] = at_zero;
    let bounds = [upper(measurement, at_most), lower(measurement, at_least)];
    let moving = move |(name, at_zero)| (name, GrowingInequality { at_zero, growth: growth.clone() });
    bounds.into_iter().flatten().map(moving)
}

fn upper(measurement: &Measurement, bound: Option<Rational>) -> Option<(BoundName, Inequality)> {
    let Measurement { row, regressor: [phi1, phi2], .. } = measurement;
    Some((BoundName::Upper(*row), Inequality::new(phi1.clone(), phi2.clone(), bound?)))
}

fn lower(measurement: &Measurement, bound: Option<Rational>) -> Option<(BoundName, Inequality)> {
    let Measurement { row, regressor: [phi1, phi2], .. } = measurement;
    Some((BoundName::Lower(*row), Inequality::new(-phi1, -phi2, -bound?)))
}

/// Returns at most three of some named half-planes with positive multipliers whose sum is `0 ≤ negative`, if they contradict each
/// other. Exact. Cost: O(n log n).
pub fn contradiction_among(
    named: impl Iterator<Item = (BoundName, Inequality)>,
) -> Option<Vec<(BoundName, Rational)>> {
    let (names, system): (Vec<BoundName>, Vec<Inequality>) = named.unzip();
    let intersection = Polyhedron::intersect(System::new(system));
    let multipliers = intersection.certificate()?.multipliers();
    Some(multipliers.iter().map(|m| (names[m.index], m.value.clone())).collect())
}

/// The conditions as named inequalities, numbered from 1; of an equation both sides.
pub fn conditions_by_name(conditions: &[Condition]) -> impl Iterator<Item = (BoundName, Inequality)> + '_ {
    (1..).zip(conditions).flat_map(|(number, condition)| {
        let names = if condition.is_equation() {
            [BoundName::WhereUpper(number), BoundName::WhereLower(number)]
        } else {
            [BoundName::Where(number); 2]
        };
        names.into_iter().zip(condition.inequalities())
    })
}
