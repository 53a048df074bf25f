//! The rows of a file that were asked for, in words.

use std::fmt;

use boundfit_exact::Foreign;

/// The rows of a file that were asked for; by default all rows.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Selection {
    /// The selected row numbers: ranges such as `1..22,24..50`; `None` for all.
    pub rows: Option<String>,
    /// The numbers of the excluded rows.
    pub without: Option<String>,
    /// The conditions that a selected row satisfies.
    pub conditions: Vec<Foreign>,
}

impl Selection {
    /// Returns whether all rows were asked for.
    pub fn is_all(&self) -> bool {
        *self == Selection::default()
    }
}

/// A column in which cells are fractions such as `3/4`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FractionCells {
    /// The name of the column.
    pub column: Foreign,
    /// The number of cells.
    pub cells: usize,
    /// The first of them.
    pub first: Foreign,
}

/// Writes the selection for use within a sentence: `rows 1..22,24..50, without 31, where temperature >= 20`.
impl fmt::Display for Selection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Selection { rows, without, conditions } = self;
        let is_one = rows.as_ref().is_some_and(|rows| rows.parse::<usize>().is_ok());
        f.write_str(if is_one { "row" } else { "rows" })?;
        rows.iter().try_for_each(|rows| write!(f, " {rows}"))?;
        without.iter().try_for_each(|without| write!(f, " without {without}"))?;
        if !conditions.is_empty() {
            let conditions: Vec<String> = conditions.iter().map(Foreign::to_string).collect();
            write!(f, " where {}", conditions.join(" and "))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_row_is_a_row() {
        let text = |rows: &str| Selection { rows: Some(rows.to_owned()), ..Selection::default() }.to_string();
        assert_eq!(["7", "7..8", "7,9", "7.."].map(text), ["row 7", "rows 7..8", "rows 7,9", "rows 7.."]);
        let conditions = vec!["t >= 20".to_owned().into()];
        let conditional = Selection { without: Some("31".to_owned()), conditions, ..Selection::default() };
        assert_eq!(conditional.to_string(), "rows without 31 where t >= 20");
    }
}
