//! The text report of a fit.

use boundfit_estimation::{
    BoundName, ErrorBound, Fit, FloatEstimate, InverseParameter, LeastSquares, Model, ParameterBound,
    ParameterInterval, Problem,
};
use boundfit_exact::{Interval, Rational, Reading};

use crate::advice::bounding_reading;
use crate::document::Text;
use crate::region::{point_text, region_text};
use crate::style::{EndRounding, Style};
use crate::text::{counted, list, table};

/// Why binary64 least squares is left out of a report.
pub(crate) const NO_BINARY64: &str = "not computed, since not every reading is kept in memory";

/// Where the readings come from.
#[derive(Debug, Clone, Copy)]
pub struct Origin<'a> {
    /// The file, in the words of the user.
    pub file: &'a str,
    /// The range of rows, in the words of the user; `None` for all.
    pub rows: Option<&'a str>,
    /// How numbers were read.
    pub reading: Reading,
    /// Whether the file stores them in binary, so that they were not read from text.
    pub is_stored: bool,
}

/// The report as text.
pub fn fit_text(problem: &Problem, fit: &Fit, origin: &Origin, style: &Style) -> String {
    let writer = Writer::new(problem, fit, style);
    let sections = [
        writer.heading(origin),
        writer.estimates_text(),
        writer.feasible_set(),
        writer.proofs_text(),
        writer.remarks_text(),
    ];
    let sections: Vec<String> = sections.into_iter().filter(|section| !section.is_empty()).collect();
    sections.join("\n")
}

pub(crate) const TITLE: &str = "Set-membership fit";
pub(crate) const FPS: &str = "Feasible parameter set (FPS)";
pub(crate) const PROOFS: &str = "What proves each end of the PUI";
pub(crate) const PROOF_HEADER: [&str; 3] = ["", "", "multiplier * (row and bound)"];

/// Builds the parts of a report.
pub(crate) struct Writer<'a> {
    problem: &'a Problem,
    fit: &'a Fit,
    style: &'a Style,
    /// With the digits that tell the ends of each PUI apart.
    pub(crate) theta: [Style; 2],
    /// With those for the range of gain and of offset.
    inverse: [Style; 2],
}

impl<'a> Writer<'a> {
    pub(crate) fn new(problem: &'a Problem, fit: &'a Fit, style: &'a Style) -> Self {
        let inverse = fit.inverse.as_ref().map(|inverse| [&inverse.gain, &inverse.offset]);
        let inverse = [0, 1].map(|axis| match inverse.map(|inverse| inverse[axis].exact_range.as_slice()) {
            Some([range]) => style.resolving(range),
            _ => style.clone(),
        });
        Writer { problem, fit, style, theta: style.resolving_both(fit.pui_intervals().as_ref()), inverse }
    }

    fn heading(&self, origin: &Origin) -> String {
        let facts = self.facts(origin).into_iter();
        let facts = facts.map(|(label, text)| format!("  {label:<7}  {}\n", text.plain()));
        format!("{TITLE}\n{}", facts.collect::<String>())
    }

    /// What was fitted, in which way.
    pub(crate) fn facts(&self, &Origin { file, rows, reading, is_stored }: &Origin) -> Vec<(String, Text)> {
        let measurements = &self.problem.measurements;
        let y = measurements.response();
        let (first, second) = match measurements.model() {
            Model::Line { x } => (x, None),
            Model::TwoRegressors { regressors: [first, second] } => (first, Some(second)),
        };
        let model = Text::given(y).then(Text::own(" = theta1*")).then(Text::given(first));
        let model = match second {
            None => model.then(Text::own(" + theta2")),
            Some(second) => model.then(Text::own(" + theta2*")).then(Text::given(second)),
        };
        let bound = match measurements.error_bound() {
            ErrorBound::Uniform(epsilon) => Text::own(format!("|e| <= {}", self.style.given_text(epsilon))),
            ErrorBound::PerRow(column) => {
                Text::own("|e| <= ").then(Text::given(column)).then(Text::own(", one bound per row"))
            }
        };
        let (used, total) = (measurements.fitted(), measurements.rows_total());
        let rows = match rows {
            None if measurements.is_of_reductions() => {
                let kept = counted(measurements.kept().len(), "row", "rows");
                format!("a reduction: {kept} for {}", counted(total, "reading", "readings"))
            }
            None => counted(total, "row", "rows"),
            Some(rows) => format!("rows {rows}: {used} of {total}"),
        };
        let reading = match reading {
            _ if is_stored => "binary64: the numbers of the file exactly as stored",
            Reading::Decimal => "decimal: numbers exactly as written",
            Reading::Binary64 => "binary64: the double nearest to each number, exactly",
        };
        let data = Text::given(file).then(Text::own(format!(", {rows}")));
        let facts = [
            ("model", model.then(Text::own(" + e"))),
            ("error", bound),
            ("data", data),
            ("reading", Text::own(reading)),
        ];
        let conditions = (1..).zip(&self.problem.conditions);
        let conditions =
            conditions.map(|(number, condition)| (format!("where:{number}"), Text::given(condition.text())));
        facts.map(|(label, text)| (label.to_owned(), text)).into_iter().chain(conditions).collect()
    }

