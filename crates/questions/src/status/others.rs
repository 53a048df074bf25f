//! Readings against a set that they do not decide, part by part.

use std::sync::atomic::{AtomicU64, Ordering};

use boundfit_estimation::{Measurement, Seen};
use boundfit_exact::Rational;
use boundfit_geometry::grid::RoundedStrips;
use boundfit_geometry::{Polyhedron, Region, System, Vertex, envelope};

use super::leave_one_out::RowStatus;
use super::ranking::Ranking;
use super::standing::Standing;

/// A set, for readings that decide nothing of it: the set of all is to them that of the others.
#[derive(Debug)]
pub struct Others<'a> {
    set: &'a Polyhedron,
    /// The corners, on rounded numbers, of a polygon around the set; none around a set that is empty or unbounded.
    corners: Vec<[f64; 2]>,
    /// The least margin beyond which readings come after all that one of the rankings lists. Numbers that are not negative are
    /// in the order of their bits.
    beyond: AtomicU64,
}

impl<'a> Others<'a> {
    /// Takes a set, and finds a polygon of at most sixteen corners around it: what keeps clear of the polygon keeps clear
    /// of the set. Cost: linear in the set's corners.
    pub fn around(set: &'a Polyhedron) -> Self {
        /// Corners that cost a reading less than one exact comparison.
        const MOST: usize = 16;
        let spokes = set.irredundant_by_angle();
        let few;
        let region: &Region = if set.region().vertices().len() <= MOST {
            set.region()
        } else {
            let inequalities = set.system().inequalities();
            let some = (0..MOST).filter_map(|place| spokes.get(place * spokes.len() / MOST));
            few = envelope::intersect(&some.map(|&spoke| inequalities[spoke].clone()).collect::<System>());
            &few
        };
        let corner = |vertex: &Vertex| [vertex.point().theta1().to_f64(), vertex.point().theta2().to_f64()];
        let corners = region.is_bounded().then(|| region.vertices().iter().map(corner).collect());
        let beyond = AtomicU64::new(f64::INFINITY.to_bits());
        Others { set, corners: corners.unwrap_or_default(), beyond }
    }

    /// Adds some readings to a ranking, which is merged with those of all other readings later; all list equally many. Readings
    /// that come after all that one of them lists are counted only. Exact. Cost: some nanoseconds for each that certainly comes after all that the
    /// ranking lists; logarithmic in the number of the set's corners for each other.
    pub fn rank(&self, readings: &Seen<'_>, ranking: &mut Ranking) {
        let margins = (!self.corners.is_empty()).then(|| self.margins(&readings.strips()));
        let readings = (0..readings.count()).map(|place| move || readings.reading(place));
        self.rank_each(readings, margins.unwrap_or_default(), ranking);
    }

    /// Adds readings in memory to a ranking, as [`Others::rank`] does. Exact. Cost: that of rounding five numbers for each reading that
    /// certainly comes after all that the ranking lists.
    pub fn rank_in_memory(&self, readings: &[&Measurement], ranking: &mut Ranking) {
        let margins = (!self.corners.is_empty()).then(|| self.margins(&strips(readings)));
        let readings = readings.iter().map(|&reading| || reading.clone());
        self.rank_each(readings, margins.unwrap_or_default(), ranking);
    }

    fn rank_each<R: FnOnce() -> Measurement>(
        &self,
        readings: impl Iterator<Item = R>,
        margins: Vec<f64>,
        ranking: &mut Ranking,
    ) {
        ranking.learn_beyond(f64::from_bits(self.beyond.load(Ordering::Relaxed)));
        let mut margins = margins.into_iter();
        for reading in readings {
            if margins.next().is_some_and(|margin| ranking.add_clear(margin)) {
                continue;
            }
            let reading = reading();
            let all = Standing::against(&reading, self.set);
            let status = RowStatus { row: reading.row, without: all.clone(), all };
            ranking.add(reading, status);
        }
        self.beyond.fetch_min(ranking.beyond().to_bits(), Ordering::Relaxed);
    }

    /// Returns a number for each reading that its [margin](Standing::margin) certainly exceeds. It is -∞ where no
    /// number above 0 is certain, as for a reading with one bound or without width. Cost: some nanoseconds each.
    fn margins(&self, strips: &RoundedStrips) -> Vec<f64> {
        /// The relative error of all terms together: regressors have 2⁻⁵⁰, bounds 2⁻⁴⁷, corners and operations 2⁻⁵³.
        const MARGIN: f64 = 1.0 / (1_u64 << 44) as f64;
        let [first, second] = &strips.phi;
        let bounds = strips.lower.iter().zip(&strips.upper);
        let margin = |((&phi1, &phi2), (&lower, &upper)): ((&f64, &f64), (&f64, &f64))| {
            let (mut room, mut size) = (f64::INFINITY, lower.abs() + upper.abs());
            for [theta1, theta2] in &self.corners {
                let [p, q] = [phi1 * theta1, phi2 * theta2];
                let (below, above) = ((p + q) - lower, upper - (p + q));
                // Not `min`, which would pass over what is not a number.
                room = if below < room { below } else { room };
                room = if above < room { above } else { room };
                size += p.abs() + q.abs();
            }
            let error = MARGIN * size;
            let half_width = (upper - lower) / 2.0 + error;
            let margin = (room - error) / half_width * (1.0 - MARGIN);
            // Infinities and what is not a number are no such margin either.
            let is_certain = margin > 0.0 && margin.is_finite() && size.is_finite() && lower < upper;
            if is_certain { margin } else { f64::NEG_INFINITY }
        };
        first.iter().zip(second).zip(bounds).map(margin).collect()
    }
}

