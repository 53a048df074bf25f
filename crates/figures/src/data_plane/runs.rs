//! The runs of readings that fit, as bars below the data.

use boundfit_estimation::{Model, Problem, fit};
use boundfit_exact::english::counted;
use boundfit_exact::{Rational, Rounding};
use boundfit_questions::{LinearRange, Order, Run};

use super::drawing;
use crate::axis::Axis;
use crate::drawing::{Drawing, Frame, LegendEntry, Panel, Swatch};
use crate::figure::{Figure, PlotOptions};
use crate::labels;
use crate::palette::{BLUE, Dash, GREY, Stroke};
use crate::render::{BOTTOM_LABELS, LEFT_LABELS};

/// The number of runs above which only the longest are drawn: bars would cover each other.
const MOST_BARS: usize = 60;
/// The pixels that one bar has, between these.
const BAR_ROOM: [f64; 2] = [3.0, 9.0];

/// Significant digits of x.
const DIGITS: usize = 5;

/// A run that is not the longest.
const RUN: Stroke = Stroke::new(GREY, 2.0, Dash::Solid);
/// The longest one.
const LONGEST: Stroke = Stroke::new(BLUE, 3.6, Dash::Solid);

/// The data with the longest run fitted and all others beside it, and a bar for each run.
pub(crate) fn runs(problem: &Problem, options: &PlotOptions) -> Drawing {
    let order = Order::natural(problem.measurements.model());
    let range = LinearRange::of(problem, order);
    let Some(longest) = range.longest() else {
        let mut empty = drawing(problem, &fit(problem), Figure::Data, options);
        empty.title = match order {
            Order::X => "No reading fits, not even those of one x alone".to_owned(),
            Order::Row => "No reading fits, not even alone".to_owned(),
        };
        return empty;
    };
    let own = range.problem_of(longest, problem, true);
    let own_fit = fit(&own);
    let upright = PlotOptions { flip: false, ..options.clone() };
    let mut drawing = drawing(&own, &own_fit, Figure::Range, &upright);
    let rows = problem.measurements.kept();
    let place = |position: usize| {
        let reading = &rows[range.order[position]];
        match problem.measurements.model() {
            Model::Line { .. } => reading.regressor[0].clone(),
            Model::TwoRegressors { .. } => Rational::from(reading.row),
        }
    };
    let shown = shown(&range, longest);
    // As far below the panel above, which needs no labels, as that one is below the first.
    let top = drawing.height - 8.0 - BOTTOM_LABELS + 32.0;
    let panel = bars(&drawing, &shown, longest, place, top);
    drawing.title = match range.runs.len() {
        1 if longest.len() == rows.len() => "All readings fit together".to_owned(),
        1 => "The run of readings that fit together".to_owned(),
        runs => format!("{runs} runs of readings that fit, none of which can be longer"),
    };
    drawing.subtitle = labels::subtitle(problem, options);
    drawing.description = format!("{} Last panel: a bar for each run.", drawing.description);
    drawing.height = panel.frame.top + panel.frame.height + BOTTOM_LABELS + 8.0;
    if let Some(last) = drawing.panels.last_mut() {
        last.labelled[0] = false;
    }
    drawing.panels.push(panel);
    let readings = counted(longest.len(), "reading", "readings");
    let ends = [longest.first, longest.last];
    let text = match problem.measurements.model() {
        Model::Line { x } => {
            let origin = &problem.measurements.line_form().x_origin;
            let [from, to] = ends.map(|at| labels::number(&(place(at) + origin), DIGITS, Rounding::Nearest));
            format!("the longest run: {x} from {from} to {to}, {readings}")
        }
        Model::TwoRegressors { .. } => {
            let [first, last] = ends.map(|position| rows[range.order[position]].row);
            format!("the longest run: {readings}, rows {first}..{last}")
        }
    };
    drawing.legend.push(LegendEntry::new(Swatch::line(LONGEST), text));
    drawing.legend.push(LegendEntry::new(Swatch::line(RUN), "another run"));
    if shown.len() < range.runs.len() {
        drawing.notes.push(format!(
            "Of {} runs the {} with the most readings are drawn.",
            range.runs.len(),
            shown.len()
        ));
    }
    drawing
}

/// The runs to be drawn, in order.
fn shown<'a>(range: &'a LinearRange, longest: &'a Run) -> Vec<&'a Run> {
    if range.runs.len() <= MOST_BARS {
        return range.runs.iter().collect();
    }
    let mut runs: Vec<&Run> = range.runs.iter().filter(|run| *run != longest).collect();
    runs.sort_by_key(|run| std::cmp::Reverse(run.len()));
    runs.truncate(MOST_BARS - 1);
    runs.push(longest);
    runs.sort_by_key(|run| run.first);
    runs
}

/// The panel of bars, from the first run at the top to the last one at the bottom.
fn bars(
    drawing: &Drawing,
    shown: &[&Run],
    longest: &Run,
    place: impl Fn(usize) -> Rational,
    top: f64,
) -> Panel {
    let left = LEFT_LABELS + 16.0;
    let room = (180.0 / shown.len() as f64).clamp(BAR_ROOM[0], BAR_ROOM[1]);
    let height = (room * (shown.len() + 1) as f64).max(40.0);
    let first = drawing.panels.first();
    let width = first.map_or(0.0, |panel| panel.frame.width);
    let frame = Frame { left, top, width, height };
    let across = first.map(|panel| panel.axes[0].clone());
    let zero = Rational::zero();
    let across = across.unwrap_or_else(|| Axis::new(String::new(), &zero, &Rational::one(), 5));
    let last = Rational::from(shown.len() + 1);
    let up = Axis::counting("runs".to_owned(), &zero, &last, 1);
    let mut panel = Panel::new(frame, [across, up], false);
    panel.labelled = [true, false];
    panel.heading = "the runs, from first to last".to_owned();
    let ends = |run: &Run, number: usize| {
        let level = Rational::from(shown.len() - number);
        [run.first, run.last].map(|position| panel.place([&place(position), &level]))
    };
    let lines: Vec<_> =
        shown.iter().enumerate().map(|(number, run)| (*run == longest, ends(run, number))).collect();
    for (is_longest, [mut from, mut to]) in lines {
        // A run of one reading, or at one x, is seen too.
        let least = 3.0 / panel.frame.width;
        if to[0] - from[0] < least {
            (from[0], to[0]) = (from[0] - least / 2.0, to[0] + least / 2.0);
        }
        panel.line(&[from, to], if is_longest { LONGEST } else { RUN });
    }
    panel
}
