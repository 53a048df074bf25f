//! Readings with errors in x as boxes, and the steepest and the shallowest line that agree with all of them.

use std::collections::BTreeSet;

use boundfit_estimation::{BoundName, Measurement, ParameterBound};
use boundfit_exact::english::counted;
use boundfit_exact::{Rational, Rounding};
use boundfit_questions::{BoxBound, Corner, SideSet, SlopeEnd, XErrorFit, XErrorProblem};

use super::frames::RIGHT;
use super::readings::{style_of_fitted, style_of_other};
use super::scene::{MOST_LARGE_MARKS, level};
use super::several::MOST_TOGETHER;
use crate::axis::Axis;
use crate::drawing::{Anchor, Drawing, Frame, LegendEntry, Panel, Swatch};
use crate::extent::Extent;
use crate::figure::PlotOptions;
use crate::labels;
use crate::outside::Outside;
use crate::page::Page;
use crate::palette::{BLUE, Dash, Fill, GREY, INK, Mark, PURPLE, Stroke, VERMILLION, style};
use crate::render::{BOTTOM_LABELS, LEFT_LABELS};
use crate::x_errors::{asked, conflict, emptiness};

const BOX: Fill = Fill { colour: GREY, opacity: 0.2 };
const CONFLICT_BOX: Fill = Fill { colour: PURPLE, opacity: 0.3 };
/// The lines at the two ends of the slopes.
const LINES: [Stroke; 2] = [Stroke::new(BLUE, 1.6, Dash::Solid), Stroke::new(VERMILLION, 1.6, Dash::Long)];
/// Significant digits of slopes.
const DIGITS: usize = 5;

/// A line at an end of the slopes, and the bounds that it touches.
struct SlopeLine<'a> {
    name: String,
    theta: [Rational; 2],
    touched: Vec<&'a BoxBound>,
    stroke: Stroke,
}

/// The figure.
pub(crate) fn boxes(problem: &XErrorProblem, answer: &XErrorFit, options: &PlotOptions) -> Drawing {
    let measurements = &problem.problem().measurements;
    let lines = lines(answer);
    let conflicting: BTreeSet<usize> = match answer.is_empty() {
        true => answer.sides.iter().flat_map(|side| conflict(side).rows).collect(),
        false => BTreeSet::new(),
    };
    let mut panel = panel(problem, !conflicting.is_empty(), options);
    let touched: Vec<&BoxBound> = lines.iter().flat_map(|line| line.touched.iter().copied()).collect();
    let mut shown = conflicting.clone();
    shown.extend(touched.iter().filter_map(|bound| bound.row()));
    let [count, others] = [measurements.kept().len(), measurements.others().len()];
    let [step, other_step] = [count, others].map(|count| count.div_ceil(MOST_TOGETHER).max(1));
    let is_dense = count + others > MOST_LARGE_MARKS;
    for other in measurements.others().iter().step_by(other_step) {
        let value = other.value().unwrap_or_default();
        panel.mark(panel.place([&other.regressor[0], &value]), style_of_other(is_dense));
    }
    let is_shown = |index: usize, row: usize| index.is_multiple_of(step) || shown.contains(&row);
    let kept = || problem.readings().enumerate().filter(|(index, (own, _))| is_shown(*index, own.row));
    for is_conflict in [false, true] {
        let own = || kept().filter(|(_, own)| conflicting.contains(&own.0.row) == is_conflict);
        let style = style_of(is_conflict, is_dense);
        for (_, (reading, width)) in own() {
            draw_box(&mut panel, reading, width, style);
            if !is_dense {
                mark_reading(&mut panel, reading, style.2);
            }
        }
        // Many boxes would cover each other's marks.
        own().filter(|_| is_dense).for_each(|(_, (reading, _))| mark_reading(&mut panel, reading, style.2));
    }
    for line in &lines {
        draw_line(&mut panel, line);
    }
    for (reading, width) in problem.readings().filter(|(own, _)| shown.contains(&own.row)) {
        for bound in touched.iter().filter(|bound| bound.row() == Some(reading.row)) {
            if let Some([x, y]) = corner(reading, width, **bound) {
                panel.mark(panel.place([&x, &y]), style::VERTEX);
            }
        }
    }
    let mut notes = notes(problem, answer, options);
    let all = || measurements.others().iter().chain(measurements.kept());
    let mut found = Outside::default();
    all().for_each(|reading| found.include(&panel, [&reading.regressor[0], &level(reading)]));
    notes.extend(found.note(&panel, "this view"));
    if step > 1 || other_step > 1 {
        let all = counted(count + others, "reading", "readings");
        notes.push(format!("{all}; drawn are some, evenly spread, and those that decide."));
    }
    let title = if answer.is_empty() {
        "Readings with errors in x that no line can explain"
    } else {
        "Readings with errors in x, and the lines that agree with all of them"
    };
    let named = labels::described(options);
    let [across, up] =
        [labels::abscissa(problem.problem(), &named), labels::response(problem.problem(), &named)];
    Drawing {
        title: title.to_owned(),
        subtitle: labels::subtitle(problem.problem(), options),
        description: format!("{title}: {up} against {across}. {}", notes.join(" ")),
        height: panel.frame.top + panel.frame.height + BOTTOM_LABELS + 8.0,
        panels: vec![panel],
        legend: legend(&lines, is_dense),
        notes,
    }
}

