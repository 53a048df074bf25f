//! Right answers made wrong by a known amount: the referee must find exactly that amount.

use boundfit_check::ProgramRows;
use boundfit_estimation::{Condition, Problem};
use boundfit_exact::Rational;
use boundfit_lp::{BoundClaim, Claimed, End, Judgement, Printed, Referee, ToleranceUnit, Verdict};
use boundfit_tests::generate::seeded;
use boundfit_tests::lp_cases::{fine, line_problem, number, ten_to};
use boundfit_tests::readings::{parse_condition, problem, with_error_bound, y_and_epsilon};
use boundfit_tests::shape::Tally;
use rand::RngExt;
use rand::seq::SliceRandom;

use super::judge::{Judge, Truth, ulp, value};

const ENDS: [End; 2] = [End::Lower, End::Upper];

fn tolerance() -> Rational {
    ten_to(-6)
}

/// Known errors of an end, outward positive: none, far below an ulp, ulps, parts of the width, many widths.
fn errors(exact: &Rational, end: End, width: Option<&Rational>) -> Vec<Rational> {
    let unit = width.filter(|width| width.is_positive()).cloned().unwrap_or_else(Rational::one);
    let mut sizes = vec![exact.abs() * ten_to(-30), &unit * ten_to(-30)];
    // Just below, at and just above the tolerance.
    let just = ten_to(-20);
    sizes.extend([-&just, Rational::zero(), just].map(|d| &unit * tolerance() * (Rational::one() + d)));
    sizes.extend(["1e-9", "1/3", "1/2", "1", "7", "1e6", "1e40"].map(|size| &unit * number(size)));
    let mut errors: Vec<Rational> = sizes.iter().flat_map(|size| [size.clone(), -size]).collect();
    let nearest = exact.to_f64();
    let stepped = |count: usize, step: fn(f64) -> f64| {
        let double = (0..count).fold(nearest, |double, _| step(double));
        let claimed = Rational::from_f64(double).unwrap();
        if end == End::Upper { claimed - exact } else { exact - claimed }
    };
    for count in [0, 1, 2, 3, 4, 5, 9] {
        errors.extend([stepped(count, f64::next_up), stepped(count, f64::next_down)]);
    }
    errors.push(Rational::zero());
    errors
}

/// The claim that is off by so much, outward.
fn off_by(exact: &Rational, end: End, error: &Rational) -> Rational {
    if end == End::Upper { exact + error } else { exact - error }
}

/// Returns the growth of the error bounds that a point needs, from the readings themselves; `None` beside a
/// condition.
fn needed(problem: &Problem, theta: &[Rational; 2]) -> Option<Rational> {
    let mut conditions = problem.conditions.iter().flat_map(Condition::inequalities);
    if conditions.any(|inequality| inequality.slack(theta).is_negative()) {
        return None;
    }
    let growth = problem.measurements.kept().iter().map(|row| {
        let predicted = &row.regressor[0] * &theta[0] + &row.regressor[1] * &theta[1];
        let (y, epsilon) = y_and_epsilon(row);
        (y - predicted).abs() - epsilon
    });
    growth.chain([Rational::zero()]).max()
}

/// An answer with one end replaced; the other one is right.
fn interval(judge: &Judge<'_>, axis: usize, end: End, wrong: BoundClaim) -> [BoundClaim; 2] {
    ENDS.map(|other| match judge.truth(axis, other) {
        _ if other == end => wrong.clone(),
        Truth::At(exact) => value(&exact),
        _ => BoundClaim { claimed: Claimed::Unbounded, point: None, duals: None },
    })
}

