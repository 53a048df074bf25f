//! The lines that agree under errors in x: at most two convex sets, one on each side of θ1 = 0.

use boundfit_exact::Rational;
use boundfit_geometry::{Constraint, HalfPlane, Point, Polyhedron};
use boundfit_questions::{BoxBound, Side, SideSet, XErrorFit, XErrorProblem};

use super::empty::{self, FILL, STYLES, THICK};
use super::fps::{kind, pui_note};
use super::layout::{finished, main_frame, panel};
use super::sliver::Sliver;
use super::{marks, region, view};
use crate::drawing::{Drawing, LegendEntry, Panel, Swatch};
use crate::figure::PlotOptions;
use crate::labels;
use crate::outside::{unseen_sets, without_end};
use crate::page::Page;
use crate::palette::{Dash, FAINT_INK, Fill, Stroke, style};
use crate::x_errors::{asked, conflict, emptiness};

/// The line between rising and falling lines, as [`Panel::line_at_first`] draws it.
const LEVEL: Stroke = Stroke::new(FAINT_INK, 0.9, Dash::Short);

/// The figure.
pub(crate) fn drawing(problem: &XErrorProblem, answer: &XErrorFit, options: &PlotOptions) -> Drawing {
    if answer.is_empty() {
        return nothing(problem, answer, options);
    }
    let names = labels::parameters(problem.problem(), options);
    let pieces = answer.pieces();
    let regions = || pieces.iter().map(|piece| piece.polyhedron.region());
    let sliver = match pieces.as_slice() {
        [only] => Sliver::of(only.polyhedron.region()),
        _ => None,
    };
    let window = view::of_regions(regions(), pieces.len() > 1).asked_for(options);
    let axes = labels::axes_of_parameters(problem.problem(), options);
    let mut main = panel(main_frame(usize::from(sliver.is_some()), Page::of(options)), &window, &axes);
    let mut legend = vec![LegendEntry::new(
        Swatch::area(style::SET_FILL, style::SET_EDGE),
        "parameters of the lines that agree with all readings",
    )];
    legend.extend(level(&mut main));
    if let Some(intervals) = answer.pui() {
        marks::draw_box(&mut main, &intervals, None, style::PUI_EDGE);
        let over = if pieces.len() > 1 { "PUI box over both sets" } else { "PUI box" };
        legend.push(LegendEntry::new(Swatch::line(style::PUI_EDGE), over));
    }
    for piece in &pieces {
        region::draw(&mut main, &piece.polyhedron, style::SET_FILL, style::SET_EDGE);
        let is_numbered = sliver.is_none() && pieces.len() == 1;
        marks::draw_vertices(&mut main, piece.polyhedron.region(), is_numbered);
    }
    if let Some(central) = &answer.central {
        main.mark(region::at(&main, &central.theta), style::CENTRAL_MARK);
        let is_in = answer.contains(&central.theta);
        let name = if is_in { "central estimate" } else { "central estimate (no line that agrees)" };
        legend.push(LegendEntry::new(Swatch::mark(style::CENTRAL_MARK), name));
    }
    let mut notes = vec![asked(problem, options)];
    notes.extend(answer.pui().and_then(|intervals| pui_note(&intervals, &names)));
    notes.extend(unseen_sets(&main, pieces.iter().map(|piece| &piece.polyhedron), options));
    let mut panels = vec![main];
    if let Some(sliver) = sliver {
        panels.push(marks::thin(sliver.panel(0, Page::of(options)), &sliver, regions()));
        notes.push(Sliver::note("the set"));
    }
    notes.extend(without_end(regions()));
    let kind = match (answer.are_joined(), pieces.first()) {
        (Some(true), _) => "two convex parts, joined at θ₁ = 0".to_owned(),
        (Some(false), _) => "two parts with a gap".to_owned(),
        (None, only) => only.map(|only| kind(only.polyhedron.region())).unwrap_or_default(),
    };
    let title = format!("Feasible parameter set under errors in x: {kind}");
    finished(problem.problem(), options, title, panels, legend, notes)
}

