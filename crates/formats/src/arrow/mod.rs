//! Numeric columns of Parquet and Arrow IPC files, in batches.

mod numbers;
mod open;
mod texts;

use std::fs::File;
use std::io::{self, Read, Seek};
use std::ops::Range;

use arrow_array::{ArrayRef, BooleanArray, RecordBatch, RecordBatchReader};
use arrow_select::filter::filter_record_batch;
use boundfit_exact::{Column, Foreign};
use sha2::{Digest, Sha256};

use crate::binary::BinaryFormat;
use crate::columns::{ColumnPlace, ColumnSelector};
use crate::error::{InputError, InputErrorKind, Place};
use crate::hash::hexadecimal;
use crate::lacking::Lacking;
use crate::memory_use::MemoryUse;
use crate::scan::check_rows;
use crate::scan::{Batch, Consumer, ScanOptions, Scanned, readable_rows};
use crate::selection::{RowNumbers, between};
use crate::threads;
use crate::wanted::WantedColumns;

use numbers::{fractions, missing, numbers};
use open::{batches, column_names, guarded, plain, rows_at_a_time, unreadable};
use texts::{BadCell, keys, lines, text};

/// The number of parts of a record batch that are decoded at a time.
const PARTS_PER_THREAD: usize = 16;

/// The memory of a number, whatever it takes in the file.
const BYTES_PER_NUMBER: u64 = 8;

/// Reads a Parquet file or an Arrow IPC file or stream, as [`scan`](crate::scan) reads text. Numbers, rows
/// and the order of batches are the same as from a CSV of the same table. The names of the columns are those
/// of the schema.
///
/// Integers and decimals are exact. Under [`Reading::Decimal`](boundfit_exact::Reading::Decimal) a float
/// stands for the shortest decimal that reads back as the same float of its width. A CSV of the float shows
/// this decimal (0.1 is 1/10). Under [`Reading::Binary64`](boundfit_exact::Reading::Binary64) a float stands
/// for itself. With [`ScanOptions::keep_text`], the rows are written as CSV of the columns asked for, which
/// reads back as the same numbers. Text is read as numbers, dictionaries as their values. Only cells of
/// wanted rows and columns need be numbers.
///
/// Cost: one pass over the wanted columns, and one over the bytes where they are hashed. Memory: some batches
/// per thread, and one record batch or the pages of a row group of the wanted columns.
///
/// # Errors
/// The first thing wrong, with the row and column.
pub(crate) fn scan_arrow(
    name: &str,
    format: BinaryFormat,
    mut file: File,
    columns: &[ColumnSelector],
    options: &ScanOptions,
    consumer: &mut Consumer,
) -> Result<Scanned, InputError> {
    let fail = |problem: InputErrorKind| InputError::of_file(name, problem);
    let bytes = file.metadata().map_err(|error| fail(error.into()))?.len();
    let sha256 = options.hash.then(|| sha256(&file)).transpose().map_err(|error| fail(error.into()))?;
    let names = guarded(format, || column_names(format, &file)).map_err(fail)?;
    let rows = Rows { wanted: WantedColumns::new(name, &names, columns, options)? };
    let mut batches = guarded(format, || batches(format, &file, rows.positions())).map_err(fail)?;
    let mut progress = Follower { options, reported: 0 };
    let mut unpacked = 0;
    let next = || {
        let batch = guarded(format, || batches.next().transpose())?;
        if let Some(batch) = &batch {
            unpacked += BYTES_PER_NUMBER * (batch.num_rows() * batch.num_columns()) as u64;
            options.table.sizes.check_ratio(bytes, unpacked)?;
        }
        Ok(batch)
    };
    // Clones of a file share their position; in Parquet it jumps between columns.
    let scanned = rows.scan(next, || progress.at(file.stream_position().unwrap_or_default()), consumer)?;
    progress.at(bytes).map_err(fail)?;
    Ok(Scanned { header: names, bytes, sha256, ..scanned })
}

