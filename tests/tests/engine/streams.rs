//! Fits under bounds that differ from reading to reading, and of two regressors, from the few readings that decide them,
//! against fits of all readings in memory.

use std::fs;
use std::ops::{Range, RangeInclusive};
use std::path::Path;

use boundfit_estimation::{
    Columns, Condition, EpsilonColumn, Fit, Keep, Law, LineForm, Measurements, NoMinimax, Problem, fit,
};
use boundfit_exact::{Limits, Rational, Reading};
use boundfit_formats::{ColumnSelector, Source};
use boundfit_geometry::RegionKind;
use boundfit_tests::generate::{one_in, seeded, share};
use boundfit_tests::readings::parse_condition;
use boundfit_tests::shape::shape;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rayon::ThreadPool;

use crate::reducing::{reduced, shuffled_parts};
use crate::reduction::{essence, essence_by, options, pools};

/// A table with columns a, b, y, e, lo and up, and how it is to be fitted.
pub(crate) struct Case {
    pub(crate) text: String,
    pub(crate) columns: Columns,
    pub(crate) reading: Reading,
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
const SHORT: Range<u32> = 0..5;
/// Numbers of 17 and 53 digits, of which no two are alike.
const LONG: Range<u32> = 5..7;
/// The styles of long numbers, and numbers so far from 1 that a filter by floats may not tell them.
const FAR: Range<u32> = 5..8;

impl Case {
    pub(crate) fn random(rng: &mut ChaCha8Rng, rows: RangeInclusive<usize>) -> Self {
        Case::written(rng, rows, SHORT)
    }

