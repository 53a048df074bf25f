//! Tables of any size.

use boundfit_exact::Rational;
use boundfit_formats::{
    Batch, InputError, InputErrorKind, ScanOptions, Scanned, Source, TableRow, open_reduction, scan,
};

use super::abscissas::{Abscissas, StoredPart};
use super::columns::Columns;
use super::reduce::stated_sums;
use crate::measurements::{Meaning, Measurement, Measurements, Origin, Readings};
use crate::selection::{FractionCells, Selection};
use crate::summary::{Keep, LineSummary, LineSums, NoEui, Reduction, SharedSieve, Spread, Thresholds};

/// Bytes of x kept from a file before it is rather read a second time: twelve million readings at four bytes each.
const MOST_BYTES_OF_FILE: usize = 48 << 20;
/// Bytes of x kept from standard input, which cannot be read a second time: 134 million readings at four bytes each.
const MOST_BYTES_OF_STREAM: usize = 512 << 20;

/// One batch with what is made of it at once.
struct Digest {
    batch: Batch,
    /// The first row without bounds.
    unbounded: Option<usize>,
    line: Option<(LineSummary, Option<StoredPart>)>,
}

/// Everything taken so far.
struct Collected {
    batches: Vec<Batch>,
    rows: usize,
    summary: LineSummary,
    abscissas: Abscissas,
}

impl Measurements {
    /// Reads the columns of a table in constant memory for a line under a uniform error bound: see [`Keep`]. Rows and
    /// numbers are those of [`Measurements::read`].
    ///
    /// Exact. Cost: one pass; two where the EUI is asked for of a file with more readings than are kept for it.
    ///
    /// # Errors
    /// The first thing wrong with the file, a negative error bound included.
    pub fn scan(
        source: Source,
        columns: &Columns,
        options: &ScanOptions,
        keep: Keep,
    ) -> Result<Self, InputError> {
        let of_line = columns.second.is_none() && columns.is_uniform();
        let name = source.name().to_owned();
        let path = source.path().map(str::to_owned);
        let usual = if path.is_some() { MOST_BYTES_OF_FILE } else { MOST_BYTES_OF_STREAM };
        let abscissas = Abscissas::new(keep.most_bytes.unwrap_or(usual));
        let mut all = Collected { batches: Vec::new(), rows: 0, summary: LineSummary::default(), abscissas };
        let sieve = SharedSieve::default();
        let digest = |batch: Batch| {
            let line = of_line.then(|| {
                let [x, y] = [&batch.columns[0], &batch.columns[1]];
                let summary = LineSummary::of_columns([x, y], None, &|k| batch.rows.get(k), &sieve);
                (summary, keep.eui.then(|| StoredPart::new(x)))
            });
            Digest { unbounded: columns.first_unbounded(&batch), batch, line }
        };
        let most_rows = if of_line { keep.most_rows } else { usize::MAX };
        let (source, reductions) = open_reduction(source, &options.table.sizes)?;
        let mut options = options.clone();
        if let Some(reductions) = &reductions {
            options.table.header = reductions.header();
        }
        let mut unbounded = None;
        let scanned = scan(source, &columns.selectors(), &options, digest, |digest| {
            unbounded = unbounded.or(digest.unbounded);
            all.take(digest, most_rows, &sieve);
        })?;
        columns.refuse_unbounded(&name, unbounded)?;
        let (mut meaning, selection) = (columns.meaning(&scanned.names), Selection::of(&options.table));
        let uniform = meaning.error_bound.uniform().cloned();
        let Collected { batches, rows, summary, abscissas } = all;
        if let Some(reductions) = &reductions {
            let sums = stated_sums(reductions, &name, columns.second.is_none(), &scanned.names, &options)?;
            let mut rows = match &uniform {
                Some(epsilon) => {
                    let mut rows = summary.into_parts(epsilon).1;
                    columns.form.count_rows(&mut rows);
                    rows
                }
                None => rows_of(&batches, &meaning),
            };
            meaning.settle(&mut rows);
            let sums = columns.form.sums(sums);
            let scanned = Scanned { rows_total: sums.count, layout: None, ..scanned };
            let reduction = Reduction { sums, spread: Err(NoEui::Reduced) };
            return Ok(measurements(meaning, selection, scanned, Readings::Supporting { rows, reduction }));
        }
        let readings = match &uniform {
            Some(epsilon) if rows > most_rows => {
                let (raw_sums, mut rows) = summary.into_parts(epsilon);
                columns.form.count_rows(&mut rows);
                // A reading with the largest or the smallest y of all is on a hull.
                meaning.settle(&mut rows);
                let sums = columns.form.sums(raw_sums.clone());
                let thresholds = Thresholds::of_form(&columns.form, &sums);
                let spread = match (abscissas.spread(&thresholds), &path) {
                    _ if !keep.eui => Err(NoEui::NotAsked),
                    (Some(spread), _) => Ok(spread),
                    (None, None) => Err(NoEui::TooManyOnce),
                    (None, Some(path)) => {
                        Ok(second_look(path, columns, &options, &thresholds, &raw_sums, &scanned)?)
                    }
                };
                let spread = spread.map(|spread| columns.form.spread(spread));
                Readings::Supporting { rows, reduction: Reduction { sums, spread } }
            }
            _ => {
                let mut rows = rows_of(&batches, &meaning);
                meaning.settle(&mut rows);
                Readings::All(rows)
            }
        };
        Ok(measurements(meaning, selection, scanned, readings))
    }
}

