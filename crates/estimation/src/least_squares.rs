//! Exact least squares and its uncertainty intervals.

use boundfit_exact::{Interval, Rational, Sum};
use boundfit_geometry::Direction;
use thiserror::Error;

use crate::measurements::Measurements;

/// The least-squares estimate θ̂ = (ΦᵀΦ)⁻¹Φᵀy with its estimate uncertainty intervals.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LeastSquares {
    /// θ̂.
    pub theta: [Rational; 2],
    /// EUI_j = [θ̂_j ∓ Σ_k |A_jk|·ε_k] with A = (ΦᵀΦ)⁻¹Φᵀ: where θ̂_j would lie for any errors within their bounds.
    pub eui: [Interval; 2],
}

/// ΦᵀΦ has no inverse: all regressors are multiples of one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error(
    "the regressors are all parallel (for a line: fewer than two distinct x), so the normal equations are singular"
)]
pub struct SingularRegressors;

impl LeastSquares {
    /// Solves the normal equations. Exact. Cost: linear in the number of readings.
    ///
    /// # Errors
    /// When ΦᵀΦ is singular.
    pub fn new(measurements: &Measurements) -> Result<Self, SingularRegressors> {
        let rows = measurements.rows();
        let total = |term: &dyn Fn(usize, &mut Sum)| {
            let mut sum = Sum::default();
            (0..rows.len()).for_each(|row| term(row, &mut sum));
            sum.total()
        };
        let gram = |i: usize, j: usize| {
            total(&|row, sum| sum.add_product(&rows[row].regressor[i], &rows[row].regressor[j]))
        };
        let moment =
            |i: usize| total(&|row, sum| sum.add_product(&rows[row].regressor[i], &rows[row].response));
        let (g11, g12, g22) = (gram(0, 0), gram(0, 1), gram(1, 1));
        let (m1, m2) = (moment(0), moment(1));
        let determinant = &g11 * &g22 - &g12 * &g12;
        let solved = |numerator: Rational| numerator.checked_div(&determinant).ok_or(SingularRegressors);
        let theta = [solved(&g22 * &m1 - &g12 * &m2)?, solved(&g11 * &m2 - &g12 * &m1)?];

        // A_jk = (p·φ_k1 + q·φ_k2) / det with (p, q) a row of the adjugate; det > 0.
        let reach = |p: &Rational, q: &Rational| {
            let mut sums = [Sum::default(), Sum::default()];
            // Only the sign of A_jk matters here, so p and q may be scaled to integers.
            let scaled = Direction::from_rational(&[p.clone(), q.clone()]).ok_or(SingularRegressors)?;
            for row in rows {
                let [phi1, phi2] = &row.regressor;
                let cross = scaled.dx() * (phi1.numerator() * phi2.denominator())
                    + scaled.dy() * (phi2.numerator() * phi1.denominator());
                let epsilon = if cross.is_negative() { -&row.epsilon } else { row.epsilon.clone() };
                sums[0].add_product(phi1, &epsilon);
                sums[1].add_product(phi2, &epsilon);
            }
            solved(p * sums[0].total() + q * sums[1].total())
        };
        let radii = [reach(&g22, &-&g12)?, reach(&-&g12, &g11)?];
        let interval = |j: usize| Interval::around(&theta[j], &radii[j]).ok_or(SingularRegressors);
        let eui = [interval(0)?, interval(1)?];
        Ok(LeastSquares { theta, eui })
    }
}
