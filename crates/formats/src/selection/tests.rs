//! Tests of rows that are picked.

use super::*;

#[test]
fn a_set_has_the_rows_that_were_named_and_no_others() {
    let named = [(2, Some(4)), (4, Some(6)), (9, Some(9)), (7, Some(7)), (12, None), (1, Some(1)), (3, None)]
        .map(|(first, last)| match last {
            Some(last) => RowRange::new(first, last).unwrap(),
            None => RowRange::from_row(first).unwrap(),
        });
    let is_in = |ranges: &[&RowRange], row: usize| ranges.iter().any(|range| range.rows().contains(&row));
    // Every subset of wanted ones, against every subset of others.
    let subset = |mask: usize| -> Vec<RowRange> {
        named.iter().enumerate().filter(|(k, _)| mask >> k & 1 == 1).map(|(_, range)| *range).collect()
    };
    for mask in 0..1 << named.len() {
        for other in 0..1 << named.len() {
            let (wanted, without) = (subset(mask), subset(other));
            let expected = |row: usize| {
                (wanted.is_empty() || is_in(&wanted.iter().collect::<Vec<_>>(), row))
                    && !is_in(&without.iter().collect::<Vec<_>>(), row)
            };
            let Some(set) = RowSet::new(&wanted, &without) else {
                assert!(!(1..100).any(expected), "{wanted:?} without {without:?}");
                continue;
            };
            let rows: Vec<usize> = (1..20).filter(|&row| expected(row)).collect();
            assert_eq!((1..20).filter(|&row| set.contains(row)).collect::<Vec<_>>(), rows);
            let among = set.among(1, 20);
            assert_eq!(among.iter().cloned().flatten().collect::<Vec<_>>(), rows);
            assert!(among.windows(2).all(|pair| pair[0].end < pair[1].start), "{among:?}");
            let mut all: Vec<usize> = among.iter().cloned().chain(between(&among, 1, 20)).flatten().collect();
            all.sort_unstable();
            assert_eq!(all, (1..20).collect::<Vec<_>>());
        }
    }
}

#[test]
fn what_is_named_beyond_the_end_is_told() {
    let range = |first, last| RowRange::new(first, last).unwrap();
    let set = RowSet::new(&[range(1, 5), RowRange::from_row(7).unwrap()], &[range(3, 9)]).unwrap();
    assert_eq!(set.beyond(9), None);
    assert_eq!(set.beyond(8).unwrap().to_string(), "3..9");
    assert_eq!(set.beyond(6).unwrap().to_string(), "7..");
    assert_eq!(set.beyond(4).unwrap().to_string(), "1..5");
    assert_eq!(range(5, 5).to_string(), "5");
    assert!(
        RowRange::new(0, 3).is_none() && RowRange::new(3, 2).is_none() && RowRange::from_row(0).is_none()
    );
}

#[test]
fn numbers_of_rows_are_found_both_ways() {
    let rows = [3, 4, 5, 9, 11, 12, 40];
    let mut numbers = RowNumbers::default();
    rows.iter().for_each(|&row| numbers.push(row));
    assert_eq!((0..numbers.len()).map(|index| numbers.get(index)).collect::<Vec<_>>(), rows);
    for row in 0..50 {
        assert_eq!(numbers.position(row), rows.iter().position(|&own| own == row));
    }
    let ranges = [[3, 5], [9, 9], [11, 12], [40, 40]];
    assert_eq!(numbers.ranges().collect::<Vec<_>>(), ranges);
    let mut appended: RowNumbers = [3..4, 4..6].into_iter().collect();
    appended.append(&[9..10, 11..13, 40..41].into_iter().collect());
    assert_eq!(appended, numbers);
    numbers.shift(2);
    assert_eq!(numbers.ranges().next(), Some([5, 7]));
    numbers.push(43);
    assert_eq!(numbers.ranges().last(), Some([42, 43]));
    assert!(RowNumbers::default().is_empty() && RowNumbers::default().position(1).is_none());
}

#[test]
fn conditions_compare_exactly() {
    let parse = |text: &str| RowCondition::parse(text, Reading::Decimal, &Limits::default());
    let third = Rational::ratio(1, 3);
    for (text, holds) in [
        ("x<1/3", [true, false, false]),
        ("x <= 1/3", [true, true, false]),
        (" x = 1/3 ", [false, true, false]),
        ("x == 1/3", [false, true, false]),
        ("x!=1/3", [true, false, true]),
        ("x >= 1/3", [false, true, true]),
        ("x > 1/3", [false, false, true]),
    ] {
        let condition = parse(text).unwrap();
        let tiny = Rational::scientific(1, -40);
        let around = [&third - &tiny, third.clone(), &third + &tiny];
        assert_eq!(around.map(|number| condition.holds(&number)), holds, "{text}");
        assert_eq!((condition.column().text().raw(), condition.text().raw()), ("x", text.trim()));
    }
}

#[test]
fn columns_of_conditions_are_names_or_numbers() {
    let column = |text: &str| {
        RowCondition::parse(text, Reading::Decimal, &Limits::default()).map(|condition| condition.column)
    };
    assert_eq!(column("r (Mpc) >= -2"), Ok(ColumnSelector::name("r (Mpc)")));
    assert_eq!(column("3 > 0"), Ok(ColumnSelector::name_or_number("3")));
    assert_eq!(column("\"a <= b\" > 0"), Ok(ColumnSelector::name("a <= b")));
    assert_eq!(column("'3'>0"), Ok(ColumnSelector::name("3")));
    for (text, message) in [
        ("x", "there is no comparison"),
        ("\"x\" y > 2", "there is no comparison"),
        ("x ! 2", "there is no comparison"),
        ("> 2", "there is no column before the comparison"),
        ("\"x > 2", "the quote before the column's name is not closed"),
        ("x > ", "\"\": not a number: nothing to read at character 1"),
        ("x > a", "\"a\": not a number: unexpected character 'a' at character 1"),
        ("1 < x < 2", "\"x < 2\": not a number: unexpected character 'x' at character 1"),
    ] {
        assert_eq!(column(text).unwrap_err().to_string(), message, "{text}");
    }
}
