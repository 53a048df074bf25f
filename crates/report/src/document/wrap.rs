//! Lines of plain text no longer than a page of listings is wide.

use unicode_width::UnicodeWidthStr;

/// The most columns of a line.
pub(super) const WIDTH: usize = 80;

/// The lines of a text of which each fits into so many columns, unless one word alone does not. Lines end at blanks: first at
/// those that tear neither a bracket, a product nor the name of a bound apart.
pub(super) fn wrapped(text: &str, width: usize) -> Vec<String> {
    let indent = text.len() - text.trim_start_matches(' ').len();
    let (indent, text) = text.split_at(indent);
    let mut lines = Lines { lines: Vec::new(), line: indent.to_owned(), is_empty: true, width };
    for chunk in chunks(text) {
        let is_long = chunk.iter().map(|word| word.width() + 1).sum::<usize>() > width + 1;
        if is_long {
            chunk.iter().for_each(|word| lines.push(word));
        } else {
            lines.push(&chunk.join(" "));
        }
    }
    lines.lines.push(lines.line);
    lines.lines
}

/// Lines that are filled one after the other.
struct Lines {
    lines: Vec<String>,
    line: String,
    is_empty: bool,
    width: usize,
}

impl Lines {
    fn push(&mut self, text: &str) {
        if !self.is_empty && self.line.width() + 1 + text.width() > self.width {
            self.lines.push(std::mem::take(&mut self.line));
            self.is_empty = true;
        }
        if !self.is_empty {
            self.line.push(' ');
        }
        self.line.push_str(text);
        self.is_empty = false;
    }
}

/// The words of a text, those together between which no line should end.
fn chunks(text: &str) -> Vec<Vec<&str>> {
    let mut chunks: Vec<Vec<&str>> = Vec::new();
    let mut depth = 0_usize;
    let mut is_torn = true;
    let mut words = text.split(' ').peekable();
    while let Some(word) = words.next() {
        match chunks.last_mut() {
            Some(chunk) if !is_torn => chunk.push(word),
            _ => chunks.push(vec![word]),
        }
        for character in word.chars() {
            match character {
                '(' | '[' => depth += 1,
                ')' | ']' => depth = depth.saturating_sub(1),
                _ => {}
            }
        }
        let next = words.peek().copied().unwrap_or_default();
        is_torn = depth == 0 && !is_joined(word, next);
    }
    chunks
}

/// Whether two words belong together: operator and operand, row and side.
fn is_joined(word: &str, next: &str) -> bool {
    let relates = |word: &str| matches!(word, "*" | "<=" | ">=" | "=" | "+-");
    let is_side = matches!(next.trim_end_matches([',', '.', ')']), "upper" | "lower");
    relates(word)
        || relates(next)
        || matches!(word, "+" | "-")
        || (is_side && word.ends_with(|character: char| character.is_ascii_digit()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_end_between_terms_and_names() {
        let proof = "500/5863 * (14 upper) + 500/5863 * (36 lower)";
        assert_eq!(wrapped(proof, 24), ["500/5863 * (14 upper)", "+ 500/5863 * (36 lower)"]);
        assert_eq!(wrapped(proof, 80), [proof]);
        assert_eq!(wrapped("fixed by 14 upper, 24 lower", 20), ["fixed by 14 upper,", "24 lower"]);
        assert_eq!(wrapped("from [1.5, 2] to 3", 10), ["from", "[1.5, 2]", "to 3"]);
    }

    #[test]
    fn what_is_too_long_is_torn_and_a_long_word_stays_whole() {
        assert_eq!(wrapped("[1.23456, 7.89012]", 10), ["[1.23456,", "7.89012]"]);
        assert_eq!(wrapped("a 123456789012 b", 5), ["a", "123456789012", "b"]);
        assert_eq!(wrapped("  indented words", 12), ["  indented", "words"]);
        assert_eq!(wrapped("", 5), [""]);
        assert_eq!(wrapped("unclosed ( and more words", 12), ["unclosed (", "and more", "words"]);
    }
}
