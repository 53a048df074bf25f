//! The statuses of readings as a report.

mod csv;
mod json;
#[cfg(feature = "files")]
mod proof;
mod repair;

pub use csv::StatusCsv;
pub use json::StatusJson;
#[cfg(feature = "files")]
pub use proof::status_proof;

use boundfit_estimation::{Fit, Problem};
use boundfit_exact::Foreign;
use boundfit_exact::english::counted;
use boundfit_questions::{Judged, NoRepair, Ranking, Repair, Standing, Status};

use crate::document::{Block, Document, Facts, Table, Text};
use crate::fit::fit_facts;
use crate::origin::Origin;
use crate::style::Style;

/// The material of a report of statuses.
#[derive(Debug, Clone)]
pub struct StatusReport<'a> {
    /// The problem.
    pub problem: &'a Problem,
    /// The set of all readings.
    pub fit: &'a Fit,
    /// The readings, each against the set of all and of the others.
    pub ranking: Ranking,
    /// Further readings.
    pub new: Option<NewReadings<'a>>,
    /// The least total widening, where it is asked for.
    pub repair: Option<Result<Repair, NoRepair>>,
}

/// Readings of a second table, judged against the set as it is.
#[derive(Debug, Clone)]
pub struct NewReadings<'a> {
    /// The file, in the words of the user; `None` for standard input.
    pub file: Option<Foreign<&'a str>>,
    /// These readings: both statuses are the one against the set.
    pub ranking: Ranking,
}

/// The report of statuses: those first that matter most, then a legend of the words used.
pub fn status_document(report: StatusReport, origin: &Origin, style: &Style) -> Document<'static> {
    let StatusReport { problem, fit, ranking, new, repair } = report;
    let mut blocks = vec![
        Block::Title("Statuses of readings".into()),
        Block::Facts(fit_facts(problem, fit, origin, style)),
    ];
    let mut used: Vec<Status> = Vec::new();
    blocks.extend(of_all(problem, fit, &ranking).into_iter().map(|line| Block::Paragraph(line.into())));
    blocks.extend(table(ranking, true, &mut used, style));
    blocks.extend(repair.iter().flat_map(|repair| repair::blocks(repair, style)));
    if let Some(NewReadings { file, ranking }) = new {
        let file = file.map_or_else(|| Text::from("standard input"), |file| Text::new().given(file));
        blocks.push(Block::Title(Text::from("Further readings, ").then(file)));
        blocks.push(Block::Paragraph(of_new(fit, &ranking).into()));
        blocks.extend(table(ranking, false, &mut used, style));
    }
    used.sort_unstable();
    used.dedup();
    if used.is_empty() {
        return Document::new(blocks);
    }
    blocks.push(Block::Facts(Facts { width: 14, rows: legend(&used) }));
    Document::new(blocks)
}

/// The summary of the readings of the set.
fn of_all(problem: &Problem, fit: &Fit, ranking: &Ranking) -> Vec<String> {
    let readings = counted(ranking.count(), "reading", "readings");
    if let Some(contradiction) = fit.contradiction(problem.measurements.error_bound()) {
        let names = contradiction.iter().map(|(name, _)| name.to_string());
        let verb = if names.len() == 1 { "cannot hold" } else { "contradict each other" };
        let mending = match ranking.count_without(Some(Status::Outlier)) {
            0 => "No single reading is an outlier: without any one of them the set stays empty.",
            1 => "Without the reading below the set is not empty; no other reading has this effect.",
            _ => "Without any one of the readings below the set is not empty; no other has this effect.",
        };
        return vec![
            format!("No theta meets every bound. These {verb}: {}.", names.collect::<Vec<_>>().join(", ")),
            mending.to_owned(),
        ];
    }
    let all = counts(|status| ranking.count_of_all(status));
    let boundary = ranking.boundary();
    let touching = ranking.count_of_all(Some(Status::Boundary));
    let which = match touching {
        0 => "No reading touches it.".to_owned(),
        1 => format!("Row {} touches it.", boundary[0]),
        _ => {
            let rows = boundary.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
            let rest = match touching - boundary.len() {
                0 => String::new(),
                more => format!(" and {more} more"),
            };
            format!("On its boundary: rows {rows}{rest}.")
        }
    };
    let others = match ranking.count() - touching {
        0 => "",
        1 => " Removing the other reading leaves the set unchanged.",
        _ => " Removing all other readings leaves the set unchanged.",
    };
    vec![
        format!("{readings} against the set of all: {all}. {which}{others}"),
        format!("Each against the set of the others: {}.", counts(|status| ranking.count_without(status))),
    ]
}

