//! Outliers against an oracle that tries every set of rows, and cuts the plane into columns.

use std::collections::BTreeSet;

use boundfit_estimation::{Condition, ErrorBound, Measurement, Measurements, Model, Problem};
use boundfit_exact::{Endpoint, Rational};
use boundfit_questions::{NoOutliers, OutlierLimits, Outliers};
use boundfit_tests::generate::{one_in, seeded, share};
use boundfit_tests::oracle;
use boundfit_tests::outliers::{Case, Relaxed, Strip, relaxed};
use boundfit_tests::readings::parse_condition;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// Returns up to nine readings, degenerate more often than not.
/// - Few different x and y, or all x equal.
/// - Bounds that coincide or cross, and one-sided bounds.
/// - Regressors 0, repeated and parallel rows, rows through one point.
fn case(rng: &mut ChaCha8Rng, most: usize) -> Case {
    let style = rng.random_range(0..8);
    let size: i64 = [1, 2, 3, 9][rng.random_range(0..4)];
    let count = rng.random_range(0..=most);
    let mut rows: Vec<Strip> = Vec::new();
    while rows.len() < count {
        let mut small = || rng.random_range(-size..=size);
        let (x, y) = (small(), small());
        let a = match style {
            0 => [2, 1],
            1 => [small(), small()],
            2 => [small().signum(), 0],
            3 => [0, small().signum()],
            _ => [x, 1],
        };
        let y = if style == 7 { 3 * x + 1 + y.signum() } else { y };
        let epsilon = rng.random_range(0..=2);
        let mut row = Strip { a, lower: Some(y - epsilon), upper: Some(y + epsilon) };
        match (rng.random_range(0..12), rows.last()) {
            (0, _) => row.lower = None,
            (1, _) => row.upper = None,
            (2, _) => row.lower = row.upper.map(|upper| upper + 1),
            (3 | 4, Some(last)) => row = last.clone(),
            (5, Some(last)) => row.a = last.a,
            _ => {}
        }
        rows.push(row);
    }
    let conditions = (0..rng.random_range(0..=3_usize).saturating_sub(1)).map(|_| {
        let a = [rng.random_range(-2..=2), rng.random_range(-2..=2)];
        let b = rng.random_range(-3..=3);
        let lower = rng.random_bool(0.3).then_some(b);
        Strip { a, lower, upper: Some(b) }
    });
    let conditions = conditions.collect();
    Case { rows, conditions }
}

fn problem(case: &Case) -> Problem {
    let number = |value: &i64| Rational::from(*value);
    let rows = (1..).zip(&case.rows).map(|(row, strip)| {
        let [u, v] = strip.a.map(Rational::from);
        Measurement::between(row, [u, v], strip.lower.as_ref().map(number), strip.upper.as_ref().map(number))
    });
    let model = Model::TwoRegressors { regressors: ["u".into(), "v".into()] };
    let bound = ErrorBound::Interval { lower: Some("lower".into()), upper: Some("upper".into()) };
    let conditions = case.conditions.iter().map(condition).collect();
    Problem { measurements: Measurements::new(model, "y".into(), bound, rows.collect()), conditions }
}

fn condition(strip: &Strip) -> Condition {
    let (relation, [a, b]) = (if strip.lower.is_some() { "=" } else { "<=" }, strip.a);
    let right = strip.upper.expect("an upper bound");
    parse_condition(&format!("{a}*theta1 + {b}*theta2 {relation} {right}"))
}

/// The half-planes of what is left without some rows.
fn half_planes(case: &Case, without: &[usize]) -> Vec<oracle::Row> {
    let kept = (0..case.rows.len()).filter(|row| !without.contains(row)).map(|row| &case.rows[row]);
    let sides = kept.chain(&case.conditions).flat_map(|strip| {
        let [a, b] = strip.a.map(i128::from);
        let upper = strip.upper.map(|upper| [a, b, i128::from(upper)]);
        let lower = strip.lower.map(|lower| [-a, -b, -i128::from(lower)]);
        upper.into_iter().chain(lower)
    });
    sides.collect()
}

