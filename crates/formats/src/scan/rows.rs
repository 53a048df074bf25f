//! Rows one after the other, by the rules of CSV in full: of the chunks that are not plain.

use boundfit_exact::DecimalMark;
use memchr::memchr_iter;

use crate::blocks::Gap;
use crate::error::{InputError, InputErrorKind};
use crate::records::Records;

use super::batch::Batch;
use super::layout::Layout;
use super::notes::Notes;
use super::row::Row;
use super::values::Mark;

/// The content.
pub(super) enum Parsed {
    /// The rows.
    Rows(Rows),
    /// A row that ends in another chunk, unless another chunk before this one did.
    Open,
    /// Something wrong, with lines counted from the start of the chunk, and what was noticed before.
    Wrong(InputError, Notes),
}

impl Parsed {
    /// The decimal mark that the rows tell.
    pub(super) fn mark(&self) -> Option<DecimalMark> {
        let notes = match self {
            Parsed::Rows(rows) => &rows.notes,
            Parsed::Wrong(_, notes) => notes,
            Parsed::Open => return None,
        };
        notes.mark.as_ref().map(|(mark, _)| *mark)
    }
}

/// The rows of a chunk.
pub(super) struct Rows {
    pub(super) batch: Batch,
    pub(super) notes: Notes,
    /// The number of rows, wanted or not.
    pub(super) total: usize,
    /// The number of lines.
    pub(super) lines: u64,
    /// The number of lines that end with a line feed.
    pub(super) line_feeds: u64,
}

/// Reads rows out of pieces of a table.
pub(super) struct RowReader<'a> {
    layout: &'a Layout<'a>,
    records: Records<'a>,
    mark: Mark,
    notes: Notes,
    total: usize,
    /// `true` if there was a row, and what stands behind the last one as far as comments were found among records.
    has_rows: bool,
    gap: Gap,
}

impl<'a> RowReader<'a> {
    /// Rows from this line on, after so many rows and with this known of their decimal marks.
    pub(super) fn new(layout: &'a Layout<'a>, mark: Mark, line: u64, rows_before: usize) -> Self {
        let notes = Notes::default();
        let records = layout.records(line);
        RowReader { layout, records, mark, notes, total: rows_before, has_rows: false, gap: Gap::default() }
    }

    /// The line reached, from 1.
    pub(super) fn line(&self) -> u64 {
        self.records.line()
    }

    /// Returns the number of rows so far, with the rows before.
    pub(super) fn total(&self) -> usize {
        self.total
    }

    /// The findings since this was asked last.
    pub(super) fn take_notes(&mut self) -> Notes {
        std::mem::take(&mut self.notes)
    }

    /// The findings, with what stands behind the last row.
    fn notes_to_end(&mut self) -> Notes {
        let mut gap = std::mem::take(&mut self.gap);
        gap.add(self.records.gap_behind());
        self.notes.ends_with(gap);
        self.take_notes()
    }

    /// Adds the rows that end in a piece to batches, if they are wanted.
    pub(super) fn read(&mut self, mut piece: &[u8], batch: &mut Batch) -> Result<(), InputError> {
        while self.records.next(&mut piece)? {
            self.add(batch)?;
        }
        Ok(())
    }

    /// Adds the row that no line end ends, if there is one.
    pub(super) fn finish(&mut self, batch: &mut Batch) -> Result<(), InputError> {
        if !self.records.finish() {
            return Ok(());
        }
        let is_within_quotes = self.records.is_within_quotes();
        let line = self.records.record_line();
        self.add(batch).map_err(|error| match is_within_quotes {
            // Whatever is wrong with it is so because it has swallowed the rows behind it.
            true => InputError::of_line(self.layout.file, line, InputErrorKind::OpenQuote),
            false => error,
        })
    }

