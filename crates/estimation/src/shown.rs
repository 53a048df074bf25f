//! The readings that can be shown: those in memory, or all, where the others wait in their columns.

use std::borrow::Cow;

use boundfit_exact::Rational;

#[cfg(feature = "files")]
use crate::files::InColumns;
use crate::measurement::{Bounds, Measurement};
use crate::measurements::Measurements;
#[cfg(feature = "files")]
use crate::measurements::{Origin, Readings};

impl Measurements {
    /// These readings with every one in memory, where now only those that decide are and the others wait in their columns
    /// ([`Keep::most_plain`](crate::Keep::most_plain)). Exact. Cost: linear.
    pub fn whole(&self) -> Option<Measurements> {
        #[cfg(feature = "files")]
        if let Some(columns) = &self.origin.in_columns {
            let readings = Readings::All(columns.readings(&self.meaning));
            let origin = Origin { in_columns: None, ..self.origin.clone() };
            return Some(Measurements {
                meaning: self.meaning.clone(),
                readings,
                others: Vec::new(),
                origin,
            });
        }
        None
    }

    /// The columns in which readings wait, others than those in memory.
    #[cfg(feature = "files")]
    fn waiting(&self) -> Option<&InColumns> {
        self.origin.in_columns.as_ref().filter(|_| matches!(self.readings, Readings::Supporting { .. }))
    }

    /// The number of readings that can be shown: all that are fitted, where others than those in memory wait in their columns, else
    /// those in memory.
    pub fn shown(&self) -> usize {
        #[cfg(feature = "files")]
        if self.waiting().is_some() {
            return self.fitted();
        }
        self.kept_count()
    }

    /// The readings that can be shown one after the other, ascending by row. Exact. Cost: linear; memory for one.
    pub fn each_shown(&self) -> Box<dyn Iterator<Item = Cow<'_, Measurement>> + '_> {
        #[cfg(feature = "files")]
        if let Some(columns) = self.waiting() {
            return Box::new(columns.each(&self.meaning).map(Cow::Owned));
        }
        Box::new(self.kept().iter().map(Cow::Borrowed))
    }

    /// A reading that can be shown, by its position; positions ascend with rows. Exact.
    pub fn shown_at(&self, position: usize) -> Option<Cow<'_, Measurement>> {
        #[cfg(feature = "files")]
        if let Some(columns) = self.waiting() {
            return columns.reading(position, &self.meaning).map(Cow::Owned);
        }
        self.kept().get(position).map(Cow::Borrowed)
    }

    /// The position of a row among the readings that can be shown.
    pub fn position_of(&self, row: usize) -> Option<usize> {
        #[cfg(feature = "files")]
        if let Some(columns) = self.waiting() {
            return columns.position_of(row);
        }
        self.kept().binary_search_by_key(&row, |reading| reading.row).ok()
    }

    /// x, y and ε of each reading of a line that can be shown, by [`Rational::near_f64`]. Returns `None` of other models, and
    /// of bounds that do not lie around y. Cost: linear.
    pub fn near_f64(&self) -> Option<Vec<[f64; 3]>> {
        if self.meaning.regressors() != 1 {
            return None;
        }
        #[cfg(feature = "files")]
        if let Some((columns, epsilon)) = self.waiting().zip(self.meaning.error_bound.uniform()) {
            let epsilon = epsilon.near_f64();
            let readings = columns.near_f64(&self.meaning).into_iter();
            return Some(readings.map(|[x, y]| [x, y, epsilon]).collect());
        }
        let near = |reading: Cow<'_, Measurement>| match &reading.bounds {
            Bounds::Around { response, epsilon } => {
                Some([&reading.regressor[0], response, epsilon].map(Rational::near_f64))
            }
            Bounds::Between { .. } => None,
        };
        self.each_shown().map(near).collect()
    }
}
