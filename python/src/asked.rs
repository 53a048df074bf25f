//! What is asked, as Python hands it over.

use boundfit::ask::{AskedXBounds, Misuse, Refusal, XErrors};
use boundfit::engine::exact::{DecimalMark, Limit, Thousands};
use boundfit::files::{
    AskedBlock, AskedDialect, ColumnSelector, CommentMark, Encoding, EpsilonColumn, Header, InputError,
    Limits, MemoryBudget, Missing, MissingWords, Question, RowCondition, RowRange, RowSet, ScanOptions,
    Setting, SizeLimits, TableOptions, Way,
};
use boundfit::questions::Agreement;
use boundfit::{Condition, Reading};
use pyo3::prelude::*;

use crate::numbers::{Given, refuse};

/// The arguments that all calls about readings have in common.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Asked {
    /// How many of the columns are regressors: one or two.
    regressors: usize,
    /// Whether the next one is y.
    response: bool,
    /// The bound on all errors in words; otherwise columns follow.
    eps: Option<Given>,
    /// Whether a column of bounds on the errors follows.
    eps_column: bool,
    /// Whether a column of lower bounds follows.
    lower: bool,
    /// Whether a column of upper bounds follows.
    upper: bool,
    conditions: Vec<String>,
    through_origin: bool,
    x_origin: Option<Given>,
    reading: String,
    missing: String,
    /// The bound on the errors of x, the same for all readings.
    x_eps: Option<Given>,
    /// Whether a column of bounds on the errors of x follows.
    x_eps_column: bool,
    /// Whether a line has to agree for every x that they allow.
    strong: bool,
}

/// How a file is read.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct AskedTable {
    rows: Vec<(usize, Option<usize>)>,
    without: Vec<(usize, Option<usize>)>,
    where_row: Vec<String>,
    header: Option<bool>,
    encoding: Option<String>,
    delimiter: Option<u8>,
    sheet: Option<String>,
    skip_lines: u64,
    units_row: bool,
    decimal: Option<String>,
    thousands: Option<String>,
    comment: Option<String>,
    missing_as: Vec<String>,
    block: Option<String>,
    limits: Vec<(String, u64)>,
}

impl Asked {
    /// What floats mean: how numbers are read, where nothing else is stored.
    pub(crate) fn reading(&self) -> PyResult<Reading> {
        match self.reading.as_str() {
            "decimal" => Ok(Reading::Decimal),
            "binary64" => Ok(Reading::Binary64),
            other => Err(refuse(format_args!("reading={other:?}: expected \"decimal\" or \"binary64\""))),
        }
    }

    /// The question about columns with these names, in the order of their roles, and what is said of errors in x. In its numbers
    /// a float means what `reading` says, a text what `texts` says, and everything else is exact.
    pub(crate) fn question(
        &self,
        names: &[String],
        selector: impl Fn(&str) -> ColumnSelector,
        [reading, texts]: [Reading; 2],
        limits: &Limits,
    ) -> PyResult<(Question, Option<XErrors>)> {
        let mut names = names.iter();
        let mut next = || selector(names.next().map_or("", String::as_str));
        let first = next();
        let second = (self.regressors == 2).then(&mut next);
        let response = self.response.then(&mut next);
        let epsilon = if self.eps_column {
            EpsilonColumn::Column(next())
        } else {
            EpsilonColumn::Interval { lower: self.lower.then(&mut next), upper: self.upper.then(&mut next) }
        };
        let x_column = self.x_eps_column.then(&mut next);
        let is_line = second.is_none();
        let question = match second {
            None => Question::line(first, response),
            Some(second) => Question::regressors(first, second, response),
        };
        let mut question = match &self.eps {
            None => question.within_columns(epsilon),
            Some(eps) => {
                let text = eps.text(reading);
                let question = question.within(&text, eps.read_by(texts));
                question.map_err(|error| refuse(format_args!("eps={:?}: {error}", eps.shown)))?
            }
        };
        if let EpsilonColumn::Law(law) = &question.columns.epsilon
            && !is_line
            && law.needs_x()
        {
            return Err(refuse(
                "eps: two regressors have no |x| (expected a law of |y|, range(y) and written)",
            ));
        }
        if !is_line && (self.through_origin || self.x_origin.is_some()) {
            return Err(refuse(
                "through_origin and x_origin are about a line: two regressors have no constant",
            ));
        }
        for text in &self.conditions {
            let condition = Condition::parse(text, texts, limits);
            question
                .conditions
                .push(condition.map_err(|error| refuse(format_args!("where={text:?}: {error}")))?);
        }
        question.columns.form.through_origin = self.through_origin;
        if let Some(origin) = &self.x_origin {
            question.columns.form.x_origin = origin.number_by(reading, texts, "x_origin")?;
        }
        let x_errors = self.x_errors(x_column, [reading, texts])?;
        Ok((question, x_errors))
    }

