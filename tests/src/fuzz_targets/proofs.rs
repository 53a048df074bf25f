//! Proofs from elsewhere.

use boundfit_exact::Limits;
use boundfit_verify::{DataLimits, Proof};
use serde_json::Value;

use crate::proofs::is_true;

/// The readings that the proofs are about.
const DATA: &[u8] = b"x,y,eps\n1,2,1/2\n2,3,1\n\"3\",5,0.25\n4,6.5,1\n";

/// A proof is refused without a panic, or every statement in it is true, as the engine sees it.
pub fn proof_files(data: &[u8]) {
    let Ok(proof) = Proof::read(data, &Limits::default()) else { return };
    if proof.verify(|| Ok(DATA), &DataLimits::default()).is_ok() {
        let value: Value = serde_json::from_slice(data).expect("it was a proof");
        assert!(is_true(&value, DATA), "{value}");
    }
}
