//! Frames, panels and words that all figures of the parameter plane share.

use boundfit_estimation::Problem;

use super::view::Window;
use crate::axis::Axis;
use crate::drawing::{Drawing, Frame, LegendEntry, Panel};
use crate::figure::PlotOptions;
use crate::labels;
use crate::page::Page;
use crate::render::{BOTTOM_LABELS, LEFT_LABELS};

const TOP: f64 = 24.0;
const HEIGHT: f64 = 430.0;
const LEFT: f64 = LEFT_LABELS + 16.0;
const RIGHT: f64 = 22.0;
/// Side of a panel beside the main one.
const SIDE: f64 = 178.0;

/// The distance from one panel to the next one below it: labels, and a heading.
const BETWEEN: f64 = BOTTOM_LABELS + 34.0;

/// The frame of the main panel, with this many smaller ones beside it, which narrow pages have below it.
pub(super) fn main_frame(beside: usize, page: Page) -> Frame {
    let room = page.width - LEFT - RIGHT;
    let is_wide = beside == 0 || page.is_narrow();
    let width = if is_wide { room } else { room - SIDE - LEFT_LABELS - 18.0 };
    Frame { left: LEFT, top: TOP, width, height: page.height(HEIGHT) }
}

/// The frame of a smaller panel, on the right or below.
pub(super) fn side_frame(index: usize, page: Page) -> Frame {
    let height = page.height(HEIGHT);
    if page.is_narrow() {
        let top = TOP + height + BETWEEN + index as f64 * (SIDE + BETWEEN);
        return Frame { left: LEFT, top, width: page.width - LEFT - RIGHT, height: SIDE };
    }
    let top = TOP + index as f64 * (height - SIDE);
    Frame { left: page.width - RIGHT - SIDE, top, width: SIDE, height: SIDE }
}

/// An empty panel of both parameters.
pub(super) fn panel(frame: Frame, window: &Window, names: &[String; 2]) -> Panel {
    let most = if frame.width > 2.0 * SIDE { [frame.width / 75.0, frame.height / 40.0] } else { [3.0, 4.0] };
    let axes = [0, 1].map(|j| {
        let [lower, upper] = &window.0[j];
        Axis::new(names[j].clone(), lower, upper, most[j] as usize)
    });
    Panel::new(frame, axes, false)
}

/// A figure with all its parts.
pub(super) fn finished(
    problem: &Problem,
    options: &PlotOptions,
    title: String,
    panels: Vec<Panel>,
    legend: Vec<LegendEntry>,
    notes: Vec<String>,
) -> Drawing {
    let axes = described_axes(&labels::axes_of_parameters(problem, &labels::described(options)));
    let bottoms = panels.iter().map(|panel| panel.frame.top + panel.frame.height);
    let bottom = bottoms.fold(0.0, f64::max);
    Drawing {
        description: format!("{title}. {axes} {}", notes.join(" ")),
        title,
        subtitle: labels::subtitle(problem, options),
        height: bottom + BOTTOM_LABELS + 8.0,
        panels,
        legend,
        notes,
    }
}

/// The names of axes in the description of a figure.
fn described_axes(names: &[String; 2]) -> String {
    format!("Horizontal axis: {}. Vertical axis: {}.", names[0], names[1])
}
