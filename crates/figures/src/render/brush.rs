//! Strokes, fills, marks and texts on the canvas, in pixels of the nominal size.

use plotters::element::{Circle, PathElement, Polygon};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, IntoFont, RGBColor, ShapeStyle, TextStyle, WHITE};

use super::canvas::{Canvas, CanvasResult, FINE};
use super::written::{Align, Pixel, Rectangle, Written};
use crate::palette::{Colour, Dash, Fill, INK, Mark, PAPER, Shape, Stroke};
use crate::text::{FAMILY, drawable};

/// Plotters sizes a font by its line height.
const LINE_HEIGHT: f64 = 1.24;

/// The plate behind labels: lines shine through.
pub(super) const PLATE: Fill = Fill { colour: PAPER, opacity: 0.7 };
/// Length and half the width of the head of an arrow.
const ARROW: [f64; 2] = [9.0, 3.6];
/// The lines of a circle, of a ring and of a cross.
pub(super) const CIRCLE_LINE: f64 = 1.0;
pub(super) const RING_LINE: f64 = 1.8;
pub(super) const CROSS_LINE: f64 = 2.0;

/// The ends of the two strokes of a cross, in radii.
pub(super) const CROSS: [[f64; 2]; 4] = [[-0.8, -0.8], [0.8, 0.8], [-0.8, 0.8], [0.8, -0.8]];

impl Shape {
    /// The corners of a mark that has some, in radii, right and down.
    pub(super) fn corners(self) -> &'static [[f64; 2]] {
        match self {
            Shape::Square => &[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]],
            Shape::Diamond => &[[-1.0, 0.0], [0.0, -1.0], [1.0, 0.0], [0.0, 1.0]],
            Shape::Triangle => &[[-0.95, 0.75], [0.95, 0.75], [0.0, -1.0]],
            Shape::Disc | Shape::Circle | Shape::Ring | Shape::Cross => &[],
        }
    }
}

/// Draws on one canvas.
pub(super) struct Brush<'a, 'b> {
    pub(super) canvas: &'b Canvas<'a>,
}

impl<'a, 'b> Brush<'a, 'b> {
    pub(super) fn new(canvas: &'b Canvas<'a>) -> Self {
        Brush { canvas }
    }

    /// The width of the page.
    pub(super) fn page_width(&self) -> f64 {
        f64::from(self.canvas.dim_in_pixel().0) / FINE
    }

    pub(super) fn line(&self, points: &[Pixel], stroke: Stroke) -> CanvasResult {
        let style = rgb(stroke.colour).stroke_width((stroke.width * FINE).round() as u32);
        for piece in dashes(points, stroke.dash.pattern()) {
            let path: Vec<(i32, i32)> = piece.into_iter().map(fine).collect();
            self.canvas.draw(&PathElement::new(path, style))?;
        }
        Ok(())
    }

    pub(super) fn area(&self, points: &[Pixel], fill: Fill) -> CanvasResult {
        let path: Vec<(i32, i32)> = points.iter().copied().map(fine).collect();
        self.canvas.draw(&Polygon::new(path, rgb(fill.colour).mix(fill.opacity)))
    }

    pub(super) fn mark(&self, at: Pixel, mark: Mark) -> CanvasResult {
        let Mark { shape, radius: r, colour } = mark;
        let around = |corners: &[[f64; 2]]| -> Vec<Pixel> {
            corners.iter().map(|[x, y]| [at[0] + x * r, at[1] + y * r]).collect()
        };
        let solid = Fill { colour, opacity: 1.0 };
        match shape {
            Shape::Disc => self.circle(at, r, rgb(colour).filled()),
            Shape::Circle => {
                self.circle(at, r, WHITE.filled())?;
                self.circle(at, r, rgb(colour).stroke_width((CIRCLE_LINE * FINE) as u32))
            }
            Shape::Ring => self.circle(at, r, rgb(colour).stroke_width((RING_LINE * FINE) as u32)),
            Shape::Square | Shape::Diamond | Shape::Triangle => self.area(&around(shape.corners()), solid),
            Shape::Cross => {
                let stroke = Stroke::new(colour, CROSS_LINE, Dash::Solid);
                let [a, b, c, d] = CROSS;
                self.line(&around(&[a, b]), stroke)?;
                self.line(&around(&[c, d]), stroke)
            }
        }
    }

    fn circle(&self, at: Pixel, radius: f64, style: ShapeStyle) -> CanvasResult {
        self.canvas.draw(&Circle::new(fine(at), (radius * FINE).round() as i32, style))
    }

    /// The head of an arrow, on a line in the same colour.
    pub(super) fn arrow_head(&self, tip: Pixel, direction: Pixel, colour: Colour) -> CanvasResult {
        match arrow_head(direction) {
            Some(corners) => {
                let corners = corners.map(|corner| [tip[0] + corner[0], tip[1] + corner[1]]);
                self.area(&corners, Fill { colour, opacity: 1.0 })
            }
            None => Ok(()),
        }
    }