#[test]
fn the_referee_reports_exactly_the_known_error() {
    let mut rng = seeded(51);
    let mut pairs = 0;
    let mut tally = Tally::default();
    while pairs < 3_000 {
        let problem = problem(&mut rng);
        let rows = ProgramRows::new(&problem);
        let tolerance = tolerance();
        let judge = Judge::new(rows.rows(), &tolerance);
        let referee = Referee::new(rows.rows().to_vec(), tolerance.clone());
        for (axis, end) in [0, 1].into_iter().flat_map(|axis| ENDS.map(|end| (axis, end))) {
            let Truth::At(exact) = judge.truth(axis, end) else { continue };
            assert_eq!(referee.exact_end(axis, end).as_ref(), Some(&exact));
            pairs += 1;
            let width = judge.width(axis);
            let attained = judge.attained_at(axis, end).unwrap();
            let mut errors = errors(&exact, end, width.as_ref());
            errors.shuffle(&mut rng);
            for error in errors.into_iter().take(12) {
                let claimed = off_by(&exact, end, &error);
                // Alone, with the right point, with the point moved as far, or with any point.
                let mut moved = attained.clone();
                moved[axis] = claimed.clone();
                let any = [fine(&mut rng), fine(&mut rng)];
                let points = [None, Some(attained.clone()), Some(moved), Some(any)];
                let point = points[rng.random_range(0..4)].clone();
                let printed = point.clone().map(|point| point.map(Printed::exact));
                let claim = BoundClaim { point: printed, ..value(&claimed) };
                let claims = interval(&judge, axis, end, claim.clone());
                let judgements = referee.judge_interval(axis, &claims);
                judge.check(axis, &claims, &judgements);
                let found = referee.judge(axis, end, &claim);
                assert_eq!(found.excess.as_ref(), Some(&error));
                let widths = width.as_ref().and_then(|width| error.checked_div(width));
                let is_width = |unit: &ToleranceUnit| *unit == ToleranceUnit::Width;
                let in_widths = found.excess_in_units.clone().filter(|(_, unit)| is_width(unit));
                assert_eq!(in_widths.map(|(size, _)| size), widths);
                assert_eq!(found.tau, point.as_ref().and_then(|point| needed(&problem, point)));
                let is_rounding = error.abs() <= ulp(&exact).unwrap() * Rational::from(4);
                let unit = width.clone().filter(Rational::is_positive).unwrap_or_else(|| exact.abs());
                if error.is_negative() && !is_rounding && error.abs() > unit * &tolerance && !exact.is_zero()
                {
                    assert!(found.verdict >= Verdict::InfeasiblePoint, "{claim:?} {found:?}");
                }
                assert_eq!(found.rounded_to.is_some(), is_rounding && !error.is_zero());
                tally.count(judgements[end as usize].verdict.name());
            }
        }
    }
    let cases =
        ["exact", "rounded", "within tolerance", "loose", "infeasible point", "unsafe", "inverted interval"];
    tally.assert_each(500, &cases);
}

#[test]
fn swapped_ends_are_an_inverted_interval() {
    let mut rng = seeded(52);
    let mut swapped = 0;
    while swapped < 300 {
        let problem = problem(&mut rng);
        let rows = ProgramRows::new(&problem);
        let tolerance = tolerance();
        let judge = Judge::new(rows.rows(), &tolerance);
        let referee = Referee::new(rows.rows().to_vec(), tolerance.clone());
        for axis in [0, 1] {
            let ends = ENDS.map(|end| judge.truth(axis, end));
            let [Truth::At(lower), Truth::At(upper)] = ends else { continue };
            let claims = [value(&upper), value(&lower)];
            let found = referee.judge_interval(axis, &claims);
            judge.check(axis, &claims, &found);
            let expected = if lower == upper { Verdict::Exact } else { Verdict::InvertedInterval };
            assert_eq!(found.each_ref().map(|judgement| judgement.verdict), [expected; 2]);
            swapped += usize::from(lower != upper);
        }
    }
    // Where one end is not bounded or nothing is feasible, that is the finding.
    let all_equal = line_problem(&[(number("2"), number("1"))], &number("1/2"));
    let empty = with_error_bound(
        &line_problem(&[(number("2"), number("1")), (number("2"), number("3"))], &number("1")),
        &number("1/3"),
    );
    for problem in [all_equal, empty] {
        let rows = ProgramRows::new(&problem).rows().to_vec();
        let found =
            Referee::new(rows, tolerance()).judge_interval(0, &[value(&number("1")), value(&number("0"))]);
        assert_eq!(found.map(|judgement| judgement.verdict), [Verdict::WrongStatus; 2]);
    }
}

