//! Fits of readings of which only those that touch a hull are kept, against fits of all of them.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use boundfit_estimation::{
    Columns, Condition, EpsilonColumn, ErrorBound, Fit, Keep, LeastSquares, LineForm, Measurement,
    Measurements, Model, NoEui, Problem, ReducedTable, fit,
};
use boundfit_exact::{Column, Rational, Reading};
use boundfit_formats::{ColumnSelector, Progress, ScanOptions, Source};
use boundfit_geometry::RegionKind;
use boundfit_tests::generate::{one_in, seeded, share};
use boundfit_tests::readings::{parse_condition, y_and_epsilon};
use boundfit_tests::reducing::{essence, essence_by, options};
use boundfit_tests::tables::TableKind;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rayon::ThreadPool;

fn columns(epsilon: &Rational) -> Columns {
    Columns {
        first: ColumnSelector::name_or_number("x"),
        second: None,
        response: Some(ColumnSelector::name_or_number("y")),
        epsilon: EpsilonColumn::Uniform(epsilon.clone()),
        form: LineForm::default(),
    }
}

fn text(rows: &[[String; 2]]) -> String {
    rows.iter().fold("x,y\n".to_owned(), |text, [x, y]| text + x + "," + y + "\n")
}

pub(crate) fn pools() -> Vec<ThreadPool> {
    let pool = |threads| rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    [1, 2, 4].map(pool).into()
}

/// A table and how it is to be fitted.
struct Case {
    rows: Vec<[String; 2]>,
    reading: Reading,
    epsilon: Rational,
    conditions: Vec<Condition>,
}

impl Case {
    fn random(rng: &mut ChaCha8Rng) -> Self {
        let kind = TableKind::ALL[rng.random_range(0..TableKind::ALL.len())];
        let count = rng.random_range(1..=40);
        let rows = kind.rows(rng, count);
        let binary = rng.random_bool(0.3);
        let reading = if binary { Reading::Binary64 } else { Reading::Decimal };
        let small = Rational::ratio(rng.random_range(0..=40), [1, 8, 100][rng.random_range(0..3)]);
        let scale = match kind {
            TableKind::WideIntegers => Rational::from(1_i128 << 62),
            TableKind::Extreme => Rational::from(100),
            _ => Rational::one(),
        };
        let mut conditions = Vec::new();
        while rng.random_bool(0.25) {
            let [a, b, c] = [0; 3].map(|_| rng.random_range(-4..=4));
            let relation = if rng.random_bool(0.5) { "<=" } else { ">=" };
            conditions.push(parse_condition(&format!("{a}*theta1 + {b}*theta2 {relation} {c}")));
        }
        Case { rows, reading, epsilon: small * scale, conditions }
    }

    fn columns(&self) -> Columns {
        columns(&self.epsilon)
    }

    /// The fit of all readings at once.
    fn whole(&self) -> (Problem, Fit) {
        let source = Source::new("table", std::io::Cursor::new(text(&self.rows).into_bytes()));
        let table = options(self.reading, 1).table;
        self.fitted(Measurements::read(source, &self.columns(), &table).unwrap())
    }

    fn fitted(&self, measurements: Measurements) -> (Problem, Fit) {
        let problem = Problem { measurements, conditions: self.conditions.clone() };
        let fit = fit(&problem);
        fit.verify(&problem).unwrap();
        (problem, fit)
    }

    fn scanned(&self, path: &Path, chunk_bytes: usize, keep: Keep) -> Measurements {
        let options = options(self.reading, chunk_bytes);
        Measurements::scan(
            Source::open(path.to_str().unwrap()).unwrap(),
            &self.columns(),
            &self.conditions,
            &options,
            keep,
        )
        .unwrap()
    }

