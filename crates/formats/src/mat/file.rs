//! A file from front to back, with the hash of its bytes.

use std::io::{self, BufReader, Read};

use sha2::{Digest, Sha256};

use crate::error::InputErrorKind;
use crate::hash::hexadecimal;
use crate::scan::Progress;

/// Reads a file, hashes what passes if that is wanted, and tells who follows how far it is.
pub(super) struct MatFile<'a> {
    inner: BufReader<Box<dyn Read>>,
    hash: Option<Sha256>,
    progress: Option<&'a dyn Progress>,
    position: u64,
}

impl<'a> MatFile<'a> {
    pub(super) fn new(file: Box<dyn Read>, hash: bool, progress: Option<&'a dyn Progress>) -> Self {
        MatFile { inner: BufReader::new(file), hash: hash.then(Sha256::new), progress, position: 0 }
    }

    /// Returns the number of bytes read so far.
    pub(super) fn position(&self) -> u64 {
        self.position
    }

    /// SHA-256 of all bytes read so far, in hexadecimal.
    pub(super) fn sha256(&self) -> Option<String> {
        self.hash.as_ref().map(hexadecimal)
    }

    /// Stops where that is asked for.
    pub(super) fn go_on(&self) -> Result<(), InputErrorKind> {
        let is_cancelled = self.progress.is_some_and(Progress::is_cancelled);
        if is_cancelled { Err(InputErrorKind::Interrupted) } else { Ok(()) }
    }
}

impl Read for MatFile<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.inner.read(buffer)?;
        if let (Some(hash), Some(bytes)) = (&mut self.hash, buffer.get(..count)) {
            hash.update(bytes);
        }
        self.position += count as u64;
        if let Some(progress) = self.progress {
            progress.advanced(count as u64);
        }
        Ok(count)
    }
}
