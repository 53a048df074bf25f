//! Names packings by their first bytes, and limits how far packed files may unpack.

/// The compression of an input.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Packing {
    Gzip,
    Zstandard,
}

impl Packing {
    /// The compression of a file that starts like this.
    pub(crate) fn of(start: &[u8]) -> Option<Self> {
        if start.starts_with(b"\x1f\x8b") {
            return Some(Packing::Gzip);
        }
        // A frame, or one to be passed over (RFC 8878, 3.1.1 and 3.1.2).
        let is_skippable = matches!(start, [0x50..=0x5f, 0x2a, 0x4d, 0x18, ..]);
        (start.starts_with(b"\x28\xb5\x2f\xfd") || is_skippable).then_some(Packing::Zstandard)
    }

    /// The name with its article.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Packing::Gzip => "a gzip file",
            Packing::Zstandard => "a Zstandard file",
        }
    }
}

/// Returns the number of bytes to which a packed file of this size may unpack.
#[cfg(any(feature = "arrow", feature = "matlab", feature = "packed", feature = "spreadsheets"))]
pub(crate) fn most_unpacked(packed: u64, ratio: u64) -> u64 {
    ANY_FILE.max(packed.saturating_mul(ratio))
}

/// The number of bytes to which any file may unpack, however small it is.
pub(crate) const ANY_FILE: u64 = 1 << 26;

/// The number of unpacked bytes that any packed file may hold to repeat them, however small it is. Writers of
/// Zstandard can rely on as many (RFC 8878, 3.1.1.1.2), and its usual levels take as many.
pub(crate) const ANY_WINDOW: u64 = 1 << 23;