    /// The table of estimates and intervals as text.
    fn estimates_text(&self) -> String {
        self.estimates()
            .map_or_else(String::new, |(header, rows)| format!("{}  {}\n", table(header, rows), self.note()))
    }

    /// The header and rows of the table of estimates and intervals.
    pub(crate) fn estimates(&self) -> Option<(&'static [&'static str], Vec<Vec<String>>)> {
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
            return None;
        }
        let header: &[&str] = match fit.inverse {
            Some(_) => &["", "theta1", "theta2", "gain 1/theta1", "offset -theta2/theta1"],
            None => &["", "theta1", "theta2"],
        };
        rows.iter_mut().for_each(|row| row.resize(header.len(), String::new()));
        Some((header, rows))
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
    pub(crate) fn note(&self) -> String {
        if self.style.exact {
            return "All numbers are exact.".to_owned();
        }
        let digits = self.style.digits;
        let more = self.theta.iter().chain(&self.inverse).any(|style| style.digits > digits);
        let more = if more { " (more where ends would look alike)" } else { "" };
        match self.style.ends {
            EndRounding::Outward => {
                format!("Rounded to {digits} digits{more}; ends of intervals and errors outward.")
            }
            EndRounding::Nearest => format!(
                "Rounded to {digits} digits{more}, to nearest: a printed interval may be too narrow by half a unit."
            ),
        }
    }

    fn feasible_set(&self) -> String {
        let region = self.fit.fps.polyhedron().region();
        let names = |indices: &[usize]| self.names(indices);
        let text = format!("{FPS}: {}", region_text(region, &self.theta, names));
        let lines = self.emptiness().into_iter().chain(self.advice());
        text + &lines.map(|line| format!("  {line}\n")).collect::<String>()
    }

    pub(crate) fn names(&self, indices: &[usize]) -> Vec<String> {
        indices.iter().map(|&index| self.fit.fps.name(index).to_string()).collect()
    }

    /// What would bound an unbounded set.
    pub(crate) fn advice(&self) -> Option<String> {
        let region = self.fit.fps.polyhedron().region();
        bounding_reading(region, self.problem.measurements.model(), self.style)
    }

    /// Which rows contradict each other, and what would help; nothing when the set is not empty.
    pub(crate) fn emptiness(&self) -> Vec<String> {
        if !self.fit.fps.polyhedron().region().is_empty() {
            return Vec::new();
        }
        let error_bound = self.problem.measurements.error_bound();
        let terms = self.fit.contradiction(error_bound).unwrap_or_default();
        let names: Vec<String> = terms.iter().map(|(name, _)| name.to_string()).collect();
        let plural = if names.len() == 1 { "cannot hold" } else { "contradict each other" };
        let contradiction = format!("No theta meets every bound. These {plural}: {}.", names.join(", "));
        let products: Vec<String> = terms
            .iter()
            .map(|(name, multiplier)| format!("{} * ({name})", self.style.proof_text(multiplier)))
            .collect();
        let sum = self.sum_of(&terms);
        let proof = format!("Proof: {} gives 0 <= {}.", products.join(" + "), self.style.upper_text(&sum));
        let help = match (&self.fit.minimax, error_bound) {
            (None, _) => "A larger error bound would not help.".to_owned(),
            (Some(minimax), ErrorBound::Uniform(epsilon)) => format!(
                "The error bound would have to grow by {}, to at least {}.",
                self.style.upper_text(&(&minimax.least - epsilon)),
                self.style.upper_text_with_exact(&minimax.least)
            ),
            (Some(minimax), ErrorBound::PerRow(_)) => format!(
                "All error bounds would have to grow by a factor of at least {}.",
                self.style.upper_text_with_exact(&minimax.least)
            ),
        };
        vec![contradiction, proof, help]
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

    /// The readings behind each end of the PUI as text.
    fn proofs_text(&self) -> String {
        let rows = self.proofs();
        if rows.is_empty() { String::new() } else { format!("{PROOFS}\n{}", table(&PROOF_HEADER, rows)) }
    }

    /// The readings behind each end of the PUI as rows.
    pub(crate) fn proofs(&self) -> Vec<Vec<String>> {
        let Some(pui) = &self.fit.pui else { return Vec::new() };
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
        rows
    }

    /// One line for each remaining result as text.
    fn remarks_text(&self) -> String {
        self.remarks().iter().map(|(label, line)| format!("{label:<14} {line}\n")).collect()
    }

    /// One line for each remaining result, some without a label.
    pub(crate) fn remarks(&self) -> Vec<(&'static str, String)> {
        let (fit, style) = (self.fit, self.style);
        let mut lines: Vec<(&'static str, String)> = Vec::new();
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
        lines
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
