//! Stands in where nothing is unpacked: whoever reads a packed file as it is refuses it by name.

use std::io::Read;

use crate::limits::SizeLimits;

/// A compressed input that is unpacked, of which there is none.
pub(crate) struct Unpacked {
    pub(crate) packed: Packed,
    pub(crate) start: Option<Vec<u8>>,
    pub(crate) bytes: Box<dyn Read>,
}

/// The known facts about one.
pub(crate) enum Packed {}

impl Packed {
    /// The bytes as they are.
    pub(crate) fn unpacked(_: &[u8], bytes: Box<dyn Read>) -> Result<Unpacked, Box<dyn Read>> {
        Err(bytes)
    }

    pub(crate) fn set_limits(&self, _: &SizeLimits) {
        match *self {}
    }

    pub(crate) fn sha256(&self) -> String {
        match *self {}
    }
}
