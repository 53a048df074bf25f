//! Times boundfit's parts on a table in memory, and the linear-programming solvers on the same rows:
//! `measure WORK FILE EPS [RUNS]` prints one line of JSON with medians in seconds. `benches/side-by-side` asks for them.
//!
//! FILE has the columns x and y, for `fleet-…` also sensor, sorted by sensor.

use std::hint::black_box;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use boundfit_check::ProgramRows;
use boundfit_estimation::{
    Columns, EpsilonColumn, ErrorBound, Fit, Fps, LineForm, Measurement, Measurements, Model, Problem, Ties,
    fit,
};
use boundfit_exact::{Interval, Limits, Rational, Reading};
use boundfit_formats::{ColumnSelector, Source, TableOptions, read_table};
use boundfit_geometry::grid::touching_of_columns;
use boundfit_geometry::predicates::lexicographic;
use boundfit_geometry::{Hulls, Point};
use boundfit_lp::{FloatProgram, Outcome, Program, PuiEnd, Solver, solver_named};
use boundfit_tests::readings::y_and_epsilon;
use cpu_time::ProcessTime;
use serde_json::{Map, Value, json};

const USAGE: &str =
    "usage: measure sum|sum-integers|polygon|fit|answer|solver-NAME|fleet-NAME FILE EPS [RUNS]";

/// Work that is shorter than this is repeated within one run: clocks are coarse.
const SHORTEST_RUN: Duration = Duration::from_millis(5);

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match answer(&arguments.iter().map(String::as_str).collect::<Vec<_>>()) {
        Ok(answer) => {
            println!("{}", Value::Object(answer));
            ExitCode::SUCCESS
        }
        Err(message) => {
            eprintln!("measure: {message}");
            ExitCode::FAILURE
        }
    }
}

fn answer(arguments: &[&str]) -> Result<Map<String, Value>, String> {
    let (&[work, file, epsilon], runs) = (match arguments {
        [named @ .., runs] if named.len() == 3 => {
            (named, runs.parse().map_err(|_| format!("{runs:?} is no number of runs"))?)
        }
        named => (named, 1_usize),
    }) else {
        return Err(USAGE.to_owned());
    };
    let epsilon = Reading::Decimal.read(epsilon, &Limits::default()).map_err(|error| error.to_string())?;
    if let Some(name) = work.strip_prefix("fleet-") {
        let sensors = sensors(file, &epsilon)?;
        return if name == "exact" {
            Ok(reference_of_fleet(&sensors))
        } else {
            fleet_by_solver(name, &sensors, runs)
        };
    }
    let problem = read(file, &epsilon)?;
    match work {
        "sum" => Ok(sum(&problem, runs)),
        "sum-integers" => sum_of_integers(&problem, runs),
        "polygon" => polygon(&problem, &epsilon, runs),
        "fit" => Ok(whole_fit(&problem, runs)),
        "answer" => Ok(reference(&problem)),
        _ => match work.strip_prefix("solver-") {
            Some(name) => pui_by_solver(name, &problem, runs),
            None => Err(USAGE.to_owned()),
        },
    }
}

/// Both columns as binary64 numbers, added up in order: the yardstick.
fn sum(problem: &Problem, runs: usize) -> Map<String, Value> {
    let rows = problem.measurements.kept();
    let x: Vec<f64> = rows.iter().map(|row| row.regressor[0].to_f64()).collect();
    let y: Vec<f64> = rows.iter().map(|row| y_and_epsilon(row).0.to_f64()).collect();
    timed(runs, || (black_box(&x).iter().sum::<f64>(), black_box(&y).iter().sum::<f64>())).0
}

/// Both columns as integers on a common power of ten, added up: the same for what boundfit works on.
fn sum_of_integers(problem: &Problem, runs: usize) -> Result<Map<String, Value>, String> {
    let rows = problem.measurements.kept();
    let (x, _) = on_grid(rows.iter().map(|row| &row.regressor[0]))?;
    let (y, _) = on_grid(rows.iter().map(|row| y_and_epsilon(row).0))?;
    let total = |column: &[i64]| column.iter().fold(0_i64, |sum, &value| sum.wrapping_add(value));
    Ok(timed(runs, || (total(black_box(&x)), total(black_box(&y)))).0)
}

