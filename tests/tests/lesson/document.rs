//! The data of a lesson, and the fits that lessons are made of.

use boundfit_estimation::{
    Columns, EpsilonColumn, Fit, LineForm, Measurement, Measurements, Model, Problem, fit,
};
use boundfit_exact::{Rational, Reading};
use boundfit_formats::{ColumnSelector, RowRange, Source, TableOptions};
use boundfit_geometry::{Direction, HalfPlane, Inequality, Point, RegionKind, System};
use boundfit_lesson::{Language, LessonOptions, lesson_data, said};
use boundfit_tests::generate::{seeded, share};
use boundfit_tests::lp_cases::hard_cases;
use boundfit_tests::program::root;
use boundfit_tests::readings::{
    parse_condition, problem as random_problem, with_error_bound, with_rows, y_and_epsilon,
};
use boundfit_tests::shape::Shape;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use serde_json::Value;

use boundfit_tests::cli::numbers::{pair, rational};

/// A fit with the data of its lesson.
pub struct Lesson {
    pub name: String,
    pub problem: Problem,
    pub fit: Fit,
    pub data: Value,
}

impl Lesson {
    pub fn of(name: &str, problem: Problem) -> Self {
        let fit = fit(&problem);
        let data = lesson_data(&problem, &fit, Reading::Decimal, &LessonOptions::default()).unwrap();
        Lesson { name: name.to_owned(), problem, fit, data: in_english(data) }
    }

    /// The same under further conditions.
    pub fn with_conditions(self, more: &[&str]) -> Self {
        let mut problem = self.problem;
        problem.conditions.extend(more.iter().map(|text| parse_condition(text)));
        Lesson::of(&self.name, problem)
    }

    /// The half-planes as the data have them.
    pub fn system(&self) -> System {
        let text = |value: &Value| rational(value.as_str().unwrap());
        let half_planes = items(&self.data["half_planes"]);
        half_planes.map(|h| Inequality::new(text(&h["a"][0]), text(&h["a"][1]), text(&h["b"]))).collect()
    }

    /// A point by its index.
    pub fn point(&self, index: &Value) -> Point {
        let [theta1, theta2] = pair(&self.data["points"][usize::try_from(index.as_u64().unwrap()).unwrap()]);
        Point::new(&theta1, &theta2)
    }

    /// Points by their indices.
    pub fn points(&self, indices: &Value) -> Vec<Point> {
        items(indices).map(|index| self.point(index)).collect()
    }

    /// A region as a set.
    pub fn shape(&self, region: &Value) -> Shape {
        let system = self.system();
        let kind = kind(region);
        let direction = |pair: &Value| {
            let component = |index: usize| rational(pair[index].as_str().unwrap()).numerator();
            Direction::new(component(0), component(1)).unwrap()
        };
        // A line may be given by the half-plane on either side of it.
        let boundary = |index: &Value| -> HalfPlane {
            let half_plane = system.half_plane(count(index)).unwrap();
            let upward =
                half_plane.a2().is_positive() || (half_plane.a2().is_zero() && half_plane.a1().is_positive());
            if kind == RegionKind::Line && !upward { half_plane.opposite() } else { half_plane.clone() }
        };
        Shape {
            kind,
            points: self.points(&region["vertices"]),
            rays: items(&region["rays"]).map(direction).collect(),
            lines: items(&region["lines"]).map(direction).collect(),
            boundaries: items(&region["boundaries"]).map(boundary).collect(),
        }
    }
}

/// A document with the English texts in place of their keys.
fn in_english(data: Value) -> Value {
    match data {
        Value::Object(fields) if fields.get("text").is_some() && !fields.contains_key("number") => {
            said(&Value::Object(fields), Language::English).into()
        }
        Value::Object(fields) => fields.into_iter().map(|(key, value)| (key, in_english(value))).collect(),
        Value::Array(items) => items.into_iter().map(in_english).collect(),
        other => other,
    }
}

/// The items of a list.
pub fn items(list: &Value) -> impl Iterator<Item = &Value> + Clone {
    list.as_array().unwrap_or_else(|| panic!("not a list: {list}")).iter()
}

/// A count or an index.
pub fn count(value: &Value) -> usize {
    usize::try_from(value.as_u64().unwrap_or_else(|| panic!("not a count: {value}"))).unwrap()
}

/// The kind of a region.
pub fn kind(region: &Value) -> RegionKind {
    let name = region["kind"].as_str().unwrap();
    RegionKind::ALL.into_iter().find(|kind| kind.name() == name).unwrap()
}

