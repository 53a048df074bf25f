//! Rows one after the other, by the rules of CSV in full: of the chunks that are not plain.

use memchr::memchr_iter;

use crate::error::{InputError, InputErrorKind};
use crate::records::Records;
use crate::table::check_width;

use super::builder::BatchBuilder;
use super::layout::Layout;

/// What a chunk holds.
pub(super) enum Parsed {
    /// Its rows.
    Rows(Rows),
    /// A row that ends in another chunk, unless another chunk before this one did.
    Open,
    /// Something wrong, with lines counted from the start of the chunk.
    Wrong(InputError),
}

/// The rows of a chunk.
pub(super) struct Rows {
    pub(super) batch: BatchBuilder,
    /// How many rows there are, wanted or not.
    pub(super) total: usize,
    /// How many lines there are.
    pub(super) lines: u64,
    /// How many of them end with a line feed.
    pub(super) line_feeds: u64,
}

/// Reads rows out of pieces of a table.
pub(super) struct RowReader<'a> {
    layout: &'a Layout<'a>,
    records: Records<'a>,
    total: usize,
}

impl<'a> RowReader<'a> {
    /// Rows from this line on, after so many rows.
    pub(super) fn new(layout: &'a Layout<'a>, line: u64, rows_before: usize) -> Self {
        RowReader { layout, records: layout.records(line), total: rows_before }
    }

    /// How many rows there are so far, with those before.
    pub(super) fn total(&self) -> usize {
        self.total
    }

    /// Adds the rows that end in a piece to a batch, if they are wanted.
    pub(super) fn read(&mut self, mut piece: &[u8], batch: &mut BatchBuilder) -> Result<(), InputError> {
        while self.records.next(&mut piece)? {
            self.add(batch)?;
        }
        Ok(())
    }

    /// Adds the row that no line end ends, if there is one.
    pub(super) fn finish(&mut self, batch: &mut BatchBuilder) -> Result<(), InputError> {
        let is_within_quotes = self.records.is_within_quotes();
        if !self.records.finish() {
            return Ok(());
        }
        let line = self.records.record_line();
        self.add(batch).map_err(|error| match is_within_quotes {
            // Whatever is wrong with it is so because it has swallowed the rows behind it.
            true => InputError::of_line(self.layout.file, line, InputErrorKind::OpenQuote),
            false => error,
        })
    }

    fn add(&mut self, batch: &mut BatchBuilder) -> Result<(), InputError> {
        let (record, line) = (self.records.record(), self.records.record_line());
        check_width(self.layout.file, line, record.len(), self.layout.width)?;
        self.total += 1;
        if self.layout.is_wanted(self.total) && self.layout.satisfies_conditions(record, line)? {
            self.layout.add(record, line, batch)?;
            batch.end_row(self.total, self.records.text());
        } else if self.layout.options.table.keep_others {
            self.layout.add_other(record, self.total, batch);
        }
        Ok(())
    }
}

/// Reads the rows of a chunk that comes after so many rows.
pub(super) fn parse(chunk: &[u8], layout: &Layout, rows_before: usize) -> Parsed {
    let mut reader = RowReader::new(layout, 1, rows_before);
    let mut batch = layout.batch();
    let mut read = reader.read(chunk, &mut batch);
    // Nothing follows a chunk whose last line has no end.
    if read.is_ok() && !chunk.ends_with(b"\n") {
        read = reader.finish(&mut batch);
    }
    match read {
        Err(error) => Parsed::Wrong(error),
        Ok(()) if reader.records.is_open() => Parsed::Open,
        Ok(()) => Parsed::Rows(Rows {
            batch,
            total: reader.total - rows_before,
            lines: reader.records.line() - 1,
            line_feeds: memchr_iter(b'\n', chunk).count() as u64,
        }),
    }
}

/// How many rows a chunk has, if it does not end within quotes.
pub(super) fn count(chunk: &[u8], layout: &Layout) -> usize {
    let mut records = layout.records(1);
    let mut rest = chunk;
    let mut total = 0;
    while let Ok(true) = records.next(&mut rest) {
        total += 1;
    }
    total
}
