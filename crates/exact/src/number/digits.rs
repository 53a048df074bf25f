//! The digits of integers beyond machine words.

use std::fmt;

/// The largest power of ten of 64 bits, and the zeros that follow its 1.
const CHUNK: u64 = 10_u64.pow(19);
const ZEROS: &str = "0000000000000000000";

/// Writes a number of up to 256 bits, of which these are the words, the lowest first. Takes no memory: it cuts off nineteen digits at a
/// time.
pub(super) fn write_words(out: &mut impl fmt::Write, mut words: [u64; 4]) -> fmt::Result {
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
    let mut digits = itoa::Buffer::new();
    let mut is_first = true;
    for chunk in chunks.iter().take(count).rev() {
        let text = digits.format(*chunk);
        if !is_first {
            out.write_str(ZEROS.get(text.len()..).unwrap_or_default())?;
        }
        out.write_str(text)?;
        is_first = false;
    }
    Ok(())
}