/// Two columns of integers on powers of ten to the exact polygon, its vertices as fractions, as the program goes: the
/// readings that touch a hull, and their FPS.
fn polygon(problem: &Problem, epsilon: &Rational, runs: usize) -> Result<Map<String, Value>, String> {
    let rows = problem.measurements.kept();
    let (x, _) = on_grid(rows.iter().map(|row| &row.regressor[0]))?;
    let (y, _) = on_grid(rows.iter().map(|row| y_and_epsilon(row).0))?;
    let (mut times, (fps, _)) = timed(runs, || {
        let touching =
            touching_of_columns(black_box(&x), black_box(&y), &|row| row as u64, Ties::MOST_LISTED);
        let mut kept: Vec<usize> = touching.iter().map(|point| point.rows.first() as usize).collect();
        kept.sort_unstable();
        let kept = line(kept.into_iter().map(|row| rows[row].clone()).collect(), epsilon);
        let fps = Fps::new(&kept, &[]);
        let vertices = fps.polyhedron().region().vertices().iter();
        let fractions: Vec<_> = vertices.map(|vertex| vertex.point().coordinates()).collect();
        (fps, fractions)
    });
    let every = Fps::of_every_half_plane(&problem.measurements, &[]);
    let points = |fps: &Fps| -> Vec<Point> {
        fps.polyhedron().region().vertices().iter().map(|vertex| vertex.point().clone()).collect()
    };
    if points(&fps) != points(&every) {
        return Err("the fast and the general way differ".to_owned());
    }
    times.insert("vertices".to_owned(), json!(points(&fps).len()));
    Ok(times)
}

fn line(rows: Vec<Measurement>, epsilon: &Rational) -> Measurements {
    let model = Model::Line { x: "x".into() };
    Measurements::new(model, "y".into(), ErrorBound::Uniform(epsilon.clone()), rows)
}

/// Everything that is known about the readings, with all proofs.
fn whole_fit(problem: &Problem, runs: usize) -> Map<String, Value> {
    let (mut times, fit) = timed(runs, || fit(black_box(problem)));
    times.insert("vertices".to_owned(), json!(fit.fps.polyhedron().region().vertices().len()));
    times
}

/// Returns what the others' answers are compared with: how many vertices and hull corners there are, and the PUI.
fn reference(problem: &Problem) -> Map<String, Value> {
    let rows = problem.measurements.kept();
    let mut points: Vec<Point> =
        rows.iter().map(|row| Point::new(&row.regressor[0], y_and_epsilon(row).0)).collect();
    points.sort_by(lexicographic);
    points.dedup();
    let corners = Hulls::of_sorted(&points).corners().len();
    let fit = fit(problem);
    let pui = exact_ends(&fit);
    let theta = fit.least_squares.ok().map(|estimate| estimate.theta.map(|theta| theta.to_f64()));
    let vertices = fit.fps.polyhedron().region().vertices().len();
    object(json!({"corners": corners, "vertices": vertices, "pui": pui, "least_squares": theta}))
}

/// The PUI of every sensor.
fn reference_of_fleet(sensors: &[Problem]) -> Map<String, Value> {
    let ends: Vec<_> = sensors.iter().map(|sensor| exact_ends(&fit(sensor))).collect();
    object(json!({"pui": ends}))
}

/// Lower and upper end of the PUI of both parameters, rounded to be compared with floats.
fn exact_ends(fit: &Fit) -> Option<[Option<[f64; 2]>; 2]> {
    let ends = |interval: &Interval| interval.ends().map(|(lower, upper)| [lower.to_f64(), upper.to_f64()]);
    fit.pui_intervals().map(|pui| pui.each_ref().map(ends))
}

/// The PUI by four linear programs in a float solver.
fn pui_by_solver(name: &str, problem: &Problem, runs: usize) -> Result<Map<String, Value>, String> {
    let programs = programs(problem);
    let solver = solver_named(name).ok_or_else(|| format!("this build has no solver {name}"))?;
    let (times, ends) = timed(runs, || interval_ends(&*solver, black_box(&programs)));
    Ok(with_answer(times, &*solver, json!(ends?)))
}

/// The PUI of every sensor by four linear programs each, one sensor after the other.
fn fleet_by_solver(name: &str, sensors: &[Problem], runs: usize) -> Result<Map<String, Value>, String> {
    let programs: Vec<[FloatProgram; 4]> = sensors.iter().map(programs).collect();
    let solver = solver_named(name).ok_or_else(|| format!("this build has no solver {name}"))?;
    let all = || -> Result<Vec<_>, String> {
        programs.iter().map(|programs| interval_ends(&*solver, black_box(programs))).collect()
    };
    let (times, ends) = timed(runs, all);
    Ok(with_answer(times, &*solver, json!(ends?)))
}

fn with_answer(times: Map<String, Value>, solver: &dyn Solver, pui: Value) -> Map<String, Value> {
    let mut answer = times;
    answer.insert("pui".to_owned(), pui);
    let version = format!("{} {}", solver.name(), solver.version());
    answer.insert("versions".to_owned(), json!([version]));
    answer
}

