//! The page without scripts: both pictures, the tables and the questions, as they are at the start.

#[cfg(feature = "figures")]
mod pictures;

use boundfit_estimation::{Fit, Measurement, Model, Problem};
use boundfit_exact::{Rational, Rounding};
use boundfit_report::Style;

use crate::data::LessonJson;
use crate::number::{STYLE, with_minus};
use crate::options::{LessonError, LessonOptions};
use crate::questions::wording::value;
use crate::texts::{Language, Message, Value, html, text};

/// The longest decimal that a reading is shown with.
const READING_DIGITS: usize = 15;

/// The statements of parts of the page about the data, whether a script runs or not.
#[derive(Debug)]
pub(crate) struct Facts<'a> {
    pub(crate) problem: &'a Problem,
    pub(crate) fit: &'a Fit,
    pub(crate) document: &'a LessonJson,
    pub(crate) options: &'a LessonOptions,
}

impl Facts<'_> {
    fn language(&self) -> Language {
        self.options.language
    }

    fn say(&self, message: &Message) -> String {
        html(message, self.language())
    }

    fn is_line(&self) -> bool {
        matches!(self.problem.measurements.model(), Model::Line { .. })
    }

    /// The model as the page names it.
    pub(crate) fn model(&self) -> &'static str {
        if self.is_line() { "line" } else { "two-regressors" }
    }

    /// The names of the columns by what formulas call them.
    pub(crate) fn names(&self) -> Vec<(&'static str, String)> {
        let measurements = &self.problem.measurements;
        let mut names = vec![("y", measurements.response().label())];
        match measurements.model() {
            Model::Line { x } => {
                let form = measurements.line_form();
                let shown = form.abscissa(x).label();
                // As the script does: the sign before the origin only.
                let shown = match shown.rsplit_once(" - ").filter(|_| form.x_origin.is_positive()) {
                    Some((name, origin)) => format!("{name} \u{2212} {origin}"),
                    None => shown,
                };
                names.push(("x", shown));
            }
            Model::TwoRegressors { regressors: [u, v] } => {
                names.extend([("u", u.label()), ("v", v.label())]);
            }
        }
        names
    }

    /// The names within formulas, in which a shifted x is a difference in parentheses.
    pub(crate) fn names_in_formulas(&self) -> Vec<(&'static str, String)> {
        let is_shifted = !self.problem.measurements.line_form().x_origin.is_zero();
        let named = self.names().into_iter().map(|(name, column)| match name {
            "x" if is_shifted => (name, format!("({column})")),
            _ => (name, column),
        });
        named.chain([("middle", self.middle_name())]).collect()
    }

    /// The kind of the feasible set.
    fn kind(&self) -> Message {
        let region = self.fit.fps.polyhedron().region();
        text!(&format!("kind.{}", region.kind().name()), vertices: region.vertices().len())
    }

    /// The name of the middle of a reading's bounds: that of y, unless they differ.
    fn middle_name(&self) -> String {
        let measurements = &self.problem.measurements;
        match measurements.error_bound().has_middles() {
            true => "m".to_owned(),
            false => measurements.response().label(),
        }
    }

    /// The text in the places of the introduction.
    pub(crate) fn values(&self) -> Vec<(&'static str, Value)> {
        let mut values: Vec<(&str, Value)> =
            self.names().into_iter().map(|(name, column)| (name, column.into())).collect();
        let phi = if self.is_line() { "introduction.phi-line" } else { "introduction.phi-two" };
        let in_formulas = self.names_in_formulas();
        let phi = in_formulas.into_iter().fold(Message::new(phi), |phi, (name, own)| phi.with(name, own));
        let phi = phi.with("shift", Value::from(""));
        let conditions = &self.problem.conditions;
        let within =
            Value::listed(conditions.iter().map(|condition| Value::formula(condition.text().to_string())));
        let within: Value =
            if conditions.is_empty() { "".into() } else { text!("conditions.within", list: within).into() };
        values.extend([
            ("phi", phi.into()),
            ("epsilon", self.stated_bound()),
            ("conditions", within),
            ("minimax", self.minimax().into()),
        ]);
        values
    }

    fn stated_bound(&self) -> Value {
        let measurements = &self.problem.measurements;
        let Some(epsilon) = measurements.error_bound().uniform() else {
            let has_middles = measurements.error_bound().has_middles();
            return text!(if has_middles { "epsilon.stated-own" } else { "epsilon.stated-each" }).into();
        };
        let unit = self.options.y_unit.as_ref().map(|unit| format!(" {unit}")).unwrap_or_default();
        Value::joined([Value::from(" = "), number(epsilon), unit.into()], "list.nothing")
    }

    fn minimax(&self) -> Message {
        let Some(minimax) = &self.fit.minimax else { return text!("minimax.none") };
        let is_factor = !self.problem.measurements.error_bound().is_uniform();
        let measure = if self.is_line() { "minimax.line" } else { "minimax.parameter" };
        text!(
            if minimax.unique { "minimax.unique" } else { "minimax.several" },
            symbol: if is_factor { "s" } else { "ε" },
            measure: text!(measure, conditions: self.problem.conditions.len(), factor: 1 + usize::from(is_factor))
        )
    }
}

