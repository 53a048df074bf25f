//! Middles and half widths of intervals in columns.

use boundfit_exact::{Column, Unit};

#[cfg(feature = "files")]
use crate::meaning::{ErrorBound, Meaning};
use crate::moments::{bits, widest};

/// Readings in columns that all have both bounds.
pub(crate) struct Halves<'a> {
    lower: &'a Column,
    upper: &'a Column,
    /// Half of a common unit, and how often it goes into the unit of each column.
    unit: Unit,
    factors: [i128; 2],
}

impl<'a> Halves<'a> {
    /// Takes the bounds from columns; `None` where a bound is missing, where bounds are no intervals, and where no integers
    /// of 128 bits hold them. Exact. Cost: a look at which bounds are there.
    #[cfg(feature = "files")]
    pub(crate) fn of_columns(meaning: &Meaning, columns: &'a [Column]) -> Option<Self> {
        let ErrorBound::Interval { lower: Some(_), upper: Some(_) } = &meaning.error_bound else {
            return None;
        };
        let [.., lower, has_lower, upper, has_upper] = columns else { return None };
        if has_lower.has_zero() || has_upper.has_zero() {
            return None;
        }
        Halves::between(lower, upper)
    }

    /// Takes the bounds; `None` where no integers of 128 bits hold them. Exact. Cost: constant.
    pub(crate) fn between(lower: &'a Column, upper: &'a Column) -> Option<Self> {
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
        Some(Halves { lower, upper, unit, factors: [factor(of_lower)?, factor(of_upper)?] })
    }

    /// The middles; `None` where 128 bits do not hold them. Exact. Cost: linear.
    pub(crate) fn middles(&self) -> Option<Column> {
        self.halves(1)
    }

    /// The half widths, negative where the bounds cross; `None` where 128 bits do not hold them. Exact. Cost: linear.
    pub(crate) fn widths(&self) -> Option<Column> {
        self.halves(-1)
    }

    fn halves(&self, sign: i128) -> Option<Column> {
        let [p, q] = [self.factors[0].checked_mul(sign)?, self.factors[1]];
        if let (Column::Narrow(lower), Column::Narrow(upper)) = (self.lower, self.upper) {
            let is_short =
                |counts: &[i64], factor: i128| widest(counts) + bits(factor.unsigned_abs()) < i64::BITS - 2;
            // By these bits neither a product nor the sum of both can overflow.
            if is_short(lower.counts(), p) && is_short(upper.counts(), q) {
                let (p, q) = (p as i64, q as i64);
                let half = |(&lower, &upper): (&i64, &i64)| {
                    lower.wrapping_mul(p).wrapping_add(upper.wrapping_mul(q))
                };
                return Column::of_short_counts(
                    lower.counts().iter().zip(upper.counts()).map(half).collect(),
                    self.unit,
                );
            }
        }
        let half = |lower: i128, upper: i128| lower.checked_mul(p)?.checked_add(upper.checked_mul(q)?);
        let (lower, upper) = (self.lower.wide()?, self.upper.wide()?);
        let halves = lower.counts().iter().zip(upper.counts()).map(|(&lower, &upper)| half(lower, upper));
        let halves: Vec<i128> = halves.collect::<Option<_>>()?;
        Some(Column::of_counts(halves.into_iter(), self.unit))
    }
}
