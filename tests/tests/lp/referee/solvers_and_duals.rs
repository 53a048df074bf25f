//! The solvers of this build on the fits that are hard for them, and what duals are good for.

use std::time::Duration;

use boundfit_check::{CheckOptions, EXACT_SIMPLEX, ProgramRows, answer_of, check, source_names};
use boundfit_exact::{Rational, Reading};
use boundfit_lp::{BoundClaim, Claimed, End, ExactOutcome, Referee, RefereeRow, Row, Verdict};
use boundfit_tests::generate::seeded;
use boundfit_tests::lp_cases::{hard_cases, number, ten_to, whole_rows};
use boundfit_tests::readings::problem;
use boundfit_tests::shape::Tally;
use rand::RngExt;

use super::judge::{Judge, Truth, value};

const LIMIT: Duration = Duration::from_secs(60);

fn options(solvers: &[String]) -> CheckOptions {
    CheckOptions {
        solvers: solvers.to_vec(),
        answers: Vec::new(),
        tolerance: ten_to(-6),
        as_printed: true,
        time_limit: LIMIT,
        directions: None,
        all_rows: true,
    }
}

#[test]
fn every_solver_is_judged_as_the_definitions_say() {
    let mut tally = Tally::default();
    for case in hard_cases() {
        let rows = ProgramRows::new(&case.problem);
        let received = rows.in_binary64().unwrap();
        let tolerance = ten_to(-6);
        for name in source_names() {
            let answer = answer_of(&name, &rows, LIMIT).unwrap();
            for (reading, rows) in [(Reading::Decimal, &rows), (Reading::Binary64, &received)] {
                let judge = Judge::new(rows.rows(), &tolerance);
                let referee = Referee::new(rows.rows().to_vec(), tolerance.clone());
                for axis in [0, 1] {
                    let judgements = referee.judge_interval(axis, &answer.claims[axis]);
                    judge.check(axis, &answer.claims[axis], &judgements);
                    if name == EXACT_SIMPLEX && reading == Reading::Decimal {
                        let verdicts = judgements.map(|judgement| judgement.verdict);
                        assert_eq!(verdicts, [Verdict::Exact; 2], "{}", case.name);
                    } else {
                        judgements.iter().for_each(|judgement| tally.count(judgement.verdict.name()));
                    }
                }
            }
        }
    }
    // The folder deserves its name.
    tally.assert_each(1, &["rounded", "unsafe", "wrong status", "loose"]);
}

#[test]
fn a_check_judges_each_reading_once() {
    for case in hard_cases() {
        let names = source_names();
        let found = check(&case.problem, Reading::Decimal, &options(&names)).unwrap();
        let float: Vec<&String> = names.iter().filter(|name| *name != EXACT_SIMPLEX).collect();
        let differs = found.rows.in_binary64().unwrap().rows() != found.rows.rows();
        let readings = if differs { 2 } else { 1 };
        // The exact simplex got no doubles.
        assert_eq!(found.answers.len(), readings * float.len() + 1, "{}", case.name);
        let rows = [found.rows.clone(), found.rows.in_binary64().unwrap()];
        let tolerance = ten_to(-6);
        for judged in &found.answers {
            let rows = &rows[usize::from(judged.reading == Reading::Binary64)];
            let judge = Judge::new(rows.rows(), &tolerance);
            for axis in [0, 1] {
                for end in [End::Lower, End::Upper] {
                    let exact = match judge.truth(axis, end) {
                        Truth::At(exact) => Some(exact),
                        _ => None,
                    };
                    assert_eq!(judged.bounds[axis][end as usize].exact, exact, "{}", case.name);
                }
            }
        }
        let worst = found.answers.iter().filter(|judged| judged.reading == Reading::Decimal);
        assert_eq!(found.worst(Reading::Decimal), worst.map(|judged| judged.worst()).max());
        // The expected answer of the file is the truth that the referee found.
        let exact = found.answers.iter().find(|judged| judged.source == EXACT_SIMPLEX).unwrap();
        for (axis, end) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let expected = case.expected["pui"][axis][end].as_str().map(number);
            assert_eq!(exact.bounds[axis][end].exact, expected, "{}", case.name);
        }
    }
    let case = &hard_cases()[0].problem;
    let unknown = check(case, Reading::Decimal, &options(&["glpk".to_owned()])).unwrap_err();
    assert_eq!((unknown.name.raw(), &unknown.available), ("glpk", &source_names()));
}

