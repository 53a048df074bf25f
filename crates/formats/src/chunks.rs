//! The bytes of a table in chunks of whole lines.

use std::io::{self, Read};
use std::ops::Deref;

use memchr::{memchr, memchr_iter, memchr2, memrchr};

use crate::binary::refuse_binary;
use crate::budget::HeldMemory;
use crate::decoding::TextReader;
use crate::dialect::Encoding;
use crate::error::{InputError, InputErrorKind};
use crate::limits::LONGEST_LINE;
use crate::memory_use::MemoryUse;
use crate::start::{FirstLine, refuse_other, without_mark};

/// The number of bytes read beyond the size of a chunk, to find the end of its last line without another
/// call.
const BEYOND: usize = 4096;

/// Some consecutive bytes, in a buffer that is used again.
#[derive(Default)]
pub(crate) struct Chunk {
    buffer: Vec<u8>,
    /// The places in the buffer where the bytes start and end.
    start: usize,
    end: usize,
}

impl Deref for Chunk {
    type Target = [u8];

    fn deref(&self) -> &[u8] {
        self.buffer.get(self.start..self.end).unwrap_or_default()
    }
}

impl Chunk {
    /// Replaces what is in it.
    pub(crate) fn set(&mut self, bytes: &[u8]) {
        (self.start, self.end) = (0, bytes.len());
        match self.buffer.get_mut(..bytes.len()) {
            Some(start) => start.copy_from_slice(bytes),
            None => self.buffer = bytes.to_vec(),
        }
    }
}

/// States whether more bytes come.
enum State {
    More,
    End,
    Failed(InputErrorKind),
}

/// Cuts a stream of bytes into chunks of whole lines of UTF-8, and hashes it.
///
/// A chunk ends with the first line end at or after its size, so that the cuts follow from the bytes alone.
pub(crate) struct ChunkReader {
    text: TextReader,
    chunk_bytes: usize,
    longest_line: usize,
    /// Bytes that were read but belong to the next chunk.
    pending: Chunk,
    state: State,
    since_line_end: usize,
    spare: Vec<Chunk>,
}

impl ChunkReader {
    /// Chunks of at least so many bytes, with lines of at most so many.
    pub(crate) fn new(bytes: Box<dyn Read>, chunk_bytes: usize, longest_line: usize, hash: bool) -> Self {
        ChunkReader {
            text: TextReader::new(bytes, hash),
            chunk_bytes: chunk_bytes.clamp(1, LONGEST_LINE),
            longest_line,
            pending: Chunk::default(),
            state: State::More,
            since_line_end: 0,
            spare: Vec::new(),
        }
    }

    /// Reads the first line that is not blank, if there is one, in this encoding or the one that the text tells, and passes over a byte
    /// order mark.
    pub(crate) fn start(&mut self, file: &str, asked: Option<Encoding>) -> Result<(), InputError> {
        let mut search = FirstLine::default();
        self.text.begin(asked);
        refuse_binary(file, self.text.held())?;
        let mut added = self.read_on();
        // Blank lines are passed over where lines are counted: a packed file may have any number of them.
        while added > 0 && !search.is_in(&self.pending, added) && !search.is_far_away() {
            added = self.read_on();
        }
        // An error behind the first line has nothing to do with the line.
        if !FirstLine::default().is_in(&self.pending, self.pending.len())
            && let Some(problem) = self.failure()
        {
            let line = 1 + memchr_iter(b'\n', &self.pending).count() as u64;
            return Err(InputError::of_line(file, line, problem));
        }
        refuse_other(&self.pending).map_err(|problem| InputError::of_file(file, problem))?;
        self.pass_byte_order_mark();
        Ok(())
    }

    /// Returns the encoding of the text, as far as the text was read.
    pub(crate) fn encoding(&self) -> Encoding {
        self.text.encoding()
    }

    /// Returns the two ends of the line that starts at this place of the pending bytes: before its line end,
    /// and behind it. Reads on as far as needed; `None` when nothing is there.
    pub(crate) fn line_at(&mut self, start: usize) -> Option<(usize, usize)> {
        let mut searched = start;
        loop {
            let rest = self.pending.get(searched..).unwrap_or_default();
            if let Some(end) = memchr2(b'\r', b'\n', rest).map(|length| searched + length) {
                if self.pending.get(end) == Some(&b'\r') && self.pending.len() == end + 1 {
                    self.read_on();
                }
                let is_pair = self.pending.get(end..).is_some_and(|rest| rest.starts_with(b"\r\n"));
                return Some((end, end + 1 + usize::from(is_pair)));
            }
            searched = self.pending.len().max(start);
            if self.read_on() == 0 {
                return (start < searched).then_some((searched, searched));
            }
        }
    }

    /// Passes over a byte order mark in front of what was not handed out, if there is one.
    pub(crate) fn pass_byte_order_mark(&mut self) {
        self.skip(self.pending.len() - without_mark(&self.pending).len());
    }

    /// All bytes that were not handed out, at once, but no more than this.
    pub(crate) fn read_to_end(
        &mut self,
        file: &str,
        limit: u64,
        memory: &HeldMemory,
    ) -> Result<Vec<u8>, InputError> {
        let mut content = Vec::new();
        while let Some(chunk) = self.next_chunk() {
            let asked = memory.ask(chunk.len() as u64, MemoryUse::Text);
            asked.map_err(|problem| InputError::of_file(file, problem))?;
            content.extend_from_slice(&chunk);
            if content.len() as u64 > limit {
                return Err(InputError::of_file(file, InputErrorKind::TextTooLarge { limit }));
            }
            self.recycle(vec![chunk]);
        }
        match self.failure() {
            Some(problem) => {
                let line_feeds =
                    [&content, self.pending()].map(|bytes| memchr_iter(b'\n', bytes).count() as u64);
                Err(InputError::of_line(file, 1 + line_feeds.iter().sum::<u64>(), problem))
            }
            None => Ok(content),
        }
    }

