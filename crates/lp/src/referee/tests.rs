use super::*;
use crate::RoundedTo;

/// θ1 in [0, 4] and θ2 in [0, 2], by rows with the error bounds 1, 2, 4 and none.
fn boxed() -> Vec<RefereeRow> {
    let bounds = [Some(1), Some(2), Some(4), None];
    rows(&[[1, 0, 4], [-1, 0, 0], [0, 1, 2], [0, -1, 0]], &bounds)
}

fn rows(rows: &[[i64; 3]], bounds: &[Option<i64>]) -> Vec<RefereeRow> {
    let row = |(&[a1, a2, b], epsilon): (&[i64; 3], &Option<i64>)| RefereeRow {
        row: Row { a: [a1.into(), a2.into()], b: b.into() },
        epsilon: epsilon.map(Rational::from),
    };
    rows.iter().zip(bounds).map(row).collect()
}

fn plain(texts: &[[i64; 3]]) -> Referee {
    Referee::new(rows(texts, &vec![Some(1); texts.len()]), hundredth())
}

fn hundredth() -> Rational {
    Rational::ratio(1, 100)
}

fn referee() -> Referee {
    Referee::new(boxed(), hundredth())
}

fn claim(claimed: Claimed) -> BoundClaim {
    BoundClaim { claimed, point: None, duals: None }
}

fn at(value: Rational) -> BoundClaim {
    claim(Claimed::Value(value.into()))
}

fn with_point(value: i64, point: [Rational; 2]) -> BoundClaim {
    BoundClaim { point: Some(point.map(Printed::exact)), ..at(value.into()) }
}

#[test]
fn the_true_ends() {
    let referee = referee();
    let ends = |axis| [End::Lower, End::Upper].map(|end| referee.exact_end(axis, end));
    assert_eq!(ends(0), [0, 4].map(|end| Some(Rational::from(end))));
    assert_eq!(ends(1), [0, 2].map(|end| Some(Rational::from(end))));
    assert!(
        matches!(referee.truth(1, End::Upper), ExactOutcome::Optimal { value, .. } if *value == Rational::from(-2))
    );
    assert_eq!(plain(&[[1, 0, 1]]).exact_end(0, End::Lower), None);
}

#[test]
fn values_by_how_far_they_are_off() {
    let referee = referee();
    let ulp = |steps: i64| {
        Rational::from(4) + Rational::from_f64(4.0 * f64::EPSILON).unwrap() * Rational::from(steps)
    };
    let upper = |value: Rational| referee.judge(0, End::Upper, &at(value));
    assert_eq!(upper(Rational::from(4)).verdict, Verdict::Exact);
    assert_eq!(upper(ulp(1)).verdict, Verdict::Rounded);
    assert_eq!(upper(ulp(4)).verdict, Verdict::Rounded);
    assert_eq!(upper(ulp(5)).verdict, Verdict::WithinTolerance);
    // The interval is 4 wide.
    assert_eq!(upper(Rational::ratio(404, 100)).verdict, Verdict::WithinTolerance);
    let loose = upper(Rational::ratio(405, 100));
    assert_eq!(loose.verdict, Verdict::Loose);
    assert_eq!(
        (loose.excess, loose.excess_in_units),
        (Some(Rational::ratio(1, 20)), Some((Rational::ratio(1, 80), ToleranceUnit::Width)))
    );
    assert_eq!((loose.exact, loose.claimed), (Some(4.into()), Some(Rational::ratio(81, 20))));
    assert_eq!(loose.witness, None);
    // The tolerance holds on either side.
    assert_eq!(upper(Rational::ratio(396, 100)).verdict, Verdict::WithinTolerance);
    assert_eq!(upper(Rational::ratio(3_959, 1_000)).verdict, Verdict::Unsafe);
    let cut = upper(Rational::from(3));
    assert_eq!((cut.verdict, cut.excess), (Verdict::Unsafe, Some(Rational::from(-1))));
    assert_eq!(cut.witness.unwrap()[0], Rational::from(4));
    let lower = |value: Rational| referee.judge(0, End::Lower, &at(value));
    assert_eq!(lower(Rational::ratio(-4, 100)).verdict, Verdict::WithinTolerance);
    let loose = lower(Rational::from(-1));
    assert_eq!((loose.verdict, loose.excess), (Verdict::Loose, Some(Rational::one())));
    assert_eq!(lower(Rational::one()).verdict, Verdict::Unsafe);
}

