//! The picture of an empty set: the strips of the readings that contradict each other, where they come nearest.

use boundfit_estimation::{BoundName, Fit, Problem, half_planes};
use boundfit_exact::Rational;
use boundfit_geometry::constructions::{between_parallels, meet};
use boundfit_geometry::{Constraint, HalfPlane, Inequality, Point, Polyhedron, System};

use super::layout::{finished, main_frame, panel};
use super::sliver::Sliver;
use super::view::{Window, around_lines};
use super::{marks, region};
use crate::clip::{self, Place};
use crate::drawing::{Drawing, LegendEntry, Panel, Swatch};
use crate::figure::PlotOptions;
use crate::labels::{self, Conflict};
use crate::page::Page;
use crate::palette::{BLUE, Colour, DARK_PURPLE, Dash, Fill, ORANGE, PURPLE, SKY, Stroke, style};

/// The set of parameters that one reading or condition allows.
struct Allowed {
    name: String,
    polyhedron: Polyhedron,
    /// The bound that contradicts the others.
    bound: Option<HalfPlane>,
}

/// Opacity of what a reading allows.
pub(super) const FILL: f64 = 0.22;
/// Width of the bounds that contradict each other.
pub(super) const THICK: f64 = 2.2;

/// Fill and edge of what is allowed by the first, second and third.
pub(super) const STYLES: [(Colour, Colour, Dash); 3] =
    [(ORANGE, ORANGE, Dash::Solid), (SKY, BLUE, Dash::Long), (PURPLE, DARK_PURPLE, Dash::Short)];

/// The figure.
pub(crate) fn drawing(problem: &Problem, fit: &Fit, options: &PlotOptions) -> Drawing {
    let conflict = Conflict::of(problem, fit);
    let allowed: Vec<Allowed> = conflict.bounds.iter().filter_map(|bound| allowed(problem, *bound)).collect();
    let lines: Vec<&HalfPlane> = allowed.iter().filter_map(|allowed| allowed.bound.as_ref()).collect();
    let names = labels::axes_of_parameters(problem, options);
    let page = Page::of(options);
    let thin = thin(&allowed, fit, page);
    let mut panel =
        panel(main_frame(usize::from(thin.is_some()), page), &window(fit, &lines).asked_for(options), &names);
    let mut legend = Vec::new();
    for (Allowed { name, polyhedron, bound }, (fill, edge, dash)) in allowed.iter().zip(STYLES.iter().cycle())
    {
        let fill = Fill { colour: *fill, opacity: FILL };
        let stroke = Stroke::new(*edge, 1.0, *dash);
        region::draw(&mut panel, polyhedron, fill, stroke);
        if let Some(half_plane) = bound {
            region::whole_line(&mut panel, half_plane, Stroke { width: THICK, ..stroke });
        }
        legend.push(LegendEntry::new(Swatch::area(fill, Stroke { width: THICK, ..stroke }), name.clone()));
    }
    let estimates = marks::estimates(problem, fit);
    legend.extend(marks::draw_estimates(&mut panel, &estimates));
    let mut notes = vec![conflict.sentence()];
    match lines.len() {
        0 => panel.heading = nowhere(problem, &conflict),
        1 => {}
        _ => notes[0].push_str(" No parameters are in all these areas."),
    }
    let panels: Vec<Panel> = [panel].into_iter().chain(thin).collect();
    notes.extend(marks::outside_note(&panels, &estimates));
    if fit.minimax.is_none() {
        notes.push("No error bound, however large, leaves any parameters.".to_owned());
    }
    if panels.len() > 1 {
        notes.push(Sliver::note("the gap"));
    }
    let title = "Feasible parameter set: empty".to_owned();
    finished(problem, options, title, panels, legend, notes)
}

/// Returns the readings that no parameters can meet, and their demands.
fn nowhere(problem: &Problem, conflict: &Conflict) -> String {
    let condition = conflict.conditions.first().and_then(|number| problem.conditions.get(number - 1));
    match condition {
        Some(condition) => format!("{} holds nowhere", labels::condition(condition.text())),
        None => format!("{}: regressors 0 and |{}| > ε", conflict.names(), problem.measurements.response()),
    }
}

