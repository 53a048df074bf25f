//! Readings that are in memory already, as columns.

use boundfit_exact::{Column, Foreign};
use thiserror::Error;

use super::{Keep, LineSummary, SharedSieve, Thresholds};
use crate::meaning::{ErrorBound, Meaning, Model};
use crate::measurements::{Measurements, Origin, Readings};
use crate::reduction::{DecidingMinimax, NoEui, Reach, Reduction};
use crate::ties::Ties;

/// The number of readings that are summarised at a time: few enough for sums in 128 bits, many enough to keep little
/// of them.
const ROWS_PER_PART: usize = 1 << 16;

/// The kind of mistake in columns.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ColumnsError {
    /// Regressors, response and, with one for each reading, error bounds are not as many.
    #[error("the model has {expected} columns, not {found}")]
    Count {
        /// The expected number of columns.
        expected: usize,
        /// The number of columns that were given.
        found: usize,
    },
    /// The columns differ in length.
    #[error("column {column} has {found} numbers, not {expected} like the first")]
    Length {
        /// The number of the column, from 1.
        column: usize,
        /// The number of numbers in the first column.
        expected: usize,
        /// The number of numbers in this column.
        found: usize,
    },
    /// The error bound of all readings is negative.
    #[error("the error bound is negative")]
    NegativeErrorBound,
    /// The error bound of a reading is negative.
    #[error("row {row} has a negative error bound")]
    NegativeErrorBoundOf {
        /// The first such row, from 1.
        row: usize,
    },
}

impl Measurements {
    /// Readings from columns: x of a line or φ1 and φ2, then the response, and the error bounds if each reading has
    /// its own. Rows are numbered from 1. Keeps only the readings that support a hull if a line under a uniform error
    /// bound has more than `keep.most_rows` readings.
    ///
    /// ```
    /// use boundfit_estimation::{ErrorBound, Keep, Measurements, Model, Problem, fit};
    /// use boundfit_exact::{Column, Rational, Unit};
    ///
    /// let x = Column::of_counts(1..=100_000, Unit::TenTo(-3));
    /// let y = Column::of_counts((1..=100_000).map(|k| 2 * k + k * k % 1009), Unit::TenTo(-3));
    /// let model = Model::Line { x: "x".into() };
    /// let bound = ErrorBound::Uniform(Rational::one());
    /// let measurements =
    ///     Measurements::of_columns(model, "y".into(), bound, &[x, y], Keep::default())?;
    /// assert_eq!(measurements.fitted(), 100_000);
    /// assert!(measurements.kept().len() < 1000);
    /// let fit = fit(&Problem { measurements, conditions: Vec::new() });
    /// assert_eq!(fit.minimax.unwrap().theta[0], Rational::from(2));
    /// # Ok::<(), boundfit_estimation::ColumnsError>(())
    /// ```
    ///
    /// Exact. Cost: linear, on one thread.
    ///
    /// # Errors
    /// When the columns are not those of the model, differ in length, or an error bound is negative.
    pub fn of_columns(
        model: Model,
        response: Foreign,
        error_bound: ErrorBound,
        columns: &[Column],
        keep: Keep,
    ) -> Result<Self, ColumnsError> {
        let meaning = Meaning::new(model, response, error_bound);
        check(&meaning, columns)?;
        let rows_total = columns.first().map_or(0, Column::len);
        let readings = match (&meaning.model, &meaning.error_bound, columns) {
            (Model::Line { .. }, ErrorBound::Uniform(epsilon), [x, y]) if rows_total > keep.most_rows => {
                let (mut summary, sieve) = (LineSummary::default(), SharedSieve::listing(Ties::MOST_LISTED));
                for start in (0..rows_total).step_by(ROWS_PER_PART) {
                    let range = start..rows_total.min(start + ROWS_PER_PART);
                    let [x, y] = [x.part(range.clone()), y.part(range)];
                    summary
                        .merge(LineSummary::of_columns([&x, &y], None, &|k| start + 1 + k, &sieve), &sieve);
                }
                let (sums, rows, ties) = summary.into_parts(epsilon, &sieve);
                let reach = || {
                    let spread = Thresholds::of_form(&meaning.form, &sums).of_column(x);
                    let (radii, absolute) = (spread.absolute_weights(&sums), spread.absolute_x(&sums));
                    Reach { radii, absolute, middles: None }
                };
                let reach = keep.eui.then(reach).ok_or(NoEui::NotAsked);
                let (count, minimax, has_widths) = (rows_total, DecidingMinimax::Kept, true);
                let reduction = Reduction { count, sums: Ok(sums), reach, minimax, has_widths };
                Readings::Supporting { rows, ties, reduction }
            }
            _ => {
                let row = |k: usize| meaning.measurement(k + 1, columns.iter().map(|column| column.get(k)));
                Readings::All((0..rows_total).map(row).collect())
            }
        };
        let origin = Origin { rows_total, ..Origin::default() };
        Ok(Measurements { meaning, readings, others: Vec::new(), origin })
    }
}

fn check(meaning: &Meaning, columns: &[Column]) -> Result<(), ColumnsError> {
    let regressors = if matches!(meaning.model, Model::Line { .. }) { 1 } else { 2 };
    let bounds = usize::from(!meaning.error_bound.is_uniform());
    let (expected, found) = (regressors + 1 + bounds, columns.len());
    if found != expected {
        return Err(ColumnsError::Count { expected, found });
    }
    let expected = columns[0].len();
    if let Some(index) = columns.iter().position(|column| column.len() != expected) {
        return Err(ColumnsError::Length { column: index + 1, expected, found: columns[index].len() });
    }
    match &meaning.error_bound {
        ErrorBound::Uniform(epsilon) if epsilon.is_negative() => Err(ColumnsError::NegativeErrorBound),
        ErrorBound::Uniform(_) => Ok(()),
        ErrorBound::Column(_) | ErrorBound::Interval { .. } | ErrorBound::Law(_) => {
            match columns[found - 1].first_negative() {
                Some(index) => Err(ColumnsError::NegativeErrorBoundOf { row: index + 1 }),
                None => Ok(()),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use boundfit_exact::Rational;

    use super::*;

    /// Ties, rows of equal x, and parts that have other numbers than integers.
    #[test]
    fn integers_among_doubles_are_numbers_like_others() {
        let of = |columns: &[Column]| {
            let model = Model::Line { x: "x".into() };
            let bound = ErrorBound::Uniform(Rational::from(4));
            let keep = Keep { most_rows: 100, ..Keep::default() };
            let read = Measurements::of_columns(model, "y".into(), bound, columns, keep).unwrap();
            let fit = crate::Problem::new(read).fit();
            (fit.least_squares.ok(), fit.pui, fit.central, fit.minimax)
        };
        let mut state = 1_u64;
        let mut word = |below: u64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((state >> 33) % below) as f64
        };
        for other in [None, Some(0), Some(ROWS_PER_PART + 7)] {
            let x: Vec<f64> = (0..2 * ROWS_PER_PART + 99).map(|_| word(60)).collect();
            let mut y: Vec<f64> = x.iter().map(|x| 3.0 * x + word(7) - 3.0).collect();
            if let Some(row) = other {
                y[row] += 0.5;
            }
            let doubles = [x, y].map(|numbers| Column::of_doubles(&numbers).unwrap());
            let fractions = doubles
                .each_ref()
                .map(|column| Column::Fractions((0..column.len()).map(|row| column.get(row)).collect()));
            assert_eq!(of(&doubles), of(&fractions), "{other:?}");
        }
    }
}
