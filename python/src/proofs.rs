//! Proofs, checked by the checker that shares nothing with the engine but its numbers.

use boundfit::verify::{VerifyError, verify as checked};
use pyo3::prelude::*;

use crate::numbers::refuse;
use crate::waiting::waiting;

/// Returns the false statements of a proof about these bytes; none if every statement is true.
#[pyfunction]
pub(crate) fn verify(py: Python<'_>, proof: String, data: Vec<u8>) -> PyResult<Option<String>> {
    match waiting(py, move |_| checked(&proof, &data))? {
        Ok(_) => Ok(None),
        Err(VerifyError::False(falsehood)) => Ok(Some(falsehood.to_string())),
        Err(other) => Err(refuse(other)),
    }
}