    /// The same readings from columns in memory, of which only those that support a hull are kept.
    fn in_memory(&self, all: &Measurements) -> Measurements {
        let numbers = |number: fn(&Measurement) -> &Rational| all.kept().iter().map(number);
        let column = |number: fn(&Measurement) -> &Rational| match self.reading {
            Reading::Decimal => numbers(number).cloned().collect(),
            Reading::Binary64 => Column::Doubles(numbers(number).map(Rational::to_f64).collect()),
        };
        let columns = [column(|row| &row.regressor[0]), column(|row| y_and_epsilon(row).0)];
        let (model, response, bound) =
            (all.model().clone(), all.response().to_owned(), all.error_bound().clone());
        let keep = Keep { most_rows: 0, ..Keep::default() };
        Measurements::of_columns(model, response, bound, &columns, keep).unwrap()
    }

    fn reduced(&self, path: &Path, chunk_bytes: usize) -> String {
        let options = options(self.reading, chunk_bytes);
        let source = Source::open(path.to_str().unwrap()).unwrap();
        let table = ReducedTable::scan(source, &self.columns(), &options).unwrap();
        let mut text = Vec::new();
        table.write(&mut text).unwrap();
        String::from_utf8(text).unwrap()
    }
}

#[test]
fn a_scan_gives_the_fit_of_all_readings_for_any_parts_and_threads() {
    let mut rng = seeded(51);
    let pools = pools();
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("table.csv");
    let mut kinds = Vec::new();
    for case_number in 0..share(600) {
        let mut case = Case::random(&mut rng);
        fs::write(&path, text(&case.rows)).unwrap();
        let mut whole = case.whole();
        // At its least error bound the set is a point, or flat.
        if let Some(minimax) = whole.1.minimax.as_ref().filter(|_| rng.random_bool(0.2)) {
            case.epsilon = minimax.least.clone();
            whole = case.whole();
        }
        kinds.push(whole.1.fps.polyhedron().region().kind());
        let expected = essence(&whole, &|row| row);
        let in_memory = case.fitted(case.in_memory(&whole.0.measurements));
        assert_eq!(essence(&in_memory, &|row| row), expected, "case {case_number}: {:?}", case.rows);
        assert_eq!(in_memory.1.eui(), whole.1.eui(), "case {case_number}: {:?}", case.rows);
        for (chunk_bytes, pool) in [1, 7, 4096].into_iter().zip(&pools) {
            // All x in memory; none, and the file read a second time; those of the first rows until they are too many.
            for most_bytes in [None, Some(0), Some(40)] {
                let keep = Keep { most_rows: 0, most_bytes, ..Keep::default() };
                let reduced = case.fitted(pool.install(|| case.scanned(&path, chunk_bytes, keep)));
                let rows = &case.rows;
                assert_eq!(essence(&reduced, &|row| row), expected, "case {case_number}: {rows:?}");
                assert_eq!(reduced.1.eui(), whole.1.eui(), "case {case_number}: {rows:?}");
                let [one, other] =
                    [&reduced, &whole].map(|(problem, fit)| fit.inverse(problem.measurements.model()));
                assert_eq!(one, other, "case {case_number}: {rows:?}");
            }
            let all = case.scanned(&path, chunk_bytes, Keep::default());
            assert_eq!(all.kept(), whole.0.measurements.kept(), "case {case_number}");
            assert!(all.all().is_some());
        }
    }
    for kind in
        [RegionKind::Empty, RegionKind::Point, RegionKind::Polygon, RegionKind::Strip, RegionKind::Line]
    {
        assert!(kinds.iter().filter(|own| **own == kind).count() >= 3 / one_in(), "{kind:?} is too rare");
    }
}

