//! A set of half-planes, and a linear program over it: where the objective improves, and the optimal points.

use boundfit_exact::{Foreign, Rational};
use boundfit_geometry::constructions::foot;
use boundfit_geometry::{Direction, Face, Point, Polyhedron, RegionKind, Support};

use super::layout::{main_frame, panel};
use super::region::{at, direction};
use super::{contradiction, marks, region, view};
use crate::clip::{self, Place};
use crate::drawing::{Drawing, LegendEntry, Panel, Swatch};
use crate::figure::PlotOptions;
use crate::labels;
use crate::outside::unseen_sets;
use crate::page::Page;
use crate::palette::{Dash, Mark, Shape, Stroke, VERMILLION, style};
use crate::render::BOTTOM_LABELS;
use crate::text::one_line;

/// Optimal points.
const OPTIMAL: Stroke = Stroke::new(VERMILLION, 3.0, Dash::Solid);
const OPTIMUM: Mark = Mark::new(Shape::Disc, 4.8, VERMILLION);
/// The line where the objective has its optimum.
const LEVEL: Stroke = Stroke::new(VERMILLION, 1.0, Dash::Short);
/// The length of the arrow of the objective, in parts of the panel.
const ARROW: f64 = 0.16;
/// The least part of a panel that an arrow takes to be seen.
const SEEN: f64 = 0.05;
/// Farther than a panel is wide or high.
const ACROSS: f64 = 4.0;

/// The figure of a set, with axes of these names.
pub(crate) fn region(
    polyhedron: &Polyhedron,
    names: &[Foreign; 2],
    title: &Foreign,
    options: &PlotOptions,
) -> Drawing {
    let names = names.each_ref().map(|name| one_line(name, 30));
    let (panel, legend) = panel_of(polyhedron, &names, options, "set");
    let kind = polyhedron.region().kind();
    let note = match kind {
        RegionKind::Empty => "No point is in all half-planes.",
        _ if polyhedron.region().is_bounded() => "",
        RegionKind::Plane => "Every point is in all half-planes.",
        _ => "Arrows: the set goes on without end.",
    };
    let unseen = unseen_sets(&panel, [polyhedron].into_iter(), options);
    finished(
        one_line(title, 90),
        format!("set: {}", kind.name()),
        &labels::asked_for(&labels::described(options), names),
        panel,
        legend,
        Notes { own: note, is_shown: true, unseen },
    )
}

/// A panel with a set, and its legend, which calls the set so. Of an empty set the panel has the half-planes that
/// contradict each other.
fn panel_of(
    polyhedron: &Polyhedron,
    names: &[String; 2],
    options: &PlotOptions,
    called: &str,
) -> (Panel, Vec<LegendEntry>) {
    let axes = labels::asked_for(options, names.clone());
    let framed = |window: &view::Window| panel(main_frame(0, Page::of(options)), window, &axes);
    if let Some(certificate) = polyhedron.region().certificate() {
        let rows = contradiction::rows(polyhedron, certificate);
        let mut panel = framed(&contradiction::window(&rows).asked_for(options));
        let legend = contradiction::draw(&mut panel, &rows, names);
        return (panel, legend);
    }
    let window = view::of_region(polyhedron.region(), room_around(polyhedron), &[]).asked_for(options);
    let mut panel = framed(&window);
    region::draw(&mut panel, polyhedron, style::SET_FILL, style::SET_EDGE);
    marks::draw_vertices(&mut panel, polyhedron.region(), true);
    let set = match polyhedron.region().kind() {
        RegionKind::Point => Swatch::mark(style::VERTEX),
        RegionKind::Segment | RegionKind::Ray | RegionKind::Line => Swatch::line(style::SET_EDGE),
        _ => Swatch::area(style::SET_FILL, style::SET_EDGE),
    };
    (panel, vec![LegendEntry::new(set, called)])
}

