//! The data that a proof is about, and looks at them.

use std::collections::BTreeMap;
use std::io::Read;

use boundfit_exact::Foreign;

use crate::about::About;
use crate::failure::{DataLimits, Failure};
use crate::falsehood::Falsehood;
use crate::rows::{Cells, Rows};

/// The data of a proof: their hash, and what is read of them.
#[derive(Debug, Clone)]
pub(crate) struct Data {
    pub(crate) sha256: String,
    pub(crate) about: About,
}

impl Data {
    /// Section 2: the hash of the data, and that all wanted rows can be read. The number of rows, and the names of columns.
    pub(crate) fn first_look<R: Read>(
        &self,
        data: R,
        limits: &DataLimits,
        read: impl FnOnce(&About, &mut Rows<R>) -> Result<(), Failure>,
    ) -> Result<(u64, BTreeMap<u64, Foreign>), Failure> {
        let look = self.look(data, limits, read)?;
        if look.hash != self.sha256 {
            return Err(Falsehood::OtherData.into());
        }
        look.found?;
        Ok((look.rows_total, look.names))
    }

    /// Reads all data as [`Data::first_look`] does. A falsehood about a row comes before another hash.
    pub(crate) fn look_by_rows<R: Read>(
        &self,
        data: R,
        limits: &DataLimits,
        read: impl FnOnce(&About, &mut Rows<R>) -> Result<(), Failure>,
    ) -> Result<(u64, BTreeMap<u64, Foreign>), Failure> {
        let look = self.look(data, limits, read)?;
        look.found?;
        if look.hash != self.sha256 {
            return Err(Falsehood::OtherData.into());
        }
        Ok((look.rows_total, look.names))
    }

    /// Reads all data once more.
    pub(crate) fn look_again<R: Read>(
        &self,
        data: R,
        limits: &DataLimits,
        read: impl FnOnce(&About, &mut Rows<R>) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let look = self.look(data, limits, read)?;
        if look.hash != self.sha256 {
            return Err(Failure::Changed);
        }
        look.found
    }

    /// Reads all data, the wanted rows by a function. Rows beyond the limits end it; what else is wrong is kept for after
    /// the hash.
    fn look<R: Read>(
        &self,
        data: R,
        limits: &DataLimits,
        read: impl FnOnce(&About, &mut Rows<R>) -> Result<(), Failure>,
    ) -> Result<Look, Failure> {
        let mut rows = self.about.open(data, limits)?;
        let has_header = self.about.header && rows.header()?;
        let names = if has_header { names(rows.cells()) } else { BTreeMap::new() };
        let found = match read(&self.about, &mut rows) {
            Err(failure) if failure.ends_reading() => return Err(failure),
            found => found,
        };
        let (hash, rows) = rows.finish()?;
        Ok(Look { hash, rows_total: rows.saturating_sub(u64::from(has_header)), names, found })
    }
}

/// The names of the columns, from the cells of a header.
fn names(header: Cells<'_>) -> BTreeMap<u64, Foreign> {
    let name = |column: usize| {
        let cell = header.get(column)?;
        Some((column as u64, Foreign::from(String::from_utf8_lossy(cell).trim())))
    };
    (1..).map_while(name).collect()
}

/// The result of reading all data.
struct Look {
    hash: String,
    rows_total: u64,
    names: BTreeMap<u64, Foreign>,
    /// Says whether all wanted rows could be read, and all of their half-planes were taken.
    found: Result<(), Failure>,
}