/// Readings of a table that was read in batches.
fn measurements(
    meaning: Meaning,
    selection: Selection,
    scanned: Scanned,
    readings: Readings,
) -> Measurements {
    let Scanned { names, fractions, rows_total, rows_missing, ranges, units, layout, sha256, .. } = scanned;
    let written = layout.as_ref().and_then(|layout| layout.dialect.words());
    let fractions = FractionCells::of(&names, &fractions);
    let origin =
        Origin { rows_total, rows_missing, selection, fractions, ranges, written, units, layout, sha256 };
    Measurements { meaning, readings, others: Vec::new(), origin }
}

/// All readings of batches.
fn rows_of(batches: &[Batch], meaning: &Meaning) -> Vec<Measurement> {
    let row = |row: TableRow| meaning.measurement(row.row, row.numbers.into_iter());
    batches.iter().flat_map(Batch::table_rows).map(row).collect()
}

impl Collected {
    fn take(&mut self, Digest { batch, line, .. }: Digest, most_rows: usize, sieve: &SharedSieve) {
        self.rows += batch.rows.len();
        if self.rows <= most_rows {
            self.batches.push(batch);
        } else {
            self.batches = Vec::new();
        }
        if let Some((summary, abscissas)) = line {
            self.summary.merge(summary, sieve);
            if let Some(part) = abscissas {
                self.abscissas.push(part);
            }
        }
    }
}

/// Reads x once more, and nothing that was not there the first time.
fn second_look(
    path: &str,
    columns: &Columns,
    options: &ScanOptions,
    thresholds: &Thresholds,
    sums: &LineSums,
    scanned: &Scanned,
) -> Result<Spread, InputError> {
    let options = ScanOptions { hash: false, list_rows: false, ..options.clone() };
    let mut spread = Spread::default();
    let (mut count, mut total) = (0, Rational::zero());
    let look = |batch: Batch| {
        let x = &batch.columns[0];
        (x.len(), LineSums::of_columns(x, x).x, thresholds.of_column(x))
    };
    let again = Source::open(path)?.limited(scanned.bytes);
    // Which rows lack a number is told by all columns.
    let seen = if scanned.rows_missing > 0 { columns.selectors().len() } else { 1 };
    scan(again, &columns.selectors()[..seen], &options, look, |(rows, x, part)| {
        count += rows;
        total = &total + x;
        spread = spread.merged(&part);
    })
    // What was right the first time is wrong only because it is something else now.
    .map_err(|error| match error.kind {
        InputErrorKind::Io(_) | InputErrorKind::Interrupted => error,
        _ => InputError::of_file(path, InputErrorKind::Changed),
    })?;
    if count == sums.count && total == sums.x {
        Ok(spread)
    } else {
        Err(InputError::of_file(path, InputErrorKind::Changed))
    }
}
