//! cdd's H-representation (Fukuda, *cddlib Reference Manual*, polyhedra file format): a row `b -a1 -a2` stands for
//! `b - a1·θ1 - a2·θ2 ≥ 0`.

use boundfit_exact::Rational;
use boundfit_geometry::{Inequality, System};

use crate::error::{InputError, Place, Problem};
use crate::half_planes::{HalfPlaneFile, RowOrigin};
use crate::source::Source;
use crate::table::TableOptions;

/// A word of the file with its line and column, from 1.
#[derive(Clone, Copy)]
struct Token<'a> {
    text: &'a str,
    line: u64,
    column: usize,
}

struct Parser<'a> {
    file: &'a str,
    lines: Vec<(u64, &'a str)>,
    options: &'a TableOptions,
}

/// Parses an H-representation in the plane.
pub(crate) fn parse_ine(
    file: &str,
    content: &[u8],
    sha256: String,
    options: &TableOptions,
) -> Result<HalfPlaneFile, InputError> {
    if content.starts_with(&[0xff, 0xfe]) || content.starts_with(&[0xfe, 0xff]) {
        return Err(Source::error(file, Place::default(), Problem::Utf16));
    }
    let content = content.strip_prefix(b"\xef\xbb\xbf").unwrap_or(content);
    let text = std::str::from_utf8(content).map_err(|error| {
        let before = &content[..error.valid_up_to()];
        let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count() as u64;
        let start = before.iter().rposition(|&byte| byte == b'\n').map_or(0, |position| position + 1);
        let place = Place { line: Some(line), ..Place::default() };
        Source::error(file, place, Problem::NotUtf8 { position: before.len() - start, unit: "line" })
    })?;
    if text.trim().is_empty() {
        return Err(Source::error(file, Place::default(), Problem::Empty));
    }
    let lines = (1..).zip(text.lines()).collect();
    Parser { file, lines, options }.parse(sha256)
}

impl<'a> Parser<'a> {
    fn parse(&self, sha256: String) -> Result<HalfPlaneFile, InputError> {
        let begin = self.lines.iter().position(|(line, text)| {
            let mut words = words(*line, text);
            words.next().is_some_and(|word| word.text == "begin") && words.next().is_none()
        });
        let Some(begin) = begin else {
            return Err(Source::error(self.file, Place::default(), Problem::NoBegin));
        };
        let (head, body) = self.lines.split_at(begin);
        if let Some(&(line, text)) = head.iter().find(|(_, text)| text.trim() == "V-representation") {
            return Err(self.error(Token { text, line, column: 1 }, Problem::VRepresentation));
        }
        let mut tokens = body[1..].iter().flat_map(|&(line, text)| words(line, text));
        let rows = self.size(&mut tokens, body[0].0)?;
        let numbers = self.numbers(&mut tokens, rows)?;
        let equations = self.equations(head, rows)?;
        // cdd wants it before the matrix; passing over it would change the set.
        if let Some(late) = tokens.find(|token| ["linearity", "equality"].contains(&token.text)) {
            return Err(self.error(late, Problem::BadLinearity));
        }

        let mut system = System::default();
        let mut origins = Vec::new();
        for (index, row) in numbers.chunks_exact(3).enumerate() {
            let [b, minus_a1, minus_a2] = [&row[0], &row[1], &row[2]];
            system.push(Inequality::new(-minus_a1, -minus_a2, b.clone()));
            origins.push(RowOrigin { row: index + 1, reversed: false });
            if equations.contains(&(index + 1)) {
                system.push(Inequality::new(minus_a1.clone(), minus_a2.clone(), -b));
                origins.push(RowOrigin { row: index + 1, reversed: true });
            }
        }
        Ok(HalfPlaneFile { system, origins, rows, sha256 })
    }

