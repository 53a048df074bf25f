//! Readings with bounds of their own, on one side or both, and laws of the error bound, against the oracle. The test
//! computes every bound from the digits in the table.

use std::fmt::Write;
use std::io::Cursor;

use boundfit_estimation::{
    Columns, Condition, EpsilonColumn, Fps, Keep, Law, LineForm, Measurements, Minimax, NoEui,
    NoLeastSquares, Problem, fit,
};
use boundfit_exact::{Endpoint, Limits, Rational, Reading};
use boundfit_formats::{ColumnSelector, ScanOptions, Source, TableOptions};
use boundfit_tests::generate::{seeded, share};
use boundfit_tests::oracle::{Row, solve};
use boundfit_tests::readings::parse_condition;
use boundfit_tests::reducing::{shuffled_parts, try_reduced};
use boundfit_tests::shape::{Tally, shape};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use crate::oracle::in_oracle_terms;

/// The statement of a generated row.
#[derive(Debug, Clone)]
struct Said {
    regressor: [i64; 2],
    y: Option<Rational>,
    lower: Option<Rational>,
    upper: Option<Rational>,
}

/// A table, how it is to be read, and what its rows say.
#[derive(Debug)]
struct Case {
    text: String,
    columns: Columns,
    rows: Vec<Said>,
    conditions: Vec<Condition>,
}

fn column(name: &str) -> ColumnSelector {
    ColumnSelector::name_or_number(name)
}

fn regressor(rng: &mut ChaCha8Rng, is_line: bool) -> [i64; 2] {
    let size = [1, 3][rng.random_range(0..2)];
    [rng.random_range(-size..=size), if is_line { 1 } else { rng.random_range(-2..=2) }]
}

fn conditions(rng: &mut ChaCha8Rng) -> Vec<Condition> {
    const TEXTS: [&str; 4] = ["theta1 >= 0", "theta2 <= 2", "theta1 + theta2 >= -1", "theta1 <= -3"];
    let count = rng.random_range(0..=4_usize).saturating_sub(3);
    (0..count).map(|_| parse_condition(TEXTS[rng.random_range(0..4)])).collect()
}

/// Rows between bounds: both, one or mixed; of width zero, crossing, repeated.
fn intervals(rng: &mut ChaCha8Rng) -> Case {
    let is_line = rng.random_bool(0.6);
    let has_y = rng.random_bool(0.3);
    let style = rng.random_range(0..8);
    let slope = rng.random_range(-2..=2);
    // Readings that say nothing of any parameter leave the plane.
    let is_idle = !is_line && rng.random_bool(0.1);
    let mut rows: Vec<Said> = Vec::new();
    for _ in 0..rng.random_range(1..=9) {
        let half = |value: i64| Rational::ratio(value, 2);
        let fresh = {
            let regressor = if is_idle { [0, 0] } else { regressor(rng, is_line) };
            let middle = 2 * slope * regressor[0] + rng.random_range(-2..=2);
            let width = match style {
                0 => 0,
                1 => rng.random_range(-1..=6),
                _ => rng.random_range(0..=6),
            };
            let there = match style {
                2 => [true, false],
                3 => [false, true],
                4 | 5 => [[true, true], [true, false], [false, true]][rng.random_range(0..3)],
                _ => [true, true],
            };
            Said {
                regressor,
                y: has_y.then(|| half(rng.random_range(-6..=6))),
                lower: there[0].then(|| half(middle - width)),
                upper: there[1].then(|| half(middle + width)),
            }
        };
        let again = rows.last().filter(|_| rng.random_bool(0.15)).cloned();
        rows.push(again.unwrap_or(fresh));
    }
    let mut text = "u,v,y,lo,up\n".to_owned();
    for Said { regressor: [u, v], y, lower, upper } in &rows {
        let mut cell = |value: &Option<Rational>| match value {
            Some(value) => decimal(value),
            None => ["", " ", "NA", "nan"][rng.random_range(0..4)].to_owned(),
        };
        let (lower, upper) = (cell(lower), cell(upper));
        let y = y.as_ref().map_or_else(String::new, ToString::to_string);
        let _ = writeln!(text, "{u},{v},{y},{lower},{upper}");
    }
    let sides = |name: &str, there: bool| there.then(|| column(name));
    let asked = [style != 3 || rng.random_bool(0.5), style != 2 || rng.random_bool(0.5)];
    let columns = Columns {
        first: column("u"),
        second: (!is_line).then(|| column("v")),
        response: has_y.then(|| column("y")),
        epsilon: EpsilonColumn::Interval { lower: sides("lo", asked[0]), upper: sides("up", asked[1]) },
        form: LineForm::default(),
    };
    Case { text, columns, rows, conditions: conditions(rng) }
}

