//! Lines before the first record of a table: skipped lines, comments, and their facts about the table.

use crate::blocks::Gap;
use crate::chunks::ChunkReader;
use crate::dialect::{AskedDialect, BLANKS, CommentMark};
use crate::heading::Heading;
use crate::limits::SizeLimits;
use crate::records::{Records, Syntax};
use crate::start::{are_blanks, delimiter_of};
use boundfit_exact::Foreign;

/// The number of bytes passed over at a time, so that many short lines cost no more than a few long ones.
const PASSED_AT_ONCE: usize = 1 << 16;

/// The most cells of a comment that are looked at: names are few.
const MOST_CELLS: usize = 100_000;

/// The number of lines in which names are looked for that do not stand in the first one.
const MOST_LINES_BEFORE: u64 = 1000;

/// Bytes that start comments unless another one is asked for.
pub(super) const USUAL_MARKS: [u8; 2] = *b"#%";

/// Lines before the first record.
pub(super) struct Preamble {
    pub(super) syntax: Syntax,
    /// `true` if there are comments, or it was said what they are.
    has_comments: bool,
    /// `true` if something separates columns.
    pub(super) has_delimiter: bool,
    /// The number of lines passed over that are neither comments nor blank.
    pub(super) passed: u64,
    /// The number of lines passed over that nobody asked to pass over.
    pub(super) unasked: u64,
    /// The comment right before the first record, as it stands.
    pub(super) comment: Option<Vec<u8>>,
    /// The line of that comment, from 1.
    pub(super) comment_line: u64,
    /// `true` if the first record begins as a comment does.
    pub(super) is_marked: bool,
    /// The line that is reached, from 1.
    pub(super) lines: u64,
    /// The line that is reached when line feeds alone are counted.
    pub(super) line_feeds: u64,
}

/// Lines of a reader, of which nothing was handed out.
struct Lines<'r> {
    reader: &'r mut ChunkReader,
    /// The number of bytes passed over but still held by the reader.
    at: usize,
    lines: u64,
    line_feeds: u64,
}

impl Lines<'_> {
    /// The next line, without its line end.
    fn next(&mut self) -> Option<&[u8]> {
        let (end, _) = self.reader.line_at(self.at)?;
        self.reader.pending().get(self.at..end)
    }

    /// The line after the next one, blank ones and those that `is_passed_over` apart.
    fn after_next(&mut self, is_passed_over: impl Fn(u8) -> bool) -> Option<Vec<u8>> {
        let (_, mut at) = self.reader.line_at(self.at)?;
        loop {
            let (end, behind) = self.reader.line_at(at)?;
            let line = self.reader.pending().get(at..end)?;
            if !line.trim_ascii().is_empty() && !line.first().is_some_and(|&first| is_passed_over(first)) {
                return Some(line.to_vec());
            }
            // Somebody may wait for an answer: a few such lines tell nothing, and many are not held for it.
            if behind > self.at + PASSED_AT_ONCE {
                return None;
            }
            at = behind;
        }
    }

    /// Returns the number of lines before the first one with all these names; 0 where none of the next lines
    /// has them.
    fn before_names(&mut self, names: &[&str], delimiter: Option<u8>) -> u64 {
        let mut at = self.at;
        for before in 0..MOST_LINES_BEFORE {
            let Some((end, behind)) = self.reader.line_at(at) else { return 0 };
            let line = self.reader.pending().get(at..end).unwrap_or_default();
            let delimiter = delimiter.or_else(|| delimiter_of(line)).unwrap_or(BLANKS);
            if has_names(&cells_of(line, delimiter), names) {
                return before;
            }
            if behind > self.at + PASSED_AT_ONCE {
                return 0;
            }
            at = behind;
        }
        0
    }

    fn pass(&mut self) {
        let Some((_, behind)) = self.reader.line_at(self.at) else { return };
        let passed = self.reader.pending().get(self.at..behind).unwrap_or_default();
        // A line ends at its first line feed.
        self.line_feeds += u64::from(passed.ends_with(b"\n"));
        self.lines += 1;
        self.pass_until(behind);
    }

    /// Passes over the empty lines that the reader holds, all at once: a file may have many millions.
    fn pass_empty(&mut self) {
        let held = self.reader.pending().get(self.at..).unwrap_or_default();
        let empty = held.iter().take_while(|&&byte| byte == b'\n').count();
        self.line_feeds += empty as u64;
        self.lines += empty as u64;
        self.pass_until(self.at + empty);
    }

    fn pass_until(&mut self, at: usize) {
        self.at = at;
        if self.at > PASSED_AT_ONCE {
            self.end();
        }
    }

    /// Has the reader pass over what was passed over here.
    fn end(&mut self) {
        self.reader.skip(std::mem::take(&mut self.at));
    }
}

