//! Which rows of a file were asked for, in words.

use std::fmt;

#[cfg(feature = "files")]
use boundfit_formats::{RowCondition, RowRange, TableOptions};

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
