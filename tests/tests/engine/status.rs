//! Statuses against a set for each reading that is left out, found by another program.

use std::collections::BTreeMap;

use boundfit_estimation::{BoundName, ErrorBound, Measurement, Measurements, Model, Problem, fit};
use boundfit_exact::Rational;
use boundfit_questions::{NoRepair, Repair, RowStatus, Standing, Status, Statuses};
use boundfit_report::{StatusCsv, StatusJson, Style};
use boundfit_tests::generate::{seeded, share};
use boundfit_tests::oracle::Row;
use boundfit_tests::readings::parse_condition;
use boundfit_tests::statuses::{Reading, least_total, statuses};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use serde_json::{Map, Value};

const CASES: usize = 4_000;

/// Readings and conditions, as the oracle and as the engine takes them.
struct Case {
    readings: Vec<Reading>,
    conditions: Vec<Row>,
    problem: Problem,
}

/// One to nine readings: repeated x and rows, all x equal, exact fits, no width, one bound, crossed bounds; sets of every kind.
fn case(rng: &mut ChaCha8Rng) -> Case {
    let (is_line, style) = (rng.random_bool(0.6), rng.random_range(0..4));
    let count = rng.random_range(1..=9);
    let size = [1, 2, 5][rng.random_range(0..3)];
    let is_vertical = rng.random_bool(0.15);
    let (slope, offset) = (rng.random_range(-2..=2_i128), rng.random_range(-2..=2));
    let uniform: i128 = rng.random_range(0..=4);
    let noise = rng.random_range(0..=3);
    let mut readings: Vec<Reading> = Vec::new();
    for _ in 0..count {
        let regressor = match readings.last() {
            Some(last) if is_vertical || rng.random_bool(0.2) => last.regressor,
            _ if is_line => [rng.random_range(-size..=size), 1],
            _ => [rng.random_range(-size..=size), rng.random_range(-size..=size)],
        };
        let y = slope * regressor[0] + offset * regressor[1] + rng.random_range(-noise..=noise);
        let epsilon = if style == 0 { uniform } else { rng.random_range(0..=3) };
        let (mut lower, mut upper) = (Some(y - epsilon), Some(y + epsilon));
        if style == 2 {
            match rng.random_range(0..4) {
                0 => lower = None,
                1 => upper = None,
                2 if rng.random_bool(0.05) => (lower, upper) = (Some(y + 1), Some(y)),
                _ => {}
            }
        }
        readings.push(Reading { regressor, lower, upper });
    }
    if rng.random_bool(0.2) {
        readings.push(readings[0].clone());
    }
    let conditions: Vec<Row> = (0..rng.random_range(0..=2_usize).saturating_sub(1))
        .map(|_| [0; 3].map(|_| rng.random_range(-3..=3)))
        .collect();
    let small = |number: i128| Rational::from(number as i64);
    let measured = |(row, reading): (usize, &Reading)| {
        let regressor = reading.regressor.map(small);
        match (reading.lower, reading.upper) {
            (Some(lower), Some(upper)) if style != 2 => {
                let half = |number: i128| Rational::ratio(number as i64, 2);
                Measurement::around(row, regressor, half(lower + upper), half(upper - lower))
            }
            (lower, upper) => Measurement::between(row, regressor, lower.map(small), upper.map(small)),
        }
    };
    let rows = (1..).zip(&readings).map(measured).collect();
    let error_bound = match style {
        0 => ErrorBound::Uniform(small(uniform)),
        2 => ErrorBound::Interval { lower: Some("lower".into()), upper: Some("upper".into()) },
        _ => ErrorBound::Column("eps".into()),
    };
    let model = match is_line {
        true => Model::Line { x: "x".into() },
        false => Model::TwoRegressors { regressors: ["u".into(), "v".into()] },
    };
    let condition = |[a, b, c]: &Row| parse_condition(&format!("{a}*theta1 + {b}*theta2 <= {c}"));
    let conditions_read = conditions.iter().map(condition).collect();
    let measurements = Measurements::new(model, "y".into(), error_bound, rows);
    Case { readings, conditions, problem: Problem { measurements, conditions: conditions_read } }
}

