//! Predictions against the largest value of a form by duality, over all pairs of half-planes, and against membership.

use std::collections::BTreeMap;

use boundfit_estimation::{ErrorBound, Fps, Law, Measurement, Measurements, Model};
use boundfit_exact::{Endpoint, Interval, Limits, Rational, Reading};
use boundfit_geometry::{Inequality, Polyhedron, Support, System};
use boundfit_questions::{FurtherError, PossibleX, Predictor};
use boundfit_tests::generate::{seeded, share};
use boundfit_tests::oracle::{Row, solve};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

const CASES: usize = 4_000;

/// Half-planes of lines: readings with one or two bounds, repeated x, all x equal, bounds without width; or any half-planes.
fn rows(rng: &mut ChaCha8Rng) -> Vec<Row> {
    let style = rng.random_range(0..4);
    let count = rng.random_range(0..=6);
    let size = [0, 1, 3][rng.random_range(0..3)];
    let (slope, offset) = (rng.random_range(-2..=2_i128), rng.random_range(-2..=2));
    let mut rows = Vec::new();
    for _ in 0..count {
        if style == 3 {
            rows.push([0; 3].map(|_| rng.random_range(-3..=3)));
            continue;
        }
        let x = rng.random_range(-size..=size);
        let y = slope * x + offset + rng.random_range(-1..=1);
        let epsilon = rng.random_range(0..=2);
        if style < 2 || rng.random_bool(0.5) {
            rows.push([x, 1, y + epsilon]);
        }
        if style < 2 || rng.random_bool(0.5) {
            rows.push([-x, -1, epsilon - y]);
        }
    }
    rows
}

fn number(value: i128) -> Rational {
    Rational::from(i64::try_from(value).expect("a small number"))
}

/// Returns the largest value of a form over the set of some rows, which is not empty. By duality it is the least
/// right-hand side of a combination of at most two rows that adds up to the form.
fn most(rows: &[Row], form: &[Rational; 2]) -> Option<Rational> {
    let [u, v] = form;
    let rows: Vec<[Rational; 3]> = rows.iter().map(|row| row.map(number)).collect();
    let mut values: Vec<Rational> = Vec::new();
    for [a, b, c] in &rows {
        let along = a * u + b * v;
        if (a * v) == (b * u) && along.is_positive() {
            values.extend((c * (u * u + v * v)).checked_div(&along));
        }
        for [d, e, f] in &rows {
            let determinant = a * e - b * d;
            let times = [u * e - v * d, a * v - b * u].map(|part| part.checked_div(&determinant));
            if let [Some(s), Some(t)] = times
                && !s.is_negative()
                && !t.is_negative()
            {
                values.push(c * s + f * t);
            }
        }
    }
    values.into_iter().min()
}

fn line_at(rows: &[Row], x: &Rational) -> Interval {
    let upper = most(rows, &[x.clone(), Rational::one()]);
    let lower = most(rows, &[-x, -Rational::one()]).map(|most| -most);
    Interval::new(lower.into(), upper.into()).expect("a set that is not empty")
}

fn set(rows: &[Row]) -> Polyhedron {
    let system: System =
        rows.iter().map(|row| row.map(number)).map(|[a, b, c]| Inequality::new(a, b, c)).collect();
    Polyhedron::intersect(system)
}

/// The facts about a further reading: how far the line may be above and below it at x.
struct Known {
    error: FurtherError,
    /// Constants and multiples of |x| and |y|, above and below.
    terms: [[Rational; 3]; 2],
    /// The x that is 0.
    zero: Rational,
}

impl Known {
    fn generated(rng: &mut ChaCha8Rng) -> Self {
        if rng.random_bool(0.4) {
            let epsilon = Rational::ratio(rng.random_range(0..=4), 2);
            let terms = [epsilon.clone(), Rational::zero(), Rational::zero()];
            let error = FurtherError::within(epsilon);
            return Known { error, terms: [terms.clone(), terms], zero: Rational::zero() };
        }
        let mut side = || {
            [
                Rational::ratio(rng.random_range(0..=4), 2),
                Rational::ratio(rng.random_range(0..=3), 2),
                Rational::ratio(rng.random_range(0..=2), 3),
            ]
        };
        let above = side();
        let below = side();
        let text = |[constant, of_x, of_y]: &[Rational; 3]| format!("{constant} + {of_x}*|x| + {of_y}*|y|");
        let is_even = rng.random_bool(0.5);
        let law = match is_even {
            true => text(&above),
            false => format!("+{}/-{}", text(&above), text(&below)),
        };
        let law = Law::parse(&law, Reading::Decimal, &Limits::default()).expect("a law");
        let zero = Rational::from(rng.random_range(-2..=2));
        let reading =
            Measurement::around(1, [Rational::zero(), Rational::one()], Rational::zero(), Rational::zero());
        let bound = ErrorBound::Uniform(Rational::zero());
        let measurements = Measurements::new(Model::Line { x: "x".into() }, "y".into(), bound, vec![reading]);
        let form = boundfit_estimation::LineForm { x_origin: -&zero, through_origin: false };
        let error = FurtherError::by_law(&law, &measurements.with_form(form)).expect("a bound");
        let below = if is_even { above.clone() } else { below };
        Known { error, terms: [above, below], zero }
    }

