//! The readings on a panel, thinned out where there are more than a panel has room for.

use std::collections::BTreeSet;

use boundfit_estimation::Bounds;
use boundfit_exact::Rational;

use super::sample::columns;
use super::scene::Shown;
use super::view::View;
use crate::clip::Place;
use crate::drawing::{Anchor, Panel};
use crate::palette::{INK, Mark, Stroke, style};

/// The number of readings above which error bars have no caps.
const MOST_CAPS: usize = 60;

/// The length by which a bar without a bound on one side goes on beyond the known end, in parts of the panel.
const OPEN_END: f64 = 0.06;

/// A reading on a panel.
pub(crate) struct Bar<'a> {
    shown: &'a Shown,
    at: f64,
    low: f64,
    middle: f64,
    high: f64,
    /// `true` if there is no bound below, and none above.
    is_open: [bool; 2],
}

/// Error bar and mark of fitted readings.
pub(crate) fn style_of_fitted(dense: bool) -> (Stroke, Mark) {
    if dense { (style::DENSE_BAR, style::DENSE_READING) } else { (style::READING_BAR, style::READING) }
}

/// The mark of readings that are not fitted.
pub(crate) fn style_of_other(dense: bool) -> Mark {
    if dense { style::DENSE_OTHER } else { style::OTHER }
}

/// The readings of a view, as far as they are beside its panel's axis of x.
pub(crate) fn bars<'a>(view: &View<'a>, panel: &Panel) -> Vec<Bar<'a>> {
    let [across, up] = panel.coordinates();
    // The bound is mostly the same for all.
    let mut last: Option<(&Rational, f64)> = None;
    let mut half_of = |epsilon: &'a Rational| match last {
        Some((known, half)) if known == epsilon => half,
        _ => {
            let half = epsilon.checked_div(up.width()).unwrap_or_default().to_f64();
            last = Some((epsilon, half));
            half
        }
    };
    let bar = |shown: &'a Shown| {
        let middle = up.fraction(view.value(shown));
        let at = across.fraction(&shown.abscissa);
        if let Bounds::Around { epsilon, .. } = &shown.measurement.bounds {
            let half = half_of(epsilon);
            return Bar { shown, at, low: middle - half, middle, high: middle + half, is_open: [false; 2] };
        }
        let [lower, upper] = view.ends(shown).map(|end| end.map(|end| up.fraction(&end)));
        let is_open = [lower.is_none(), upper.is_none()];
        let low = lower.unwrap_or_else(|| middle.min(upper.unwrap_or(middle)) - OPEN_END);
        let high = upper.unwrap_or_else(|| middle.max(lower.unwrap_or(middle)) + OPEN_END);
        Bar { shown, at, low, middle, high, is_open }
    };
    let bars = view.scene.readings.iter().map(bar);
    bars.filter(|bar| (0.0..=1.0).contains(&bar.at)).collect()
}

/// Length of the axis of x in pixels.
fn length(panel: &Panel) -> f64 {
    if panel.is_flipped() { panel.frame.height } else { panel.frame.width }
}

/// Draws, for readings that are thinned out, how far they reach in every column with their bounds.
pub(crate) fn shade(view: &View, panel: &mut Panel, bars: &[Bar]) {
    if !view.scene.is_crowded() {
        return;
    }
    let columns = columns(length(panel));
    // Neighbours overlap by half a pixel, or the paper would shine through.
    let overlap = 0.25 / length(panel);
    for (column, extremes) in extremes(bars, columns, true).into_iter().enumerate() {
        let Some([lowest, highest]) = extremes else { continue };
        let (low, high) = (bars[lowest].low, bars[highest].high);
        let (from, to) = (column as f64 / columns - overlap, (column as f64 + 1.0) / columns + overlap);
        let corners = [[from, low], [to, low], [to, high], [from, high]];
        panel.area(&corners.map(|corner| panel.oriented(corner)), style::ALL_READINGS);
    }
}