    /// Bytes that were read but not yet handed out.
    pub(crate) fn pending(&self) -> &[u8] {
        &self.pending
    }

    /// Reads more than what was not handed out; gives how many bytes came. None come at the end and after a failure.
    pub(crate) fn read_on(&mut self) -> usize {
        if !matches!(self.state, State::More) {
            return 0;
        }
        let mut pending = std::mem::take(&mut self.pending);
        let added = self.read_more(&mut pending);
        self.pending = pending;
        added
    }

    /// Passes over the first bytes of what was not handed out.
    pub(crate) fn skip(&mut self, count: usize) {
        self.pending.start += count;
    }

    /// The next chunk of whole lines; the last one may lack its line end. `None` at the end, and when the bytes stop
    /// for another reason: then [`Self::failure`] has it, and [`Self::pending`] the bytes before it.
    #[allow(
        clippy::indexing_slicing,
        reason = "searched never exceeds the length of the chunk, and a position found by memchr lies behind it"
    )]
    pub(crate) fn next_chunk(&mut self) -> Option<Chunk> {
        let mut chunk = std::mem::take(&mut self.pending);
        let mut searched = (self.chunk_bytes - 1).min(chunk.len());
        let end = loop {
            if let Some(position) = memchr(b'\n', &chunk[searched..]) {
                break searched + position + 1;
            }
            searched = chunk.len().max(searched);
            match self.state {
                State::More => {
                    self.read_more(&mut chunk);
                    searched = searched.max((self.chunk_bytes - 1).min(chunk.len()));
                }
                State::End if chunk.is_empty() => return None,
                State::End => break chunk.len(),
                State::Failed(_) => {
                    self.pending = chunk;
                    return None;
                }
            }
        };
        let mut other = self.spare.pop().unwrap_or_default();
        // The shorter part is copied: what was read to see the first rows may be many chunks, of which none takes all of it.
        if end <= chunk.len() - end {
            other.set(&chunk[..end]);
            chunk.start += end;
            (chunk, other) = (other, chunk);
        } else {
            other.set(&chunk[end..]);
            chunk.end = chunk.start + end;
        }
        self.pending = other;
        Some(chunk)
    }

    /// Returns whether all bytes have been handed out.
    pub(crate) fn is_at_end(&self) -> bool {
        matches!(self.state, State::End) && self.pending.is_empty()
    }

    /// Returns whether the bytes stopped before their end, and [`Self::failure`] was not asked why.
    pub(crate) fn has_failed(&self) -> bool {
        matches!(self.state, State::Failed(_))
    }

    /// Returns the reason why the bytes stopped before their end.
    pub(crate) fn failure(&mut self) -> Option<InputErrorKind> {
        match std::mem::replace(&mut self.state, State::End) {
            State::Failed(problem) => Some(problem),
            state => {
                self.state = state;
                None
            }
        }
    }

    /// Takes back the buffers of chunks.
    pub(crate) fn recycle(&mut self, chunks: Vec<Chunk>) {
        self.spare.extend(chunks);
    }

    /// Returns the number of bytes that were read.
    pub(crate) fn total(&self) -> u64 {
        self.text.total()
    }

    /// SHA-256 of all bytes read, in hexadecimal.
    pub(crate) fn sha256(&self) -> Option<String> {
        self.text.sha256()
    }

    /// Reads into the free part of a buffer once; returns how many bytes came.
    #[allow(
        clippy::indexing_slicing,
        reason = "the buffer was made larger than before, and a reader gives no more bytes than there is room for"
    )]
    fn read_more(&mut self, chunk: &mut Chunk) -> usize {
        if chunk.start > 0 {
            chunk.buffer.copy_within(chunk.start..chunk.end, 0);
            (chunk.start, chunk.end) = (0, chunk.end - chunk.start);
        }
        let before = chunk.end;
        let size = (self.chunk_bytes.saturating_add(BEYOND)).max(before + BEYOND);
        if chunk.buffer.is_empty() {
            // Zeros come from the system without being written: a few rows touch few of them.
            chunk.buffer = vec![0; size];
        } else if chunk.buffer.len() < size {
            // A line that goes on and on is read in pieces that grow with it.
            chunk.buffer.resize(size.max(before + before / 2), 0);
        }
        let count = loop {
            match self.text.read(&mut chunk.buffer[before..]) {
                Ok(0) => {
                    self.state = State::End;
                    return 0;
                }
                Ok(count) => break count,
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                Err(error) => {
                    self.state = State::Failed(error.into());
                    return 0;
                }
            }
        };
        let fresh = &chunk.buffer[before..before + count];
        if self.since_line_end + count > self.longest_line
            && let Some(end) = end_of_longest(fresh, self.since_line_end, self.longest_line)
        {
            self.state = State::Failed(InputErrorKind::LineTooLong { limit: self.longest_line });
            chunk.end = before + end;
            return end;
        }
        self.since_line_end =
            memrchr(b'\n', fresh).map_or(self.since_line_end + count, |position| count - position - 1);
        chunk.end = before + count;
        count
    }
}

/// Returns the place where the first line passes the limit, given the number of its bytes that came before.
fn end_of_longest(bytes: &[u8], before: usize, limit: usize) -> Option<usize> {
    let mut line_start = 0;
    let mut before = before;
    for end in memchr_iter(b'\n', bytes).map(|position| position + 1).chain([bytes.len()]) {
        if before + end - line_start > limit {
            return Some(line_start + limit - before);
        }
        before = 0;
        line_start = end;
    }
    None
}
