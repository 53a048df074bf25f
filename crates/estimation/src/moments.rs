//! The sums that the normal equations of least squares are made of, and their solution.

use std::borrow::Borrow;
use std::ops::{Mul, Sub};

use boundfit_exact::{Rational, Sum};

/// Bits of an `i128` without its sign.
pub(crate) const SUM_BITS: u32 = 127;

/// N, Σu², Σuv, Σv², Σuy and Σvy over readings y ≈ u·θ1 + v·θ2: ΦᵀΦ = (Σu², Σuv; Σuv, Σv²) and Φᵀy = (Σuy, Σvy). For
/// a line u is x and v is 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Sums<N = Rational> {
    /// The number of readings.
    pub count: usize,
    /// Σu²; Σx² of a line.
    pub uu: N,
    /// Σuv; Σx of a line.
    pub uv: N,
    /// Σv²; N of a line.
    pub vv: N,
    /// Σuy; Σxy of a line.
    pub uy: N,
    /// Σvy; Σy of a line.
    pub vy: N,
}

/// θ as fractions on a common denominator, which is the determinant of ΦᵀΦ.
pub(crate) struct Solution<N> {
    pub(crate) numerators: [N; 2],
    pub(crate) determinant: N,
}

impl<N> Sums<N> {
    /// Sums in the order of the fields.
    pub(crate) fn new(count: usize, [uu, uv, vv, uy, vy]: [N; 5]) -> Self {
        Sums { count, uu, uv, vv, uy, vy }
    }

    /// The sums as numbers of another type.
    pub(crate) fn map<M>(self, to: impl Fn(N) -> M) -> Sums<M> {
        let Sums { count, uu, uv, vv, uy, vy } = self;
        Sums { count, uu: to(uu), uv: to(uv), vv: to(vv), uy: to(uy), vy: to(vy) }
    }

    /// The sums over other readings as well, each put together with its like.
    pub(crate) fn zip(self, other: Self, with: impl Fn(N, N) -> N) -> Self {
        Sums {
            count: self.count + other.count,
            uu: with(self.uu, other.uu),
            uv: with(self.uv, other.uv),
            vv: with(self.vv, other.vv),
            uy: with(self.uy, other.uy),
            vy: with(self.vy, other.vy),
        }
    }
}

impl<N: Sub<Output = N>> Sums<N>
where
    for<'a> &'a N: Mul<Output = N>,
{
    /// The solution of ΦᵀΦ·θ = Φᵀy, by Cramer's rule. Exact.
    pub(crate) fn solution(&self) -> Solution<N> {
        let Sums { uu, uv, vv, uy, vy, .. } = self;
        Solution { numerators: [vv * uy - uv * vy, uu * vy - uv * uy], determinant: uu * vv - uv * uv }
    }
}

impl Sums<i128> {
    /// The sums over integers, where v is 1 if there is none; `None` when one of the sums might not fit. Exact.
    /// Cost: linear.
    pub(crate) fn of_integers(u: &[i64], v: Option<&[i64]>, y: &[i64]) -> Option<Self> {
        let regressor_bits = widest(u).max(v.map_or(1, widest));
        let count = u.len().min(y.len());
        if regressor_bits + regressor_bits.max(widest(y)) + bits(count as u128) > SUM_BITS {
            return None;
        }
        // By the bits above none of these can overflow.
        let product = |left: i64, right: i64| i128::from(left).wrapping_mul(i128::from(right));
        let add = |sum: &mut i128, term: i128| *sum = sum.wrapping_add(term);
        let [mut uu, mut uv, mut vv, mut uy, mut vy] = [0; 5];
        let rows = u.iter().zip(y);
        match v {
            None => {
                vv = count as i128;
                for (&u, &y) in rows {
                    add(&mut uu, product(u, u));
                    add(&mut uv, u.into());
                    add(&mut uy, product(u, y));
                    add(&mut vy, y.into());
                }
            }
            Some(v) => {
                for ((&u, &y), &v) in rows.zip(v) {
                    add(&mut uu, product(u, u));
                    add(&mut uv, product(u, v));
                    add(&mut vv, product(v, v));
                    add(&mut uy, product(u, y));
                    add(&mut vy, product(v, y));
                }
            }
        }
        Some(Sums { count, uu, uv, vv, uy, vy })
    }
}

/// Bits of the largest magnitude.
pub(crate) fn widest(counts: &[i64]) -> u32 {
    // The bits of all magnitudes together reach as far as those of the largest.
    bits(counts.iter().fold(0, |all, count| all | count.unsigned_abs()).into())
}

/// Bits of a magnitude.
pub(crate) fn bits(magnitude: u128) -> u32 {
    u128::BITS - magnitude.leading_zeros()
}

/// Sums in the making: over common denominators that nobody has reduced yet, which takes longer than to add up what a batch of
/// readings comes to.
impl Sums<Sum> {
    /// The sums over readings (u, v, y) of any size. Exact. Cost: linear.
    pub(crate) fn of_numbers<R: Borrow<Rational>>(readings: impl Iterator<Item = [R; 3]>) -> Self {
        let mut sums = Self::default();
        for reading in readings {
            let [u, v, y] = reading.each_ref().map(R::borrow);
            sums.count += 1;
            sums.uu.add_product(u, u);
            sums.uv.add_product(u, v);
            sums.vv.add_product(v, v);
            sums.uy.add_product(u, y);
            sums.vy.add_product(v, y);
        }
        sums
    }

    /// Returns the sums in lowest terms. Exact.
    pub(crate) fn total(self) -> Sums {
        self.map(|sum| sum.total())
    }
}

impl Sums {
    /// The sums over the readings of both. Exact.
    pub fn merged(&self, other: &Self) -> Self {
        self.clone().zip(other.clone(), |own, other| own + other)
    }
}
