//! Selects data rows: by number, and by the values in them.

use std::ops::Range;

use boundfit_exact::{Foreign, Limits, ParseNumberError, Rational, Reading};
use thiserror::Error;

use crate::columns::ColumnSelector;
use crate::row_range::RowRange;

/// Data rows by number.
///
/// ```
/// use boundfit_formats::{RowRange, RowSet};
///
/// let [head, outlier] = [RowRange::new(1, 9).unwrap(), RowRange::new(4, 4).unwrap()];
/// let rows = RowSet::new(&[head], &[outlier]).unwrap();
/// assert!(rows.contains(3) && !rows.contains(4) && rows.contains(9) && !rows.contains(10));
/// assert!(RowSet::default().contains(10));
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct RowSet {
    /// The named rows, none beyond the last row.
    named: Vec<RowRange>,
    without: Vec<RowRange>,
    /// Ascending, with a gap between any two; `None` for all rows.
    wanted: Option<Vec<Range<usize>>>,
}

impl RowSet {
    /// The rows of some ranges, of none all, without those of others; `None` when no row can be left.
    pub fn new(wanted: &[RowRange], without: &[RowRange]) -> Option<Self> {
        if wanted.is_empty() && without.is_empty() {
            return Some(RowSet::default());
        }
        let all = Range { start: 1, end: usize::MAX };
        let mut left = if wanted.is_empty() { vec![all] } else { united(wanted) };
        for hole in united(without) {
            let around = |range: Range<usize>| {
                [range.start..range.end.min(hole.start), range.start.max(hole.end)..range.end]
            };
            left = left.into_iter().flat_map(around).filter(|range| !range.is_empty()).collect();
        }
        (!left.is_empty()).then(|| RowSet {
            named: wanted.to_vec(),
            without: without.to_vec(),
            wanted: Some(left),
        })
    }

    /// The ranges of wanted rows as they were named.
    pub fn named(&self) -> &[RowRange] {
        &self.named
    }

    /// The ranges of rows that are left out as they were named.
    pub fn without(&self) -> &[RowRange] {
        &self.without
    }

    /// Returns whether all rows are wanted.
    pub fn is_all(&self) -> bool {
        self.wanted.is_none()
    }

    /// Returns whether a row is wanted.
    #[inline]
    pub fn contains(&self, row: usize) -> bool {
        self.wanted.as_ref().is_none_or(|wanted| {
            let at = wanted.partition_point(|range| range.end <= row);
            wanted.get(at).is_some_and(|range| range.start <= row)
        })
    }

    /// Returns the wanted rows among the rows from `start` to before `end`.
    pub(crate) fn among(&self, start: usize, end: usize) -> Vec<Range<usize>> {
        let Some(wanted) = &self.wanted else { return ranges_of(std::iter::once(start..end)) };
        ranges_of(wanted.iter().map(|range| range.start.max(start)..range.end.min(end)))
    }

    /// The first named row beyond these rows.
    pub(crate) fn beyond(&self, total: usize) -> Option<RowRange> {
        self.named.iter().chain(&self.without).find(|range| range.is_beyond(total)).copied()
    }
}

impl From<RowRange> for RowSet {
    fn from(range: RowRange) -> Self {
        RowSet { named: vec![range], without: Vec::new(), wanted: Some(vec![range.rows()]) }
    }
}

/// All rows when there is no range.
impl From<Option<RowRange>> for RowSet {
    fn from(range: Option<RowRange>) -> Self {
        range.map_or_else(RowSet::default, RowSet::from)
    }
}

/// The parts that have rows.
fn ranges_of(ranges: impl IntoIterator<Item = Range<usize>>) -> Vec<Range<usize>> {
    ranges.into_iter().filter(|range| !range.is_empty()).collect()
}

/// The rows of all ranges, ascending, with a gap between any two.
fn united(ranges: &[RowRange]) -> Vec<Range<usize>> {
    let mut sorted: Vec<Range<usize>> = ranges.iter().map(RowRange::rows).collect();
    sorted.sort_by_key(|range| range.start);
    let mut united: Vec<Range<usize>> = Vec::new();
    for range in sorted {
        match united.last_mut() {
            Some(last) if range.start <= last.end => last.end = last.end.max(range.end),
            _ => united.push(range),
        }
    }
    united
}

