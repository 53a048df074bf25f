//! The checks, in the order of `docs/proof.md`.

use std::collections::BTreeMap;
use std::io::{self, Read};

use boundfit_exact::{Foreign, Rational};

use crate::cells::Model;
use crate::claims::{bits_of_points, named_rows};
use crate::failure::{DataLimits, Failure};
use crate::falsehood::Falsehood;
use crate::plane::HalfPlane;
use crate::proof::{About, Body, HalfPlanes, Proof};
use crate::rows::Rows;
use crate::statements::Claim;
use crate::whole_set::longest;

/// What a true proof states, and of which question that is the answer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Statement {
    /// Which rows were read, how, and what they say about the parameters.
    pub about: About,
    /// How many rows the data have.
    pub rows_total: u64,
    /// The names of the columns that are read, where the data have a header; nothing for one that the header does not reach.
    pub names: BTreeMap<u64, Foreign>,
    /// How many half-planes the data and the conditions give.
    pub half_planes: usize,
    /// What is so.
    pub found: Found,
}

/// What a true proof states.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Found {
    /// What the feasible parameter set is.
    Set(SetFound),
    /// Claims about the sets that parts of the rows leave, in their order.
    Claims(Vec<Claim>),
}

/// What a feasible parameter set is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SetFound {
    /// How far the set goes.
    pub extent: Extent,
    /// How many vertices it has.
    pub vertices: usize,
    /// How many sides.
    pub sides: usize,
    /// The range of each parameter, lower and upper end; an end is `None` where nothing bounds the parameter. `None` for an
    /// empty set.
    pub bounds: Option<[[Option<Rational>; 2]; 2]>,
}

/// How far a set goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Extent {
    /// There is no point in it.
    Empty,
    /// It lies within a circle.
    Bounded,
    /// It does not.
    Unbounded,
}

impl Proof {
    /// Checks every statement against the data, which are read twice unless half-planes alone prove all of them: `open` gives
    /// them from the start. Exact. One row is in memory at a time; nothing depends on what was read before the hash is known to
    /// be right.
    ///
    /// # Errors
    /// The first statement that is false, or why the data cannot be checked.
    pub fn verify<R: Read>(
        &self,
        mut open: impl FnMut() -> io::Result<R>,
        limits: &DataLimits,
    ) -> Result<Statement, Failure> {
        let mut open = || open().map_err(Failure::Unreadable);
        let about = self.about.clone();
        match &self.body {
            Body::Whole(set) => {
                let wanted = set.names();
                let (mut half_planes, mut count) = (BTreeMap::new(), 0);
                let longest = longest(&set.vertices);
                let take = |name, half_plane: &dyn Fn() -> HalfPlane| {
                    count += 1;
                    if wanted.contains(&name) {
                        half_planes.insert(name, half_plane());
                    }
                    Ok(())
                };
                let (rows_total, names) = self.first_look(open()?, limits, |about, rows| {
                    about.for_each_half_plane(rows, limits, longest, take)
                })?;
                let found = Found::Set(set.check(self, &HalfPlanes(half_planes), open, limits)?);
                Ok(Statement { about, rows_total, names, half_planes: count, found })
            }
            Body::Statements(statements) => {
                let wanted = named_rows(statements);
                let longest = bits_of_points(statements);
                let (mut kept, mut count) = (BTreeMap::new(), 0);
                let take = |row, model: &Model| {
                    count += model.sides().into_iter().filter(|is_there| *is_there).count();
                    if wanted.contains(&row) {
                        kept.insert(row, model.row());
                    }
                    Ok(())
                };
                let (rows_total, names) = self.first_look(open()?, limits, |about, rows| {
                    about.for_each_row(rows, limits, longest, take)
                })?;
                count += self.about.conditions_by_name().count();
                let found = Found::Claims(self.check_statements(statements, &kept, open, limits)?);
                Ok(Statement { about, rows_total, names, half_planes: count, found })
            }
        }
    }

    /// Section 2: the hash of the data, and that all wanted rows can be read. How many rows there are, and the names of columns.
    fn first_look<R: Read>(
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
        let has_header = self.about.header && rows.next()?;
        let names = if has_header { self.about.names(rows.cells()) } else { BTreeMap::new() };
        let found = match read(&self.about, &mut rows) {
            Err(failure) if failure.ends_reading() => return Err(failure),
            found => found,
        };
        let (hash, rows) = rows.finish()?;
        Ok(Look { hash, rows_total: rows - u64::from(has_header), names, found })
    }
}

/// What reading all data gives.
struct Look {
    hash: String,
    rows_total: u64,
    names: BTreeMap<u64, Foreign>,
    /// Whether all wanted rows could be read, and all of their half-planes were taken.
    found: Result<(), Failure>,
}
