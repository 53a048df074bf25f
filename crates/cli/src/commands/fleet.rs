//! `boundfit fit --by`: every group of rows on its own.

use std::io::{self, IsTerminal, Write};
use std::ops::Range;

use boundfit_estimation::{Fleet, GroupFit, Question};
use boundfit_exact::{Foreign, Work};
use boundfit_formats::{ColumnSelector, ScanOptions};
use boundfit_report::{
    FleetCsv, FleetSummary, FleetTable, GroupCells, GroupReport, Style, TableJson, table_line,
    write_group_json,
};

use crate::CommandResult;
use crate::arguments::{DataArguments, FitArguments, ReportFormat, assumption};
use crate::exit::{Exit, Failure};
use crate::input;
use crate::output::{Guard, Output, Stop};
use crate::progress::while_working;
use crate::work::{refuse_long, times};

/// Reads the data, then fits group after group and writes what is ready.
pub(crate) fn run(
    arguments: &FitArguments,
    by: &ColumnSelector,
    format: ReportFormat,
    guard: &Guard,
) -> CommandResult {
    let write_groups = match format {
        ReportFormat::Text => Job::write_text,
        ReportFormat::Json => Job::write_json,
        ReportFormat::Csv => Job::write_csv,
        _ => return Err(Failure::Usage("'--by' writes text, json or csv".to_owned())),
    };
    let (asked, fleet) = read(&arguments.data, by)?;
    if format == ReportFormat::Csv {
        input::say_table(arguments.data.file_name(), fleet.table());
    }
    let job = Job { fleet: &fleet, asked: &asked, style: arguments.output.style() };
    let mut output = Output::open(arguments.output.file.output.as_deref(), guard)?;
    let mut summary = FleetSummary::default();
    let mut write = || write_groups(&job, &mut output, &mut summary);
    // Lines that scroll by on a terminal are progress enough.
    let is_watched = arguments.output.file.output.is_none() && io::stdout().is_terminal();
    let written = if is_watched { write() } else { while_working("fitting", write) };
    match written {
        Ok(()) => {
            output.finish()?;
            if format != ReportFormat::Text {
                // The answer is written, whether or not somebody reads the summary.
                let _ = io::stderr().write_all((summary.to_text() + &assumption(&asked)).as_bytes());
            }
        }
        Err(Stop::Closed) => {}
        Err(Stop::Failed(failure)) => return Err(failure),
    }
    Ok(if summary.has_empty() { Exit::Empty } else { Exit::Answer })
}

/// Reads the groups that a column makes, whose numbers are not too long for a fit of each.
pub(super) fn read(arguments: &DataArguments, by: &ColumnSelector) -> Result<(Question, Fleet), Failure> {
    let data = arguments.open();
    let asked = data.asked()?;
    let (source, options) = data.scan()?;
    let options = ScanOptions { hash: false, list_rows: false, ..options };
    let fleet = Fleet::read(source, &asked.columns, by, options).map_err(Failure::refused)?;
    refuse_long_groups(arguments, &asked, &fleet)?;
    Ok((asked, fleet))
}

/// Refuses groups whose numbers are long. A multiple of the least bound is not looked for: it is work itself.
fn refuse_long_groups(arguments: &DataArguments, asked: &Question, fleet: &Fleet) -> Result<(), Failure> {
    if !asked.has_long_bound() && !fleet.has_fractions() {
        return Ok(());
    }
    let (file, limits) = (arguments.file_name(), &arguments.table.limits);
    refuse_long(file, &asked.work_of_every(fleet.readings()), times::FIT, limits)?;
    let mut work = Work::default();
    (0..fleet.len()).for_each(|group| work.append(asked.stated_problem(fleet.measurements(group)).work(&[])));
    refuse_long(file, &work, times::FIT, limits)
}

/// What is to be fitted and how it is shown.
struct Job<'a> {
    fleet: &'a Fleet,
    asked: &'a Question,
    style: Style,
}

impl Job<'_> {
    fn write_json(&self, output: &mut Output, whole: &mut FleetSummary) -> Result<(), Stop> {
        let table = self.fleet.table().map(TableJson::new);
        let table = table.as_ref();
        let lines = |groups| {
            let mut lines = Vec::new();
            let summary =
                self.each_whole(groups, |group| write_group_json(&mut lines, &group, table, &self.style));
            (lines, summary)
        };
        self.fleet.in_order(lines, |(lines, summary)| {
            whole.append(summary);
            output.write(&lines)
        })
    }

    fn write_csv(&self, output: &mut Output, whole: &mut FleetSummary) -> Result<(), Stop> {
        let mut header = FleetCsv::new();
        header.header(self.fleet.is_bounded_per_row());
        output.write(&header.into_bytes())?;
        let rows = |groups| {
            let mut rows = FleetCsv::new();
            let summary = self.each(groups, |key, group| rows.group(key, group, &self.style));
            (rows.into_bytes(), summary)
        };
        self.fleet.in_order(rows, |(rows, summary)| {
            whole.append(summary);
            output.write(&rows)
        })
    }

    fn write_text(&self, output: &mut Output, whole: &mut FleetSummary) -> Result<(), Stop> {
        let mut table = FleetTable::new(self.fleet.is_bounded_per_row());
        let lines = |groups| {
            let mut lines = Vec::new();
            let summary = self.each(groups, |key, group| {
                lines.push(GroupCells::new(key, group, &self.style));
            });
            (lines, summary)
        };
        self.fleet.in_order(lines, |(lines, summary)| {
            whole.append(summary);
            let mut text = String::new();
            lines.into_iter().for_each(|cells| table.push(cells, &mut text));
            output.write(text.as_bytes())
        })?;
        let mut text = String::new();
        table.finish(&mut text);
        let summary = whole.to_text() + &table_line(self.fleet.table()) + &assumption(self.asked);
        output.write(format!("{text}\n{summary}").as_bytes())
    }

    /// Fits groups and shows each as a line.
    fn each(&self, groups: Range<usize>, mut show: impl FnMut(Foreign<&str>, &GroupFit)) -> FleetSummary {
        let mut summary = FleetSummary::default();
        for group in groups {
            let line = self.asked.of_group(self.fleet, group);
            summary.add(self.fleet.key(group), &line);
            show(self.fleet.key(group), &line);
        }
        summary
    }

    /// Fits groups and shows all of each.
    fn each_whole(&self, groups: Range<usize>, mut show: impl FnMut(GroupReport<'_>)) -> FleetSummary {
        let mut summary = FleetSummary::default();
        for group in groups {
            let problem = self.asked.of_measurements(self.fleet.measurements(group));
            let fit = problem.fit();
            let line = GroupFit::of(&problem, &fit);
            summary.add(self.fleet.key(group), &line);
            show(GroupReport { key: self.fleet.key(group), problem: &problem, fit: &fit, line: &line });
        }
        summary
    }
}
