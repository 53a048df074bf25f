//! The half-planes of a fit as functions of the factor s.

use boundfit_exact::{Integer, Rational};
use boundfit_geometry::{Inequality, Multiplier, Polyhedron, System};

use super::functions::Linear;
use super::section::Section;
use crate::bound_name::BoundName;
use crate::fps::{conditions_by_name, growing_half_planes};
use crate::hulls::touching_a_hull;
use crate::least_growth::GrowingInequality;
use crate::measurement::Measurement;
use crate::problem::Problem;
use crate::ties::{ActiveBounds, TiedReading, Ties};

/// Half-planes a·θ ≤ b(s) with their names: the bounds of the readings move, conditions stay.
#[derive(Default)]
pub(super) struct GrowingSystem {
    names: Vec<BoundName>,
    forms: Vec<[Rational; 2]>,
    bounds: Vec<Linear>,
    /// The form, and the constant and the slope of the bound, as integers with a common positive factor.
    scaled: Vec<[Integer; 4]>,
    speeds: Vec<[Rational; 2]>,
    ties: Ties,
}

impl GrowingSystem {
    pub(super) fn new(problem: &Problem) -> Self {
        let mut system = GrowingSystem::default();
        let known = problem.measurements.ties().cloned().unwrap_or_default();
        let tied = |row: &Measurement| TiedReading { reading: row.clone(), rows: known.of(row.row) };
        let mut rows: Vec<TiedReading> = problem.measurements.kept().iter().map(tied).collect();
        if problem.measurements.has_hulls() {
            rows = touching_a_hull(rows, usize::MAX, true);
        }
        let (rows, ties) = TiedReading::by_row(rows);
        system.ties = ties;
        for row in &rows {
            for (name, GrowingInequality { at_zero, growth }) in growing_half_planes(row) {
                system.push(name, at_zero, growth);
            }
        }
        for (name, inequality) in conditions_by_name(&problem.conditions) {
            system.push(name, inequality, Rational::zero());
        }
        system
    }

    fn push(&mut self, name: BoundName, at_zero: Inequality, slope: Rational) {
        let [a1, a2] = &at_zero.a;
        self.scaled.push(Rational::over_common_denominator([a1, a2, &at_zero.b, &slope]).0);
        // The boundary runs along (-a2, a1).
        self.speeds.push(match slope.checked_div(a2) {
            Some(quotient) => [-quotient, Rational::zero()],
            None => [Rational::zero(), slope.checked_div(a1).unwrap_or_default()],
        });
        self.names.push(name);
        self.forms.push(at_zero.a);
        self.bounds.push(Linear { constant: at_zero.b, slope });
    }

    pub(super) fn form(&self, index: usize) -> &[Rational; 2] {
        &self.forms[index]
    }

    /// The right-hand side of a half-plane.
    pub(super) fn bound(&self, index: usize) -> &Linear {
        &self.bounds[index]
    }

    /// A multiple of a half-plane: the coefficients of its form, and the constant and the slope of its right-hand side.
    pub(super) fn scaled(&self, index: usize) -> &[Integer; 4] {
        &self.scaled[index]
    }

    /// The growth of the bound over a coefficient of the form, for the change of either coordinate along the boundary.
    pub(super) fn speed(&self, index: usize) -> &[Rational; 2] {
        &self.speeds[index]
    }

    pub(super) fn len(&self) -> usize {
        self.names.len()
    }

    /// The right-hand side of a combination of half-planes.
    pub(super) fn combined(&self, multipliers: &[Multiplier]) -> Linear {
        multipliers
            .iter()
            .map(|multiplier| self.bounds[multiplier.index].times(&multiplier.value))
            .fold(Linear::default(), |total, term| &total + &term)
    }

    /// Names of half-planes, sorted.
    pub(super) fn named(&self, indices: &[usize]) -> Vec<BoundName> {
        let mut names: Vec<BoundName> = indices.iter().map(|&index| self.names[index]).collect();
        names.sort_unstable();
        names
    }

    /// The bounds that are active where half-planes are, those that they stand for included.
    pub(super) fn active(&self, indices: &[usize]) -> ActiveBounds {
        self.ties.active(indices.iter().map(|&index| self.names[index]), usize::MAX)
    }

    /// The set at a factor.
    pub(super) fn polyhedron(&self, s: &Rational) -> Polyhedron {
        let at = |(form, bound): (&[Rational; 2], &Linear)| {
            let [a1, a2] = form.clone();
            Inequality::new(a1, a2, bound.at(s))
        };
        Polyhedron::intersect(self.forms.iter().zip(&self.bounds).map(at).collect::<System>())
    }

    pub(super) fn section(&self, s: &Rational) -> Section {
        Section::of(&self.polyhedron(s), |indices| self.active(indices))
    }
}
