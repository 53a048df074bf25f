//! Formulas of several reports: pairs, sums, and combinations of half-planes.

use boundfit_estimation::Measurements;
use boundfit_exact::{Integer, Rational};
use boundfit_geometry::Direction;

use crate::document::{Inline, Operator, Symbol, THETA, Text};
use crate::style::Style;

/// Two numbers in brackets.
pub(crate) fn pair(first: impl ToString, second: impl ToString) -> Text {
    Text::new().mark("(").number(first).mark(", ").number(second).mark(")")
}

/// The error of a reading, by a name that no column of the model has.
pub(crate) fn error(measurements: &Measurements) -> Text {
    match measurements.error_name() {
        "e" => Symbol::Error.into(),
        name => Text::new().given(name),
    }
}

/// `|e| <= `.
pub(crate) fn bounded_error(measurements: &Measurements) -> Text {
    Text::new().mark("|").then(error(measurements)).mark("|").operator(Operator::AtMost)
}

/// `2 * (14 upper) + 1/2 * (36 lower)`: multiples of named half-planes.
pub(crate) fn products(terms: impl IntoIterator<Item = (Text, String)>) -> Text {
    let product =
        |(multiplier, name): (Text, String)| multiplier.operator(Operator::Times).words(format!("({name})"));
    Text::joined(terms.into_iter().map(product), &Inline::Operator(Operator::Plus))
}

/// The contradiction that a sum of half-planes of an empty set states.
pub(crate) fn absurdity(products: Text, sum: &Rational, style: &Style) -> Text {
    let zero = Text::from(" gives ").number(Integer::zero());
    products.then(zero).operator(Operator::AtMost).number(style.upper(sum))
}

/// A sum of terms: what each is multiplied by, how its size is shown, and what it is a multiple of, if anything.
/// Terms that are zero are omitted.
pub(crate) fn sum_text(terms: impl IntoIterator<Item = (Rational, Text, Option<Text>)>) -> Text {
    let mut sum = Text::new();
    for (value, size, factor) in terms.into_iter().filter(|(value, ..)| !value.is_zero()) {
        sum = match (sum.is_empty(), value.is_negative()) {
            (true, false) => sum,
            (true, true) => sum.mark("-"),
            (false, false) => sum.operator(Operator::Plus),
            (false, true) => sum.operator(Operator::Minus),
        };
        sum = match factor {
            None => sum.then(size),
            // 1*s is s.
            Some(factor) if value.abs() == Rational::one() => sum.then(factor),
            Some(factor) => sum.then(size).operator(Operator::Dot).then(factor),
        };
    }
    if sum.is_empty() { Text::new().number(0) } else { sum }
}

/// `a1*theta1 + a2*theta2` for the normal of a half-plane.
pub(crate) fn form_text(normal: &Direction) -> Text {
    let coefficients = [normal.dx(), normal.dy()].map(Rational::from);
    let terms = coefficients.into_iter().zip(THETA);
    sum_text(terms.map(|(value, theta): (Rational, Symbol)| {
        let size = Text::new().number(value.abs());
        (value, size, Some(theta.into()))
    }))
}
