//! Readings: what was measured, under which model, with which error bound.

use boundfit_exact::Rational;
use boundfit_formats::{
    Batch, ColumnSelector, InputError, Scanned, Source, TableOptions, TableRow, TextLayout, read_table,
};

use crate::summary::{NoEui, Reduction};

/// One reading.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Measurement {
    /// Number of the data row in the file, from 1.
    pub row: usize,
    /// φ = (φ1, φ2); (x, 1) for the line model.
    pub regressor: [Rational; 2],
    /// y.
    pub response: Rational,
    /// The bound on the error of this reading; not negative.
    pub epsilon: Rational,
}

/// How the regressors come from the columns.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Model {
    /// y = θ1·x + θ2 + e.
    Line {
        /// The column of x.
        x: String,
    },
    /// y = φ1·θ1 + φ2·θ2 + e.
    TwoRegressors {
        /// The columns of φ1 and φ2.
        regressors: [String; 2],
    },
}

/// Where the error bounds come from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ErrorBound {
    /// The same for every reading.
    Uniform(Rational),
    /// One per reading, from a column of this name.
    PerRow(String),
}

/// The readings of a fit.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Measurements {
    model: Model,
    response: String,
    error_bound: ErrorBound,
    rows: Vec<Measurement>,
    others: Vec<Measurement>,
    reduction: Option<Reduction>,
    rows_total: usize,
    layout: Option<TextLayout>,
    sha256: Option<String>,
}

/// The error bound as it is asked for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum EpsilonColumn {
    /// The same number for every reading; not negative.
    Uniform(Rational),
    /// A column.
    Column(ColumnSelector),
}

/// Which columns of a table are what.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Columns {
    /// x, or φ1.
    pub first: ColumnSelector,
    /// φ2; `None` for the line model.
    pub second: Option<ColumnSelector>,
    /// y.
    pub response: ColumnSelector,
    /// ε.
    pub epsilon: EpsilonColumn,
}

impl Columns {
    /// The columns in the order in which they are read: regressors, response, error bound.
    pub(crate) fn selectors(&self) -> Vec<ColumnSelector> {
        let mut selectors = vec![self.first.clone()];
        selectors.extend(self.second.clone());
        selectors.push(self.response.clone());
        if let EpsilonColumn::Column(epsilon) = &self.epsilon {
            selectors.push(epsilon.clone().non_negative());
        }
        selectors
    }

    /// Model, response and error bound by the names of those columns.
    pub(crate) fn described(&self, names: &[String]) -> (Model, String, ErrorBound) {
        let mut names = names.iter().cloned();
        let mut name = || names.next().unwrap_or_default();
        let first = name();
        let model = match self.second {
            None => Model::Line { x: first },
            Some(_) => Model::TwoRegressors { regressors: [first, name()] },
        };
        let response = name();
        let error_bound = match &self.epsilon {
            EpsilonColumn::Uniform(epsilon) => ErrorBound::Uniform(epsilon.clone()),
            EpsilonColumn::Column(_) => ErrorBound::PerRow(name()),
        };
        (model, response, error_bound)
    }
}

impl Measurements {
    /// Readings that do not come from a file.
    pub fn new(model: Model, response: String, error_bound: ErrorBound, rows: Vec<Measurement>) -> Self {
        let rows_total = rows.len();
        Measurements {
            model,
            response,
            error_bound,
            rows,
            others: Vec::new(),
            reduction: None,
            rows_total,
            layout: None,
            sha256: None,
        }
    }

    /// Reads the columns of a table.
    ///
    /// # Errors
    /// The first thing wrong with the file, a negative error bound included.
    pub fn read(source: Source, columns: &Columns, options: &TableOptions) -> Result<Self, InputError> {
        let table = read_table(source, &columns.selectors(), options)?;
        let (model, response, error_bound) = columns.described(&table.names);
        let measured =
            |rows: &[TableRow]| rows.iter().map(|row| measurement(row, &model, &error_bound)).collect();
        let (rows, others) = (measured(&table.rows), measured(&table.others));
        Ok(Measurements {
            others,
            rows_total: table.rows_total,
            layout: table.layout,
            sha256: Some(table.sha256),
            ..Measurements::new(model, response, error_bound, rows)
        })
    }

