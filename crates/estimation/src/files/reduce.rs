//! Readings reduced to those that support a hull, as they were written, with the sums over all.

use std::collections::{HashMap, HashSet};
use std::io::{self, Write};

use boundfit_exact::{Limits, Rational};
use boundfit_formats::{
    Batch, ColumnSelector, InputError, ReductionError, ReductionRecord, Reductions, ScanOptions, Source,
    open_reduction, scan,
};

use crate::summary::{LineSummary, SharedSieve, Sums};

/// Texts of rows that have meanwhile turned out to lie between the hulls are dropped when there are so many of them, so
/// that dropping them is rare.
const MOST_SUPERFLUOUS: usize = 100_000;

/// How many times as many digits as a reading a sum may have: that of squares has twice as many, and those of the
/// fractions on top.
const DIGITS_OF_SUMS: usize = 10;

/// The few readings of a line that decide every fit of all of them, and the sums for least squares.
#[derive(Debug, Clone)]
pub struct ReducedTable {
    record: ReductionRecord,
    header: Option<Vec<u8>>,
    rows: Vec<Vec<u8>>,
}

/// Which columns a reduction is about.
#[derive(Debug, Clone)]
pub struct ReducedColumns {
    /// x.
    pub x: ColumnSelector,
    /// y.
    pub y: ColumnSelector,
    /// ε, when it is to be a column: readings are then compared with those of the same bound only.
    pub epsilon: Option<ColumnSelector>,
}

/// One batch with what is made of it at once, or everything taken so far.
#[derive(Default)]
struct Digest {
    summary: LineSummary,
    /// The rows that may turn out to be kept, as they stand in the file.
    texts: HashMap<usize, Vec<u8>>,
}

impl ReducedTable {
    /// Reduces a table. A line under a uniform error bound, whatever it is, has the same feasible set, PUI and ε_min before and after, with rows counted anew; with a column of error bounds the
    /// same holds under any multiple of these. The union of reductions, reduced, is the reduction of the union.
    ///
    /// Exact. Cost: one pass; memory for the rows that are kept.
    ///
    /// # Errors
    /// The first thing wrong with the file.
    pub fn scan(source: Source, columns: &ReducedColumns, options: &ScanOptions) -> Result<Self, InputError> {
        let name = source.name().to_owned();
        let (source, reductions) = open_reduction(source, &options.table.sizes)?;
        let mut options = ScanOptions { keep_text: true, hash: false, ..options.clone() };
        if let Some(reductions) = &reductions {
            options.table.header = reductions.header();
        }
        let mut selectors = vec![columns.x.clone(), columns.y.clone()];
        selectors.extend(columns.epsilon.clone().map(ColumnSelector::non_negative));
        let mut all = Digest::default();
        let sieve = SharedSieve::default();
        let digest = |batch: Batch| Digest::new(&batch, &sieve);
        let scanned = scan(source, &selectors, &options, digest, |digest| all.merge(digest, &sieve))?;
        let Digest { summary, mut texts } = all;
        let (sums, kept) = summary.into_parts(&Rational::zero());
        let sums = match &reductions {
            Some(reductions) => stated_sums(reductions, &name, true, &scanned.names, &options)?,
            None => sums,
        };
        let rows: Vec<Vec<u8>> = kept.iter().filter_map(|reading| texts.remove(&reading.row)).collect();
        let mut names = scanned.names.into_iter();
        let mut name = || names.next().unwrap_or_default();
        let record = ReductionRecord {
            rows: sums.count,
            kept: rows.iter().map(|row| 1 + row.iter().filter(|&&byte| byte == b'\n').count()).sum(),
            header: scanned.header_line.is_some(),
            reading: options.table.reading.name().to_owned(),
            x: name(),
            y: name(),
            epsilon: columns.epsilon.as_ref().map(|_| name()),
            sums: [&sums.uv, &sums.vy, &sums.uu, &sums.uy].map(Rational::to_string),
        };
        Ok(ReducedTable { record, header: scanned.header_line, rows })
    }

    /// How many readings there were.
    pub fn rows(&self) -> usize {
        self.record.rows
    }

    /// How many of them are kept.
    pub fn kept(&self) -> usize {
        self.rows.len()
    }

    /// Writes the reduction as text.
    ///
    /// # Errors
    /// Of the writer.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        let record = self.record.line();
        let lines = [record.as_bytes()].into_iter().chain(self.header.as_deref());
        for line in lines.chain(self.rows.iter().map(Vec::as_slice)) {
            out.write_all(line)?;
            out.write_all(b"\n")?;
        }
        Ok(())
    }
}

/// The sums that reductions of these columns state.
pub(super) fn stated_sums(
    reductions: &Reductions,
    path: &str,
    line: bool,
    names: &[String],
    options: &ScanOptions,
) -> Result<Sums, InputError> {
    let fail = |error: ReductionError| InputError::of_file(path, error);
    if !line {
        let (has, asked) = ("a line".to_owned(), "two regressors".to_owned());
        return Err(fail(ReductionError::NotAsked { what: "the model", has, asked }));
    }
    if options.table.selects_rows() {
        return Err(fail(ReductionError::NoRowNumbers));
    }
    let digits = options.table.limits.digits.saturating_mul(DIGITS_OF_SUMS);
    let limits = Limits { digits, exponent: 0 };
    let mut total = Sums::default();
    for record in reductions.records() {
        record.check(names, options.table.reading).map_err(fail)?;
        let [x, y, xx, xy] = record.sums(&limits).map_err(fail)?;
        if total.count.checked_add(record.rows).is_none() {
            return Err(fail(ReductionError::TooManyRows));
        }
        let vv = Rational::from(record.rows);
        total = total.merged(&Sums { count: record.rows, uu: xx, uv: x, vv, uy: xy, vy: y });
    }
    Ok(total)
}

impl Digest {
    fn new(batch: &Batch, sieve: &SharedSieve) -> Self {
        let [x, y] = [&batch.columns[0], &batch.columns[1]];
        let summary = LineSummary::of_columns([x, y], batch.columns.get(2), &|k| batch.rows.get(k), sieve);
        let text = |row: usize| {
            let line = || Some(batch.lines.as_ref()?.get(batch.rows.position(row)?).to_vec());
            (row, line().unwrap_or_default())
        };
        Digest { texts: summary.row_numbers().map(text).collect(), summary }
    }

    fn merge(&mut self, other: Digest, sieve: &SharedSieve) {
        self.summary.merge(other.summary, sieve);
        self.texts.extend(other.texts);
        if self.texts.len() > 2 * self.summary.row_numbers().count() + MOST_SUPERFLUOUS {
            let kept: HashSet<usize> = self.summary.row_numbers().collect();
            self.texts.retain(|row, _| kept.contains(row));
        }
    }
}
