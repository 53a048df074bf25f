//! Numeric columns of delimited text of any size, in batches.
//!
//! The bytes are cut into chunks of whole lines. A group of chunks is read in parallel (`parallel`), each as if a row
//! started with it. The fast lane (`plain`) reads a chunk, or else the rules of CSV in full (`rows`). Where one ends
//! within quotes, the next one does not start with a row: from there on chunks are read one after the other
//! (`sequential`).

mod batch;
mod builder;
mod chosen;
mod consumer;
mod csv_line;
mod first_record;
mod keys;
mod lane;
mod layout;
mod mantissa;
mod notes;
mod others;
mod parallel;
mod pieces;
mod plain;
mod preamble;
mod quoting;
mod route;
mod row;
mod rows;
mod run;
mod sequential;
mod straight;
mod values;

use std::io::Read;

use crate::binary::{DOCUMENT_START, refuse_document};
use crate::block::AskedBlock;
use crate::chunks::ChunkReader;
use crate::columns::{ColumnPlace, ColumnSelector};
use crate::error::InputError;
use crate::notes::BlockNote;
use crate::table::TextLayout;

pub(crate) use batch::check_rows;
pub use batch::{Batch, Progress, ScanOptions, Scanned};
use chosen::Chosen;
pub(crate) use consumer::Consumer;
pub(crate) use csv_line::{csv_line, each_once};
use first_record::FirstRecord;
pub use keys::RowKeys;
use notes::Notes;
pub(crate) use others::readable_rows;
pub use pieces::Pieces;
use run::Run;

/// Reads columns of delimited text as [`scan`](crate::scan) says.
pub(crate) fn scan_text(
    file: &str,
    bytes: Box<dyn Read>,
    columns: &[ColumnSelector],
    options: &ScanOptions,
    consumer: &mut Consumer,
) -> Result<Scanned, InputError> {
    let mut reader = ChunkReader::new(bytes, options.chunk_bytes, options.table.sizes.line, options.hash);
    reader.start(file, options.table.dialect.encoding)?;
    if options.table.dialect.skip_lines == 0 {
        let is_full = |text: &[u8]| text.len() >= DOCUMENT_START;
        // If the first line begins like a comment or a document, the bytes that tell the format may stand far
        // behind it.
        while matches!(reader.pending().trim_ascii_start(), [b'<' | b'%' | b'!', ..])
            && !is_full(reader.pending())
            && reader.read_on() > 0
        {}
        refuse_document(file, reader.pending())?;
    }
    // A second mark is passed over too, as CSV readers do that are handed the text behind the first one.
    reader.pass_byte_order_mark();
    let chosen = Chosen::find(file, options, &mut reader)?;
    let start = chosen.as_ref().map(|chosen| chosen.lines);
    let FirstRecord { mut layout, header_line, position } =
        FirstRecord::read(file, columns, options, &mut reader, start)?;
    let mut run = Run { file, options, consumer };
    let mut notes = Notes::default();
    let read = match chosen {
        Some(chosen) => run.read_chosen(&mut layout, &mut reader, position, &mut notes, chosen),
        None => run.read_chunks(&mut layout, &mut reader, position, &mut notes),
    };
    if options.table.block == Some(AskedBlock::All) {
        layout.block = BlockNote::of(None, None, notes.breaks + 1);
    }
    layout.mark = notes.mark_after(layout.mark);
    layout.is_comma_open = notes.comma().is_some_and(|cell| layout.numbers.has_group_commas(cell.as_bytes()));
    layout.has_comments = notes.has_comments;
    // A character that tells it may stand in any row.
    layout.encoding = reader.encoding();
    layout.skipped.add(notes.skipped);
    let (rows_total, rows_missing) = notes.settle(read, options)?;
    check_rows(file, rows_total, options)?;
    let places = &layout.places;
    Ok(Scanned {
        names: places.iter().map(ColumnPlace::title).collect(),
        header: layout.header.clone(),
        fractions: Vec::new(),
        key_name: layout.key.as_ref().map(ColumnPlace::title),
        header_line,
        // Who reads a table by the rules of CSV alone refuses rows of another length.
        layout: (layout.skipped.short_rows == 0 && layout.skipped.headers == 0 && layout.block.is_none())
            .then(|| TextLayout::new(layout.dialect(), places)),
        table: Some(layout.table_notes()),
        units: layout.units,
        rows_total,
        rows_missing,
        ranges: Vec::new(),
        bytes: reader.total(),
        sha256: reader.sha256(),
    })
}
