//! Which rows of a file were asked for, in words.

use std::fmt;

#[cfg(feature = "files")]
use boundfit_formats::{Fractions, RowCondition, RowRange, TableOptions};

/// Which rows of a file were asked for; by default all of them.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Selection {
    /// By number: ranges such as `1..22,24..50`; `None` for all.
    pub rows: Option<String>,
    /// Those left out, by number.
    pub without: Option<String>,
    /// What must hold for a row to be taken.
    pub conditions: Vec<String>,
}

impl Selection {
    /// Whether all rows were asked for.
    pub fn is_all(&self) -> bool {
        *self == Selection::default()
    }

    #[cfg(feature = "files")]
    pub(crate) fn of(options: &TableOptions) -> Self {
        let ranges = |ranges: &[RowRange]| {
            let ranges: Vec<String> = ranges.iter().map(RowRange::to_string).collect();
            (!ranges.is_empty()).then(|| ranges.join(","))
        };
        Selection {
            rows: ranges(options.rows.named()),
            without: ranges(options.rows.without()),
            conditions: options.conditions.iter().map(RowCondition::text).map(ToOwned::to_owned).collect(),
        }
    }
}

/// A column in which cells are fractions such as `3/4`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FractionCells {
    /// Its name.
    pub column: String,
    /// How many cells.
    pub cells: usize,
    /// The first of them.
    pub first: String,
}

#[cfg(feature = "files")]
impl FractionCells {
    /// Of columns with these names; of those that are read in several ways only once.
    pub(crate) fn of(names: &[String], fractions: &[Fractions]) -> Vec<Self> {
        let mut found: Vec<FractionCells> = Vec::new();
        for (column, Fractions { cells, first }) in names.iter().zip(fractions) {
            if let Some(first) = first
                && !found.iter().any(|other| other.column == *column)
            {
                found.push(FractionCells { column: column.clone(), cells: *cells, first: first.clone() });
            }
        }
        found
    }
}

/// Within a sentence: `rows 1..22,24..50, without 31, where temperature >= 20`.
impl fmt::Display for Selection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Selection { rows, without, conditions } = self;
        f.write_str("rows")?;
        rows.iter().try_for_each(|rows| write!(f, " {rows}"))?;
        without.iter().try_for_each(|without| write!(f, " without {without}"))?;
        if !conditions.is_empty() {
            write!(f, " where {}", conditions.join(" and "))?;
        }
        Ok(())
    }
}
