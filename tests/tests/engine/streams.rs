//! Fits under bounds that differ from reading to reading, and of two regressors, from the few readings that decide them,
//! against fits of all readings in memory.

use std::fs;
use std::ops::{Range, RangeInclusive};
use std::path::Path;

use boundfit_estimation::{Columns, EpsilonColumn, Fit, Keep, LineForm, Measurements, NoMinimax, Problem};
use boundfit_exact::{Rational, Reading};
use boundfit_formats::Source;
use boundfit_geometry::RegionKind;
use boundfit_tests::generate::{one_in, seeded, share};
use boundfit_tests::reducing::{essence, essence_by, options, reduced, shuffled_parts};
use boundfit_tests::shape::shape;
use boundfit_tests::streams::{Case, FAR, LONG, SHORT, column};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rayon::ThreadPool;

use crate::reduction::pools;

fn whole(case: &Case) -> (Problem, Fit) {
    let source = Source::new("table", std::io::Cursor::new(case.text.clone().into_bytes()));
    let table = options(case.reading, 1).table;
    case.fitted(Measurements::read(source, &case.columns, &table).unwrap())
}

/// The fit of a reduction, or of several.
fn of_reduction(case: &Case, text: &str) -> (Problem, Fit) {
    let source = Source::new("reduced", std::io::Cursor::new(text.as_bytes().to_vec()));
    let options = options(case.reading, 7);
    let keep = Keep::default();
    case.fitted(Measurements::scan(source, &case.columns, &case.conditions, &options, keep).unwrap())
}

/// Returns whether a reduction decides for every multiple of the bounds.
fn is_open(case: &Case) -> bool {
    case.columns.second.is_none() && matches!(case.columns.epsilon, EpsilonColumn::Column(_))
}

/// Checks reductions. For any threads and chunks the reduction of the whole is the same text, and its fit is the
/// fit of the whole, row by row. Reductions of parts in any order have the same set, and reduced again they keep
/// the same rows.
fn check_reductions(
    case: &Case,
    (problem, whole): &(Problem, Fit),
    pools: &[ThreadPool],
    rng: &mut ChaCha8Rng,
) {
    let context = || format!("{:?}\n{}", case.columns, case.text);
    let texts = [1, 100, 1 << 18].into_iter().zip(pools).map(|(chunk, pool)| {
        pool.install(|| reduced(&case.text, &case.columns, &options(case.reading, chunk)))
    });
    let texts: Vec<String> = texts.collect();
    assert!(texts.iter().all(|text| *text == texts[0]), "{}", context());
    let own = reduced(&texts[0], &case.columns, &options(case.reading, 1));
    assert_eq!(own, texts[0], "{}", context());

    let ids = ids(&texts[0]);
    let found = of_reduction(case, &texts[0]);
    let of_kept = |fitted: &(Problem, Fit), row: &dyn Fn(usize) -> usize| {
        essence_by(fitted, row, &|row| ids.contains(&row))
    };
    let (found_text, expected) =
        (of_kept(&found, &|row| ids[row - 1]), of_kept(&(problem.clone(), whole.clone()), &|row| row));
    let lines = |text: &str| -> Vec<String> {
        let lines = text.lines().enumerate();
        // Least squares and its slack, and what decides under other bounds, stand in lines of their own.
        let is_told = |line: usize| match line {
            4 => case.columns.second.is_none(),
            5 => is_open(case) || !problem.measurements.has_widths(),
            _ => true,
        };
        lines.filter(|(line, _)| is_told(*line)).map(|(_, text)| text.to_owned()).collect()
    };
    assert_eq!(lines(&found_text), lines(&expected), "{}", context());
    check_answers(case, &found, (problem, whole));

    let parts = shuffled_parts(&case.text, &case.columns, &options(case.reading, 1), rng);
    check_answers(case, &of_reduction(case, &parts), (problem, whole));
    let again = reduced(&parts, &case.columns, &options(case.reading, 64));
    check_answers(case, &of_reduction(case, &again), (problem, whole));
    // Among rows without regressors the first one that nothing agrees with is kept, or the first one where no row
    // decides. The order decides which of several rows represents the others; the number of rows that it stands
    // for is the same.
    let kept = |text: &str| -> Vec<usize> {
        let regressors = |id: &usize| -> Vec<f64> {
            let cells = case.text.lines().nth(*id).unwrap().split(',').take(2);
            cells.map(|cell| cell.parse().unwrap_or(1.0)).collect()
        };
        let has_none = |id: &usize| case.columns.second.is_some() && regressors(id) == [0.0, 0.0];
        let rows = self::ids(text).into_iter().zip(counts(text));
        let mut counts: Vec<usize> = rows.filter(|(id, _)| !has_none(id)).map(|(_, count)| count).collect();
        counts.sort_unstable();
        counts
    };
    assert_eq!(kept(&again), kept(&own), "{}", context());
}

