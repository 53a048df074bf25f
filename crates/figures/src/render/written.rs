//! Lines of text on a picture, and where things stand.

use crate::palette::Colour;

/// Half the height of a label.
pub(super) const HALF_LINE: f64 = 7.0;

/// A point on the canvas: right and down.
pub(super) type Pixel = [f64; 2];

/// The part of a text that stands at its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Align {
    Start,
    Middle,
    End,
}

/// A rectangle on the canvas.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rectangle {
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) right: f64,
    pub(super) bottom: f64,
}

impl Rectangle {
    /// The rectangle of a text of one line from its left end and middle line.
    pub(super) fn of_text([left, middle]: Pixel, width: f64) -> Self {
        Rectangle { left, top: middle - HALF_LINE, right: left + width, bottom: middle + HALF_LINE }
    }

    /// The rectangle around a mark.
    pub(super) fn around([x, y]: Pixel, radius: f64) -> Self {
        Rectangle { left: x - radius, top: y - radius, right: x + radius, bottom: y + radius }
    }

    /// Returns whether they have more than an edge in common.
    pub(super) fn overlaps(&self, other: &Rectangle) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }
}

/// A line of text on the picture.
pub(super) struct Written {
    /// The left end, middle or right end of the text, as it is aligned, at half its height.
    pub(super) at: Pixel,
    pub(super) text: String,
    pub(super) size: f64,
    pub(super) colour: Colour,
    pub(super) align: Align,
    /// The plate under a label within the drawing.
    pub(super) plate: Option<Rectangle>,
}
