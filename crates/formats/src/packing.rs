//! Limits how far packed files may unpack, and names what is wrong with one that unpacks further.

use thiserror::Error;

/// Returns the number of bytes to which a packed file of this size may unpack.
pub(crate) fn most_unpacked(packed: u64, ratio: u64) -> u64 {
    ANY_FILE.max(packed.saturating_mul(ratio))
}

/// The number of bytes to which any file may unpack, however small it is.
pub(crate) const ANY_FILE: u64 = 1 << 26;

/// The number of unpacked bytes that any packed file may hold to repeat them, however small it is. Writers of
/// Zstandard can rely on as many (RFC 8878, 3.1.1.1.2), and its usual levels take as many.
pub(crate) const ANY_WINDOW: u64 = 1 << 23;

/// The problem with a compressed input.
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
