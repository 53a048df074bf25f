//! Rows in the fast lane, cell by cell.

use std::ops::Range;

use boundfit_exact::{
    DecimalMark, LONG_DIGITS, NarrowCount, NarrowUnit, Others, PlainPrefix, Reading, exponent_prefix,
    long_prefix, nearest_double, short_prefix,
};
use memchr::{memchr, memchr_iter, memchr3, memrchr};

use super::batch::Batch;
use super::layout::Layout;
use super::mantissa::{Mantissa, Plain};
use super::route::{Route, Step, What, first_end};
use super::rows;
use super::values::Mark;
use crate::columns::{ColumnSelector, Role};
use crate::error::InputError;

/// A plain chunk on the way into a batch. Positions are offsets in the chunk.
pub(super) struct Lane<'a> {
    pub(super) chunk: &'a [u8],
    /// The chunk with decimal points.
    numbers: &'a [u8],
    layout: &'a Layout<'a>,
    route: &'a Route,
    /// `true` if numbers are read as they are written, not as doubles.
    pub(super) is_decimal: bool,
    /// `true` if there are quotes.
    pub(super) is_quoted: bool,
    /// `true` if the row looked at satisfies the conditions so far.
    is_satisfied: bool,
    /// `true` if it has a number in one of the columns that may lack one, if there are such columns.
    is_bounded: bool,
    pub(super) batch: Batch,
    /// The bytes of `numbers` that are no digits.
    pub(super) others: Others,
}

impl<'a> Lane<'a> {
    /// Starts at the beginning of a chunk, whose numbers have points.
    pub(super) fn new(chunk: &'a [u8], numbers: &'a [u8], layout: &'a Layout<'a>, route: &'a Route) -> Self {
        let is_decimal = layout.options.table.reading == Reading::Decimal;
        Lane {
            chunk,
            numbers,
            layout,
            route,
            is_decimal,
            is_quoted: memchr(b'"', chunk).is_some(),
            is_satisfied: true,
            is_bounded: true,
            batch: layout.batch(),
            others: Others::default(),
        }
    }
}

