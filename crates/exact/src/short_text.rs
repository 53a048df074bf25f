//! Text that is put together without taking memory.

use std::fmt;

/// The length of a fraction of two 128-bit numbers with a sign, and of a decimal of as many digits.
const LENGTH: usize = 96;

/// ASCII text of up to [`LENGTH`] bytes. More makes [`ShortText::as_str`] an error.
pub(crate) struct ShortText {
    bytes: [u8; LENGTH],
    length: usize,
}

impl ShortText {
    pub(crate) fn new() -> Self {
        ShortText { bytes: [0; LENGTH], length: 0 }
    }

    pub(crate) fn push(&mut self, text: &str) {
        let end = self.length + text.len();
        if let Some(room) = self.bytes.get_mut(self.length..end) {
            room.copy_from_slice(text.as_bytes());
        }
        self.length = end;
    }

    pub(crate) fn push_integer(&mut self, magnitude: u128) {
        let mut digits = itoa::Buffer::new();
        match u64::try_from(magnitude) {
            // Several times faster.
            Ok(magnitude) => self.push(digits.format(magnitude)),
            Err(_) => self.push(digits.format(magnitude)),
        }
    }

    pub(crate) fn as_str(&self) -> Result<&str, fmt::Error> {
        self.bytes.get(..self.length).and_then(|bytes| std::str::from_utf8(bytes).ok()).ok_or(fmt::Error)
    }
}
