//! Tests of columns of long numbers.

use super::super::Column;
use super::*;
use crate::{Limits, Reading};

fn read(text: &str) -> Rational {
    Reading::Decimal.read(text, &Limits::default()).unwrap()
}

/// Texts of 1 to 100 digits with the point anywhere, and small and large exponents.
fn texts() -> Vec<String> {
    let mut state = 7_u64;
    let mut below = |most: u64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) % most
    };
    (0..400)
        .map(|_| {
            let count = 1 + below(100);
            let digits: String = (0..count).map(|_| char::from(b'0' + below(10) as u8)).collect();
            let (whole, fraction) = digits.split_at(below(count + 1) as usize);
            let sign = ["", "-", "+"][below(3) as usize];
            let exponent = ["", "", "e-5", "E17", "e-40"][below(5) as usize];
            format!("{sign}{whole}.{fraction}{exponent}")
        })
        .collect()
}

fn column(texts: &[String]) -> Long {
    let mut column = Long::new();
    texts.iter().for_each(|text| column.push(&long_number(text.as_bytes()).unwrap()).unwrap());
    column
}

#[test]
fn numbers_keep_their_values_order_and_sums() {
    let texts = texts();
    let column = column(&texts);
    let values: Vec<Rational> = texts.iter().map(|text| read(text)).collect();
    assert_eq!((0..column.len()).map(|index| column.get(index)).collect::<Vec<_>>(), values);
    let (mut total, mut products) =
        (LongTotal::new(column.width()), LongProducts::new(column.width(), column.width()));
    let mut expected = [Rational::zero(), Rational::zero()];
    for (index, pair) in values.windows(2).enumerate() {
        let [words, next] = [column.words(index), column.words(index + 1)];
        assert_eq!(compare_words(words, next), pair[0].cmp(&pair[1]), "{pair:?}");
        total.add(words);
        products.add(words, next);
        let [sum, of_products] = &expected;
        expected = [sum + &pair[0], of_products + &pair[0] * &pair[1]];
    }
    let unit = column.unit().value();
    assert_eq!(Rational::from(total.total()) * &unit, expected[0]);
    assert_eq!(Rational::from(products.total()) * &unit * unit, expected[1]);
}

#[test]
fn what_is_above_a_threshold_is_above_its_words() {
    let texts = texts();
    let column = column(&texts);
    for threshold in ["0", "1/3", "-1/7", "5", "-5e-39", "1e300", "-1e300", &texts[3], &texts[4]] {
        let threshold = read(threshold);
        let floor = column.floor_of(&threshold);
        for (index, text) in texts.iter().enumerate() {
            let is_above = compare_words(column.words(index), &floor).is_gt();
            assert_eq!(is_above, read(text) > threshold, "{text} {threshold}");
        }
    }
}

#[test]
fn columns_leave_one_width_for_another_in_any_order() {
    let texts = texts();
    for start in 0..20 {
        let mut column = Column::default();
        let mut expected = Vec::new();
        for (index, text) in texts.iter().skip(19 * start).take(30).enumerate() {
            let value = read(text);
            match (index + start) % 4 {
                0 => column.push_decimal(index as i64 - 3, -(index as i32)),
                1 => column.push_long_decimal(i128::MAX - 7, index as i32 - 20),
                2 => assert!(column.push_text(text.as_bytes()), "{text}"),
                _ => {
                    let mut other = Column::default();
                    assert!(other.push_text(text.as_bytes()));
                    column.append(&other, 0..1);
                }
            }
            expected.push(match (index + start) % 4 {
                0 => Rational::scientific(index as i64 - 3, -(index as i32)),
                1 => Rational::scientific(i128::MAX - 7, index as i32 - 20),
                _ => value,
            });
        }
        assert!(matches!(column, Column::Long(_)));
        let values: Vec<Rational> = (0..column.len()).map(|index| column.get(index)).collect();
        assert_eq!(values, expected);
        let part: Vec<Rational> = (0..9).map(|index| column.part(5..14).get(index)).collect();
        assert_eq!(part, expected[5..14]);
    }
}

#[test]
fn numbers_too_far_apart_are_left_to_fractions() {
    let mut column = Column::default();
    assert!(column.push_text(b"1e200"));
    assert!(!column.push_text(b"1e-200"));
    assert_eq!((column.len(), column.get(0)), (1, read("1e200")));
    column.push(read("1e-200"));
    assert!(matches!(column, Column::Fractions(_)));
    assert_eq!([column.get(0), column.get(1)], [read("1e200"), read("1e-200")]);
    for text in ["", "-", ".", "1e", "1 ", "1/3", "0x1", "1e10000", "nan", "1.2.3", &"1".repeat(271)] {
        assert!(!Column::default().push_text(text.as_bytes()), "{text}");
    }
    assert!(Column::default().push_text("1".repeat(270).as_bytes()));
}