    /// Returns how far the line may be above and below a reading y at x.
    fn around(&self, x: &Rational, y: &Rational) -> [Rational; 2] {
        let x = (x - &self.zero).abs();
        self.terms.each_ref().map(|[constant, of_x, of_y]| constant + of_x * &x + of_y * y.abs())
    }

    /// Returns whether a reading y may come from x, where the line has these values.
    fn is_possible(&self, line: &Interval, x: &Rational, y: &Rational) -> bool {
        let [above, below] = self.around(x, y);
        line.lower().value().is_none_or(|lower| *lower <= y + above)
            && line.upper().value().is_none_or(|upper| *upper >= y - below)
    }
}

/// Numbers at, about and between some numbers.
fn samples(at: &[Rational]) -> Vec<Rational> {
    let mut sorted = at.to_vec();
    sorted.sort();
    let step = Rational::ratio(1, 1_000_000);
    let about = sorted.iter().flat_map(|x| [x - &step, x.clone(), x + &step]);
    let between = sorted.windows(2).map(|pair| (&pair[0] + &pair[1]).half());
    let far = [-1000, -1, 0, 1, 1000].map(Rational::from);
    about.chain(between).chain(far).collect()
}

fn ends(interval: &Interval) -> impl Iterator<Item = Rational> + '_ {
    [interval.lower(), interval.upper()].into_iter().filter_map(Endpoint::value).cloned()
}

fn check_order(found: &[PossibleX], what: &str) {
    assert!(found.len() <= 2, "{what}");
    for pair in found.windows(2) {
        let (one, other) = (pair[0].upper.as_ref().unwrap(), pair[1].lower.as_ref().unwrap());
        let is_apart = one.x < other.x || (one.x == other.x && !one.included && !other.included);
        assert!(is_apart, "{what}: {found:?}");
    }
}

#[test]
fn the_line_and_further_readings_lie_where_brute_force_says() {
    let mut rng = seeded(162);
    let mut seen: BTreeMap<&str, usize> = BTreeMap::new();
    for case in 0..CASES {
        let rows = rows(&mut rng);
        let kind = solve(&rows).kind;
        *seen.entry(kind).or_default() += 1;
        let set = set(&rows);
        let Some(predictor) = Predictor::new(&set) else {
            assert_eq!(kind, "empty", "case {case}");
            continue;
        };
        let known = Known::generated(&mut rng);
        for x in [-3, -1, 0, 1, 2, 7].map(|x| Rational::ratio(x, rng.random_range(1..=3))) {
            let what = format!("case {case} at {x}: {rows:?} {:?}", known.terms);
            let line = predictor.line(&x);
            assert_eq!(line, line_at(&rows, &x), "{what}");
            let form = [x.clone(), Rational::one()];
            assert_eq!(predictor.form(&form), line, "{what}");
            let reading = known.error.around(&line, &x).expect("an interval");
            for y in samples(&ends(&reading).collect::<Vec<_>>()) {
                assert_eq!(reading.contains(&y), known.is_possible(&line, &x, &y), "{what}: {y}");
            }
            let proved = predictor.ends(&form).map(|support| match support {
                Support::Bounded { proof, .. } => {
                    assert!(proof.verify(set.system()).is_ok(), "{what}");
                    Some(proof.value)
                }
                Support::Unbounded(proof) => {
                    assert!(proof.verify(set.system()).is_ok(), "{what}");
                    None
                }
                Support::Empty(_) => panic!("{what}"),
            });
            let [lower, upper] = proved;
            assert_eq!(Interval::new(lower.map(|lower| -lower).into(), upper.into()), Some(line), "{what}");
        }
    }
    let kinds = [
        "empty",
        "point",
        "segment",
        "ray",
        "line",
        "polygon",
        "unbounded-polygon",
        "strip",
        "half-plane",
        "plane",
    ];
    for kind in kinds {
        assert!(seen.get(kind).is_some_and(|count| *count > 10), "{seen:?}");
    }
}

