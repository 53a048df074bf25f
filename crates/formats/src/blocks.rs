//! Blocks: rows behind a comment, or behind two blank lines, are other readings than those before.

use boundfit_exact::{Foreign, plain_decimal};
use memchr::memchr2;

use crate::block::{AskedBlock, Block};
use crate::dialect::{BLANKS, CommentMark};
use crate::error::{InputError, InputErrorKind};
use crate::notes::BlockNote;
use crate::start::{cells_between_blanks, delimiter_of};

/// The most bytes of a comment that serve as a name.
const LONGEST_NAME: usize = 100;

/// The most comments between two rows that are looked at.
const MOST_COMMENTS: u64 = 1000;

/// The most blocks that a message lists.
const MOST_LISTED: usize = 10;

/// The most names that are kept to see if a name stands for several blocks.
const MOST_NAMES: usize = 10_000;

/// The text between two rows.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Gap {
    pub(crate) blank_lines: u64,
    /// The number of comments.
    pub(crate) comments: u64,
    /// The last one that is no row that was taken out.
    pub(crate) title: Option<Foreign>,
}

impl Gap {
    /// Returns whether what comes behind it is another block.
    pub(crate) fn is_break(&self) -> bool {
        self.blank_lines > 1 || self.title.is_some()
    }

    /// Adds a comment, in a table with so many columns.
    pub(crate) fn add_comment(&mut self, line: &[u8], delimiter: u8, width: usize) {
        self.comments += 1;
        // Nobody chooses a block by the last one of very many comments.
        if self.comments > MOST_COMMENTS {
            return;
        }
        let start = line.iter().position(|byte| !matches!(byte, b'#' | b'%')).unwrap_or(line.len());
        let start = if start == 0 { 1.min(line.len()) } else { start };
        let text = line.get(start..).unwrap_or_default().trim_ascii();
        if !is_row(text, delimiter, width) {
            let text = text.get(..LONGEST_NAME).unwrap_or(text);
            self.title = Some(String::from_utf8_lossy(text).into_owned().into());
        }
    }

    /// Adds what follows.
    pub(crate) fn add(&mut self, later: Gap) {
        self.blank_lines += later.blank_lines;
        self.comments += later.comments;
        self.title = later.title.or(self.title.take());
    }
}

/// Returns whether a text is a row with so many columns, all of them numbers.
fn is_row(text: &[u8], delimiter: u8, width: usize) -> bool {
    let is_number = |cell: &[u8]| is_number(cell, delimiter);
    let cells: Vec<&[u8]> = cells_of(text, delimiter).collect();
    width > 1 && cells.len() == width && cells.into_iter().all(is_number)
}

fn cells_of(text: &[u8], delimiter: u8) -> impl Iterator<Item = &[u8]> {
    let is_between = move |byte: &u8| {
        if delimiter == BLANKS { matches!(byte, b' ' | b'\t') } else { *byte == delimiter }
    };
    text.split(is_between).filter(move |cell| delimiter != BLANKS || !cell.is_empty())
}

/// Returns whether a cell has a number, in quotes or not, with a point or a comma.
fn is_number(cell: &[u8], delimiter: u8) -> bool {
    let cell = cell.trim_ascii();
    let cell = cell.strip_prefix(b"\"").and_then(|cell| cell.strip_suffix(b"\"")).unwrap_or(cell);
    if delimiter == b',' || !cell.contains(&b',') {
        return plain_decimal(cell).is_some();
    }
    let with_point: Vec<u8> = cell.iter().map(|&byte| if byte == b',' { b'.' } else { byte }).collect();
    plain_decimal(&with_point).is_some()
}

