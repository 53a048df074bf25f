//! The polyhedra files of cdd and lrs (Fukuda, *cddlib Reference Manual*, "Polyhedra H- and V-Formats"; Avis, *lrslib
//! User's Guide*, "File Formats"). An H-representation has a row `b -a1 -a2` for `b - a1·θ1 - a2·θ2 ≥ 0`. A file with
//! a line `V-representation` has generators as in [`super::ext`].
//!
//! Numbers are read exactly, whatever the word `integer`, `rational` or `real` says: cdd and lrs take
//! fractions under `integer` too. Rows on lines `linearity` (or the older `equality`) are equations. Options
//! that only ask for other output are passed over; options that mean another set are refused.

use boundfit_exact::{Rational, WorkMeter};
use boundfit_geometry::{Inequality, System};

use crate::budget::HeldMemory;
use crate::columns::readable;
use crate::error::{InputError, InputErrorKind, Place};
use crate::half_planes::file::{HalfPlaneFile, OF_A_HALF_PLANE, RowOrigin};
use crate::memory_use::MemoryUse;
use crate::table::TableOptions;

use super::ext::from_generators;
use super::words::{MatrixRow, Token, after_unknown_rows, is_line, is_linearity, words, words_of_rest};

/// Options that make the set another one, and what would be accepted in their place. cdd's `partial_enum` means what
/// `linearity` means there, and nothing in lrs.
const OTHER_SETS: [(&str, &str); 8] = [
    ("nonnegative", "rows \"0 1 0\" and \"0 0 1\""),
    ("strict_inequality", "closed half-planes"),
    ("partial_enum", "a line \"linearity COUNT ROW...\" before begin"),
    ("eliminate", "the projected set itself"),
    ("extract", "the set itself"),
    ("project", "the projected set itself"),
    ("projection", "the projected set itself"),
    ("voronoi", "the set itself"),
];

struct Parser<'a> {
    file: &'a str,
    lines: Vec<(u64, &'a str)>,
    options: &'a TableOptions,
    /// The memory of the lines and the rows.
    memory: HeldMemory,
}

/// Parses an H- or V-representation in the plane.
pub(crate) fn parse_cdd(
    file: &str,
    content: &[u8],
    sha256: String,
    options: &TableOptions,
) -> Result<HalfPlaneFile, InputError> {
    if content.starts_with(&[0xff, 0xfe]) || content.starts_with(&[0xfe, 0xff]) {
        return Err(InputError::of_file(file, InputErrorKind::Utf16));
    }
    let content = content.strip_prefix(b"\xef\xbb\xbf").unwrap_or(content);
    let text = std::str::from_utf8(content).map_err(|error| {
        let (before, _) = content.split_at_checked(error.valid_up_to()).unwrap_or((content, &[]));
        let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count() as u64;
        let start = before.iter().rposition(|&byte| byte == b'\n').map_or(0, |position| position + 1);
        let place = Place { line: Some(line), ..Place::default() };
        let position = readable(before.get(start..).unwrap_or_default());
        InputError::new(file, place, InputErrorKind::NotUtf8 { position, unit: "line" })
    })?;
    if text.trim().is_empty() {
        return Err(InputError::of_file(file, InputErrorKind::Empty));
    }
    let memory = options.sizes.memory.nothing();
    let lines = text.lines().count() as u64;
    let asked = memory.ask(lines.saturating_mul(size_of::<(u64, &str)>() as u64), MemoryUse::Text);
    asked.map_err(|problem| InputError::of_file(file, problem))?;
    let lines = (1..).zip(text.lines()).collect();
    Parser { file, lines, options, memory }.parse(sha256)
}

impl<'a> Parser<'a> {
    fn parse(&self, sha256: String) -> Result<HalfPlaneFile, InputError> {
        let begin = self.lines.iter().position(|(line, text)| is_line(*line, text, "begin"));
        let parts = begin.and_then(|begin| self.lines.split_at_checked(begin));
        let Some((head, [(begin, _), body @ ..])) = parts else {
            return Err(InputError::of_file(self.file, InputErrorKind::NoBegin));
        };
        let last = |name: &str| head.iter().rposition(|(line, text)| is_line(*line, text, name));
        let (named_h, named_v) = (last("H-representation"), last("V-representation"));
        let is_v = named_v > named_h;
        // Any words before such a line are the name of the set.
        let options = named_v.max(named_h).and_then(|at| head.get(at..)).unwrap_or(head);
        self.refuse_other_sets(options, is_v)?;

        let (announced, mut tokens) = self.size(body, *begin)?;
        let (mut rows, end) = self.rows(&mut tokens, announced)?;
        let tail = body.iter().position(|(line, _)| *line > end).and_then(|at| body.get(at..));
        let tail = tail.unwrap_or_default();
        // lrs lists rows that it does not write where there is no solution.
        if announced.is_some() || !rows.is_empty() {
            self.mark_linear(head, &mut rows)?;
        }
        self.refuse_late(tail)?;
        self.refuse_other_sets(tail, is_v)?;
        if is_v { from_generators(self.file, &rows, sha256) } else { Ok(from_half_planes(&rows, sha256)) }
    }

