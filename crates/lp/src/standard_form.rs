//! The revised simplex method in exact arithmetic, for programs with two equations and many columns:
//! `min cost·λ` subject to `Σ λ_k·column_k = target`, `λ ≥ 0`.
//!
//! Bland's rule (1977): of the columns that improve, the first in a fixed order enters; of those that block, the
//! first leaves. It cannot cycle, not even on a zero target, where both basic values stay 0. Any fixed order will do.
//! One that leaps through the columns ([`LeapingOrder`]) meets the columns that matter early, where an order sorted
//! by slope would creep from each to its neighbour.
//!
//! Before that rule a number of pivots take the column that improves most (Dantzig 1963), as binary64 numbers see it:
//! that finds the optimum in few passes over many columns. The choice of the entering column is a matter of speed
//! alone. An exact decision, or a binary64 value beyond the proved bound of its error, tells that a column improves,
//! and that none does.

use boundfit_exact::{Integer, Rational};

/// The number of pivots that take the column that improves most before Bland's rule, which alone cannot cycle, takes
/// over.
const STEEPEST_PIVOTS: usize = 100;

/// A column with its cost, times a positive integer that makes everything whole. Scaling a column scales its λ only.
#[derive(Debug, Clone)]
pub(crate) struct Column {
    entries: [Integer; 2],
    cost: Integer,
    /// The factor.
    scale: Integer,
    /// Entries and cost, each rounded to the nearest double.
    rounded: [f64; 3],
    /// The factor, rounded.
    rounded_scale: f64,
}

impl Column {
    /// A column of fractions with its cost.
    pub(crate) fn new([first, second]: [&Rational; 2], cost: &Rational) -> Self {
        let ([first, second, cost], scale) = Rational::over_common_denominator([first, second, cost]);
        let rounded = [&first, &second, &cost].map(rounded);
        let rounded_scale = self::rounded(&scale);
        Column { entries: [first, second], cost, scale, rounded, rounded_scale }
    }
}

/// An integer as the nearest double; infinite where it is too large for one.
fn rounded(integer: &Integer) -> f64 {
    Rational::from(integer).to_f64()
}

/// The end of the method.
#[derive(Debug)]
pub(crate) enum Ending {
    /// Optimal: the basic columns with their λ (of the unscaled columns), and the prices.
    Optimal { basis: Vec<(usize, Rational)>, prices: [Rational; 2] },
    /// The target is out of reach: `prices·column ≤ 0` for all columns, `prices·target > 0`.
    OutOfReach { prices: [Rational; 2] },
    /// The cost falls without end along this combination of columns, whose sum is 0.
    Unbounded { combination: Vec<(usize, Rational)> },
}

/// A basic variable: a column of the program or the artificial unit column of an equation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Basic {
    Column(usize),
    Artificial(usize),
}

/// The costs that count.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Phase {
    /// Artificial columns cost 1, others nothing.
    Reach,
    /// The program's own costs; artificial columns stay at 0.
    Cost,
}

/// Solves the program. Exact; it always ends.
#[allow(clippy::indexing_slicing, reason = "rows are 0 or 1 of arrays of two")]
pub(crate) fn solve(columns: &[Column], target: &[Rational; 2]) -> Ending {
    let mut tableau = Tableau::new(columns, target);
    // The first phase is bounded below by 0, so that it ends in an optimum.
    tableau.run(Phase::Reach);
    if tableau.artificial_rows().any(|row| tableau.values[row].is_positive()) {
        return Ending::OutOfReach { prices: tableau.prices(Phase::Reach) };
    }
    match tableau.run(Phase::Cost) {
        Some(combination) => Ending::Unbounded { combination },
        None => Ending::Optimal { basis: tableau.basic_columns(), prices: tableau.prices(Phase::Cost) },
    }
}

/// The order `0, step, 2·step, …` modulo the count: with a step near the golden section of the count, every stretch of it
/// is spread evenly over all columns.
#[derive(Debug, Clone, Copy)]
struct LeapingOrder {
    count: usize,
    step: usize,
}

impl LeapingOrder {
    fn new(count: usize) -> Self {
        let coprime = |step: &usize| Integer::from(*step).gcd(&Integer::from(count)) == Integer::one();
        // 1597 / 2584 is a convergent of the golden section; 1 is coprime with everything.
        let golden = (count as u128 * 1597 / 2584) as usize;
        let step = (golden..count).find(coprime).unwrap_or(1);
        LeapingOrder { count, step }
    }

    /// Column numbers in this order.
    fn columns(self) -> impl Iterator<Item = usize> {
        let mut column = 0;
        (0..self.count).map(move |_| {
            let current = column;
            column = (column + self.step) % self.count;
            current
        })
    }
}

struct Tableau<'a> {
    columns: &'a [Column],
    order: LeapingOrder,
    basis: [Basic; 2],
    /// Inverse of the matrix of basic columns.
    inverse: [[Rational; 2]; 2],
    /// λ of the basic columns.
    values: [Rational; 2],
}

