//! Where the x of a line lie, as the EUI needs it: only known when all readings have been seen.

use boundfit_exact::{Integer, Rational, Scaled, Sum};
use boundfit_formats::Column;

use super::columns::WideColumn;
use super::sums::{LineSums, power_of_ten};

/// The two values of x at which a weight of least squares changes its sign: A_1k that of N·x_k − Σx, A_2k that of
/// Σx² − x_k·Σx.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Thresholds {
    values: [Rational; 2],
}

/// How many x lie above each threshold, and their sum.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Spread {
    above: [Above; 2],
}

#[derive(Debug, Clone, PartialEq, Eq, Default)]
struct Above {
    count: usize,
    x: Rational,
}

impl Thresholds {
    /// The thresholds of readings with these sums. Where Σx = 0 no A_2k changes its sign, and any second one will do.
    pub(super) fn new(sums: &LineSums) -> Self {
        let first = sums.x.checked_div(&Rational::from(sums.count)).unwrap_or_default();
        let second = sums.xx.checked_div(&sums.x).unwrap_or_default();
        Thresholds { values: [first, second] }
    }

    /// What a column of x has above each. Exact. Cost: linear; on machine integers where they fit.
    pub(super) fn of_column(&self, x: &Column) -> Spread {
        match x {
            Column::Scaled(x) => self.of_scaled(x),
            Column::Exact(_) | Column::Doubles(_) => match WideColumn::new(x) {
                Some(wide) => self.of_wide(&wide),
                None => self.of_any(x),
            },
        }
    }

    fn of_any(&self, x: &Column) -> Spread {
        Spread {
            above: self.values.each_ref().map(|threshold| {
                let mut total = Sum::default();
                let above = (0..x.len()).map(|k| x.get(k)).filter(|x| x > threshold);
                let count = above.map(|x| total.add(&x)).count();
                Above { count, x: total.total() }
            }),
        }
    }

    fn of_scaled(&self, x: &Scaled) -> Spread {
        let unit = power_of_ten(x.exponent);
        let above = self.on_grid(x.exponent).map(|threshold| {
            let above = x.mantissas.iter().filter(|&&mantissa| i128::from(mantissa) > threshold);
            let (count, sum) = above.fold((0, 0_i128), |(count, sum), &mantissa| {
                (count + 1, sum.wrapping_add(i128::from(mantissa)))
            });
            Above { count, x: Rational::from(sum) * &unit }
        });
        Spread { above }
    }

    pub(super) fn of_wide(&self, x: &WideColumn) -> Spread {
        let denominator = Rational::from(x.denominator);
        let above = self.values.each_ref().map(|threshold| {
            let mantissa = threshold * &denominator;
            let (floor, _) = mantissa.numerator().div_rem_floor(&mantissa.denominator());
            let beyond = if floor.is_negative() { i128::MIN } else { i128::MAX };
            let threshold = floor.to_i128().unwrap_or(beyond);
            let above = x.mantissas.iter().filter(|&&mantissa| mantissa > threshold);
            let (count, sum) = above.fold((0, Integer::zero()), |(count, sum), &mantissa| {
                (count + 1, sum + Integer::from(mantissa))
            });
            Above { count, x: Rational::new(sum, x.denominator.into()).unwrap_or_default() }
        });
        Spread { above }
    }

    /// The largest mantissa that is not above each threshold, cut to what an `i64` can be compared with.
    pub(super) fn on_grid(&self, exponent: i32) -> [i128; 2] {
        let unit = power_of_ten(exponent);
        self.values.each_ref().map(|threshold| {
            let Some(mantissa) = threshold.checked_div(&unit) else { return 0 };
            let (floor, _) = mantissa.numerator().div_rem_floor(&mantissa.denominator());
            let (least, most) = (Integer::from(i64::MIN) - Integer::one(), Integer::from(i64::MAX));
            floor.clamp(least, most).to_i128().unwrap_or_default()
        })
    }
}

impl Spread {
    pub(super) fn of_counts(counts: [(usize, Rational); 2]) -> Self {
        Spread { above: counts.map(|(count, x)| Above { count, x }) }
    }

    /// The spread of the readings of both. Exact.
    pub fn merged(&self, other: &Self) -> Self {
        let both = |axis: usize| {
            let (one, other) = (&self.above[axis], &other.above[axis]);
            Above { count: one.count + other.count, x: &one.x + &other.x }
        };
        Spread { above: [both(0), both(1)] }
    }

    /// Σ_k |A_1k| and Σ_k |A_2k| times the determinant N·Σx² − (Σx)², for readings with these sums. Exact.
    ///
    /// Both follow from Σ_k |t_k| = 2·Σ_(t_k > 0) t_k − Σ_k t_k.
    pub fn absolute_weights(&self, sums: &LineSums) -> [Rational; 2] {
        let LineSums { count, x, xx, .. } = sums;
        let count = Rational::from(*count);
        let two = Rational::from(2);
        let [mean, other] = &self.above;
        let slope = (&count * &mean.x - x * Rational::from(mean.count)) * &two;
        // Where Σx is negative, the negative weights are those not above the threshold.
        let (beyond, beyond_x) = if x.is_negative() {
            (&count - Rational::from(other.count), x - &other.x)
        } else {
            (Rational::from(other.count), other.x.clone())
        };
        let determinant = &count * xx - x * x;
        let negative = if x.is_zero() { Rational::zero() } else { x * beyond_x - xx * beyond };
        [slope, determinant + negative * two]
    }
}
