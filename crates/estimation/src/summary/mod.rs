//! Readings of any number in memory that does not grow with them.
//!
//! Under a uniform error bound a line is decided by the readings that touch the convex hull, least squares by five sums,
//! and both of a whole are found from those of its parts. Only the EUI needs a second look at x, when the sums are known.

mod abscissas;
mod columns;
mod estimate;
mod extremes;
mod reduce;
mod sieve;
mod spread;
mod sums;

use boundfit_exact::Rational;
use boundfit_formats::{
    Batch, InputError, InputErrorKind, ScanOptions, Scanned, Source, open_reduction, scan,
};
use thiserror::Error;

pub use reduce::{ReducedColumns, ReducedTable};
pub use spread::Spread;
pub use sums::LineSums;

use abscissas::{Abscissas, StoredPart};
use columns::LineColumns;
use extremes::Extremes;
use sieve::SharedSieve;
use spread::Thresholds;

use crate::files::{Columns, EpsilonColumn, rows_of};
use crate::measurements::{Measurement, Measurements, Readings};

/// Bytes of x kept from a file before it is rather read a second time: twelve million readings at four bytes each.
const MOST_BYTES_OF_FILE: usize = 48 << 20;
/// Bytes of x kept from standard input, which cannot be read a second time: 134 million readings at four bytes each.
const MOST_BYTES_OF_STREAM: usize = 512 << 20;

/// How many readings are kept in memory.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Keep {
    /// Up to this many readings all of them; of more readings of a line under a uniform error bound only those that
    /// touch a hull. Of other models and error bounds all are always kept.
    pub most_rows: usize,
    /// Whether the EUI is wanted of more readings than that.
    pub eui: bool,
    /// How many bytes of x are kept for it. When left out: 48 MiB of a file, which is read a second time when it has
    /// more; 512 MiB of standard input, which cannot be.
    pub most_bytes: Option<usize>,
}

impl Keep {
    /// Above this many readings the LP solvers and binary64 least squares, which need all of them, are left out of
    /// reports. Measured: at this size microlp takes half a second, at ten times as many readings five seconds and
    /// 400 MB.
    pub const MOST_ROWS: usize = 10_000;
}

impl Default for Keep {
    /// All of 10,000 readings, with EUI.
    fn default() -> Self {
        Keep { most_rows: Keep::MOST_ROWS, eui: true, most_bytes: None }
    }
}

/// What is known about the readings of a line of which only those that touch a hull are kept.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Reduction {
    /// The sums over all readings.
    pub sums: LineSums,
    /// Where all x lie.
    pub spread: Result<Spread, NoEui>,
}

/// Why there is no EUI although there is a least-squares estimate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum NoEui {
    /// It was not asked for.
    #[error("not asked for")]
    NotAsked,
    /// Readings that cannot be read twice, and more than are kept.
    #[error(
        "standard input has more readings than are kept for a second look at their x; a file can be read twice"
    )]
    TooManyOnce,
    /// The data are the result of a reduction.
    #[error("the data are a reduction, which does not have the x of every reading")]
    Reduced,
}

/// One batch with what is made of it at once.
struct Digest {
    batch: Batch,
    line: Option<(LineSums, Extremes, Option<StoredPart>)>,
}

/// Everything taken so far.
struct Collected {
    batches: Vec<Batch>,
    rows: usize,
    sums: LineSums,
    extremes: Extremes,
    abscissas: Abscissas,
}