/// Draws readings of a view: for each flag in turn those that are conflicting or those that are not.
pub(crate) fn draw(view: &View, panel: &mut Panel, bars: &[Bar], in_turn: &[bool]) {
    let kept: Vec<&Bar> =
        if view.scene.is_crowded() { thinned(bars, columns(length(panel))) } else { bars.iter().collect() };
    let caps = if kept.len() <= MOST_CAPS { 3.0 / length(panel) } else { 0.0 };
    let dense = view.scene.is_dense();
    for &conflicting in in_turn {
        let drawn = || kept.iter().filter(|bar| bar.shown.conflicting == conflicting);
        // Many bars would cover each other's marks.
        if dense {
            drawn().for_each(|bar| draw_bar(panel, bar, caps, dense));
            drawn().for_each(|bar| draw_mark(panel, bar, dense));
        } else {
            drawn().for_each(|bar| {
                draw_bar(panel, bar, caps, dense);
                draw_mark(panel, bar, dense);
            });
        }
    }
}

/// Bar and mark of a fitted reading.
fn style_of(bar: &Bar, dense: bool) -> (Stroke, Mark) {
    if bar.shown.conflicting { (style::CONFLICT_BAR, style::CONFLICT) } else { style_of_fitted(dense) }
}

fn draw_bar(panel: &mut Panel, bar: &Bar, caps: f64, dense: bool) {
    let place = |across: f64, up: f64| -> Place { [across, up] };
    if !bar.shown.fitted {
        return;
    }
    let (stroke, _) = style_of(bar, dense);
    if bar.high > bar.low {
        let ends = [bar.low, bar.high];
        panel.line(&ends.map(|up| place(bar.at, up)).map(|p| panel.oriented(p)), stroke);
        for (up, is_open, inwards) in [(bar.low, bar.is_open[0], 1.0), (bar.high, bar.is_open[1], -1.0)] {
            if caps > 0.0 {
                // An arrow head where the bar goes on without end.
                let back = if is_open { inwards * OPEN_END / 3.0 } else { 0.0 };
                let cap =
                    [place(bar.at - caps, up + back), place(bar.at, up), place(bar.at + caps, up + back)];
                let cap = cap.map(|p| panel.oriented(p));
                if is_open { panel.line(&cap, stroke) } else { panel.line(&[cap[0], cap[2]], stroke) }
            }
        }
    }
}

fn draw_mark(panel: &mut Panel, bar: &Bar, dense: bool) {
    let middle = panel.oriented([bar.at, bar.middle]);
    if !bar.shown.fitted {
        panel.mark(middle, style_of_other(dense));
        return;
    }
    // Bounds without a y have nothing between them to be marked.
    if bar.shown.measurement.response().is_some() || bar.high <= bar.low {
        panel.mark(middle, style_of(bar, dense).1);
    }
    if bar.shown.conflicting {
        label(panel, bar);
    }
}

/// The number of a conflicting reading's row beyond its bar and mark, above or, where there is no room, below; to the
/// side when flipped.
fn label(panel: &mut Panel, bar: &Bar) {
    const LINE: f64 = 19.0;
    let text = format!("row {}", bar.shown.measurement.row);
    let length = if panel.is_flipped() { panel.frame.width } else { panel.frame.height };
    let room = if panel.is_flipped() { LINE * 3.0 } else { LINE };
    let radius = style::CONFLICT.radius / length;
    let (high, low) = (bar.high.max(bar.middle + radius), bar.low.min(bar.middle - radius));
    let above = (1.0 - high) * length > room || low * length <= room;
    let (end, up) = if above { (high, 1.0) } else { (low, -1.0) };
    let (across, up) = if panel.is_flipped() { (up, 0.0) } else { (0.0, up) };
    panel.text(panel.oriented([bar.at, end]), text, Anchor { across, up }, INK);
}

/// Thins out readings. Among readings that are not fitted it keeps the one that reaches highest and the one that
/// reaches lowest in each column. Among fitted readings, which are counted as well, it keeps those that are kept
/// anyway.
fn thinned<'a, 'b>(bars: &'b [Bar<'a>], columns: f64) -> Vec<&'b Bar<'a>> {
    let mut kept: BTreeSet<usize> = BTreeSet::new();
    kept.extend(extremes(bars, columns, false).into_iter().flatten().flatten());
    kept.extend(bars.iter().enumerate().filter(|(_, bar)| bar.shown.kept).map(|(index, _)| index));
    kept.into_iter().map(|index| &bars[index]).collect()
}

/// The lowest and the highest reading of each column, among those that are fitted or those that are not.
fn extremes(bars: &[Bar], columns: f64, fitted: bool) -> Vec<Option<[usize; 2]>> {
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
    extremes
}
