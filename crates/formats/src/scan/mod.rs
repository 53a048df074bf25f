//! Numeric columns of delimited text of any size, in batches.
//!
//! The bytes are cut into chunks of whole lines. Some chunks at a time are taken apart side by side (`parallel`), by the
//! fast lane (`plain`) or else by the rules of CSV in full (`rows`), each as if a row started with it. Where one ends
//! within quotes, the next one does not start with a row: from there on chunks are read one after the other
//! (`sequential`).

mod batch;
mod builder;
mod csv_line;
mod first_record;
mod layout;
mod notes;
mod others;
mod parallel;
mod plain;
mod preamble;
mod quoting;
mod rows;
mod sequential;
mod straight;
mod values;

use std::io::Read;

use crate::chunks::ChunkReader;
use crate::columns::{ColumnPlace, ColumnSelector};
use crate::error::{InputError, InputErrorKind};
use crate::table::{TextLayout, check_rows};

pub use batch::{Batch, Pieces, Progress, ScanOptions, Scanned};
pub(crate) use csv_line::{csv_line, each_once};
use first_record::FirstRecord;
use notes::Notes;
pub(crate) use others::readable_rows;

/// Reads columns of delimited text as [`scan`](crate::scan) says.
pub(crate) fn scan_text<T: Send>(
    file: &str,
    bytes: Box<dyn Read>,
    columns: &[ColumnSelector],
    options: &ScanOptions,
    work: impl Fn(Batch) -> T + Sync,
    take: impl FnMut(T),
) -> Result<Scanned, InputError> {
    let mut reader = ChunkReader::new(bytes, options.chunk_bytes, options.table.sizes.line, options.hash);
    reader.start(file)?;
    // A second mark is passed over too, as CSV readers do that are handed the text behind the first one.
    reader.pass_byte_order_mark();
    let FirstRecord { mut layout, header_line, position } =
        FirstRecord::read(file, columns, options, &mut reader)?;
    let mut run = Run { file, options, work, take };
    let mut notes = Notes::default();
    let read = run.read_chunks(&mut layout, &mut reader, position, &mut notes);
    layout.mark = notes.mark_after(layout.mark);
    layout.has_comments = notes.has_comments;
    let (rows_total, rows_missing) = notes.settle(read, options)?;
    check_rows(file, rows_total, options)?;
    let places = &layout.places;
    Ok(Scanned {
        names: places.iter().map(ColumnPlace::title).collect(),
        header: layout.header.clone(),
        fractions: Vec::new(),
        key_name: layout.key.as_ref().map(ColumnPlace::title),
        header_line,
        layout: Some(TextLayout::new(layout.dialect(), places)),
        units: layout.units,
        rows_total,
        rows_missing,
        ranges: Vec::new(),
        bytes: reader.total(),
        sha256: reader.sha256(),
    })
}

/// A scan under way.
struct Run<'a, W, K> {
    file: &'a str,
    options: &'a ScanOptions,
    work: W,
    take: K,
}

impl<W, K> Run<'_, W, K> {
    fn is_cancelled(&self) -> bool {
        self.options.progress.as_ref().is_some_and(|progress| progress.is_cancelled())
    }

    /// Tells that so many more bytes are done, and stops if that is asked for.
    fn advance(&self, bytes: u64) -> Result<(), InputError> {
        if self.is_cancelled() {
            return Err(InputError::of_file(self.file, InputErrorKind::Interrupted));
        }
        if let Some(progress) = &self.options.progress {
            progress.advanced(bytes);
        }
        Ok(())
    }
}
