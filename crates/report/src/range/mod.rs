//! The linear range as a report.

mod csv;
mod json;
#[cfg(feature = "files")]
mod proof;

pub(crate) use csv::exact;
pub use csv::range_csv;
pub use json::range_json;
#[cfg(feature = "files")]
pub use proof::range_proof;

use boundfit_estimation::{BoundName, Fit, Model, Problem};
use boundfit_exact::Rational;
use boundfit_exact::english::{counted, list_of};
use boundfit_questions::{Contradiction, LinearRange, Order, Run};

use crate::document::{Block, Document, Facts, Symbol, THETA, Table, Text};
use crate::fit::{fit_facts, times_what};
use crate::origin::Origin;
use crate::region::kind_text;
use crate::style::Style;

/// Runs that a sentence names.
const MOST_IN_SENTENCE: usize = 8;

/// The material of a report of the linear range.
#[derive(Debug, Clone)]
pub struct RangeReport<'a> {
    /// The readings.
    pub problem: &'a Problem,
    /// The fit of all readings at once.
    pub fit: &'a Fit,
    /// The order in which runs are taken.
    pub order: Order,
    /// The runs.
    pub range: &'a LinearRange,
    /// The readings of the longest run and their fit, if there is a run.
    pub longest: Option<(&'a Problem, &'a Fit)>,
}

impl<'a> RangeReport<'a> {
    /// The row of the reading at a position of the order.
    pub(crate) fn row(&self, position: usize) -> usize {
        self.problem.measurements.kept()[self.range.order[position]].row
    }

    /// x of the reading at a position, counted from its origin; `None` with two regressors.
    pub(crate) fn x(&self, position: usize) -> Option<&'a Rational> {
        match self.problem.measurements.model() {
            Model::Line { .. } => {
                Some(&self.problem.measurements.kept()[self.range.order[position]].regressor[0])
            }
            Model::TwoRegressors { .. } => None,
        }
    }

    /// The least and the largest x of a run, which are those of the data; `None` with two regressors.
    fn reach(&self, run: &Run) -> Option<[Rational; 2]> {
        let (least, most) = match self.order {
            Order::X => self.x(run.first).zip(self.x(run.last)),
            Order::Row => {
                let all = || (run.first..=run.last).filter_map(|position| self.x(position));
                all().min().zip(all().max())
            }
        }?;
        let origin = &self.problem.measurements.line_form().x_origin;
        Some([least + origin, most + origin])
    }

    /// The rows of a run where they follow each other in the file: `14..36`, `7`.
    fn consecutive_rows(&self, run: &Run) -> Option<String> {
        let rows = || (run.first..=run.last).map(|position| self.row(position));
        let (first, last) = rows().min().zip(rows().max())?;
        let are_consecutive = last + 1 - first == run.len();
        are_consecutive.then(|| if first == last { first.to_string() } else { format!("{first}..{last}") })
    }

    /// Returns whether runs are ranges of x.
    fn is_by_x(&self) -> bool {
        self.order == Order::X && self.x(0).is_some()
    }

    /// `x from 1.2 to 5: 23 readings, rows 14..36`, in the order of rows `rows 14..36: 23 readings, x from 1.2 to 5`.
    fn run_text(&self, run: &Run, style: &Style) -> Text {
        let readings = counted(run.len(), "reading", "readings");
        let reach = match (self.reach(run), self.problem.measurements.model()) {
            (Some([least, most]), Model::Line { x }) => {
                let from = Text::new().given(x.clone()).words(" from ").then(style.given(&least));
                Some(from.words(" to ").then(style.given(&most)))
            }
            _ => None,
        };
        let rows = |rows: String| format!("{} {rows}", if run.len() == 1 { "row" } else { "rows" });
        match (reach, self.is_by_x()) {
            (Some(reach), true) => {
                let text = reach.words(format!(": {readings}"));
                match self.consecutive_rows(run) {
                    Some(own) => text.words(format!(", {}", rows(own))),
                    None => text,
                }
            }
            (reach, _) => {
                let own = self.consecutive_rows(run).unwrap_or_default();
                let text = Text::from(format!("{}: {readings}", rows(own)));
                reach.into_iter().fold(text, |text, reach| text.words(", ").then(reach))
            }
        }
    }
}