fn check_pieces(case: &Case, found: &Outliers) {
    for piece in &found.pieces {
        let without: Vec<usize> = piece.rows.iter().map(|row| row - 1).collect();
        let expected = oracle::solve(&half_planes(case, &without));
        let region = piece.left.polyhedron().region();
        assert_eq!(region.kind().name(), expected.kind, "{case:?} {without:?}");
        let vertices: BTreeSet<[Rational; 2]> =
            region.vertices().iter().map(|vertex| vertex.point().coordinates()).collect();
        let small = |value: i128| Rational::from(i64::try_from(value).expect("a small number"));
        let corner =
            |[x, y, w]: [i128; 3]| [x, y].map(|part| small(part).checked_div(&small(w)).expect("a weight"));
        let corners: BTreeSet<[Rational; 2]> =
            expected.vertices.iter().map(|(vertex, _)| corner(*vertex)).collect();
        assert_eq!(vertices, corners, "{case:?} {without:?}");
        assert_eq!(region.rays().len(), expected.rays.len());
        assert_eq!(region.lines().len(), expected.lines.len());
        // Every half-plane through a corner is named.
        let names: BTreeSet<usize> = region.vertices().iter().map(|vertex| vertex.active().len()).collect();
        let active: BTreeSet<usize> = expected.vertices.iter().map(|(_, active)| active.len()).collect();
        assert_eq!(names, active, "{case:?} {without:?}");
    }
}

fn check_growth(case: &Case, problem: &Problem, found: &Outliers, most: usize) {
    let growth = found.growth(problem, most, &OutlierLimits::default()).expect("within the limits");
    assert_eq!(growth.len(), most.min(case.rows.len()) + 1);
    for own in growth {
        let expected = relaxed(case, own.most);
        let ranges = own.pui.map(|pui| {
            pui.map(|range| [range.lower(), range.upper()].map(|end: &Endpoint| end.value().cloned()))
        });
        let area = own.area.map(|area| Rational::from(area.total()));
        let own = Relaxed { pieces: own.pieces, holes: own.holes, ranges, area };
        assert_eq!(own, expected, "{case:?}");
    }
}

#[test]
fn the_least_number_and_every_set_of_so_many_agree_with_trying_all() {
    let mut rng = seeded(41);
    let (mut empty, mut several, mut none) = (0, 0, 0);
    for round in 0..2500 {
        let case = case(&mut rng, 9);
        let problem = problem(&case);
        // Most of them by the tree alone, the others by walks alone where that is not at the very first level.
        let steps = if round % 2 == 0 { OutlierLimits::default().steps } else { 1_000 };
        let limits = OutlierLimits { steps, ..OutlierLimits::default() };
        let found = match (Outliers::new(&problem, &limits), case.least()) {
            (Err(NoOutliers::Conditions(_)), None) => {
                none += 1;
                continue;
            }
            (Ok(found), Some((least, sets))) => {
                assert_eq!(found.least, least, "{case:?}");
                let own: Vec<Vec<usize>> = found.pieces.iter().map(|piece| piece.rows.clone()).collect();
                let sets: Vec<Vec<usize>> =
                    sets.iter().map(|set| set.iter().map(|row| row + 1).collect()).collect();
                assert_eq!(own, sets, "{case:?}");
                assert!(found.is_complete);
                found
            }
            (found, expected) => panic!("{case:?}: {found:?}, not {expected:?}"),
        };
        empty += usize::from(found.least > 0);
        several += usize::from(found.pieces.len() > 1);
        check_pieces(&case, &found);
    }
    assert!(empty > 800 && several > 300 && none > 20, "{empty} {several} {none}");
}

#[test]
fn the_growth_agrees_with_columns_through_all_crossings() {
    let mut rng = seeded(42);
    let mut holes = 0;
    for _ in 0..share(700) {
        let case = case(&mut rng, 6);
        let problem = problem(&case);
        let Ok(found) = Outliers::new(&problem, &OutlierLimits::default()) else { continue };
        check_growth(&case, &problem, &found, case.rows.len());
        holes += usize::from(relaxed(&case, found.least + 1).holes > 0);
    }
    assert!(holes > 5 / one_in(), "{holes}");
}
