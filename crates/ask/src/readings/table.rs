//! The dialect of a table, and the rows of it that are used, as people say both.

use std::iter;

use boundfit_exact::{DecimalMark, Reading, Thousands};
use boundfit_formats::{
    AskedBlock, AskedDialect, CommentMark, DELIMITERS, Encoding, Header, Missing, MissingWords, RowCondition,
    RowSet, TableOptions,
};

use super::keys::keys;
use super::limits::{AskedLimits, resolve_limits};
use super::rows::Rows;
use crate::given::Given;
use crate::misuse::Misuse;
use crate::refusal::{Refusal, ValueProblem};

keys! {
    /// The data rows that are used.
    RowWords {
        /// These rows only.
        "rows" rows: Rows,
        /// All but these rows.
        "without" without: Rows,
        /// Rows for which a comparison of a column holds, such as `temperature >= 20`.
        "where_row" where_row: Vec<Given>,
    }
}

keys! {
    /// The dialect of a table and the reading of its numbers, each in the word that every surface has for it.
    TableWords {
        /// `decimal`, numbers exactly as written, or `binary64`, the nearest double.
        "reading" reading: Option<String>,
        /// Names of columns in the first row: `yes`, `no` or `auto`.
        "header" header: Option<String>,
        /// The name of an encoding, or `auto`.
        "encoding" encoding: Option<String>,
        /// The delimiter of columns: `comma`, `semicolon`, `tab`, `space`, `pipe` or `auto`.
        "delimiter" delimiter: Option<String>,
        /// The decimal mark: `point`, `comma` or `auto`.
        "decimal" decimal: Option<String>,
        /// The character between groups of three digits.
        "thousands" thousands: Option<String>,
        /// The character that starts a line of comment, `none` or `auto`.
        "comment" comment: Option<String>,
        /// The number of lines that are passed over first.
        "skip_lines" skip_lines: u64,
        /// `true` if the row after the header has units.
        "units_row" units_row: bool,
        /// Treatment of rows that lack a number: `refuse` or `skip`.
        "missing" missing: Option<String>,
        /// Cells that say that a value is missing.
        "missing_as" missing_as: Vec<String>,
        /// The block of a file with several: its number, the comment before it, or `all`.
        "block" block: Option<String>,
        /// The sheet of a workbook.
        "sheet" sheet: Option<String>,
        /// The most that an input may ask for of something, by the names of limits: `{"digits": 20000}`.
        "limits" limits: AskedLimits,
    }
}

impl TableWords {
    /// Returns the reading of numbers: the one that is asked for, or that of doubles where the data store doubles.
    ///
    /// # Errors
    /// When there is no such reading, or the data store doubles and another one is asked for.
    pub fn reading(&self, is_stored: bool) -> Result<Reading, Refusal> {
        let names = Reading::ALL.map(|reading| (reading.name(), reading));
        let asked = named("reading", self.reading.as_deref(), &names)?;
        match (asked, is_stored) {
            (Some(Reading::Decimal), true) => {
                let expected =
                    "the data store doubles and no decimals: they are read as binary64, exactly as stored";
                Err(refused("reading", Reading::Decimal.name(), expected))
            }
            (_, true) => Ok(Reading::Binary64),
            (asked, false) => Ok(asked.unwrap_or_default()),
        }
    }

