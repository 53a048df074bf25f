//! What least squares needs to know about readings, in constant memory.

#[cfg(feature = "files")]
use boundfit_exact::Sum;
use boundfit_exact::{Column, DoubleSum, Integer, Rational, Scaled, Unit};

use crate::moments::Moments;

/// The sum of each column. Exact. Cost: linear.
#[cfg(feature = "files")]
pub(crate) fn column_totals(columns: &[Column]) -> Vec<Rational> {
    let total = |column: &Column| match column {
        // So many integers of 64 bits fit into 128.
        Column::Narrow(scaled) => {
            let total: i128 = scaled.counts().iter().map(|&count| i128::from(count)).sum();
            Rational::from(total) * scaled.unit().value()
        }
        Column::Doubles(doubles) => {
            let mut sum = DoubleSum::default();
            doubles.iter().for_each(|&double| sum.add(double));
            sum.total()
        }
        Column::Wide(_) | Column::Fractions(_) => {
            let mut sum = Sum::default();
            (0..column.len()).for_each(|row| sum.add(&column.get(row)));
            sum.total()
        }
    };
    columns.iter().map(total).collect()
}

/// Bits of the lower part of a wide integer.
const LOW_BITS: u32 = 40;

/// N, Σu², Σuv, Σv², Σuy and Σvy over readings with regressors (u, v); of a line u is x and v is 1. Exact, whatever the order
/// in which readings are added.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Sums {
    /// How many readings.
    pub count: usize,
    /// Σu²; Σx² of a line.
    pub uu: Rational,
    /// Σuv; Σx of a line.
    pub uv: Rational,
    /// Σv²; N of a line.
    pub vv: Rational,
    /// Σuy; Σxy of a line.
    pub uy: Rational,
    /// Σvy; Σy of a line.
    pub vy: Rational,
}

impl Sums {
    /// The sums over columns of equal length, without v those of a line. Exact. Cost: linear; on machine integers where their
    /// bits suffice.
    pub(crate) fn of_columns(u: &Column, v: Option<&Column>, y: &Column) -> Self {
        match v {
            None => Sums::of_line(u, y),
            Some(v) => Sums::of_two(u, v, y),
        }
    }

    fn of_line(x: &Column, y: &Column) -> Self {
        let on_machine_numbers = match (x, y) {
            (Column::Narrow(x), Column::Narrow(y)) => of_narrow(x, None, y),
            (Column::Doubles(x), Column::Doubles(y)) => Some(of_doubles(x, y)),
            _ => None,
        };
        // Where one column is wide, or both are narrow but not their sums.
        let wide = || of_wide(x.wide()?.as_ref(), y.wide()?.as_ref());
        let one = Rational::one();
        on_machine_numbers
            .or_else(wide)
            .unwrap_or_else(|| of_numbers(x.len().min(y.len()), |row| [x.get(row), one.clone(), y.get(row)]))
    }

    fn of_two(u: &Column, v: &Column, y: &Column) -> Self {
        let on_machine_numbers = match (u, v, y) {
            (Column::Narrow(u), Column::Narrow(v), Column::Narrow(y)) => of_narrow(u, Some(v), y),
            _ => None,
        };
        on_machine_numbers.unwrap_or_else(|| of_numbers(u.len(), |row| [u.get(row), v.get(row), y.get(row)]))
    }

    /// The sums that the normal equations are made of.
    pub(crate) fn moments(&self) -> Moments<Rational> {
        let Sums { uu, uv, vv, uy, vy, .. } = self.clone();
        Moments { uu, uv, vv, uy, vy }
    }

    /// The sums over the readings of both. Exact.
    pub fn merged(&self, other: &Self) -> Self {
        Sums {
            count: self.count + other.count,
            uu: &self.uu + &other.uu,
            uv: &self.uv + &other.uv,
            vv: &self.vv + &other.vv,
            uy: &self.uy + &other.uy,
            vy: &self.vy + &other.vy,
        }
    }
}

