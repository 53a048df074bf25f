//! The sums over readings that least squares needs, in constant memory.

use boundfit_exact::{
    Column, DecimalSum, DoubleSum, Dyadic, Integer, LongTotal, Rational, Scaled, Sum, Unit, WideSum,
};

use crate::moments::{Counts, Sums};
use crate::products::{product_sum, sum_of};

/// The sum of a column. Exact. Cost: linear.
pub(crate) fn column_sum(column: &Column) -> Sum {
    let of_counts = |count: Integer, unit: Unit| {
        let mut total = Sum::default();
        total.add_units(count, &[unit]);
        total
    };
    match column {
        Column::Narrow(scaled) => of_counts(Counts::new(scaled.counts()).sum().into(), scaled.unit()),
        Column::Wide(scaled) => {
            let mut sum = WideSum::default();
            scaled.counts().iter().for_each(|&count| sum.add(count));
            of_counts(sum.total(), scaled.unit())
        }
        Column::Long(long) => {
            let mut sum = LongTotal::new(long.width());
            long.numbers().for_each(|words| sum.add(words));
            of_counts(sum.total(), long.unit())
        }
        Column::Doubles(doubles) => {
            let mut sum = DoubleSum::default();
            doubles.chunks(Dyadic::CHUNK).for_each(|chunk| sum.add_all(&Dyadic::new(chunk)));
            sum_of(sum.total())
        }
        Column::Scattered(scattered) => {
            let mut sum = DecimalSum::default();
            scattered.numbers().iter().for_each(|&(mantissa, exponent)| sum.add(mantissa.into(), exponent));
            sum.total()
        }
        Column::Fractions(_) => {
            let mut sum = Sum::default();
            (0..column.len()).for_each(|row| sum.add(&column.get(row)));
            sum
        }
    }
}

impl Sums<Sum> {
    /// Returns the sums of a line over columns of equal length. Exact. Cost: linear, on machine numbers where these
    /// hold the columns.
    pub(crate) fn of_line(x: &Column, y: &Column) -> Self {
        let sums = match (x, y) {
            (Column::Narrow(x), Column::Narrow(y)) => of_narrow(x, None, y),
            (Column::Doubles(x), Column::Doubles(y)) => Some(of_doubles(x, y)),
            _ => None,
        };
        sums.unwrap_or_else(|| {
            let count = x.len().min(y.len());
            let [xx, xy] = [x, y].map(|other| product_sum(x, other));
            Sums::new(count, [xx, column_sum(x), sum_of(Rational::from(count)), xy, column_sum(y)])
        })
    }

    /// Returns the sums of these counts of units.
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

    /// Adds the sums over other readings. Exact.
    pub(crate) fn and(self, other: Self) -> Self {
        self.zip(other, |mut own, other| {
            own.merge(other);
            own
        })
    }
}

/// The sums on machine integers, unless one of them might not fit.
pub(crate) fn of_narrow(u: &Scaled<i64>, v: Option<&Scaled<i64>>, y: &Scaled<i64>) -> Option<Sums<Sum>> {
    let near = || if v.is_none() { Sums::of_near(u.counts(), y.counts()) } else { None };
    let any = || Sums::of_integers(u.counts(), v.map(Scaled::counts), y.counts());
    let counts = near().or_else(|| Some(any()?.map(Integer::from)))?;
    let units = [u.unit(), v.map_or(Unit::Any, Scaled::unit), y.unit()];
    Some(Sums::of_units(counts, units))
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
    Sums::new(count, [uu, uv, count.into(), uy, vy]).map(sum_of)
}
