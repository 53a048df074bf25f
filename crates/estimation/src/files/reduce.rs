//! Readings reduced to those that decide, as they were written, with the sums over all.

use std::collections::{HashMap, HashSet};
use std::io::{self, Write};

use boundfit_exact::Rational;
use boundfit_formats::{
    Batch, InputError, ReducedBounds, ReducedMarks, ReductionRecord, ScanOptions, Source, TableNotes,
    open_reduction, scan,
};

use super::agreement::KeptRows;
use super::columns::Columns;
use super::fixed::{FixedBounds, FixedPart, FixedSummary};
use super::outline::Outline;
use super::stated::{Stated, asked_by_reduction, counts_of, refuse_late};
use crate::line_form::LineForm;
use crate::meaning::{ErrorBound, Meaning};
use crate::measurement::Measurement;
use crate::moments::Sums;
use crate::reduction::NoLeastSquares;
use crate::scale::Scale;
use crate::summary::{LineSummary, SharedSieve};

/// Texts of rows that have meanwhile turned out to be superfluous are dropped when there are so many of them, so
/// that dropping them is rare.
const MOST_SUPERFLUOUS: usize = 100_000;

/// The few readings that decide fits of all of them, and the sums for least squares.
#[derive(Debug, Clone)]
pub struct ReducedTable {
    record: ReductionRecord,
    header: Option<Vec<u8>>,
    rows: Vec<Vec<u8>>,
    /// The number of readings that each of these stands for.
    counts: Vec<usize>,
    table: Option<TableNotes>,
    rows_missing: usize,
}

/// The rule for the readings that are kept.
struct Rule<'a> {
    /// The column of bounds, of a line for which readings are kept that decide under every multiple of these; `None` under
    /// bounds that are fixed.
    open: Option<Option<usize>>,
    sieve: SharedSieve,
    fixed: FixedBounds<'a>,
}

/// The readings that are kept of one batch.
enum Part {
    Open(LineSummary),
    Fixed(FixedPart, usize),
}

/// One batch with what is made of it at once.
struct Digest {
    part: Part,
    /// The first row without bounds.
    unbounded: Option<usize>,
    /// The rows that may turn out to be kept, as they stand in the file.
    texts: HashMap<usize, Vec<u8>>,
    first: Option<Vec<u8>>,
}

/// Everything taken so far.
#[derive(Default)]
struct Collected {
    open: LineSummary,
    fixed: FixedSummary,
    texts: HashMap<usize, Vec<u8>>,
    /// The first row, for when none decides anything: a table has rows.
    first: Option<Vec<u8>>,
}

