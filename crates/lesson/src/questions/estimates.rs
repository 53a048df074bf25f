//! The least-squares and the central estimate.

use boundfit_estimation::BoundName;
use boundfit_exact::english::in_words;
use boundfit_exact::{Rational, Rounding};

use super::wording::{THETA, all_bounds, bound, bounds, every_bound, size, value};
use super::{Facts, Question, Show};
use crate::number::DIGITS;

/// Is the least-squares line feasible?
pub(super) fn least_squares(facts: &Facts<'_>) -> Question {
    let noun = if facts.is_line() { "line" } else { "estimate" };
    let question = format!("Is the least-squares {noun} feasible?");
    let (answer, show) = match facts.fit.least_squares_slack() {
        None => {
            let why = no_least_squares(facts);
            (format!("There is no single least-squares estimate to ask about: {why}."), None)
        }
        Some((slack, name)) => {
            let tightest = bound(name, facts.problem);
            let answer = if slack.is_negative() {
                infeasible(facts, noun, &tightest, &slack.abs())
            } else if slack.is_zero() {
                tight(facts)
            } else {
                let spare = value(&slack, DIGITS, Rounding::Down);
                format!(
                    "Yes. It satisfies {}; the tightest is {tightest}, with {spare} to spare.",
                    every_bound(facts.problem)
                )
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
    why.to_owned()
}

/// The half-planes whose slack at the least-squares estimate has a certain sign.
fn with_slack(facts: &Facts<'_>, is_meant: impl Fn(&Rational) -> bool) -> Vec<BoundName> {
    let Ok(estimate) = &facts.fit.least_squares else { return Vec::new() };
    let slacks = facts.inequalities().iter().map(|inequality| inequality.slack(&estimate.theta));
    let meant = slacks.enumerate().filter(|(_, slack)| is_meant(slack));
    meant.map(|(index, _)| facts.fit.fps.name(index)).collect()
}

/// A feasible estimate on the boundary of the set.
fn tight(facts: &Facts<'_>) -> String {
    let equal = with_slack(facts, Rational::is_zero);
    let rows = facts.problem.measurements.kept();
    let conditions = match facts.problem.conditions.len() {
        0 => "",
        1 => ", and it satisfies the condition",
        _ => ", and it satisfies the conditions",
    };
    if rows.iter().all(|row| row.half_width().is_some_and(|width| width.is_zero())) {
        let meets = if facts.is_line() { "passes exactly through" } else { "reproduces exactly" };
        return format!(
            "Yes. It {meets} every reading, so that it meets every error bound of 0 with equality{conditions}."
        );
    }
    if equal.len() == facts.inequalities().len() {
        return format!(
            "Yes, but with nothing to spare: it meets {} with equality.",
            every_bound(facts.problem)
        );
    }
    format!(
        "Yes, but with nothing to spare: it satisfies {}, {} of them with equality: {}.",
        every_bound(facts.problem),
        in_words(equal.len()),
        bounds(equal.iter().copied(), facts.problem)
    )
}

fn infeasible(facts: &Facts<'_>, noun: &str, worst: &str, by: &Rational) -> String {
    let names = with_slack(facts, Rational::is_negative);
    let conditions = names.iter().filter(|name| name.row().is_none()).count();
    let broken = names.len();
    let total = facts.inequalities().len();
    let what = all_bounds(facts.problem);
    let by = value(by, DIGITS, Rounding::Up);
    let what = if broken == 1 {
        format!("It violates one of the {} {what}: {worst}, by {by}.", in_words(total))
    } else {
        let (broken, total) = (in_words(broken), in_words(total));
        format!("It violates {broken} of the {total} {what}, most of all {worst}, by {by}.")
    };
    let why = if facts.region().is_empty() {
        format!("No other {noun} keeps all of them either: the feasible parameter set is empty.")
    } else {
        let does_not = match conditions {
            0 => "that does not keep every single error within its bound",
            count if count == broken => "it takes no notice of conditions",
            _ => "that neither keeps every single error within its bound nor takes notice of conditions",
        };
        format!("Least squares makes the sum of the squared errors as small as possible; {does_not}.")
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
        // No estimate at all: with a single least-squares estimate the readings alone bound the set.
        (None, _) => format!(
            "Neither: there is no central estimate, because the PUI box is unbounded and has no mid-point, and no \
             single least-squares estimate, because {}. No estimate can guarantee an error for both parameters here: \
             the true ones may be arbitrarily far from it.",
            no_least_squares(facts)
        ),
        (Some(_), None) => return None,
        (Some(central), Some(least_squares)) => compared(&central.guaranteed_error, &least_squares),
    };
    Some(Question {
        id: "central-or-least-squares",
        question,
        answer,
        show: facts.fit.central.as_ref().map(|_| Show::Layer { layer: "central" }),
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
    let errors_of_central = if central.iter().all(Rational::is_zero) {
        "no error at all (the set is a single point)".to_owned()
    } else {
        pair(central)
    };
    let verdict = match [0, 1].map(|axis| central[axis] < least_squares[axis]) {
        [false, false] => {
            return format!(
                "Both guarantee the same here: {errors_of_central}. No estimate guarantees less than the central one, \
                 the mid-point of the PUI box."
            );
        }
        [true, true] => "The central estimate, for both parameters",
        [true, false] => "The central estimate for θ₁, while both guarantee the same for θ₂",
        [false, true] => "The central estimate for θ₂, while both guarantee the same for θ₁",
    };
    format!(
        "{verdict}. The central estimate guarantees {errors_of_central}, least squares {}. The central estimate is the \
         mid-point of the PUI box, and no other estimate guarantees less.",
        pair(least_squares)
    )
}
