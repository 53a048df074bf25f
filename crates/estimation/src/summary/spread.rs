//! The positions of the x of a line, as the EUI needs them; they are known only when all readings have been seen.

use std::cell::OnceCell;

use boundfit_exact::{
    Column, Count, DecimalSum, DoubleSum, Dyadic, Long, LongTotal, Rational, Scaled, Sum, Unit, WideSum,
    compare_words,
};

use crate::line_form::LineForm;
use crate::moments::Sums;

/// The values of x at which a weight of least squares changes its sign: A_1k at the root of N·x_k − Σx, A_2k at that
/// of Σx² − x_k·Σx. For a line through the origin it is the root of x_k.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Thresholds {
    values: [Rational; 3],
}

/// The number of x above each threshold, and their sum.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(crate) struct Spread {
    above: [Above; 3],
}

#[derive(Debug, Clone, PartialEq, Eq, Default)]
struct Above {
    count: usize,
    x: Rational,
}

impl Thresholds {
    /// The thresholds of readings of lines of a form, as values of x as it is, from the sums over x counted from the form's
    /// origin. Where Σx = 0 no A_2k changes its sign, and any second one will do.
    pub(crate) fn of_form(form: &LineForm, sums: &Sums) -> Self {
        let first = sums.uv.checked_div(&sums.vv).unwrap_or_default();
        let second = sums.uu.checked_div(&sums.uv).unwrap_or_default();
        Thresholds { values: [first, second, Rational::zero()].map(|value| value + &form.x_origin) }
    }

    /// Returns what a column of x has above each. Exact. Cost: linear; on machine integers where they fit.
    pub(crate) fn of_column(&self, x: &Column) -> Spread {
        match x {
            Column::Narrow(x) => self.of_scaled(x),
            Column::Wide(x) => self.of_scaled(x),
            Column::Long(x) => self.of_long(x),
            Column::Doubles(x) => self.of_doubles(x),
            Column::Scattered(x) => Spread::of_counts(self.values.each_ref().map(|threshold| {
                let mut sum = DecimalSum::default();
                let above = x.above(threshold).map(|(mantissa, exponent)| sum.add(mantissa.into(), exponent));
                let count = above.count();
                (count, sum.total().total())
            })),
            Column::Fractions(_) => Spread {
                above: self.values.each_ref().map(|threshold| {
                    let mut total = Sum::default();
                    let above = (0..x.len()).map(|k| x.get(k)).filter(|x| x > threshold);
                    let count = above.map(|x| total.add(&x)).count();
                    Above { count, x: total.total() }
                }),
            },
        }
    }

    /// A double is above a threshold when it is above the largest double that is not.
    fn of_doubles(&self, x: &[f64]) -> Spread {
        let floors = self.values.each_ref().map(Rational::floor_to_f64);
        let (mut counts, mut sums) = ([0; 3], std::array::from_fn::<_, 3, _>(|_| DoubleSum::default()));
        for x in x.chunks(Dyadic::CHUNK).map(Dyadic::new) {
            for ((count, sum), floor) in counts.iter_mut().zip(&mut sums).zip(floors) {
                *count += sum.add_above(&x, floor);
            }
        }
        let mut counts = counts.into_iter();
        Spread::of_counts(sums.map(|sum| (counts.next().unwrap_or_default(), sum.total())))
    }

    fn of_scaled<I: Count>(&self, x: &Scaled<I>) -> Spread {
        let (counts, unit) = (x.counts(), x.unit().value());
        let (Some(least), Some(most)) = (counts.iter().min(), counts.iter().max()) else {
            return Spread::default();
        };
        let ends: [i128; 2] = [*least, *most].map(I::into);
        let terms = || counts.iter().map(|&count| count.into());
        let all = OnceCell::new();
        Spread::of_counts(self.in_units(x.unit()).map(|threshold| {
            // Where x ascend, all x of most parts are on one side.
            match ends.map(|end| end > threshold) {
                [_, false] => (0, Rational::zero()),
                [true, true] => all.get_or_init(|| total(terms(), &unit)).clone(),
                [false, true] => total(terms().filter(|count| *count > threshold), &unit),
            }
        }))
    }

    fn of_long(&self, x: &Long) -> Spread {
        Spread::of_counts(self.values.each_ref().map(|threshold| {
            let floor = x.floor_of(threshold);
            let (mut count, mut sum) = (0, LongTotal::new(x.width()));
            for words in x.numbers().filter(|words| compare_words(words, &floor).is_gt()) {
                count += 1;
                sum.add(words);
            }
            (count, Rational::from(sum.total()) * x.unit().value())
        }))
    }

