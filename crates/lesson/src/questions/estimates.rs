//! The least-squares and the central estimate.

use boundfit_estimation::{BoundName, Central, Fit, NoLeastSquares};
use boundfit_exact::{PlusMinus, Rational, Rounding};

use super::wording::{bound, bounds, decimal, every_bound, sentences, value};
use super::{Facts, Question, Show};
use crate::number::DIGITS;
use crate::texts::{Message, text};

/// Is the least-squares line feasible?
pub(super) fn least_squares(facts: &Facts<'_>) -> Question {
    let question = of_model(facts, "q.squares.question-line", "q.squares.question-estimate");
    let (answer, show) = match facts.fit.least_squares_slack() {
        None => (text!("q.squares.none", why: no_least_squares(facts)), None),
        Some((slack, name)) => {
            let tightest = bound(name, facts.problem);
            let answer = if slack.is_negative() {
                infeasible(facts, tightest, &slack.abs())
            } else if slack.is_zero() {
                tight(facts)
            } else {
                let spare = value(&slack, DIGITS, Rounding::Down);
                text!("q.squares.yes", bounds: every_bound(facts.problem), tightest: tightest, spare: spare)
            };
            (answer, Some(Show::Layer { layer: "least-squares" }))
        }
    };
    Question { id: "least-squares-feasible", question, answer, show }
}

/// The text of the first key for a line, of the second one for two regressors.
fn of_model(facts: &Facts<'_>, line: &str, two_regressors: &str) -> Message {
    text!(if facts.is_line() { line } else { two_regressors })
}

/// Returns the reason, in the words of the layers where they are as short.
fn no_least_squares(facts: &Facts<'_>) -> Message {
    match facts.fit.least_squares {
        Err(NoLeastSquares::NoResponse) => text!("reason.9"),
        Err(NoLeastSquares::EveryXZero) => text!("reason.8"),
        Err(NoLeastSquares::Singular) | Ok(_) => {
            of_model(facts, "q.squares.one-abscissa", "q.squares.one-vector")
        }
    }
}

/// The half-planes whose slack at the least-squares estimate has a certain sign.
fn with_slack(facts: &Facts<'_>, is_meant: impl Fn(&Rational) -> bool) -> Vec<BoundName> {
    let Ok(estimate) = &facts.fit.least_squares else { return Vec::new() };
    let slacks = facts.inequalities().iter().map(|inequality| inequality.slack(&estimate.theta));
    let meant = slacks.enumerate().filter(|(_, slack)| is_meant(slack));
    meant.map(|(index, _)| facts.fit.fps.name(index)).collect()
}

/// A feasible estimate on the boundary of the set.
fn tight(facts: &Facts<'_>) -> Message {
    let equal = with_slack(facts, Rational::is_zero);
    let rows = facts.problem.measurements.kept();
    let every = every_bound(facts.problem);
    if rows.iter().all(|row| row.half_width().is_some_and(|width| width.is_zero())) {
        let meets = of_model(facts, "q.squares.through-line", "q.squares.through-pair");
        return meets.with("conditions", facts.problem.conditions.len());
    }
    if equal.len() == facts.inequalities().len() {
        return text!("q.squares.tight-all", bounds: every);
    }
    let names = bounds(equal.iter().copied(), facts.problem);
    text!("q.squares.tight", bounds: every, count: equal.len(), names: names)
}

fn infeasible(facts: &Facts<'_>, worst: Message, by: &Rational) -> Message {
    let names = with_slack(facts, Rational::is_negative);
    let conditions = names.iter().filter(|name| name.row().is_none()).count();
    let broken = names.len();
    let violated = text!(
        "q.squares.violates",
        broken: broken,
        total: facts.inequalities().len(),
        conditions: facts.problem.conditions.len(),
        worst: worst,
        by: value(by, DIGITS, Rounding::Up)
    );
    let why = if facts.region().is_empty() {
        of_model(facts, "q.squares.no-line", "q.squares.no-estimate")
    } else {
        text!(match conditions {
            0 => "q.squares.why-bounds",
            count if count == broken => "q.squares.why-conditions",
            _ => "q.squares.why-both",
        })
    };
    sentences([violated, why])
}

/// Is the central estimate better than least squares?
pub(super) fn central(facts: &Facts<'_>) -> Option<Question> {
    let question = text!("q.central.question");
    if facts.region().is_empty() {
        return None;
    }
    let answer = match (&facts.fit.central, facts.fit.least_squares_guaranteed_error()) {
        // No estimate at all: with a single least-squares estimate the readings alone bound the set.
        (None, _) => text!("q.central.neither", why: no_least_squares(facts)),
        (Some(_), None) => return None,
        (Some(central), Some(errors)) => compared(central, facts.fit, &errors),
    };
    Some(Question {
        id: "central-or-least-squares",
        question,
        answer,
        show: facts.fit.central.as_ref().map(|_| Show::Layer { layer: "central" }),
    })
}

fn compared(central: &Central, fit: &Fit, least_squares: &[Rational; 2]) -> Message {
    let bounded = |theta: &[Rational; 2], errors: &[Rational; 2]| {
        let [first, second] = [0, 1].map(|axis| PlusMinus::enclosing(&theta[axis], &errors[axis], DIGITS));
        text!(
            "q.central.errors",
            theta1: decimal(&first.centre),
            first: decimal(&first.error),
            theta2: decimal(&second.centre),
            second: decimal(&second.error)
        )
    };
    let Central { theta, guaranteed_error } = central;
    let of_central = match guaranteed_error.iter().all(Rational::is_zero) {
        true => text!("q.central.no-error"),
        false => bounded(theta, guaranteed_error),
    };
    let verdict = match [0, 1].map(|axis| guaranteed_error[axis] < least_squares[axis]) {
        [false, false] => return text!("q.central.same", errors: of_central),
        [true, true] => "q.central.both",
        [true, false] => "q.central.first",
        [false, true] => "q.central.second",
    };
    // Where least squares has errors, it is an estimate.
    let squares = fit.least_squares.as_ref().map_or(theta, |own| &own.theta);
    let errors = text!("q.central.guarantees", central: of_central, squares: bounded(squares, least_squares));
    sentences([text!(verdict), errors])
}
