//! What packed files begin with, how far they may unpack, and what is wrong with one that does not.

use thiserror::Error;

/// How an input is compressed.
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

/// How many bytes so many bytes may unpack to.
#[cfg(any(feature = "arrow", feature = "matlab", feature = "packed", feature = "spreadsheets"))]
pub(crate) fn most_unpacked(packed: u64, ratio: u64) -> u64 {
    ANY_FILE.max(packed.saturating_mul(ratio))
}

/// How many bytes any file may unpack to, however small it is.
pub(crate) const ANY_FILE: u64 = 1 << 26;

/// How many bytes that were unpacked may be held to be repeated, however small a packed file is: as many as those who write Zstandard
/// can rely on (RFC 8878, 3.1.1.1.2), and as its usual levels take.
pub(crate) const ANY_WINDOW: u64 = 1 << 23;

/// The problem with a compressed input.
#[cfg_attr(not(feature = "packed"), allow(dead_code, reason = "nothing is unpacked that could have one"))]
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