/// The strip of a reading or the half-plane of a condition; `None` when it has no boundary.
fn allowed(problem: &Problem, bound: BoundName) -> Option<Allowed> {
    let half_plane = |inequality: &Inequality| match inequality.constraint() {
        Constraint::HalfPlane(half_plane) => Some(half_plane),
        Constraint::Always | Constraint::Never => None,
    };
    let (name, inequalities, own) = match bound {
        BoundName::Where(number) | BoundName::WhereUpper(number) | BoundName::WhereLower(number) => {
            let condition = problem.conditions.get(number - 1)?;
            let text = labels::condition(condition.text());
            let own = usize::from(matches!(bound, BoundName::WhereLower(_)));
            (format!("condition {number}: {text}"), condition.inequalities().collect(), own)
        }
        BoundName::Upper(row) | BoundName::Lower(row) => {
            let reading = problem.measurements.kept().iter().find(|reading| reading.row == row)?;
            let (names, sides): (Vec<BoundName>, Vec<Inequality>) = half_planes(reading).unzip();
            let own = names.iter().position(|name| *name == bound)?;
            let side = if matches!(bound, BoundName::Upper(_)) { "upper" } else { "lower" };
            (format!("allowed by row {row} ({side} bound thick)"), sides, own)
        }
    };
    let bound = half_plane(&inequalities[own]);
    Some(Allowed { name, polyhedron: Polyhedron::intersect(System::new(inequalities)), bound })
}

/// Returns the places where two of the contradicting bounds meet each other.
pub(super) fn corners(lines: &[&HalfPlane]) -> Vec<[Rational; 2]> {
    let pairs = lines
        .iter()
        .enumerate()
        .flat_map(|(index, line)| lines[..index].iter().map(move |other| (line, other)));
    pairs.filter_map(|(f, g)| Some(meet(f, g)?.coordinates())).collect()
}

/// A window around the triangle between contradicting bounds, if they make one.
pub(super) fn triangle(corners: &[[Rational; 2]]) -> Option<Window> {
    let around = Window::around(corners);
    let is_one = corners.len() > 2 && around.0.iter().all(|[lower, upper]| lower < upper);
    is_one.then(|| around.padded(&Rational::ratio(3, 5)))
}

/// The triangle between the contradicting bounds; for parallel ones, the gap between them.
fn window(fit: &Fit, lines: &[&HalfPlane]) -> Window {
    let corners = corners(lines);
    if let Some(triangle) = triangle(&corners) {
        return triangle;
    }
    let minimax = || fit.minimax.as_ref().map(|minimax| minimax.theta.clone());
    let between = || match lines {
        [f, g, ..] => Some(between_parallels(f, g).coordinates()),
        _ => None,
    };
    let least_squares = || fit.least_squares.as_ref().ok().map(|estimate| estimate.theta.clone());
    let centre = corners.first().cloned().or_else(minimax).or_else(between).or_else(least_squares);
    around_lines(&centre.unwrap_or_else(|| Point::origin().coordinates()), lines)
}

/// The triangle between three bounds in its principal axes, when it is thin. Each bound allows the side away from the
/// corner that is not on it.
fn thin(allowed: &[Allowed], fit: &Fit, page: Page) -> Option<Panel> {
    let lines: Vec<&HalfPlane> = allowed.iter().filter_map(|allowed| allowed.bound.as_ref()).collect();
    let [_, _, _] = lines.as_slice() else { return None };
    let corners = corners(&lines);
    let sliver = Sliver::of_corners(&corners).filter(|_| corners.len() == 3)?;
    let mut panel = sliver.panel(0, page);
    // Corners are where the lines 1 and 0, 2 and 0, 2 and 1 meet.
    for ((line, ends), (fill, edge, dash)) in [[0, 1], [0, 2], [1, 2]].into_iter().enumerate().zip(STYLES) {
        let [from, to] = ends.map(|corner| sliver.place(&panel, &corners[corner]));
        let (from, to) = from.zip(to)?;
        let away = sliver.place(&panel, &corners[2 - line])?;
        let form = [from[1] - to[1], to[0] - from[0]];
        let value = |place: Place| form[0] * place[0] + form[1] * place[1];
        let sign = if value(away) > value(from) { 1.0 } else { -1.0 };
        let side = clip::half_plane(&clip::SQUARE, form.map(|c| sign * c), sign * value(from));
        panel.area(&side, Fill { colour: fill, opacity: FILL });
        panel.ray(
            from,
            [to[0] - from[0], to[1] - from[1]],
            f64::NEG_INFINITY,
            Stroke::new(edge, THICK, dash),
        );
    }
    if let Some(at) = fit.minimax.as_ref().and_then(|minimax| sliver.place(&panel, &minimax.theta)) {
        panel.mark(at, style::MINIMAX_MARK);
    }
    Some(panel)
}