/// Reads record batches that come from somewhere else as [`scan_arrow`] reads those of a file. There are no bytes to hash.
///
/// # Errors
/// The first thing wrong, with the row and column, or where they came from.
pub(crate) fn scan_batches(
    name: &str,
    reader: Box<dyn RecordBatchReader>,
    columns: &[ColumnSelector],
    options: &ScanOptions,
    consumer: &mut Consumer,
) -> Result<Scanned, InputError> {
    let names: Vec<Foreign> =
        reader.schema().fields().iter().map(|field| Foreign::from(field.name())).collect();
    let rows = Rows { wanted: WantedColumns::new(name, &names, columns, options)? };
    let positions = rows.positions();
    let mut batches = reader.map(|batch| batch?.project(&positions));
    let format = BinaryFormat::ArrowStream;
    let next = || guarded(format, || batches.next().transpose().map_err(|error| unreadable(format, error)));
    let mut progress = Follower { options, reported: 0 };
    let scanned = rows.scan(next, || progress.at(0), consumer)?;
    Ok(Scanned { header: names, ..scanned })
}

/// Consecutive rows of a file.
struct Part {
    first_row: usize,
    batch: RecordBatch,
    /// `true` if these rows may be wanted; else they are kept where they hold numbers.
    is_wanted: bool,
}

/// The rows of record batches, and which of their columns are wanted.
struct Rows<'a> {
    wanted: WantedColumns<'a>,
}