#[test]
fn without_a_width_errors_are_compared_with_the_end_or_with_epsilon() {
    // θ1 = 2 and θ2 = 0, and a half-line that ends at 2. The tolerance is a hundredth.
    let point = plain(&[[1, 0, 2], [-1, 0, -2], [0, 1, 0], [0, -1, 0]]);
    let ray = plain(&[[1, 0, 2], [0, 1, 0], [0, -1, 0]]);
    for referee in [&point, &ray] {
        let upper = |value| referee.judge(0, End::Upper, &at(value));
        let near = upper(Rational::ratio(202, 100));
        let expected = (Rational::ratio(1, 100), ToleranceUnit::Value);
        assert_eq!((near.verdict, near.excess_in_units), (Verdict::WithinTolerance, Some(expected)));
        assert_eq!(upper(Rational::ratio(198, 100)).verdict, Verdict::WithinTolerance);
        assert_eq!(upper(Rational::ratio(20_201, 10_000)).verdict, Verdict::Loose);
        assert_eq!(upper(Rational::ratio(19_799, 10_000)).verdict, Verdict::Unsafe);
        // Where the end is 0 too, in units of the smallest error bound.
        let zero = referee.judge(1, End::Upper, &at(hundredth()));
        let expected = (Rational::ratio(1, 100), ToleranceUnit::Epsilon);
        assert_eq!((zero.verdict, zero.excess_in_units), (Verdict::WithinTolerance, Some(expected)));
        assert_eq!(referee.judge(1, End::Upper, &at(Rational::ratio(1, 99))).verdict, Verdict::Loose);
    }
    // Without error bounds nothing is left to compare with.
    let rows = rows(&[[0, 1, 0], [0, -1, 0]], &[None, Some(0)]);
    let judged = Referee::new(rows, hundredth()).judge(1, End::Upper, &at(Rational::scientific(1, -30)));
    assert_eq!((judged.verdict, judged.excess_in_units), (Verdict::Loose, None));
}

#[test]
fn digits_that_were_not_printed_are_no_error() {
    // θ1 in [1/3, 2/3].
    let referee = Referee::new(rows(&[[3, 0, 2], [-3, 0, -1]], &[Some(1), Some(1)]), Rational::zero());
    let upper = |printed: Printed| referee.judge(0, End::Upper, &claim(Claimed::Value(printed)));
    let printed = |text: &str, value| Printed::typed(text, value);
    let found = upper(printed("0.667", Rational::ratio(667, 1_000)));
    assert_eq!((found.verdict, found.rounded_to), (Verdict::Rounded, Some(RoundedTo::Digits(3))));
    assert_eq!(found.excess, Some(Rational::ratio(1, 3_000)));
    assert_eq!(found.excess_in_units, Some((Rational::scientific(1, -3), ToleranceUnit::Width)));
    assert_eq!(upper(Printed::exact(Rational::ratio(667, 1_000))).verdict, Verdict::Loose);
    assert_eq!(upper(printed("0.666", Rational::ratio(666, 1_000))).verdict, Verdict::Unsafe);
    assert_eq!(upper(printed("0.67", Rational::ratio(67, 100))).verdict, Verdict::Loose);
    let double = upper(Printed::exact(Rational::from_f64(2.0 / 3.0).unwrap()));
    assert_eq!((double.verdict, double.rounded_to), (Verdict::Rounded, Some(RoundedTo::Binary64)));
}

#[test]
fn rounding_excuses_points_too() {
    // 3·θ1 = 1: no decimal attains it, and the nearest one may exceed it by three half units.
    let referee = Referee::new(rows(&[[3, 0, 1], [-3, 0, -1]], &[Some(1), Some(1)]), Rational::zero());
    let judged = |point: [Printed; 2]| {
        let claim = BoundClaim { point: Some(point), ..at(Rational::ratio(1, 3)) };
        referee.judge(0, End::Upper, &claim)
    };
    let printed = Printed::typed("0.3335", Rational::ratio(3_335, 10_000));
    assert_eq!(judged([printed, Printed::exact(Rational::zero())]).verdict, Verdict::InfeasiblePoint);
    let printed = Printed::typed("0.3333", Rational::ratio(3_333, 10_000));
    let found = judged([printed.clone(), Printed::exact(Rational::zero())]);
    assert_eq!((found.verdict, found.tau), (Verdict::Exact, Some(Rational::scientific(1, -4))));
    assert_eq!(found.violation, Some(Violation { row: 1, by: Rational::scientific(1, -4) }));
    let exactly = [printed.without_precision(), Printed::exact(Rational::zero())];
    assert_eq!(judged(exactly).verdict, Verdict::InfeasiblePoint);
    let double = Rational::from_f64(1.0 / 3.0).unwrap();
    assert_eq!(judged([double.into(), Printed::exact(Rational::zero())]).verdict, Verdict::Exact);
}

