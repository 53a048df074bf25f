//! The smallest error bound.

use boundfit_estimation::{BoundName, Measurement, Minimax, reading_of_bound};
use boundfit_exact::english::sentence;
use boundfit_exact::{Rational, Rounding};

use super::wording::{clash, combination, owners, size, value};
use super::{Facts, Question, Show};
use crate::number::DIGITS;

/// What is the smallest error bound that leaves anything, and who fixes it?
pub(super) fn least(facts: &Facts<'_>) -> Question {
    let uniform = facts.problem.measurements.error_bound().is_uniform();
    let question = if uniform {
        "What is the smallest error bound ε that leaves a feasible parameter pair, and what fixes it?"
    } else {
        "All error bounds are multiplied by one factor s. What is the smallest s that leaves a feasible parameter pair, and what fixes it?"
    };
    let answer = match &facts.fit.minimax {
        None => none(facts, uniform),
        Some(minimax) if minimax.least.is_zero() => zero(facts, uniform),
        Some(minimax) => positive(facts, minimax, uniform),
    };
    let show = facts.fit.minimax.as_ref().map(|_| Show::Layer { layer: "minimax" });
    Question { id: "smallest-error-bound", question: question.to_owned(), answer, show }
}

/// Why no error bound, however large, leaves anything.
fn none(facts: &Facts<'_>, uniform: bool) -> String {
    let symbol = if uniform { "ε" } else { "s" };
    if let Some(terms) = facts.fit.contradiction_of_conditions() {
        let names: Vec<BoundName> = terms.iter().map(|(name, _)| *name).collect();
        return format!("There is none: {}, however large {symbol} is.", clash(&names, facts.problem));
    }
    let rows = facts.problem.measurements.kept();
    let grows = |index: &usize| {
        let row = reading_of_bound(rows, *index).and_then(|position| rows.get(position));
        row.and_then(Measurement::half_width).is_some_and(|width| width.is_positive())
    };
    let growing: Vec<usize> = (0..facts.inequalities().len()).filter(grows).collect();
    let (fixed, names) = facts.others(&growing);
    let multipliers = fixed.region().certificate().map_or(&[][..], |certificate| certificate.multipliers());
    let names: Vec<BoundName> = multipliers.iter().filter_map(|m| names.get(m.index).copied()).collect();
    let fixed = if facts.problem.conditions.is_empty() {
        "an error bound of 0"
    } else {
        "an error bound of 0 or a condition"
    };
    format!("There is none: no factor changes {fixed}, and {}.", clash(&names, facts.problem))
}

fn zero(facts: &Facts<'_>, uniform: bool) -> String {
    let symbol = if uniform { "ε" } else { "s" };
    let (noun, meets) = if facts.is_line() {
        ("a line", "passes exactly through every reading")
    } else {
        ("a parameter pair", "reproduces every reading exactly")
    };
    let conditions = match facts.problem.conditions.len() {
        0 => "",
        1 => " and satisfies the condition",
        _ => " and satisfies the conditions",
    };
    format!(
        "{symbol} = 0: there is {noun} that {meets}{conditions}, so nothing keeps the error bound from 0.{}",
        present(facts, &Rational::zero(), symbol)
    )
}

fn positive(facts: &Facts<'_>, minimax: &Minimax, uniform: bool) -> String {
    let symbol = if uniform { "ε" } else { "s" };
    let least = value(&minimax.least, DIGITS, Rounding::Up);
    let (owners, several) = owners(minimax.proof.multipliers.iter().map(|(name, _)| *name), facts.problem);
    let terms = combination(&minimax.proof.multipliers, facts.problem);
    let left = if minimax.unique {
        "a single point is left, the minimax estimate"
    } else {
        "more than one point is left, of which the minimax estimate is one"
    };
    format!(
        "{symbol} = {least}. {} {} it: as inequalities in θ, {terms} {} 0 ≤ {symbol} − {}, which is false for every \
         smaller {symbol}. At this value {left}.{}",
        sentence(&owners),
        if several { "fix" } else { "fixes" },
        if minimax.proof.multipliers.len() > 1 { "add up to" } else { "says that" },
        size(&minimax.least, Rounding::Up),
        present(facts, &minimax.least, symbol)
    )
}

/// How the error bound in use compares.
fn present(facts: &Facts<'_>, least: &Rational, symbol: &str) -> String {
    let (in_use, what) = match facts.problem.measurements.error_bound().uniform() {
        Some(epsilon) => (epsilon.clone(), value(epsilon, DIGITS, Rounding::Nearest)),
        None => (Rational::one(), "1".to_owned()),
    };
    match in_use.cmp(least) {
        std::cmp::Ordering::Less => format!(" With {symbol} = {what} the set is empty."),
        std::cmp::Ordering::Equal => format!(" This is the {symbol} in use."),
        std::cmp::Ordering::Greater => String::new(),
    }
}
