//! The rows without which an empty set is not empty, against trying every row.

use boundfit_estimation::{ErrorBound, Problem, fit, mending_rows};
use boundfit_exact::Rational;
use boundfit_tests::definitions::least_bound;
use boundfit_tests::generate::seeded;
use boundfit_tests::readings::{problem, with_rows};

/// Returns whether the set is empty by ε_min, which cutting planes find without a feasible set or a contradiction.
fn is_empty(problem: &Problem) -> bool {
    let in_use = match problem.measurements.error_bound() {
        ErrorBound::Uniform(epsilon) => epsilon.clone(),
        _ => Rational::one(),
    };
    least_bound(problem).is_none_or(|(least, ..)| least > in_use)
}

#[test]
fn a_row_mends_the_set_if_the_rest_is_not_empty() {
    let mut rng = seeded(20_261_122);
    let mut seen = [0; 4];
    for _ in 0..1500 {
        let problem = problem(&mut rng);
        let answer = fit(&problem);
        let found = mending_rows(&problem, &answer);
        if !answer.is_empty() {
            assert_eq!(found, None);
            continue;
        }
        let rows = problem.measurements.all().unwrap();
        let rest = |row: usize| rows.iter().filter(|own| own.row != row).cloned().collect();
        let mut expected: Vec<usize> = rows.iter().map(|own| own.row).collect();
        expected.dedup();
        expected.retain(|row| !is_empty(&with_rows(&problem, rest(*row))));
        assert_eq!(found.as_deref(), Some(expected.as_slice()), "{problem:?}");
        seen[expected.len()] += 1;
    }
    assert!(seen.iter().all(|count| *count >= 5), "{seen:?}");
}
