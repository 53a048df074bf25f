//! Fits under bounds that differ from reading to reading, and of two regressors, from the few readings that decide them,
//! against fits of all readings in memory.

use std::fs;
use std::path::Path;

use boundfit_estimation::{
    Columns, Condition, EpsilonColumn, Fit, Keep, Law, LineForm, Measurements, Problem, fit,
};
use boundfit_exact::{Limits, Rational, Reading};
use boundfit_formats::{ColumnSelector, Source};
use boundfit_geometry::RegionKind;
use boundfit_tests::generate::seeded;
use boundfit_tests::readings::parse_condition;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use crate::reduction::{essence, options, pools};

/// A table with columns a, b, y, e, lo and up, and how it is to be fitted.
struct Case {
    text: String,
    columns: Columns,
    reading: Reading,
    conditions: Vec<Condition>,
    is_through_origin: bool,
}

fn column(name: &str) -> ColumnSelector {
    ColumnSelector::name_or_number(name)
}

/// A number of one of several sizes, as it may be written.
fn number(rng: &mut ChaCha8Rng, units: i64, style: u32) -> String {
    match style {
        0 => units.to_string(),
        1 => Rational::ratio(units, 8).to_string(),
        2 => format!("{}e-3", units * 125),
        3 => format!("{}.{:018}", units, rng.random_range(0..3_u64)),
        _ => format!("{}", units as f64 / 3.0),
    }
}

impl Case {
    fn random(rng: &mut ChaCha8Rng, rows: std::ops::RangeInclusive<usize>) -> Self {
        let is_line = rng.random_bool(0.5);
        let kind = rng.random_range(0..6);
        let style = rng.random_range(0..5);
        let size = [1, 2, 5, 40][rng.random_range(0..4)];
        let noise = [0, 1, 3, 30][rng.random_range(0..4)];
        let widest = [0, 1, 3, 60][rng.random_range(0..4)];
        let slopes = [0; 2].map(|_| rng.random_range(-3..=3));
        let crossing = rng.random_bool(0.1);
        let one_sided = [0.0, 0.2, 1.0][rng.random_range(0..3)];
        let mut text = "a,b,y,e,lo,up\n".to_owned();
        for _ in 0..rng.random_range(rows) {
            let [a, b] = [0; 2].map(|_| rng.random_range(-size..=size));
            let second = if is_line { 1 } else { b };
            let y = slopes[0] * a + slopes[1] * second + rng.random_range(-noise..=noise);
            let e = rng.random_range(0..=widest);
            let below = rng.random_range(if crossing { -widest } else { 0 }..=widest);
            let mut cells = [a, b, y, e, y - below, y + e].map(|units| number(rng, units, style));
            if rng.random_bool(one_sided) {
                cells[rng.random_range(4..6)].clear();
            }
            text += &(cells.join(",") + "\n");
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
            conditions.push(parse_condition(
                &format!("{a}*theta1 + {b}*theta2 {relation} {c}").replace("+ -", "- "),
            ));
        }
        let reading = if rng.random_bool(0.3) { Reading::Binary64 } else { Reading::Decimal };
        let is_through_origin = is_line && rng.random_bool(0.15);
        Case { text, columns, reading, conditions, is_through_origin }
    }

    fn fitted(&self, measurements: Measurements) -> (Problem, Fit) {
        let problem = Problem { measurements, conditions: self.conditions.clone() };
        // A line through the origin takes its sums and its EUI from the same looks.
        let problem = if self.is_through_origin { problem.through_origin() } else { problem };
        let fit = fit(&problem);
        fit.verify(&problem).unwrap();
        (problem, fit)
    }

    fn whole(&self) -> (Problem, Fit) {
        let source = Source::new("table", std::io::Cursor::new(self.text.clone().into_bytes()));
        let table = options(self.reading, 1).table;
        self.fitted(Measurements::read(source, &self.columns, &table).unwrap())
    }

    fn scanned(&self, path: &Path, chunk_bytes: usize, most_bytes: Option<usize>) -> (Problem, Fit) {
        let keep = Keep { most_rows: 0, eui: true, most_bytes };
        let options = options(self.reading, chunk_bytes);
        let source = Source::open(path.to_str().unwrap()).unwrap();
        let own = self.is_through_origin.then(Condition::no_intercept);
        let conditions: Vec<Condition> = self.conditions.iter().cloned().chain(own).collect();
        self.fitted(Measurements::scan(source, &self.columns, &conditions, &options, keep).unwrap())
    }
}

fn compare(
    rounds: usize,
    seed: u64,
    rows: std::ops::RangeInclusive<usize>,
    chunks: [usize; 3],
) -> Vec<RegionKind> {
    let mut rng = seeded(seed);
    let pools = pools();
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("table.csv");
    let mut kinds = Vec::new();
    for round in 0..rounds {
        let case = Case::random(&mut rng, rows.clone());
        fs::write(&path, &case.text).unwrap();
        let whole = case.whole();
        kinds.push(whole.1.fps.polyhedron().region().kind());
        let expected = essence(&whole, &|row| row);
        // The numbers in memory, and the file read again.
        for (position, (chunk, pool)) in chunks.into_iter().zip(&pools).enumerate() {
            let most_bytes = if (round + position) % 2 == 0 { None } else { Some(0) };
            let streamed = pool.install(|| case.scanned(&path, chunk, most_bytes));
            assert_eq!(
                essence(&streamed, &|row| row),
                expected,
                "case {round}: {:?}\n{}",
                case.columns,
                case.text
            );
            assert_eq!(streamed.1.eui(), whole.1.eui(), "case {round}: {:?}\n{}", case.columns, case.text);
        }
    }
    kinds
}

#[test]
fn bounds_per_row_and_two_regressors_stream_for_any_parts_and_threads() {
    let kinds = compare(1500, 61, 1..=30, [1, 7, 4096]);
    for kind in RegionKind::ALL {
        let count = kinds.iter().filter(|own| **own == kind).count();
        let is_rare = matches!(kind, RegionKind::Plane | RegionKind::HalfPlane | RegionKind::Ray);
        assert!(count >= if is_rare { 1 } else { 3 }, "{kind:?}: {count}");
    }
}

#[test]
fn long_tables_stream_through_sieves() {
    compare(20, 62, 2_000..=4_000, [20_000, 7_000, 4096]);
}
