//! Least squares in binary64 by two methods, for comparison with the exact estimate.

use boundfit_exact::Rational;
use nalgebra::{DMatrix, DVector, SVD};

use crate::fit::Fit;
use crate::measurement::Measurement;
use crate::measurements::Measurements;

/// A binary64 estimate beside the exact one.
#[derive(Debug, Clone, PartialEq)]
pub struct FloatEstimate {
    /// The estimate.
    pub theta: [f64; 2],
    /// |θ_j - θ̂_j| from the exact estimate. Exact.
    pub distance: [Rational; 2],
}

/// Least squares as it is computed in binary64: Φ and y are rounded to the nearest doubles first.
#[derive(Debug, Clone, PartialEq)]
pub struct FloatLeastSquares {
    /// The estimate by Householder QR, as MATLAB's `Phi\y`. `None` when it does not come out finite.
    pub qr: Option<FloatEstimate>,
    /// The estimate by the pseudo-inverse from a singular value decomposition, as MATLAB's `pinv(Phi)*y`. Singular
    /// values below max(N, 2)·σ_max·2⁻⁵² count as zero. `None` when it does not come out finite.
    pub pseudo_inverse: Option<FloatEstimate>,
}

impl Fit {
    /// The least-squares estimate in binary64, for comparison; `None` when there is no exact one, or not all readings are
    /// kept. Rounded.
    /// Cost: linear in the number of readings.
    pub fn float_least_squares(&self, measurements: &Measurements) -> Option<FloatLeastSquares> {
        let exact = self.least_squares.as_ref().ok()?;
        let rows = measurements.all()?;
        Some(match measurements.line_form().through_origin {
            true => FloatLeastSquares::of_columns::<1>(rows, &exact.theta),
            false => FloatLeastSquares::new(rows, &exact.theta),
        })
    }
}

impl FloatLeastSquares {
    /// Computes both estimates. Rounded; the distances are exact. Cost: linear in the number of readings.
    pub fn new(rows: &[Measurement], exact: &[Rational; 2]) -> Self {
        FloatLeastSquares::of_columns::<2>(rows, exact)
    }

    /// Computes both estimates of a model with the first so many regressors; the parameters of the others are 0.
    fn of_columns<const COLUMNS: usize>(rows: &[Measurement], exact: &[Rational; 2]) -> Self {
        let phi = DMatrix::from_fn(rows.len(), COLUMNS, |row, column| rows[row].regressor[column].to_f64());
        let y = DVector::from_fn(rows.len(), |row, _| rows[row].value().unwrap_or_default().to_f64());
        // An infinity would keep the iterative decomposition going for ever.
        if phi.iter().chain(y.iter()).any(|value| !value.is_finite()) {
            return FloatLeastSquares { qr: None, pseudo_inverse: None };
        }
        let beside_exact = |theta: DVector<f64>| {
            let theta = [0, 1].map(|axis| theta.get(axis).copied().unwrap_or(0.0));
            let distance = |j: usize| Some((Rational::from_f64(theta[j])? - &exact[j]).abs());
            Some(FloatEstimate { theta, distance: [distance(0)?, distance(1)?] })
        };
        FloatLeastSquares {
            qr: by_qr(&phi, &y).and_then(beside_exact),
            pseudo_inverse: by_pseudo_inverse(phi, &y).and_then(beside_exact),
        }
    }
}

fn by_qr(phi: &DMatrix<f64>, y: &DVector<f64>) -> Option<DVector<f64>> {
    let (q, r) = phi.clone().qr().unpack();
    r.solve_upper_triangular(&(q.transpose() * y))
}

fn by_pseudo_inverse(phi: DMatrix<f64>, y: &DVector<f64>) -> Option<DVector<f64>> {
    const MOST_ITERATIONS: usize = 10_000;
    let size = phi.nrows().max(phi.ncols()) as f64;
    let decomposition = SVD::try_new(phi, true, true, f64::EPSILON, MOST_ITERATIONS)?;
    let negligible = size * decomposition.singular_values.max() * f64::EPSILON;
    Some(decomposition.pseudo_inverse(negligible).ok()? * y)
}
