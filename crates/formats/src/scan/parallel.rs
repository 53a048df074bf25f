//! Chunks side by side, in groups that keep all threads at work.

use boundfit_exact::DecimalMark;

use crate::chunks::{Chunk, ChunkReader};
use crate::error::InputError;
use crate::threads;

use super::consumer::{Made, Worker};
use super::first_record::Position;
use super::layout::Layout;
use super::notes::Notes;
use super::plain::{self, Ways};
use super::rows::{self, Parsed};
use super::run::Run;
use super::values::Mark;

/// Chunks of a group for each thread: enough that a slow one does not leave the other threads idle for long.
const CHUNKS_PER_THREAD: usize = 4;

/// The treatment of a group.
struct Outcome {
    made: Vec<Made>,
    /// The place where the next group starts.
    position: Position,
    /// The chunk that ends within quotes.
    open: Option<usize>,
}

impl Run<'_, '_> {
    /// Reads all rows from a position on; returns how many there are with those before.
    pub(super) fn read_chunks(
        &mut self,
        layout: &mut Layout,
        reader: &mut ChunkReader,
        position: Position,
        notes: &mut Notes,
    ) -> Result<usize, InputError> {
        let ways = Ways::new(layout);
        let mut position = position;
        let mut group = self.next_group(reader);
        while !group.is_empty() {
            let gap = notes.gap_behind().clone();
            let (outcome, mut next) = if reader.is_at_end() {
                (read_group(&group, layout, ways.as_ref(), position, notes, self.consumer.worker), Vec::new())
            } else {
                self.read_group_and_next(&group, layout, ways.as_ref(), position, notes, reader)
            };
            let Outcome { made, position: end, open } = match outcome {
                Ok(outcome) => outcome,
                Err(error) => {
                    let rest = group.into_iter().chain(next).collect();
                    return Err(self.or_blocks(error, layout, reader, position, (gap, rest)));
                }
            };
            layout.mark = notes.mark_after(layout.mark);
            made.into_iter().for_each(|made| self.consumer.take(made));
            position = end;
            let rest = group.split_off(open.unwrap_or(group.len()));
            self.advance(group.iter().map(|chunk| chunk.len() as u64).sum())?;
            if open.is_some() {
                let rest = rest.into_iter().chain(next).collect();
                return self.read_in_sequence(layout, reader, position, notes, rest);
            }
            reader.recycle(group);
            group = std::mem::take(&mut next);
        }
        if reader.has_failed() {
            return self.read_in_sequence(layout, reader, position, notes, Vec::new());
        }
        Ok(position.rows)
    }

    /// Reads the rows of a group and, at the same time, the next group.
    fn read_group_and_next(
        &self,
        group: &[Chunk],
        layout: &Layout,
        ways: Option<&Ways>,
        position: Position,
        notes: &mut Notes,
        reader: &mut ChunkReader,
    ) -> (Result<Outcome, InputError>, Vec<Chunk>) {
        let worker = self.consumer.worker;
        threads::beside(
            move || read_group(group, layout, ways, position, notes, worker),
            || self.next_group(reader),
        )
    }

    /// Reads the next chunks, as many as are needed to keep all threads at work.
    fn next_group(&self, reader: &mut ChunkReader) -> Vec<Chunk> {
        let mut group: Vec<Chunk> = reader.next_chunk().into_iter().collect();
        // Who asks for the number of threads starts them: not for a single chunk.
        if !group.is_empty() && !reader.is_at_end() {
            let size = CHUNKS_PER_THREAD * threads::count();
            while group.len() < size && !self.is_cancelled() {
                let Some(chunk) = reader.next_chunk() else { break };
                group.push(chunk);
            }
        }
        group
    }
}

/// The rows of chunks, each with how many come before it. Reads chunks once more for which the decimal mark
/// matters that the first one tells. These are chunks that tell another mark, chunks with an error, whose
/// words the mark may change, and all chunks where commas that may group digits have become decimal ones.
fn with_first_mark(
    group: &[Chunk],
    layout: &Layout,
    mut parsed: Vec<(Parsed, usize)>,
) -> Vec<(Parsed, usize)> {
    let first = |(index, (parsed, _)): (usize, &(Parsed, usize))| Some((index, parsed.mark()?));
    let Some((telling, mark)) = parsed.iter().enumerate().find_map(first) else { return parsed };
    let matters_to_all = mark == DecimalMark::Comma && layout.numbers.has_comma_cells;
    let again = |(chunk, (parsed, rows_before)): (&Chunk, (Parsed, usize))| {
        let tells_another = parsed.mark().is_some_and(|own| own != mark);
        let is_wrong = matches!(parsed, Parsed::Wrong(..));
        let parsed = match matters_to_all || tells_another || is_wrong {
            true => rows::parse(chunk, layout, Mark::Found(mark), rows_before),
            false => parsed,
        };
        (parsed, rows_before)
    };
    let behind: Vec<(Parsed, usize)> = parsed.drain(telling + 1..).collect();
    let behind = group.iter().skip(telling + 1).zip(behind).collect();
    parsed.extend(threads::map(behind, again));
    parsed
}

/// Reads the rows of a group that starts at a position, and works on them.
fn read_group(
    group: &[Chunk],
    layout: &Layout,
    ways: Option<&Ways>,
    position: Position,
    notes: &mut Notes,
    worker: Worker,
) -> Result<Outcome, InputError> {
    let mut rows_before = vec![position.rows; group.len()];
    if !layout.options.table.rows.is_all() || position.rows == 0 {
        // The number of rows before decides which rows are wanted, and the words about the first one.
        let counts = threads::map(group.iter().collect(), |chunk: &Chunk| {
            ways.and_then(|ways| plain::count(chunk, layout, ways))
                .unwrap_or_else(|| rows::count(chunk, layout))
        });
        let mut rows = position.rows;
        for (before, count) in rows_before.iter_mut().zip(counts) {
            *before = rows;
            rows += count;
        }
    }
    let parsed = threads::map(group.iter().zip(rows_before).collect(), |(chunk, rows_before)| {
        let rows = ways.and_then(|ways| plain::parse(chunk, layout, ways, rows_before));
        let in_full = || rows::parse(chunk, layout, layout.mark, rows_before);
        (rows.map_or_else(in_full, Parsed::Rows), rows_before)
    });
    let parsed = if layout.mark == Mark::Open { with_first_mark(group, layout, parsed) } else { parsed };
    let mut position = position;
    let mut open = None;
    let mut batches = Vec::with_capacity(group.len());
    for (index, (parsed, rows_before)) in parsed.into_iter().enumerate() {
        match parsed {
            Parsed::Rows(rows) => {
                notes.add(rows.notes, position.lines - 1, layout.takes_all_blocks())?;
                let shift = position.rows - rows_before;
                batches.extend(rows.batch.finish(shift));
                position.rows += rows.total;
                position.lines += rows.lines;
                position.line_feeds += rows.line_feeds;
            }
            Parsed::Open => {
                open = Some(index);
                break;
            }
            Parsed::Wrong(mut error, noticed) => {
                notes.add(noticed, position.lines - 1, layout.takes_all_blocks())?;
                error.after_lines(position.lines - 1);
                return Err(error);
            }
        }
    }
    Ok(Outcome { made: threads::map(batches, |batch| worker.work(batch)), position, open })
}