#[test]
fn points_are_measured_beside_wrong_statuses_too() {
    let half_plane = plain(&[[1, 0, 1]]);
    let point = [Rational::from(3), Rational::zero()];
    let judged = half_plane.judge(0, End::Lower, &with_point(0, point.clone()));
    assert_eq!((judged.verdict, judged.tau), (Verdict::WrongStatus, Some(Rational::from(2))));
    assert_eq!(judged.violation, Some(Violation { row: 0, by: Rational::from(2) }));
    // A point beside the right status: of an unbounded program it should be feasible, of an empty one none is.
    let with = |claimed| BoundClaim { point: Some(point.clone().map(Printed::exact)), ..claim(claimed) };
    let unbounded = half_plane.judge(0, End::Lower, &with(Claimed::Unbounded));
    assert_eq!((unbounded.verdict, unbounded.tau), (Verdict::InfeasiblePoint, Some(Rational::from(2))));
    let empty = plain(&[[1, 0, -1], [-1, 0, 0]]);
    let infeasible = empty.judge(0, End::Lower, &with(Claimed::Infeasible));
    assert_eq!((infeasible.verdict, infeasible.tau), (Verdict::Exact, Some(Rational::from(4))));
}

#[test]
fn statuses_in_all_combinations() {
    let empty = plain(&[[1, 0, -1], [-1, 0, 0]]);
    let half_plane = plain(&[[1, 0, 1]]);
    let bounded = referee();
    let judged = |referee: &Referee, end, claimed| {
        let Judgement { verdict, proof, .. } = referee.judge(0, end, &claim(claimed));
        (verdict, proof)
    };
    let right = (Verdict::Exact, None);
    let is_wrong = |found: &(Verdict, Option<Refutation>), kind: fn(&Refutation) -> bool| {
        assert_eq!(found.0, Verdict::WrongStatus);
        assert!(found.1.as_ref().is_some_and(kind), "{found:?}");
    };
    let (infeasible, unbounded, either) =
        (|| Claimed::Infeasible, || Claimed::Unbounded, || Claimed::InfeasibleOrUnbounded);

    assert_eq!(judged(&empty, End::Lower, infeasible()), right);
    assert_eq!(judged(&empty, End::Lower, either()), right);
    for claimed in [unbounded(), Claimed::Value(Rational::zero().into())] {
        is_wrong(
            &judged(&empty, End::Upper, claimed),
            |proof| matches!(proof, Refutation::Infeasible(by) if by.len() == 2),
        );
    }
    assert_eq!(judged(&half_plane, End::Lower, unbounded()), right);
    assert_eq!(judged(&half_plane, End::Lower, either()), right);
    is_wrong(&judged(&half_plane, End::Lower, infeasible()), |proof| {
        matches!(proof, Refutation::FeasiblePoint(_))
    });
    is_wrong(&judged(&half_plane, End::Lower, Claimed::Value(Rational::zero().into())), |proof| {
        matches!(proof, Refutation::Ray { .. })
    });
    is_wrong(&judged(&bounded, End::Upper, infeasible()), |proof| {
        matches!(proof, Refutation::FeasiblePoint(_))
    });
    for claimed in [unbounded(), either()] {
        is_wrong(
            &judged(&bounded, End::Upper, claimed),
            |proof| matches!(proof, Refutation::Bound(by) if by.len() == 1),
        );
    }
    let nothing = bounded.judge(0, End::Upper, &claim(Claimed::Nothing("out of time".to_owned())));
    assert_eq!((nothing.verdict, nothing.reason.as_deref()), (Verdict::NoAnswer, Some("out of time")));
    // The set is not empty, and that it ends is no contradiction to a value.
    assert_eq!(bounded.judge(0, End::Upper, &at(4.into())).proof, None);
}

