//! The measures of errors.

use boundfit_exact::Rational;
use boundfit_lp::{Model, ModelRow, ObjectiveSense};

use crate::answer::{Answer, Item, Side};
use crate::certificate::value_of;

/// A model with its exact answer, and what errors about it are measured by:
///
/// - of a row or bound: the larger of the violated bound and the sum of the sizes of the row's terms at the optimum. A column
///   that is 0 there counts as large as the smallest row that it is in lets it be;
/// - of the objective: the sum of the sizes of its terms at the optimum, or how much it varies over the feasible set where that
///   is less and not 0. Its constant is no term;
/// - of a reduced cost: the larger of the column's cost and the sum of the sizes of the terms that the exact duals
///   take from it. A dual has the size of its contribution to these.
#[derive(Debug, Clone)]
pub struct Ground<'a> {
    pub(super) model: &'a Model,
    pub(super) answer: &'a Answer,
    /// The measure of each column's value.
    columns: Vec<Rational>,
    /// The measure of each column's reduced cost.
    costs: Vec<Rational>,
    /// The measure of the objective.
    objective: Rational,
    /// The optimum of the opposite sense, if there is one.
    pub(super) opposite: Option<Rational>,
}

impl<'a> Ground<'a> {
    /// Finds what errors are measured by. Exact. Cost: that of solving the model for the opposite objective, and a pass over
    /// the coefficients.
    pub fn new(model: &'a Model, answer: &'a Answer) -> Self {
        let columns = column_sizes(model, answer);
        let costs = cost_sizes(model, answer);
        let terms = objective_terms(model, answer);
        let opposite = opposite_optimum(model, answer);
        let range = match (answer, &opposite) {
            (Answer::Optimal { value, .. }, Some(other)) => Some((other - value).abs()),
            _ => None,
        };
        let range = range.filter(|range| range.is_positive() && (*range < terms || terms.is_zero()));
        let objective = range.or(Some(terms).filter(Rational::is_positive)).unwrap_or_else(Rational::one);
        Ground { model, answer, columns, costs, objective, opposite }
    }

    /// The measure of the objective.
    pub(super) fn objective_scale(&self) -> Rational {
        self.objective.clone()
    }

    /// The measure of a bound of a row or a column.
    pub(super) fn scale_of(&self, side: Side, bound: &Rational) -> Rational {
        let terms = match side.item {
            Item::Row(row) => self.model.rows.get(row).map(|row| self.terms(row)).unwrap_or_default(),
            Item::Column(column) => self.columns.get(column).cloned().unwrap_or_default(),
        };
        Some(terms.max(bound.abs())).filter(Rational::is_positive).unwrap_or_else(Rational::one)
    }

    fn terms(&self, row: &ModelRow) -> Rational {
        let size = |(column, value): &(usize, Rational)| Some((value * self.columns.get(*column)?).abs());
        row.coefficients.iter().filter_map(size).fold(Rational::zero(), |sum, term| sum + term)
    }

    /// The measure of a column's reduced cost.
    pub(super) fn cost_scale(&self, column: usize) -> Rational {
        self.costs.get(column).cloned().unwrap_or_else(Rational::one)
    }

    /// The measure of a price of a row or column.
    pub(super) fn price_scale(&self, item: Item) -> Rational {
        let row = match item {
            Item::Column(column) => return self.cost_scale(column),
            Item::Row(row) => self.model.rows.get(row),
        };
        let coefficients = row.iter().flat_map(|row| &row.coefficients);
        let scales =
            coefficients.filter_map(|(column, value)| self.cost_scale(*column).checked_div(&value.abs()));
        scales.min().unwrap_or_else(Rational::one)
    }
}

/// Returns how large each column is at the optimum; where it is 0, or there is no optimum, as large as its rows let it be.
fn column_sizes(model: &Model, answer: &Answer) -> Vec<Rational> {
    let points: Vec<&Vec<Rational>> = match answer {
        Answer::Optimal { face, .. } => face.vertices.iter().chain(&face.points).collect(),
        Answer::Unbounded { point, .. } => vec![point],
        Answer::Infeasible { .. } => Vec::new(),
    };
    let mut allowed: Vec<Option<Rational>> = vec![None; model.columns.len()];
    for row in &model.rows {
        let bounds = [&row.bounds.lower, &row.bounds.upper].into_iter().flatten();
        let Some(bound) = bounds.map(Rational::abs).max().filter(Rational::is_positive) else { continue };
        for (column, value) in &row.coefficients {
            let size = bound.checked_div(&value.abs());
            if let Some(slot) = allowed.get_mut(*column) {
                *slot = slot.take().into_iter().chain(size).min();
            }
        }
    }
    let own = |(place, column): (usize, &boundfit_lp::ModelColumn)| {
        let at_optimum = points.iter().filter_map(|point| point.get(place)).map(Rational::abs).max();
        let bounds = [&column.bounds.lower, &column.bounds.upper].into_iter().flatten().map(Rational::abs);
        let bounds = bounds.filter(Rational::is_positive).min();
        let allowed = allowed.get(place).cloned().flatten();
        at_optimum.filter(Rational::is_positive).or_else(|| allowed.into_iter().chain(bounds).min())
    };
    let sizes: Vec<Option<Rational>> = model.columns.iter().enumerate().map(own).collect();
    let largest = sizes.iter().flatten().max().cloned().unwrap_or_else(Rational::one);
    sizes.into_iter().map(|size| size.unwrap_or_else(|| largest.clone())).collect()
}

/// Returns how large the terms of each column's reduced cost are.
fn cost_sizes(model: &Model, answer: &Answer) -> Vec<Rational> {
    let mut sums = vec![Rational::zero(); model.columns.len()];
    if let Answer::Optimal { prices, .. } = answer {
        for (row, price) in model.rows.iter().zip(&prices.rows).filter(|(_, price)| !price.is_zero()) {
            for (column, value) in &row.coefficients {
                if let Some(sum) = sums.get_mut(*column) {
                    *sum = &*sum + (value * price).abs();
                }
            }
        }
    }
    let own = model.columns.iter().zip(sums).map(|(column, sum)| sum.max(column.cost.abs()));
    let own: Vec<Rational> = own.collect();
    let largest = own.iter().max().filter(|size| size.is_positive()).cloned().unwrap_or_else(Rational::one);
    own.into_iter().map(|size| if size.is_zero() { largest.clone() } else { size }).collect()
}

/// The sum of the sizes of the objective's terms at the optimum, the largest of all optimal vertices.
fn objective_terms(model: &Model, answer: &Answer) -> Rational {
    let Answer::Optimal { face, .. } = answer else { return Rational::zero() };
    let at = |point: &Vec<Rational>| {
        let terms = model.columns.iter().zip(point).map(|(column, value)| (&column.cost * value).abs());
        terms.fold(Rational::zero(), |sum, term| sum + term)
    };
    face.vertices.iter().chain(&face.points).map(at).max().unwrap_or_default()
}

/// Returns the optimum of the opposite sense, where both are finite.
fn opposite_optimum(model: &Model, answer: &Answer) -> Option<Rational> {
    let Answer::Optimal { .. } = answer else { return None };
    let sense = match model.sense {
        ObjectiveSense::Minimize => ObjectiveSense::Maximize,
        ObjectiveSense::Maximize => ObjectiveSense::Minimize,
    };
    match Answer::of(&Model { sense, ..model.clone() }).ok()? {
        Answer::Optimal { value, .. } => Some(value),
        _ => None,
    }
}

/// The objective at a point.
pub(super) fn objective_at(model: &Model, point: &[Rational]) -> Rational {
    value_of(model, point)
}
