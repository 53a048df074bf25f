//! A set of parameters of any kind in a panel. An unbounded part is cut at the edge of the panel, with arrows.

use boundfit_exact::Rational;
use boundfit_geometry::{Direction, HalfPlane, Inequality, Polyhedron, Region};

use crate::clip::{self, Place};
use crate::drawing::Panel;
use crate::palette::{Fill, Stroke};

/// Draws a set: its inside, its edges, and how it goes on.
pub(crate) fn draw(panel: &mut Panel, polyhedron: &Polyhedron, fill: Fill, edge: Stroke) {
    let region = polyhedron.region();
    fill_inside(panel, polyhedron, fill);
    match region {
        Region::Empty(_) | Region::Point(_) => {}
        Region::Segment(_) | Region::Polygon(_) => panel.outline(&places(panel, region), edge),
        Region::Ray(ray) => {
            if let [apex] = places(panel, region).as_slice() {
                let step = direction(panel, ray.direction());
                panel.ray(*apex, step, 0.0, edge);
            }
        }
        Region::UnboundedPolygon(polygon) => {
            let chain: Vec<Place> =
                polygon.chain().map(|vertex| at(panel, &vertex.point().coordinates())).collect();
            panel.line(&chain, edge);
            if let (Some(&first), Some(&last)) = (chain.first(), chain.last()) {
                panel.ray(first, direction(panel, polygon.incoming()), 0.0, edge);
                panel.ray(last, direction(panel, polygon.outgoing()), 0.0, edge);
            }
        }
        Region::Line(_) | Region::Strip(_) | Region::HalfPlane(_) => {
            for boundary in region.boundaries() {
                whole_line(panel, boundary.half_plane(), edge);
            }
        }
        Region::Plane => {}
    }
    open_sides(panel, region, edge);
}

/// Arrows where a half-plane or the plane goes on without an edge that could show it.
fn open_sides(panel: &mut Panel, region: &Region, edge: Stroke) {
    match region {
        Region::Plane => {
            for (tip, step) in [
                ([0.5, 1.0], [0.0, 1.0]),
                ([0.5, 0.0], [0.0, -1.0]),
                ([0.0, 0.5], [-1.0, 0.0]),
                ([1.0, 0.5], [1.0, 0.0]),
            ] {
                panel.arrow(tip, step, edge.colour);
            }
        }
        Region::HalfPlane(half) => {
            let Some((form, bound)) = form_in(panel, half.boundary().half_plane()) else { return };
            let inward = form.map(|c| -c);
            // From the point of the boundary nearest to the centre of the panel.
            let excess = (form[0] + form[1]) * 0.5 - bound;
            let square = form[0] * form[0] + form[1] * form[1];
            let foot = clip::along([0.5, 0.5], form, -excess / square);
            if let Some((_, leave)) = clip::crossing(foot, inward, 0.0, f64::INFINITY) {
                panel.arrow(clip::along(foot, inward, leave * 0.9), inward, edge.colour);
            }
        }
        _ => {}
    }
}

fn fill_inside(panel: &mut Panel, polyhedron: &Polyhedron, fill: Fill) {
    let region = polyhedron.region();
    match region {
        Region::Polygon(_) => panel.area(&places(panel, region), fill),
        Region::UnboundedPolygon(_) | Region::Strip(_) | Region::HalfPlane(_) | Region::Plane => {
            let system = polyhedron.system();
            let bounds = polyhedron.irredundant();
            let half_planes = bounds.iter().filter_map(|&index| form_in(panel, system.half_plane(index)?));
            let inside = half_planes
                .fold(clip::SQUARE.to_vec(), |area, (form, bound)| clip::half_plane(&area, form, bound));
            panel.area(&inside, fill);
        }
        Region::Empty(_) | Region::Point(_) | Region::Segment(_) | Region::Ray(_) | Region::Line(_) => {}
    }
}

/// Returns the places of the vertices.
pub(crate) fn places(panel: &Panel, region: &Region) -> Vec<Place> {
    region.vertices().iter().map(|vertex| at(panel, &vertex.point().coordinates())).collect()
}

/// Returns the place of a point.
pub(crate) fn at(panel: &Panel, [theta1, theta2]: &[Rational; 2]) -> Place {
    panel.place([theta1, theta2])
}

/// A direction in fractions of the panel, of size 1.
pub(crate) fn direction(panel: &Panel, direction: &Direction) -> Place {
    let [first, second] = panel.coordinates();
    let part = |step, width: &Rational| Rational::from(step).checked_div(width).unwrap_or_default();
    in_unit_size([part(direction.dx(), first.width()), part(direction.dy(), second.width())])
}

/// A half-plane `form·p ≤ bound` in fractions of the panel.
fn form_in(panel: &Panel, half_plane: &HalfPlane) -> Option<(Place, f64)> {
    let [first, second] = panel.coordinates();
    let Inequality { a, b } = inequality(half_plane);
    let rest = b - &a[0] * first.lower() - &a[1] * second.lower();
    let form = [&a[0] * first.width(), &a[1] * second.width()];
    let size = form[0].abs().max(form[1].abs());
    Some((in_unit_size(form), rest.checked_div(&size)?.to_f64()))
}

/// A half-plane as an inequality.
pub(crate) fn inequality(half_plane: &HalfPlane) -> Inequality {
    let [a1, a2, b] = [half_plane.a1(), half_plane.a2(), half_plane.b()].map(Rational::from);
    Inequality::new(a1, a2, b)
}

/// A vector over the size of its larger component: floats of any vector's ratio, however large its numbers.
fn in_unit_size(vector: [Rational; 2]) -> Place {
    let size = vector[0].abs().max(vector[1].abs());
    vector.map(|part| part.checked_div(&size).unwrap_or_default().to_f64())
}

/// The whole line that bounds a half-plane, with an arrow at either end.
pub(crate) fn whole_line(panel: &mut Panel, half_plane: &HalfPlane, stroke: Stroke) {
    let Inequality { a, b } = inequality(half_plane);
    let centre = panel.coordinates().map(|axis| axis.lower() + axis.width().half());
    let widths = panel.coordinates().map(|axis| axis.width().clone());
    // The line is entered beside the centre of the panel, on the axis that it crosses at the larger angle.
    let j = usize::from((&a[0] * &widths[0]).abs() < (&a[1] * &widths[1]).abs());
    let other = 1 - j;
    let Some(cut) = (b - &a[other] * &centre[other]).checked_div(&a[j]) else { return };
    let mut point = centre;
    point[j] = cut;
    let from = at(panel, &point);
    let along = direction(panel, &half_plane.normal().turned_left());
    panel.ray(from, along, f64::NEG_INFINITY, stroke);
}
