//! Lines through the origin, from another origin of x, and under a multiple of their own least error bound.

use std::collections::BTreeMap;
use std::io::Cursor;

use boundfit_estimation::{
    Columns, EpsilonColumn, ErrorBound, Family, Fit, Keep, LineForm, Measurement, Measurements, Model,
    NoLeastSquares, Problem, ReducedTable, fit,
};
use boundfit_exact::{Interval, Rational};
use boundfit_formats::{ColumnSelector, ScanOptions, Source, TableOptions};
use boundfit_geometry::RegionKind;
use boundfit_tests::generate::seeded;
use boundfit_tests::readings::{parse_condition, small_rational};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// x, y and ε of a reading.
type Triple = [Rational; 3];

/// One to eight readings, degenerate more often than not: x is 0, negative or repeated, rows repeat, readings fit exactly.
fn readings(rng: &mut ChaCha8Rng, uniform: bool) -> Vec<Triple> {
    let count = rng.random_range(1..=8);
    let (slope, style) = (small_rational(rng), rng.random_range(0..6));
    let bound =
        |rng: &mut ChaCha8Rng| Rational::ratio(rng.random_range(0..=12), [1, 4][rng.random_range(0..2)]);
    let common = bound(rng);
    let mut rows: Vec<Triple> = Vec::new();
    while rows.len() < count {
        let x = match style {
            0 => Rational::zero(),
            1 => -small_rational(rng).abs(),
            2 => Rational::from(rng.random_range(-1..=1)),
            _ => small_rational(rng),
        };
        let noise = if style == 3 { Rational::zero() } else { Rational::ratio(rng.random_range(-8..=8), 4) };
        let y = &slope * &x + noise;
        let epsilon = if uniform { common.clone() } else { bound(rng) };
        match rows.last().filter(|_| rng.random_bool(0.2)) {
            Some(last) => rows.push(last.clone()),
            None => rows.push([x, y, epsilon]),
        }
    }
    rows
}

fn problem(rows: &[Triple], uniform: bool) -> Problem {
    let bound =
        if uniform { ErrorBound::Uniform(rows[0][2].clone()) } else { ErrorBound::Column("eps".into()) };
    let measured = (1..).zip(rows.iter().cloned());
    let measured =
        measured.map(|(row, [x, y, epsilon])| Measurement::around(row, [x, Rational::one()], y, epsilon));
    Problem::new(Measurements::new(Model::Line { x: "x".into() }, "y".into(), bound, measured.collect()))
}

/// All θ with |y - θ·x| ≤ ε by one reading after the other: `None` when there are none, else both ends as far as they exist.
fn slopes(rows: &[Triple]) -> Option<[Option<Rational>; 2]> {
    let (mut lower, mut upper): (Option<Rational>, Option<Rational>) = (None, None);
    for [x, y, epsilon] in rows {
        if x.is_zero() {
            if y.abs() > *epsilon {
                return None;
            }
            continue;
        }
        let ends = [y - epsilon, y + epsilon].map(|end| end.checked_div(x).unwrap());
        let [low, high] = if x.is_negative() { [&ends[1], &ends[0]] } else { [&ends[0], &ends[1]] };
        lower = Some(lower.map_or(low.clone(), |lower| lower.max(low.clone())));
        upper = Some(upper.map_or(high.clone(), |upper| upper.min(high.clone())));
    }
    if lower.as_ref().zip(upper.as_ref()).is_some_and(|(lower, upper)| lower > upper) {
        None
    } else {
        Some([lower, upper])
    }
}

