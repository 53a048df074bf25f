//! The hash of a file in the words of reports.

use sha2::{Digest, Sha256};

/// The hash of what was hashed so far, in hexadecimal.
pub(crate) fn hexadecimal(hash: &Sha256) -> String {
    hash.clone().finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}
