//! Boxes, vertices and estimates.

use boundfit_estimation::{Fit, Problem};
use boundfit_exact::{Interval, Rational};
use boundfit_geometry::Region;

use super::region::{at, direction, places};
use super::sliver::Sliver;
use crate::clip::{self, Place};
use crate::drawing::{Anchor, LegendEntry, Panel, Swatch};
use crate::labels;
use crate::palette::{BLUE, Fill, Mark, Stroke, style};

/// Vertices are numbered up to this count: beyond it the numbers would cover the figure.
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
        let uniform = problem.measurements.error_bound().is_uniform();
        let (sign, least) = labels::rounded_up(&minimax.least);
        let least = if uniform {
            format!("least ε {sign} {least}")
        } else {
            format!("least bound {sign} {least}·ε")
        };
        let several = if minimax.unique { "" } else { ", one of several" };
        let name = format!("minimax estimate ({least}{several})");
        all.push(Estimate { theta: minimax.theta.clone(), mark: style::MINIMAX_MARK, name });
    }
    all
}

/// Draws the estimates and gives the legend's lines, whether or not they are in the view.
pub(crate) fn draw_estimates(panel: &mut Panel, estimates: &[Estimate]) -> Vec<LegendEntry> {
    let mut entries = Vec::new();
    // The largest mark goes first: where all three coincide, each is still to be seen.
    for Estimate { theta, mark, .. } in estimates.iter().rev() {
        panel.mark(at(panel, theta), *mark);
    }
    for Estimate { mark, name, .. } in estimates {
        entries.push(LegendEntry::new(Swatch::mark(*mark), name.clone()));
    }
    entries
}

/// Marks the vertices and, when there are few, numbers them as reports do.
pub(crate) fn draw_vertices(panel: &mut Panel, region: &Region, numbered: bool) {
    let vertices = places(panel, region);
    let radius =
        if vertices.len() > MOST_NUMBERED { style::VERTEX.radius * 0.7 } else { style::VERTEX.radius };
    for place in &vertices {
        panel.mark(*place, Mark { radius, ..style::VERTEX });
    }
    if !numbered || vertices.len() > MOST_NUMBERED || vertices.len() < 2 {
        return;
    }
    let ends = match region {
        Region::UnboundedPolygon(polygon) => {
            [polygon.incoming(), polygon.outgoing()].map(|ray| Some(direction(panel, ray)))
        }
        _ => [None, None],
    };
    draw_numbers(panel, &vertices, ends);
}

/// Numbers the vertices of a convex set, given in order, outside of it. A set that goes on without end has directions
/// before its first and after its last vertex.
fn draw_numbers(panel: &mut Panel, vertices: &[Place], [before, after]: [Option<Place>; 2]) {
    let size = [panel.frame.width, panel.frame.height];
    let pixels = |place: Place| [place[0] * size[0], place[1] * size[1]];
    let mut corners: Vec<Place> = vertices.iter().copied().map(pixels).collect();
    let beyond =
        |corner: Option<&Place>, step: Option<Place>| Some(clip::along(*corner?, pixels(step?), 1.0));
    let first = beyond(corners.first(), before);
    corners.extend(beyond(corners.last(), after));
    let shift = usize::from(first.is_some());
    corners.splice(0..0, first);
    let count = corners.len();
    let mean = |axis: usize| corners.iter().map(|corner| corner[axis]).sum::<f64>() / count as f64;
    let centre = [mean(0), mean(1)];
    for group in neighbours_together(&corners[shift..shift + vertices.len()]) {
        let [from, to] = [group[0], group[group.len() - 1]].map(|index| index + shift);
        let [previous, next] = [corners[(from + count - 1) % count], corners[(to + 1) % count]];
        let normal = outward([previous, next], corners[from], centre);
        // A line along the chord from the vertex before to the one after touches the set at the group.
        let reach =
            |index: &usize| normal[0] * corners[index + shift][0] + normal[1] * corners[index + shift][1];
        let outermost = group.iter().copied().max_by(|one, other| reach(one).total_cmp(&reach(other)));
        let Some(vertex) = outermost else { continue };
        let numbers: Vec<String> = group.iter().map(|index| (index + 1).to_string()).collect();
        let anchor = Anchor { across: normal[0], up: normal[1] };
        panel.text(vertices[vertex], numbers.join(", "), anchor, BLUE);
    }
}

/// The unit normal of a chord between the neighbours of a corner, away from the centre.
fn outward([previous, next]: [Place; 2], corner: Place, centre: Place) -> Place {
    let away = [corner[0] - centre[0], corner[1] - centre[1]];
    let chord = [next[0] - previous[0], next[1] - previous[1]];
    let mut normal = if chord[0].hypot(chord[1]) > 0.0 { [-chord[1], chord[0]] } else { away };
    if normal[0] * away[0] + normal[1] * away[1] < 0.0 {
        normal = normal.map(|part| -part);
    }
    let length = normal[0].hypot(normal[1]);
    if length > 0.0 { normal.map(|part| part / length) } else { [0.0, 1.0] }
}

/// The vertices in groups of neighbours that cannot be told apart, which have their numbers in one text. In pixels.
fn neighbours_together(vertices: &[Place]) -> Vec<Vec<usize>> {
    const APART: f64 = 15.0;
    let near = |p: usize, q: usize| {
        let [p, q] = [vertices[p], vertices[q]];
        (p[0] - q[0]).hypot(p[1] - q[1]) <= APART
    };
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for index in 0..vertices.len() {
        match groups.last_mut() {
            Some(group) if near(group[0], index) => group.push(index),
            _ => groups.push(vec![index]),
        }
    }
    groups
}

/// Draws a thin set in its principal axes on a panel of these, its vertices numbered.
pub(crate) fn thin<'a>(
    mut panel: Panel,
    sliver: &Sliver,
    regions: impl Iterator<Item = &'a Region>,
) -> Panel {
    let vertices = regions.flat_map(Region::vertices);
    let outline: Vec<_> =
        vertices.filter_map(|vertex| sliver.place(&panel, &vertex.point().coordinates())).collect();
    panel.area(&outline, style::SET_FILL);
    panel.outline(&outline, style::SET_EDGE);
    for at in &outline {
        panel.mark(*at, style::VERTEX);
    }
    if outline.len() <= MOST_NUMBERED {
        draw_numbers(&mut panel, &outline, [None, None]);
    }
    panel
}

/// Returns the estimates that no panel shows, in words.
pub(crate) fn outside_note(panels: &[Panel], estimates: &[Estimate]) -> Option<String> {
    let drawn = |estimate: &&Estimate| !panels.iter().any(|panel| panel.has_mark(&estimate.mark));
    let names: Vec<&str> = estimates.iter().filter(drawn).map(|estimate| estimate.name.as_str()).collect();
    (!names.is_empty()).then(|| format!("Outside of this view: {}.", names.join(", ")))
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
