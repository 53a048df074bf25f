//! Readings as people ask about them, and the one way from there to what the engine takes.

mod common;
mod keys;
mod limits;
mod rows;
mod table;

use boundfit_estimation::{AskedBound, Condition, EpsilonColumn, Law, LineForm, Question};
use boundfit_exact::{Limits, Rational, Reading};
use boundfit_formats::{ColumnSelector, ScanOptions};
use boundfit_questions::Agreement;
use serde::Deserialize;

use crate::asked::{Asked, AskedXBounds, XErrors};
use crate::given::Given;
use crate::misuse::Misuse;
use crate::question::Subject;
use crate::refusal::{Refusal, ValueProblem};

pub use common::{AnswerWords, Common, Digits};
pub use keys::take_key;
pub use limits::{AskedLimits, limits_of_files, range_of_limit, resolve_limits};
pub use rows::{OfRows, Rows};
pub use table::{RowWords, TableWords, named};

/// The column of x, or those of two regressors, by header names or by numbers from 1, as text.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged, expecting = "expected the name or number of a column as text, or an array of two of these")]
pub enum Regressors {
    /// The x of a line.
    One(String),
    /// Two regressors.
    Two([String; 2]),
}

keys::keys! {
    /// The readings that are asked about: columns, bounds on the errors and what else is known, in the words of people. Columns are
    /// header names or numbers from 1, and numbers are texts.
    ///
    /// ```
    /// use boundfit_ask::{Common, Request};
    ///
    /// let (request, Common { readings, .. }) = Request::with_readings(r#"{"ask": "range", "x": "V", "y": "z", "eps": "1/2"}"#)
    ///     .map_err(|refusal| format!("{refusal:?}"))?;
    /// assert_eq!(request.name(), "range");
    /// let reading = readings.table.reading(false).map_err(|refusal| format!("{refusal:?}"))?;
    /// let asked = readings.resolve(reading).map_err(|refusal| format!("{refusal:?}"))?;
    /// assert!(asked.question.is_plain());
    /// # Ok::<(), String>(())
    /// ```
    Readings {
        /// The column of x, or those of two regressors.
        "x" x: Option<Regressors>,
        /// The column of y.
        "y" y: Option<String>,
        /// The bound on every error: a number, a law, or a multiple of the least bound such as `1.2*min`.
        "eps" eps: Option<Given>,
        /// The column with the bound on each error.
        "eps_column" eps_column: Option<String>,
        /// The column with the least value that the model may have at each reading.
        "lower" lower: Option<String>,
        /// The column with the largest value that the model may have at each reading.
        "upper" upper: Option<String>,
        /// Conditions that the parameters are known to satisfy, such as `theta1 >= 0`.
        "where" conditions: Vec<Given>,
        /// `true` for lines without offset.
        "through_origin" through_origin: bool,
        /// The origin that x is counted from.
        "x_origin" x_origin: Option<Given>,
        /// The bound on the errors of x: a number, or else the column with the bound of each reading.
        "x_eps" x_eps: Option<Given>,
        /// The column with the bound on the error of each x.
        "x_eps_column" x_eps_column: Option<String>,
        /// `true` if a line must agree for every x that the errors of x allow.
        "strong" strong: bool,
    } with {
        /// The rows of the table.
        rows: RowWords,
        /// The dialect of the table.
        table: TableWords,
    }
}

impl Readings {
    /// Returns whether it is said how large errors may be.
    pub fn has_bounds(&self) -> bool {
        self.eps.is_some() || [&self.eps_column, &self.lower, &self.upper].into_iter().any(Option::is_some)
    }

    /// Returns what is asked of readings whose numbers are read like that ([`TableWords::reading`]); numbers that are said to be exact are
    /// what they say under every reading.
    ///
    /// # Errors
    /// When a value makes no sense, or values exclude or need each other.
    pub fn resolve(&self, reading: Reading) -> Result<Asked, Refusal> {
        self.resolve_for(Subject::BoundedReadings, reading)
    }

