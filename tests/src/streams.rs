//! Tables with bounds that differ from reading to reading, and of two regressors, and how they are to be fitted.

use std::ops::{Range, RangeInclusive};

use boundfit_estimation::{
    Columns, Condition, EpsilonColumn, Fit, Law, LineForm, Measurements, Problem, fit,
};
use boundfit_exact::{Limits, Rational, Reading};
use boundfit_formats::ColumnSelector;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use crate::readings::parse_condition;

/// A table with columns a, b, y, e, lo and up, and how it is to be fitted.
pub struct Case {
    /// The table.
    pub text: String,
    /// The columns that are asked for, and the bounds.
    pub columns: Columns,
    /// The reading of its numbers.
    pub reading: Reading,
    /// Conditions on the parameters.
    pub conditions: Vec<Condition>,
    /// `true` for a line through the origin.
    pub is_through_origin: bool,
}

/// The column of a name.
pub fn column(name: &str) -> ColumnSelector {
    ColumnSelector::name_or_number(name)
}

/// A number of one of several sizes, as it may be written.
fn number(rng: &mut ChaCha8Rng, units: i64, style: u32) -> String {
    match style {
        0 => units.to_string(),
        1 => Rational::ratio(units, 8).to_string(),
        2 => format!("{}e-3", units * 125),
        3 => format!("{}.{:018}", units, rng.random_range(0..3_u64)),
        4 => format!("{}", units as f64 / 3.0),
        5 => format!("{}.{:016}", units, rng.random_range(0..10_u64.pow(16))),
        6 => format!("{}.{1:018}{1:017}{1:018}", units, rng.random_range(0..10_u64.pow(17))),
        _ => {
            format!(
                "{}.{:05}e{}",
                units,
                rng.random_range(0..20_000),
                [-400, -170, 0, 160][rng.random_range(0..4)]
            )
        }
    }
}

/// The styles of numbers of which columns of integers hold many.
pub const SHORT: Range<u32> = 0..5;
/// Numbers of 17 and 53 digits, of which no two are alike.
pub const LONG: Range<u32> = 5..7;
/// The styles of long numbers, and numbers so far from 1 that a filter by floats may not tell them.
pub const FAR: Range<u32> = 5..8;

impl Case {
    /// Returns a case with numbers that columns of integers hold.
    pub fn random(rng: &mut ChaCha8Rng, rows: RangeInclusive<usize>) -> Self {
        Case::written(rng, rows, SHORT)
    }

    /// Returns a case with numbers written in one of these styles.
    pub fn written(rng: &mut ChaCha8Rng, rows: RangeInclusive<usize>, styles: Range<u32>) -> Self {
        let is_line = rng.random_bool(0.5);
        let kind = rng.random_range(0..6);
        let style = rng.random_range(styles);
        let size = [1, 2, 5, 40][rng.random_range(0..4)];
        let noise = [0, 1, 3, 30][rng.random_range(0..4)];
        let widest = [0, 1, 3, 60][rng.random_range(0..4)];
        let slopes = [0; 2].map(|_| rng.random_range(-3..=3));
        let crossing = rng.random_bool(0.1);
        let one_sided = [0.0, 0.2, 1.0][rng.random_range(0..3)];
        let mut text = "a,b,y,e,lo,up,id\n".to_owned();
        for id in 1..=rng.random_range(rows) {
            let [a, b] = [0; 2].map(|_| rng.random_range(-size..=size));
            let second = if is_line { 1 } else { b };
            let y = slopes[0] * a + slopes[1] * second + rng.random_range(-noise..=noise);
            let e = rng.random_range(0..=widest);
            let below = rng.random_range(if crossing { -widest } else { 0 }..=widest);
            let mut cells = [a, b, y, e, y - below, y + e].map(|units| number(rng, units, style));
            if rng.random_bool(one_sided) {
                cells[rng.random_range(4..6)].clear();
            }
            text += &format!("{},{id}\n", cells.join(","));
        }
        let uniform = Rational::ratio(rng.random_range(0..=widest), [1, 8][rng.random_range(0..2)]);
        let law =
            |text: &str| EpsilonColumn::Law(Law::parse(text, Reading::Decimal, &Limits::default()).unwrap());
        let [lower, upper] = ["lo", "up"].map(|name| Some(column(name)));
        let epsilon = match kind {
            0 if !is_line => EpsilonColumn::Uniform(uniform),
            0 | 1 => EpsilonColumn::Column(column("e")),
            2 | 3 => EpsilonColumn::Interval { lower, upper },
            // A fraction has no last digit.
            4 if style == 1 => law("10%*|y| + 1/8"),
            4 => law("10%*|y| + 1/8 + 2*written"),
            _ => law("+1/2/-25%*|y|"),
        };
        let is_interval = matches!(epsilon, EpsilonColumn::Interval { .. });
        let x_origin = Rational::ratio([0, 3][rng.random_range(0..2)], 2);
        let columns = Columns {
            first: column("a"),
            second: (!is_line).then(|| column("b")),
            response: (!is_interval || rng.random_bool(0.5)).then(|| column("y")),
            epsilon,
            form: LineForm { x_origin, through_origin: false },
        };
        let mut conditions = Vec::new();
        while rng.random_bool(0.2) {
            let [a, b, c] = [0; 3].map(|_| rng.random_range(-4..=4));
            let relation = if rng.random_bool(0.5) { "<=" } else { ">=" };
            conditions.push(parse_condition(&format!("{a}*theta1 + {b}*theta2 {relation} {c}")));
        }
        let reading = if rng.random_bool(0.3) { Reading::Binary64 } else { Reading::Decimal };
        let is_through_origin = is_line && rng.random_bool(0.15);
        Case { text, columns, reading, conditions, is_through_origin }
    }

