//! `boundfit status`.

use boundfit_ask::Refusal;
use boundfit_estimation::{Columns, EpsilonColumn, Fit, Keep, Measurement, Measurements, Problem, fit};
use boundfit_exact::{DecimalMark, Foreign};
use boundfit_formats::{InputError, InputErrorKind, RowRange, RowSet, ScanOptions, Source};
use boundfit_questions::{Deciding, NoRepair, Ranking, Repair, RowStatus, Standing, Statuses};
use boundfit_report::{
    NewReadings, Origin, StatusCsv, StatusJson, StatusReport, Style, status_document, status_proof,
};

use super::proof_file;
use crate::CommandResult;
use crate::arguments::{StatusArguments, TableFormat};
use crate::exit::{Exit, Failure};
use crate::input;
use crate::output::{self, Output, Stop};
use crate::progress::while_working;
use crate::work::{refuse_long_problem, refuse_long_status_proof, times};

/// Readings that the text lists where nobody asks for all.
const MOST_LISTED: usize = 40;

/// Readings that decide of which a proof has a statement each.
const MOST_PROVED: usize = 1000;

/// Finds the set in a first look at the data, the readings that are judged by another one in a second, and writes.
pub(crate) fn run(arguments: &StatusArguments) -> CommandResult {
    arguments.threads.set()?;
    let format = arguments.output.format()?;
    check_usage(arguments, format)?;
    let output = arguments.output.file.output.as_deref();
    let new = arguments.new.as_deref();
    let mut guard = arguments.output.file.replace.guard([arguments.data.path()].into_iter().chain(new));
    guard.check(output)?;
    guard.check(arguments.proof.as_deref())?;
    let data = arguments.data.open();
    let asked = data.asked()?;
    let origin = data.origin();
    let has_proof = arguments.proof.is_some();
    let problem = if data.can_be_read_again() && !arguments.repair {
        data.scanned_problem(false, true, has_proof, false)?
    } else {
        data.every_reading(true, has_proof)?
    };
    if problem.measurements.is_of_reductions() {
        return Err(Failure::of(&Refusal::Reduction { ask: "status" }, arguments.data.file_name()));
    }
    let limits = &arguments.data.table.limits;
    refuse_long_problem(arguments.data.file_name(), &problem, times::STATUS, limits)?;
    if arguments.proof.is_some() {
        refuse_long_status_proof(arguments.data.file_name(), &problem, limits)?;
    }
    if format == TableFormat::Csv {
        input::say_table(arguments.data.file_name(), problem.measurements.table());
    }
    let fit = while_working("fitting", || fit(&problem));
    let style = arguments.output.style();
    let columns = resolved(asked.columns, &problem);
    let repair = arguments.repair.then(|| while_working("repairing", || Repair::of(&problem, &fit)));
    let question = Question { arguments, problem: &problem, fit: &fit, columns: &columns, origin, style };
    let is_document = !matches!(format, TableFormat::Json | TableFormat::Csv);
    let (statuses, ranking) = question.statuses(is_document)?;
    let proof = match &arguments.proof {
        Some(file) => Some((question.proof(&statuses)?, file.as_str())),
        None => None,
    };
    let mut report = Vec::new();
    if is_document {
        let new = new.map(|file| question.ranked_new(file, &statuses)).transpose()?;
        let report_of = StatusReport { problem: &problem, fit: &fit, ranking, new, repair };
        let document = status_document(report_of, &origin, &style);
        report = match format {
            TableFormat::Latex => document.to_latex(),
            TableFormat::Markdown => document.to_markdown(),
            _ => document.to_text(),
        }
        .into_bytes();
    } else if proof.is_none() {
        let write = |output: &mut Output| {
            question.write(&statuses, repair.as_ref(), format, &mut |part| output.write(part))
        };
        output::write_parts(write, output, &guard)?;
    } else {
        let mut put = |part: &[u8]| {
            report.extend_from_slice(part);
            Ok(())
        };
        match question.write(&statuses, repair.as_ref(), format, &mut put) {
            Ok(()) | Err(Stop::Closed) => {}
            Err(Stop::Failed(failure)) => return Err(failure),
        }
    }
    if is_document || proof.is_some() {
        proof_file::write(&report, output, proof, &mut guard)?;
    }
    Ok(if fit.is_empty() { Exit::Empty } else { Exit::Answer })
}

/// Refuses what only some formats have, and files that are named twice.
fn check_usage(arguments: &StatusArguments, format: TableFormat) -> Result<(), Failure> {
    let refuse = |problem: &str| Err(Failure::Usage(problem.to_owned()));
    if arguments.repair && format == TableFormat::Csv {
        return refuse(
            "'--repair' is no part of csv: a table has a row for each reading, and no room for it",
        );
    }
    if arguments.all && matches!(format, TableFormat::Json | TableFormat::Csv) {
        return refuse("'--all' is about text, latex and markdown; other formats list every reading anyway");
    }
    if arguments.new.as_deref() == Some("-") && arguments.data.path() == "-" {
        return refuse("DATA and '--new' would both be read from standard input: give one of them a file");
    }
    proof_file::check(arguments.proof.as_deref(), arguments.output.file.output.as_deref())
}

