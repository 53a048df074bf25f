//! Everything that the page shows.

use boundfit_estimation::{Fit, Model, Problem};
use boundfit_exact::english::unit_by;
use boundfit_exact::{Foreign, Reading};
use boundfit_report::{FitJson, Number, Origin};
use serde::Serialize;

use crate::asked::{AskedJson, asked};
use crate::corridor::{CorridorJson, corridor};
use crate::half_planes::{HalfPlaneJson, half_planes};
use crate::layers::{self, LayersJson, programs};
use crate::leave_one_out::{self, WithoutJson, leave_one_out};
use crate::number::STYLE;
use crate::options::{LessonError, LessonOptions};
use crate::orders::{OrderJson, orders};
use crate::outliers::{OutliersJson, outliers};
use crate::points::Points;
use crate::questions::{Facts, Question, questions};
use crate::readings::{self, ConditionJson, EpsilonJson, ModelJson, ReadingJson};
use crate::sweep::{SweepJson, sweep};
use crate::texts::{Message, Value, say, text};

/// The file of readings that come from none, in the words of all surfaces.
const STANDARD_INPUT: &str = "standard input";

/// The document of schema `boundfit/lesson/3`. Texts from outside are in it as they are shown.
#[derive(Debug, Serialize)]
pub(crate) struct LessonJson {
    schema: &'static str,
    title: String,
    /// `true` if the title was made of the file and the columns.
    is_default_title: bool,
    file: String,
    asked: AskedJson,
    columns: Vec<String>,
    units: UnitsJson,
    model: ModelJson,
    epsilon: EpsilonJson,
    reading: &'static str,
    readings: Vec<ReadingJson>,
    others: Vec<ReadingJson>,
    conditions: Vec<ConditionJson>,
    half_planes: Vec<HalfPlaneJson>,
    points: Vec<[Number; 2]>,
    fit: FitJson,
    corridor: Option<CorridorJson>,
    orders: Vec<OrderJson>,
    sweep: SweepJson,
    layers: LayersJson,
    leave_one_out: Vec<WithoutJson>,
    outliers: Option<OutliersJson>,
    questions: Vec<Question>,
}

#[derive(Debug, Serialize)]
struct UnitsJson {
    x: Option<String>,
    y: Option<String>,
    theta1: Option<String>,
    theta2: Option<String>,
}

impl LessonJson {
    pub(crate) fn title(&self) -> &str {
        &self.title
    }

    /// The unit of a parameter.
    pub(crate) fn unit_of_parameter(&self, axis: usize) -> Option<&str> {
        [&self.units.theta1, &self.units.theta2].get(axis)?.as_deref()
    }

    /// The questions with their answers.
    pub(crate) fn questions(&self) -> impl Iterator<Item = (&Message, &Message)> {
        self.questions.iter().map(Question::texts)
    }
}

pub(crate) fn build(
    problem: &Problem,
    fit: &Fit,
    reading: Reading,
    options: &LessonOptions,
) -> Result<LessonJson, LessonError> {
    let measurements = &problem.measurements;
    let rows = measurements.kept().len();
    if rows > options.most_rows {
        return Err(LessonError::TooManyRows { rows, limit: options.most_rows });
    }
    // Half-planes that cannot be active are part of the lesson.
    let fit = &fit.with_every_half_plane(problem);
    let styles = STYLE.resolving_both(fit.pui_intervals().as_ref());
    let mut points = Points::new(styles);
    let programs = programs(problem);
    let without = leave_one_out(problem, fit);
    let file = file_name(options.file.raw());
    let origin = Origin { file: Some(file), reading, is_stored: false };
    let (asked, columns) =
        asked(problem, reading, options, file.raw(), &readings::shown_others(measurements));
    let facts = Facts { problem, fit, styles, programs: &programs, without: &without };
    Ok(LessonJson {
        schema: "boundfit/lesson/3",
        title: options.title.as_ref().map_or_else(
            || say(&default_title(file, problem), options.language),
            |title| title.raw().to_owned(),
        ),
        is_default_title: options.title.is_none(),
        file: file.to_string(),
        asked,
        columns,
        units: units(measurements.model(), options),
        model: readings::model(measurements),
        epsilon: readings::epsilon(measurements.error_bound()),
        reading: reading.name(),
        readings: readings::fitted(measurements),
        others: readings::others(measurements),
        conditions: readings::conditions(&problem.conditions),
        half_planes: half_planes(problem, fit),
        fit: FitJson::new(problem, fit, None, &origin, &STYLE),
        corridor: corridor(problem, fit, &mut points),
        orders: orders(problem, fit, &mut points),
        sweep: sweep(problem, fit),
        layers: layers::to_json(&programs, reading, &styles, &mut points),
        leave_one_out: leave_one_out::to_json(&without, &styles, &mut points),
        outliers: outliers(problem, fit),
        questions: questions(&facts),
        points: points.into_numbers(),
    })
}

/// The units of what is measured, and those that follow for the parameters.
fn units(model: &Model, options: &LessonOptions) -> UnitsJson {
    let [x, y] = [&options.x_unit, &options.y_unit]
        .map(|unit| unit.as_ref().map(Foreign::to_string).filter(|u| !u.is_empty()));
    let quotient = y.as_deref().zip(x.as_deref()).map(|(y, x)| unit_by(y, x));
    let second = match model {
        Model::Line { .. } => y.clone(),
        Model::TwoRegressors { .. } => quotient.clone(),
    };
    UnitsJson { x, y, theta1: quotient, theta2: second }
}

/// The text after the last separator of a path.
fn file_name(file: &str) -> Foreign<&str> {
    let name = file.rsplit(['/', '\\']).find(|name| !name.is_empty()).unwrap_or(file);
    Foreign::of(name)
}

fn default_title(file: Foreign<&str>, problem: &Problem) -> Message {
    let y = problem.measurements.response();
    let x = match problem.measurements.model() {
        Model::Line { x } => vec![problem.measurements.line_form().abscissa(x).label()],
        Model::TwoRegressors { regressors } => regressors.iter().map(Foreign::label).collect(),
    };
    // Readings that were typed, piped or linked have no file to name.
    if file.raw() == STANDARD_INPUT {
        return text!("page.title-of-input", y: y.label(), x: Value::listed(x));
    }
    text!("page.title", file: file.label(), y: y.label(), x: Value::listed(x))
}
