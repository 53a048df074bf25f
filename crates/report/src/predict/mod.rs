//! The report of predictions: the line at an x, a further reading there, and the x that a reading may come from.

mod csv;
mod json;
#[cfg(feature = "files")]
mod proof;

use boundfit_estimation::{Fit, Law, Model, Problem};
use boundfit_exact::english::counted;
use boundfit_exact::{Interval, Rational, Rounding};
use boundfit_geometry::Support;
use boundfit_questions::{FurtherError, NoFurtherError, PossibleEnd, PossibleX, Predictor};

use crate::document::{Block, Document, Inline, Operator, Symbol, Table, Text};
use crate::fit::{empty_blocks, fit_facts};
use crate::formula::{bounded_error, pair, products};
use crate::origin::Origin;
use crate::scale::{Scale, scales};
use crate::style::Style;

pub use csv::write_prediction_csv;
pub use json::write_prediction_json;
#[cfg(feature = "files")]
pub use proof::prediction_proof;
#[cfg(feature = "files")]
pub(crate) use proof::proved_forms;

/// Values that are asked about, which may be more than are to be in memory: each time that they are asked for they
/// come anew. The values are x and 1 of a line, both regressors of a model with two, y and 0 of a reading.
pub struct AskedValues<'a> {
    /// The number of values.
    pub count: usize,
    /// The values.
    pub values: &'a (dyn Fn() -> Box<dyn Iterator<Item = [Rational; 2]> + 'a> + 'a),
}

/// The material of a report of predictions.
pub struct Prediction<'a> {
    /// The readings.
    pub problem: &'a Problem,
    /// The fit of the readings.
    pub fit: &'a Fit,
    /// The source of the readings.
    pub origin: Origin<'a>,
    /// The known bound on the error of a further reading.
    pub error: Result<FurtherError, NoFurtherError>,
    /// The law by which that was given, where it is not that of the readings.
    pub given: Option<Law>,
    /// The values at which the line is asked for.
    pub at: AskedValues<'a>,
    /// The readings whose origin is asked for.
    pub from: AskedValues<'a>,
}

impl Prediction<'_> {
    pub(crate) fn is_line(&self) -> bool {
        matches!(self.problem.measurements.model(), Model::Line { .. })
    }

    fn x_origin(&self) -> &Rational {
        &self.problem.measurements.line_form().x_origin
    }

    pub(crate) fn predictor(&self) -> Option<Predictor<'_>> {
        Predictor::new(self.fit.fps.polyhedron())
    }

    /// The form whose values are asked for: x is counted from the origin of the fit.
    fn form(&self, [first, second]: &[Rational; 2]) -> [Rational; 2] {
        let first = if self.is_line() { first - self.x_origin() } else { first.clone() };
        [first, second.clone()]
    }

    /// The values of the model at such a form, and where a further reading lies there.
    pub(crate) fn at(&self, predictor: &Predictor, form: &[Rational; 2]) -> (Interval, Option<Interval>) {
        let line = if self.is_line() { predictor.line(&form[0]) } else { predictor.form(form) };
        let reading = self.error.as_ref().ok().and_then(|error| error.around(&line, &form[0]));
        (line, reading)
    }

    /// Returns the x that readings may come from, by y, with x as the user counts it.
    fn sources<'b>(&'b self, predictor: &'b Predictor) -> impl Fn(&Rational) -> Vec<PossibleX> + 'b {
        let of = self.error.as_ref().ok().map(|error| predictor.sources_of_many(error));
        let moved =
            |end: Option<PossibleEnd>| end.map(|end| PossibleEnd { x: end.x + self.x_origin(), ..end });
        move |y| {
            let found = of.as_ref().map(|of| of(y)).unwrap_or_default();
            found
                .into_iter()
                .map(|own| PossibleX { lower: moved(own.lower), upper: moved(own.upper) })
                .collect()
        }
    }

    /// Returns the proof of an end of the line's interval at x.
    fn why(&self, predictor: &Predictor, end: &PossibleEnd) -> Support {
        let form = self.form(&[end.x.clone(), Rational::one()]);
        let [lower, upper] = predictor.ends(&form);
        if end.by_upper { upper } else { lower }
    }

    fn name(&self, index: usize) -> String {
        self.fit.fps.name(index).to_string()
    }
}

/// The report of predictions, with the readings that prove each end if these are wanted.
pub fn prediction_document(prediction: &Prediction, has_proofs: bool, style: &Style) -> Document<'static> {
    let Prediction { problem, fit, origin, .. } = prediction;
    let mut facts = fit_facts(problem, fit, origin, style);
    facts.rows.push(("further".into(), further(prediction, style)));
    let mut blocks = vec![Block::Title("Prediction".into()), Block::Facts(facts)];
    match prediction.predictor() {
        None => {
            blocks.extend(empty_blocks(problem, fit, style));
            blocks.push(Block::Paragraph("Nothing can be predicted from a set without a point.".into()));
        }
        Some(predictor) => {
            blocks.extend(values(prediction, &predictor, style));
            blocks.extend(sources(prediction, &predictor, style));
            if has_proofs {
                blocks.extend(proofs(prediction, &predictor, style));
            }
        }
    }
    Document::new(blocks)
}