/// Readings on floats that lie within their bounds.
fn strips(readings: &[&Measurement]) -> RoundedStrips {
    let inside = |own: Option<Rational>, without: f64, inwards: fn(f64) -> f64| {
        own.map_or(without, |own| inwards(own.to_f64()))
    };
    RoundedStrips {
        phi: [0, 1].map(|k| readings.iter().map(|own| own.regressor[k].to_f64()).collect()),
        lower: readings.iter().map(|own| inside(own.lower(), f64::NEG_INFINITY, f64::next_up)).collect(),
        upper: readings.iter().map(|own| inside(own.upper(), f64::INFINITY, f64::next_down)).collect(),
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use boundfit_geometry::Inequality;

    use super::*;
    use crate::status::Status;

    fn word(state: &mut u64) -> i64 {
        *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*state >> 40) as i64 - (1 << 23)
    }

    #[test]
    fn no_margin_is_below_the_one_that_is_certain() {
        let mut state = 7;
        let mut certain = 0;
        for case in 0..400 {
            // Sets of three to some hundred sides, far from the origin or not, some of them unbounded.
            let sides = 3 + case % 100;
            let far = Rational::from(word(&mut state) * (case % 3));
            let scale = Rational::ratio(1, 1 + (case % 7) * 1000);
            let side = |state: &mut u64| {
                let a = [word(state), word(state)].map(Rational::from);
                let b = Rational::from(word(state).abs() + (1 << 23)) * &scale * Rational::from(1 << 10);
                let moved = &a[0] * &far;
                Inequality::new(a[0].clone(), a[1].clone(), b + moved)
            };
            let set = Polyhedron::intersect((0..sides).map(|_| side(&mut state)).collect());
            let others = Others::around(&set);
            let reading = |state: &mut u64, row: usize| {
                let x = Rational::ratio(word(state), 1 << 20);
                let around = set.range(&[x.clone(), Rational::one()]).and_then(|own| own.midpoint());
                let y = around.unwrap_or_default() + Rational::ratio(word(state), 1 << (10 + case % 20));
                let half_width = Rational::ratio(word(state).abs(), 1 << (8 + case % 20));
                Measurement::around(row, [x, Rational::one()], y, half_width)
            };
            let readings: Vec<Measurement> = (1..=50).map(|row| reading(&mut state, row)).collect();
            let every: Vec<&Measurement> = readings.iter().collect();
            for (reading, margin) in readings.iter().zip(others.margins(&strips(&every))) {
                if margin == f64::NEG_INFINITY {
                    continue;
                }
                certain += 1;
                let standing = Standing::against(reading, &set).unwrap();
                assert_eq!(standing.status, Status::Inner);
                let exact = standing.margin().unwrap();
                assert!(exact > Rational::from_f64(margin).unwrap(), "{exact} {margin}");
            }
        }
        assert!(certain > 2000, "{certain}");
    }

    /// Adding each reading without a look at its margin is the reference.
    #[test]
    fn rankings_of_parts_list_what_a_ranking_of_all_lists() {
        let mut state = 3;
        let (mut looked_at_first, mut looked_at_others) = (0, 0);
        for case in 0..60 {
            let side = |a: i64, b: i64| Inequality::new(a.into(), b.into(), Rational::from(2));
            let set = Polyhedron::intersect(
                [(1, 0), (-1, 0), (0, 1), (0, -1)].map(|(a, b)| side(a, b)).into_iter().collect(),
            );
            let others = Others::around(&set);
            // Many readings are equal, so that rows decide; some cut the set or leave nothing.
            let readings: Vec<Measurement> = (1..=400)
                .map(|row| {
                    let [x, y, width] = [(); 3].map(|()| Rational::from(word(&mut state) % (3 + case % 5)));
                    let width = width.abs() + Rational::from(if row % 90 == 0 { 0 } else { 3 + case % 9 });
                    Measurement::around(row as usize, [x, Rational::one()], y, width)
                })
                .collect();
            let most = 1 + case as usize % 7;
            let (mut merged, mut plain) = (Ranking::listing(most), Ranking::listing(most));
            for part in readings.chunks(1 + 13 * (case as usize % 9)) {
                let mut ranking = Ranking::listing(most);
                let looked = Cell::new(0);
                let look = |own: &Measurement| {
                    looked.set(looked.get() + 1);
                    own.clone()
                };
                let each = part.iter().map(|own| || look(own));
                let every: Vec<&Measurement> = part.iter().collect();
                others.rank_each(each, others.margins(&strips(&every)), &mut ranking);
                merged.merge(ranking);
                // One part of a hundred readings tells the others what comes too late.
                if part.len() == 1 + 13 * 8 {
                    let is_first = part[0].row == 1;
                    *(if is_first { &mut looked_at_first } else { &mut looked_at_others }) += looked.get();
                }
            }
            for reading in &readings {
                let all = Standing::against(reading, &set);
                plain.add(reading.clone(), RowStatus { row: reading.row, without: all.clone(), all });
            }
            assert_eq!((merged.count(), merged.boundary()), (plain.count(), plain.boundary()));
            for status in Status::ALL.map(Some) {
                assert_eq!(merged.count_of_all(status), plain.count_of_all(status));
            }
            assert_eq!(merged.into_listed(), plain.into_listed(), "{case}");
        }
        // There are two more such parts.
        assert!(3 * looked_at_others < 4 * looked_at_first, "{looked_at_others} and {looked_at_first}");
    }
}
