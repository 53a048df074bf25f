//! Fleets: every group is fitted as it would be alone, whatever else is in the table and however the rows take turns.

use std::fmt::Write as _;
use std::io::Cursor;

use boundfit_estimation::{
    Bounds, Columns, EpsilonColumn, ErrorBound, Fleet, GroupAnswer, Keep, LineForm, Measurement,
    Measurements, Model, Problem, fit, least_squares_is_feasible,
};
use boundfit_exact::{Foreign, Limits, Rational, Reading};
use boundfit_formats::{ColumnSelector, RowRange, ScanOptions, Source, TableOptions};
use boundfit_geometry::RegionKind;
use boundfit_report::{FleetCsv, Style};
use boundfit_tests::generate::{seeded, shuffled};
use boundfit_tests::readings::{problem, rebuilt, y_and_epsilon};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// The columns of the tables of these tests.
fn columns(model: &Model, error_bound: &ErrorBound) -> Columns {
    let named = ColumnSelector::name_or_number;
    Columns {
        first: named("a"),
        second: matches!(model, Model::TwoRegressors { .. }).then(|| named("b")),
        response: Some(named("y")),
        epsilon: match error_bound {
            ErrorBound::Uniform(epsilon) => EpsilonColumn::Uniform(epsilon.clone()),
            _ => EpsilonColumn::Column(named("eps")),
        },
        form: LineForm::default(),
    }
}

fn read(text: &str, columns: &Columns, options: ScanOptions) -> Fleet {
    let source = Source::new("table", Cursor::new(text.to_owned().into_bytes()));
    Fleet::read(source, columns, &ColumnSelector::name_or_number("key"), options).unwrap()
}

/// A number as a decimal with or without spare zeros, with an exponent, or as a fraction.
fn text(rng: &mut ChaCha8Rng, number: &Rational) -> String {
    let decimal = number.exact_decimal(30).map(|decimal| decimal.compact().to_string());
    match (decimal, rng.random_range(0..40)) {
        (None, _) | (_, 0) => number.to_string(),
        (Some(decimal), 1) => format!("{decimal}{}", if decimal.contains('e') { "" } else { "e0" }),
        (Some(decimal), 2) if decimal.contains('.') && !decimal.contains('e') => format!("{decimal}00"),
        (Some(decimal), _) => decimal,
    }
}

/// Groups with one model, one kind of error bound and the same conditions, and the table in which their rows take turns.
struct Case {
    groups: Vec<Problem>,
    table: String,
}

impl Case {
    fn new(rng: &mut ChaCha8Rng, count: usize) -> Self {
        let base = problem(rng);
        let mut groups: Vec<Problem> = Vec::new();
        while groups.len() < count {
            let other = problem(rng);
            let (own, base) = (&other.measurements, &base.measurements);
            let alike = std::mem::discriminant(own.model()) == std::mem::discriminant(base.model())
                && std::mem::discriminant(own.error_bound()) == std::mem::discriminant(base.error_bound());
            if alike {
                groups.push(other);
            }
        }
        let bound = match base.measurements.error_bound() {
            ErrorBound::Uniform(epsilon) => ErrorBound::Uniform(epsilon.clone()),
            _ => ErrorBound::Column("eps".into()),
        };
        let far = Rational::new(7.into(), boundfit_exact::Integer::power_of_ten(40)).unwrap();
        for (number, group) in groups.iter_mut().enumerate() {
            let mut rows = group.measurements.kept().to_vec();
            for row in &mut rows {
                let Bounds::Around { response, epsilon: own } = &mut row.bounds else { unreachable!() };
                if let ErrorBound::Uniform(epsilon) = &bound {
                    *own = epsilon.clone();
                }
                // Some numbers have no short form.
                if number % 17 == 3 {
                    *response = &*response + &far;
                }
            }
            *group = Problem { conditions: base.conditions.clone(), ..rebuilt(group, rows, bound.clone()) };
        }
        Case::in_turn(rng, groups)
    }

