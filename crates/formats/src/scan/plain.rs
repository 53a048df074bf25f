//! The fast lane: chunks in which line feeds end lines, and quotes are around whole cells if there are any.

use std::borrow::Cow;

use boundfit_exact::DecimalMark;
use memchr::{memchr, memchr_iter, memchr2};

use super::lane::Lane;
use super::layout::Layout;
use super::notes::Notes;
use super::route::Route;
use super::rows::Rows;
use super::straight::Straight;
use crate::error::{InputError, InputErrorKind};

/// The ways through a row.
pub(super) struct Ways {
    route: Route,
    /// The way through rows of which only numbers are wanted.
    straight: Option<Straight>,
}

impl Ways {
    /// The ways through the rows of a table; `None` as [`Route::new`] says.
    pub(super) fn new(layout: &Layout) -> Option<Self> {
        let route = Route::new(layout)?;
        let table = &layout.options.table;
        let wants_all = !table.selects_rows() && !layout.options.keep_text;
        let straight =
            wants_all.then(|| Straight::of(&route.steps, layout.places.len(), route.behind)).flatten();
        Some(Ways { route, straight })
    }
}

/// The number of stops that the reader of many rows at once may make at rows that take more, before it is
/// left alone. It may also stop at a fourth of the rows.
const MOST_STOPS: usize = 100;

/// Reads the rows of a chunk that comes after so many rows; `None` when it is not for the fast lane.
pub(super) fn parse(chunk: &[u8], layout: &Layout, ways: &Ways, rows_before: usize) -> Option<Rows> {
    if !is_plain(chunk, layout) {
        return None;
    }
    let numbers = with_points(chunk, layout)?;
    let mut lane = Lane::new(chunk, &numbers, layout, &ways.route);
    let mut used = 0;
    lane.batch.reserve(likely_rows(chunk));
    let (mut total, mut lines, mut at) = (0, 0, 0);
    let (mut straight, mut stops) = (ways.straight.as_ref(), 0);
    // Blank lines before the first row, and since the last one.
    let (mut before, mut since) = (0, 0);
    // The first decimal point of a cell that is read, which the rules in full note as well.
    let mut is_looking = layout.waits_for_mark() && memchr(b'.', chunk).is_some();
    let mut mark = None;
    while at < chunk.len() {
        if let Some(way) = straight {
            let (rows, next) = way.read(&mut lane, at).unwrap_or_else(|| {
                straight = None;
                (0, at)
            });
            if is_looking {
                mark = lane.first_point(at..next, lines, rows_before + total);
                is_looking = mark.is_none();
            }
            at = next;
            if rows > 0 {
                since = blanks_ended(since, total, &mut before)?;
            }
            lane.batch.end_rows(rows_before + total + 1, rows);
            (total, used, lines) = (total + rows, used + rows, lines + rows as u64);
            if at == chunk.len() {
                break;
            }
            stops += 1;
            if stops > MOST_STOPS + total / 4 {
                straight = None;
            }
        }
        lines += 1;
        if let Some(next) = lane.after_blank_line(at) {
            at = next;
            since += 1;
            continue;
        }
        since = blanks_ended(since, total, &mut before)?;
        total += 1;
        let start = at;
        let is_wanted = layout.is_wanted(rows_before + total);
        let is_satisfied = is_wanted && lane.satisfies_conditions(start)?;
        if is_looking && is_wanted {
            let end = lane.next_line(start);
            mark = lane.told(start..end, is_satisfied, lines, rows_before + total - 1);
            is_looking = mark.is_none();
        }
        if is_satisfied {
            at = lane.row(start)?;
            let text = layout.options.keep_text.then(|| chunk.get(start..at).map_or(chunk, without_line_end));
            lane.batch.end_row(rows_before + total, text);
            used += 1;
        } else {
            if lane.may_be_empty(start) {
                return None;
            }
            at = lane.end_of_row(start, layout.shape.width - 1)?;
        }
    }
    let first = InputError::of_line(layout.file, before + 1, InputErrorKind::NextBlock);
    let mut notes = Notes::of_rows(total, used, [before, since], first);
    notes.mark = mark;
    Some(Rows { batch: lane.batch, notes, total, lines, line_feeds: lines })
}

/// Ends a run of blank lines before a row that comes after so many others; `None` where another block begins.
#[inline]
fn blanks_ended(since: u64, total: usize, before: &mut u64) -> Option<u64> {
    if total == 0 {
        *before = since;
        return Some(0);
    }
    (since < 2).then_some(0)
}

/// The chunk in which decimals have points: a copy where they have commas. `None` where it may hold both, or where the first
/// mark is still to be found, unless commas separate cells: a comma within one ends the fast lane anyway.
fn with_points<'c>(chunk: &'c [u8], layout: &Layout) -> Option<Cow<'c, [u8]>> {
    match layout.mark.known() {
        Some(DecimalMark::Point) => Some(Cow::Borrowed(chunk)),
        Some(DecimalMark::Comma) if layout.syntax.delimiter == b',' || memchr(b'.', chunk).is_some() => None,
        Some(DecimalMark::Comma) => {
            Some(chunk.iter().map(|&byte| if byte == b',' { b'.' } else { byte }).collect())
        }
        None if layout.syntax.delimiter == b',' => Some(Cow::Borrowed(chunk)),
        None => memchr2(b'.', b',', chunk).is_none().then_some(Cow::Borrowed(chunk)),
    }
}

/// Estimates the number of rows of a chunk, rather too high, by its first lines; in steps, so that freed
/// memory fits again.
fn likely_rows(chunk: &[u8]) -> usize {
    const STEP: usize = 1 << 11;
    let sample = chunk.get(..1 << 12).unwrap_or(chunk);
    let rows = (memchr_iter(b'\n', sample).count() + 1) * chunk.len() / sample.len().max(1);
    if chunk.len() == sample.len() { rows } else { (rows + rows / 16).next_multiple_of(STEP) }
}

/// Returns the number of rows of a chunk; `None` when it is not for the fast lane.
pub(super) fn count(chunk: &[u8], layout: &Layout, ways: &Ways) -> Option<usize> {
    if !is_plain(chunk, layout) {
        return None;
    }
    let lane = Lane::new(chunk, chunk, layout, &ways.route);
    let mut start = 0;
    let mut total = 0;
    while start < chunk.len() {
        if chunk.get(start).is_some_and(|&first| layout.may_be_comment(first)) {
            return None;
        }
        total += usize::from(lane.after_blank_line(start).is_none());
        start = if lane.is_quoted { lane.end_of_quoted_row(start)? } else { lane.next_line(start) };
    }
    Some(total)
}

/// Returns whether line feeds end lines, nothing else does, and there are neither comments nor further headers.
fn is_plain(chunk: &[u8], layout: &Layout) -> bool {
    !layout.may_repeat_header(chunk)
        && layout.syntax.comment.is_none_or(|[one, other]| memchr2(one, other, chunk).is_none())
        && memchr_iter(b'\r', chunk).all(|position| chunk.get(position + 1) == Some(&b'\n'))
}

fn without_line_end(line: &[u8]) -> &[u8] {
    let line = line.strip_suffix(b"\n").unwrap_or(line);
    line.strip_suffix(b"\r").unwrap_or(line)
}
