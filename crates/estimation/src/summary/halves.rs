//! Middles and half widths of intervals in columns.

use boundfit_exact::{Column, Unit};

use crate::meaning::{ErrorBound, Meaning};

/// Middles and half widths of readings that all have both bounds.
pub(crate) struct Halves {
    pub(crate) middles: Column,
    /// Negative where the bounds cross.
    pub(crate) widths: Column,
}

impl Halves {
    /// Of readings in columns; `None` where a bound is missing, where bounds are no intervals, and where 128 bits do not hold them.
    /// Exact. Cost: linear.
    pub(crate) fn of_columns(meaning: &Meaning, columns: &[Column]) -> Option<Self> {
        let ErrorBound::Interval { lower: Some(_), upper: Some(_) } = &meaning.error_bound else {
            return None;
        };
        let [.., lower, has_lower, upper, has_upper] = columns else { return None };
        if has_lower.has_zero() || has_upper.has_zero() {
            return None;
        }
        let (lower, upper) = (lower.wide()?, upper.wide()?);
        let common = lower.unit().common(upper.unit())?;
        // Half of the common unit, and how often it goes into that.
        let (unit, times) = match common {
            Unit::Any => (Unit::TenTo(0), 1),
            Unit::TenTo(exponent) => (Unit::TenTo(exponent.checked_sub(1)?), 5),
            Unit::OneOver(denominator) => (Unit::OneOver(denominator.checked_mul(2)?), 1),
        };
        let factor = |own: Unit| own.counted_in(common)?.checked_mul(times);
        let (of_lower, of_upper) = (factor(lower.unit())?, factor(upper.unit())?);
        let halves = |sign: i128| {
            let half = |(&lower, &upper): (&i128, &i128)| {
                let lower = i128::checked_mul(lower, of_lower)?.checked_mul(sign)?;
                i128::checked_mul(upper, of_upper)?.checked_add(lower)
            };
            let halves: Option<Vec<i128>> = lower.counts().iter().zip(upper.counts()).map(half).collect();
            Some(Column::of_counts(halves?.into_iter(), unit))
        };
        Some(Halves { middles: halves(1)?, widths: halves(-1)? })
    }
}