/// The question about lines, and the unbounded parts of the answer.
fn notes(problem: &XErrorProblem, answer: &XErrorFit, options: &PlotOptions) -> Vec<String> {
    let mut notes = vec![asked(problem, options)];
    notes.extend(emptiness(problem, answer));
    let slopes = answer.pui().map(|[slopes, _]| slopes);
    if slopes.is_some_and(|slopes| slopes.lower().value().is_none() || slopes.upper().value().is_none()) {
        notes.push("There are lines as steep as one likes.".to_owned());
    }
    let kept = problem.problem().measurements.kept();
    if kept.iter().any(|own| own.lower().is_none() || own.upper().is_none()) {
        notes.push("A box that reaches the edge goes on without end.".to_owned());
    }
    notes
}

/// The lines at the ends of the slopes, as far as there are such.
fn lines(answer: &XErrorFit) -> Vec<SlopeLine<'_>> {
    let line = |((end, is_upper), stroke): ((SlopeEnd, bool), Stroke)| {
        let (side, bound): (&SideSet, _) = answer.end(0, is_upper)?;
        let ParameterBound::Bounded { proof, .. } = bound else { return None };
        let theta = proof.attained_at.coordinates();
        let sign = if theta[0].exact_decimal(DIGITS).is_some() { "=" } else { "≈" };
        let name = match end {
            SlopeEnd::Steepest => "steepest line",
            SlopeEnd::Shallowest => "shallowest line",
            SlopeEnd::Only => "line of the only slope",
            SlopeEnd::RisesMost => "line that rises most",
            SlopeEnd::FallsMost => "line that falls most",
        };
        // As an end of an interval.
        let rounding = if is_upper { Rounding::Up } else { Rounding::Down };
        let slope = labels::number(&theta[0], DIGITS, rounding);
        let touched = proof.multipliers.iter().filter_map(|own| side.names.get(own.index)).collect();
        Some(SlopeLine { name: format!("{name}, θ₁ {sign} {slope}"), theta, touched, stroke })
    };
    let ends = answer.pui().map(|[slopes, _]| SlopeEnd::of(&slopes)).unwrap_or_default();
    ends.into_iter().zip(LINES).filter_map(line).collect()
}

/// An empty panel that has room for all boxes.
fn panel(problem: &XErrorProblem, has_labels: bool, options: &PlotOptions) -> Panel {
    let (mut across, mut up) = (Extent::default(), Extent::default());
    for (reading, width) in problem.readings() {
        across.include(&(&reading.regressor[0] - width));
        across.include(&(&reading.regressor[0] + width));
        let ends = [reading.lower(), reading.upper(), reading.value().map(|value| value.into_owned())];
        ends.iter().flatten().for_each(|end| up.include(end));
    }
    for other in problem.problem().measurements.others() {
        across.include(&other.regressor[0]);
        other.value().iter().for_each(|value| up.include(value));
    }
    let room = Rational::ratio(1, 20);
    let [left, right] = options.x_range.clone().unwrap_or_else(|| across.padded(&room).into_ends());
    let margin = if has_labels { Rational::ratio(1, 9) } else { Rational::ratio(1, 16) };
    let [bottom, top] = options.y_range.clone().unwrap_or_else(|| up.padded(&margin).into_ends());
    let left_edge = LEFT_LABELS + 16.0;
    let page = Page::of(options);
    let width = page.width - left_edge - RIGHT;
    let frame = Frame { left: left_edge, top: 20.0, width, height: page.height(420.0) };
    let most = |is_along: bool| if is_along { frame.width / 62.0 } else { frame.height / 33.0 } as usize;
    let names = [labels::abscissa(problem.problem(), options), labels::response(problem.problem(), options)];
    let [x, y] = names;
    let axes =
        [Axis::new(x, &left, &right, most(!options.flip)), Axis::new(y, &bottom, &top, most(options.flip))];
    Panel::new(frame, axes, options.flip)
}

