//! The objective and the point.

use boundfit_exact::Rational;
use boundfit_lp::{Bounds, End};

use super::ground::objective_at;
use super::measure::{Measured, rounding};
use super::{Aspect, Excuse, Fault, Finding, Ground, Measure, OtherProgram, Tolerances, value_at};
use crate::answer::{Answer, Item, Side};
use crate::solution::{Given, Solution};

/// Returns what every row and column may be: rows first.
pub(super) fn items<'a>(ground: &Ground<'a>) -> impl Iterator<Item = (Item, &'a Bounds)> {
    let rows = ground.model.rows.iter().enumerate().map(|(place, row)| (Item::Row(place), &row.bounds));
    let columns = ground.model.columns.iter().enumerate();
    rows.chain(columns.map(|(place, column)| (Item::Column(place), &column.bounds)))
}

/// The numbers alone.
pub(super) fn values(given: &[Given]) -> Vec<Rational> {
    given.iter().map(|given| given.number.value.clone()).collect()
}

/// Returns how far each number may be from the one that was meant.
pub(super) fn roundings(given: &[Given], tolerances: &Tolerances) -> Vec<Rational> {
    given.iter().map(|given| rounding(&given.number, tolerances)).collect()
}

impl Ground<'_> {
    pub(super) fn objective(&self, solution: &Solution, tolerances: &Tolerances) -> Option<Finding> {
        let Answer::Optimal { value, .. } = self.answer else { return None };
        let claimed = solution.objective.as_ref().filter(|_| self.claims_optimum(solution))?;
        let number = &claimed.number.value;
        let rounding = rounding(&claimed.number, tolerances);
        let constant = &self.model.constant;
        let other = value - constant - constant;
        let is_other = !constant.is_zero() && (number - other).abs() <= rounding;
        let answers = is_other.then_some(OtherProgram::OtherConstant);
        let mut measure = Measure::new(tolerances);
        measure.take(Measured {
            error: (number - value).abs(),
            scale: self.objective_scale(),
            line: claimed.line,
            fault: Fault::Value {
                claimed: number.clone(),
                exact: value.clone(),
                answers: answers.or_else(|| self.of_opposite_sense(number, &rounding)),
            },
            rounding,
            excuse: None,
        });
        Some(measure.finding(Aspect::Objective, claimed.line))
    }

    /// Returns whether a number is the optimum of the opposite sense.
    fn of_opposite_sense(&self, value: &Rational, rounding: &Rational) -> Option<OtherProgram> {
        let opposite = self.opposite.as_ref()?;
        ((value - opposite).abs() <= *rounding).then_some(OtherProgram::OppositeSense)
    }

    fn claims_optimum(&self, solution: &Solution) -> bool {
        solution.status == crate::solution::SolverStatus::Optimal
    }

    /// Returns how much of a row's or column's value rounding explains.
    pub(super) fn reach(&self, item: Item, roundings: &[Rational]) -> Rational {
        match item {
            Item::Column(column) => roundings.get(column).cloned().unwrap_or_default(),
            Item::Row(row) => {
                let coefficients = self.model.rows.get(row).into_iter().flat_map(|row| &row.coefficients);
                let parts =
                    coefficients.filter_map(|(column, value)| Some(value.abs() * roundings.get(*column)?));
                parts.fold(Rational::zero(), |sum, part| sum + part)
            }
        }
    }

    pub(super) fn primal(&self, solution: &Solution, tolerances: &Tolerances) -> Option<Finding> {
        let given = solution.point.as_ref()?;
        let (point, roundings) = (values(given), roundings(given, tolerances));
        let mut measure = Measure::new(tolerances);
        for (item, bounds) in items(self) {
            let value = value_at(self.model, item, &point);
            let sides = [(End::Lower, &bounds.lower), (End::Upper, &bounds.upper)];
            for (end, bound) in sides {
                let Some(bound) = bound else { continue };
                let error = if end == End::Lower { bound - &value } else { &value - bound };
                if !error.is_positive() {
                    continue;
                }
                let side = Side { item, end };
                measure.take(Measured {
                    rounding: self.reach(item, &roundings),
                    scale: self.scale_of(side, bound),
                    line: self.line_of(item, given, &point).unwrap_or(solution.status_line),
                    excuse: Some(self.primal_excuse(item, &error, &value, bound)),
                    fault: Fault::Beyond { side, bound: bound.clone(), value: value.clone() },
                    error,
                });
            }
        }
        Some(measure.finding(Aspect::Primal, solution.status_line))
    }

    fn primal_excuse(&self, item: Item, error: &Rational, value: &Rational, bound: &Rational) -> Excuse {
        let size = Rational::one().max(value.abs()).max(bound.abs());
        Excuse {
            absolute: error.clone(),
            relative: error.checked_div(&size).unwrap_or_default(),
            scaled: error.checked_div(&self.largest_coefficient(item)).unwrap_or_else(|| error.clone()),
        }
    }

    /// The largest coefficient of a row; 1 of a column, and of a row without any.
    pub(super) fn largest_coefficient(&self, item: Item) -> Rational {
        let Item::Row(row) = item else { return Rational::one() };
        let coefficients = self.model.rows.get(row).into_iter().flat_map(|row| &row.coefficients);
        coefficients.map(|(_, value)| value.abs()).max().unwrap_or_else(Rational::one)
    }

    /// The line of a column, and of a row that of the column with the largest term in it.
    pub(super) fn line_of(&self, item: Item, given: &[Given], point: &[Rational]) -> Option<usize> {
        let column = match item {
            Item::Column(column) => column,
            Item::Row(row) => {
                let coefficients = self.model.rows.get(row)?.coefficients.iter();
                let term =
                    |(column, value): &&(usize, Rational)| point.get(*column).map(|own| (value * own).abs());
                coefficients.max_by_key(term)?.0
            }
        };
        given.get(column).map(|given| given.line)
    }

    pub(super) fn optimality(&self, solution: &Solution, tolerances: &Tolerances) -> Option<Finding> {
        let Answer::Optimal { value, .. } = self.answer else { return None };
        let given = solution.point.as_ref()?;
        let (point, roundings) = (values(given), roundings(given, tolerances));
        let claimed = objective_at(self.model, &point);
        let costs = self.model.columns.iter().zip(&roundings);
        let rounding = costs.fold(Rational::zero(), |sum, (column, own)| sum + column.cost.abs() * own);
        let answers = self.of_opposite_sense(&claimed, &rounding);
        let line = given.first().map_or(solution.status_line, |given| given.line);
        let mut measure = Measure::new(tolerances);
        measure.take(Measured {
            error: (&claimed - value).abs(),
            rounding,
            scale: self.objective_scale(),
            line,
            fault: Fault::Value { claimed, exact: value.clone(), answers },
            excuse: None,
        });
        Some(measure.finding(Aspect::Optimality, line))
    }
}
