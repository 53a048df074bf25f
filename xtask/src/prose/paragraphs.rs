//! Takes prose out of Markdown and of comments of Rust, without code.

/// The place of a paragraph.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// The first paragraph of a comment of rustdoc.
    Summary,
    /// Any other.
    Plain,
}

/// A paragraph, an item of a list or a cell of a table.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Paragraph {
    /// The line of the file that it begins in.
    pub(super) line: usize,
    /// The place of the paragraph.
    pub(super) kind: Kind,
    /// The words of the paragraph in one line; a piece of code is the one word `` `x` ``.
    pub(super) text: String,
}

/// Collects lines of Markdown into paragraphs.
#[derive(Default)]
struct Collector {
    paragraphs: Vec<Paragraph>,
    line: usize,
    open: String,
    is_summary: bool,
    /// `true` in a block of code, or in the output of a command.
    is_code: bool,
}

impl Collector {
    /// Ends the paragraph.
    fn close(&mut self) {
        let text = without_code(&std::mem::take(&mut self.open));
        if !text.trim().is_empty() {
            let kind = if self.is_summary { Kind::Summary } else { Kind::Plain };
            self.is_summary = false;
            self.paragraphs.push(Paragraph { line: self.line, kind, text });
        }
    }

    /// Ends a text; the next one begins with a summary or not.
    fn begin(&mut self, is_summary: bool) {
        self.close();
        (self.is_summary, self.is_code) = (is_summary, false);
    }

    /// Adds words to the paragraph that is open.
    fn add(&mut self, number: usize, words: &str) {
        if self.open.is_empty() {
            self.line = number;
        } else {
            self.open.push(' ');
        }
        self.open.push_str(words);
    }

    /// Reads a line.
    fn read(&mut self, number: usize, line: &str) {
        let text = line.trim();
        let is_fence = text.starts_with("```") || text.starts_with("~~~");
        let begins_output = text.starts_with("<!-- output of:");
        if is_fence || begins_output || text == "<!-- end of output -->" {
            self.close();
            self.is_code = if is_fence { !self.is_code } else { begins_output };
            return;
        }
        if self.is_code {
            return;
        }
        // Headings may be questions.
        if text.is_empty() || text.starts_with('#') {
            self.close();
        } else if text.starts_with('|') {
            self.close();
            for line in cells(text).iter().flat_map(|cell| cell.split("<br>")) {
                self.add(number, line.trim());
                self.close();
            }
        } else if let Some(item) = item(text) {
            self.close();
            self.add(number, item);
        } else if self.open.is_empty() && line.starts_with("    ") {
            // Code that is known by its indent.
        } else {
            self.add(number, text.trim_start_matches("> "));
        }
    }
}

/// The cells of a row of a table; a bar in code or behind a backslash is none of its bars.
fn cells(row: &str) -> Vec<String> {
    let (mut cells, mut is_code, mut before) = (vec![String::new()], false, ' ');
    for letter in row.chars() {
        is_code ^= letter == '`';
        match cells.last_mut() {
            Some(cell) if letter != '|' || is_code || before == '\\' => cell.push(letter),
            _ => cells.push(String::new()),
        }
        before = letter;
    }
    cells
}

/// The text of an item of a list.
fn item(text: &str) -> Option<&str> {
    let rest = text.trim_start_matches(|letter: char| letter.is_ascii_digit());
    let numbered = (rest.len() < text.len()).then(|| rest.strip_prefix(". ")).flatten();
    numbered.or_else(|| ["- ", "* ", "+ "].iter().find_map(|mark| text.strip_prefix(mark)))
}

/// A text with `` `x` `` in the place of code, and without tags and the addresses of links.
fn without_code(text: &str) -> String {
    let pieces: Vec<&str> = text.split('`').collect();
    // An odd number of marks: the last one is a letter.
    let is_closed = pieces.len() % 2 == 1;
    let mut plain = String::new();
    for (place, piece) in pieces.iter().enumerate() {
        match place % 2 == 1 && (is_closed || place + 1 < pieces.len()) {
            true => plain.push_str("`x`"),
            false => plain.push_str(piece),
        }
    }
    without(&without(&plain, "](", ')'), "<", '>')
}