/// Draws the line θ1 = 0 where it is in view; gives the legend.
fn level(panel: &mut Panel) -> Option<LegendEntry> {
    let before = panel.items.len();
    panel.line_at_first(&Rational::zero(), FAINT_INK);
    (panel.items.len() > before).then(|| LegendEntry::new(Swatch::line(LEVEL), "level lines, θ₁ = 0"))
}

/// Draws the sets that the contradicting readings allow, on the side whose lines need the smaller factor.
fn nothing(problem: &XErrorProblem, answer: &XErrorFit, options: &PlotOptions) -> Drawing {
    let nearest = answer.least.as_ref().map_or(Side::Both, |least| least.side);
    let side = answer.sides.iter().find(|side| side.side == nearest).or(answer.sides.first());
    let names = labels::axes_of_parameters(problem.problem(), options);
    let lines = side.map(bounds).unwrap_or_default();
    let own: Vec<&HalfPlane> = lines.iter().map(|(_, line)| line).collect();
    let corners = empty::corners(&own);
    let window = empty::triangle(&corners).unwrap_or_else(|| {
        let centre = corners.first().cloned().unwrap_or_else(|| Point::origin().coordinates());
        view::around_lines(&centre, &own)
    });
    let mut panel = panel(main_frame(0, Page::of(options)), &window.asked_for(options), &names);
    let mut legend = Vec::new();
    let conflict = side.map(conflict).unwrap_or_default();
    let rows = conflict.rows.iter().map(|&row| (format!("allowed by row {row}"), Some(row), None));
    let conditions = conflict.conditions.iter().map(|&number| {
        let text = problem.problem().conditions.get(number - 1).map(|own| labels::condition(own.text()));
        (format!("condition {number}: {}", text.unwrap_or_default()), None, Some(number))
    });
    for ((name, row, condition), (fill, edge, dash)) in rows.chain(conditions).zip(STYLES.iter().cycle()) {
        let Some(side) = side else { break };
        let is_own = |bound: BoxBound| match bound {
            BoxBound::Slope(_) => true,
            BoxBound::Bound(name, _) => name.row() == row && name.condition() == condition,
        };
        let fill = Fill { colour: *fill, opacity: FILL };
        let stroke = Stroke::new(*edge, 1.0, *dash);
        let thick = Stroke { width: THICK, ..stroke };
        region::draw(&mut panel, &allowed(side, is_own), fill, stroke);
        let thick_lines = lines.iter().filter(|(bound, _)| is_own(*bound) && bound.name().is_some());
        thick_lines.for_each(|(_, line)| region::whole_line(&mut panel, line, thick));
        legend.push(LegendEntry::new(Swatch::area(fill, thick), name));
    }
    legend.extend(level(&mut panel));
    let mut notes = vec![asked(problem, options)];
    notes.extend(emptiness(problem, answer));
    let title = "Feasible parameter set under errors in x: empty".to_owned();
    finished(problem.problem(), options, title, vec![panel], legend, notes)
}

/// The boundaries that contradict each other.
fn bounds(side: &SideSet) -> Vec<(BoxBound, HalfPlane)> {
    let system = side.polyhedron.system().inequalities();
    let own = side.farkas().unwrap_or_default().into_iter().map(|own| own.index);
    let line = |index: usize| match system[index].constraint() {
        Constraint::HalfPlane(line) => Some((side.names[index], line)),
        Constraint::Always | Constraint::Never => None,
    };
    own.filter_map(line).collect()
}

/// Returns the set that some of the half-planes of a side leave.
fn allowed(side: &SideSet, is_own: impl Fn(BoxBound) -> bool) -> Polyhedron {
    let all = side.names.iter().zip(side.polyhedron.system().inequalities());
    Polyhedron::intersect(all.filter(|(name, _)| is_own(**name)).map(|(_, own)| own.clone()).collect())
}
