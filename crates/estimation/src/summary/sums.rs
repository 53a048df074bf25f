//! What least squares needs to know about the readings of a line, in constant memory.

use boundfit_exact::{Column, DoubleSum, Integer, Rational, Scaled, Unit};

use crate::moments::Moments;

/// Bits of the lower part of a wide integer.
const LOW_BITS: u32 = 40;

/// N, Σx, Σy, Σx² and Σxy over readings of a line. Exact, whatever the order in which readings are added.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct LineSums {
    /// How many readings.
    pub count: usize,
    /// Σx.
    pub x: Rational,
    /// Σy.
    pub y: Rational,
    /// Σx².
    pub xx: Rational,
    /// Σxy.
    pub xy: Rational,
}

impl LineSums {
    /// The sums over two columns of equal length. Exact. Cost: linear; on machine integers where their bits suffice.
    pub(crate) fn of_columns(x: &Column, y: &Column) -> Self {
        let on_machine_numbers = match (x, y) {
            (Column::Narrow(x), Column::Narrow(y)) => of_narrow(x, y),
            (Column::Doubles(x), Column::Doubles(y)) => Some(of_doubles(x, y)),
            _ => None,
        };
        // Where one column is wide, or both are narrow but not their sums.
        let wide = || of_wide(x.wide()?.as_ref(), y.wide()?.as_ref());
        on_machine_numbers.or_else(wide).unwrap_or_else(|| of_numbers(x, y))
    }

    /// The sums as those of readings with the regressors (x, 1).
    pub(crate) fn moments(&self) -> Moments<Rational> {
        let LineSums { count, x, y, xx, xy } = self;
        Moments { uu: xx.clone(), uv: x.clone(), vv: Rational::from(*count), uy: xy.clone(), vy: y.clone() }
    }

    /// The sums over the readings of both. Exact.
    pub fn merged(&self, other: &Self) -> Self {
        LineSums {
            count: self.count + other.count,
            x: &self.x + &other.x,
            y: &self.y + &other.y,
            xx: &self.xx + &other.xx,
            xy: &self.xy + &other.xy,
        }
    }
}

/// The sums on machine integers, unless one of them might not fit.
fn of_narrow(x: &Scaled<i64>, y: &Scaled<i64>) -> Option<LineSums> {
    let Moments { uu, uv, uy, vy, .. } = Moments::of_integers(x.counts(), None, y.counts())?;
    let [x_unit, y_unit] = [x.unit(), y.unit()].map(Unit::value);
    Some(LineSums {
        count: x.counts().len().min(y.counts().len()),
        xx: Rational::from(uu) * &x_unit * &x_unit,
        xy: Rational::from(uy) * &x_unit * &y_unit,
        x: Rational::from(uv) * x_unit,
        y: Rational::from(vy) * y_unit,
    })
}

/// The sums on wide integers in two parts; `None` for so many rows that a sum of products might not fit.
fn of_wide(x: &Scaled<i128>, y: &Scaled<i128>) -> Option<LineSums> {
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
    Some(LineSums {
        count,
        xx: Rational::from(xx.total()) * &x_unit * &x_unit,
        xy: Rational::from(xy.total()) * &x_unit * &y_unit,
        x: Rational::from(sum_x) * x_unit,
        y: Rational::from(sum_y) * y_unit,
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

fn of_doubles(x: &[f64], y: &[f64]) -> LineSums {
    let mut sums = std::array::from_fn::<_, 4, _>(|_| DoubleSum::default());
    for (&x, &y) in x.iter().zip(y) {
        sums[0].add(x);
        sums[1].add(y);
        sums[2].add_product(x, x);
        sums[3].add_product(x, y);
    }
    let [sum_x, sum_y, sum_xx, sum_xy] = sums.map(DoubleSum::total);
    LineSums { count: x.len().min(y.len()), x: sum_x, y: sum_y, xx: sum_xx, xy: sum_xy }
}

fn of_numbers(x: &Column, y: &Column) -> LineSums {
    let count = x.len().min(y.len());
    let readings = (0..count).map(|row| [x.get(row), Rational::one(), y.get(row)]);
    let Moments { uu, uv, uy, vy, .. } = Moments::of_readings(readings);
    LineSums { count, x: uv, y: vy, xx: uu, xy: uy }
}
