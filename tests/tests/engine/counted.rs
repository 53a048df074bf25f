//! Equal readings that are kept once, against the same readings each by itself.

use std::fmt::Write as _;
use std::io::Cursor;

use boundfit_estimation::{
    Bounds, Columns, Condition, EpsilonColumn, Fit, Fleet, Fps, Keep, LineForm, Measurement, Measurements,
    Problem, Readings, Ties, fit,
};
use boundfit_exact::{Limits, Rational, Reading};
use boundfit_formats::{ColumnSelector, ScanOptions, Source};
use boundfit_geometry::Region;
use boundfit_questions::{
    Agreement, Calibration, CalibrationColumns, CalibrationResponse, Linearity, LinearityOptions,
    OutlierLimits, Outliers, SideSet, XBounds, XErrorProblem,
};
use boundfit_tests::generate::{seeded, share};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

fn named(name: &str) -> ColumnSelector {
    ColumnSelector::name_or_number(name)
}

/// Rows of few different numbers, of which some are far away.
fn table(rng: &mut ChaCha8Rng, count: usize) -> String {
    let mut text = "x,u,y,eps,dx,d,g\n".to_owned();
    for _ in 0..count {
        let mut below = |most: i32| rng.random_range(0..most);
        let far = if below(25) == 0 { 9 } else { 0 };
        let [x, u, y, epsilon, dx] = [below(3), 1 + below(2), below(3) + far, 1 + below(2), below(2)];
        // 1 and 1.0 are one number.
        let zeros = if below(6) == 0 { ".0" } else { "" };
        let word = ["up", "down"][below(2) as usize];
        writeln!(text, "{x}{zeros},{u},{y},{epsilon},{dx},{word},{}", ["a", "b"][below(2) as usize]).unwrap();
    }
    text
}

fn source(text: &str) -> Source {
    Source::new("table", Cursor::new(text.to_owned().into_bytes()))
}

/// The readings counted, and each by itself.
fn both(
    text: &str,
    columns: &Columns,
    beside: &[ColumnSelector],
    options: &ScanOptions,
) -> [(Measurements, Vec<Vec<Rational>>); 2] {
    [0, usize::MAX]
        .map(|most| Measurements::read_counted(source(text), columns, beside, options, most).unwrap())
}

/// The vertices of a set with all that is active there.
fn corners<N>(region: &Region, names: impl Fn(&[usize]) -> N) -> Vec<([Rational; 2], N)> {
    let vertices = region.vertices().iter();
    vertices.map(|vertex| (vertex.point().coordinates(), names(vertex.active()))).collect()
}

fn of_fps(fps: &Fps) -> Vec<([Rational; 2], boundfit_estimation::ActiveBounds)> {
    corners(fps.polyhedron().region(), |indices| fps.active(indices, usize::MAX))
}

fn columns(rng: &mut ChaCha8Rng) -> Columns {
    let epsilon = match rng.random_range(0..4) {
        0 => EpsilonColumn::Column(named("eps")),
        1 => EpsilonColumn::Interval { lower: Some(named("y")), upper: None },
        _ => EpsilonColumn::Uniform(Rational::ratio(rng.random_range(1..9), 2)),
    };
    Columns {
        first: named("x"),
        second: rng.random_bool(0.3).then(|| named("u")),
        response: Some(named("y")),
        epsilon,
        form: LineForm::default(),
    }
}

fn same_fits(counted: &Problem, each: &Problem) {
    let [one, other]: [Fit; 2] = [counted, each].map(fit);
    assert_eq!(one.least_squares, other.least_squares);
    assert_eq!(one.pui_intervals(), other.pui_intervals());
    assert_eq!(one.central, other.central);
    assert_eq!(one.minimax, other.minimax);
    assert_eq!(of_fps(&one.fps), of_fps(&other.fps));
    let bound = each.measurements.error_bound();
    assert_eq!(one.contradiction(bound), other.contradiction(bound));
}