/// The report: how many runs there are, each with what stops it, the longest, the widest and the fewest that have every reading.
pub fn range_document(report: &RangeReport<'_>, origin: &Origin, style: &Style) -> Document<'static> {
    let RangeReport { problem, fit, range, .. } = report;
    let mut blocks =
        vec![Block::Title("Linear range".into()), Block::Facts(fit_facts(problem, fit, origin, style))];
    blocks.push(Block::Paragraph(summary(report).into()));
    if !range.runs.is_empty() {
        blocks.push(Block::Table(table(report, style)));
    }
    let more = range.runs.len().saturating_sub(Document::MOST_LISTED);
    if more > 0 {
        blocks.push(Block::Paragraph(format!("{more} more: CSV and JSON have every one.").into()));
    }
    blocks.push(Block::Facts(Facts { width: 7, rows: choices(report, style) }));
    blocks.extend(alone(report).into_iter().map(|line| Block::Paragraph(line.into())));
    if let Some((own, fit)) = &report.longest {
        blocks.push(Block::Title("The longest run".into()));
        blocks.push(Block::Facts(Facts { width: 7, rows: longest(own, fit, style) }));
    }
    Document::new(blocks)
}

fn summary(report: &RangeReport<'_>) -> String {
    let RangeReport { range, order, .. } = report;
    let count = range.order.len();
    let readings = counted(count, "reading", "readings");
    let in_order = match order {
        Order::X => "of x",
        Order::Row => "of rows",
    };
    match range.runs.as_slice() {
        [] => match order {
            Order::X => "No reading fits, not even those of one x alone.".to_owned(),
            Order::Row => "No reading fits, not even alone.".to_owned(),
        },
        [_] if count == 1 => "The only reading fits: one run has it.".to_owned(),
        [only] if only.len() == count => format!("All {readings} together fit: one run has them all."),
        runs => {
            let runs = match runs.len() {
                1 => "1 run that fits and is as long as it can be".to_owned(),
                many => format!("{many} runs that fit and are as long as they can be"),
            };
            format!(
                "The {readings} together do not fit. In order {in_order} there {verb} {runs}.",
                verb = if range.runs.len() == 1 { "is" } else { "are" }
            )
        }
    }
}

/// A row for each run: where it is, and which bounds stand against another place at either end.
fn table(report: &RangeReport<'_>, style: &Style) -> Table {
    let runs: Vec<&Run> = report.range.runs.iter().take(Document::MOST_LISTED).collect();
    let reaches = report.x(0).is_some();
    let has_rows = runs.iter().any(|run| report.consecutive_rows(run).is_some());
    // The columns that name a run come first.
    let mut columns = vec!["readings"];
    let place = if report.is_by_x() { 0 } else { 1 };
    if reaches {
        columns.splice(place..place, ["x from", "to"]);
    }
    if has_rows {
        columns.insert(if report.is_by_x() { columns.len() } else { 0 }, "rows");
    }
    columns.extend(["not one before", "not one after"]);
    let row = |run: &&Run| -> Vec<Text> {
        let [from, to] =
            report.reach(run).map_or_else(Default::default, |ends| ends.map(|end| style.given(&end)));
        let why =
            |why: &Option<Contradiction>| -> Text { why.as_ref().map_or("-".to_owned(), rows_of).into() };
        let cell = |column: &&str| match *column {
            "x from" => from.clone(),
            "to" => to.clone(),
            "readings" => Text::new().number(run.len()),
            "rows" => report.consecutive_rows(run).unwrap_or_else(|| "-".to_owned()).into(),
            "not one before" => why(&run.before),
            _ => why(&run.after),
        };
        columns.iter().map(cell).collect()
    };
    Table::new(columns.clone(), runs.iter().map(row).collect())
}

/// `12, 15, 20`: short, since every run has two.
fn rows_of(contradiction: &Contradiction) -> String {
    let name =
        |(name, _): &(BoundName, _)| name.row().map_or_else(|| name.to_string(), |row| row.to_string());
    let mut names: Vec<String> = contradiction.terms.iter().map(name).collect();
    names.dedup();
    names.join(", ")
}

/// `12 upper, 15 lower, 20 upper`.
fn names(contradiction: &Contradiction) -> String {
    let names: Vec<String> =
        contradiction.terms.iter().map(|(name, _): &(BoundName, _)| name.to_string()).collect();
    names.join(", ")
}

/// The longest run, the widest one where that is another, the fewest that have every reading.
fn choices(report: &RangeReport<'_>, style: &Style) -> Vec<(Text, Text)> {
    let RangeReport { range, problem, .. } = report;
    let mut rows: Vec<(Text, Text)> = Vec::new();
    let Some(longest) = range.longest() else { return rows };
    rows.push(("longest".into(), report.run_text(longest, style)));
    let widest = range.widest(problem).filter(|_| report.is_by_x());
    if let Some(widest) = widest.filter(|widest| *widest != longest) {
        rows.push(("widest".into(), report.run_text(widest, style)));
    }
    let fewest = range.fewest();
    if range.runs.len() > 1 {
        let all = if range.alone.is_empty() { "every reading" } else { "every reading that fits alone" };
        let name = |run: &&Run| match (report.reach(run), report.is_by_x()) {
            (Some([least, most]), true) if least == most => style.given(&least).to_string(),
            (Some([least, most]), true) => format!("{} to {}", style.given(&least), style.given(&most)),
            _ => format!("{}..{}", report.row(run.first), report.row(run.last)),
        };
        let shown: Vec<String> = fewest.iter().take(MOST_IN_SENTENCE).map(name).collect();
        let named = list_of(shown.into_iter(), fewest.len().saturating_sub(MOST_IN_SENTENCE));
        let what = if report.is_by_x() { "x from" } else { "rows" };
        let runs = counted(fewest.len(), "run has", "runs have");
        rows.push(("fewest".into(), format!("{runs} {all}: {what} {named}").into()));
    }
    rows
}

/// The readings that are in no run.
fn alone(report: &RangeReport<'_>) -> Vec<String> {
    let alone = &report.range.alone;
    let line = |(position, contradiction): &(usize, Contradiction)| {
        let verb = if contradiction.terms.len() == 1 { "cannot hold" } else { "contradict each other" };
        format!("Row {} is in no run: {} {verb}.", report.row(*position), names(contradiction))
    };
    let mut lines: Vec<String> = alone.iter().take(Document::MOST_LISTED).map(line).collect();
    let more = alone.len().saturating_sub(Document::MOST_LISTED);
    if more > 0 {
        lines.push(format!("{more} more readings are in no run: JSON has every one."));
    }
    lines
}

/// The parameters of the longest run.
fn longest(own: &Problem, fit: &Fit, style: &Style) -> Vec<(Text, Text)> {
    let region = fit.fps.polyhedron().region();
    let mut rows: Vec<(Text, Text)> =
        vec![("set".into(), kind_text(region.kind(), region.vertices().len()).into())];
    let pui = fit.pui_intervals();
    let styles = style.resolving_both(pui.as_ref());
    for (axis, interval) in pui.iter().flatten().enumerate() {
        let is_single = interval.ends().is_some_and(|(lower, upper)| lower == upper);
        let range = styles[axis].interval(interval);
        let range = if is_single { range } else { Text::from("in ").then(range) };
        let line = match fit.central.as_ref().filter(|_| !is_single) {
            Some(central) => range.words("; central ").number(styles[axis].nearest(&central.theta[axis])),
            None => range,
        };
        rows.push((THETA[axis].into(), line));
    }
    if let Some(minimax) = &fit.minimax {
        let least = Text::new().number(style.upper(&minimax.least));
        let least = least.words(times_what(own.measurements.error_bound()));
        rows.push((Symbol::LeastEpsilon.into(), least));
    }
    rows
}
