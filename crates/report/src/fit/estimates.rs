//! The tables of estimates and intervals, and what their words and digits mean.

use std::iter;

use boundfit_estimation::{ErrorBound, Fit, Inverse, InverseParameter, Model};
use boundfit_exact::{Interval, Rational};

use super::{Extent, Report};
use crate::document::{Block, Facts, Inline, Operator, Symbol, THETA, Table, Text};
use crate::scale::{Scale, scales};
use crate::style::{EndRounding, GiveOrTake, Style};

/// The part; nothing when there is neither an estimate nor an interval.
pub(super) fn blocks(report: &Report) -> Vec<Block<'static>> {
    let rows = parameter_rows(report);
    if rows.is_empty() {
        return Vec::new();
    }
    let words = Facts { width: 7, rows: words(report.fit, report.problem.measurements.error_bound()) };
    let names = parameter_names(report.problem.measurements.model());
    let header = [Text::new()].into_iter().chain(names);
    let mut blocks = vec![Block::Space, Block::Table(Table::new(header, rows))];
    blocks.extend([Block::Paragraph(note(report).into()), Block::Facts(words)]);
    blocks.extend(report.inverse().into_iter().flat_map(|inverse| inverse_blocks(report, &inverse)));
    blocks
}

/// The two parameters; those of a line are its slope and its offset.
pub(super) fn parameter_names(model: &Model) -> [Text; 2] {
    match model {
        Model::Line { .. } => [("slope ", Symbol::Theta1), ("offset ", Symbol::Theta2)]
            .map(|(word, theta)| Text::from(word).symbol(theta)),
        Model::TwoRegressors { .. } => THETA.map(Text::from),
    }
}

/// The inverse line, with its title.
fn inverse_blocks(report: &Report, inverse: &Inverse) -> Vec<Block<'static>> {
    let rows = inverse_rows(report, inverse);
    let measurements = &report.problem.measurements;
    let Model::Line { x } = measurements.model() else { return Vec::new() };
    if rows.is_empty() {
        return Vec::new();
    }
    let x = measurements.line_form().abscissa(x);
    let title = Text::from("Inverse line: ").given(&x).operator(Operator::Equals).words("gain");
    let title =
        title.operator(Operator::Dot).given(measurements.response()).operator(Operator::Plus).words("offset");
    let gain = Text::from("gain ").number(1).mark("/").symbol(Symbol::Theta1);
    let offset = Text::from("offset ").mark("-").symbol(Symbol::Theta2).mark("/").symbol(Symbol::Theta1);
    vec![Block::Title(title), Block::Table(Table::new([Text::new(), gain, offset], rows))]
}

/// The meaning of each word in the table.
fn words(fit: &Fit, error_bound: &ErrorBound) -> Vec<(Text, Text)> {
    let largest = match error_bound {
        ErrorBound::Uniform(_) => "the estimate with the smallest largest error",
        bound if bound.has_middles() => {
            "the estimate with the smallest largest distance from the middles, in units of each half width"
        }
        _ => "the estimate with the smallest largest error, in units of each bound",
    };
    let words = [
        (
            "EUI",
            fit.eui().is_some(),
            "estimate uncertainty interval: how far such errors can move least squares",
        ),
        ("PUI", fit.pui.is_some(), "parameter uncertainty interval: all values in the feasible set (FPS)"),
        ("central", fit.central.is_some(), "the middle of the PUI; guaranteed: its largest possible error"),
        ("minimax", fit.minimax.is_some(), largest),
    ];
    let used = words.into_iter().filter(|(_, is_used, _)| *is_used);
    used.map(|(word, _, meaning)| (word.into(), meaning.into())).collect()
}

/// The rows of the table of both parameters.
fn parameter_rows(report: &Report) -> Vec<Vec<Text>> {
    let fit = report.fit;
    let mut rows = Vec::new();
    let estimate = |label: &str, theta: &[Rational; 2]| {
        let number = |axis: usize| Text::new().number(report.theta[axis].value(&theta[axis]));
        vec![label.into(), number(0), number(1)]
    };
    let intervals = |label: &str, intervals: &[Interval; 2]| {
        let interval = |axis: usize| report.theta[axis].interval(&intervals[axis]);
        vec![label.into(), interval(0), interval(1)]
    };
    rows.extend(fit.least_squares.as_ref().ok().map(|own| match fit.least_squares_guaranteed_error() {
        Some(errors) => {
            let [row, _] = bounded_rows("least squares", &own.theta, &errors, report.style, &report.theta);
            row
        }
        None => estimate("least squares", &own.theta),
    }));
    rows.extend(fit.eui().map(|eui| intervals("EUI", eui)));
    rows.extend(fit.pui_intervals().map(|pui| intervals("PUI", &pui)));
    rows.extend(fit.central.iter().flat_map(|own| {
        bounded_rows("central", &own.theta, &own.guaranteed_error, report.style, &report.theta)
    }));
    rows.extend(fit.minimax.as_ref().map(|minimax| estimate("minimax", &minimax.theta)));
    rows
}

