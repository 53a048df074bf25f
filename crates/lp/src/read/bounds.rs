//! Bounds as files state them: perhaps infinite, perhaps not at all.

use std::sync::LazyLock;

use boundfit_exact::{Integer, Rational};

use crate::model::Bounds;

/// From here on a bound is infinite: the least size that CPLEX, Gurobi, HiGHS and CBC agree on.
static INFINITE: LazyLock<Rational> = LazyLock::new(|| Rational::from(Integer::power_of_ten(30)));

/// A bound, or where there is none.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Extended {
    Minus,
    Finite(Rational),
    Plus,
}

impl Extended {
    /// What a number says as a bound.
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

    /// The number, if it is one.
    pub(super) fn finite(self) -> Option<Rational> {
        match self {
            Extended::Finite(value) => Some(value),
            Extended::Minus | Extended::Plus => None,
        }
    }
}

/// One of the two bounds of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    Lower,
    Upper,
}

impl Side {
    /// The adjective in messages.
    pub(super) fn name(self) -> &'static str {
        match self {
            Side::Lower => "lower",
            Side::Upper => "upper",
        }
    }

    /// The infinity that is no bound: −∞ below, +∞ above.
    pub(super) fn none(self) -> Extended {
        match self {
            Side::Lower => Extended::Minus,
            Side::Upper => Extended::Plus,
        }
    }

    /// The infinity that leaves no value: +∞ below, −∞ above.
    pub(super) fn impossible(self) -> Extended {
        match self {
            Side::Lower => Extended::Plus,
            Side::Upper => Extended::Minus,
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
    pub(super) fn of(&mut self, side: Side) -> &mut Option<Extended> {
        match side {
            Side::Lower => &mut self.lower,
            Side::Upper => &mut self.upper,
        }
    }

    /// The bounds that are meant. Unless stated, a lower bound is 0, but −∞ under a negative upper one (CPLEX), and an
    /// upper bound is +∞.
    pub(super) fn meant(self) -> Bounds {
        let upper = self.upper.and_then(Extended::finite);
        let lower = match self.lower {
            Some(lower) => lower.finite(),
            None => {
                Some(Rational::zero()).filter(|_| upper.as_ref().is_none_or(|upper| !upper.is_negative()))
            }
        };
        Bounds { lower, upper }
    }
}