    /// Does as [`Readings::resolve`], for a question with this subject. Where bounds on the errors have no say, they may be left out, and y
    /// too. Half-planes have columns of their own, and a linear program has none.
    ///
    /// # Errors
    /// Errors are those of [`Readings::resolve`].
    pub fn resolve_for(&self, subject: Subject, reading: Reading) -> Result<Asked, Refusal> {
        let table = self.table.resolve(reading, &self.rows)?;
        let has_bounds = subject == Subject::BoundedReadings;
        let own = Words { readings: self, reading, limits: &table.limits, has_bounds };
        let (question, x_errors) = match subject {
            Subject::HalfPlanes => (self.half_planes()?, None),
            Subject::LinearProgram => (self.no_readings()?, None),
            Subject::BoundedReadings | Subject::Readings => (own.question()?, own.x_errors()?),
        };
        let options = ScanOptions { table, ..ScanOptions::default() };
        Ok(Asked { x_errors, options, ..Asked::new(question) })
    }

    /// Refuses every word about readings and their table but limits.
    fn no_readings(&self) -> Result<Question, Refusal> {
        let table = TableWords { limits: self.table.limits.clone(), ..TableWords::default() };
        match *self == (Readings { table, ..Readings::default() }) {
            true => Ok(Question::line(ColumnSelector::name_or_number("1"), None)),
            false => Err(Refusal::Misuse(Misuse::ReadingsOfProgram)),
        }
    }

    /// The half-planes a1·θ1 + a2·θ2 ≤ b of a table, as readings b of which the upper bound alone is known.
    fn half_planes(&self) -> Result<Question, Refusal> {
        let [a1, a2, b] =
            [("a1", 1), ("a2", 2), ("b", 3)].map(|(name, at)| ColumnSelector::name_at(name, at));
        match *self == (Readings { table: self.table.clone(), ..Readings::default() }) {
            true => Ok(Question::regressors(a1, a2, None)
                .within_columns(EpsilonColumn::Interval { lower: None, upper: Some(b) })),
            false => Err(Refusal::Misuse(Misuse::ReadingsOfHalfPlanes)),
        }
    }
}

/// Words with what they are read by.
struct Words<'a> {
    readings: &'a Readings,
    reading: Reading,
    limits: &'a Limits,
    has_bounds: bool,
}

