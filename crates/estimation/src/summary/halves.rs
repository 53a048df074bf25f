//! Middles and half widths of intervals in columns, on machine integers.

use boundfit_exact::{Column, Scaled, Unit};

use crate::meaning::{ErrorBound, Meaning};

/// Middles and half widths of readings that all have both bounds, as so many units each.
pub(crate) struct Halves {
    pub(crate) middles: Scaled<i64>,
    /// Negative where the bounds cross.
    pub(crate) widths: Scaled<i64>,
}

impl Halves {
    /// Of readings in columns; `None` where a bound is missing, where bounds are no intervals, and where the numbers do not fit.
    /// Exact. Cost: linear.
    pub(crate) fn of_columns(meaning: &Meaning, columns: &[Column]) -> Option<Self> {
        let ErrorBound::Interval { lower: Some(_), upper: Some(_) } = &meaning.error_bound else {
            return None;
        };
        let [.., Column::Narrow(lower), has_lower, Column::Narrow(upper), has_upper] = columns else {
            return None;
        };
        let is_there = |presence: &Column| match presence {
            Column::Narrow(presence) => presence.counts().iter().all(|&count| count != 0),
            Column::Doubles(presence) => presence.iter().all(|&double| double != 0.0),
            _ => false,
        };
        if !is_there(has_lower) || !is_there(has_upper) {
            return None;
        }
        let common = lower.unit().common(upper.unit())?;
        // Half of the common unit, and how often it goes into that.
        let (unit, times) = match common {
            Unit::Any => (Unit::TenTo(0), 1),
            Unit::TenTo(exponent) => (Unit::TenTo(exponent.checked_sub(1)?), 5),
            Unit::OneOver(denominator) => (Unit::OneOver(denominator.checked_mul(2)?), 1),
        };
        let factor =
            |own: &Scaled<i64>| i64::try_from(own.unit().counted_in(common)?.checked_mul(times)?).ok();
        let (of_lower, of_upper) = (factor(lower)?, factor(upper)?);
        let pairs = || lower.counts().iter().zip(upper.counts());
        let halves = |sign: i128| {
            // Products of two words, of which no two overflow together.
            let half = move |(&lower, &upper): (&i64, &i64)| {
                i128::from(upper) * i128::from(of_upper) + sign * i128::from(lower) * i128::from(of_lower)
            };
            Scaled::new(pairs().map(half), unit)
        };
        Some(Halves { middles: halves(1)?, widths: halves(-1)? })
    }
}