type Named = (Option<Rational>, Option<Rational>, &'static str);

fn named(standing: Option<Standing>) -> Option<Named> {
    standing.map(|Standing { leverage, residual, status }| (leverage, residual, status.name()))
}

#[test]
fn every_reading_stands_as_the_definitions_say() {
    let mut rng = seeded(16);
    let mut seen: BTreeMap<(bool, &str), usize> = BTreeMap::new();
    for number in 0..share(CASES) {
        let case = case(&mut rng);
        let statuses_of = Statuses::of(&case.problem, &fit(&case.problem)).expect("all in memory");
        let expected = statuses(&case.readings, &case.conditions);
        for (reading, [all, without]) in case.problem.measurements.kept().iter().zip(expected) {
            let found = statuses_of.status(reading);
            for (is_without, own) in [(false, &all), (true, &without)] {
                *seen.entry((is_without, own.as_ref().map_or("nothing", |own| own.2))).or_default() += 1;
            }
            assert_eq!(named(found.all), all, "case {number}, row {}: {:?}", reading.row, case.readings);
            assert_eq!(
                named(found.without),
                without,
                "case {number}, row {}: {:?}",
                reading.row,
                case.readings
            );
        }
    }
    for status in ["inner", "boundary", "outer", "strictly outer", "outlier", "nothing"] {
        assert!(seen.get(&(true, status)).is_some_and(|count| *count > share(100)), "{seen:?}");
    }
    for status in ["outer", "strictly outer", "outlier"] {
        assert!(!seen.contains_key(&(false, status)), "{seen:?}");
    }
}

/// Returns the lower bound that the multipliers of a repair prove, from the readings alone: no sum of factors is
/// smaller.
fn proved(problem: &Problem, repair: &Repair) -> Rational {
    let rows = problem.measurements.kept();
    let (mut sums, mut least) = ([Rational::zero(), Rational::zero()], Rational::from(repair.count as i64));
    let mut add = |form: &[Rational; 2], times: &Rational| {
        sums = [&sums[0] + &form[0] * times, &sums[1] + &form[1] * times];
    };
    for (row, multiplier) in &repair.multipliers {
        let reading = &rows[row - 1];
        let half_width = reading.half_width().expect("a width");
        assert!(multiplier.abs() * half_width.as_ref() <= Rational::one());
        add(&reading.regressor, multiplier);
        least = least
            - multiplier * reading.middle().expect("a middle").as_ref()
            - multiplier.abs() * half_width.as_ref();
    }
    for (name, multiplier) in &repair.held {
        assert!(multiplier.is_positive());
        let (form, bound) = match name {
            BoundName::Upper(row) => {
                (rows[row - 1].regressor.clone(), rows[row - 1].upper().expect("a bound"))
            }
            BoundName::Lower(row) => {
                let lower = rows[row - 1].lower().expect("a bound");
                (rows[row - 1].regressor.each_ref().map(|own| -own), -lower)
            }
            BoundName::Where(number) => {
                let own = problem.conditions[number - 1].inequality();
                (own.a.clone(), own.b.clone())
            }
            BoundName::WhereUpper(_) | BoundName::WhereLower(_) => panic!("no equations here"),
        };
        add(&form, multiplier);
        least = least - multiplier * bound;
    }
    assert_eq!(sums, [Rational::zero(), Rational::zero()]);
    least
}

#[test]
fn the_least_total_widening_is_that_of_the_best_crossing_and_is_proved() {
    let mut rng = seeded(17);
    let (mut repaired, mut impossible, mut with_held) = (0, 0, 0);
    for number in 0..CASES {
        let Case { readings, conditions, problem } = case(&mut rng);
        let own = fit(&problem);
        let expected = least_total(&readings, &conditions);
        match Repair::of(&problem, &own) {
            Ok(repair) => {
                assert_eq!(
                    Some(&repair.total),
                    expected.as_ref(),
                    "case {number}: {readings:?} {conditions:?}"
                );
                assert_eq!(repair.widened.is_empty(), !own.is_empty(), "case {number}");
                assert_eq!(
                    proved(&problem, &repair),
                    repair.total,
                    "case {number}: {readings:?} {conditions:?}"
                );
                let above: Rational = repair.widened.iter().map(|own| &own.factor - Rational::one()).sum();
                assert_eq!(above + Rational::from(repair.count as i64), repair.total);
                repaired += usize::from(!repair.widened.is_empty());
                with_held += usize::from(!repair.held.is_empty());
            }
            Err(NoRepair::Contradiction(terms)) => {
                assert_eq!(expected, None, "case {number}: {readings:?} {conditions:?}");
                assert!((1..=3).contains(&terms.len()));
                impossible += 1;
            }
            Err(NoRepair::NotInMemory) => panic!("all are in memory"),
        }
    }
    assert!(repaired > 500 && impossible > 500 && with_held > 50, "{repaired} {impossible} {with_held}");
}

/// Numbers of a reading that stands to both sets alike become text once: its row has the parts of rows that say them apart.
#[test]
fn rows_have_the_same_parts_whether_or_not_the_sets_differ() {
    let style = Style::default();
    let numbers = [Some(Rational::ratio(-3, 7)), Some(Rational::ratio(1, 4096)), None];
    for (leverage, residual) in numbers.iter().flat_map(|one| numbers.iter().map(move |other| (one, other))) {
        let own =
            Standing { leverage: leverage.clone(), residual: residual.clone(), status: Status::Boundary };
        let other = Standing { leverage: None, residual: None, status: Status::Outlier };
        let row = |all: &Standing, without: &Standing| RowStatus {
            row: 7,
            all: Some(all.clone()),
            without: Some(without.clone()),
        };
        let rows = [row(&own, &own), row(&own, &other), row(&other, &own)];
        let [alike, with, without] = rows.each_ref().map(|row| -> Map<String, Value> {
            serde_json::from_str(&StatusJson::row(row, &style)).unwrap()
        });
        let parts = with
            .iter()
            .map(|(key, with)| (key, if key.starts_with("without") { &without[key] } else { with }));
        assert!(alike.iter().eq(parts), "{alike:?}");
        let [alike, with, without] = rows.each_ref().map(StatusCsv::row);
        let cells = |row: &str| row.split(',').map(str::to_owned).collect::<Vec<_>>();
        let header = cells(StatusCsv::HEADER);
        let parts = header
            .iter()
            .zip(cells(&with))
            .zip(cells(&without))
            .map(|((key, with), without)| if key.starts_with("without") { without } else { with });
        assert_eq!(cells(&alike), parts.collect::<Vec<_>>());
    }
}
