//! A figure as a list of what is on it, before anything is drawn.

use boundfit_exact::Rational;

use crate::axis::Axis;
use crate::clip::{self, Place};
use crate::palette::{Colour, Dash, Fill, Mark, Stroke};

/// A figure, ready to be drawn.
#[derive(Debug, Clone)]
pub(crate) struct Drawing {
    /// The line above everything.
    pub(crate) title: String,
    /// Smaller, below the title.
    pub(crate) subtitle: String,
    /// The content in full sentences, for people who cannot see it.
    pub(crate) description: String,
    pub(crate) panels: Vec<Panel>,
    /// The top of the legend, in pixels of the nominal size below the header.
    pub(crate) height: f64,
    pub(crate) legend: Vec<LegendEntry>,
    /// Remarks below the legend.
    pub(crate) notes: Vec<String>,
}

/// A rectangle in pixels of the nominal size: where a panel's axes enclose it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Frame {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) width: f64,
    pub(crate) height: f64,
}

/// One pair of axes with everything between them. Items are inside: they are cut when they are added.
#[derive(Debug, Clone)]
pub(crate) struct Panel {
    pub(crate) frame: Frame,
    /// The horizontal and the vertical axis.
    pub(crate) axes: [Axis; 2],
    /// The axes that have labels: the horizontal, the vertical one.
    pub(crate) labelled: [bool; 2],
    /// The text above the panel.
    pub(crate) heading: String,
    /// Words behind the heading. They stay whole where a long heading is cut.
    pub(crate) finding: &'static str,
    /// `true` if the first coordinate runs along the vertical axis.
    flipped: bool,
    pub(crate) items: Vec<Item>,
}

/// One thing in a panel, in fractions of its horizontal and vertical axis.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Item {
    Area {
        outline: Vec<Place>,
        fill: Fill,
    },
    Line {
        points: Vec<Place>,
        stroke: Stroke,
    },
    Mark {
        at: Place,
        mark: Mark,
    },
    /// The tip of an arrow that points along a direction.
    ArrowHead {
        tip: Place,
        direction: Place,
        colour: Colour,
    },
    Text {
        at: Place,
        text: String,
        anchor: Anchor,
        colour: Colour,
    },
}

/// The direction from its place in which a text stands, with a small distance: a vector of length 1 in pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Anchor {
    pub(crate) across: f64,
    pub(crate) up: f64,
}

/// One line of the legend.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct LegendEntry {
    pub(crate) swatch: Swatch,
    pub(crate) text: String,
    /// `true` if it stays where nothing of it is drawn: an empty set is told too.
    pub(crate) stays: bool,
}

/// The sample beside a legend's text.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Swatch {
    pub(crate) fill: Option<Fill>,
    pub(crate) edge: Option<Stroke>,
    /// A horizontal line.
    pub(crate) line: Option<Stroke>,
    /// A vertical bar behind the mark.
    pub(crate) bar: Option<Stroke>,
    pub(crate) mark: Option<Mark>,
}

impl Swatch {
    pub(crate) const NOTHING: Swatch = Swatch { fill: None, edge: None, line: None, bar: None, mark: None };

    pub(crate) fn area(fill: Fill, edge: Stroke) -> Self {
        Swatch { fill: Some(fill), edge: Some(edge), ..Swatch::NOTHING }
    }

    pub(crate) fn inside(fill: Fill) -> Self {
        Swatch { fill: Some(fill), ..Swatch::NOTHING }
    }

    pub(crate) fn line(stroke: Stroke) -> Self {
        Swatch { line: Some(stroke), ..Swatch::NOTHING }
    }

    pub(crate) fn mark(mark: Mark) -> Self {
        Swatch { mark: Some(mark), ..Swatch::NOTHING }
    }

    pub(crate) fn line_and_mark(stroke: Stroke, mark: Mark) -> Self {
        Swatch { line: Some(stroke), mark: Some(mark), ..Swatch::NOTHING }
    }

    pub(crate) fn bar(stroke: Stroke, mark: Mark) -> Self {
        Swatch { bar: Some(stroke), mark: Some(mark), ..Swatch::NOTHING }
    }
}

impl Drawing {
    /// Leaves of the legend what is drawn on some panel.
    pub(crate) fn keep_legend_of_drawn(&mut self) {
        let items = || self.panels.iter().flat_map(|panel| &panel.items);
        let filled =
            |wanted: &Fill| items().any(|item| matches!(item, Item::Area { fill, .. } if fill == wanted));
        let stroked = |wanted: &Stroke| {
            items().any(|item| matches!(item, Item::Line { stroke, .. } if stroke == wanted))
        };
        let marked = |wanted: &Mark| self.panels.iter().any(|panel| panel.has_mark(wanted));
        for LegendEntry { swatch, .. } in self.legend.iter_mut().filter(|entry| !entry.stays) {
            swatch.fill = swatch.fill.filter(filled);
            swatch.edge = swatch.edge.filter(stroked);
            swatch.line = swatch.line.filter(stroked);
            swatch.bar = swatch.bar.filter(stroked);
            swatch.mark = swatch.mark.filter(marked);
            if swatch.fill.is_none() {
                // An area with an edge but no inside is a line.
                swatch.line = swatch.line.or(swatch.edge.take());
            }
        }
        self.legend.retain(|entry| entry.swatch != Swatch::NOTHING);
    }
}

