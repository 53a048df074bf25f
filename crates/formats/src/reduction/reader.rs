//! Reductions one after the other, read as one table.

use std::io::{self, BufRead, BufReader, Cursor, Read};
use std::sync::{Arc, Mutex};

use crate::block::AskedBlock;
use crate::columns::Header;
use crate::error::InputError;
use crate::limits::SizeLimits;
use crate::source::Source;
use crate::table::TableOptions;

use super::error::ReductionError;
use super::record::{REDUCTION_MARK, ReductionRecord};

/// The records of a text, as far as it has been read.
#[derive(Debug, Clone, Default)]
pub struct Reductions(Arc<Mutex<Seen>>);

/// The readings so far.
#[derive(Debug, Default)]
struct Seen {
    records: Vec<ReductionRecord>,
    /// The number of rows, and for each row that does not stand for one reading its place among all rows and
    /// its count.
    rows: usize,
    counts: Vec<(usize, u64)>,
}

impl Seen {
    fn push(&mut self, count: u64) {
        if count != 1 {
            self.counts.push((self.rows, count));
        }
        self.rows += 1;
    }
}

impl Reductions {
    /// The records seen so far.
    pub fn records(&self) -> Vec<ReductionRecord> {
        // Nothing panics while it holds the lock.
        self.0.lock().map(|seen| seen.records.clone()).unwrap_or_default()
    }

    /// Returns the number of readings that each row stands for, in order; `None` where no reduction says so.
    ///
    /// # Errors
    /// When it is not known which row is which.
    pub fn counts(&self, rows: usize) -> Result<Option<Vec<u64>>, ReductionError> {
        let Ok(mut seen) = self.0.lock() else { return Ok(None) };
        if !seen.records.iter().any(|record| record.counted) {
            return Ok(None);
        }
        if seen.rows != rows {
            return Err(ReductionError::RowsOfSeveralLines);
        }
        let mut counts = vec![1; rows];
        for (row, count) in std::mem::take(&mut seen.counts) {
            counts.get_mut(row).into_iter().for_each(|own| *own = count);
        }
        Ok(Some(counts))
    }

    /// Returns, for the rows with these numbers (from 1) that stand for more than one reading, their position
    /// and the number of further readings. Rows that have not been read stand for themselves.
    pub fn beside_themselves(&self, rows: impl Iterator<Item = usize>) -> Vec<(usize, u64)> {
        let Ok(seen) = self.0.lock() else { return Vec::new() };
        let count = |row: usize| {
            let place = seen.counts.binary_search_by_key(&row.checked_sub(1)?, |(row, _)| *row).ok()?;
            seen.counts.get(place).map(|(_, count)| *count)
        };
        rows.map(|row| count(row).unwrap_or(1).saturating_sub(1))
            .enumerate()
            .filter(|&(_, others)| others > 0)
            .collect()
    }

    /// Sets how the rows are read: with or without a header, across the lines in front, and with the marks and words that were
    /// stated where the table was reduced.
    ///
    /// # Errors
    /// When a mark is stated that differs.
    pub fn apply(&self, table: &mut TableOptions) -> Result<(), ReductionError> {
        let records = self.records();
        let first = records.first();
        let present = first.is_some_and(|record| record.header);
        table.header = if present { Header::Present } else { Header::Absent };
        // Records stand between the rows of several.
        table.block = Some(AskedBlock::All);
        first.map_or(Ok(()), |record| record.written.apply(table))
    }
}

/// Opens a source as a reduction if it is one: a table whose lines keep their numbers, and its records.
///
/// # Errors
/// When the source cannot be read or its first line is not understood.
pub fn open_reduction(
    source: Source,
    sizes: &SizeLimits,
) -> Result<(Source, Option<Reductions>), InputError> {
    source.with_text(sizes, |name, mut bytes| {
        let fail = |error: io::Error| InputError::of_file(name, error);
        let mut start = Vec::new();
        let mark = REDUCTION_MARK.len() as u64;
        bytes.by_ref().take(mark).read_to_end(&mut start).map_err(fail)?;
        let is_reduction = start == REDUCTION_MARK.as_bytes();
        let bytes: Box<dyn Read> = Box::new(Cursor::new(start).chain(bytes));
        if !is_reduction {
            return Ok((bytes, None));
        }
        let mut reader = ReductionReader::new(bytes, sizes.line);
        reader.next_line().map_err(fail)?;
        let reductions = reader.reductions.clone();
        Ok((Box::new(reader) as Box<dyn Read>, Some(reductions)))
    })
}

/// Shows one or more reductions as one table: lines in front and repeated headers become blank lines.
struct ReductionReader<R> {
    inner: BufReader<R>,
    reductions: Reductions,
    header: Option<Vec<u8>>,
    line: u64,
    /// The place where the current reduction began, and the rows of it so far.
    begun: u64,
    found: usize,
    /// The number of readings that the rows of the current reduction stand for so far; `None` where they do
    /// not say so.
    counted: Option<u64>,
    /// The number of lines of the header that are still to come, and those before.
    awaited: usize,
    begun_header: Vec<u8>,
    out: Vec<u8>,
    position: usize,
    longest_line: usize,
}

