//! Readings from files.

mod columns;

use boundfit_formats::{Batch, InputError, Scanned, Source, TableOptions, TableRow, read_table};

pub use columns::{Columns, EpsilonColumn};

use crate::measurements::{Meaning, Measurement, Measurements, Origin, Readings};

impl Measurements {
    /// Reads the columns of a table.
    ///
    /// # Errors
    /// The first thing wrong with the file, a negative error bound included.
    pub fn read(source: Source, columns: &Columns, options: &TableOptions) -> Result<Self, InputError> {
        let table = read_table(source, &columns.selectors(), options)?;
        let meaning = columns.meaning(&table.names);
        let measured = |rows: Vec<TableRow>| {
            rows.into_iter().map(|row| meaning.measurement(row.row, row.numbers.into_iter())).collect()
        };
        let (rows, others) = (measured(table.rows), measured(table.others));
        let (rows_total, layout, sha256) = (table.rows_total, table.layout, Some(table.sha256));
        let origin = Origin { rows_total, layout, sha256 };
        Ok(Measurements { meaning, readings: Readings::All(rows), others, origin })
    }

    /// Readings of a table that was read in batches.
    pub(crate) fn scanned(columns: &Columns, scanned: Scanned, readings: Readings) -> Self {
        let meaning = columns.meaning(&scanned.names);
        let Scanned { rows_total, layout, sha256, .. } = scanned;
        let origin = Origin { rows_total, layout, sha256 };
        Measurements { meaning, readings, others: Vec::new(), origin }
    }
}

/// All readings of batches.
pub(crate) fn rows_of(batches: &[Batch], meaning: &Meaning) -> Vec<Measurement> {
    let row = |batch: &Batch, k: usize| {
        meaning.measurement(batch.first_row + k, batch.columns.iter().map(|column| column.get(k)))
    };
    batches.iter().flat_map(|batch| (0..batch.rows).map(move |k| row(batch, k))).collect()
}