impl Preamble {
    /// Has the reader pass over what comes before the first record. Where names are given that do not stand in the first line but
    /// together in a later one, the lines before that are none of the table.
    pub(super) fn read(
        reader: &mut ChunkReader,
        asked: &AskedDialect,
        names: &[&str],
        start: Option<[u64; 2]>,
    ) -> Self {
        let [at_line, at_line_feed] = start.unwrap_or([1, 1]);
        let mut lines = Lines { reader, at: 0, lines: at_line, line_feeds: at_line_feed };
        let mut asked = *asked;
        if start.is_some() {
            asked.skip_lines = 0;
        }
        let mut passed = 0;
        while passed < asked.skip_lines && lines.next().is_some() {
            lines.pass();
            passed += 1;
        }
        if passed == 0
            && let Some(delimiter) = lines.next().and_then(stated_delimiter)
        {
            asked.delimiter = asked.delimiter.or(Some(delimiter));
            lines.pass();
            passed += 1;
        }
        let has_comments = asked.comment != CommentMark::Auto;
        let mut found = Preamble::before_first(&mut lines, &asked, has_comments);
        let mut unasked = 0;
        if !found.has_names(names, &mut lines) {
            unasked = lines.before_names(names, asked.delimiter);
            (0..unasked).for_each(|_| lines.pass());
            if unasked > 0 {
                found = Preamble::before_first(&mut lines, &asked, found.has_comments);
            }
        }
        passed += unasked;
        lines.end();
        Preamble { passed, unasked, lines: lines.lines, line_feeds: lines.line_feeds, ..found }
    }

    /// Passes over comments and blank lines.
    fn before_first(lines: &mut Lines, asked: &AskedDialect, has_comments: bool) -> Self {
        let marks = match asked.comment {
            CommentMark::Auto => Some(USUAL_MARKS),
            CommentMark::None => None,
            CommentMark::Mark(mark) => Some([mark; 2]),
        };
        let is_mark = |first: u8| marks.is_some_and(|marks| marks.contains(&first));
        let (mut comment, mut comment_line, mut is_marked) = (None, 0, false);
        let mut has_comments = has_comments;
        while let Some(line) = lines.next() {
            match line.first() {
                _ if is_blank(line, asked) => {
                    comment = None;
                    lines.pass();
                    lines.pass_empty();
                    continue;
                }
                Some(&first) if is_mark(first) => {
                    let line = line.to_vec();
                    if !has_comments && is_header(&line, asked, lines, is_mark) {
                        is_marked = true;
                        break;
                    }
                    (comment, comment_line, has_comments) = (Some(line), lines.lines, true);
                }
                _ => break,
            }
            lines.pass();
        }
        let first = lines.next().unwrap_or_default().to_vec();
        let found = asked.delimiter.or_else(|| delimiter_of(&first)).or_else(|| {
            let second = lines.after_next(is_mark);
            are_blanks(&first, second.as_deref()).then_some(BLANKS)
        });
        let delimiter = found.unwrap_or(b',');
        let in_force = has_comments || delimiter == BLANKS;
        Preamble {
            syntax: Syntax { delimiter, comment: marks.filter(|_| in_force) },
            has_comments,
            has_delimiter: found.is_some(),
            passed: 0,
            unasked: 0,
            comment,
            comment_line,
            is_marked,
            lines: lines.lines,
            line_feeds: lines.line_feeds,
        }
    }