/// The blocks of a file, found line after line.
#[derive(Debug)]
pub(crate) struct Blocks {
    comment: CommentMark,
    delimiter: Option<u8>,
    /// The separator of the current block, and its number of cells.
    shape: Option<(u8, usize)>,
    /// `true` if comments precede the table, so that a mark always starts one.
    has_comments: bool,
    complete: Vec<Block>,
    /// The numbers and names of the first many that have names.
    names: Vec<(usize, Foreign)>,
    /// The number of complete blocks, listed or not.
    count: usize,
    current: Option<Block>,
    gap: Gap,
    /// The line of the next text.
    line: u64,
}

impl Blocks {
    /// Nothing yet of a text with these comments and delimiter, as far as they are asked for, which begins with this line.
    pub(crate) fn new(comment: CommentMark, delimiter: Option<u8>, line: u64) -> Self {
        let has_comments = comment != CommentMark::Auto;
        Blocks {
            comment,
            delimiter,
            shape: None,
            has_comments,
            complete: Vec::new(),
            names: Vec::new(),
            count: 0,
            current: None,
            gap: Gap::default(),
            line,
        }
    }

    /// The blocks of a text of which this one was begun and this stood last, up to this line.
    pub(crate) fn after(
        self,
        block: Block,
        shape: (u8, usize),
        has_comments: bool,
        gap: Gap,
        line: u64,
    ) -> Self {
        let has_comments = self.has_comments || has_comments;
        Blocks { shape: Some(shape), has_comments, current: Some(block), gap, line, ..self }
    }

    /// Goes on with some lines.
    pub(crate) fn read(&mut self, piece: &[u8]) {
        let mut rest = piece;
        while !rest.is_empty() {
            // Many of them are passed over at once.
            let blank_lines = rest.iter().take_while(|&&byte| byte == b'\n').count();
            self.gap.blank_lines += blank_lines as u64;
            self.line += blank_lines as u64;
            rest = rest.get(blank_lines..).unwrap_or_default();
            if rest.is_empty() {
                return;
            }
            let end = memchr2(b'\r', b'\n', rest).unwrap_or(rest.len());
            let is_pair = rest.get(end..).is_some_and(|rest| rest.starts_with(b"\r\n"));
            let (line, behind) = rest.split_at_checked(end).unwrap_or_default();
            self.add(line);
            rest = behind.get(1 + usize::from(is_pair)..).unwrap_or_default();
        }
    }

    /// Goes on with a line; gives whether a block begins with it, and nothing of blank lines and comments.
    pub(crate) fn add(&mut self, line: &[u8]) -> Option<bool> {
        let number = self.line;
        self.line += 1;
        if line.trim_ascii().is_empty() {
            self.gap.blank_lines += 1;
            return None;
        }
        if self.is_comment(line) {
            let (delimiter, width) = self.shape.unwrap_or((BLANKS, 0));
            self.has_comments |= self.current.is_none();
            self.gap.add_comment(line, delimiter, width);
            return None;
        }
        let gap = std::mem::take(&mut self.gap);
        let is_next = self.current.as_ref().is_none_or(|block| block.rows > 0 && gap.is_break());
        if is_next {
            self.end();
            let delimiter = self.delimiter.or_else(|| delimiter_of(line)).unwrap_or(BLANKS);
            let width = match delimiter {
                BLANKS => cells_between_blanks(line),
                delimiter => cells_of(line, delimiter).count(),
            };
            self.shape = Some((delimiter, width));
            let name = gap.title.clone().filter(|_| self.names.len() < MOST_NAMES);
            self.names.extend(name.map(|name| (self.count + 1, name)));
            self.current = Some(Block { name: gap.title, lines: [number; 2], rows: 0 });
        }
        let delimiter = self.shape.map_or(BLANKS, |(delimiter, _)| delimiter);
        let has_number = cells_of(line, delimiter).any(|cell| is_number(cell, delimiter));
        if let Some(block) = &mut self.current {
            block.lines[1] = number;
            block.rows += usize::from(has_number);
        }
        Some(is_next)
    }

