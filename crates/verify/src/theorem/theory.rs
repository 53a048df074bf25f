//! The part of a theorem's file before its rows, which must be the theory of this version and nothing else.

use sha2::{Digest, Sha256};

use super::sentences::code;
use crate::rows::hexadecimal;
use crate::shape::NotAProof;

/// The SHA-256 of the text between the comment at the head and the one about the rows. The first two texts are the theory itself, for a
/// set and for parts of the rows. The other two import it from `Boundfit`. `boundfit-report` writes them; a test compares.
pub const THEORIES: [&str; 4] = [
    "6c499c5e7f4ca6d5bfe878d7ab37eed1f506cc5c5e3ddaa63189ef237f43c381",
    "acd701bb02ad39f97d05b4977cda87829bb1fde6580100809f4ab11d8cc071ee",
    "1315eff4c592cb3d6fccbc863712fd879e7136cc157978cd28065fba7f4616c7",
    "b4ce356035e78bced50b69d90991ceae3d81acde089a13b0957760faf3ac9f5a",
];

/// The comment about the rows.
const ABOUT_ROWS: &str = "\n(* Rows: ";

/// Refuses a text before the rows that this version does not write. Another definition there gives the names in the theorem another
/// meaning, and Coq accepts it.
pub(super) fn refuse_another_theory(before: &str) -> Result<(), NotAProof> {
    if before.contains('\r') {
        return Err(NotAProof::new(
            "its lines end with a carriage return (expected the bytes as boundfit wrote them: make the theorem again, or take the \
             carriage returns away)",
        ));
    }
    let is_comment = |text: &str| code(text).is_some_and(|code| code.trim().is_empty());
    let parts =
        before.split_once("*)\n").and_then(|(head, rest)| Some((head, rest.rsplit_once(ABOUT_ROWS)?)));
    let is_known = parts.is_some_and(|(head, (theory, about))| {
        let hash = hexadecimal(&Sha256::digest(theory));
        is_comment(&[head, "*)"].concat())
            && is_comment(&[ABOUT_ROWS, about].concat())
            && THEORIES.contains(&hash.as_str())
    });
    if is_known {
        return Ok(());
    }
    Err(NotAProof::new(
        "the text before its rows is not the theory of this version of boundfit. The names in the theorem may mean something else. \
         Make the theorem again with this version, check it with the version that wrote it, or read its theory yourself",
    ))
}
