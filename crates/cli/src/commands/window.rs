//! `boundfit fit --window`: the last readings, again and again as the window moves on.

use std::io::{self, Write};

use boundfit_estimation::Problem;
use boundfit_questions::{Moved, Moving, Turn};
use boundfit_report::{
    FleetTable, Style, TableJson, WindowReport, WindowSummary, table_line, write_window_json,
};

use super::refuse_reductions;
use crate::CommandResult;
use crate::arguments::{FitArguments, ReportFormat};
use crate::exit::{Exit, Failure};
use crate::input;
use crate::output::{Guard, Output, Stop};
use crate::work::{refuse_long_problem, times};

/// Reads the data, then moves on and writes what is ready.
pub(crate) fn run(
    arguments: &FitArguments,
    moving: &Moving,
    format: ReportFormat,
    guard: &Guard,
) -> CommandResult {
    if !matches!(format, ReportFormat::Text | ReportFormat::Json | ReportFormat::Csv) {
        return Err(Failure::Usage("'--window' and '--window-x' write text, json or csv".to_owned()));
    }
    let data = arguments.data.open();
    let problem = data.whole_problem()?;
    refuse_reductions(&problem, arguments.data.file_name(), "windows are")?;
    refuse_long_problem(arguments.data.file_name(), &problem, times::RANGE, &arguments.data.table.limits)?;
    if format == ReportFormat::Csv {
        input::say_table(arguments.data.file_name(), problem.measurements.table());
    }
    let table = TableJson::of_measurements(&problem.measurements);
    let mut output = Output::open(arguments.output.file.output.as_deref(), guard)?;
    let mut job = Job {
        problem: &problem,
        taken_for: table.as_ref(),
        format,
        style: arguments.output.style(),
        summary: WindowSummary::default(),
        table: FleetTable::of_windows(),
        output: &mut output,
    };
    let written = job.header().and_then(|()| moving.each(&problem, |turn| job.take(&turn)));
    match written.and_then(|moved| job.finish(moving, &moved)) {
        Ok(summary) => {
            output.finish()?;
            if format != ReportFormat::Text {
                // The answer is written, whether or not somebody reads the summary.
                let _ = io::stderr().write_all(summary.to_text.as_bytes());
            }
            Ok(if summary.has_empty { Exit::Empty } else { Exit::Answer })
        }
        Err(Stop::Closed) => Ok(Exit::Answer),
        Err(Stop::Failed(failure)) => Err(failure),
    }
}

/// What is shown of which readings.
struct Job<'a> {
    problem: &'a Problem,
    /// What the table was taken for.
    taken_for: Option<&'a TableJson>,
    format: ReportFormat,
    style: Style,
    summary: WindowSummary,
    table: FleetTable,
    output: &'a mut Output,
}

/// What all windows come to.
struct Summary {
    to_text: String,
    has_empty: bool,
}

impl Job<'_> {
    fn header(&mut self) -> Result<(), Stop> {
        match self.format {
            ReportFormat::Csv => self.output.write(WindowReport::CSV_HEADER.as_bytes()),
            _ => Ok(()),
        }
    }

    fn take(&mut self, turn: &Turn<'_>) -> Result<(), Stop> {
        let Some(window) = WindowReport::new(turn, self.problem) else { return Ok(()) };
        self.summary.add(&window);
        match self.format {
            ReportFormat::Csv => self.output.write(window.csv(&self.style).as_bytes()),
            ReportFormat::Json => {
                let mut line = Vec::new();
                write_window_json(&mut line, &window, self.taken_for, &self.style);
                self.output.write(&line)
            }
            _ => {
                let mut text = String::new();
                self.table.push(window.cells(&self.style), &mut text);
                self.output.write(text.as_bytes())
            }
        }
    }

    fn finish(mut self, moving: &Moving, moved: &Moved) -> Result<Summary, Stop> {
        let to_text = self.summary.to_text(moving, moved, &self.style);
        if self.format == ReportFormat::Text {
            let mut text = String::new();
            self.table.finish(&mut text);
            let table = table_line(self.problem.measurements.table());
            self.output.write(format!("{text}\n{to_text}{table}").as_bytes())?;
        }
        Ok(Summary { to_text, has_empty: self.summary.has_empty() })
    }
}