/// The columns under the error bound that was found from all readings, where it was.
fn resolved(columns: Columns, problem: &Problem) -> Columns {
    match problem.measurements.error_bound().uniform() {
        Some(epsilon) => Columns { epsilon: EpsilonColumn::Uniform(epsilon.clone()), ..columns },
        None => columns,
    }
}

/// What is asked of which readings.
struct Question<'a> {
    arguments: &'a StatusArguments,
    problem: &'a Problem,
    fit: &'a Fit,
    columns: &'a Columns,
    origin: Origin<'a>,
    style: Style,
}

impl Question<'_> {
    /// The statuses, and where the text is asked for what it lists.
    fn statuses(&self, is_ranked: bool) -> Result<(Statuses, Ranking), Failure> {
        let most = if self.arguments.all { usize::MAX } else { MOST_LISTED };
        let mut ranking = Ranking::listing(most);
        if let Some(all) = self.problem.measurements.all() {
            let statuses = while_working("judging", || Statuses::of(self.problem, self.fit));
            // All are in memory.
            let statuses = statuses.ok_or_else(|| Failure::data("not every reading is in memory"))?;
            for reading in all.iter().filter(|_| is_ranked) {
                ranking.add(reading.clone(), statuses.status(reading));
            }
            return Ok((statuses, ranking));
        }
        let deciding = Deciding::new(self.problem, self.fit);
        // The others stand to the set of all as to that of the others.
        let judge = |readings: &mut dyn Iterator<Item = Measurement>| {
            let mut ranking = Ranking::listing(most);
            let shown = is_ranked.then_some(readings);
            for reading in shown.into_iter().flatten() {
                let all = Standing::against(&reading, deciding.set());
                let status = RowStatus { row: reading.row, without: all.clone(), all };
                ranking.add(reading, status);
            }
            ranking
        };
        let rows: Vec<usize> = deciding.rows().collect();
        let others = self.look(&rows, judge, |part| ranking.merge(part))?;
        let statuses = Statuses::new(deciding.clone(), &others);
        for reading in deciding.readings().iter().filter(|_| is_ranked) {
            ranking.add(reading.clone(), statuses.status(reading));
        }
        Ok((statuses, ranking))
    }

    /// Another look at the data, without some rows.
    fn look<T: Send>(
        &self,
        without: &[usize],
        see: impl Fn(&mut dyn Iterator<Item = Measurement>) -> T + Sync + Send,
        seen: impl FnMut(T),
    ) -> Result<Measurements, Failure> {
        let data = &self.arguments.data;
        let changed = || Failure::data(InputError::of_file(data.file_name(), InputErrorKind::Changed));
        let source = input::open(data.path()).map_err(Failure::refused)?;
        let mut options = data.scan_options(&source)?;
        let holes = without.iter().filter_map(|&row| RowRange::new(row, row));
        let holes: Vec<RowRange> = options.table.rows.without().iter().copied().chain(holes).collect();
        options.table.rows = RowSet::new(options.table.rows.named(), &holes).ok_or_else(changed)?;
        let first = &self.problem.measurements;
        // The row that tells it may be among those that are left out.
        let notation = first.table().map(|notes| notes.dialect.notation);
        if notation.is_some_and(|notation| notation.decimal == DecimalMark::Comma) {
            options.table.dialect.decimal = Some(DecimalMark::Comma);
        }
        let seen = self.scan(source, self.columns, &options, see, seen).map_err(Failure::refused)?;
        let is_same = seen.sha256() == first.sha256() && seen.fitted() + without.len() == first.fitted();
        if is_same { Ok(seen) } else { Err(changed()) }
    }

    fn scan<T: Send>(
        &self,
        source: Source,
        columns: &Columns,
        options: &ScanOptions,
        see: impl Fn(&mut dyn Iterator<Item = Measurement>) -> T + Sync + Send,
        seen: impl FnMut(T),
    ) -> Result<Measurements, InputError> {
        let keep = Keep { eui: false, ..Keep::default() };
        let options = ScanOptions { list_rows: false, ..options.clone() };
        Measurements::scan_and_see(source, columns, &self.problem.conditions, &options, keep, see, seen)
    }

    /// Reads further readings.
    fn see_new<T: Send>(
        &self,
        file: &str,
        see: impl Fn(&mut dyn Iterator<Item = Measurement>) -> T + Sync + Send,
        seen: impl FnMut(T),
    ) -> Result<(), Failure> {
        let source = input::open(file).map_err(Failure::refused)?;
        let problem = match &self.columns.epsilon {
            EpsilonColumn::Law(law) if law.needs_range() => Some(
                "'--new' is about readings with bounds of their own, and a law with range(y) takes them from all of a table: \
                 give the number that it comes to",
            ),
            _ if source.is_reduction() => Some(
                "'--new' is about every reading, and the file is a reduction: judge the table that it was made from",
            ),
            _ => None,
        };
        if let Some(problem) = problem {
            return Err(Failure::Usage(problem.to_owned()));
        }
        let options = self.arguments.data.table.scan_options(&source, None)?;
        let options = ScanOptions { hash: false, ..options };
        let new = self.scan(source, self.columns, &options, see, seen).map_err(Failure::refused)?;
        input::say_table(Foreign::of(input::named(file)), new.table());
        Ok(())
    }

    /// Further readings for the text.
    fn ranked_new<'a>(&self, file: &'a str, statuses: &Statuses) -> Result<NewReadings<'a>, Failure> {
        let most = if self.arguments.all { usize::MAX } else { MOST_LISTED };
        let judge = |readings: &mut dyn Iterator<Item = Measurement>| {
            let mut ranking = Ranking::listing(most);
            for reading in readings {
                let all = Standing::against(&reading, statuses.set());
                let status = RowStatus { row: reading.row, without: all.clone(), all };
                ranking.add(reading, status);
            }
            ranking
        };
        let mut ranking = Ranking::listing(most);
        self.see_new(file, judge, |part| ranking.merge(part))?;
        Ok(NewReadings { file: (file != "-").then_some(Foreign::of(file)), ranking })
    }

    /// The proof of the statuses.
    fn proof(&self, statuses: &Statuses) -> Result<String, Failure> {
        if statuses.deciding().count() > MOST_PROVED {
            return Err(Failure::Usage(format!(
                "'--proof' is about sets that at most {MOST_PROVED} readings decide"
            )));
        }
        let file = self.arguments.data.file_name();
        status_proof(self.problem, statuses, self.origin.reading).ok_or_else(|| {
            Failure::Usage(format!(
                "'--proof' is about the rows of delimited text, and {file} is none (docs/proof.md)"
            ))
        })
    }

    /// Writes JSON or CSV while the data are read once more, or from memory.
    fn write(
        &self,
        statuses: &Statuses,
        repair: Option<&Result<Repair, NoRepair>>,
        format: TableFormat,
        put: &mut dyn FnMut(&[u8]) -> Result<(), Stop>,
    ) -> Result<(), Stop> {
        let is_json = format == TableFormat::Json;
        let style = &self.style;
        let head = match is_json {
            true => StatusJson::head(self.problem, self.fit, statuses.deciding(), &self.origin, style),
            false => StatusCsv::HEADER.to_owned(),
        };
        put(head.as_bytes())?;
        let row = |reading: Measurement| {
            let status = statuses.status(&reading);
            if is_json { StatusJson::row(&status, style) } else { StatusCsv::row(&status) }
        };
        let new_row = |reading: Measurement| {
            let standing = Standing::against(&reading, statuses.set());
            let standing = standing.as_ref();
            match is_json {
                true => StatusJson::new_row(reading.row, standing, style),
                false => StatusCsv::new_row(reading.row, standing),
            }
        };
        let between = if is_json { StatusJson::BETWEEN } else { "" };
        let made = |readings: &mut dyn Iterator<Item = Measurement>| {
            readings.map(&row).collect::<Vec<_>>().join(between)
        };
        let made_new = |readings: &mut dyn Iterator<Item = Measurement>| {
            readings.map(&new_row).collect::<Vec<_>>().join(between)
        };
        let mut parts = Parts { put: &mut *put, between, has_part: false, stop: None };
        match self.problem.measurements.all() {
            Some(all) => {
                for readings in all.chunks(ROWS_AT_ONCE) {
                    parts.take(&made(&mut readings.iter().cloned()));
                }
            }
            None => {
                self.look(&[], made, |part| parts.take(&part)).map_err(Stop::Failed)?;
            }
        }
        parts.end()?;
        if is_json {
            put(StatusJson::END_OF_ROWS.as_bytes())?;
        }
        if let Some(file) = self.arguments.new.as_deref() {
            if is_json {
                let name = (file != "-").then_some(Foreign::of(file));
                put(StatusJson::new_head(name).as_bytes())?;
            }
            let mut parts = Parts { put: &mut *put, between, has_part: false, stop: None };
            self.see_new(file, made_new, |part| parts.take(&part)).map_err(Stop::Failed)?;
            parts.end()?;
            if is_json {
                put(StatusJson::END_OF_NEW.as_bytes())?;
            }
        }
        if let Some(repair) = repair.filter(|_| is_json) {
            put(StatusJson::repair(repair, style).as_bytes())?;
        }
        if is_json { put(StatusJson::TAIL.as_bytes()) } else { Ok(()) }
    }
}

/// Readings whose lines are put together in memory.
const ROWS_AT_ONCE: usize = 4096;

/// Lines on their way to an output.
struct Parts<'a> {
    put: &'a mut dyn FnMut(&[u8]) -> Result<(), Stop>,
    between: &'static str,
    has_part: bool,
    stop: Option<Stop>,
}

impl Parts<'_> {
    fn take(&mut self, part: &str) {
        if self.stop.is_some() || part.is_empty() {
            return;
        }
        let between = if self.has_part { self.between } else { "" };
        self.has_part = true;
        let written = (self.put)(between.as_bytes()).and_then(|()| (self.put)(part.as_bytes()));
        self.stop = written.err();
    }

    fn end(self) -> Result<(), Stop> {
        self.stop.map_or(Ok(()), Err)
    }
}