impl Words<'_> {
    fn question(&self) -> Result<Question, Refusal> {
        let own = self.readings;
        let response = own.y.as_deref().map(|text| column("y", text)).transpose()?;
        let mut question = match own.x.as_ref().ok_or(Refusal::Misuse(Misuse::NoX))? {
            Regressors::One(x) => Question::line(column("x", x)?, response),
            Regressors::Two([phi1, phi2]) => {
                Question::regressors(column("x", phi1)?, column("x", phi2)?, response)
            }
        };
        let is_line = question.columns.second.is_none();
        if self.has_bounds {
            (question.columns.epsilon, question.multiple_of_least) = self.bound(is_line)?;
        }
        question.columns.form = self.form(is_line)?;
        for given in &own.conditions {
            let condition = Condition::parse(&given.text(), given.reading(self.reading), self.limits);
            question.conditions.push(
                condition.map_err(|error| refused("where", given.text(), ValueProblem::Condition(error)))?,
            );
        }
        match question.multiple_of_least.is_some() && question.conditions_contradict() {
            true => Err(Refusal::Misuse(Misuse::LeastOfNothing)),
            false => Ok(question),
        }
    }

    /// The bounds on the errors, of which there are to be those of one kind, and how many times the least bound is asked for.
    fn bound(&self, is_line: bool) -> Result<(EpsilonColumn, Option<Rational>), Refusal> {
        let own = self.readings;
        let [eps_column, lower, upper] =
            [("eps_column", &own.eps_column), ("lower", &own.lower), ("upper", &own.upper)]
                .map(|(key, text)| text.as_deref().map(|text| column(key, text)).transpose());
        let (eps_column, lower, upper) = (eps_column?, lower?, upper?);
        let is_interval = lower.is_some() || upper.is_some();
        if own.y.is_none() && !is_interval {
            return Err(Refusal::Misuse(Misuse::NoResponse));
        }
        match (&own.eps, eps_column, is_interval) {
            (Some(eps), None, false) => self.bound_in_words(eps, is_line),
            (None, Some(column), false) => Ok((EpsilonColumn::Column(column), None)),
            (None, None, true) => Ok((EpsilonColumn::Interval { lower, upper }, None)),
            (None, None, false) => Err(Refusal::Misuse(Misuse::NoBound)),
            _ => Err(Refusal::Misuse(Misuse::SeveralBounds)),
        }
    }

    fn bound_in_words(
        &self,
        eps: &Given,
        is_line: bool,
    ) -> Result<(EpsilonColumn, Option<Rational>), Refusal> {
        let text = eps.text();
        match AskedBound::parse(&text, eps.reading(self.reading), self.limits) {
            Ok(AskedBound::Number(number)) => Ok((EpsilonColumn::Uniform(number), None)),
            Ok(AskedBound::Law(law)) if !is_line && law.needs_x() => {
                Err(refused("eps", text, ValueProblem::LawOfX))
            }
            Ok(AskedBound::Law(law)) => Ok((EpsilonColumn::Law(*law), None)),
            // It is not known yet, and 0 has no say in what it follows from.
            Ok(AskedBound::TimesLeast(factor)) => {
                Ok((EpsilonColumn::Uniform(Rational::zero()), Some(factor)))
            }
            Err(error) => Err(refused("eps", text, ValueProblem::Bound(error))),
        }
    }

    /// Returns the origin that x is counted from.
    fn form(&self, is_line: bool) -> Result<LineForm, Refusal> {
        let own = self.readings;
        if !is_line && own.through_origin {
            return Err(Refusal::Misuse(Misuse::OffsetOfTwoRegressors));
        }
        if !is_line && own.x_origin.is_some() {
            return Err(Refusal::Misuse(Misuse::OriginOfTwoRegressors));
        }
        let number = |given: &Given| {
            let expected = "expected a number such as 1980 or -2.5";
            let number = given.number(self.reading, self.limits);
            number
                .map_err(|error| refused("x_origin", given.text(), ValueProblem::Number { error, expected }))
        };
        let x_origin = own.x_origin.as_ref().map(number).transpose()?.unwrap_or_default();
        Ok(LineForm { x_origin, through_origin: own.through_origin })
    }

    /// The errors of x, where they are said. A text that is a number is one, and any other the name of a column.
    fn x_errors(&self) -> Result<Option<XErrors>, Refusal> {
        const EXPECTED: &str = "expected a number that is at least 0, such as 0.15, or a column";
        let own = self.readings;
        let bounds = match (&own.x_eps, &own.x_eps_column) {
            (None, None) if own.strong => return Err(Refusal::Misuse(Misuse::StrongAlone)),
            (None, None) => return Ok(None),
            (Some(_), Some(_)) => return Err(Refusal::Misuse(Misuse::TwoXBounds)),
            (None, Some(text)) => AskedXBounds::Column(column("x_eps_column", text)?),
            (Some(given), None) => match (given.number(self.reading, self.limits), given) {
                (Ok(number), _) if number.is_negative() => {
                    return Err(refused("x_eps", given.text(), ValueProblem::Negative(EXPECTED)));
                }
                (Ok(number), _) => AskedXBounds::Uniform(number),
                (Err(_), Given::Read(text)) if Law::parse(text, self.reading, self.limits).is_ok() => {
                    let problem =
                        "an error of x has no law (expected a number such as 0.15, or a column of bounds)";
                    return Err(refused("x_eps", text.clone(), ValueProblem::Expected(problem)));
                }
                (Err(error), Given::Read(text)) if !error.kind.is_limit() => {
                    AskedXBounds::Column(column("x_eps", text)?)
                }
                (Err(error), _) => {
                    let problem = ValueProblem::Number { error, expected: EXPECTED };
                    return Err(refused("x_eps", given.text(), problem));
                }
            },
        };
        let agreement = if own.strong { Agreement::Strong } else { Agreement::Weak };
        Ok(Some(XErrors { bounds, agreement }))
    }
}

/// The column that a key names.
fn column(key: &'static str, text: &str) -> Result<ColumnSelector, Refusal> {
    match text.trim() {
        "" => {
            let expected = "expected a header name or a column number";
            Err(refused(key, text.to_owned(), ValueProblem::Expected(expected)))
        }
        text => Ok(ColumnSelector::name_or_number(text)),
    }
}

fn refused(key: &'static str, text: String, problem: ValueProblem) -> Refusal {
    Refusal::Value { key, text, problem }
}

#[cfg(test)]
mod tests;
