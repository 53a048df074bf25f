//! The least factor of a few rows by itself.
//!
//! A row is a half-plane that moves with a factor s, in homogeneous form:
//!
//! ```text
//! slope·t + offset·θ2 - bound·τ ≤ s·(of_y·τ + of_x·t),   t = |θ1| ≥ 0, τ ≥ 0
//! ```
//!
//! which is that of t and θ2 themselves at τ = 1. With t = λ and τ = 1 - λ it is a half-plane of (λ, v), 0 ≤ λ < 1: all slopes
//! fit into one interval. No line has λ = 1, but lines of ever larger slope come as near to it as one likes, so that ratios have their
//! limits there.

use boundfit_exact::{Rational, Sign, Surd};
use boundfit_geometry::Inequality;

/// A half-plane that moves with the factor.
#[derive(Debug, Clone)]
pub(super) struct Row {
    /// Of t.
    pub(super) slope: Rational,
    /// Of θ2.
    pub(super) offset: Rational,
    /// At factor 0.
    pub(super) bound: Rational,
    /// How fast the bound grows because of the error in y; not negative.
    pub(super) of_y: Rational,
    /// And for each unit of t because of the error in x; negative under strong agreement.
    pub(super) of_x: Rational,
}

impl Row {
    /// The half-plane of (λ, v) at a factor.
    pub(super) fn at(&self, factor: &Rational) -> Inequality {
        let along = &self.slope + &self.bound - factor * (&self.of_x - &self.of_y);
        Inequality::new(along, self.offset.clone(), &self.bound + factor * &self.of_y)
    }

    /// How far inside the row a point lies: negative where it is not.
    pub(super) fn slack(&self, factor: &Surd, [lambda, v]: &[Surd; 2]) -> Surd {
        let (one, minus) = (Surd::from(Rational::one()), -Rational::one());
        let along = Surd::sum([(&(&self.slope + &self.bound), &one), (&(&self.of_y - &self.of_x), factor)]);
        let along = along.product(lambda);
        let minus_offset = -&self.offset;
        Surd::sum([(&self.bound, &one), (&self.of_y, factor), (&minus, &along), (&minus_offset, v)])
    }
}

/// A sum of two rows without θ2, or a row without it: numerator(λ) ≤ s·denominator(λ), each a constant and a multiple of λ.
/// Where the denominator is 0 it asks for a numerator that is not positive; nowhere is it negative.
struct Ratio {
    numerator: [Rational; 2],
    denominator: [Rational; 2],
}

/// A value of a ratio: the least factor at which it holds at one λ.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
enum Value {
    /// None, however small.
    Always,
    At(Surd),
    Never,
}

impl Ratio {
    fn of_row(row: &Row) -> Self {
        let Row { slope, bound, of_y, of_x, .. } = row;
        Ratio { numerator: [-bound, slope + bound], denominator: [of_y.clone(), of_x - of_y] }
    }

    /// The sum of multiples of rows whose offsets have opposite signs.
    fn of_pair(upper: &Row, lower: &Row) -> Self {
        let times = [-&lower.offset, upper.offset.clone()];
        let sum = |of: fn(&Row) -> &Rational| of(upper) * &times[0] + of(lower) * &times[1];
        Ratio::of_row(&Row {
            slope: sum(|row| &row.slope),
            offset: Rational::zero(),
            bound: sum(|row| &row.bound),
            of_y: sum(|row| &row.of_y),
            of_x: sum(|row| &row.of_x),
        })
    }

    /// Whether no factor has a say in it.
    fn is_fixed(&self) -> bool {
        self.denominator.iter().all(Rational::is_zero)
    }

    fn at(&self, lambda: &Surd) -> Value {
        let one = Surd::from(Rational::one());
        let of = |[constant, times]: &[Rational; 2]| Surd::sum([(constant, &one), (times, lambda)]);
        let (numerator, denominator) = (of(&self.numerator), of(&self.denominator));
        match (denominator.recip(), numerator.sign()) {
            (Some(over), _) => Value::At(numerator.product(&over)),
            (None, Sign::Positive) => Value::Never,
            // Both are multiples of 1 - λ.
            (None, Sign::Zero) if *lambda == one => match self.numerator[1].checked_div(&self.denominator[1])
            {
                Some(limit) => Value::At(limit.into()),
                None => Value::Always,
            },
            (None, _) => Value::Always,
        }
    }

    /// Where two ratios are equal.
    fn crossings(&self, other: &Ratio) -> Vec<Surd> {
        let ([n0, n1], [d0, d1]) = (&self.numerator, &self.denominator);
        let ([m0, m1], [e0, e1]) = (&other.numerator, &other.denominator);
        let constant = n0 * e0 - m0 * d0;
        let linear = n0 * e1 + n1 * e0 - m0 * d1 - m1 * d0;
        let square = n1 * e1 - m1 * d1;
        Surd::roots(&[square, linear, constant])
    }
}

/// The least factor of a few rows, and one λ where it is attained.
#[derive(Debug, Clone)]
pub(super) struct Few {
    /// Not negative.
    pub(super) factor: Surd,
    pub(super) lambda: Surd,
}

/// The infimum of the factors that are not negative and leave something of these rows for some λ < 1 from 0 to `top`; `None` when
/// none does. Exact. Cost: the fourth power of the number of rows.
///
/// Over λ each ratio is monotone, so that the λ at which a factor is enough for it are an interval. Intervals meet if every two of them
/// do (Helly), so that the least factor is the largest one that two ratios ask for; and these ask for it at an end, or
/// where they are equal.
pub(super) fn least_of_few(rows: &[&Row], top: &Rational) -> Option<Few> {
    let signed = |sign: Sign| rows.iter().filter(move |row| row.offset.sign() == sign);
    let pairs = signed(Sign::Positive)
        .flat_map(|upper| signed(Sign::Negative).map(|lower| Ratio::of_pair(upper, lower)));
    let singles = signed(Sign::Zero).map(|row| Ratio::of_row(row));
    let (fixed, moving): (Vec<Ratio>, Vec<Ratio>) = singles.chain(pairs).partition(Ratio::is_fixed);
    let [bottom, top] = cut([Rational::zero(), top.clone()], &fixed)?;
    let ends = [Surd::from(bottom), Surd::from(top)];
    let mut least = Few { factor: Rational::zero().into(), lambda: ends[0].clone() };
    for (index, one) in moving.iter().enumerate() {
        for other in &moving[index..] {
            let crossings = one.crossings(other).into_iter();
            let within = crossings.filter(|lambda| ends[0] < *lambda && *lambda < ends[1]);
            let asked = |lambda: Surd| (one.at(&lambda).max(other.at(&lambda)), lambda);
            match ends.iter().cloned().chain(within).map(asked).min_by(|one, other| one.0.cmp(&other.0))? {
                (Value::Never, _) => return None,
                (Value::At(factor), lambda) if factor > least.factor => least = Few { factor, lambda },
                _ => {}
            }
        }
    }
    Some(least)
}

/// The λ of an interval at which ratios hold whatever the factor is; `None` when there is none.
fn cut([mut bottom, mut top]: [Rational; 2], fixed: &[Ratio]) -> Option<[Rational; 2]> {
    for Ratio { numerator: [constant, times], .. } in fixed {
        let end = (-constant).checked_div(times);
        match (times.sign(), end) {
            (Sign::Positive, Some(end)) => top = top.min(end),
            (Sign::Negative, Some(end)) => bottom = bottom.max(end),
            _ if constant.is_positive() => return None,
            _ => {}
        }
    }
    let is_left = bottom <= top && bottom < Rational::one();
    is_left.then_some([bottom, top])
}
