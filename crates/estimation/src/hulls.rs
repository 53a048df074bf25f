//! The readings of a line that can bound anything, from the two hulls of the readings, and ε_min.
//!
//! A line within ε of every reading passes above the upper hull of (x, y - ε) and below the lower hull of (x, y + ε).
//! So the smallest ε is half of the largest vertical distance between the upper and the lower hull of (x, y). It is
//! found between a vertex of one hull and an edge of the other, and those three readings prove it.

use boundfit_exact::{Rational, Scaled, multiples};
use boundfit_geometry::grid::{GridPoint, touching, touching_of_columns, touching_places_of_columns};
use boundfit_geometry::{Hull, Tally, touching_as_one, touching_each};

use crate::deciding::OnGrid;
use crate::grid::Grid;
use crate::measurement::Measurement;
use crate::measurements::Measurements;
use crate::places::{ExactPlace, Place, WidePlace};
use crate::ties::TiedReading;

/// The number of readings from which on readings inside are discarded before the others are sorted.
const FEWEST_TO_FILTER: usize = 64;

/// The readings on the two hulls of (x, y), as positions among the rows.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Extremes {
    /// The readings that can have an active bound: those on a hull, ascending, each with those that it stands for. Under a
    /// uniform error bound, however large, no other reading has one.
    pub(crate) touching: Vec<Touching>,
    /// The largest vertical distance between the hulls; `None` without readings.
    pub(crate) widest: Option<Gap>,
    /// The corners of both hulls, ascending.
    pub(crate) corners: Vec<usize>,
}

/// A reading on a hull: the first of those at one corner, or strictly within one edge.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Touching {
    /// The positions of all that it stands for, its own as the first.
    pub(crate) tied: Tally,
    /// `true` on the lower hull: the reading's upper bound can be active.
    pub(crate) lower: bool,
    /// `true` on the upper hull: the reading's lower bound can be active.
    pub(crate) upper: bool,
}

/// A corner of one hull and the edge of the other hull above or below it. Both ends of the edge are the same where
/// the corner is at an end of the other hull.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Gap {
    pub(crate) corner: usize,
    pub(crate) edge: [usize; 2],
    pub(crate) corner_is_lower: bool,
}

impl Touching {
    /// The position of the reading.
    pub(crate) fn position(&self) -> usize {
        self.tied.first() as usize
    }
}

impl Extremes {
    /// The extremes of readings; `None` unless they are of a line under a uniform error bound. Exact. Cost: O(N log N).
    pub(crate) fn of(measurements: &Measurements) -> Option<Self> {
        measurements.has_hulls().then(|| match measurements.on_grid() {
            Some(own) => Extremes::of_deciding(own),
            None => Extremes::new(measurements.kept(), Grid::new(measurements).as_ref()),
        })
    }

    /// The extremes of the readings of a line. Exact. Cost: O(N log N).
    pub(crate) fn new(rows: &[Measurement], grid: Option<&Grid>) -> Self {
        grid.map_or_else(|| Extremes::in_general(rows), Extremes::on_grid)
    }

    /// The extremes of readings of which each touches a hull: nothing is left to be discarded. Exact. Cost: O(N log N); linear where
    /// rows are sorted by x.
    pub(crate) fn of_deciding(readings: &OnGrid) -> Self {
        Extremes::of_touching(readings.sorted_points())
    }

    /// Finds the extremes with machine integers: the coordinates of a grid are small enough for every decision.
    pub(crate) fn on_grid(grid: &Grid) -> Self {
        Extremes::of_columns(grid.phi1.counts(), grid.response.counts())
    }

    fn of_columns(x: &[i64], y: &[i64]) -> Self {
        if x.len() >= FEWEST_TO_FILTER {
            let row = |row: usize| row as u64;
            return Extremes::of_touching(touching_of_columns(x, y, &row, usize::MAX));
        }
        let points = (0..).zip(x.iter().zip(y));
        let points = points.map(|(row, (&x, &y))| GridPoint::of_row(x, y, row)).collect();
        Extremes::of_touching(touching(points, usize::MAX))
    }

