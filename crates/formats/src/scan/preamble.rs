//! What comes before the first record of a table: lines to be passed over, comments, and what they tell of the table.

use memchr::memchr_iter;

use crate::chunks::ChunkReader;
use crate::dialect::{AskedDialect, BLANKS, CommentMark};
use crate::records::{Records, Syntax};
use crate::start::{are_blanks, delimiter_of};

/// How many bytes are passed over at a time, so that many short lines cost no more than a few long ones.
const PASSED_AT_ONCE: usize = 1 << 16;

/// How many cells of a comment are looked at: names are few.
const MOST_CELLS: usize = 100_000;

/// Bytes that start comments unless another one is asked for.
pub(super) const USUAL_MARKS: [u8; 2] = *b"#%";

/// What comes before the first record.
pub(super) struct Preamble {
    pub(super) syntax: Syntax,
    /// Whether something separates columns.
    pub(super) has_delimiter: bool,
    /// The comment right before the first record, as it stands.
    pub(super) comment: Option<Vec<u8>>,
    /// The line that is reached, from 1.
    pub(super) lines: u64,
    /// The line that is reached when line feeds alone are counted.
    pub(super) line_feeds: u64,
}

/// Lines of a reader, of which nothing was handed out.
struct Lines<'r> {
    reader: &'r mut ChunkReader,
    /// How much was passed over, but is still held by the reader.
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

    fn pass(&mut self) {
        let Some((_, behind)) = self.reader.line_at(self.at) else { return };
        let passed = self.reader.pending().get(self.at..behind).unwrap_or_default();
        self.line_feeds += memchr_iter(b'\n', passed).count() as u64;
        self.lines += 1;
        self.at = behind;
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
    /// Has the reader pass over what comes before the first record.
    pub(super) fn read(reader: &mut ChunkReader, asked: &AskedDialect) -> Self {
        let mut lines = Lines { reader, at: 0, lines: 1, line_feeds: 1 };
        for _ in 0..asked.skip_lines {
            if lines.next().is_none() {
                break;
            }
            lines.pass();
        }
        let marks = match asked.comment {
            CommentMark::Auto => Some(USUAL_MARKS),
            CommentMark::None => None,
            CommentMark::Mark(mark) => Some([mark; 2]),
        };
        let is_mark = |first: u8| marks.is_some_and(|marks| marks.contains(&first));
        let mut comment = None;
        let mut has_comments = asked.comment != CommentMark::Auto;
        while let Some(line) = lines.next() {
            match line.first() {
                _ if is_blank(line, asked) => comment = None,
                Some(&first) if is_mark(first) => {
                    let line = line.to_vec();
                    if !has_comments && is_header(&line, asked, &mut lines, is_mark) {
                        break;
                    }
                    (comment, has_comments) = (Some(line), true);
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
        lines.end();
        let delimiter = found.unwrap_or(b',');
        let in_force = has_comments || delimiter == BLANKS;
        Preamble {
            syntax: Syntax { delimiter, comment: marks.filter(|_| in_force) },
            has_delimiter: found.is_some(),
            comment,
            lines: lines.lines,
            line_feeds: lines.line_feeds,
        }
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

/// Whether the first line that looks like a comment, which is the next one, is rather a header such as `#,x,y` or a row such as
/// `#1,2,3`: it has as many cells as the line after it, and those are not separated by blanks.
fn is_header(line: &[u8], asked: &AskedDialect, lines: &mut Lines, is_mark: impl Fn(u8) -> bool) -> bool {
    let Some(next) = lines.after_next(|_| false) else { return true };
    if next.first().is_some_and(|&first| is_mark(first)) && delimiter_of(line) != delimiter_of(&next) {
        return false;
    }
    let Some(delimiter) = asked.delimiter.or_else(|| delimiter_of(line)) else { return false };
    let cells = cells_of(line, delimiter).len();
    delimiter != BLANKS && cells > 1 && cells == cells_of(&next, delimiter).len()
}

/// Whether a line is no record, whatever separates cells; tabs that are known to separate some make one.
fn is_blank(line: &[u8], asked: &AskedDialect) -> bool {
    line.trim_ascii().is_empty() && !(asked.delimiter == Some(b'\t') && line.contains(&b'\t'))
}

/// The cells of a line.
fn cells_of(line: &[u8], delimiter: u8) -> Vec<Vec<u8>> {
    let mut records = Records::new("", Syntax { delimiter, comment: None }, 1, usize::MAX, false);
    let mut rest = line;
    if !matches!(records.next(&mut rest), Ok(true)) && !records.finish() {
        return Vec::new();
    }
    records.record().cells().take(MOST_CELLS).map(<[u8]>::to_vec).collect()
}
