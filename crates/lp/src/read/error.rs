//! The errors of a file of a linear program, with their places.

use std::fmt;

use boundfit_exact::{Foreign, Limit, ParseNumberError};
use thiserror::Error;

use crate::format::ExchangeFormat;

/// A place in a file, with what stands there.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ModelPlace {
    /// The line, from 1.
    pub line: u64,
    /// The character of the line, from 1.
    pub column: usize,
    /// The text found there.
    pub text: Foreign,
}

/// A file that states no linear program, or none that is read.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{}{kind}{}", At(.place.as_deref()), Expected(.kind))]
pub struct ModelError {
    /// The place; `None` if the file as a whole is meant.
    pub place: Option<Box<ModelPlace>>,
    /// The problem.
    #[source]
    pub kind: ModelErrorKind,
}

impl ModelError {
    /// The error for a file in which something is wrong as a whole.
    pub(super) fn of_file(kind: ModelErrorKind) -> Self {
        ModelError { place: None, kind }
    }

    /// The line; 0 for the file as a whole.
    pub(super) fn line(&self) -> u64 {
        self.place.as_ref().map_or(0, |place| place.line)
    }

    /// The limit that was passed, if that is the problem.
    pub fn limit(&self) -> Option<Limit> {
        self.kind.limit()
    }
}

