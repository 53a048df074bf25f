//! The least number of readings to leave out, and all sets of so many.

use std::collections::{BTreeMap, BTreeSet};

use boundfit_geometry::constructions::foot;
use boundfit_geometry::predicates::{Side, side};
use boundfit_geometry::{Farkas, LayerOf, Point, System, envelope};

use super::kept::Kept;
use super::lines::{Edge, Lines, Place, Visitor};
use super::near::FORBIDDEN;
use super::{NoOutliers, OutlierLimits};

/// The result of the search.
pub(super) struct Found {
    pub(super) least: usize,
    /// Sets of so many rows that can be met or missed, each ascending.
    pub(super) sets: Vec<Vec<u32>>,
    /// `true` if these are all.
    pub(super) is_complete: bool,
}

/// The cost of an intersection per half-plane, in crossings of a walk.
const INTERSECTION: u64 = 2;

/// The least number of rows that are missed anywhere, and all sets of so many.
pub(super) fn least(kept: &Kept, limits: &OutlierLimits) -> Result<Found, NoOutliers> {
    // A walk along m boundaries looks at m² crossings.
    let at_least = match tree(kept, |boundaries| limits.steps.min(boundaries.saturating_mul(boundaries))) {
        Ok(found) => return Ok(found),
        Err(at_least) => at_least,
    };
    let steps = |at_least: usize, enough: Option<usize>, needed: u64| NoOutliers::Steps {
        at_least: at_least + kept.never.len(),
        enough: enough.map(|enough| enough + kept.never.len()),
        needed,
    };
    let packed = match kept.enough {
        Some(enough) => Ok((at_least, enough)),
        None => packing_of_layers(kept, at_least, limits.steps),
    };
    let (packed, enough) = packed.map_err(|(packed, needed)| steps(packed.max(at_least), None, needed))?;
    let rows = match kept.enough {
        Some(_) => (0..kept.rows.len() as u32).collect(),
        None => kept.in_layers(LayerOf::Corners, enough),
    };
    let lines = Lines::new(kept, &rows);
    if lines.steps() > limits.steps {
        return Err(steps(packed.max(at_least), Some(enough), lines.steps()));
    }
    // The first sets by their rows are listed, as by the tree; the walk meets them in another order.
    Ok(walk(kept, &rows, &lines, limits.sets.max(OutlierLimits::default().sets)))
}

/// The half-planes of some rows without others, and of all conditions; with the row of each half-plane of a row.
fn system(kept: &Kept, rows: &[u32], without: &[u32]) -> (System, Vec<u32>) {
    let (mut system, mut owners) = (System::default(), Vec::new());
    for &own in rows.iter().filter(|own| without.binary_search(own).is_err()) {
        for inequality in &kept.rows[own as usize].inequalities {
            system.push(inequality.clone());
            owners.push(own);
        }
    }
    kept.conditions.iter().for_each(|condition| {
        system.push(condition.clone());
    });
    (system, owners)
}

/// The rows of a contradiction, of which one has to be left out.
fn rows_of(certificate: &Farkas, owners: &[u32]) -> BTreeSet<u32> {
    certificate.multipliers().iter().filter_map(|multiplier| owners.get(multiplier.index).copied()).collect()
}

/// Searches the tree of contradictions, from sets of few readings to sets of more, each set of rows once. The search
/// finds every set of the least size. As long as some reading of the set remains, the remaining readings are
/// contradictory, and each contradiction has a row of the set.
///
/// # Errors
/// With a number of rows below which there is nothing, where more is spent than with so many boundaries may be.
fn tree(kept: &Kept, limit: impl Fn(u64) -> u64) -> Result<Found, usize> {
    let mut layers = kept.layers(LayerOf::Corners);
    let mut taken = 0;
    // By how many readings they stand for.
    let mut open: BTreeMap<u64, BTreeSet<Vec<u32>>> = [(0, [Vec::new()].into())].into();
    let mut spent = 0_u64;
    while let Some((least, level)) = open.pop_first() {
        // Where at most so many rows are missed, one more layer than that decides.
        let most = level.iter().map(Vec::len).max().unwrap_or_default();
        while taken <= most {
            layers.take_next();
            taken += 1;
        }
        let least = least as usize;
        let mut rows = layers.rows.clone();
        rows.sort_unstable();
        let size = 2 * rows.len() as u64 + 2 * kept.conditions.len() as u64 + 1;
        spent = spent.saturating_add(size.saturating_mul(level.len() as u64).saturating_mul(INTERSECTION));
        if least > 0 && spent > limit(size) {
            return Err(least);
        }
        let mut sets = Vec::new();
        for set in level {
            let (system, owners) = system(kept, &rows, &set);
            let region = envelope::intersect(&system);
            let Some(certificate) = region.certificate() else {
                sets.push(set);
                continue;
            };
            for row in rows_of(certificate, &owners) {
                let mut larger = set.clone();
                larger.insert(larger.partition_point(|own| *own < row), row);
                open.entry(kept.weight(&larger)).or_default().insert(larger);
            }
        }
        if !sets.is_empty() {
            return Ok(Found { least, sets, is_complete: true });
        }
    }
    unreachable!("without any row the conditions leave something")
}

