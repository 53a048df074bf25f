//! What is asked, as Python hands it over.

use boundfit::files::{
    AskedDialect, ColumnSelector, EpsilonColumn, Header, InputError, Keep, MemoryTable, Missing, Question,
    RowCondition, RowRange, RowSet, ScanOptions, SizeLimits, Source, TableOptions,
};
use boundfit::{Condition, Problem, Reading};
use pyo3::prelude::*;

use crate::numbers::refuse;

/// The arguments that all calls about readings have in common.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Asked {
    /// How many of the columns are regressors: one or two.
    regressors: usize,
    /// Whether the next one is y.
    response: bool,
    /// The bound on all errors in words; otherwise columns follow.
    eps: Option<String>,
    /// Whether a column of bounds on the errors follows.
    eps_column: bool,
    /// Whether a column of lower bounds follows.
    lower: bool,
    /// Whether a column of upper bounds follows.
    upper: bool,
    conditions: Vec<String>,
    through_origin: bool,
    x_origin: Option<String>,
    pub(crate) reading: String,
    missing: String,
    eui: bool,
}

/// How a file is read.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct AskedTable {
    rows: Vec<(usize, Option<usize>)>,
    without: Vec<(usize, Option<usize>)>,
    where_row: Vec<String>,
    header: Option<bool>,
    delimiter: Option<u8>,
    sheet: Option<String>,
    skip_lines: u64,
    units_row: bool,
}

impl Asked {
    /// How numbers are read.
    pub(crate) fn reading(&self) -> PyResult<Reading> {
        match self.reading.as_str() {
            "decimal" => Ok(Reading::Decimal),
            "binary64" => Ok(Reading::Binary64),
            other => Err(refuse(format_args!("reading={other:?}: expected \"decimal\" or \"binary64\""))),
        }
    }

    /// The question about columns with these names, in the order of their roles.
    pub(crate) fn question(
        &self,
        names: &[String],
        selector: impl Fn(&str) -> ColumnSelector,
    ) -> PyResult<Question> {
        let reading = self.reading()?;
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
        let is_line = second.is_none();
        let question = match second {
            None => Question::line(first, response),
            Some(second) => Question::regressors(first, second, response),
        };
        let mut question = match &self.eps {
            None => question.within_columns(epsilon),
            Some(eps) => {
                question.within(eps, reading).map_err(|error| refuse(format_args!("eps={eps:?}: {error}")))?
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
        let limits = TableOptions::default().limits;
        for text in &self.conditions {
            let condition = Condition::parse(text, reading, &limits);
            question
                .conditions
                .push(condition.map_err(|error| refuse(format_args!("where={text:?}: {error}")))?);
        }
        question.columns.form.through_origin = self.through_origin;
        if let Some(origin) = &self.x_origin {
            let origin =
                reading.read(origin, &limits).map_err(|error| refuse(format_args!("x_origin: {error}")));
            question.columns.form.x_origin = origin?;
        }
        Ok(question)
    }

    /// How a table in memory is read.
    pub(crate) fn options(&self) -> PyResult<ScanOptions> {
        let missing = match self.missing.as_str() {
            "refuse" => Missing::Refuse,
            "skip" => Missing::Skip,
            other => return Err(refuse(format_args!("missing={other:?}: expected \"refuse\" or \"skip\""))),
        };
        let table = TableOptions { reading: self.reading()?, missing, ..TableOptions::default() };
        Ok(ScanOptions { table, hash: false, list_rows: false, ..ScanOptions::default() })
    }

    /// How a file is read; with its hash and the rows that are fitted, which proofs are about.
    pub(crate) fn file_options(&self, asked: &AskedTable, reading: Reading) -> PyResult<ScanOptions> {
        let ScanOptions { table, .. } = self.options()?;
        let conditions = asked.where_row.iter().map(|text| {
            let condition = RowCondition::parse(text, reading, &table.limits);
            condition.map_err(|error| refuse(format_args!("where_row={text:?}: {error}")))
        });
        let header = match asked.header {
            None => Header::Auto,
            Some(true) => Header::Present,
            Some(false) => Header::Absent,
        };
        let rows = RowSet::new(&ranges(&asked.rows)?, &ranges(&asked.without)?);
        let table = TableOptions {
            header,
            sheet: asked.sheet.clone(),
            dialect: AskedDialect {
                delimiter: asked.delimiter,
                skip_lines: asked.skip_lines,
                units_row: asked.units_row,
                ..AskedDialect::default()
            },
            rows: rows.ok_or_else(|| refuse("without: no row is left"))?,
            conditions: conditions.collect::<PyResult<_>>()?,
            reading,
            ..table
        };
        Ok(ScanOptions { table, ..ScanOptions::default() })
    }

    /// What is kept of many readings.
    pub(crate) fn keep(&self) -> Keep {
        Keep { eui: self.eui, ..Keep::default() }
    }
}

/// The problem of a table in memory.
pub(crate) fn problem_of_table(
    question: &Question,
    table: MemoryTable,
    options: &ScanOptions,
    keep: Keep,
) -> Result<Problem, String> {
    let problem = question.problem(Source::of_table("readings", table), options, keep);
    short(problem.map_err(|error| in_words(&error))?)
}

/// A problem whose numbers are not too long for a fit.
pub(crate) fn short(problem: Problem) -> Result<Problem, String> {
    let work = problem.work(&[]).check(4, SizeLimits::default().work);
    work.map_err(|error| error.to_string())?;
    Ok(problem)
}

/// What is wrong with a table, in the words of this package.
pub(crate) fn in_words(error: &InputError) -> String {
    // What the program calls an option is an argument here.
    error.to_string().replace("--missing skip", "missing=\"skip\"")
}

fn ranges(asked: &[(usize, Option<usize>)]) -> PyResult<Vec<RowRange>> {
    let range = |&(first, last): &(usize, Option<usize>)| match last {
        Some(last) => RowRange::new(first, last),
        None => RowRange::from_row(first),
    };
    let ranges: Option<Vec<RowRange>> = asked.iter().map(range).collect();
    ranges.ok_or_else(|| refuse("rows are counted from 1, and the first comes before the last"))
}
