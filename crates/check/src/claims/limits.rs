//! How much a claims file may ask for.

use boundfit_exact::Limits;

/// What a claims file may ask for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ClaimLimits {
    /// Of one number.
    pub number: Limits,
    /// How deep arrays and objects of JSON may be nested. At most 120, so that no stack overflows.
    pub nesting: usize,
}

impl Default for ClaimLimits {
    /// Those of numbers, and 64 levels.
    fn default() -> Self {
        ClaimLimits { number: Limits::default(), nesting: 64 }
    }
}
