//! A system of linear inequalities: the input of both intersection algorithms.

use std::ops::Range;

use boundfit_exact::Work;

use crate::half_plane::{Constraint, HalfPlane, Inequality};

/// Linear inequalities in a fixed order. Their indices, from 0, name them everywhere: in the active sets of
/// vertices, in proofs and in reasons for redundancy.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct System {
    inequalities: Vec<Inequality>,
    constraints: Vec<Constraint>,
}

impl System {
    /// A system of the given inequalities.
    pub fn new(inequalities: impl IntoIterator<Item = Inequality>) -> Self {
        let inequalities: Vec<Inequality> = inequalities.into_iter().collect();
        let constraints = inequalities.iter().map(Inequality::constraint).collect();
        System { inequalities, constraints }
    }

    /// Adds an inequality and returns its index.
    pub fn push(&mut self, inequality: Inequality) -> usize {
        self.constraints.push(inequality.constraint());
        self.inequalities.push(inequality);
        self.inequalities.len() - 1
    }

    /// The system without some that follow each other; those behind them move up.
    ///
    /// # Panics
    /// When an index is out of range.
    pub fn without(&self, indices: Range<usize>) -> Self {
        let mut rest = self.clone();
        rest.inequalities.drain(indices.clone());
        rest.constraints.drain(indices);
        rest
    }

    /// The work that intersecting takes as far as numbers are long; rows are counted from 1. Cost: linear.
    pub fn work(&self) -> Work {
        let mut work = Work::default();
        for (row, Inequality { a, b }) in (1..).zip(&self.inequalities) {
            work.add(row, a.iter().chain([b]));
        }
        work
    }

    /// Number of inequalities.
    pub fn len(&self) -> usize {
        self.inequalities.len()
    }

    /// Returns whether there is no inequality at all; the region is then the plane.
    pub fn is_empty(&self) -> bool {
        self.inequalities.is_empty()
    }

    /// The inequalities as given.
    pub fn inequalities(&self) -> &[Inequality] {
        &self.inequalities
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
    pub fn half_planes(&self) -> impl Iterator<Item = (usize, &HalfPlane)> {
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
}
