//! Opening a file or standard input, and watching the bytes go by.

use std::fs::File;
use std::io::{self, Read};

use sha2::{Digest, Sha256};
use thiserror::Error;

use crate::binary::{BinaryFormat, BinaryTable};
use crate::error::{InputError, InputErrorKind};
use crate::limits::SizeLimits;

/// What messages call the input named `-`.
pub(crate) const STANDARD_INPUT: &str = "standard input";

/// A named stream of bytes.
pub struct Source {
    name: String,
    bytes: Box<dyn Read>,
    /// The same file, when it is a binary table that this build can read.
    binary: Option<BinaryTable>,
}

impl Source {
    /// Opens a file, or standard input for `-`. Of a file that grows while it is read, what was there when it was opened
    /// is seen.
    ///
    /// # Errors
    /// When the file cannot be opened or is a directory.
    pub fn open(path: &str) -> Result<Self, InputError> {
        if path == "-" {
            return Ok(Source::new(STANDARD_INPUT, io::stdin()));
        }
        let fail = |problem: InputErrorKind| InputError::of_file(path, problem);
        let file = File::open(path).map_err(|error| fail(InputErrorKind::Io(error)))?;
        let metadata = file.metadata().map_err(|error| fail(InputErrorKind::Io(error)))?;
        if metadata.is_dir() {
            return Err(fail(InputErrorKind::IsDirectory));
        }
        let binary = BinaryTable::of(&file).map_err(|error| fail(InputErrorKind::Io(error)))?;
        let source = Source { binary, ..Source::new(path, file) };
        // Pipes, devices and the files of /proc state no length.
        let states_length = metadata.is_file() && metadata.len() > 0;
        Ok(if states_length { source.limited(metadata.len()) } else { source })
    }

    /// A source with a name for messages.
    pub fn new(name: impl Into<String>, bytes: impl Read + 'static) -> Self {
        Source { name: name.into(), bytes: Box::new(bytes), binary: None }
    }

    /// The same, but not more than so many bytes of it.
    pub fn limited(self, most_bytes: u64) -> Self {
        Source { bytes: Box::new(self.bytes.take(most_bytes)), ..self }
    }

    /// The name that messages use.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The error for bytes that stopped coming, as a [`WatchedReader`] reports it.
    pub(crate) fn stopped(name: &str, error: io::Error) -> InputError {
        match error.downcast::<Stopped>() {
            Ok(Stopped { line, problem }) => InputError::of_line(name, line, problem),
            Err(error) => InputError::of_file(name, error),
        }
    }

    /// Whether this is a binary table that this build can read.
    pub(crate) fn is_binary(&self) -> bool {
        self.binary.is_some()
    }

    /// Whether the numbers in this file are stored in binary, exactly, so that no reading of text applies: in a MATLAB
    /// file. What is reported of them is the binary64 reading.
    pub fn is_stored(&self) -> bool {
        self.binary.as_ref().is_some_and(|table| table.format.is_matlab())
    }

    /// The name and the binary table, if this is one of a format like this.
    pub(crate) fn into_binary(
        mut self,
        is_meant: impl Fn(BinaryFormat) -> bool,
    ) -> Result<(String, BinaryTable), Self> {
        match self.binary.take_if(|table| is_meant(table.format)) {
            Some(table) => Ok((self.name, table)),
            None => Err(self),
        }
    }

    pub(crate) fn into_parts(self) -> (String, Box<dyn Read>) {
        (self.name, self.bytes)
    }

    pub(crate) fn watched(self, sizes: &SizeLimits) -> (String, WatchedReader) {
        let reader = WatchedReader {
            bytes: self.bytes,
            hash: Sha256::new(),
            line: 1,
            since_line_end: 0,
            longest_line: sizes.line,
        };
        (self.name, reader)
    }
}

/// A reader that claims to have read more than there was room for; none of the standard library's does.
pub(crate) fn over_full() -> io::Error {
    io::Error::other("more bytes than the buffer holds")
}

/// Why no more bytes come, and in which line, counted by line feeds from 1.
#[derive(Debug, Error)]
#[error("{problem}")]
pub(crate) struct Stopped {
    pub(crate) line: u64,
    pub(crate) problem: InputErrorKind,
}

/// The hash of what was hashed so far, in hexadecimal.
pub(crate) fn hexadecimal(hash: &Sha256) -> String {
    hash.clone().finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

/// A reader that hashes what passes and stops at a line that never ends.
pub(crate) struct WatchedReader {
    bytes: Box<dyn Read>,
    hash: Sha256,
    line: u64,
    since_line_end: usize,
    longest_line: usize,
}

impl WatchedReader {
    /// SHA-256 of all bytes read so far, in hexadecimal.
    pub(crate) fn sha256(&self) -> String {
        hexadecimal(&self.hash)
    }

    fn stopped(&self, problem: InputErrorKind) -> io::Error {
        io::Error::other(Stopped { line: self.line, problem })
    }
}

impl Read for WatchedReader {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = loop {
            match self.bytes.read(buffer) {
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                result => break result.map_err(|error| self.stopped(error.into()))?,
            }
        };
        let bytes = buffer.get(..count).ok_or_else(over_full)?;
        self.hash.update(bytes);
        for piece in bytes.split_inclusive(|&byte| byte == b'\n') {
            self.since_line_end += piece.len();
            if self.since_line_end > self.longest_line {
                return Err(self.stopped(InputErrorKind::LineTooLong { limit: self.longest_line }));
            }
            if piece.ends_with(b"\n") {
                self.line += 1;
                self.since_line_end = 0;
            }
        }
        Ok(count)
    }
}
