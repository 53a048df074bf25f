//! Exact least squares and its uncertainty intervals.

use boundfit_exact::{Endpoint, Integer, Interval, Rational, Sum};
use boundfit_geometry::Direction;
use thiserror::Error;

use crate::grid::{Column, Grid};
use crate::measurements::{ErrorBound, Measurements, Readings};
use crate::summary::NoEui;

/// The least-squares estimate θ̂ = (ΦᵀΦ)⁻¹Φᵀy with its estimate uncertainty intervals.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LeastSquares {
    /// θ̂.
    pub theta: [Rational; 2],
    /// EUI_j = [θ̂_j ∓ Σ_k |A_jk|·ε_k] with A = (ΦᵀΦ)⁻¹Φᵀ: where θ̂_j would lie for any errors within their bounds.
    ///
    /// It takes a second look at all readings; why there was none, otherwise.
    pub eui: Result<[Interval; 2], NoEui>,
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
        LeastSquares::with_grid(measurements, Grid::new(measurements).as_ref())
    }

    /// The same where the readings are on a grid already, if they fit on one.
    pub(crate) fn with_grid(
        measurements: &Measurements,
        grid: Option<&Grid>,
    ) -> Result<Self, SingularRegressors> {
        if let Readings::Supporting { reduction, .. } = measurements.readings() {
            return LeastSquares::of_reduction(reduction, measurements.error_bound());
        }
        match grid.and_then(|grid| LeastSquares::on_grid(measurements, grid)) {
            Some(solved) => solved,
            None => LeastSquares::in_general(measurements),
        }
    }

    /// The same without machine integers, for readings of any size.
    ///
    /// # Errors
    /// When ΦᵀΦ is singular.
    pub fn in_general(measurements: &Measurements) -> Result<Self, SingularRegressors> {
        let rows = measurements.kept();
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
        let eui = Ok([interval(0)?, interval(1)?]);
        Ok(LeastSquares { theta, eui })
    }

    /// The same on machine integers, every fraction reduced once; `None` when a sum does not fit into 128 bits.
    fn on_grid(measurements: &Measurements, grid: &Grid) -> Option<Result<Self, SingularRegressors>> {
        let Moments { g11, g12, g22, m1, m2 } = Moments::new(grid)?;
        let [i11, i12, i22, i1, i2] = [g11, g12, g22, m1, m2].map(Integer::from);
        let determinant = &i11 * &i22 - &i12 * &i12;
        if determinant.is_zero() {
            return Some(Err(SingularRegressors));
        }
        let solutions = [&i22 * &i1 - &i12 * &i2, &i11 * &i2 - &i12 * &i1];
        // With φ = Φ/s and y = Y/t, an estimate in the units of the grid is θ·t/s.
        let one = Integer::one();
        let scales = [grid.phi1.scale(), grid.phi2.as_ref().map_or(one.clone(), Column::scale)];
        let response_scale = grid.response.scale();
        let (epsilon, epsilon_scale) = match (measurements.error_bound(), &grid.epsilon) {
            (ErrorBound::Uniform(epsilon), _) => (epsilon.numerator(), epsilon.denominator()),
            (ErrorBound::PerRow(_), column) => (one.clone(), column.as_ref().map_or(one, Column::scale)),
        };
        // A_jk = (p·φ_k1 + q·φ_k2) / det with (p, q) a row of the adjugate.
        let reaches = [(g22, g12.checked_neg()?), (g12.checked_neg()?, g11)];
        // The estimate and the ends of its interval have this denominator in common.
        let denominator = &determinant * &response_scale * &epsilon_scale;
        let part = |j: usize| {
            let centre = &solutions[j] * &epsilon_scale;
            let radius = reach(grid, reaches[j])? * &epsilon * &response_scale;
            let scaled = |numerator: Integer| Rational::new(numerator * &scales[j], denominator.clone());
            let ends = [scaled(&centre - &radius)?, scaled(&centre + &radius)?].map(Endpoint::Finite);
            let [lower, upper] = ends;
            Some((scaled(centre)?, Interval::new(lower, upper)?))
        };
        let ((theta1, eui1), (theta2, eui2)) = (part(0)?, part(1)?);
        Some(Ok(LeastSquares { theta: [theta1, theta2], eui: Ok([eui1, eui2]) }))
    }
}

/// ΦᵀΦ and Φᵀy of readings on a grid.
struct Moments {
    g11: i128,
    g12: i128,
    g22: i128,
    m1: i128,
    m2: i128,
}

impl Moments {
    fn new(grid: &Grid) -> Option<Self> {
        let (first, response) = (&grid.phi1.mantissas, &grid.response.mantissas);
        let rows = first.iter().zip(response);
        let mut sums = Moments { g11: 0, g12: 0, g22: 0, m1: 0, m2: 0 };
        match &grid.phi2 {
            None => {
                sums.g22 = i128::try_from(grid.len()).ok()?;
                for (&u, &y) in rows {
                    sums.g11 = sums.g11.checked_add(product(u, u))?;
                    sums.g12 = sums.g12.checked_add(i128::from(u))?;
                    sums.m1 = sums.m1.checked_add(product(u, y))?;
                    sums.m2 = sums.m2.checked_add(i128::from(y))?;
                }
            }
            Some(second) => {
                for ((&u, &y), &v) in rows.zip(&second.mantissas) {
                    sums.g11 = sums.g11.checked_add(product(u, u))?;
                    sums.g12 = sums.g12.checked_add(product(u, v))?;
                    sums.g22 = sums.g22.checked_add(product(v, v))?;
                    sums.m1 = sums.m1.checked_add(product(u, y))?;
                    sums.m2 = sums.m2.checked_add(product(v, y))?;
                }
            }
        }
        Some(sums)
    }
}

/// Σ |p·u + q·v|·ε over the readings (u, v) of a grid, in its units; ε counts as 1 when it is uniform.
fn reach(grid: &Grid, (p, q): (i128, i128)) -> Option<Integer> {
    let mut sums = [0_i128, 0];
    for (row, &u) in grid.phi1.mantissas.iter().enumerate() {
        let at = |column: &Option<Column>| column.as_ref().map_or(1, |column| column.mantissas[row]);
        let (v, epsilon) = (at(&grid.phi2), at(&grid.epsilon));
        let cross = p.checked_mul(i128::from(u))?.checked_add(q.checked_mul(i128::from(v))?)?;
        let signed = if cross < 0 { -epsilon } else { epsilon };
        sums[0] = sums[0].checked_add(product(signed, u))?;
        sums[1] = sums[1].checked_add(product(signed, v))?;
    }
    Some(Integer::from(p) * Integer::from(sums[0]) + Integer::from(q) * Integer::from(sums[1]))
}

fn product(left: i64, right: i64) -> i128 {
    i128::from(left) * i128::from(right)
}
