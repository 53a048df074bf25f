//! How far packed files may unpack, and what is wrong with one that does not.

use thiserror::Error;

/// How many bytes so many bytes may unpack to.
pub(crate) fn most_unpacked(packed: u64, ratio: u64) -> u64 {
    ANY_FILE.max(packed.saturating_mul(ratio))
}

/// How many bytes any file may unpack to, however small it is.
pub(crate) const ANY_FILE: u64 = 1 << 26;

/// How many bytes that were unpacked may be held to be repeated, however small a packed file is: as many as those who write Zstandard
/// can rely on (RFC 8878, 3.1.1.1.2), and as its usual levels take.
pub(crate) const ANY_WINDOW: u64 = 1 << 23;

/// The problem with a compressed input.
#[derive(Debug, Error)]
pub(crate) enum UnpackError {
    /// It unpacks to more than may be.
    #[error("it unpacks to more than {limit} bytes")]
    TooLong {
        /// The most bytes.
        limit: u64,
    },
    /// It unpacks to more than may be for its size.
    #[error("it unpacks to more than {ratio} times its size")]
    TooFar {
        /// How many times its size it may unpack to.
        ratio: u64,
    },
    /// It holds more of what it unpacked than it may for its size.
    #[error("it holds more than {ratio} times its size")]
    HoldsTooMuch {
        /// How many times its size it may hold.
        ratio: u64,
    },
    /// Unpacking takes more memory than may be held.
    #[error("it takes too much memory")]
    TooMuchMemory {
        /// How many bytes all that is held takes at least.
        needed: u64,
        /// How many may be held.
        limit: u64,
    },
    /// It cannot be unpacked.
    #[error("{reason}")]
    Damaged {
        /// The format, with its article.
        format: &'static str,
        /// The library's words.
        reason: String,
    },
}
