//! Opening a file or standard input, and watching the bytes go by.

use std::fs::File;
use std::io::{self, Read};

use sha2::{Digest, Sha256};

use crate::error::{InputError, Place, Problem};

/// The longest line that is read, in bytes. Without a bound, a file without line ends would be held in memory whole.
pub const LONGEST_LINE: usize = 1 << 24;

/// A named stream of bytes.
pub struct Source {
    name: String,
    bytes: Box<dyn Read>,
}

impl Source {
    /// Opens a file, or standard input for `-`.
    ///
    /// # Errors
    /// When the file cannot be opened or is a directory.
    pub fn open(path: &str) -> Result<Self, InputError> {
        if path == "-" {
            return Ok(Source::new("standard input", io::stdin()));
        }
        let fail = |problem: Problem| Source::error(path, Place::default(), problem);
        let file = File::open(path).map_err(|error| fail(Problem::Io(error)))?;
        if file.metadata().is_ok_and(|metadata| metadata.is_dir()) {
            return Err(fail(Problem::IsDirectory));
        }
        Ok(Source::new(path, file))
    }

    /// A source with a name for messages.
    pub fn new(name: impl Into<String>, bytes: impl Read + 'static) -> Self {
        Source { name: name.into(), bytes: Box::new(bytes) }
    }

    /// The name that messages use.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The error for a problem at a place of this source.
    pub(crate) fn error(name: &str, place: Place, problem: impl Into<Problem>) -> InputError {
        InputError { file: name.to_owned(), place: Box::new(place), problem: problem.into() }
    }

    pub(crate) fn watched(self) -> (String, WatchedReader) {
        let reader = WatchedReader { bytes: self.bytes, hash: Sha256::new(), line: 1, since_line_end: 0 };
        (self.name, reader)
    }
}

/// A reader that hashes what passes and stops at a line that never ends.
pub(crate) struct WatchedReader {
    bytes: Box<dyn Read>,
    hash: Sha256,
    line: u64,
    since_line_end: usize,
}

impl WatchedReader {
    /// SHA-256 of all bytes read so far, in hexadecimal.
    pub(crate) fn sha256(&self) -> String {
        self.hash.clone().finalize().iter().map(|byte| format!("{byte:02x}")).collect()
    }

    /// The line in which the reader stands, from 1.
    pub(crate) fn line(&self) -> u64 {
        self.line
    }

    /// The problem behind a reading error: the line limit comes out of the reader as an error of its own.
    pub(crate) fn problem(&self, error: io::Error) -> Problem {
        if self.since_line_end > LONGEST_LINE {
            Problem::LineTooLong { limit: LONGEST_LINE }
        } else {
            error.into()
        }
    }
}

impl Read for WatchedReader {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.bytes.read(buffer)?;
        let bytes = &buffer[..count];
        self.hash.update(bytes);
        for piece in bytes.split_inclusive(|&byte| byte == b'\n') {
            self.since_line_end += piece.len();
            if self.since_line_end > LONGEST_LINE {
                return Err(io::Error::other("line too long"));
            }
            if piece.ends_with(b"\n") {
                self.line += 1;
                self.since_line_end = 0;
            }
        }
        Ok(count)
    }
}
