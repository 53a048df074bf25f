//! The readings of several fits, in one panel or in one each.

use boundfit_estimation::{Measurement, Model, Problem};
use boundfit_exact::Rational;
use boundfit_exact::english::counted;

use super::frames::RIGHT;
use super::scene::level;
use crate::axis::Axis;
use crate::drawing::{Drawing, Frame, LegendEntry, Panel, Swatch};
use crate::extent::Extent;
use crate::figure::PlotOptions;
use crate::labels;
use crate::outside::Outside;
use crate::page::Page;
use crate::palette::{Dash, INK, Mark, Shape, Stroke, style};
use crate::render::{BOTTOM_LABELS, LEFT_LABELS};
use crate::series::{self, Series, SeriesLook};

/// The largest number of readings that are drawn where none are counted.
pub(super) const MOST_TOGETHER: usize = 10_000;
/// The number of readings in a panel above which each is drawn small.
const MOST_LARGE: usize = 125;
/// The number of readings in a small panel above which each is drawn small.
const MOST_IN_SMALL: usize = 40;
/// Parts of the panel that a bar without a bound goes on.
const OPEN_END: f64 = 0.06;
/// The additional width of the next, shorter bar at the same reading.
const BAR_ON_BAR: f64 = 1.3;

/// The drawing of a fit: bars, marks, and its line.
struct Style {
    bar: Stroke,
    mark: Mark,
    line: Stroke,
}

/// The figure of several files in one panel.
pub(crate) fn several(all: &[Series], options: &PlotOptions) -> Drawing {
    let left = LEFT_LABELS + 16.0;
    let page = Page::of(options);
    let frame = Frame { left, top: 24.0, width: page.width - left - RIGHT, height: page.height(430.0) };
    let axes = axes(all, frame, options);
    let mut panel = Panel::new(frame, axes, options.flip);
    let count: usize = all.iter().map(|own| own.problem.measurements.kept().len()).sum();
    let step = count.div_ceil(MOST_TOGETHER).max(1);
    let mut styles: Vec<Style> =
        SeriesLook::all().take(all.len()).map(|look| style_of(look, count)).collect();
    // Wide bars first, or they would cover narrow ones at the same x.
    let mut order: Vec<usize> = (0..all.len()).collect();
    order.sort_by_key(|&index| std::cmp::Reverse(widest(all[index].problem)));
    // One file under several bounds has one line and one kind of marks, and bars on bars.
    let is_one = all.windows(2).all(|pair| are_same(pair[0].problem, pair[1].problem));
    let radius = styles.iter().map(|style| style.mark.radius).fold(0.0, f64::max);
    for (rank, &index) in order.iter().enumerate() {
        if is_one {
            let own = &mut styles[index];
            own.bar.width += rank as f64 * BAR_ON_BAR;
            // The readings and the line are those of all bounds.
            own.mark = Mark::new(Shape::Disc, radius, INK);
            own.line = Stroke::new(INK, 1.6, Dash::Solid);
        }
        draw_readings(&mut panel, all[index].problem, step, &styles[index]);
    }
    let lines = if is_one { order.get(..1).unwrap_or_default() } else { order.as_slice() };
    for &index in lines.iter().rev() {
        draw_line(&mut panel, &all[index], styles[index].line);
    }
    let entries = all.iter().zip(&styles).enumerate();
    let legend = entries.map(|(index, (own, style))| entry(own, style, lines.contains(&index))).collect();
    let mut notes: Vec<String> = thinned(count, step).into_iter().collect();
    let mut found = Outside::default();
    all.iter().for_each(|own| look_outside(&mut found, &panel, own.problem));
    notes.extend(found.note(&panel, "this view"));
    let title = "Readings and lines, compared".to_owned();
    let told: Vec<String> = all.iter().map(|own| told(own, true)).collect();
    Drawing {
        description: format!("{title}. {}. {}", told.join("; "), notes.join(" ")),
        title,
        subtitle: series::subtitle(all, options),
        height: frame.top + frame.height + BOTTOM_LABELS + 8.0,
        panels: vec![panel],
        legend,
        notes,
    }
}