    /// Returns a case with numbers written in one of these styles.
    fn written(rng: &mut ChaCha8Rng, rows: RangeInclusive<usize>, styles: Range<u32>) -> Self {
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
    fn of_ties(rng: &mut ChaCha8Rng, rows: RangeInclusive<usize>) -> Self {
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
    pub(crate) fn needs_written(&self) -> bool {
        matches!(&self.columns.epsilon, EpsilonColumn::Law(law) if law.needs_written())
    }

    /// The conditions, with that of a line through the origin.
    pub(crate) fn all_conditions(&self) -> Vec<Condition> {
        let own = self.is_through_origin.then(Condition::no_intercept);
        self.conditions.iter().cloned().chain(own).collect()
    }

    pub(crate) fn fitted(&self, measurements: Measurements) -> (Problem, Fit) {
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

    /// The fit of a reduction, or of several.
    fn of_reduction(&self, text: &str) -> (Problem, Fit) {
        let source = Source::new("reduced", std::io::Cursor::new(text.as_bytes().to_vec()));
        let options = options(self.reading, 7);
        let keep = Keep::default();
        self.fitted(Measurements::scan(source, &self.columns, &self.conditions, &options, keep).unwrap())
    }

    /// Returns whether a reduction decides for every multiple of the bounds.
    fn is_open(&self) -> bool {
        self.columns.second.is_none() && matches!(self.columns.epsilon, EpsilonColumn::Column(_))
    }

    /// Checks reductions. For any threads and chunks the reduction of the whole is the same text, and its fit is the
    /// fit of the whole, row by row. Reductions of parts in any order have the same set, and reduced again they keep
    /// the same rows.
    fn check_reductions(
        &self,
        (problem, whole): &(Problem, Fit),
        pools: &[ThreadPool],
        rng: &mut ChaCha8Rng,
    ) {
        let context = || format!("{:?}\n{}", self.columns, self.text);
        let texts = [1, 100, 1 << 18].into_iter().zip(pools).map(|(chunk, pool)| {
            pool.install(|| reduced(&self.text, &self.columns, &options(self.reading, chunk)))
        });
        let texts: Vec<String> = texts.collect();
        assert!(texts.iter().all(|text| *text == texts[0]), "{}", context());
        let own = reduced(&texts[0], &self.columns, &options(self.reading, 1));
        assert_eq!(own, texts[0], "{}", context());

        let ids = ids(&texts[0]);
        let found = self.of_reduction(&texts[0]);
        let of_kept = |fitted: &(Problem, Fit), row: &dyn Fn(usize) -> usize| {
            essence_by(fitted, row, &|row| ids.contains(&row))
        };
        let (found_text, expected) =
            (of_kept(&found, &|row| ids[row - 1]), of_kept(&(problem.clone(), whole.clone()), &|row| row));
        let lines = |text: &str| -> Vec<String> {
            let lines = text.lines().enumerate();
            // Least squares and its slack, and what decides under other bounds, stand in lines of their own.
            let is_told = |line: usize| match line {
                4 => self.columns.second.is_none(),
                5 => self.is_open() || !problem.measurements.has_widths(),
                _ => true,
            };
            lines.filter(|(line, _)| is_told(*line)).map(|(_, text)| text.to_owned()).collect()
        };
        assert_eq!(lines(&found_text), lines(&expected), "{}", context());
        self.check_answers(&found, (problem, whole));

        let parts = shuffled_parts(&self.text, &self.columns, &options(self.reading, 1), rng);
        self.check_answers(&self.of_reduction(&parts), (problem, whole));
        let again = reduced(&parts, &self.columns, &options(self.reading, 64));
        self.check_answers(&self.of_reduction(&again), (problem, whole));
        // Among rows without regressors the first one that nothing agrees with is kept, or the first one where no row
        // decides. The order decides which of several rows represents the others; the number of rows that it stands
        // for is the same.
        let kept = |text: &str| -> Vec<usize> {
            let regressors = |id: &usize| -> Vec<f64> {
                let cells = self.text.lines().nth(*id).unwrap().split(',').take(2);
                cells.map(|cell| cell.parse().unwrap_or(1.0)).collect()
            };
            let has_none = |id: &usize| self.columns.second.is_some() && regressors(id) == [0.0, 0.0];
            let rows = self::ids(text).into_iter().zip(counts(text));
            let mut counts: Vec<usize> =
                rows.filter(|(id, _)| !has_none(id)).map(|(_, count)| count).collect();
            counts.sort_unstable();
            counts
        };
        assert_eq!(kept(&again), kept(&own), "{}", context());
    }

    /// Checks the answers that do not depend on names and order of rows.
    fn check_answers(&self, (found_problem, found): &(Problem, Fit), (problem, whole): (&Problem, &Fit)) {
        let context = || format!("{:?}\n{}", self.columns, self.text);
        let region = |fit: &Fit| shape(fit.fps.polyhedron().region());
        assert_eq!(region(found), region(whole), "{}", context());
        assert_eq!(found.vertices(), whole.vertices(), "{}", context());
        assert_eq!(found.pui_intervals(), whole.pui_intervals(), "{}", context());
        assert_eq!(found.central, whole.central, "{}", context());
        let theta = |fit: &Fit| fit.least_squares.as_ref().map(|own| own.theta.clone()).map_err(|why| *why);
        assert_eq!(theta(found), theta(whole), "{}", context());
        assert_eq!(found_problem.measurements.fitted(), problem.measurements.fitted(), "{}", context());
        assert_eq!(
            found_problem.measurements.has_widths(),
            problem.measurements.has_widths(),
            "{}",
            context()
        );
        let least = |fit: &Fit| fit.minimax.as_ref().map(|own| (own.least.clone(), own.theta.clone()));
        if self.is_open() || !problem.measurements.has_widths() {
            assert_eq!(least(found), least(whole), "{}", context());
        } else {
            assert_eq!(found_problem.measurements.deciding_minimax(), Err(NoMinimax::Reduced));
            assert_eq!(least(found), None, "{}", context());
        }
    }

    fn scanned(&self, path: &Path, chunk_bytes: usize, keep: Keep) -> (Problem, Fit) {
        let options = options(self.reading, chunk_bytes);
        let source = Source::open(path.to_str().unwrap()).unwrap();
        self.fitted(
            Measurements::scan(source, &self.columns, &self.all_conditions(), &options, keep).unwrap(),
        )
    }
}

/// Returns the last column of the rows of reductions.
fn ids(text: &str) -> Vec<usize> {
    let rows = text.lines().filter(|line| !line.starts_with(['#', 'a']));
    rows.map(|row| row.rsplit_once(',').unwrap().1.parse().unwrap()).collect()
}

/// Returns the numbers of readings that the rows of reductions stand for.
fn counts(text: &str) -> Vec<usize> {
    let (mut counts, mut is_counted) = (Vec::new(), false);
    for line in text.lines() {
        if let Some(format) = line.strip_prefix("# boundfit/reduced/") {
            is_counted = format.starts_with(['3', '4']);
        } else if !line.starts_with('a') {
            counts.push(if is_counted { line.split(' ').next().unwrap().parse().unwrap() } else { 1 });
        }
    }
    counts
}

fn compare(
    rounds: usize,
    seed: u64,
    rows: RangeInclusive<usize>,
    styles: Range<u32>,
    chunks: [usize; 3],
) -> Vec<RegionKind> {
    compare_cases(rounds, seed, chunks, |rng| Case::written(rng, rows.clone(), styles.clone()))
}

fn compare_cases(
    rounds: usize,
    seed: u64,
    chunks: [usize; 3],
    case: impl Fn(&mut ChaCha8Rng) -> Case,
) -> Vec<RegionKind> {
    let (mut rng, mut order) = (seeded(seed), seeded(seed + 1000));
    let pools = pools();
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("table.csv");
    let mut kinds = Vec::new();
    for round in 0..share(rounds) {
        let case = case(&mut rng);
        fs::write(&path, &case.text).unwrap();
        let whole = case.whole();
        kinds.push(whole.1.fps.polyhedron().region().kind());
        let expected = essence(&whole, &|row| row);
        // The numbers in memory, and the file read again.
        for (position, (chunk, pool)) in chunks.into_iter().zip(&pools).enumerate() {
            let most_bytes = if (round + position) % 2 == 0 { None } else { Some(0) };
            // The first rows wait until there are too many.
            let most_rows = [0, case.text.lines().count() / 2][round / 2 % 2];
            let keep = Keep { most_rows, most_bytes, ..Keep::default() };
            let streamed = pool.install(|| case.scanned(&path, chunk, keep));
            assert_eq!(
                essence(&streamed, &|row| row),
                expected,
                "case {round}: {:?}\n{}",
                case.columns,
                case.text
            );
            assert_eq!(streamed.1.eui(), whole.1.eui(), "case {round}: {:?}\n{}", case.columns, case.text);
        }
        case.check_reductions(&whole, &pools, &mut order);
    }
    kinds
}

#[test]
fn bounds_per_row_and_two_regressors_stream_for_any_parts_and_threads() {
    let kinds = compare(1500, 61, 1..=30, SHORT, [1, 7, 4096]);
    for kind in RegionKind::ALL {
        let count = kinds.iter().filter(|own| **own == kind).count();
        let is_rare = matches!(kind, RegionKind::Plane | RegionKind::HalfPlane | RegionKind::Ray);
        assert!(count >= if is_rare { 1 } else { 3 } / one_in(), "{kind:?}: {count}");
    }
}

#[test]
fn long_tables_stream_through_sieves() {
    compare(20, 62, 2_000..=4_000, SHORT, [20_000, 7_000, 4096]);
}

/// Columns of integers of 128 bits, of words, and of what is no float: all of them take other ways through sieves and sums.
#[test]
fn long_and_far_numbers_stream_as_short_ones_do() {
    compare(300, 63, 1..=30, FAR, [1, 7, 4096]);
    compare(12, 64, 1_000..=2_000, LONG, [50_000, 20_000, 4096]);
}

/// The answer and its proofs are the same where one reading stands for all that go through a vertex.
#[test]
fn readings_through_one_vertex_stream_as_each_by_itself() {
    let mut kinds = compare_cases(300, 65, [1, 60, 4096], |rng| Case::of_ties(rng, 1..=40));
    kinds.extend(compare_cases(12, 66, [4000, 1000, 1 << 18], |rng| Case::of_ties(rng, 500..=1500)));
    for kind in [RegionKind::Empty, RegionKind::Point, RegionKind::Segment, RegionKind::Polygon] {
        assert!(kinds.iter().filter(|own| **own == kind).count() >= 5 / one_in(), "{kind:?}");
    }
}

/// Memory is for the rows that decide: not for the thousands through the one point that is left, nor at the least bound.
#[test]
fn of_readings_through_one_vertex_few_are_kept() {
    let mut rng = seeded(67);
    let mut text = "a,b,y\n".to_owned();
    for _ in 0..20_000 {
        let [a, b] = [0; 2].map(|_| rng.random_range(0..1000));
        text += &format!("{a},{b},{}\n", a + 2 * b + rng.random_range(-3..=3));
    }
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("table.csv");
    fs::write(&path, &text).unwrap();
    for (epsilon, kind) in [(3, RegionKind::Point), (4, RegionKind::Polygon)] {
        let case = Case {
            text: text.clone(),
            columns: Columns {
                first: column("a"),
                second: Some(column("b")),
                response: Some(column("y")),
                epsilon: EpsilonColumn::Uniform(Rational::from(epsilon)),
                form: LineForm::default(),
            },
            reading: Reading::Decimal,
            conditions: Vec::new(),
            is_through_origin: false,
        };
        let (problem, fit) = case.scanned(&path, 10_000, Keep { most_rows: 0, ..Keep::default() });
        let region = fit.fps.polyhedron().region();
        assert_eq!(region.kind(), kind);
        let measurements = &problem.measurements;
        let kept = measurements.kept().len() + measurements.deciding_minimax().unwrap().len();
        assert!(kept < 500, "{epsilon}: {kept}");
        if kind == RegionKind::Point {
            let active = fit.fps.active(region.vertices()[0].active(), 10);
            assert!(active.names.len() + active.more > 5_000);
        }
    }
}
