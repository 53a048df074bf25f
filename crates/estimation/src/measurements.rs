//! Readings: what was measured, under which model, with which error bound.

use std::borrow::Cow;

#[cfg(feature = "files")]
use boundfit_exact::Column;
use boundfit_exact::Rational;
#[cfg(feature = "files")]
use boundfit_formats::TextLayout;

use crate::law::{Law, range_of_y};
#[cfg(feature = "files")]
use crate::least_squares::NoLeastSquares;
use crate::line_form::LineForm;
use crate::selection::{FractionCells, Selection};
use crate::summary::{DecidingMinimax, NoEui, NoMinimax, Reduction};
#[cfg(feature = "files")]
use crate::summary::{Halves, Sums};

/// One reading.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Measurement {
    /// Number of the data row in the file, from 1.
    pub row: usize,
    /// φ = (φ1, φ2); (x, 1) for the line model.
    pub regressor: [Rational; 2],
    /// What it says of φ·θ.
    pub bounds: Bounds,
}

/// What a reading says of φ·θ.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Bounds {
    /// It lies within ε of y.
    Around {
        /// y.
        response: Rational,
        /// ε; not negative.
        epsilon: Rational,
    },
    /// It lies between two values, of which one may be missing. The lower one may be above the upper one: no θ agrees then.
    Between {
        /// φ·θ is at least this.
        lower: Option<Rational>,
        /// φ·θ is at most this.
        upper: Option<Rational>,
        /// y, if there is one. It bounds nothing: least squares takes it.
        response: Option<Rational>,
    },
}

impl Measurement {
    /// A reading y with |y - φ·θ| ≤ ε.
    pub fn around(row: usize, regressor: [Rational; 2], response: Rational, epsilon: Rational) -> Self {
        Measurement { row, regressor, bounds: Bounds::Around { response, epsilon } }
    }

    /// A reading that says lower ≤ φ·θ ≤ upper, as far as the bounds are there, and nothing else.
    pub fn between(
        row: usize,
        regressor: [Rational; 2],
        lower: Option<Rational>,
        upper: Option<Rational>,
    ) -> Self {
        Measurement { row, regressor, bounds: Bounds::Between { lower, upper, response: None } }
    }

    /// y, if there is one.
    pub fn response(&self) -> Option<&Rational> {
        match &self.bounds {
            Bounds::Around { response, .. } => Some(response),
            Bounds::Between { response, .. } => response.as_ref(),
        }
    }

    /// y and ε of a reading that is bounded by them.
    ///
    /// # Panics
    /// When it has other bounds.
    #[allow(
        clippy::panic,
        reason = "a mistake of the caller, which asks for what kind of bound there is first"
    )]
    pub(crate) fn y_and_epsilon(&self) -> (&Rational, &Rational) {
        match &self.bounds {
            Bounds::Around { response, epsilon } => (response, epsilon),
            Bounds::Between { .. } => panic!("bounds that do not come from y"),
        }
    }

    /// What least squares takes for y: y if there is one, else the middle of both bounds. Exact.
    pub fn value(&self) -> Option<Cow<'_, Rational>> {
        self.response().map(Cow::Borrowed).or_else(|| self.middle())
    }

    /// The least value that φ·θ may have. Exact.
    pub fn lower(&self) -> Option<Rational> {
        match &self.bounds {
            Bounds::Around { response, epsilon } => Some(response - epsilon),
            Bounds::Between { lower, .. } => lower.clone(),
        }
    }

    /// The largest value that φ·θ may have. Exact.
    pub fn upper(&self) -> Option<Rational> {
        match &self.bounds {
            Bounds::Around { response, epsilon } => Some(response + epsilon),
            Bounds::Between { upper, .. } => upper.clone(),
        }
    }

    /// The middle between both bounds; `None` unless there are both. Exact.
    pub fn middle(&self) -> Option<Cow<'_, Rational>> {
        match &self.bounds {
            Bounds::Around { response, .. } => Some(Cow::Borrowed(response)),
            Bounds::Between { lower, upper, .. } => {
                Some(Cow::Owned((lower.as_ref()? + upper.as_ref()?).half()))
            }
        }
    }

    /// Half of the distance from the lower to the upper bound, negative where they cross; `None` unless there are both.
    /// Exact.
    pub fn half_width(&self) -> Option<Cow<'_, Rational>> {
        match &self.bounds {
            Bounds::Around { epsilon, .. } => Some(Cow::Borrowed(epsilon)),
            Bounds::Between { lower, upper, .. } => {
                Some(Cow::Owned((upper.as_ref()? - lower.as_ref()?).half()))
            }
        }
    }

    /// This reading within another distance of y; one with bounds that do not come from y stays as it is.
    pub fn within(mut self, bound: Rational) -> Self {
        if let Bounds::Around { epsilon, .. } = &mut self.bounds {
            *epsilon = bound;
        }
        self
    }
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
#[allow(clippy::large_enum_variant, reason = "one per fit")]
pub enum ErrorBound {
    /// One for all readings.
    Uniform(Rational),
    /// One per reading, from a column of this name.
    PerRow(String),
    /// The values between which φ·θ lies, from columns of these names, of which one may be left out.
    Interval {
        /// The column of lower bounds.
        lower: Option<String>,
        /// The column of upper bounds.
        upper: Option<String>,
    },
    /// By a law that says of each reading another one.
    Law(Law),
}

