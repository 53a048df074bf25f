//! The meaning of the columns of a table.

use boundfit_exact::Column;

use crate::deciding::DecidingRows;
use crate::law::range_of_y;
use crate::meaning::{ErrorBound, Meaning};
use crate::measurement::Measurement;

impl<C> ErrorBound<C> {
    /// The same bound with other words for its columns, the lower one first.
    pub(crate) fn with_columns<D>(&self, mut column: impl FnMut(&C) -> D) -> ErrorBound<D> {
        match self {
            ErrorBound::Uniform(epsilon) => ErrorBound::Uniform(epsilon.clone()),
            ErrorBound::Column(own) => ErrorBound::Column(column(own)),
            ErrorBound::Interval { lower, upper } => {
                let lower = lower.as_ref().map(&mut column);
                ErrorBound::Interval { lower, upper: upper.as_ref().map(column) }
            }
            ErrorBound::Law(law) => ErrorBound::Law(law.clone()),
        }
    }
}

impl Meaning {
    /// Returns whether every reading is given by y and an ε that is a number or a column.
    pub(crate) fn is_around_y(&self) -> bool {
        match self.error_bound {
            ErrorBound::Uniform(_) | ErrorBound::Column(_) => true,
            ErrorBound::Interval { .. } | ErrorBound::Law(_) => false,
        }
    }

    /// Returns whether a summary of a line serves every error bound, since all have the same one.
    pub(crate) fn is_open(&self) -> bool {
        self.regressors() == 1 && self.error_bound.is_uniform()
    }

    /// Returns whether the bounds of each reading are known before all readings are.
    pub(crate) fn are_bounds_known(&self) -> bool {
        let law = match &self.error_bound {
            ErrorBound::Law(law) => Some(law),
            _ => self.uniform_law.as_ref(),
        };
        law.is_none_or(|law| !law.needs_range())
    }

    /// The reading in a row of columns, counted from 0, with this number in the file.
    pub(crate) fn of_columns(&self, columns: &[Column], position: usize, row: usize) -> Measurement {
        self.measurement(row, columns.iter().map(|column| column.get(position)))
    }

    /// Returns whether a reading in columns has two bounds, whose distance a factor may multiply.
    pub(crate) fn have_widths(&self, columns: &[Column]) -> bool {
        let count = columns.first().map_or(0, Column::len);
        match &self.error_bound {
            ErrorBound::Interval { lower: Some(_), upper: Some(_) } => {
                let [.., lower, _, upper] = columns else { return false };
                (0..count).any(|row| !lower.get(row).is_zero() && !upper.get(row).is_zero())
            }
            ErrorBound::Interval { .. } => false,
            _ => count > 0,
        }
    }

    /// Counts the x of the deciding readings of a line from its origin and [settles](Meaning::settle) their bounds. A reading with the
    /// largest or the smallest y of all is on a hull, and so among them.
    pub(crate) fn settled(&mut self, rows: DecidingRows) -> DecidingRows {
        if self.form.x_origin.is_zero() && self.uniform_law.is_none() {
            return rows;
        }
        let mut rows = rows.into_numbers();
        self.form.count_rows(&mut rows);
        self.settle(&mut rows);
        rows.into()
    }

    /// Adds to the bounds of readings what a law takes from all of them, when they are known: all, or of a uniform law those
    /// that support a hull.
    pub(crate) fn settle(&mut self, rows: &mut Vec<Measurement>) {
        if let ErrorBound::Law(law) = &self.error_bound {
            let range = range_of_y(rows);
            law.widen(rows, &range);
        }
        if let Some(law) = &self.uniform_law {
            let epsilon = law.uniform_bound(&range_of_y(rows));
            *rows = std::mem::take(rows).into_iter().map(|row| row.within(epsilon.clone())).collect();
            self.error_bound = ErrorBound::Uniform(epsilon);
        }
    }
}