    /// Finds the extremes of numbers of any size. Numbers of few digits, as 1.25e300, are machine integers on a unit of their
    /// own.
    pub(crate) fn in_general(rows: &[Measurement]) -> Self {
        if let Some(places) = WidePlace::sorted(rows) {
            return Extremes::of_touching(touching_as_one(places, WidePlace::orientation, usize::MAX));
        }
        let x = multiples(rows.iter().map(|row| &row.regressor[0]));
        if let Some((x, y)) = x.zip(multiples(rows.iter().map(|row| row.y_and_epsilon().0))) {
            return Extremes::of_columns(&x, &y);
        }
        Extremes::of_touching(touching_as_one(ExactPlace::sorted(rows), ExactPlace::orientation, usize::MAX))
    }

    /// Returns the extremes of the readings that touch a hull as one, sorted by x, then by y.
    fn of_touching<P: Place>(points: Vec<P>) -> Self {
        let points = points.as_slice();
        let [lower, upper] = Hull::both(points, P::orientation);
        let mut on = vec![[false; 2]; points.len()];
        lower.support(points).for_each(|place| on[place][0] = true);
        upper.support(points).for_each(|place| on[place][1] = true);
        let touching =
            |(point, [lower, upper]): (&P, [bool; 2])| Touching { tied: point.rows().clone(), lower, upper };
        let mut touching: Vec<Touching> = points.iter().zip(on).map(touching).collect();
        touching.sort_unstable_by_key(Touching::position);
        let lower: Vec<&P> = lower.corners().map(|place| &points[place]).collect();
        let upper: Vec<&P> = upper.corners().rev().map(|place| &points[place]).collect();
        let mut corners: Vec<usize> = lower.iter().chain(&upper).map(|corner| corner.position()).collect();
        // Few runs, where readings are sorted by x.
        corners.sort();
        corners.dedup();
        Extremes { touching, widest: widest(&lower, &upper), corners }
    }
}

impl Measurements {
    /// The readings in memory that touch a hull of all: under no uniform error bound can another one bound a line. `None` unless these are readings of a line under a uniform error bound. Exact. Cost: O(N log N).
    pub fn supporting(&self) -> Option<Vec<Measurement>> {
        let extremes = Extremes::of(self)?;
        let mut positions: Vec<u64> =
            extremes.touching.iter().flat_map(|touching| touching.tied.rows()).collect();
        positions.sort_unstable();
        Some(positions.into_iter().map(|position| self.kept()[position as usize].clone()).collect())
    }
}

/// Returns the readings of a line on either hull of (x, y): the readings of [`Extremes::touching`], or each place
/// within an edge. Lists at most so many numbers of the readings that each stands for. Exact. Cost: O(N log N).
pub(crate) fn touching_a_hull(
    readings: Vec<TiedReading>,
    most: usize,
    edges_as_one: bool,
) -> Vec<TiedReading> {
    let (rows, tallies): (Vec<Measurement>, Vec<Tally>) =
        readings.into_iter().map(|TiedReading { reading, rows }| (reading, rows)).unzip();
    let columns = Scaled::of_numbers(rows.iter().map(|row| &row.regressor[0]))
        .zip(Scaled::of_numbers(rows.iter().map(|row| row.y_and_epsilon().0)));
    let extremes = match columns {
        Some((x, y)) if edges_as_one => Extremes::of_columns(x.counts(), y.counts()),
        Some((x, y)) => {
            let row = |row: usize| row as u64;
            Extremes::of_touching(touching_places_of_columns(x.counts(), y.counts(), &row, usize::MAX))
        }
        None if edges_as_one => Extremes::in_general(&rows),
        None => Extremes::of_touching(touching_each(
            ExactPlace::sorted(&rows),
            ExactPlace::orientation,
            usize::MAX,
        )),
    };
    let with_all = |Touching { tied, .. }: Touching| {
        let tallies = || tied.rows().map(|position| &tallies[position as usize]);
        let first = tied.rows().min_by_key(|&position| rows[position as usize].row).unwrap_or_default();
        let reading = rows[first as usize].clone();
        TiedReading { reading, rows: Tally::merged(tallies().cloned(), most) }
    };
    extremes.touching.into_iter().map(with_all).collect()
}