    /// The number of rows from the line `rows columns type`, if it is known, and the words after it.
    fn size(
        &self,
        body: &'a [(u64, &'a str)],
        begin: u64,
    ) -> Result<(Option<usize>, impl Iterator<Item = Token<'a>>), InputError> {
        let nothing = Token { text: "", line: begin, column: 1 };
        let is_content = |(line, text): &(u64, &str)| {
            after_unknown_rows(text).is_some() || words(*line, text).next().is_some()
        };
        let first = body.iter().position(is_content).and_then(|at| body.get(at..));
        let Some([(line, text), rest @ ..]) = first else {
            return Err(self.error(nothing, InputErrorKind::BadSizeLine));
        };
        let unknown = after_unknown_rows(text);
        let of_line = words_of_rest(*line, text, unknown.unwrap_or(text));
        let mut tokens = of_line.chain(rest.iter().flat_map(|&(line, text)| words(line, text)));
        let announced = match unknown {
            Some(_) => None,
            None => Some(self.row_count(tokens.next().unwrap_or(nothing))?),
        };
        let [columns, kind] = [0; 2].map(|_| tokens.next().unwrap_or(nothing));
        match columns.text.parse() {
            Ok(3) => {}
            Ok(other) => return Err(self.error(columns, InputErrorKind::NotThePlane(other))),
            Err(_) => return Err(self.error(columns, InputErrorKind::BadSizeLine)),
        }
        match kind.text {
            "integer" | "rational" | "real" => Ok((announced, tokens)),
            _ => Err(self.error(kind, InputErrorKind::BadSizeLine)),
        }
    }

    /// The number of rows announced.
    fn row_count(&self, token: Token<'a>) -> Result<usize, InputError> {
        let limit = self.options.sizes.rows;
        let is_number = !token.text.is_empty() && token.text.bytes().all(|byte| byte.is_ascii_digit());
        match token.text.parse() {
            Ok(rows) if rows <= limit => Ok(rows),
            _ if is_number => Err(self.error(token, InputErrorKind::TooManyRows { limit })),
            _ => Err(self.error(token, InputErrorKind::BadSizeLine)),
        }
    }

    /// The rows up to `end`, and the line of that word.
    fn rows(
        &self,
        tokens: &mut impl Iterator<Item = Token<'a>>,
        announced: Option<usize>,
    ) -> Result<(Vec<MatrixRow<'a>>, u64), InputError> {
        let limit = self.options.sizes.rows;
        let row_cost = self.options.row_cost.max(OF_A_HALF_PLANE);
        let mut rows: Vec<MatrixRow<'a>> = Vec::new();
        let mut pending: Vec<(Token<'a>, Rational)> = Vec::with_capacity(3);
        let meter = WorkMeter::default();
        for token in tokens {
            if token.text == "end" {
                let found = 3 * rows.len() + pending.len();
                return match announced {
                    Some(rows) if rows.checked_mul(3) != Some(found) => {
                        Err(self.error(token, InputErrorKind::CountMismatch { rows, found }))
                    }
                    None if !pending.is_empty() => {
                        Err(self.error(token, InputErrorKind::PartOfARow { found: pending.len() }))
                    }
                    _ => Ok((rows, token.line)),
                };
            }
            let number = self.options.reading.read(token.text, &self.options.limits);
            let number = number.map_err(|error| self.error(token, InputErrorKind::NotANumber(error)))?;
            // Each row is made whole on its own.
            let metered = meter.add(&number, false, self.options.sizes.work);
            metered.map_err(|problem| self.error(token, problem.into()))?;
            pending.push((token, number));
            if pending.len() < 3 {
                continue;
            }
            if rows.len() >= limit {
                return Err(self.error(token, InputErrorKind::TooManyRows { limit }));
            }
            let asked = self.memory.ask(row_cost as u64, MemoryUse::Rows(rows.len() + 1));
            asked.map_err(|problem| InputError::of_file(self.file, problem))?;
            let start = pending.first().map_or(token, |(start, _)| *start);
            let mut numbers = pending.drain(..).map(|(_, number)| number);
            let numbers = [0; 3].map(|_| numbers.next().unwrap_or_default());
            rows.push(MatrixRow { start, numbers, is_linear: false });
        }
        let place = Place { line: self.lines.last().map(|(line, _)| *line), ..Place::default() };
        let found = 3 * rows.len() + pending.len();
        Err(InputError::new(self.file, place, InputErrorKind::NoEnd { rows: announced, found }))
    }

    /// Marks the rows on lines `linearity count row...`.
    fn mark_linear(&self, head: &[(u64, &'a str)], rows: &mut [MatrixRow<'a>]) -> Result<(), InputError> {
        for &(line, text) in head {
            let mut tokens = words(line, text);
            if tokens.next().is_none_or(|first| !is_linearity(first.text)) {
                continue;
            }
            let refused = || self.error(Token { text, line, column: 1 }, InputErrorKind::BadLinearity);
            let numbers: Option<Vec<usize>> = tokens.map(|token| token.text.parse().ok()).collect();
            let Some([count, listed @ ..]) = numbers.as_deref() else { return Err(refused()) };
            if listed.len() != *count {
                return Err(refused());
            }
            for row in listed {
                let row = row.checked_sub(1).and_then(|index| rows.get_mut(index)).ok_or_else(refused)?;
                row.is_linear = true;
            }
        }
        Ok(())
    }

    /// Refuses options that make the set another one.
    fn refuse_other_sets(&self, lines: &[(u64, &'a str)], is_v: bool) -> Result<(), InputError> {
        for first in lines.iter().filter_map(|&(line, text)| words(line, text).next()) {
            let hull = (!is_v).then_some(("hull", "a line \"V-representation\" before begin"));
            let mut refused = OTHER_SETS.iter().copied().chain(hull);
            if let Some((_, instead)) = refused.find(|(name, _)| *name == first.text) {
                return Err(self.error(first, InputErrorKind::OtherSet { instead }));
            }
        }
        Ok(())
    }

    /// Refuses what must stand before the matrix or in a file of its own: passing over it would change the set.
    fn refuse_late(&self, tail: &[(u64, &'a str)]) -> Result<(), InputError> {
        for first in tail.iter().filter_map(|&(line, text)| words(line, text).next()) {
            if is_linearity(first.text) {
                return Err(self.error(first, InputErrorKind::BadLinearity));
            }
            if first.text == "begin" {
                return Err(self.error(first, InputErrorKind::SecondMatrix));
            }
        }
        Ok(())
    }

    fn error(&self, token: Token<'a>, problem: InputErrorKind) -> InputError {
        token.error(self.file, problem)
    }
}

/// The half-planes of rows `b -a1 -a2`; an equation gives two.
fn from_half_planes(rows: &[MatrixRow<'_>], sha256: String) -> HalfPlaneFile {
    let mut system = System::default();
    let mut origins = Vec::new();
    for (row, MatrixRow { numbers: [b, minus_a1, minus_a2], is_linear, .. }) in (1..).zip(rows) {
        system.push(Inequality::new(-minus_a1, -minus_a2, b.clone()));
        origins.push(RowOrigin { row, reversed: false });
        if *is_linear {
            system.push(Inequality::new(minus_a1.clone(), minus_a2.clone(), -b));
            origins.push(RowOrigin { row, reversed: true });
        }
    }
    HalfPlaneFile { system, origins, rows: rows.len(), sha256, generators: None, table: None, layout: None }
}

#[cfg(test)]
mod tests {
    use boundfit_geometry::{Generator, Point};

    use super::*;
    use crate::limits::SizeLimits;

    fn parse_with(text: &str, options: &TableOptions) -> Result<HalfPlaneFile, InputError> {
        parse_cdd("test.ine", text.as_bytes(), String::new(), options)
    }

    fn parse(text: &str) -> Result<HalfPlaneFile, InputError> {
        parse_with(text, &TableOptions::default())
    }

    fn problem(text: &str) -> InputErrorKind {
        parse(text).unwrap_err().kind
    }

    #[test]
    fn a_byte_order_mark_and_comments_change_nothing() {
        let plain = "linearity 1 1\nbegin\n2 3 integer\n1 -1 -1\n0 1 0\nend\n";
        let expected = parse(plain).unwrap();
        assert_eq!((expected.system.len(), expected.rows), (3, 2));
        let commented = plain.replace("begin", "begin * the matrix").replace("0 1 0", "0 1 0 * theta1");
        let starred = plain.replace("2 3", "***\n***** \n2 3").replace("1 -1", "*****\n1 -1");
        for text in [format!("\u{feff}{plain}"), commented, starred, plain.replace('\n', "\r\n")] {
            let file = parse(&text).unwrap();
            assert_eq!(
                (file.system, file.origins),
                (expected.system.clone(), expected.origins.clone()),
                "{text:?}"
            );
        }
    }

    #[test]
    fn an_unknown_number_of_rows_is_what_stands_there() {
        let known = "linearity 1 1\nbegin\n2 3 rational\n1 -1 -1\n0 1 0\nend\n";
        let unknown = parse(&known.replace("2 3", " ***** 3")).unwrap();
        assert_eq!((unknown.system, unknown.rows), (parse(known).unwrap().system, 2));
        let part = parse("begin\n***** 3 rational\n1 -1\nend\n").unwrap_err();
        assert!(matches!(part.kind, InputErrorKind::PartOfARow { found: 2 }), "{part}");
        // lrs's words for the empty set.
        let empty =
            "V-representation\nlinearity 1  1\nbegin\n***** 3 rational\nend\n\nNo feasible solution\n";
        let empty = parse(empty).unwrap();
        assert_eq!((empty.rows, empty.generators.unwrap().generators.is_empty()), (0, true));
    }

    #[test]
    fn the_number_of_rows_is_limited_as_announced_and_as_found() {
        let sizes = SizeLimits { rows: 2, ..SizeLimits::default() };
        let options = TableOptions { sizes, ..TableOptions::default() };
        let rows = "1 1 0\n1 0 1\n1 -1 -1\nend\n";
        for size in ["3", "*****", "99999999999999999999999"] {
            let error = parse_with(&format!("begin\n{size} 3 integer\n{rows}"), &options).unwrap_err();
            assert!(matches!(error.kind, InputErrorKind::TooManyRows { limit: 2 }), "{error}");
        }
        let two = "begin\n2 3 integer\n1 1 0\n1 0 1\nend\n";
        assert_eq!(parse_with(two, &options).unwrap().rows, 2);
    }

    #[test]
    fn options_are_passed_over_unless_they_mean_another_set() {
        let matrix = "begin\n1 3 integer\n1 1 0\nend\n";
        let expected = parse(matrix).unwrap().system;
        for option in ["maximize 0 1 1", "verbose", "incidence", "printcobasis 1", "redund_list 1 1", "hullo"]
        {
            assert_eq!(parse(&format!("{matrix}{option}\n")).unwrap().system, expected, "{option}");
            assert_eq!(parse(&format!("H-representation\n{option}\n{matrix}")).unwrap().system, expected);
        }
        let named = format!("project of a hull\nH-representation\n{matrix}");
        assert_eq!(parse(&named).unwrap().system, expected);
        for option in OTHER_SETS.map(|(name, _)| name).into_iter().chain(["hull"]) {
            for text in [format!("{option} 1 1\n{matrix}"), format!("{matrix}{option}\n")] {
                assert!(matches!(problem(&text), InputErrorKind::OtherSet { .. }), "{text}");
            }
        }
        assert!(parse(&format!("V-representation\n{matrix}hull\n")).is_ok());
        assert!(matches!(
            problem(&format!("{matrix}H-representation\n{matrix}")),
            InputErrorKind::SecondMatrix
        ));
        assert!(matches!(problem(&format!("{matrix}linearity 1 1\n")), InputErrorKind::BadLinearity));
    }

    #[test]
    fn rows_of_a_v_representation_are_points_rays_and_lines() {
        let point = |x: i64, y: i64| Generator::Point(Point::new(&x.into(), &y.into()));
        let text = "V-representation\nlinearity 1 3\nbegin\n5 3 real\n1 2 3.0\n2 1 1/2\n0 2 4\n0 0 0\n0.5 1 -1\nend\n";
        let file = parse(text).unwrap();
        let generators = file.generators.unwrap().generators;
        let [first, _, Generator::Line(line), Generator::Zero, last] = generators.as_slice() else {
            panic!("{generators:?}")
        };
        assert_eq!((first, last), (&point(2, 3), &point(2, -2)));
        assert_eq!((line.dx(), line.dy()), (&1.into(), &2.into()));
        assert!(matches!(problem(&text.replace("0.5", "-0.5")), InputErrorKind::NegativeWeight));
        assert!(matches!(problem(&text.replace("1 3\nbegin", "1 1\nbegin")), InputErrorKind::LinearPoint));
        // Directions alone: cdd and lrs mean the cone with its apex at the origin.
        let cone = parse("V-representation\nbegin\n1 3 integer\n0 1 0\nend\n").unwrap();
        assert_eq!(cone.generators.unwrap().generators.as_slice().get(1), Some(&point(0, 0)));
        assert_eq!(cone.rows, 1);
    }
}