    fn x_errors(
        &self,
        column: Option<ColumnSelector>,
        [reading, texts]: [Reading; 2],
    ) -> PyResult<Option<XErrors>> {
        let bounds = match (&self.x_eps, column) {
            (None, None) if self.strong => {
                return Err(refuse(crate::questions::in_words(&Refusal::Misuse(Misuse::StrongAlone))));
            }
            (None, None) => return Ok(None),
            (_, Some(column)) => AskedXBounds::Column(column.non_negative()),
            (Some(bound), None) => {
                let number = bound.number_by(reading, texts, "x_eps")?;
                if number.is_negative() {
                    return Err(refuse(format_args!(
                        "x_eps={:?}: negative (expected a number that is at least 0)",
                        bound.shown
                    )));
                }
                AskedXBounds::Uniform(number)
            }
        };
        let agreement = if self.strong { Agreement::Strong } else { Agreement::Weak };
        Ok(Some(XErrors { bounds, agreement }))
    }

    /// How a table in memory is read, whose numbers are read like that.
    pub(crate) fn options(&self, reading: Reading) -> PyResult<ScanOptions> {
        let missing = match self.missing.as_str() {
            "refuse" => Missing::Refuse,
            "skip" => Missing::Skip,
            other => return Err(refuse(format_args!("missing={other:?}: expected \"refuse\" or \"skip\""))),
        };
        let table = TableOptions { reading, missing, ..TableOptions::default() };
        Ok(ScanOptions { table, hash: false, list_rows: false, ..ScanOptions::default() })
    }

    /// How a file is read; with its hash and the rows that are fitted, which proofs are about.
    pub(crate) fn file_options(&self, asked: &AskedTable, reading: Reading) -> PyResult<ScanOptions> {
        let ScanOptions { table, .. } = self.options(reading)?;
        let table = TableOptions { limits: asked.number_limits(), sizes: asked.size_limits()?, ..table };
        let conditions = asked.where_row.iter().map(|text| {
            let condition = RowCondition::parse(text, reading, &table.limits);
            condition.map_err(|error| refuse(format_args!("where_row={text:?}: {error}")))
        });
        let header = match asked.header {
            None => Header::Auto,
            Some(true) => Header::Present,
            Some(false) => Header::Absent,
        };
        let block = asked.block.as_deref().map(|text| {
            AskedBlock::parse(text).ok_or_else(|| {
                refuse(format_args!(
                    "block={text:?}: expected a number from 1, a comment before a block, or \"all\""
                ))
            })
        });
        let rows = RowSet::new(&ranges(&asked.rows)?, &ranges(&asked.without)?);
        let table = TableOptions {
            header,
            sheet: asked.sheet.clone(),
            block: block.transpose()?,
            missing_as: MissingWords::new(asked.missing_as.iter().cloned()),
            dialect: asked.dialect()?,
            rows: rows.ok_or_else(|| refuse("without: no row is left"))?,
            conditions: conditions.collect::<PyResult<_>>()?,
            ..table
        };
        Ok(ScanOptions { table, ..ScanOptions::default() })
    }
}

