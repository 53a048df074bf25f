//! What is noticed while rows are read, and counts only once it is known what came before: which decimal mark was the first
//! one, which rows lack a number, and whether rows of nothing are the end of the table.

use boundfit_exact::DecimalMark;

use crate::error::InputError;
use crate::lacking::Lacking;

use super::batch::ScanOptions;
use super::values::Mark;

/// What was noticed in some consecutive rows. Lines in its errors count from where the rows were read.
#[derive(Default)]
pub(super) struct Notes {
    /// The first decimal mark that told which one it is, and the error that its cell is if another one came before.
    pub(super) mark: Option<(DecimalMark, InputError)>,
    /// Rows that are wanted but lack a number.
    missing: Lacking,
    /// Rows of empty cells at the end.
    tail: Tail,
    /// Whether there is a row that is not empty.
    has_rows: bool,
    /// How many rows were handed out.
    used: usize,
    /// Whether comments were passed over between rows or after them.
    pub(super) has_comments: bool,
}

/// Rows of empty cells after which nothing has come yet.
#[derive(Default)]
struct Tail {
    rows: usize,
    wanted: Lacking,
}

impl Notes {
    /// Those of so many rows without anything to notice.
    pub(super) fn of_rows(total: usize, used: usize) -> Self {
        Notes { has_rows: total > 0, used, ..Notes::default() }
    }

    /// What is known of decimal marks after these rows, when this was known before them.
    pub(super) fn mark_after(&self, before: Mark) -> Mark {
        match (before, &self.mark) {
            (Mark::Open, Some((mark, _))) => Mark::Found(*mark),
            _ => before,
        }
    }

    /// Notices a row that is not empty: those of empty cells before it are no end.
    pub(super) fn row(&mut self) {
        self.has_rows = true;
        let Tail { wanted, .. } = std::mem::take(&mut self.tail);
        self.missing.add(wanted);
    }

    /// Notices a comment.
    pub(super) fn comment(&mut self) {
        self.has_comments = true;
    }

    /// Notices that a row is handed out.
    pub(super) fn used(&mut self) {
        self.used += 1;
    }

    /// Notices that a wanted row lacks a number: the first such place.
    pub(super) fn lacks(&mut self, place: InputError) {
        self.missing.notice(|| place);
    }

    /// Notices a row of empty cells; with the place of the first one that is wanted there.
    pub(super) fn empty_row(&mut self, wanted: Option<InputError>) {
        self.tail.rows += 1;
        self.tail.wanted.add(Lacking { rows: usize::from(wanted.is_some()), first: wanted });
    }

    /// Adds what was noticed in the rows that follow, whose lines start after so many.
    ///
    /// # Errors
    /// When these rows have another decimal mark than those before.
    pub(super) fn add(&mut self, mut next: Notes, lines: u64) -> Result<(), InputError> {
        let places = [&mut next.missing.first, &mut next.tail.wanted.first].into_iter().flatten();
        for place in places.chain(next.mark.as_mut().map(|(_, place)| place)) {
            place.after_lines(lines);
        }
        if next.has_rows {
            self.row();
        }
        let before = self.mark.as_ref().map(|(mark, _)| *mark);
        if let Some((mark, place)) = next.mark {
            if before.is_some_and(|before| before != mark) {
                return Err(place);
            }
            self.mark.get_or_insert((mark, place));
        }
        self.missing.add(next.missing);
        self.tail.rows += next.tail.rows;
        self.tail.wanted.add(next.tail.wanted);
        self.used += next.used;
        self.has_comments |= next.has_comments;
        Ok(())
    }

    /// How many rows there were, and how many of them were left out since they lack a number, when reading them came to an
    /// end with so many rows.
    ///
    /// # Errors
    /// That of reading, unless the first missing number came before it and is not allowed.
    pub(super) fn settle(
        self,
        read: Result<usize, InputError>,
        options: &ScanOptions,
    ) -> Result<(usize, usize), InputError> {
        let (rows, missing) = self.missing.settle(read, self.used, options)?;
        Ok((rows - self.tail.rows, missing))
    }
}
