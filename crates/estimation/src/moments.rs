//! The sums that the normal equations of least squares are made of, and their solution.

use std::borrow::Borrow;
use std::ops::{Mul, Sub};

use boundfit_exact::{Rational, Sum};

/// Bits of an `i128` without its sign.
pub(crate) const SUM_BITS: u32 = 127;

/// Of readings y ≈ u·θ1 + v·θ2: ΦᵀΦ = (Σu², Σuv; Σuv, Σv²) and Φᵀy = (Σuy, Σvy).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Moments<N> {
    pub(crate) uu: N,
    pub(crate) uv: N,
    pub(crate) vv: N,
    pub(crate) uy: N,
    pub(crate) vy: N,
}

/// θ as fractions on a common denominator, which is the determinant of ΦᵀΦ.
pub(crate) struct Solution<N> {
    pub(crate) numerators: [N; 2],
    pub(crate) determinant: N,
}

impl<N> Moments<N> {
    /// The moments as numbers of another type.
    pub(crate) fn map<M>(self, to: impl Fn(N) -> M) -> Moments<M> {
        let Moments { uu, uv, vv, uy, vy } = self;
        Moments { uu: to(uu), uv: to(uv), vv: to(vv), uy: to(uy), vy: to(vy) }
    }
}

impl<N: Sub<Output = N>> Moments<N>
where
    for<'a> &'a N: Mul<Output = N>,
{
    /// The solution of ΦᵀΦ·θ = Φᵀy, by Cramer's rule. Exact.
    pub(crate) fn solution(&self) -> Solution<N> {
        let Moments { uu, uv, vv, uy, vy } = self;
        Solution { numerators: [vv * uy - uv * vy, uu * vy - uv * uy], determinant: uu * vv - uv * uv }
    }
}

impl Moments<i128> {
    /// The moments of integers, where v is 1 if there is none; `None` when one of the sums might not fit. Exact.
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
        Some(Moments { uu, uv, vv, uy, vy })
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

impl Moments<Rational> {
    /// The moments of readings (u, v, y) of any size. Exact. Cost: linear.
    pub(crate) fn of_readings<R: Borrow<Rational>>(readings: impl Iterator<Item = [R; 3]>) -> Self {
        let mut sums = std::array::from_fn::<_, 5, _>(|_| Sum::default());
        for reading in readings {
            let [u, v, y] = reading.each_ref().map(R::borrow);
            for (sum, [left, right]) in sums.iter_mut().zip([[u, u], [u, v], [v, v], [u, y], [v, y]]) {
                sum.add_product(left, right);
            }
        }
        let [uu, uv, vv, uy, vy] = sums.map(|sum| sum.total());
        Moments { uu, uv, vv, uy, vy }
    }
}
