//! Numbers of cells as mantissas and exponents.

use boundfit_exact::{PlainPrefix, long_plain_prefix, plain_prefix};

/// `mantissa · 10^exponent` in a cell that ends there.
pub(super) struct Plain<M = i64> {
    pub(super) mantissa: M,
    pub(super) exponent: i32,
    pub(super) end: usize,
}

/// The integers that mantissas are read as.
pub(super) trait Mantissa: Copy + Default + PartialEq {
    /// Reads the digits at the start of a text.
    fn prefix(text: &[u8]) -> Option<PlainPrefix<Self>>;

    /// The word that is negative where the mantissa is.
    fn high_word(self) -> i64;
}

impl Mantissa for i64 {
    #[inline(always)]
    fn prefix(text: &[u8]) -> Option<PlainPrefix> {
        plain_prefix(text)
    }

    fn high_word(self) -> i64 {
        self
    }
}

/// Mantissas of 16 digits or more are read sooner.
impl Mantissa for i128 {
    fn prefix(text: &[u8]) -> Option<PlainPrefix<i128>> {
        long_plain_prefix(text)
    }

    fn high_word(self) -> i64 {
        (self >> 64) as i64
    }
}