    /// Rows of all groups in random order, each group's own order kept; the groups in the order of their first rows.
    fn in_turn(rng: &mut ChaCha8Rng, groups: Vec<Problem>) -> Self {
        let mut turns: Vec<usize> = Vec::new();
        for (group, problem) in groups.iter().enumerate() {
            turns.extend(std::iter::repeat_n(group, problem.measurements.kept().len()));
        }
        let turns: Vec<usize> = shuffled(rng, turns.len()).into_iter().map(|k| turns[k]).collect();
        let mut table = "eps,b,key,y,a\n".to_owned();
        let mut gathered: Vec<(usize, Vec<Measurement>)> = Vec::new();
        for (number, &group) in (1..).zip(&turns) {
            let place = gathered.iter().position(|(own, _)| *own == group).unwrap_or_else(|| {
                gathered.push((group, Vec::new()));
                gathered.len() - 1
            });
            let own = &mut gathered[place].1;
            let row = Measurement { row: number, ..groups[group].measurements.kept()[own.len()].clone() };
            let (y, epsilon) = y_and_epsilon(&row);
            let [a, b, y, epsilon] =
                [&row.regressor[0], &row.regressor[1], y, epsilon].map(|number| text(rng, number));
            writeln!(table, "{epsilon},{b},sensor {group},{y},{a}").unwrap();
            own.push(row);
        }
        let bound = |group: &Problem| group.measurements.error_bound().clone();
        let groups = gathered
            .into_iter()
            .map(|(group, rows)| named(rebuilt(&groups[group], rows, bound(&groups[group]))))
            .collect();
        Case { groups, table }
    }
}

/// The problem under the names that the table's columns have.
fn named(problem: Problem) -> Problem {
    let model = match problem.measurements.model() {
        Model::Line { .. } => Model::Line { x: "a".into() },
        Model::TwoRegressors { .. } => Model::TwoRegressors { regressors: ["a".into(), "b".into()] },
    };
    let (bound, rows) = (problem.measurements.error_bound().clone(), problem.measurements.kept().to_vec());
    Problem { measurements: Measurements::new(model, "y".into(), bound, rows), ..problem }
}

#[test]
fn every_group_is_fitted_as_it_would_be_alone() {
    let mut rng = seeded(2201);
    let mut kinds = [0_usize; RegionKind::ALL.len()];
    let mut long = 0;
    for round in 0..60 {
        let Case { groups, table } = Case::new(&mut rng, 60);
        let columns = columns(groups[0].measurements.model(), groups[0].measurements.error_bound());
        let options = ScanOptions { chunk_bytes: [1, 100, 1 << 16][round % 3], ..ScanOptions::default() };
        let fleet = read(&table, &columns, options);
        assert_eq!(fleet.len(), groups.len());
        for (number, alone) in groups.iter().enumerate() {
            let measurements = fleet.measurements(number);
            assert_eq!(measurements, alone.measurements, "{}", fleet.key(number));
            let problem = Problem { measurements, conditions: alone.conditions.clone() };
            let (own, expected) = (fit(&problem), fit(alone));
            assert_eq!(own.least_squares, expected.least_squares);
            assert_eq!(own.fps.polyhedron().region(), expected.fps.polyhedron().region());
            assert_eq!((&own.pui, &own.central), (&expected.pui, &expected.central));
            assert_eq!(own.minimax, expected.minimax);
            let bound = problem.measurements.error_bound();
            assert_eq!(own.contradiction(bound), expected.contradiction(bound));
            assert_eq!(own.verify(&problem), Ok(()));
            let slack = expected.least_squares_slack().map(|(slack, _)| !slack.is_negative());
            assert_eq!(least_squares_is_feasible(&own), slack, "{alone:?}");
            let kind = own.fps.polyhedron().region().kind();
            kinds[RegionKind::ALL.iter().position(|other| *other == kind).unwrap()] += 1;
            let numbers =
                alone.measurements.kept().iter().map(|row| y_and_epsilon(row).0.denominator().bits());
            long += usize::from(numbers.max() > Some(100));
        }
    }
    // Without readings there would be no group, and each confines θ to a strip: the plane and half-planes cannot occur.
    for (kind, count) in RegionKind::ALL.iter().zip(kinds) {
        let never = matches!(kind, RegionKind::Plane | RegionKind::HalfPlane);
        assert!(never && count == 0 || !never && count > 0, "{kind:?}: {count}");
    }
    assert!(long > 100, "{long}");
}

/// Groups of few readings near a line, at few places left and right of 0 and above each other, or of 17 digits.
fn small_groups(rng: &mut ChaCha8Rng, is_long: bool) -> String {
    let mut table = "key,a,y\n".to_owned();
    for group in 0..200 {
        let (slope, offset) = (rng.random_range(-3..=3_i64), rng.random_range(-5..=5_i64));
        let shift = [-30, -3, 0, 3, 30][group % 5];
        for _ in 0..rng.random_range(1..=9) {
            let x = shift + rng.random_range(-4..=4_i64);
            let y = slope * x + offset + rng.random_range(-2..=2_i64);
            let mut tail = || {
                if is_long { format!("{:016}", rng.random_range(0..10_u64.pow(16))) } else { "0".to_owned() }
            };
            writeln!(table, "{group},{x}.{},{y}.{}", tail(), tail()).unwrap();
        }
    }
    table
}