    /// The number of rows from the line `rows columns type`.
    fn size(&self, tokens: &mut impl Iterator<Item = Token<'a>>, begin: u64) -> Result<usize, InputError> {
        let nothing = Token { text: "", line: begin, column: 1 };
        let [rows, columns, kind] = [0; 3].map(|_| tokens.next().unwrap_or(nothing));
        let whole = |token: Token<'a>| {
            token.text.parse::<usize>().map_err(|_| self.error(token, Problem::BadSizeLine))
        };
        let (row_count, column_count) = (whole(rows)?, whole(columns)?);
        if column_count != 3 {
            return Err(self.error(columns, Problem::NotThePlane(column_count)));
        }
        match kind.text {
            "integer" | "rational" | "real" => Ok(row_count),
            _ => Err(self.error(kind, Problem::BadSizeLine)),
        }
    }

    /// The numbers up to `end`, which must be three for each row.
    fn numbers(
        &self,
        tokens: &mut impl Iterator<Item = Token<'a>>,
        rows: usize,
    ) -> Result<Vec<Rational>, InputError> {
        let mut numbers = Vec::new();
        for token in tokens {
            let found = numbers.len();
            if token.text == "end" {
                if rows.checked_mul(3) == Some(found) {
                    return Ok(numbers);
                }
                return Err(self.error(token, Problem::CountMismatch { rows, found }));
            }
            let number = self.options.reading.read(token.text, &self.options.limits);
            numbers.push(number.map_err(|error| self.error(token, Problem::NotANumber(error)))?);
        }
        let place = Place { line: self.lines.last().map(|(line, _)| *line), ..Place::default() };
        Err(Source::error(self.file, place, Problem::NoEnd { rows, found: numbers.len() }))
    }

    /// The rows that a line `linearity count row...` makes equations.
    fn equations(&self, head: &[(u64, &'a str)], rows: usize) -> Result<Vec<usize>, InputError> {
        let mut equations = Vec::new();
        for &(line, text) in head {
            let mut tokens = words(line, text);
            if tokens.next().is_none_or(|first| first.text != "linearity" && first.text != "equality") {
                continue;
            }
            let numbers: Option<Vec<usize>> = tokens.map(|token| token.text.parse().ok()).collect();
            match numbers.as_deref() {
                Some([count, listed @ ..])
                    if listed.len() == *count && listed.iter().all(|row| (1..=rows).contains(row)) =>
                {
                    equations.extend_from_slice(listed);
                }
                _ => return Err(self.error(Token { text, line, column: 1 }, Problem::BadLinearity)),
            }
        }
        Ok(equations)
    }

    fn error(&self, token: Token<'a>, problem: Problem) -> InputError {
        let place = Place {
            line: Some(token.line),
            row: None,
            column: Some((token.column, None)),
            text: Some(token.text.to_owned()),
        };
        Source::error(self.file, place, problem)
    }
}

/// The words of a line. A `*` starts a comment.
fn words(line: u64, text: &str) -> impl Iterator<Item = Token<'_>> {
    let text = text.split('*').next().unwrap_or_default();
    text.split_ascii_whitespace().map(move |word| Token {
        text: word,
        line,
        column: 1 + word.as_ptr() as usize - text.as_ptr() as usize,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &str) -> Result<HalfPlaneFile, InputError> {
        parse_ine("test.ine", text.as_bytes(), String::new(), &TableOptions::default())
    }

    #[test]
    fn a_byte_order_mark_and_comments_change_nothing() {
        let plain = "linearity 1 1\nbegin\n2 3 integer\n1 -1 -1\n0 1 0\nend\n";
        let expected = parse(plain).unwrap();
        assert_eq!((expected.system.len(), expected.rows), (3, 2));
        let commented = plain.replace("begin", "begin * the matrix").replace("0 1 0", "0 1 0 * theta1");
        for text in [format!("\u{feff}{plain}"), commented, plain.replace('\n', "\r\n")] {
            let file = parse(&text).unwrap();
            assert_eq!(
                (file.system, file.origins),
                (expected.system.clone(), expected.origins.clone()),
                "{text:?}"
            );
        }
    }
}
