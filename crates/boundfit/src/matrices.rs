//! Readings in matrices of nalgebra, and vertices as its points.

use nalgebra::{DVector, Dim, Dyn, Matrix, Point2, RawStorage};
use num_rational::BigRational;

use boundfit_exact::Rational;

use crate::observations::{Error, Observations};

impl Observations {
    /// Readings y = Φ·θ + e in a regressor matrix Φ and a vector y of nalgebra, a row for each reading. Exact: each double is the
    /// dyadic fraction that it is. Cost: O(n).
    ///
    /// A matrix of one column, or a vector, holds the x of a line: y = theta1*x + theta2 + e. A matrix of two columns holds two
    /// regressors: y = theta1*phi1 + theta2*phi2 + e.
    ///
    /// ```
    /// use boundfit::Observations;
    /// use boundfit::nalgebra::{DMatrix, DVector};
    ///
    /// let y = DVector::from_vec(vec![0.0, 1.5, 2.0]);
    /// let line = Observations::from_matrix(&DVector::from_vec(vec![0.0, 1.0, 2.0]), &y)?.error_bound(0.5)?.fit();
    /// // The same line: its second regressor is 1.
    /// let phi = DMatrix::from_row_slice(3, 2, &[0.0, 1.0, 1.0, 1.0, 2.0, 1.0]);
    /// let regressors = Observations::from_matrix(&phi, &y)?.error_bound(0.5)?.fit();
    /// assert_eq!(line.vertices(), regressors.vertices());
    /// # Ok::<(), boundfit::Error>(())
    /// ```
    ///
    /// # Errors
    /// When the matrix has no column or more than two, a number is not finite, or there are not as many rows as readings.
    pub fn from_matrix<C: Dim, S: RawStorage<f64, Dyn, C>>(
        phi: &Matrix<f64, Dyn, C, S>,
        y: &DVector<f64>,
    ) -> Result<Self, Error> {
        let column = |index: usize| phi.column(index).iter().copied().collect::<Vec<f64>>();
        match phi.ncols() {
            1 => Observations::line(&column(0), y.as_slice()),
            2 => Observations::regressors(&column(0), &column(1), y.as_slice()),
            columns => Err(Error::Regressors { columns }),
        }
    }
}

/// Vertices, or other parameter pairs, as points of nalgebra. Exact. Cost: O(n).
///
/// ```
/// use boundfit::exact_points;
/// use boundfit::num_rational::BigRational;
///
/// let fit = boundfit::fit(&[0, 1, 2], &["0", "1.5", "2"], "1/2")?;
/// let points = exact_points(&fit.vertices());
/// assert_eq!(points[0].x, BigRational::new(1.into(), 2.into()));
/// let edge = &points[1] - &points[0];
/// assert_eq!(edge.x, BigRational::from_integer(1.into()));
/// # Ok::<(), boundfit::Error>(())
/// ```
pub fn exact_points(pairs: &[[Rational; 2]]) -> Vec<Point2<BigRational>> {
    pairs.iter().map(|pair| Point2::from(pair.each_ref().map(BigRational::from))).collect()
}

/// Vertices, or other parameter pairs, as points of doubles. **Rounded**: each coordinate is the double nearest to the exact one,
/// so that a point may lie outside the set, and vertices close to each other may coincide. Cost: O(n).
///
/// ```
/// use boundfit::nalgebra::Point2;
/// use boundfit::rounded_points;
///
/// let fit = boundfit::fit(&[0, 3], &[0, 1], "1/10")?;
/// assert_eq!(rounded_points(&fit.vertices())[0], Point2::new(0.8 / 3.0, 0.1));
/// # Ok::<(), boundfit::Error>(())
/// ```
pub fn rounded_points(pairs: &[[Rational; 2]]) -> Vec<Point2<f64>> {
    pairs.iter().map(|pair| Point2::from(pair.each_ref().map(Rational::to_f64))).collect()
}