/// A fit of a fixture.
pub fn read(path: &str, [x, y]: [&str; 2], epsilon: EpsilonColumn, rows: Option<RowRange>) -> Problem {
    let source = Source::open(root().join("fixtures").join(path).to_str().unwrap()).unwrap();
    let column = ColumnSelector::name_or_number;
    let columns = Columns {
        first: column(x),
        second: None,
        response: Some(column(y)),
        epsilon,
        form: LineForm::default(),
    };
    let options = TableOptions { rows: rows.into(), keep_others: true, ..TableOptions::default() };
    let measurements = Measurements::read(source, &columns, &options).unwrap();
    Problem { measurements, conditions: Vec::new() }
}

/// The transducer's linearity interval.
pub fn transducer() -> Lesson {
    let epsilon = EpsilonColumn::Uniform(Rational::ratio(1, 2000));
    let rows = RowRange::new(14, 36);
    Lesson::of("transducer", read("transducer/transducer.csv", ["Vz", "z"], epsilon, rows))
}

/// The steam generator: an error bound per reading, and a condition.
pub fn steam_generator() -> Lesson {
    let epsilon = EpsilonColumn::Column(ColumnSelector::name_or_number("eps"));
    let path = "steam-generator/steam_generator.csv";
    let problem =
        Problem { conditions: vec![parse_condition("theta1 >= 0")], ..read(path, ["x", "y"], epsilon, None) };
    Lesson::of("steam generator", problem)
}

/// Norris' calibration, whose set is empty at this error bound.
pub fn norris() -> Lesson {
    let epsilon = EpsilonColumn::Uniform(Rational::one());
    Lesson::of("norris", read("norris/norris.csv", ["x", "y"], epsilon, None))
}

/// Readings of one x only.
pub fn strip() -> Lesson {
    let epsilon = EpsilonColumn::Uniform(Rational::ratio(1, 5));
    Lesson::of("strip", read("claims/strip.csv", ["x", "y"], epsilon, None))
}

/// Published data, and those on which float solvers fail.
pub fn fixtures() -> Vec<Lesson> {
    let mut lessons = vec![transducer(), steam_generator(), norris(), strip()];
    lessons.extend(hard_cases().into_iter().map(|case| Lesson::of(&case.name, case.problem)));
    lessons
}

/// Generated fits: every kind of set, model and error bound, with conditions and repeated readings.
pub fn generated(seed: u64, count: usize) -> Vec<Lesson> {
    let mut rng = seeded(seed);
    let lesson = |number: usize| {
        let problem =
            if number.is_multiple_of(2) { random_problem(&mut rng) } else { sparse_problem(&mut rng) };
        Lesson::of(&format!("seed {seed}, {number}"), problem)
    };
    (0..share(count)).map(lesson).collect()
}

/// One to three readings, often of one x, of regressors zero or with error bound zero, under up to two conditions: sets
/// that are unbounded or flat.
fn sparse_problem(rng: &mut ChaCha8Rng) -> Problem {
    const CONDITIONS: [&str; 7] = [
        "theta1 >= 0",
        "theta1 <= 0",
        "theta2 >= -1",
        "theta2 <= 1",
        "theta1 + theta2 >= 1",
        "2*theta1 - theta2 <= 3",
        "0*theta1 <= 0",
    ];
    let problem = random_problem(rng);
    let is_line = matches!(problem.measurements.model(), Model::Line { .. });
    let same = rng.random_bool(0.7);
    let zero = !is_line && rng.random_bool(0.7);
    let mut rows = problem.measurements.kept().to_vec();
    rows.truncate(rng.random_range(1..=3));
    let first = rows[0].clone();
    for row in rows.iter_mut().filter(|_| same) {
        let (regressor, response) = (first.regressor.clone(), y_and_epsilon(&first).0.clone());
        let (regressor, response) = if zero {
            ([Rational::zero(), Rational::zero()], Rational::zero())
        } else {
            (regressor, response)
        };
        *row = Measurement::around(row.row, regressor, response, y_and_epsilon(row).1.clone());
    }
    let conditions =
        (0..rng.random_range(0..=2)).map(|_| parse_condition(CONDITIONS[rng.random_range(0..7)]));
    let problem = Problem { conditions: conditions.collect(), ..with_rows(&problem, rows) };
    if rng.random_bool(0.4) { with_error_bound(&problem, &Rational::zero()) } else { problem }
}
