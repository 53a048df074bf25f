//! Runs of readings by their definition: the set of every run on its own, by the oracle, which shares no code with the engine.

use boundfit_estimation::{Condition, ErrorBound, Measurement, Measurements, Model, Problem};
use boundfit_exact::Rational;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use crate::oracle::{Answer, Row, solve};
use crate::readings::parse_condition;

/// A reading in integers: φ, and the bounds on φ·θ.
#[derive(Debug, Clone)]
pub struct Reading {
    /// φ.
    pub phi: [i64; 2],
    /// φ·θ is at least this.
    pub lower: Option<i64>,
    /// φ·θ is at most this.
    pub upper: Option<i64>,
}

/// Readings in integers, and a·θ ≤ b for each condition.
#[derive(Debug, Clone)]
pub struct Readings {
    /// True if φ = (x, 1).
    pub is_line: bool,
    /// ε, where all readings have one.
    pub epsilon: Option<i64>,
    /// One after the other.
    pub rows: Vec<Reading>,
    /// (a1, a2, b) of each condition, and whether it is an equation.
    pub conditions: Vec<([i64; 3], bool)>,
}

/// One to `most` readings, degenerate ones most: few different x, repeated rows, all x equal, ε = 0, bounds that cross or are
/// missing, φ = 0, conditions that contradict.
pub fn readings(rng: &mut ChaCha8Rng, most: usize) -> Readings {
    let is_line = rng.random_bool(0.65);
    let epsilon = rng.random_bool(0.6).then(|| [0, 0, 1, 1, 2, 3][rng.random_range(0..6)]);
    let spread = [0, 1, 1, 2, 4, 9][rng.random_range(0..6)];
    let noise = [0, 1, 2, 3, 5][rng.random_range(0..5)];
    let slope = rng.random_range(-2..=2);
    let count = rng.random_range(1..=most);
    let mut rows: Vec<Reading> = Vec::new();
    for _ in 0..count {
        if let Some(last) = rows.last().filter(|_| rng.random_bool(0.15)).cloned() {
            rows.push(last);
            continue;
        }
        let x = rng.random_range(-spread..=spread);
        let phi = [x, if is_line { 1 } else { rng.random_range(-2..=2) }];
        // Every tenth reading follows a parabola: many corners.
        let middle =
            slope * x + rng.random_range(-noise..=noise) + if rng.random_bool(0.1) { x * x } else { 0 };
        let (below, above) = match epsilon {
            Some(epsilon) => (Some(epsilon), Some(epsilon)),
            None => {
                let mut side = || rng.random_bool(0.8).then(|| rng.random_range(-1..=4));
                (side(), side())
            }
        };
        rows.push(Reading {
            phi,
            lower: below.map(|below| middle - below),
            upper: above.map(|above| middle + above),
        });
    }
    let conditions = (0..rng.random_range(0..=4_usize).saturating_sub(2))
        .map(|_| ([0; 3].map(|_| rng.random_range(-3..=3)), rng.random_bool(0.25)))
        .collect();
    Readings { is_line, epsilon, rows, conditions }
}

impl Readings {
    /// The half-planes of these rows, in order, and of all conditions.
    pub fn half_planes(&self, rows: impl IntoIterator<Item = usize>) -> Vec<Row> {
        let mut all: Vec<Row> = Vec::new();
        let wide = |numbers: [i64; 3]| numbers.map(i128::from);
        for Reading { phi: [u, v], lower, upper } in rows.into_iter().map(|row| &self.rows[row]) {
            all.extend(upper.map(|upper| wide([*u, *v, upper])));
            all.extend(lower.map(|lower| wide([-u, -v, -lower])));
        }
        for &([a, b, c], is_equation) in &self.conditions {
            all.push(wide([a, b, c]));
            if is_equation {
                all.push(wide([-a, -b, -c]));
            }
        }
        all
    }

    /// The oracle's answer about these rows.
    pub fn answer(&self, rows: impl IntoIterator<Item = usize>) -> Answer {
        solve(&self.half_planes(rows))
    }

    /// Rows by ascending x, those at the same x as they stand.
    pub fn by_x(&self) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.rows.len()).collect();
        order.sort_by_key(|&row| self.rows[row].phi[0]);
        order
    }

    /// Returns whether two rows stand at one place when runs are taken by x.
    pub fn are_one_place(&self, one: usize, other: usize) -> bool {
        self.rows[one].phi[0] == self.rows[other].phi[0]
    }

    /// The maximal runs, first and last position from 0 of rows in some order: of all runs that have a set of their own those
    /// that no other one contains. By x, a run has all rows at one x or none.
    pub fn maximal_runs(&self, order: &[usize], by_x: bool) -> Vec<[usize; 2]> {
        let count = order.len();
        let cuts_a_place = |position: usize| {
            by_x && (1..count).contains(&position) && self.are_one_place(order[position - 1], order[position])
        };
        let mut fitting: Vec<[usize; 2]> = Vec::new();
        for first in 0..count {
            for last in first..count {
                if cuts_a_place(first) || cuts_a_place(last + 1) {
                    continue;
                }
                if self.answer(order[first..=last].iter().copied()).kind != "empty" {
                    fitting.push([first, last]);
                }
            }
        }
        let is_within =
            |run: &[usize; 2], other: &[usize; 2]| run != other && other[0] <= run[0] && run[1] <= other[1];
        let is_maximal = |run: &[usize; 2]| !fitting.iter().any(|other| is_within(run, other));
        fitting.iter().copied().filter(|run| is_maximal(run)).collect()
    }

    /// The problem for the engine.
    pub fn problem(&self) -> Problem {
        let rows = (1..).zip(&self.rows).map(|(row, reading)| self.measurement(row, reading)).collect();
        let model = if self.is_line {
            Model::Line { x: "x".into() }
        } else {
            Model::TwoRegressors { regressors: ["u".into(), "v".into()] }
        };
        let bound = match self.epsilon {
            Some(epsilon) => ErrorBound::Uniform(Rational::from(epsilon)),
            None => ErrorBound::Interval { lower: Some("lower".into()), upper: Some("upper".into()) },
        };
        let measurements = Measurements::new(model, "y".into(), bound, rows);
        Problem { measurements, conditions: self.conditions() }
    }

    /// The reading of a row.
    pub fn measurement(&self, row: usize, reading: &Reading) -> Measurement {
        let regressor = reading.phi.map(Rational::from);
        let [lower, upper] = [reading.lower, reading.upper].map(|bound| bound.map(Rational::from));
        match (self.epsilon, &lower) {
            (Some(epsilon), Some(lower)) => {
                let epsilon = Rational::from(epsilon);
                Measurement::around(row, regressor, lower + &epsilon, epsilon)
            }
            _ => Measurement::between(row, regressor, lower, upper),
        }
    }

    fn conditions(&self) -> Vec<Condition> {
        let text = |&([a, b, c], is_equation): &([i64; 3], bool)| {
            let relation = if is_equation { "=" } else { "<=" };
            format!("{a}*theta1 + {b}*theta2 {relation} {c}")
        };
        self.conditions.iter().map(|condition| parse_condition(&text(condition))).collect()
    }
}
