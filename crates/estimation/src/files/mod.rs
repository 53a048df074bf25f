//! Readings from files: whole tables, tables of any size, reductions and fleets. Nothing else in this crate reads.

mod agreement;
mod columns;
mod counted;
mod counts;
mod first_look;
mod fixed;
mod fleet;
mod in_columns;
mod kept_columns;
mod looks;
mod meaning;
mod origin;
mod outline;
mod question;
mod reach;
mod reduce;
mod rounded;
mod scan;
mod seen;
mod series;
mod stated;
mod sums;
mod vertices;

use boundfit_exact::Rational;
use boundfit_formats::{ColumnSelector, InputError, ScanOptions, Source, TableOptions, TableRow, read_table};

pub use columns::{Columns, EpsilonColumn};
pub use counted::{CountedBatch, CountedRows};
pub use fleet::Fleet;
pub(crate) use in_columns::InColumns;
pub use question::Question;
pub use reduce::ReducedTable;
pub use seen::Seen;

use crate::measurement::Measurement;
use crate::measurements::{Measurements, Origin, Readings};
use crate::selection::Selection;
use crate::summary::Keep;

impl Measurements {
    /// Reads the columns of a table. A table that is a reduction gives the readings that were kept, with the facts
    /// about all readings.
    ///
    /// # Errors
    /// The first thing wrong with the file, a negative error bound included.
    pub fn read(source: Source, columns: &Columns, options: &TableOptions) -> Result<Self, InputError> {
        if source.is_reduction() {
            let options = ScanOptions { table: options.clone(), ..ScanOptions::default() };
            return Measurements::scan(source, columns, &[], &options, Keep::default());
        }
        Ok(Measurements::read_beside(source, columns, &[], options)?.0)
    }

    /// Reads as [`Measurements::read`] does for a table that is no reduction. Adds the numbers of further columns in
    /// the order of the fitted readings, a list for each column.
    ///
    /// # Errors
    /// The first thing wrong with the file, a negative error bound included.
    pub fn read_beside(
        source: Source,
        columns: &Columns,
        beside: &[ColumnSelector],
        options: &TableOptions,
    ) -> Result<(Self, Vec<Vec<Rational>>), InputError> {
        let file = source.name().to_owned();
        let own = columns.selectors();
        let selectors: Vec<ColumnSelector> = own.iter().chain(beside).cloned().collect();
        let mut table = read_table(source, &selectors, options)?;
        columns.refuse_long_in_each(&file, table.rows.len() + table.others.len(), options.sizes.work)?;
        let cells_of = |row: &mut TableRow| {
            let cells = std::mem::take(&mut row.cells);
            (!cells.is_empty()).then_some((row.row, cells))
        };
        let cells = table.rows.iter_mut().chain(&mut table.others).filter_map(cells_of).collect();
        let further = |position: usize| {
            let numbers = table.rows.iter().map(|row| row.numbers.get(own.len() + position).cloned());
            numbers.map(Option::unwrap_or_default).collect()
        };
        let further: Vec<Vec<Rational>> = (0..beside.len()).map(further).collect();
        let mut meaning = columns.meaning(&table.scanned.names);
        let measured = |rows: Vec<TableRow>| {
            rows.into_iter().map(|row| meaning.measurement(row.row, row.numbers.into_iter())).collect()
        };
        let is_bounded = |row: &Measurement| row.lower().or_else(|| row.upper()).is_some();
        let (mut rows, mut others): (Vec<Measurement>, Vec<Measurement>) =
            (measured(table.rows), measured(table.others));
        let unbounded = rows.iter().find(|row| !is_bounded(row)).map(|row| row.row);
        columns.refuse_unbounded(&file, unbounded)?;
        others.retain(is_bounded);
        meaning.settle(&mut rows);
        let own = scan::measurements(meaning, Selection::of(options), table.scanned, Readings::All(rows));
        let origin = Origin { cells, ..own.origin };
        Ok((Measurements { others, origin, ..own }, further))
    }
}