impl<R: Read> ReductionReader<R> {
    /// A reader of a text that begins with [`REDUCTION_MARK`]. The reader of its lines refuses lines with
    /// more bytes than `longest_line`; this reader only avoids holding them whole in memory.
    fn new(inner: R, longest_line: usize) -> Self {
        ReductionReader {
            inner: BufReader::new(inner),
            reductions: Reductions::default(),
            header: None,
            line: 0,
            begun: 0,
            found: 0,
            counted: None,
            awaited: 0,
            begun_header: Vec::new(),
            out: Vec::new(),
            position: 0,
            longest_line,
        }
    }

    /// Reads one line and puts what is to be seen of it into `out`; `false` at the end.
    fn next_line(&mut self) -> io::Result<bool> {
        let mut line = Vec::new();
        let limit = self.longest_line as u64 + 2;
        self.inner.by_ref().take(limit).read_until(b'\n', &mut line)?;
        if line.is_empty() {
            self.check_count()?;
            return Ok(false);
        }
        self.line += 1;
        self.position = 0;
        let text = line.trim_ascii_end();
        if text.starts_with(REDUCTION_MARK.as_bytes()) {
            self.check_count()?;
            self.begin(ReductionRecord::parse(text).map_err(io::Error::other)?)?;
            self.out = b"\n".to_vec();
        } else if text.is_empty() && self.begun_header.is_empty() {
            self.out = line;
        } else if self.awaited > 0 {
            self.header_line(line)?;
        } else {
            self.out = self.row(line)?;
            self.found += 1;
        }
        Ok(true)
    }

    /// Takes a line of the header, of which cells in quotes may have several.
    fn header_line(&mut self, line: Vec<u8>) -> io::Result<()> {
        self.begun_header.extend(line.trim_ascii_end());
        self.begun_header.push(b'\n');
        if self.begun_header.len() > self.longest_line.saturating_add(1) {
            let problem = "its header is longer than a line may be";
            return Err(io::Error::other(ReductionError::BadRecord(problem.into())));
        }
        self.awaited -= 1;
        self.out = if self.header.is_some() { b"\n".to_vec() } else { line };
        if self.awaited > 0 {
            return Ok(());
        }
        let header = std::mem::take(&mut self.begun_header);
        match &self.header {
            Some(first) if *first != header => Err(self.different("its header")),
            _ => {
                self.header = Some(header);
                Ok(())
            }
        }
    }

    /// A line of a row without how many readings it stands for, which is noted.
    fn row(&mut self, line: Vec<u8>) -> io::Result<Vec<u8>> {
        let mut seen = self.reductions.0.lock().map_err(|_| poisoned())?;
        let Some(counted) = &mut self.counted else {
            seen.push(1);
            return Ok(line);
        };
        let fail = || io::Error::other(ReductionError::NoCount { line: self.line });
        let end = line.iter().position(|byte| !byte.is_ascii_digit()).ok_or_else(fail)?;
        let (count, rest) = line.split_at_checked(end).ok_or_else(fail)?;
        let count: u64 = str::from_utf8(count).ok().and_then(|count| count.parse().ok()).ok_or_else(fail)?;
        let rest = rest.strip_prefix(b" ").ok_or_else(fail)?;
        // A line within a row belongs to one that has begun.
        if count > 0 {
            seen.push(count);
            *counted = counted.saturating_add(count);
        } else if self.found == 0 {
            return Err(fail());
        }
        Ok(rest.to_vec())
    }

    fn begin(&mut self, record: ReductionRecord) -> io::Result<()> {
        self.counted = record.counted.then_some(0);
        (self.begun, self.found) = (self.line, 0);
        self.awaited = if record.header { record.header_lines.max(1) } else { 0 };
        self.begun_header.clear();
        let difference = {
            let records = &mut self.reductions.0.lock().map_err(|_| poisoned())?.records;
            let difference = records.first().and_then(|first| first.difference(&record));
            records.push(record);
            difference
        };
        difference.map_or(Ok(()), |what| Err(self.different(what)))
    }

    fn different(&self, what: &'static str) -> io::Error {
        io::Error::other(ReductionError::Different { line: self.begun, what })
    }

    /// Returns whether as many rows as announced followed the last record.
    fn check_count(&self) -> io::Result<()> {
        let seen = self.reductions.0.lock().map_err(|_| poisoned())?;
        match seen.records.last() {
            Some(record) if record.kept != self.found => {
                let (line, announced, found) = (self.begun, record.kept, self.found);
                Err(io::Error::other(ReductionError::CountMismatch { line, announced, found }))
            }
            Some(record) if self.counted.is_some_and(|counted| counted > record.rows as u64) => {
                let (line, rows, counted) = (self.begun, record.rows, self.counted.unwrap_or_default());
                Err(io::Error::other(ReductionError::CountsTooMany { line, rows, counted }))
            }
            _ => Ok(()),
        }
    }
}

/// Cannot happen: nothing panics while it holds the lock.
fn poisoned() -> io::Error {
    io::Error::other("another thread stopped")
}

impl<R: Read> Read for ReductionReader<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if self.position == self.out.len() && (buffer.is_empty() || !self.next_line()?) {
            return Ok(0);
        }
        let count = self.out.get(self.position..).unwrap_or_default().read(buffer)?;
        self.position += count;
        Ok(count)
    }
}
