//! The next steps for an empty set, as data: a surface says how it takes them.

use boundfit_estimation::{ErrorBound, Fit, Problem};

use crate::document::{Block, Document, Facts, Text};
use crate::style::{EndRounding, Style};

/// A question that helps with an empty set.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NextStep {
    /// Find the fewest readings to leave out.
    Outliers,
    /// Classify each reading against the others.
    Status,
    /// Fit again under an error bound of at least ε_min, whose decimal is rounded up.
    LeastBound(String),
}

impl NextStep {
    /// Says what the step answers.
    fn purpose(&self) -> &'static str {
        match self {
            NextStep::Outliers => "the fewest readings to leave out",
            NextStep::Status => "the readings that disagree with the others",
            NextStep::LeastBound(_) => "if errors can be as large as eps_min",
        }
    }
}

/// Returns the steps that help where the set is empty; none where it is not, nor where the conditions alone make it so.
pub fn next_steps(problem: &Problem, fit: &Fit, style: &Style) -> Vec<NextStep> {
    if !fit.fps.polyhedron().is_empty() || fit.contradiction_of_conditions().is_some() {
        return Vec::new();
    }
    let measurements = &problem.measurements;
    let of_readings = [NextStep::Outliers, NextStep::Status];
    let of_readings = of_readings.into_iter().filter(|_| !measurements.is_of_reductions());
    let is_uniform = matches!(measurements.error_bound(), ErrorBound::Uniform(_));
    let least = fit.minimax.as_ref().filter(|_| is_uniform);
    // Rounded to nearest the bound could be too small for what it is for.
    let style = &Style { ends: EndRounding::Outward, ..*style };
    let least = least.map(|minimax| NextStep::LeastBound(style.upper(&minimax.least).to_string()));
    of_readings.chain(least).collect()
}

/// Writes the steps that a surface can take, each with its words for it.
pub fn next_document(steps: &[NextStep], words: impl Fn(&NextStep) -> Option<String>) -> Document<'static> {
    let row = |step: &NextStep| Some((Text::from(words(step)?), Text::from(step.purpose())));
    let rows: Vec<(Text, Text)> = steps.iter().filter_map(row).collect();
    if rows.is_empty() {
        return Document::default();
    }
    let width = rows.iter().map(|(label, _)| label.to_string().len()).max().unwrap_or_default();
    Document::new(vec![
        Block::Title("Next steps, with the same data".into()),
        Block::Facts(Facts { width, rows }),
    ])
}
