//! The steepest and the shallowest line of a set, in words.

use boundfit_estimation::{BoundName, Fit, Model, ParameterBound, Problem};
use boundfit_exact::english::list;
use boundfit_exact::{Foreign, Interval};
use boundfit_questions::{BoxBound, SlopeEnd};

use crate::document::{Operator, Text};
use crate::formula::sum_text;
use crate::scale::Scale;

/// A line at an end of the PUI of θ1.
struct SlopeLine<'a> {
    bound: &'a ParameterBound,
    /// The readings whose bounds it touches, which prove it.
    through: Vec<String>,
    /// The inequalities, not of readings, that end the slopes there.
    limits: Vec<String>,
}

/// The lines at both ends of the slopes of a fitted line, each behind what it is called; nothing for an empty set and for two
/// regressors.
pub(crate) fn of_fit(problem: &Problem, fit: &Fit, scales: &[Scale; 2]) -> Vec<(Text, Text)> {
    let (Model::Line { .. }, Some([pui, _])) = (problem.measurements.model(), &fit.pui) else {
        return Vec::new();
    };
    let name = |index: usize| fit.fps.name(index).into();
    let line = |is_upper| Some(SlopeLine::new(if is_upper { &pui.upper } else { &pui.lower }, name));
    lines(&pui.interval(), problem, scales, line)
}

/// The lines at the ends of these slopes, each behind what it is called. `end` gives the upper or the lower end with the names of
/// its half-planes.
pub(crate) fn of_ends<'a, N: Fn(usize) -> BoxBound>(
    slopes: &Interval,
    problem: &Problem,
    scales: &[Scale; 2],
    end: impl Fn(bool) -> Option<(&'a ParameterBound, N)>,
) -> Vec<(Text, Text)> {
    let line = |is_upper| end(is_upper).map(|(bound, name)| SlopeLine::new(bound, name));
    lines(slopes, problem, scales, line)
}

fn lines<'a>(
    slopes: &Interval,
    problem: &Problem,
    scales: &[Scale; 2],
    line: impl Fn(bool) -> Option<SlopeLine<'a>>,
) -> Vec<(Text, Text)> {
    let ends = SlopeEnd::of(slopes);
    if ends.is_empty() {
        return vec![("slope".into(), "any: there are lines as steep as one likes, both ways".into())];
    }
    let text =
        |(end, is_upper): (SlopeEnd, bool)| Some((label(end).into(), line(is_upper)?.text(problem, scales)));
    ends.into_iter().filter_map(text).collect()
}

/// The name of the line at an end of the slopes.
fn label(end: SlopeEnd) -> &'static str {
    match end {
        SlopeEnd::Steepest => "steepest",
        SlopeEnd::Shallowest => "shallowest",
        SlopeEnd::Only => "slope",
        SlopeEnd::RisesMost => "rises most",
        SlopeEnd::FallsMost => "falls most",
    }
}

impl<'a> SlopeLine<'a> {
    /// Returns the end of the interval, with the names of the half-planes.
    fn new(bound: &'a ParameterBound, name: impl Fn(usize) -> BoxBound) -> Self {
        let mut line = SlopeLine { bound, through: Vec::new(), limits: Vec::new() };
        let ParameterBound::Bounded { proof, .. } = bound else { return line };
        let mut names: Vec<BoxBound> = proof.multipliers.iter().map(|own| name(own.index)).collect();
        names.sort_unstable();
        for own in names {
            match own.name() {
                Some(BoundName::Upper(_) | BoundName::Lower(_)) => line.through.push(own.to_string()),
                // An equation holds for every line.
                Some(BoundName::WhereUpper(_) | BoundName::WhereLower(_)) => {}
                Some(BoundName::Where(_)) | None => line.limits.push(own.to_string()),
            }
        }
        line
    }

    /// The line, and what it touches.
    fn text(&self, problem: &Problem, scales: &[Scale; 2]) -> Text {
        let ParameterBound::Bounded { proof, .. } = self.bound else {
            return "none: there are lines as steep as one likes".into();
        };
        let measurements = &problem.measurements;
        let x: Foreign = match measurements.model() {
            Model::Line { x } => measurements.line_form().abscissa(x),
            Model::TwoRegressors { .. } => Foreign::default(),
        };
        let x = if measurements.line_form().x_origin.is_zero() { x } else { format!("({})", x.raw()).into() };
        let theta = proof.attained_at.coordinates();
        let size = |axis: usize| {
            // A sum has its signs by itself.
            let shown = scales[axis].value(&theta[axis]).to_string();
            Text::new().number(shown.strip_prefix('-').unwrap_or(&shown))
        };
        let terms =
            [(theta[0].clone(), size(0), Some(Text::new().given(&x))), (theta[1].clone(), size(1), None)];
        // An inequality of the slope alone leaves several lines there.
        let is_one_of_many = self.through.is_empty() && !measurements.line_form().through_origin;
        let start = if is_one_of_many { Text::from("such as ") } else { Text::new() };
        let mut line = start.given(measurements.response()).operator(Operator::Equals).then(sum_text(terms));
        for (words, names) in [("through", &self.through), ("limited by", &self.limits)] {
            if !names.is_empty() {
                line = line.words(format!(", {words} {}", list(names.iter().cloned())));
            }
        }
        line
    }
}