/// The figure of a feasible set, with axes of these names and an objective that is to be made large.
pub(crate) fn drawing(
    polyhedron: &Polyhedron,
    gain: &[Rational; 2],
    names: &[Foreign; 2],
    title: &Foreign,
    options: &PlotOptions,
) -> Drawing {
    let names = names.each_ref().map(|name| one_line(name, 30));
    let (mut panel, mut legend) = panel_of(polyhedron, &names, options, "feasible set");
    let improves = LegendEntry::new(Swatch::line(LEVEL), "the objective improves along the arrow");
    // The remark of the description about the optimum, and whether the remark is to stand below the figure.
    let (note, is_shown) = match polyhedron.support(gain) {
        Support::Bounded { proof, face } => {
            draw_face(&mut panel, &face);
            if let Some(along) = Direction::from_rational(gain) {
                draw_level(&mut panel, &proof.attained_at.coordinates(), &along);
            }
            legend.push(LegendEntry::new(Swatch::line_and_mark(OPTIMAL, OPTIMUM), "optimal"));
            legend.push(improves);
            (optimal_points(&face), face == Face::Whole)
        }
        Support::Unbounded(proof) => {
            let along = direction(&panel, &proof.ray);
            let from = start_of_ray(&panel, polyhedron, &proof.point, along);
            let drawn = panel.items.len();
            panel.ray(from, along, 0.0, LEVEL);
            legend.push(improves);
            match panel.items.len() > drawn {
                true => ("The objective improves for ever along the arrow.", true),
                false => ("The objective improves for ever, along an arrow outside this view.", true),
            }
        }
        Support::Empty(_) => ("No point is feasible.", true),
    };
    let subtitle = format!("feasible set: {}", polyhedron.region().kind().name());
    let names = labels::asked_for(&labels::described(options), names);
    let unseen = unseen_sets(&panel, [polyhedron].into_iter(), options);
    finished(one_line(title, 90), subtitle, &names, panel, legend, Notes { own: note, is_shown, unseen })
}

/// The remarks of a figure.
struct Notes {
    own: &'static str,
    /// `true` if the own remark stands below the panel, too.
    is_shown: bool,
    /// The remark on a set that is not in view.
    unseen: Option<String>,
}

/// A figure with all its parts.
fn finished(
    title: String,
    subtitle: String,
    names: &[String; 2],
    panel: Panel,
    legend: Vec<LegendEntry>,
    Notes { own, is_shown, unseen }: Notes,
) -> Drawing {
    let main = panel.frame;
    let own = Some(own.to_owned()).filter(|own| !own.is_empty());
    let remarks: Vec<&str> = own.iter().chain(&unseen).map(String::as_str).collect();
    let remarks = remarks.join(" ");
    let description =
        format!("{title}, {subtitle}. Horizontal axis: {}. Vertical axis: {}. {remarks}", names[0], names[1]);
    Drawing {
        description: description.trim_end().to_owned(),
        title,
        subtitle,
        height: main.top + main.height + BOTTOM_LABELS + 8.0,
        panels: vec![panel],
        legend,
        notes: own.filter(|_| is_shown).into_iter().chain(unseen).collect(),
    }
}

/// A box as large as a vertex is far from the origin, for sets without width.
fn room_around(polyhedron: &Polyhedron) -> Option<[[Rational; 2]; 2]> {
    let [first, second] = polyhedron.region().vertices().first()?.point().coordinates();
    let size = |value: Rational| if value.is_zero() { Rational::one() } else { value.abs() };
    Some([[Rational::zero(), Rational::zero()], [size(first), size(second)]])
}

/// Returns the optimal points, in words.
fn optimal_points(face: &Face) -> &'static str {
    match face {
        Face::Vertex(_) => "One point is optimal.",
        Face::Segment(_) => "An edge is optimal.",
        Face::Ray { .. } => "A ray is optimal.",
        Face::Line { .. } => "A line is optimal.",
        Face::Whole => "Every feasible point is optimal.",
    }
}

/// Marks the optimal points, unless all points are.
fn draw_face(panel: &mut Panel, face: &Face) {
    match face {
        Face::Vertex(point) => panel.mark(at(panel, &point.coordinates()), OPTIMUM),
        Face::Segment(ends) => {
            let ends = ends.each_ref().map(|end| at(panel, &end.coordinates()));
            panel.line(&ends, OPTIMAL);
            for end in ends {
                panel.mark(end, OPTIMUM);
            }
        }
        Face::Ray { apex, direction: along } => {
            let from = at(panel, &apex.coordinates());
            let step = direction(panel, along);
            panel.ray(from, step, 0.0, OPTIMAL);
            panel.mark(from, OPTIMUM);
        }
        Face::Line { point, direction: along } => {
            let from = at(panel, &point.coordinates());
            let step = direction(panel, along);
            panel.ray(from, step, f64::NEG_INFINITY, OPTIMAL);
        }
        Face::Whole => {}
    }
}