    fn is_comment(&self, line: &[u8]) -> bool {
        let Some(&first) = line.first() else { return false };
        match (self.comment, self.shape) {
            (CommentMark::None, _) => false,
            (CommentMark::Mark(mark), _) => first == mark,
            (CommentMark::Auto, _) if !matches!(first, b'#' | b'%') => false,
            (CommentMark::Auto, Some((delimiter, width))) => {
                self.has_comments || delimiter == BLANKS || cells_of(line, delimiter).count() != width
            }
            (CommentMark::Auto, None) => true,
        }
    }

    /// Ends the block under way.
    pub(crate) fn end(&mut self) {
        if let Some(block) = self.current.take() {
            self.count += 1;
            if self.complete.len() < MOST_LISTED {
                self.complete.push(block);
            }
        }
    }

    /// Returns the number of blocks, with the one that is being read.
    pub(crate) fn total(&self) -> usize {
        self.count + usize::from(self.current.is_some())
    }

    /// These blocks from this line on.
    pub(crate) fn resumed_at(self, line: u64) -> Self {
        Blocks { line, gap: Gap::default(), ..self }
    }

    /// Returns the numbers of the blocks with this name.
    pub(crate) fn named(&self, name: &str) -> Vec<usize> {
        self.names.iter().filter(|(_, own)| own.raw() == name).map(|(number, _)| *number).collect()
    }

    /// The line of the next text.
    pub(crate) fn line(&self) -> u64 {
        self.line
    }

    /// The block under way.
    pub(crate) fn current(&self) -> Option<&Block> {
        self.current.as_ref()
    }

    /// The error that there are several, or that the one that is asked for is not there.
    pub(crate) fn error(mut self, file: &str, wanted: Option<&AskedBlock>) -> InputError {
        self.end();
        let is_name = matches!(wanted, Some(AskedBlock::Number(n)) if !self.named(&n.to_string()).is_empty());
        let (total, blocks) = (self.count, self.complete);
        InputError::of_file(
            file,
            match wanted.cloned() {
                Some(wanted) => InputErrorKind::UnknownBlock { wanted, is_name, total, blocks },
                None => InputErrorKind::SeveralBlocks { total, blocks },
            },
        )
    }
}

impl BlockNote {
    /// The words about the block that was read, if there are several.
    pub(crate) fn of(number: Option<usize>, name: Option<Foreign>, total: usize) -> Option<Self> {
        let name = name.filter(|name| !name.is_empty());
        (total > 1).then_some(BlockNote { number, name, total })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::block::listed;

    fn blocks(text: &str) -> String {
        let mut blocks = Blocks::new(CommentMark::Auto, None, 1);
        blocks.read(text.as_bytes());
        blocks.end();
        listed(&blocks.complete, blocks.count)
    }

    #[test]
    fn blocks_begin_behind_comments_and_two_blank_lines() {
        for (text, expected) in [
            ("x,y\n1,2\n\n3,4\n", "1, lines 1 to 4, 2 rows"),
            ("x,y\n\n\n1,2\n3,4\n", "1, lines 1 to 5, 2 rows"),
            (
                "# run 1\n1 2\n2 3\n\n\n# run 2\r\n1 7\n",
                "1 (run 1), lines 2 to 3, 2 rows; 2 (run 2), line 7, 1 row",
            ),
            // A row is one whatever stands in front of its first number, unless comments precede the table.
            ("1;2\n# 3;4\n5;6\n# end\n", "1, lines 1 to 3, 3 rows"),
            ("# a\n1;2\n# 3;4\n5;6\n# end\n", "1 (a), lines 2 to 4, 2 rows"),
            ("a,b\n1,2\n\n\nc,d\n3,4\n", "1, lines 1 to 2, 1 row; 2, lines 5 to 6, 1 row"),
        ] {
            assert_eq!(blocks(text), expected, "{text:?}");
        }
        assert!(blocks(&"1 2\n\n\n".repeat(12)).ends_with("; and 2 more"));
    }
}
