//! The legend: below the panels, where it covers nothing.

use super::brush::{Align, Brush};
use super::canvas::{CanvasResult, MARGIN};
use crate::drawing::{LegendEntry, Swatch};
use crate::palette::{INK, Mark};

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

pub(super) fn draw(brush: &Brush, rows: &[Row], top: f64) -> CanvasResult {
    for (index, row) in rows.iter().enumerate() {
        let middle = top + (index as f64 + 0.5) * ROW;
        for (left, sample, text) in row {
            swatch(brush, *left, middle, sample)?;
            brush.text([left + SWATCH + GAP, middle], text, SIZE, INK, Align::Start)?;
        }
    }
    Ok(())
}

fn swatch(brush: &Brush, left: f64, middle: f64, swatch: &Swatch) -> CanvasResult {
    let (right, centre) = (left + SWATCH, left + SWATCH / 2.0);
    let (top, bottom) = (middle - 6.0, middle + 6.0);
    let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
    if let Some(fill) = swatch.fill {
        brush.area(&corners, fill)?;
    }
    if let Some(edge) = swatch.edge {
        brush.line(&[corners[0], corners[1], corners[2], corners[3], corners[0]], edge)?;
    }
    if let Some(line) = swatch.line {
        brush.line(&[[left, middle], [right, middle]], line)?;
    }
    if let Some(bar) = swatch.bar {
        brush.line(&[[centre, middle - 7.5], [centre, middle + 7.5]], bar)?;
    }
    if let Some(mark) = swatch.mark {
        brush.mark([centre, middle], Mark { ..mark })?;
    }
    Ok(())
}
