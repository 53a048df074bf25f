//! The reach of least squares for readings whose error bounds differ or that have two regressors; it is known only
//! when all readings have been seen.

use boundfit_exact::{Column, Rational, Scaled, Sum, Unit};

use crate::halves::Halves;
use crate::meaning::Meaning;
use crate::moments::{Sums, WORD_BITS, bits, widest};
use crate::products::product_sum;
use crate::reduction::{NoEui, Reach};
use crate::rounded::float;
use crate::sums::column_sum;

/// A_jk times the determinant of ΦᵀΦ is p·φ_k1 + q·φ_k2, with (p, q) a row of the adjugate; then φ_k1 itself.
#[derive(Debug, Clone)]
pub(crate) struct Weights {
    of: [[Rational; 2]; 3],
    /// Φᵀm, where readings have no y, and least squares takes the middles m instead.
    middles: [Rational; 2],
}

/// Σ_k ±φ_k1·ε_k and Σ_k ±φ_k2·ε_k with the sign of A_jk, for each j, and with that of φ_k1; then Φᵀm, where the middles are
/// not y.
#[derive(Debug, Clone, Default)]
pub(crate) struct SignedSums([[Rational; 2]; 4]);

impl SignedSums {
    /// The sums over the readings of both. Exact.
    pub(crate) fn merged(self, other: &Self) -> Self {
        let mut sums = self.0;
        let pairs = sums.iter_mut().flatten().zip(other.0.iter().flatten());
        pairs.for_each(|(own, other)| *own = &*own + other);
        SignedSums(sums)
    }
}

/// Bounds of which one is missing say more about a whole than bounds that cross.
pub(crate) fn merged_or_reason(
    one: Result<SignedSums, NoEui>,
    other: Result<SignedSums, NoEui>,
) -> Result<SignedSums, NoEui> {
    match (one, other) {
        (Ok(one), Ok(other)) => Ok(one.merged(&other)),
        (Err(NoEui::OneSided), _) | (_, Err(NoEui::OneSided)) => Err(NoEui::OneSided),
        (Err(reason), _) | (_, Err(reason)) => Err(reason),
    }
}

impl Weights {
    /// The weights of readings with these sums.
    pub(crate) fn new(Sums { uu, uv, vv, uy, vy, .. }: &Sums) -> Self {
        let of = [[vv.clone(), -uv], [-uv, uu.clone()], [Rational::one(), Rational::zero()]];
        Weights { of, middles: [uy.clone(), vy.clone()] }
    }

    /// Returns what readings in columns, with their rounded regressors, add. Exact. Cost: linear, on whole columns where these say
    /// it all.
    ///
    /// # Errors
    /// When a reading has no bound on its error.
    pub(crate) fn of_columns(
        &self,
        meaning: &Meaning,
        columns: &[Column],
        rounded: &[Vec<f64>; 2],
        number: &dyn Fn(usize) -> usize,
    ) -> Result<SignedSums, NoEui> {
        if let Some(sums) = self.by_columns(meaning, columns, rounded) {
            return sums;
        }
        let mut sums = [(); 4].map(|()| [(); 2].map(|()| Sum::default()));
        let mut is_crossing = false;
        for row in 0..columns.first().map_or(0, Column::len) {
            let reading = meaning.of_columns(columns, row, number(row));
            let (Some(epsilon), Some(middle)) = (reading.half_width(), reading.middle()) else {
                return Err(NoEui::OneSided);
            };
            is_crossing |= epsilon.is_negative();
            let [u, v] = &reading.regressor;
            let [first, second, own, middles] = &mut sums;
            for ([p, q], [sum_u, sum_v]) in self.of.iter().zip([first, second, own]) {
                let signed =
                    if (p * u + q * v).is_negative() { -epsilon.as_ref() } else { epsilon.as_ref().clone() };
                sum_u.add_product(u, &signed);
                sum_v.add_product(v, &signed);
            }
            if !meaning.is_around_y() && meaning.has_response {
                middles[0].add_product(u, &middle);
                middles[1].add_product(v, &middle);
            }
        }
        if is_crossing {
            return Err(NoEui::Crossing);
        }
        Ok(SignedSums(sums.map(|pair| pair.map(|sum| sum.total()))))
    }

    /// Returns how far least squares may move, from what all readings add.
    pub(crate) fn reach(&self, meaning: &Meaning, sums: SignedSums) -> Reach {
        let SignedSums([first, second, [absolute, _], middles]) = sums;
        let radius = |[p, q]: &[Rational; 2], [sum_u, sum_v]: [Rational; 2]| p * sum_u + q * sum_v;
        let radii = [radius(&self.of[0], first), radius(&self.of[1], second)];
        let middles = if meaning.has_response { middles } else { self.middles.clone() };
        Reach { radii, absolute, middles: (!meaning.is_around_y()).then_some(middles) }
    }

