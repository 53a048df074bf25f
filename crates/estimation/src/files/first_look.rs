//! The first look at the readings of a table: what is kept of them, batch by batch.

use std::sync::Arc;

use boundfit_exact::{Column, Foreign, Rational};
use boundfit_formats::{
    Batch, ColumnSelector, HeldRows, InputError, Reductions, ScanOptions, Scanned, Source, open_reduction,
    scan,
};

use super::agreement::KeptRows;
use super::columns::Columns;
use super::fixed::{FixedBounds, FixedPart, FixedSummary};
use super::in_columns::readings_of;
use super::kept_columns::{KeptColumns, KeptPart};
use super::seen::Seen;
use super::sums::column_totals;
use crate::line_form::LineForm;
use crate::meaning::Meaning;
use crate::measurement::Measurement;
use crate::scale::Scale;
use crate::summary::{Keep, LineSummary, SharedSieve};
use crate::ties::Ties;

/// Bytes of numbers kept from a file before it is rather read again: 50 million x at four bytes each, 12 million of 17 digits.
const MOST_BYTES_OF_FILE: usize = 192 << 20;
/// Bytes of numbers kept from standard input, which cannot be read again: 134 million x at four bytes each.
const MOST_BYTES_OF_STREAM: usize = 512 << 20;

/// The settings that all threads use, fixed before the first reading is read.
pub(super) struct FirstLook<'a> {
    pub(super) name: Foreign,
    /// The file in which the readings can be read again.
    pub(super) path: Option<String>,
    pub(super) columns: &'a Columns,
    pub(super) options: ScanOptions,
    pub(super) selectors: Vec<ColumnSelector>,
    pub(super) reductions: Option<Reductions>,
    pub(super) keep: Keep,
    /// The largest number of readings of which all are kept.
    pub(super) most_rows: usize,
    pub(super) sieve: SharedSieve,
    pub(super) bounds: FixedBounds<'a>,
    /// True if numbers are kept for further looks.
    keeps_numbers: bool,
    /// The limits of what is kept, where all readings are.
    held: Option<Arc<HeldRows>>,
}

/// The readings and sums that the first look keeps of all readings. There are no sums of so few that all become numbers.
pub(super) struct Collected {
    pub(super) batches: Vec<Batch>,
    /// The number of batches, the first ones, that have not been summed up.
    waiting: usize,
    pub(super) rows: usize,
    /// The first row without bounds.
    pub(super) unbounded: Option<usize>,
    pub(super) open: LineSummary,
    pub(super) fixed: FixedSummary,
    pub(super) totals: Vec<Rational>,
    pub(super) kept: KeptColumns,
    pub(super) kept_rows: KeptRows,
}

/// One batch with what is made of it at once.
struct Digest {
    batch: Batch,
    unbounded: Option<usize>,
    /// `None` of a batch that is among the first few readings.
    summed: Option<Summed>,
    kept_rows: Option<KeptRows>,
}

/// Sums and columns that are kept of a batch in place of its readings.
struct Summed {
    part: Part,
    kept: Option<KeptPart>,
}

/// The readings that are kept of a batch.
enum Part {
    /// Part of a line under a uniform bound, whatever the bound is.
    Open(LineSummary),
    /// Part under fixed bounds, with the sums of each column.
    Fixed(FixedPart, Vec<Rational>),
    /// Nothing where bounds are only known when all readings are.
    Nothing,
}

