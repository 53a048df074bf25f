//! One panel: grid, axes and items.

use plotters::chart::{ChartBuilder, LabelAreaPosition};
use plotters::style::{Color, TRANSPARENT};

use super::brush::{Brush, rgb, text_style};
use super::canvas::{CanvasResult, FINE};
use super::placing::{self, Label};
use super::written::{Align, Pixel, Rectangle, Written};
use crate::axis::Axis;
use crate::clip::Place;
use crate::drawing::{Frame, Item, Panel};
use crate::palette::{Colour, Dash, FAINT_INK, FRAME, GRID, INK, Stroke};

pub(super) const LABEL_SIZE: f64 = 11.5;
pub(super) const NAME_SIZE: f64 = 12.5;
/// Room for labels and name left of a panel.
pub(crate) const LEFT_LABELS: f64 = 66.0;
/// Room for labels and name below a panel.
pub(crate) const BOTTOM_LABELS: f64 = 42.0;
pub(super) const TICK: f64 = 4.0;
/// The height above a panel of its heading and of the scale of its vertical axis.
const ABOVE: f64 = 9.0;
/// Least distance between two texts side by side.
const APART: f64 = 10.0;

pub(super) fn draw(brush: &Brush, panel: &Panel, top: f64) -> CanvasResult {
    let frame = frame_below(panel, top);
    mesh(brush, panel, frame)?;
    for item in &panel.items {
        self::item(brush, item, frame)?;
    }
    let Frame { left, top, width, height } = frame;
    let corners =
        [[left, top], [left + width, top], [left + width, top + height], [left, top + height], [left, top]];
    brush.line(&corners, Stroke::new(FRAME, 0.9, Dash::Solid))?;
    texts(brush, panel, frame)?.iter().try_for_each(|text| brush.write(text))
}

/// The rectangle of a panel whose header is so high.
pub(super) fn frame_below(panel: &Panel, top: f64) -> Frame {
    Frame { top: panel.frame.top + top, ..panel.frame }
}

/// All texts around and in a panel but for ticks and the name of the vertical axis.
pub(super) fn texts(brush: &Brush, panel: &Panel, frame: Frame) -> CanvasResult<Vec<Written>> {
    let Frame { left, top, width, .. } = frame;
    let [horizontal, vertical] = &panel.axes;
    let mut texts = Vec::new();
    if panel.labelled[0] {
        texts.extend(name_below(brush, horizontal, frame)?);
    }
    let mut scale_width = 0.0;
    if panel.labelled[1] {
        let text = brush.fitted(vertical.scale(), LABEL_SIZE, width)?;
        scale_width = brush.text_width(&text, LABEL_SIZE)?;
        let at = [left, top - ABOVE];
        texts.push(written(at, text, (LABEL_SIZE, FAINT_INK), Align::Start));
    }
    let room = width - brush.text_width(panel.finding, NAME_SIZE)?;
    let text = brush.fitted(&panel.heading, NAME_SIZE, room)? + panel.finding;
    let heading_width = brush.text_width(&text, NAME_SIZE)?;
    let free = (width - heading_width) / 2.0;
    let raised = if scale_width > 0.0 && free < scale_width + APART { 15.0 } else { 0.0 };
    let at = [left + width / 2.0, top - ABOVE - raised];
    texts.push(written(at, text, (NAME_SIZE, INK), Align::Middle));
    let above = [([left, top - ABOVE], scale_width), ([left + free, top - ABOVE - raised], heading_width)];
    let above = above.into_iter().filter(|(_, width)| *width > 0.0);
    texts.extend(labels(
        brush,
        panel,
        frame,
        above.map(|(at, width)| Rectangle::of_text(at, width)).collect(),
    )?);
    Ok(texts)
}

fn written(at: Pixel, text: String, (size, colour): (f64, Colour), align: Align) -> Written {
    Written { at, text, size, colour, align, plate: None }
}