/// Judges a claim about the upper end of θ1.
fn upper(problem: &Problem, tolerance: &str, claim: &BoundClaim) -> Judgement {
    let rows = ProgramRows::new(problem).rows().to_vec();
    Referee::new(rows, number(tolerance)).judge(0, End::Upper, claim)
}

/// θ1 and θ2 between -1 and 1, each with the error bound 1.
fn square() -> Problem {
    let mut square = line_problem(&[(number("1"), number("0")), (number("1"), number("0"))], &number("1"));
    let rows = square.measurements.kept().iter().cloned().zip([["1", "0"], ["0", "1"]]);
    let rows = rows
        .map(|(row, regressor)| boundfit_estimation::Measurement { regressor: regressor.map(number), ..row });
    square = boundfit_tests::readings::with_rows(&square, rows.collect());
    square
}

#[test]
fn the_tolerance_is_sharp() {
    let cases = [
        ("1", Verdict::Exact),
        ("1.002", Verdict::WithinTolerance),
        ("1.00200000000000000000000000000000000001", Verdict::Loose),
        ("1.00199999999999999999999999999999999999", Verdict::WithinTolerance),
        // The other end is at -1: the interval is 2 wide.
        ("0.998", Verdict::WithinTolerance),
        ("0.99799999999999999999999999999999999999", Verdict::Unsafe),
        ("0.99800000000000000000000000000000000001", Verdict::WithinTolerance),
        ("1.0000000000000000000000000000000000001", Verdict::Rounded),
        ("0.9999999999999999999999999999999999999", Verdict::Rounded),
        // Four times the distance of 1 to the next double, 2.22e-16.
        ("1.00000000000000088", Verdict::Rounded),
        ("1.00000000000000089", Verdict::WithinTolerance),
        ("0.99999999999999912", Verdict::Rounded),
        ("0.99999999999999911", Verdict::WithinTolerance),
        ("-1", Verdict::Unsafe),
        ("1e400", Verdict::Loose),
        ("-1e400", Verdict::Unsafe),
    ];
    for (claimed, verdict) in cases {
        assert_eq!(upper(&square(), "1/1000", &value(&number(claimed))).verdict, verdict, "{claimed}");
    }
    // Without any tolerance nothing but rounding is excused, with a large one everything is.
    assert_eq!(upper(&square(), "0", &value(&number("1.1"))).verdict, Verdict::Loose);
    assert_eq!(upper(&square(), "0", &value(&number("0.99999999999999911"))).verdict, Verdict::Unsafe);
    assert_eq!(upper(&square(), "0", &value(&number("0.99999999999999912"))).verdict, Verdict::Rounded);
    assert_eq!(upper(&square(), "1/20", &value(&number("1.1"))).verdict, Verdict::WithinTolerance);
    assert_eq!(upper(&square(), "1000", &value(&number("0.9"))).verdict, Verdict::WithinTolerance);
    // Points: τ in units of ε at the tolerance, and just above.
    let at = |theta1: &str, theta2: &str| BoundClaim {
        point: Some([number(theta1), number(theta2)].map(Printed::exact)),
        ..value(&Rational::one())
    };
    let cases = [
        ("1", "0", Verdict::Exact, "0"),
        ("1", "1.001", Verdict::Exact, "0.001"),
        ("1", "1.00100000000000000001", Verdict::InfeasiblePoint, "0.00100000000000000001"),
        ("-3", "1", Verdict::InfeasiblePoint, "2"),
    ];
    for (theta1, theta2, verdict, tau) in cases {
        let found = upper(&square(), "1/1000", &at(theta1, theta2));
        assert_eq!((found.verdict, found.tau), (verdict, Some(number(tau))), "{theta1} {theta2}");
        assert_eq!(found.tau_in_epsilon, Some(number(tau)));
    }
}

