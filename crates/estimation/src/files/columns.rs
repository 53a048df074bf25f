//! The meaning of each column of a table.

use boundfit_exact::{Column, Foreign, Rational, Work};
use boundfit_formats::{Batch, ColumnSelector, InputError, InputErrorKind};

use crate::line_form::LineForm;
use crate::meaning::{ErrorBound, Meaning, Model};
use crate::measurements::Measurements;

/// The error bound as it is asked for.
pub type EpsilonColumn = ErrorBound<ColumnSelector>;

/// The meaning of each column of a table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Columns {
    /// x, or φ1.
    pub first: ColumnSelector,
    /// φ2; `None` for the line model.
    pub second: Option<ColumnSelector>,
    /// y; may be left out beside [`EpsilonColumn::Interval`] only.
    pub response: Option<ColumnSelector>,
    /// ε.
    pub epsilon: EpsilonColumn,
    /// The form of the lines that are fitted.
    pub form: LineForm,
}

impl Columns {
    /// Returns whether the readings that decide the feasible set do so for every error bound: those of a line under a uniform one.
    pub fn are_open(&self) -> bool {
        self.meaning(&[]).is_open()
    }

    /// No readings of these columns, named as they are asked for.
    pub fn without_rows(&self) -> Measurements {
        let names: Vec<Foreign> = self.selectors().iter().map(|column| column.text().clone()).collect();
        Measurements::of_meaning(self.meaning(&names), Vec::new())
    }

    /// Estimates the work on the numbers that this many readings get beside their own, before memory is taken for
    /// them. These are the shared bound and origin, and the numbers given here.
    pub fn work_of_every<'a>(
        &'a self,
        readings: usize,
        more: impl IntoIterator<Item = &'a Rational>,
    ) -> Work {
        let mut numbers = vec![&self.form.x_origin];
        if let EpsilonColumn::Uniform(epsilon) = &self.epsilon {
            numbers.push(epsilon);
        }
        numbers.extend(more);
        let mut work = Work::default();
        if Work::of_numbers(&numbers).products(1) > 0 {
            (1..=readings).for_each(|row| work.add(row, numbers.iter().copied()));
        }
        work
    }

    /// Refuses numbers so long that so many readings, which get them each, would take too much of it.
    pub(crate) fn refuse_long_in_each(
        &self,
        file: &Foreign,
        readings: usize,
        limit: u64,
    ) -> Result<(), InputError> {
        let work = self.work_of_every(readings, []).check(1, limit);
        work.map_err(|problem| InputError::of_file(file, problem))
    }

    /// The columns in the order in which they are read: regressors, response, error bound.
    pub(crate) fn selectors(&self) -> Vec<ColumnSelector> {
        let mut selectors = vec![self.first.clone()];
        selectors.extend(self.second.clone());
        selectors.extend(self.response.clone());
        match &self.epsilon {
            EpsilonColumn::Uniform(_) => {}
            EpsilonColumn::Column(epsilon) => selectors.push(epsilon.clone().non_negative()),
            EpsilonColumn::Interval { lower, upper } => {
                let sides = [lower, upper].into_iter().flatten();
                selectors.extend(sides.flat_map(|side| [side.clone().optional(), side.clone().presence()]));
            }
            EpsilonColumn::Law(law) if law.needs_written() => {
                selectors.extend(self.response.clone().map(ColumnSelector::half_unit));
            }
            EpsilonColumn::Law(_) => {}
        }
        selectors
    }

    /// The number of the first row of a batch that has neither a lower nor an upper bound.
    pub(crate) fn first_unbounded(&self, batch: &Batch) -> Option<usize> {
        let EpsilonColumn::Interval { lower, upper } = &self.epsilon else { return None };
        let sides = usize::from(lower.is_some()) + usize::from(upper.is_some());
        // Behind each bound stands whether it is there.
        let presences: Vec<&Column> = batch.columns.iter().rev().step_by(2).take(sides).collect();
        if presences.iter().any(|presence| !presence.has_zero()) {
            return None;
        }
        let is_unbounded = |&k: &usize| presences.iter().all(|presence| presence.get(k).is_zero());
        (0..batch.rows.len()).find(is_unbounded).map(|k| batch.rows.get(k))
    }

    /// Refuses a row without bounds, if there is one.
    pub(crate) fn refuse_unbounded(&self, file: &Foreign, row: Option<usize>) -> Result<(), InputError> {
        row.map_or(Ok(()), |row| Err(InputError::of_row(file, row, InputErrorKind::NoBound)))
    }

    /// Returns what the numbers in those columns mean, whose names are given.
    pub(crate) fn meaning(&self, names: &[Foreign]) -> Meaning {
        let mut names = names.iter().cloned();
        let mut name = || names.next().unwrap_or_default();
        let first = name();
        let model = match self.second {
            None => Model::Line { x: first },
            Some(_) => Model::TwoRegressors { regressors: [first, name()] },
        };
        let response = self.response.as_ref().map(|_| name());
        let is_interval = matches!(self.epsilon, EpsilonColumn::Interval { .. });
        let (error_bound, uniform_law) = match &self.epsilon {
            EpsilonColumn::Law(law) if law.is_uniform() => {
                (ErrorBound::Uniform(law.uniform_bound(&Rational::zero())), Some(law.clone()))
            }
            stated => {
                let stated = stated.with_columns(|_| {
                    let own = name();
                    // Behind each bound stands the column that tells where it is.
                    if is_interval {
                        name();
                    }
                    own
                });
                (stated, None)
            }
        };
        let has_response = response.is_some();
        let response = response.unwrap_or_else(|| "y".into());
        let form = self.form.clone();
        Meaning { has_response, uniform_law, form, ..Meaning::new(model, response, error_bound) }
    }
}