/// Everything between header and footer that scripts would draw.
///
/// # Errors
/// When a picture cannot be drawn.
pub(crate) fn content(facts: &Facts<'_>) -> Result<String, LessonError> {
    #[cfg(feature = "figures")]
    let pictures = pictures::pictures(facts)?;
    #[cfg(not(feature = "figures"))]
    let pictures = String::new();
    let heading = |key: &str| format!("<h2>{}</h2>", facts.say(&text!(key)));
    let parts = [
        format!("<h2>{}</h2>", crate::texts::escaped(facts.document.title())),
        format!("<p>{}</p>", facts.say(&text!("page.no-script"))),
        pictures,
        heading("shown.title"),
        set(facts),
        intervals(facts),
        vertices(facts),
        heading("readings.title"),
        readings(facts),
        heading("questions.title"),
        questions(facts),
    ];
    Ok(parts.concat().replace('\u{2028}', "&#8232;"))
}

fn set(facts: &Facts<'_>) -> String {
    format!("<p>{}</p>", facts.say(&text!("summary.set", set: facts.kind())))
}

/// A table with these heads.
fn table(heads: &[String], rows: &[Vec<String>]) -> String {
    let heads: String = heads.iter().map(|head| format!("<th scope=\"col\">{head}</th>")).collect();
    let row = |cells: &Vec<String>| {
        let cells: String = cells.iter().map(|cell| format!("<td class=\"number\">{cell}</td>")).collect();
        format!("<tr>{cells}</tr>")
    };
    let rows: String = rows.iter().map(row).collect();
    format!("<table><thead><tr>{heads}</tr></thead><tbody>{rows}</tbody></table>")
}

/// The name of a parameter with its unit.
fn theta(facts: &Facts<'_>, axis: usize) -> String {
    let name = if axis == 0 { "θ₁" } else { "θ₂" };
    match facts.document.unit_of_parameter(axis) {
        Some(unit) => format!("{name} ({})", crate::texts::escaped(unit)),
        None => name.to_owned(),
    }
}

fn styles(facts: &Facts<'_>) -> [Style; 2] {
    STYLE.resolving_both(facts.fit.pui_intervals().as_ref())
}

fn intervals(facts: &Facts<'_>) -> String {
    let Some(pui) = facts.fit.pui_intervals() else { return String::new() };
    let styles = styles(facts);
    let heads = ["PUI".to_owned(), facts.say(&text!("summary.lower")), facts.say(&text!("summary.upper"))];
    let rows = [0, 1].map(|axis| {
        let end = |end: Option<&Rational>, rounding: Rounding, infinite: &str| match end {
            Some(end) => said(facts, value(end, styles[axis].significant(), rounding)),
            None => infinite.to_owned(),
        };
        vec![
            theta(facts, axis),
            end(pui[axis].lower().value(), Rounding::Down, "−∞"),
            end(pui[axis].upper().value(), Rounding::Up, "∞"),
        ]
    });
    table(&heads, &rows)
}

fn vertices(facts: &Facts<'_>) -> String {
    let region = facts.fit.fps.polyhedron().region();
    if region.vertices().is_empty() {
        return String::new();
    }
    let styles = styles(facts);
    let rows: Vec<Vec<String>> = (1..)
        .zip(region.vertices())
        .map(|(number, vertex)| {
            let theta = vertex.point().coordinates();
            let cell =
                |axis: usize| said(facts, value(&theta[axis], styles[axis].significant(), Rounding::Nearest));
            let active = vertex.active().iter().map(|&index| bound(facts, index));
            vec![number.to_string(), cell(0), cell(1), said(facts, Value::listed(active))]
        })
        .collect();
    let heads = [
        facts.say(&text!("parameter-plane.vertices")),
        theta(facts, 0),
        theta(facts, 1),
        facts.say(&text!("vertices.active")),
    ];
    table(&heads, &rows)
}

/// The half-plane with an index.
fn bound(facts: &Facts<'_>, index: usize) -> Message {
    crate::questions::wording::bound(facts.fit.fps.name(index), facts.problem)
}

/// A value by itself.
fn said(facts: &Facts<'_>, value: Value) -> String {
    facts.say(&text!("wording.sentences", sentences: value))
}

/// A measured number as it was written, when its decimal is short.
fn number(value: &Rational) -> Value {
    let decimal = match value.exact_decimal(READING_DIGITS) {
        Some(exact) => exact.to_string(),
        None => value.to_decimal(READING_DIGITS, Rounding::Nearest),
    };
    Value::number(with_minus(&decimal))
}

fn readings(facts: &Facts<'_>) -> String {
    let names = facts.names();
    let column = |wanted: &str| {
        let found = names.iter().find(|(name, _)| *name == wanted);
        crate::texts::escaped(found.map_or("", |(_, column)| column))
    };
    let regressors: &[&str] = if facts.is_line() { &["x"] } else { &["u", "v"] };
    let mut heads = vec![facts.say(&text!("readings.row"))];
    heads.extend(regressors.iter().map(|name| column(name)));
    heads.extend([column("y"), facts.say(&text!("summary.lower")), facts.say(&text!("summary.upper"))]);
    let row = |reading: &Measurement| {
        let mut cells = vec![reading.row.to_string()];
        cells.extend(reading.regressor.iter().take(regressors.len()).map(|x| said(facts, number(x))));
        let ends = [reading.value().map(|y| y.into_owned()), reading.lower(), reading.upper()];
        cells.extend(ends.map(|end| end.map_or_else(|| "–".to_owned(), |end| said(facts, number(&end)))));
        cells
    };
    let rows: Vec<Vec<String>> = facts.problem.measurements.kept().iter().map(row).collect();
    table(&heads, &rows)
}

fn questions(facts: &Facts<'_>) -> String {
    let item = |(question, answer): (&Message, &Message)| {
        format!(
            "<li><details><summary>{}</summary><p>{}</p></details></li>",
            facts.say(question),
            facts.say(answer)
        )
    };
    let items: String = facts.document.questions().map(item).collect();
    format!("<ol>{items}</ol>")
}
