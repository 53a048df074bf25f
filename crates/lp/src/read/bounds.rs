//! Bounds as files state them: perhaps infinite, perhaps not at all.

use std::sync::LazyLock;

use boundfit_exact::{Integer, Rational};

use crate::claim::End;
use crate::model::Bounds;

/// The size from which on a bound is infinite: the least that CPLEX, Gurobi, HiGHS and CBC agree on.
static INFINITE: LazyLock<Rational> = LazyLock::new(|| Rational::from(Integer::power_of_ten(30)));

/// A bound, or where there is none.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Extended {
    Minus,
    Finite(Rational),
    Plus,
}

impl Extended {
    /// Returns what a number says as a bound.
    pub(super) fn new(value: Rational) -> Self {
        match () {
            () if value >= *INFINITE => Extended::Plus,
            () if -&value >= *INFINITE => Extended::Minus,
            () => Extended::Finite(value),
        }
    }

    /// The opposite.
    pub(super) fn negated(self) -> Self {
        match self {
            Extended::Minus => Extended::Plus,
            Extended::Finite(value) => Extended::Finite(-value),
            Extended::Plus => Extended::Minus,
        }
    }

    /// The infinity that is no bound: −∞ below, +∞ above.
    pub(super) fn none(end: End) -> Self {
        match end {
            End::Lower => Extended::Minus,
            End::Upper => Extended::Plus,
        }
    }

    /// The infinity that leaves no value: +∞ below, −∞ above.
    pub(super) fn impossible(end: End) -> Self {
        match end {
            End::Lower => Extended::Plus,
            End::Upper => Extended::Minus,
        }
    }

    /// The number, if it is one.
    pub(super) fn finite(self) -> Option<Rational> {
        match self {
            Extended::Finite(value) => Some(value),
            Extended::Minus | Extended::Plus => None,
        }
    }
}

/// The bounds of a column as far as they are stated.
#[derive(Debug, Clone, Default)]
pub(super) struct StatedBounds {
    pub(super) lower: Option<Extended>,
    pub(super) upper: Option<Extended>,
}

impl StatedBounds {
    pub(super) fn of(&mut self, end: End) -> &mut Option<Extended> {
        match end {
            End::Lower => &mut self.lower,
            End::Upper => &mut self.upper,
        }
    }

    /// The bounds that are meant: unless stated, a lower bound is 0 and an upper one +∞.
    pub(super) fn meant(self) -> Bounds {
        let [lower, upper] = [self.lower, self.upper].map(|bound| bound.map(Extended::finite));
        Bounds { lower: lower.unwrap_or_else(|| Some(Rational::zero())), upper: upper.flatten() }
    }

    /// The bounds that are meant in MPS. There a negative upper bound makes a lower one that is not stated −∞ (CPLEX).
    pub(super) fn meant_in_mps(self) -> Bounds {
        let is_free_below = self.lower.is_none();
        let Bounds { lower, upper } = self.meant();
        let is_negative = upper.as_ref().is_some_and(Rational::is_negative);
        Bounds { lower: lower.filter(|_| !(is_free_below && is_negative)), upper }
    }
}