    /// Returns whether all these names stand in the comment before the first record, or in the line that it starts with.
    fn has_names(&self, names: &[&str], lines: &mut Lines) -> bool {
        let has_all = |cells: Vec<Vec<u8>>| has_names(&cells, names);
        names.len() < 2
            || self.commented_cells().is_some_and(has_all)
            || lines.next().is_none_or(|line| has_names(&cells_of(line, self.syntax.delimiter), names))
    }

    /// The text of that comment.
    pub(super) fn title(&self) -> Option<Foreign> {
        let mut gap = Gap::default();
        gap.add_comment(self.comment.as_deref()?, self.syntax.delimiter, 0);
        gap.title
    }

    /// The cells of the comment right before the first record, without its mark.
    pub(super) fn commented_cells(&self) -> Option<Vec<Vec<u8>>> {
        let comment = self.comment.as_deref()?;
        let marks = self.syntax.comment.unwrap_or(USUAL_MARKS);
        let start = comment.iter().position(|byte| !marks.contains(byte))?;
        let text = comment.get(start..)?.trim_ascii();
        (!text.is_empty()).then(|| cells_of(text, self.syntax.delimiter))
    }
}

/// Returns true if the next line, the first that looks like a comment, is rather a header such as `#,x,y` or
/// a row such as `#1,2,3`. It has then as many cells as the line after it, and blanks do not separate them.
fn is_header(line: &[u8], asked: &AskedDialect, lines: &mut Lines, is_mark: impl Fn(u8) -> bool) -> bool {
    let Some(next) = lines.after_next(|_| false) else { return true };
    if next.first().is_some_and(|&first| is_mark(first)) && delimiter_of(line) != delimiter_of(&next) {
        return false;
    }
    let Some(delimiter) = asked.delimiter.or_else(|| delimiter_of(line)) else { return false };
    let cells = cells_of(line, delimiter).len();
    delimiter != BLANKS && cells > 1 && cells == cells_of(&next, delimiter).len()
}

/// The separator of columns by Excel's own first line, `sep=;`.
fn stated_delimiter(line: &[u8]) -> Option<u8> {
    let line = line.strip_prefix(b"\"").and_then(|line| line.strip_suffix(b"\"")).unwrap_or(line);
    let (start, stated) = line.split_at_checked(4)?;
    let is_stated = start.eq_ignore_ascii_case(b"sep=");
    match stated {
        [delimiter] if is_stated => {
            (delimiter.is_ascii_punctuation() || matches!(delimiter, b'\t' | b' ')).then_some(*delimiter)
        }
        _ => None,
    }
}

/// Returns whether each of these names is that of one of the cells.
fn has_names(cells: &[Vec<u8>], names: &[&str]) -> bool {
    let cells: Vec<Foreign> =
        cells.iter().map(|cell| String::from_utf8_lossy(cell).trim().to_owned().into()).collect();
    names.iter().all(|name| !Heading::named(&cells, name).is_empty())
}

/// Returns whether a line is no record, whatever separates cells; tabs that are known to separate some make one.
fn is_blank(line: &[u8], asked: &AskedDialect) -> bool {
    line.trim_ascii().is_empty() && !(asked.delimiter == Some(b'\t') && line.contains(&b'\t'))
}

/// The cells of a line.
fn cells_of(line: &[u8], delimiter: u8) -> Vec<Vec<u8>> {
    let sizes = SizeLimits { line: usize::MAX, columns: MOST_CELLS, ..SizeLimits::default() };
    let mut records = Records::new("", Syntax { delimiter, comment: None }, 1, &sizes, false);
    // Without quotes a line lacks nothing but its end to be a record.
    let ended = if line.contains(&b'"') { line.to_vec() } else { [line, b"\n"].concat() };
    let mut rest = ended.as_slice();
    // A line with more cells than that is refused, and has the first of them.
    if matches!(records.next(&mut rest), Ok(false)) && !records.finish() {
        return Vec::new();
    }
    records.record().cells().take(MOST_CELLS).map(<[u8]>::to_vec).collect()
}