#[test]
fn readings_come_from_where_brute_force_says() {
    let mut rng = seeded(163);
    let mut parts = [0; 3];
    let mut excluded = 0;
    for case in 0..share(CASES) {
        let rows = rows(&mut rng);
        let set = set(&rows);
        let Some(predictor) = Predictor::new(&set) else { continue };
        let known = Known::generated(&mut rng);
        for y in [-9, -4, 0, 1, 3, 8].map(|y| Rational::ratio(y, rng.random_range(1..=2))) {
            let what = format!("case {case} from {y}: {rows:?} {:?} about {}", known.terms, known.zero);
            let found = predictor.sources(&y, &known.error);
            check_order(&found, &what);
            parts[found.len()] += 1;
            let at: Vec<Rational> = found
                .iter()
                .flat_map(|own| [&own.lower, &own.upper])
                .flatten()
                .map(|end| end.x.clone())
                .collect();
            excluded += found
                .iter()
                .flat_map(|own| [&own.lower, &own.upper])
                .flatten()
                .filter(|end| !end.included)
                .count();
            for x in samples(&at) {
                let is_in = found.iter().any(|own| own.contains(&x));
                assert_eq!(is_in, known.is_possible(&line_at(&rows, &x), &x, &y), "{what}: {x} in {found:?}");
            }
            for end in
                found.iter().flat_map(|own| [&own.lower, &own.upper]).flatten().filter(|end| end.included)
            {
                // Where an interval ends the line just reaches what decides.
                let line = predictor.line(&end.x);
                let [above, below] = known.around(&end.x, &y);
                let reached = if end.by_upper { line.upper().value() } else { line.lower().value() };
                let needed = if end.by_upper { &y - below } else { &y + above };
                assert_eq!(reached, Some(&needed), "{what}: {end:?}");
            }
        }
    }
    assert!(parts.iter().all(|count| *count > share(30)), "{parts:?}");
    assert!(excluded > share(50), "{excluded}");
}

#[test]
fn many_readings_at_once_come_from_where_each_does() {
    let mut rng = seeded(164);
    for _ in 0..200 {
        let set = set(&rows(&mut rng));
        let Some(predictor) = Predictor::new(&set) else { continue };
        let error = FurtherError::within(Rational::one());
        let of = predictor.sources_of_many(&error);
        for y in (-5..=5).map(Rational::from) {
            assert_eq!(of(&y), predictor.sources(&y, &error));
        }
    }
}

#[test]
fn two_regressors_are_predicted_as_any_form_is() {
    let mut rng = seeded(165);
    for case in 0..1_000 {
        let rows = rows(&mut rng);
        let set = set(&rows);
        let Some(predictor) = Predictor::new(&set) else { continue };
        let form = [0; 2].map(|_| Rational::from(rng.random_range(-3..=3)));
        let zero = form.iter().all(Rational::is_zero);
        let upper = if zero { Some(Rational::zero()) } else { most(&rows, &form) };
        let opposite = form.each_ref().map(|part| -part);
        let lower = if zero { Some(Rational::zero()) } else { most(&rows, &opposite).map(|most| -most) };
        let expected = Interval::new(lower.into(), upper.into()).expect("in order");
        assert_eq!(predictor.form(&form), expected, "case {case}: {rows:?} {form:?}");
    }
}

#[test]
fn readings_of_a_fit_predict_themselves() {
    let mut rng = seeded(166);
    for _ in 0..500 {
        let problem = boundfit_tests::readings::problem(&mut rng);
        let fps = Fps::new(&problem.measurements, &problem.conditions);
        let Some(predictor) = Predictor::new(fps.polyhedron()) else { continue };
        let Ok(error) = FurtherError::of(&problem.measurements) else { continue };
        if !matches!(problem.measurements.model(), Model::Line { .. }) {
            continue;
        }
        for row in problem.measurements.kept() {
            let (x, y) = (&row.regressor[0], row.response().expect("a reading"));
            assert!(error.around(&predictor.line(x), x).is_some_and(|reading| reading.contains(y)));
            assert!(predictor.sources(y, &error).iter().any(|own| own.contains(x)));
        }
    }
}