impl ReducedTable {
    /// Reduces a table. A line under a uniform error bound keeps the readings that decide for every such bound. A
    /// line with a column of bounds keeps the readings that decide for every multiple of these bounds. Every other
    /// table keeps the readings that decide under the bounds asked for. Feasible set, PUI and least squares are the
    /// same before and after, whatever the conditions and [`Columns::form`], with rows counted anew; so is ε_min
    /// where the bounds are not fixed. The union of reductions, reduced, is the reduction of the union. With
    /// [`ScanOptions::allow_nothing`] what has no rows is reduced to none.
    ///
    /// Exact. Cost: one pass; memory for the rows that are kept.
    ///
    /// # Errors
    /// The first thing wrong with the file; bounds that take a multiple of the range of y, unless they are uniform and the model
    /// is a line.
    pub fn scan(source: Source, columns: &Columns, options: &ScanOptions) -> Result<Self, InputError> {
        let name = source.name().to_owned();
        // Identities may have several lines, and go together with counted rows of other parts.
        let is_named = options.identity.is_some();
        // The deciding readings do not depend on the origin of x, and the sums refer to x as it is.
        let columns = Columns { form: LineForm::default(), ..columns.clone() };
        let unnamed = columns.meaning(&[]);
        refuse_late(&name, &unnamed)?;
        let (source, reductions) = open_reduction(source, &options.table.sizes)?;
        let mut options = ScanOptions { keep_text: true, hash: false, ..options.clone() };
        if let Some(reductions) = &reductions {
            reductions.apply(&mut options.table).map_err(|error| InputError::of_file(&name, error))?;
            // The check that reductions fit together comes first.
            (options.unbounded_rows, options.same_columns) = (true, true);
            // Reductions of nothing are reductions too.
            options.allow_nothing = true;
        }
        // The numbers of a reduction's rows say how many readings each row stands for.
        let rule = Rule::new(&unnamed, if reductions.is_some() { usize::MAX } else { 1 });
        let mut all = Collected::default();
        let mut unbounded = None;
        let digest = |batch: Batch| {
            let rows = reductions.as_ref().map(|own| KeptRows::of_batch(&unnamed, &batch, own));
            (rows, Digest { unbounded: columns.first_unbounded(&batch), ..Digest::new(&batch, &rule) })
        };
        let mut kept_rows = KeptRows::default();
        let scanned = scan(source, &columns.selectors(), &options, digest, |(rows, digest)| {
            rows.into_iter().for_each(|rows| kept_rows.add(rows));
            unbounded = unbounded.or(digest.unbounded);
            all.take(digest, &rule);
        })?;
        let asked = asked_by_reduction(&columns.meaning(&scanned.names));
        let Collected { open, fixed, mut texts, first } = all;
        let (mut own, kept, mut ties) = if rule.open.is_some() {
            let (sums, kept, ties) = open.into_parts(&Rational::zero(), &rule.sieve);
            (
                Stated { count: sums.count, has_widths: true, sums: Ok(sums), is_open: true, is_hull: true },
                kept.into_numbers(),
                ties,
            )
        } else {
            let FixedSummary { support, sums, has_widths } = fixed;
            let count = support.count();
            let (kept, ties) = support.into_rows(&rule.fixed);
            (Stated { count, has_widths, sums, is_open: false, is_hull: false }, kept, ties)
        };
        if let Some(reductions) = &reductions {
            own = Stated::of(reductions, &name, &asked, &options)?;
            if let Some(counts) = counts_of(reductions, &name, scanned.rows_total)? {
                ties = ties.weighted(&kept, &counts);
            }
            let outline = own.is_hull.then(|| Outline::of(&kept));
            kept_rows.check(&own, outline.as_ref()).map_err(|error| InputError::of_file(&name, error))?;
        }
        columns.refuse_unbounded(&name, unbounded)?;
        let text = |reading: &Measurement| Some((texts.remove(&reading.row)?, ties.count(reading.row)));
        let (mut rows, mut counts): (Vec<Vec<u8>>, Vec<usize>) = kept.iter().filter_map(text).unzip();
        if rows.is_empty() {
            rows.extend(first);
            counts = vec![1; rows.len()];
        }
        let may_lack = matches!(asked.model.bounds, ReducedBounds::Interval { .. });
        let record = ReductionRecord {
            rows: own.count,
            kept: rows.iter().map(|row| lines(row)).sum(),
            counted: counts.iter().any(|&count| count > 1)
                || rows.iter().any(|row| is_named && row.contains(&b'\n') || has_blank_line(row)),
            header: scanned.header_line.is_some(),
            header_lines: scanned.header_line.as_deref().map_or(1, lines),
            reading: options.table.reading.name().to_owned(),
            written: ReducedMarks::of(&options.table, may_lack),
            model: asked.model,
            widths: own.has_widths,
            sums: written(&own.sums),
        };
        // A reduction no longer knows the tables that reductions were made from.
        let table = scanned.table.filter(|_| reductions.is_none());
        let rows_missing = scanned.rows_missing;
        Ok(ReducedTable { record, header: scanned.header_line, rows, counts, table, rows_missing })
    }

    /// The number of readings there were.
    pub fn rows(&self) -> usize {
        self.record.rows
    }

    /// Returns how many of them are kept.
    pub fn kept(&self) -> usize {
        self.rows.len()
    }

    /// The number of rows that were left out since they lack a number.
    pub fn rows_missing(&self) -> usize {
        self.rows_missing
    }

