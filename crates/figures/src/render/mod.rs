//! Drawing a [`Drawing`] with plotters.

mod brush;
mod canvas;
mod legend;
mod panel;
mod placing;

pub(crate) use canvas::WIDTH;
pub(crate) use panel::{BOTTOM_LABELS, LEFT_LABELS};

use plotters::drawing::DrawingAreaErrorKind;
use plotters::prelude::{IntoDrawingArea, SVGBackend};
use plotters::style::WHITE;

use crate::drawing::Drawing;
use crate::palette::{Colour, FAINT_INK, INK};
use crate::picture::{FigureError, Picture};
use crate::text;
use brush::{Align, Brush};
use canvas::{Canvas, CanvasResult, FINE, MARGIN};

/// Height of title and subtitle.
const HEADER: f64 = 52.0;
/// Height of a line of notes.
const NOTE_LINE: f64 = 17.0;
/// Letters of subtitle and notes.
const NOTE_SIZE: f64 = 11.5;

/// How large a picture is, and in which colours.
#[derive(Debug, Clone, Default)]
pub(crate) struct Look {
    /// In micrometres.
    pub(crate) width: Option<u32>,
    pub(crate) greyscale: bool,
}

/// Micrometres in a nominal pixel: 96 to an inch.
const PIXEL: f64 = 25_400.0 / 96.0;

/// Draws a figure. Cost: the number of items.
pub(crate) fn render(drawing: &Drawing) -> Result<Picture, FigureError> {
    render_as(drawing, &Look::default())
}

/// Draws a figure of some size and colours.
pub(crate) fn render_as(drawing: &Drawing, look: &Look) -> Result<Picture, FigureError> {
    text::register();
    let fail = |error: DrawingAreaErrorKind<std::io::Error>| FigureError(error.to_string());
    let (rows, notes) = measured(drawing).map_err(fail)?;
    let notes_top = header(drawing) + drawing.height + legend::height(rows.len());
    let height = notes_top + notes.len() as f64 * NOTE_LINE + MARGIN * 0.7;
    let size = [WIDTH, height].map(|length| (length * FINE).round() as u32);
    let mut svg = String::new();
    let canvas = SVGBackend::with_string(&mut svg, (size[0], size[1])).into_drawing_area();
    draw(&canvas, drawing, &rows, (&notes, notes_top)).map_err(fail)?;
    drop(canvas);
    // The view box keeps the canvas's own units, so that a smaller size scales everything. Plotters has no setting for it.
    let large = format!("width=\"{}\" height=\"{}\"", size[0], size[1]);
    let width = look.width.map_or(WIDTH, |width| f64::from(width) / PIXEL);
    let nominal = format!("width=\"{width}\" height=\"{}\"", f64::from(size[1]) / FINE * width / WIDTH);
    let svg = svg.replacen(&large, &nominal, 1);
    let svg = if look.greyscale { in_greys(&svg) } else { svg };
    Picture::new(&svg, drawing.title.clone(), drawing.description.clone())
}

/// Height of what stands above the panels.
fn header(drawing: &Drawing) -> f64 {
    if drawing.title.is_empty() && drawing.subtitle.is_empty() { 4.0 } else { HEADER }
}

/// A document with each colour as the grey that is as light (Rec. 709).
fn in_greys(svg: &str) -> String {
    let mut parts = svg.split("=\"#");
    let mut grey = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        grey.push_str("=\"#");
        let byte = |at: usize| u32::from_str_radix(part.get(at..at + 2)?, 16).ok();
        match (byte(0), byte(2), byte(4), part.get(6..)) {
            (Some(red), Some(green), Some(blue), Some(rest)) => {
                let light = (2126 * red + 7152 * green + 722 * blue + 5000) / 10_000;
                grey.push_str(&format!("{light:02X}{light:02X}{light:02X}{rest}"));
            }
            _ => grey.push_str(part),
        }
    }
    grey
}

/// The rows of the legend and the lines of the notes, as long as there is room.
fn measured(drawing: &Drawing) -> CanvasResult<(Vec<legend::Row<'_>>, Vec<String>)> {
    // Measuring needs a canvas, but nothing is drawn on this one.
    let mut scratch = String::new();
    let canvas = SVGBackend::with_string(&mut scratch, (1, 1)).into_drawing_area();
    let brush = Brush::new(&canvas);
    let rows = legend::layout(&brush, &drawing.legend)?;
    let mut lines = Vec::new();
    for note in &drawing.notes {
        lines.extend(brush.wrapped(note, NOTE_SIZE, WIDTH - 2.0 * MARGIN)?);
    }
    Ok((rows, lines))
}

fn draw(
    canvas: &Canvas,
    drawing: &Drawing,
    rows: &[legend::Row],
    (notes, notes_top): (&[String], f64),
) -> CanvasResult {
    canvas.fill(&WHITE)?;
    let brush = Brush::new(canvas);
    let top = header(drawing);
    let header = |text: &str, middle: f64, size: f64, colour: Colour| {
        let text = brush.fitted(text, size, WIDTH - 2.0 * MARGIN)?;
        brush.text([MARGIN, middle], &text, size, colour, Align::Start)
    };
    header(&drawing.title, 19.0, 15.5, INK)?;
    header(&drawing.subtitle, 39.0, NOTE_SIZE, FAINT_INK)?;
    for panel in &drawing.panels {
        panel::draw(&brush, panel, top)?;
    }
    legend::draw(&brush, rows, top + drawing.height)?;
    for (index, note) in notes.iter().enumerate() {
        let middle = notes_top + (index as f64 + 0.5) * NOTE_LINE;
        brush.text([MARGIN, middle], note, NOTE_SIZE, FAINT_INK, Align::Start)?;
    }
    canvas.present()
}
