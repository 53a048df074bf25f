//! Drawing a [`Drawing`] with plotters.

mod brush;
mod canvas;
mod legend;
mod panel;

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

/// Draws a figure. Cost: the number of items.
pub(crate) fn render(drawing: &Drawing) -> Result<Picture, FigureError> {
    text::register();
    let fail = |error: DrawingAreaErrorKind<std::io::Error>| FigureError(error.to_string());
    let (rows, notes) = measured(drawing).map_err(fail)?;
    let notes_top = HEADER + drawing.height + legend::height(rows.len());
    let height = notes_top + notes.len() as f64 * NOTE_LINE + MARGIN * 0.7;
    let size = [WIDTH, height].map(|length| (length * FINE).round() as u32);
    let mut svg = String::new();
    let canvas = SVGBackend::with_string(&mut svg, (size[0], size[1])).into_drawing_area();
    draw(&canvas, drawing, &rows, (&notes, notes_top)).map_err(fail)?;
    drop(canvas);
    // The view box keeps the canvas's own units, so that a smaller size scales everything. Plotters has no setting for it.
    let large = format!("width=\"{}\" height=\"{}\"", size[0], size[1]);
    let nominal = format!("width=\"{WIDTH}\" height=\"{}\"", f64::from(size[1]) / FINE);
    let svg = svg.replacen(&large, &nominal, 1);
    Picture::new(&svg, drawing.title.clone(), drawing.description.clone())
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
    let header = |text: &str, middle: f64, size: f64, colour: Colour| {
        let text = brush.fitted(text, size, WIDTH - 2.0 * MARGIN)?;
        brush.text([MARGIN, middle], &text, size, colour, Align::Start)
    };
    header(&drawing.title, 19.0, 15.5, INK)?;
    header(&drawing.subtitle, 39.0, NOTE_SIZE, FAINT_INK)?;
    for panel in &drawing.panels {
        panel::draw(&brush, panel, HEADER)?;
    }
    legend::draw(&brush, rows, HEADER + drawing.height)?;
    for (index, note) in notes.iter().enumerate() {
        let middle = notes_top + (index as f64 + 0.5) * NOTE_LINE;
        brush.text([MARGIN, middle], note, NOTE_SIZE, FAINT_INK, Align::Start)?;
    }
    canvas.present()
}
