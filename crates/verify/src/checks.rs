//! The checks, in the order of `docs/proof.md`.

use std::collections::BTreeMap;
use std::io::{self, Read};

use boundfit_exact::Foreign;

use crate::about::About;
use crate::cells::Model;
use crate::claims::{bits_of_points, check_statements, named_rows};
use crate::failure::{DataLimits, Failure};
use crate::found::SetFound;
use crate::proof::{Body, Proof};
use crate::statements::Claim;
use crate::theorem::Agreed;

/// The statement of a true proof, and the question that it answers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Statement {
    /// The rows that were read, the way of reading, and the meaning of the rows for the parameters.
    pub about: About,
    /// The number of rows of the data, rows of empty cells at the end left out.
    pub rows_total: u64,
    /// The names of the columns, where the data have a header.
    pub names: BTreeMap<u64, Foreign>,
    /// The number of half-planes of the data and the conditions.
    pub half_planes: usize,
    /// The claim.
    pub found: Found,
}

/// The statement of a true proof.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Found {
    /// The feasible parameter set.
    Set(SetFound),
    /// Claims about the sets that parts of the rows leave, in their order.
    Claims(Vec<Claim>),
    /// The number of rows of a theorem for Coq, all of which are those of the data.
    Rows(usize),
}

impl Proof {
    /// Checks every statement against the data: `open` gives them from the start. Exact. They are read once if half-planes alone
    /// prove all statements, or if the vertices of a bounded set leave a few thousand half-planes in doubt; otherwise twice. One row
    /// is in memory at a time; nothing depends on what was read before the hash is known to be right.
    ///
    /// # Errors
    /// The first statement that is false, or why the data cannot be checked.
    pub fn verify<R: Read>(
        &self,
        mut open: impl FnMut() -> io::Result<R>,
        limits: &DataLimits,
    ) -> Result<Statement, Failure> {
        let mut open = || open().map_err(Failure::Unreadable);
        let (data, about) = (&self.data, self.data.about.clone());
        match &self.body {
            Body::Whole(set) => {
                let (Agreed { rows_total, names, half_planes }, found) = set.verify(data, open, limits)?;
                Ok(Statement { about, rows_total, names, half_planes, found: Found::Set(found) })
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
                let look = data
                    .look(open()?, limits, |about, rows| about.for_each_row(rows, limits, longest, take))?;
                let (rows_total, names) = look.first()?;
                count += about.conditions_by_name().count();
                let found = Found::Claims(check_statements(data, statements, &kept, open, limits)?);
                Ok(Statement { about, rows_total, names, half_planes: count, found })
            }
            Body::Theorem(theorem) => {
                let Agreed { rows_total, names, half_planes } = theorem.check(data, open()?, limits)?;
                Ok(Statement { about, rows_total, names, half_planes, found: Found::Rows(theorem.count()) })
            }
        }
    }
}
