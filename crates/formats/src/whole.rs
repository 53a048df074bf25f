//! Files that are read whole before anybody looks into them.

use crate::chunks::ChunkReader;
use crate::error::InputError;
use crate::limits::SizeLimits;
use crate::source::Source;
use crate::unpack::Packed;
use boundfit_exact::Foreign;

/// The number of bytes read at a time.
const CHUNK_BYTES: usize = 1 << 16;

/// A file of text, unpacked if it was compressed, in UTF-8 if it was UTF-16.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WholeFile {
    /// The name that messages use.
    pub name: Foreign,
    /// The text, which may have bytes that are no UTF-8.
    pub content: Vec<u8>,
    /// SHA-256 of the file's own bytes, in hexadecimal.
    pub sha256: String,
}

impl WholeFile {
    /// Reads a source to its end. Cost: linear, with all of it in memory.
    ///
    /// # Errors
    /// When it cannot be read, or passes a limit: of one line, of all bytes, or of what a compressed file unpacks to.
    pub fn read(source: Source, sizes: &SizeLimits) -> Result<Self, InputError> {
        let (name, bytes, packed) = source.into_bytes();
        if let Some(packed) = &packed {
            packed.set_limits(sizes);
        }
        let mut reader = ChunkReader::new(bytes, CHUNK_BYTES, sizes.line, true);
        let content = reader.read_to_end(name.raw(), sizes.text, &sizes.memory.nothing())?;
        let of_text = || reader.sha256().unwrap_or_default();
        let sha256 = packed.as_ref().map_or_else(of_text, Packed::sha256);
        Ok(WholeFile { name, content, sha256 })
    }
}
