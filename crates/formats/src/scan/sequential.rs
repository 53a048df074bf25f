//! The rest of a table, row after row: where a row may go on in the next chunk, or the bytes stop unexpectedly.

use std::collections::VecDeque;
use std::io::{self, Read};

use memchr::memchr_iter;

use crate::error::InputError;
use crate::source::Stopped;

use super::Run;
use super::batch::Batch;
use super::builder::BatchBuilder;
use super::chunks::{Chunk, ChunkReader};
use super::library::RowReader;

/// Chunks one after the other as a stream, those already at hand first.
pub(super) struct Rest<'a> {
    current: Chunk,
    position: usize,
    at_hand: VecDeque<Chunk>,
    reader: &'a mut ChunkReader,
    /// The line reached, counted by line feeds from 1.
    line: u64,
}

impl<'a> Rest<'a> {
    /// The stream of these chunks, which start on this line, and of what the reader has after them.
    pub(super) fn new(at_hand: Vec<Chunk>, reader: &'a mut ChunkReader, line: u64) -> Self {
        Rest { current: Chunk::default(), position: 0, at_hand: at_hand.into(), reader, line }
    }
}

impl Read for Rest<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        while self.position == self.current.len() {
            self.position = 0;
            if let Some(chunk) = self.at_hand.pop_front().or_else(|| self.reader.next_chunk()) {
                let old = std::mem::replace(&mut self.current, chunk);
                self.reader.recycle(vec![old]);
            } else if !self.reader.rest().is_empty() {
                self.current.set(self.reader.rest());
                self.reader.skip(self.current.len());
            } else if let Some(problem) = self.reader.failure() {
                self.current.set(b"");
                return Err(io::Error::other(Stopped { line: self.line, problem }));
            } else {
                self.current.set(b"");
                return Ok(0);
            }
        }
        let mut rest = self.current.get(self.position..).unwrap_or_default();
        let count = rest.read(buffer)?;
        self.position += count;
        self.line += memchr_iter(b'\n', buffer.get(..count).unwrap_or_default()).count() as u64;
        Ok(count)
    }
}

impl<T, W: Fn(Batch) -> T, K: FnMut(T)> Run<'_, W, K> {
    /// Reads all rows that a reader has, after so many rows before; the first one may have been read. Returns how many
    /// rows there are with those before.
    pub(super) fn read_rows<R: Read>(
        &mut self,
        mut reader: RowReader<'_, R>,
        rows_before: usize,
        has_row: bool,
    ) -> Result<usize, InputError> {
        let mut total = rows_before;
        let mut batch = reader.layout().batch();
        let mut batch_start = 0;
        let mut more = has_row || reader.next()?;
        while more {
            total += 1;
            reader.add(total, &mut batch)?;
            let bytes = reader.taken() - batch_start;
            if bytes >= self.options.chunk_bytes as u64 {
                batch_start += bytes;
                self.hand_out(std::mem::replace(&mut batch, reader.layout().batch()), bytes)?;
            }
            more = reader.next()?;
        }
        self.hand_out(batch, reader.taken() - batch_start)?;
        Ok(total)
    }

    fn hand_out(&mut self, batch: BatchBuilder, bytes: u64) -> Result<(), InputError> {
        if let Some(batch) = batch.finish(0) {
            (self.take)((self.work)(batch));
        }
        self.advance(bytes)
    }
}
