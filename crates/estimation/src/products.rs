//! Sums of products of two columns.

use boundfit_exact::{
    Column, Count, DecimalSum, DoubleSum, Dyadic, Integer, Long, LongProducts, Rational, Scaled, Sum, Unit,
    WideProducts,
};

use crate::moments::{Counts, SUM_BITS, bits};

/// Σ left·right over columns of equal length. Exact. Cost: linear, on machine integers but for numbers that only fractions hold.
pub(crate) fn product_sum(left: &Column, right: &Column) -> Sum {
    let of_counts = |sum: Integer, units: [Unit; 2]| {
        let mut total = Sum::default();
        total.add_units(sum, &units);
        total
    };
    match (left, right) {
        (Column::Narrow(x), Column::Narrow(y)) => of_counts(narrow(x, y), [x.unit(), y.unit()]),
        (Column::Narrow(x), Column::Wide(y)) => of_counts(wide(x, y), [x.unit(), y.unit()]),
        (Column::Wide(x), Column::Narrow(y)) => of_counts(wide(x, y), [x.unit(), y.unit()]),
        (Column::Wide(x), Column::Wide(y)) => of_counts(wide(x, y), [x.unit(), y.unit()]),
        (Column::Doubles(x), Column::Doubles(y)) => sum_of(doubles(x, y)),
        (Column::Scattered(x), Column::Scattered(y)) => {
            let mut sum = DecimalSum::default();
            for (&(x, x_exponent), &(y, y_exponent)) in x.numbers().iter().zip(y.numbers()) {
                // Two magnitudes of 63 bits and one exponent far from any limit.
                sum.add(i128::from(x).wrapping_mul(y.into()), x_exponent.wrapping_add(y_exponent));
            }
            sum.total()
        }
        _ => match (left.long(), right.long()) {
            (Some(x), Some(y)) => of_counts(long(&x, &y), [x.unit(), y.unit()]),
            _ => {
                let mut sum = Sum::default();
                (0..left.len()).for_each(|row| sum.add_product(&left.get(row), &right.get(row)));
                sum
            }
        },
    }
}

/// A sum that so far comes to this.
pub(crate) fn sum_of(total: Rational) -> Sum {
    let mut sum = Sum::default();
    sum.add(&total);
    sum
}

fn narrow(x: &Scaled<i64>, y: &Scaled<i64>) -> Integer {
    let (own, other) = (Counts::new(x.counts()), Counts::new(y.counts()));
    match own.bits + other.bits + bits(x.counts().len() as u128) > SUM_BITS {
        true => wide(x, y),
        false => own.sum_of_products(other).into(),
    }
}

fn wide<X: Count, Y: Count>(x: &Scaled<X>, y: &Scaled<Y>) -> Integer {
    let mut sum = WideProducts::default();
    x.counts().iter().zip(y.counts()).for_each(|(&x, &y)| sum.add(x.into(), y.into()));
    sum.total()
}

fn long(x: &Long, y: &Long) -> Integer {
    let mut sum = LongProducts::new(x.width(), y.width());
    x.numbers().zip(y.numbers()).for_each(|(x, y)| sum.add(x, y));
    sum.total()
}

fn doubles(x: &[f64], y: &[f64]) -> Rational {
    let mut sum = DoubleSum::default();
    for (x, y) in x.chunks(Dyadic::CHUNK).zip(y.chunks(Dyadic::CHUNK)) {
        sum.add_products(&Dyadic::new(x), &Dyadic::new(y));
    }
    sum.total()
}

#[cfg(test)]
mod tests {
    use boundfit_exact::{Limits, Reading};

    use super::*;

    #[test]
    fn products_of_all_kinds_of_columns_are_those_of_fractions() {
        let read = |text: &str| Reading::Decimal.read(text, &Limits::default()).unwrap();
        let mut long = Column::default();
        for text in ["-0.1234567890123456789012345678901234567890123", "7e30", "0", "-3e-60", "12"] {
            assert!(long.push_text(text.as_bytes()));
        }
        let largest = (1_i128 << 62) - 1;
        let columns = [
            Column::of_counts([3, -5, 0, 17, -1].into_iter(), Unit::TenTo(-2)),
            Column::of_counts([largest, -5, largest, largest, -largest].into_iter(), Unit::TenTo(3)),
            Column::of_counts([3, -5, 0, 1 << 100, -1 << 100].into_iter(), Unit::OneOver(7)),
            Column::of_counts([0; 5].into_iter(), Unit::Any),
            long,
            Column::of_doubles(&[1.5, -0.25, 0.0, 1e300, -1e-300]).unwrap(),
            Column::of_shortest(&[1.5, -0.25, 0.0, 1e300, -1e-300]).unwrap(),
            Column::Fractions([read("1/3"), read("-2/7"), read("0"), read("9e99"), read("1")].to_vec()),
        ];
        for left in &columns {
            for right in &columns {
                let expected: Rational = (0..5).map(|row| left.get(row) * right.get(row)).sum();
                assert_eq!(product_sum(left, right).total(), expected, "{left:?} {right:?}");
            }
        }
    }
}