#[test]
fn points_are_measured_in_error_bounds() {
    let referee = referee();
    let upper = |value, point| referee.judge(0, End::Upper, &with_point(value, point));
    let inside = upper(4, [Rational::from(4), Rational::one()]);
    assert_eq!((inside.verdict, inside.violation), (Verdict::Exact, None));
    assert_eq!((inside.tau, inside.tau_in_epsilon), (Some(Rational::zero()), Some(Rational::zero())));

    // Row 0 by 1 of 1, row 2 by 3 of 4: the first is the worst, the largest shift is that of the second.
    let outside = upper(4, [Rational::from(5), Rational::from(5)]);
    assert_eq!(outside.verdict, Verdict::InfeasiblePoint);
    assert_eq!(outside.violation, Some(Violation { row: 0, by: Rational::one() }));
    assert_eq!((outside.tau, outside.tau_in_epsilon), (Some(Rational::from(3)), Some(Rational::one())));
    // Row 1 by 1 of 2, row 2 by 6 of 4.
    let other = upper(4, [Rational::from(-1), Rational::from(8)]);
    assert_eq!(other.violation, Some(Violation { row: 2, by: Rational::from(6) }));
    assert_eq!(other.tau_in_epsilon, Some(Rational::ratio(3, 2)));

    // If rows are violated as much, the first is named: row 0 by 1 of 1, row 2 by 4 of 4.
    let tied = upper(4, [Rational::from(5), Rational::from(6)]);
    assert_eq!(tied.violation, Some(Violation { row: 0, by: Rational::one() }));

    // One hundredth of the error bound is within tolerance, and takes nothing from a bound that is right.
    let near = upper(4, [Rational::ratio(401, 100), Rational::one()]);
    assert_eq!((near.verdict, near.tau), (Verdict::Exact, Some(Rational::ratio(1, 100))));
    let far = upper(4, [Rational::ratio(4_011, 1_000), Rational::one()]);
    assert_eq!(far.verdict, Verdict::InfeasiblePoint);
    // One of two rows beyond tolerance is enough.
    let mixed = upper(4, [Rational::ratio(401, 100), Rational::from(5)]);
    assert_eq!(mixed.verdict, Verdict::InfeasiblePoint);
    // The worse of bound and point counts.
    let near = [Rational::ratio(401, 100), Rational::one()];
    assert_eq!(upper(9, near.clone()).verdict, Verdict::Loose);
    assert_eq!(upper(1, near).verdict, Verdict::Unsafe);
    assert_eq!(upper(9, [Rational::from(9), Rational::one()]).verdict, Verdict::InfeasiblePoint);
    assert_eq!(upper(1, [Rational::from(9), Rational::one()]).verdict, Verdict::Unsafe);
}

#[test]
fn conditions_are_measured_by_their_own_terms() {
    // θ2 ≥ 0 is violated by 1/2: all that its terms amount to.
    let judged = referee().judge(0, End::Upper, &with_point(4, [Rational::one(), Rational::ratio(-1, 2)]));
    assert_eq!((judged.verdict, judged.tau, judged.tau_in_epsilon), (Verdict::InfeasiblePoint, None, None));
    assert_eq!(judged.violation, Some(Violation { row: 3, by: Rational::ratio(1, 2) }));
    // 3·θ1 + 5·θ2 ≤ 92 at (20, 20/3): by 4/3 of 92 + 60 + 100/3.
    let rows = |bound: i64| {
        let terms = [[3, 5, 92], [-1, 0, 0], [0, -1, 0]];
        self::rows(&terms, &[None, Some(bound), Some(1)])
    };
    let point = [Rational::from(20), Rational::ratio(20, 3)];
    let share = Rational::ratio(4, 3).checked_div(&(Rational::from(152) + Rational::ratio(100, 3))).unwrap();
    let judge = |tolerance: Rational| {
        let claim =
            BoundClaim { point: Some(point.clone().map(Printed::exact)), ..at(Rational::ratio(92, 3)) };
        Referee::new(rows(1), tolerance).judge(0, End::Upper, &claim).verdict
    };
    assert_eq!(judge(share.clone()), Verdict::Exact);
    assert_eq!(judge(share * Rational::ratio(999, 1_000)), Verdict::InfeasiblePoint);
    // Negative terms have a size too: -θ1 ≤ 0 with no room at θ1 = -1/1000.
    let nothing = Referee::new(rows(0), hundredth());
    let judged = nothing.judge(0, End::Lower, &with_point(0, [Rational::ratio(-1, 1_000), Rational::one()]));
    assert_eq!(judged.verdict, Verdict::InfeasiblePoint);
    assert_eq!((judged.tau, judged.tau_in_epsilon), (Some(Rational::ratio(1, 1_000)), None));
}