/// The prices of a basis, over one denominator, and rounded.
struct Pricing {
    prices: [Integer; 2],
    /// The weight of the costs: the denominator, or 0 where they do not count.
    weight: Integer,
    /// Prices and weight, each rounded to the nearest double.
    rounded: [f64; 3],
}

impl Pricing {
    fn new(prices: [Rational; 2], phase: Phase) -> Self {
        let (prices, denominator) = Rational::over_common_denominator(prices.each_ref());
        let weight = if phase == Phase::Cost { denominator } else { Integer::zero() };
        let rounded = [&prices[0], &prices[1], &weight].map(rounded);
        Pricing { prices, weight, rounded }
    }

    /// Returns the improvement of a column, and its possible error. Each of three products of two rounded integers
    /// has a relative error of at most 3 units of rounding, and two additions add 2. A bound of 8 covers their
    /// combined effect. Nothing underflows: what is not 0 is at least 1. A value that overflows is not a number, or
    /// has an infinite error.
    fn approximate(&self, column: &Column) -> (f64, f64) {
        let ([p, q, w], [a, b, cost]) = (self.rounded, column.rounded);
        let terms = [p * a, q * b, -w * cost];
        let size: f64 = terms.iter().map(|term| term.abs()).sum();
        (terms.iter().sum(), 8.0 * f64::EPSILON * size)
    }

    /// Returns whether the reduced cost is negative. Exact.
    fn improves(&self, column: &Column) -> bool {
        let (by, error) = self.approximate(column);
        if by.abs() > error {
            return by > 0.0;
        }
        let ([p, q], [a, b]) = (&self.prices, &column.entries);
        &self.weight * &column.cost < p * a + q * b
    }

    /// The column that improves most of those whose doubles prove that they do.
    fn steepest(&self, columns: &[Column]) -> Option<usize> {
        let mut best = (None, 0.0);
        for (index, column) in columns.iter().enumerate() {
            let (by, error) = self.approximate(column);
            let by_one = by / column.rounded_scale;
            if by > error && by_one > best.1 {
                best = (Some(index), by_one);
            }
        }
        best.0
    }
}

#[allow(
    clippy::indexing_slicing,
    reason = "rows are 0 or 1 of arrays of two; numbers of columns come from the order, which counts these columns"
)]
impl<'a> Tableau<'a> {
    /// Starts from the artificial columns, whose signs make their values non-negative.
    fn new(columns: &'a [Column], target: &[Rational; 2]) -> Self {
        let sign = |value: &Rational| if value.is_negative() { -Rational::one() } else { Rational::one() };
        Tableau {
            columns,
            order: LeapingOrder::new(columns.len()),
            basis: [Basic::Artificial(0), Basic::Artificial(1)],
            inverse: [[sign(&target[0]), Rational::zero()], [Rational::zero(), sign(&target[1])]],
            values: target.each_ref().map(Rational::abs),
        }
    }

    /// Pivots until nothing improves; returns the combination along which the cost falls without end, if there is one.
    fn run(&mut self, phase: Phase) -> Option<Vec<(usize, Rational)>> {
        let mut pivots = 0;
        while let Some(entering) = self.entering(phase, pivots < STEEPEST_PIVOTS) {
            pivots += 1;
            let column = &self.columns[entering].entries;
            let change = self.inverse.each_ref().map(|row| dot(row, column));
            match self.leaving(phase, &change) {
                Some(row) => self.pivot(row, entering, &change),
                None => return Some(self.combination(entering, &change)),
            }
        }
        None
    }

    /// A column with a negative reduced cost: the one that improves most as far as doubles tell, or the first.
    fn entering(&self, phase: Phase, is_steepest: bool) -> Option<usize> {
        let pricing = Pricing::new(self.prices(phase), phase);
        let basic = |index: usize| self.basis.contains(&Basic::Column(index));
        let steepest = is_steepest.then(|| pricing.steepest(self.columns)).flatten();
        steepest.or_else(|| {
            self.order.columns().find(|&index| pricing.improves(&self.columns[index]) && !basic(index))
        })
    }

    /// The row that blocks first when the entering column grows and `change` is taken from the basic values.
    fn leaving(&self, phase: Phase, change: &[Rational; 2]) -> Option<usize> {
        let mut best: Option<(usize, Rational)> = None;
        for row in [0, 1] {
            let stays_at_zero = phase == Phase::Cost && matches!(self.basis[row], Basic::Artificial(_));
            let blocks = change[row].is_positive() || (stays_at_zero && !change[row].is_zero());
            let Some(ratio) = self.values[row].checked_div(&change[row]).filter(|_| blocks) else { continue };
            let sooner = best.as_ref().is_none_or(|(other, least)| {
                ratio < *least || (ratio == *least && self.comes_first(row, *other))
            });
            if sooner {
                best = Some((row, ratio));
            }
        }
        best.map(|(row, _)| row)
    }

    /// Returns whether the basic column of one row comes before that of another in Bland's order; artificial columns come first.
    fn comes_first(&self, row: usize, other: usize) -> bool {
        match (self.basis[row], self.basis[other]) {
            (Basic::Artificial(one), Basic::Artificial(other)) => one < other,
            (Basic::Artificial(_), Basic::Column(_)) => true,
            (Basic::Column(_), Basic::Artificial(_)) => false,
            (Basic::Column(one), Basic::Column(other)) => {
                self.order.columns().find(|&column| column == one || column == other) == Some(one)
            }
        }
    }

