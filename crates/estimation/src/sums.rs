//! What least squares needs to know about readings, in constant memory.

use boundfit_exact::{
    Column, Count, DoubleSum, Dyadic, Integer, Long, LongProducts, LongTotal, Rational, Scaled, Sum, Unit,
    WideProducts, WideSum,
};

use crate::moments::Moments;
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
    #[cfg(feature = "files")]
    pub(crate) fn of_columns(u: &Column, v: Option<&Column>, y: &Column) -> Self {
        match v {
            None => RunningSums::of_line(u, y).total(),
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
        let [uu, uv, vv, uy, vy] = pairs.map(|[left, right]| product_sum(left, right));
        Sums { count: u.len(), uu, uv, vv, uy, vy }
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

/// [`Sums`] in the making: over common denominators that nobody has reduced yet, which takes longer than to add up what a
/// batch of readings comes to.
#[derive(Debug, Clone, Default)]
pub(crate) struct RunningSums {
    pub(crate) count: usize,
    /// Σu², Σuv, Σv², Σuy and Σvy.
    sums: [Sum; 5],
}

impl RunningSums {
    /// Those of a line over columns of equal length. Exact. Cost: linear.
    pub(crate) fn of_line(x: &Column, y: &Column) -> Self {
        match (x, y) {
            (Column::Narrow(x), Column::Narrow(y)) => {
                of_narrow(x, None, y).unwrap_or_else(|| of_counts(x, y))
            }
            (Column::Narrow(x), Column::Wide(y)) => of_counts(x, y),
            (Column::Wide(x), Column::Narrow(y)) => of_counts(x, y),
            (Column::Wide(x), Column::Wide(y)) => of_counts(x, y),
            (Column::Doubles(x), Column::Doubles(y)) => RunningSums::from(of_doubles(x, y)),
            _ => match (x.long(), y.long()) {
                (Some(x), Some(y)) => of_long(&x, &y),
                _ => {
                    let one = Rational::one();
                    let reading = |row: usize| [x.get(row), one.clone(), y.get(row)];
                    RunningSums::from(of_numbers(x.len().min(y.len()), reading))
                }
            },
        }
    }

    /// So many units each.
    fn new(count: usize, counts: [Integer; 5], [u, v, y]: [Unit; 3]) -> Self {
        let mut sums: [Sum; 5] = Default::default();
        for ((sum, count), units) in sums.iter_mut().zip(counts).zip([[u, u], [u, v], [v, v], [u, y], [v, y]])
        {
            sum.add_units(count, &units);
        }
        RunningSums { count, sums }
    }

    /// Adds those over other readings. Exact.
    pub(crate) fn merge(&mut self, other: RunningSums) {
        self.count += other.count;
        self.sums.iter_mut().zip(other.sums).for_each(|(own, other)| own.merge(other));
    }

    /// In lowest terms. Exact.
    pub(crate) fn total(&self) -> Sums {
        let [uu, uv, vv, uy, vy] = self.sums.each_ref().map(Sum::total);
        Sums { count: self.count, uu, uv, vv, uy, vy }
    }
}

impl From<Sums> for RunningSums {
    fn from(Sums { count, uu, uv, vv, uy, vy }: Sums) -> Self {
        let sums = [uu, uv, vv, uy, vy].map(|total| {
            let mut sum = Sum::default();
            sum.add(&total);
            sum
        });
        RunningSums { count, sums }
    }
}

/// The sums on machine integers, unless one of them might not fit.
fn of_narrow(u: &Scaled<i64>, v: Option<&Scaled<i64>>, y: &Scaled<i64>) -> Option<RunningSums> {
    let Moments { uu, uv, vv, uy, vy } = Moments::of_integers(u.counts(), v.map(Scaled::counts), y.counts())?;
    let count = u.counts().len().min(y.counts().len());
    let units = [u.unit(), v.map_or(Unit::Any, Scaled::unit), y.unit()];
    Some(RunningSums::new(count, [uu, uv, vv, uy, vy].map(Integer::from), units))
}

/// Those of a line on integers of up to 128 bits.
fn of_counts<X: Count, Y: Count>(x: &Scaled<X>, y: &Scaled<Y>) -> RunningSums {
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
    let counts = [xx.total(), sum_x.total(), Integer::from(count), xy.total(), sum_y.total()];
    RunningSums::new(count, counts, [x.unit(), Unit::Any, y.unit()])
}

/// Those of a line on decimals of any number of digits.
fn of_long(x: &Long, y: &Long) -> RunningSums {
    let count = x.len().min(y.len());
    let [mut sum_x, mut sum_y] = [x, y].map(|column| LongTotal::new(column.width()));
    let [mut xx, mut xy] = [x, y].map(|other| LongProducts::new(x.width(), other.width()));
    for (x, y) in x.numbers().zip(y.numbers()) {
        sum_x.add(x);
        sum_y.add(y);
        xx.add(x, x);
        xy.add(x, y);
    }
    let counts = [xx.total(), sum_x.total(), Integer::from(count), xy.total(), sum_y.total()];
    RunningSums::new(count, counts, [x.unit(), Unit::Any, y.unit()])
}

fn of_doubles(x: &[f64], y: &[f64]) -> Sums {
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
    Sums { count, uu, uv, vv: Rational::from(count), uy, vy }
}

fn of_numbers(count: usize, reading: impl Fn(usize) -> [Rational; 3]) -> Sums {
    let Moments { uu, uv, vv, uy, vy } = Moments::of_readings((0..count).map(reading));
    Sums { count, uu, uv, vv, uy, vy }
}
