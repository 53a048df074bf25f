//! Tables of the few readings that stand for many, with what is known about all of them in front.
//!
//! A reduction is a line `# boundfit/reduced/1 {…}`, the header of the table if it has one, and the readings that were
//! kept, as they were written. Several of them one after the other are a reduction of all their readings: `cat` is the
//! union. [`ReductionReader`] shows such a text as one table whose lines keep their numbers.

use std::io::{self, BufRead, BufReader, Cursor, Read};
use std::sync::{Arc, Mutex};

use boundfit_exact::{Limits, ParseNumberError, Rational, Reading};
use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::columns::Header;
use crate::error::InputError;
use crate::limits::SizeLimits;
use crate::source::Source;

/// How the line in front begins.
pub const REDUCTION_MARK: &str = "# boundfit/reduced/1 ";

/// The line in front of a reduction.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ReductionRecord {
    /// How many readings there were.
    pub rows: usize,
    /// How many lines of them follow.
    pub kept: usize,
    /// Whether the first line that follows is a header.
    pub header: bool,
    /// `decimal` or `binary64`: how numbers were read.
    pub reading: String,
    /// The name of the column of x.
    pub x: String,
    /// The name of the column of y.
    pub y: String,
    /// The name of the column of the error bounds, when readings were compared only with those of the same bound.
    pub epsilon: Option<String>,
    /// Σx, Σy, Σx² and Σxy over all readings, each as `p/q` or `n`.
    pub sums: [String; 4],
}

/// What is wrong with a reduction.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ReductionError {
    /// A line that begins as it should and goes on otherwise.
    #[error("the line in front of a reduction is not understood: {0}")]
    BadRecord(String),
    /// A sum that is not a number, or one beyond a limit.
    #[error("a sum in the line in front of a reduction: {0}")]
    BadSum(#[from] ParseNumberError),
    /// More readings than can be counted.
    #[error("the reductions stand for more than {} readings", usize::MAX)]
    TooManyRows,
    /// More or fewer lines than announced.
    #[error("the reduction from line {line} on announces {announced} lines of readings, but {found} follow")]
    CountMismatch {
        /// The line in front.
        line: u64,
        /// Lines announced.
        announced: usize,
        /// Lines found.
        found: usize,
    },
    /// A reduction where a table belongs.
    #[error("this is a reduction, which only 'boundfit fit' (without --by) and 'boundfit reduce' read")]
    NotHere,
    /// A range of rows of a reduction.
    #[error("no rows of a reduction can be picked: it does not have the numbers that they had")]
    NoRowNumbers,
    /// A reduction of something else than what is asked for.
    #[error("the reduction is about {what} {has}, not {asked}")]
    NotAsked {
        /// What is meant.
        what: &'static str,
        /// What the reduction says.
        has: String,
        /// What is asked for.
        asked: String,
    },
    /// Reductions of different tables.
    #[error("the reduction from line {line} on differs from the first one in {what}")]
    Different {
        /// The line in front.
        line: u64,
        /// What differs.
        what: &'static str,
    },
}

impl ReductionRecord {
    /// The sums as numbers.
    ///
    /// # Errors
    /// When one of them is not a number within the limits.
    pub fn sums(&self, limits: &Limits) -> Result<[Rational; 4], ReductionError> {
        let mut numbers = [const { None }; 4];
        for (number, text) in numbers.iter_mut().zip(&self.sums) {
            *number = Some(Reading::Decimal.read(text, limits)?);
        }
        Ok(numbers.map(Option::unwrap_or_default))
    }

    /// Whether the reduction is about these columns (x, y, and perhaps ε) and this reading of numbers.
    ///
    /// # Errors
    /// The first thing that differs.
    pub fn check(&self, names: &[String], reading: Reading) -> Result<(), ReductionError> {
        let none = || "one bound for all readings".to_owned();
        let asked = |position: usize| names.get(position).cloned();
        let epsilon = asked(2).map(|asked| (self.epsilon.clone().unwrap_or_else(none), asked));
        let compared = [
            ("the column of x", Some((self.x.clone(), asked(0).unwrap_or_default()))),
            ("the column of y", Some((self.y.clone(), asked(1).unwrap_or_default()))),
            ("error bounds from", epsilon),
            ("the reading", Some((self.reading.clone(), reading.name().to_owned()))),
        ];
        for (what, pair) in compared {
            if let Some((has, asked)) = pair.filter(|(has, asked)| has != asked) {
                return Err(ReductionError::NotAsked { what, has, asked });
            }
        }
        Ok(())
    }

    /// The line in front, without line end.
    pub fn line(&self) -> String {
        // Strings, numbers and truth values only: there is nothing in it that cannot be written.
        let json = serde_json::to_string(self).unwrap_or_default();
        format!("{REDUCTION_MARK}{json}")
    }

