//! Data rows as people say them.

use boundfit_formats::RowRange;
use serde::Deserialize;

use crate::refusal::{Refusal, ValueProblem};

/// Data rows, counted from 1 without the header: `[5, [14, 36], [40, null]]` or `"5,14..36,40.."` is 5, 14 to 36, and 40 to the end.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(
    untagged,
    expecting = "expected rows from 1 such as 5, [14, 36] or, to the end, [10, null], or a text such as \"1..22,24..\""
)]
pub enum Rows {
    /// `14..36`, `5`, `..10`, `10..` or a list such as `1..22,24..50`.
    Text(String),
    /// Rows and ranges.
    List(Vec<OfRows>),
}

/// One row, or some that follow each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged, expecting = "expected a row from 1, or a first and a last one")]
pub enum OfRows {
    /// This row.
    One(usize),
    /// Rows from one to another, or to the end.
    Range(usize, Option<usize>),
}

impl Default for Rows {
    fn default() -> Self {
        Rows::List(Vec::new())
    }
}

impl Rows {
    /// Returns whether nothing is said.
    pub fn are_all(&self) -> bool {
        *self == Rows::default()
    }

    /// The ranges, none where nothing is said.
    pub(super) fn ranges(&self, key: &'static str) -> Result<Vec<RowRange>, Refusal> {
        let (ranges, expected): (Option<Vec<RowRange>>, _) = match self {
            Rows::Text(text) => (
                text.split(',').map(|range| parse(range.trim())).collect(),
                "expected rows from 1 such as 14..36, 5, ..10, 10.. or a list of these, 1..22,24..50",
            ),
            Rows::List(list) => (
                list.iter().map(|own| own.range()).collect(),
                "rows are counted from 1, and the first comes before the last",
            ),
        };
        ranges.ok_or_else(|| match self {
            Rows::Text(text) if has_uncounted(text) => {
                let problem = ValueProblem::Other(format!(
                    "a row that cannot be counted (expected rows up to {})",
                    usize::MAX
                ));
                Refusal::Value { key, text: text.clone(), problem }
            }
            _ => self.refused(key, expected),
        })
    }

    pub(super) fn refused(&self, key: &'static str, problem: &'static str) -> Refusal {
        Refusal::Value { key, text: self.text(), problem: ValueProblem::Expected(problem) }
    }

    /// Returns the rows as they were said, a list in the words of a text.
    fn text(&self) -> String {
        let list = match self {
            Rows::Text(text) => return text.clone(),
            Rows::List(list) => list.iter(),
        };
        let shown = list.map(|own| match *own {
            OfRows::One(row) => row.to_string(),
            OfRows::Range(first, Some(last)) => format!("{first}..{last}"),
            OfRows::Range(first, None) => format!("{first}.."),
        });
        shown.collect::<Vec<_>>().join(",")
    }
}

impl OfRows {
    fn range(self) -> Option<RowRange> {
        match self {
            OfRows::One(row) => RowRange::new(row, row),
            OfRows::Range(first, Some(last)) => RowRange::new(first, last),
            OfRows::Range(first, None) => RowRange::from_row(first),
        }
    }
}

/// Returns whether a number in a text is too large to be counted.
fn has_uncounted(text: &str) -> bool {
    let mut numbers =
        text.split(|character: char| !character.is_ascii_digit()).filter(|digits| !digits.is_empty());
    numbers.any(|digits| digits.parse::<usize>().is_err())
}

fn parse(text: &str) -> Option<RowRange> {
    let number = |text: &str| {
        let digits = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
        digits.then(|| text.parse().ok()).flatten()
    };
    let Some((first, last)) = text.split_once("..") else {
        let row = number(text)?;
        return RowRange::new(row, row);
    };
    match (first.trim(), last.trim()) {
        ("", last) => RowRange::new(1, number(last)?),
        (first, "") => RowRange::from_row(number(first)?),
        (first, last) => RowRange::new(number(first)?, number(last)?),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_ranges_and_lists_of_these() {
        let shown = |text: &str| {
            let ranges = Rows::Text(text.to_owned()).ranges("rows").ok()?;
            Some(ranges.iter().map(RowRange::to_string).collect::<Vec<_>>().join(","))
        };
        for (text, ranges) in [
            ("14..36", "14..36"),
            ("5", "5"),
            (" ..10", "1..10"),
            ("10 ..", "10.."),
            ("1..22, 24..50 ,7", "1..22,24..50,7"),
            ("3..3", "3"),
        ] {
            assert_eq!(shown(text).as_deref(), Some(ranges), "{text}");
        }
        for text in ["", "..", "0", "0..3", "3..2", "1,", "a", "1...3", "1-3", "+1", "-1", "1..2..3", "1;2"] {
            assert_eq!(shown(text), None, "{text}");
        }
    }

    #[test]
    fn a_list_says_what_a_text_does() {
        let list: Rows = serde_json::from_str("[5, [14, 36], [40, null]]").unwrap();
        let text = Rows::Text("5,14..36,40..".to_owned());
        assert_eq!(list.ranges("rows").unwrap(), text.ranges("rows").unwrap());
        assert_eq!(list.text(), text.text());
        for json in ["[0]", "[[3, 2]]", "[[0, null]]"] {
            assert!(serde_json::from_str::<Rows>(json).unwrap().ranges("rows").is_err(), "{json}");
        }
        assert!(serde_json::from_str::<Rows>("[\"1..2\"]").is_err());
    }
}
