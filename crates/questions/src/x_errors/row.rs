//! A half-plane of one side as a function of a factor on all bounds.
//!
//! It moves with a factor s, in homogeneous form:
//!
//! ```text
//! slope·t + offset·θ2 - bound·τ ≤ s·(of_y·τ + of_x·t),   t = |θ1| ≥ 0, τ ≥ 0
//! ```
//!
//! which is that of t and θ2 themselves at τ = 1. With t = λ and τ = 1 - λ it is a half-plane of (λ, v), 0 ≤ λ < 1: all slopes
//! fit into one interval. No line has λ = 1, but ever steeper lines come arbitrarily close to it.

use boundfit_exact::Rational;
use boundfit_geometry::Inequality;

/// A half-plane that moves with the factor.
#[derive(Debug, Clone)]
pub(super) struct Row {
    /// The coefficient of t.
    pub(super) slope: Rational,
    /// The coefficient of θ2.
    pub(super) offset: Rational,
    /// The bound at factor 0.
    pub(super) bound: Rational,
    /// The growth of the bound because of the error in y; not negative.
    pub(super) of_y: Rational,
    /// The growth for each unit of t because of the error in x; negative under strong agreement.
    pub(super) of_x: Rational,
}

impl Row {
    /// The same half-planes with integers, which need no common divisors wherever they are added.
    pub(super) fn over_integers(&self) -> Self {
        let Row { slope, offset, bound, of_y, of_x } = self;
        let (integers, _) = Rational::over_common_denominator([slope, offset, bound, of_y, of_x]);
        let [slope, offset, bound, of_y, of_x] = integers.map(Rational::from);
        Row { slope, offset, bound, of_y, of_x }
    }

    /// The half-plane of (λ, v) at a factor, times the factor's denominator.
    pub(super) fn at(&self, factor: &Rational) -> Inequality {
        let [of_factor, one] = [factor.numerator(), factor.denominator()].map(Rational::from);
        let along = (&self.slope + &self.bound) * &one - &of_factor * (&self.of_x - &self.of_y);
        Inequality::new(along, &self.offset * &one, &self.bound * &one + &of_factor * &self.of_y)
    }

    /// Returns whether the half-plane grows with the factor at this λ.
    pub(super) fn grows(&self, lambda: &Rational) -> bool {
        self.grows_at([lambda, &Rational::one()])
    }

    /// Returns whether it does at λ = x/w.
    fn grows_at(&self, [x, w]: [&Rational; 2]) -> bool {
        !(&self.of_y * w + x * (&self.of_x - &self.of_y)).is_zero()
    }

    /// Returns whether it does at a point (x/w, y/w) that lies on its boundary.
    pub(super) fn is_touched(&self, factor: &Rational, [x, y, w]: &[Rational; 3]) -> bool {
        let Inequality { a: [along, offset], b: bound } = self.at(factor);
        self.grows_at([x, w]) && along * x + offset * y == bound * w
    }

    /// Returns whether (1, v) lies on the boundary whatever the factor is, though a line close to it may not.
    pub(super) fn is_asymptote(&self, v: &Rational) -> bool {
        self.of_x.is_zero() && !self.offset.is_zero() && (&self.slope + &self.offset * v).is_zero()
    }
}
