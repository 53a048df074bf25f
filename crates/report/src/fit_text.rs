//! The text report of a fit.

use boundfit_estimation::{
    BoundName, ErrorBound, Fit, FloatEstimate, InverseParameter, LeastSquares, Model, ParameterBound,
    ParameterInterval, Problem,
};
use boundfit_exact::{Interval, Rational, Reading};

use crate::advice::bounding_reading;
use crate::region::{point_text, region_text};
use crate::style::{EndRounding, Style};
use crate::text::{counted, list, table};

/// Why binary64 least squares is left out of a report.
pub(crate) const NO_BINARY64: &str = "not computed, since not every reading is kept in memory";

/// The report as text. `file` and `rows` say where the readings come from, in the words of the user.
pub fn fit_text(
    problem: &Problem,
    fit: &Fit,
    file: &str,
    rows: Option<&str>,
    reading: Reading,
    style: &Style,
) -> String {
    let writer = Writer::new(problem, fit, style);
    let sections = [
        writer.heading(file, rows, reading),
        writer.estimates(),
        writer.feasible_set(),
        writer.proofs(),
        writer.remarks(),
    ];
    let sections: Vec<String> = sections.into_iter().filter(|section| !section.is_empty()).collect();
    sections.join("\n")
}

struct Writer<'a> {
    problem: &'a Problem,
    fit: &'a Fit,
    style: &'a Style,
    /// With the digits that tell the ends of each PUI apart.
    theta: [Style; 2],
    /// With those for the range of gain and of offset.
    inverse: [Style; 2],
}

impl<'a> Writer<'a> {
    fn new(problem: &'a Problem, fit: &'a Fit, style: &'a Style) -> Self {
        let inverse = fit.inverse.as_ref().map(|inverse| [&inverse.gain, &inverse.offset]);
        let inverse = [0, 1].map(|axis| match inverse.map(|inverse| inverse[axis].exact_range.as_slice()) {
            Some([range]) => style.resolving(range),
            _ => style.clone(),
        });
        Writer { problem, fit, style, theta: style.resolving_both(fit.pui_intervals().as_ref()), inverse }
    }

    fn heading(&self, file: &str, rows: Option<&str>, reading: Reading) -> String {
        let measurements = &self.problem.measurements;
        let y = measurements.response();
        let model = match measurements.model() {
            Model::Line { x } => format!("{y} = theta1*{x} + theta2 + e"),
            Model::TwoRegressors { regressors: [first, second] } => {
                format!("{y} = theta1*{first} + theta2*{second} + e")
            }
        };
        let bound = match measurements.error_bound() {
            ErrorBound::Uniform(epsilon) => format!("|e| <= {}", self.style.given_text(epsilon)),
            ErrorBound::PerRow(column) => format!("|e| <= {column}, one bound per row"),
        };
        let (used, total) = (measurements.fitted(), measurements.rows_total());
        let rows = match rows {
            None if measurements.is_of_reductions() => {
                let kept = counted(measurements.rows().len(), "row", "rows");
                format!("a reduction: {kept} for {}", counted(total, "reading", "readings"))
            }
            None => counted(total, "row", "rows"),
            Some(rows) => format!("rows {rows}: {used} of {total}"),
        };
        let reading = match reading {
            Reading::Decimal => "decimal: numbers exactly as written",
            Reading::Binary64 => "binary64: the double nearest to each number, exactly",
        };
        let mut text = format!(
            "Set-membership fit\n  model    {model}\n  error    {bound}\n  data     {file}, {rows}\n  reading  {reading}\n"
        );
        for (number, condition) in (1..).zip(&self.problem.conditions) {
            text.push_str(&format!("  where:{number}  {}\n", condition.text()));
        }
        text
    }

    /// The table of estimates and intervals.
    fn estimates(&self) -> String {
        let fit = self.fit;
        let mut rows = Vec::new();
        let of_inverse = |pick: fn(&InverseParameter) -> Option<&Rational>| {
            fit.inverse.as_ref().map(|inverse| [pick(&inverse.gain), pick(&inverse.offset)])
        };
        if let Ok(least_squares) = &fit.least_squares {
            let inverse = of_inverse(|parameter| parameter.least_squares.as_ref());
            rows.push(self.estimate_row("least squares", &least_squares.theta, inverse));
        }
        if let Some(eui) = fit.eui() {
            rows.push(self.interval_row("EUI", eui, |inverse| inverse.eui_range.as_deref()));
        }
        if let Some(pui) = fit.pui_intervals() {
            rows.push(self.interval_row("PUI", &pui, |inverse| Some(&inverse.box_range)));
            if fit.inverse.is_some() {
                let mut row = self.interval_row("over the FPS", &pui, |inverse| Some(&inverse.exact_range));
                row[1..3].fill("\"".to_owned());
                rows.push(row);
            }
        }
        if let Some(central) = &fit.central {
            let inverse = of_inverse(|parameter| parameter.central.as_ref());
            rows.push(self.estimate_row("central", &central.theta, inverse));
            let error = central
                .guaranteed_error
                .each_ref()
                .map(|error| format!("+-{}", self.style.upper_text(error)));
            rows.push([vec!["  guaranteed".to_owned()], error.to_vec()].concat());
        }
        if let Some(minimax) = &fit.minimax {
            let gain = minimax.theta[0].recip();
            let offset = (-&minimax.theta[1]).checked_div(&minimax.theta[0]);
            let inverse = fit.inverse.as_ref().map(|_| [gain.as_ref(), offset.as_ref()]);
            rows.push(self.estimate_row("minimax", &minimax.theta, inverse));
        }
        if rows.is_empty() {
            return String::new();
        }
        let header = ["", "theta1", "theta2", "gain 1/theta1", "offset -theta2/theta1"];
        let width = if fit.inverse.is_some() { 5 } else { 3 };
        rows.iter_mut().for_each(|row| row.resize(width, String::new()));
        table(&header[..width], rows) + &self.note()
    }

