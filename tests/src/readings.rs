//! Generated readings, the same on every run.

use boundfit_estimation::{
    Bounds, Condition, ErrorBound, LeastSquares, Measurement, Measurements, Model, NoLeastSquares, Problem,
};
use boundfit_exact::{Interval, Limits, Rational, Reading};
use rand::RngExt;
use rand::seq::SliceRandom;
use rand_chacha::ChaCha8Rng;

use crate::generate::seeded;

/// A rational number with a small numerator; ties and zeros are frequent.
pub fn small_rational(rng: &mut ChaCha8Rng) -> Rational {
    let denominator = [1, 1, 2, 10, 1000][rng.random_range(0..5)];
    Rational::ratio(rng.random_range(-20..=20), denominator)
}

/// Returns one to twelve readings of a line or of two regressors, under a uniform error bound or one per reading,
/// some with conditions. Repeated x, repeated rows and exact fits occur.
pub fn problem(rng: &mut ChaCha8Rng) -> Problem {
    let line = rng.random_bool(0.6);
    let uniform = rng.random_bool(0.6);
    let count = rng.random_range(1..=12);
    let slope = small_rational(rng);
    let epsilon = Rational::ratio(rng.random_range(0..=40), [1, 8, 100][rng.random_range(0..3)]);
    let mut rows: Vec<Measurement> = Vec::new();
    for row in 1..=count {
        let regressor = match rows.last().filter(|_| rng.random_bool(0.2)) {
            Some(last) => last.regressor.clone(),
            None if line => [small_rational(rng), Rational::one()],
            None => [small_rational(rng), small_rational(rng)],
        };
        let noise = Rational::ratio(rng.random_range(-10..=10), 8);
        let response = &slope * &regressor[0] + &regressor[1] * Rational::from(2) + noise;
        let epsilon = if uniform { epsilon.clone() } else { Rational::ratio(rng.random_range(0..=16), 8) };
        rows.push(Measurement::around(row, regressor, response, epsilon));
    }
    let model = if line {
        Model::Line { x: "x".into() }
    } else {
        Model::TwoRegressors { regressors: ["u".into(), "v".into()] }
    };
    let error_bound = if uniform { ErrorBound::Uniform(epsilon) } else { ErrorBound::Column("eps".into()) };
    let conditions = (0..rng.random_range(0..=3_usize).saturating_sub(1)).map(|_| condition(rng)).collect();
    Problem { measurements: Measurements::new(model, "y".into(), error_bound, rows), conditions }
}

fn condition(rng: &mut ChaCha8Rng) -> Condition {
    let relation = ["<=", ">=", "<=", ">=", "="][rng.random_range(0..5)];
    let [a, b, c] = [0; 3].map(|_| rng.random_range(-4..=4));
    parse_condition(&format!("{a}*theta1 + {b}*theta2 {relation} {c}"))
}

/// A condition from its text.
///
/// # Panics
/// When the text is not a condition.
pub fn parse_condition(text: &str) -> Condition {
    Condition::parse(text, Reading::Decimal, &Limits::default()).expect(text)
}

/// The problem with other rows.
pub fn with_rows(problem: &Problem, rows: Vec<Measurement>) -> Problem {
    rebuilt(problem, rows, problem.measurements.error_bound().clone())
}

/// The problem with its error bounds multiplied (per row) or replaced (uniform).
pub fn with_error_bound(problem: &Problem, bound: &Rational) -> Problem {
    let old = &problem.measurements;
    let uniform = old.error_bound().is_uniform();
    let epsilon = |row: &Measurement| if uniform { bound.clone() } else { y_and_epsilon(row).1 * bound };
    let rows = old.kept().iter().map(|row| row.clone().within(epsilon(row))).collect();
    let error_bound = if uniform { ErrorBound::Uniform(bound.clone()) } else { old.error_bound().clone() };
    rebuilt(problem, rows, error_bound)
}

/// y and ε of a reading that is bounded by them.
pub fn y_and_epsilon(row: &Measurement) -> (&Rational, &Rational) {
    let Bounds::Around { response, epsilon } = &row.bounds else {
        panic!("row {} has other bounds", row.row)
    };
    (response, epsilon)
}

/// The problem with other rows and error bounds.
pub fn rebuilt(problem: &Problem, rows: Vec<Measurement>, error_bound: ErrorBound) -> Problem {
    let old = &problem.measurements;
    let measurements = Measurements::new(old.model().clone(), old.response().to_owned(), error_bound, rows);
    Problem { measurements, conditions: problem.conditions.clone() }
}