/// A panel for each fit, with axes that all of them share, and what the legend and the notes say.
pub(crate) fn panels(
    all: &[Series],
    frames: &[Frame],
    options: &PlotOptions,
) -> (Vec<Panel>, Vec<LegendEntry>, Vec<String>) {
    let count: usize = all.iter().map(|own| own.problem.measurements.kept().len()).sum();
    let step = count.div_ceil(MOST_TOGETHER).max(1);
    let is_dense = all.iter().any(|own| own.problem.measurements.kept().len() > MOST_IN_SMALL);
    let (bar, mark) = super::readings::style_of_fitted(is_dense);
    let style = Style { bar, mark, line: Stroke { width: 1.3, ..style::LEAST_SQUARES } };
    let mut beyond = Outside::default();
    let panels = all.iter().zip(frames).map(|(own, frame)| {
        let mut panel = Panel::new(*frame, axes(all, *frame, options), options.flip);
        look_outside(&mut beyond, &panel, own.problem);
        draw_readings(&mut panel, own.problem, step, &style);
        draw_line(&mut panel, own, style.line);
        panel.heading = own.name();
        panel.finding = if own.fit.is_empty() { ": no line" } else { "" };
        panel
    });
    let panels: Vec<Panel> = panels.collect();
    let legend = vec![
        LegendEntry::new(
            Swatch::bar(style.bar, style.mark),
            all.first().map_or("reading", |own| super::bar_name(own.problem)),
        ),
        LegendEntry::new(Swatch::line(style.line), "least-squares line"),
    ];
    let mut notes: Vec<String> = thinned(count, step).into_iter().collect();
    // The panels have the same axes.
    notes.extend(panels.first().and_then(|panel| beyond.note(panel, "this view")));
    let empty = all.iter().filter(|own| own.fit.is_empty()).count();
    if empty > 0 {
        notes.push(format!("No line agrees with all readings of {}.", counted(empty, "group", "groups")));
    }
    (panels, legend, notes)
}

/// Counts the readings outside a panel.
fn look_outside(found: &mut Outside, panel: &Panel, problem: &Problem) {
    for reading in problem.measurements.kept() {
        found.include(panel, [&abscissa(problem, reading), &level(reading)]);
    }
}

fn thinned(count: usize, step: usize) -> Option<String> {
    (step > 1).then(|| format!("{}; drawn is one of every {step}.", counted(count, "reading", "readings")))
}

fn style_of(look: SeriesLook, count: usize) -> Style {
    let colour = look.edge.colour;
    match count > MOST_LARGE {
        true => Style {
            bar: Stroke::new(colour, 0.6, Dash::Solid),
            mark: Mark { radius: look.mark.radius * 0.6, ..look.mark },
            line: look.edge,
        },
        false => Style { bar: Stroke::new(colour, 1.1, Dash::Solid), mark: look.mark, line: look.edge },
    }
}

/// Returns whether two problems have the same readings, whatever their bounds are.
fn are_same(one: &Problem, other: &Problem) -> bool {
    let [one, other] = [one, other].map(|problem| problem.measurements.kept());
    let is_same = |(one, other): (&Measurement, &Measurement)| {
        (one.row, &one.regressor, level(one)) == (other.row, &other.regressor, level(other))
    };
    one.len() == other.len() && one.iter().zip(other).all(is_same)
}

/// The largest distance from a reading to its bound.
fn widest(problem: &Problem) -> Rational {
    let reach = |reading: &Measurement| Some(reading.upper()? - reading.lower()?);
    problem.measurements.kept().iter().filter_map(reach).max().unwrap_or_default()
}

fn is_line(problem: &Problem) -> bool {
    matches!(problem.measurements.model(), Model::Line { .. })
}

/// x, or the number of the row.
fn abscissa(problem: &Problem, reading: &Measurement) -> Rational {
    if is_line(problem) { reading.regressor[0].clone() } else { Rational::from(reading.row) }
}

