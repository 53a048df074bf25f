//! Prices: duals and reduced costs.

use boundfit_exact::Rational;
use boundfit_lp::{Bounds, End};

use super::ground::objective_at;
use super::measure::Measured;
use super::primal::{items, roundings, values};
use super::{Aspect, Excuse, Fault, Finding, Ground, Measure, Tolerances, Worth, value_at};
use crate::answer::{Item, Side};
use crate::certificate::sign_of;
use crate::solution::{Given, Solution};

/// The price of a row, as given, or of a column, as the duals leave it, with what rounding explains of it.
pub(super) struct Price {
    pub(super) value: Rational,
    pub(super) rounding: Rational,
    pub(super) line: usize,
}

/// The bound that a price leans on.
pub(super) fn leans_on<'a>(bounds: &'a Bounds, times: &Rational) -> (End, Option<&'a Rational>) {
    if times.is_negative() {
        (End::Upper, bounds.upper.as_ref())
    } else {
        (End::Lower, bounds.lower.as_ref())
    }
}

/// The solution with the opposite sign of each dual and reduced cost.
fn with_negated_prices(solution: &Solution) -> Solution {
    let mut negated = solution.clone();
    let duals = negated.duals.iter_mut().flatten();
    for price in duals.chain(negated.reduced_costs.iter_mut().flatten().flatten()) {
        price.number.value = -&price.number.value;
    }
    negated
}