/// The known bound on the error of a further reading.
fn further(prediction: &Prediction, style: &Style) -> Text {
    let law = prediction.given.as_ref().or_else(|| prediction.problem.measurements.law());
    let what = match (&prediction.error, law) {
        (Err(reason), _) => return Text::from(format!("not predicted: {reason}")),
        (Ok(error), law) => match (error.uniform(), law) {
            (Some(epsilon), _) => known_error(epsilon, prediction.problem, prediction.given.is_some(), style),
            (None, Some(law)) => {
                let [y, words] = prediction.problem.measurements.law_in_names(law);
                match law.is_asymmetric() {
                    true => Text::new().given(&y).words(" ").given(&words),
                    false => bounded_error(&prediction.problem.measurements).given(&words),
                }
            }
            (None, None) => Text::new(),
        },
    };
    let given = prediction.given.is_some();
    Text::from("the error of a further reading: ").then(what).words(if given { ", as given" } else { "" })
}

/// The bound on the error of a further reading, given or that of the readings: nobody wrote a multiple of eps_min down.
pub(crate) fn known_error(epsilon: &Rational, problem: &Problem, is_given: bool, style: &Style) -> Text {
    let is_written = is_given || problem.measurements.multiple_of_least().is_none();
    let number = if is_written { style.given(epsilon) } else { Text::new().number(style.upper(epsilon)) };
    bounded_error(&problem.measurements).then(number)
}

/// An x, or both regressors.
fn asked(prediction: &Prediction, [first, second]: &[Rational; 2], style: &Style) -> Text {
    match prediction.is_line() {
        true => style.given(first),
        false => pair(style.given(first), style.given(second)),
    }
}

/// The table of the line's values and of further readings.
fn values(prediction: &Prediction, predictor: &Predictor, style: &Style) -> Vec<Block<'static>> {
    let AskedValues { count, values } = prediction.at;
    if count == 0 {
        return Vec::new();
    }
    let interval = |interval: &Interval| style.resolving(interval).interval(interval);
    let row = |value: [Rational; 2]| {
        let (line, reading) = prediction.at(predictor, &prediction.form(&value));
        let reading = reading.map_or("-".into(), |reading| interval(&reading));
        vec![asked(prediction, &value, style), interval(&line), reading]
    };
    let rows = values().take(Document::MOST_LISTED).map(row).collect();
    let (title, what) = match prediction.is_line() {
        true => ("The line, and a further reading", "line"),
        false => ("The model, and a further reading", "model"),
    };
    let table = Table::new(["at", what, "a further reading"], rows);
    let mut blocks = vec![Block::Title(title.into()), Block::Table(table)];
    blocks.extend(more(count, "value", "values"));
    blocks
}

/// The table of where readings come from.
fn sources(prediction: &Prediction, predictor: &Predictor, style: &Style) -> Vec<Block<'static>> {
    let AskedValues { count, values } = prediction.from;
    if count == 0 {
        return Vec::new();
    }
    let of = prediction.sources(predictor);
    let row = |[y, _]: [Rational; 2]| {
        let found = of(&y);
        let text = match found.as_slice() {
            [] => "none: no line comes near enough".into(),
            found => {
                let or = Inline::Words(" or ".to_owned());
                Text::joined(found.iter().map(|own| possible(own, style)), &or)
            }
        };
        vec![style.given(&y), text]
    };
    let rows = values().take(Document::MOST_LISTED).map(row).collect();
    let title = Block::Title("The x that a reading may come from".into());
    let mut blocks = vec![title, Block::Table(Table::new(["reading", "x"], rows))];
    blocks.extend(more(count, "reading", "readings"));
    blocks
}

/// Returns the note that there are more entries than are listed.
fn more(count: usize, one: &str, several: &str) -> Option<Block<'static>> {
    let more = count.checked_sub(Document::MOST_LISTED).filter(|more| *more > 0)?;
    let more = counted(more, one, several);
    Some(Block::Paragraph(format!("And {more} more, which CSV and JSON have.").into()))
}

/// The x between both ends, whether these belong to it or not.
fn between(PossibleX { lower, upper }: &PossibleX) -> Option<Interval> {
    let [lower, upper] = [lower, upper].map(|end| end.as_ref().map(|end| end.x.clone()));
    Interval::new(lower.into(), upper.into())
}

