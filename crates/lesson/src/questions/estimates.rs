//! The least-squares and the central estimate.

use boundfit_exact::{Rational, Rounding};
use boundfit_geometry::Inequality;

use super::wording::{THETA, bound, in_words, size, value};
use super::{Facts, Question, Show};
use crate::number::DIGITS;

/// Is the least-squares line feasible?
pub(super) fn least_squares(facts: &Facts<'_>) -> Question {
    let noun = if facts.is_line() { "line" } else { "estimate" };
    let question = format!("Is the least-squares {noun} feasible?");
    let (answer, show) = match facts.fit.least_squares_slack() {
        None => (no_least_squares(facts), None),
        Some((slack, name)) => {
            let tightest = bound(name, facts.problem);
            let answer = if slack.is_negative() {
                infeasible(facts, noun, &tightest, &slack.abs())
            } else if slack.is_zero() {
                format!("Yes, but only just: it satisfies every bound, and {tightest} with nothing to spare.")
            } else {
                let spare = value(&slack, DIGITS, Rounding::Down);
                format!("Yes. It satisfies every bound; the tightest is {tightest}, with {spare} to spare.")
            };
            (answer, Some(Show::Layer { layer: "least-squares" }))
        }
    };
    Question { id: "least-squares-feasible", question, answer, show }
}

fn no_least_squares(facts: &Facts<'_>) -> String {
    let why = if facts.is_line() {
        "there are fewer than two distinct abscissas, so that many lines have the same smallest sum of squared \
         errors"
    } else {
        "the regressors of all readings are multiples of one vector, so that many parameters have the same smallest \
         sum of squared errors"
    };
    format!("There is no single least-squares estimate to ask about: {why}.")
}

fn infeasible(facts: &Facts<'_>, noun: &str, worst: &str, by: &Rational) -> String {
    let theta = facts.fit.least_squares.as_ref().map(|estimate| &estimate.theta);
    let is_broken = |inequality: &&Inequality| theta.is_ok_and(|theta| inequality.slack(theta).is_negative());
    let broken = facts.inequalities().iter().filter(is_broken).count();
    let total = facts.inequalities().len();
    let by = value(by, DIGITS, Rounding::Up);
    let what = if broken == 1 {
        format!("It violates one of the {} bounds: {worst}, by {by}.", in_words(total))
    } else {
        let (broken, total) = (in_words(broken), in_words(total));
        format!("It violates {broken} of the {total} bounds, most of all {worst}, by {by}.")
    };
    let why = if facts.region().is_empty() {
        format!("No other {noun} keeps all of them either: the feasible parameter set is empty.")
    } else {
        "Least squares makes the sum of the squared errors as small as possible; that does not keep every single error \
         within its bound."
            .to_owned()
    };
    format!("No. {what} {why}")
}

/// Is the central estimate better than least squares?
pub(super) fn central(facts: &Facts<'_>) -> Option<Question> {
    let question =
        "Which estimate guarantees the smaller error, the central one or least squares?".to_owned();
    if facts.region().is_empty() {
        return None;
    }
    let answer = match (&facts.fit.central, facts.fit.least_squares_guaranteed_error()) {
        (None, _) => "Neither guarantees one for both parameters: the feasible parameter set is unbounded, so the true \
                      parameters may be arbitrarily far from any estimate."
            .to_owned(),
        (Some(_), None) => return None,
        (Some(central), Some(least_squares)) => compared(&central.guaranteed_error, &least_squares),
    };
    Some(Question {
        id: "central-or-least-squares",
        question,
        answer,
        show: Some(Show::Layer { layer: "central" }),
    })
}

fn compared(central: &[Rational; 2], least_squares: &[Rational; 2]) -> String {
    let pair = |errors: &[Rational; 2]| {
        format!(
            "±{} for {} and ±{} for {}",
            size(&errors[0], Rounding::Up),
            THETA[0],
            size(&errors[1], Rounding::Up),
            THETA[1]
        )
    };
    let verdict = match [0, 1].map(|axis| central[axis] < least_squares[axis]) {
        [false, false] => "Here both guarantee the same",
        [true, true] => "The central estimate, for both parameters",
        [true, false] => "The central estimate, for θ₁; for θ₂ both guarantee the same",
        [false, true] => "The central estimate, for θ₂; for θ₁ both guarantee the same",
    };
    let central = if central.iter().all(Rational::is_zero) {
        "no error at all (the set is a single point)".to_owned()
    } else {
        pair(central)
    };
    format!(
        "{verdict}: the central estimate guarantees {central}, least squares {}. The central estimate is the \
         mid-point of the PUI box, and no other estimate guarantees less.",
        pair(least_squares)
    )
}