impl AskedTable {
    fn dialect(&self) -> PyResult<AskedDialect> {
        let decimal = match self.decimal.as_deref() {
            None => None,
            Some("point") => Some(DecimalMark::Point),
            Some("comma") => Some(DecimalMark::Comma),
            Some(other) => {
                return Err(refuse(format_args!("decimal={other:?}: expected \"point\" or \"comma\"")));
            }
        };
        let thousands = self.thousands.as_deref().map(|text| {
            let mark = Thousands::ALL.into_iter().find(|own| own.mark() == text);
            mark.ok_or_else(|| {
                refuse(format_args!("thousands={text:?}: expected \",\", \".\", \" \" or \"'\""))
            })
        });
        let thousands = thousands.transpose()?;
        if let (Some(decimal), Some(thousands)) = (decimal, thousands)
            && thousands.mark().as_bytes() == [decimal.byte()]
        {
            return Err(refuse(
                "decimal and thousands name one mark, which cannot both group digits and come before decimals",
            ));
        }
        let comment = match self.comment.as_deref() {
            None => CommentMark::Auto,
            Some("none") => CommentMark::None,
            Some(text) => match text.as_bytes() {
                [mark] if mark.is_ascii_punctuation() => CommentMark::Mark(*mark),
                _ => {
                    return Err(refuse(format_args!(
                        "comment={text:?}: expected \"none\", or one character such as \"#\""
                    )));
                }
            },
        };
        let encoding = self.encoding.as_deref().map(|name| {
            Encoding::named(name).ok_or_else(|| {
                refuse(format_args!("encoding={name:?}: expected one of {}", Encoding::names()))
            })
        });
        let (skip_lines, units_row) = (self.skip_lines, self.units_row);
        Ok(AskedDialect {
            encoding: encoding.transpose()?,
            delimiter: self.delimiter,
            decimal,
            thousands,
            comment,
            skip_lines,
            units_row,
        })
    }

    /// What one number may ask for.
    pub(crate) fn number_limits(&self) -> Limits {
        let mut own = Limits::default();
        for (name, most) in &self.limits {
            match name.as_str() {
                "digits" => own.digits = size(*most).min(1_000_000),
                "exponent" => own.exponent = u32::try_from(*most).unwrap_or(u32::MAX).min(1_000_000),
                _ => {}
            }
        }
        own
    }

    /// What a file may ask for.
    fn size_limits(&self) -> PyResult<SizeLimits> {
        let mut own = SizeLimits::default();
        for (name, most) in &self.limits {
            match name.as_str() {
                "digits" | "exponent" => {}
                "line" => own.line = size(*most),
                "columns" => own.columns = size(*most),
                "rows" => own.rows = size(*most),
                "elements" => own.elements = size(*most),
                "unpacked" => own.unpacked = *most,
                "ratio" => own.ratio = *most,
                "workbook" => own.workbook = *most,
                "work" => own.work = *most,
                "memory" => own.memory = MemoryBudget::new(*most),
                other => {
                    return Err(refuse(format_args!(
                        "limits: {other:?}: expected digits, exponent, line, columns, rows, elements, unpacked, ratio, workbook, work \
                         or memory"
                    )));
                }
            }
        }
        Ok(own)
    }
}

/// A size that no memory of this machine holds is as good as the largest one.
fn size(asked: u64) -> usize {
    usize::try_from(asked).unwrap_or(usize::MAX)
}

/// What is wrong with a table, in the words of this package.
pub(crate) fn in_words(error: &InputError) -> String {
    // Columns in memory have this name, and no header.
    let text = error
        .to_string()
        .replace("readings: the file has a header but no data rows", "readings: the columns are empty");
    let ways: Vec<String> = error.kind.ways().iter().map(as_argument).collect();
    if ways.is_empty() { text } else { format!("{text}; {}", ways.join(", ")) }
}

/// A way out as this package has it: `decimal="comma" reads 1,5`.
pub(crate) fn as_argument(way: &Way) -> String {
    let Way { setting, value, effect } = way;
    match setting {
        // It has an argument of its own.
        Setting::Limit(Limit::Steps) => format!("max_steps=... {effect}"),
        Setting::Limit(limit) => format!("limits={{\"{}\": ...}} {effect}", limit.name()),
        setting => {
            let value = match *value {
                "" => "True".to_owned(),
                number @ "N" => number.to_owned(),
                text => format!("\"{}\"", text.trim_matches('\'')),
            };
            format!("{}={value} {effect}", setting.name().replace(' ', "_"))
        }
    }
}

fn ranges(asked: &[(usize, Option<usize>)]) -> PyResult<Vec<RowRange>> {
    let range = |&(first, last): &(usize, Option<usize>)| match last {
        Some(last) => RowRange::new(first, last),
        None => RowRange::from_row(first),
    };
    let ranges: Option<Vec<RowRange>> = asked.iter().map(range).collect();
    ranges.ok_or_else(|| refuse("rows are counted from 1, and the first comes before the last"))
}