impl Measurements {
    /// Reads the columns of a table in constant memory for a line under a uniform error bound: see [`Keep`]. Rows and numbers are those of [`Measurements::read`].
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
        let of_line = columns.second.is_none() && matches!(columns.epsilon, EpsilonColumn::Uniform(_));
        let name = source.name().to_owned();
        let path = source.path().map(str::to_owned);
        let usual = if path.is_some() { MOST_BYTES_OF_FILE } else { MOST_BYTES_OF_STREAM };
        let mut all = Collected {
            batches: Vec::new(),
            rows: 0,
            sums: LineSums::default(),
            extremes: Extremes::default(),
            abscissas: Abscissas::new(keep.most_bytes.unwrap_or(usual)),
        };
        let sieve = SharedSieve::default();
        let digest = |batch: Batch| {
            let line = of_line.then(|| {
                let columns = LineColumns::new(&batch.columns[0], &batch.columns[1]);
                let extremes = sieve.extremes(&columns, batch.first_row);
                let stored = keep.eui.then(|| StoredPart::new(&columns));
                (LineSums::of_columns(&columns), extremes, stored)
            });
            Digest { batch, line }
        };
        let most_rows = if of_line { keep.most_rows } else { usize::MAX };
        let (source, reductions) = open_reduction(source, &options.table.sizes)?;
        let mut options = options.clone();
        if let Some(reductions) = &reductions {
            options.table.header = reductions.header();
        }
        let scanned = scan(source, &columns.selectors(), &options, digest, |digest| {
            all.take(digest, most_rows, &sieve);
        })?;
        let meaning = columns.meaning(&scanned.names);
        let supporting = |extremes: Extremes| {
            let reading = |reading: Measurement| {
                let [x, _] = reading.regressor;
                meaning.measurement(reading.row, [x, reading.response].into_iter())
            };
            extremes.into_rows().into_iter().map(reading).collect()
        };
        if let Some(reductions) = &reductions {
            let line = columns.second.is_none();
            let sums = LineSums::stated(reductions, &name, line, &scanned.names, &options)?;
            let rows = match columns.epsilon {
                EpsilonColumn::Uniform(_) => supporting(all.extremes),
                EpsilonColumn::Column(_) => rows_of(&all.batches, &meaning),
            };
            let scanned = Scanned { rows_total: sums.count, layout: None, ..scanned };
            let reduction = Reduction { sums, spread: Err(NoEui::Reduced) };
            return Ok(Measurements::scanned(columns, scanned, Readings::Supporting { rows, reduction }));
        }
        if all.rows <= most_rows {
            let rows = rows_of(&all.batches, &meaning);
            return Ok(Measurements::scanned(columns, scanned, Readings::All(rows)));
        }
        let spread = if keep.eui {
            let thresholds = Thresholds::new(&all.sums);
            match (all.abscissas.spread(&thresholds), &path) {
                (Some(spread), _) => Ok(spread),
                (None, None) => Err(NoEui::TooManyOnce),
                (None, Some(path)) => {
                    Ok(second_look(path, columns, &options, &thresholds, &all.sums, &scanned)?)
                }
            }
        } else {
            Err(NoEui::NotAsked)
        };
        let (rows, reduction) = (supporting(all.extremes), Reduction { sums: all.sums, spread });
        Ok(Measurements::scanned(columns, scanned, Readings::Supporting { rows, reduction }))
    }
}

impl Collected {
    fn take(&mut self, Digest { batch, line }: Digest, most_rows: usize, sieve: &SharedSieve) {
        self.rows += batch.rows;
        if self.rows <= most_rows {
            self.batches.push(batch);
        } else {
            self.batches = Vec::new();
        }
        if let Some((sums, extremes, abscissas)) = line {
            self.sums = self.sums.merged(&sums);
            self.extremes.merge(extremes);
            sieve.learn(&self.extremes, self.rows);
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
    let options = ScanOptions { hash: false, ..options.clone() };
    let mut spread = Spread::default();
    let (mut count, mut total) = (0, Rational::zero());
    let look = |batch: Batch| {
        let x = &batch.columns[0];
        (x.len(), LineSums::of_x(x), thresholds.of_column(x))
    };
    let again = Source::open(path)?.limited(scanned.bytes);
    scan(again, &columns.selectors()[..1], &options, look, |(rows, x, part)| {
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
