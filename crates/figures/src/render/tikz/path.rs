//! Paths of TikZ, those of one style that follow each other as one: a thousand commands take LaTeX longer than one of a thousand parts.

use std::fmt::Write;

/// More parts than this are another path: TeX holds one in its memory.
const MOST_PARTS: usize = 150;
/// Points of a path on one line of the source.
const ON_A_LINE: usize = 6;

/// A number as TeX reads it, to a hundred-thousandth.
pub(super) fn number(value: f64) -> String {
    let text = format!("{value:.5}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// A place in the units of where it stands.
pub(super) fn at([first, second]: [f64; 2]) -> String {
    format!("({},{})", number(first), number(second))
}

/// Source that grows.
#[derive(Default)]
pub(super) struct Paths {
    text: String,
    /// The command of the path that is open, and how many parts it has.
    open: Option<(String, usize)>,
}

impl Paths {
    /// The source.
    pub(super) fn finished(mut self) -> String {
        self.end();
        self.text
    }

    /// A comment on what follows.
    pub(super) fn remark(&mut self, text: &str) {
        self.end();
        let text = text.replace(['\n', '\r'], " ");
        let _ = writeln!(self.text, "% {}", text.trim_end_matches([' ', ':']));
    }

    /// Begins a part with units of its own.
    pub(super) fn open(&mut self, options: &str) {
        self.end();
        let _ = writeln!(self.text, "\\begin{{scope}}[{options}]");
    }

    /// Ends it.
    pub(super) fn close(&mut self) {
        self.end();
        self.text.push_str("\\end{scope}\n");
    }

    /// A line through points; one that ends where it begins has no ends. `is_alone`: whether its dashes begin anew, or are none.
    pub(super) fn draw(&mut self, style: &str, points: &[String], is_alone: bool) {
        let is_closed = is_alone && points.len() > 2 && points.first() == points.last();
        let points = if is_closed { points.split_last().map_or(points, |(_, rest)| rest) } else { points };
        let end = if is_closed { " -- cycle" } else { "" };
        self.part(&format!("\\path[{style}]"), &(joined(points, " -- ") + end), true);
    }

    /// A filled area. Translucent areas are paths of their own; otherwise they would be one area where they overlap.
    pub(super) fn fill(&mut self, style: &str, points: &[String], is_opaque: bool) {
        self.part(&format!("\\path[{style}]"), &(joined(points, " -- ") + " -- cycle"), is_opaque);
    }

    /// A filled area with corners beside a place.
    pub(super) fn fill_around(&mut self, style: &str, at: &str, corners: &[String]) {
        let part = format!("{at} {} -- cycle", joined(corners, " -- "));
        self.part(&format!("\\path[{style}]"), &part, true);
    }

    /// A rectangle between opposite corners.
    pub(super) fn rectangle(&mut self, style: &str, [one, other]: &[String; 2], is_joined: bool) {
        self.part(&format!("\\path[{style}]"), &format!("{one} rectangle {other}"), is_joined);
    }

    /// A circle with a radius in points.
    pub(super) fn circle(&mut self, style: &str, at: &str, radius: &str) {
        self.part(
            &format!("\\path[{style}]"),
            &format!("{at} circle[radius={radius}bp]"),
            !style.contains(','),
        );
    }

    /// Two strokes between points beside a place.
    pub(super) fn cross(&mut self, style: &str, at: &str, [a, b, c, d]: &[String; 4]) {
        self.part(&format!("\\path[{style}]"), &format!("{at} {a} -- {b} {c} -- {d}"), true);
    }

    /// A text.
    pub(super) fn node(&mut self, style: &str, at: &str, text: &str) {
        self.end();
        let _ = writeln!(self.text, "\\node[{style}] at {at} {{{text}}};");
    }

    /// Appends to the path that is open, if it is of the same command, or begins another one.
    fn part(&mut self, command: &str, part: &str, is_joined: bool) {
        match &mut self.open {
            Some((own, parts)) if is_joined && own == command && *parts < MOST_PARTS => {
                *parts += 1;
                let _ = write!(self.text, "\n  {part}");
            }
            _ => {
                self.end();
                let _ = write!(self.text, "{command} {part}");
                self.open = Some((command.to_owned(), if is_joined { 1 } else { MOST_PARTS }));
            }
        }
    }

    fn end(&mut self) {
        if self.open.take().is_some() {
            self.text.push_str(";\n");
        }
    }
}

/// Points with something between them, in lines that are not too long for TeX.
fn joined(points: &[String], between: &str) -> String {
    let lines: Vec<String> = points.chunks(ON_A_LINE).map(|line| line.join(between)).collect();
    lines.join(&format!("{}\n   ", between.trim_end()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_those_that_tex_reads() {
        for (value, text) in [(0.5, "0.5"), (-0.0, "0"), (-1e-9, "0"), (1e-5, "0.00001"), (1234.0, "1234")] {
            assert_eq!(number(value), text);
        }
    }

    #[test]
    fn neighbours_of_one_style_are_one_path() {
        let mut paths = Paths::default();
        let line = ["(0,0)", "(1,0)"].map(str::to_owned);
        paths.draw("line 1", &line, true);
        paths.draw("line 1", &line, true);
        paths.draw("line 2", &line, true);
        paths.fill("area 1", &line, false);
        paths.fill("area 1", &line, false);
        let expected = "\\path[line 1] (0,0) -- (1,0)\n  (0,0) -- (1,0);\n\\path[line 2] (0,0) -- (1,0);\n\
                        \\path[area 1] (0,0) -- (1,0) -- cycle;\n\\path[area 1] (0,0) -- (1,0) -- cycle;\n";
        assert_eq!(paths.finished(), expected);
    }
}
