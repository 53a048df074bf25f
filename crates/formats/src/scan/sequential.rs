//! The end of a table, chunk after chunk: where a row may go on in the next chunk, or the bytes stop unexpectedly.

use memchr::memchr_iter;

use crate::blocks::Gap;
use crate::chunks::{Chunk, ChunkReader};
use crate::error::InputError;

use super::batch::Batch;
use super::first_record::Position;
use super::layout::Layout;
use super::notes::Notes;
use super::rows::RowReader;
use super::run::Run;

impl Run<'_, '_> {
    /// Reads all rows of these chunks, which start at a position, and of what the reader has after them. Returns how many
    /// rows there are with those before.
    pub(super) fn read_in_sequence(
        &mut self,
        layout: &Layout,
        reader: &mut ChunkReader,
        position: Position,
        notes: &mut Notes,
        at_hand: Vec<Chunk>,
    ) -> Result<usize, InputError> {
        let mut rows = RowReader::new(layout, notes.mark_after(layout.mark), position.lines, position.rows);
        let mut line = position.line_feeds;
        let mut at_hand = at_hand.into_iter();
        while let Some(chunk) = at_hand.next().or_else(|| reader.next_chunk()) {
            let mut batch = layout.batch();
            let before = Position { rows: rows.total(), lines: rows.line(), line_feeds: line };
            let read = rows.read(&chunk, &mut batch);
            if let Err(error) = notes.add(rows.take_notes(), 0, layout.takes_all_blocks()).and(read) {
                let rest = [chunk].into_iter().chain(at_hand).collect();
                return Err(self.or_blocks(error, layout, reader, before, (Gap::default(), rest)));
            }
            self.hand_out(batch, chunk.len() as u64)?;
            line += memchr_iter(b'\n', &chunk).count() as u64;
            reader.recycle(vec![chunk]);
        }
        // Rows before a failure are handed out no more.
        let mut batch = layout.batch();
        let read = rows.read(reader.pending(), &mut batch);
        notes.add(rows.take_notes(), 0, layout.takes_all_blocks())?;
        read?;
        line += memchr_iter(b'\n', reader.pending()).count() as u64;
        if let Some(problem) = reader.failure() {
            return Err(InputError::of_line(self.file, line, problem));
        }
        let read = rows.finish(&mut batch);
        notes.add(rows.take_notes(), 0, layout.takes_all_blocks())?;
        read?;
        self.hand_out(batch, 0)?;
        Ok(rows.total())
    }

    pub(super) fn hand_out(&mut self, batch: Batch, bytes: u64) -> Result<(), InputError> {
        if let Some(batch) = batch.finish(0) {
            self.consumer.consume(batch);
        }
        self.advance(bytes)
    }
}
