//! The question that a proof must answer, from the options of `fit`.

use std::collections::BTreeMap;

use boundfit_ask::{AskedXBounds, Readings, Regressors, Subject, XErrors};
use boundfit_estimation::{Condition, EpsilonColumn, Law, LineForm};
use boundfit_exact::{Foreign, Rational, Reading};
use boundfit_formats::{ColumnSelector, Header, RowSet, find_column};
use boundfit_questions::Agreement;
use boundfit_report::{condition_text, rows_text};
use boundfit_verify::{About, Claim, Found, Quantity, Side, Statement};

use super::VerifyArguments;
use crate::exit::Failure;

/// The question; a part that is `None` is not compared.
pub(crate) struct Question {
    x: Option<(ColumnSelector, Option<ColumnSelector>)>,
    y: Option<ColumnSelector>,
    bound: Option<EpsilonColumn>,
    /// The errors of x, of which there may be none.
    x_errors: Option<Option<XErrors>>,
    rows: Option<RowSet>,
    conditions: Option<Vec<Condition>>,
    form: Option<LineForm>,
    reading: Option<Reading>,
    header: Option<bool>,
    delimiter: Option<char>,
}

impl VerifyArguments {
    /// The question that the options ask. Numbers in them are read as the proof reads those of the data, unless something else is
    /// asked for.
    pub(super) fn question(&self, about: &About) -> Result<Question, Failure> {
        let said = self.words();
        let (has_bound, has_reading) = (said.has_bounds(), said.table.reading.is_some());
        let resolved = || {
            let reading = said.table.reading(false)?;
            let own = if has_reading { reading } else { about.reading };
            let whole = with_columns_of(about, &said);
            let subject = if has_bound { Subject::BoundedReadings } else { Subject::Readings };
            Ok((whole.resolve_for(subject, own)?, reading))
        };
        let (asked, reading) = resolved().map_err(Failure::misused)?;
        let x_errors = asked.x_errors;
        let (question, table) = (asked.question, asked.options.table);
        let columns = question.columns;
        if question.multiple_of_least.is_some() {
            return Err(refuse("'--eps min'", "the number that it comes to, which 'fit' reports"));
        }
        if !said.rows.where_row.is_empty() {
            return Err(refuse("'--where-row'", "the rows with '--rows' and '--without'"));
        }
        if let EpsilonColumn::Law(law) = &columns.epsilon
            && law.terms(&Rational::zero()) != law.terms(&Rational::one())
        {
            return Err(refuse("'range(y)'", "the number that it comes to"));
        }
        let is_whole = said.x.is_some() && has_bound;
        let has_rows = !said.rows.rows.are_all() || !said.rows.without.are_all();
        let has_form = said.through_origin || said.x_origin.is_some();
        Ok(Question {
            x: said.x.is_some().then_some((columns.first, columns.second)),
            y: columns.response.filter(|_| said.y.is_some()),
            bound: has_bound.then_some(columns.epsilon),
            x_errors: (is_whole || x_errors.is_some()).then_some(x_errors),
            rows: (is_whole || has_rows).then_some(table.rows),
            conditions: (is_whole || !said.conditions.is_empty()).then_some(question.conditions),
            form: (is_whole || has_form).then_some(columns.form),
            reading: (is_whole || has_reading).then_some(reading),
            header: match table.header {
                Header::Auto => None,
                asked => Some(asked == Header::Present),
            },
            delimiter: table.dialect.delimiter.map(char::from),
        })
    }
}

/// Returns the question, with the columns of a proof where it names none.
fn with_columns_of(about: &About, said: &Readings) -> Readings {
    let [first, second, response, _] = &about.model;
    let column = |(column, _): &(u64, Rational)| column.to_string();
    let x = || match second {
        (0, _) => Regressors::One(column(first)),
        second => Regressors::Two([column(first), column(second)]),
    };
    Readings {
        x: said.x.clone().or_else(|| Some(x())),
        y: said.y.clone().or_else(|| Some(column(response))),
        ..said.clone()
    }
}

fn refuse(what: &str, instead: &str) -> Failure {
    Failure::Usage(format!("{what} depends on the readings, and cannot be compared: give {instead}"))
}

