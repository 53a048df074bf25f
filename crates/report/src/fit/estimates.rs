//! The table of estimates and intervals, and what its words and digits mean.

use boundfit_estimation::{ErrorBound, Fit, InverseParameter};
use boundfit_exact::{Interval, Rational};

use super::Report;
use crate::document::{Block, Facts, Inline, Symbol, THETA, Table, Text};
use crate::style::{EndRounding, Style};

/// The part; nothing when there is neither an estimate nor an interval.
pub(super) fn blocks(report: &Report) -> Vec<Block> {
    let inverse = report.fit.inverse.as_ref().map(|inverse| [&inverse.gain, &inverse.offset]);
    let styles = [0, 1].map(|axis| match inverse.map(|inverse| inverse[axis].exact_range.as_slice()) {
        Some([range]) => report.style.resolving(range),
        _ => *report.style,
    });
    let estimates = Estimates { report, inverse, styles };
    let rows = estimates.rows();
    if rows.is_empty() {
        return Vec::new();
    }
    let theta = THETA.map(Text::from);
    let gain = Text::from("gain ").number(1).mark("/").symbol(Symbol::Theta1);
    let offset = Text::from("offset ").mark("-").symbol(Symbol::Theta2).mark("/").symbol(Symbol::Theta1);
    let inverse = inverse.map(|_| [gain, offset]);
    let fold = inverse.as_ref().map(|_| 3);
    let header = [Text::new()].into_iter().chain(theta).chain(inverse.into_iter().flatten()).collect();
    let words = Facts { width: 7, rows: words(report.fit, report.problem.measurements.error_bound()) };
    vec![
        Block::Space,
        Block::Table(Table { header, rows, fold }),
        Block::Paragraph(estimates.note().into()),
        Block::Facts(words),
    ]
}

/// What the words of the table mean.
fn words(fit: &Fit, error_bound: &ErrorBound) -> Vec<(Text, Text)> {
    let largest = match error_bound {
        ErrorBound::Uniform(_) => "the estimate whose largest error is smallest",
        ErrorBound::PerRow(_) | ErrorBound::Law(_) => {
            "the estimate whose largest error, in units of its bound, is smallest"
        }
        ErrorBound::Interval { .. } => {
            "the estimate whose largest distance from the middle of an interval, in units of its half width, is smallest"
        }
    };
    let words = [
        (
            "EUI",
            fit.eui().is_some(),
            "estimate uncertainty interval: how far such errors can move least squares",
        ),
        (
            "PUI",
            fit.pui.is_some(),
            "parameter uncertainty interval: the range over the feasible parameter set (FPS)",
        ),
        ("central", fit.central.is_some(), "the mid-point of the PUI, guaranteed to half its width"),
        ("minimax", fit.minimax.is_some(), largest),
    ];
    let used = words.into_iter().filter(|(_, is_used, _)| *is_used);
    used.map(|(word, _, meaning)| (word.into(), meaning.into())).collect()
}

/// The rows of the table, with gain and offset when the model has an inverse.
struct Estimates<'a> {
    report: &'a Report<'a>,
    inverse: Option<[&'a InverseParameter; 2]>,
    /// With the digits that tell the ends of the ranges of gain and offset apart.
    styles: [Style; 2],
}

impl Estimates<'_> {
    fn rows(&self) -> Vec<Vec<Text>> {
        let fit = self.report.fit;
        let mut rows = Vec::new();
        if let Ok(least_squares) = &fit.least_squares {
            let inverse = self.inverse.map(|both| both.map(|parameter| parameter.least_squares.clone()));
            rows.push(self.estimate("least squares", &least_squares.theta, inverse));
        }
        if let Some(eui) = fit.eui() {
            rows.push(self.intervals("EUI", self.theta(eui), |inverse| inverse.eui_range.as_deref()));
        }
        if let Some(pui) = fit.pui_intervals() {
            rows.push(self.intervals("PUI", self.theta(&pui), |inverse| Some(&inverse.box_range)));
            if self.inverse.is_some() {
                let same = [0, 1].map(|_| Text::new().with(Inline::Ditto));
                rows.push(self.intervals("over the FPS", same, |inverse| Some(&inverse.exact_range)));
            }
        }
        if let Some(central) = &fit.central {
            let inverse = self.inverse.map(|both| both.map(|parameter| parameter.central.clone()));
            rows.push(self.estimate("central", &central.theta, inverse));
            let mut row = vec![Text::new().with(Inline::Indent).words("guaranteed")];
            row.extend(central.guaranteed_error.iter().map(|error| self.report.give_or_take(error)));
            row.resize(rows[0].len(), Text::new());
            rows.push(row);
        }
        if let Some(minimax) = &fit.minimax {
            let [theta1, theta2] = &minimax.theta;
            let inverse = self.inverse.map(|_| [theta1.recip(), (-theta2).checked_div(theta1)]);
            rows.push(self.estimate("minimax", &minimax.theta, inverse));
        }
        rows
    }

    fn theta(&self, intervals: &[Interval; 2]) -> [Text; 2] {
        [0, 1].map(|axis| self.report.theta[axis].interval(&intervals[axis]))
    }

    /// An estimate with its gain and offset.
    fn estimate(
        &self,
        label: &str,
        theta: &[Rational; 2],
        inverse: Option<[Option<Rational>; 2]>,
    ) -> Vec<Text> {
        let number = |(style, value): (&Style, &Rational)| Text::new().number(style.nearest(value));
        let mut row = vec![label.into()];
        row.extend(self.report.theta.iter().zip(theta).map(number));
        for (style, value) in self.styles.iter().zip(inverse.into_iter().flatten()) {
            row.push(value.map_or("-".into(), |value| number((style, &value))));
        }
        row
    }

    /// A box with its ranges of gain and offset.
    fn intervals<'a>(
        &'a self,
        label: &str,
        theta: [Text; 2],
        ranges: impl Fn(&'a InverseParameter) -> Option<&'a [Interval]>,
    ) -> Vec<Text> {
        let mut row = vec![label.into()];
        row.extend(theta);
        for (style, parameter) in self.styles.iter().zip(self.inverse.into_iter().flatten()) {
            row.push(ranges(parameter).map_or("-".into(), |intervals| style.union(intervals)));
        }
        row
    }

    /// What the digits of the table are.
    fn note(&self) -> String {
        let Style { digits, ends, exact } = *self.report.style;
        if exact {
            return "All numbers are exact.".to_owned();
        }
        let more = self.report.theta.iter().chain(&self.styles).any(|style| style.digits > digits);
        let more = if more { " (more where ends would look alike)" } else { "" };
        match ends {
            EndRounding::Outward => {
                format!("Rounded to {digits} digits{more}; ends of intervals and errors outward.")
            }
            EndRounding::Nearest => format!(
                "Rounded to {digits} digits{more}, to nearest: a printed interval may be too narrow by half a unit."
            ),
        }
    }
}
