//! A system of linear inequalities: the input of both intersection algorithms.

use std::borrow::Cow;
use std::ops::Range;
use std::sync::OnceLock;

use boundfit_exact::{Fraction, Integer, Rational, Work};

use crate::half_plane::{Constraint, HalfPlane, Inequality};

/// Linear inequalities in a fixed order. Their indices, from 0, name them everywhere: in the active sets of
/// vertices, in proofs and in reasons for redundancy.
#[derive(Debug, Clone, Default)]
pub struct System {
    constraints: Vec<Constraint>,
    /// The number of constraints, the first ones, whose inequalities follow from them: `a2` is 1 or -1 there.
    lines: usize,
    /// The inequalities of the others.
    given: Vec<Inequality>,
    /// All inequalities, once somebody has asked for them, where there are lines.
    all: OnceLock<Vec<Inequality>>,
}

impl PartialEq for System {
    fn eq(&self, other: &Self) -> bool {
        self.constraints == other.constraints && self.inequalities() == other.inequalities()
    }
}

impl Eq for System {}

impl System {
    /// A system of the given inequalities.
    pub fn new(inequalities: impl IntoIterator<Item = Inequality>) -> Self {
        let given: Vec<Inequality> = inequalities.into_iter().collect();
        let constraints = given.iter().map(Inequality::constraint).collect();
        System { constraints, given, ..System::default() }
    }

    /// A system of half-planes whose inequalities have 1 or -1 for `a2`, and of other inequalities behind them. The
    /// former take memory only when somebody asks for all inequalities.
    pub fn of_lines(
        lines: impl IntoIterator<Item = HalfPlane>,
        others: impl IntoIterator<Item = Inequality>,
    ) -> Self {
        let mut constraints: Vec<Constraint> = lines.into_iter().map(Constraint::HalfPlane).collect();
        let (lines, given) = (constraints.len(), Vec::from_iter(others));
        constraints.extend(given.iter().map(Inequality::constraint));
        System { constraints, lines, given, all: OnceLock::new() }
    }

    /// Adds an inequality and returns its index.
    pub fn push(&mut self, inequality: Inequality) -> usize {
        self.constraints.push(inequality.constraint());
        self.given.push(inequality);
        self.all.take();
        self.len() - 1
    }

    /// The system without some that follow each other; those behind them move up.
    ///
    /// # Panics
    /// When an index is out of range.
    pub fn without(&self, indices: Range<usize>) -> Self {
        let (mut given, mut constraints) = (self.inequalities().to_vec(), self.constraints.clone());
        given.drain(indices.clone());
        constraints.drain(indices);
        System { constraints, given, ..System::default() }
    }

    /// The work that intersecting takes as far as numbers are long; rows are counted from 1. Cost: linear.
    pub fn work(&self) -> Work {
        let mut work = Work::default();
        for (row, Inequality { a, b }) in (1..).zip(self.inequalities()) {
            work.add(row, a.iter().chain([b]));
        }
        work
    }

    /// Number of inequalities.
    pub fn len(&self) -> usize {
        self.constraints.len()
    }

    /// Returns whether there is no inequality at all; the region is then the plane.
    pub fn is_empty(&self) -> bool {
        self.constraints.is_empty()
    }

    /// The inequalities as given. Cost: linear where they are made now.
    pub fn inequalities(&self) -> &[Inequality] {
        if self.lines == 0 {
            return &self.given;
        }
        self.all.get_or_init(|| (0..self.len()).map(|index| self.inequality(index).into_owned()).collect())
    }

