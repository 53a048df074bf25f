//! Boxes, vertices and estimates.

use boundfit_estimation::{Fit, Problem};
use boundfit_exact::{Interval, Rational, Rounding};
use boundfit_geometry::Region;

use super::region::{at, places};
use crate::clip::Place;
use crate::drawing::{Anchor, LegendEntry, Panel, Swatch};
use crate::labels;
use crate::palette::{BLUE, Fill, Mark, Stroke, style};

/// Up to so many vertices are numbered.
const MOST_NUMBERED: usize = 12;

/// An estimate with what it is called in the legend.
pub(crate) struct Estimate {
    pub(crate) theta: [Rational; 2],
    pub(crate) mark: Mark,
    pub(crate) name: String,
}

/// The estimates that exist.
pub(crate) fn estimates(problem: &Problem, fit: &Fit) -> Vec<Estimate> {
    let mut all = Vec::new();
    if let Ok(estimate) = &fit.least_squares {
        let feasible = fit.fps.polyhedron().membership(&estimate.theta).is_inside();
        let name = if feasible { "least squares (feasible)" } else { "least squares (not feasible)" };
        all.push(Estimate {
            theta: estimate.theta.clone(),
            mark: style::LEAST_SQUARES_MARK,
            name: name.to_owned(),
        });
    }
    if let Some(central) = &fit.central {
        let (theta, name) = (central.theta.clone(), "central estimate".to_owned());
        all.push(Estimate { theta, mark: style::CENTRAL_MARK, name });
    }
    if let Some(minimax) = &fit.minimax {
        let uniform =
            matches!(problem.measurements.error_bound(), boundfit_estimation::ErrorBound::Uniform(_));
        let least = labels::number(&minimax.least, 4, Rounding::Up);
        let least = if uniform { format!("least ε = {least}") } else { format!("at {least}·ε") };
        let several = if minimax.unique { "" } else { ", one of several" };
        let name = format!("minimax estimate ({least}{several})");
        all.push(Estimate { theta: minimax.theta.clone(), mark: style::MINIMAX_MARK, name });
    }
    all
}

/// Draws the estimates and gives the legend's lines.
pub(crate) fn draw_estimates(panel: &mut Panel, estimates: &[Estimate]) -> Vec<LegendEntry> {
    let mut entries = Vec::new();
    // The largest mark goes first: where all three coincide, each is still to be seen.
    for Estimate { theta, mark, .. } in estimates.iter().rev() {
        panel.mark(at(panel, theta), *mark);
    }
    for Estimate { theta, mark, name } in estimates {
        let place = at(panel, theta);
        let name = if panel.shows(place) { name.clone() } else { format!("{name}, outside of this view") };
        entries.push(LegendEntry::new(Swatch::mark(*mark), name));
    }
    entries
}

/// Marks the vertices and, when there are few, numbers them as reports do.
pub(crate) fn draw_vertices(panel: &mut Panel, region: &Region, numbered: bool) {
    let vertices = places(panel, region);
    let shown: Vec<Place> = vertices.iter().copied().filter(|place| panel.shows(*place)).collect();
    let radius =
        if vertices.len() > MOST_NUMBERED { style::VERTEX.radius * 0.7 } else { style::VERTEX.radius };
    for place in &vertices {
        panel.mark(*place, Mark { radius, ..style::VERTEX });
    }
    if !numbered || vertices.len() > MOST_NUMBERED || vertices.len() < 2 {
        return;
    }
    let mean = |axis: usize| shown.iter().map(|place| place[axis]).sum::<f64>() / shown.len() as f64;
    // Of a set that goes on without end the vertices alone do not show where its inside is.
    let inward = |mean: f64| if region.is_bounded() { mean } else { (mean + 0.5) / 2.0 };
    let centre = [inward(mean(0)), inward(mean(1))];
    for (numbers, place) in neighbours_together(panel, &vertices) {
        let away = [place[0] - centre[0], place[1] - centre[1]];
        let size = away[0].abs().max(away[1].abs());
        let side = |part: f64| if part.abs() < 0.35 * size { 0 } else { part.signum() as i8 };
        let anchor = Anchor { across: side(away[0]), up: side(away[1]) };
        panel.text(place, numbers, anchor, BLUE);
    }
}

/// The numbers of the vertices at their places, those of neighbours that cannot be told apart as one text.
fn neighbours_together(panel: &Panel, vertices: &[Place]) -> Vec<(String, Place)> {
    const APART: f64 = 15.0;
    let far = |p: Place, q: Place| {
        let [across, up] = [(p[0] - q[0]) * panel.frame.width, (p[1] - q[1]) * panel.frame.height];
        across.hypot(up) > APART
    };
    let mut texts: Vec<(String, Place)> = Vec::new();
    for (index, place) in vertices.iter().enumerate() {
        match texts.last_mut() {
            Some((numbers, last)) if !far(*last, *place) => *numbers = format!("{numbers}, {}", index + 1),
            _ => texts.push(((index + 1).to_string(), *place)),
        }
    }
    texts
}

/// Draws a box; a side at infinity is left out and the others run to the edge of the panel.
pub(crate) fn draw_box(panel: &mut Panel, intervals: &[Interval; 2], fill: Option<Fill>, edge: Stroke) {
    let ends: [[Option<f64>; 2]; 2] = [0, 1].map(|j| {
        let axis = panel.coordinates()[j];
        [intervals[j].lower(), intervals[j].upper()].map(|end| end.value().map(|value| axis.fraction(value)))
    });
    let sides = ends.map(|[lower, upper]| [lower.unwrap_or(-0.01), upper.unwrap_or(1.01)]);
    let [[left, right], [bottom, top]] = sides;
    if let Some(fill) = fill {
        panel.area(&[[left, bottom], [right, bottom], [right, top], [left, top]], fill);
    }
    if ends.iter().flatten().all(Option::is_some) {
        panel.outline(&[[left, bottom], [right, bottom], [right, top], [left, top]], edge);
        return;
    }
    for x in ends[0].into_iter().flatten() {
        panel.line(&[[x, bottom], [x, top]], edge);
    }
    for y in ends[1].into_iter().flatten() {
        panel.line(&[[left, y], [right, y]], edge);
    }
}