impl ErrorBound {
    /// The bound on all errors, if there is one.
    pub fn uniform(&self) -> Option<&Rational> {
        match self {
            ErrorBound::Uniform(epsilon) => Some(epsilon),
            ErrorBound::PerRow(_) | ErrorBound::Interval { .. } | ErrorBound::Law(_) => None,
        }
    }

    /// Whether all errors have one bound.
    pub fn is_uniform(&self) -> bool {
        self.uniform().is_some()
    }
}

/// What the numbers of a row mean.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Meaning {
    pub(crate) model: Model,
    pub(crate) response: String,
    /// Whether there is a column of the response.
    pub(crate) has_response: bool,
    pub(crate) error_bound: ErrorBound,
    /// The law by which the bound on all errors was stated.
    pub(crate) uniform_law: Option<Law>,
    pub(crate) form: LineForm,
    pub(crate) multiple_of_least: Option<MultipleOfLeast>,
}

/// An error bound that was not known but taken from the readings themselves: a multiple of the least one that leaves anything.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MultipleOfLeast {
    /// How many times ε_min the bound is.
    pub factor: Rational,
    /// ε_min of the readings under the conditions.
    pub least: Rational,
}

impl Meaning {
    /// Of numbers taken as they are.
    pub(crate) fn new(model: Model, response: String, error_bound: ErrorBound) -> Self {
        Meaning {
            model,
            response,
            has_response: true,
            error_bound,
            uniform_law: None,
            form: LineForm::default(),
            multiple_of_least: None,
        }
    }

    /// How many regressors are columns.
    pub(crate) fn regressors(&self) -> usize {
        if matches!(self.model, Model::Line { .. }) { 1 } else { 2 }
    }

    /// Whether every reading is given by y and an ε that is a number or a column.
    #[cfg(feature = "files")]
    pub(crate) fn is_around_y(&self) -> bool {
        match self.error_bound {
            ErrorBound::Uniform(_) | ErrorBound::PerRow(_) => true,
            ErrorBound::Interval { .. } | ErrorBound::Law(_) => false,
        }
    }

    /// Whether a summary of a line serves every error bound, since all have the same one.
    #[cfg(feature = "files")]
    pub(crate) fn is_open(&self) -> bool {
        self.regressors() == 1 && self.error_bound.is_uniform()
    }

    /// Whether the bounds of each reading are known before all readings are.
    #[cfg(feature = "files")]
    pub(crate) fn are_bounds_known(&self) -> bool {
        let law = match &self.error_bound {
            ErrorBound::Law(law) => Some(law),
            _ => self.uniform_law.as_ref(),
        };
        law.is_none_or(|law| !law.needs_range())
    }

    /// The reading in a row of columns, counted from 0, with this number in the file.
    #[cfg(feature = "files")]
    pub(crate) fn of_columns(&self, columns: &[Column], position: usize, row: usize) -> Measurement {
        self.measurement(row, columns.iter().map(|column| column.get(position)))
    }

    /// Whether a reading in columns has two bounds, whose distance a factor may multiply.
    #[cfg(feature = "files")]
    pub(crate) fn have_widths(&self, columns: &[Column]) -> bool {
        let count = columns.first().map_or(0, Column::len);
        match &self.error_bound {
            ErrorBound::Interval { lower: Some(_), upper: Some(_) } => {
                let [.., lower, _, upper] = columns else { return false };
                (0..count).any(|row| !lower.get(row).is_zero() && !upper.get(row).is_zero())
            }
            ErrorBound::Interval { .. } => false,
            _ => count > 0,
        }
    }