/// The programs that find the least and the largest θ1 and θ2, as a float solver receives them.
fn programs(problem: &Problem) -> [FloatProgram; 4] {
    let rows = ProgramRows::new(problem).plain();
    PuiEnd::ALL.map(PuiEnd::objective).map(|objective| FloatProgram::new(&Program { rows: &rows, objective }))
}

/// Lower and upper end for both parameters.
fn interval_ends(solver: &dyn Solver, programs: &[FloatProgram; 4]) -> Result<[[f64; 2]; 2], String> {
    let mut ends = [[f64::NAN; 2]; 2];
    for (number, program) in programs.iter().enumerate() {
        match solver.solve(program) {
            Outcome::Optimal(optimum) => ends[number / 2][number % 2] = optimum.theta[number / 2],
            Outcome::Failed(reason) => return Err(reason),
            other => return Err(format!("{other:?}").to_lowercase()),
        }
    }
    Ok(ends)
}

/// The medians of the work's times, of the wall clock and of the processor in seconds, and its result. A single run is not
/// repeated: it may be a long one.
fn timed<T>(runs: usize, work: impl Fn() -> T) -> (Map<String, Value>, T) {
    let mut result = None;
    let mut repetitions = 1;
    if runs > 1 {
        let start = Instant::now();
        result = Some(black_box(work()));
        repetitions += SHORTEST_RUN.as_nanos() / start.elapsed().as_nanos().max(1);
    }
    let mut walls = Vec::new();
    let mut processors = Vec::new();
    for _ in 0..runs.max(1) {
        let (wall, processor) = (Instant::now(), ProcessTime::now());
        for _ in 0..repetitions {
            result = Some(black_box(work()));
        }
        walls.push(wall.elapsed().as_secs_f64() / repetitions as f64);
        processors.push(processor.elapsed().as_secs_f64() / repetitions as f64);
    }
    let times = json!({"wall": median(walls), "cpu": median(processors), "runs": runs.max(1)});
    (object(times), result.unwrap_or_else(work))
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn object(value: Value) -> Map<String, Value> {
    value.as_object().cloned().unwrap_or_default()
}

fn read(file: &str, epsilon: &Rational) -> Result<Problem, String> {
    let columns = Columns {
        first: ColumnSelector::name_or_number("x"),
        second: None,
        response: Some(ColumnSelector::name_or_number("y")),
        epsilon: EpsilonColumn::Uniform(epsilon.clone()),
        form: LineForm::default(),
    };
    let source = Source::open(file).map_err(|error| error.to_string())?;
    let measurements = Measurements::read(source, &columns, &TableOptions::default());
    Ok(Problem { measurements: measurements.map_err(|error| error.to_string())?, conditions: Vec::new() })
}

/// The readings of each sensor.
fn sensors(file: &str, epsilon: &Rational) -> Result<Vec<Problem>, String> {
    let text = std::fs::read_to_string(file).map_err(|error| format!("{file}: {error}"))?;
    let key = |line: &str| line.split(',').next().unwrap_or_default().to_owned();
    let keys: Vec<String> = text.lines().skip(1).map(key).collect();
    let columns = ["x", "y"].map(ColumnSelector::name_or_number);
    let source = Source::open(file).map_err(|error| error.to_string())?;
    let table = read_table(source, &columns, &TableOptions::default()).map_err(|error| error.to_string())?;
    let rows: Vec<(&String, Measurement)> = keys
        .iter()
        .zip(table.rows)
        .map(|(key, row)| {
            let [x, y] = [row.numbers[0].clone(), row.numbers[1].clone()];
            let regressor = [x, Rational::one()];
            (key, Measurement::around(row.row, regressor, y, epsilon.clone()))
        })
        .collect();
    let group = |rows: &[(&String, Measurement)]| {
        let rows = rows.iter().map(|(_, row)| row.clone()).collect();
        Problem { measurements: line(rows, epsilon), conditions: Vec::new() }
    };
    Ok(rows.chunk_by(|left, right| left.0 == right.0).map(group).collect())
}

/// The numbers as integers that count the largest power of ten for which they are integers, and that power.
fn on_grid<'a>(numbers: impl Iterator<Item = &'a Rational> + Clone) -> Result<(Vec<i64>, Rational), String> {
    const MOST_DECIMALS: u32 = 18;
    let scaled = |decimals: u32| -> Option<(Vec<i64>, Rational)> {
        let power = 10_i64.pow(decimals);
        let scale = Rational::from(power);
        let integers = numbers.clone().map(|number| (number * &scale).to_string().parse().ok());
        Some((integers.collect::<Option<_>>()?, Rational::ratio(1, power)))
    };
    (0..=MOST_DECIMALS).find_map(scaled).ok_or_else(|| "the numbers do not fit into 64 bits".to_owned())
}