/// The sums on machine integers, unless one of them might not fit.
fn of_narrow(u: &Scaled<i64>, v: Option<&Scaled<i64>>, y: &Scaled<i64>) -> Option<Sums> {
    let Moments { uu, uv, vv, uy, vy } = Moments::of_integers(u.counts(), v.map(Scaled::counts), y.counts())?;
    let one = Rational::one();
    let (u_unit, y_unit) = (u.unit().value(), y.unit().value());
    let v_unit = v.map_or(one, |v| v.unit().value());
    Some(Sums {
        count: u.counts().len().min(y.counts().len()),
        uu: Rational::from(uu) * &u_unit * &u_unit,
        uv: Rational::from(uv) * &u_unit * &v_unit,
        vv: Rational::from(vv) * &v_unit * &v_unit,
        uy: Rational::from(uy) * &u_unit * &y_unit,
        vy: Rational::from(vy) * &v_unit * &y_unit,
    })
}

/// The sums on wide integers in two parts; `None` for so many rows that a sum of products might not fit.
fn of_wide(x: &Scaled<i128>, y: &Scaled<i128>) -> Option<Sums> {
    const MOST_ROWS: usize = 1 << 20;
    let count = x.counts().len().min(y.counts().len());
    if count > MOST_ROWS {
        return None;
    }
    let [mut sum_x, mut sum_y] = [0_i128; 2];
    let [mut xx, mut xy] = [SumOfProducts::default(); 2];
    for (&x, &y) in x.counts().iter().zip(y.counts()) {
        sum_x += x;
        sum_y += y;
        xx.add(x, x);
        xy.add(x, y);
    }
    let [x_unit, y_unit] = [x.unit(), y.unit()].map(Unit::value);
    Some(Sums {
        count,
        uu: Rational::from(xx.total()) * &x_unit * &x_unit,
        uy: Rational::from(xy.total()) * &x_unit * &y_unit,
        uv: Rational::from(sum_x) * x_unit,
        vv: Rational::from(count),
        vy: Rational::from(sum_y) * y_unit,
    })
}

/// A sum of products of wide integers high·2^40 + low, apart for each power of two.
#[derive(Debug, Clone, Copy, Default)]
struct SumOfProducts {
    high: i128,
    middle: i128,
    low: i128,
}

impl SumOfProducts {
    fn add(&mut self, left: i128, right: i128) {
        let parts = |count: i128| (count >> LOW_BITS, count & ((1 << LOW_BITS) - 1));
        let ((left_high, left_low), (right_high, right_low)) = (parts(left), parts(right));
        // High parts have 53 bits, low ones 40: with 2^20 terms none of these overflows.
        self.high = self.high.wrapping_add(left_high.wrapping_mul(right_high));
        let middle = left_high.wrapping_mul(right_low).wrapping_add(left_low.wrapping_mul(right_high));
        self.middle = self.middle.wrapping_add(middle);
        self.low = self.low.wrapping_add(left_low.wrapping_mul(right_low));
    }

    fn total(&self) -> Integer {
        let shift = Integer::power_of_two(LOW_BITS.into());
        (Integer::from(self.high) * &shift + Integer::from(self.middle)) * shift + Integer::from(self.low)
    }
}

fn of_doubles(x: &[f64], y: &[f64]) -> Sums {
    let mut sums = std::array::from_fn::<_, 4, _>(|_| DoubleSum::default());
    for (&x, &y) in x.iter().zip(y) {
        sums[0].add(x);
        sums[1].add(y);
        sums[2].add_product(x, x);
        sums[3].add_product(x, y);
    }
    let count = x.len().min(y.len());
    let [uv, vy, uu, uy] = sums.map(DoubleSum::total);
    Sums { count, uu, uv, vv: Rational::from(count), uy, vy }
}

fn of_numbers(count: usize, reading: impl Fn(usize) -> [Rational; 3]) -> Sums {
    let Moments { uu, uv, vv, uy, vy } = Moments::of_readings((0..count).map(reading));
    Sums { count, uu, uv, vv, uy, vy }
}
