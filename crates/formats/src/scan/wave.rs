//! Chunks side by side.

use csv::ByteRecord;
use rayon::prelude::*;

use crate::error::InputError;

use super::Run;
use super::batch::Batch;
use super::chunks::{Chunk, ChunkReader};
use super::layout::Layout;
use super::library::{self, Parsed, RowReader};
use super::plain::{self, Route};
use super::sequential::Rest;

/// Chunks of a wave for each thread: enough that a slow one does not leave the other threads idle for long.
const CHUNKS_PER_THREAD: usize = 4;

/// How far the rows have been read.
#[derive(Debug, Clone, Copy)]
pub(super) struct Position {
    /// How many rows.
    pub(super) rows: usize,
    /// The line reached, from 1.
    pub(super) lines: u64,
    /// The same, counted by line feeds alone.
    pub(super) line_feeds: u64,
}

/// What became of a wave.
struct Outcome<T> {
    made: Vec<T>,
    /// Where the next wave starts.
    position: Position,
    /// The chunk that ends within quotes.
    open: Option<usize>,
}

impl<T: Send, W: Fn(Batch) -> T + Sync, K: FnMut(T)> Run<'_, W, K> {
    /// Reads all rows from a position on; returns how many there are with those before.
    pub(super) fn read_chunks(
        &mut self,
        layout: &Layout,
        reader: &mut ChunkReader,
        position: Position,
    ) -> Result<usize, InputError> {
        let route = Route::new(layout);
        let mut position = position;
        let mut wave = self.next_wave(reader);
        if !reader.is_at_end() {
            keep_freed_memory();
        }
        while !wave.is_empty() {
            let (outcome, mut next) = if reader.is_at_end() {
                (read_wave(&wave, layout, route.as_ref(), position, &self.work), Vec::new())
            } else {
                self.read_wave_and_next(&wave, layout, route.as_ref(), position, reader)
            };
            let Outcome { made, position: end, open } = outcome?;
            made.into_iter().for_each(&mut self.take);
            position = end;
            let rest = wave.split_off(open.unwrap_or(wave.len()));
            self.advance(wave.iter().map(|chunk| chunk.len() as u64).sum())?;
            if open.is_some() {
                let rest = rest.into_iter().chain(next).collect();
                return self.read_rest(layout, reader, position, rest);
            }
            reader.recycle(wave);
            wave = std::mem::take(&mut next);
        }
        if reader.has_failed() {
            return self.read_rest(layout, reader, position, Vec::new());
        }
        Ok(position.rows)
    }

    /// Reads the rows of a wave and, at the same time, the next wave.
    fn read_wave_and_next(
        &self,
        wave: &[Chunk],
        layout: &Layout,
        route: Option<&Route>,
        position: Position,
        reader: &mut ChunkReader,
    ) -> (Result<Outcome<T>, InputError>, Vec<Chunk>) {
        let mut outcome = Ok(Outcome { made: Vec::new(), position, open: None });
        let work = &self.work;
        let next = rayon::in_place_scope(|scope| {
            let outcome = &mut outcome;
            scope.spawn(move |_| *outcome = read_wave(wave, layout, route, position, work));
            self.next_wave(reader)
        });
        (outcome, next)
    }

    /// Reads all rows of these chunks and after them, row after row.
    fn read_rest(
        &mut self,
        layout: &Layout,
        reader: &mut ChunkReader,
        position: Position,
        chunks: Vec<Chunk>,
    ) -> Result<usize, InputError> {
        // The library passes over this line end, and does not take what follows for the start of a file, where it would
        // pass over a byte order mark too.
        let line_end = Chunk::from(b"\n".as_slice());
        let chunks = [line_end].into_iter().chain(chunks).collect();
        let input = Rest::new(chunks, reader, position.line_feeds - 1);
        let records = layout.records(input, position.lines - 1);
        self.read_rows(RowReader::new(layout, records, ByteRecord::new()), position.rows, false)
    }

    /// Reads the next chunks, as many as are needed to keep all threads at work.
    fn next_wave(&self, reader: &mut ChunkReader) -> Vec<Chunk> {
        let mut wave: Vec<Chunk> = reader.next_chunk().into_iter().collect();
        // Who asks for the number of threads starts them: not for a single chunk.
        if !wave.is_empty() && !reader.is_at_end() {
            let size = CHUNKS_PER_THREAD * rayon::current_num_threads();
            while wave.len() < size && !self.is_cancelled() {
                let Some(chunk) = reader.next_chunk() else { break };
                wave.push(chunk);
            }
        }
        wave
    }
}

/// Has the allocator keep what is freed, as far as it learns from what it sees: the C library of GNU gives freed memory
/// back to the system from 128 KiB on, and gets it anew for the next batch, until a larger piece is freed. That took a
/// fifth of the processor time of a scan.
fn keep_freed_memory() {
    const LARGER_THAN_THE_COLUMNS_OF_A_WAVE: usize = 1 << 24;
    drop(std::hint::black_box(Vec::<u8>::with_capacity(LARGER_THAN_THE_COLUMNS_OF_A_WAVE)));
}

/// Reads the rows of a wave that starts at a position, and works on them.
fn read_wave<T: Send>(
    wave: &[Chunk],
    layout: &Layout,
    route: Option<&Route>,
    position: Position,
    work: &(impl Fn(Batch) -> T + Sync),
) -> Result<Outcome<T>, InputError> {
    let mut rows_before = vec![position.rows; wave.len()];
    if layout.options.table.rows.is_some() {
        // Which rows are wanted depends on how many come before.
        let counts = on_all_threads(wave.iter().collect(), |chunk: &Chunk| {
            route
                .and_then(|route| plain::count(chunk, layout, route))
                .unwrap_or_else(|| library::count(chunk, layout))
        });
        let mut rows = position.rows;
        for (before, count) in rows_before.iter_mut().zip(counts) {
            *before = rows;
            rows += count;
        }
    }
    let parsed = on_all_threads(wave.iter().zip(rows_before).collect(), |(chunk, rows_before)| {
        let rows = route.and_then(|route| plain::parse(chunk, layout, route, rows_before));
        (rows.map_or_else(|| library::parse(chunk, layout, rows_before), Parsed::Rows), rows_before)
    });
    let mut position = position;
    let mut open = None;
    let mut batches = Vec::with_capacity(wave.len());
    for (index, (parsed, rows_before)) in parsed.into_iter().enumerate() {
        match parsed {
            Parsed::Rows(rows) => {
                batches.extend(rows.batch.finish(position.rows - rows_before));
                position.rows += rows.total;
                position.lines += rows.lines;
                position.line_feeds += rows.line_feeds;
            }
            Parsed::Open => {
                open = Some(index);
                break;
            }
            Parsed::Wrong(mut error) => {
                if let Some(line) = &mut error.place.line {
                    *line += position.lines - 1;
                }
                return Err(error);
            }
        }
    }
    Ok(Outcome { made: on_all_threads(batches, work), position, open })
}

/// The results for all items in their order, made on the threads of the current pool; a single one on this thread.
fn on_all_threads<I: Send, T: Send>(items: Vec<I>, make: impl Fn(I) -> T + Sync + Send) -> Vec<T> {
    if items.len() == 1 {
        return items.into_iter().map(make).collect();
    }
    items.into_par_iter().map(make).collect()
}