/// The least t with |y - θ·x| ≤ t·g for some θ, where g is 1 or ε: intervals of slopes meet when every two of them do. `None`
/// when no t will do.
fn least(rows: &[Triple], uniform: bool) -> Option<Rational> {
    let growth = |row: &Triple| if uniform { Rational::one() } else { row[2].clone() };
    let mut least = Rational::zero();
    for one in rows {
        for other in rows {
            let ([x, y, _], [u, v, _]) = (one, other);
            // |y/x - v/u| ≤ t·(g/|x| + h/|u|), times |x·u|; of a reading at x = 0 alone |y| ≤ t·g.
            let (gap, speed) = if x.is_zero() {
                (y.abs(), growth(one))
            } else {
                ((y * u - v * x).abs(), growth(one) * u.abs() + growth(other) * x.abs())
            };
            if gap.is_zero() {
                continue;
            }
            least = least.max(gap.checked_div(&speed)?);
        }
    }
    Some(least)
}

/// Σxy/Σx² and Σ|x|ε/Σx².
fn least_squares(rows: &[Triple]) -> Option<[Rational; 2]> {
    let sum = |term: &dyn Fn(&Triple) -> Rational| rows.iter().map(term).sum::<Rational>();
    let xx = sum(&|[x, ..]| x * x);
    let estimate = sum(&|[x, y, _]| x * y).checked_div(&xx)?;
    Some([estimate, sum(&|[x, _, epsilon]| x.abs() * epsilon).checked_div(&xx)?])
}

fn zero() -> Interval {
    Interval::around(&Rational::zero(), &Rational::zero()).unwrap()
}

#[test]
fn a_line_through_the_origin_is_what_one_dimension_says() {
    let mut rng = seeded(1301);
    let mut kinds: BTreeMap<&str, usize> = BTreeMap::new();
    for number in 0..4000 {
        let uniform = number % 3 != 0;
        let rows = readings(&mut rng, uniform);
        let problem = problem(&rows, uniform).through_origin();
        let fit = fit(&problem);
        let context = format!("{number}: {rows:?}");
        assert_eq!(problem.conditions[0].text(), "theta2 = 0", "{context}");
        let kind = fit.fps.polyhedron().region().kind();
        *kinds.entry(kind.name()).or_default() += 1;
        let expected = slopes(&rows);
        let expected_kind = match &expected {
            None => RegionKind::Empty,
            Some([Some(lower), Some(upper)]) if lower == upper => RegionKind::Point,
            Some([Some(_), Some(_)]) => RegionKind::Segment,
            Some(_) => RegionKind::Line,
        };
        assert_eq!(kind, expected_kind, "{context}");
        let pui = fit.pui_intervals().map(|[first, second]| {
            assert_eq!(second, zero(), "{context}");
            [first.lower().value().cloned(), first.upper().value().cloned()]
        });
        assert_eq!(pui, expected, "{context}");
        assert_eq!(
            fit.minimax.as_ref().map(|minimax| minimax.least.clone()),
            least(&rows, uniform),
            "{context}"
        );
        match least_squares(&rows) {
            None => assert_eq!(fit.least_squares, Err(NoLeastSquares::EveryXZero), "{context}"),
            Some([estimate, radius]) => {
                let own = fit.least_squares.as_ref().unwrap();
                let eui = Interval::around(&estimate, &radius).unwrap();
                assert_eq!(own.theta, [estimate, Rational::zero()], "{context}");
                assert_eq!(own.eui, Ok([eui, zero()]), "{context}");
            }
        }
        for offset in fit.inverse(problem.measurements.model()).unwrap().offset.exact_range {
            assert_eq!(offset, zero(), "{context}");
        }
        assert_eq!(fit.verify(&problem), Ok(()), "{context}");
    }
    for kind in ["empty", "point", "segment", "line"] {
        assert!(kinds.get(kind).is_some_and(|&count| count >= 100), "{kinds:?}");
    }
}