impl Lane<'_> {
    /// Adds the cells wanted of the row that starts here; gives the start of the next line, or `None` when the row is
    /// not as it should be.
    #[inline]
    pub(super) fn row(&mut self, start: usize) -> Option<usize> {
        self.is_bounded = !self.route.wants_presence;
        let at = self.walk(start, &self.route.steps)?;
        if !self.is_bounded {
            return None;
        }
        self.end_of_row(at, self.route.behind)
    }

    /// Returns whether the row that starts here satisfies all conditions; `None` when a cell is not as it should be.
    #[inline]
    pub(super) fn satisfies_conditions(&mut self, start: usize) -> Option<bool> {
        if self.route.conditions.is_empty() {
            return Some(true);
        }
        self.is_satisfied = true;
        self.walk(start, &self.route.conditions)?;
        Some(self.is_satisfied)
    }

    /// Goes to cells of the row that starts here and treats each as it is wanted. It returns the end of the
    /// last one, or `None` when one is not as it should be.
    #[inline]
    fn walk(&mut self, start: usize, steps: &[Step]) -> Option<usize> {
        let mut cell = start;
        let mut at = start;
        for step in steps {
            match step.separators {
                Some(separators) => {
                    for _ in 0..separators {
                        at = self.after_separator(at)?;
                    }
                    cell = at;
                }
                None => at = cell,
            }
            at = match step.what {
                What::Number { column, non_negative } => self.number(at, column, non_negative)?,
                What::Presence { column } => self.presence(at, column)?,
                What::Aside { column } => self.long_number(at, column)?,
                What::Key => self.key(at)?,
                What::Condition(index) => self.condition(at, index)?,
            };
        }
        Some(at)
    }

    /// Looks whether the cell that starts here satisfies a condition; gives the end of the cell.
    fn condition(&mut self, at: usize, index: usize) -> Option<usize> {
        let (contents, end) = self.cell(at)?;
        let (_, condition) = self.layout.conditions.get(index)?;
        self.has_one_meaning(&contents)?;
        let (holds, _) = self.layout.holds(condition, self.chunk.get(contents)?, self.layout.mark).ok()?;
        self.is_satisfied &= holds;
        Some(end)
    }

    /// Adds the number in the cell that starts here to a column; gives the end of the cell.
    #[inline]
    fn number(&mut self, at: usize, column: usize, non_negative: bool) -> Option<usize> {
        if let Some(Plain { mantissa, exponent, end }) = self.plain_number(at)
            && !(non_negative && mantissa < 0)
        {
            let builder = self.batch.columns.get_mut(column)?;
            if self.is_decimal {
                builder.push_decimal(mantissa, exponent);
                return Some(end);
            }
            if let Some(double) = nearest_double(mantissa, exponent) {
                builder.push_double(double);
                return Some(end);
            }
        } else if self.is_decimal {
            let quotes = self.opening_quotes(at);
            if let Some(prefix) = long_prefix(self.numbers.get(at + quotes..)?)
                && let Some(end) = self.end_behind(at + quotes + prefix.length, quotes)
                && !(non_negative && prefix.mantissa < 0)
            {
                self.batch.columns.get_mut(column)?.push_long_decimal(prefix.mantissa, prefix.exponent);
                return Some(end);
            }
        }
        self.long_number(at, column)
    }

    /// Adds to a column whether the cell that starts here has a number; gives the end of the cell.
    #[inline]
    fn presence(&mut self, at: usize, column: usize) -> Option<usize> {
        if self.is_decimal
            && let Some(Plain { end, .. }) = self.plain_number::<i64>(at)
        {
            self.batch.columns.get_mut(column)?.push_decimal(1, 0);
            self.is_bounded = true;
            return Some(end);
        }
        self.long_number(at, column)
    }

    /// Returns the number in the cell that starts here, in units, and the end of the cell. `None` where it takes more to read it,
    /// such as quotes, or there is none.
    #[inline(always)]
    pub(super) fn short_count(
        &self,
        at: usize,
        unit: &NarrowUnit,
        others: &mut Others,
    ) -> Option<(NarrowCount, usize)> {
        let text = self.numbers.get(at..)?.first_chunk()?;
        let short = short_prefix(text, others.behind(self.numbers, at))?;
        let end = at + short.length;
        self.is_end_of_cell(end).then_some((unit.count_short(short)?, end))
    }

    /// [`Self::short_count`] of other numbers, too; slower.
    #[inline(never)]
    pub(super) fn count(&self, at: usize, unit: &NarrowUnit) -> Option<(NarrowCount, usize)> {
        let Plain { mantissa, exponent, end } = self.plain_number(at)?;
        Some((unit.count(mantissa, exponent)?, end))
    }

    /// The number in the cell that starts here; `None` where it takes more to read it, or there is none.
    #[inline(always)]
    pub(super) fn plain_number<M: Mantissa>(&self, at: usize) -> Option<Plain<M>> {
        let quotes = self.opening_quotes(at);
        let PlainPrefix { mantissa, fraction_digits, length } = M::prefix(self.numbers.get(at + quotes..)?)?;
        let end = at + quotes + length;
        if quotes == 0 && self.is_end_of_cell(end) {
            return Some(Plain { mantissa, exponent: -fraction_digits, end });
        }
        let (power, end) = self.end_of_number(end, quotes)?;
        let exponent = if mantissa == M::default() { 0 } else { power - fraction_digits };
        Some(Plain { mantissa, exponent, end })
    }

    /// Returns the exponent behind the digits of a number (0 if there is none) and the end of the cell, which
    /// has this many quotes around it. It returns `None` where the cell goes on.
    fn end_of_number(&self, at: usize, quotes: usize) -> Option<(i32, usize)> {
        let (power, length) = exponent_prefix(self.numbers.get(at..)?).unwrap_or_default();
        Some((power, self.end_behind(at + length, quotes)?))
    }

    /// Returns the number of quotes that the cell here starts with: one or none.
    #[inline(always)]
    fn opening_quotes(&self, at: usize) -> usize {
        usize::from(self.is_quoted && self.chunk.get(at) == Some(&b'"'))
    }

    /// The end of the cell whose contents end here, with so many quotes around them; `None` where it goes on.
    #[inline]
    fn end_behind(&self, at: usize, quotes: usize) -> Option<usize> {
        if quotes == 1 && self.chunk.get(at) != Some(&b'"') {
            return None;
        }
        self.is_end_of_cell(at + quotes).then_some(at + quotes)
    }

    /// Adds any other number in the cell that starts here to a column; gives the end of the cell.
    #[inline(never)]
    fn long_number(&mut self, at: usize, column: usize) -> Option<usize> {
        let (contents, end) = self.cell(at)?;
        let selector = self.layout.selectors.get(column)?;
        if self.takes_long(selector, contents.len())
            && self.batch.columns.get_mut(column)?.push_text(self.numbers.get(contents.clone())?)
        {
            return Some(end);
        }
        self.has_one_meaning(&contents)?;
        let (layout, cell) = (self.layout, self.chunk.get(contents)?);
        let (value, _) = layout.numbers.value(cell, selector, layout.mark).ok()?;
        value.check(selector).ok()?;
        // A number that is too long is refused with its place by the rules of CSV in full.
        layout.meter(&value, cell).ok()?;
        self.is_bounded |= value.is_presence();
        value.push_to(self.batch.columns.get_mut(column)?);
        self.batch.fractions.get_mut(column)?.count(cell);
        Some(end)
    }

    /// Nothing where a cell may tell the decimal mark by a comma, or not be a number until it is told: that takes the rules in full.
    fn has_one_meaning(&self, contents: &Range<usize>) -> Option<()> {
        let has_comma = || self.chunk.get(contents.clone()).is_some_and(|cell| memchr(b',', cell).is_some());
        (self.layout.mark != Mark::Open || !has_comma()).then_some(())
    }

    /// The decimal mark that the first of these lines tells which tells one. They are rows that are wanted, behind so many lines
    /// and rows.
    pub(super) fn first_point(
        &self,
        range: Range<usize>,
        lines: u64,
        rows_before: usize,
    ) -> Option<(DecimalMark, InputError)> {
        let mut start = range.start;
        for index in 0.. {
            if start >= range.end {
                return None;
            }
            let end = self.next_line(start);
            let told = self.told(start..end, true, lines + index as u64 + 1, rows_before + index);
            if told.is_some() {
                return told;
            }
            start = end;
        }
        None
    }

    /// The decimal mark that a line tells, which is a row behind so many: by the conditions on rows, and by what is read of rows that
    /// satisfy them.
    pub(super) fn told(
        &self,
        line: Range<usize>,
        is_satisfied: bool,
        number: u64,
        rows_before: usize,
    ) -> Option<(DecimalMark, InputError)> {
        let text = self.chunk.get(line.clone())?;
        let before = text.get(..memrchr(b'.', text)?)?;
        let steps: &[Step] = if is_satisfied { &self.route.steps } else { &[] };
        // Times in front of what is read may have points in every line.
        let first = |steps: &[Step]| steps.first().and_then(|step| step.separators).unwrap_or_default();
        let [first_condition, first_cell] = [&self.route.conditions, steps].map(first);
        let least =
            if self.route.conditions.is_empty() { first_cell } else { first_condition.min(first_cell) };
        if memchr_iter(self.layout.syntax.delimiter, before).count() < least {
            return None;
        }
        let is_telling = self.has_point(line.start, &self.route.conditions).unwrap_or(true)
            || self.has_point(line.start, steps).unwrap_or(true);
        if is_telling { rows::told(text, self.layout, number, rows_before) } else { None }
    }

    /// Returns whether one of these cells of the row that starts here has a point, and is not missing; `None` when one is not as it should
    /// be.
    fn has_point(&self, start: usize, steps: &[Step]) -> Option<bool> {
        let mut at = start;
        for step in steps {
            for _ in 0..step.separators.unwrap_or_default() {
                at = self.after_separator(at)?;
            }
            let (contents, _) = self.cell(at)?;
            let cell = self.chunk.get(contents)?;
            let is_read = !matches!(step.what, What::Key);
            if is_read && memchr(b'.', cell).is_some() && !self.layout.numbers.is_missing(cell) {
                return Some(true);
            }
        }
        Some(false)
    }

    /// Returns whether the number of a cell of this length goes into a column as it is, however many digits it has.
    fn takes_long(&self, selector: &ColumnSelector, length: usize) -> bool {
        let limits = &self.layout.options.table.limits;
        self.is_decimal
            && selector.role() == Role::Number
            && (LONG_DIGITS + 1..=limits.digits).contains(&length)
    }

    /// Adds the text of the cell that starts here to the keys; gives the end of the cell.
    fn key(&mut self, at: usize) -> Option<usize> {
        let (contents, end) = self.cell(at)?;
        let is_quoted = contents.start > at;
        Layout::add_key(self.chunk.get(contents)?, is_quoted, self.batch.keys.as_mut()?).ok()?;
        Some(end)
    }

    /// Returns whether a cell ends here.
    #[inline]
    fn is_end_of_cell(&self, at: usize) -> bool {
        self.chunk
            .get(at)
            .is_none_or(|&byte| byte == self.layout.syntax.delimiter || byte == b'\n' || byte == b'\r')
    }

    /// The end of the cell that starts here, if its text is that of another cell and a further cell comes behind it.
    #[inline]
    pub(super) fn end_of_same(&self, at: usize, other: &Range<usize>) -> Option<usize> {
        let text = self.chunk.get(other.clone())?;
        let behind = self.chunk.get(at..)?.strip_prefix(text)?;
        (behind.first() == Some(&self.layout.syntax.delimiter)).then_some(at + text.len())
    }

    /// The contents of the cell that starts here, and its end; `None` when it has quotes that are not just around it, or goes on
    /// in another line.
    pub(super) fn cell(&self, at: usize) -> Option<(Range<usize>, usize)> {
        let rest = self.chunk.get(at..)?;
        if self.is_quoted && rest.first() == Some(&b'"') {
            let length = memchr3(b'"', b'\n', b'\r', rest.get(1..)?)?;
            let end = at + 1 + length;
            return (self.chunk.get(end) == Some(&b'"') && self.is_end_of_cell(end + 1))
                .then_some((at + 1..end, end + 1));
        }
        let end = memchr3(self.layout.syntax.delimiter, b'\n', b'\r', rest)
            .map_or(self.chunk.len(), |length| at + length);
        Some((at..end, end))
    }

    /// The end of the quotes around the cell that starts here; its start if there are none, and `None` as for [`Self::cell`].
    #[inline]
    fn after_quotes(&self, at: usize) -> Option<usize> {
        if self.is_quoted && self.chunk.get(at) == Some(&b'"') { Some(self.cell(at)?.1) } else { Some(at) }
    }

    /// The start of the next cell of the same row, from the start or the end of a cell.
    #[inline]
    pub(super) fn after_separator(&self, at: usize) -> Option<usize> {
        if self.chunk.get(at) == Some(&self.layout.syntax.delimiter) {
            return Some(at + 1);
        }
        self.after_cell(at)
    }

    /// The start of the next cell of the same row, from the start of a cell that is not empty. Not inlined: at the end of a cell, the
    /// usual place, it would only be in the way.
    #[inline(never)]
    fn after_cell(&self, at: usize) -> Option<usize> {
        let at = self.after_quotes(at)?;
        let rest = self.chunk.get(at..)?;
        let length = first_end(rest, self.layout.syntax.delimiter)?;
        (rest.get(length) == Some(&self.layout.syntax.delimiter)).then_some(at + length + 1)
    }

    /// The start of the next line, when exactly so many separators come before it.
    #[inline]
    pub(super) fn end_of_row(&self, at: usize, separators: usize) -> Option<usize> {
        if separators == 0 && self.chunk.get(at) == Some(&b'\n') {
            return Some(at + 1);
        }
        self.end_of_long_row(at, separators)
    }

    fn end_of_long_row(&self, at: usize, separators: usize) -> Option<usize> {
        let mut at = at;
        for _ in 0..separators {
            at = self.after_separator(at)?;
        }
        let at = self.after_quotes(at)?;
        let rest = self.chunk.get(at..)?;
        match first_end(rest, self.layout.syntax.delimiter) {
            Some(length) if rest.get(length) == Some(&b'\n') => Some(at + length + 1),
            Some(_) => None,
            None => Some(self.chunk.len()),
        }
    }

    /// The start of the line after a row in which there may be quotes; `None` when it is not as it should be, or may be empty.
    pub(super) fn end_of_quoted_row(&self, start: usize) -> Option<usize> {
        if self.after_blank_line(start).is_some() {
            return Some(self.next_line(start));
        }
        if self.may_be_empty(start) { None } else { self.end_of_row(start, self.layout.shape.width - 1) }
    }

    /// The start of the line after this one.
    #[inline]
    pub(super) fn next_line(&self, at: usize) -> usize {
        let rest = self.chunk.get(at..).unwrap_or_default();
        memchr(b'\n', rest).map_or(self.chunk.len(), |length| at + length + 1)
    }

    /// Returns whether a row that starts here may have nothing but empty cells.
    #[inline]
    pub(super) fn may_be_empty(&self, at: usize) -> bool {
        let is_empty = |&first: &u8| first == self.layout.syntax.delimiter || first <= b' ' || first == b'"';
        match self.chunk.get(at) {
            Some(b'"') => self.chunk.get(at + 1).is_some_and(is_empty),
            first => first.is_some_and(is_empty),
        }
    }

    /// The start of the line after this one, when this one is white space in one cell.
    #[inline]
    pub(super) fn after_blank_line(&self, at: usize) -> Option<usize> {
        // Nothing that is white space comes after the space.
        if self.chunk.get(at).is_none_or(|&first| first > b' ') {
            return None;
        }
        let next = self.next_line(at);
        let line = self.chunk.get(at..next)?;
        (line.trim_ascii().is_empty() && memchr(self.layout.syntax.delimiter, line).is_none()).then_some(next)
    }
}
