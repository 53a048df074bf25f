//! Linear ranges against all runs, each judged by the oracle.

use boundfit_questions::{LinearRange, Order};
use boundfit_tests::generate::{seeded, share};
use boundfit_tests::readings::with_rows;
use boundfit_tests::runs::readings;

use super::window::verify;

/// Returns the least number of runs that cover these positions, by dynamic programming over all of them.
fn fewest(runs: &[[usize; 2]], count: usize) -> usize {
    let mut least = vec![0; count + 1];
    for position in 0..count {
        let ways = runs.iter().filter(|[first, last]| (*first..=*last).contains(&position));
        // Nothing is needed for a reading that no run has.
        least[position + 1] = ways.map(|[first, _]| least[*first] + 1).min().unwrap_or(least[position]);
    }
    least[count]
}

#[test]
fn runs_are_those_of_all_runs_that_no_other_one_contains() {
    let mut rng = seeded(165);
    let (mut several, mut alone, mut whole) = (0, 0, 0);
    for case in 0..share(2_500) {
        let readings = readings(&mut rng, 8);
        let problem = readings.problem();
        for order in [Order::X, Order::Row] {
            let range = LinearRange::of(&problem, order);
            let expected: Vec<usize> =
                if order == Order::X { readings.by_x() } else { (0..readings.rows.len()).collect() };
            assert_eq!(range.order, expected, "case {case}");
            let runs: Vec<[usize; 2]> = range.runs.iter().map(|run| [run.first, run.last]).collect();
            let brute = readings.maximal_runs(&expected, order == Order::X);
            assert_eq!(runs, brute, "case {case}, {order:?}: {readings:?}");
            let longest = brute.iter().map(|[first, last]| last - first + 1).max();
            let first = brute.iter().find(|[first, last]| Some(last - first + 1) == longest);
            assert_eq!(range.longest().map(|run| [run.first, run.last]), first.copied());
            let chosen = range.fewest();
            assert_eq!(chosen.len(), fewest(&brute, expected.len()), "case {case}, {order:?}: {readings:?}");
            for position in 0..expected.len() {
                let is_in = |runs: &[[usize; 2]]| {
                    runs.iter().any(|[first, last]| (*first..=*last).contains(&position))
                };
                let chosen: Vec<[usize; 2]> = chosen.iter().map(|run| [run.first, run.last]).collect();
                assert_eq!(is_in(&brute), is_in(&chosen), "case {case}, {order:?}: {readings:?}");
                assert_eq!(range.alone.iter().any(|(own, _)| *own == position), !is_in(&brute));
            }
            let some = |first: usize, last: usize| {
                let row = |&position: &usize| problem.measurements.kept()[position].clone();
                with_rows(&problem, range.order[first..=last].iter().map(row).collect())
            };
            // The first and the last position of the place of one.
            let place = |position: usize| {
                let is_same = |&other: &usize| {
                    let [one, other] = [expected[position], expected[other]];
                    one == other || order == Order::X && readings.are_one_place(one, other)
                };
                let mut all = (0..expected.len()).filter(is_same);
                let first = all.next().unwrap();
                [first, all.next_back().unwrap_or(first)]
            };
            for run in &range.runs {
                assert_eq!(
                    (run.before.is_none(), run.after.is_none()),
                    (run.first == 0, run.last + 1 == expected.len())
                );
                if let Some(before) = &run.before {
                    verify(before, &some(place(run.first - 1)[0], run.last));
                }
                if let Some(after) = &run.after {
                    verify(after, &some(run.first, place(run.last + 1)[1]));
                }
            }
            for (position, contradiction) in &range.alone {
                let [first, last] = place(*position);
                verify(contradiction, &some(first, last));
                alone += 1;
            }
            several += usize::from(runs.len() > 1);
            whole += usize::from(runs == [[0, expected.len() - 1]]);
        }
    }
    assert!(
        several > share(1_000) && alone > share(100) && whole > share(500),
        "{several}, {alone}, {whole}"
    );
}