/// Returns the gaps between ascending ranges, from `start` to before `end`.
pub(crate) fn between(ranges: &[Range<usize>], start: usize, end: usize) -> Vec<Range<usize>> {
    let starts = [start].into_iter().chain(ranges.iter().map(|range| range.end));
    let ends = ranges.iter().map(|range| range.start).chain([end]);
    ranges_of(starts.zip(ends).map(|(start, end)| start..end))
}

/// The most rows that are handed out at a time: two columns of them take 1 MB.
const BATCH_ROWS: usize = 1 << 16;

/// Rows in groups that are not too large.
pub(crate) fn in_batches(wanted: &[Range<usize>]) -> Vec<Vec<Range<usize>>> {
    let (mut batches, mut room) = (Vec::<Vec<Range<usize>>>::new(), 0);
    for range in wanted {
        let mut start = range.start;
        while start < range.end {
            if room == 0 {
                batches.push(Vec::new());
                room = BATCH_ROWS;
            }
            let end = range.end.min(start + room);
            room -= end - start;
            batches.last_mut().into_iter().for_each(|batch| batch.push(start..end));
            start = end;
        }
    }
    batches
}

/// The numbers of some data rows, ascending, counted from 1. Rows one after the other take no more memory than one.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct RowNumbers {
    runs: Vec<Run>,
    count: usize,
    /// One more than the last number.
    next: usize,
}

/// Rows one after the other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Run {
    /// The position of the first, from 0.
    index: usize,
    /// The row's number.
    row: usize,
}

impl FromIterator<Range<usize>> for RowNumbers {
    fn from_iter<T: IntoIterator<Item = Range<usize>>>(ranges: T) -> Self {
        let mut numbers = RowNumbers::default();
        ranges.into_iter().for_each(|range| numbers.push_all(range));
        numbers
    }
}

impl RowNumbers {
    /// Returns the number of rows.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Returns whether there are none.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// The number of the row at a position, counted from 0. Cost: logarithmic in the number of gaps.
    ///
    /// # Panics
    /// When there are not that many.
    #[allow(clippy::indexing_slicing, reason = "documented to panic")]
    pub fn get(&self, index: usize) -> usize {
        let run = self.runs[self.runs.partition_point(|run| run.index <= index) - 1];
        run.row + (index - run.index)
    }

    /// The position of a row, if it is there.
    pub fn position(&self, row: usize) -> Option<usize> {
        let after = self.runs.partition_point(|run| run.row <= row);
        let run = self.runs.get(after.checked_sub(1)?)?;
        let end = self.runs.get(after).map_or(self.count, |run| run.index);
        let position = run.index + (row - run.row);
        (position < end).then_some(position)
    }

    /// First and last of the rows that follow each other without a gap.
    pub fn ranges(&self) -> impl Iterator<Item = [usize; 2]> + '_ {
        let ends = self.runs.iter().skip(1).map(|run| run.index).chain([self.count]);
        self.runs.iter().zip(ends).map(|(run, end)| [run.row, run.row + (end - run.index) - 1])
    }

    /// Adds the numbers of later rows.
    pub fn append(&mut self, later: &RowNumbers) {
        later.ranges().for_each(|[first, last]| self.push_all(first..last + 1));
    }

    /// Adds a later row.
    #[inline]
    pub(crate) fn push(&mut self, row: usize) {
        if row != self.next || self.count == 0 {
            self.runs.push(Run { index: self.count, row });
        }
        self.count += 1;
        self.next = row + 1;
    }

    /// Adds later rows.
    pub(crate) fn push_all(&mut self, rows: Range<usize>) {
        if !rows.is_empty() {
            self.push(rows.start);
            self.count += rows.len() - 1;
            self.next = rows.end;
        }
    }

    /// Adds so much to every number.
    pub(crate) fn shift(&mut self, by: usize) {
        self.runs.iter_mut().for_each(|run| run.row += by);
        self.next += by;
    }
}

/// A comparison of numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Comparison {
    Less,
    AtMost,
    Equal,
    NotEqual,
    AtLeast,
    Greater,
}