    /// Returns how such a table is read, whose numbers are read like that, and which of its rows.
    ///
    /// # Errors
    /// When a word is none, or words exclude each other.
    pub fn resolve(&self, reading: Reading, rows: &RowWords) -> Result<TableOptions, Refusal> {
        let (limits, sizes) = resolve_limits(&self.limits)?;
        let missing = Missing::ALL.map(|missing| (missing.name(), missing));
        let headers = Header::ALL.map(|header| (header.name(), header));
        let block = self.block.as_deref().map(|text| {
            let expected = "expected a number from 1, the comment before a block, or all";
            AskedBlock::parse(text).ok_or_else(|| refused("block", text, expected))
        });
        let conditions = rows.where_row.iter().map(|given| {
            let condition = RowCondition::parse(&given.text(), given.reading(reading), &limits);
            condition.map_err(|error| Refusal::Value {
                key: "where_row",
                text: given.text(),
                problem: ValueProblem::RowCondition(error),
            })
        });
        let dialect = self.dialect()?;
        let missing_as = MissingWords::new(self.missing_as.iter().cloned()).in_dialect(&dialect);
        Ok(TableOptions {
            header: named("header", self.header.as_deref(), &headers)?.unwrap_or_default(),
            sheet: self.sheet.clone(),
            dialect,
            block: block.transpose()?,
            missing: named("missing", self.missing.as_deref(), &missing)?.unwrap_or_default(),
            missing_as,
            rows: rows.set()?,
            conditions: conditions.collect::<Result<_, _>>()?,
            reading,
            limits,
            sizes,
            ..TableOptions::default()
        })
    }

    fn dialect(&self) -> Result<AskedDialect, Refusal> {
        let decimals = DecimalMark::ALL.map(|mark| (mark.name(), mark));
        let groups = Thousands::ALL.map(|mark| (mark.mark(), mark));
        let decimal = named("decimal", unless_auto(&self.decimal), &decimals)?;
        let thousands = named("thousands", self.thousands.as_deref(), &groups)?;
        if let (Some(decimal), Some(thousands)) = (decimal, thousands)
            && thousands.mark().as_bytes() == [decimal.byte()]
        {
            return Err(Refusal::Misuse(Misuse::OneMark));
        }
        let comment = self.comment.as_deref().map(|text| {
            let expected = "expected auto, none or one character such as '#', no letter, digit or blank";
            CommentMark::parse(text).ok_or_else(|| refused("comment", text, expected))
        });
        let encoding = unless_auto(&self.encoding).map(|name| {
            Encoding::named(name).ok_or_else(|| {
                let names = Encoding::ALL.map(|encoding| encoding.name().to_lowercase());
                let problem = ValueProblem::OneOf(iter::once("auto".to_owned()).chain(names).collect());
                Refusal::Value { key: "encoding", text: name.to_owned(), problem }
            })
        });
        Ok(AskedDialect {
            encoding: encoding.transpose()?,
            delimiter: named("delimiter", unless_auto(&self.delimiter), &DELIMITERS)?,
            decimal,
            thousands,
            comment: comment.transpose()?.unwrap_or_default(),
            skip_lines: self.skip_lines,
            units_row: self.units_row,
        })
    }
}

impl RowWords {
    /// The rows by number.
    fn set(&self) -> Result<RowSet, Refusal> {
        let rows = RowSet::new(&self.rows.ranges("rows")?, &self.without.ranges("without")?);
        rows.ok_or_else(|| self.without.refused("without", "no row is left"))
    }
}

/// A word that is asked for, unless it leaves the choice to the table.
fn unless_auto(asked: &Option<String>) -> Option<&str> {
    asked.as_deref().filter(|text| *text != "auto")
}

/// Returns what a key asks for by name, if it is there.
///
/// # Errors
/// When nothing has that name.
pub fn named<T: Clone>(
    key: &'static str,
    asked: Option<&str>,
    names: &[(&str, T)],
) -> Result<Option<T>, Refusal> {
    let Some(asked) = asked else { return Ok(None) };
    let found = names.iter().find(|(name, _)| *name == asked).map(|(_, own)| own.clone());
    found.map(Some).ok_or_else(|| {
        let names = names.iter().map(|(name, _)| (*name).to_owned()).collect();
        Refusal::Value { key, text: asked.to_owned(), problem: ValueProblem::OneOf(names) }
    })
}

fn refused(key: &'static str, text: &str, expected: &'static str) -> Refusal {
    Refusal::Value { key, text: text.to_owned(), problem: ValueProblem::Expected(expected) }
}
