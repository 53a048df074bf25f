//! Claimed statuses in all combinations with the true ones.

use boundfit_check::ProgramRows;
use boundfit_exact::Rational;
use boundfit_lp::{BoundClaim, Claimed, End, Printed, Referee, RefereeRow, Refutation, Row, Verdict};
use boundfit_tests::generate::seeded;
use boundfit_tests::lp_cases::{fine, rows, ten_to, whole_rows};
use boundfit_tests::readings::problem;
use boundfit_tests::shape::Tally;
use rand::RngExt;

use super::judge::{Judge, Truth, claim, value};

fn claims(rng: &mut rand_chacha::ChaCha8Rng) -> [BoundClaim; 5] {
    [
        value(&fine(rng)),
        claim(Claimed::Infeasible),
        claim(Claimed::Unbounded),
        claim(Claimed::InfeasibleOrUnbounded),
        claim(Claimed::Nothing("out of time".to_owned())),
    ]
}

fn name(claimed: &Claimed) -> &'static str {
    match claimed {
        Claimed::Value(_) => "value",
        Claimed::Infeasible => "infeasible",
        Claimed::Unbounded => "unbounded",
        Claimed::InfeasibleOrUnbounded => "either",
        Claimed::Nothing(_) => "nothing",
    }
}

#[test]
fn every_wrong_status_is_proved_wrong() {
    let mut rng = seeded(61);
    let mut tally = Tally::default();
    for case in 0..1_200 {
        let rows: Vec<RefereeRow> = if case % 2 == 0 {
            ProgramRows::new(&problem(&mut rng)).rows().to_vec()
        } else {
            let epsilon = |rng: &mut rand_chacha::ChaCha8Rng| {
                [None, Some(Rational::zero()), Some(Rational::one())][rng.random_range(0..3)].clone()
            };
            let plain = rows(&mut rng);
            plain.into_iter().map(|row| RefereeRow { row, epsilon: epsilon(&mut rng) }).collect()
        };
        let tolerance = ten_to(-6);
        let judge = Judge::new(&rows, &tolerance);
        let referee = Referee::new(rows.clone(), tolerance.clone());
        for axis in [0, 1] {
            let offered = claims(&mut rng);
            for (lower, upper) in
                offered.iter().flat_map(|lower| offered.iter().map(move |upper| (lower, upper)))
            {
                let mut pair = [lower.clone(), upper.clone()];
                if rng.random_bool(0.3) {
                    pair[0].point = Some([fine(&mut rng), fine(&mut rng)].map(Printed::exact));
                    pair[1].duals = Some(vec![0.5; rng.random_range(0..=rows.len().min(1))]);
                }
                let judgements = referee.judge_interval(axis, &pair);
                judge.check(axis, &pair, &judgements);
                for (end, judgement) in [End::Lower, End::Upper].into_iter().zip(judgements) {
                    let claimed = &pair[end as usize].claimed;
                    let combination = match (judge.truth(axis, end), judgement.verdict, judgement.proof) {
                        (Truth::Empty, Verdict::WrongStatus, Some(Refutation::Infeasible(_))) => {
                            match name(claimed) {
                                "value" => "empty: value",
                                "unbounded" => "empty: unbounded",
                                other => panic!("{other} is right about an empty set"),
                            }
                        }
                        (Truth::Unbounded, Verdict::WrongStatus, Some(Refutation::Ray { .. })) => {
                            match name(claimed) {
                                "value" => "unbounded: value",
                                other => panic!("{other} is right about an unbounded end"),
                            }
                        }
                        (Truth::Unbounded, Verdict::WrongStatus, Some(Refutation::FeasiblePoint(_))) => {
                            "unbounded: infeasible"
                        }
                        (Truth::At(_), Verdict::WrongStatus, Some(Refutation::FeasiblePoint(_))) => {
                            "bounded: infeasible"
                        }
                        (Truth::At(_), Verdict::WrongStatus, Some(Refutation::Bound(_))) => {
                            match name(claimed) {
                                "unbounded" => "bounded: unbounded",
                                "either" => "bounded: either",
                                other => panic!("{other} is right about a bounded end"),
                            }
                        }
                        (truth, Verdict::WrongStatus, proof) => panic!("{truth:?} {claimed:?} {proof:?}"),
                        (_, _, None) => "right",
                        (truth, verdict, proof) => panic!("{truth:?} {claimed:?} {verdict:?} {proof:?}"),
                    };
                    tally.count(combination);
                }
            }
        }
    }
    let cases = [
        "empty: value",
        "empty: unbounded",
        "unbounded: value",
        "unbounded: infeasible",
        "bounded: infeasible",
        "bounded: unbounded",
        "bounded: either",
        "right",
    ];
    tally.assert_each(1_000, &cases);
}

#[test]
fn no_answer_is_no_refutation() {
    let rows = whole_rows(&[[1, 0, 1], [-1, 0, 0], [0, 1, 1], [0, -1, 0]]);
    let rows = rows.into_iter().map(|row| RefereeRow { row, epsilon: None }).collect();
    let referee = Referee::new(rows, ten_to(-6));
    let nothing = BoundClaim {
        point: Some([Rational::from(9), Rational::from(9)].map(Printed::exact)),
        ..claim(Claimed::Nothing("crashed".to_owned()))
    };
    let found = referee.judge(0, End::Lower, &nothing);
    assert_eq!((found.verdict, found.reason.as_deref()), (Verdict::NoAnswer, Some("crashed")));
    assert_eq!((found.exact, found.tau, found.violation), (Some(Rational::zero()), None, None));
    assert!(!found.verdict.is_refutation());
    // The lower end above an end that nobody claims is not an inverted interval.
    let pair = [value(&Rational::from(5)), claim(Claimed::Nothing("crashed".to_owned()))];
    let verdicts = referee.judge_interval(0, &pair).map(|judgement| judgement.verdict);
    assert_eq!(verdicts, [Verdict::Unsafe, Verdict::NoAnswer]);
}

#[test]
fn verdicts_are_ordered_from_best_to_worst() {
    let ordered = [
        Verdict::Exact,
        Verdict::Rounded,
        Verdict::WithinTolerance,
        Verdict::NoAnswer,
        Verdict::Loose,
        Verdict::InfeasiblePoint,
        Verdict::Unsafe,
        Verdict::InvertedInterval,
        Verdict::WrongStatus,
    ];
    assert!(ordered.is_sorted_by(|left, right| left < right));
    let refutations: Vec<&str> =
        ordered.into_iter().filter(|verdict| verdict.is_refutation()).map(Verdict::name).collect();
    let expected = ["loose", "infeasible point", "unsafe", "inverted interval", "wrong status"];
    assert_eq!(refutations, expected);
}

#[test]
fn an_empty_or_unbounded_set_needs_no_rows_of_readings() {
    let never = RefereeRow {
        row: Row { a: [Rational::zero(), Rational::zero()], b: -Rational::one() },
        epsilon: None,
    };
    let referee = Referee::new(vec![never], ten_to(-6));
    assert_eq!(referee.judge(0, End::Upper, &claim(Claimed::Infeasible)).verdict, Verdict::Exact);
    assert_eq!(referee.judge(0, End::Upper, &claim(Claimed::Unbounded)).verdict, Verdict::WrongStatus);
    let referee = Referee::new(Vec::new(), ten_to(-6));
    assert_eq!(referee.judge(1, End::Lower, &claim(Claimed::Unbounded)).verdict, Verdict::Exact);
    assert_eq!(referee.judge(1, End::Lower, &claim(Claimed::Infeasible)).verdict, Verdict::WrongStatus);
}