impl<'a> FirstLook<'a> {
    /// Prepares the look at a source whose numbers have this meaning, and returns the source to read.
    pub(super) fn new(
        source: Source,
        columns: &'a Columns,
        meaning: &'a Meaning,
        options: &ScanOptions,
        keep: Keep,
    ) -> Result<(Self, Source), InputError> {
        let name = source.name().to_owned();
        let path = source.path().map(str::to_owned);
        let (source, reductions) = open_reduction(source, &options.table.sizes)?;
        let mut options = options.clone();
        if let Some(reductions) = &reductions {
            reductions.apply(&mut options.table).map_err(|error| InputError::of_file(&name, error))?;
            // The reduction must serve these bounds, and this check comes first.
            (options.unbounded_rows, options.same_columns) = (true, true);
        }
        // A proof names every row that touches; of a reduction the rows are few, and stand for others by their numbers.
        let most_listed =
            if options.list_rows || reductions.is_some() { usize::MAX } else { Ties::MOST_LISTED };
        let sieve = SharedSieve::listing(most_listed);
        let bounds = FixedBounds::new(meaning, &Scale::AsStated, most_listed);
        // Rows that stand for others are looked for again where a proof takes them.
        let can_look = reductions.is_none() && (keep.eui || path.is_some());
        let bounds = if can_look { bounds.telling_vertices_as_one() } else { bounds };
        // A reduction kept each of its readings for a reason.
        let keeps_all = reductions.is_some() || !(meaning.is_open() || meaning.are_bounds_known());
        let most_rows = if keeps_all { usize::MAX } else { keep.most_rows };
        // Others are kept only as long as they are few.
        let held = (most_rows == usize::MAX).then(|| HeldRows::limiting(&mut options));
        let keeps_numbers = keep.eui && !keeps_all;
        let look = FirstLook {
            name,
            path,
            columns,
            options,
            selectors: columns.selectors(),
            reductions,
            keep,
            most_rows,
            sieve,
            bounds,
            keeps_numbers,
            held,
        };
        Ok((look, source))
    }

    /// Reads every row, and shows the readings: see [`Measurements::scan_and_see`](crate::Measurements::scan_and_see).
    pub(super) fn take<T: Send + 'static>(
        &self,
        source: Source,
        see: impl Fn(&Seen<'_>) -> T + Sync + Send,
        mut seen: impl FnMut(T),
    ) -> Result<(Collected, Scanned), InputError> {
        let mut all = Collected::new(self.most_bytes());
        let reductions = self.reductions.as_ref().map(|own| {
            // Sums are told of x as it is.
            let as_it_is = Columns { form: LineForm::default(), ..self.columns.clone() };
            (own, as_it_is.meaning(&[]))
        });
        let digest = |batch: Batch| {
            let rows = reductions.as_ref().map(|(own, meaning)| KeptRows::of_batch(meaning, &batch, own));
            let shown = see(&Seen { meaning: self.bounds.meaning, batch: &batch });
            (shown, Digest { kept_rows: rows, ..Digest::new(batch, self) })
        };
        let scanned = scan(source, &self.selectors, &self.options, digest, |(shown, digest)| {
            seen(shown);
            self.held.iter().for_each(|held| held.add(digest.batch.rows.len()));
            all.take(digest, self);
        });
        if let Some(held) = &self.held {
            held.check(self.name.raw())?;
        }
        let scanned = scanned?;
        if self.held.is_some() {
            self.columns.refuse_long_in_each(&self.name, all.rows, self.options.table.sizes.work)?;
        }
        Ok((all, scanned))
    }

    /// Returns the largest number of readings that all become numbers, so that nothing is to be kept in their place, where these are
    /// columns of them.
    fn most_plain(&self, columns: &[Column]) -> usize {
        // Further looks at long numbers cost more than the numbers do, and without them less would be known.
        let are_short = || columns.iter().all(|own| matches!(own, Column::Narrow(_)));
        match self.bounds.meaning {
            // A reduction says more of a line than its readings do.
            _ if self.reductions.is_some() => 0,
            meaning if meaning.is_open() || meaning.are_bounds_known() && self.keep.eui && are_short() => {
                self.most_rows.min(self.keep.most_plain)
            }
            _ => self.most_rows,
        }
    }