/// A multiple of a half as a decimal.
fn decimal(value: &Rational) -> String {
    let twice = whole(value, 2);
    let sign = if twice < 0 { "-" } else { "" };
    format!("{sign}{}.{}", twice.abs() / 2, twice.abs() % 2 * 5)
}

/// Rows under a law, with y in many notations.
fn law(rng: &mut ChaCha8Rng) -> Case {
    let is_line = rng.random_bool(0.7);
    let slope = rng.random_range(-2..=2);
    let mut text = "u,v,y\n".to_owned();
    let mut readings = Vec::new();
    for _ in 0..rng.random_range(1..=8) {
        let regressor = regressor(rng, is_line);
        let near = slope * regressor[0] + rng.random_range(-1..=1);
        let places = rng.random_range(0..=2_usize);
        let mantissa = near * 10_i64.pow(places as u32) + rng.random_range(-3..=3);
        let exponent = [0, 0, 0, 1, -1][rng.random_range(0..5)];
        let (sign, size) = (if mantissa < 0 { "-" } else { "" }, mantissa.abs());
        let unit = 10_i64.pow(places as u32);
        let digits = match places {
            0 => format!("{size}"),
            _ => format!("{}.{:0places$}", size / unit, size % unit),
        };
        let exponent_text = if exponent == 0 { String::new() } else { format!("e{exponent}") };
        let _ = writeln!(text, "{},{},{sign}{digits}{exponent_text}", regressor[0], regressor[1]);
        let unit = Rational::scientific(1, i64::from(exponent) - places as i64);
        readings.push((regressor, Rational::from(mantissa) * &unit, unit * Rational::ratio(1, 2)));
    }
    let range =
        readings.iter().map(|row| &row.1).max().unwrap() - readings.iter().map(|row| &row.1).min().unwrap();
    let mut sum = || {
        let mut terms = vec![(format!("0.{}", rng.random_range(0..=9)), None)];
        terms[0].1 = Some((0, terms[0].0[2..].parse::<i64>().unwrap(), 10));
        for (index, name) in [(1, "|y|"), (2, "|x|"), (3, "range(y)"), (4, "written")] {
            if rng.random_bool(0.35) && (index != 2 || is_line) {
                let times = rng.random_range(0..=30);
                let (text, divisor) = match rng.random_range(0..3) {
                    0 => (format!("{times}%*{name}"), 100),
                    1 => (format!("{times}/7 * {name}"), 7),
                    _ => (format!("{times}*{name}"), 1),
                };
                let times = if divisor == 1 && index != 4 { None } else { Some((index, times, divisor)) };
                if times.is_some() {
                    terms.push((text, times));
                }
            }
        }
        if terms.len() > 1 && rng.random_bool(0.5) {
            terms.remove(0);
        }
        let text = terms.iter().map(|(text, _)| text.as_str()).collect::<Vec<_>>().join(" + ");
        let terms: Vec<(usize, Rational)> = terms
            .into_iter()
            .flat_map(|(_, t)| t)
            .map(|(index, n, d)| (index, Rational::ratio(n, d)))
            .collect();
        (text, terms)
    };
    let (above, below) = (sum(), sum());
    let is_asymmetric = rng.random_bool(0.3);
    let (asked, below) = if is_asymmetric {
        (format!("+{}/-{}", above.0, below.0), below.1)
    } else {
        (above.0, above.1.clone())
    };
    let law = Law::parse(&asked, Reading::Decimal, &Limits::default()).expect(&asked);
    let said = |(regressor, y, written): ([i64; 2], Rational, Rational)| {
        let at = |terms: &[(usize, Rational)]| -> Rational {
            let x = Rational::from(regressor[0]).abs();
            let quantities = [Rational::one(), y.abs(), x, range.clone(), written.clone()];
            terms.iter().map(|(index, times)| times * &quantities[*index]).sum()
        };
        Said { regressor, lower: Some(&y - at(&below)), upper: Some(&y + at(&above.1)), y: Some(y) }
    };
    let rows = readings.into_iter().map(said).collect();
    let columns = Columns {
        first: column("u"),
        second: (!is_line).then(|| column("v")),
        response: Some(column("y")),
        epsilon: EpsilonColumn::Law(law),
        form: LineForm::default(),
    };
    Case { text, columns, rows, conditions: conditions(rng) }
}

/// A number times a factor that makes it whole.
fn whole(value: &Rational, factor: i64) -> i128 {
    let value = value * Rational::from(factor);
    assert_eq!(value.denominator().to_string(), "1", "{value}");
    value.numerator().to_string().parse().unwrap()
}

/// 7 of the fractions, 100 of per cents, and two more places of y, halved.
const FACTOR: i64 = 7 * 100 * 2 * 1000;