/// Longer ones before those that they begin with.
const COMPARISONS: [(&str, Comparison); 7] = [
    ("<=", Comparison::AtMost),
    (">=", Comparison::AtLeast),
    ("!=", Comparison::NotEqual),
    ("==", Comparison::Equal),
    ("<", Comparison::Less),
    (">", Comparison::Greater),
    ("=", Comparison::Equal),
];

/// The condition on the number in a column for a row to be wanted.
///
/// ```
/// use boundfit_exact::{Limits, Rational, Reading};
/// use boundfit_formats::RowCondition;
///
/// let condition = RowCondition::parse("temperature >= 0.1", Reading::Decimal, &Limits::default())?;
/// assert_eq!(condition.column().text(), "temperature");
/// assert!(condition.holds(&Rational::ratio(1, 10)) && !condition.holds(&Rational::ratio(1, 11)));
/// # Ok::<(), boundfit_formats::ParseRowConditionError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RowCondition {
    column: ColumnSelector,
    comparison: Comparison,
    number: Rational,
    text: Foreign,
}

/// A reason why a text is no condition on rows.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ParseRowConditionError {
    /// Nothing is compared.
    #[error("there is no comparison")]
    NoComparison,
    /// The comparison has no column.
    #[error("there is no column before the comparison")]
    NoColumn,
    /// A name that begins with a quote does not end with one.
    #[error("the quote before the column's name is not closed")]
    OpenQuote,
    /// The text after the comparison, which is no number.
    #[error("{text:?}: {}: {error}", if .error.kind.is_limit() { "refused" } else { "not a number" })]
    NotANumber {
        /// The text that stands there.
        text: Foreign,
        /// The problem with it.
        error: ParseNumberError,
    },
}

impl RowCondition {
    /// Reads a condition such as `temperature >= 20` or `3 != 0`. The column stands by its number or its
    /// name, in quotes if the name has a comparison in it. Then comes one of `<`, `<=`, `=`, `!=`, `>=`, `>`,
    /// and a number, which is read like the column's.
    ///
    /// # Errors
    /// When the text is not of this form.
    pub fn parse(text: &str, reading: Reading, limits: &Limits) -> Result<Self, ParseRowConditionError> {
        let (column, rest) = column_and_rest(text.trim())?;
        let rest = rest.trim_start();
        let (comparison, number) = COMPARISONS
            .iter()
            .find_map(|(sign, comparison)| Some((*comparison, rest.strip_prefix(sign)?.trim())))
            .ok_or(ParseRowConditionError::NoComparison)?;
        if column.text().is_empty() {
            return Err(ParseRowConditionError::NoColumn);
        }
        let not_a_number = |error| ParseRowConditionError::NotANumber { text: number.into(), error };
        let number = reading.read(number, limits).map_err(not_a_number)?;
        Ok(RowCondition { column, comparison, number, text: text.trim().into() })
    }

    /// The column.
    pub fn column(&self) -> &ColumnSelector {
        &self.column
    }

    /// The condition as it was written.
    pub fn text(&self) -> &Foreign {
        &self.text
    }

    /// Returns whether a number satisfies it. Exact.
    pub fn holds(&self, number: &Rational) -> bool {
        let order = number.cmp(&self.number);
        match self.comparison {
            Comparison::Less => order.is_lt(),
            Comparison::AtMost => order.is_le(),
            Comparison::Equal => order.is_eq(),
            Comparison::NotEqual => order.is_ne(),
            Comparison::AtLeast => order.is_ge(),
            Comparison::Greater => order.is_gt(),
        }
    }
}

/// The column in front of a condition, and what follows it.
fn column_and_rest(text: &str) -> Result<(ColumnSelector, &str), ParseRowConditionError> {
    for quote in ['"', '\''] {
        if let Some(quoted) = text.strip_prefix(quote) {
            let (name, rest) = quoted.split_once(quote).ok_or(ParseRowConditionError::OpenQuote)?;
            return Ok((ColumnSelector::name(name), rest));
        }
    }
    let end = text.find(['<', '>', '=', '!']).unwrap_or(text.len());
    let (name, rest) = text.split_at_checked(end).unwrap_or((text, ""));
    Ok((ColumnSelector::name_or_number(name), rest))
}

#[cfg(test)]
mod tests;