/// The summary of further readings.
fn of_new(fit: &Fit, ranking: &Ranking) -> String {
    let readings = counted(ranking.count(), "reading", "readings");
    match fit.is_empty() {
        true => format!("{readings}; the set is empty, and nothing can be said of them."),
        false => format!(
            "{readings} against the set as it is: {}.",
            counts(|status| ranking.count_without(status))
        ),
    }
}

/// The counts of each status, worst status first: `4 outer, 19 inner`.
fn counts(count: impl Fn(Option<Status>) -> usize) -> String {
    let of_status = Status::ALL.into_iter().rev().map(|status| (count(Some(status)), status.name()));
    let words = of_status.filter(|(count, _)| *count > 0);
    let words: Vec<String> = words.map(|(count, name)| format!("{count} {}", plural(name, count))).collect();
    if words.is_empty() { "none".to_owned() } else { words.join(", ") }
}

fn plural(name: &str, count: usize) -> String {
    match name {
        "outlier" if count != 1 => "outliers".to_owned(),
        name => name.to_owned(),
    }
}

/// The readings that matter most, and how many more there are.
fn table(ranking: Ranking, is_with: bool, used: &mut Vec<Status>, style: &Style) -> Vec<Block<'static>> {
    let without = |status| ranking.count_without(status);
    let all = |status| ranking.count_of_all(status);
    used.extend(Status::ALL.into_iter().filter(|&status| without(Some(status)) + all(Some(status)) > 0));
    let whole = ranking.clone();
    // Where nothing is left either way, there is nothing to be said of a reading.
    let mut listed = ranking.into_listed();
    listed.retain(|own| own.status.without.is_some());
    if listed.is_empty() {
        return Vec::new();
    }
    let more = whole.count() - whole.count_without(None) - listed.len();
    let has_set = is_with && all_have_set(&listed);
    let mut header = vec!["row"];
    if has_set {
        header.extend(["with it", "leverage", "residual"]);
    }
    header.extend([if is_with { "without it" } else { "status" }, "leverage", "residual"]);
    let row = |Judged { status, .. }: &Judged| {
        let mut cells = vec![Text::new().number(status.row)];
        if has_set {
            cells.extend(cells_of(status.all.as_ref(), style));
        }
        cells.extend(cells_of(status.without.as_ref(), style));
        cells
    };
    let rows: Vec<Vec<Text>> = listed.iter().map(row).collect();
    let mut blocks = vec![Block::Table(Table::new(header, rows))];
    if more > 0 {
        let listed_with = |status: Option<Status>| {
            listed.iter().filter(|own| own.status.without.as_ref().map(|own| own.status) == status).count()
        };
        let rest = counts(|status| whole.count_without(status) - listed_with(status));
        blocks.push(Block::Paragraph(format!("{more} more: {rest} (CSV and JSON list every one).").into()));
    }
    blocks
}

fn all_have_set(listed: &[Judged]) -> bool {
    listed.iter().all(|own| own.status.all.is_some())
}

fn cells_of(standing: Option<&Standing>, style: &Style) -> [Text; 3] {
    let Some(Standing { leverage, residual, status }) = standing else {
        return ["-", "-", "-"].map(Text::from);
    };
    let number = |number: &Option<_>| {
        number.as_ref().map_or_else(|| Text::from("-"), |number| Text::new().number(style.nearest(number)))
    };
    [status.name().into(), number(leverage), number(residual)]
}

/// The meaning of the words.
fn legend(used: &[Status]) -> Vec<(Text, Text)> {
    let meaning = |status: &Status| match status {
        Status::Inner => "|r| < 1 - l: changes nothing, with room to spare",
        Status::Boundary => "|r| = 1 - l: changes nothing, and a bound of it is met with equality",
        Status::Outer => "1 - l < |r| <= 1 + l: cuts the set",
        Status::StrictlyOuter => "outer with l > 1: a reading with such a bound cuts wherever it falls",
        Status::Outlier => "|r| > 1 + l: leaves nothing",
    };
    let words = used.iter().map(|status| (status.name().into(), meaning(status).into()));
    let numbers = [
        ("leverage l", "half the range of the model's values over the set, over half the reading's width"),
        ("residual r", "the reading's middle less that of these values, over the same"),
        ("-", "one bound, no width, or values without an end: judged by the two intervals alone"),
    ];
    let numbers = numbers.into_iter().map(|(word, meaning)| (word.into(), meaning.into()));
    numbers.chain(words).collect()
}
