//! The report of a fit in ten lines.

use boundfit_estimation::{ErrorBound, Fit, Problem};
use boundfit_exact::english::list;

use super::{InverseLine, Report};
use crate::document::{Block, Document, Facts, Symbol, THETA, Text};
use crate::origin::Origin;
use crate::region::kind_text;
use crate::style::Style;

/// Returns the report of a fit in ten lines: model, error, data, the kind of set, ε_min and least squares. Each
/// parameter has its PUI and its central estimate with the guaranteed error. An empty set has its contradiction and
/// the remedy instead.
pub fn brief_document(problem: &Problem, fit: &Fit, origin: &Origin, style: &Style) -> Document<'static> {
    let pui = fit.pui_intervals();
    let report = Report::new(problem, fit, pui.as_ref(), InverseLine::default(), style);
    let set = fit.fps.polyhedron();
    let mut rows = report.facts(origin);
    rows.push(("set".into(), kind_text(set.kind(), set.vertex_count()).into()));
    for (axis, interval) in pui.iter().flatten().enumerate() {
        let range = report.theta[axis].interval(interval);
        let is_single = interval.ends().is_some_and(|(lower, upper)| lower == upper);
        let line = match fit.central.as_ref().filter(|_| !is_single) {
            // A single value is its own middle.
            None if is_single => range,
            None => Text::from("in ").then(range),
            Some(central) => {
                let shown = report.theta[axis].give_or_take(
                    &central.theta[axis],
                    &central.guaranteed_error[axis],
                    style,
                );
                let line = Text::from("in ").then(range).words("; central ").number(shown.centre).words(" ");
                line.symbol(Symbol::PlusMinus).number(shown.error)
            }
        };
        rows.push((THETA[axis].into(), line));
    }
    rows.extend(fit.minimax.as_ref().map(|minimax| {
        let least = Text::new().number(style.upper(&minimax.least));
        let names = list(minimax.proof.multipliers.iter().map(|(name, _)| name.to_string()));
        let least = least.words(times_what(problem.measurements.error_bound()));
        // Where nothing has to be given up, no bound stands against less.
        let least = if names.is_empty() { least } else { least.words(format!(", fixed by {names}")) };
        (Text::from(Symbol::LeastEpsilon), least)
    }));
    if let Ok(least_squares) = &fit.least_squares {
        let errors = fit.least_squares_guaranteed_error();
        let [theta1, theta2] = [0, 1].map(|axis| {
            let theta = &least_squares.theta[axis];
            match &errors {
                Some(errors) => {
                    report.theta[axis].give_or_take(theta, &errors[axis], style).centre.to_string()
                }
                None => report.theta[axis].value(theta).to_string(),
            }
        });
        let is_feasible = fit.least_squares_slack().is_none_or(|(slack, _)| !slack.is_negative());
        let line = Text::from("least squares ").number(theta1).words(" and ").number(theta2);
        let line = line.words(if is_feasible { ", feasible" } else { ", not feasible" });
        rows.push((Text::new(), line));
    }
    let mut blocks = vec![Block::Title("Set-membership fit".into()), Block::Facts(Facts { width: 7, rows })];
    if set.is_empty() {
        // The proof is in the whole report.
        let lines = report.emptiness().into_iter().enumerate().filter(|(number, _)| *number != 1);
        blocks.extend(lines.map(|(_, line)| Block::Paragraph(line)));
    }
    Document::new(blocks)
}

/// Returns the words behind a short ε_min: what of the bounds it multiplies, where it is a factor.
pub(crate) fn times_what(error_bound: &ErrorBound) -> &'static str {
    match error_bound {
        bound if bound.has_middles() => " times the widths",
        bound if bound.is_uniform() => "",
        _ => " times the bounds",
    }
}