#[test]
fn an_equation_is_two_inequalities() {
    let mut rng = seeded(1302);
    for number in 0..3000 {
        let uniform = number % 2 == 0;
        let rows = readings(&mut rng, uniform);
        let [a, b, c] = [0; 3].map(|_| rng.random_range(-3..=3));
        let under = |relations: &[&str]| {
            let text = |relation: &&str| format!("{a}*theta1 + {b}*theta2 {relation} {c}");
            let conditions = relations.iter().map(|relation| parse_condition(&text(relation))).collect();
            Problem { conditions, ..problem(&rows, uniform) }
        };
        let (one, two) = (under(&["="]), under(&["<=", ">="]));
        let (equation, inequalities) = (fit(&one), fit(&two));
        let context = format!("{number}: {rows:?} {}", one.conditions[0].text());
        let region = |fit: &Fit| fit.fps.polyhedron().region().clone();
        let inverse = |fit: &Fit| fit.inverse(one.measurements.model());
        assert_eq!(region(&equation), region(&inequalities), "{context}");
        assert_eq!(equation.pui, inequalities.pui, "{context}");
        assert_eq!(equation.central, inequalities.central, "{context}");
        assert_eq!(inverse(&equation), inverse(&inequalities), "{context}");
        let least =
            |fit: &Fit| fit.minimax.as_ref().map(|minimax| (minimax.least.clone(), minimax.theta.clone()));
        assert_eq!(least(&equation), least(&inequalities), "{context}");
        assert_eq!(equation.verify(&one), Ok(()), "{context}");
        if number % 10 == 0 {
            let family = |problem: &Problem| {
                let family = Family::new(problem, Rational::ratio(1, 2), Rational::from(2));
                family
                    .breakpoints()
                    .iter()
                    .map(|at| (at.s.clone(), at.section.vertices.len()))
                    .collect::<Vec<_>>()
            };
            assert_eq!(family(&one), family(&two), "{context}");
        }
    }
}

fn columns(epsilon: &Rational, form: LineForm) -> Columns {
    Columns {
        first: ColumnSelector::name_or_number("x"),
        second: None,
        response: Some(ColumnSelector::name_or_number("y")),
        epsilon: EpsilonColumn::Uniform(epsilon.clone()),
        form,
    }
}

fn table(rows: &[Triple], origin: &Rational) -> String {
    rows.iter().fold("x,y\n".to_owned(), |text, [x, y, _]| text + &format!("{},{y}\n", x - origin))
}

/// Everything that is known of a problem, in one text; rows by their numbers.
fn essence(problem: &Problem) -> String {
    let fit = fit(problem);
    let region = fit.fps.polyhedron().region();
    format!(
        "{:?} {:?} {:?} {:?} {:?} {:?} {:?}",
        region.kind(),
        fit.vertices(),
        fit.pui_intervals(),
        fit.central,
        fit.minimax,
        fit.least_squares,
        fit.inverse(problem.measurements.model())
    )
}

#[test]
fn another_origin_is_the_same_as_shifted_data() {
    let mut rng = seeded(1303);
    for number in 0..2500 {
        let rows = readings(&mut rng, true);
        let origin =
            [Rational::from(1980), small_rational(&mut rng), Rational::ratio(-1, 3)][number % 3].clone();
        let through_origin = number % 4 == 1;
        let epsilon = rows[0][2].clone();
        let finished = |measurements: Measurements| {
            let problem = Problem::new(measurements);
            if through_origin { problem.through_origin() } else { problem }
        };
        let source = |text: &str| Source::new("t", Cursor::new(text.as_bytes().to_vec()));
        let read = |text: &str, form: &LineForm| {
            let columns = columns(&epsilon, form.clone());
            finished(Measurements::read(source(text), &columns, &TableOptions::default()).unwrap())
        };
        let by_hand = essence(&read(&table(&rows, &origin), &LineForm::default()));
        let text = table(&rows, &Rational::zero());
        let form = LineForm { x_origin: origin.clone(), through_origin: false };
        let context = format!("{number}: {rows:?} from {origin}");
        assert_eq!(essence(&read(&text, &form)), by_hand, "{context}");
        let in_memory = finished(problem(&rows, true).measurements.with_form(form.clone()));
        assert_eq!(essence(&in_memory), by_hand, "{context}");
        // The program asks for the form when it reads, since the second look at x depends on it.
        let form = LineForm { through_origin, ..form };
        let scanned = |most_rows: usize| {
            let keep = Keep { most_rows, ..Keep::default() };
            let columns = columns(&epsilon, form.clone());
            let options = ScanOptions { chunk_bytes: 20, ..ScanOptions::default() };
            let measurements = Measurements::scan(source(&text), &columns, &[], &options, keep).unwrap();
            finished(measurements)
        };
        assert_eq!(essence(&scanned(100)), by_hand, "{context}");
        assert_eq!(essence(&scanned(0)), by_hand, "{context}");
    }
}