#[test]
fn of_long_tables_too_only_the_rows_that_touch_a_hull_count() {
    let mut rng = seeded(53);
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("table.csv");
    for kind in [
        TableKind::Noise,
        TableKind::LongDecimals,
        TableKind::ManyDigits,
        TableKind::MixedDecimals,
        TableKind::WideIntegers,
    ] {
        for reading in [Reading::Decimal, Reading::Binary64] {
            let rows = kind.rows(&mut rng, 3000);
            let case = Case { rows, reading, epsilon: Rational::ratio(1, 3), conditions: Vec::new() };
            fs::write(&path, text(&case.rows)).unwrap();
            let whole = case.whole();
            for (chunk_bytes, most_bytes) in [(1 << 18, None), (5000, Some(0)), (5000, Some(4000))] {
                let keep = Keep { most_rows: 0, most_bytes, ..Keep::default() };
                let reduced = case.fitted(case.scanned(&path, chunk_bytes, keep));
                assert_eq!(
                    essence(&reduced, &|row| row),
                    essence(&whole, &|row| row),
                    "{kind:?} {reading:?}"
                );
                assert_eq!(reduced.1.eui(), whole.1.eui(), "{kind:?} {reading:?}");
                // Wide integers are few, and occur often.
                let kept = reduced.0.measurements.kept().len();
                assert!(kept < 200 || kind == TableKind::WideIntegers, "{kind:?} {reading:?}: {kept}");
            }
        }
    }
}

/// A stream cannot be read again: its EUI is known as long as all x fit into the memory allowed for them, at four bytes each.
#[test]
fn the_eui_of_a_stream_beyond_the_memory_allowed_for_it_is_not_known() {
    let mut rng = seeded(55);
    let rows = TableKind::Noise.rows(&mut rng, 30_000);
    let case = Case { rows, reading: Reading::Decimal, epsilon: Rational::one(), conditions: Vec::new() };
    let whole = case.whole();
    let streamed = |most_bytes| {
        let keep = Keep { most_rows: 0, most_bytes: Some(most_bytes), ..Keep::default() };
        let source = Source::new("stream", std::io::Cursor::new(text(&case.rows).into_bytes()));
        let options = options(Reading::Decimal, 5000);
        let measurements = Measurements::scan(source, &columns(&case.epsilon), &[], &options, keep).unwrap();
        let fit = case.fitted(measurements).1;
        let Some(LeastSquares { eui, .. }) = fit.least_squares.ok() else { panic!("30,000 different x") };
        eui
    };
    assert_eq!(streamed(120_000).ok().as_ref(), whole.1.eui());
    for most_bytes in [119_999, 60_000, 0] {
        assert_eq!(streamed(most_bytes), Err(NoEui::TooManyOnce));
    }
}

/// Replaces a file when all of it has been read once: the next part is read before one is reported.
struct Replacing {
    path: PathBuf,
    left: AtomicU64,
    text: String,
}

impl Progress for Replacing {
    fn advanced(&self, bytes: u64) {
        let before = self.left.fetch_sub(bytes, Ordering::Relaxed);
        if (bytes..bytes + 200).contains(&before) {
            fs::write(&self.path, &self.text).unwrap();
        }
    }
}

#[test]
fn a_file_that_changes_between_two_looks_is_refused() {
    let mut rng = seeded(54);
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("table.csv");
    let columns = columns(&Rational::one());
    let keep = Keep { most_rows: 0, most_bytes: Some(0), ..Keep::default() };
    let rows = TableKind::Noise.rows(&mut rng, 500);
    let first = text(&rows);
    // The same; one x less by 1000; a row less; rows that were not there the first time.
    let mut moved = rows.clone();
    moved[123][0] = "-1000".to_owned();
    let longer = first.clone() + "1000000,0\n";
    for (second, is_refused) in
        [(first.clone(), false), (text(&moved), true), (text(&rows[1..]), true), (longer, false)]
    {
        fs::write(&path, &first).unwrap();
        let replacing =
            Replacing { path: path.clone(), left: AtomicU64::new(first.len() as u64), text: second };
        let options = ScanOptions { progress: Some(Arc::new(replacing)), ..options(Reading::Decimal, 1000) };
        let scanned =
            Measurements::scan(Source::open(path.to_str().unwrap()).unwrap(), &columns, &[], &options, keep);
        match scanned {
            Err(error) => {
                assert!(is_refused && error.to_string().ends_with("the file changed while it was read"))
            }
            Ok(measurements) => assert!(!is_refused && measurements.fitted() == 500),
        }
    }
}

