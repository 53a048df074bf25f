//! Changes to inputs that mean something: numbers in place of numbers, lines repeated, bytes exchanged.

use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use super::MOST_BYTES;
use super::numbers::{number, written};

/// Some changes, by which the input stays as small as it has to.
pub(super) fn mutated(rng: &mut ChaCha8Rng, bytes: &[u8]) -> Vec<u8> {
    let mut bytes = bytes.to_owned();
    for _ in 0..rng.random_range(0..5) {
        let changed = match rng.random_range(0..4) {
            0 => with_byte(rng, &bytes),
            1 => with_lines_repeated(rng, &bytes),
            _ => with_numbers(rng, &bytes),
        };
        if changed.len() <= MOST_BYTES - 700 {
            bytes = changed;
        }
    }
    bytes
}

fn with_byte(rng: &mut ChaCha8Rng, bytes: &[u8]) -> Vec<u8> {
    let mut bytes = bytes.to_owned();
    if !bytes.is_empty() {
        let place = rng.random_range(0..bytes.len());
        bytes[place] = rng.random();
    }
    bytes
}

/// A stretch of lines several times.
fn with_lines_repeated(rng: &mut ChaCha8Rng, bytes: &[u8]) -> Vec<u8> {
    let mut lines: Vec<&[u8]> = bytes.split_inclusive(|byte| *byte == b'\n').collect();
    if lines.is_empty() {
        return Vec::new();
    }
    let place = rng.random_range(0..lines.len());
    let line = lines[place];
    for _ in 0..rng.random_range(1..30) {
        lines.insert(place, line);
    }
    lines.concat()
}

/// Some of the numbers, or all, replaced by expensive ones.
fn with_numbers(rng: &mut ChaCha8Rng, bytes: &[u8]) -> Vec<u8> {
    let (written, every) = (written(rng), rng.random_range(1..6));
    let is_part = |byte: u8| byte.is_ascii_digit() || byte == b'.';
    let mut changed = Vec::new();
    for (row, stretch) in bytes.chunk_by(|one, next| is_part(*one) == is_part(*next)).enumerate() {
        if is_part(stretch[0]) && rng.random_range(0..every) == 0 {
            changed.extend(number(rng, written, row).bytes());
        } else {
            changed.extend(stretch);
        }
    }
    changed
}