    /// The sums over all rows of columns. Exact. Cost: linear.
    ///
    /// # Errors
    /// When a reading has nothing that least squares could take.
    #[cfg(feature = "files")]
    pub(crate) fn sums(&self, columns: &[Column]) -> Result<Sums, NoLeastSquares> {
        let regressors = self.regressors();
        let second = (regressors == 2).then(|| &columns[1]);
        let form = |sums: Sums| if regressors == 1 { self.form.sums(sums) } else { sums };
        if self.has_response {
            return Ok(form(Sums::of_columns(&columns[0], second, &columns[regressors])));
        }
        if let Some(Halves { middles, .. }) = Halves::of_columns(self, columns) {
            return Ok(form(Sums::of_columns(&columns[0], second, &Column::Narrow(middles))));
        }
        let value = |row: usize| self.of_columns(columns, row, 0).value().map(Cow::into_owned);
        let values: Option<Column> = (0..columns[0].len()).map(value).collect();
        let values = values.ok_or(NoLeastSquares::NoResponse)?;
        Ok(form(Sums::of_columns(&columns[0], second, &values)))
    }

    /// The reading with these numbers: the regressors that are columns, the response, and the error bound if it is a
    /// column.
    pub(crate) fn measurement(&self, row: usize, mut numbers: impl Iterator<Item = Rational>) -> Measurement {
        let mut next = || numbers.next().unwrap_or_default();
        let regressor = match self.model {
            Model::Line { .. } => [next(), Rational::one()],
            Model::TwoRegressors { .. } => [next(), next()],
        };
        let response = self.has_response.then(&mut next);
        let mut side = |column: &Option<String>| {
            column.as_ref()?;
            let value = next();
            // Behind each bound stands whether it is there.
            (!next().is_zero()).then_some(value)
        };
        let bounds = match &self.error_bound {
            ErrorBound::Interval { lower, upper } => {
                Bounds::Between { lower: side(lower), upper: side(upper), response }
            }
            ErrorBound::Law(law) => {
                let written = if law.needs_written() { next() } else { Rational::zero() };
                law.bounds(&regressor[0], response.unwrap_or_default(), &written)
            }
            ErrorBound::PerRow(_) => {
                Bounds::Around { response: response.unwrap_or_default(), epsilon: next() }
            }
            ErrorBound::Uniform(epsilon) => {
                Bounds::Around { response: response.unwrap_or_default(), epsilon: epsilon.clone() }
            }
        };
        // A law is about x as it is.
        let [first, second] = regressor;
        let first = if matches!(self.model, Model::Line { .. }) { self.form.counted(first) } else { first };
        Measurement { row, regressor: [first, second], bounds }
    }

    #[cfg(feature = "files")]
    /// Adds to the bounds of readings what a law takes from all of them, when they are known: all, or of a uniform law those
    /// that support a hull.
    pub(crate) fn settle(&mut self, rows: &mut Vec<Measurement>) {
        if let ErrorBound::Law(law) = &self.error_bound {
            let range = range_of_y(rows);
            law.widen(rows, &range);
        }
        if let Some(law) = &self.uniform_law {
            let epsilon = law.uniform_bound(&range_of_y(rows));
            *rows = std::mem::take(rows).into_iter().map(|row| row.within(epsilon.clone())).collect();
            self.error_bound = ErrorBound::Uniform(epsilon);
        }
    }
}

/// The readings that are fitted, as far as they are in memory.
#[derive(Debug, Clone, PartialEq, Eq)]
#[allow(clippy::large_enum_variant, reason = "one per fit")]
pub enum Readings {
    /// Every one of them.
    All(Vec<Measurement>),
    /// Those that decide the feasible set.
    Supporting {
        /// Ascending by row: of a line under a uniform error bound the readings on the lower or the upper hull of (x, y), which
        /// decide for every bound; otherwise those with a bound that touches an envelope, and the one that the least-squares
        /// estimate misses most.
        rows: Vec<Measurement>,
        /// What else is known about all readings.
        reduction: Reduction,
    },
}

/// Where readings come from.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(crate) struct Origin {
    /// How many data rows there are, fitted or not.
    pub(crate) rows_total: usize,
    pub(crate) selection: Selection,
    pub(crate) fractions: Vec<FractionCells>,
    /// First and last of the rows fitted that follow each other without a gap, where that was asked for.
    pub(crate) ranges: Vec<[usize; 2]>,
    /// How many rows that were asked for were left out since they lack a number.
    pub(crate) rows_missing: usize,
    /// What is unusual about how the file is written, in words.
    pub(crate) written: Option<String>,
    /// The units of regressors, response and error bound, where the file states them.
    pub(crate) units: Vec<Option<String>>,
    #[cfg(feature = "files")]
    pub(crate) layout: Option<TextLayout>,
    pub(crate) sha256: Option<String>,
}

