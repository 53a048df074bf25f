//! Drawing a [`Drawing`] with plotters.

mod brush;
mod canvas;
mod legend;
mod panel;
mod placing;
#[cfg(feature = "tikz")]
mod tikz;
mod written;

pub(crate) use panel::{BOTTOM_LABELS, LEFT_LABELS};
#[cfg(feature = "tikz")]
pub(crate) use tikz::source;

use plotters::prelude::{IntoDrawingArea, SVGBackend};
use plotters::style::WHITE;

use crate::drawing::Drawing;
use crate::error::FigureError;
use crate::page::Page;
use crate::palette::{Colour, FAINT_INK, INK};
use crate::text;
use brush::Brush;
use canvas::{Canvas, CanvasResult, FINE, MARGIN};
use written::{Align, Written};

/// Height of title and subtitle of one line each.
const HEADER: f64 = 52.0;
/// Letters of the title, and height of a line of it.
const TITLE_SIZE: f64 = 15.5;
const TITLE_LINE: f64 = 20.0;
/// Height of a line of notes.
const NOTE_LINE: f64 = 17.0;
/// Letters of subtitle and notes.
const NOTE_SIZE: f64 = 11.5;

/// The size of a picture, and its colours.
#[derive(Debug, Clone)]
pub(crate) struct Look {
    pub(crate) page: Page,
    pub(crate) greyscale: bool,
}

/// The SVG of a figure of some size and colours. Cost: the number of items.
pub(crate) fn svg(drawing: &Drawing, look: &Look) -> Result<String, FigureError> {
    text::register();
    let (svg, size) = document(drawing, look.page).map_err(FigureError::of_canvas)?;
    // The view box keeps the canvas's own units, so that a smaller size scales everything. Plotters has no setting for it.
    let large = format!("width=\"{}\" height=\"{}\"", size[0], size[1]);
    let [width, height] = size.map(|length| f64::from(length) / FINE * look.page.scale);
    let nominal = format!("width=\"{width}\" height=\"{height}\"");
    let svg = svg.replacen(&large, &nominal, 1);
    Ok(if look.greyscale { in_greys(&svg) } else { svg })
}

/// The document in units of the canvas, and its width and height.
fn document(drawing: &Drawing, page: Page) -> CanvasResult<(String, [u32; 2])> {
    let words = measured(drawing, page)?;
    let size = [page.width, words.bottom(drawing)].map(|length| (length * FINE).round() as u32);
    let mut svg = String::new();
    let canvas = SVGBackend::with_string(&mut svg, (size[0], size[1])).into_drawing_area();
    draw(&canvas, drawing, &words)?;
    drop(canvas);
    Ok((svg, size))
}

/// A canvas as wide as a page, to measure texts on.
fn with_scratch<T>(page: Page, measure: impl FnOnce(&Brush) -> CanvasResult<T>) -> CanvasResult<T> {
    let mut scratch = String::new();
    let canvas =
        SVGBackend::with_string(&mut scratch, ((page.width * FINE).round() as u32, 1)).into_drawing_area();
    measure(&Brush::new(&canvas))
}

/// The text around the panels, in lines that have room.
struct Words<'a> {
    title: Vec<String>,
    subtitle: Vec<String>,
    legend: Vec<legend::Row<'a>>,
    notes: Vec<String>,
}

impl Words<'_> {
    /// Height of what stands above the panels.
    fn header(&self) -> f64 {
        if self.title.is_empty() && self.subtitle.is_empty() {
            return 4.0;
        }
        self.below_title() + self.subtitle.len().saturating_sub(1) as f64 * NOTE_LINE + HEADER
    }

    /// Returns the distance by which a title of several lines moves everything below it.
    fn below_title(&self) -> f64 {
        self.title.len().saturating_sub(1) as f64 * TITLE_LINE
    }

    /// Returns the place where notes begin.
    fn notes_top(&self, drawing: &Drawing) -> f64 {
        self.header() + drawing.height + legend::height(self.legend.len())
    }

    /// The height of the picture.
    fn bottom(&self, drawing: &Drawing) -> f64 {
        self.notes_top(drawing) + self.notes.len() as f64 * NOTE_LINE + MARGIN * 0.7
    }

    /// The lines of title and subtitle.
    fn above(&self) -> impl Iterator<Item = Written> {
        let subtitle = 39.0 + self.below_title();
        lines(&self.title, 19.0, TITLE_LINE, (TITLE_SIZE, INK)).chain(lines(
            &self.subtitle,
            subtitle,
            NOTE_LINE,
            (NOTE_SIZE, FAINT_INK),
        ))
    }

    /// The lines of notes.
    fn below(&self, drawing: &Drawing) -> impl Iterator<Item = Written> {
        let first = self.notes_top(drawing) + 0.5 * NOTE_LINE;
        lines(&self.notes, first, NOTE_LINE, (NOTE_SIZE, FAINT_INK))
    }
}

/// Lines below each other at the left edge.
fn lines(
    lines: &[String],
    first: f64,
    step: f64,
    (size, colour): (f64, Colour),
) -> impl Iterator<Item = Written> {
    lines.iter().enumerate().map(move |(index, line)| Written {
        at: [MARGIN, first + index as f64 * step],
        text: line.clone(),
        size,
        colour,
        align: Align::Start,
        plate: None,
    })
}

/// A document with each colour as a grey.
fn in_greys(svg: &str) -> String {
    let mut parts = svg.split("=\"#");
    let mut grey = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        grey.push_str("=\"#");
        let byte = |at: usize| u8::from_str_radix(part.get(at..at + 2)?, 16).ok();
        match (byte(0), byte(2), byte(4), part.get(6..)) {
            (Some(red), Some(green), Some(blue), Some(rest)) => {
                let Colour(light, ..) = Colour(red, green, blue).grey();
                grey.push_str(&format!("{light:02X}{light:02X}{light:02X}{rest}"));
            }
            _ => grey.push_str(part),
        }
    }
    grey
}

/// Cuts what stands around the panels into lines.
fn measured(drawing: &Drawing, page: Page) -> CanvasResult<Words<'_>> {
    with_scratch(page, |brush| {
        let lines = |text: &str, size: f64| match text.is_empty() {
            true => Ok(Vec::new()),
            false => brush.wrapped(text, size, brush.page_width() - 2.0 * MARGIN),
        };
        let [title, subtitle] = [lines(&drawing.title, TITLE_SIZE)?, lines(&drawing.subtitle, NOTE_SIZE)?];
        let mut notes = Vec::new();
        for note in &drawing.notes {
            notes.extend(lines(note, NOTE_SIZE)?);
        }
        Ok(Words { title, subtitle, legend: legend::layout(brush, &drawing.legend)?, notes })
    })
}

fn draw(canvas: &Canvas, drawing: &Drawing, words: &Words) -> CanvasResult {
    canvas.fill(&WHITE)?;
    let brush = Brush::new(canvas);
    let top = words.header();
    words.above().try_for_each(|line| brush.write(&line))?;
    for panel in &drawing.panels {
        panel::draw(&brush, panel, top)?;
    }
    legend::draw(&brush, &words.legend, top + drawing.height)?;
    words.below(drawing).try_for_each(|line| brush.write(&line))?;
    canvas.present()
}