    /// The sums over whole columns; `None` where these do not say what a reading is.
    fn by_columns(
        &self,
        meaning: &Meaning,
        columns: &[Column],
        rounded: &[Vec<f64>; 2],
    ) -> Option<Result<SignedSums, NoEui>> {
        if !meaning.form.x_origin.is_zero() {
            return None;
        }
        let regressors = meaning.regressors();
        let second = if regressors == 2 { Some(columns.get(1)?) } else { None };
        let phi = Phi { u: columns.first()?, v: second, rounded };
        if !meaning.is_around_y() {
            let halves = Halves::of_columns(meaning, columns)?;
            let widths = halves.widths()?;
            if widths.first_negative().is_some() {
                return Some(Err(NoEui::Crossing));
            }
            let [first, second, own] = self.signed(&phi, Some(&widths));
            let middles =
                if meaning.has_response { phi.products(&halves.middles()?) } else { Default::default() };
            return Some(Ok(SignedSums([first, second, own, middles])));
        }
        let sums = match meaning.error_bound.uniform() {
            Some(uniform) => self.signed(&phi, None).map(|pair| pair.map(|sum| sum * uniform)),
            None => self.signed(&phi, Some(columns.get(regressors + 1)?)),
        };
        let [first, second, own] = sums;
        Some(Ok(SignedSums([first, second, own, <[Rational; 2]>::default()])))
    }

    /// Σ ±u·ε and Σ ±v·ε with each sign, where a missing ε is 1. Rows whose signs are the same are summed together.
    fn signed(&self, phi: &Phi, epsilon: Option<&Column>) -> [[Rational; 2]; 3] {
        let [first, second, own] = self.of.each_ref().map(|weight| phi.are_negative(weight));
        let kinds: Vec<u8> = first
            .iter()
            .zip(&second)
            .zip(&own)
            .map(|((&first, &second), &own)| u8::from(first) << 2 | u8::from(second) << 1 | u8::from(own))
            .collect();
        let (sums, units) = phi.word_sums(&kinds, epsilon).unwrap_or_else(|| {
            let mut alike: [Vec<usize>; KINDS] = Default::default();
            for (row, &kind) in kinds.iter().enumerate() {
                alike[usize::from(kind) % KINDS].push(row);
            }
            (alike.map(|rows| phi.sums_at(&rows, epsilon)), [Rational::one(), Rational::one()])
        });
        let mut signed = [(); 3].map(|()| <[Rational; 2]>::default());
        for (kind, sums) in sums.iter().enumerate() {
            for (signed, bit) in signed.iter_mut().zip([4, 2, 1]) {
                for (signed, sum) in signed.iter_mut().zip(sums) {
                    *signed = if kind & bit == 0 { &*signed + sum } else { &*signed - sum };
                }
            }
        }
        signed.map(|[of_u, of_v]| [of_u * &units[0], of_v * &units[1]])
    }
}

/// The number of ways in which three signs may differ.
const KINDS: usize = 8;

/// The regressors in columns.
struct Phi<'a> {
    u: &'a Column,
    /// Missing where it is 1.
    v: Option<&'a Column>,
    rounded: &'a [Vec<f64>; 2],
}

