//! A figure as source for LaTeX's TikZ. Styles that people change stand once, above. The figure follows below: on the
//! page in pixels to the right and down, in a panel in fractions of its axes. Axes are those of the other formats:
//! pgfplots computes in floats of few digits, and would draw a view of width 1e-12 beside 1e6 as a point.

mod path;
mod styles;

use std::borrow::Cow;
use std::fmt::Write;

use super::brush::{self, CIRCLE_LINE, CROSS_LINE, PLATE, RING_LINE};
use super::panel::{self, LABEL_SIZE, LEFT_LABELS, NAME_SIZE, TICK};
use super::written::{Align, Pixel, Written};
use super::{Look, canvas::CanvasResult, legend, measured, with_scratch};
use crate::clip::Place;
use crate::drawing::{Drawing, Frame, Item, Panel, Swatch};
use crate::error::FigureError;
use crate::palette::{Colour, Dash, FRAME, Fill, GRID, INK, Mark, PAPER, Shape, Stroke};
use crate::tex;
use crate::text::NOTE_OF_MISSING;
use path::Paths;
use styles::Styles;

/// Points of 1/72 inch in a pixel of 1/96.
const POINTS: f64 = 0.75;
const GRID_LINE: Stroke = Stroke::new(GRID, 0.8, Dash::Solid);
const FRAME_LINE: Stroke = Stroke::new(FRAME, 0.9, Dash::Solid);

/// The source of a figure: a picture to be put into a document with `\input`, or a document of one page of its own. Cost: the number
/// of items.
pub(crate) fn source(drawing: &Drawing, look: &Look, is_document: bool) -> Result<String, FigureError> {
    let (body, styles, size) = written(drawing, look).map_err(FigureError::of_canvas)?;
    let [width, height] = size.map(path::number);
    let mut text = String::new();
    let head = match is_document {
        true => "% A figure written by boundfit: a document of its own, for pdflatex.",
        false => {
            "% A figure written by boundfit: \\input it in a document that has \\usepackage{tikz} in its preamble."
        }
    };
    // It has no line end, but a comment must not depend on it.
    let _ = write!(text, "{head}\n% {}\n", drawing.description.replace(['\n', '\r'], " "));
    if is_document {
        let _ = write!(
            text,
            "\\RequirePackage{{fix-cm}}\n\\documentclass{{article}}\n\
             \\usepackage[papersize={{{width}bp,{height}bp}},margin=0bp]{{geometry}}\n\\usepackage{{tikz}}\n\
             \\pagestyle{{empty}}\\parindent=0pt\\topskip=0pt\n\\begin{{document}}\n"
        );
    }
    let step = path::number(POINTS * look.page.scale);
    let _ = write!(
        text,
        "\\begin{{tikzpicture}}[x={step}bp, y=-{step}bp, line join=round,\n  every node/.style={{inner sep=0pt, outer sep=0pt}}]\n"
    );
    text.push_str(&styles.source(&drawing.legend));
    let _ = writeln!(text, "\\useasboundingbox (0bp,0bp) rectangle ({width}bp,-{height}bp);");
    text.push_str(&body);
    text.push_str("\\end{tikzpicture}%\n");
    if is_document {
        text.push_str("\\end{document}\n");
    }
    Ok(text)
}

