//! Numeric columns of a table of any size, in batches.
//!
//! The bytes are cut into chunks of whole lines (`chunks`). The chunks of a wave are taken apart side by side (`wave`), by
//! the fast lane (`plain`) or else by the CSV library (`library`), each as if a row started with it. Where one ends
//! within quotes, the next one does not start with a row: from there on the library reads row after row
//! (`sequential`). So rows and errors are those of [`read_table`](crate::read_table).

mod batch;
pub(crate) mod builder;
mod chunks;
mod head;
mod layout;
mod library;
mod plain;
mod sequential;
mod tape;
mod wave;

use crate::binary::BinaryFormat;
use crate::columns::{ColumnPlace, ColumnSelector};
use crate::error::{InputError, InputErrorKind};
use crate::mat::scan_mat;
use crate::source::Source;
use crate::start::detect_delimiter;
use crate::table::{TextLayout, check_rows};

pub use batch::{Batch, Column, Pieces, Progress, ScanOptions, Scanned};
use chunks::ChunkReader;
use head::{Head, Start};
use library::RowReader;
use sequential::Rest;

/// Reads the columns asked for like [`read_table`](crate::read_table), with the same numbers and the same errors, but
/// hands the rows out in batches instead of keeping them; with the feature `arrow`, Parquet and Arrow IPC files too.
/// `work` is called for each batch of consecutive wanted rows, on the threads of the current rayon pool, in any order; `take` with what it made of them, on the calling thread and
/// in the order of the file. A file of one batch needs no pool.
///
/// ```
/// use boundfit_formats::{ColumnSelector, ScanOptions, Source, scan};
///
/// let table = Source::new("data.csv", "x,y\n1,2.5\n3,4.25\n".as_bytes());
/// let columns = [ColumnSelector::name_or_number("y")];
/// let mut largest = None;
/// let largest_of = |batch: boundfit_formats::Batch| (0..batch.rows).map(|row| batch.columns[0].get(row)).max();
/// let scanned =
///     scan(table, &columns, &ScanOptions::default(), largest_of, |found| largest = found.max(largest.take()))?;
/// assert_eq!((scanned.rows_total, largest.unwrap().to_string()), (2, "17/4".to_owned()));
/// # Ok::<(), boundfit_formats::InputError>(())
/// ```
///
/// Which rows make a batch follows from the file and [`ScanOptions::chunk_bytes`] alone. Exact. Cost: one pass; memory
/// for a few batches per thread, whatever the size of the file.
///
/// # Errors
/// The first thing wrong, with its place; by then batches before it may have been handed out.
pub fn scan<T: Send>(
    source: Source,
    columns: &[ColumnSelector],
    options: &ScanOptions,
    work: impl Fn(Batch) -> T + Sync,
    take: impl FnMut(T),
) -> Result<Scanned, InputError> {
    let source = match source.into_binary(BinaryFormat::is_matlab) {
        Ok((name, table)) => return scan_mat(&name, table, columns, options, work, take),
        Err(other) => other,
    };
    #[cfg(feature = "arrow")]
    let source = match source.into_binary(|_| true) {
        Ok((name, table)) => return crate::arrow::scan_arrow(&name, table, columns, options, work, take),
        Err(text) => text,
    };
    let (file, bytes) = source.into_parts();
    let mut reader = ChunkReader::new(bytes, options);
    reader.start(&file)?;
    let delimiter = options.table.delimiter.unwrap_or_else(|| detect_delimiter(reader.rest()));
    let start = Start { file: &file, delimiter, columns, options };
    let mut run = Run { file: &file, options, work, take };
    let (head, rows_total) = match start.plain_head(&mut reader)? {
        Some((head, position)) => {
            let rows = run.read_chunks(&head.layout, &mut reader, position)?;
            (head, rows)
        }
        None => {
            let mut records = start.records(Rest::new(Vec::new(), &mut reader, 1), 1);
            let (head, record) = start.head(&mut records)?;
            let has_row = !head.layout.has_header;
            let rows = run.read_rows(RowReader::new(&head.layout, records, record), 0, has_row)?;
            (head, rows)
        }
    };
    check_rows(&file, rows_total, options.table.rows)?;
    let Head { layout, header_line } = head;
    Ok(Scanned {
        names: layout.places.iter().map(ColumnPlace::title).collect(),
        key_name: layout.key.as_ref().map(ColumnPlace::title),
        header_line,
        delimiter,
        layout: Some(TextLayout::new(
            delimiter,
            layout.has_header,
            &layout.places,
            options.table.rows,
            rows_total,
        )),
        rows_total,
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