    fn parse(line: &[u8]) -> Result<Self, ReductionError> {
        let json = line.strip_prefix(REDUCTION_MARK.as_bytes()).unwrap_or_default();
        serde_json::from_slice(json).map_err(|error| ReductionError::BadRecord(error.to_string()))
    }

    /// What makes two reductions parts of different wholes.
    fn difference(&self, other: &Self) -> Option<&'static str> {
        [
            (self.x != other.x, "the column of x"),
            (self.y != other.y, "the column of y"),
            (self.epsilon != other.epsilon, "the column of error bounds"),
            (self.reading != other.reading, "the reading of numbers"),
            (self.header != other.header, "whether there is a header"),
        ]
        .into_iter()
        .find_map(|(differs, what)| differs.then_some(what))
    }
}

/// The records of a text, as far as it has been read.
#[derive(Debug, Clone, Default)]
pub struct Reductions(Arc<Mutex<Vec<ReductionRecord>>>);

impl Reductions {
    /// The records seen so far.
    pub fn records(&self) -> Vec<ReductionRecord> {
        // Nothing panics while it holds the lock.
        self.0.lock().map(|records| records.clone()).unwrap_or_default()
    }

    /// Whether the table has a header.
    pub fn header(&self) -> Header {
        let present = self.records().first().is_some_and(|record| record.header);
        if present { Header::Present } else { Header::Absent }
    }
}

/// Opens a source as a reduction if it is one: a table as [`ReductionReader`] shows it, and its records.
///
/// # Errors
/// When the source cannot be read or its first line is not understood.
pub fn open_reduction(
    source: Source,
    sizes: &SizeLimits,
) -> Result<(Source, Option<Reductions>), InputError> {
    if source.is_binary() {
        return Ok((source, None));
    }
    let (name, mut bytes) = source.into_parts();
    let mut start = Vec::new();
    let mark = REDUCTION_MARK.len() as u64;
    let fail = |error: io::Error| Source::stopped(&name, error);
    bytes.by_ref().take(mark).read_to_end(&mut start).map_err(fail)?;
    let is_reduction = start == REDUCTION_MARK.as_bytes();
    let bytes = Cursor::new(start).chain(bytes);
    if !is_reduction {
        return Ok((Source::new(name, bytes), None));
    }
    let mut reader = ReductionReader::new(bytes, sizes.line);
    reader.next_line().map_err(fail)?;
    let reductions = reader.reductions.clone();
    Ok((Source::new(name, reader), Some(reductions)))
}

/// Shows one or more reductions as one table: lines in front and repeated headers become blank lines.
pub struct ReductionReader<R> {
    inner: BufReader<R>,
    reductions: Reductions,
    header: Option<Vec<u8>>,
    line: u64,
    /// Where the current reduction began, and the rows of it so far.
    begun: u64,
    found: usize,
    awaits_header: bool,
    out: Vec<u8>,
    position: usize,
    longest_line: usize,
}

impl<R: Read> ReductionReader<R> {
    /// A reader of a text that begins with [`REDUCTION_MARK`]. What reads from it is to refuse lines with more bytes than
    /// `longest_line`; here longer ones are only kept from being held in memory whole.
    pub fn new(inner: R, longest_line: usize) -> Self {
        ReductionReader {
            inner: BufReader::new(inner),
            reductions: Reductions::default(),
            header: None,
            line: 0,
            begun: 0,
            found: 0,
            awaits_header: false,
            out: Vec::new(),
            position: 0,
            longest_line,
        }
    }

    /// The records, which fill while the reader is read.
    pub fn reductions(&self) -> Reductions {
        self.reductions.clone()
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
        } else if text.is_empty() {
            self.out = line;
        } else if std::mem::take(&mut self.awaits_header) {
            let different = self.header.as_ref().is_some_and(|header| header != text);
            if different {
                return Err(self.different("its header"));
            }
            self.out = if self.header.is_some() { b"\n".to_vec() } else { line.clone() };
            self.header = Some(text.to_vec());
        } else {
            self.found += 1;
            self.out = line;
        }
        Ok(true)
    }

    fn begin(&mut self, record: ReductionRecord) -> io::Result<()> {
        (self.begun, self.found, self.awaits_header) = (self.line, 0, record.header);
        let difference = {
            let mut records = self.reductions.0.lock().map_err(|_| poisoned())?;
            let difference = records.first().and_then(|first| first.difference(&record));
            records.push(record);
            difference
        };
        difference.map_or(Ok(()), |what| Err(self.different(what)))
    }

    fn different(&self, what: &'static str) -> io::Error {
        io::Error::other(ReductionError::Different { line: self.begun, what })
    }

    /// Whether as many rows as announced followed the last record.
    fn check_count(&self) -> io::Result<()> {
        let records = self.reductions.0.lock().map_err(|_| poisoned())?;
        match records.last() {
            Some(record) if record.kept != self.found => {
                let (line, announced, found) = (self.begun, record.kept, self.found);
                Err(io::Error::other(ReductionError::CountMismatch { line, announced, found }))
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
