//! The remaining results of a fit: one line each.

use boundfit_estimation::{FloatEstimate, LeastSquares, least_squares_is_feasible};
use boundfit_exact::english::list;

use super::{Extent, Report};
use crate::document::{Symbol, THETA, Text};
use crate::fit_json::{NO_WIDTHS, no_binary64};
use crate::region::measured_point;
use crate::slope_lines;
use crate::style::Style;

/// Returns each label with its result; the label is blank where the line continues the result above.
pub(super) fn lines(report: &Report) -> Vec<(Text, Text)> {
    let mut lines: Vec<(Text, Text)> = report.least_error_bound();
    lines.extend(slope_lines::of_fit(report.problem, report.fit, &report.theta));
    if report.extent == Extent::Full {
        lines.extend(sizes(report));
    }
    lines.extend(report.least_squares());
    lines
}

/// The area and the centroid of the set.
fn sizes(report: &Report) -> Vec<(Text, Text)> {
    let (fit, style) = (report.fit, report.style);
    let mut lines = Vec::new();
    let region = fit.fps.polyhedron().region();
    let measures = region.measures();
    if let Some(area) = measures.area().filter(|_| !region.is_empty()) {
        let line = style.measure(&area);
        let line = match fit.share_of_box(&measures) {
            Some(share) => line.words(", ").then(style.measure(&share)).words(" of its PUI box"),
            None => line,
        };
        lines.push(("area".into(), line));
    }
    if let Some(centroid) = measures.centroid() {
        lines.push(("centroid".into(), measured_point(&centroid, &report.theta)));
    }
    lines
}

impl Report<'_> {
    fn least_error_bound(&self) -> Vec<(Text, Text)> {
        let label = Text::from(Symbol::LeastEpsilon);
        let Some(minimax) = &self.fit.minimax else {
            let never = if self.problem.measurements.has_widths() {
                "no error bound, however large, is enough"
            } else {
                NO_WIDTHS
            };
            let unknown = self.problem.measurements.unknown_minimax();
            let reason =
                unknown.map_or_else(|| format!("none: {never}"), |reason| format!("not known: {reason}"));
            return vec![(label, reason.into())];
        };
        let least = self.style.upper_with_exact(&minimax.least);
        let least = least.words(match self.problem.measurements.error_bound() {
            bound if bound.has_middles() => " times the width of each interval, about its middle",
            bound if bound.is_uniform() => "",
            _ => " times each row's bound",
        });
        let proof = list(minimax.proof.multipliers.iter().map(|(name, _)| name.to_string()));
        let least = if proof.is_empty() { least } else { least.words(format!(", fixed by {proof}")) };
        let mut lines = vec![(label, least)];
        if !minimax.unique {
            lines.push((Text::new(), "the minimax estimate is not unique; this is one of many".into()));
        }
        lines
    }

    /// The rounding errors of least squares in doubles.
    fn in_doubles(&self) -> Vec<(Text, Text)> {
        // Two digits are enough for an error in the sixteenth digit.
        let short = Style { digits: Some(2), ..*self.style };
        let float = |method: &str, estimate: &Option<FloatEstimate>| match estimate {
            Some(FloatEstimate { distance: [first, second], .. }) => {
                Text::from(format!("{method} is off by "))
                    .number(short.upper(first))
                    .words(" in ")
                    .symbol(Symbol::Theta1)
                    .words(" and ")
                    .number(short.upper(second))
                    .words(" in ")
                    .symbol(Symbol::Theta2)
            }
            None => format!("{method} fails").into(),
        };
        let label = Text::from("in doubles");
        match self.fit.float_least_squares(&self.problem.measurements) {
            Some(floats) => vec![
                (label, float("QR", &floats.qr)),
                (Text::new(), float("pseudo-inverse", &floats.pseudo_inverse)),
            ],
            None if self.fit.least_squares.is_ok() => {
                vec![(label, no_binary64(&self.problem.measurements).into())]
            }
            None => Vec::new(),
        }
    }

    fn least_squares(&self) -> Vec<(Text, Text)> {
        let (fit, style) = (self.fit, self.style);
        let state = match (&fit.least_squares, fit.least_squares_slack()) {
            (Err(singular), _) => format!("none: {singular}").into(),
            (Ok(_), Some((slack, name))) if slack.is_negative() => {
                Text::from(format!("not feasible: exceeds {name} by ")).number(style.upper(&-slack))
            }
            (Ok(_), _) if least_squares_is_feasible(fit) == Some(false) => "not feasible".into(),
            (Ok(_), _) => "feasible".into(),
        };
        let mut lines = vec![("least squares".into(), state)];
        let is_full = self.extent == Extent::Full;
        let errors = fit.least_squares_guaranteed_error().filter(|_| is_full);
        if let (Ok(own), Some(errors)) = (&fit.least_squares, errors) {
            let error = |axis: usize| {
                let shown = self.theta[axis].give_or_take(&own.theta[axis], &errors[axis], style);
                Text::from(THETA[axis]).mark(" ").symbol(Symbol::PlusMinus).number(shown.error)
            };
            let line = Text::from("guaranteed error ").then(error(0)).words(", ").then(error(1));
            lines.push((Text::new(), line));
        }
        if is_full {
            lines.extend(self.in_doubles());
        }
        if let Ok(LeastSquares { eui: Err(reason), .. }) = &fit.least_squares {
            lines.push(("EUI".into(), format!("none: {reason}").into()));
        }
        lines
    }
}
