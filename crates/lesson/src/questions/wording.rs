//! Plain English for half-planes, sets and numbers.

use boundfit_estimation::{BoundName, Condition, Problem};
use boundfit_exact::english::{counted_in_words, listed};
use boundfit_exact::{Rational, Rounding};
use boundfit_geometry::{Region, RegionKind};

use crate::number::{DIGITS, with_minus};

/// The longest fraction that a sentence shows.
const LONGEST_FRACTION: usize = 40;

/// The names of the parameters in sentences.
pub(super) const THETA: [&str; 2] = ["θ₁", "θ₂"];

/// A number with its exact value behind it, unless that is the decimal itself or too long to read.
pub(super) fn value(value: &Rational, digits: usize, rounding: Rounding) -> String {
    let fraction = value.to_string();
    with_minus(&match value.exact_decimal(digits) {
        Some(decimal) => decimal.to_string(),
        None if fraction.len() > LONGEST_FRACTION => value.to_decimal(digits, rounding),
        None => format!("{} (exactly {fraction})", value.to_decimal(digits, rounding)),
    })
}

/// A size, rounded.
pub(super) fn size(size: &Rational, rounding: Rounding) -> String {
    with_minus(&size.to_decimal(DIGITS, rounding))
}

/// A number of a proof: exact where that can be read.
pub(super) fn fraction(value: &Rational) -> String {
    let exact = value.to_string();
    if exact.len() <= LONGEST_FRACTION {
        with_minus(&exact)
    } else {
        format!("about {}", size(value, Rounding::Nearest))
    }
}

/// A point or direction, exact where that can be read.
pub(super) fn pair(numbers: &[Rational; 2]) -> String {
    format!("({}, {})", fraction(&numbers[0]), fraction(&numbers[1]))
}

/// A half-plane: `the upper bound of reading 14`, `the condition theta1 >= 0`.
pub(super) fn bound(name: BoundName, problem: &Problem) -> String {
    match name {
        BoundName::Upper(row) => format!("the upper bound of reading {row}"),
        BoundName::Lower(row) => format!("the lower bound of reading {row}"),
        BoundName::Where(number) => match condition(number, problem) {
            Some(condition) => format!("the condition {}", condition.text()),
            None => format!("condition {number}"),
        },
        BoundName::WhereUpper(number) | BoundName::WhereLower(number) => {
            let side = if matches!(name, BoundName::WhereUpper(_)) { "≤" } else { "≥" };
            match condition(number, problem) {
                Some(condition) => format!("the side {side} of the condition {}", condition.text()),
                None => format!("the side {side} of condition {number}"),
            }
        }
    }
}

fn condition(number: usize, problem: &Problem) -> Option<&Condition> {
    problem.conditions.get(number.checked_sub(1)?)
}

/// Half-planes, listed.
pub(super) fn bounds(names: impl Iterator<Item = BoundName>, problem: &Problem) -> String {
    listed(&names.map(|name| bound(name, problem)).collect::<Vec<_>>())
}

/// What half-planes belong to: `reading 14`, `readings 14 and 36 and the condition theta1 >= 0`. Also whether that is
/// more than one thing.
pub(super) fn owners(names: impl Iterator<Item = BoundName>, problem: &Problem) -> (String, bool) {
    let mut rows: Vec<String> = Vec::new();
    let mut parts: Vec<String> = Vec::new();
    for name in names {
        match name {
            BoundName::Upper(row) | BoundName::Lower(row) => {
                if !rows.contains(&row.to_string()) {
                    rows.push(row.to_string());
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
        let noun = if rows.len() == 1 { "reading" } else { "readings" };
        parts.insert(0, format!("{noun} {}", listed(&rows)));
    }
    (listed(&parts), several)
}

/// A positive combination: `500/5863 times the upper bound of reading 14 plus …`.
pub(super) fn combination(terms: &[(BoundName, Rational)], problem: &Problem) -> String {
    let term = |(name, times): &(BoundName, Rational)| {
        let bound = bound(*name, problem);
        if *times == Rational::one() { bound } else { format!("{} times {bound}", fraction(times)) }
    };
    terms.iter().map(term).collect::<Vec<_>>().join(" plus ")
}

/// What contradicts itself when these half-planes leave nothing, as a clause: `condition 1 (0*theta1>=1) can never hold`.
pub(super) fn clash(names: &[BoundName], problem: &Problem) -> String {
    match names {
        [only] => format!("{} can never hold", never(*only, problem)),
        _ if names.iter().all(|name| name.row().is_none()) => {
            "the conditions contradict each other".to_owned()
        }
        _ => format!("{} contradict each other", bounds(names.iter().copied(), problem)),
    }
}

/// A half-plane that no θ satisfies.
pub(super) fn never(name: BoundName, problem: &Problem) -> String {
    match name.condition() {
        Some(number) => match condition(number, problem) {
            Some(condition) => format!("condition {number} ({})", condition.text()),
            None => format!("condition {number}"),
        },
        None => bound(name, problem),
    }
}

/// `bounds`, `bounds and conditions`: what the half-planes of a problem are.
pub(super) fn all_bounds(problem: &Problem) -> &'static str {
    if problem.conditions.is_empty() { "bounds" } else { "bounds and conditions" }
}

/// `every bound`, `every bound and the condition`.
pub(super) fn every_bound(problem: &Problem) -> &'static str {
    match problem.conditions.len() {
        0 => "every bound",
        1 => "every bound and the condition",
        _ => "every bound and every condition",
    }
}

/// What a set is: `a polygon with 6 vertices`.
pub(super) fn described(region: &Region) -> String {
    let vertices = counted_in_words(region.vertices().len(), "vertex", "vertices");
    match region.kind() {
        RegionKind::Empty => "empty".to_owned(),
        RegionKind::Point => "a single point".to_owned(),
        RegionKind::Segment => "a segment".to_owned(),
        RegionKind::Ray => "a ray".to_owned(),
        RegionKind::Line => "a whole line".to_owned(),
        RegionKind::Polygon => format!("a polygon with {vertices}"),
        RegionKind::UnboundedPolygon => format!("an unbounded polygon with {vertices}"),
        RegionKind::Strip => "a strip between two parallel lines".to_owned(),
        RegionKind::HalfPlane => "a half-plane".to_owned(),
        RegionKind::Plane => "the whole plane".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_say_when_they_are_rounded() {
        assert_eq!(value(&Rational::ratio(1, 4), 5, Rounding::Up), "0.25");
        assert_eq!(value(&Rational::ratio(1, 3), 5, Rounding::Up), "0.33334 (exactly 1/3)");
    }
}