impl Ground<'_> {
    /// Multiplies rows out: what they leave of `costs`, by column.
    pub(super) fn left_of(
        &self,
        costs: impl Iterator<Item = Rational>,
        duals: &[Given],
        tolerances: &Tolerances,
        line: usize,
    ) -> Vec<Price> {
        let price = |value| Price { value, rounding: Rational::zero(), line };
        let mut left: Vec<Price> = costs.map(price).collect();
        let rows = self.model.rows.iter().zip(duals.iter().zip(roundings(duals, tolerances)));
        for (row, (dual, rounding)) in rows {
            for (column, value) in &row.coefficients {
                if let Some(own) = left.get_mut(*column) {
                    own.value = &own.value - value * &dual.number.value;
                    own.rounding = &own.rounding + value.abs() * &rounding;
                    own.line = dual.line;
                }
            }
        }
        left
    }

    /// Returns what is found about duals and reduced costs; nothing where the solution has none.
    pub(super) fn prices(&self, solution: &Solution, tolerances: &Tolerances) -> [Option<Finding>; 3] {
        let mut found = self.prices_as_given(solution, tolerances);
        let is_refuted = |own: &Option<Finding>| own.as_ref().is_some_and(|own| own.worth == Worth::Refuted);
        if found.iter().any(is_refuted)
            && !self.prices_as_given(&with_negated_prices(solution), tolerances).iter().any(is_refuted)
        {
            for own in found.iter_mut().flatten() {
                own.is_negated = own.worth == Worth::Refuted;
            }
        }
        found
    }

    fn prices_as_given(&self, solution: &Solution, tolerances: &Tolerances) -> [Option<Finding>; 3] {
        let Some(duals) = &solution.duals else { return [None, None, None] };
        let costs = self.model.columns.iter().map(|column| column.cost.clone());
        let left = self.left_of(costs, duals, tolerances, solution.status_line);
        let rows = duals.iter().zip(roundings(duals, tolerances)).map(|(dual, rounding)| Price {
            value: dual.number.value.clone(),
            rounding,
            line: dual.line,
        });
        let rows: Vec<Price> = rows.collect();
        let count = rows.len();
        let prices: Vec<Price> = rows.into_iter().chain(left).collect();
        let (_, left) = prices.split_at_checked(count).unwrap_or_default();
        let dual = self.dual(solution, tolerances, &prices, left);
        // Prices that lean on no bound prove nothing, and no point attains it.
        let point = solution.point.as_ref().filter(|_| self.all_lean_on_bounds(&prices, tolerances));
        let slackness = point.map(|point| self.slackness(solution, point, tolerances, &prices));
        let gap = point.map(|point| self.gap(solution, point, tolerances, &prices));
        [Some(dual), slackness, gap]
    }

    fn all_lean_on_bounds(&self, prices: &[Price], tolerances: &Tolerances) -> bool {
        let sign = sign_of(self.model.sense);
        items(self).zip(prices).all(|((item, bounds), price)| {
            self.is_small(item, price, tolerances) || leans_on(bounds, &(&price.value * &sign)).1.is_some()
        })
    }

    /// Returns whether a price is next to nothing.
    fn is_small(&self, item: Item, price: &Price, tolerances: &Tolerances) -> bool {
        let size = price.value.abs();
        size <= price.rounding
            || size.checked_div(&self.price_scale(item)).is_some_and(|part| part <= tolerances.relative)
    }

    /// Reduced costs are what the duals leave.
    fn reduced_costs(
        &self,
        solution: &Solution,
        tolerances: &Tolerances,
        left: &[Price],
        measure: &mut Measure<'_>,
    ) {
        let given = solution.reduced_costs.iter().flatten();
        for (column, (given, left)) in given.zip(left).enumerate() {
            let Some(given) = given else { continue };
            let claimed = given.number.value.clone();
            let error = (&claimed - &left.value).abs();
            measure.take(Measured {
                rounding: super::measure::rounding(&given.number, tolerances) + &left.rounding,
                scale: self.cost_scale(column),
                line: given.line,
                excuse: Some(self.dual_excuse(Item::Column(column), &error)),
                fault: Fault::ReducedCost { column, claimed, exact: left.value.clone() },
                error,
            });
        }
    }

    fn dual(
        &self,
        solution: &Solution,
        tolerances: &Tolerances,
        prices: &[Price],
        left: &[Price],
    ) -> Finding {
        let mut measure = Measure::new(tolerances);
        let sign = sign_of(self.model.sense);
        for ((item, bounds), price) in items(self).zip(prices) {
            if price.value.is_zero() {
                continue;
            }
            let (end, bound) = leans_on(bounds, &(&price.value * &sign));
            if bound.is_none() {
                let error = price.value.abs();
                measure.take(Measured {
                    rounding: price.rounding.clone(),
                    scale: self.price_scale(item),
                    line: price.line,
                    excuse: Some(self.dual_excuse(item, &error)),
                    fault: Fault::NoSuchBound { side: Side { item, end }, price: price.value.clone() },
                    error,
                });
            }
        }
        self.reduced_costs(solution, tolerances, left, &mut measure);
        let line = solution.duals.iter().flatten().map(|dual| dual.line).next();
        measure.finding(Aspect::Dual, line.unwrap_or(solution.status_line))
    }

    fn dual_excuse(&self, item: Item, error: &Rational) -> Excuse {
        let cost = match item {
            Item::Column(column) => self.model.columns.get(column).map(|column| column.cost.abs()),
            Item::Row(_) => None,
        };
        let size = cost.unwrap_or_default().max(Rational::one());
        Excuse {
            absolute: error.clone(),
            relative: error.checked_div(&size).unwrap_or_default(),
            scaled: error * self.largest_coefficient(item),
        }
    }

    /// A price and a distance from its bound must not both be there.
    fn slackness(
        &self,
        solution: &Solution,
        given: &[Given],
        tolerances: &Tolerances,
        prices: &[Price],
    ) -> Finding {
        let sign = sign_of(self.model.sense);
        let (point, reaches) = (values(given), roundings(given, tolerances));
        let mut measure = Measure::new(tolerances);
        for ((item, bounds), price) in items(self).zip(prices) {
            let (end, Some(bound)) = leans_on(bounds, &(&price.value * &sign)) else { continue };
            let slack = (value_at(self.model, item, &point) - bound).abs();
            if price.value.is_zero() || slack.is_zero() {
                continue;
            }
            let side = Side { item, end };
            let in_scale = price.value.abs().checked_div(&self.price_scale(item)).unwrap_or_default();
            let away = slack.checked_div(&self.scale_of(side, bound)).unwrap_or_default();
            // Rounding explains a product of which it explains one factor.
            let explained = price.value.abs() <= price.rounding || slack <= self.reach(item, &reaches);
            let error = in_scale.min(away);
            measure.take(Measured {
                rounding: if explained { error.clone() } else { Rational::zero() },
                error,
                scale: Rational::one(),
                line: price.line,
                fault: Fault::Slack { side, price: price.value.clone(), slack },
                excuse: None,
            });
        }
        measure.finding(Aspect::ComplementarySlackness, solution.status_line)
    }

    /// The objective at the point, less what the prices prove of it.
    fn gap(
        &self,
        solution: &Solution,
        given: &[Given],
        tolerances: &Tolerances,
        prices: &[Price],
    ) -> Finding {
        let sign = sign_of(self.model.sense);
        let (point, reaches) = (values(given), roundings(given, tolerances));
        let mut gap = Rational::zero();
        let mut explained = Rational::zero();
        for ((item, bounds), price) in items(self).zip(prices) {
            let value = value_at(self.model, item, &point);
            let size = price.value.abs();
            let is_small = self.is_small(item, price, tolerances);
            let (_, own) = leans_on(bounds, &(&price.value * &sign));
            // A price that is next to nothing leans on the bound that is next to the point, if any.
            let both = [bounds.lower.as_ref(), bounds.upper.as_ref()];
            let nearest = both.into_iter().flatten().min_by_key(|bound| (*bound - &value).abs());
            let Some(bound) = (if is_small { nearest } else { own }) else { continue };
            let slack = &value - bound;
            explained = explained + &size * self.reach(item, &reaches) + slack.abs() * &price.rounding;
            gap = gap + &price.value * slack;
        }
        let claimed = objective_at(self.model, &point);
        let mut measure = Measure::new(tolerances);
        measure.take(Measured {
            error: gap.abs(),
            rounding: explained,
            scale: self.objective_scale(),
            line: solution.status_line,
            fault: Fault::Value { exact: &claimed - gap, claimed, answers: None },
            excuse: None,
        });
        measure.finding(Aspect::DualityGap, solution.status_line)
    }
}