impl Phi<'_> {
    /// Returns, for each row, whether p·u + q·v is negative. Exact. Cost: linear, with a few fractions where it is
    /// almost 0.
    fn are_negative(&self, [p, q]: &[Rational; 2]) -> Vec<bool> {
        /// The relative margin, 2⁻⁴⁸, that exceeds the rounding error of the sum of both terms.
        const MARGIN: f64 = 1.0 / (1_u64 << 48) as f64;
        /// The number of rows that are looked at together.
        const LANES: usize = 64;
        // Only the sign matters, so that the larger of the two may be a float in the middle of its range.
        let size = p.abs().max(q.abs());
        let rounded = |own: &Rational| own.checked_div(&size).map_or(0.0, |own| float(&own));
        let (rounded_p, rounded_q) = (rounded(p), rounded(q));
        let exact = |row: usize| {
            let weight = match self.v {
                Some(v) => p * self.u.get(row) + q * v.get(row),
                None => p * self.u.get(row) + q,
            };
            weight.is_negative()
        };
        let [u, v] = self.rounded;
        let weight_and_size = |(u, v): (&f64, &f64)| {
            let (of_u, of_v) = (rounded_p * u, rounded_q * v);
            (of_u + of_v, of_u.abs() + of_v.abs())
        };
        let is_certain = |(weight, size): (f64, f64)| weight.abs() > MARGIN * size;
        let mut are_negative = Vec::with_capacity(u.len());
        // A loop without branches takes many numbers at a time.
        for (u, v) in u.chunks(LANES).zip(v.chunks(LANES)) {
            let weights = || u.iter().zip(v).map(weight_and_size);
            let start = are_negative.len();
            are_negative.extend(weights().map(|(weight, _)| weight < 0.0));
            if !weights().fold(true, |all, weight| all & is_certain(weight)) {
                let uncertain = (start..).zip(weights()).filter(|(_, weight)| !is_certain(*weight));
                // A result of exactly 0 is no product that underflowed.
                uncertain.for_each(|(row, (_, size))| are_negative[row] = size != 0.0 && exact(row));
            }
        }
        are_negative
    }

    /// Σ u·m and Σ v·m. Exact.
    fn products(&self, factors: &Column) -> [Rational; 2] {
        let of_v = self.v.map_or_else(|| column_sum(factors), |v| product_sum(v, factors));
        [product_sum(self.u, factors), of_v].map(|sum| sum.total())
    }

    /// Σ u·ε and Σ v·ε over the rows of each kind, where a missing ε is 1, in units of each. Exact; `None` where columns are no words,
    /// or sums may not be. Cost: a few instructions a row, a fraction of what it takes to put rows of a kind together.
    fn word_sums(
        &self,
        kinds: &[u8],
        epsilon: Option<&Column>,
    ) -> Option<([[Rational; 2]; KINDS], [Rational; 2])> {
        fn narrow(column: &Column) -> Option<&Scaled<i64>> {
            if let Column::Narrow(scaled) = column { Some(scaled) } else { None }
        }
        let ones = Column::Narrow(Scaled::new(std::iter::repeat_n(1, kinds.len()), Unit::Any)?);
        let [u, v, epsilon] =
            [narrow(self.u)?, narrow(self.v.unwrap_or(&ones))?, narrow(epsilon.unwrap_or(&ones))?];
        let [of_u, of_v, of_epsilon] = [u, v, epsilon].map(|own| widest(own.counts()));
        if of_u.max(of_v) + of_epsilon + bits(kinds.len() as u128) > WORD_BITS {
            return None;
        }
        let mut sums = [[0_i64; 2]; KINDS];
        let rows = u.counts().iter().zip(v.counts()).zip(epsilon.counts());
        for (&kind, ((&u, &v), &epsilon)) in kinds.iter().zip(rows) {
            let [of_u, of_v] = &mut sums[usize::from(kind) % KINDS];
            *of_u = of_u.wrapping_add(u.wrapping_mul(epsilon));
            *of_v = of_v.wrapping_add(v.wrapping_mul(epsilon));
        }
        let units = [u, v].map(|own| own.unit().value() * epsilon.unit().value());
        Some((sums.map(|pair| pair.map(Rational::from)), units))
    }

    /// Σ u·ε and Σ v·ε over these rows, where a missing ε is 1. Exact.
    fn sums_at(&self, rows: &[usize], epsilon: Option<&Column>) -> [Rational; 2] {
        let at = |column: &Column| column.at(rows.iter().copied());
        let (u, v) = (at(self.u), self.v.map(at));
        match epsilon.map(at) {
            Some(epsilon) => Phi { u: &u, v: v.as_ref(), rounded: self.rounded }.products(&epsilon),
            None => {
                let of_v = v.map_or_else(|| Rational::from(rows.len()), |v| column_sum(&v).total());
                [column_sum(&u).total(), of_v]
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Short numbers have sums of words, long ones have none. Some cases lack the second regressor, some the error bounds.
    #[test]
    fn words_of_a_kind_come_to_what_the_rows_of_the_kind_do() {
        let mut seed = 4_u64;
        let mut below = |size: i64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 2) as i64 % size
        };
        let rounded = [Vec::new(), Vec::new()];
        let mut found = [0; 2];
        for round in 0..400_usize {
            let count = round % 50;
            let mut column = |unit: Unit| {
                let size = 1 << (5 * (1 + below(12)));
                Column::of_counts(
                    (0..count).map(|_| i128::from(below(size) - size / 2)).collect::<Vec<_>>().into_iter(),
                    unit,
                )
            };
            let [u, v, epsilon] = [Unit::TenTo(-3), Unit::OneOver(7), Unit::TenTo(2)].map(&mut column);
            let phi = Phi { u: &u, v: (round % 2 == 0).then_some(&v), rounded: &rounded };
            let epsilon = (round % 3 > 0).then_some(&epsilon);
            let kinds: Vec<u8> = (0..count).map(|_| below(8) as u8).collect();
            let own = phi.word_sums(&kinds, epsilon);
            found[usize::from(own.is_none())] += 1;
            let Some((sums, units)) = own else { continue };
            for (kind, [of_u, of_v]) in sums.iter().enumerate() {
                let rows: Vec<usize> = (0..count).filter(|&row| usize::from(kinds[row]) == kind).collect();
                assert_eq!(
                    [of_u * &units[0], of_v * &units[1]],
                    phi.sums_at(&rows, epsilon),
                    "{round} {kind}"
                );
            }
        }
        assert!(found.iter().all(|&own| own > 100), "{found:?}");
    }
}
