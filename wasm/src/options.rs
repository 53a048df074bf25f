//! What is asked, as JSON says it.

use boundfit::engine::estimation::TextProblem;
use boundfit::engine::exact::{DecimalMark, Foreign, Thousands};
use boundfit::engine::formats::{CommentMark, DELIMITERS, Encoding, RowNumbers};
use boundfit::files::{
    AskedBlock, AskedDialect, ColumnSelector, EpsilonColumn, Header, Measurements, Missing, MissingWords,
    Question, RowCondition, RowRange, RowSet, TableOptions,
};
use boundfit::lesson::{LessonOptions, MOST_ROWS, MOST_ROWS_EVER};
use boundfit::report::{EndRounding, Style};
use boundfit::{Condition, Reading};
use serde::Deserialize;

use crate::refusal::{Refusal, of_bound, of_condition};

/// What a table without a name is called in messages.
const NO_FILE: &str = "standard input";

/// The keys of the object, each named as the option of `boundfit fit` or `boundfit lesson` that it is.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Options {
    /// The name of the table in reports and messages; without one it is standard input.
    pub(crate) file: Option<String>,
    x: Regressors,
    y: Option<String>,
    eps: Option<String>,
    eps_column: Option<String>,
    lower: Option<String>,
    upper: Option<String>,
    #[serde(default, rename = "where")]
    conditions: Vec<String>,
    #[serde(default)]
    through_origin: bool,
    x_origin: Option<String>,
    #[serde(default)]
    rows: Vec<Rows>,
    #[serde(default)]
    without: Vec<Rows>,
    #[serde(default)]
    where_row: Vec<String>,
    reading: Option<String>,
    header: Option<String>,
    encoding: Option<String>,
    delimiter: Option<String>,
    decimal: Option<String>,
    thousands: Option<String>,
    comment: Option<String>,
    #[serde(default)]
    skip_lines: u64,
    #[serde(default)]
    units_row: bool,
    missing: Option<String>,
    #[serde(default)]
    missing_as: Vec<String>,
    block: Option<String>,
    #[serde(default)]
    row_numbers: Vec<Rows>,
    #[serde(default)]
    pub(crate) no_eui: bool,
    format: Option<String>,
    digits: Option<u16>,
    rounding: Option<String>,
    #[serde(default)]
    exact: bool,
    title: Option<String>,
    x_unit: Option<String>,
    y_unit: Option<String>,
    max_readings: Option<u16>,
}

/// How a table is written, where nothing is asked of it yet.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct TableWords {
    file: Option<String>,
    encoding: Option<String>,
    header: Option<String>,
    delimiter: Option<String>,
    decimal: Option<String>,
    thousands: Option<String>,
    comment: Option<String>,
    #[serde(default)]
    skip_lines: u64,
    #[serde(default)]
    units_row: bool,
}

impl TableWords {
    /// Reads the object.
    ///
    /// # Errors
    /// With the key that is not known, or of another type.
    pub(crate) fn parse(json: &str) -> Result<Self, String> {
        serde_json::from_str(json).map_err(|error| format!("options: {error}"))
    }

    /// The name of the table in messages.
    pub(crate) fn file(&self) -> &str {
        self.file.as_deref().unwrap_or(NO_FILE)
    }

    /// Whether the first row names the columns, as far as that is said.
    pub(crate) fn header(&self) -> Result<Header, String> {
        header(self.header.as_deref())
    }

    /// How the table is written, as far as that is said.
    pub(crate) fn dialect(&self) -> Result<AskedDialect, String> {
        let marks = [&self.encoding, &self.delimiter, &self.decimal, &self.thousands, &self.comment];
        dialect(marks, self.skip_lines, self.units_row)
    }
}

/// The columns of one or two regressors.
#[derive(Debug, Deserialize)]
#[serde(
    untagged,
    expecting = "x: expected the name or number of a column as text, or an array of two of these"
)]
enum Regressors {
    One(String),
    Two([String; 2]),
}

/// Data rows, counted from 1.
#[derive(Debug, Deserialize)]
#[serde(
    untagged,
    expecting = "rows and without: expected rows from 1 such as 5, [14, 36] or, to the end, [10, null]"
)]
enum Rows {
    One(usize),
    Range(usize, Option<usize>),
}

/// What is written of a fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Format {
    Json,
    Text,
    Latex,
    Proof,
}

impl Options {
    /// Reads the object.
    ///
    /// # Errors
    /// With the key that is missing, not known, or of another type.
    pub(crate) fn parse(json: &str) -> Result<Self, String> {
        serde_json::from_str(json).map_err(|error| format!("options: {error}"))
    }

