//! Readings in slices of doubles, of any number.

use boundfit_estimation::{ColumnsError, ErrorBound, Fit, Keep, Measurements, Model, Problem};
use boundfit_exact::{Column, Reading};

use crate::number::{Number, NumberError};
use crate::observations::{Error, same_length};

/// The problem of readings of a line, y = theta1*x + theta2 + e with |e| ≤ eps, in slices of doubles of any length.
///
/// Under [`Reading::Binary64`] a double stands for itself. Under [`Reading::Decimal`] it stands for the shortest
/// decimal that is read as it: 0.1 is 1/10. That is the written number where readings were printed with up to 15
/// digits and parsed.
///
/// The answers are those of [`Observations::line`](crate::Observations::line) and
/// [`error_bound`](crate::Observations::error_bound). For more than 10,000 readings, the function keeps only
/// the readings that decide the feasible set under any error bound. Then 10⁶ of them take some twenty
/// milliseconds, or a tenth of a second where 17 digits are read as decimals. Proofs still name rows, counted
/// from 1. Exact. Cost: linear where few readings are close to the hulls of all, O(n log n) at worst.
///
/// ```
/// use boundfit::Reading;
///
/// let x: Vec<f64> = (0..100_000).map(|k| f64::from(k) / 1e3).collect();
/// let y: Vec<f64> = (0..100_000).map(|k| f64::from(2 * k + k % 7) / 1e3).collect();
/// let fit = boundfit::problem_of_doubles(&x, &y, "0.005", Reading::Decimal)?.fit();
/// assert_eq!(fit.minimax.as_ref().unwrap().least.to_string(), "3/1000");
/// # Ok::<(), boundfit::Error>(())
/// ```
///
/// # Errors
/// When a double or the error bound is not a finite number, the columns are not equally long, or the error bound is negative.
pub fn problem_of_doubles(
    x: &[f64],
    y: &[f64],
    eps: impl Number,
    reading: Reading,
) -> Result<Problem, Error> {
    problem_keeping(x, y, eps, reading, Keep::default())
}

fn problem_keeping(
    x: &[f64],
    y: &[f64],
    eps: impl Number,
    reading: Reading,
    keep: Keep,
) -> Result<Problem, Error> {
    let column = |name: &'static str, doubles: &[f64]| {
        let column = match reading {
            Reading::Decimal => Column::of_shortest(doubles),
            Reading::Binary64 => Column::of_doubles(doubles),
        };
        let not_finite = |index: usize| {
            let value = doubles.get(index).copied().unwrap_or(f64::NAN);
            Error::Number { column: name, row: index + 1, problem: NumberError::NotFinite(value) }
        };
        column.map_err(not_finite)
    };
    same_length(["x", "y"], [x.len(), y.len()])?;
    let columns = [column("x", x)?, column("y", y)?];
    let epsilon = eps.exact().map_err(Error::ErrorBound)?;
    let model = Model::Line { x: "x".into() };
    let bound = ErrorBound::Uniform(epsilon);
    let measurements = Measurements::of_columns(model, "y".into(), bound, &columns, keep);
    match measurements {
        Ok(measurements) => Ok(Problem::new(measurements)),
        Err(ColumnsError::NegativeErrorBound | ColumnsError::NegativeErrorBoundOf { .. }) => {
            Err(Error::NegativeBound { row: None })
        }
        Err(ColumnsError::Count { .. } | ColumnsError::Length { .. }) => {
            Err(Error::Lengths { columns: ["x", "y"], rows: [x.len(), y.len()] })
        }
    }
}

/// Fits a line to readings in slices of doubles: see [`problem_of_doubles`]. Only some dozen readings are kept besides those that
/// decide, so that thousands cost what they cost among millions.
///
/// # Errors
/// The errors are the ones of [`problem_of_doubles`].
///
/// ```
/// use boundfit::Reading;
///
/// let slope = |reading| {
///     let fit = boundfit::fit_doubles(&[0.0, 1.0], &[0.0, 0.1], 0, reading)?;
///     Ok::<_, boundfit::Error>(fit.vertices()[0][0].to_string())
/// };
/// assert_eq!(slope(Reading::Decimal)?, "1/10");
/// assert_eq!(slope(Reading::Binary64)?, "3602879701896397/36028797018963968");
/// # Ok::<(), boundfit::Error>(())
/// ```
pub fn fit_doubles(x: &[f64], y: &[f64], eps: impl Number, reading: Reading) -> Result<Fit, Error> {
    let keep = Keep { most_rows: Keep::DECIDING.most_plain, ..Keep::DECIDING };
    Ok(problem_keeping(x, y, eps, reading, keep)?.fit())
}