/// Returns contradictions without a reading in common, one after the other. Their number is a lower bound for the
/// readings to leave out. All of their readings, at most three times as many, are enough.
///
/// # Errors
/// With how many there are at least and what would be needed, where the limit is reached.
fn packing(kept: &Kept, rows: &[u32], limit: u64) -> Result<(usize, usize), (usize, u64)> {
    let mut without: BTreeSet<u32> = BTreeSet::new();
    // For each row that had a part in a contradiction, the number of its readings that no contradiction stands for
    // yet (local ratio).
    let mut left_of: BTreeMap<u32, u64> = BTreeMap::new();
    let (mut spent, mut count) = (0_u64, 0);
    loop {
        spent += 2 * INTERSECTION * (rows.len() - without.len()) as u64;
        if spent > limit {
            return Err((count, spent));
        }
        let left_out: Vec<u32> = without.iter().copied().collect();
        let (system, owners) = system(kept, rows, &left_out);
        let region = envelope::intersect(&system);
        match region.certificate() {
            Some(certificate) => {
                let own = rows_of(certificate, &owners);
                let left = |row: &u32| left_of.get(row).copied().unwrap_or(kept.rows[*row as usize].weight);
                let fewest = own.iter().map(left).min().unwrap_or_default();
                count += fewest as usize;
                let rest: Vec<(u32, u64)> = own.iter().map(|row| (*row, left(row) - fewest)).collect();
                without.extend(rest.iter().filter(|(_, rest)| *rest == 0).map(|(row, _)| *row));
                left_of.extend(rest);
            }
            None => {
                let rows: Vec<u32> = without.into_iter().collect();
                return Ok((count, kept.weight(&rows) as usize));
            }
        }
    }
}

/// The packing of the first layers, of ever more of them until they decide about so many as are enough.
fn packing_of_layers(kept: &Kept, at_least: usize, limit: u64) -> Result<(usize, usize), (usize, u64)> {
    let once = 2 * INTERSECTION * kept.rows.len() as u64;
    if once > limit {
        return Err((at_least, once));
    }
    let mut most = 4 * at_least.max(1);
    loop {
        let rows = kept.in_layers(LayerOf::Corners, most);
        let (packed, enough) = packing(kept, &rows, limit)?;
        if enough <= most || rows.len() == kept.rows.len() {
            return Ok((packed, enough));
        }
        most = 2 * enough;
    }
}

/// The places where the fewest readings are missed.
struct Fewest {
    missed: u64,
    crossings: Vec<Place>,
    lines: Vec<u32>,
    /// The number of places that are kept.
    most: usize,
    has_all: bool,
}

impl Fewest {
    /// Returns whether a place belongs to those where the fewest are missed.
    fn takes(&mut self, missed: u64) -> bool {
        if missed < self.missed {
            self.missed = missed;
            self.crossings.clear();
            self.lines.clear();
            self.has_all = true;
        }
        let belongs = missed == self.missed;
        let has_room = self.crossings.len() + self.lines.len() < self.most;
        self.has_all &= has_room || !belongs;
        belongs && has_room
    }
}

impl Visitor for Fewest {
    fn crossing(&mut self, place: Place, missed: u64) {
        if self.takes(missed) {
            self.crossings.push(place);
        }
    }

    fn edge(&mut self, edge: Edge) {
        // An edge with an end has a crossing on which no more are missed.
        if edge.ends == [None, None] && self.takes(edge.on) {
            self.lines.push(edge.line);
        }
    }
}