fn same_outliers(counted: &Problem, each: &Problem) {
    let limits = OutlierLimits { sets: 1000, steps: 200_000 };
    let [one, other] = [counted, each].map(|problem| Outliers::new(problem, &limits));
    // Counted, more can be answered.
    let (Ok(one), Ok(other)) = (&one, &other) else {
        assert!(other.is_err() && (one.is_ok() || one.as_ref().err() == other.as_ref().err()));
        return;
    };
    assert_eq!((one.least, one.is_complete), (other.least, other.is_complete));
    assert_eq!(one.pieces.len(), other.pieces.len());
    for (piece, expected) in one.pieces.iter().zip(&other.pieces) {
        assert_eq!(piece.rows, expected.rows);
        assert_eq!(of_fps(&piece.left), of_fps(&expected.left));
        let of = |problem: &Problem| -> Vec<(usize, Measurement)> {
            let found = problem.measurements.readings_of(&piece.rows);
            let numbered =
                |(row, reading): (usize, &Measurement)| (row, Measurement { row, ..reading.clone() });
            found.into_iter().map(numbered).collect()
        };
        assert_eq!(of(counted), of(each));
        let left = |problem: &Problem| -> Vec<(usize, Bounds)> {
            let left = problem.measurements.without(&piece.rows.iter().copied().collect());
            left.into_iter().map(|reading| (reading.row, reading.bounds)).collect()
        };
        assert!(left(counted).iter().all(|own| left(each).contains(own)));
    }
    assert_eq!(one.pui(), other.pui());
    let [of_one, of_other] =
        [(one, counted), (other, each)].map(|(own, problem)| own.growth(problem, own.least + 2, &limits));
    if let (Ok(of_one), Ok(of_other)) = (of_one, of_other) {
        assert_eq!(of_one, of_other);
    }
}

#[test]
fn fits_and_outliers_of_counted_readings_are_those_of_each() {
    let mut rng = seeded(4_101);
    let (mut are_counted, mut have_outliers) = (0, 0);
    for round in 0..150 {
        let text = table(&mut rng, 12 + round % 60);
        let columns = columns(&mut rng);
        let chunk_bytes = [40, 1 << 18][round % 2];
        let options = ScanOptions { chunk_bytes, ..ScanOptions::default() };
        let [(counted, _), (each, _)] = both(&text, &columns, &[], &options);
        assert!(matches!(each.readings(), Readings::All(_)));
        are_counted += usize::from(matches!(counted.readings(), Readings::Counted { .. }));
        assert_eq!((counted.fitted(), counted.rows_total()), (each.fitted(), each.rows_total()));
        let mut conditions = Vec::new();
        if round % 5 == 0 {
            let condition = Condition::parse("theta1 >= 0", Reading::Decimal, &Limits::default());
            conditions.push(condition.unwrap());
        }
        let [counted, each] = [counted, each].map(|measurements| {
            let problem = Problem { measurements, conditions: conditions.clone() };
            if round % 7 == 0 { problem.through_origin() } else { problem }
        });
        same_fits(&counted, &each);
        same_outliers(&counted, &each);
        have_outliers += usize::from(fit(&each).is_empty());
    }
    assert!(are_counted > 80 && have_outliers > 30, "{are_counted} {have_outliers}");
}

type Corner<N> = ([Rational; 2], N);

fn of_side(side: &SideSet) -> Vec<Corner<(Vec<boundfit_questions::BoxBound>, usize)>> {
    corners(side.polyhedron.region(), |indices| side.active(indices, usize::MAX))
}

#[test]
fn lines_under_errors_in_x_are_those_of_each() {
    let mut rng = seeded(4_102);
    let mut are_counted = 0;
    for round in 0..60 {
        let text = table(&mut rng, 12 + round % 40);
        let columns = Columns {
            second: None,
            epsilon: EpsilonColumn::Uniform(Rational::ratio(rng.random_range(1..12), 2)),
            ..columns(&mut rng)
        };
        let beside: Vec<ColumnSelector> = if round % 2 == 0 { vec![named("dx")] } else { Vec::new() };
        let agreement = if round % 3 == 0 { Agreement::Strong } else { Agreement::Weak };
        let [one, other] =
            both(&text, &columns, &beside, &ScanOptions::default()).map(|(own, mut further)| {
                are_counted += usize::from(own.ties().is_some());
                let bounds = match further.pop() {
                    Some(bounds) => XBounds::PerRow { column: "dx".into(), bounds },
                    None => XBounds::Uniform(Rational::ratio(1, 3)),
                };
                XErrorProblem::new(Problem::new(own), bounds, agreement).unwrap().fit()
            });
        assert_eq!(one.pui(), other.pui());
        assert_eq!(one.central, other.central);
        assert_eq!(one.least, other.least);
        assert_eq!(
            one.sides.iter().map(of_side).collect::<Vec<_>>(),
            other.sides.iter().map(of_side).collect::<Vec<_>>()
        );
    }
    assert!(are_counted > 30, "{are_counted}");
}

