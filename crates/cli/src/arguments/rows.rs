//! The data rows that are used.

use boundfit_exact::{Limit, Limits, Reading};
use boundfit_formats::{ParseRowConditionError, RowCondition, RowRange, RowSet};
use clap::Args;

use crate::exit::{Failure, raises};

/// Which data rows are used.
#[derive(Debug, Clone, Args)]
pub(crate) struct RowArguments {
    /// Use only these data rows, counted from 1 without the header: 14..36, 5, ..10, 10.. or a list such as
    /// 1..22,24..50
    #[arg(long, value_name = "ROWS", value_parser = parse_rows)]
    rows: Option<AskedRows>,
    /// Skip these data rows, such as 23,31 or 40..
    #[arg(long, value_name = "ROWS", value_parser = parse_rows)]
    without: Option<AskedRows>,
    /// Use only rows where a number in a column compares so (< <= = != >= >), such as 'temperature >= 20'. The column
    /// is a name, quoted or not, or a number; if repeated, all comparisons must hold
    #[arg(long, value_name = "COMPARISON", allow_hyphen_values = true)]
    where_row: Vec<String>,
}

/// Ranges of rows with the words they were asked for in.
#[derive(Debug, Clone)]
struct AskedRows {
    text: String,
    ranges: Vec<RowRange>,
}

impl RowArguments {
    /// The rows by number.
    pub(super) fn set(&self) -> Result<RowSet, Failure> {
        let ranges =
            |asked: &Option<AskedRows>| asked.as_ref().map_or_else(Vec::new, |asked| asked.ranges.clone());
        RowSet::new(&ranges(&self.rows), &ranges(&self.without)).ok_or_else(|| {
            let without = self.without.as_ref().map_or("", |asked| &asked.text);
            Failure::value("--without <ROWS>", without, "no row is left")
        })
    }

    /// Returns whether some rows are included or excluded by number.
    pub(super) fn are_asked(&self) -> bool {
        self.rows.is_some() || self.without.is_some()
    }

    /// Returns whether rows are chosen by their cells.
    pub(super) fn depend_on_cells(&self) -> bool {
        !self.where_row.is_empty()
    }

    /// Returns the conditions on each row.
    pub(super) fn conditions(&self, reading: Reading, limits: &Limits) -> Result<Vec<RowCondition>, Failure> {
        let condition = |text: &String| {
            RowCondition::parse(text, reading, limits)
                .map_err(|error| Failure::value("--where-row <COMPARISON>", text, problem(&error)))
        };
        self.where_row.iter().map(condition).collect()
    }
}

fn problem(error: &ParseRowConditionError) -> String {
    let limit = match error {
        ParseRowConditionError::NotANumber { error, .. } => Limit::of_number(&error.kind),
        _ => None,
    };
    match limit {
        Some(limit) => format!("{error}; {}", raises(limit)),
        None => format!(
            "{error} (expected a column, one of < <= = != >= >, and a number, such as 'temperature >= 20')"
        ),
    }
}

fn parse_rows(text: &str) -> Result<AskedRows, String> {
    const EXPECTED: &str =
        "expected rows from 1 such as 14..36, 5, ..10, 10.. or a list of these, 1..22,24..50";
    let ranges = text.split(',').map(|range| parse_range(range.trim())).collect::<Option<Vec<_>>>();
    ranges.map(|ranges| AskedRows { text: text.to_owned(), ranges }).ok_or_else(|| EXPECTED.to_owned())
}

fn parse_range(text: &str) -> Option<RowRange> {
    // A row number too large to be counted is beyond the end of any file.
    let number = |text: &str| {
        let digits = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
        digits.then(|| text.parse().unwrap_or(usize::MAX))
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
            let asked = parse_rows(text).ok()?;
            Some(asked.ranges.iter().map(RowRange::to_string).collect::<Vec<_>>().join(","))
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
}