/// Searches by a walk along every boundary of these rows: every part of the remaining set has a crossing or a whole
/// boundary.
fn walk(kept: &Kept, rows: &[u32], lines: &Lines, most_sets: usize) -> Found {
    const PLACES_OF_A_SET: usize = 16;
    let most = most_sets.saturating_mul(PLACES_OF_A_SET).saturating_add(PLACES_OF_A_SET);
    let mut fewest =
        Fewest { missed: FORBIDDEN, crossings: Vec::new(), lines: Vec::new(), most, has_all: true };
    lines.walk(&mut fewest);
    let feet = fewest.lines.iter().map(|&line| foot(&lines.0[line as usize].below));
    let points = fewest.crossings.iter().map(|&place| lines.point(place)).chain(feet);
    let mut sets: BTreeSet<Vec<u32>> = BTreeSet::new();
    let mut has_all = fewest.has_all;
    for point in points {
        sets.insert(missed_at(kept, rows, &point));
        if sets.len() > most_sets {
            has_all = false;
            break;
        }
    }
    Found { least: fewest.missed as usize, sets: sets.into_iter().collect(), is_complete: has_all }
}

/// The rows that a point misses, ascending.
fn missed_at(kept: &Kept, rows: &[u32], point: &Point) -> Vec<u32> {
    let misses = |own: &u32| {
        kept.rows[*own as usize].half_planes.iter().any(|half_plane| side(half_plane, point) == Side::Outside)
    };
    rows.iter().copied().filter(misses).collect()
}

#[cfg(test)]
mod tests {
    use std::borrow::Cow;

    use boundfit_estimation::{Condition, Measurement, Problem, Ties};
    use boundfit_exact::Rational;

    use super::*;
    use crate::outliers::Outliers;

    /// Readings near a line on a grid, some of them far away; every other time with bounds of their own.
    fn readings(seed: &mut u64, count: usize, most_outliers: u64) -> Vec<Measurement> {
        let mut next = |below: u64| {
            *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (*seed >> 33) % below
        };
        let mut reading = |row: usize| {
            let (x, noise) = (next(60) as i64, next(41) as i64 - 20);
            let far = if next(count as u64) < most_outliers { next(300) as i64 - 150 } else { 0 };
            let epsilon = Rational::from(18 + if row.is_multiple_of(2) { next(3) as i64 } else { 0 });
            let regressor = [Rational::from(x), Rational::one()];
            Measurement::around(row, regressor, Rational::from(3 * x + noise + far), epsilon)
        };
        (1..=count).map(&mut reading).collect()
    }

    #[test]
    fn the_tree_and_the_walk_agree() {
        let mut seed = 11;
        let mut most = 0;
        for round in 0..24 {
            let rows = readings(&mut seed, 16 + round, 4);
            let conditions: Vec<Condition> = Vec::new();
            let kept = Kept::new(&rows, Cow::Owned(Ties::default()), &conditions);
            let by_tree = tree(&kept, |_| u64::MAX).expect("no limit");
            let (packed, enough) = packing_of_layers(&kept, 1, u64::MAX).expect("no limit");
            assert!(packed <= by_tree.least && by_tree.least <= enough && enough <= 3 * packed);
            for rows in [kept.in_layers(LayerOf::Corners, enough), (0..kept.rows.len() as u32).collect()] {
                let by_walk = walk(&kept, &rows, &Lines::new(&kept, &rows), usize::MAX >> 8);
                assert_eq!(by_walk.least, by_tree.least);
                let mut sets = by_tree.sets.clone();
                sets.sort();
                assert_eq!(by_walk.sets, sets);
            }
            most = most.max(by_tree.least);
        }
        assert!(most > 3, "{most}");
    }

    #[test]
    fn the_growth_from_the_least_number_on_has_as_many_pieces_as_sets() {
        let mut seed = 12;
        for round in 0..20 {
            let rows = readings(&mut seed, 15 + round, 5);
            let bound = boundfit_estimation::ErrorBound::Column("eps".into());
            let model = boundfit_estimation::Model::Line { x: "x".into() };
            let measurements = boundfit_estimation::Measurements::new(model, "y".into(), bound, rows);
            let problem = Problem::new(measurements);
            let outliers = Outliers::new(&problem, &OutlierLimits::default()).expect("few rows");
            let growth =
                outliers.growth(&problem, outliers.least + 1, &OutlierLimits::default()).expect("few");
            let [.., least, _] = growth.as_slice() else { panic!("two at least") };
            assert_eq!((least.most, least.pieces, least.holes), (outliers.least, outliers.pieces.len(), 0));
            assert_eq!(least.pui, outliers.pui());
            let total = |area: &Option<boundfit_exact::LongSum>| area.as_ref().map(|area| area.total());
            assert_eq!(total(&least.area), total(&outliers.area()));
        }
    }
}