/// Returns the parts of a linearity that must agree: everything but how many points stand for how many.
fn told(found: &Linearity) -> String {
    let mut text = format!("{:?}", (&found.hysteresis, &found.repeatability));
    for own in [Some(&found.average), found.up.as_ref(), found.down.as_ref()].into_iter().flatten() {
        let lines =
            [Ok(&own.independent), own.terminal.as_ref(), Ok(&own.zero_based), own.least_squares.as_ref()];
        let lines = lines.map(|line| {
            line.map(|line| (&line.deviation, &line.percent, &line.theta, line.unique, line.rows(own)))
        });
        let proof = own.proof.iter().map(|point| {
            let place = &own.points[point.position];
            (&place.x, &place.y, &place.rows, &point.deviation, &point.weight)
        });
        write!(text, "{:?}", (own.count(), &own.span, &own.full_scale, lines, proof.collect::<Vec<_>>()))
            .unwrap();
    }
    text
}

#[test]
fn the_linearity_of_counted_readings_is_that_of_each() {
    let mut rng = seeded(4_103);
    let mut are_counted = 0;
    for round in 0..90 {
        let text = table(&mut rng, 20 + round % 60);
        let response = match round % 3 {
            0 => CalibrationResponse::One(named("y")),
            1 => CalibrationResponse::Directed { y: named("y"), direction: named("d") },
            _ => CalibrationResponse::Two { up: named("y"), down: named("eps") },
        };
        let columns = CalibrationColumns { x: named("x"), response };
        let options = ScanOptions { chunk_bytes: [50, 1 << 18][round % 2], ..ScanOptions::default() };
        let [counted, each] = [0, usize::MAX]
            .map(|most| Calibration::read_counted(source(&text), &columns, &options, most).unwrap());
        are_counted += usize::from(counted.readings.len() < each.readings.len());
        assert_eq!(format!("{:?}", counted.input), format!("{:?}", each.input));
        let through = [Rational::one(), Rational::from(round as i64 % 3)];
        let asked = LinearityOptions { full_scale: None, through };
        let [one, other] = [&counted, &each].map(|own| told(&Linearity::new(&own.readings, &asked).unwrap()));
        assert_eq!(one, other);
    }
    assert!(are_counted > 60, "{are_counted}");
}

/// Some hundred rows: noise about a line, few steps of x, all on a line, all at one x, or a curve. Numbers are short, long
/// or very different, some rows are equal, and some tables have a fraction.
fn plain_table(rng: &mut ChaCha8Rng, round: usize) -> String {
    let mut text = "x,y\n".to_owned();
    let count = rng.random_range(50..400);
    let steps = [3, 40, 1_000, 1 << 40][rng.random_range(0..4)];
    let noise = [1, 2, 50, 1 << 30][rng.random_range(0..4)];
    let slope = rng.random_range(-3_i64..4);
    let exponents = [[0, 0], [-4, 2], [-30, 30], [-17, -290]][rng.random_range(0..4)];
    let mut lines: Vec<String> = Vec::new();
    for k in 0..count {
        if !lines.is_empty() && rng.random_range(0..10) < round % 4 {
            lines.push(lines[rng.random_range(0..lines.len())].clone());
            continue;
        }
        let x = match round % 7 {
            0 => 5,
            _ => rng.random_range(-steps..steps),
        };
        let curve = if round % 7 == 1 { k * k } else { 0 };
        let y = slope * x + rng.random_range(0..noise) + curve;
        let mut cells = [x, y].map(i128::from);
        if round % 3 == 1 {
            // Seventeen digits and more.
            cells = cells.map(|number| number * 10_i128.pow(6) + rng.random_range(0_i128..1_000_000));
        }
        let fraction = if round % 11 == 10 && k == 70 { "/3" } else { "" };
        let [x, y] = cells;
        let [e, f] = exponents.map(|exponent| match (fraction, rng.random_bool(0.5)) {
            ("", true) => format!("0e{}", exponent - 1),
            ("", false) => format!("e{exponent}"),
            _ => fraction.to_owned(),
        });
        lines.push(format!("{x}{e},{y}{f}"));
    }
    lines.iter().for_each(|line| writeln!(text, "{line}").unwrap());
    text
}

