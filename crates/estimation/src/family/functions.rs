//! Functions of the factor s on the error bounds.

use std::ops::{Add, Sub};

use boundfit_exact::Rational;

/// `constant + slope·s`.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
pub struct Linear {
    /// The value at s = 0.
    pub constant: Rational,
    /// The growth per unit of s.
    pub slope: Rational,
}

impl Linear {
    /// The value at s. Exact.
    pub fn at(&self, s: &Rational) -> Rational {
        &self.constant + &self.slope * s
    }

    /// Returns where the function is zero; `None` for a constant.
    pub(crate) fn root(&self) -> Option<Rational> {
        (-&self.constant).checked_div(&self.slope)
    }

    /// This function times a number.
    pub(crate) fn times(&self, factor: &Rational) -> Linear {
        Linear { constant: &self.constant * factor, slope: &self.slope * factor }
    }
}

impl Add for &Linear {
    type Output = Linear;

    fn add(self, other: &Linear) -> Linear {
        Linear { constant: &self.constant + &other.constant, slope: &self.slope + &other.slope }
    }
}

impl Sub for &Linear {
    type Output = Linear;

    fn sub(self, other: &Linear) -> Linear {
        Linear { constant: &self.constant - &other.constant, slope: &self.slope - &other.slope }
    }
}
