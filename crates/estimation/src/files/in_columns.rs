//! Readings that wait in their columns.

use std::sync::Arc;

use boundfit_formats::{Batch, TableRow};

use crate::meaning::Meaning;
use crate::measurement::Measurement;

/// All readings of a table, in its columns.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct InColumns(Arc<[Batch]>);

/// No number of a column is unlike itself.
impl Eq for InColumns {}

impl InColumns {
    /// Takes all batches; `None` where none were kept.
    pub(super) fn new(batches: Vec<Batch>) -> Option<Self> {
        (!batches.is_empty()).then(|| InColumns(batches.into()))
    }

    /// The readings. Exact. Cost: linear.
    pub(crate) fn readings(&self, meaning: &Meaning) -> Vec<Measurement> {
        readings_of(&self.0, meaning)
    }
}

/// The readings in some batches. Exact. Cost: linear.
pub(super) fn readings_of(batches: &[Batch], meaning: &Meaning) -> Vec<Measurement> {
    let reading = |row: TableRow| meaning.measurement(row.row, row.numbers.into_iter());
    batches.iter().flat_map(Batch::table_rows).map(reading).collect()
}
