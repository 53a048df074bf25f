//! Readings from files: whole tables, tables of any size, reductions and fleets. Nothing else in this crate reads.

mod abscissas;
mod columns;
mod fleet;
mod reduce;
mod scan;

use boundfit_formats::{InputError, Source, TableOptions, TableRow, read_table};

pub use columns::{Columns, EpsilonColumn};
pub use fleet::Fleet;
pub use reduce::{ReducedColumns, ReducedTable};

use crate::measurements::{Measurements, Origin, Readings};

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
}