/// The rows of an estimate and of its guaranteed error, whose digits it has.
pub(crate) fn bounded_rows(
    label: &str,
    theta: &[Rational; 2],
    errors: &[Rational; 2],
    style: &Style,
    scales: &[Scale; 2],
) -> [Vec<Text>; 2] {
    let both = [0, 1].map(|axis| scales[axis].give_or_take(&theta[axis], &errors[axis], style));
    let [[centre1, error1], [centre2, error2]] = both.map(|GiveOrTake { centre, error }| {
        [Text::new().number(centre), Text::from(Symbol::PlusMinus).number(error)]
    });
    let guaranteed = Text::new().with(Inline::Indent).words("guaranteed");
    [vec![label.into(), centre1, centre2], vec![guaranteed, error1, error2]]
}

/// The rows of the table of gain and offset.
fn inverse_rows(report: &Report, inverse: &Inverse) -> Vec<Vec<Text>> {
    let fit = report.fit;
    let both = [&inverse.gain, &inverse.offset];
    let single = |of: &dyn Fn(&InverseParameter) -> Vec<Interval>| match both.map(of) {
        [gain, offset] => match (gain.as_slice(), offset.as_slice()) {
            ([gain], [offset]) => Some([gain.clone(), offset.clone()]),
            _ => None,
        },
    };
    let exact = single(&|own| own.exact_range.clone());
    let boxes =
        [single(&|own| own.box_range.clone()), single(&|own| own.eui_range.clone().unwrap_or_default())];
    let others: Vec<&[Interval; 2]> = boxes.iter().flatten().collect();
    let scales = scales(report.style, exact.as_ref(), &others, &[], iter::empty);
    let estimate = |label: &str, values: [Option<Rational>; 2]| {
        let cell = |axis: usize| match &values[axis] {
            Some(value) => Text::new().number(scales[axis].value(value)),
            None => "-".into(),
        };
        vec![label.into(), cell(0), cell(1)]
    };
    let intervals = |label: &str, of: &dyn Fn(&InverseParameter) -> Vec<Interval>| {
        let cell = |axis: usize| scales[axis].union(&of(both[axis]));
        vec![label.into(), cell(0), cell(1)]
    };
    let is_full = report.extent == Extent::Full;
    let mut rows = Vec::new();
    if is_full && fit.least_squares.is_ok() {
        rows.push(estimate("least squares", both.map(|own| own.least_squares.clone())));
    }
    if is_full && both.iter().all(|own| own.eui_range.is_some()) {
        rows.push(intervals("EUI", &|own| own.eui_range.clone().unwrap_or_default()));
    }
    if is_full && fit.pui.is_some() {
        rows.push(intervals("PUI", &|own| own.box_range.clone()));
    }
    if fit.pui.is_some() {
        rows.push(intervals("over the FPS", &|own| own.exact_range.clone()));
    }
    if fit.central.is_some() {
        rows.push(estimate("central", both.map(|own| own.central.clone())));
    }
    if let Some(minimax) = fit.minimax.as_ref().filter(|_| is_full) {
        let [theta1, theta2] = &minimax.theta;
        rows.push(estimate("minimax", [theta1.recip(), (-theta2).checked_div(theta1)]));
    }
    rows
}

/// Returns the note on the rounding of the tables' numbers.
fn note(report: &Report) -> String {
    if report.style.exact {
        return "All numbers are exact.".to_owned();
    }
    let digits = match report.style.digits {
        Some(digits) => format!("Rounded to {digits} digits"),
        None => format!("Rounded to {} digits or more", report.style.significant()),
    };
    match report.style.ends {
        EndRounding::Outward => format!(
            "{digits}, ends and errors outward; shorter ones are exact. Estimates stop at the last place of their errors."
        ),
        EndRounding::Nearest => {
            format!("{digits}, to nearest: a printed interval may be too narrow by half a unit.")
        }
    }
}
