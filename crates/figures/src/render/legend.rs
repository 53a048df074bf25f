//! The legend: below the panels, where it covers nothing.

use super::brush::Brush;
use super::canvas::{CanvasResult, MARGIN};
use super::written::{Align, Pixel, Written};
use crate::drawing::{LegendEntry, Swatch};
use crate::palette::INK;

const SIZE: f64 = 12.0;
const ROW: f64 = 20.0;
const SWATCH: f64 = 26.0;
const GAP: f64 = 6.0;
const BETWEEN: f64 = 20.0;

/// Entries side by side, each with its distance from the left.
pub(super) type Row<'a> = Vec<(f64, &'a Swatch, String)>;

/// Fills rows from left to right.
pub(super) fn layout<'a>(brush: &Brush, entries: &'a [LegendEntry]) -> CanvasResult<Vec<Row<'a>>> {
    let mut rows: Vec<Row> = Vec::new();
    let page = brush.page_width();
    let mut left = page;
    for entry in entries {
        let lines = brush.wrapped(&entry.text, SIZE, page - 2.0 * MARGIN - SWATCH - GAP)?;
        for (index, text) in lines.into_iter().enumerate() {
            let width = SWATCH + GAP + brush.text_width(&text, SIZE)?;
            if index > 0 || left + width > page - MARGIN {
                rows.push(Vec::new());
                left = MARGIN;
            }
            let swatch = if index == 0 { &entry.swatch } else { &Swatch::NOTHING };
            if let Some(row) = rows.last_mut() {
                row.push((left, swatch, text));
            }
            left += width + BETWEEN;
        }
    }
    Ok(rows)
}

/// Height of this many rows, with the distance to what follows.
pub(super) fn height(rows: usize) -> f64 {
    rows as f64 * ROW + 4.0
}

/// Each sample of these rows, from its left end and its middle line, with the text beside it.
pub(super) fn lines<'a, 'b>(
    rows: &'b [Row<'a>],
    top: f64,
) -> impl Iterator<Item = (f64, f64, &'a Swatch, Written)> + use<'a, 'b> {
    rows.iter().enumerate().flat_map(move |(index, row)| {
        let middle = top + (index as f64 + 0.5) * ROW;
        row.iter().map(move |(left, sample, text)| {
            let (at, text) = ([left + SWATCH + GAP, middle], text.clone());
            let text = Written { at, text, size: SIZE, colour: INK, align: Align::Start, plate: None };
            (*left, middle, *sample, text)
        })
    })
}

pub(super) fn draw(brush: &Brush, rows: &[Row], top: f64) -> CanvasResult {
    for (left, middle, sample, text) in lines(rows, top) {
        swatch(brush, left, middle, sample)?;
        brush.write(&text)?;
    }
    Ok(())
}

/// The corners of a sample of an area.
pub(super) fn corners(left: f64, middle: f64) -> [Pixel; 4] {
    let (right, top, bottom) = (left + SWATCH, middle - 6.0, middle + 6.0);
    [[left, top], [right, top], [right, bottom], [left, bottom]]
}

/// The ends of a sample of a line.
pub(super) fn line(left: f64, middle: f64) -> [Pixel; 2] {
    [[left, middle], [left + SWATCH, middle]]
}

/// The ends of a sample of an error bar.
pub(super) fn bar(left: f64, middle: f64) -> [Pixel; 2] {
    let [centre, _] = self::centre(left, middle);
    [[centre, middle - 7.5], [centre, middle + 7.5]]
}

/// Returns the place of a sample of a mark.
pub(super) fn centre(left: f64, middle: f64) -> Pixel {
    [left + SWATCH / 2.0, middle]
}

fn swatch(brush: &Brush, left: f64, middle: f64, swatch: &Swatch) -> CanvasResult {
    let corners = corners(left, middle);
    if let Some(fill) = swatch.fill {
        brush.area(&corners, fill)?;
    }
    if let Some(edge) = swatch.edge {
        brush.line(&[corners[0], corners[1], corners[2], corners[3], corners[0]], edge)?;
    }
    if let Some(line) = swatch.line {
        brush.line(&self::line(left, middle), line)?;
    }
    if let Some(bar) = swatch.bar {
        brush.line(&self::bar(left, middle), bar)?;
    }
    if let Some(mark) = swatch.mark {
        brush.mark(centre(left, middle), mark)?;
    }
    Ok(())
}
