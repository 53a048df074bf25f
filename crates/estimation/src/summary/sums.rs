//! What least squares needs to know about the readings of a line, in constant memory.

use boundfit_exact::{DoubleSum, Integer, Rational, Scaled, Sum};
use boundfit_formats::Column;

use super::columns::{LOW_BITS, LineColumns, WideColumn};

/// Bits of an `i128` without its sign.
const SUM_BITS: u32 = 127;

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
    pub(super) fn of_columns(columns: &LineColumns) -> Self {
        let LineColumns { x, y, wide } = columns;
        let on_machine_integers = match (x, y, wide) {
            (Column::Scaled(x), Column::Scaled(y), _) => of_scaled(x, y),
            (Column::Doubles(x), Column::Doubles(y), _) => Some(of_doubles(x, y)),
            (_, _, Some([x, y])) => of_wide(x, y),
            _ => None,
        };
        // Both on 64 bits, but not their sums.
        let wide = || of_wide(&WideColumn::new(x)?, &WideColumn::new(y)?);
        on_machine_integers.or_else(wide).unwrap_or_else(|| of_numbers(x, y))
    }

    /// Σx alone. Exact.
    pub(super) fn of_x(x: &Column) -> Rational {
        LineSums::of_columns(&LineColumns::new(x, x)).x
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
fn of_scaled(x: &Scaled, y: &Scaled) -> Option<LineSums> {
    let count = x.mantissas.len().min(y.mantissas.len());
    let (x_bits, y_bits) = (widest(&x.mantissas), widest(&y.mantissas));
    if x_bits.max(y_bits) + x_bits + usize::BITS - count.leading_zeros() > SUM_BITS {
        return None;
    }
    let [mut sum_x, mut sum_y, mut sum_xx, mut sum_xy] = [0_i128; 4];
    for (&x, &y) in x.mantissas.iter().zip(&y.mantissas) {
        let (x, y) = (i128::from(x), i128::from(y));
        // By the bits above none of these can overflow.
        sum_x = sum_x.wrapping_add(x);
        sum_y = sum_y.wrapping_add(y);
        sum_xx = sum_xx.wrapping_add(x.wrapping_mul(x));
        sum_xy = sum_xy.wrapping_add(x.wrapping_mul(y));
    }
    let scaled = |sum: i128, exponent: i32| Rational::from(sum) * power_of_ten(exponent);
    Some(LineSums {
        count,
        x: scaled(sum_x, x.exponent),
        y: scaled(sum_y, y.exponent),
        xx: scaled(sum_xx, 2 * x.exponent),
        xy: scaled(sum_xy, x.exponent + y.exponent),
    })
}

/// Bits of the largest magnitude.
fn widest(mantissas: &[i64]) -> u32 {
    // The bits of all magnitudes together reach as far as those of the largest.
    let all = mantissas.iter().fold(0, |all, mantissa| all | mantissa.unsigned_abs());
    u64::BITS - all.leading_zeros()
}

/// The sums on mantissas in two parts; `None` for so many rows that a sum of products might not fit.
fn of_wide(x: &WideColumn, y: &WideColumn) -> Option<LineSums> {
    const MOST_ROWS: usize = 1 << 20;
    let count = x.mantissas.len().min(y.mantissas.len());
    if count > MOST_ROWS {
        return None;
    }
    let [mut sum_x, mut sum_y] = [0_i128; 2];
    let [mut xx, mut xy] = [SumOfProducts::default(); 2];
    for (&x, &y) in x.mantissas.iter().zip(&y.mantissas) {
        sum_x += x;
        sum_y += y;
        xx.add(x, x);
        xy.add(x, y);
    }
    let over = |sum: Integer, denominator: Integer| Rational::new(sum, denominator);
    let (x_unit, y_unit) = (Integer::from(x.denominator), Integer::from(y.denominator));
    Some(LineSums {
        count,
        x: over(sum_x.into(), x_unit.clone())?,
        y: over(sum_y.into(), y_unit.clone())?,
        xx: over(xx.total(), &x_unit * &x_unit)?,
        xy: over(xy.total(), x_unit * y_unit)?,
    })
}

/// A sum of products of wide mantissas m = high·2^40 + low, apart for each power of two.
#[derive(Debug, Clone, Copy, Default)]
struct SumOfProducts {
    high: i128,
    middle: i128,
    low: i128,
}

impl SumOfProducts {
    fn add(&mut self, left: i128, right: i128) {
        let parts = |mantissa: i128| (mantissa >> LOW_BITS, mantissa & ((1 << LOW_BITS) - 1));
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
    let mut sums = std::array::from_fn::<_, 4, _>(|_| Sum::default());
    for row in 0..count {
        let (x, y) = (x.get(row), y.get(row));
        sums[0].add(&x);
        sums[1].add(&y);
        sums[2].add_product(&x, &x);
        sums[3].add_product(&x, &y);
    }
    let [x, y, xx, xy] = sums.map(|sum| sum.total());
    LineSums { count, x, y, xx, xy }
}

/// 10 to any power.
pub(super) fn power_of_ten(exponent: i32) -> Rational {
    Rational::scientific(1, exponent)
}
