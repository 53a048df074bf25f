//! Lines of plain text no longer than a page of listings is wide.

use crate::align::columns;

/// The most columns of a line.
pub(crate) const WIDTH: usize = 80;

/// The lines of a text of which each fits into so many columns, unless one word alone does not. Lines end at blanks: first at
/// those that tear neither a bracket, a product nor the name of a bound apart.
pub(super) fn wrapped(text: &str, width: usize) -> Vec<String> {
    if columns(text) <= width {
        return vec![text.to_owned()];
    }
    let indent = text.len() - text.trim_start_matches(' ').len();
    let (indent, text) = text.split_at(indent);
    let mut lines = Lines { lines: Vec::new(), line: indent.to_owned(), is_empty: true, width };
    for chunk in chunks(text) {
        let is_long = chunk.split(' ').map(|word| columns(word) + 1).sum::<usize>() > width + 1;
        if is_long {
            chunk.split(' ').for_each(|word| lines.push(word));
        } else {
            lines.push(chunk);
        }
    }
    lines.lines.push(lines.line);
    lines.lines
}

/// Breaks the lines of a text so that each fits into a page of listings, unless one word alone does not.
pub fn in_page_width(text: &str) -> String {
    text.lines().flat_map(|line| wrapped(line, WIDTH)).map(|line| line + "\n").collect()
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
        if !self.is_empty && columns(&self.line) + 1 + columns(text) > self.width {
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

/// The pieces of a text, between blanks, within which no line should end.
fn chunks(text: &str) -> impl Iterator<Item = &str> {
    let (mut rest, mut is_over) = (text, false);
    std::iter::from_fn(move || {
        if is_over {
            return None;
        }
        let mut depth = 0_usize;
        let (mut start, mut end) = (0, 0);
        loop {
            let after = rest.get(end..).unwrap_or_default();
            end += after.bytes().position(|byte| byte == b' ').unwrap_or(after.len());
            let word = rest.get(start..end).unwrap_or_default();
            for byte in word.bytes() {
                match byte {
                    b'(' | b'[' => depth += 1,
                    b')' | b']' => depth = depth.saturating_sub(1),
                    _ => {}
                }
            }
            let Some(after) = rest.get(end + 1..) else {
                is_over = true;
                return Some(rest);
            };
            let next = after.split(' ').next().unwrap_or_default();
            if depth == 0 && !is_joined(word, next) {
                let chunk = rest.get(..end);
                rest = after;
                return chunk;
            }
            (start, end) = (end + 1, end + 1);
        }
    })
}

/// Returns whether two words belong together: operator and operand, row and side.
fn is_joined(word: &str, next: &str) -> bool {
    let relates = |word: &str| matches!(word, "*" | "<=" | ">=" | "=" | "+-");
    let is_side = || matches!(next.trim_end_matches([',', '.', ')']), "upper" | "lower");
    relates(word)
        || relates(next)
        || matches!(word, "+" | "-")
        || (word.ends_with(|character: char| character.is_ascii_digit()) && is_side())
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
