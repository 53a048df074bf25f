//! Functions of the factor s on the error bounds.

use std::ops::{Add, Mul, Sub};

use boundfit_exact::Rational;

/// `constant + slope·s`.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Linear {
    /// The value at s = 0.
    pub constant: Rational,
    /// The growth per unit of s.
    pub slope: Rational,
}

/// `constant + slope·s + quadratic·s²`.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Quadratic {
    /// The value at s = 0.
    pub constant: Rational,
    /// The coefficient of s.
    pub slope: Rational,
    /// The coefficient of s².
    pub quadratic: Rational,
}

impl Linear {
    /// The value at s. Exact.
    pub fn at(&self, s: &Rational) -> Rational {
        &self.constant + &self.slope * s
    }

    /// Where the function is zero; `None` for a constant.
    pub(crate) fn root(&self) -> Option<Rational> {
        (-&self.constant).checked_div(&self.slope)
    }

    /// This function times a number.
    pub(crate) fn times(&self, factor: &Rational) -> Linear {
        Linear { constant: &self.constant * factor, slope: &self.slope * factor }
    }
}

impl Quadratic {
    /// The value at s. Exact.
    pub fn at(&self, s: &Rational) -> Rational {
        &self.constant + (&self.slope + &self.quadratic * s) * s
    }

    /// The function that has one value everywhere.
    pub(crate) fn constant(value: Rational) -> Self {
        Quadratic { constant: value, ..Quadratic::default() }
    }

    pub(crate) fn times(&self, factor: &Rational) -> Quadratic {
        Quadratic {
            constant: &self.constant * factor,
            slope: &self.slope * factor,
            quadratic: &self.quadratic * factor,
        }
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

impl Mul for &Linear {
    type Output = Quadratic;

    fn mul(self, other: &Linear) -> Quadratic {
        Quadratic {
            constant: &self.constant * &other.constant,
            slope: &self.constant * &other.slope + &self.slope * &other.constant,
            quadratic: &self.slope * &other.slope,
        }
    }
}

impl Add for Quadratic {
    type Output = Quadratic;

    fn add(self, other: Quadratic) -> Quadratic {
        Quadratic {
            constant: self.constant + other.constant,
            slope: self.slope + other.slope,
            quadratic: self.quadratic + other.quadratic,
        }
    }
}

impl Sub for Quadratic {
    type Output = Quadratic;

    fn sub(self, other: Quadratic) -> Quadratic {
        self + other.times(&-Rational::one())
    }
}