/// Fill, edge and mark of the box of a reading.
fn style_of(is_conflict: bool, is_dense: bool) -> (Fill, Stroke, Mark) {
    if is_conflict {
        return (CONFLICT_BOX, style::CONFLICT_BAR, style::CONFLICT);
    }
    let (edge, mark) = style_of_fitted(is_dense);
    (BOX, edge, mark)
}

/// The box of a reading, which without a bound on y goes on to the edge.
fn draw_box(panel: &mut Panel, reading: &Measurement, width: &Rational, style: (Fill, Stroke, Mark)) {
    const BEYOND: [f64; 2] = [-0.01, 1.01];
    let x = &reading.regressor[0];
    let [across, up] = panel.coordinates();
    let [left, right] = [across.fraction(&(x - width)), across.fraction(&(x + width))];
    let ends = [reading.lower(), reading.upper()].map(|end| end.map(|end| up.fraction(&end)));
    let [bottom, top] = [ends[0].unwrap_or(BEYOND[0]), ends[1].unwrap_or(BEYOND[1])];
    let corners = [[left, bottom], [right, bottom], [right, top], [left, top]];
    let corners = corners.map(|corner| panel.oriented(corner));
    let (fill, edge, _) = style;
    panel.area(&corners, fill);
    panel.outline(&corners, edge);
    if fill == CONFLICT_BOX {
        let at = panel.oriented([f64::midpoint(left, right), top.max(bottom).min(1.0)]);
        let (across, up) = if panel.is_flipped() { (1.0, 0.0) } else { (0.0, 1.0) };
        panel.text(at, format!("row {}", reading.row), Anchor { across, up }, INK);
    }
}

/// Marks y in the box of a reading, where there is one.
fn mark_reading(panel: &mut Panel, reading: &Measurement, mark: Mark) {
    if let Some(response) = reading.response() {
        panel.mark(panel.place([&reading.regressor[0], response]), mark);
    }
}

/// A line across the panel.
fn draw_line(panel: &mut Panel, SlopeLine { theta, stroke, .. }: &SlopeLine) {
    let across = panel.coordinates()[0];
    let ends = [across.lower().clone(), across.lower() + across.width()];
    let ends = ends.map(|x| panel.place([&x, &(&theta[0] * &x + &theta[1])]));
    panel.line(&ends, *stroke);
}

/// Returns the corner where a line touches the box of a reading; `None` for a bound that belongs to no reading.
fn corner(reading: &Measurement, width: &Rational, bound: BoxBound) -> Option<[Rational; 2]> {
    let BoxBound::Bound(name, corner) = bound else { return None };
    let y = match name {
        BoundName::Upper(_) => reading.upper()?,
        BoundName::Lower(_) => reading.lower()?,
        _ => return None,
    };
    let x = &reading.regressor[0];
    let x = match corner {
        Some(Corner::Left) => x - width,
        Some(Corner::Right) => x + width,
        None => x.clone(),
    };
    Some([x, y])
}

fn legend(lines: &[SlopeLine], is_dense: bool) -> Vec<LegendEntry> {
    let swatch = |is_conflict: bool| {
        let (fill, edge, mark) = style_of(is_conflict, is_dense);
        Swatch { mark: Some(mark), ..Swatch::area(fill, edge) }
    };
    let lines = lines.iter().map(|line| LegendEntry::new(Swatch::line(line.stroke), line.name.clone()));
    [LegendEntry::new(swatch(false), "reading with its errors, x ± δ and y ± ε")]
        .into_iter()
        .chain([LegendEntry::new(swatch(true), "readings that contradict each other")])
        .chain([LegendEntry::new(Swatch::mark(style_of_other(is_dense)), "reading that is not fitted")])
        .chain(lines)
        .chain([LegendEntry::new(Swatch::mark(style::VERTEX), "where these lines touch a box")])
        .collect()
}