#[test]
fn reductions_of_parts_put_together_and_reduced_are_the_reduction_of_the_whole() {
    let mut rng = seeded(52);
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("table.csv");
    for case_number in 0..share(600) {
        let case = Case::random(&mut rng);
        fs::write(&path, text(&case.rows)).unwrap();
        let whole = case.whole();
        let of_whole = case.reduced(&path, 7);
        let mut together = String::new();
        let mut rest = case.rows.as_slice();
        while !rest.is_empty() {
            let (part, others) = rest.split_at(rng.random_range(1..=rest.len()));
            fs::write(&path, text(part)).unwrap();
            together += &case.reduced(&path, 4096);
            rest = others;
        }
        // Twice: the reduction of a reduction is itself.
        fs::write(&path, &together).unwrap();
        let again = case.reduced(&path, 1);
        assert_eq!(again, of_whole, "case {case_number}: {:?}", case.rows);
        let from_parts = case.fitted(case.scanned(&path, 7, Keep::default()));
        fs::write(&path, &again).unwrap();
        assert_eq!(case.reduced(&path, 64), of_whole, "case {case_number}");
        // The k-th row kept is the k-th that touches a hull.
        let kept: Vec<usize> = {
            fs::write(&path, text(&case.rows)).unwrap();
            let keep = Keep { most_rows: 0, ..Keep::default() };
            case.scanned(&path, 4096, keep).kept().iter().map(|reading| reading.row).collect()
        };
        fs::write(&path, &of_whole).unwrap();
        let reduced = case.fitted(case.scanned(&path, 7, Keep::default()));
        let of_kept = |row: usize| kept.binary_search(&row).is_ok();
        assert_eq!(
            essence_by(&reduced, &|row| kept[row - 1], &of_kept),
            essence_by(&whole, &|row| row, &of_kept),
            "case {case_number}: {:?}",
            case.rows
        );
        let area = |fit: &Fit| fit.fps.polyhedron().region().area();
        assert_eq!(area(&from_parts.1), area(&whole.1), "case {case_number}");
        assert!(reduced.1.eui().is_none());
    }
}

#[test]
fn columns_that_are_not_those_of_a_model_are_refused() {
    let column = |numbers: &[i64]| numbers.iter().map(|&number| Rational::from(number)).collect::<Column>();
    let of = |bound: ErrorBound, columns: &[Column]| {
        let model = Model::Line { x: "x".into() };
        let refused = Measurements::of_columns(model, "y".into(), bound, columns, Keep::default());
        refused.map(|measurements| measurements.fitted()).map_err(|error| error.to_string())
    };
    let (uniform, per_row) = (|bound: i64| ErrorBound::Uniform(bound.into()), ErrorBound::Column("e".into()));
    let (two, three) = (column(&[1, 2]), column(&[1, 2, -3]));
    assert_eq!(of(uniform(1), &[two.clone(), two.clone()]), Ok(2));
    assert_eq!(of(per_row.clone(), &[two.clone(), two.clone(), two.clone()]), Ok(2));
    for (bound, columns, expected) in [
        (uniform(1), vec![two.clone()], "the model has 2 columns, not 1"),
        (per_row.clone(), vec![two.clone(), two.clone()], "the model has 3 columns, not 2"),
        (uniform(1), vec![two, three.clone()], "column 2 has 3 numbers, not 2 like the first"),
        (per_row, vec![three.clone(); 3], "row 3 has a negative error bound"),
        (uniform(-1), vec![three; 2], "the error bound is negative"),
    ] {
        assert_eq!(of(bound, &columns), Err(expected.to_owned()));
    }
}