#[test]
fn the_readings_that_decide_linearity_tell_it_of_all() {
    let mut rng = seeded(4_105);
    let mut decided = 0;
    for round in 0..share(400) {
        let text = plain_table(&mut rng, round);
        let columns = CalibrationColumns { x: named("x"), response: CalibrationResponse::One(named("y")) };
        let options = ScanOptions { chunk_bytes: [300, 1 << 18][round % 2], ..ScanOptions::default() };
        let few = Calibration::read(source(&text), &columns, &options).unwrap();
        let each = Calibration::read_counted(source(&text), &columns, &options, usize::MAX).unwrap();
        decided += usize::from(few.readings.len() < each.readings.len());
        assert_eq!(format!("{:?}", few.input), format!("{:?}", each.input));
        let through = [Rational::from(round as i64 % 2), Rational::from(round as i64 % 3)];
        let full_scale = (round % 5 == 0).then(|| Rational::from(7));
        let asked = LinearityOptions { full_scale, through };
        let [one, other] = [&few, &each].map(|own| told(&own.linearity(&asked).unwrap()));
        assert_eq!(one, other, "{round}: {text}");
    }
    assert!(decided > share(200), "{decided}");
}

#[test]
fn groups_of_equal_readings_are_fitted_like_others() {
    let mut rng = seeded(4_104);
    for (round, count) in [40, 300, 25_000, 26_000].into_iter().enumerate() {
        let text = table(&mut rng, count);
        let columns = Columns {
            second: None,
            epsilon: EpsilonColumn::Uniform(Rational::from([2, 12][round % 2])),
            ..columns(&mut rng)
        };
        let fleet = Fleet::read(source(&text), &columns, &named("g"), ScanOptions::default()).unwrap();
        assert_eq!((fleet.len(), fleet.readings()), (2, count));
        for group in 0..2 {
            let key = fleet.key(group).raw().to_owned();
            let own = text.lines().enumerate().filter(|(row, line)| *row == 0 || line.ends_with(&key));
            let (rows, lines): (Vec<usize>, Vec<&str>) = own.unzip();
            let alone = lines.join("\n");
            let expected = Measurements::read_counted(
                source(&alone),
                &columns,
                &[],
                &ScanOptions::default(),
                usize::MAX,
            );
            let expected = fit(&Problem::new(expected.unwrap().0));
            let measurements = fleet.measurements(group);
            assert_eq!(measurements.fitted(), rows.len() - 1);
            assert_eq!(measurements.kept().len() > 100, rows.len() < Keep::MOST_ROWS && rows.len() > 101);
            let found = fit(&Problem::new(measurements));
            assert_eq!(found.least_squares, expected.least_squares);
            assert_eq!(found.pui_intervals(), expected.pui_intervals());
            let named = |fit: &Fit, rows: &dyn Fn(usize) -> usize| -> Vec<Vec<String>> {
                let names = of_fps(&fit.fps).into_iter().map(|(_, active)| active.at_most(Ties::MOST_LISTED));
                let name = |name: &boundfit_estimation::BoundName| {
                    name.of_row(rows(name.row().unwrap())).to_string()
                };
                names.map(|active| active.names.iter().map(name).collect()).collect()
            };
            assert_eq!(named(&found, &|row| row), named(&expected, &|row| rows[row]));
        }
    }
}
