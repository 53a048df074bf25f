//! The range of factors over which a set keeps its shape.
//!
//! The shape holds as long as certain linear functions of s are not negative. Each is about two or three half-planes,
//! whichever others there are, so that it is the same one in every piece in which these are neighbours: it is kept.

use boundfit_geometry::Direction;
use boundfit_geometry::predicates::angle_order;

use super::area::AreaGrowth;
use super::functions::Linear;
use super::growing::GrowingSystem;
use super::neighbours::{Neighbours, Reach};

/// The facts about the half-planes of a family, by their indices.
pub(super) struct Shape<'a> {
    pub(super) system: &'a GrowingSystem,
    /// Half-planes of the same direction together, by angle from behind that of (-1, 0): the first vertex of a
    /// polygon is the corner of its last half-plane and its first.
    directions: Vec<Vec<usize>>,
    /// The place of each half-plane in this order.
    places: Vec<usize>,
    /// The half-planes that were the next neighbours of each, with the facts about both.
    neighbours: Vec<Known<usize, Neighbours>>,
    /// The pairs that each half-plane had an edge between, with the factors at which it has.
    edges: Vec<Known<[usize; 2], Reach>>,
}

/// Facts by their keys. There are few, and the last ones are asked for most.
type Known<K, F> = Vec<(K, F)>;

/// The place of a fact, if it is known.
fn place<K: PartialEq, F>(facts: &Known<K, F>, key: &K) -> Option<usize> {
    facts.iter().rposition(|(known, _)| known == key)
}

impl<'a> Shape<'a> {
    pub(super) fn new(system: &'a GrowingSystem) -> Self {
        let direction = |index: usize| Some((Direction::from_rational(system.form(index))?, index));
        let mut sorted: Vec<(Direction, usize)> = (0..system.len()).filter_map(direction).collect();
        sorted.sort_by(|(one, _), (other, _)| angle_order((one.dx(), one.dy()), (other.dx(), other.dy())));
        let half_turn = sorted.partition_point(|(direction, _)| !direction.dy().is_negative());
        sorted.rotate_left(half_turn);
        let mut places = vec![0; system.len()];
        let mut directions: Vec<Vec<usize>> = Vec::new();
        for same in sorted.chunk_by(|(one, _), (other, _)| one == other) {
            same.iter().for_each(|&(_, index)| places[index] = directions.len());
            directions.push(same.iter().map(|&(_, index)| index).collect());
        }
        let neighbours = places.iter().map(|_| Known::new()).collect();
        let edges = places.iter().map(|_| Known::new()).collect();
        Shape { system, directions, places, neighbours, edges }
    }

    /// Sorts half-planes by angle, from behind that of (-1, 0).
    pub(super) fn sort(&self, spokes: &mut [usize]) {
        spokes.sort_unstable_by_key(|&spoke| self.places[spoke]);
    }

    /// Returns the facts about two half-planes that are neighbours in a set.
    pub(super) fn neighbours(&mut self, f: usize, g: usize) -> &Neighbours {
        let facts = &mut self.neighbours[f];
        let place = place(facts, &g).unwrap_or_else(|| {
            let (first, last, all) = (self.places[f], self.places[g], self.directions.as_slice());
            let between =
                if first < last { [&all[first..=last], &[]] } else { [&all[first..], &all[..=last]] };
            let between = between.into_iter().flatten().flatten().copied();
            facts.push((g, Neighbours::new(self.system, [f, g], between)));
            facts.len() - 1
        });
        &self.neighbours[f][place].1
    }

    /// The factors at which there is an edge along the second half-plane between the first and the third.
    pub(super) fn edge(&mut self, before: usize, spoke: usize, next: usize) -> &Reach {
        let place = place(&self.edges[spoke], &[before, next]).unwrap_or_else(|| {
            let length = self.length(before, spoke, next);
            let reach = length.map_or_else(Reach::default, |own| Reach::of(&own));
            self.edges[spoke].push(([before, next], reach));
            self.edges[spoke].len() - 1
        });
        &self.edges[spoke][place].1
    }

    /// The length of an edge, in a positive unit: its boundary runs to the left of its normal.
    fn length(&mut self, before: usize, spoke: usize, next: usize) -> Option<Linear> {
        let start = self.neighbours(before, spoke).corner.as_ref()?.theta.clone();
        let end = &self.neighbours(spoke, next).corner.as_ref()?.theta;
        let along = [&end[0] - &start[0], &end[1] - &start[1]];
        let [a1, a2] = self.system.form(spoke);
        Some(&along[1].times(a1) - &along[0].times(a2))
    }

    /// Returns how far the shape of a set reaches that has these half-planes by angle. The shape ends where an edge
    /// shrinks to nothing, parallel sides meet, or another half-plane stops containing it.
    pub(super) fn reach(&mut self, spokes: &[usize]) -> Reach {
        let mut reach = Reach::default();
        for [before, spoke, next] in around(spokes) {
            reach.narrow(&self.neighbours(before, spoke).reach);
            reach.narrow(self.edge(before, spoke, next));
        }
        reach
    }

    /// Returns the growth of the area of a polygon: the sum, over the edges, of the length times the speed of the
    /// boundary. In the units of the half-plane these are the change of a coordinate along the edge over a
    /// coefficient of its form, times the growth of its bound. As a sum over corners there is no term where the
    /// boundaries that meet move alike, as they do nearly everywhere for a line under one bound.
    pub(super) fn growth(&mut self, spokes: &[usize]) -> AreaGrowth {
        let mut terms = Vec::new();
        for [before, spoke, _] in around(spokes) {
            let speeds = [before, spoke].map(|side| self.system.speed(side));
            let Some(corner) = &self.neighbours(before, spoke).corner else { continue };
            // Where one edge ends, the next one starts.
            for ((own, others), coordinate) in speeds[0].iter().zip(speeds[1]).zip(&corner.theta) {
                if own != others {
                    let factor = own - others;
                    terms.push((&coordinate.constant * &factor, &coordinate.slope * &factor));
                }
            }
        }
        AreaGrowth::sum(&terms)
    }
}

/// Each half-plane of a set between the ones before and after it by angle.
pub(super) fn around(spokes: &[usize]) -> impl Iterator<Item = [usize; 3]> {
    let count = spokes.len();
    (0..count).map(move |at| [(at + count - 1) % count, at, (at + 1) % count].map(|at| spokes[at]))
}