#[test]
fn right_duals_repair_wrong_digits() {
    let mut rng = seeded(71);
    let mut tally = Tally::default();
    for _ in 0..800 {
        let problem = problem(&mut rng);
        let rows = ProgramRows::new(&problem).rows().to_vec();
        let tolerance = ten_to(-6);
        let judge = Judge::new(&rows, &tolerance);
        let referee = Referee::new(rows.clone(), tolerance.clone());
        for (axis, end) in [(0, End::Lower), (0, End::Upper), (1, End::Lower), (1, End::Upper)] {
            let ExactOutcome::Optimal { multipliers, .. } = referee.truth(axis, end) else { continue };
            let exact = referee.exact_end(axis, end).unwrap();
            let mut right = vec![0.0; rows.len()];
            multipliers.iter().for_each(|multiplier| right[multiplier.row] = multiplier.value.to_f64());
            let repairable = |duals: &[f64]| {
                let claim = BoundClaim { duals: Some(duals.to_vec()), ..value(&(&exact + Rational::one())) };
                let mut claims = [value(&exact), value(&exact)];
                claims[end as usize] = claim;
                let found = referee.judge_interval(axis, &claims);
                judge.check(axis, &claims, &found);
                found[end as usize].repairable
            };
            assert_eq!(repairable(&right), Some(true));
            // The size of duals and a little noise on the others do not matter, their order does.
            let least = right.iter().copied().filter(|dual| *dual > 0.0).fold(f64::MAX, f64::min);
            let noisy: Vec<f64> =
                right.iter().map(|dual| if *dual > 0.0 { *dual } else { least * 1e-9 }).collect();
            assert_eq!(repairable(&noisy), Some(true));
            tally.count("right");
            assert_eq!(repairable(&vec![0.0; rows.len()]), Some(false));
            assert_eq!(repairable(&right.iter().map(|dual| -dual).collect::<Vec<_>>()), Some(false));
            assert_eq!(repairable(&right[1..]), None);
            assert_eq!(repairable(&[right.clone(), vec![0.0]].concat()), None);
            // Any two rows that are not parallel, one more important than the other.
            let (first, second) = (rng.random_range(0..rows.len()), rng.random_range(0..rows.len()));
            if turn(&rows[first].row, &rows[second].row).is_zero() {
                continue;
            }
            let mut other = vec![0.0; rows.len()];
            (other[first], other[second]) = (2.0, 1.0);
            tally.count(if repairable(&other) == Some(true) { "also right" } else { "wrong" });
        }
    }
    tally.assert_each(500, &["right", "wrong"]);
    tally.assert_each(30, &["also right"]);
}

fn turn(left: &Row, right: &Row) -> Rational {
    &left.a[0] * &right.a[1] - &left.a[1] * &right.a[0]
}

#[test]
fn duals_say_nothing_where_there_is_no_end() {
    let row = |a1: i64, a2: i64, b: i64| RefereeRow {
        row: Row { a: [a1.into(), a2.into()], b: b.into() },
        epsilon: None,
    };
    for rows in [vec![row(1, 0, 0), row(-1, 0, -1)], vec![row(0, 1, 1), row(0, -1, 1)]] {
        let referee = Referee::new(rows, ten_to(-6));
        let claim = BoundClaim { duals: Some(vec![1.0, 1.0]), ..value(&Rational::zero()) };
        assert_eq!(referee.judge(0, End::Upper, &claim).repairable, None);
    }
}

#[test]
fn the_second_of_two_parallel_rows_may_prove_the_end() {
    let rows = whole_rows(&[[1, 0, 5], [1, 0, 3], [-1, 0, 0], [0, 1, 1], [0, -1, 0]]);
    let rows = rows.into_iter().map(|row| RefereeRow { row, epsilon: None }).collect();
    let referee = Referee::new(rows, ten_to(-6));
    // The largest two duals belong to θ1 ≤ 5 and θ1 ≤ 3, or to -θ1 ≤ 0 and θ1 ≤ 3: either pair proves θ1 ≤ 3.
    for duals in [vec![2.0, 1.0, 0.0, 0.0, 0.0], vec![0.0, 1.0, 2.0, 0.0, 0.0]] {
        let claim =
            BoundClaim { claimed: Claimed::Value(Rational::from(4).into()), point: None, duals: Some(duals) };
        assert_eq!(referee.judge(0, End::Upper, &claim).repairable, Some(true));
    }
}
