//! Middles and half widths of intervals in columns, and the sums of readings that least squares takes these of.

use std::borrow::Cow;

use boundfit_exact::{Column, Unit};

use crate::meaning::{ErrorBound, Meaning};
use crate::moments::Sums;
use crate::reduction::NoLeastSquares;

/// Middles and half widths of readings that all have both bounds.
pub(crate) struct Halves {
    pub(crate) middles: Column,
    /// Negative where the bounds cross.
    pub(crate) widths: Column,
}

impl Halves {
    /// Takes the bounds from columns; `None` where a bound is missing, where bounds are no intervals, and where 128
    /// bits do not hold them. Exact. Cost: linear.
    pub(crate) fn of_columns(meaning: &Meaning, columns: &[Column]) -> Option<Self> {
        let ErrorBound::Interval { lower: Some(_), upper: Some(_) } = &meaning.error_bound else {
            return None;
        };
        let [.., lower, has_lower, upper, has_upper] = columns else { return None };
        if has_lower.has_zero() || has_upper.has_zero() {
            return None;
        }
        let unit = |column: &Column| match column {
            Column::Narrow(scaled) => Some(scaled.unit()),
            Column::Wide(scaled) => Some(scaled.unit()),
            _ => None,
        };
        let (of_lower, of_upper) = (unit(lower)?, unit(upper)?);
        let common = of_lower.common(of_upper)?;
        // Half of the common unit, and how often it goes into that.
        let (unit, times) = match common {
            Unit::Any => (Unit::TenTo(0), 1),
            Unit::TenTo(exponent) => (Unit::TenTo(exponent.checked_sub(1)?), 5),
            Unit::OneOver(denominator) => (Unit::OneOver(denominator.checked_mul(2)?), 1),
        };
        let factor = |own: Unit| own.counted_in(common)?.checked_mul(times);
        let (of_lower, of_upper) = (factor(of_lower)?, factor(of_upper)?);
        let halves = |sign: i128| {
            let factors = [of_lower.checked_mul(sign)?, of_upper];
            // Checked products of 128 bits take ten times as long as those of 64 bits.
            if let (Column::Narrow(lower), Column::Narrow(upper)) = (lower, upper)
                && let [Ok(p), Ok(q)] = factors.map(i64::try_from)
            {
                let half = |lower: i64, upper: i64| lower.checked_mul(p)?.checked_add(upper.checked_mul(q)?);
                if let Some(halves) = of_pairs(lower.counts(), upper.counts(), half) {
                    return Some(Column::of_counts(halves.into_iter().map(i128::from), unit));
                }
            }
            let [p, q] = factors;
            let half = |lower: i128, upper: i128| lower.checked_mul(p)?.checked_add(upper.checked_mul(q)?);
            let halves = of_pairs(lower.wide()?.counts(), upper.wide()?.counts(), half)?;
            Some(Column::of_counts(halves.into_iter(), unit))
        };
        Some(Halves { middles: halves(1)?, widths: halves(-1)? })
    }
}

/// Returns one number for each pair; `None` where there is none for a pair.
fn of_pairs<N: Copy>(lower: &[N], upper: &[N], of: impl Fn(N, N) -> Option<N>) -> Option<Vec<N>> {
    lower.iter().zip(upper).map(|(&lower, &upper)| of(lower, upper)).collect()
}

impl Sums {
    /// The sums over all rows of columns. Exact. Cost: linear.
    ///
    /// # Errors
    /// When a reading has nothing that least squares could take.
    pub(crate) fn of_readings(meaning: &Meaning, columns: &[Column]) -> Result<Sums, NoLeastSquares> {
        let regressors = meaning.regressors();
        let second = (regressors == 2).then(|| &columns[1]);
        let form =
            |sums: Sums| if regressors == 1 { sums.counted_from(&meaning.form.x_origin) } else { sums };
        if meaning.has_response {
            return Ok(form(Sums::of_columns(&columns[0], second, &columns[regressors])));
        }
        if let Some(Halves { middles, .. }) = Halves::of_columns(meaning, columns) {
            return Ok(form(Sums::of_columns(&columns[0], second, &middles)));
        }
        let value = |row: usize| meaning.of_columns(columns, row, 0).value().map(Cow::into_owned);
        let values: Option<Column> = (0..columns[0].len()).map(value).collect();
        let values = values.ok_or(NoLeastSquares::NoResponse)?;
        Ok(form(Sums::of_columns(&columns[0], second, &values)))
    }
}