/// An interval of x, with round brackets where an end does not belong to it.
fn possible(own: &PossibleX, style: &Style) -> Text {
    let Some(interval) = between(own) else { return Text::new() };
    let PossibleX { lower, upper } = own;
    let style = style.resolving(&interval);
    if let (Some(one), Some(other)) = (lower, upper)
        && one.x == other.x
    {
        return style.interval(&interval);
    }
    let text = match lower {
        None => Text::new().mark("(").mark("-").symbol(Symbol::Infinity),
        Some(end) => Text::new().mark(if end.included { "[" } else { "(" }).number(style.lower(&end.x)),
    };
    let text = text.mark(", ");
    match upper {
        None => text.symbol(Symbol::Infinity).mark(")"),
        Some(end) => text.number(style.upper(&end.x)).mark(if end.included { "]" } else { ")" }),
    }
}

/// The readings behind each end of the line's intervals, and behind the x where readings end.
fn proofs(prediction: &Prediction, predictor: &Predictor, style: &Style) -> Vec<Block<'static>> {
    let (pui, fps) = (prediction.fit.pui_intervals(), prediction.fit.fps.polyhedron());
    let scales = scales(style, pui.as_ref(), &[], &[], || fps.homogeneous_vertices());
    let mut rows: Vec<Vec<Text>> = Vec::new();
    for value in (prediction.at.values)().take(Document::MOST_LISTED) {
        let ends = predictor.ends(&prediction.form(&value));
        for (relation, support) in [Symbol::AtLeast, Symbol::AtMost].into_iter().zip(ends) {
            let place = asked(prediction, &value, style);
            rows.push(proof(prediction, place, relation, &support, &scales, style));
        }
    }
    let of = prediction.sources(predictor);
    for [y, _] in (prediction.from.values)().take(Document::MOST_LISTED) {
        for own in of(&y) {
            let own_style = between(&own).map_or(*style, |interval| style.resolving(&interval));
            for (end, outward) in [(own.lower, Rounding::Down), (own.upper, Rounding::Up)] {
                let Some(end) = end else { continue };
                let relation = if end.by_upper { Symbol::AtMost } else { Symbol::AtLeast };
                let place = place(prediction, predictor, &end, outward, &own_style);
                let support = prediction.why(predictor, &end);
                let row = proof(prediction, place, relation, &support, &scales, style);
                // Two intervals may end at one x.
                if !rows.contains(&row) {
                    rows.push(row);
                }
            }
        }
    }
    let header = Text::from("multiplier").operator(Operator::Times).words("(row and bound)");
    let title = match prediction.is_line() {
        true => "Proof of each end of the line",
        false => "Proof of each end of the model",
    };
    let reached = if style.exact { "reached by" } else { "reached near" };
    let table = Table::new([Text::new(), reached.into(), header], rows);
    vec![Block::Title(title.into()), Block::Table(table)]
}

/// The x of an end as its interval shows it, if what is proved at the end is true of the rounded x, too; else the exact one.
fn place(
    prediction: &Prediction,
    predictor: &Predictor,
    end: &PossibleEnd,
    outward: Rounding,
    style: &Style,
) -> Text {
    let line = |x: &Rational| predictor.line(&(x - prediction.x_origin()));
    let rounded = end.x.rounded(style.significant(), style.directed(outward));
    let (exact, nearby) = (line(&end.x), line(&rounded));
    let is_true = match end.by_upper {
        true => nearby.upper().value().zip(exact.upper().value()).is_some_and(|(one, other)| one <= other),
        false => nearby.lower().value().zip(exact.lower().value()).is_some_and(|(one, other)| one >= other),
    };
    match outward {
        _ if style.exact || !is_true => style.given(&end.x),
        Rounding::Down => Text::new().number(style.lower(&end.x)),
        _ => Text::new().number(style.upper(&end.x)),
    }
}

/// A row of the table of proofs: what is proved at a place, which parameters reach it, and by which rows.
fn proof(
    prediction: &Prediction,
    place: Text,
    relation: Symbol,
    support: &Support,
    scales: &[Scale; 2],
    style: &Style,
) -> Vec<Text> {
    let label = Text::from("at ").then(place).mark(" ").symbol(relation).mark(" ");
    match support {
        Support::Bounded { proof, .. } => {
            let label = match relation {
                Symbol::AtLeast => label.number(style.lower(&-&proof.value)),
                _ => label.number(style.upper(&proof.value)),
            };
            let [theta1, theta2] = proof.attained_at.coordinates();
            let multipliers =
                proof.multipliers.iter().map(|m| (style.proof(&m.value), prediction.name(m.index)));
            vec![label, pair(scales[0].value(&theta1), scales[1].value(&theta2)), products(multipliers)]
        }
        Support::Unbounded(proof) => {
            let label = if relation == Symbol::AtLeast { label.mark("-") } else { label };
            let along = pair(proof.ray.dx(), proof.ray.dy());
            vec![label.symbol(Symbol::Infinity), Text::from("without end along ").then(along), Text::new()]
        }
        // A set without a point predicts nothing.
        Support::Empty(_) => vec![label, Text::new(), Text::new()],
    }
}
