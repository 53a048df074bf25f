//! Functions of the factor s on the error bounds.

use std::ops::{Add, Sub};

use boundfit_exact::Rational;
use boundfit_geometry::Direction;

use crate::ties::ActiveBounds;

/// `constant + slope·s`.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
pub struct Linear {
    /// The value at s = 0.
    pub constant: Rational,
    /// The growth per unit of s.
    pub slope: Rational,
}

/// A vertex as a function of s.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MovingVertex {
    /// The place of the vertex.
    pub theta: [Linear; 2],
    /// The bounds met with equality.
    pub active: ActiveBounds,
}

/// The line normal·θ = offset as a function of s, on the boundary of normal·θ ≤ offset.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MovingBoundary {
    /// The outer normal.
    pub normal: Direction,
    /// The right-hand side.
    pub offset: Linear,
    /// The bounds met with equality.
    pub active: ActiveBounds,
}

impl Linear {
    /// The value at s. Exact.
    pub fn at(&self, s: &Rational) -> Rational {
        // Of two lines that move alike the corner keeps a coordinate, and a sum would copy it with more effort.
        if self.slope.is_zero() { self.constant.clone() } else { &self.constant + &self.slope * s }
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
