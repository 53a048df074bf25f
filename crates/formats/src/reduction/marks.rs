//! The marks and words that were stated for the cells of a reduced table.

use boundfit_exact::{DecimalMark, Foreign, Thousands};
use serde::{Deserialize, Serialize};

use super::error::ReductionError;
use crate::dialect::{AskedDialect, MissingWords};
use crate::table::TableOptions;

/// The marks in numbers and the words for missing values that were stated where a table was reduced. The kept rows stand as
/// in the table, so that they mean the same under these alone.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(try_from = "Written", into = "Written")]
pub struct ReducedMarks {
    decimal: Option<DecimalMark>,
    thousands: Option<Thousands>,
    /// The words for missing values in alphabetical order, each once.
    missing: Vec<String>,
}

/// The marks as the line in front has them.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Written {
    #[serde(default, skip_serializing_if = "Option::is_none")]
    decimal: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    thousands: Option<String>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    missing: Vec<String>,
}

impl ReducedMarks {
    /// The marks stated for a table. Words for missing values matter only where cells may lack a number.
    pub fn of(table: &TableOptions, may_lack: bool) -> Self {
        let AskedDialect { decimal, thousands, .. } = table.dialect;
        let mut missing: Vec<String> =
            table.missing_as.texts().iter().filter(|_| may_lack).cloned().collect();
        missing.sort_unstable();
        missing.dedup();
        ReducedMarks { decimal, thousands, missing }
    }

    pub(super) fn is_empty(&self) -> bool {
        *self == ReducedMarks::default()
    }

    /// Reads rows by these marks and words, and by those that are stated beside them.
    ///
    /// # Errors
    /// When a mark that is stated differs.
    pub(super) fn apply(&self, table: &mut TableOptions) -> Result<(), ReductionError> {
        let ReducedMarks { decimal, thousands, missing } = self;
        let own = AskedDialect { decimal: *decimal, thousands: *thousands, ..AskedDialect::default() };
        let differ = |what, has: &str, asked: &str| {
            let (has, asked) = (Foreign::of(has).quoted(), Foreign::of(asked).quoted());
            Err(ReductionError::NotAsked { what, has, asked })
        };
        if let (Some(has), Some(asked)) = (own.given_mark(), table.dialect.given_mark())
            && has != asked
        {
            return differ("the decimal mark of the reduction is", has.name(), asked.name());
        }
        if let (Some(has), Some(asked)) = (thousands, table.dialect.thousands)
            && *has != asked
        {
            return differ("the mark between digits in the reduction is", has.mark(), asked.mark());
        }
        table.dialect.decimal = decimal.or(table.dialect.decimal);
        table.dialect.thousands = thousands.or(table.dialect.thousands);
        let words = missing.iter().chain(table.missing_as.texts()).cloned();
        table.missing_as = MissingWords::new(words).in_dialect(&table.dialect);
        Ok(())
    }
}

impl TryFrom<Written> for ReducedMarks {
    type Error = &'static str;

    fn try_from(written: Written) -> Result<Self, Self::Error> {
        let named = |name: String| DecimalMark::ALL.into_iter().find(|mark| mark.name() == name);
        let between = |mark: String| Thousands::ALL.into_iter().find(|own| own.mark() == mark);
        let decimal = written.decimal.map(|name| named(name).ok_or("an unknown decimal mark")).transpose()?;
        let thousands = written
            .thousands
            .map(|mark| between(mark).ok_or("an unknown mark between digits"))
            .transpose()?;
        let own = AskedDialect { thousands, ..AskedDialect::default() };
        if decimal.zip(own.given_mark()).is_some_and(|(decimal, other)| decimal != other) {
            return Err("one mark for decimals and between digits");
        }
        Ok(ReducedMarks { decimal, thousands, missing: written.missing })
    }
}

impl From<ReducedMarks> for Written {
    fn from(own: ReducedMarks) -> Self {
        Written {
            decimal: own.decimal.map(|mark| mark.name().to_owned()),
            thousands: own.thousands.map(|mark| mark.mark().to_owned()),
            missing: own.missing,
        }
    }
}
