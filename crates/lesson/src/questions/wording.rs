//! Words for half-planes, sets and numbers.

use boundfit_estimation::{BoundName, Condition, Problem};
use boundfit_exact::{PlacedDecimal, Rational, Rounding};
use boundfit_geometry::Region;

use crate::number::{DIGITS, with_minus};
use crate::texts::{Message, Value, text};

/// The longest fraction that a sentence shows.
const LONGEST_FRACTION: usize = 40;

/// The names of the parameters in sentences.
pub(super) const THETA: [&str; 2] = ["θ₁", "θ₂"];

/// A number with its exact value behind it, unless that is the decimal itself or too long to read.
pub(crate) fn value(value: &Rational, digits: usize, rounding: Rounding) -> Value {
    let fraction = value.to_string();
    let decimal = |decimal: &str| Value::number(with_minus(decimal));
    match value.exact_decimal(digits) {
        Some(exact) => decimal(&exact.to_string()),
        None if fraction.len() > LONGEST_FRACTION => decimal(&value.to_decimal(digits, rounding)),
        None => text!(
            "wording.exactly",
            decimal: decimal(&value.to_decimal(digits, rounding)),
            fraction: with_minus(&fraction)
        )
        .into(),
    }
}

/// A size, rounded.
pub(super) fn size(size: &Rational, rounding: Rounding) -> Value {
    Value::number(with_minus(&size.to_decimal(DIGITS, rounding)))
}

/// An estimate or its error bound.
pub(super) fn decimal(decimal: &PlacedDecimal) -> Value {
    Value::number(with_minus(&decimal.to_string()))
}

/// A number of a proof: exact where that can be read.
pub(super) fn fraction(value: &Rational) -> Value {
    let exact = value.to_string();
    if exact.len() <= LONGEST_FRACTION {
        with_minus(&exact).into()
    } else {
        text!("wording.about", number: size(value, Rounding::Nearest)).into()
    }
}

/// A point or direction, exact where that can be read.
pub(super) fn pair(numbers: &[Rational; 2]) -> Message {
    text!("wording.pair", first: fraction(&numbers[0]), second: fraction(&numbers[1]))
}

/// A half-plane: `the upper bound of reading 14`, `the condition theta1 >= 0`.
pub(crate) fn bound(name: BoundName, problem: &Problem) -> Message {
    let of_condition = |number: usize, written: &str, numbered: &str| match condition(number, problem) {
        Some(condition) => text!(written, condition: Value::formula(condition.text().to_string())),
        None => text!(numbered, number: number),
    };
    match name {
        BoundName::Upper(row) => text!("wording.upper", row: row),
        BoundName::Lower(row) => text!("wording.lower", row: row),
        BoundName::Where(number) => of_condition(number, "wording.condition", "wording.condition-number"),
        BoundName::WhereUpper(number) | BoundName::WhereLower(number) => {
            let side = if matches!(name, BoundName::WhereUpper(_)) { "≤" } else { "≥" };
            of_condition(number, "wording.side", "wording.side-number").with("side", side)
        }
    }
}

fn condition(number: usize, problem: &Problem) -> Option<&Condition> {
    problem.conditions.get(number.checked_sub(1)?)
}

/// Half-planes, listed.
pub(super) fn bounds(names: impl Iterator<Item = BoundName>, problem: &Problem) -> Value {
    Value::listed(names.map(|name| bound(name, problem)))
}

/// Returns the owners of half-planes: `reading 14`, `readings 14 and 36 and the condition theta1 >= 0`. Also whether
/// that is more than one thing.
pub(super) fn owners(names: impl Iterator<Item = BoundName>, problem: &Problem) -> (Value, bool) {
    let mut rows: Vec<usize> = Vec::new();
    let mut parts: Vec<Message> = Vec::new();
    for name in names {
        match name {
            BoundName::Upper(row) | BoundName::Lower(row) => {
                if !rows.contains(&row) {
                    rows.push(row);
                }
            }
            // Both sides of an equation are one thing.
            BoundName::Where(number) | BoundName::WhereUpper(number) | BoundName::WhereLower(number) => {
                let owner = bound(BoundName::Where(number), problem);
                if !parts.contains(&owner) {
                    parts.push(owner);
                }
            }
        }
    }
    let several = rows.len() + parts.len() > 1;
    if !rows.is_empty() {
        parts.insert(0, text!("wording.readings", rows: Value::listed(rows)));
    }
    (Value::listed(parts), several)
}

/// A positive combination: `500/5863 times the upper bound of reading 14 plus …`.
pub(super) fn combination(terms: &[(BoundName, Rational)], problem: &Problem) -> Value {
    let term = |(name, times): &(BoundName, Rational)| {
        let bound = bound(*name, problem);
        if *times == Rational::one() {
            bound
        } else {
            text!("wording.times", factor: fraction(times), bound: bound)
        }
    };
    Value::joined(terms.iter().map(term), "list.plus")
}

/// Returns the conflict when these half-planes leave nothing, as a clause:
/// `condition 1 (0*theta1>=1) can never hold`.
pub(super) fn clash(names: &[BoundName], problem: &Problem) -> Message {
    match names {
        [only] => text!("wording.never-holds", what: never(*only, problem)),
        _ if names.iter().all(|name| name.row().is_none()) => text!("wording.conditions-clash"),
        _ => text!("wording.clash", bounds: bounds(names.iter().copied(), problem)),
    }
}

/// A half-plane that no θ satisfies.
pub(super) fn never(name: BoundName, problem: &Problem) -> Message {
    match name.condition() {
        Some(number) => match condition(number, problem) {
            Some(condition) => {
                text!("wording.numbered-condition", number: number, condition: Value::formula(condition.text().to_string()))
            }
            None => text!("wording.condition-number", number: number),
        },
        None => bound(name, problem),
    }
}

/// `every bound`, `every bound and the condition`.
pub(super) fn every_bound(problem: &Problem) -> Message {
    text!("wording.every-bound", conditions: problem.conditions.len())
}

/// The kind of a set: `a polygon with 6 vertices`.
pub(super) fn described(region: &Region) -> Message {
    text!(&format!("set.{}", region.kind().name()), vertices: region.vertices().len())
}

/// Sentences, one after another.
pub(super) fn sentences(parts: impl IntoIterator<Item = Message>) -> Message {
    text!("wording.sentences", sentences: Value::joined(parts, "list.sentences"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::texts::{Language, say};

    #[test]
    fn numbers_say_when_they_are_rounded() {
        let said = |number: Rational| {
            say(&text!("wording.about", number: value(&number, 5, Rounding::Up)), Language::English)
        };
        assert_eq!(said(Rational::ratio(1, 4)), "about 0.25");
        assert_eq!(said(Rational::ratio(1, 3)), "about 0.33334 (exactly 1/3)");
    }
}