    /// Refuses what is about a page alone.
    ///
    /// # Errors
    /// With the key.
    pub(crate) fn refuse_words_of_page(&self) -> Result<(), String> {
        let asked = [
            ("title", self.title.is_some()),
            ("x_unit", self.x_unit.is_some()),
            ("y_unit", self.y_unit.is_some()),
            ("max_readings", self.max_readings.is_some()),
        ];
        refuse_any(&asked, "is about a lesson, and this is a report")
    }

    /// What the page says of the readings besides what follows from them.
    ///
    /// # Errors
    /// With a key that is about a report alone, or a number of readings that no page has.
    pub(crate) fn lesson(&self, measurements: &Measurements) -> Result<LessonOptions, String> {
        if self.max_readings.is_some_and(|most| !(1..=MOST_ROWS_EVER).contains(&most)) {
            return Err(format!("max_readings: expected a number from 1 to {MOST_ROWS_EVER}"));
        }
        let [x_unit, y_unit] = measurements.plane_units();
        let foreign = |text: &Option<String>| text.as_ref().map(Foreign::from);
        Ok(LessonOptions {
            file: self.file().into(),
            title: foreign(&self.title),
            x_unit: foreign(&self.x_unit).or(x_unit.cloned()),
            y_unit: foreign(&self.y_unit).or(y_unit.cloned()),
            most_rows: self.max_readings.map_or(MOST_ROWS, usize::from),
            // Of the page, not of what it shows.
            ..LessonOptions::default()
        })
    }

    /// Refuses what is about a report alone.
    ///
    /// # Errors
    /// With the key.
    pub(crate) fn refuse_words_of_report(&self) -> Result<(), String> {
        let asked = [
            ("format", self.format.is_some()),
            ("digits", self.digits.is_some()),
            ("rounding", self.rounding.is_some()),
            ("exact", self.exact),
            ("no_eui", self.no_eui),
        ];
        refuse_any(&asked, "is about a report, and this is a lesson")
    }

    /// The name of the table in messages.
    pub(crate) fn file(&self) -> &str {
        self.file.as_deref().unwrap_or(NO_FILE)
    }

    /// What is written.
    pub(crate) fn format(&self) -> Result<Format, String> {
        let names = [
            ("json", Format::Json),
            ("text", Format::Text),
            ("latex", Format::Latex),
            ("proof", Format::Proof),
        ];
        Ok(named("format", self.format.as_deref(), &names)?.unwrap_or(Format::Json))
    }

    /// How numbers of text are read.
    pub(crate) fn reading(&self) -> Result<Reading, String> {
        let names = Reading::ALL.map(|reading| (reading.name(), reading));
        Ok(named("reading", self.reading.as_deref(), &names)?.unwrap_or_default())
    }

    /// How numbers are written.
    pub(crate) fn style(&self) -> Result<Style, String> {
        if self.digits.is_some_and(|digits| !(1..=1000).contains(&digits)) {
            return Err("digits: expected a number from 1 to 1000".to_owned());
        }
        let names = EndRounding::ALL.map(|rounding| (rounding.name(), rounding));
        let ends = named("rounding", self.rounding.as_deref(), &names)?.unwrap_or_default();
        Ok(Style { digits: self.digits.map(usize::from), ends, exact: self.exact, ..Style::default() })
    }

    /// What is asked of a table whose numbers are read like that.
    pub(crate) fn question(&self, reading: Reading) -> Result<Question, Refusal> {
        let limits = TableOptions::default().limits;
        let response = self.y.as_deref().map(|own| column("y", own)).transpose()?;
        let question = match &self.x {
            Regressors::One(x) => Question::line(column("x", x)?, response),
            Regressors::Two([phi1, phi2]) => {
                Question::regressors(column("x", phi1)?, column("x", phi2)?, response)
            }
        };
        let mut question = self.bounded(question, reading)?;
        if question.columns.second.is_some() && (self.through_origin || self.x_origin.is_some()) {
            return Err("through_origin and x_origin are about a line: two regressors have no offset"
                .to_owned()
                .into());
        }
        for text in &self.conditions {
            let condition = Condition::parse(text, reading, &limits);
            question.conditions.push(condition.map_err(|error| {
                let (named, place, words) =
                    (of_condition(&error.kind), error.position + 1, error.kind.to_string());
                Refusal::of_text("where", text, named, Some(place), error, words)
            })?);
        }
        question.columns.form.through_origin = self.through_origin;
        if let Some(text) = &self.x_origin {
            let origin = reading.read(text, &limits);
            question.columns.form.x_origin = origin.map_err(|error| refused("x_origin", text, error))?;
        }
        Ok(question)
    }