    /// Returns how many bytes of numbers are kept for further looks.
    fn most_bytes(&self) -> usize {
        let usual = if self.path.is_some() { MOST_BYTES_OF_FILE } else { MOST_BYTES_OF_STREAM };
        let memory = self.options.table.sizes.memory.limit() / 2;
        self.keep.most_bytes.unwrap_or(usual.min(usize::try_from(memory).unwrap_or(usize::MAX)))
    }
}

impl Digest {
    fn new(batch: Batch, look: &FirstLook) -> Self {
        // No row has a lower number than there are rows before it.
        let last = batch.rows.len().checked_sub(1).map(|last| batch.rows.get(last));
        let is_plain = last.is_none_or(|last| last <= look.most_plain(&batch.columns));
        let summed = (!is_plain).then(|| Summed::new(&batch, look));
        let unbounded = look.columns.first_unbounded(&batch);
        Digest { batch, unbounded, summed, kept_rows: None }
    }
}

impl Summed {
    fn new(batch: &Batch, look: &FirstLook) -> Self {
        let (columns, meaning) = (&batch.columns, look.bounds.meaning);
        let row = |k| batch.rows.get(k);
        let is_open = meaning.is_open();
        let part = if is_open {
            Part::Open(LineSummary::of_columns([&columns[0], &columns[1]], None, &row, &look.sieve))
        } else if meaning.are_bounds_known() {
            Part::Fixed(look.bounds.part(columns, &row), column_totals(columns))
        } else {
            Part::Nothing
        };
        let wanted = if is_open { &columns[..1] } else { columns };
        let kept = look.keeps_numbers.then(|| KeptPart::new(wanted, batch.rows.clone()));
        Summed { part, kept }
    }
}

impl Collected {
    fn new(most_bytes: usize) -> Self {
        Collected {
            batches: Vec::new(),
            waiting: 0,
            rows: 0,
            unbounded: None,
            open: LineSummary::default(),
            fixed: FixedSummary::default(),
            totals: Vec::new(),
            kept: KeptColumns::new(most_bytes),
            kept_rows: KeptRows::default(),
        }
    }

    fn take(&mut self, Digest { batch, unbounded, summed, kept_rows }: Digest, look: &FirstLook) {
        let rows = batch.rows.len();
        self.rows += rows;
        self.unbounded = self.unbounded.or(unbounded);
        kept_rows.into_iter().for_each(|rows| self.kept_rows.add(rows));
        let is_first = self.waiting == self.batches.len();
        if summed.is_none() && is_first && self.rows <= look.most_plain(&batch.columns) {
            self.waiting += 1;
        } else {
            for position in 0..std::mem::take(&mut self.waiting) {
                let waiting = &self.batches[position];
                let (summed, rows) = (Summed::new(waiting, look), waiting.rows.len());
                self.add(summed, rows, look);
            }
            self.add(summed.unwrap_or_else(|| Summed::new(&batch, look)), rows, look);
        }
        if self.rows <= look.most_rows {
            self.batches.push(batch);
        } else {
            self.batches = Vec::new();
        }
    }

    fn add(&mut self, Summed { part, kept }: Summed, rows: usize, look: &FirstLook) {
        match part {
            Part::Open(summary) => self.open.merge(summary, &look.sieve),
            Part::Nothing => {}
            Part::Fixed(part, totals) => {
                self.fixed.merge(part, rows, &look.bounds);
                self.totals.resize(totals.len(), Rational::zero());
                self.totals.iter_mut().zip(totals).for_each(|(total, part)| *total = &*total + part);
            }
        }
        kept.into_iter().for_each(|part| self.kept.push(part));
    }

    /// Returns whether all readings become numbers.
    pub(super) fn are_plain(&self, look: &FirstLook) -> bool {
        self.waiting == self.batches.len() && self.rows <= look.most_rows
    }

    /// All readings, where all are kept.
    pub(super) fn readings(&self, meaning: &Meaning) -> Vec<Measurement> {
        readings_of(&self.batches, meaning)
    }
}
