//! Figures of the parameter plane: the feasible parameter set, its boxes, estimates and approximations.

mod directions;
mod empty;
mod fps;
mod marks;
mod region;
mod sliver;
#[cfg(test)]
mod tests;
mod view;

pub(crate) use directions::drawing as directions;
pub(crate) use fps::drawing as fps;

use boundfit_estimation::{Fit, Problem};
use boundfit_exact::{Endpoint, Rational, Rounding};
use boundfit_geometry::{Region, RegionKind};

use crate::axis::Axis;
use crate::drawing::{Drawing, Frame, LegendEntry, Panel};
use crate::figure::PlotOptions;
use crate::labels;
use crate::render::{BOTTOM_LABELS, LEFT_LABELS, WIDTH};
use view::Window;

const TOP: f64 = 24.0;
const HEIGHT: f64 = 430.0;
const LEFT: f64 = LEFT_LABELS + 16.0;
const RIGHT: f64 = 22.0;
/// Side of a panel beside the main one.
const SIDE: f64 = 178.0;

/// The frame of the main panel, beside so many smaller ones.
fn main_frame(beside: usize) -> Frame {
    let room = WIDTH - LEFT - RIGHT;
    let width = if beside == 0 { room } else { room - SIDE - LEFT_LABELS - 18.0 };
    Frame { left: LEFT, top: TOP, width, height: HEIGHT }
}

/// The frame of a smaller panel on the right.
fn side_frame(index: usize) -> Frame {
    let top = TOP + index as f64 * (HEIGHT - SIDE);
    Frame { left: WIDTH - RIGHT - SIDE, top, width: SIDE, height: SIDE }
}

/// An empty panel of both parameters.
fn panel(frame: Frame, window: &Window, names: &[String; 2]) -> Panel {
    let most = if frame.width > 2.0 * SIDE { [frame.width / 75.0, frame.height / 40.0] } else { [3.0, 4.0] };
    let axes = [0, 1].map(|j| {
        let [lower, upper] = &window.0[j];
        Axis::new(names[j].clone(), lower, upper, most[j] as usize)
    });
    Panel::new(frame, axes, false)
}

/// The kind of a set in words: `polygon with 6 vertices`.
fn kind(region: &Region) -> String {
    let name = region.kind().name();
    match region.kind() {
        RegionKind::Polygon | RegionKind::UnboundedPolygon => {
            let count = region.vertices().len();
            let noun = if count == 1 { "vertex" } else { "vertices" };
            format!("{} with {count} {noun}", name.replace('-', " "))
        }
        RegionKind::Empty => name.to_owned(),
        RegionKind::Plane => "the whole plane".to_owned(),
        _ => format!("a {name}"),
    }
}

/// A figure with all its parts; the first panel is the tallest.
fn finished(
    problem: &Problem,
    options: &PlotOptions,
    title: String,
    panels: Vec<Panel>,
    legend: Vec<LegendEntry>,
    notes: Vec<String>,
) -> Drawing {
    let axes = described_axes(&labels::parameters(problem, options));
    let main = panels[0].frame;
    Drawing {
        description: format!("{title}. {axes} {}", notes.join(" ")),
        title,
        subtitle: labels::subtitle(problem, options),
        height: main.top + main.height + BOTTOM_LABELS + 8.0,
        panels,
        legend,
        notes,
    }
}

/// What the axes are called in the description of a figure.
fn described_axes(names: &[String; 2]) -> String {
    format!("Horizontal axis: {}. Vertical axis: {}.", names[0], names[1])
}

/// Significant digits of the ends of intervals.
const DIGITS: usize = 5;

/// The parameter uncertainty intervals in words; nothing when they are unbounded on all sides.
fn pui_note(fit: &Fit, names: &[String; 2]) -> Option<String> {
    let intervals = fit.pui_intervals()?;
    let ends = || {
        intervals.iter().flat_map(|interval| [interval.lower(), interval.upper()]).filter_map(Endpoint::value)
    };
    ends().next()?;
    let rounded =
        |end: &Rational| end.to_decimal(DIGITS, Rounding::Down) != end.to_decimal(DIGITS, Rounding::Up);
    let text = |end: &Endpoint, digits, rounding, unbounded: &str| {
        end.value().map_or_else(|| unbounded.to_owned(), |value| labels::number(value, digits, rounding))
    };
    let each = [0, 1].map(|j| {
        let digits = intervals[j].resolving_digits(DIGITS);
        let lower = text(intervals[j].lower(), digits, Rounding::Down, "−∞");
        let upper = text(intervals[j].upper(), digits, Rounding::Up, "∞");
        let (symbol, unit) = names[j].split_once(' ').unwrap_or((&names[j], ""));
        format!("{symbol} from {lower} to {upper} {}", unit.trim_matches(['[', ']'])).trim_end().to_owned()
    });
    let remark = if ends().any(rounded) { " (ends rounded outward)" } else { "" };
    Some(format!("PUI: {}; {}{remark}.", each[0], each[1]))
}