    /// The question with the bounds on the errors, of which there are to be those of one kind.
    fn bounded(&self, question: Question, reading: Reading) -> Result<Question, Refusal> {
        let bound = |key: &str, own: &Option<String>| own.as_deref().map(|own| column(key, own)).transpose();
        let [lower, upper] = [bound("lower", &self.lower)?, bound("upper", &self.upper)?];
        let is_interval = lower.is_some() || upper.is_some();
        if self.y.is_none() && !is_interval {
            return Err("y is missing: only beside lower or upper it may be left out".to_owned().into());
        }
        match (&self.eps, bound("eps_column", &self.eps_column)?, is_interval) {
            (Some(eps), None, false) => {
                let question = question.within(eps, reading).map_err(|error| {
                    let (named, words) = (of_bound(&error.kind), error.kind.to_string());
                    let place = error.kind.has_place().then_some(error.position + 1);
                    Refusal::of_text("eps", eps, named, place, error, words)
                })?;
                match &question.columns.epsilon {
                    EpsilonColumn::Law(law) if question.columns.second.is_some() && law.needs_x() => {
                        let problem =
                            "two regressors have no |x| (expected a law of |y|, range(y) and written)";
                        let named = ("bound-x", None);
                        Err(Refusal::of_text("eps", eps, named, None, problem, problem.to_owned()))
                    }
                    _ => Ok(question),
                }
            }
            (None, Some(column), false) => Ok(question.within_columns(EpsilonColumn::Column(column))),
            (None, None, true) => Ok(question.within_columns(EpsilonColumn::Interval { lower, upper })),
            (None, None, false) => {
                Err("the bound on the errors is missing: eps, eps_column, lower or upper".to_owned().into())
            }
            _ => Err("the errors have one bound: eps, or eps_column, or lower and upper".to_owned().into()),
        }
    }

    /// How the table is read.
    pub(crate) fn table(&self, reading: Reading) -> Result<TableOptions, String> {
        let table = TableOptions::default();
        let conditions = self.where_row.iter().map(|text| {
            let condition = RowCondition::parse(text, reading, &table.limits);
            condition.map_err(|error| refused("where_row", text, error))
        });
        let missing = Missing::ALL.map(|missing| (missing.name(), missing));
        let marks = [&self.encoding, &self.delimiter, &self.decimal, &self.thousands, &self.comment];
        let rows = match self.numbering()? {
            Some(numbering) => numbering.positions(&self.row_set()?),
            None => Some(self.row_set()?),
        };
        let block = self.block.as_deref().map(|text| {
            AskedBlock::parse(text).ok_or_else(|| {
                refused("block", text, "expected a number from 1, a comment before a block, or all")
            })
        });
        Ok(TableOptions {
            block: block.transpose()?,
            missing_as: MissingWords::new(self.missing_as.iter().cloned()),
            header: header(self.header.as_deref())?,
            dialect: dialect(marks, self.skip_lines, self.units_row)?,
            missing: named("missing", self.missing.as_deref(), &missing)?.unwrap_or_default(),
            rows: rows.ok_or("rows: none of them is left")?,
            conditions: conditions.collect::<Result<_, _>>()?,
            reading,
            ..table
        })
    }

    /// The rows that are asked for, by their numbers.
    pub(crate) fn row_set(&self) -> Result<RowSet, String> {
        let rows = RowSet::new(&ranges("rows", &self.rows)?, &ranges("without", &self.without)?);
        rows.ok_or_else(|| "without: no row is left".to_owned())
    }

    /// The numbers of the rows of the table, where they are not 1, 2, 3 and so on.
    ///
    /// # Errors
    /// When they do not ascend.
    pub(crate) fn numbering(&self) -> Result<Option<Numbering>, String> {
        if self.row_numbers.is_empty() {
            return Ok(None);
        }
        let expected = || {
            "row_numbers: expected rows from 1, ascending, such as 5 and [14, 36]: the number of each row of the table"
                .to_owned()
        };
        let ends = self.row_numbers.iter().map(|own| match *own {
            Rows::One(row) => Some([row, row]),
            Rows::Range(first, last) => Some([first, last?]),
        });
        let ends: Vec<[usize; 2]> = ends.collect::<Option<_>>().ok_or_else(expected)?;
        Numbering::new(&ends).map(Some).ok_or_else(expected)
    }
}

fn header(asked: Option<&str>) -> Result<Header, String> {
    let headers = Header::ALL.map(|header| (header.name(), header));
    Ok(named("header", asked, &headers)?.unwrap_or_default())
}

