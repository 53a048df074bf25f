//! A set of half-planes, and a linear program over it: where the objective improves, and the optimal points.

use boundfit_exact::{Foreign, Rational};
use boundfit_geometry::{Direction, Face, Polyhedron, RegionKind, Support};

use super::layout::{main_frame, panel};
use super::region::{at, direction};
use super::{marks, region, view};
use crate::clip;
use crate::drawing::{Drawing, LegendEntry, Panel, Swatch};
use crate::figure::PlotOptions;
use crate::labels;
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
    let (panel, set) = panel_of(polyhedron, &names, options);
    let kind = polyhedron.region().kind();
    let note = match kind {
        RegionKind::Empty => "No point is in all half-planes.",
        _ if polyhedron.region().is_bounded() => "",
        RegionKind::Plane => "Every point is in all half-planes.",
        _ => "Arrows: the set goes on without end.",
    };
    finished(
        one_line(title, 90),
        format!("set: {}", kind.name()),
        &labels::asked_for(&labels::described(options), names),
        panel,
        vec![LegendEntry::new(set, "set")],
        (note, true),
    )
}

/// An empty panel with a set that is not empty, and how its legend shows it.
fn panel_of(polyhedron: &Polyhedron, names: &[String; 2], options: &PlotOptions) -> (Panel, Swatch) {
    let window = view::of_region(polyhedron.region(), room_around(polyhedron), &[]).asked_for(options);
    let names = labels::asked_for(options, names.clone());
    let mut panel = panel(main_frame(0, Page::of(options)), &window, &names);
    region::draw(&mut panel, polyhedron, style::SET_FILL, style::SET_EDGE);
    marks::draw_vertices(&mut panel, polyhedron.region(), true);
    let set = match polyhedron.region().kind() {
        RegionKind::Point => Swatch::mark(style::VERTEX),
        RegionKind::Segment | RegionKind::Ray | RegionKind::Line => Swatch::line(style::SET_EDGE),
        _ => Swatch::area(style::SET_FILL, style::SET_EDGE),
    };
    (panel, set)
}

/// The figure of a set that is not empty, with axes of these names and an objective that is to be made large.
pub(crate) fn drawing(
    polyhedron: &Polyhedron,
    gain: &[Rational; 2],
    names: &[Foreign; 2],
    title: &Foreign,
    options: &PlotOptions,
) -> Drawing {
    let names = names.each_ref().map(|name| one_line(name, 30));
    let (mut panel, set) = panel_of(polyhedron, &names, options);
    let improves = LegendEntry::new(Swatch::line(LEVEL), "the objective improves along the arrow");
    let mut legend = vec![LegendEntry::new(set, "feasible set")];
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
            let from = at(&panel, &proof.point.coordinates());
            let along = direction(&panel, &proof.ray);
            panel.ray(from, along, 0.0, LEVEL);
            legend.push(improves);
            ("The objective improves for ever along the arrow.", true)
        }
        Support::Empty(_) => ("No point is feasible.", true),
    };
    let subtitle = format!("feasible set: {}", polyhedron.region().kind().name());
    let names = labels::asked_for(&labels::described(options), names);
    finished(one_line(title, 90), subtitle, &names, panel, legend, (note, is_shown))
}

/// A figure with all its parts; of the note, whether it stands below the panel.
fn finished(
    title: String,
    subtitle: String,
    names: &[String; 2],
    panel: Panel,
    legend: Vec<LegendEntry>,
    (note, is_shown): (&str, bool),
) -> Drawing {
    let main = panel.frame;
    let description =
        format!("{title}, {subtitle}. Horizontal axis: {}. Vertical axis: {}. {note}", names[0], names[1]);
    Drawing {
        description: description.trim_end().to_owned(),
        title,
        subtitle,
        height: main.top + main.height + BOTTOM_LABELS + 8.0,
        panels: vec![panel],
        legend,
        notes: Some(note.to_owned()).filter(|note| is_shown && !note.is_empty()).into_iter().collect(),
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
