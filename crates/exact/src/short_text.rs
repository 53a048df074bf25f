//! Text that is put together without taking memory.

use std::fmt;

/// The length of a fraction of two 256-bit numbers with a sign, and of a decimal of as many digits.
const LENGTH: usize = 160;

/// The largest power of ten of 64 bits, and the zeros that follow its 1.
const CHUNK: u64 = 10_u64.pow(19);
const ZEROS: &str = "0000000000000000000";

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

    /// Adds a number of up to 256 bits, of which these are the words, the lowest first. It is cut into nineteen digits at a time.
    pub(crate) fn push_words(&mut self, mut words: [u64; 4]) {
        let mut digits = itoa::Buffer::new();
        if let [word, 0, 0, 0] = words {
            return self.push(digits.format(word));
        }
        let mut chunks = [0_u64; 5];
        let mut count = 0;
        for chunk in &mut chunks {
            for word in words.iter_mut().rev() {
                // No word above has left anything yet where both are 0.
                if *chunk | *word != 0 {
                    let value = u128::from(*chunk) << u64::BITS | u128::from(*word);
                    // Less than 2⁶⁴, since the rest is less than the divisor.
                    *word = (value / u128::from(CHUNK)) as u64;
                    *chunk = (value as u64).wrapping_sub(word.wrapping_mul(CHUNK));
                }
            }
            count += 1;
            if words == [0; 4] {
                break;
            }
        }
        let mut is_first = true;
        for chunk in chunks.iter().take(count).rev() {
            let text = digits.format(*chunk);
            if !is_first {
                self.push(ZEROS.get(text.len()..).unwrap_or_default());
            }
            self.push(text);
            is_first = false;
        }
    }

    pub(crate) fn as_str(&self) -> Result<&str, fmt::Error> {
        self.bytes.get(..self.length).and_then(|bytes| std::str::from_utf8(bytes).ok()).ok_or(fmt::Error)
    }
}
