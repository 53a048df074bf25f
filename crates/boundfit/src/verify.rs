//! Proofs that `boundfit fit --proof` writes, checked against the data that they are about.
//!
//! The checker shares nothing with the engine that finds answers but its numbers: `docs/proof.md` in the repository says what a
//! proof states, and why the checks suffice.

use boundfit_exact::Limits;
use boundfit_verify::Proof;
pub use boundfit_verify::{Extent, Falsehood, Statement};
use sha2::{Digest, Sha256};
use thiserror::Error;

/// Why a text does not prove what it should.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum VerifyError {
    /// It is no JSON document of the schema `boundfit/proof/1`.
    #[error("not a proof: {0}")]
    NotAProof(#[source] serde_json::Error),
    /// A statement is not true of these data.
    #[error("{0}")]
    False(Falsehood),
}

/// Checks every statement of a proof against the bytes of the table that it is about. Exact. Two passes over the data.
///
/// # Errors
/// When the text is not a proof, or the first statement that is false.
///
/// ```
/// use boundfit::verify::{VerifyError, verify};
///
/// assert!(matches!(verify("{}", b"x,y\n"), Err(VerifyError::NotAProof(_))));
/// ```
pub fn verify(proof: &str, data: &[u8]) -> Result<Statement, VerifyError> {
    let proof: Proof = serde_json::from_str(proof).map_err(VerifyError::NotAProof)?;
    let hash: String = Sha256::digest(data).iter().map(|byte| format!("{byte:02x}")).collect();
    proof.verify(data, &hash, &Limits::default()).map_err(VerifyError::False)
}
