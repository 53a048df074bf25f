//! Two half-planes of a set that are neighbours by angle, and the redundant ones between them.

use std::sync::Arc;

use boundfit_exact::{Fraction, Integer, Rational, Sign};

use super::functions::{Linear, MovingVertex};
use super::growing::GrowingSystem;

/// All that two neighbours say about every set in which they are neighbours.
pub(super) struct Neighbours {
    /// Their corner; `None` where the set goes on between them.
    pub(super) corner: Option<Arc<MovingVertex>>,
    /// True if no other half-plane goes along with the corner.
    pub(super) is_simple: bool,
    /// The factors at which they can be neighbours.
    pub(super) reach: Reach,
    /// The redundant half-planes that the corner meets at the end of that range.
    pub(super) met: Vec<usize>,
}

/// A closed range of factors; without end when `to` is `None`.
#[derive(Clone, Default)]
pub(super) struct Reach {
    pub(super) from: Rational,
    pub(super) to: Option<Rational>,
}

impl Reach {
    /// The factors from 0 at which a linear function is not negative; it is positive at some of them.
    pub(super) fn of(function: &Linear) -> Self {
        match (function.slope.sign(), function.root()) {
            (Sign::Positive, Some(root)) => Reach { from: root.max(Rational::zero()), to: None },
            (_, to) => Reach { from: Rational::zero(), to },
        }
    }

    /// Narrows the range to what it shares with another one.
    pub(super) fn narrow(&mut self, other: &Reach) {
        if other.from > self.from {
            self.from = other.from.clone();
        }
        if let Some(end) = &other.to
            && self.to.as_ref().is_none_or(|to| end < to)
        {
            self.to = Some(end.clone());
        }
    }
}

impl Neighbours {
    /// The neighbours `f` and `g`; the half-planes between them by angle come last.
    pub(super) fn new(
        system: &GrowingSystem,
        [f, g]: [usize; 2],
        between: impl Iterator<Item = usize>,
    ) -> Self {
        let theta = corner(system, f, g);
        let mut reach = gap(system, f, g).map_or_else(Reach::default, |gap| Reach::of(&gap));
        let mut active = vec![f, g];
        let (mut from, mut to, mut met) = (None, None, Vec::new());
        let scaled = theta.as_ref().map(Scaled::new);
        for index in between.filter(|index| ![f, g].contains(index)) {
            let slack = match &scaled {
                Some(corner) => Some(corner.slack(system.scaled(index))),
                None => slack_of_parallel(system, index, [f, g]),
            };
            let Some([constant, slope]) = slack else { continue };
            if slope.is_zero() && constant.is_zero() {
                active.push(index);
            }
            // Reduced once, not for each half-plane.
            let Some(root) = Fraction::new(-constant, slope.clone()) else { continue };
            if slope.is_positive() {
                from = from.max(Some(root));
            } else if to.as_ref().is_none_or(|to| root <= *to) {
                if to.as_ref() != Some(&root) {
                    met.clear();
                }
                met.push(index);
                to = Some(root);
            }
        }
        let [from, to] = [from, to].map(|root| root.map(Rational::from));
        reach.narrow(&Reach { from: from.unwrap_or_default(), to });
        let is_simple = active.len() == 2;
        let corner = theta.map(|theta| Arc::new(MovingVertex { theta, active: system.active(&active) }));
        Neighbours { corner, is_simple, reach, met }
    }
}

/// The common point of two moving boundaries (Cramer's rule), unless the second is half a turn or more further on.
fn corner(system: &GrowingSystem, f: usize, g: usize) -> Option<[Linear; 2]> {
    let ([f1, f2], [g1, g2]) = (system.form(f), system.form(g));
    let determinant = f1 * g2 - f2 * g1;
    let reciprocal = determinant.recip().filter(|_| determinant.is_positive())?;
    let (bf, bg) = (system.bound(f), system.bound(g));
    let theta1 = &bf.times(g2) - &bg.times(f2);
    let theta2 = &bg.times(f1) - &bf.times(g1);
    Some([theta1.times(&reciprocal), theta2.times(&reciprocal)])
}

/// Returns the gap between two sides if they are parallel and face each other.
fn gap(system: &GrowingSystem, f: usize, g: usize) -> Option<Linear> {
    let opposite = system.form(g).each_ref().map(|coefficient| -coefficient);
    let factor = multiple_of(&opposite, system.form(f))?;
    Some(system.bound(g) + &system.bound(f).times(&factor))
}

/// The positive factor with `vector = factor·other`, if there is one.
fn multiple_of(vector: &[Rational; 2], other: &[Rational; 2]) -> Option<Rational> {
    let parallel = &vector[0] * &other[1] == &vector[1] * &other[0];
    let factor = vector[0].checked_div(&other[0]).or_else(|| vector[1].checked_div(&other[1]))?;
    (parallel && factor.is_positive()).then_some(factor)
}

/// Constant and slope, times something positive, of what a half-plane leaves of the parallel one of two others.
fn slack_of_parallel(system: &GrowingSystem, index: usize, others: [usize; 2]) -> Option<[Integer; 2]> {
    let slack = |other: usize| {
        let factor = multiple_of(system.form(index), system.form(other))?;
        Some(system.bound(index) - &system.bound(other).times(&factor))
    };
    let Linear { constant, slope } = others.into_iter().find_map(slack)?;
    Some(Rational::over_common_denominator([&constant, &slope]).0)
}

/// A moving point as integers over a common denominator: the slack of a half-plane takes no common divisor.
struct Scaled {
    constant: [Integer; 2],
    slope: [Integer; 2],
    denominator: Integer,
}

impl Scaled {
    fn new([theta1, theta2]: &[Linear; 2]) -> Self {
        let functions = [&theta1.constant, &theta2.constant, &theta1.slope, &theta2.slope];
        let ([c1, c2, s1, s2], denominator) = Rational::over_common_denominator(functions);
        Scaled { constant: [c1, c2], slope: [s1, s2], denominator }
    }

    /// Constant and slope, times something positive, of the distance to the boundary of a half-plane.
    fn slack(&self, [a1, a2, constant, slope]: &[Integer; 4]) -> [Integer; 2] {
        let left = |bound: &Integer, [theta1, theta2]: &[Integer; 2]| {
            bound * &self.denominator - a1 * theta1 - a2 * theta2
        };
        [left(constant, &self.constant), left(slope, &self.slope)]
    }
}
