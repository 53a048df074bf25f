//! The range of factors over which a set keeps its shape.
//!
//! The shape holds as long as certain linear functions of s are not negative. Each is about two or three half-planes,
//! whichever others there are, so that it is the same one in every piece in which these are neighbours: it is kept.

use std::collections::HashMap;

use boundfit_exact::Rational;
use boundfit_geometry::{Polyhedron, Redundancy};

use super::area::AreaGrowth;
use super::functions::Linear;
use super::growing::GrowingSystem;

/// The facts about the half-planes of a family, by their indices.
#[derive(Default)]
pub(super) struct Shape {
    /// The moving corner of one with the next by angle; `None` where a set goes on between them.
    corners: HashMap<(usize, usize), Option<[Linear; 2]>>,
    /// The distance between a side and the next one in the opposite direction.
    gaps: HashMap<(usize, usize), Option<Change>>,
    /// The length along the second half-plane between the first and the third.
    edges: HashMap<[usize; 3], Option<Change>>,
    /// The distance between the first half-plane, which is redundant, and the corner of its neighbours.
    slacks: HashMap<[usize; 3], Option<Change>>,
}

/// The place where a linear function changes its sign.
struct Change {
    at: Rational,
    is_rising: bool,
}

impl Change {
    fn of(function: &Linear) -> Option<Self> {
        Some(Change { at: function.root()?, is_rising: function.slope.is_positive() })
    }
}

/// The closed range of factors in which the shape found at a sample lasts; without end when `to` is `None`.
pub(super) struct Reach {
    pub(super) from: Rational,
    pub(super) to: Option<Rational>,
}

impl Reach {
    /// Narrows the range to the factors at which one more function is not negative.
    fn require(&mut self, change: &Change) {
        if change.is_rising {
            if change.at > self.from {
                self.from = change.at.clone();
            }
        } else if self.to.as_ref().is_none_or(|to| change.at < *to) {
            self.to = Some(change.at.clone());
        }
    }
}

impl Shape {
    /// The common point of two moving boundaries (Cramer's rule), unless the second is half a turn or more further on.
    pub(super) fn corner(&mut self, system: &GrowingSystem, f: usize, g: usize) -> Option<&[Linear; 2]> {
        let found = self.corners.entry((f, g)).or_insert_with(|| corner(system, f, g));
        found.as_ref()
    }

    /// Returns how far the shape at a sample reaches. The shape ends where an edge shrinks to nothing, parallel sides
    /// meet, or another half-plane stops containing it.
    pub(super) fn reach(
        &mut self,
        system: &GrowingSystem,
        polyhedron: &Polyhedron,
        sample: &Rational,
    ) -> Reach {
        let mut reach = Reach { from: Rational::zero(), to: None };
        let spokes = polyhedron.irredundant_by_angle();
        let mut is_irredundant = vec![false; polyhedron.system().len()];
        for (number, &spoke) in spokes.iter().enumerate() {
            is_irredundant[spoke] = true;
            let before = spokes[(number + spokes.len() - 1) % spokes.len()];
            let next = spokes[(number + 1) % spokes.len()];
            if !self.edges.contains_key(&[before, spoke, next]) {
                let change = self.edge(system, before, spoke, next).and_then(|edge| Change::of(&edge));
                self.edges.insert([before, spoke, next], change);
            }
            let gap = self.gaps.entry((spoke, next)).or_insert_with(|| gap(system, spoke, next));
            [&self.edges[&[before, spoke, next]], gap]
                .into_iter()
                .flatten()
                .for_each(|change| reach.require(change));
        }
        for index in (0..is_irredundant.len()).filter(|&index| !is_irredundant[index]) {
            let (before, after) = polyhedron.neighbours(index).unwrap_or((index, index));
            let slack = self.slacks.entry([index, before, after]);
            let slack =
                slack.or_insert_with(|| Change::of(&slack_of(system, index, polyhedron.reason(index))));
            slack.iter().for_each(|change| reach.require(change));
        }
        debug_assert!(reach.from <= *sample, "a shape that is not there at its own sample");
        reach
    }