/// Returns the widest gap between the hulls, whose corners are sorted by x. Among equal gaps it takes the first
/// corner of the upper hull, or else of the lower one. Cost: O(log² n), since the gap is a concave function of x.
fn widest<P: Place>(lower: &[&P], upper: &[&P]) -> Option<Gap> {
    let gap_of = |corners: &[&P], hull: &[&P], corner_is_lower: bool| {
        // The edge above or below a corner; at the right end of the hull, both ends are that corner.
        let edge = |corner: &P| {
            let left = hull[1..].partition_point(|next| next.by_x(corner).is_le());
            [hull[left], hull.get(left + 1).unwrap_or(&hull[left])]
        };
        let distance = |corner: &P| corner.distance(edge(corner));
        // The first corner behind which no gap is wider.
        let (mut first, mut last) = (0, corners.len() - 1);
        while first < last {
            let middle = first + (last - first) / 2;
            let grows = distance(corners[middle]) < distance(corners[middle + 1]);
            if grows {
                first = middle + 1;
            } else {
                last = middle;
            }
        }
        let corner = corners[first];
        let [left, right] = edge(corner).map(P::position);
        (distance(corner), Gap { corner: corner.position(), edge: [left, right], corner_is_lower })
    };
    if lower.is_empty() {
        return None;
    }
    let (above, below) = (gap_of(upper, lower, false), gap_of(lower, upper, true));
    Some(if above.0 < below.0 { below.1 } else { above.1 })
}

/// ε_min with its proof.
#[derive(Debug)]
pub(crate) struct HullMinimum {
    /// ε_min.
    pub(crate) epsilon: Rational,
    /// Positions of the readings whose lower (`true`) or upper bound proves it, with multipliers that sum to 1.
    pub(crate) proof: Vec<(usize, bool, Rational)>,
    /// The minimiser, when these readings leave only one.
    pub(crate) theta: Option<[Rational; 2]>,
}

impl Gap {
    /// ε_min when no gap is wider: half of its height.
    pub(crate) fn minimum(&self, measurements: &Measurements) -> HullMinimum {
        let Gap { corner, edge: [left, right], corner_is_lower } = *self;
        let three = [corner, left, right].map(|position| measurements.kept_at(position));
        let [(x, y), (left_x, left_y), (right_x, right_y)] =
            three.each_ref().map(|row| (&row.regressor[0], row.y_and_epsilon().0));
        let run = right_x - left_x;
        let along = x - left_x;
        let weight = along.checked_div(&run).unwrap_or_default();
        let slope = (right_y - left_y).checked_div(&run);
        let rise = slope.as_ref().map_or_else(Rational::zero, |slope| slope * &along);
        let distance = y - left_y - rise;
        let epsilon = if corner_is_lower { -distance } else { distance }.half();
        let opposite = Rational::one() - &weight;
        // A reading on the upper hull pushes the line up: its lower bound is the one that counts.
        let proof = vec![
            (corner, !corner_is_lower, Rational::ratio(1, 2)),
            (left, corner_is_lower, opposite.half()),
            (right, corner_is_lower, weight.half()),
        ];
        let proof: Vec<_> = proof.into_iter().filter(|(_, _, multiplier)| !multiplier.is_zero()).collect();
        // Every minimiser keeps the greatest distance from each of these: three readings at different x leave one line, in
        // parallel to the edge.
        let theta = slope.filter(|_| proof.len() == 3).map(|slope| {
            let edge_offset = left_y - &slope * left_x;
            let offset = if corner_is_lower { edge_offset - &epsilon } else { edge_offset + &epsilon };
            [slope, offset]
        });
        HullMinimum { epsilon, proof, theta }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Few values on a fine unit, so that many readings are equal, above each other or on one line.
    #[test]
    fn wide_integers_have_the_extremes_of_fractions() {
        let mut seed = 3_u64;
        let mut draw = |below: u64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 33) % below
        };
        for round in 0..2_000 {
            let far = i128::from(i64::MAX) << (round % 62);
            let mut number = || {
                let [steps, rest] = [draw(4), if round % 3 == 0 { draw(3) } else { 0 }].map(i128::from);
                Rational::scientific((steps - 2) * far + rest, -19)
            };
            let reading =
                |row| Measurement::around(row, [number(), Rational::one()], number(), Rational::one());
            let rows: Vec<Measurement> = (1..2 + round % 14).map(reading).collect();
            let wide = WidePlace::sorted(&rows).unwrap();
            assert_eq!(
                Extremes::of_touching(touching_as_one(wide, WidePlace::orientation, usize::MAX)),
                Extremes::of_touching(touching_as_one(
                    ExactPlace::sorted(&rows),
                    ExactPlace::orientation,
                    usize::MAX
                )),
                "{round}"
            );
        }
    }
}