/// The texts among the items, beside what they belong to.
fn labels(brush: &Brush, panel: &Panel, frame: Frame, taken: Vec<Rectangle>) -> CanvasResult<Vec<Written>> {
    let texts = || {
        panel.items.iter().filter_map(|item| match item {
            Item::Text { at, text, anchor, colour } => Some((*at, text, *anchor, *colour)),
            _ => None,
        })
    };
    let mut wanted = Vec::new();
    for (place, text, anchor, _) in texts() {
        let width = brush.text_width(text, LABEL_SIZE)?;
        wanted.push(Label { place, at: pixel(place, frame), anchor, width });
    }
    let marks = panel.items.iter().filter_map(|item| match item {
        Item::Mark { at, mark } => Some(Rectangle::around(pixel(*at, frame), mark.radius)),
        _ => None,
    });
    let found = placing::placed(&wanted, taken, &marks.collect::<Vec<_>>(), frame, brush.page_width());
    let label =
        |((at, label), (_, text, _, colour)): ((Pixel, &Label), (Place, &String, _, Colour))| Written {
            plate: Some(Rectangle::of_text(at, label.width)),
            ..written(at, text.clone(), (LABEL_SIZE, colour), Align::Start)
        };
    Ok(found.into_iter().zip(&wanted).zip(texts()).map(label).collect())
}

/// Returns the place on the canvas of a place in the panel.
pub(super) fn pixel([x, y]: Place, frame: Frame) -> Pixel {
    [frame.left + x * frame.width, frame.top + (1.0 - y) * frame.height]
}

/// The scale of the horizontal axis, and its name in the middle, or where the scale leaves no room for that, at the left.
fn name_below(brush: &Brush, axis: &Axis, frame: Frame) -> CanvasResult<[Written; 2]> {
    let Frame { left, top, width, height } = frame;
    let below = top + height + BOTTOM_LABELS - 8.5;
    // Without its scale an axis would be wrong; of its name some is enough.
    let scale = brush.fitted(axis.scale(), LABEL_SIZE, width)?;
    let scale_width = if scale.is_empty() { 0.0 } else { brush.text_width(&scale, LABEL_SIZE)? + APART };
    let scale = written([left + width, below], scale, (LABEL_SIZE, FAINT_INK), Align::End);
    let name = brush.fitted(&axis.name, NAME_SIZE, width - scale_width)?;
    let free = (width - brush.text_width(&name, NAME_SIZE)?) / 2.0;
    let (at, align) = match free < scale_width {
        true => ([left, below], Align::Start),
        false => ([left + width / 2.0, below], Align::Middle),
    };
    Ok([scale, written(at, name, (NAME_SIZE, INK), align)])
}

/// Grid lines, tick labels and the name of the vertical axis, by plotters.
fn mesh(brush: &Brush, panel: &Panel, frame: Frame) -> CanvasResult {
    let fine = |length: f64| (length * FINE).round() as i32;
    let [left, bottom] = [LEFT_LABELS, BOTTOM_LABELS];
    let origin = (fine(frame.left - left), fine(frame.top));
    let size = (fine(left + frame.width), fine(frame.height + bottom));
    let area = brush.canvas.clone().shrink(origin, (size.0 as u32, size.1 as u32));
    let [horizontal, vertical] = panel.axes.clone();
    let name = brush.fitted(&vertical.name, NAME_SIZE, frame.height)?;
    let mut chart = ChartBuilder::on(&area)
        .set_label_area_size(LabelAreaPosition::Left, fine(left))
        .set_label_area_size(LabelAreaPosition::Bottom, fine(bottom))
        .build_cartesian_2d(horizontal, vertical)?;
    let blank = |_: &f64| String::new();
    let mut mesh = chart.configure_mesh();
    mesh.bold_line_style(rgb(GRID).stroke_width(fine(0.8) as u32))
        .light_line_style(TRANSPARENT)
        .axis_style(rgb(FRAME).stroke_width(fine(0.9) as u32))
        .label_style(text_style(LABEL_SIZE, INK))
        .axis_desc_style(text_style(NAME_SIZE, INK))
        .set_all_tick_mark_size(fine(TICK));
    if !panel.labelled[0] {
        mesh.x_label_formatter(&blank);
    }
    if panel.labelled[1] {
        mesh.y_desc(name.as_str());
    } else {
        mesh.y_label_formatter(&blank);
    }
    mesh.draw()
}

fn item(brush: &Brush, item: &Item, frame: Frame) -> CanvasResult {
    let pixel = |place: Place| pixel(place, frame);
    let pixels = |places: &[Place]| places.iter().copied().map(pixel).collect::<Vec<_>>();
    match item {
        Item::Area { outline, fill } => brush.area(&pixels(outline), *fill),
        Item::Line { points, stroke } => brush.line(&pixels(points), *stroke),
        Item::Mark { at, mark } => brush.mark(pixel(*at), *mark),
        Item::ArrowHead { tip, direction, colour } => {
            let down = [direction[0] * frame.width, -direction[1] * frame.height];
            brush.arrow_head(pixel(*tip), down, *colour)
        }
        // Texts are placed when all else is known.
        Item::Text { .. } => Ok(()),
    }
}