    /// Integers of two regressors, of which many go through one point exactly: what many rows say at once, in any order.
    pub fn of_ties(rng: &mut ChaCha8Rng, rows: RangeInclusive<usize>) -> Self {
        let size = [1, 3, 30, 1000][rng.random_range(0..4)];
        let noise = [0, 1, 1, 3][rng.random_range(0..4)];
        let is_positive = rng.random_bool(0.5);
        let centres = [0; 2].map(|_| [0; 2].map(|_| rng.random_range(-3..=3)));
        let parted = [0.0, 0.0, 0.02, 0.5][rng.random_range(0..4)];
        let mut readings: Vec<[i64; 3]> = (0..rng.random_range(rows))
            .map(|_| {
                let least = if is_positive { 0 } else { -size };
                let [a, b] = [0; 2].map(|_| rng.random_range(least..=size));
                let [p, q] = centres[usize::from(rng.random_bool(parted))];
                [a, b, p * a + q * b + rng.random_range(-noise..=noise)]
            })
            .collect();
        match rng.random_range(0..4) {
            0 => readings.sort_unstable(),
            1 => readings.sort_by_key(|[a, b, _]| 5000 * a / b.abs().max(1)),
            _ => {}
        }
        let unit = ["", ".0", "e-2"][rng.random_range(0..3)];
        let row = |(id, [a, b, y]): (usize, &[i64; 3])| format!("{a},{b},{y}{unit},{}\n", id + 1);
        let rows: String = readings.iter().enumerate().map(row).collect();
        let epsilon = Rational::ratio(2 * noise + [-1, 0, 0, 0, 1, 2][rng.random_range(0..6)], 2).abs();
        let epsilon = if unit == "e-2" { epsilon * Rational::ratio(1, 100) } else { epsilon };
        let columns = Columns {
            first: column("a"),
            second: Some(column("b")),
            response: Some(column("y")),
            epsilon: EpsilonColumn::Uniform(epsilon),
            form: LineForm::default(),
        };
        let condition = rng.random_bool(0.2).then(|| parse_condition("theta1 + theta2 <= 1"));
        let (text, conditions) = ("a,b,y,id\n".to_owned() + &rows, condition.into_iter().collect());
        Case { text, columns, reading: Reading::Decimal, conditions, is_through_origin: false }
    }

    /// Returns whether half units of last digits are asked for.
    pub fn needs_written(&self) -> bool {
        matches!(&self.columns.epsilon, EpsilonColumn::Law(law) if law.needs_written())
    }

    /// The conditions, with that of a line through the origin.
    pub fn all_conditions(&self) -> Vec<Condition> {
        let own = self.is_through_origin.then(Condition::no_intercept);
        self.conditions.iter().cloned().chain(own).collect()
    }

    /// Returns the fit of measurements from the table, which is proved.
    pub fn fitted(&self, measurements: Measurements) -> (Problem, Fit) {
        let problem = Problem { measurements, conditions: self.conditions.clone() };
        // A line through the origin takes its sums and its EUI from the same looks.
        let problem = if self.is_through_origin { problem.through_origin() } else { problem };
        let fit = fit(&problem);
        fit.verify(&problem).unwrap();
        (problem, fit)
    }
}