/// The readings of a fit.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Measurements {
    pub(crate) meaning: Meaning,
    pub(crate) readings: Readings,
    /// Readings that are not fitted, to be shown.
    pub(crate) others: Vec<Measurement>,
    pub(crate) origin: Origin,
}

impl Measurements {
    /// Readings that do not come from a file.
    pub fn new(model: Model, response: String, error_bound: ErrorBound, rows: Vec<Measurement>) -> Self {
        Measurements::of_meaning(Meaning::new(model, response, error_bound), rows)
    }

    /// Readings that do not come from a file, with numbers of this meaning.
    pub(crate) fn of_meaning(meaning: Meaning, rows: Vec<Measurement>) -> Self {
        let origin = Origin { rows_total: rows.len(), ..Origin::default() };
        Measurements { meaning, readings: Readings::All(rows), others: Vec::new(), origin }
    }

    /// The model.
    pub fn model(&self) -> &Model {
        &self.meaning.model
    }

    /// How lines are written down; of a model with two regressors it says nothing.
    pub fn line_form(&self) -> &LineForm {
        &self.meaning.form
    }

    /// These readings as readings of lines of this form: their x are counted from its origin, wherever they were counted from
    /// before. Of a model with two regressors nothing changes. Exact.
    ///
    /// # Panics
    /// When the origin is another one and not every reading is in memory; [`Columns::form`](crate::Columns::form) is for those.
    #[allow(clippy::panic, reason = "documented: a mistake of the caller, which no input can make")]
    pub fn with_form(mut self, form: LineForm) -> Self {
        if matches!(self.meaning.model, Model::TwoRegressors { .. }) {
            return self;
        }
        let by = LineForm { x_origin: &form.x_origin - &self.meaning.form.x_origin, ..form };
        if !by.x_origin.is_zero() {
            let Readings::All(rows) = &mut self.readings else {
                panic!("another origin of readings that are not in memory");
            };
            by.count_rows(rows);
            by.count_rows(&mut self.others);
        }
        self.meaning.form = form;
        self
    }

    /// The multiple of ε_min that the error bound is, if it was taken from these readings.
    pub fn multiple_of_least(&self) -> Option<&MultipleOfLeast> {
        self.meaning.multiple_of_least.as_ref()
    }

    /// These readings under a multiple of the least error bound, in the place of theirs.
    pub(crate) fn within_multiple(mut self, multiple: MultipleOfLeast) -> Self {
        let epsilon = &multiple.factor * &multiple.least;
        let rows = match &mut self.readings {
            Readings::All(rows) | Readings::Supporting { rows, .. } => rows,
        };
        for row in rows.iter_mut().chain(&mut self.others) {
            *row = row.clone().within(epsilon.clone());
        }
        self.meaning.error_bound = ErrorBound::Uniform(epsilon);
        self.meaning.multiple_of_least = Some(multiple);
        self
    }

    /// The name of the response.
    pub fn response(&self) -> &str {
        &self.meaning.response
    }

    /// Whether the response is a column, and not only a name for what lies between two bounds.
    pub fn has_response(&self) -> bool {
        self.meaning.has_response
    }

    /// The largest less the smallest y of the readings in memory. Exact.
    pub fn range_of_response(&self) -> Rational {
        range_of_y(self.kept())
    }

    /// Whether a reading in memory has two bounds, whose distance a factor may multiply.
    pub fn has_widths(&self) -> bool {
        match &self.readings {
            Readings::All(rows) => rows.is_empty() || rows.iter().any(|row| row.half_width().is_some()),
            Readings::Supporting { reduction, .. } => reduction.has_widths,
        }
    }

    /// The law by which the error bounds were stated, if it was one.
    pub fn law(&self) -> Option<&Law> {
        match &self.meaning.error_bound {
            ErrorBound::Law(law) => Some(law),
            _ => self.meaning.uniform_law.as_ref(),
        }
    }

    /// Where the error bounds come from.
    pub fn error_bound(&self) -> &ErrorBound {
        &self.meaning.error_bound
    }

    /// Whether every reading in memory lies within an ε of its y.
    pub(crate) fn is_around_y(&self) -> bool {
        self.kept().iter().all(|row| matches!(row.bounds, Bounds::Around { .. }))
    }

