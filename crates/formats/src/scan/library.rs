//! Rows by the CSV library: the chunks that are not plain.

use std::io::Read;

use csv::ByteRecord;
use memchr::memchr_iter;

use crate::error::InputError;
use crate::records::Records;
use crate::table::check_width;

use super::builder::BatchBuilder;
use super::layout::Layout;
use super::tape::Tape;

/// Stands before the bytes of a chunk: the library passes over it, and does not take what follows for the start of a
/// file, where it would pass over a byte order mark.
const LINE_END: &[u8] = b"\n";
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

/// Reads rows one after the other.
pub(super) struct RowReader<'a, R> {
    layout: &'a Layout<'a>,
    records: Records<Tape<R>>,
    record: ByteRecord,
}

impl<'a, R: Read> RowReader<'a, R> {
    /// The last record read may be the first row.
    pub(super) fn new(layout: &'a Layout<'a>, records: Records<Tape<R>>, record: ByteRecord) -> Self {
        RowReader { layout, records, record }
    }

    /// Reads the next row; `false` when there is none.
    pub(super) fn next(&mut self) -> Result<bool, InputError> {
        self.records.next(self.layout.file, &mut self.record)
    }

    /// What is taken from every row.
    pub(super) fn layout(&self) -> &'a Layout<'a> {
        self.layout
    }

    /// Where the bytes taken so far end.
    pub(super) fn taken(&self) -> u64 {
        self.records.range().end
    }

    /// Checks the last row read and adds it to a batch if it is wanted.
    pub(super) fn add(&mut self, row: usize, batch: &mut BatchBuilder) -> Result<(), InputError> {
        let line = self.records.line();
        check_width(self.layout.file, line, self.record.len(), self.layout.width)?;
        let text = self.records.text();
        if self.layout.is_wanted(row) {
            self.layout.add(&self.record, line, batch)?;
            batch.end_row(row, text.as_deref());
        }
        Ok(())
    }
}

/// Reads the rows of a chunk that comes after so many rows.
pub(super) fn parse(chunk: &[u8], layout: &Layout, rows_before: usize) -> Parsed {
    // A record of its own, unless the chunk ends within quotes.
    let mark: &[u8] = if layout.delimiter == b'0' { b"1" } else { b"0" };
    let behind = if chunk.ends_with(b"\n") { mark } else { b"" };
    let end = (LINE_END.len() + chunk.len()) as u64;
    let records = layout.records(LINE_END.chain(chunk).chain(behind), 0);
    let mut reader = RowReader::new(layout, records, ByteRecord::new());
    let mut batch = layout.batch();
    let mut total = 0;
    loop {
        match reader.next() {
            Ok(true) => {}
            Ok(false) => break,
            Err(error) => return Parsed::Wrong(error),
        }
        if reader.taken() > end {
            if reader.record.iter().eq([mark]) {
                break;
            }
            return Parsed::Open;
        }
        total += 1;
        if let Err(error) = reader.add(rows_before + total, &mut batch) {
            return Parsed::Wrong(error);
        }
    }
    let line_feeds = memchr_iter(b'\n', chunk).count() as u64;
    Parsed::Rows(Rows { batch, total, lines: lines_in(chunk), line_feeds })
}

/// How many rows a chunk has, if it does not end within quotes.
pub(super) fn count(chunk: &[u8], layout: &Layout) -> usize {
    let mut records =
        Records::new(LINE_END.chain(chunk), layout.delimiter, 0, layout.options.table.sizes.line);
    let mut record = ByteRecord::new();
    let mut total = 0;
    while let Ok(true) = records.next(layout.file, &mut record) {
        total += 1;
    }
    total
}

/// How many lines end in a chunk: a carriage return and a line feed right after it are one end.
pub(super) fn lines_in(chunk: &[u8]) -> u64 {
    let ends = |(index, byte): (usize, &u8)| match byte {
        b'\n' => true,
        b'\r' => chunk.get(index + 1) != Some(&b'\n'),
        _ => false,
    };
    chunk.iter().enumerate().filter(|&item| ends(item)).count() as u64
}