/// Returns the source of the figure, the styles that it uses, and the size of the picture in points.
fn written(drawing: &Drawing, look: &Look) -> CanvasResult<(String, Styles, [f64; 2])> {
    // The letters of a document are its own.
    let without = |drawing: &Drawing| {
        let mut drawing = drawing.clone();
        drawing.notes.retain(|note| note != NOTE_OF_MISSING);
        drawing
    };
    let has_note = drawing.notes.iter().any(|note| note == NOTE_OF_MISSING);
    let drawing = &if has_note { Cow::Owned(without(drawing)) } else { Cow::Borrowed(drawing) };
    let words = measured(drawing, look.page)?;
    let points = POINTS * look.page.scale;
    let mut writer = Writer { paths: Paths::default(), styles: Styles::new(points, look.greyscale), points };
    let top = words.header();
    words.above().for_each(|line| writer.text(&line));
    for (number, own) in (1..).zip(&drawing.panels) {
        let frame = panel::frame_below(own, top);
        writer.paths.remark(&format!("panel {number}: {}{}", own.heading, own.finding));
        writer.grid(own, frame);
        writer.panel(own, frame);
        with_scratch(look.page, |brush| {
            panel::texts(brush, own, frame)?.iter().for_each(|text| writer.text(text));
            let [_, vertical] = &own.axes;
            let name = brush.fitted(&vertical.name, NAME_SIZE, frame.height)?;
            if own.labelled[1] {
                writer.upright_name(&name, frame);
            }
            Ok(())
        })?;
    }
    writer.paths.remark("legend");
    for (left, middle, swatch, text) in legend::lines(&words.legend, top + drawing.height) {
        writer.swatch(left, middle, swatch);
        writer.text(&text);
    }
    words.below(drawing).for_each(|line| writer.text(&line));
    let size = [look.page.width, words.bottom(drawing)].map(|length| length * points);
    Ok((writer.paths.finished(), writer.styles, size))
}

struct Writer {
    paths: Paths,
    styles: Styles,
    /// Points of 1/72 inch in a nominal pixel.
    points: f64,
}

impl Writer {
    /// Lines at the ticks, the ticks, and their labels.
    fn grid(&mut self, panel: &Panel, frame: Frame) {
        let Frame { left, top, width, height } = frame;
        let bottom = top + height;
        let [across, up] = &panel.axes;
        let columns: Vec<f64> = across.ticks().iter().map(|tick| left + tick.at * width).collect();
        let rows: Vec<f64> = up.ticks().iter().map(|tick| bottom - tick.at * height).collect();
        columns.iter().for_each(|&x| self.segment([x, top], [x, bottom], GRID_LINE));
        rows.iter().for_each(|&y| self.segment([left, y], [left + width, y], GRID_LINE));
        columns.iter().for_each(|&x| self.segment([x, bottom], [x, bottom + TICK], FRAME_LINE));
        rows.iter().for_each(|&y| self.segment([left - TICK, y], [left, y], FRAME_LINE));
        if panel.labelled[0] {
            for (&x, tick) in columns.iter().zip(across.ticks()) {
                self.tick([x, bottom + TICK + 9.0], &tick.label, Align::Middle);
            }
        }
        if panel.labelled[1] {
            for (&y, tick) in rows.iter().zip(up.ticks()) {
                self.tick([left - TICK - 4.0, y], &tick.label, Align::End);
            }
        }
    }

    fn segment(&mut self, from: Pixel, to: Pixel, stroke: Stroke) {
        let style = self.styles.stroke(stroke);
        self.paths.draw(&style, &[path::at(from), path::at(to)], false);
    }

    fn tick(&mut self, at: Pixel, label: &str, align: Align) {
        let (text, size) = (label.to_owned(), LABEL_SIZE);
        self.text(&Written { at, text, size, colour: INK, align, plate: None });
    }

    /// The name of the vertical axis, from below to above.
    fn upright_name(&mut self, name: &str, frame: Frame) {
        if name.is_empty() {
            return;
        }
        let style = self.styles.text(NAME_SIZE, INK);
        let at = path::at([frame.left - LEFT_LABELS + 8.0, frame.top + frame.height / 2.0]);
        self.paths.node(&format!("{style}, rotate=90"), &at, &tex::text(name));
    }

    /// A line of text, on its plate.
    fn text(&mut self, Written { at, text, size, colour, align, plate }: &Written) {
        if text.is_empty() {
            return;
        }
        if let Some(plate) = plate {
            let style = self.styles.fill(PLATE);
            let corners = [[plate.left, plate.top], [plate.right, plate.bottom]].map(path::at);
            self.paths.rectangle(&style, &corners, false);
        }
        let anchor = match align {
            Align::Start => "mid west",
            Align::Middle => "mid",
            Align::End => "mid east",
        };
        let style = self.styles.text(*size, *colour);
        self.paths.node(&format!("{style}, anchor={anchor}"), &path::at(*at), &tex::text(text));
    }

