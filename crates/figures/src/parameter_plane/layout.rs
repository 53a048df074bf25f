//! Frames, panels and words that all figures of the parameter plane share.

use boundfit_estimation::Problem;

use super::view::Window;
use crate::axis::Axis;
use crate::drawing::{Drawing, Frame, LegendEntry, Panel};
use crate::figure::PlotOptions;
use crate::labels;
use crate::render::{BOTTOM_LABELS, LEFT_LABELS, WIDTH};

const TOP: f64 = 24.0;
const HEIGHT: f64 = 430.0;
const LEFT: f64 = LEFT_LABELS + 16.0;
const RIGHT: f64 = 22.0;
/// Side of a panel beside the main one.
const SIDE: f64 = 178.0;

/// The frame of the main panel, with this many smaller ones beside it.
pub(super) fn main_frame(beside: usize) -> Frame {
    let room = WIDTH - LEFT - RIGHT;
    let width = if beside == 0 { room } else { room - SIDE - LEFT_LABELS - 18.0 };
    Frame { left: LEFT, top: TOP, width, height: HEIGHT }
}

/// The frame of a smaller panel on the right.
pub(super) fn side_frame(index: usize) -> Frame {
    let top = TOP + index as f64 * (HEIGHT - SIDE);
    Frame { left: WIDTH - RIGHT - SIDE, top, width: SIDE, height: SIDE }
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

/// A figure with all its parts; the first panel is the tallest.
pub(super) fn finished(
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
