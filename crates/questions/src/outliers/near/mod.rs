//! The rows that decide where few readings are missed, and walls around that place.
//!
//! A point that misses few readings meets both of most pairs of readings, so that order statistics of the parallelograms of disjoint
//! pairs bound it. The box that they give is divided again and again, without the parts in which more readings are missed throughout
//! than at the best point found. All of it happens on machine integers.

mod counted;
mod place;

use boundfit_estimation::{Condition, Measurement, Ties, conditions_by_name};
use boundfit_geometry::Inequality;

use counted::Counted;
pub(super) use place::FORBIDDEN;
use place::Side;

/// The number of rows below which all of them are looked at.
const FEWEST: usize = 64;

/// The rows that decide around the points that miss at most `enough` readings.
pub(super) struct Near {
    /// Positions of rows, ascending, and whether their upper and lower bounds decide. The other rows are met throughout the walls.
    pub(super) rows: Vec<(usize, [bool; 2])>,
    /// The number of readings that are missed at some point within the walls, of those that can be met.
    pub(super) enough: u64,
    /// Every point that misses at most `enough` readings, and no condition, is strictly within these.
    pub(super) walls: Vec<Inequality>,
}

impl Near {
    /// Finds the rows. Exact. Returns `None` where it does not pay: few rows, bounds that are not multiples of one unit in machine
    /// integers, a place without limits, or most rows decide. Cost: linear in the rows, with a factor for the bits of the place.
    pub(super) fn new(measurements: &[Measurement], ties: &Ties, conditions: &[Condition]) -> Option<Self> {
        if measurements.len() < FEWEST {
            return None;
        }
        let conditions: Vec<Inequality> = conditions_by_name(conditions).map(|(_, own)| own).collect();
        let counted = Counted::new(measurements, ties, &conditions)?;
        let place = counted.place()?;
        let sides = counted.sides(&place)?;
        let cells = place.divided(&sides)?;
        if cells.fewest >= place.certain {
            return None;
        }
        let (around, corners) = place.around_cells(&cells);
        let decides_within = |side: &Side| {
            around.reach(side)[1] >= side.most && corners.iter().any(|corner| side.value(corner) >= side.most)
        };
        let mut rows: Vec<(usize, [bool; 2])> = Vec::new();
        for side in sides.iter().filter(|side| side.owner < measurements.len()) {
            if rows.last().is_none_or(|(last, _)| *last != side.owner) {
                rows.push((side.owner, [false; 2]));
            }
            if let Some((_, decides)) = rows.last_mut()
                && decides_within(side)
            {
                decides[usize::from(side.is_lower)] = true;
            }
        }
        rows.retain(|(_, decides)| *decides != [false; 2]);
        rows.extend(counted.others.iter().map(|&own| (own, [true; 2])));
        rows.sort_unstable_by_key(|(own, _)| *own);
        let pays = 2 * rows.len() <= measurements.len();
        pays.then(|| Near { rows, enough: cells.fewest, walls: counted.walls(&corners, place.scale) })
    }
}

#[cfg(test)]
mod tests {
    use std::borrow::Cow;

    use boundfit_estimation::{ErrorBound, Measurements, Model, Problem};
    use boundfit_exact::{Limits, Rational, Reading};

    use super::*;
    use crate::outliers::kept::Kept;
    use crate::outliers::{OutlierLimits, Outliers};

    /// Readings about a plane or a line, some of them far away. They have few different numbers, are repeated, have bounds of their
    /// own, are one-sided or crossed, or have a second regressor.
    fn readings(seed: &mut u64, kind: u64, count: usize) -> Vec<Measurement> {
        let mut next = |below: i64| {
            *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (*seed >> 33) as i64 % below
        };
        let size = if kind == 0 { 6 } else { 1000 };
        let far = next(8);
        let mut rows: Vec<Measurement> = Vec::new();
        for row in 1..=count {
            let x = next(2 * size) - size / 3;
            let second = if kind == 4 { next(2 * size) - size } else { 1 };
            let noise = next(41) - 20 + if next(count as i64) < far { next(3000) - 1500 } else { 0 };
            let y = Rational::ratio(37 * x - 11 * second + 10 * noise, 10);
            let regressor = [Rational::ratio(x, 7), Rational::from(second)];
            let epsilon = Rational::from(19 + if kind == 2 { next(4) } else { 0 });
            let [lower, upper] = [&y - &epsilon, &y + &epsilon];
            let own = match (kind, next(12)) {
                (3, 0) => Measurement::between(row, regressor, Some(lower), None),
                (3, 1) => Measurement::between(row, regressor, None, Some(upper)),
                (3, 2) if far > 5 => Measurement::between(row, regressor, Some(upper), Some(lower)),
                (3, _) => Measurement::between(row, regressor, Some(lower), Some(upper)),
                (5, 0..6) if row > 9 => {
                    Measurement { row, ..rows.get(next(9) as usize).cloned().expect("nine rows") }
                }
                _ => Measurement::around(row, regressor, y, epsilon),
            };
            rows.push(own);
        }
        rows
    }

    #[test]
    fn the_rows_near_the_fewest_decide_as_all_rows_do() {
        let mut seed = 7;
        let (mut found, mut most) = (0, 0);
        for round in 0..90_u64 {
            let kind = round % 6;
            let rows = readings(&mut seed, kind, 64 + (round as usize * 7) % 120);
            let text = ["theta1 <= 25.889", "theta2 >= -0.5", "theta1 = 25.9"][round as usize / 4 % 3];
            let own = Condition::parse(text, Reading::Decimal, &Limits::default()).expect("a condition");
            let conditions: Vec<Condition> = (round % 4 == 1).then_some(own).into_iter().collect();
            let model = Model::Line { x: "x".into() };
            let bound = ErrorBound::Interval { lower: Some("lower".into()), upper: Some("upper".into()) };
            let measurements = match round % 5 {
                0 => {
                    let counts: Vec<u64> = (0..rows.len() as u64).map(|k| 1 + k % 3).collect();
                    Measurements::counted(model, "y".into(), bound, rows, &counts)
                }
                _ => Measurements::new(model, "y".into(), bound, rows),
            };
            let problem = Problem { measurements, conditions };
            let (rows, ties) = problem.measurements.every().expect("all readings");
            let near = Kept::near_the_fewest(rows, ties.clone(), &problem.conditions);
            found += usize::from(near.enough.is_some());
            let all = Kept::new(rows, Cow::Owned(ties.into_owned()), &problem.conditions);
            for limits in [OutlierLimits::default(), OutlierLimits { sets: 2, steps: 20_000_000 }] {
                let [near, all] = [&near, &all].map(|kept| Outliers::of_kept(kept, &problem, &limits));
                let ([Ok(near), Ok(all)], true) = ([&near, &all], near.is_ok()) else {
                    panic!("{near:?} {all:?}");
                };
                assert_eq!((near.least, near.is_complete), (all.least, all.is_complete));
                assert_eq!((near.pui(), near.pieces.len()), (all.pui(), all.pieces.len()));
                for (one, other) in near.pieces.iter().zip(&all.pieces) {
                    assert_eq!(one.rows, other.rows);
                    assert_eq!(one.left.polyhedron().system(), other.left.polyhedron().system());
                    assert_eq!(one.left.polyhedron().region(), other.left.polyhedron().region());
                }
                most = most.max(near.least);
            }
        }
        assert!(found > 30 && most > 5, "{found} {most}");
    }
}