/// How a text is written: its encoding, the marks that separate columns, come before decimals, group digits and start comments, as far as they are said.
fn dialect(marks: [&Option<String>; 5], skip_lines: u64, units_row: bool) -> Result<AskedDialect, String> {
    let [encoding, delimiter, decimal, thousands, comment] = marks;
    let decimals = DecimalMark::ALL.map(|mark| (mark.name(), mark));
    let groups = Thousands::ALL.map(|mark| (mark.mark(), mark));
    // Of both what is left to the table has a name on the command line.
    let asked = |text: &Option<String>| text.clone().filter(|text| text != "auto");
    let decimal = named("decimal", asked(decimal).as_deref(), &decimals)?;
    let thousands = named("thousands", thousands.as_deref(), &groups)?;
    if let (Some(decimal), Some(thousands)) = (decimal, thousands)
        && thousands.mark().as_bytes() == [decimal.byte()]
    {
        return Err(
            "decimal and thousands name one mark: it cannot both group digits and come before decimals"
                .to_owned(),
        );
    }
    let comment = comment.as_deref().map(|text| {
        CommentMark::parse(text)
            .ok_or_else(|| refused("comment", text, "expected auto, none or one character such as #"))
    });
    let encoding = asked(encoding).map(|name| {
        let expected = || refused("encoding", &name, format!("expected one of {}", Encoding::names()));
        Encoding::named(&name).ok_or_else(expected)
    });
    Ok(AskedDialect {
        encoding: encoding.transpose()?,
        delimiter: named("delimiter", asked(delimiter).as_deref(), &DELIMITERS)?,
        decimal,
        thousands,
        comment: comment.transpose()?.unwrap_or_default(),
        skip_lines,
        units_row,
    })
}

fn refuse_any(asked: &[(&str, bool)], why: &str) -> Result<(), String> {
    match asked.iter().find(|(_, is_asked)| *is_asked) {
        Some((key, _)) => Err(format!("{key} {why}")),
        None => Ok(()),
    }
}

/// The numbers of the rows of a table.
pub(crate) struct Numbering {
    pub(crate) numbers: RowNumbers,
    /// First and last number, and how many come before.
    runs: Vec<([usize; 2], usize)>,
}

impl Numbering {
    /// `None` unless they ascend from 1.
    fn new(ends: &[[usize; 2]]) -> Option<Self> {
        let (mut runs, mut before, mut last) = (Vec::new(), 0_usize, 0_usize);
        for &[first, end] in ends {
            if first <= last || end < first || end == usize::MAX {
                return None;
            }
            runs.push(([first, end], before));
            before += end - first + 1;
            last = end;
        }
        let numbers = ends.iter().map(|&[first, last]| first..last + 1).collect();
        Some(Numbering { numbers, runs })
    }

    /// How many numbers there are up to this one.
    fn up_to(&self, number: usize) -> usize {
        let run = self.runs.partition_point(|([first, _], _)| *first <= number).checked_sub(1);
        run.map_or(0, |run| {
            let ([first, last], before) = self.runs[run];
            before + number.min(last) - first + 1
        })
    }

    /// The rows with these numbers, by their places in the table; `None` if there is none.
    fn positions(&self, asked: &RowSet) -> Option<RowSet> {
        let places = |ranges: &[RowRange]| -> Vec<RowRange> {
            let place = |range: &RowRange| {
                let (first, last) = range.ends();
                let after = last.map_or(self.numbers.len(), |last| self.up_to(last));
                RowRange::new(self.up_to(first - 1) + 1, after)
            };
            ranges.iter().filter_map(place).collect()
        };
        let named = places(asked.named());
        if named.is_empty() && !asked.named().is_empty() {
            return None;
        }
        RowSet::new(&named, &places(asked.without()))
    }
}

/// What a key asks for by name, if it is there.
fn named<T: Clone>(key: &str, asked: Option<&str>, names: &[(&str, T)]) -> Result<Option<T>, String> {
    let Some(asked) = asked else { return Ok(None) };
    let found = names.iter().find(|(name, _)| *name == asked).map(|(_, own)| own.clone());
    let expected = || names.iter().map(|(name, _)| format!("{name:?}")).collect::<Vec<_>>().join(", ");
    found.map(Some).ok_or_else(|| refused(key, asked, format_args!("expected one of {}", expected())))
}

fn column(key: &str, text: &str) -> Result<ColumnSelector, String> {
    match text.trim() {
        "" => Err(refused(key, text, "expected a header name or a column number")),
        text => Ok(ColumnSelector::name_or_number(text)),
    }
}

fn ranges(key: &str, asked: &[Rows]) -> Result<Vec<RowRange>, String> {
    let range = |own: &Rows| match *own {
        Rows::One(row) => RowRange::new(row, row),
        Rows::Range(first, Some(last)) => RowRange::new(first, last),
        Rows::Range(first, None) => RowRange::from_row(first),
    };
    let ranges: Option<Vec<RowRange>> = asked.iter().map(range).collect();
    ranges.ok_or_else(|| format!("{key}: rows are counted from 1, and the first comes before the last"))
}

fn refused(key: &str, text: &str, problem: impl std::fmt::Display) -> String {
    format!("{key}: {text:?}: {problem}")
}
