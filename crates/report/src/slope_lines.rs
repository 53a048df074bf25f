//! The steepest and the shallowest line of a set, in words.

use boundfit_estimation::{Model, ParameterBound, Problem};
use boundfit_exact::english::list;
use boundfit_exact::{Foreign, Interval, Rational};

use crate::document::{Operator, Text};
use crate::formula::sum_text;
use crate::scale::Scale;

/// A line at an end of the PUI of θ1.
pub(crate) struct SlopeLine<'a> {
    bound: &'a ParameterBound,
    /// The bounds that it touches, which prove it.
    names: Vec<String>,
}

/// What the lines at the two ends of the slopes are called, each with whether it is at the upper end.
pub(crate) fn labels(slopes: &Interval) -> Vec<(&'static str, bool)> {
    let zero = Rational::zero();
    let (lower, upper) = (slopes.lower().value(), slopes.upper().value());
    match (lower, upper) {
        (Some(lower), Some(upper)) if lower == upper => vec![("slope", true)],
        (Some(lower), _) if *lower >= zero => vec![("steepest", true), ("shallowest", false)],
        (_, Some(upper)) if *upper <= zero => vec![("steepest", false), ("shallowest", true)],
        _ => vec![("rises most", true), ("falls most", false)],
    }
}

impl<'a> SlopeLine<'a> {
    /// From the end of the interval, with the names of the half-planes.
    pub(crate) fn new(bound: &'a ParameterBound, name: impl Fn(usize) -> String) -> Self {
        let names = match bound {
            ParameterBound::Bounded { proof, .. } => {
                let mut indices: Vec<usize> = proof.multipliers.iter().map(|own| own.index).collect();
                indices.sort_unstable();
                indices.into_iter().map(name).collect()
            }
            ParameterBound::Unbounded(_) => Vec::new(),
        };
        SlopeLine { bound, names }
    }

    /// The line, and what it touches.
    pub(crate) fn text(&self, problem: &Problem, scales: &[Scale; 2]) -> Text {
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
        let line =
            Text::new().given(measurements.response()).operator(Operator::Equals).then(sum_text(terms));
        match self.names.is_empty() {
            true => line,
            false => line.words(format!(", through {}", list(self.names.iter().cloned()))),
        }
    }
}
