//! The sums that the normal equations of least squares are made of, and their solution.

use std::borrow::Borrow;
use std::ops::{Mul, Sub};

use boundfit_exact::{Integer, Rational, Sum};

/// Bits of an `i128` without its sign.
pub(crate) const SUM_BITS: u32 = 127;
/// Bits of an `i64` without its sign.
pub(crate) const WORD_BITS: u32 = 63;

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
        let count = u.len().min(y.len());
        let (u, y) = (Counts::new(u), Counts::new(y));
        let v = v.map(Counts::new);
        let regressor_bits = u.bits.max(v.map_or(1, |v| v.bits));
        if regressor_bits + regressor_bits.max(y.bits) + bits(count as u128) > SUM_BITS {
            return None;
        }
        let [uv, vv, vy] = match v {
            None => [u.sum(), count as i128, y.sum()],
            Some(v) => [u.sum_of_products(v), v.sum_of_products(v), v.sum_of_products(y)],
        };
        let [uu, uy] = [u, y].map(|other| u.sum_of_products(other));
        Some(Sums { count, uu, uv, vv, uy, vy })
    }
}

impl Sums<Integer> {
    /// The sums of a line over integers x of at most 62 bits, of which the first and the last are near to each other and far from 0.
    /// Times in a part of a table are such x. Products of differences from the first x need fewer bits. `None` for other x. Exact.
    /// Cost: linear.
    pub(crate) fn of_near(x: &[i64], y: &[i64]) -> Option<Self> {
        /// The bits that differences must save, or else they do not pay for their making.
        const LEAST_SAVED: u32 = 8;
        let (&base, &last) = (x.first()?, x.last()?);
        let [own, apart] = [base.unsigned_abs(), base.abs_diff(last)].map(|size| bits(size.into()));
        if 2 * own + bits(x.len() as u128) <= WORD_BITS || apart + LEAST_SAVED > own {
            return None;
        }
        // Differences of integers of 62 bits fit into 64.
        let offsets: Vec<i64> = x.iter().map(|count| count.wrapping_sub(base)).collect();
        let Sums { count, uu, uv, vv, uy, vy } = Sums::of_integers(&offsets, None, y)?.map(Integer::from);
        let base = Integer::from(base);
        let all = &base * &vv;
        let twice = &uv + &uv;
        Some(Sums { count, uu: uu + (twice + &all) * &base, uv: uv + all, uy: uy + base * &vy, vv, vy })
    }
}

/// Integers, and the bits of the largest magnitude.
#[derive(Clone, Copy)]
pub(crate) struct Counts<'a> {
    counts: &'a [i64],
    pub(crate) bits: u32,
}

impl<'a> Counts<'a> {
    pub(crate) fn new(counts: &'a [i64]) -> Self {
        Counts { counts, bits: widest(counts) }
    }

    /// The sum. Exact: the sum of this many integers of 64 bits fits into 128.
    pub(crate) fn sum(self) -> i128 {
        if self.bits + bits(self.counts.len() as u128) <= WORD_BITS {
            return self.counts.iter().fold(0_i64, |sum, &count| sum.wrapping_add(count)).into();
        }
        self.counts.iter().map(|&count| i128::from(count)).sum()
    }

    /// The sum of the products. Exact where the bits of both, and of how many there are, are no more than [`SUM_BITS`].
    pub(crate) fn sum_of_products(self, other: Counts<'_>) -> i128 {
        let pairs = self.counts.iter().zip(other.counts);
        // Sums of 128 bits take three times as long.
        if self.bits + other.bits + bits(self.counts.len() as u128) <= WORD_BITS {
            return pairs.fold(0_i64, |sum, (&own, &other)| sum.wrapping_add(own.wrapping_mul(other))).into();
        }
        pairs.fold(0_i128, |sum, (&own, &other)| {
            sum.wrapping_add(i128::from(own).wrapping_mul(i128::from(other)))
        })
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

#[cfg(test)]
mod tests {
    use super::*;

    /// The lengths go across the edges of 63 and of 127 bits.
    #[test]
    fn sums_over_integers_of_any_length_are_those_over_fractions() {
        let mut seed = 5_u64;
        let mut word = |bits: u32| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let magnitude = (seed >> 1) as i64 >> (63 - bits);
            if seed & 1 == 0 { magnitude } else { -magnitude }
        };
        let mut missing = 0;
        for round in 0..2000_u32 {
            let [u_bits, v_bits, y_bits] = [1, 7, 40].map(|step| 1 + (round * step + round / 62) % 62);
            let count = [1, 2, 7, 8, 9, 100][round as usize % 6];
            let [u, v, y] =
                [u_bits, v_bits, y_bits].map(|bits| (0..count).map(|_| word(bits)).collect::<Vec<_>>());
            for second in [None, Some(&v[..])] {
                let Some(sums) = Sums::of_integers(&u, second, &y) else {
                    missing += 1;
                    continue;
                };
                let row = |k: usize| [u[k], second.map_or(1, |v| v[k]), y[k]].map(Rational::from);
                assert_eq!(
                    sums.map(Rational::from),
                    Sums::of_numbers((0..count).map(row)).total(),
                    "{round}"
                );
            }
        }
        assert!((20..2000).contains(&missing), "{missing}");
    }

    /// Times of either sign, in the order of time or not, some so far apart that products of differences need 128 bits.
    #[test]
    fn sums_over_near_integers_are_those_over_fractions() {
        let mut seed = 7_u64;
        let mut below = |size: i64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 1) as i64 % size
        };
        let mut found = [0; 2];
        for round in 0..2000_u32 {
            let size = 1 << [25, 40, 61][round as usize % 3];
            let (base, spread) = (below(size), (1 + below(size)) >> (round % 60));
            let sign = if round % 5 == 0 { -1 } else { 1 };
            let count = 1 + below(60);
            let mut x: Vec<i64> =
                (0..count).map(|_| sign * (base + below(spread + 1)).min((1 << 62) - 1)).collect();
            if round % 2 == 0 {
                x.sort_unstable();
            }
            let y: Vec<i64> = (0..count).map(|_| below(1 << 50) - (1 << 49)).collect();
            let Some(sums) = Sums::of_near(&x, &y) else { continue };
            let row = |k: usize| [x[k], 1, y[k]].map(Rational::from);
            let expected = Sums::of_numbers((0..x.len()).map(row)).total();
            assert_eq!(sums.map(Rational::from), expected, "{x:?} {y:?}");
            found[usize::from(Sums::of_integers(&x, None, &y).is_none())] += 1;
        }
        assert!(found.iter().all(|&own| own > 100), "{found:?}");
    }
}