#[test]
fn the_line_of_a_group_is_that_of_its_fit() {
    let mut rng = seeded(1511);
    let (mut lines, mut rows, mut answers) = ([0, 0], [0, 0], [0, 0]);
    let styles = [None, Some(1), Some(3), Some(9)].map(|digits| Style { digits, ..Style::default() });
    for (round, epsilon) in
        ["0", "1", "1.5", "3", "1/3", "0.75", "2"].into_iter().cycle().take(42).enumerate()
    {
        let is_long = round % 2 == 1;
        let table = small_groups(&mut rng, is_long);
        let bound = ErrorBound::Uniform(Reading::Decimal.read(epsilon, &Limits::default()).unwrap());
        let columns = columns(&Model::Line { x: Foreign::default() }, &bound);
        let fleet = read(&table, &columns, ScanOptions::default());
        for group in 0..fleet.len() {
            let problem = Problem::new(fleet.measurements(group));
            let answer = GroupAnswer::of(&problem, &fit(&problem));
            if let Some(own) = fleet.group_answer(group) {
                answers[usize::from(is_long)] += 1;
                assert_eq!(own, answer, "{epsilon} {:?}", problem.measurements.kept());
            }
            let expected = answer.fit;
            let is_polygon = expected.kind == RegionKind::Polygon;
            match fleet.group_fit(group) {
                Some(line) => {
                    lines[usize::from(is_long)] += 1;
                    assert_eq!(line, expected, "{epsilon} {:?}", problem.measurements.kept());
                }
                None => assert!(!is_polygon || epsilon == "1/3", "{:?}", problem.measurements.kept()),
            }
            let line = fleet.group_line(group);
            assert_eq!(line.is_some(), fleet.group_fit(group).is_some(), "{:?}", problem.measurements.kept());
            // Rounded, the quotients are what the numbers of the fit are.
            for style in &styles {
                let (mut own, mut of_fit) = (FleetCsv::new(), FleetCsv::new());
                if line.is_some_and(|line| own.line(fleet.key(group), &line, style)) {
                    rows[usize::from(is_long)] += 1;
                    of_fit.group(fleet.key(group), &expected, style);
                }
                let [own, of_fit] = [own, of_fit].map(|rows| String::from_utf8(rows.into_bytes()).unwrap());
                assert_eq!(own, of_fit, "{epsilon} {:?}", problem.measurements.kept());
            }
        }
    }
    assert!(lines.iter().all(|&count| count > 1000), "{lines:?}");
    assert!(rows.iter().all(|&count| count > 3000), "{rows:?}");
    assert!(answers.iter().all(|&count| count > 1000), "{answers:?}");
}

#[test]
fn a_large_group_answers_as_a_small_one() {
    let columns = columns(&Model::Line { x: Foreign::default() }, &ErrorBound::Uniform(Rational::from(3)));
    for rows in [Keep::MOST_ROWS - 1, Keep::MOST_ROWS, Keep::MOST_ROWS + 1] {
        // The first reading is far inside, the second one on a hull.
        let mut table = "key,a,y\ns,500,1000.5\ns,0,-2\n".to_owned();
        (2..rows).for_each(|x| writeln!(table, "s,{x},{}.{x:05}", 2 * x).unwrap());
        let fleet = read(&table, &columns, ScanOptions::default());
        let problem = Problem::new(fleet.measurements(0));
        let mut of_fit = GroupAnswer::of(&problem, &fit(&problem));
        of_fit.fit.first_row = fleet.first_row(0);
        assert_eq!((of_fit.fit.rows, of_fit.fit.first_row), (rows, Some(1)));
        assert_eq!(of_fit.fit.kind, RegionKind::Polygon);
        assert_eq!(fleet.group_answer(0), (rows <= Keep::MOST_ROWS).then_some(of_fit));
    }
}

#[test]
fn doubles_are_taken_as_they_are() {
    let table = "key,a,y\ns,0.1,1e-310\nt,1/3,2\ns,0.3,0\n";
    let uniform = ErrorBound::Uniform(Rational::one());
    let columns = columns(&Model::Line { x: Foreign::default() }, &uniform);
    let table_options = TableOptions { reading: Reading::Binary64, ..TableOptions::default() };
    let fleet = read(table, &columns, ScanOptions { table: table_options, ..ScanOptions::default() });
    let numbers = |group| -> Vec<[Rational; 2]> {
        let rows = fleet.measurements(group).kept().to_vec();
        rows.into_iter().map(|row| [row.regressor[0].clone(), y_and_epsilon(&row).0.clone()]).collect()
    };
    let double = |value: f64| Rational::from_f64(value).unwrap();
    assert_eq!(numbers(0), [[double(0.1), double(1e-310)], [double(0.3), double(0.0)]]);
    assert_eq!(numbers(1), [[double(1.0 / 3.0), double(2.0)]]);
}