/// The kinds of errors of a file of a linear program.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ModelErrorKind {
    /// Nothing but white space and comments.
    #[error("there is nothing in the file")]
    Empty(ExchangeFormat),
    /// Two bytes per character.
    #[error("the text is UTF-16")]
    Utf16,
    /// Bytes that are not UTF-8.
    #[error("no valid UTF-8 behind this")]
    NotUtf8,
    /// A character that no text contains.
    #[error("the control character {0:?}")]
    ControlCharacter(char),
    /// A line without end.
    #[error("the line is longer than {limit} bytes (the limit)")]
    LineTooLong {
        /// The longest line that is read.
        limit: usize,
    },
    /// Too many rows.
    #[error("there are more than {limit} rows (the limit)")]
    TooManyRows {
        /// The most that are read.
        limit: usize,
    },
    /// Too many columns.
    #[error("there are more than {limit} columns (the limit)")]
    TooManyColumns {
        /// The most that are read.
        limit: usize,
    },
    /// Too many coefficients.
    #[error("there are more than {limit} coefficients (the limit)")]
    TooManyEntries {
        /// The most that are read.
        limit: usize,
    },
    /// A text that is no number, or one beyond a limit.
    #[error("{verdict}: {0}", verdict = if .0.kind.is_limit() { "refused" } else { "not a number" })]
    NotANumber(ParseNumberError),
    /// An infinite bound on the wrong side.
    #[error("an infinite {0} bound leaves no value")]
    Impossible(&'static str),
    /// A part that linear programs do not have.
    #[error("this is more than a linear program")]
    NotLinear,
    /// A column that may have whole values only.
    #[error("the column is integer")]
    Integer,
    /// A column that may be 0 or between bounds.
    #[error("the column is semi-continuous")]
    SemiContinuous,
    /// A line of MPS that begins in the first column with something else than a section.
    #[error("this begins no section of MPS")]
    UnknownSection,
    /// A section for the second time.
    #[error("the section began on line {first} already")]
    SectionTwice {
        /// The first line.
        first: u64,
    },
    /// A section that has to come later.
    #[error("the section {0} has to come before this one")]
    SectionEarly(&'static str),
    /// A section without what it is for.
    #[error("the section {0} has no line of data")]
    EmptySection(&'static str),
    /// Text behind the name of a section.
    #[error("there is more on the line than the name of a section")]
    SectionWithData,
    /// Data before the first section, or in `NAME`.
    #[error("a line of data where a section begins")]
    OutsideSection,
    /// A line with more, fewer or other pieces than its section has.
    #[error("this is no line of {section}")]
    Record {
        /// The section.
        section: &'static str,
        /// The expected record.
        expected: &'static str,
    },
    /// A line out of the columns of fixed MPS, in a file with blanks in its names.
    #[error("this is not in the columns of fixed MPS, as the names with blanks before it are")]
    FixedColumns,
    /// A type of row that is none.
    #[error("not a type of row")]
    RowType,
    /// A type of bound that is none.
    #[error("not a type of bound")]
    BoundType,
    /// A sense of the objective that is none.
    #[error("not a sense")]
    Sense,
    /// A comment that asks for a maximum in a file that is minimized without `OBJSENSE`.
    #[error("only a comment asks for the maximum, and MPS without OBJSENSE means the minimum")]
    SenseInComment,
    /// An objective that is not a row of type N.
    #[error("the row is not of type N, so it is no objective")]
    NotAnObjective,
    /// A name that begins a comment elsewhere.
    #[error("a name that begins with $")]
    Dollar,
    /// A row for the second time.
    #[error("the row is on line {first} already")]
    RowTwice {
        /// The first line.
        first: u64,
    },
    /// A column that comes again after others.
    #[error("other columns stand between this and line {last}, where the column was before")]
    ColumnAgain {
        /// The last line on which it was.
        last: u64,
    },
    /// A row that is none.
    #[error("there is no such row{}", did_you_mean(.meant.as_ref()))]
    UnknownRow {
        /// The one that may be meant.
        meant: Option<Foreign>,
    },
    /// A column that is none.
    #[error("there is no such column{}", did_you_mean(.meant.as_ref()))]
    UnknownColumn {
        /// The one that may be meant.
        meant: Option<Foreign>,
    },
    /// A coefficient for the second time.
    #[error("the column has a coefficient in this row on line {first} already")]
    EntryTwice {
        /// The first line.
        first: u64,
    },
    /// A right-hand side or a range for the second time.
    #[error("the row has a {what} on line {first} already")]
    SideTwice {
        /// `right-hand side` or `range`.
        what: &'static str,
        /// The first line.
        first: u64,
    },
    /// A bound without its number.
    #[error("the bound is missing")]
    NoBound,
    /// A bound for the second time.
    #[error("the column has its {side} bound on line {first} already")]
    BoundTwice {
        /// `lower` or `upper`.
        side: &'static str,
        /// The first line.
        first: u64,
    },
    /// A range of a row that has no finite side.
    #[error("the row has no finite right-hand side from which the range extends")]
    RangeOfNothing,
    /// A range of a row of type N.
    #[error("the row is of type N and has no range")]
    RangeOfObjective,
    /// A second vector of right-hand sides, ranges or bounds.
    #[error(
        "a second vector in {section}, after {first:?}; some solvers take the first alone, some take both"
    )]
    SecondVector {
        /// The section.
        section: &'static str,
        /// The name of the first.
        first: Foreign,
    },
    /// Text that means one program in the columns of fixed MPS and another one in free MPS.
    #[error("names with blanks, as in fixed MPS, and yet another program as free MPS")]
    Ambiguous,
    /// A piece of LP format that does not belong here.
    #[error("this cannot stand here")]
    Unexpected(&'static str),
    /// A text in the format of another program.
    #[error("this is lp_solve's own LP format")]
    LpSolve,
    /// A quadratic term.
    #[error("quadratic terms are not linear")]
    Quadratic,
    /// A sign of multiplication, which quadratic terms alone have.
    #[error("LP format has * in quadratic terms alone")]
    Times,
    /// A variable for the second time in one expression.
    #[error("the variable has a term on line {first} already")]
    TermTwice {
        /// The first line.
        first: u64,
    },
    /// A name that may be a term of another variable, such as `x/3` beside `x`.
    #[error("the name may be a term of the variable {of:?}")]
    MayBeTerm {
        /// The other variable.
        of: Foreign,
    },
    /// The text stops before its end.
    #[error("the file stops without its end")]
    NoEnd(ExchangeFormat),
    /// A section that has to be there.
    #[error("there is no section {0}")]
    NoSection(&'static str),
}

impl ModelErrorKind {
    /// The limit that was passed, if that is the problem.
    fn limit(&self) -> Option<Limit> {
        match self {
            ModelErrorKind::NotANumber(error) => Limit::of_number(&error.kind),
            ModelErrorKind::LineTooLong { .. } => Some(Limit::Line),
            ModelErrorKind::TooManyRows { .. } => Some(Limit::Rows),
            ModelErrorKind::TooManyColumns { .. } => Some(Limit::Columns),
            ModelErrorKind::TooManyEntries { .. } => Some(Limit::Elements),
            _ => None,
        }
    }

    /// Returns what would be accepted instead, where that is not said already.
    fn expected(&self) -> Option<&'static str> {
        Some(match self {
            ModelErrorKind::Empty(ExchangeFormat::Mps) | ModelErrorKind::NoSection(_) => {
                "a linear program in MPS: NAME, ROWS, COLUMNS, RHS, RANGES, BOUNDS, ENDATA"
            }
            ModelErrorKind::Empty(ExchangeFormat::Lp) => {
                "a linear program in LP format: minimize or maximize, subject to, bounds, end"
            }
            ModelErrorKind::Utf16 | ModelErrorKind::NotUtf8 | ModelErrorKind::ControlCharacter(_) => {
                "text in UTF-8"
            }
            ModelErrorKind::NotANumber(error) if error.kind.is_limit() => return None,
            ModelErrorKind::NotANumber(_) => "a decimal such as 1.30e-2 or a fraction such as 7/19",
            ModelErrorKind::Impossible(_) => "a number; 1e30 and more are infinite",
            ModelErrorKind::NotLinear => "rows, columns, right-hand sides, ranges and bounds",
            ModelErrorKind::Integer | ModelErrorKind::SemiContinuous => {
                "columns that may have any value between two bounds"
            }
            ModelErrorKind::UnknownSection | ModelErrorKind::OutsideSection => {
                "NAME, OBJSENSE, OBJNAME, ROWS, COLUMNS, RHS, RANGES, BOUNDS or ENDATA; data begin with a blank"
            }
            ModelErrorKind::SectionWithData => "the name alone; data begin with a blank",
            ModelErrorKind::SectionTwice { .. } | ModelErrorKind::SectionEarly(_) => {
                "ROWS, then COLUMNS, then RHS, RANGES and BOUNDS, each once"
            }
            ModelErrorKind::EmptySection(_) => "MIN or MAX in OBJSENSE, a row in OBJNAME",
            ModelErrorKind::Record { expected, .. } => expected,
            ModelErrorKind::LpSolve => {
                "CPLEX's LP format, or MPS: lp_solve -S1 -parse_only FILE.lp -wfmps FILE.mps writes it"
            }
            ModelErrorKind::FixedColumns => {
                "names and numbers in the columns 2-3, 5-12, 15-22, 25-36, 40-47 and 50-61, or names without blanks"
            }
            ModelErrorKind::RowType => "N, L, G or E",
            ModelErrorKind::BoundType => "LO, UP, FX, FR, MI or PL",
            ModelErrorKind::Sense => "MIN or MAX",
            ModelErrorKind::SenseInComment => {
                "the section OBJSENSE with MAX or MIN; PuLP writes it with writeMPS(..., with_objsense=True)"
            }
            ModelErrorKind::NotAnObjective => "a row of type N",
            ModelErrorKind::Dollar => "another name: what begins with $ may be a comment",
            ModelErrorKind::ColumnAgain { .. } => "all of a column together",
            ModelErrorKind::UnknownRow { .. } => "a row of the section ROWS",
            ModelErrorKind::UnknownColumn { .. } => "a column that has coefficients; they may be 0",
            ModelErrorKind::EntryTwice { .. } | ModelErrorKind::SideTwice { .. } => "one",
            ModelErrorKind::BoundTwice { .. } => "one; FX and FR are both bounds",
            ModelErrorKind::NoBound => "a number behind the column; FR, MI and PL have none",
            ModelErrorKind::RowTwice { .. } => "names that differ",
            ModelErrorKind::SecondVector { .. } => "one vector, under one name",
            ModelErrorKind::Ambiguous => "names without blanks",
            ModelErrorKind::NoEnd(ExchangeFormat::Mps) => "ENDATA as the last line; was the file cut off?",
            ModelErrorKind::NoEnd(ExchangeFormat::Lp) => "end as the last word; was the file cut off?",
            ModelErrorKind::Quadratic => "terms such as 3 x",
            ModelErrorKind::Times => "a blank, as in 3 x",
            ModelErrorKind::Unexpected(expected) => expected,
            ModelErrorKind::MayBeTerm { .. } => "terms such as 1/3 x and 2 x, or another name",
            ModelErrorKind::TermTwice { .. } => "one term of each variable",
            _ => return None,
        })
    }
}

/// The part of a message that says where.
struct At<'a>(Option<&'a ModelPlace>);

impl fmt::Display for At<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(ModelPlace { line, column, text }) => {
                write!(f, "line {line}, column {column}: {}: ", text.quoted())
            }
            None => Ok(()),
        }
    }
}

/// The part of a message that says what would be accepted.
struct Expected<'a>(&'a ModelErrorKind);

impl fmt::Display for Expected<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0.expected() {
            Some(expected) => write!(f, " (expected {expected})"),
            None => Ok(()),
        }
    }
}

fn did_you_mean(meant: Option<&Foreign>) -> String {
    meant.map(|name| format!("; did you mean {}?", name.quoted())).unwrap_or_default()
}
