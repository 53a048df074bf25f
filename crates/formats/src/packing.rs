//! Names packings by their first bytes, limits how far packed files may unpack, and says what is wrong with one.

use thiserror::Error;

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

/// The problem with a compressed input.
#[cfg_attr(not(feature = "packed"), allow(dead_code, reason = "nothing is unpacked that could have one"))]
#[derive(Debug, Error)]
pub(crate) enum UnpackError {
    /// The file unpacks to more than is allowed.
    #[error("it unpacks to more than {limit} bytes")]
    TooLong {
        /// The most bytes.
        limit: u64,
    },
    /// The file unpacks to more than is allowed for its size.
    #[error("it unpacks to more than {ratio} times its size")]
    TooFar {
        /// The factor of its size up to which it may unpack.
        ratio: u64,
    },
    /// The file holds more unpacked bytes than is allowed for its size.
    #[error("it holds more than {ratio} times its size")]
    HoldsTooMuch {
        /// The factor of its size that it may hold.
        ratio: u64,
    },
    /// Unpacking takes more memory than may be held.
    #[error("it takes too much memory")]
    TooMuchMemory {
        /// The number of bytes that all input held takes at least.
        needed: u64,
        /// The most bytes that may be held.
        limit: u64,
    },
    /// The file cannot be unpacked.
    #[error("{reason}")]
    Damaged {
        /// The format, with its article.
        format: &'static str,
        /// The library's words.
        reason: String,
    },
}