    /// All readings of these batches.
    pub(crate) fn of_batches(columns: &Columns, scanned: Scanned, batches: &[Batch]) -> Self {
        let (model, response, error_bound) = columns.described(&scanned.names);
        let row = |batch: &Batch, k: usize| {
            let numbers = batch.columns.iter().map(|column| column.get(k)).collect();
            TableRow { row: batch.first_row + k, line: 0, numbers }
        };
        let rows = batches.iter().flat_map(|batch| (0..batch.rows).map(move |k| row(batch, k)));
        let rows = rows.map(|row| measurement(&row, &model, &error_bound)).collect();
        Measurements {
            rows_total: scanned.rows_total,
            layout: scanned.layout,
            sha256: scanned.sha256,
            ..Measurements::new(model, response, error_bound, rows)
        }
    }

    /// The readings of a line that touch a hull, and what is known about all of them.
    pub(crate) fn of_reduction(
        columns: &Columns,
        scanned: Scanned,
        mut rows: Vec<Measurement>,
        reduction: Reduction,
    ) -> Self {
        let (model, response, error_bound) = columns.described(&scanned.names);
        if let ErrorBound::Uniform(epsilon) = &error_bound {
            rows.iter_mut().for_each(|row| row.epsilon = epsilon.clone());
        }
        Measurements {
            rows_total: scanned.rows_total,
            layout: scanned.layout,
            sha256: scanned.sha256,
            reduction: Some(reduction),
            ..Measurements::new(model, response, error_bound, rows)
        }
    }

    /// The model.
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// The name of the response.
    pub fn response(&self) -> &str {
        &self.response
    }

    /// Where the error bounds come from.
    pub fn error_bound(&self) -> &ErrorBound {
        &self.error_bound
    }

    /// The readings that are fitted; where [`Measurements::reduction`] is given, those of them that touch a hull.
    pub fn rows(&self) -> &[Measurement] {
        &self.rows
    }

    /// What is known about all readings where only those that touch a hull are kept. These decide everything but
    /// least squares.
    pub fn reduction(&self) -> Option<&Reduction> {
        self.reduction.as_ref()
    }

    /// Whether the rows were read from reductions, which number them anew.
    pub fn is_of_reductions(&self) -> bool {
        self.reduction.as_ref().is_some_and(|reduction| reduction.spread == Err(NoEui::Reduced))
    }

    /// How many readings are fitted, kept or not.
    pub fn fitted(&self) -> usize {
        self.reduction.as_ref().map_or(self.rows.len(), |reduction| reduction.sums.count)
    }

    /// Readings of the file that are not fitted, kept where the table was read with
    /// [`TableOptions::keep_others`].
    pub fn others(&self) -> &[Measurement] {
        &self.others
    }

    /// How many data rows the file has.
    pub fn rows_total(&self) -> usize {
        self.rows_total
    }

    /// Where in the file the numbers stand: regressors, response and, with one per row, error bound; `None` unless the
    /// readings come from delimited text that has a row for each of them.
    pub fn layout(&self) -> Option<&TextLayout> {
        self.layout.as_ref()
    }

    /// SHA-256 of the file's bytes in hexadecimal, when the readings come from a file.
    pub fn sha256(&self) -> Option<&str> {
        self.sha256.as_deref()
    }
}

fn measurement(row: &TableRow, model: &Model, error_bound: &ErrorBound) -> Measurement {
    let mut numbers = row.numbers.iter().cloned();
    let mut next = || numbers.next().unwrap_or_default();
    let regressor = match model {
        Model::Line { .. } => [next(), Rational::one()],
        Model::TwoRegressors { .. } => [next(), next()],
    };
    let response = next();
    let epsilon = match error_bound {
        ErrorBound::Uniform(epsilon) => epsilon.clone(),
        ErrorBound::PerRow(_) => next(),
    };
    Measurement { row: row.row, regressor, response, epsilon }
}
