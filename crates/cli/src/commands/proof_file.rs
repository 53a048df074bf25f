//! The file of `--proof`, beside a report.

use std::fs;
use std::path::Path;

use boundfit_exact::Foreign;
use boundfit_report::{MOST_THEOREM_BYTES, Theory};
use sha2::{Digest, Sha256};

use crate::exit::Failure;

/// Returns whether a proof is a theorem for Coq, as the ending of its file's name tells.
pub(super) fn is_theorem(proof: Option<&str>) -> bool {
    proof.is_some_and(|file| file.ends_with(".v"))
}

/// Returns the source of a theorem's theory; `None` when the proof is JSON.
///
/// # Errors
/// When the theory of another kind of proof is asked for.
pub(super) fn theory(proof: Option<&str>, is_installed: bool) -> Result<Option<Theory>, Failure> {
    match (is_theorem(proof), is_installed) {
        (true, true) => Ok(Some(Theory::Installed)),
        (true, false) => Ok(Some(Theory::Included)),
        (false, false) => Ok(None),
        (false, true) => Err(Failure::Usage(
            "'--proof-library' is about theorems for Coq: give '--proof' a file that ends in .v".to_owned(),
        )),
    }
}

/// Returns what [`theory`] does, where a theorem is the only proof of what is asked.
///
/// # Errors
/// When another kind of proof is asked for.
pub(super) fn only_theory(
    proof: Option<&str>,
    is_installed: bool,
    proved: &str,
) -> Result<Option<Theory>, Failure> {
    match theory(proof, is_installed)? {
        None if proof.is_some() => Err(Failure::Usage(format!(
            "the proof of {proved} is a theorem for Coq: give '--proof' a file that ends in .v"
        ))),
        theory => Ok(theory),
    }
}

/// The bytes of a file that a theorem may hold, with their SHA-256.
pub(super) struct SmallFile {
    bytes: Vec<u8>,
    sha256: String,
}

impl SmallFile {
    pub(super) fn parts(&self) -> (&[u8], &str) {
        (&self.bytes, &self.sha256)
    }
}

/// Reads a small file; `None` if it is not small or is no file.
pub(super) fn small_file(path: &str) -> Option<SmallFile> {
    let path = Path::new(path);
    let about = fs::metadata(path).ok()?;
    if !about.is_file() || about.len() > MOST_THEOREM_BYTES as u64 {
        return None;
    }
    let bytes = fs::read(path).ok()?;
    let sha256 = Sha256::digest(&bytes).iter().map(|byte| format!("{byte:02x}")).collect();
    Some(SmallFile { bytes, sha256 })
}

/// Refuses a theorem about an answer that has none.
pub(super) fn refuse_theorem(proof: Option<&str>) -> Result<(), Failure> {
    match proof {
        Some(file) if is_theorem(proof) => Err(Failure::Usage(format!(
            "'--proof {}': there is no theorem for Coq about this answer; a file that ends in .json gets the proof for 'boundfit verify'",
            Foreign::of(file)
        ))),
        _ => Ok(()),
    }
}
