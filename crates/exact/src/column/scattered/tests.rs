use std::cmp::Ordering;

use super::*;
use crate::{Column, DecimalSum};

/// Pseudo-random bits, the same ones every time.
struct Bits(u64);

impl Bits {
    fn below(&mut self, limit: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 24) % limit
    }

    /// Mantissas of few digits and of many, with zeros at their ends, and the ends of the type.
    fn decimal(&mut self, spread: u64) -> (i64, i32) {
        let exponent = self.below(2 * spread + 1) as i32 - spread as i32;
        let mantissa = match self.below(8) {
            0 => 0,
            1 => [i64::MAX, i64::MIN + 1, 10_i64.pow(18), 1, -1, 9][self.below(6) as usize],
            2 => 10_i64.pow(self.below(19) as u32) - self.below(2) as i64,
            digits => (self.below(1 << 40) * self.below(1 << 23)) as i64 / 10_i64.pow(2 * digits as u32),
        };
        (if self.below(2) == 0 { -mantissa } else { mantissa }, exponent)
    }
}

fn exact(&(mantissa, exponent): &(i64, i32)) -> Rational {
    Rational::scientific(mantissa, exponent)
}

/// Numbers of all sizes, the first two so that no words hold them.
fn numbers(bits: &mut Bits) -> Vec<(i64, i32)> {
    let spread = [1, 3, 40, 330][bits.below(4) as usize];
    let more = (0..40).map(|_| bits.decimal(spread));
    [(7, 200), (-3, -200)].into_iter().chain(more).collect()
}

#[test]
fn short_decimals_of_all_sizes_stay_what_they_are() {
    let mut bits = Bits(1);
    for _ in 0..300 {
        let numbers = numbers(&mut bits);
        let mut column = Column::default();
        numbers.iter().for_each(|&(mantissa, exponent)| column.push_decimal(mantissa, exponent));
        assert!(matches!(column, Column::Scattered(_)), "{column:?}");
        let values: Vec<Rational> = numbers.iter().map(exact).collect();
        let found = |column: &Column| (0..column.len()).map(|row| column.get(row)).collect::<Vec<_>>();
        assert_eq!(found(&column), values);
        assert_eq!(column.first_negative(), values.iter().position(Rational::is_negative));
        assert_eq!(column.has_zero(), values.iter().any(Rational::is_zero));
        for (one, value) in values.iter().enumerate() {
            for (other, further) in values.iter().enumerate() {
                assert_eq!(column.are_equal(one, other), value == further);
            }
        }
        let mut parts = column.part(0..5);
        parts.append(&column, 5..values.len());
        assert_eq!(parts, column);
        // Numbers of another kind come behind, and before.
        for other in [
            Column::of_counts([5, -70].into_iter(), Unit::TenTo(-3)),
            Column::of_counts([5, -70].into_iter(), Unit::OneOver(3)),
            Column::of_counts([1 << 100, 10_i128.pow(30)].into_iter(), Unit::TenTo(2)),
        ] {
            let mut both = column.clone();
            both.append(&other, 0..2);
            assert_eq!(found(&both), [values.clone(), found(&other)].concat());
            let mut both = other.clone();
            both.append(&column, 0..values.len());
            assert_eq!(found(&both), [found(&other), values.clone()].concat());
        }
    }
}

#[test]
fn what_has_too_many_digits_is_no_short_decimal() {
    for (count, unit) in [
        (10_i128.pow(20) + 1, Unit::TenTo(0)),
        (i64::MIN.into(), Unit::TenTo(0)),
        (1, Unit::TenTo(1 << 21)),
        (1, Unit::OneOver(3)),
    ] {
        let mut column = Scattered::default();
        assert_eq!(column.push(count, unit), None);
        assert_eq!(column.push(0, unit), Some(()));
        assert_eq!(column.numbers(), [(0, 0)]);
    }
    let mut column = Column::default();
    column.push_decimal(1, 200);
    column.push_long_decimal(10_i128.pow(36) + 1, 0);
    column.push_decimal(1, -200);
    assert!(matches!(column, Column::Fractions(_)));
    assert_eq!(column.get(1), Rational::from(10_i128.pow(36) + 1));
}

#[test]
fn each_is_rounded_within_its_bound() {
    let mut bits = Bits(2);
    let mut normal = 0;
    for _ in 0..20_000 {
        let (mantissa, exponent) = bits.decimal(345);
        let exact = exact(&(mantissa, exponent));
        let nearest = exact.to_f64();
        let Some(double) = rounded(mantissa, exponent) else {
            // No normal number, or so near to the largest one that a step before goes beyond.
            assert!(!nearest.is_normal() || nearest.abs() > 1e307, "{mantissa}e{exponent}");
            continue;
        };
        normal += 1;
        let error = (Rational::from_f64(double).unwrap() - &exact).abs();
        assert!(error * Rational::from(1_i128 << 50) <= exact.abs(), "{mantissa}e{exponent} as {double}");
    }
    assert!(normal > 15_000, "{normal}");
}

/// Comparing fractions is the reference.
#[test]
fn numbers_are_above_thresholds_that_are_less() {
    let mut bits = Bits(3);
    let mut found = [0; 3];
    for _ in 0..1000 {
        let mut column = Scattered::default();
        let numbers = numbers(&mut bits);
        for &(mantissa, exponent) in &numbers {
            column.push(mantissa.into(), Unit::TenTo(exponent)).unwrap();
        }
        let own = exact(&numbers[bits.below(42) as usize]);
        let tiny = Rational::scientific(1, -(bits.below(400) as i64)) * own.abs();
        let threshold = match bits.below(6) {
            0 => own,
            1 => own - tiny,
            2 => own + tiny,
            3 => Rational::zero(),
            4 => own.checked_div(&Rational::from(7)).unwrap(),
            _ => Rational::scientific(bits.below(1 << 40) as i64 - (1 << 39), -(bits.below(9) as i64)),
        };
        let above: Vec<Rational> = column.above(&threshold).map(|number| exact(&number)).collect();
        let expected: Vec<Rational> = numbers.iter().map(exact).filter(|own| *own > threshold).collect();
        assert_eq!(above, expected, "{threshold}");
        for number in &numbers {
            let place = match exact(number).cmp(&threshold) {
                Ordering::Less => 0,
                Ordering::Equal => 1,
                Ordering::Greater => 2,
            };
            found[place] += 1;
        }
    }
    assert!(found.iter().all(|count| *count > 0), "{found:?}");
}

#[test]
fn sums_by_exponents_are_those_of_fractions() {
    let mut bits = Bits(4);
    assert_eq!(DecimalSum::default().total().total(), Rational::zero());
    for _ in 0..300 {
        let (left, right) = (numbers(&mut bits), numbers(&mut bits));
        let [mut sum, mut products] = [DecimalSum::default(), DecimalSum::default()];
        let [mut expected, mut expected_products] = [Rational::zero(), Rational::zero()];
        for (one, other) in left.iter().zip(&right) {
            sum.add(one.0.into(), one.1);
            expected = expected + exact(one);
            products.add(i128::from(one.0) * i128::from(other.0), one.1 + other.1);
            expected_products = expected_products + exact(one) * exact(other);
        }
        assert_eq!(sum.total().total(), expected);
        assert_eq!(products.total().total(), expected_products);
    }
}