    /// Writes the content of a panel, and its frame.
    fn panel(&mut self, panel: &Panel, frame: Frame) {
        let bottom = path::at([frame.left, frame.top + frame.height]);
        let [width, height] = [frame.width, frame.height].map(|length| path::number(length * self.points));
        self.paths.open(&format!("shift={{{bottom}}}, x={width}bp, y={height}bp"));
        for item in &panel.items {
            self.item(item, frame);
        }
        let style = self.styles.stroke(FRAME_LINE);
        self.paths.rectangle(&style, &[[0.0, 0.0], [1.0, 1.0]].map(path::at), false);
        self.paths.close();
    }

    fn item(&mut self, item: &Item, frame: Frame) {
        let places = |points: &[Place]| points.iter().copied().map(path::at).collect::<Vec<_>>();
        match item {
            Item::Area { outline, fill } => {
                let style = self.styles.fill(*fill);
                self.paths.fill(&style, &places(outline), fill.opacity >= 1.0);
            }
            Item::Line { points, stroke } => {
                let style = self.styles.stroke(*stroke);
                self.paths.draw(&style, &places(points), true);
            }
            Item::Mark { at, mark } => self.mark(&path::at(*at), *mark),
            Item::ArrowHead { tip, direction, colour } => {
                let down = [direction[0] * frame.width, -direction[1] * frame.height];
                if let Some(corners) = brush::arrow_head(down) {
                    self.corners(&path::at(*tip), &corners, *colour);
                }
            }
            // Texts are placed when all else is known.
            Item::Text { .. } => {}
        }
    }

    /// A filled area with corners so many pixels from a place.
    fn corners(&mut self, at: &str, corners: &[Pixel], colour: Colour) {
        let style = self.styles.fill(Fill { colour, opacity: 1.0 });
        let corners: Vec<String> = corners.iter().map(|corner| self.beside(*corner)).collect();
        self.paths.fill_around(&style, at, &corners);
    }

    /// A point so many pixels from another one.
    fn beside(&self, [right, down]: Pixel) -> String {
        let [right, up] = [right, -down].map(|length| path::number(length * self.points));
        format!("+({right}bp,{up}bp)")
    }

    fn mark(&mut self, at: &str, Mark { shape, radius, colour }: Mark) {
        let line = |width: f64| Stroke::new(colour, width, Dash::Solid);
        let size = path::number(radius * self.points);
        match shape {
            Shape::Disc => {
                let style = self.styles.fill(Fill { colour, opacity: 1.0 });
                self.paths.circle(&style, at, &size);
            }
            Shape::Circle => {
                let inside = self.styles.fill(Fill { colour: PAPER, opacity: 1.0 });
                let style = format!("{inside}, {}", self.styles.stroke(line(CIRCLE_LINE)));
                self.paths.circle(&style, at, &size);
            }
            Shape::Ring => {
                let style = self.styles.stroke(line(RING_LINE));
                self.paths.circle(&style, at, &size);
            }
            Shape::Square | Shape::Diamond | Shape::Triangle => {
                let corners: Vec<Pixel> = shape.corners().iter().map(|c| c.map(|c| c * radius)).collect();
                self.corners(at, &corners, colour);
            }
            Shape::Cross => {
                let style = self.styles.stroke(line(CROSS_LINE));
                let ends = brush::CROSS.map(|end| self.beside(end.map(|c| c * radius)));
                self.paths.cross(&style, at, &ends);
            }
        }
    }

    /// The sample beside a text of the legend.
    fn swatch(&mut self, left: f64, middle: f64, swatch: &Swatch) {
        let corners = legend::corners(left, middle);
        let opposite = [corners[0], corners[2]].map(path::at);
        if let Some(fill) = swatch.fill {
            let style = self.styles.fill(fill);
            self.paths.rectangle(&style, &opposite, false);
        }
        if let Some(edge) = swatch.edge {
            let style = self.styles.stroke(edge);
            self.paths.rectangle(&style, &opposite, false);
        }
        if let Some(line) = swatch.line {
            let [from, to] = legend::line(left, middle);
            self.segment(from, to, line);
        }
        if let Some(bar) = swatch.bar {
            let [from, to] = legend::bar(left, middle);
            self.segment(from, to, bar);
        }
        if let Some(mark) = swatch.mark {
            self.mark(&path::at(legend::centre(left, middle)), mark);
        }
    }
}