    fn add(&mut self, batch: &mut Batch) -> Result<(), InputError> {
        self.gap.add(self.records.take_gap());
        let (layout, record, line) = (self.layout, self.records.record(), self.records.record_line());
        if layout.is_comment(record) {
            let text: Vec<&[u8]> = record.cells().collect();
            let delimiter = layout.syntax.delimiter;
            self.gap.add_comment(&text.join(&delimiter), delimiter, layout.shape.width);
            return Ok(());
        }
        if layout.is_header(record) {
            self.notes.skipped.headers += 1;
            return Ok(());
        }
        let next_block = || InputError::of_line(layout.file, line, InputErrorKind::NextBlock);
        self.notes.gap(
            std::mem::take(&mut self.gap),
            self.has_rows,
            layout.takes_all_blocks(),
            next_block,
        )?;
        self.has_rows = true;
        layout.check_width(record, line, &mut self.notes)?;
        layout.check_beside(record, line)?;
        self.total += 1;
        let is_wanted = layout.is_wanted(self.total);
        if record.is_empty() {
            self.notes.empty_row(is_wanted.then(|| layout.first_place(record, line)));
            return Ok(());
        }
        self.notes.row();
        let keeps_others = layout.options.table.keep_others;
        if !is_wanted && !keeps_others {
            return Ok(());
        }
        if is_wanted {
            match layout.row(record, line, self.total, true, &mut self.mark, &mut self.notes)? {
                Row::Values(values) => {
                    let key = layout.key_of(record, self.records.text(), line)?;
                    if let Some((key, keys)) = key.zip(batch.keys.as_mut()) {
                        keys.push(key);
                    }
                    let columns = values.into_iter().zip(&mut batch.columns);
                    columns.for_each(|(value, column)| value.push_to(column));
                    let cells = layout.places.iter().map(|place| record.cell(place.position - 1));
                    cells.zip(&mut batch.fractions).for_each(|(cell, fractions)| fractions.count(cell));
                    if layout.options.table.keep_cells {
                        batch.cells.push(layout.cells(record));
                    }
                    batch.end_row(self.total, self.records.text());
                    self.notes.used();
                    return Ok(());
                }
                Row::Lacks(place) => {
                    layout
                        .key_of(record, self.records.text(), line)?
                        .into_iter()
                        .for_each(|key| batch.leave_out(key));
                    self.notes.lacks(place);
                    return Ok(());
                }
                Row::Unwanted if !keeps_others => return Ok(()),
                Row::Unwanted => {}
            }
        }
        // Unwanted rows are kept where they are numbers. A mix of decimal marks must be found in them too:
        // otherwise the kept rows would depend on the ends of chunks.
        match layout.row(record, line, self.total, false, &mut self.mark, &mut self.notes) {
            Ok(Row::Values(values)) => batch.others.push(layout.other(record, values, self.total)),
            Err(error) if matches!(error.kind, InputErrorKind::AnotherDecimalMark { .. }) => {
                return Err(error);
            }
            _ => {}
        }
        Ok(())
    }
}

/// Reads the rows of a chunk that comes after so many rows, with this known of their decimal marks.
pub(super) fn parse(chunk: &[u8], layout: &Layout, mark: Mark, rows_before: usize) -> Parsed {
    let mut reader = RowReader::new(layout, mark, 1, rows_before);
    let mut batch = layout.batch();
    let mut read = reader.read(chunk, &mut batch);
    // Nothing follows a chunk whose last line has no end.
    if read.is_ok() && !chunk.ends_with(b"\n") {
        read = reader.finish(&mut batch);
    }
    match read {
        Err(error) => Parsed::Wrong(error, reader.take_notes()),
        Ok(()) if reader.records.is_open() => Parsed::Open,
        Ok(()) => Parsed::Rows(Rows {
            batch,
            notes: reader.notes_to_end(),
            total: reader.total - rows_before,
            lines: reader.records.line() - 1,
            line_feeds: memchr_iter(b'\n', chunk).count() as u64,
        }),
    }
}

/// The decimal mark that a line tells, which is a row behind so many, with its error if another mark came before.
pub(super) fn told(
    line: &[u8],
    layout: &Layout,
    number: u64,
    rows_before: usize,
) -> Option<(DecimalMark, InputError)> {
    let mut reader = RowReader::new(layout, Mark::Open, number, rows_before);
    let mut batch = layout.batch();
    let read = reader.read(line, &mut batch).and_then(|()| reader.finish(&mut batch));
    read.ok().and_then(|()| reader.take_notes().mark)
}

/// Returns the number of rows of a chunk, if it does not end within quotes.
pub(super) fn count(chunk: &[u8], layout: &Layout) -> usize {
    let mut records = layout.records(1);
    let mut rest = chunk;
    let mut total = 0;
    while let Ok(true) = records.next(&mut rest) {
        let record = records.record();
        total += usize::from(!layout.is_comment(record) && !layout.is_header(record));
    }
    total
}
