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
    /// Reads all data, the wanted rows by a function. Rows beyond the limits end it; what else is wrong is kept for after
    /// the hash.
    pub(crate) fn look<R: Read>(
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
        let is_same = hash == self.sha256;
        Ok(Look { is_same, rows_total: rows.saturating_sub(u64::from(has_header)), names, found })
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
pub(crate) struct Look {
    /// Says whether the data have the hash of the proof.
    is_same: bool,
    rows_total: u64,
    names: BTreeMap<u64, Foreign>,
    /// Says whether all wanted rows could be read, and all of their half-planes were taken.
    found: Result<(), Failure>,
}

impl Look {
    /// Checks section 2: the hash of the data, and that all wanted rows can be read. Returns the number of rows and the names of columns.
    pub(crate) fn first(self) -> Result<(u64, BTreeMap<u64, Foreign>), Failure> {
        if !self.is_same {
            return Err(Falsehood::OtherData.into());
        }
        self.by_rows()
    }

    /// Checks what [`Look::first`] does, but a falsehood about a row comes before another hash.
    pub(crate) fn by_rows(self) -> Result<(u64, BTreeMap<u64, Foreign>), Failure> {
        self.found?;
        match self.is_same {
            true => Ok((self.rows_total, self.names)),
            false => Err(Falsehood::OtherData.into()),
        }
    }

    /// Checks that data which were read before are the same once more, and that their rows were taken.
    pub(crate) fn again(self) -> Result<(), Failure> {
        match self.is_same {
            true => self.found,
            false => Err(Failure::Changed),
        }
    }
}