    /// One of the inequalities as given.
    ///
    /// # Panics
    /// When the index is out of range.
    pub fn inequality(&self, index: usize) -> Cow<'_, Inequality> {
        match (index.checked_sub(self.lines), &self.constraints[index]) {
            (None, Constraint::HalfPlane(half_plane)) => Cow::Owned(Inequality::of_line(half_plane)),
            (place, _) => Cow::Borrowed(&self.given[place.unwrap_or_default()]),
        }
    }

    /// `b - a·θ` of one of the inequalities times `common`, at the point `theta / common`. Not in lowest terms: where numbers are
    /// long, the common divisors would cost more than comparing. Always there, as no denominator is 0.
    ///
    /// # Panics
    /// When the index is out of range.
    pub(crate) fn slack_over(
        &self,
        index: usize,
        theta: &[Integer; 2],
        common: &Integer,
    ) -> Option<Fraction> {
        let over = |[a1, a2, b]: &[Integer; 3], own: Integer| {
            Fraction::new(b * common - a1 * &theta[0] - a2 * &theta[1], own)
        };
        match (index.checked_sub(self.lines), &self.constraints[index]) {
            (None, Constraint::HalfPlane(line)) => {
                let triple = line.triple();
                over(&triple, triple[1].abs())
            }
            (place, _) => {
                let Inequality { a: [a1, a2], b } = &self.given[place.unwrap_or_default()];
                let (triple, own) = Rational::over_common_denominator([a1, a2, b]);
                over(&triple, own)
            }
        }
    }

    /// Returns the meaning of each inequality for the plane.
    pub fn constraints(&self) -> &[Constraint] {
        &self.constraints
    }

    /// The half-plane with this index, unless the inequality has a zero normal.
    ///
    /// # Panics
    /// When the index is out of range.
    pub fn half_plane(&self, index: usize) -> Option<&HalfPlane> {
        match &self.constraints[index] {
            Constraint::HalfPlane(half_plane) => Some(half_plane),
            Constraint::Always | Constraint::Never => None,
        }
    }

    /// The half-planes with their indices, in order.
    pub fn half_planes(&self) -> impl Iterator<Item = (usize, &HalfPlane)> + Clone {
        self.constraints.iter().enumerate().filter_map(|(index, constraint)| match constraint {
            Constraint::HalfPlane(half_plane) => Some((index, half_plane)),
            Constraint::Always | Constraint::Never => None,
        })
    }
}

impl FromIterator<Inequality> for System {
    fn from_iter<I: IntoIterator<Item = Inequality>>(inequalities: I) -> Self {
        System::new(inequalities)
    }
}

#[cfg(test)]
mod tests {
    use boundfit_exact::Rational;

    use super::*;

    #[test]
    fn inequalities_are_counted_from_0() {
        let mut system = System::default();
        assert_eq!((system.len(), system.is_empty()), (0, true));
        for index in 0..4 {
            let inequality = Inequality::new(1.into(), 0.into(), index.into());
            assert_eq!(system.push(inequality), index);
            assert_eq!((system.len(), system.is_empty()), (index + 1, false));
        }
        let kept = [&system.inequalities()[..1], &system.inequalities()[3..]].concat();
        assert_eq!(system.without(1..3), System::new(kept));
    }

    #[test]
    fn lines_are_the_inequalities_that_they_came_from() {
        let line = |x: Rational, side: i64, b: Rational| Inequality::new(x, side.into(), b);
        let ratio = Rational::ratio;
        let mut given = vec![
            line(ratio(1, 10), 1, ratio(-7, 30)),
            line(ratio(0, 1), -1, ratio(0, 1)),
            line(ratio(-25, 4), 1, ratio(1 << 40, 3)),
        ];
        let half_planes = given.iter().filter_map(|own| match own.constraint() {
            Constraint::HalfPlane(half_plane) => Some(half_plane),
            Constraint::Always | Constraint::Never => None,
        });
        let others = [line(ratio(2, 3), 0, ratio(5, 1)), line(ratio(0, 1), 0, ratio(-1, 1))];
        let mut system = System::of_lines(half_planes, others.clone());
        given.extend(others);
        for more in 0..3 {
            let expected = System::new(given.iter().cloned());
            assert_eq!((system.inequalities(), system.constraints()), (&given[..], expected.constraints()));
            for (index, own) in given.iter().enumerate() {
                assert_eq!(*system.inequality(index), *own);
            }
            assert_eq!(
                (&system, system.len(), system.without(1..3)),
                (&expected, given.len(), expected.without(1..3))
            );
            let another = line(ratio(3, 7), 2, ratio(more, 1));
            assert_eq!(system.push(another.clone()), given.len());
            given.push(another);
        }
    }
}