/// The problem with readings that are intervals: with and without y, open on one side, and crossing.
pub fn in_intervals(problem: &Problem, rng: &mut ChaCha8Rng) -> Problem {
    let mut rows = problem.measurements.kept().to_vec();
    for row in &mut rows {
        let (y, epsilon) = y_and_epsilon(row);
        let sides = (y - epsilon, y + epsilon * Rational::from(rng.random_range(0..3_i64)));
        let (lower, upper, response) = match rng.random_range(0..6) {
            0 => (Some(sides.0), None, None),
            1 => (None, Some(sides.1), Some(y.clone())),
            2 => (Some(sides.1), Some(sides.0), None),
            3 => (Some(sides.0), Some(sides.1), Some(y.clone())),
            _ => (Some(sides.0), Some(sides.1), None),
        };
        row.bounds = Bounds::Between { lower, upper, response };
    }
    let columns = ErrorBound::Interval { lower: Some("low".into()), upper: Some("high".into()) };
    rebuilt(problem, rows, columns)
}

/// Least squares and EUI by their definitions, θ̂ = A·y with A = (ΦᵀΦ)⁻¹Φᵀ and Σ_k |A_jk|·ε_k, one fraction after the other.
pub fn naive_least_squares(measurements: &Measurements) -> Result<LeastSquares, NoLeastSquares> {
    let rows = measurements.all().expect("every reading is kept");
    let gram = |i: usize, j: usize| -> Rational {
        rows.iter().map(|row| &row.regressor[i] * &row.regressor[j]).sum()
    };
    let (g11, g12, g22) = (gram(0, 0), gram(0, 1), gram(1, 1));
    let determinant = &g11 * &g22 - &g12 * &g12;
    let weights = |j: usize, Measurement { regressor: [u, v], .. }: &Measurement| {
        let numerator = if j == 0 { &g22 * u - &g12 * v } else { &g11 * v - &g12 * u };
        numerator.checked_div(&determinant).ok_or(NoLeastSquares::Singular)
    };
    let part = |j: usize| {
        let (mut theta, mut radius) = (Rational::zero(), Rational::zero());
        for row in rows {
            let weight = weights(j, row)?;
            let (response, epsilon) = y_and_epsilon(row);
            theta = theta + &weight * response;
            radius = radius + weight.abs() * epsilon;
        }
        let eui = Interval::around(&theta, &radius).expect("a radius is not negative");
        if rows.is_empty() { Err(NoLeastSquares::Singular) } else { Ok((theta, eui)) }
    };
    let ((theta1, eui1), (theta2, eui2)) = (part(0)?, part(1)?);
    Ok(LeastSquares { theta: [theta1, theta2], eui: Ok([eui1, eui2]) })
}

/// A line sampled at `count` places with four decimals, with uniform noise below the error bound: the benchmarks' data.
pub fn noisy_line(count: i64) -> Problem {
    let mut rng = seeded(7);
    let points = (0..count).map(|k| {
        let x = (k - count / 2) * 100_000 / count;
        (
            Rational::ratio(x, 10_000),
            Rational::ratio(18 * x + 227_000 + rng.random_range(-2000..=2000), 10_000),
        )
    });
    line(points, Rational::ratio(1, 4))
}

/// Integer points of the parabola y = x² in random order, every one extreme, with an error bound that a line meets: the
/// benchmarks' hardest data.
pub fn parabola(count: i64) -> Problem {
    let mut abscissas: Vec<i64> = (0..count).map(|k| k - count / 2).collect();
    abscissas.shuffle(&mut seeded(8));
    let points = abscissas.into_iter().map(|x| (Rational::from(x), Rational::from(x * x)));
    line(points, Rational::from(count * count))
}

/// Readings of a line under a uniform error bound.
pub fn line(points: impl IntoIterator<Item = (Rational, Rational)>, epsilon: Rational) -> Problem {
    let rows = (1..)
        .zip(points)
        .map(|(row, (x, y))| Measurement::around(row, [x, Rational::one()], y, epsilon.clone()));
    let model = Model::Line { x: "x".into() };
    let measurements =
        Measurements::new(model, "y".into(), ErrorBound::Uniform(epsilon.clone()), rows.collect());
    Problem { measurements, conditions: Vec::new() }
}