#[test]
fn reductions_are_fitted_from_any_origin() {
    let mut rng = seeded(1304);
    for number in 0..300 {
        let rows = readings(&mut rng, true);
        let origin = small_rational(&mut rng);
        let selectors = columns(&Rational::zero(), LineForm::default());
        let source = |text: &[u8]| Source::new("t", Cursor::new(text.to_vec()));
        let text = table(&rows, &Rational::zero());
        let reduced =
            ReducedTable::scan(source(text.as_bytes()), &selectors, &ScanOptions::default()).unwrap();
        let mut reduction = Vec::new();
        reduced.write(&mut reduction).unwrap();
        let form = LineForm { x_origin: origin.clone(), through_origin: number % 2 == 0 };
        let scanned = |text: &[u8], form: &LineForm| {
            let columns = columns(&rows[0][2], form.clone());
            let keep = Keep::default();
            let measurements =
                Measurements::scan(source(text), &columns, &[], &ScanOptions::default(), keep).unwrap();
            Problem::new(measurements)
        };
        let (of_reduction, of_table) = (scanned(&reduction, &form), scanned(text.as_bytes(), &form));
        let (own, expected) = (fit(&of_reduction), fit(&of_table));
        assert_eq!(own.vertices(), expected.vertices(), "{rows:?} {origin}");
        assert_eq!(own.pui_intervals(), expected.pui_intervals(), "{rows:?} {origin}");
        let theta = |fit: &Fit| fit.least_squares.as_ref().map(|estimate| estimate.theta.clone()).ok();
        assert_eq!(theta(&own), theta(&expected), "{rows:?} {origin}");
    }
}

#[test]
fn a_multiple_of_the_least_bound_is_one() {
    let mut rng = seeded(1305);
    for number in 0..2000 {
        let rows = readings(&mut rng, true);
        let mut problem = problem(&rows, true);
        if number % 3 == 0 {
            problem = problem.through_origin();
        }
        if number % 5 == 0 {
            problem.conditions.push(parse_condition("theta1 >= 1/2"));
        }
        let least = fit(&problem).minimax.unwrap();
        for factor in [Rational::one(), Rational::ratio(6, 5), Rational::ratio(9, 10)] {
            let own = problem.clone().with_multiple_of_least(&factor);
            let context = format!("{number}: {rows:?} {factor}");
            let bound = own.measurements.error_bound().uniform().cloned();
            assert_eq!(bound, Some(&factor * &least.least), "{context}");
            let multiple = own.measurements.multiple_of_least().unwrap();
            assert_eq!((&multiple.factor, &multiple.least), (&factor, &least.least), "{context}");
            let fit = fit(&own);
            let is_empty = factor < Rational::one() && !least.least.is_zero();
            assert_eq!(fit.is_empty(), is_empty, "{context}");
            assert_eq!(fit.minimax.as_ref(), Some(&least), "{context}");
            if factor == Rational::one() && least.unique {
                assert_eq!(fit.vertices(), std::slice::from_ref(&least.theta), "{context}");
            }
            assert_eq!(fit.verify(&own), Ok(()), "{context}");
        }
    }
    let contradiction = ["theta1 >= 1", "theta1 <= 0"].map(parse_condition).to_vec();
    let hopeless = Problem { conditions: contradiction, ..problem(&[[0, 0, 1].map(Rational::from)], true) };
    assert_eq!(hopeless.clone().with_multiple_of_least(&Rational::one()), hopeless);
}
