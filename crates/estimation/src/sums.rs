//! What least squares needs to know about readings, in constant memory.

use boundfit_exact::{
    Column, Count, DoubleSum, Dyadic, Integer, Long, LongProducts, LongTotal, Rational, Scaled, Sum, Unit,
    WideProducts, WideSum,
};

use crate::moments::Sums;
#[cfg(feature = "files")]
use crate::products::product_sum;

/// The sum of each column. Exact. Cost: linear.
#[cfg(feature = "files")]
pub(crate) fn column_totals(columns: &[Column]) -> Vec<Rational> {
    columns.iter().map(column_total).collect()
}

/// The sum of a column. Exact. Cost: linear.
#[cfg(feature = "files")]
pub(crate) fn column_total(column: &Column) -> Rational {
    match column {
        // So many integers of 64 bits fit into 128.
        Column::Narrow(scaled) => {
            let total: i128 = scaled.counts().iter().map(|&count| i128::from(count)).sum();
            Rational::from(total) * scaled.unit().value()
        }
        Column::Doubles(doubles) => {
            let mut sum = DoubleSum::default();
            doubles.chunks(Dyadic::CHUNK).for_each(|chunk| sum.add_all(&Dyadic::new(chunk)));
            sum.total()
        }
        Column::Wide(scaled) => total_of_counts(scaled.counts()) * scaled.unit().value(),
        Column::Long(long) => {
            let mut sum = LongTotal::new(long.width());
            long.numbers().for_each(|words| sum.add(words));
            Rational::from(sum.total()) * long.unit().value()
        }
        Column::Fractions(_) => {
            let mut sum = Sum::default();
            (0..column.len()).for_each(|row| sum.add(&column.get(row)));
            sum.total()
        }
    }
}

#[cfg(feature = "files")]
fn total_of_counts(counts: &[i128]) -> Rational {
    let mut sum = WideSum::default();
    counts.iter().for_each(|&count| sum.add(count));
    Rational::from(sum.total())
}

impl Sums {
    /// The sums over columns of equal length, without v those of a line. Exact. Cost: linear; on machine integers where their
    /// bits suffice.
    #[cfg(feature = "files")]
    pub(crate) fn of_columns(u: &Column, v: Option<&Column>, y: &Column) -> Self {
        match v {
            None => Sums::of_line(u, y).total(),
            Some(v) => Sums::of_two(u, v, y),
        }
    }

    #[cfg(feature = "files")]
    fn of_two(u: &Column, v: &Column, y: &Column) -> Self {
        if let (Column::Narrow(u), Column::Narrow(v), Column::Narrow(y)) = (u, v, y)
            && let Some(sums) = of_narrow(u, Some(v), y)
        {
            return sums.total();
        }
        let pairs = [[u, u], [u, v], [v, v], [u, y], [v, y]];
        Sums::new(u.len(), pairs.map(|[left, right]| product_sum(left, right)))
    }

    /// The sums over the readings of lines whose x are counted from here, from those of x as it is. Exact.
    #[cfg(feature = "files")]
    pub(crate) fn counted_from(self, origin: &Rational) -> Self {
        if origin.is_zero() {
            return self;
        }
        let Sums { count, uu: xx, uv: x, vv, uy: xy, vy: y } = self;
        let all = origin * Rational::from(count);
        let twice = &x + &x;
        Sums { count, uu: xx + origin * (&all - twice), uv: x - all, vv, uy: xy - origin * &y, vy: y }
    }
}

impl Sums<Sum> {
    /// Those of a line over columns of equal length. Exact. Cost: linear.
    pub(crate) fn of_line(x: &Column, y: &Column) -> Self {
        match (x, y) {
            (Column::Narrow(x), Column::Narrow(y)) => {
                of_narrow(x, None, y).unwrap_or_else(|| of_counts(x, y))
            }
            (Column::Narrow(x), Column::Wide(y)) => of_counts(x, y),
            (Column::Wide(x), Column::Narrow(y)) => of_counts(x, y),
            (Column::Wide(x), Column::Wide(y)) => of_counts(x, y),
            (Column::Doubles(x), Column::Doubles(y)) => of_doubles(x, y),
            _ => match (x.long(), y.long()) {
                (Some(x), Some(y)) => of_long(&x, &y),
                _ => {
                    let one = Rational::one();
                    let reading = |row: usize| [x.get(row), one.clone(), y.get(row)];
                    Sums::of_numbers((0..x.len().min(y.len())).map(reading))
                }
            },
        }
    }