#[test]
fn conditions_and_readings_without_error_have_no_relative_tau() {
    let far =
        BoundClaim { point: Some([number("1"), number("5/2")].map(Printed::exact)), ..value(&number("1")) };
    let found = upper(&square(), "1e-6", &far);
    assert_eq!((found.tau, found.tau_in_epsilon), (Some(number("3/2")), Some(number("3/2"))));
    // Row 1 upper, row 2 upper, row 1 lower, row 2 lower, then conditions.
    assert_eq!(found.violation.map(|violation| (violation.row, violation.by)), Some((1, number("3/2"))));

    let mut conditioned = square();
    conditioned.conditions.push(parse_condition("theta2 <= 1/2"));
    let found = upper(&conditioned, "1e-6", &far);
    assert_eq!((found.verdict, found.tau, found.tau_in_epsilon), (Verdict::InfeasiblePoint, None, None));
    // The condition is violated by 2 of its terms' 3, the reading by 3/2 of its error bound.
    assert_eq!(found.violation.map(|violation| violation.row), Some(1));
    let near =
        BoundClaim { point: Some([number("1"), number("3/4")].map(Printed::exact)), ..value(&number("1")) };
    let found = upper(&conditioned, "1e-6", &near);
    assert_eq!((found.verdict, found.tau, found.tau_in_epsilon), (Verdict::InfeasiblePoint, None, None));
    assert_eq!(found.violation.map(|violation| (violation.row, violation.by)), Some((4, number("1/4"))));

    // Error bound 0: τ is a length, but no multiple of nothing; both intervals have no width.
    let exact = with_error_bound(&square(), &Rational::zero());
    let beside =
        BoundClaim { point: Some([number("1/4"), number("0")].map(Printed::exact)), ..value(&number("1/4")) };
    let found = upper(&exact, "1e-6", &beside);
    assert_eq!((found.verdict, found.excess), (Verdict::InfeasiblePoint, Some(number("1/4"))));
    assert_eq!((found.excess_in_units, found.tau, found.tau_in_epsilon), (None, Some(number("1/4")), None));
    assert_eq!(upper(&exact, "1e-6", &value(&number("1e-300"))).verdict, Verdict::Loose);
    assert_eq!(upper(&exact, "1e-6", &value(&number("-1e-300"))).verdict, Verdict::Unsafe);
    // No double lies there, so that this is not the rounding of one.
    assert_eq!(upper(&exact, "1e-6", &value(&number("1e-400"))).verdict, Verdict::Loose);
    assert_eq!(upper(&exact, "1e-6", &value(&Rational::zero())).verdict, Verdict::Exact);
}

#[test]
fn readings_without_error_and_sets_without_width() {
    let mut rng = seeded(53);
    let mut tally = Tally::default();
    for case in 0..600 {
        // A line through two readings, and one more on it or beside it.
        let theta = [fine(&mut rng), fine(&mut rng)];
        let xs = [0, 1, 2].map(|k: i64| Rational::from(k + rng.random_range(0..=1)));
        let beside = if case % 3 == 0 { ten_to(-25) } else { Rational::zero() };
        let mut readings: Vec<_> = xs.into_iter().map(|x| (x.clone(), &x * &theta[0] + &theta[1])).collect();
        readings[2].1 = &readings[2].1 + beside;
        let problem = line_problem(&readings, &Rational::zero());
        let rows = ProgramRows::new(&problem);
        let tolerance = tolerance();
        let judge = Judge::new(rows.rows(), &tolerance);
        let referee = Referee::new(rows.rows().to_vec(), tolerance.clone());
        for axis in [0, 1] {
            for error in ["0", "1e-30", "-1e-30", "1e-3", "-1e-3"] {
                let claimed = &theta[axis] + number(error);
                let mut point = theta.clone();
                point[axis] = claimed.clone();
                let claim = BoundClaim { point: Some(point.map(Printed::exact)), ..value(&claimed) };
                let claims = [claim.clone(), claim];
                let judgements = referee.judge_interval(axis, &claims);
                judge.check(axis, &claims, &judgements);
                tally.count(judgements[0].verdict.name());
                tally.count(judgements[1].verdict.name());
            }
        }
    }
    tally.assert_each(100, &["exact", "infeasible point", "unsafe", "wrong status"]);
}