    /// Returns the growth of the area of a polygon: the sum, over the edges, of the length times the speed of the
    /// boundary. In the units of the half-plane these are the change of a coordinate along the edge over a
    /// coefficient of its form, times the growth of its bound. As a sum over corners there is no term where the
    /// boundaries that meet move alike, as they do nearly everywhere for a line under one bound.
    pub(super) fn growth(&mut self, system: &GrowingSystem, spokes: &[usize]) -> AreaGrowth {
        let speed = |spoke: usize| {
            let [a1, a2] = system.form(spoke);
            let growth = &system.bound(spoke).slope;
            // The boundary runs along (-a2, a1).
            match growth.checked_div(a2) {
                Some(quotient) => [-quotient, Rational::zero()],
                None => [Rational::zero(), growth.checked_div(a1).unwrap_or_default()],
            }
        };
        let mut terms = Vec::new();
        for (&spoke, &next) in spokes.iter().zip(spokes.iter().cycle().skip(1)) {
            let Some(corner) = self.corner(system, spoke, next) else { continue };
            // Where one edge ends, the next one starts.
            for ((own, others), coordinate) in speed(spoke).iter().zip(&speed(next)).zip(corner) {
                if own != others {
                    let factor = own - others;
                    terms.push((&coordinate.constant * &factor, &coordinate.slope * &factor));
                }
            }
        }
        AreaGrowth::sum(&terms)
    }

    /// The length of an edge, in a positive unit: its boundary runs to the left of its normal.
    fn edge(&mut self, system: &GrowingSystem, before: usize, spoke: usize, next: usize) -> Option<Linear> {
        let start = self.corner(system, before, spoke)?.clone();
        let end = self.corner(system, spoke, next)?;
        let [a1, a2] = system.form(spoke);
        let along = [&end[0] - &start[0], &end[1] - &start[1]];
        Some(&along[1].times(a1) - &along[0].times(a2))
    }
}

fn corner(system: &GrowingSystem, f: usize, g: usize) -> Option<[Linear; 2]> {
    let ([f1, f2], [g1, g2]) = (system.form(f), system.form(g));
    let determinant = f1 * g2 - f2 * g1;
    let reciprocal = determinant.recip().filter(|_| determinant.is_positive())?;
    let (bf, bg) = (system.bound(f), system.bound(g));
    let theta1 = &bf.times(g2) - &bg.times(f2);
    let theta2 = &bg.times(f1) - &bf.times(g1);
    Some([theta1.times(&reciprocal), theta2.times(&reciprocal)])
}

/// Returns the gap between two sides if the sides are parallel.
fn gap(system: &GrowingSystem, spoke: usize, next: usize) -> Option<Change> {
    let opposite = system.form(next).each_ref().map(|coefficient| -coefficient);
    let factor = multiple_of(&opposite, system.form(spoke))?;
    Change::of(&(system.bound(next) + &system.bound(spoke).times(&factor)))
}

/// The positive factor with `vector = factor·other`, if there is one.
fn multiple_of(vector: &[Rational; 2], other: &[Rational; 2]) -> Option<Rational> {
    let parallel = &vector[0] * &other[1] == &vector[1] * &other[0];
    let factor = vector[0].checked_div(&other[0]).or_else(|| vector[1].checked_div(&other[1]))?;
    (parallel && factor.is_positive()).then_some(factor)
}

/// Returns what a redundant half-plane leaves.
fn slack_of(system: &GrowingSystem, index: usize, reason: Redundancy) -> Linear {
    let implied = match reason {
        Redundancy::Dominated { by, .. } => system.combined(&by),
        Redundancy::SameAs(other) => {
            let factor = multiple_of(system.form(index), system.form(other)).unwrap_or_default();
            system.bound(other).times(&factor)
        }
        Redundancy::Always | Redundancy::EmptyWithout => Linear::default(),
    };
    system.bound(index) - &implied
}
