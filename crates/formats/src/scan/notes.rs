//! Findings while rows are read, which count only once the rows before are known. They say which decimal mark
//! was the first one, which rows lack a number, and if rows of nothing are the end of the table.

use boundfit_exact::DecimalMark;

use crate::blocks::Gap;
use crate::error::InputError;
use crate::lacking::Lacking;
use crate::notes::Skipped;

use super::batch::ScanOptions;
use super::values::Mark;

/// The findings in some consecutive rows. Lines in its errors count from where the rows were read.
#[derive(Default)]
pub(super) struct Notes {
    /// The first decimal mark that told which one it is, and the error that its cell is if another one came before.
    pub(super) mark: Option<(DecimalMark, InputError)>,
    /// Rows that are wanted but lack a number.
    missing: Lacking,
    /// Rows of empty cells at the end.
    tail: Tail,
    /// `true` if there is a row that is not empty.
    has_rows: bool,
    /// The number of rows handed out.
    used: usize,
    /// `true` if comments were passed over between rows or after them.
    pub(super) has_comments: bool,
    /// The text before the first row, with the line of the row; `None` without rows.
    before: Option<(Gap, InputError)>,
    /// The text behind the last row, or the whole text without rows.
    after: Gap,
    /// The number of blocks that begin, where all of them are read.
    pub(super) breaks: usize,
    /// Other skipped lines, and rows that differ from the first one.
    pub(super) skipped: Skipped,
}

/// Rows of empty cells after which nothing has come yet.
#[derive(Default)]
struct Tail {
    rows: usize,
    wanted: Lacking,
}

impl Notes {
    /// Returns the findings of rows with nothing to notice except these numbers of blank lines before and
    /// behind them. The first row stands on this line.
    pub(super) fn of_rows(total: usize, used: usize, blank_lines: [u64; 2], first: InputError) -> Self {
        let [before, after] = blank_lines.map(|blank_lines| Gap { blank_lines, ..Gap::default() });
        let before = (total > 0).then_some((before, first));
        Notes { has_rows: total > 0, used, before, after, ..Notes::default() }
    }

    /// Notices what stands before a row, which is the first one unless `has_rows` says that there were others.
    ///
    /// # Errors
    /// When another block begins with the row, and blocks are told apart.
    pub(super) fn gap(
        &mut self,
        gap: Gap,
        has_rows: bool,
        takes_all: bool,
        place: impl FnOnce() -> InputError,
    ) -> Result<(), InputError> {
        self.has_comments |= gap.comments > 0;
        if !has_rows {
            self.before = Some((gap, place()));
            return Ok(());
        }
        self.skipped.comments += gap.comments;
        if gap.is_break() {
            if !takes_all {
                return Err(place());
            }
            self.breaks += 1;
        }
        Ok(())
    }

    /// Notices what stands behind the last row.
    pub(super) fn ends_with(&mut self, gap: Gap) {
        self.has_comments |= gap.comments > 0;
        self.after = gap;
    }

    /// The text behind the last row.
    pub(super) fn gap_behind(&self) -> &Gap {
        &self.after
    }

    /// The known facts about decimal marks after these rows, when this was known before them.
    pub(super) fn mark_after(&self, before: Mark) -> Mark {
        match (before, &self.mark) {
            (Mark::Open, Some((mark, _))) => Mark::Found(*mark),
            _ => before,
        }
    }

    /// The cell whose comma told that the decimal mark is one.
    pub(super) fn comma(&self) -> Option<&str> {
        let (mark, place) = self.mark.as_ref()?;
        Some(place.place.text.as_ref()?.raw()).filter(|_| *mark == DecimalMark::Comma)
    }

    /// Notices a row that is not empty: those of empty cells before it are no end.
    pub(super) fn row(&mut self) {
        self.has_rows = true;
        let Tail { wanted, .. } = std::mem::take(&mut self.tail);
        self.missing.add(wanted);
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
    pub(super) fn add(&mut self, mut next: Notes, lines: u64, takes_all: bool) -> Result<(), InputError> {
        self.add_gaps(&mut next, lines, takes_all)?;
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
        self.skipped.add(next.skipped);
        Ok(())
    }

    /// Adds what stands between rows.
    fn add_gaps(&mut self, next: &mut Notes, lines: u64, takes_all: bool) -> Result<(), InputError> {
        let after = std::mem::take(&mut next.after);
        let Some((gap, mut place)) = next.before.take() else {
            self.after.add(after);
            return Ok(());
        };
        place.after_lines(lines);
        let mut between = std::mem::replace(&mut self.after, after);
        between.add(gap);
        if self.before.is_none() {
            self.before = Some((between, place));
        } else {
            self.skipped.comments += between.comments;
            if between.is_break() && !takes_all {
                return Err(place);
            }
            self.breaks += usize::from(between.is_break());
        }
        self.breaks += next.breaks;
        Ok(())
    }

    /// Returns the number of rows and the number left out since they lack a number, when reading ended after
    /// these rows.
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