impl Rows<'_> {
    /// Hands the rows of record batches out, which have the columns that are read, in their order. `advanced` is called between them.
    fn scan(
        &self,
        mut next: impl FnMut() -> Result<Option<RecordBatch>, InputErrorKind>,
        mut advanced: impl FnMut() -> Result<(), InputErrorKind>,
        consumer: &mut Consumer,
    ) -> Result<Scanned, InputError> {
        let options = self.wanted.options;
        let fail = |problem: InputErrorKind| InputError::of_file(self.wanted.file, problem);
        let (mut rows_total, mut more) = (0, true);
        let (mut used, mut lacking) = (0, Lacking::default());
        let memory = options.table.sizes.memory.nothing();
        while more {
            let mut group = Vec::new();
            memory.give_back();
            while more && group.len() < threads::count() {
                more = match next().map_err(fail)? {
                    Some(batch) => {
                        // The library tells how large a record batch is when it has it.
                        let bytes = batch.get_array_memory_size() as u64;
                        memory.ask(bytes, MemoryUse::Batches).map_err(fail)?;
                        group.extend(self.parts(rows_total + 1, &batch));
                        rows_total += batch.num_rows();
                        true
                    }
                    None => false,
                };
            }
            // A record batch may have any number of rows.
            while !group.is_empty() {
                let later = group.split_off(group.len().min(PARTS_PER_THREAD * threads::count()));
                let worker = consumer.worker;
                let decoded: Vec<Result<_, InputError>> = threads::map(group, |part| {
                    let (batch, lacking) = self.decode(&part)?;
                    let used = batch.rows.len();
                    Ok((worker.work(batch), used, lacking))
                });
                for result in decoded {
                    match result {
                        Ok((made, rows, later)) => {
                            consumer.take(made);
                            used += rows;
                            lacking.add(later);
                        }
                        Err(error) => {
                            return lacking.settle(Err(error), used, options).map(|(never, _)| never);
                        }
                    }
                }
                group = later;
            }
            advanced().map_err(fail)?;
        }
        check_rows(self.wanted.file, rows_total, options)?;
        let ((), rows_missing) = lacking.settle(Ok(()), used, options)?;
        Ok(self.wanted.scanned(rows_total, rows_missing))
    }

    /// The indices of all columns that are read, ascending.
    fn positions(&self) -> Vec<usize> {
        let looked_at = self.wanted.conditions.iter().map(|(place, _)| place);
        let places =
            self.wanted.places.iter().chain(&self.wanted.key).chain(&self.wanted.identity).chain(looked_at);
        let mut positions: Vec<usize> = places.map(|place| place.position - 1).collect();
        positions.sort_unstable();
        positions.dedup();
        positions
    }

    /// A batch that starts with this row in parts that are not too large, without rows that are not kept.
    fn parts(&self, first_row: usize, batch: &RecordBatch) -> Vec<Part> {
        let end = first_row + batch.num_rows();
        let most = rows_at_a_time(batch.columns().iter().map(|column| column.data_type()));
        let parts = |ranges: Vec<Range<usize>>, is_wanted: bool| {
            ranges.into_iter().flat_map(move |rows| {
                rows.clone().step_by(most).map(move |start| {
                    let length = most.min(rows.end - start);
                    Part { first_row: start, batch: batch.slice(start - first_row, length), is_wanted }
                })
            })
        };
        let wanted = self.wanted.options.table.rows.among(first_row, end);
        let unwanted =
            if self.wanted.options.table.keep_others { between(&wanted, first_row, end) } else { Vec::new() };
        parts(wanted, true).chain(parts(unwanted, false)).collect()
    }

    /// The batch that is handed out for a part, and the rows that are left out of it since they lack a number.
    fn decode(&self, part: &Part) -> Result<(Batch, Lacking), InputError> {
        let Part { first_row, batch, is_wanted } = part;
        let all = *first_row..first_row + batch.num_rows();
        let mut lacking = Lacking::default();
        let [satisfying, wanted] = match is_wanted {
            true => self.with_values(*first_row, batch, &mut lacking)?,
            false => Default::default(),
        };
        if wanted.len() == batch.num_rows() {
            return Ok((self.numbers(wanted, batch)?, lacking));
        }
        let is_wanted: BooleanArray = all.clone().map(|row| Some(wanted.position(row).is_some())).collect();
        let filtered = filter_record_batch(batch, &is_wanted);
        let unreadable = |error| unreadable(BinaryFormat::ArrowFile, error);
        let filtered = filtered.map_err(|error| InputError::of_file(self.wanted.file, unreadable(error)))?;
        let keys_missing = self.keys_missing(*first_row, batch, [&satisfying, &wanted])?;
        let numbers = Batch { keys_missing, ..self.numbers(wanted, &filtered)? };
        if !self.wanted.options.table.keep_others {
            return Ok((numbers, lacking));
        }
        let read = |rows: Range<usize>| {
            let part = batch.slice(rows.start - first_row, rows.len());
            self.numbers([rows].into_iter().collect(), &part)
        };
        let satisfying: Vec<Range<usize>> =
            satisfying.ranges().map(|[first, last]| first..last + 1).collect();
        let unwanted = between(&satisfying, all.start, all.end).into_iter();
        let others = unwanted.flat_map(|rows| readable_rows(rows, &read)).collect();
        Ok((Batch { others, ..numbers }, lacking))
    }

    /// Returns the rows of a batch, which starts with this one, that satisfy all conditions as far as they have the
    /// numbers for them. Returns as well those of them that lack no number.
    fn with_values(
        &self,
        first_row: usize,
        batch: &RecordBatch,
        lacking: &mut Lacking,
    ) -> Result<[RowNumbers; 2], InputError> {
        let rows = first_row..first_row + batch.num_rows();
        let numbers: RowNumbers = [rows.clone()].into_iter().collect();
        let mut columns = Vec::new();
        for (place, condition) in &self.wanted.conditions {
            let optional = condition.column().clone().optional();
            columns.push((self.column(place, &optional, &numbers, batch)?, *condition));
        }
        let mut gaps = Vec::new();
        for place in self.wanted.needed() {
            let array = self.array(place, batch)?;
            gaps.push((place, missing(&array), array));
        }
        if columns.is_empty() && gaps.iter().all(|(_, missing, _)| missing.is_none()) {
            return Ok([numbers.clone(), numbers]);
        }
        let lacks = |gap: &(&ColumnPlace, Option<Vec<bool>>, ArrayRef), index: usize| {
            gap.1.as_ref().and_then(|missing| missing.get(index)).is_some_and(|&is_missing| is_missing)
        };
        let [mut satisfying, mut wanted] = [RowNumbers::default(), RowNumbers::default()];
        for row in rows {
            let index = row - first_row;
            let mut conditions = columns.iter().zip(&gaps);
            if !conditions
                .all(|((column, condition), gap)| lacks(gap, index) || condition.holds(&column.get(index)))
            {
                continue;
            }
            satisfying.push(row);
            match gaps.iter().find(|gap| lacks(gap, index)) {
                None => wanted.push(row),
                Some((place, _, array)) => lacking.notice(|| {
                    let text = array.is_valid(index).then(|| text(array, index)).flatten();
                    let bad = BadCell {
                        index: Some(index),
                        text: text.map(Foreign::from),
                        problem: InputErrorKind::Null,
                    };
                    self.error(place, Some(&numbers), bad)
                }),
            }
        }
        Ok([satisfying, wanted])
    }

    /// The keys of the rows that satisfy all conditions and lack a number, one of equal neighbours.
    fn keys_missing(
        &self,
        first_row: usize,
        batch: &RecordBatch,
        [satisfying, wanted]: [&RowNumbers; 2],
    ) -> Result<Vec<String>, InputError> {
        let Some(place) = &self.wanted.key else { return Ok(Vec::new()) };
        let is_missing = |row: usize| satisfying.position(row).is_some() && wanted.position(row).is_none();
        let keys = keys(&self.array(place, batch)?).map_err(|bad| self.error(place, None, bad))?;
        let rows = (0..batch.num_rows()).filter(|index| is_missing(first_row + index));
        let mut missing: Vec<String> = rows.map(|index| keys.get(index).to_owned()).collect();
        missing.dedup();
        Ok(missing)
    }

    /// The numbers and keys of a batch that has these rows.
    fn numbers(&self, rows: RowNumbers, batch: &RecordBatch) -> Result<Batch, InputError> {
        let columns = self.wanted.places.iter().zip(self.wanted.selectors);
        let columns = columns.map(|(place, selector)| self.column(place, selector, &rows, batch));
        let columns = columns.collect::<Result<_, _>>()?;
        let key_column = |place: &ColumnPlace| {
            keys(&self.array(place, batch)?).map_err(|bad| self.error(place, Some(&rows), bad))
        };
        let keys = self.wanted.key.as_ref().map(key_column).transpose()?;
        let lines = if self.wanted.options.keep_text {
            let arrays = self.wanted.written().into_iter().map(|place| self.array(place, batch));
            Some(lines(&arrays.collect::<Result<Vec<_>, _>>()?, self.wanted.options.table.reading))
        } else {
            None
        };
        let fractions = self.wanted.places.iter().map(|place| Ok(fractions(&self.array(place, batch)?)));
        let fractions = fractions.collect::<Result<_, InputError>>()?;
        let (keys_missing, cells, others) = (Vec::new(), Vec::new(), Vec::new());
        Ok(Batch { rows, columns, keys, keys_missing, lines, fractions, cells, others })
    }

    /// The numbers of one column of a batch that has these rows.
    fn column(
        &self,
        place: &ColumnPlace,
        selector: &ColumnSelector,
        rows: &RowNumbers,
        batch: &RecordBatch,
    ) -> Result<Column, InputError> {
        numbers(&self.array(place, batch)?, selector, &self.wanted.options.table, &self.wanted.meter)
            .map_err(|bad| self.error(place, Some(rows), bad))
    }

    /// One column of a batch as it is stored.
    fn array(&self, place: &ColumnPlace, batch: &RecordBatch) -> Result<ArrayRef, InputError> {
        let positions = self.positions();
        let index = positions.partition_point(|&position| position < place.position - 1);
        plain(batch.column(index)).map_err(|problem| self.error(place, None, BadCell::of_column(problem)))
    }

    fn error(&self, place: &ColumnPlace, rows: Option<&RowNumbers>, bad: BadCell) -> InputError {
        let place = Place {
            row: rows.zip(bad.index).map(|(rows, index)| rows.get(index)),
            column: Some((place.position, place.name.clone())),
            text: bad.text,
            ..Place::default()
        };
        InputError::new(self.wanted.file, place, bad.problem)
    }
}

/// Tells who follows the scan how far it is.
struct Follower<'a> {
    options: &'a ScanOptions,
    reported: u64,
}

impl Follower<'_> {
    fn at(&mut self, position: u64) -> Result<(), InputErrorKind> {
        if let Some(progress) = &self.options.progress {
            progress.advanced(position.saturating_sub(self.reported));
            if progress.is_cancelled() {
                return Err(InputErrorKind::Interrupted);
            }
        }
        self.reported = self.reported.max(position);
        Ok(())
    }
}

/// SHA-256 of a file's bytes, in hexadecimal.
fn sha256(mut file: &File) -> io::Result<String> {
    let mut hash = Sha256::new();
    let mut buffer = vec![0; 1 << 16];
    loop {
        match file.read(&mut buffer) {
            Ok(0) => return Ok(hexadecimal(&hash)),
            Ok(count) => hash.update(buffer.get(..count).unwrap_or(&buffer)),
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
}
