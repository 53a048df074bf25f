//! Styles by name: what a line, an area or a text looks like.

use std::fmt::Write;

use super::path::number;
use crate::drawing::LegendEntry;
use crate::palette::{
    BLUE, Colour, DARK_PURPLE, FAINT_INK, FRAME, Fill, GREEN, GREY, GRID, INK, LIGHT_GREY, ORANGE, PAPER,
    PURPLE, SKY, Stroke, VERMILLION,
};

/// Colours by name in source that people read; there are many more greys.
const NAMES: [(Colour, &str); 14] = [
    (PAPER, "paper"),
    (INK, "ink"),
    (FAINT_INK, "faint ink"),
    (GRID, "grid"),
    (FRAME, "frame"),
    (GREY, "grey"),
    (LIGHT_GREY, "light grey"),
    (ORANGE, "orange"),
    (SKY, "sky"),
    (GREEN, "green"),
    (BLUE, "blue"),
    (VERMILLION, "vermillion"),
    (PURPLE, "purple"),
    (DARK_PURPLE, "dark purple"),
];

/// The ratio of the distance of lines, of which there is one, to the size of letters.
const LEADING: f64 = 1.2;

/// The styles of a figure so far, each kind in the order in which it was asked for.
pub(super) struct Styles {
    /// Points of 1/72 inch in a nominal pixel.
    points: f64,
    greyscale: bool,
    strokes: Vec<Stroke>,
    fills: Vec<Fill>,
    texts: Vec<(f64, Colour)>,
}

impl Styles {
    pub(super) fn new(points: f64, greyscale: bool) -> Self {
        Styles { points, greyscale, strokes: Vec::new(), fills: Vec::new(), texts: Vec::new() }
    }

    /// The name of the style of a line.
    pub(super) fn stroke(&mut self, stroke: Stroke) -> String {
        format!("line {}", place_in(&mut self.strokes, stroke))
    }

    /// The name of the style of an area.
    pub(super) fn fill(&mut self, fill: Fill) -> String {
        format!("area {}", place_in(&mut self.fills, fill))
    }

    /// The name of the style of letters.
    pub(super) fn text(&mut self, size: f64, colour: Colour) -> String {
        format!("text {}", place_in(&mut self.texts, (size, colour)))
    }

    /// The definitions of colours and styles, with what each stands for in the legend.
    pub(super) fn source(&self, legend: &[LegendEntry]) -> String {
        let mut source = String::new();
        let mut colours: Vec<Colour> = Vec::new();
        let strokes = self.strokes.iter().map(|stroke| stroke.colour);
        let fills = self.fills.iter().map(|fill| fill.colour);
        for colour in strokes.chain(fills).chain(self.texts.iter().map(|(_, colour)| *colour)) {
            place_in(&mut colours, colour);
        }
        for &colour in &colours {
            let Colour(red, green, blue) = if self.greyscale { colour.grey() } else { colour };
            let name = name(colour);
            let _ = writeln!(source, "\\definecolor{{{name}}}{{HTML}}{{{red:02X}{green:02X}{blue:02X}}}");
        }
        source.push_str("\\tikzset{\n");
        for (index, stroke) in (1..).zip(&self.strokes) {
            let meaning = meaning(legend, |entry| {
                [entry.swatch.edge, entry.swatch.line, entry.swatch.bar].contains(&Some(*stroke))
            });
            let _ = writeln!(source, "  line {index}/.style={{{}}},{meaning}", self.of_line(stroke));
        }
        for (index, Fill { colour, opacity }) in (1..).zip(&self.fills) {
            let meaning = meaning(legend, |entry| {
                entry.swatch.fill == Some(Fill { colour: *colour, opacity: *opacity })
            });
            let opacity = match *opacity < 1.0 {
                true => format!(", fill opacity={}", number(*opacity)),
                false => String::new(),
            };
            let _ = writeln!(source, "  area {index}/.style={{fill={}{opacity}}},{meaning}", name(*colour));
        }
        for (index, (size, colour)) in (1..).zip(&self.texts) {
            // In TeX's points, of which an inch has 72.27.
            let points = size * self.points * 72.27 / 72.0;
            let [size, line] = [points, points * LEADING].map(|length| format!("{length:.2}pt"));
            let font = format!("\\fontsize{{{size}}}{{{line}}}\\selectfont");
            let _ = writeln!(source, "  text {index}/.style={{font={font}, text={}}},", name(*colour));
        }
        source.push_str("}\n");
        source
    }

    fn of_line(&self, stroke: &Stroke) -> String {
        let width = number(stroke.width * self.points);
        let mut style = format!("draw={}, line width={width}bp", name(stroke.colour));
        let pattern = stroke.dash.pattern();
        if !pattern.is_empty() {
            style.push_str(", dash pattern=");
            for (index, length) in pattern.iter().enumerate() {
                let word = if index % 2 == 0 { "on" } else { " off" };
                let gap = if index > 0 && index % 2 == 0 { " " } else { "" };
                let _ = write!(style, "{gap}{word} {}bp", number(length * self.points));
            }
        }
        style
    }
}

/// Returns the legend's text about a style, as a comment.
fn meaning(legend: &[LegendEntry], is_of: impl Fn(&LegendEntry) -> bool) -> String {
    let entry = legend.iter().find(|entry| is_of(entry));
    entry.map(|entry| format!(" % {}", entry.text.replace(['\n', '\r'], " "))).unwrap_or_default()
}

/// The name of a colour, which no other package has.
fn name(colour: Colour) -> String {
    let Colour(red, green, blue) = colour;
    match NAMES.iter().find(|(own, _)| *own == colour) {
        Some((_, name)) => format!("boundfit {name}"),
        None => format!("boundfit {red:02x}{green:02x}{blue:02x}"),
    }
}

/// The place of something among others from 1, to which it is appended where it is new.
fn place_in<T: PartialEq>(all: &mut Vec<T>, wanted: T) -> usize {
    match all.iter().position(|own| *own == wanted) {
        Some(place) => place + 1,
        None => {
            all.push(wanted);
            all.len()
        }
    }
}