#[test]
fn rows_left_out_are_no_group() {
    let table = "key,a,y\nx,1,1\ny,2,2\nz,3,3\ny,4,4\nw,5,5\n";
    let columns = columns(&Model::Line { x: Foreign::default() }, &ErrorBound::Uniform(Rational::one()));
    let rows = RowRange::new(2, 4).into();
    let options =
        ScanOptions { table: TableOptions { rows, ..TableOptions::default() }, ..ScanOptions::default() };
    let fleet = read(table, &columns, options);
    let rows =
        |group: usize| -> Vec<usize> { fleet.measurements(group).kept().iter().map(|row| row.row).collect() };
    let groups: Vec<(&str, Vec<usize>)> =
        (0..fleet.len()).map(|group| (fleet.key(group).into_inner(), rows(group))).collect();
    assert_eq!(groups, [("y", vec![2, 4]), ("z", vec![3])]);
}

#[test]
fn groups_are_worked_on_in_order_for_any_number_of_threads() {
    let mut table = "key,a,y\n".to_owned();
    for number in 0..5000 {
        writeln!(table, "s{number},1,{number}").unwrap();
    }
    let columns = columns(&Model::Line { x: Foreign::default() }, &ErrorBound::Uniform(Rational::one()));
    let fleet = read(&table, &columns, ScanOptions::default());
    let pieces = |threads: usize, stop_after: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let mut seen = Vec::new();
        let end = pool.install(|| {
            fleet.in_order(
                |groups| groups,
                |groups| {
                    seen.push(groups);
                    if seen.len() == stop_after { Err(stop_after) } else { Ok(()) }
                },
            )
        });
        (seen, end)
    };
    let (one, end) = pieces(1, usize::MAX);
    assert_eq!(end, Ok(()));
    assert!(one.iter().cloned().flatten().eq(0..5000) && one.len() > 70);
    for threads in [1, 2, 8] {
        assert_eq!(pieces(threads, usize::MAX).0, one);
        let (some, end) = pieces(threads, 40);
        assert_eq!((some.as_slice(), end), (&one[..40], Err(40)));
    }
}

/// Rows of two large groups and of small ones that take turns. Many rows of some stretches are equal, some numbers are long or no
/// decimals, and some readings lie on one edge.
fn large_groups(rng: &mut ChaCha8Rng, round: usize) -> String {
    let mut table = "key,a,y\n".to_owned();
    for row in 0..36_000 {
        let key = match (round % 3, row % 5) {
            (0, turn) => turn % 2,
            (1, 4) => 2 + row / 1_000,
            (1, _) => row / 300 % 2,
            _ => rng.random_range(0..2) + row / 35_000,
        };
        let x: i64 = match (round % 4, row / 1_500 % 8) {
            (1, 0 | 6) => row as i64 % 3,
            (2, _) => row as i64,
            _ => rng.random_range(-900..900),
        };
        let y = if round % 4 == 2 { x * x } else { 2 * x + rng.random_range(-5..=5) };
        match rng.random_range(0..4_000) {
            0 if round > 3 => writeln!(table, "g{key},{x}/7,{y}.123456789012345678901234567"),
            1..30 => writeln!(table, "g{key},{x},{y}.{row:05}"),
            _ => writeln!(table, "g{key},{x},{y}"),
        }
        .unwrap();
    }
    table
}

#[test]
fn few_further_rows_of_large_groups_are_kept_and_they_tell_the_same() {
    let mut rng = seeded(3_011);
    let columns = columns(&Model::Line { x: Foreign::default() }, &ErrorBound::Uniform(Rational::from(7)));
    let by = ColumnSelector::name_or_number("key");
    for round in 0..8 {
        let table = large_groups(&mut rng, round);
        let source = || Source::new("table", Cursor::new(table.clone().into_bytes()));
        let options = || ScanOptions { chunk_bytes: 1 << 14, ..ScanOptions::default() };
        let every = Fleet::read_every(source(), &columns, &by, options()).unwrap();
        let few = Fleet::read(source(), &columns, &by, options()).unwrap();
        assert_eq!((few.len(), few.readings()), (every.len(), 36_000));
        for group in 0..every.len() {
            let answer = |fleet: &Fleet| {
                let problem = Problem::new(fleet.measurements(group));
                (fleet.first_row(group), GroupAnswer::of(&problem, &fit(&problem)))
            };
            assert_eq!((few.key(group), answer(&few)), (every.key(group), answer(&every)), "{round}");
        }
        let kept = few.each(0).kept().len();
        assert!(every.each(0).kept().len() > 10_000 && (kept < 500) == (round % 4 != 2), "{round}: {kept}");
    }
}