    /// The largest number of units that is not above each threshold, cut to 128 bits.
    pub(crate) fn in_units(&self, unit: Unit) -> [i128; 3] {
        self.values.each_ref().map(|threshold| {
            let Some(count) = threshold.checked_div(&unit.value()) else { return 0 };
            let (floor, _) = count.numerator().div_rem_floor(&count.denominator());
            floor.to_i128().unwrap_or(if floor.is_negative() { i128::MIN } else { i128::MAX })
        })
    }
}

/// Returns the number of some counts of a unit, and what they come to. Exact.
fn total(terms: impl Iterator<Item = i128>, unit: &Rational) -> (usize, Rational) {
    let (mut count, mut sum) = (0, WideSum::default());
    terms.for_each(|term| {
        count += 1;
        sum.add(term);
    });
    (count, Rational::from(sum.total()) * unit)
}

impl Spread {
    pub(crate) fn of_counts(counts: [(usize, Rational); 3]) -> Self {
        Spread { above: counts.map(|(count, x)| Above { count, x }) }
    }

    /// The spread of the readings of both. Exact.
    #[cfg(feature = "files")]
    pub(crate) fn merged(&self, other: &Self) -> Self {
        let both = |axis: usize| {
            let (one, other) = (&self.above[axis], &other.above[axis]);
            Above { count: one.count + other.count, x: &one.x + &other.x }
        };
        Spread { above: [0, 1, 2].map(both) }
    }

    #[cfg(feature = "files")]
    /// Returns what lies above the thresholds when x is counted from another origin. Exact.
    pub(crate) fn counted_from(self, origin: &Rational) -> Self {
        if origin.is_zero() {
            return self;
        }
        let above =
            |Above { count, x }: &Above| Above { count: *count, x: x - origin * Rational::from(*count) };
        Spread { above: self.above.each_ref().map(above) }
    }

    /// Σ|x| of readings with these sums, from what lies above 0. Exact.
    pub(crate) fn absolute_x(&self, sums: &Sums) -> Rational {
        let [_, _, Above { x, .. }] = &self.above;
        x + x - &sums.uv
    }

    /// Σ_k |A_1k| and Σ_k |A_2k| times the determinant N·Σx² − (Σx)², for readings with these sums. Exact.
    ///
    /// Both follow from Σ_k |t_k| = 2·Σ_(t_k > 0) t_k − Σ_k t_k.
    pub(crate) fn absolute_weights(&self, sums: &Sums) -> [Rational; 2] {
        let Sums { vv: count, uv: x, uu: xx, .. } = sums;
        let two = Rational::from(2);
        let [mean, other, _] = &self.above;
        let slope = (count * &mean.x - x * Rational::from(mean.count)) * &two;
        // Where Σx is negative, the negative weights are those not above the threshold.
        let (beyond, beyond_x) = if x.is_negative() {
            (count - Rational::from(other.count), x - &other.x)
        } else {
            (Rational::from(other.count), other.x.clone())
        };
        let determinant = count * xx - x * x;
        let negative = if x.is_zero() { Rational::zero() } else { x * beyond_x - xx * beyond };
        [slope, determinant + negative * two]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Thresholds left and right of all x, among them, and at some; words, wider integers, and none.
    #[test]
    fn integers_spread_like_fractions() {
        let mut seed = 6_u64;
        let mut below = |size: i64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 33) as i64 % size
        };
        let mut sides = [0; 3];
        for round in 0..3000_usize {
            let (far, unit) =
                ([0, 40, -40, 1 << 40][round % 4], [Unit::TenTo(-2), Unit::OneOver(3)][round % 2]);
            let factor = if round % 3 == 0 { 1 << 70 } else { 1 };
            let counts: Vec<i128> =
                (0..below(20)).map(|_| i128::from(far + below(30) - 15) * factor).collect();
            let column = Column::of_counts(counts.iter().copied(), unit);
            let values = [(); 3].map(|()| unit.times(i128::from(far + below(60) - 30) * factor));
            for value in &values {
                let above = counts.iter().filter(|&&count| unit.times(count) > *value).count();
                let side = usize::from(above > 0) + usize::from(above == counts.len());
                sides[side] += usize::from(!counts.is_empty());
            }
            let fractions = Column::Fractions((0..column.len()).map(|row| column.get(row)).collect());
            let thresholds = Thresholds { values };
            assert_eq!(thresholds.of_column(&column), thresholds.of_column(&fractions), "{round} {counts:?}");
        }
        assert!(sides.iter().all(|&own| own > 1000), "{sides:?}");
    }
}
