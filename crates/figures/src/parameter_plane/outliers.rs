//! The remaining set without outliers: as many convex sets as there are ways to leave so few readings out.

use boundfit_estimation::{Problem, half_planes};
use boundfit_exact::english::{counted, ranges};
use boundfit_geometry::{Constraint, HalfPlane};
use boundfit_questions::{Outliers, Piece};

use super::layout::{finished, main_frame, panel};
use super::sliver::Sliver;
use super::{marks, region, view};
use crate::drawing::{Anchor, Drawing, LegendEntry, Panel, Swatch};
use crate::figure::PlotOptions;
use crate::labels;
use crate::outside::{unseen_sets, without_end};
use crate::page::Page;
use crate::palette::{BLUE, Dash, ORANGE, Stroke, style};

/// Sets that are drawn, numbered, and told with their rows below the figure.
const MOST_DRAWN: usize = 1000;
const MOST_NUMBERED: usize = 12;
const MOST_TOLD: usize = 5;
/// Readings left out whose bounds are drawn.
const MOST_BOUNDS: usize = 8;
/// Rows of one set that are told.
const MOST_ROWS: usize = 24;

/// The bounds of readings that are left out.
const PASSED: Stroke = Stroke::new(ORANGE, 1.2, Dash::Short);

/// The figure.
pub(crate) fn drawing(problem: &Problem, outliers: &Outliers, options: &PlotOptions) -> Drawing {
    let names = labels::axes_of_parameters(problem, options);
    let pieces = outliers.pieces.get(..MOST_DRAWN).unwrap_or(&outliers.pieces);
    let regions = || pieces.iter().map(|piece| piece.left.polyhedron().region());
    let sliver = match pieces {
        [only] => Sliver::of(only.left.polyhedron().region()),
        _ => None,
    };
    let mut main = panel(
        main_frame(usize::from(sliver.is_some()), Page::of(options)),
        &view::of_regions(regions(), pieces.len() > 1).asked_for(options),
        &names,
    );
    let mut legend = vec![LegendEntry::new(Swatch::area(style::SET_FILL, style::SET_EDGE), left(outliers))];
    if bounds_passed(problem, pieces, &mut main) {
        legend.push(LegendEntry::new(Swatch::line(PASSED), "bounds of the readings left out"));
    }
    if let Some(intervals) = outliers.pui().filter(|_| pieces.len() > 1) {
        marks::draw_box(&mut main, &intervals, None, style::PUI_EDGE);
        legend.push(LegendEntry::new(Swatch::line(style::PUI_EDGE), "PUI box over all of them"));
    }
    for piece in pieces {
        region::draw(&mut main, piece.left.polyhedron(), style::SET_FILL, style::SET_EDGE);
    }
    if let [only] = pieces {
        marks::draw_vertices(&mut main, only.left.polyhedron().region(), sliver.is_none());
    } else {
        mark_pieces(&mut main, pieces);
    }
    let mut notes = told(outliers);
    notes.extend(unseen_sets(&main, pieces.iter().map(|piece| piece.left.polyhedron()), options));
    let mut panels = vec![main];
    if let Some(sliver) = sliver {
        panels.push(marks::thin(sliver.panel(0, Page::of(options)), &sliver, regions()));
        notes.push(Sliver::note("the set"));
    }
    notes.extend(without_end(regions()));
    let all = problem.measurements.fitted();
    let title = format!("Least number of readings to leave out: {} of {all}", outliers.least);
    finished(problem, options, title, panels, legend, notes)
}

/// Returns the meaning of the filled areas.
fn left(outliers: &Outliers) -> String {
    match (outliers.least, outliers.pieces.len()) {
        (0, _) => "feasible parameter set (FPS): nothing has to be left out".to_owned(),
        (_, 1) => "parameters that agree with all other readings".to_owned(),
        (least, _) => {
            format!("parameters that agree with all readings but {least}, by the number of the set")
        }
    }
}

/// Draws the bounds of the readings that are left out, where they are few.
fn bounds_passed(problem: &Problem, pieces: &[Piece], panel: &mut Panel) -> bool {
    let mut rows: Vec<usize> = pieces.iter().flat_map(|piece| piece.rows.iter().copied()).collect();
    rows.sort_unstable();
    rows.dedup();
    if rows.len() > MOST_BOUNDS {
        return false;
    }
    let readings = problem.measurements.kept().iter().filter(|reading| rows.contains(&reading.row));
    let lines: Vec<HalfPlane> = readings
        .flat_map(half_planes)
        .filter_map(|(_, inequality)| match inequality.constraint() {
            Constraint::HalfPlane(half_plane) => Some(half_plane),
            Constraint::Always | Constraint::Never => None,
        })
        .collect();
    lines.iter().for_each(|line| region::whole_line(panel, line, PASSED));
    !lines.is_empty()
}

/// Numbers the sets where they are few; one that is too small to be seen is a dot.
fn mark_pieces(panel: &mut Panel, pieces: &[Piece]) {
    const LEAST: f64 = 6.0;
    for (number, piece) in (1..).zip(pieces) {
        let region = piece.left.polyhedron().region();
        let places = region::places(panel, region);
        let extent = |axis: usize| {
            let along = || places.iter().map(|place| place[axis]);
            along().fold(f64::NEG_INFINITY, f64::max) - along().fold(f64::INFINITY, f64::min)
        };
        let size = [extent(0) * panel.frame.width, extent(1) * panel.frame.height];
        if region.is_bounded() && size[0].max(size[1]) < LEAST {
            places.iter().take(1).for_each(|place| panel.mark(*place, style::VERTEX));
        }
        let witness = region.witness().map(|point| region::at(panel, &point.coordinates()));
        let highest = places.into_iter().max_by(|p, q| (p[0] + p[1]).total_cmp(&(q[0] + q[1])));
        if let Some(at) = highest.or(witness).filter(|_| pieces.len() <= MOST_NUMBERED) {
            let slant = std::f64::consts::FRAC_1_SQRT_2;
            panel.text(at, number.to_string(), Anchor { across: slant, up: slant }, BLUE);
        }
    }
}

/// The rows of the first sets in words.
fn told(outliers: &Outliers) -> Vec<String> {
    if outliers.least == 0 {
        return Vec::new();
    }
    let rows = |piece: &Piece| {
        let more = piece.rows.len().saturating_sub(MOST_ROWS);
        let rows = ranges(piece.rows.get(..MOST_ROWS).unwrap_or(&piece.rows));
        let noun = if piece.rows.len() == 1 { "row" } else { "rows" };
        let more = if more > 0 { format!(" and {more} more") } else { String::new() };
        format!("{noun} {rows}{more}")
    };
    if let [only] = outliers.pieces.as_slice() {
        return vec![format!("Left out: {}.", rows(only))];
    }
    let first = (1..).zip(&outliers.pieces).take(MOST_TOLD);
    let mut told: Vec<String> =
        first.map(|(number, piece): (usize, &Piece)| format!("{number}: without {}.", rows(piece))).collect();
    let more = outliers.pieces.len().saturating_sub(MOST_TOLD);
    if more > 0 {
        let so_far = if outliers.is_complete { "" } else { " at least" };
        told.push(format!("And {}{so_far}.", counted(more, "more set", "more sets")));
    }
    told
}