    /// A text of one line with its middle at the height of a point.
    pub(super) fn text(
        &self,
        at: Pixel,
        text: &str,
        size: f64,
        colour: Colour,
        align: Align,
    ) -> CanvasResult {
        if text.is_empty() {
            return Ok(());
        }
        let horizontal = match align {
            Align::Start => HPos::Left,
            Align::Middle => HPos::Center,
            Align::End => HPos::Right,
        };
        let style = text_style(size, colour).pos(Pos::new(horizontal, VPos::Center));
        self.canvas.draw_text(text, &style, fine(at))
    }

    /// A line of text, on its plate.
    pub(super) fn write(&self, Written { at, text, size, colour, align, plate }: &Written) -> CanvasResult {
        if let Some(Rectangle { left, top, right, bottom }) = *plate {
            let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
            self.area(&corners, PLATE)?;
        }
        self.text(*at, text, *size, *colour, *align)
    }

    /// The width of a text, with a lozenge for each letter that the font lacks.
    pub(super) fn text_width(&self, text: &str, size: f64) -> CanvasResult<f64> {
        let (width, _) = self.canvas.estimate_text_size(&drawable(text), &text_style(size, INK))?;
        Ok(f64::from(width) / FINE)
    }

    /// A text as far as it fits a width; what is cut ends in "…".
    pub(super) fn fitted(&self, text: &str, size: f64, room: f64) -> CanvasResult<String> {
        if self.text_width(text, size)? <= room {
            return Ok(text.to_owned());
        }
        let letters: Vec<char> = text.chars().collect();
        let cut = |kept: usize| -> String {
            let start: String = letters[..kept].iter().collect();
            format!("{}…", start.trim_end())
        };
        // The longest beginning that fits is between these.
        let (mut fits, mut too_long) = (0, letters.len());
        while too_long - fits > 1 {
            let middle = (fits + too_long) / 2;
            if self.text_width(&cut(middle), size)? <= room { fits = middle } else { too_long = middle }
        }
        Ok(cut(fits))
    }

    /// A text in as many lines as it needs at a width, broken between words.
    pub(super) fn wrapped(&self, text: &str, size: f64, room: f64) -> CanvasResult<Vec<String>> {
        let mut lines: Vec<String> = Vec::new();
        for word in text.split(' ') {
            let longer = lines.last().map(|line| format!("{line} {word}"));
            match (longer, lines.last_mut()) {
                (Some(longer), Some(line)) if self.text_width(&longer, size)? <= room => *line = longer,
                _ => lines.push(self.fitted(word, size, room)?),
            }
        }
        Ok(lines)
    }
}

/// The corners of the head of an arrow that points along a direction, seen from its tip; `None` for one that has none.
pub(super) fn arrow_head(direction: Pixel) -> Option<[Pixel; 3]> {
    let length = direction[0].hypot(direction[1]);
    if !(length > 0.0 && length.is_finite()) {
        return None;
    }
    let [x, y] = direction.map(|step| step / length);
    let [back, half] = ARROW;
    let side = |sign: f64| [-back * x - sign * half * y, -back * y + sign * half * x];
    Some([[0.0, 0.0], side(1.0), side(-1.0)])
}

/// The style of a text whose em has `size` nominal pixels.
pub(super) fn text_style(size: f64, colour: Colour) -> TextStyle<'static> {
    (FAMILY, size * LINE_HEIGHT * FINE).into_font().color(&rgb(colour))
}

pub(super) fn rgb(Colour(red, green, blue): Colour) -> RGBColor {
    RGBColor(red, green, blue)
}

fn fine([x, y]: Pixel) -> (i32, i32) {
    ((x * FINE).round() as i32, (y * FINE).round() as i32)
}

/// The drawn pieces of a polyline under a pattern of lengths drawn and left out.
fn dashes(points: &[Pixel], pattern: &[f64]) -> Vec<Vec<Pixel>> {
    let (Some(&first), false) = (points.first(), pattern.is_empty()) else { return vec![points.to_vec()] };
    let mut pieces = Vec::new();
    let (mut phase, mut left) = (0, pattern[0]);
    let mut piece = vec![first];
    for pair in points.windows(2) {
        let step = [pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]];
        let length = step[0].hypot(step[1]);
        let mut done = 0.0;
        while length - done > left {
            done += left;
            let turn = [pair[0][0] + step[0] * done / length, pair[0][1] + step[1] * done / length];
            if phase % 2 == 0 {
                piece.push(turn);
                pieces.push(std::mem::take(&mut piece));
            } else {
                piece = vec![turn];
            }
            phase = (phase + 1) % pattern.len();
            left = pattern[phase];
        }
        left -= length - done;
        if phase % 2 == 0 {
            piece.push(pair[1]);
        }
    }
    if piece.len() > 1 {
        pieces.push(piece);
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pattern_runs_on_around_corners() {
        let corner = [[0.0, 0.0], [5.0, 0.0], [5.0, 5.0]];
        let pieces = dashes(&corner, &[4.0, 2.0]);
        assert_eq!(pieces, vec![vec![[0.0, 0.0], [4.0, 0.0]], vec![[5.0, 1.0], [5.0, 5.0]]]);
        let around = dashes(&corner, &[6.0, 2.0]);
        assert_eq!(around[0], vec![[0.0, 0.0], [5.0, 0.0], [5.0, 1.0]]);
        assert_eq!(dashes(&corner, &[]), vec![corner.to_vec()]);
    }
}