/// Axes that have room for all readings.
fn axes(all: &[Series], frame: Frame, options: &PlotOptions) -> [Axis; 2] {
    let (mut across, mut up) = (Extent::default(), Extent::default());
    for own in all {
        for reading in own.problem.measurements.kept() {
            across.include(&abscissa(own.problem, reading));
            up.include(&level(reading));
            [reading.lower(), reading.upper()].iter().flatten().for_each(|end| up.include(end));
        }
    }
    let room = Rational::ratio(1, 20);
    let [left, right] = options.x_range.clone().unwrap_or_else(|| across.padded(&room).into_ends());
    let [bottom, top] = options.y_range.clone().unwrap_or_else(|| up.padded(&room).into_ends());
    let most = |is_along: bool| {
        let steps = if is_along { frame.width / 62.0 } else { frame.height / 33.0 };
        steps.max(2.0) as usize
    };
    let x = series::axis_name(all, options, labels::abscissa);
    let y = series::axis_name(all, options, labels::response);
    let is_counted = all.iter().any(|own| !is_line(own.problem)) && &right - &left > Rational::one();
    let axis = if is_counted { Axis::counting } else { Axis::new };
    [axis(x, &left, &right, most(!options.flip)), Axis::new(y, &bottom, &top, most(options.flip))]
}

/// The readings of a fit: all bars, then all marks.
fn draw_readings(panel: &mut Panel, problem: &Problem, step: usize, style: &Style) {
    let readings = || problem.measurements.kept().iter().step_by(step);
    for reading in readings() {
        let x = abscissa(problem, reading);
        let [at, middle] = {
            let [across, up] = panel.coordinates();
            [across.fraction(&x), up.fraction(&level(reading))]
        };
        let end = |end: Option<Rational>, open: f64| {
            end.map_or(middle + open, |end| panel.coordinates()[1].fraction(&end))
        };
        let ends = [end(reading.lower(), -OPEN_END), end(reading.upper(), OPEN_END)];
        let ends = ends.map(|end| panel.oriented([at, end]));
        panel.line(&ends, style.bar);
    }
    for reading in readings() {
        let at = panel.place([&abscissa(problem, reading), &level(reading)]);
        panel.mark(at, style.mark);
    }
}

/// The parameters of the line that stands for a fit, and what it is.
fn line(own: &Series) -> Option<([Rational; 2], &'static str)> {
    if !is_line(own.problem) {
        return None;
    }
    let least_squares = own.fit.least_squares.as_ref().ok();
    let least_squares = least_squares.map(|estimate| (estimate.theta.clone(), "least-squares line"));
    least_squares.or_else(|| own.fit.central.as_ref().map(|own| (own.theta.clone(), "central line")))
}

fn draw_line(panel: &mut Panel, own: &Series, stroke: Stroke) {
    let Some(([slope, offset], _)) = line(own) else { return };
    let ends = {
        let across = panel.coordinates()[0];
        [across.lower().clone(), across.lower() + across.width()]
    };
    let ends = ends.map(|x| panel.place([&x, &(&slope * &x + &offset)]));
    panel.line(&ends, stroke);
}

fn entry(own: &Series, style: &Style, has_line: bool) -> LegendEntry {
    let line = line(own).map(|_| style.line).filter(|_| has_line);
    LegendEntry::staying(
        Swatch { line, bar: Some(style.bar), mark: Some(style.mark), ..Swatch::NOTHING },
        told(own, has_line),
    )
}

/// Returns the number of readings of a fit, its line, and its contradiction if no line agrees with all.
fn told(own: &Series, has_line: bool) -> String {
    let readings = counted(own.problem.measurements.kept().len(), "reading", "readings");
    let line = line(own).filter(|_| has_line).map(|(_, name)| format!(", {name}")).unwrap_or_default();
    let empty = if own.fit.is_empty() { format!("; empty, {}", own.conflict()) } else { String::new() };
    format!("{}: {readings}{line}{empty}", own.name())
}