    /// An estimate with gain and offset, when the model has an inverse.
    fn estimate_row(
        &self,
        label: &str,
        theta: &[Rational; 2],
        inverse: Option<[Option<&Rational>; 2]>,
    ) -> Vec<String> {
        let mut row = vec![label.to_owned()];
        row.extend(self.theta.iter().zip(theta).map(|(style, value)| style.text(value)));
        for (style, value) in self.inverse.iter().zip(inverse.into_iter().flatten()) {
            row.push(value.map_or("-".to_owned(), |value| style.text(value)));
        }
        row
    }

    /// A box with the ranges of gain and offset, when the model has an inverse.
    fn interval_row(
        &self,
        label: &str,
        intervals: &[Interval; 2],
        ranges: impl Fn(&InverseParameter) -> Option<&[Interval]>,
    ) -> Vec<String> {
        let mut row = vec![label.to_owned()];
        row.extend(self.theta.iter().zip(intervals).map(|(style, interval)| style.interval_text(interval)));
        if let Some(inverse) = &self.fit.inverse {
            for (style, parameter) in self.inverse.iter().zip([&inverse.gain, &inverse.offset]) {
                row.push(ranges(parameter).map_or("-".to_owned(), |intervals| style.union_text(intervals)));
            }
        }
        row
    }

    /// What the numbers of the table are.
    fn note(&self) -> String {
        if self.style.exact {
            return "  All numbers are exact.\n".to_owned();
        }
        let digits = self.style.digits;
        let more = self.theta.iter().chain(&self.inverse).any(|style| style.digits > digits);
        let more = if more { " (more where ends would look alike)" } else { "" };
        match self.style.ends {
            EndRounding::Outward => {
                format!("  Rounded to {digits} digits{more}; ends of intervals and errors outward.\n")
            }
            EndRounding::Nearest => format!(
                "  Rounded to {digits} digits{more}, to nearest: a printed interval may be too narrow by half a unit.\n"
            ),
        }
    }

    fn feasible_set(&self) -> String {
        let region = self.fit.fps.polyhedron().region();
        let name =
            |indices: &[usize]| indices.iter().map(|&index| self.fit.fps.name(index).to_string()).collect();
        let mut text = format!("Feasible parameter set (FPS): {}", region_text(region, &self.theta, name));
        if region.is_empty() {
            text.push_str(&self.emptiness());
        }
        if let Some(advice) = bounding_reading(region, self.problem.measurements.model(), self.style) {
            text.push_str(&format!("  {advice}\n"));
        }
        text
    }

    /// Which rows contradict each other, and what would help.
    fn emptiness(&self) -> String {
        let error_bound = self.problem.measurements.error_bound();
        let terms = self.fit.contradiction(error_bound).unwrap_or_default();
        let names: Vec<String> = terms.iter().map(|(name, _)| name.to_string()).collect();
        let plural = if names.len() == 1 { "cannot hold" } else { "contradict each other" };
        let mut text = format!("  No theta meets every bound. These {plural}: {}.\n", names.join(", "));
        let products: Vec<String> = terms
            .iter()
            .map(|(name, multiplier)| format!("{} * ({name})", self.style.proof_text(multiplier)))
            .collect();
        let sum = self.sum_of(&terms);
        text.push_str(&format!(
            "  Proof: {} gives 0 <= {}.\n",
            products.join(" + "),
            self.style.upper_text(&sum)
        ));
        text.push_str(&match (&self.fit.minimax, error_bound) {
            (None, _) => "  A larger error bound would not help.\n".to_owned(),
            (Some(minimax), ErrorBound::Uniform(epsilon)) => format!(
                "  The error bound would have to grow by {}, to at least {}.\n",
                self.style.upper_text(&(&minimax.least - epsilon)),
                self.style.upper_text_with_exact(&minimax.least)
            ),
            (Some(minimax), ErrorBound::PerRow(_)) => format!(
                "  All error bounds would have to grow by a factor of at least {}.\n",
                self.style.upper_text_with_exact(&minimax.least)
            ),
        });
        text
    }

