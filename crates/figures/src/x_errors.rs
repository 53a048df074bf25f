//! The texts of figures of errors in x.

use boundfit_exact::Rounding;
use boundfit_questions::{Agreement, NoLeastFactor, Side, SideSet, XBounds, XErrorFit, XErrorProblem};

use crate::figure::PlotOptions;
use crate::labels::{self, Conflict};
use crate::text::one_line;

/// Significant digits of the least factor.
const DIGITS: usize = 5;

/// Returns the possible error of x, and the demands on a line.
pub(crate) fn asked(problem: &XErrorProblem, options: &PlotOptions) -> String {
    let unit = labels::unit(&options.x_unit).map(|unit| format!(" {unit}")).unwrap_or_default();
    let bound = match problem.bounds() {
        XBounds::Uniform(bound) => format!("up to {}{unit}", labels::number(bound, 12, Rounding::Up)),
        XBounds::PerRow { column, .. } => {
            format!("up to {} of its row", one_line(column, labels::LONGEST_NAME))
        }
    };
    let asked = match problem.agreement() {
        Agreement::Weak => "a line has to meet the box of each reading",
        Agreement::Strong => "a line has to keep between top and bottom of each box, all along it",
    };
    format!("Each x is known {bound}; {asked}.")
}

/// Returns the bounds of a side that contradict each other.
pub(crate) fn conflict(side: &SideSet) -> Conflict {
    let bounds = side.contradiction().unwrap_or_default();
    Conflict::among(bounds.into_iter().filter_map(|(bound, _)| bound.name()))
}

/// Returns the reason why there is no line, side by side, and the remedies; nothing when there is a line.
pub(crate) fn emptiness(problem: &XErrorProblem, answer: &XErrorFit) -> Vec<String> {
    if !answer.is_empty() {
        return Vec::new();
    }
    let first = match problem.agreement() {
        Agreement::Weak => "No line meets the boxes of all readings.",
        Agreement::Strong => "No line keeps between top and bottom of all boxes, all along them.",
    };
    let sides = answer.sides.iter().map(|side| {
        let conflict = conflict(side);
        match side.side {
            Side::Rising => format!("Rising and level lines: {}", conflict.claim()),
            Side::Falling => format!("Falling and level lines: {}", conflict.claim()),
            Side::Both => conflict.sentence(),
        }
    });
    let help = match &answer.least {
        Err(NoLeastFactor::Never) => "Larger error bounds would not help.".to_owned(),
        Err(reason @ NoLeastFactor::NotMonotone) => format!("No factor is told: {reason}."),
        Ok(least) => {
            let factor = least.upper.rounded(DIGITS, Rounding::Up);
            let than = if least.theta.is_some() { "at least" } else { "more than" };
            let factor = labels::number(&factor, DIGITS, Rounding::Up);
            format!("All bounds, of x and y, would have to grow by a factor of {than} {factor}.")
        }
    };
    [first.to_owned()].into_iter().chain(sides).chain([help]).collect()
}
