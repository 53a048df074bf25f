//! The limits of a claims file.

use boundfit_exact::{Limits, MOST_WORK};

/// The limits of a claims file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ClaimLimits {
    /// The limits of one number.
    pub number: Limits,
    /// The depth to which arrays and objects of JSON may be nested. At most 120, so that no stack overflows.
    pub nesting: usize,
    /// The work on numbers with exponents, in products of machine words.
    pub work: u64,
}

impl Default for ClaimLimits {
    /// The default limits of numbers and their work, and 64 levels.
    fn default() -> Self {
        ClaimLimits { number: Limits::default(), nesting: 64, work: MOST_WORK }
    }
}
