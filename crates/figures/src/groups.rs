//! Small multiples: a panel for each group of readings, all with the same axes.

use boundfit_exact::Foreign;
use boundfit_exact::english::counted;

use crate::axis::Axis;
use crate::drawing::{Drawing, Frame, Panel};
use crate::figure::PlotOptions;
use crate::page::Page;
use crate::render::{BOTTOM_LABELS, LEFT_LABELS};
use crate::series::{self, Compared, Series};
use crate::text::one_line;
use crate::{data_plane, parameter_plane};

/// More groups than this are not drawn: panels would be too small, or the page too long.
pub const MOST_PANELS: usize = 24;

const TOP: f64 = 26.0;
const LEFT: f64 = LEFT_LABELS + 16.0;
const RIGHT: f64 = 22.0;
/// The gaps between panels: side by side, and above each other with a heading that may stand above the scale of an
/// axis.
const GAPS: [f64; 2] = [22.0, 38.0];
/// Panels that are narrower stand below each other.
const NARROWEST: f64 = 95.0;
/// The approximate width of a letter of a scale, and of the beginning of a name.
const LETTER: f64 = 6.5;
const NAME: f64 = 34.0;
/// The height of a panel in parts of its width, and the highest.
const HIGH: f64 = 0.78;
const HIGHEST: f64 = 250.0;

/// The figure: of so many groups in all those given, at most [`MOST_PANELS`].
pub(crate) fn drawing(
    groups: &[Series],
    by: &Foreign,
    all: usize,
    what: Compared,
    options: &PlotOptions,
) -> Drawing {
    let groups = groups.get(..MOST_PANELS).unwrap_or(groups);
    let page = Page::of(options);
    let mut columns = columns(groups.len(), page);
    let (frames, (mut panels, legend, mut notes)) = loop {
        let frames = frames(groups.len(), columns, page);
        let parts = match what {
            Compared::Sets => parameter_plane::panels(groups, &frames, options),
            Compared::Readings => data_plane::panels(groups, &frames, options),
        };
        // The axes of all panels are the same.
        if columns == 1 || parts.0.first().is_none_or(has_room_for_scales) {
            break (frames, parts);
        }
        columns -= 1;
    };
    for (index, panel) in panels.iter_mut().enumerate() {
        panel.labelled = [index + columns >= groups.len(), index % columns == 0];
    }
    let by = one_line(by, 40);
    let shown = match what {
        Compared::Sets => "Feasible parameter sets",
        Compared::Readings => "Readings",
    };
    let title = format!("{shown} by {by}: {}", counted(all, "group", "groups"));
    if all > groups.len() {
        notes.insert(
            0,
            format!("Drawn are the first {} of {all} groups, in the order of rows.", groups.len()),
        );
    }
    let names: Vec<String> =
        panels.iter().map(|panel| format!("{}{}", panel.heading, panel.finding)).collect();
    let bottom = frames.iter().map(|frame| frame.top + frame.height).fold(0.0, f64::max);
    Drawing {
        description: format!(
            "{title}. A panel for each group, all with the same axes: {}. {}",
            names.join("; "),
            notes.join(" ")
        ),
        title,
        subtitle: series::subtitle(groups, options),
        height: bottom + BOTTOM_LABELS + 8.0,
        panels,
        legend,
        notes,
    }
}

/// Returns whether a panel is wide enough for what its ticks are to be multiplied with and moved by, and for some of the name beside that.
fn has_room_for_scales(panel: &Panel) -> bool {
    let width = |axis: &Axis| LETTER * axis.scale().chars().count() as f64;
    let [horizontal, vertical] = panel.axes.each_ref().map(width);
    let name = if panel.axes[0].name.is_empty() { 0.0 } else { NAME };
    horizontal + name <= panel.frame.width && vertical <= panel.frame.width
}

/// Returns the number of panels side by side.
fn columns(count: usize, page: Page) -> usize {
    let wished = match count {
        0 | 1 => 1,
        2 | 4 => 2,
        3 | 5 | 6 | 9 => 3,
        _ => 4,
    };
    let room = ((page.width - LEFT - RIGHT + GAPS[0]) / (NARROWEST + GAPS[0])) as usize;
    wished.min(room.max(1))
}

/// Returns the places of the panels, row by row.
fn frames(count: usize, columns: usize, page: Page) -> Vec<Frame> {
    let width = (page.width - LEFT - RIGHT - (columns - 1) as f64 * GAPS[0]) / columns as f64;
    let height = (width * HIGH).min(HIGHEST);
    let frame = |index: usize| {
        let (row, column) = ((index / columns) as f64, (index % columns) as f64);
        // A panel whose lower neighbour is missing has its labels between the rows.
        Frame { left: LEFT + column * (width + GAPS[0]), top: TOP + row * (height + GAPS[1]), width, height }
    };
    (0..count).map(frame).collect()
}