impl Question {
    /// Returns the differences between the question that the proof of a file of data answers and this one, a sentence for each.
    ///
    /// # Errors
    /// A column that is asked for is not there, or could be several.
    pub(crate) fn differences(&self, file: &str, statement: &Statement) -> Result<Vec<String>, Failure> {
        let about = &statement.about;
        let mut differences = Vec::new();
        let mut differ = |is_same: bool, what: &str, stated: String, asked: String| {
            if !is_same {
                differences.push(format!("the proof is about {what} {stated}, not {asked}"));
            }
        };
        let columns = Columns::new(file, statement, self.columns())?;
        if let Some((first, second)) = &self.x {
            let [phi1, phi2, ..] = &about.model;
            differ(columns.is(phi1, first), "x =", columns.shown(phi1), columns.asked(first));
            match second {
                Some(second) => {
                    differ(
                        columns.is(phi2, second),
                        "the second x =",
                        columns.shown(phi2),
                        columns.asked(second),
                    );
                }
                None => {
                    let is_line = *phi2 == (0, Rational::one());
                    differ(
                        is_line,
                        "the second x =",
                        columns.shown(phi2),
                        "a line with an offset".to_owned(),
                    );
                }
            }
        }
        if let Some(y) = &self.y {
            let is_same = about.response.is_empty() && columns.is(&about.model[2], y);
            differ(is_same, "y =", columns.response(about), columns.asked(y));
        }
        if let Some(bound) = &self.bound {
            let (stated, asked) = (columns.bound(about), columns.asked_bound(bound));
            let is_same = columns.is_bound(about, bound);
            differ(is_same, &stated.0, stated.1, asked);
        }
        if let Some(asked) = &self.x_errors {
            let (stated, asked) = (columns.x_errors(statement), columns.asked_x_errors(asked.as_ref()));
            differ(stated == asked, "errors in x", stated, asked);
        }
        if let Some(form) = &self.form {
            let is_same = about.x_origin == form.x_origin;
            differ(is_same, "x counted from", given(&about.x_origin), given(&form.x_origin));
        }
        let through_origin = self.form.as_ref().is_some_and(|form| form.through_origin);
        if let Some(conditions) = &self.conditions {
            self.differ_in_conditions(about, conditions, through_origin, &mut differ);
        } else if through_origin {
            let no_intercept = normal(&terms(&Condition::no_intercept()));
            let is_there = about.conditions.iter().any(|own| normal(own) == no_intercept);
            differ(is_there, "a line with", "an offset".to_owned(), "one through the origin".to_owned());
        }
        if let Some(rows) = &self.rows {
            let stated = format!("{} of {}", rows_text(&about.rows), statement.rows_total);
            differ(
                have_rows(about, rows, statement.rows_total),
                "rows",
                stated,
                asked_rows(rows, statement.rows_total),
            );
        }
        if let Some(reading) = self.reading {
            differ(
                about.reading == reading,
                "the reading",
                about.reading.name().to_owned(),
                reading.name().to_owned(),
            );
        }
        if let Some(header) = self.header {
            let word = |header: bool| if header { "with a header" } else { "without a header" };
            differ(about.header == header, "data", word(about.header).to_owned(), word(header).to_owned());
        }
        if let Some(delimiter) = self.delimiter {
            let is_same = about.delimiter == delimiter;
            differ(is_same, "cells between", format!("{:?}", about.delimiter), format!("{delimiter:?}"));
        }
        Ok(differences)
    }

    /// The columns that are asked for.
    fn columns(&self) -> Vec<ColumnSelector> {
        let x = self.x.iter().flat_map(|(first, second)| [Some(first), second.as_ref()]).flatten();
        let bound = match &self.bound {
            Some(EpsilonColumn::Column(column)) => [Some(column), None],
            Some(EpsilonColumn::Interval { lower, upper }) => [lower.as_ref(), upper.as_ref()],
            _ => [None, None],
        };
        let x_bound = match self.x_errors.iter().flatten().next() {
            Some(XErrors { bounds: AskedXBounds::Column(column), .. }) => Some(column),
            _ => None,
        };
        x.chain(&self.y).chain(bound.into_iter().flatten()).chain(x_bound).cloned().collect()
    }

    fn differ_in_conditions(
        &self,
        about: &About,
        conditions: &[Condition],
        through_origin: bool,
        differ: &mut impl FnMut(bool, &str, String, String),
    ) {
        let no_intercept = through_origin.then(Condition::no_intercept);
        let asked: Vec<Terms> = conditions.iter().chain(&no_intercept).map(terms).collect();
        let sorted = |conditions: &[Terms]| {
            let mut all: Vec<Terms> = conditions.iter().map(normal).collect();
            all.sort();
            all
        };
        let shown = |conditions: &[Terms]| match conditions {
            [] => "none".to_owned(),
            [only] => format!("'{}'", condition_text(only)),
            [first, more @ ..] => format!("'{}' and {} more", condition_text(first), more.len()),
        };
        let is_same = sorted(&about.conditions) == sorted(&asked);
        differ(is_same, "the conditions", shown(&about.conditions), shown(&asked));
    }
}

/// a1, a2 and b of a condition, and whether it is an equation.
type Terms = ([Rational; 3], bool);

