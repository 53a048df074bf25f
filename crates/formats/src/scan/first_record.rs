//! The first record of a table: whether it is a header, and where the columns are.

use memchr::memchr_iter;

use crate::chunks::ChunkReader;
use crate::columns::ColumnSelector;
use crate::error::{InputError, InputErrorKind};
use crate::records::Records;

use super::batch::ScanOptions;
use super::layout::Layout;

/// How far the rows have been read.
#[derive(Debug, Clone, Copy)]
pub(super) struct Position {
    /// How many rows.
    pub(super) rows: usize,
    /// The line reached, from 1.
    pub(super) lines: u64,
    /// The line reached when line feeds alone are counted.
    pub(super) line_feeds: u64,
}

/// What the first record tells.
pub(super) struct FirstRecord<'a> {
    pub(super) layout: Layout<'a>,
    /// The header as it stands in the file, where text is kept.
    pub(super) header_line: Option<Vec<u8>>,
    /// Where the rows start.
    pub(super) position: Position,
}

impl<'a> FirstRecord<'a> {
    /// Reads the first record, and has the reader pass over it if it is a header.
    pub(super) fn read(
        file: &'a str,
        delimiter: u8,
        columns: &'a [ColumnSelector],
        options: &'a ScanOptions,
        reader: &mut ChunkReader,
    ) -> Result<Self, InputError> {
        let mut records = Records::new(file, delimiter, 1, options.table.sizes.line, options.keep_text);
        let mut end = 0;
        let mut is_within_quotes = false;
        loop {
            let mut rest = reader.pending().get(end..).unwrap_or_default();
            let is_found = records.next(&mut rest)?;
            end = reader.pending().len() - rest.len();
            if is_found {
                break;
            }
            if reader.read_on() > 0 {
                continue;
            }
            if let Some(problem) = reader.failure() {
                return Err(InputError::of_line(file, 1 + line_feeds(reader.pending()), problem));
            }
            is_within_quotes = records.is_within_quotes();
            if !records.finish() {
                return Err(InputError::of_file(file, InputErrorKind::Empty));
            }
            break;
        }
        let line = records.record_line();
        let layout = Layout::new(file, records.record(), line, delimiter, columns, options);
        let layout = layout.map_err(|error| match is_within_quotes {
            true => InputError::of_line(file, line, InputErrorKind::OpenQuote),
            false => error,
        })?;
        let mut position = Position { rows: 0, lines: 1, line_feeds: 1 };
        let mut header_line = None;
        if layout.has_header {
            header_line = records.text().map(<[u8]>::to_vec);
            // A record ends with the first half of its line end.
            if reader.pending().get(..end).is_some_and(|record| record.ends_with(b"\r")) {
                if reader.pending().len() == end {
                    reader.read_on();
                }
                end += usize::from(reader.pending().get(end) == Some(&b'\n'));
            }
            position.lines = records.line();
            position.line_feeds += line_feeds(reader.pending().get(..end).unwrap_or_default());
            reader.skip(end);
        }
        Ok(FirstRecord { layout, header_line, position })
    }
}

fn line_feeds(bytes: &[u8]) -> u64 {
    memchr_iter(b'\n', bytes).count() as u64
}
