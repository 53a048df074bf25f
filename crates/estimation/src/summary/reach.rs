//! How far least squares may move, for readings whose error bounds differ or whose regressors are two: only known when all
//! readings have been seen.

use boundfit_exact::{Column, Integer, Rational, Scaled, Sum};

use super::halves::Halves;
use super::sums::Sums;
use super::{NoEui, Reach};
use crate::meaning::Meaning;

/// A_jk times the determinant of ΦᵀΦ is p·φ_k1 + q·φ_k2, with (p, q) a row of the adjugate; then φ_k1 itself.
#[derive(Debug, Clone)]
pub(crate) struct Weights([[Rational; 2]; 3]);

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
    pub(crate) fn new(Sums { uu, uv, vv, .. }: &Sums) -> Self {
        Weights([[vv.clone(), -uv], [-uv, uu.clone()], [Rational::one(), Rational::zero()]])
    }

    /// What readings in columns add. Exact. Cost: linear, on machine integers where they fit.
    ///
    /// # Errors
    /// When a reading has no bound on its error.
    pub(crate) fn of_columns(
        &self,
        meaning: &Meaning,
        columns: &[Column],
        number: &dyn Fn(usize) -> usize,
    ) -> Result<SignedSums, NoEui> {
        if let Some(sums) = self.on_integers(meaning, columns) {
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
            for ([p, q], [sum_u, sum_v]) in self.0.iter().zip([first, second, own]) {
                let signed =
                    if (p * u + q * v).is_negative() { -epsilon.as_ref() } else { epsilon.as_ref().clone() };
                sum_u.add_product(u, &signed);
                sum_v.add_product(v, &signed);
            }
            if !meaning.is_around_y() {
                middles[0].add_product(u, &middle);
                middles[1].add_product(v, &middle);
            }
        }
        if is_crossing {
            return Err(NoEui::Crossing);
        }
        Ok(SignedSums(sums.map(|pair| pair.map(|sum| sum.total()))))
    }

    /// How far least squares may move, from what all readings add.
    pub(crate) fn reach(&self, meaning: &Meaning, sums: SignedSums) -> Reach {
        let SignedSums([first, second, [absolute, _], middles]) = sums;
        let radius = |[p, q]: &[Rational; 2], [sum_u, sum_v]: [Rational; 2]| p * sum_u + q * sum_v;
        let radii = [radius(&self.0[0], first), radius(&self.0[1], second)];
        Reach { radii, absolute, middles: (!meaning.is_around_y()).then_some(middles) }
    }

    /// The sums on machine integers; `None` where these might not hold them.
    fn on_integers(&self, meaning: &Meaning, columns: &[Column]) -> Option<Result<SignedSums, NoEui>> {
        let scaled = |index: usize| match columns.get(index) {
            Some(Column::Narrow(scaled)) => Some(scaled),
            _ => None,
        };
        if !meaning.form.x_origin.is_zero() {
            return None;
        }
        let regressors = meaning.regressors();
        let u = scaled(0)?;
        let v = if regressors == 2 { Some(scaled(1)?) } else { None };
        if !meaning.is_around_y() {
            let Halves { middles, widths } = Halves::of_columns(meaning, columns)?;
            if widths.counts().iter().any(|&width| width < 0) {
                return Some(Err(NoEui::Crossing));
            }
            let [first, second, own] = self.signed(u, v, Some(&widths), &Rational::one())?;
            let middles = [Some(u), v].map(|own| products(own, &middles));
            let [Some(of_u), Some(of_v)] = middles else { return None };
            return Some(Ok(SignedSums([first, second, own, [of_u, of_v]])));
        }
        let (epsilon, uniform) = match meaning.error_bound.uniform() {
            Some(uniform) => (None, uniform.clone()),
            None => (Some(scaled(regressors + 1)?), Rational::one()),
        };
        let [first, second, own] = self.signed(u, v, epsilon, &uniform)?;
        Some(Ok(SignedSums([first, second, own, <[Rational; 2]>::default()])))
    }

    /// Σ ±u·ε and Σ ±v·ε with each sign, where a missing v is 1 and a missing ε the number for all.
    fn signed(
        &self,
        u: &Scaled<i64>,
        v: Option<&Scaled<i64>>,
        epsilon: Option<&Scaled<i64>>,
        uniform: &Rational,
    ) -> Option<[[Rational; 2]; 3]> {
        let (u_unit, v_unit, epsilon_unit) = (u.unit().value(), unit(v), unit(epsilon) * uniform);
        let count = |column: Option<&Scaled<i64>>, row: usize| column.map_or(1, |own| own.counts()[row]);
        let sums = |[p, q]: &[Rational; 2]| {
            // Only the sign of a weight matters.
            let ([p, q], _) = Rational::over_common_denominator([&(p * &u_unit), &(q * &v_unit)]);
            let divisor = p.gcd(&q);
            let [p, q] = [p, q].map(|own| if divisor.is_zero() { own } else { own.quotient(&divisor) });
            let (p, q) = (p.to_i128()?, q.to_i128()?);
            let (mut sum_u, mut sum_v) = (0_i128, 0_i128);
            for (row, &u) in u.counts().iter().enumerate() {
                let (v, epsilon) = (count(v, row), count(epsilon, row));
                let weight = p.checked_mul(u.into())?.checked_add(q.checked_mul(v.into())?)?;
                let signed = i128::from(if weight < 0 { epsilon.checked_neg()? } else { epsilon });
                sum_u = sum_u.checked_add(signed * i128::from(u))?;
                sum_v = sum_v.checked_add(signed * i128::from(v))?;
            }
            let number =
                |sum: i128, unit: &Rational| Rational::from(Integer::from(sum)) * unit * &epsilon_unit;
            Some([number(sum_u, &u_unit), number(sum_v, &v_unit)])
        };
        let [first, second, own] = &self.0;
        Some([sums(first)?, sums(second)?, sums(own)?])
    }
}

/// What a column counts; without one 1.
fn unit(column: Option<&Scaled<i64>>) -> Rational {
    column.map_or_else(Rational::one, |own| own.unit().value())
}

/// Σ u·m on machine integers, where a missing u is 1; `None` where the sum does not fit.
fn products(u: Option<&Scaled<i64>>, middles: &Scaled<i64>) -> Option<Rational> {
    let mut sum = 0_i128;
    for (row, &middle) in middles.counts().iter().enumerate() {
        let u = u.map_or(1, |own| own.counts()[row]);
        sum = sum.checked_add(i128::from(u) * i128::from(middle))?;
    }
    Some(Rational::from(Integer::from(sum)) * unit(u) * middles.unit().value())
}
