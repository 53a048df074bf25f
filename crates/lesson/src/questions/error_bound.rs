//! The smallest error bound.

use boundfit_estimation::{BoundName, Measurement, Minimax, reading_of_bound};
use boundfit_exact::{Rational, Rounding};

use super::wording::{clash, combination, owners, sentences, size, value};
use super::{Facts, Question, Show};
use crate::number::DIGITS;
use crate::texts::{Message, text};

/// Asks for the smallest error bound that leaves anything, and for the readings that fix it.
pub(super) fn least(facts: &Facts<'_>) -> Question {
    let uniform = facts.problem.measurements.error_bound().is_uniform();
    let question = text!(if uniform { "q.least.question" } else { "q.least.question-factor" });
    let answer = match &facts.fit.minimax {
        None => none(facts, uniform),
        Some(minimax) if minimax.least.is_zero() => zero(facts, uniform),
        Some(minimax) => positive(facts, minimax, uniform),
    };
    let show = facts.fit.minimax.as_ref().map(|_| Show::Layer { layer: "minimax" });
    Question { id: "smallest-error-bound", question, answer, show }
}

/// Returns the reason why no error bound, however large, leaves anything.
fn none(facts: &Facts<'_>, uniform: bool) -> Message {
    if let Some(terms) = facts.fit.contradiction_of_conditions() {
        let names: Vec<BoundName> = terms.iter().map(|(name, _)| *name).collect();
        return text!("q.least.none", clash: clash(&names, facts.problem), symbol: symbol(uniform));
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
    let conditions = facts.problem.conditions.len();
    text!("q.least.fixed", clash: clash(&names, facts.problem), conditions: conditions)
}

/// Returns the symbol of the least quantity: the one error bound, or the factor on all of them.
fn symbol(uniform: bool) -> &'static str {
    if uniform { "ε" } else { "s" }
}

fn zero(facts: &Facts<'_>, uniform: bool) -> Message {
    let answer = if facts.is_line() { "q.least.zero-line" } else { "q.least.zero-pair" };
    let conditions = facts.problem.conditions.len();
    // A reading with one bound has no middle.
    let readings = facts.problem.measurements.all().unwrap_or_default();
    let open = if readings.iter().all(|reading| reading.value().is_some()) { 1 } else { 2 };
    let answer = text!(answer, symbol: symbol(uniform), open: open, conditions: conditions);
    sentences([Some(answer), present(facts, &Rational::zero(), uniform)].into_iter().flatten())
}

fn positive(facts: &Facts<'_>, minimax: &Minimax, uniform: bool) -> Message {
    let (owners, several) = owners(minimax.proof.multipliers.iter().map(|(name, _)| *name), facts.problem);
    let symbol = || symbol(uniform);
    let least = value(&minimax.least, DIGITS, Rounding::Up);
    let fixed = text!("q.least.fixes", owners: owners, several: if several { 2 } else { 1 });
    let proof = text!(
        "q.least.proof",
        combination: combination(&minimax.proof.multipliers, facts.problem),
        terms: minimax.proof.multipliers.len(),
        symbol: symbol(),
        least: size(&minimax.least, Rounding::Up)
    );
    let left = text!(if minimax.unique { "q.least.single" } else { "q.least.more" });
    let answer =
        text!("q.least.answer", symbol: symbol(), least: least, fixed: fixed, proof: proof, left: left);
    sentences([Some(answer), present(facts, &minimax.least, uniform)].into_iter().flatten())
}

/// Returns the comparison with the error bound in use.
fn present(facts: &Facts<'_>, least: &Rational, uniform: bool) -> Option<Message> {
    let (in_use, what) = match facts.problem.measurements.error_bound().uniform() {
        Some(epsilon) => (epsilon.clone(), value(epsilon, DIGITS, Rounding::Nearest)),
        None => (Rational::one(), "1".into()),
    };
    match in_use.cmp(least) {
        std::cmp::Ordering::Less => Some(text!("q.least.empty", symbol: symbol(uniform), value: what)),
        std::cmp::Ordering::Equal => Some(text!("q.least.in-use", symbol: symbol(uniform))),
        std::cmp::Ordering::Greater => None,
    }
}
