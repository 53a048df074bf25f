//! Rows that are wanted but lack a number.

use crate::dialect::Missing;
use crate::error::{InputError, InputErrorKind};
use crate::scan::ScanOptions;

/// Rows that lack a number: how many, and the place of the first one.
#[derive(Debug, Default)]
pub(crate) struct Lacking {
    pub(crate) rows: usize,
    pub(crate) first: Option<InputError>,
}

impl Lacking {
    /// Adds those of later rows.
    pub(crate) fn add(&mut self, later: Lacking) {
        self.rows += later.rows;
        self.first = self.first.take().or(later.first);
    }

    /// Adds a row that lacks a number at this place.
    pub(crate) fn notice(&mut self, place: impl FnOnce() -> InputError) {
        self.rows += 1;
        self.first.get_or_insert_with(place);
    }

    /// The result of reading: how many rows are used, and how many were skipped.
    ///
    /// # Errors
    /// That of reading, unless a number was missing before that must not be.
    pub(crate) fn settle<T>(
        self,
        read: Result<T, InputError>,
        used: usize,
        options: &ScanOptions,
    ) -> Result<(T, usize), InputError> {
        let Lacking { rows, first } = self;
        let is_complete = read.is_ok();
        match first {
            Some(place) if options.table.missing == Missing::Refuse && !was_stopped(&read) => {
                Err(InputError { kind: InputErrorKind::Missing { rows, is_complete }, ..place })
            }
            Some(place) if is_complete && used == 0 && !options.allow_nothing => {
                Err(InputError { kind: InputErrorKind::AllMissing { rows }, ..place })
            }
            _ => Ok((read?, rows)),
        }
    }
}

/// Returns whether somebody stopped the reading.
fn was_stopped<T>(read: &Result<T, InputError>) -> bool {
    matches!(read, Err(InputError { kind: InputErrorKind::Interrupted, .. }))
}