    fn pivot(&mut self, row: usize, entering: usize, change: &[Rational; 2]) {
        let other = 1 - row;
        let quotient = |value: &Rational| value.checked_div(&change[row]).unwrap_or_default();
        let scaled = self.inverse[row].each_ref().map(&quotient);
        let step = quotient(&self.values[row]);
        self.inverse[other] = [0, 1].map(|i| &self.inverse[other][i] - &change[other] * &scaled[i]);
        self.values[other] = &self.values[other] - &change[other] * &step;
        self.inverse[row] = scaled;
        self.values[row] = step;
        self.basis[row] = Basic::Column(entering);
    }

    /// Prices π with π·column = cost for the basic columns.
    fn prices(&self, phase: Phase) -> [Rational; 2] {
        let costs = self.basis.map(|basic| match (basic, phase) {
            (Basic::Artificial(_), Phase::Reach) => Rational::one(),
            (Basic::Column(index), Phase::Cost) => Rational::from(&self.columns[index].cost),
            _ => Rational::zero(),
        });
        [0, 1].map(|i| &costs[0] * &self.inverse[0][i] + &costs[1] * &self.inverse[1][i])
    }

    fn artificial_rows(&self) -> impl Iterator<Item = usize> {
        let basis = self.basis;
        (0..2).filter(move |&row| matches!(basis[row], Basic::Artificial(_)))
    }

    /// The basic columns with their λ, in terms of the unscaled columns.
    fn basic_columns(&self) -> Vec<(usize, Rational)> {
        let values = self.basis.iter().zip(&self.values);
        values
            .filter_map(|(basic, value)| Some((basic.column()?, self.unscaled(basic.column()?, value))))
            .collect()
    }

    /// One unit of the entering column and what cancels it.
    fn combination(&self, entering: usize, change: &[Rational; 2]) -> Vec<(usize, Rational)> {
        let entered = (entering, self.unscaled(entering, &Rational::one()));
        let basic = self.basis.iter().zip(change).filter_map(|(basic, change)| {
            let index = basic.column()?;
            (!change.is_zero()).then(|| (index, self.unscaled(index, &-change)))
        });
        std::iter::once(entered).chain(basic).collect()
    }

    fn unscaled(&self, index: usize, value: &Rational) -> Rational {
        value * Rational::from(&self.columns[index].scale)
    }
}

impl Basic {
    fn column(self) -> Option<usize> {
        match self {
            Basic::Column(index) => Some(index),
            Basic::Artificial(_) => None,
        }
    }
}

fn dot([first, second]: &[Rational; 2], [a, b]: &[Integer; 2]) -> Rational {
    first * Rational::from(a) + second * Rational::from(b)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The doubles' answer about a reduced cost is within the bound of their error, at sizes near cancellation too.
    /// Beyond the largest double they have no answer.
    #[test]
    fn approximate_prices_are_as_far_off_as_they_say() {
        let mut state = 1_u64;
        let mut random = |most: u32| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let digits = Integer::power_of_ten((state >> 59) as u32 % most);
            let signed = (state >> 20) as i64 & 0x7fff_ffff;
            Integer::from(signed - 0x3fff_ffff) * digits
        };
        let (mut decided, mut undecided) = (0, 0);
        for case in 0..20_000 {
            let [p, q, a, b, weight] = [random(20), random(20), random(20), random(20), random(20)];
            // Near cancellation: the cost is what the prices say, and a little.
            let weight = if weight == Integer::zero() { Integer::one() } else { weight };
            let whole = &p * &a + &q * &b;
            let cost = whole.div_rem_floor(&weight).0 + Integer::from(case % 3 - 1);
            let [a, b, cost] = [a, b, cost].map(Rational::from);
            let column = Column::new([&a, &b], &cost);
            let rounded = [&p, &q, &weight].map(rounded);
            let pricing = Pricing { prices: [p, q], weight, rounded };
            let ([p, q], [a, b]) = (&pricing.prices, &column.entries);
            let exact = Rational::from(p * a + q * b - &pricing.weight * &column.cost);
            let (by, error) = pricing.approximate(&column);
            let off = Rational::from_f64(by).map(|by| (by - &exact).abs());
            assert!(off <= Rational::from_f64(error), "{case}");
            assert_eq!(pricing.improves(&column), exact.is_positive(), "{case}");
            if by.abs() > error { decided += 1 } else { undecided += 1 }
        }
        assert!(decided > 4_000 && undecided > 4_000, "{decided} {undecided}");
        let huge = Rational::from(Integer::power_of_ten(400));
        let column = Column::new([&huge, &-&huge], &Rational::one());
        let one = [Rational::one(), Rational::one()];
        assert!(!Pricing::new(one.clone(), Phase::Reach).improves(&column));
        assert_eq!(Pricing::new(one, Phase::Cost).steepest(&[column]), None);
    }
}