fn terms(condition: &Condition) -> Terms {
    let inequality = condition.inequality();
    let [a1, a2] = &inequality.a;
    ([a1.clone(), a2.clone(), inequality.b.clone()], condition.is_equation())
}

/// The one of all its positive multiples, of an equation of all its multiples, that begins with 1 or -1, or with 1.
fn normal((numbers, is_equation): &Terms) -> Terms {
    let first = numbers.iter().find(|number| !number.is_zero());
    let scale = first.map(|first| if *is_equation { first.clone() } else { first.abs() });
    let scaled = |number: &Rational| scale.as_ref().and_then(|scale| number.checked_div(scale));
    (numbers.each_ref().map(|number| scaled(number).unwrap_or_default()), *is_equation)
}

/// Returns whether a set has exactly the rows, from 1 to `total`, that a proof is about.
fn have_rows(about: &About, rows: &RowSet, total: u64) -> bool {
    let mut asked = (1..=total).filter(|row| usize::try_from(*row).is_ok_and(|row| rows.contains(row)));
    let range = |pair: &[u64]| match *pair {
        [first, last] => Some(first..=last),
        _ => None,
    };
    let mut stated = about.rows.chunks_exact(2).filter_map(range).flatten();
    let rows_are_same = stated.by_ref().all(|row| asked.next() == Some(row));
    rows_are_same && asked.next().is_none()
}

fn asked_rows(rows: &RowSet, total: u64) -> String {
    let ranges = |ranges: &[boundfit_formats::RowRange]| {
        ranges.iter().map(ToString::to_string).collect::<Vec<_>>().join(",")
    };
    let named = if rows.named().is_empty() { format!("all {total}") } else { ranges(rows.named()) };
    if rows.without().is_empty() { named } else { format!("{named} without {}", ranges(rows.without())) }
}

/// The columns of the data by name and number, and which of them are asked for.
struct Columns<'a> {
    statement: &'a Statement,
    asked: Vec<(ColumnSelector, u64)>,
}

impl<'a> Columns<'a> {
    /// Finds the columns that are asked for as `fit` does.
    fn new(file: &str, statement: &'a Statement, asked: Vec<ColumnSelector>) -> Result<Self, Failure> {
        let names: Vec<Foreign> = statement.names.values().cloned().collect();
        let number = |column: &ColumnSelector| match (statement.about.header, column.number()) {
            (true, _) => find_column(file, &names, &asked, column).map_err(Failure::data),
            // No row has names, so that no other column can be meant.
            (false, number) => Ok(number.unwrap_or_default()),
        };
        let numbers = asked.iter().map(|column| Ok(number(column)? as u64)).collect::<Result<Vec<_>, _>>()?;
        Ok(Columns { statement, asked: asked.into_iter().zip(numbers).collect() })
    }

    /// Returns whether a column is taken once, and is the one that was asked for.
    fn is(&self, (column, times): &(u64, Rational), asked: &ColumnSelector) -> bool {
        *times == Rational::one() && self.is_column(*column, asked)
    }

    fn is_column(&self, column: u64, asked: &ColumnSelector) -> bool {
        self.asked.iter().any(|(own, number)| own == asked && *number == column)
    }

    fn column(&self, column: u64) -> String {
        match self.statement.names.get(&column) {
            Some(name) => format!("column {column} ({})", name.borrowed().quoted()),
            None => format!("column {column}"),
        }
    }

    fn shown(&self, (column, times): &(u64, Rational)) -> String {
        match column {
            0 => given(times),
            column if *times == Rational::one() => self.column(*column),
            column => format!("{times} times {}", self.column(*column)),
        }
    }

    /// y with the columns that are added to it.
    fn response(&self, about: &About) -> String {
        let own = Some(&about.model[2]).filter(|(column, times)| *column > 0 || !times.is_zero());
        let terms = own.into_iter().chain(&about.response).map(|term| self.shown(term));
        let terms: Vec<String> = terms.collect();
        if terms.is_empty() { "0".to_owned() } else { terms.join(" + ") }
    }

    /// The errors of x that a proof allows.
    fn x_errors(&self, statement: &Statement) -> String {
        let Some(bound) = &statement.about.x_error else { return NO_X_ERRORS.to_owned() };
        let is_strong = |claim: &Claim| claim.scope.side == Some(Side::Strong);
        let are_strong = matches!(&statement.found, Found::Claims(claims) if claims.iter().all(is_strong));
        let agreement = if are_strong { Agreement::Strong } else { Agreement::Weak };
        up_to(&self.shown(bound), agreement)
    }

