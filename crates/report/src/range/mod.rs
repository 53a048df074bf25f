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
use boundfit_exact::english::{counted, list};
use boundfit_questions::{Contradiction, LinearRange, Order, Run};

use crate::document::{Block, Document, Facts, Symbol, THETA, Table, Text};
use crate::fit::fit_facts;
use crate::origin::Origin;
use crate::region::kind_text;
use crate::style::Style;

/// Runs and readings that the text lists; JSON and CSV have all.
const MOST_LISTED: usize = 40;

/// What a report of the linear range is made of.
#[derive(Debug, Clone)]
pub struct RangeReport<'a> {
    /// The readings.
    pub problem: &'a Problem,
    /// Their fit, of all at once.
    pub fit: &'a Fit,
    /// In which order runs are taken.
    pub order: Order,
    /// The runs.
    pub range: &'a LinearRange,
    /// The readings of the longest run and their fit, if there is a run.
    pub longest: Option<(Problem, Fit)>,
}

impl<'a> RangeReport<'a> {
    /// The row of the reading at a position of the order.
    fn row(&self, position: usize) -> usize {
        self.problem.measurements.kept()[self.range.order[position]].row
    }

    /// x of the reading at a position; `None` with two regressors.
    fn x(&self, position: usize) -> Option<&'a Rational> {
        match self.problem.measurements.model() {
            Model::Line { .. } => {
                Some(&self.problem.measurements.kept()[self.range.order[position]].regressor[0])
            }
            Model::TwoRegressors { .. } => None,
        }
    }

    /// The least and the largest x of a run; `None` with two regressors.
    fn reach(&self, run: &Run) -> Option<[&'a Rational; 2]> {
        match self.order {
            Order::X => self.x(run.first).zip(self.x(run.last)).map(<[_; 2]>::from),
            Order::Row => {
                let all = || (run.first..=run.last).filter_map(|position| self.x(position));
                all().min().zip(all().max()).map(<[_; 2]>::from)
            }
        }
    }

    /// `rows 14..36: 23 readings, x from 1.2 to 5`.
    fn run_text(&self, run: &Run, style: &Style) -> Text {
        let (first, last) = (self.row(run.first), self.row(run.last));
        let rows = match first == last {
            true => format!("row {first}: 1 reading"),
            false => format!("rows {first}..{last}: {}", counted(run.len(), "reading", "readings")),
        };
        match (self.reach(run), self.problem.measurements.model()) {
            (Some([least, most]), Model::Line { x }) => {
                let reach = Text::from(rows).words(", ").given(x.clone()).words(" from ");
                reach.then(style.given(least)).words(" to ").then(style.given(most))
            }
            _ => rows.into(),
        }
    }
}

/// The report: how many runs there are, each with what stops it, the longest, the widest and the fewest that have every reading.
pub fn range_document(report: &RangeReport<'_>, origin: &Origin, style: &Style) -> Document {
    let RangeReport { problem, fit, range, .. } = report;
    let mut blocks =
        vec![Block::Title("Linear range".into()), Block::Facts(fit_facts(problem, fit, origin, style))];
    blocks.push(Block::Paragraph(summary(report).into()));
    if !range.runs.is_empty() {
        blocks.push(Block::Table(table(report, style)));
    }
    let more = range.runs.len().saturating_sub(MOST_LISTED);
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
    let (readings, order) = (
        counted(count, "reading", "readings"),
        match order {
            Order::X => "of x",
            Order::Row => "of rows",
        },
    );
    match range.runs.as_slice() {
        [] => "No reading fits, not even alone.".to_owned(),
        [only] if only.len() == count => format!("All {readings} together fit: one run has them all."),
        runs => {
            let runs = match runs.len() {
                1 => "1 run that fits and is as long as it can be".to_owned(),
                many => format!("{many} runs that fit and are as long as they can be"),
            };
            format!(
                "The {readings} together do not fit. In order {order} there {verb} {runs}.",
                verb = if range.runs.len() == 1 { "is" } else { "are" }
            )
        }
    }
}

/// A row for each run: where it is, and which bounds stand against another reading at either end.
fn table(report: &RangeReport<'_>, style: &Style) -> Table {
    let reaches = report.x(0).is_some();
    let mut header = vec!["rows", "readings"];
    if reaches {
        header.extend(["x from", "to"]);
    }
    header.extend(["not one before", "not one after"]);
    let row = |run: &Run| {
        let rows = format!("{}..{}", report.row(run.first), report.row(run.last));
        let mut cells = vec![Text::from(rows), Text::new().number(run.len())];
        if let Some(ends) = report.reach(run) {
            cells.extend(ends.map(|end| style.given(end)));
        }
        cells.extend(
            [&run.before, &run.after]
                .map(|why| Text::from(why.as_ref().map_or_else(|| "-".to_owned(), rows_of))),
        );
        cells
    };
    Table::new(header, report.range.runs.iter().take(MOST_LISTED).map(row).collect())
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
    let widest = range.widest(problem).filter(|_| report.order == Order::X && report.x(0).is_some());
    if let Some(widest) = widest.filter(|widest| *widest != longest) {
        rows.push(("widest".into(), report.run_text(widest, style)));
    }
    let fewest = range.fewest();
    if range.runs.len() > 1 {
        let all = if range.alone.is_empty() { "every reading" } else { "every reading that fits alone" };
        let shown = fewest.iter().take(MOST_LISTED);
        let named = list(shown.map(|run| format!("{}..{}", report.row(run.first), report.row(run.last))));
        let more = match fewest.len().saturating_sub(MOST_LISTED) {
            0 => String::new(),
            more => format!(" and {more} more"),
        };
        let runs = counted(fewest.len(), "run has", "runs have");
        rows.push(("fewest".into(), format!("{runs} {all}: rows {named}{more}").into()));
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
    let mut lines: Vec<String> = alone.iter().take(MOST_LISTED).map(line).collect();
    let more = alone.len().saturating_sub(MOST_LISTED);
    if more > 0 {
        lines.push(format!("{more} more readings are in no run: JSON has every one."));
    }
    lines
}

/// What the readings of the longest run say of the parameters.
fn longest(own: &Problem, fit: &Fit, style: &Style) -> Vec<(Text, Text)> {
    let region = fit.fps.polyhedron().region();
    let mut rows: Vec<(Text, Text)> =
        vec![("set".into(), kind_text(region.kind(), region.vertices().len()).into())];
    let pui = fit.pui_intervals();
    let styles = style.resolving_both(pui.as_ref());
    for (axis, interval) in pui.iter().flatten().enumerate() {
        let range = Text::from("in ").then(styles[axis].interval(interval));
        let line = match &fit.central {
            Some(central) => range.words("; central ").number(styles[axis].nearest(&central.theta[axis])),
            None => range,
        };
        rows.push((THETA[axis].into(), line));
    }
    if let Some(minimax) = &fit.minimax {
        let least = Text::new().number(style.upper(&minimax.least));
        let is_uniform = own.measurements.error_bound().is_uniform();
        let least = if is_uniform { least } else { least.words(" times the bounds") };
        rows.push((Symbol::LeastEpsilon.into(), least));
    }
    rows
}