/// Checks the answers that do not depend on names and order of rows.
fn check_answers(case: &Case, (found_problem, found): &(Problem, Fit), (problem, whole): (&Problem, &Fit)) {
    let context = || format!("{:?}\n{}", case.columns, case.text);
    let region = |fit: &Fit| shape(fit.fps.polyhedron().region());
    assert_eq!(region(found), region(whole), "{}", context());
    assert_eq!(found.vertices(), whole.vertices(), "{}", context());
    assert_eq!(found.pui_intervals(), whole.pui_intervals(), "{}", context());
    assert_eq!(found.central, whole.central, "{}", context());
    let theta = |fit: &Fit| fit.least_squares.as_ref().map(|own| own.theta.clone()).map_err(|why| *why);
    assert_eq!(theta(found), theta(whole), "{}", context());
    assert_eq!(found_problem.measurements.fitted(), problem.measurements.fitted(), "{}", context());
    assert_eq!(found_problem.measurements.has_widths(), problem.measurements.has_widths(), "{}", context());
    let least = |fit: &Fit| fit.minimax.as_ref().map(|own| (own.least.clone(), own.theta.clone()));
    if is_open(case) || !problem.measurements.has_widths() {
        assert_eq!(least(found), least(whole), "{}", context());
    } else {
        assert_eq!(found_problem.measurements.deciding_minimax(), Err(NoMinimax::Reduced));
        assert_eq!(least(found), None, "{}", context());
    }
}

fn scanned(case: &Case, path: &Path, chunk_bytes: usize, keep: Keep) -> (Problem, Fit) {
    let options = options(case.reading, chunk_bytes);
    let source = Source::open(path.to_str().unwrap()).unwrap();
    case.fitted(Measurements::scan(source, &case.columns, &case.all_conditions(), &options, keep).unwrap())
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
        let whole = whole(&case);
        kinds.push(whole.1.fps.polyhedron().region().kind());
        let expected = essence(&whole, &|row| row);
        // The numbers in memory, and the file read again.
        for (position, (chunk, pool)) in chunks.into_iter().zip(&pools).enumerate() {
            let most_bytes = if (round + position) % 2 == 0 { None } else { Some(0) };
            // The first rows wait until there are too many.
            let most_rows = [0, case.text.lines().count() / 2][round / 2 % 2];
            let keep = Keep { most_rows, most_bytes, ..Keep::default() };
            let streamed = pool.install(|| scanned(&case, &path, chunk, keep));
            assert_eq!(
                essence(&streamed, &|row| row),
                expected,
                "case {round}: {:?}\n{}",
                case.columns,
                case.text
            );
            assert_eq!(streamed.1.eui(), whole.1.eui(), "case {round}: {:?}\n{}", case.columns, case.text);
        }
        check_reductions(&case, &whole, &pools, &mut order);
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
        let (problem, fit) = scanned(&case, &path, 10_000, Keep { most_rows: 0, ..Keep::default() });
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