impl Case {
    fn problem(&self, measurements: Measurements) -> Problem {
        Problem { measurements, conditions: self.conditions.clone() }
    }

    fn read(&self) -> Problem {
        let source = Source::new("case.csv", Cursor::new(self.text.clone().into_bytes()));
        self.problem(Measurements::read(source, &self.columns, &TableOptions::default()).expect(&self.text))
    }

    fn scanned(&self, chunk_bytes: usize, most_rows: usize) -> Problem {
        let source = Source::new("case.csv", Cursor::new(self.text.clone().into_bytes()));
        let options = ScanOptions { chunk_bytes, ..ScanOptions::default() };
        let keep = Keep { most_rows, ..Keep::default() };
        self.problem(
            Measurements::scan(source, &self.columns, &self.conditions, &options, keep).expect(&self.text),
        )
    }

    /// The problem of reductions of parts in any order; `None` where bounds are only known when all rows are.
    fn merged(&self, rng: &mut ChaCha8Rng) -> Option<Problem> {
        if let Err(refused) = try_reduced(&self.text, &self.columns, &ScanOptions::default()) {
            assert!(refused.to_string().contains("a law with range(y)"), "{refused}");
            return None;
        }
        let parts = shuffled_parts(&self.text, &self.columns, &ScanOptions::default(), rng);
        let source = Source::new("parts.csv", Cursor::new(parts.clone().into_bytes()));
        let (options, keep) = (ScanOptions::default(), Keep::default());
        let scanned = Measurements::scan(source, &self.columns, &self.conditions, &options, keep);
        Some(self.problem(scanned.unwrap_or_else(|error| panic!("{error}\n{parts}"))))
    }

    /// The half-planes when widths are multiplied by `times/over` about their middles.
    fn half_planes(&self, times: i128, over: i128) -> Vec<Row> {
        let mut rows = Vec::new();
        for said in &self.rows {
            let [u, v] = said.regressor.map(i128::from);
            let factor = 2 * i128::from(FACTOR) * over;
            let [lower, upper] =
                [&said.lower, &said.upper].map(|side| side.as_ref().map(|side| whole(side, FACTOR)));
            let (lower, upper) = match (lower, upper) {
                (Some(lower), Some(upper)) if lower <= upper => (
                    Some((lower + upper) * over - (upper - lower) * times),
                    Some((lower + upper) * over + (upper - lower) * times),
                ),
                (lower, upper) => (lower.map(|side| 2 * over * side), upper.map(|side| 2 * over * side)),
            };
            rows.extend(upper.map(|upper| [u * factor, v * factor, upper]));
            rows.extend(lower.map(|lower| [-u * factor, -v * factor, -lower]));
        }
        rows.extend(self.conditions.iter().map(|condition| {
            let inequality = condition.inequality();
            [&inequality.a[0], &inequality.a[1], &inequality.b].map(|number| whole(number, 1))
        }));
        rows.into_iter().map(reduced).collect()
    }

    fn is_empty_at(&self, times: &Rational) -> bool {
        let part = |part: boundfit_exact::Integer| part.to_string().parse().unwrap();
        solve(&self.half_planes(part(times.numerator()), part(times.denominator()))).kind == "empty"
    }
}

/// A row over its greatest common divisor: the oracle multiplies.
fn reduced([a, b, c]: Row) -> Row {
    fn gcd(a: i128, b: i128) -> i128 {
        if b == 0 { a.abs() } else { gcd(b, a % b) }
    }
    match gcd(gcd(a, b), c) {
        0 => [a, b, c],
        divisor => [a / divisor, b / divisor, c / divisor],
    }
}

