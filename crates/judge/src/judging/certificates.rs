//! Rays and Farkas multipliers.

use boundfit_exact::Rational;
use boundfit_lp::End;

use super::dual::{Price, leans_on};
use super::ground::objective_at;
use super::measure::Measured;
use super::primal::{items, roundings, values};
use super::{Aspect, Fault, Finding, Ground, Measure, Tolerances, value_at};
use crate::answer::{Item, Side};
use crate::certificate::sign_of;
use crate::solution::Solution;

impl Ground<'_> {
    pub(super) fn ray(&self, solution: &Solution, tolerances: &Tolerances) -> Option<Finding> {
        let given = solution.ray.as_ref()?;
        let line = given.first().map_or(solution.status_line, |given| given.line);
        let (ray, reaches) = (values(given), roundings(given, tolerances));
        let mut measure = Measure::new(tolerances);
        for (item, bounds) in items(self) {
            let change = value_at(self.model, item, &ray);
            let (end, bound) =
                if change.is_negative() { (End::Lower, &bounds.lower) } else { (End::Upper, &bounds.upper) };
            if bound.is_none() || change.is_zero() {
                continue;
            }
            measure.take(Measured {
                error: change.abs(),
                rounding: self.reach(item, &reaches),
                scale: self.along(item, &ray),
                line: self.line_of(item, given, &ray).unwrap_or(line),
                fault: Fault::Leaves { side: Side { item, end }, change },
                excuse: None,
            });
        }
        let gain = (objective_at(self.model, &ray) - &self.model.constant) * sign_of(self.model.sense);
        if !gain.is_negative() {
            // No tolerance makes a direction improve that does not.
            measure.take(Measured {
                error: gain.abs().max(Rational::one()),
                rounding: Rational::zero(),
                scale: Rational::zero(),
                line,
                fault: Fault::DoesNotImprove { change: gain },
                excuse: None,
            });
        }
        Some(measure.finding(Aspect::Ray, line))
    }

    /// The sum of the sizes of a row's terms along a direction; of a column the largest entry of the direction.
    fn along(&self, item: Item, ray: &[Rational]) -> Rational {
        match item {
            Item::Column(_) => ray.iter().map(Rational::abs).max().unwrap_or_else(Rational::one),
            Item::Row(_) => self.reach(item, &ray.iter().map(Rational::abs).collect::<Vec<_>>()),
        }
    }

    pub(super) fn farkas(&self, solution: &Solution, tolerances: &Tolerances) -> Option<Finding> {
        let given = solution.farkas.as_ref()?;
        let line = given.first().map_or(solution.status_line, |given| given.line);
        let none = self.model.columns.iter().map(|_| Rational::zero());
        let left = self.left_of(none, given, tolerances, line);
        let rows = given.iter().zip(roundings(given, tolerances)).map(|(given, rounding)| Price {
            value: given.number.value.clone(),
            rounding,
            line: given.line,
        });
        let sizes = self.farkas_sizes(&values(given));
        let mut measure = Measure::new(tolerances);
        let (mut total, mut explained) = (Rational::zero(), Rational::zero());
        for (((item, bounds), price), scale) in items(self).zip(rows.chain(left)).zip(sizes) {
            let (end, bound) = leans_on(bounds, &price.value);
            match bound {
                Some(bound) => {
                    total = total + &price.value * bound;
                    explained = explained + bound.abs() * price.rounding;
                }
                None if price.value.is_zero() => {}
                None => measure.take(Measured {
                    error: price.value.abs(),
                    rounding: price.rounding,
                    scale,
                    line: price.line,
                    fault: Fault::NoSuchBound { side: Side { item, end }, price: price.value },
                    excuse: None,
                }),
            }
        }
        if !total.is_positive() {
            // Rounding may turn a contradiction into none, but never proves one.
            measure.take(Measured {
                error: total.abs().max(explained).max(Rational::one()),
                rounding: Rational::zero(),
                scale: Rational::zero(),
                line,
                fault: Fault::NoContradiction { total },
                excuse: None,
            });
        }
        Some(measure.finding(Aspect::Farkas, line))
    }

    /// Returns the measures of multipliers that lean on no bound. A column has the sum of the sizes of what rows put there, a row
    /// the largest multiplier.
    fn farkas_sizes(&self, multipliers: &[Rational]) -> Vec<Rational> {
        let mut columns = vec![Rational::zero(); self.model.columns.len()];
        for (row, multiplier) in self.model.rows.iter().zip(multipliers) {
            for (column, value) in &row.coefficients {
                if let Some(sum) = columns.get_mut(*column) {
                    *sum = &*sum + (value * multiplier).abs();
                }
            }
        }
        let largest = multipliers.iter().map(Rational::abs).max().unwrap_or_else(Rational::one);
        self.model.rows.iter().map(|_| largest.clone()).chain(columns).collect()
    }
}
