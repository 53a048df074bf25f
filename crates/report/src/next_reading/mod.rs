//! The report of the next reading: where it certainly makes the set smaller, and the best x of a range.

mod csv;
mod json;

use boundfit_estimation::{Fit, Model, Problem};
use boundfit_exact::{Integer, Rational};
use boundfit_questions::{Best, Goal, Next, NextReading};

use crate::document::{Block, Document, Inline, Operator, Symbol, THETA, Table, Text};
use crate::fit::{empty_blocks, fit_facts};
use crate::origin::Origin;
use crate::predict::known_error;
use crate::style::Style;

pub use csv::next_reading_csv;
pub use json::next_reading_json;

/// The material of a report of the next reading.
#[derive(Debug, Clone)]
pub struct NextReadingReport<'a> {
    /// The readings.
    pub problem: &'a Problem,
    /// The fit of the readings.
    pub fit: &'a Fit,
    /// The error bound of the next reading.
    pub epsilon: &'a Rational,
    /// `true` if the error bound was given, and is not that of the readings.
    pub is_epsilon_given: bool,
    /// `true` if the range of x was given, and is not that of the readings.
    pub is_range_given: bool,
    /// The answer; `None` where the set is empty.
    pub next: Option<&'a NextReading>,
}

/// The reason for a range that is not known.
const NO_RANGE: &str =
    "the range of the readings' x is not known, since not every reading is kept in memory: give one";

impl NextReadingReport<'_> {
    /// The name of x.
    fn x(&self) -> Text {
        match self.problem.measurements.model() {
            Model::Line { x } => Text::new().given(x.clone()),
            Model::TwoRegressors { .. } => Text::from("x"),
        }
    }

    /// The reason for a goal that is left out.
    fn too_long() -> String {
        format!("the set has more than {} vertices", Next::MOST_CORNERS)
    }
}

/// Writes the report: where a reading certainly makes the set smaller, and the best x of the range for each goal.
pub fn next_reading_document(
    report: &NextReadingReport<'_>,
    origin: &Origin,
    style: &Style,
) -> Document<'static> {
    let NextReadingReport { problem, fit, epsilon, is_epsilon_given, .. } = report;
    let mut facts = fit_facts(problem, fit, origin, style);
    let further = Text::from("the error of the next reading: ");
    let further = further.then(known_error(epsilon, problem, *is_epsilon_given, style));
    let further = further.words(if *is_epsilon_given { ", as given" } else { "" });
    facts.rows.push(("further".into(), further));
    let mut blocks = vec![Block::Title("Next reading".into()), Block::Facts(facts)];
    match report.next {
        None => {
            blocks.extend(empty_blocks(problem, fit, style));
            blocks.push(Block::Paragraph("No reading makes an empty set smaller.".into()));
        }
        Some(next) => {
            blocks.push(Block::Title("Where it certainly makes the set smaller".into()));
            blocks.push(Block::Paragraph(certainty(report, next, style)));
            blocks.extend(choice(report, next, style));
        }
    }
    Document::new(blocks)
}

/// Says at which x a reading certainly makes the set smaller.
fn certainty(report: &NextReadingReport, next: &NextReading, style: &Style) -> Text {
    let (x, epsilon) = (report.x(), &next.epsilon);
    let style = next.unsure.as_ref().map_or(*style, |unsure| style.resolving(unsure));
    let twice = Text::from("2 ").symbol(Symbol::Epsilon).operator(Operator::Equals);
    let twice = twice.then(style.given(&(epsilon + epsilon)));
    let certain = next.certain();
    let single = next.unsure.as_ref().and_then(|unsure| unsure.ends()).filter(|(from, to)| from == to);
    let surely = " certainly makes the set smaller, whatever it shows";
    match (certain.as_slice(), single) {
        ([], _) => Text::from("At every ")
            .then(x)
            .words(" the lines are at most ")
            .then(twice)
            .words(" apart: a reading may agree with all of them, and leave the set as it is."),
        ([[None, None]], _) => Text::from("A reading at any ").then(x).words(surely).words("."),
        (_, Some((only, _))) => Text::from("A reading at any ")
            .then(x)
            .words(" but ")
            .then(style.given(only))
            .words(surely)
            .words("."),
        (certain, None) => {
            let part = |[from, to]: &[Option<&Rational>; 2]| match (from, to) {
                (Some(from), _) => x.clone().mark(" > ").number(style.upper(from)),
                (None, to) => to.iter().fold(x.clone().mark(" < "), |text, to| text.number(style.lower(to))),
            };
            let parts = Text::joined(certain.iter().map(part), &Inline::Words(" or ".to_owned()));
            let text = Text::from("A reading at ").then(parts).words(surely);
            text.words(": the lines are more than ").then(twice).words(
                " apart there. Anywhere else it may agree with all of them, and leave the set as it is.",
            )
        }
    }
}

/// The best x of the range for each goal.
fn choice(report: &NextReadingReport, next: &NextReading, style: &Style) -> Vec<Block<'static>> {
    let Some([lower, upper]) = &next.within else {
        return vec![Block::Paragraph(format!("Where it is best is left open: {NO_RANGE}.").into())];
    };
    let title = Text::from("The best ").then(report.x()).words(" from ").then(style.given(lower));
    let title = title.words(" to ").then(style.given(upper));
    let title = title.words(if report.is_range_given { "" } else { ", the range of the readings" });
    let header = ["to make small", "now", "at worst", "at"];
    let rows = next.best.iter().map(|best| row(best, style)).collect();
    let mut blocks = vec![Block::Title(title), Block::Table(Table::new(header, rows))];
    let mut say = |words: String| blocks.push(Block::Paragraph(words.into()));
    if next.is_certain_within() == Some(false) {
        say("No single reading in this range is sure to make the set smaller.".to_owned());
    }
    if !next.too_long.is_empty() {
        say(format!("The area is left out: {}.", NextReadingReport::too_long()));
    }
    blocks
}

/// A goal: its value now, the largest value after a reading at the best x, and that x.
fn row(best: &Best, style: &Style) -> Vec<Text> {
    let goal = match best.goal {
        Goal::Theta1 => Text::from("length of ").symbol(THETA[0]),
        Goal::Theta2 => Text::from("length of ").symbol(THETA[1]),
        Goal::Area => Text::from("area"),
    };
    let size = |value: &Option<Rational>| match value {
        Some(value) => Text::new().number(style.upper(value)),
        None => Symbol::Infinity.into(),
    };
    let (worst, at) = match best.at.is_empty() {
        true => ("as now".into(), "-".into()),
        false => {
            let or = Inline::Words(" or ".to_owned());
            (size(&best.worst), Text::joined(best.at.iter().map(|x| style.given(x)), &or))
        }
    };
    vec![goal, size(&best.now), worst, at]
}

/// Returns whether a fraction has no more digits than reports write.
fn is_short(value: &Rational, style: &Style) -> bool {
    let longest = u32::try_from(style.longest_fraction).unwrap_or(u32::MAX);
    let longest = Integer::bits_of_power_of_ten(longest);
    value.numerator().bits() < longest && value.denominator().bits() < longest
}