/// Least squares and EUI by their definitions, from what the table says.
fn check_least_squares(case: &Case, problem: &Problem, tally: &mut Tally) {
    let found = fit(problem).least_squares;
    let rows = &case.rows;
    let values: Option<Vec<Rational>> = rows
        .iter()
        .map(|row| {
            let middle = || Some((row.lower.as_ref()? + row.upper.as_ref()?) * Rational::ratio(1, 2));
            row.y.clone().or_else(middle)
        })
        .collect();
    let Some(values) = values else {
        tally.count("no response");
        return assert_eq!(found, Err(NoLeastSquares::NoResponse), "{}", case.text);
    };
    let phi = |row: &Said, j: usize| Rational::from(row.regressor[j]);
    let gram = |i: usize, j: usize| -> Rational { rows.iter().map(|row| phi(row, i) * phi(row, j)).sum() };
    let determinant = gram(0, 0) * gram(1, 1) - gram(0, 1) * gram(0, 1);
    let Ok(found) = found else {
        tally.count("singular");
        return assert!(determinant.is_zero(), "{}", case.text);
    };
    let weight = |row: &Said, j: usize| {
        let other = 1 - j;
        (gram(other, other) * phi(row, j) - gram(0, 1) * phi(row, other)).checked_div(&determinant).unwrap()
    };
    for j in 0..2 {
        let theta: Rational = rows.iter().zip(&values).map(|(row, y)| weight(row, j) * y).sum();
        assert_eq!(found.theta[j], theta, "{}", case.text);
        let is_one_sided = rows.iter().any(|row| row.lower.is_none() || row.upper.is_none());
        let is_crossing = rows.iter().any(|row| row.lower > row.upper);
        match &found.eui {
            Err(reason) => {
                tally.count("no EUI");
                let expected = if is_one_sided { NoEui::OneSided } else { NoEui::Crossing };
                assert!(is_one_sided || is_crossing, "{}", case.text);
                assert_eq!(*reason, expected, "{}", case.text);
            }
            Ok(eui) => {
                tally.count("EUI");
                let (mut least, mut most) = (Rational::zero(), Rational::zero());
                for row in rows {
                    let ends = [&row.lower, &row.upper].map(|end| weight(row, j) * end.as_ref().unwrap());
                    least = least + ends.iter().min().unwrap();
                    most = most + ends.iter().max().unwrap();
                }
                let ends = [eui[j].lower(), eui[j].upper()].map(Endpoint::value);
                assert_eq!(ends, [Some(&least), Some(&most)], "{}", case.text);
            }
        }
    }
}

/// The least factor: the set is not empty there, and empty a little below; without one it is empty at any factor.
fn check_least_factor(case: &Case, problem: &Problem, tally: &mut Tally) {
    let measurements = &problem.measurements;
    let minimax = Minimax::new(measurements, &problem.conditions);
    if measurements.error_bound().is_uniform() {
        return;
    }
    let has_widths = case.rows.iter().any(|row| row.lower.is_some() && row.upper.is_some());
    let Some(minimax) = minimax else {
        tally.count(if has_widths { "no factor" } else { "no width" });
        return assert!(!has_widths || case.is_empty_at(&Rational::from(1000)), "{}", case.text);
    };
    assert!(has_widths, "{}", case.text);
    if minimax.least.denominator().bits() > 16 || minimax.least.numerator().bits() > 16 {
        return;
    }
    tally.count("factor");
    assert!(!case.is_empty_at(&minimax.least), "{} {}", case.text, minimax.least);
    if minimax.least.is_positive() {
        tally.count("positive factor");
        let below = &minimax.least * Rational::ratio(999, 1000);
        assert!(case.is_empty_at(&below), "{} {}", case.text, minimax.least);
    }
}

fn check(case: &Case, rng: &mut ChaCha8Rng, tally: &mut Tally) {
    let problem = case.read();
    for (chunk_bytes, most_rows) in [(1, usize::MAX), (1 << 18, usize::MAX)] {
        let scanned = case.scanned(chunk_bytes, most_rows).measurements;
        assert_eq!(scanned.kept(), problem.measurements.kept(), "{}", case.text);
        assert_eq!(scanned.error_bound(), problem.measurements.error_bound(), "{}", case.text);
    }
    let every = Fps::of_every_half_plane(&problem.measurements, &problem.conditions);
    let expected = solve(&case.half_planes(1, 1));
    assert_eq!(in_oracle_terms(every.polyhedron().region()), expected, "{}", case.text);
    tally.count(expected.kind);
    let merged = case.merged(rng);
    if merged.is_some() {
        tally.count("merged");
    }
    for problem in [Some(&problem), Some(&case.scanned(1 << 18, 0)), merged.as_ref()].into_iter().flatten() {
        let fit = fit(problem);
        assert_eq!(shape(fit.fps.polyhedron().region()), shape(every.polyhedron().region()), "{}", case.text);
        assert_eq!(fit.verify(problem), Ok(()), "{}", case.text);
    }
    check_least_squares(case, &problem, tally);
    check_least_factor(case, &problem, tally);
}

#[test]
fn intervals_and_rows_with_one_bound_agree_with_the_oracle() {
    let mut rng = seeded(61);
    let mut tally = Tally::default();
    for _ in 0..share(2500) {
        check(&intervals(&mut rng), &mut rng, &mut tally);
    }
    tally.assert_each_kind(3);
    let cases = ["no response", "singular", "EUI", "no EUI", "no factor", "no width", "positive factor"];
    tally.assert_each(20, &cases);
    tally.assert_each(2500, &["merged"]);
}

#[test]
fn laws_agree_with_the_oracle() {
    let mut rng = seeded(62);
    let mut tally = Tally::default();
    for _ in 0..share(1500) {
        check(&law(&mut rng), &mut rng, &mut tally);
    }
    tally.assert_each(20, &["empty", "polygon", "strip", "EUI", "factor", "positive factor"]);
    tally.assert_each(700, &["merged"]);
}
