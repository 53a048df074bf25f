//! The fewest readings to leave out against fits without every set of readings.

use boundfit_estimation::fit;
use boundfit_tests::readings::with_rows;
use boundfit_tests::shape::Tally;

use crate::document::{Lesson, count, fixtures, generated, items};

/// More ways than this are not offered.
const MOST: usize = 12;
/// The number of readings above which there are too many sets of them to try.
const MOST_READINGS: usize = 9;

/// The smallest sets of rows without which something is left, by trying all, in lexicographic order; none where nothing helps.
fn smallest(lesson: &Lesson) -> Vec<Vec<usize>> {
    let rows = lesson.problem.measurements.kept();
    let mut found: Vec<Vec<usize>> = Vec::new();
    for chosen in 0_u32..1 << rows.len() {
        let is_out = |index: usize| chosen >> index & 1 == 1;
        let least = found.first().map_or(usize::MAX, Vec::len);
        if chosen.count_ones() as usize > least {
            continue;
        }
        let rest = (0..rows.len()).filter(|&index| !is_out(index)).map(|index| rows[index].clone()).collect();
        if fit(&with_rows(&lesson.problem, rest)).is_empty() {
            continue;
        }
        let out: Vec<usize> =
            (0..rows.len()).filter(|&index| is_out(index)).map(|index| rows[index].row).collect();
        if out.len() < least {
            found.clear();
        }
        found.push(out);
    }
    found.sort();
    found
}

#[test]
fn the_fewest_readings_to_leave_out_are_those_of_trying_all() {
    let mut tally = Tally::default();
    for lesson in fixtures().into_iter().chain(generated(43, 400)) {
        let told = &lesson.data["outliers"];
        if lesson.data["fit"]["fps"]["kind"] != "empty" {
            assert!(told.is_null(), "{}", lesson.name);
            tally.count("nothing to leave out");
            continue;
        }
        if lesson.problem.measurements.kept().len() > MOST_READINGS {
            continue;
        }
        let expected = smallest(&lesson);
        let Some(first) = expected.first() else {
            assert!(told.is_null(), "{}", lesson.name);
            tally.count("conditions alone");
            continue;
        };
        assert_eq!(count(&told["least"]), first.len(), "{}", lesson.name);
        let ways: Vec<Vec<usize>> = items(&told["ways"]).map(|way| items(way).map(count).collect()).collect();
        assert!(ways.iter().all(|way| expected.contains(way)), "{}: {ways:?}", lesson.name);
        assert_eq!(ways.len(), expected.len().min(MOST), "{}: {ways:?}", lesson.name);
        assert_eq!(told["complete"], expected.len() <= MOST, "{}", lesson.name);
        tally.count(if first.len() > 1 { "several" } else { "one" });
    }
    tally.assert_each(20, &["nothing to leave out", "one", "several"]);
    tally.assert_each(1, &["conditions alone"]);
}