    /// Returns what the table was taken for; nothing unless it is text or a sheet, and no reduction.
    pub fn table(&self) -> Option<&TableNotes> {
        self.table.as_ref()
    }

    /// Writes the reduction as text.
    ///
    /// # Errors
    /// Errors of the writer.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        let record = self.record.line();
        for line in [record.as_bytes()].into_iter().chain(self.header.as_deref()) {
            out.write_all(line)?;
            out.write_all(b"\n")?;
        }
        for (row, &count) in self.rows.iter().zip(&self.counts) {
            if !self.record.counted {
                out.write_all(row)?;
                out.write_all(b"\n")?;
                continue;
            }
            // A row of several lines says on the first of them how many readings it stands for.
            for (line, count) in
                row.split(|&byte| byte == b'\n').zip([count].into_iter().chain([0].into_iter().cycle()))
            {
                write!(out, "{count} ")?;
                out.write_all(line)?;
                out.write_all(b"\n")?;
            }
        }
        Ok(())
    }
}

/// The number of lines of a row: cells in quotes may have several.
fn lines(row: &[u8]) -> usize {
    1 + row.iter().filter(|&&byte| byte == b'\n').count()
}

/// Returns whether a line of a row is blank, which between rows counts as none.
fn has_blank_line(row: &[u8]) -> bool {
    row.contains(&b'\n') && row.split(|&byte| byte == b'\n').any(|line| line.trim_ascii().is_empty())
}

/// The sums as a reduction has them.
fn written(sums: &Result<Sums, NoLeastSquares>) -> Option<[String; 5]> {
    Some(sums.as_ref().ok()?.parts().map(Rational::to_string))
}

impl<'a> Rule<'a> {
    fn new(meaning: &'a Meaning, most_listed: usize) -> Self {
        let open = match &meaning.error_bound {
            ErrorBound::Uniform(_) if meaning.regressors() == 1 => Some(None),
            ErrorBound::Column(_) if meaning.regressors() == 1 => Some(Some(2)),
            _ => None,
        };
        Rule {
            open,
            sieve: SharedSieve::listing(most_listed),
            fixed: FixedBounds::new(meaning, &Scale::AsStated, most_listed),
        }
    }
}

impl Digest {
    fn new(batch: &Batch, rule: &Rule) -> Self {
        let (columns, row) = (&batch.columns, |k: usize| batch.rows.get(k));
        let (part, numbers): (Part, Vec<usize>) = match rule.open {
            Some(bounds) => {
                let bounds = bounds.and_then(|index| columns.get(index));
                let summary = LineSummary::of_columns([&columns[0], &columns[1]], bounds, &row, &rule.sieve);
                let numbers = summary.row_numbers().collect();
                (Part::Open(summary), numbers)
            }
            None => {
                let part = rule.fixed.part(columns, &row);
                let numbers = part.touching.iter().map(|own| own.reading.row).collect();
                (Part::Fixed(part, batch.rows.len()), numbers)
            }
        };
        let text = |row: usize| {
            let line = || Some(batch.lines.as_ref()?.get(batch.rows.position(row)?).to_vec());
            (row, line().unwrap_or_default())
        };
        let first = batch.lines.as_ref().filter(|lines| !lines.is_empty()).map(|lines| lines.get(0).to_vec());
        Digest { part, unbounded: None, texts: numbers.into_iter().map(text).collect(), first }
    }
}

impl Collected {
    fn take(&mut self, Digest { part, texts, first, .. }: Digest, rule: &Rule) {
        self.first = self.first.take().or(first);
        match part {
            Part::Open(summary) => self.open.merge(summary, &rule.sieve),
            Part::Fixed(part, rows) => self.fixed.merge(part, rows, &rule.fixed),
        }
        self.texts.extend(texts);
        // Only one part of each kind exists.
        let kept = || self.open.row_numbers().chain(self.fixed.support.row_numbers());
        if self.texts.len() > 2 * kept().count() + MOST_SUPERFLUOUS {
            let kept: HashSet<usize> = kept().collect();
            self.texts.retain(|row, _| kept.contains(row));
        }
    }
}