/// A text without what stands between a beginning and an end, both left out.
fn without(text: &str, begin: &str, end: char) -> String {
    let mut parts = text.split(begin);
    let mut kept = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        // A beginning that nothing follows closely, as in `a < b`, is text.
        let is_mark = begin.len() > 1
            || part.starts_with(|letter: char| letter.is_alphabetic() || "/!".contains(letter));
        match part.split_once(end).filter(|_| is_mark) {
            Some((_, rest)) => kept.push_str(rest),
            None => kept = kept + begin + part,
        }
    }
    kept
}

/// The paragraphs of a page.
pub(super) fn of_markdown(text: &str) -> Vec<Paragraph> {
    let mut collector = Collector::default();
    for (number, line) in (1..).zip(text.lines()) {
        collector.read(number, line);
    }
    collector.close();
    collector.paragraphs
}

/// A line of comment and whether rustdoc shows it. Comments behind code are not read.
fn comment(line: &str) -> Option<(&str, bool)> {
    let text = line.trim_start().strip_prefix("//")?;
    match text.strip_prefix('/').or_else(|| text.strip_prefix('!')) {
        Some(text) if !text.starts_with('/') => Some((text.strip_prefix(' ').unwrap_or(text), true)),
        _ => Some((text.strip_prefix(' ').unwrap_or(text), false)),
    }
}

/// The paragraphs of the comments of a file of Rust.
pub(super) fn of_rust(text: &str) -> Vec<Paragraph> {
    let mut collector = Collector::default();
    let mut last = None;
    for (number, line) in (1..).zip(text.lines()) {
        let comment = comment(line);
        let is_shown = comment.map(|(_, is_shown)| is_shown);
        if is_shown != last {
            collector.begin(is_shown == Some(true));
        }
        if let Some((text, _)) = comment {
            collector.read(number, text);
        }
        last = is_shown;
    }
    collector.close();
    collector.paragraphs
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(paragraphs: Vec<Paragraph>) -> Vec<(usize, String)> {
        paragraphs.into_iter().map(|paragraph| (paragraph.line, paragraph.text)).collect()
    }

    #[test]
    fn pages_are_read_without_code_headings_and_output() {
        let page = "# What is it?\n\nOne `a.b` [two](x.md#y)\nthree.\n\n```sh\nfour\n```\n- five\n- six <br> a < b\n\n\
                    <!-- output of: c -->\nseven\n<!-- end of output -->\n| eight | `a|b` nine<br>ten |\n|---|---|\n";
        let expected = [
            (3, "One `x` [two three."),
            (9, "five"),
            (10, "six  a < b"),
            (15, "eight"),
            (15, "`x` nine"),
            (15, "ten"),
            (16, "---"),
            (16, "---"),
        ];
        assert_eq!(texts(of_markdown(page)), expected.map(|(line, text)| (line, text.to_owned())));
    }

    #[test]
    fn comments_are_read_with_their_kind() {
        let code = "//! Head\n//! of it.\n//!\n//! More.\n\nfn f() {} // no\n    /// Shown.\n    // why\n//// line\n";
        let found: Vec<_> = of_rust(code).into_iter().map(|part| (part.line, part.kind, part.text)).collect();
        let expected = [
            (1, Kind::Summary, "Head of it."),
            (4, Kind::Plain, "More."),
            (7, Kind::Summary, "Shown."),
            (8, Kind::Plain, "why //line"),
        ];
        assert_eq!(found.len(), expected.len(), "{found:?}");
        for (found, expected) in found.iter().zip(expected) {
            assert_eq!((found.0, found.1), (expected.0, expected.1));
            assert_eq!(found.2.replace("// ", "//"), expected.2);
        }
    }
}
