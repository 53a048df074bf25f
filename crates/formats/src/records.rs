//! Records of delimited text, by the CSV library, with the lines on which they start.

use std::io::{self, Read};
use std::ops::Range;

use csv::{ByteRecord, ReaderBuilder};

use crate::error::{InputError, Place};
use crate::lines::LineCounter;
use crate::source::Source;

/// Reads the records that are not blank, one after the other.
pub(crate) struct Records<R> {
    reader: csv::Reader<LineCounter<R>>,
    /// Where the last record starts, before the line ends that the library skips.
    start: u64,
}

impl<R: Read> Records<R> {
    /// Records of at most so many bytes of an input that starts on this line.
    pub(crate) fn new(input: R, delimiter: u8, line: u64, longest: usize) -> Self {
        let reader = ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .delimiter(delimiter)
            .from_reader(LineCounter::new(input, line, longest));
        Records { reader, start: 0 }
    }

    /// Reads the next record that is not blank; `false` when there is none.
    pub(crate) fn next(&mut self, file: &str, record: &mut ByteRecord) -> Result<bool, InputError> {
        loop {
            let start = self.reader.position().byte();
            self.reader.get_mut().begin(start);
            match self.reader.read_byte_record(record) {
                Ok(more) => {
                    self.start = start;
                    let end = self.reader.position().byte();
                    if let Some(problem) = self.reader.get_ref().too_long(end) {
                        let place = Place { line: Some(self.line()), ..Place::default() };
                        return Err(InputError::new(file, place, problem));
                    }
                    let is_blank =
                        record.len() == 1 && record.iter().all(|cell| cell.trim_ascii().is_empty());
                    if !(more && is_blank) {
                        return Ok(more);
                    }
                }
                Err(error) => {
                    let error = match error.into_kind() {
                        csv::ErrorKind::Io(error) => error,
                        other => io::Error::other(format!("{other:?}")),
                    };
                    return Err(Source::stopped(file, error));
                }
            }
        }
    }

    /// The line on which the last record starts, from 1.
    pub(crate) fn line(&self) -> u64 {
        self.reader.get_ref().record_line()
    }

    /// The bytes of the input that make the last record, with line ends around it.
    pub(crate) fn range(&self) -> Range<u64> {
        self.start..self.reader.position().byte()
    }

    /// What the records are read from.
    pub(crate) fn input(&self) -> &R {
        self.reader.get_ref().get_ref()
    }

    /// What the records are read from.
    pub(crate) fn input_mut(&mut self) -> &mut R {
        self.reader.get_mut().get_mut()
    }
}