#[test]
fn ends_in_the_wrong_order() {
    let verdicts = |referee: &Referee, lower: i64, upper: i64| {
        referee.judge_interval(0, &[at(lower.into()), at(upper.into())]).map(|judgement| judgement.verdict)
    };
    assert_eq!(verdicts(&referee(), 0, 4), [Verdict::Exact, Verdict::Exact]);
    assert_eq!(verdicts(&referee(), 2, 2), [Verdict::Unsafe, Verdict::Unsafe]);
    assert_eq!(verdicts(&referee(), 3, 1), [Verdict::InvertedInterval, Verdict::InvertedInterval]);
    let empty = plain(&[[1, 0, -1], [-1, 0, 0]]);
    assert_eq!(verdicts(&empty, 3, 1), [Verdict::WrongStatus, Verdict::WrongStatus]);
    // Ends that cross by no more than the tolerance are right both; of a point they do so half the time.
    let point = plain(&[[1, 0, 1], [-1, 0, -1]]);
    let crossed = |lower, upper| {
        let claims = [at(Rational::ratio(lower, 1_000)), at(Rational::ratio(upper, 1_000))];
        point.judge_interval(0, &claims).map(|judgement| judgement.verdict)
    };
    assert_eq!(crossed(1_001, 999), [Verdict::WithinTolerance; 2]);
    assert_eq!(crossed(1_000, 999), [Verdict::Exact, Verdict::WithinTolerance]);
    assert_eq!(crossed(1_000, 989), [Verdict::InvertedInterval; 2]);
    let lower = referee().judge_interval(1, &[at(0.into()), at(2.into())]);
    assert_eq!(lower.map(|judgement| judgement.verdict), [Verdict::Exact, Verdict::Exact]);
}

#[test]
fn what_duals_are_good_for() {
    // The corner (1, 0): by the first row alone, by the last two, or not at all.
    let corner = plain(&[[1, 0, 1], [1, 1, 1], [0, 1, 0], [2, -1, 2], [-1, 0, 0]]);
    let with = |referee: &Referee, end, duals: &[f64]| {
        referee.judge(0, end, &BoundClaim { duals: Some(duals.to_vec()), ..at(1.into()) }).repairable
    };
    let upper = |duals: &[f64]| with(&corner, End::Upper, duals);
    assert_eq!(upper(&[1.0, 0.0, 0.0, 0.0, 0.0]), Some(true));
    assert_eq!(upper(&[0.5, 0.9, 0.0, 0.0, 0.0]), Some(true));
    // Only the two largest count.
    assert_eq!(upper(&[0.5, 0.9, 0.8, 0.0, 0.0]), Some(false));
    // θ1 ≤ 1 is the second row less the third: no proof.
    assert_eq!(upper(&[0.0, 1.0, 1.0, 0.0, 0.0]), Some(false));
    // A third of the second and of the fourth row add up to θ1 ≤ 1.
    assert_eq!(upper(&[0.0, 0.7, 0.0, 0.2, 0.0]), Some(true));
    assert_eq!(upper(&[0.0, 0.2, 0.0, 0.7, 0.1]), Some(true));
    assert_eq!(upper(&[0.0, 0.0, 0.0, 0.0, 1.0]), Some(false));
    assert_eq!(upper(&[0.0, 0.0, 0.0, 0.0, 0.0]), Some(false));
    assert_eq!(upper(&[-1.0, 0.0, 0.0, 0.0, 0.0]), Some(false));
    assert_eq!(upper(&[1.0, 0.0, 0.0, 0.0]), None);
    assert_eq!(with(&corner, End::Lower, &[0.0, 0.0, 0.0, 0.0, 1.0]), Some(true));
    assert_eq!(with(&corner, End::Lower, &[1.0, 0.0, 0.0, 0.0, 0.0]), Some(false));
    // A row that is another one in other units, and one that is parallel but further out.
    let parallel = plain(&[[3, 0, 6], [1, 0, 5], [-2, 0, 0]]);
    assert_eq!(with(&parallel, End::Upper, &[1.0, 0.0, 0.0]), Some(true));
    assert_eq!(with(&parallel, End::Upper, &[0.0, 1.0, 0.0]), Some(false));
    assert_eq!(with(&parallel, End::Lower, &[0.0, 0.0, 0.1]), Some(true));
    // Nothing to prove where there is no end.
    assert_eq!(with(&plain(&[[1, 0, 1]]), End::Lower, &[1.0]), None);
    assert_eq!(with(&plain(&[[0, 0, -1]]), End::Lower, &[1.0]), None);
    // The same for θ2, whose rows have no θ1.
    let duals = BoundClaim { duals: Some(vec![0.0, 0.0, 1.0, 0.0]), ..at(2.into()) };
    assert_eq!(referee().judge(1, End::Upper, &duals).repairable, Some(true));
    let duals = BoundClaim { duals: Some(vec![1.0, 0.0, 0.0, 0.0]), ..at(2.into()) };
    assert_eq!(referee().judge(1, End::Upper, &duals).repairable, Some(false));
}
