//! The number types.
//!
//! Numbers that fit into 128 bits are machine words, all others the libraries' big ones. The value of a number alone
//! decides which of the two it is. So equal numbers are equal in memory, and no result depends on the choice.

mod digits;
mod factors;
mod fraction;
mod gcd;
mod integer;
mod interop;
mod lehmer;
mod library;
mod rational;

use std::cmp::Ordering;

pub use fraction::Fraction;
pub use integer::Integer;
pub use interop::TooWide;
pub use rational::Rational;

/// The sign of an exact number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Sign {
    /// Less than zero.
    Negative,
    /// Exactly zero.
    Zero,
    /// Greater than zero.
    Positive,
}

impl From<Ordering> for Sign {
    #[inline]
    fn from(ordering: Ordering) -> Self {
        match ordering {
            Ordering::Less => Sign::Negative,
            Ordering::Equal => Sign::Zero,
            Ordering::Greater => Sign::Positive,
        }
    }
}

/// Operators for all four ways to pass two numbers, from a function of two references.
macro_rules! operators {
    ($type:ident: $($trait:ident $method:ident $function:ident),*) => {$(
        impl std::ops::$trait<&$type> for &$type {
            type Output = $type;
            #[inline]
            fn $method(self, other: &$type) -> $type { $function(self, other) }
        }
        impl std::ops::$trait<$type> for &$type {
            type Output = $type;
            #[inline]
            fn $method(self, other: $type) -> $type { $function(self, &other) }
        }
        impl std::ops::$trait<&$type> for $type {
            type Output = $type;
            #[inline]
            fn $method(self, other: &$type) -> $type { $function(&self, other) }
        }
        impl std::ops::$trait<$type> for $type {
            type Output = $type;
            #[inline]
            fn $method(self, other: $type) -> $type { $function(&self, &other) }
        }
    )*};
}

/// Implements the common parts of every number type, from its `sign` and its `negated`.
macro_rules! number {
    ($type:ident) => {
        impl std::ops::Neg for $type {
            type Output = $type;
            #[inline]
            fn neg(self) -> $type {
                self.negated()
            }
        }
        impl std::ops::Neg for &$type {
            type Output = $type;
            #[inline]
            fn neg(self) -> $type {
                self.negated()
            }
        }
        impl $type {
            /// Returns whether the number is 0.
            #[inline]
            pub fn is_zero(&self) -> bool {
                self.sign() == Sign::Zero
            }
            /// Returns whether the number is less than 0.
            #[inline]
            pub fn is_negative(&self) -> bool {
                self.sign() == Sign::Negative
            }
            /// Returns whether the number is greater than 0.
            #[inline]
            pub fn is_positive(&self) -> bool {
                self.sign() == Sign::Positive
            }
            /// The absolute value.
            #[inline]
            pub fn abs(&self) -> Self {
                if self.is_negative() { self.negated() } else { self.clone() }
            }
        }
        impl PartialOrd for $type {
            fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
                Some(self.cmp(other))
            }
        }
        impl std::fmt::Debug for $type {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                std::fmt::Display::fmt(self, f)
            }
        }
        impl Default for $type {
            fn default() -> Self {
                $type::zero()
            }
        }
        impl std::iter::Sum for $type {
            fn sum<I: Iterator<Item = $type>>(numbers: I) -> $type {
                numbers.fold($type::zero(), |total, number| total + number)
            }
        }
    };
}

use {number, operators};