    fn asked_x_errors(&self, asked: Option<&XErrors>) -> String {
        let Some(XErrors { bounds, agreement }) = asked else { return NO_X_ERRORS.to_owned() };
        let bound = match bounds {
            AskedXBounds::Uniform(bound) => given(bound),
            AskedXBounds::Column(column) => {
                let found = self.asked.iter().find(|(own, _)| own == column);
                found.map_or_else(|| self.asked(column), |(_, number)| self.column(*number))
            }
        };
        up_to(&bound, *agreement)
    }

    fn asked(&self, column: &ColumnSelector) -> String {
        column.text().to_string()
    }

    /// Returns the kind of bound that a proof is about, and the bound.
    fn bound(&self, about: &About) -> (String, String) {
        let side =
            |side: Option<u64>| side.map_or_else(|| "nothing".to_owned(), |column| self.column(column));
        match (&about.interval, &about.law) {
            (Some([lower, upper]), _) => {
                ("values between".to_owned(), format!("{} and {}", side(*lower), side(*upper)))
            }
            (None, Some(_)) => ("an error bound that".to_owned(), "is a law".to_owned()),
            (None, None) => ("eps =".to_owned(), self.shown(&about.model[3])),
        }
    }

    fn asked_bound(&self, bound: &EpsilonColumn) -> String {
        match bound {
            EpsilonColumn::Uniform(epsilon) => given(epsilon),
            EpsilonColumn::Column(column) => format!("column {}", self.asked(column)),
            EpsilonColumn::Interval { lower, upper } => {
                let side = |side: &Option<ColumnSelector>| {
                    side.as_ref().map_or_else(|| "nothing".to_owned(), |own| self.asked(own))
                };
                format!("values between {} and {}", side(lower), side(upper))
            }
            EpsilonColumn::Law(law) => law.text().to_string(),
        }
    }

    fn is_bound(&self, about: &About, asked: &EpsilonColumn) -> bool {
        let epsilon = &about.model[3];
        let is_plain = about.interval.is_none() && about.law.is_none();
        match asked {
            EpsilonColumn::Uniform(asked) => is_plain && epsilon.0 == 0 && epsilon.1 == *asked,
            EpsilonColumn::Column(asked) => is_plain && self.is(epsilon, asked),
            EpsilonColumn::Interval { lower, upper } => {
                let is_side = |stated: Option<u64>, asked: &Option<ColumnSelector>| match (stated, asked) {
                    (None, None) => true,
                    (Some(column), Some(asked)) => self.is_column(column, asked),
                    _ => false,
                };
                about.interval.is_some_and(|[own_lower, own_upper]| {
                    is_side(own_lower, lower) && is_side(own_upper, upper)
                })
            }
            EpsilonColumn::Law(law) => about.interval.is_none() && stated_law(about) == asked_law(law, about),
        }
    }
}

/// The words where x has no errors.
const NO_X_ERRORS: &str = "of 0";

/// Errors in x under a bound, and for which x a line agrees.
fn up_to(bound: &str, agreement: Agreement) -> String {
    let which = match agreement {
        Agreement::Weak => "some",
        Agreement::Strong => "every",
    };
    format!("up to {bound}, for {which} x within them")
}

/// A number as a decimal, or as the fraction that it is.
fn given(number: &Rational) -> String {
    number.exact_decimal(17).map_or_else(|| number.to_string(), |decimal| decimal.to_string())
}

/// The multiples of each quantity of a column.
type Sum = BTreeMap<(&'static str, u64), Rational>;

/// Returns the law above and below y.
fn stated_law(about: &About) -> [Sum; 2] {
    let (column, times) = &about.model[3];
    let law = about.law.clone().unwrap_or_default();
    law.map(|terms| sum([(Quantity::Number, *column, times.clone())].into_iter().chain(terms)))
}

fn asked_law(law: &Law, about: &About) -> [Sum; 2] {
    law.terms(&Rational::zero()).map(|(constant, terms)| {
        let term = |(name, times): (&'static str, Rational)| match name {
            "x" => (Quantity::Abs, about.model[0].0, times),
            "written" => (Quantity::Written, about.model[2].0, times),
            _ => (Quantity::Abs, about.model[2].0, times),
        };
        sum([(Quantity::Abs, 0, constant)].into_iter().chain(terms.into_iter().map(term)))
    })
}

fn sum(terms: impl Iterator<Item = (Quantity, u64, Rational)>) -> Sum {
    let mut sum = Sum::new();
    for (quantity, column, times) in terms.filter(|(.., times)| !times.is_zero()) {
        let name = match quantity {
            Quantity::Written => "written",
            // 1 in every row.
            Quantity::Number | Quantity::Abs if column == 0 => "constant",
            Quantity::Number => "number",
            Quantity::Abs => "abs",
        };
        let own = sum.entry((name, column)).or_default();
        *own = &*own + times;
    }
    sum
}
