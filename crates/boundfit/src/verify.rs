//! Proofs that `boundfit fit --proof` writes, checked against the data that they are about.
//!
//! The checker shares nothing with the engine that finds answers but its numbers: `docs/proof.md` in the repository says what a
//! proof states, and why the checks suffice.

use boundfit_exact::Limits;
use boundfit_verify::Proof;
pub use boundfit_verify::{
    About, Claim, ClaimKind, DataLimits, ErrorScale, Extent, Failure, Falsehood, Found, NotAProof, Quantity,
    Refusal, Scope, SetFound, Side, Statement,
};
use thiserror::Error;

/// The reason why a text does not prove what it should.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum VerifyError {
    /// The text is no JSON document of the schemas `boundfit/proof/1` and `boundfit/proof/2`.
    #[error("not a proof: {0}")]
    NotAProof(#[source] NotAProof),
    /// A statement is not true of these data.
    #[error("{0}")]
    False(#[source] Falsehood),
    /// The data are beyond a limit, which says nothing of the proof.
    #[error("{0}")]
    Data(#[source] Failure),
}

/// Checks every statement of a proof against the bytes of the table that it is about, within the default limits. Exact. Two
/// passes over the data.
///
/// # Errors
/// When the text is not a proof, or the first statement that is false, or what of the data is beyond a limit.
///
/// ```
/// use boundfit::verify::{VerifyError, verify};
///
/// assert!(matches!(verify("{}", b"x,y\n"), Err(VerifyError::NotAProof(_))));
/// ```
pub fn verify(proof: &str, data: &[u8]) -> Result<Statement, VerifyError> {
    let proof = Proof::read(proof.as_bytes(), &Limits::default()).map_err(VerifyError::NotAProof)?;
    proof.verify(|| Ok(data), &DataLimits::default()).map_err(|failure| match failure {
        Failure::False(falsehood) => VerifyError::False(falsehood),
        other => VerifyError::Data(other),
    })
}
