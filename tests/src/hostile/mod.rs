//! Small inputs made to be expensive, and commands about them: at most 4 kB of files each, the same for the same seed.

mod commands;
mod files;
mod limited;
mod mutations;
mod numbers;
mod questions;

use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use crate::generate::seeded;

pub use files::{gzip, matlab_zeros, repeated_behind, repeated_by_zstandard};
pub use limited::{Cost, Ended, FEW_SECONDS, LIMITS, TOO_FAR, refused, run_limited};

/// The most bytes that the files of a case have together.
pub const MOST_BYTES: usize = 4096;

/// Files, and command lines about them, one after the other.
#[derive(Debug, Clone)]
pub struct Case {
    /// Name and content.
    pub files: Vec<(String, Vec<u8>)>,
    /// The words after `boundfit` of each command.
    pub lines: Vec<Vec<String>>,
}

/// The case of a seed.
pub fn case(seed: u64) -> Case {
    let rng = &mut seeded(seed);
    loop {
        let case = match rng.random_range(0..23) {
            0..12 => commands::about_table(rng),
            12..15 => commands::about_half_planes(rng),
            15..18 => commands::about_model(rng),
            18 => commands::about_claims(rng),
            19 => commands::about_proof(rng),
            20 => commands::about_reduction(rng),
            21 => commands::about_packed(rng),
            _ => commands::about_seed(rng),
        };
        if case.files.iter().map(|(_, bytes)| bytes.len()).sum::<usize>() <= MOST_BYTES {
            return case;
        }
    }
}

/// One of some values.
fn one_of<T: Clone>(rng: &mut ChaCha8Rng, values: &[T]) -> T {
    values[rng.random_range(0..values.len())].clone()
}
