//! The words that a text of an answer may be, for schemas.

use boundfit_geometry::RegionKind;

/// The reading of numbers.
pub(crate) const READINGS: [&str; 2] = ["decimal", "binary64"];

/// The side of a set with errors in x.
pub(crate) const SIDES: [&str; 3] = ["+", "-", "both"];

/// The ends of an interval.
pub(crate) const ENDS: [&str; 2] = ["lower", "upper"];

/// The verdicts on a claimed end.
pub(crate) const VERDICTS: [&str; 9] = [
    "exact",
    "rounded",
    "within tolerance",
    "no answer",
    "loose",
    "infeasible point",
    "unsafe",
    "wrong status",
    "inverted interval",
];

/// The verdicts on a part of a solution.
pub(crate) const WORTHS: [&str; 5] = ["exact", "rounded", "within tolerance", "no answer", "refuted"];

/// The kinds of sets.
pub(crate) fn kinds() -> [&'static str; 10] {
    RegionKind::ALL.map(RegionKind::name)
}

/// These words, or null.
pub(crate) fn or_null(words: &[&'static str]) -> Vec<Option<&'static str>> {
    words.iter().copied().map(Some).chain([None]).collect()
}