impl LegendEntry {
    pub(crate) fn new(swatch: Swatch, text: impl Into<String>) -> Self {
        LegendEntry { swatch, text: text.into(), stays: false }
    }

    /// One that stays where nothing of it is drawn.
    pub(crate) fn staying(swatch: Swatch, text: impl Into<String>) -> Self {
        LegendEntry { stays: true, ..LegendEntry::new(swatch, text) }
    }
}

impl Panel {
    /// An empty panel of the first and the second coordinate; flipped, the first runs upwards.
    pub(crate) fn new(frame: Frame, [first, second]: [Axis; 2], flipped: bool) -> Self {
        let axes = if flipped { [second, first] } else { [first, second] };
        Panel {
            frame,
            axes,
            labelled: [true, true],
            heading: String::new(),
            finding: "",
            flipped,
            items: Vec::new(),
        }
    }

    /// Returns the place of a point. Rounded once per coordinate.
    pub(crate) fn place(&self, point: [&Rational; 2]) -> Place {
        let [horizontal, vertical] = &self.axes;
        let [first, second] = if self.flipped { [point[1], point[0]] } else { point };
        [horizontal.fraction(first), vertical.fraction(second)]
    }

    /// The axis of the first and of the second coordinate.
    pub(crate) fn coordinates(&self) -> [&Axis; 2] {
        let [horizontal, vertical] = &self.axes;
        if self.flipped { [vertical, horizontal] } else { [horizontal, vertical] }
    }

    /// Returns whether the first coordinate runs along the vertical axis.
    pub(crate) fn is_flipped(&self) -> bool {
        self.flipped
    }

    /// A place from fractions along the first and the second coordinate.
    pub(crate) fn oriented(&self, [first, second]: Place) -> Place {
        if self.flipped { [second, first] } else { [first, second] }
    }

    /// Returns whether a place is in the panel.
    pub(crate) fn shows(&self, place: Place) -> bool {
        place.iter().all(|coordinate| (0.0..=1.0).contains(coordinate))
    }

    /// Adds a convex area.
    pub(crate) fn area(&mut self, outline: &[Place], fill: Fill) {
        let outline = clip::area(outline);
        if outline.len() > 2 {
            self.items.push(Item::Area { outline, fill });
        }
    }

    /// Adds a polyline.
    pub(crate) fn line(&mut self, points: &[Place], stroke: Stroke) {
        self.items.extend(clip::polyline(points).into_iter().map(|points| Item::Line { points, stroke }));
    }

    /// Adds a closed polyline.
    pub(crate) fn outline(&mut self, points: &[Place], stroke: Stroke) {
        let closed: Vec<Place> = points.iter().chain(points.first()).copied().collect();
        self.line(&closed, stroke);
    }

    /// Adds the part of `from + t·direction`, `t ≥ first`, in the panel, with an arrow where it is cut.
    pub(crate) fn ray(&mut self, from: Place, direction: Place, first: f64, stroke: Stroke) {
        let Some((enter, leave)) = clip::crossing(from, direction, first, f64::INFINITY) else { return };
        let points = vec![clip::cut(from, direction, enter), clip::cut(from, direction, leave)];
        self.items.push(Item::Line { points, stroke });
        self.arrow(clip::cut(from, direction, leave), direction, stroke.colour);
        if first == f64::NEG_INFINITY {
            let backwards = direction.map(|step| -step);
            self.arrow(clip::cut(from, direction, enter), backwards, stroke.colour);
        }
    }

    /// Adds the head of an arrow.
    pub(crate) fn arrow(&mut self, tip: Place, direction: Place, colour: Colour) {
        self.items.push(Item::ArrowHead { tip, direction, colour });
    }

    /// Adds a mark, if its middle is in the panel, whose border belongs to it.
    pub(crate) fn mark(&mut self, at: Place, mark: Mark) {
        if self.shows(at) {
            self.items.push(Item::Mark { at, mark });
        }
    }

    /// Returns whether a mark of this form and colour is on the panel.
    pub(crate) fn has_mark(&self, wanted: &Mark) -> bool {
        let same = |mark: &Mark| mark.shape == wanted.shape && mark.colour == wanted.colour;
        self.items.iter().any(|item| matches!(item, Item::Mark { mark, .. } if same(mark)))
    }

    /// Adds a text, if its place is in the panel.
    pub(crate) fn text(&mut self, at: Place, text: impl Into<String>, anchor: Anchor, colour: Colour) {
        if self.shows(at) {
            self.items.push(Item::Text { at, text: text.into(), anchor, colour });
        }
    }

    /// A thin line across the panel at a value of the first coordinate.
    pub(crate) fn line_at_first(&mut self, value: &Rational, colour: Colour) {
        let at = self.coordinates()[0].fraction(value);
        let ends = [[at, 0.0], [at, 1.0]].map(|place| self.oriented(place));
        self.line(&ends, Stroke::new(colour, 0.9, Dash::Short));
    }
}