    /// So many units each.
    fn of_units(counts: Sums<Integer>, [u, v, y]: [Unit; 3]) -> Self {
        let of = |count: Integer, units: [Unit; 2]| {
            let mut sum = Sum::default();
            sum.add_units(count, &units);
            sum
        };
        let Sums { count, uu, uv, vv, uy, vy } = counts;
        Sums {
            count,
            uu: of(uu, [u, u]),
            uv: of(uv, [u, v]),
            vv: of(vv, [v, v]),
            uy: of(uy, [u, y]),
            vy: of(vy, [v, y]),
        }
    }

    /// Those over other readings as well. Exact.
    pub(crate) fn and(self, other: Self) -> Self {
        self.zip(other, |mut own, other| {
            own.merge(other);
            own
        })
    }
}

/// The sums on machine integers, unless one of them might not fit.
fn of_narrow(u: &Scaled<i64>, v: Option<&Scaled<i64>>, y: &Scaled<i64>) -> Option<Sums<Sum>> {
    let counts = Sums::of_integers(u.counts(), v.map(Scaled::counts), y.counts())?;
    let units = [u.unit(), v.map_or(Unit::Any, Scaled::unit), y.unit()];
    Some(Sums::of_units(counts.map(Integer::from), units))
}

/// Those of a line on integers of up to 128 bits.
fn of_counts<X: Count, Y: Count>(x: &Scaled<X>, y: &Scaled<Y>) -> Sums<Sum> {
    let count = x.counts().len().min(y.counts().len());
    let [mut sum_x, mut sum_y] = [WideSum::default(); 2];
    let [mut xx, mut xy] = [WideProducts::default(); 2];
    for (&x, &y) in x.counts().iter().zip(y.counts()) {
        let (x, y): (i128, i128) = (x.into(), y.into());
        sum_x.add(x);
        sum_y.add(y);
        xx.add(x, x);
        xy.add(x, y);
    }
    of_line_counts(count, [xx.total(), sum_x.total(), xy.total(), sum_y.total()], [x.unit(), y.unit()])
}

/// Those of a line on decimals of any number of digits.
fn of_long(x: &Long, y: &Long) -> Sums<Sum> {
    let count = x.len().min(y.len());
    let [mut sum_x, mut sum_y] = [x, y].map(|column| LongTotal::new(column.width()));
    let [mut xx, mut xy] = [x, y].map(|other| LongProducts::new(x.width(), other.width()));
    for (x, y) in x.numbers().zip(y.numbers()) {
        sum_x.add(x);
        sum_y.add(y);
        xx.add(x, x);
        xy.add(x, y);
    }
    of_line_counts(count, [xx.total(), sum_x.total(), xy.total(), sum_y.total()], [x.unit(), y.unit()])
}

/// Those of a line from Σx², Σx, Σxy and Σy in units of the columns.
fn of_line_counts(count: usize, [uu, uv, uy, vy]: [Integer; 4], [x, y]: [Unit; 2]) -> Sums<Sum> {
    Sums::of_units(Sums { count, uu, uv, vv: count.into(), uy, vy }, [x, Unit::Any, y])
}

fn of_doubles(x: &[f64], y: &[f64]) -> Sums<Sum> {
    let mut sums = std::array::from_fn::<_, 4, _>(|_| DoubleSum::default());
    for (x, y) in x.chunks(Dyadic::CHUNK).zip(y.chunks(Dyadic::CHUNK)) {
        let (x, y) = (Dyadic::new(x), Dyadic::new(y));
        sums[0].add_all(&x);
        sums[1].add_all(&y);
        sums[2].add_products(&x, &x);
        sums[3].add_products(&x, &y);
    }
    let count = x.len().min(y.len());
    let [uv, vy, uu, uy] = sums.map(DoubleSum::total);
    Sums { count, uu, uv, vv: Rational::from(count), uy, vy }.map(|total| {
        let mut sum = Sum::default();
        sum.add(&total);
        sum
    })
}