/// Returns the place where a ray along which a set goes on starts: the vertex from which most of it is in view. The ray may start at
/// any point of the set, so that a set without a vertex in view has it from a point inside.
fn start_of_ray(panel: &Panel, polyhedron: &Polyhedron, inside: &Point, along: Place) -> Place {
    let region = polyhedron.region();
    let shown = |from: &Place| {
        let visible = clip::crossing(*from, along, 0.0, f64::INFINITY);
        visible.map_or(0.0, |(enter, leave)| (leave - enter) * along[0].hypot(along[1]))
    };
    let best = |places: Vec<Place>| {
        let seen = places.into_iter().map(|place| (shown(&place), place));
        seen.filter(|(length, _)| *length > SEEN).max_by(|one, other| one.0.total_cmp(&other.0))
    };
    let place = |point: &Point| at(panel, &point.coordinates());
    let vertices = region.vertices().iter().map(|vertex| place(vertex.point()));
    let vertices: Vec<Place> = vertices.filter(|vertex| panel.shows(*vertex)).collect();
    let sides = region.boundaries().iter().map(|side| foot(side.half_plane()));
    let others: Vec<Place> = sides.chain(region.witness()).map(|point| place(&point)).collect();
    best(vertices).or_else(|| best(others)).map_or_else(|| place(inside), |(_, place)| place)
}

/// The line on which the objective has its optimum, and an arrow in which direction it improves.
fn draw_level(panel: &mut Panel, point: &[Rational; 2], along: &Direction) {
    let middle = at(panel, point);
    let level = direction(panel, &along.turned_left());
    panel.line(&[-ACROSS, ACROSS].map(|steps| clip::along(middle, level, steps)), LEVEL);
    let step = direction(panel, along);
    let tip = clip::along(middle, step, ARROW);
    // A vertex at the edge of the view leaves room behind it.
    let (from, tip) =
        if panel.shows(tip) { (middle, tip) } else { (clip::along(middle, step, -ARROW), middle) };
    panel.line(&[from, tip], LEVEL);
    panel.arrow(tip, step, LEVEL.colour);
}

#[cfg(test)]
mod tests {
    use boundfit_exact::Rational;
    use boundfit_geometry::{Inequality, Polyhedron};

    use super::*;
    use crate::drawing::Item;

    /// The figure of x ≥ 0, y ≥ 0 and x - y ≥ 1 with an objective.
    fn wedge(gain: [i64; 2], options: &PlotOptions) -> Drawing {
        let row = |a1: i64, a2: i64, b: i64| Inequality::new(a1.into(), a2.into(), b.into());
        let set = Polyhedron::intersect([row(-1, 0, 0), row(0, -1, 0), row(-1, 1, -1)].into_iter().collect());
        drawing(&set, &gain.map(Rational::from), &["x".into(), "y".into()], &"wedge".into(), options)
    }

    #[test]
    fn an_objective_without_end_improves_from_the_vertex_on() {
        for gain in [[1, 1], [1, 0], [2, -1]] {
            let figure = wedge(gain, &PlotOptions::default());
            let panel = &figure.panels[0];
            let vertex = panel.place([&Rational::one(), &Rational::zero()]);
            let mut lines = panel.items.iter().filter_map(|item| match item {
                Item::Line { points, stroke } if *stroke == LEVEL => Some(points),
                _ => None,
            });
            assert_eq!(lines.next().map(|points| points[0]), Some(vertex), "{gain:?}");
            assert!(
                panel
                    .items
                    .iter()
                    .any(|item| matches!(item, Item::ArrowHead { colour, .. } if *colour == LEVEL.colour))
            );
        }
    }

    #[test]
    fn a_set_out_of_view_is_said_to_be_elsewhere() {
        let range = |from: i64, to: i64| Some([from, to].map(Rational::from));
        let options = PlotOptions { x_range: range(-9, -5), y_range: range(3, 4), ..PlotOptions::default() };
        let notes = wedge([1, 1], &options).notes;
        let expected = [
            "The objective improves for ever, along an arrow outside this view.",
            "The set is not in this view: it has vertices at 1 across and at 0 up.",
        ];
        assert_eq!(notes, expected);
    }
}
