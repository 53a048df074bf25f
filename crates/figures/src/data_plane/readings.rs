//! The readings on a panel, thinned out where there are more than a panel has room for.

use std::collections::BTreeSet;

use boundfit_estimation::{BoundName, Fit, Measurement, Model, Problem};
use boundfit_exact::Rational;

use super::view::View;
use crate::clip::Place;
use crate::drawing::{Anchor, Panel};
use crate::figure::Figure;
use crate::labels::Conflict;
use crate::palette::{Dash, LIGHT_GREY, Mark, Shape, Stroke, VERMILLION, style};

/// Above so many readings marks thin out.
pub(crate) const MOST_MARKS: usize = 250;
/// Above so many readings error bars have no caps.
const MOST_CAPS: usize = 60;
/// How wide a column is in which the extreme readings are kept, in pixels.
const COLUMN: f64 = 3.0;
/// So many rows that fix the set are kept whatever the columns say.
const MOST_KEPT_BY_NAME: usize = 100;

/// A reading that is to be seen.
pub(crate) struct Shown {
    /// x, or the number of the row.
    pub(crate) abscissa: Rational,
    pub(crate) measurement: Measurement,
    pub(crate) fitted: bool,
    /// Kept when marks thin out.
    pub(crate) kept: bool,
    pub(crate) conflicting: bool,
}

/// The readings of a figure: those that are not fitted, too, but for [`Figure::Corridor`], which is about narrow gaps.
pub(crate) fn all(problem: &Problem, fit: &Fit, conflict: &Conflict, figure: Figure) -> Vec<Shown> {
    let active = active_rows(fit);
    let line = matches!(problem.measurements.model(), Model::Line { .. });
    let shown = |measurement: &Measurement, fitted: bool| {
        let conflicting = fitted && conflict.rows.contains(&measurement.row);
        Shown {
            abscissa: if line { measurement.regressor[0].clone() } else { Rational::from(measurement.row) },
            fitted,
            kept: fitted && (conflicting || active.contains(&measurement.row)),
            conflicting,
            measurement: measurement.clone(),
        }
    };
    let others = if figure == Figure::Corridor { &[] } else { problem.measurements.others() };
    let fitted = problem.measurements.rows().iter().map(|row| shown(row, true));
    others.iter().map(|row| shown(row, false)).chain(fitted).collect()
}

/// The rows whose bounds pass through a vertex: the first of each vertex, when there are many.
fn active_rows(fit: &Fit) -> BTreeSet<usize> {
    let row = |&index: &usize| match fit.fps.name(index) {
        BoundName::Upper(row) | BoundName::Lower(row) => Some(row),
        BoundName::Where(_) => None,
    };
    let vertices = fit.fps.polyhedron().region().vertices();
    let all: BTreeSet<usize> = vertices.iter().flat_map(|vertex| vertex.active()).filter_map(row).collect();
    all.into_iter().take(MOST_KEPT_BY_NAME).collect()
}

/// A reading on a panel.
struct Bar<'a> {
    shown: &'a Shown,
    at: f64,
    low: f64,
    middle: f64,
    high: f64,
}

/// Draws the readings of a view: others first, conflicting ones last.
pub(crate) fn draw(view: &View, panel: &mut Panel) {
    let readings = &view.scene.readings;
    let [across, up] = panel.coordinates();
    let bars: Vec<Bar> = readings
        .iter()
        .map(|shown| {
            let Measurement { response, epsilon, .. } = &shown.measurement;
            let middle = response - view.reference_at(&shown.measurement);
            Bar {
                shown,
                at: across.fraction(&shown.abscissa),
                low: up.fraction(&(&middle - epsilon)),
                high: up.fraction(&(&middle + epsilon)),
                middle: up.fraction(&middle),
            }
        })
        .filter(|bar| (0.0..=1.0).contains(&bar.at))
        .collect();
    let length = if view.scene.options.flip { panel.frame.height } else { panel.frame.width };
    let kept = thinned(&bars, length / COLUMN);
    let caps = if kept.len() <= MOST_CAPS { 3.0 / length } else { 0.0 };
    for conflicting in [false, true] {
        for bar in kept.iter().filter(|bar| bar.shown.conflicting == conflicting) {
            draw_bar(panel, bar, caps, kept.len() > MOST_MARKS / 2);
        }
    }
}

fn draw_bar(panel: &mut Panel, bar: &Bar, caps: f64, dense: bool) {
    let place = |across: f64, up: f64| -> Place { [across, up] };
    let middle = panel.oriented(place(bar.at, bar.middle));
    if !bar.shown.fitted {
        let shape = if dense { Shape::Square } else { Shape::Circle };
        let radius = if dense { 1.2 } else { style::OTHER.radius };
        panel.mark(middle, Mark { shape, radius, ..style::OTHER });
        return;
    }
    let (stroke, mark) = match (bar.shown.conflicting, dense) {
        (true, _) => (style::CONFLICT_BAR, style::CONFLICT),
        (false, false) => (style::READING_BAR, style::READING),
        (false, true) => {
            let thin = Stroke::new(LIGHT_GREY, 0.7, Dash::Solid);
            (thin, Mark { shape: Shape::Square, radius: 1.0, ..style::READING })
        }
    };
    if bar.high > bar.low {
        let ends = [bar.low, bar.high];
        panel.line(&ends.map(|up| place(bar.at, up)).map(|p| panel.oriented(p)), stroke);
        for up in ends.into_iter().filter(|_| caps > 0.0) {
            let cap = [place(bar.at - caps, up), place(bar.at + caps, up)].map(|p| panel.oriented(p));
            panel.line(&cap, stroke);
        }
    }
    panel.mark(middle, mark);
    if bar.shown.conflicting {
        let text = format!("row {}", bar.shown.measurement.row);
        let (end, up) = if bar.high < 0.88 { (bar.high, 1) } else { (bar.low, -1) };
        let (across, up) = if panel.is_flipped() { (up, 0) } else { (0, up) };
        panel.text(panel.oriented(place(bar.at, end)), text, Anchor { across, up }, VERMILLION);
    }
}

/// Of each column the reading that reaches highest and the one that reaches lowest, and those that are kept anyway;
/// all when there are few.
fn thinned<'a, 'b>(bars: &'b [Bar<'a>], columns: f64) -> Vec<&'b Bar<'a>> {
    if bars.len() <= MOST_MARKS {
        return bars.iter().collect();
    }
    let mut kept: BTreeSet<usize> = BTreeSet::new();
    for fitted in [false, true] {
        let mut extremes: Vec<Option<[usize; 2]>> = vec![None; columns as usize + 2];
        for (index, bar) in bars.iter().enumerate().filter(|(_, bar)| bar.shown.fitted == fitted) {
            let column = (bar.at * columns) as usize;
            let [lowest, highest] = extremes[column].get_or_insert([index, index]);
            if bar.low < bars[*lowest].low {
                *lowest = index;
            }
            if bar.high > bars[*highest].high {
                *highest = index;
            }
        }
        kept.extend(extremes.into_iter().flatten().flatten());
    }
    kept.extend(bars.iter().enumerate().filter(|(_, bar)| bar.shown.kept).map(|(index, _)| index));
    kept.into_iter().map(|index| &bars[index]).collect()
}