    /// The right-hand side of a combination of half-planes.
    fn sum_of(&self, terms: &[(BoundName, Rational)]) -> Rational {
        let inequalities = self.fit.fps.polyhedron().system().inequalities();
        let right_hand_side = |name: &BoundName| {
            (0..inequalities.len())
                .find(|&index| self.fit.fps.name(index) == *name)
                .map(|index| &inequalities[index].b)
        };
        terms.iter().filter_map(|(name, multiplier)| Some(right_hand_side(name)? * multiplier)).sum()
    }

    /// The readings behind each end of the PUI.
    fn proofs(&self) -> String {
        let Some(pui) = &self.fit.pui else { return String::new() };
        let mut rows = Vec::new();
        for (axis, ParameterInterval { lower, upper }) in pui.iter().enumerate() {
            let (parameter, style) = (["theta1", "theta2"][axis], &self.theta[axis]);
            for (relation, end, is_lower) in [(">=", lower, true), ("<=", upper, false)] {
                let ParameterBound::Bounded { value, proof } = end else { continue };
                let value = if is_lower { style.lower_text(value) } else { style.upper_text(value) };
                let product = |m: &boundfit_geometry::Multiplier| {
                    format!("{} * ({})", self.style.proof_text(&m.value), self.fit.fps.name(m.index))
                };
                let products: Vec<String> = proof.multipliers.iter().map(product).collect();
                rows.push(vec![format!("{parameter} {relation}"), value, products.join(" + ")]);
            }
        }
        if rows.is_empty() {
            return String::new();
        }
        format!("What proves each end of the PUI\n{}", table(&["", "", "multiplier * (row and bound)"], rows))
    }

    /// One line for each remaining result.
    fn remarks(&self) -> String {
        let (fit, style) = (self.fit, self.style);
        let mut lines: Vec<(&str, String)> = Vec::new();
        match (&fit.minimax, self.problem.measurements.error_bound()) {
            (None, _) => lines.push(("eps_min", "none: no error bound, however large, is enough".to_owned())),
            (Some(minimax), bound) => {
                let least = style.upper_text_with_exact(&minimax.least);
                let proof = list(minimax.proof.multipliers.iter().map(|(name, _)| name.to_string()));
                let reason = if proof.is_empty() { String::new() } else { format!(", fixed by {proof}") };
                lines.push(match bound {
                    ErrorBound::Uniform(_) => ("eps_min", format!("{least}{reason}")),
                    ErrorBound::PerRow(_) => ("eps_min", format!("{least} times each row's bound{reason}")),
                });
                if !minimax.unique {
                    lines.push(("", "the minimax estimate is not unique; this is one of many".to_owned()));
                }
            }
        }
        let region = fit.fps.polyhedron().region();
        if let Some(area) = region.area().filter(|_| !region.is_empty()) {
            let of_box =
                fit.tightness().map(|tightness| format!(", {} of its PUI box", style.text(&tightness)));
            lines.push(("area", style.text(&area) + &of_box.unwrap_or_default()));
        }
        if let Some(centroid) = region.area_centroid() {
            lines.push(("centroid", point_text(&centroid.coordinates(), &self.theta)));
        }
        lines.extend(self.least_squares_remarks());
        lines.iter().map(|(label, line)| format!("{label:<14} {line}\n")).collect()
    }

    fn least_squares_remarks(&self) -> Vec<(&'static str, String)> {
        let (fit, style) = (self.fit, self.style);
        let mut lines = Vec::new();
        match (&fit.least_squares, fit.least_squares_slack()) {
            (Err(singular), _) => lines.push(("least squares", format!("none: {singular}"))),
            (Ok(_), Some((slack, name))) if slack.is_negative() => {
                let excess = style.upper_text(&-slack);
                lines.push(("least squares", format!("not feasible: exceeds {name} by {excess}")));
            }
            (Ok(_), _) => lines.push(("least squares", "feasible".to_owned())),
        }
        if let Some(error) = fit.least_squares_guaranteed_error() {
            let error = error.each_ref().map(|error| format!("+-{}", style.upper_text(error)));
            lines.push(("", format!("guaranteed error theta1 {}, theta2 {}", error[0], error[1])));
        }
        let float = |method: &str, estimate: &Option<FloatEstimate>| match estimate {
            Some(FloatEstimate { distance: [first, second], .. }) => {
                format!("{method} off by {} and {}", style.upper_text(first), style.upper_text(second))
            }
            None => format!("{method} fails"),
        };
        let floats = fit.float_least_squares(&self.problem.measurements);
        if fit.least_squares.is_ok() && floats.is_none() {
            lines.push(("", format!("in binary64: {NO_BINARY64}")));
        }
        if let Some(floats) = &floats {
            let (qr, pseudo_inverse) =
                (float("QR", &floats.qr), float("pseudo-inverse", &floats.pseudo_inverse));
            lines.push(("", format!("in binary64: {qr}; {pseudo_inverse}")));
        }
        if let Ok(LeastSquares { eui: Err(reason), .. }) = &fit.least_squares {
            lines.push(("EUI", format!("none: {reason}")));
        }
        lines
    }
}