    /// Whether the two hulls of the readings tell which of them can bound anything.
    pub(crate) fn has_hulls(&self) -> bool {
        matches!(self.model(), Model::Line { .. }) && self.error_bound().is_uniform() && self.is_around_y()
    }

    /// The readings that are fitted, and whether all of them are in memory.
    pub fn readings(&self) -> &Readings {
        &self.readings
    }

    /// Every reading that is fitted; `None` when only those that support a hull are in memory.
    pub fn all(&self) -> Option<&[Measurement]> {
        match &self.readings {
            Readings::All(rows) => Some(rows),
            Readings::Supporting { .. } => None,
        }
    }

    /// The readings that decide ε_min.
    ///
    /// # Errors
    /// Why they are not known.
    pub fn deciding_minimax(&self) -> Result<&[Measurement], NoMinimax> {
        match &self.readings {
            Readings::All(rows) => Ok(rows),
            Readings::Supporting { rows, reduction } => match &reduction.minimax {
                DecidingMinimax::Kept => Ok(rows),
                DecidingMinimax::Own(rows) => Ok(rows),
                DecidingMinimax::Unknown(reason) => Err(*reason),
            },
        }
    }

    /// Whether the reading that any θ, or the least-squares estimate at least, misses most is among those in memory.
    pub(crate) fn have_tightest(&self) -> bool {
        match &self.readings {
            Readings::All(_) => true,
            Readings::Supporting { reduction, .. } => {
                self.meaning.regressors() == 1 || !matches!(reduction.minimax, DecidingMinimax::Unknown(_))
            }
        }
    }

    /// Whether the readings in memory decide for every multiple of their error bounds.
    pub fn are_open(&self) -> bool {
        match &self.readings {
            Readings::All(_) => true,
            Readings::Supporting { reduction, .. } => reduction.minimax == DecidingMinimax::Kept,
        }
    }

    /// The readings in memory: all of them, or those that decide the feasible set.
    pub fn kept(&self) -> &[Measurement] {
        match &self.readings {
            Readings::All(rows) | Readings::Supporting { rows, .. } => rows,
        }
    }

    /// Whether the rows were read from reductions, which number them anew.
    pub fn is_of_reductions(&self) -> bool {
        matches!(
            self.readings,
            Readings::Supporting { reduction: Reduction { reach: Err(NoEui::Reduced), .. }, .. }
        )
    }

    /// How many readings are fitted, kept or not.
    pub fn fitted(&self) -> usize {
        match &self.readings {
            Readings::All(rows) => rows.len(),
            Readings::Supporting { reduction, .. } => reduction.count,
        }
    }

    /// Readings of the file that are not fitted, kept where the table was read with
    /// [`TableOptions::keep_others`](boundfit_formats::TableOptions::keep_others).
    pub fn others(&self) -> &[Measurement] {
        &self.others
    }

    /// How many data rows the file has.
    pub fn rows_total(&self) -> usize {
        self.origin.rows_total
    }

    /// Which rows of the file were asked for.
    pub fn selection(&self) -> &Selection {
        &self.origin.selection
    }

    /// The columns in which cells are fractions such as `3/4`.
    pub fn fractions(&self) -> &[FractionCells] {
        &self.origin.fractions
    }

    /// Which data rows of the file are fitted: first and last of those that follow each other without a gap. Empty where the
    /// readings do not come from a file, or were read without
    /// [`ScanOptions::list_rows`](boundfit_formats::ScanOptions::list_rows).
    pub fn fitted_rows(&self) -> &[[usize; 2]] {
        &self.origin.ranges
    }

    /// How many rows that were asked for were left out since they lack a number.
    pub fn rows_missing(&self) -> usize {
        self.origin.rows_missing
    }

    /// What is unusual about how the file is written, such as `decimal comma, separated by semicolons`; `None` of text that is
    /// as usual, and of what is no text.
    pub fn written(&self) -> Option<&str> {
        self.origin.written.as_deref()
    }

    /// The unit that the file states for a column: regressors, response and, with one per row, error bound, from 0.
    pub fn unit(&self, column: usize) -> Option<&str> {
        self.origin.units.get(column)?.as_deref()
    }

    /// Where in the file the numbers stand: regressors, response and, with one per row, error bound; `None` unless the
    /// readings come from delimited text that has a row for each of them.
    #[cfg(feature = "files")]
    pub fn layout(&self) -> Option<&TextLayout> {
        self.origin.layout.as_ref()
    }

    /// SHA-256 of the file's bytes in hexadecimal, when the readings come from a file.
    pub fn sha256(&self) -> Option<&str> {
        self.origin.sha256.as_deref()
    }
}
