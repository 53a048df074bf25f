//! The readings of a fit, and where they come from.

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};

use boundfit_exact::{Foreign, Rational};
#[cfg(feature = "files")]
use boundfit_formats::{TableNotes, TextLayout};
use boundfit_geometry::Tally;

use crate::deciding::{DecidingRows, OnGrid};
#[cfg(feature = "files")]
use crate::files::InColumns;
use crate::law::{Law, range_of_y};
use crate::line_form::LineForm;
use crate::meaning::{ErrorBound, Meaning, Model, MultipleOfLeast};
use crate::measurement::{Bounds, Measurement};
use crate::reduction::{DecidingMinimax, NoEui, NoMinimax, Reduction};
use crate::selection::{FractionCells, Selection};
use crate::ties::Ties;

/// The readings that are fitted, as far as they are in memory.
#[derive(Debug, Clone, PartialEq, Eq)]
#[allow(clippy::large_enum_variant, reason = "one per fit")]
pub enum Readings {
    /// Every one of them.
    All(Vec<Measurement>),
    /// The readings that decide the feasible set.
    Supporting {
        /// The readings, ascending by row. A line under a uniform error bound has the readings on the lower or the
        /// upper hull of (x, y), which decide for every bound. The first represents readings at one corner or
        /// strictly within one edge. Other models have the readings with a bound that touches an envelope, the first
        /// of those that say the same, and the reading that the least-squares estimate misses most. For two
        /// regressors under a uniform error bound, one reading may stand for all that go through one vertex of an
        /// envelope.
        rows: DecidingRows,
        /// The number of readings that each of these stands for.
        ties: Ties,
        /// The other facts about all readings.
        reduction: Reduction,
    },
    /// Every one of them, equal ones once.
    Counted {
        /// The first of those that are equal, ascending by row.
        rows: Vec<Measurement>,
        /// The readings that each of these stands for: all are listed.
        ties: Ties,
        /// The other facts about all readings.
        reduction: Reduction,
    },
}

/// The source of readings.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(crate) struct Origin {
    /// The number of data rows, fitted or not.
    pub(crate) rows_total: usize,
    pub(crate) selection: Selection,
    pub(crate) fractions: Vec<FractionCells>,
    /// First and last of the rows fitted that follow each other without a gap, where that was asked for.
    pub(crate) ranges: Vec<[usize; 2]>,
    /// The number of rows that were asked for but lack a number.
    pub(crate) rows_missing: usize,
    /// The format in which the table was read.
    #[cfg(feature = "files")]
    pub(crate) table: Option<TableNotes>,
    /// The units of regressors, response and error bound, where the file states them.
    pub(crate) units: Vec<Option<Foreign>>,
    /// The texts of the cells of each row, by its number, where they were kept.
    pub(crate) cells: BTreeMap<usize, Vec<String>>,
    #[cfg(feature = "files")]
    pub(crate) layout: Option<TextLayout>,
    pub(crate) sha256: Option<String>,
    /// The readings in their columns, where only some of them are kept as numbers.
    #[cfg(feature = "files")]
    pub(crate) in_columns: Option<InColumns>,
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
    pub fn new(model: Model, response: Foreign, error_bound: ErrorBound, rows: Vec<Measurement>) -> Self {
        Measurements::of_meaning(Meaning::new(model, response, error_bound), rows)
    }

    /// Readings that do not come from a file, each of which stands for so many that are equal to it, itself included.
    pub fn counted(
        model: Model,
        response: Foreign,
        error_bound: ErrorBound,
        rows: Vec<Measurement>,
        counts: &[u64],
    ) -> Self {
        let mut ties = Ties::default();
        for (reading, &count) in rows.iter().zip(counts) {
            ties.insert(reading.row, Tally::counted(reading.row as u64, count));
        }
        Measurements::of_counted(Meaning::new(model, response, error_bound), rows, ties)
    }

    /// Readings of which each stands for others equal to it, with numbers of this meaning.
    pub(crate) fn of_counted(meaning: Meaning, rows: Vec<Measurement>, ties: Ties) -> Self {
        let reduction = Reduction::of_counted(&meaning, &rows, &ties);
        Measurements::of_readings(meaning, Readings::Counted { rows, ties, reduction })
    }

    /// Readings that do not come from a file, with numbers of this meaning.
    pub(crate) fn of_readings(meaning: Meaning, readings: Readings) -> Self {
        let mut own = Measurements { meaning, readings, others: Vec::new(), origin: Origin::default() };
        own.origin.rows_total = own.fitted();
        own
    }

    /// Every one of some readings that do not come from a file, with numbers of this meaning.
    pub(crate) fn of_meaning(meaning: Meaning, rows: Vec<Measurement>) -> Self {
        Measurements::of_readings(meaning, Readings::All(rows))
    }

    /// The readings at these positions of [`Measurements::kept`] alone, ascending; the rest of those are to be shown but not
    /// fitted where that is asked for, and are left out otherwise. Cost: linear in what is taken.
    pub fn only(&self, positions: &[usize], shows_rest: bool) -> Self {
        let rows = self.kept();
        let fitted = positions.iter().filter_map(|&position| rows.get(position)).cloned().collect();
        let mut others = Vec::new();
        if shows_rest {
            let is_left_out =
                |(position, _): &(usize, &Measurement)| positions.binary_search(position).is_err();
            let rest = rows.iter().enumerate().filter(is_left_out).map(|(_, row)| row.clone());
            others = self.others.iter().cloned().chain(rest).collect();
        }
        let (meaning, origin) = (self.meaning.clone(), self.origin.clone());
        Measurements { meaning, readings: Readings::All(fitted), others, origin }
    }

    /// The model.
    pub fn model(&self) -> &Model {
        &self.meaning.model
    }

    /// Returns how lines are written down; of a model with two regressors it says nothing.
    pub fn line_form(&self) -> &LineForm {
        &self.meaning.form
    }

    /// These readings as readings of lines of this form: their x are counted from its origin, wherever they were
    /// counted from before. A model with two regressors stays as it is. Exact.
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
        let epsilon = multiple.bound();
        let within = |rows: &mut Vec<Measurement>| {
            rows.iter_mut().for_each(|row| *row = row.clone().within(epsilon.clone()));
        };
        match &mut self.readings {
            Readings::All(rows) | Readings::Counted { rows, .. } => within(rows),
            Readings::Supporting { rows, .. } => rows.set_bound(&epsilon),
        }
        within(&mut self.others);
        self.meaning.error_bound = ErrorBound::Uniform(epsilon);
        self.meaning.multiple_of_least = Some(multiple);
        self
    }

    /// The name of the response.
    pub fn response(&self) -> &Foreign {
        &self.meaning.response
    }

    /// The name of the error in formulas: `e`, unless a column beside it has that name.
    pub fn error_name(&self) -> &'static str {
        let regressors = self.model().regressors();
        let bound = match self.error_bound() {
            ErrorBound::Column(column) => Some(column),
            _ => None,
        };
        let is_taken = |name: &str| {
            regressors.iter().chain([self.response()]).chain(bound).any(|column| column.raw() == name)
        };
        ["e", "error", "noise"].into_iter().find(|name| !is_taken(name)).unwrap_or("residual")
    }

    /// The name of y, and a law as it was written. If another column has the name `x` or `y`, names of columns stand in place of
    /// x and y: `|U|`.
    pub fn law_in_names(&self, law: &Law) -> [Foreign; 2] {
        law.in_names_of(self.model().regressors(), self.response())
    }

    /// Returns whether the response is a column, and not only a name for what lies between two bounds.
    pub fn has_response(&self) -> bool {
        self.meaning.has_response
    }

    /// The largest less the smallest y of the readings in memory. Exact.
    pub fn range_of_response(&self) -> Rational {
        range_of_y(self.kept())
    }

    /// Returns the least and the largest x of the readings of a line, as x is counted. Returns `None` if there are no
    /// readings, or if the readings in memory need not include these x; the hulls of a line under one error bound
    /// include both. Exact.
    pub fn range_of_x(&self) -> Option<[Rational; 2]> {
        let x = || self.kept().iter().map(|reading| &reading.regressor[0]);
        Some([x().min()?.clone(), x().max()?.clone()]).filter(|_| self.has_every_hull())
    }

    /// Returns whether the readings in memory are all, or include those on the hulls of a line under one error bound.
    pub fn has_every_hull(&self) -> bool {
        self.every().is_some() || (self.are_open() && self.has_hulls())
    }

    /// Returns whether a reading in memory has two bounds, whose distance a factor may multiply.
    pub fn has_widths(&self) -> bool {
        let is_of_all = || self.kept().is_empty() || self.kept().iter().any(Measurement::is_two_sided);
        self.reduction().map_or_else(is_of_all, |reduction| reduction.has_widths)
    }

    /// The law by which the error bounds were stated, if it was one.
    pub fn law(&self) -> Option<&Law> {
        match &self.meaning.error_bound {
            ErrorBound::Law(law) => Some(law),
            _ => self.meaning.uniform_law.as_ref(),
        }
    }

    /// Returns where the error bounds come from.
    pub fn error_bound(&self) -> &ErrorBound {
        &self.meaning.error_bound
    }

    /// Returns whether every reading in memory lies within an ε of its y.
    pub(crate) fn is_around_y(&self) -> bool {
        let is_around = |row: &Measurement| matches!(row.bounds, Bounds::Around { .. });
        self.on_grid().is_some() || self.kept().iter().all(is_around)
    }

    /// Returns whether the two hulls of the readings tell which of them can bound anything.
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
            Readings::Supporting { .. } | Readings::Counted { .. } => None,
        }
    }

    /// Every reading that is fitted, equal ones maybe once, with what these stand for; `None` when only those that support a hull
    /// are in memory.
    pub fn every(&self) -> Option<(&[Measurement], Cow<'_, Ties>)> {
        match &self.readings {
            Readings::All(rows) => Some((rows, Cow::Owned(Ties::default()))),
            Readings::Counted { rows, ties, .. } => Some((rows, Cow::Borrowed(ties))),
            Readings::Supporting { .. } => None,
        }
    }

    /// The readings of these data rows, ascending, as far as they are in memory.
    pub fn readings_of<'a>(&'a self, rows: &'a [usize]) -> Vec<(usize, &'a Measurement)> {
        let kept = self.kept();
        let Some(ties) = self.ties() else {
            let own = |&row: &usize| {
                let place = kept.binary_search_by_key(&row, |reading| reading.row).ok()?;
                Some((row, kept.get(place)?))
            };
            return rows.iter().filter_map(own).collect();
        };
        // Among equal readings the first is among these rows, or none is.
        let is_asked = |row: usize| rows.binary_search(&row).is_ok();
        let asked = kept.iter().filter(|reading| is_asked(reading.row));
        let of_rows = asked.flat_map(|reading| {
            ties.rows(reading.row).filter(|&row| is_asked(row)).map(move |row| (row, reading))
        });
        let mut found: Vec<(usize, &Measurement)> = of_rows.collect();
        found.sort_by_key(|(row, _)| *row);
        found
    }

    /// The readings without those of some rows, ascending: of equal ones the first that is left.
    pub fn without(&self, rows: &BTreeSet<usize>) -> Vec<Measurement> {
        let ties = self.ties();
        let first_left = |reading: &Measurement| match ties {
            Some(ties) => ties.rows(reading.row).find(|row| !rows.contains(row)),
            None => Some(reading.row).filter(|row| !rows.contains(row)),
        };
        let left = |reading: &Measurement| Some(Measurement { row: first_left(reading)?, ..reading.clone() });
        let mut left: Vec<Measurement> = self.kept().iter().filter_map(left).collect();
        left.sort_by_key(|reading| reading.row);
        left
    }

    /// These readings alone, of those in memory, with what they stand for, as far as reports list it.
    #[must_use]
    pub fn of_kept(&self, rows: Vec<Measurement>) -> Self {
        let meaning = Meaning::new(self.model().clone(), self.response().clone(), self.error_bound().clone());
        let ties =
            self.ties().map(|ties| ties.among(rows.iter().map(|reading| reading.row), Ties::MOST_LISTED));
        match ties.filter(|ties| !ties.is_empty()) {
            Some(ties) => Measurements::of_counted(meaning, rows, ties),
            None => Measurements::of_meaning(meaning, rows),
        }
    }

    /// The readings that decide ε_min.
    ///
    /// # Errors
    /// Why they are not known.
    pub fn deciding_minimax(&self) -> Result<&[Measurement], NoMinimax> {
        match self.minimax() {
            DecidingMinimax::Kept => Ok(self.kept()),
            DecidingMinimax::Own(rows) => Ok(rows),
            DecidingMinimax::Unknown(reason) => Err(*reason),
        }
    }

    /// Returns which readings decide ε_min. Cost: constant.
    fn minimax(&self) -> &DecidingMinimax {
        self.reduction().map_or(&DecidingMinimax::Kept, |reduction| &reduction.minimax)
    }

    /// The reason why the readings that decide ε_min are not known; `None` where they are. Cost: constant.
    pub fn unknown_minimax(&self) -> Option<NoMinimax> {
        match self.minimax() {
            DecidingMinimax::Kept | DecidingMinimax::Own(_) => None,
            DecidingMinimax::Unknown(reason) => Some(*reason),
        }
    }

    /// Returns whether the reading that any θ, or the least-squares estimate at least, misses most is among those in memory.
    pub(crate) fn have_tightest(&self) -> bool {
        self.meaning.regressors() == 1 || self.unknown_minimax().is_none()
    }

    /// Returns whether the readings in memory decide for every multiple of their error bounds.
    pub fn are_open(&self) -> bool {
        *self.minimax() == DecidingMinimax::Kept
    }

    /// The readings in memory: all of them, or those that decide the feasible set.
    pub fn kept(&self) -> &[Measurement] {
        match &self.readings {
            Readings::All(rows) | Readings::Counted { rows, .. } => rows,
            Readings::Supporting { rows, .. } => rows,
        }
    }

    /// The number of readings in memory. Cost: constant.
    pub fn kept_count(&self) -> usize {
        match &self.readings {
            Readings::All(rows) | Readings::Counted { rows, .. } => rows.len(),
            Readings::Supporting { rows, .. } => rows.len(),
        }
    }

    /// The readings in memory as integers, where they are on a grid and nobody need look at them as numbers.
    pub(crate) fn on_grid(&self) -> Option<&OnGrid> {
        match &self.readings {
            Readings::All(_) | Readings::Counted { .. } => None,
            Readings::Supporting { rows, .. } => rows.on_grid(),
        }
    }

    /// The reading in memory at a position, whatever form it has there.
    pub(crate) fn kept_at(&self, position: usize) -> Cow<'_, Measurement> {
        match self.on_grid() {
            Some(grid) => Cow::Owned(grid.reading(position)),
            None => Cow::Borrowed(&self.kept()[position]),
        }
    }

    /// Returns which of the readings in memory stand for more than themselves; `None` where all are in memory.
    pub fn ties(&self) -> Option<&Ties> {
        match &self.readings {
            Readings::All(_) => None,
            Readings::Supporting { ties, .. } | Readings::Counted { ties, .. } => Some(ties),
        }
    }

    /// The other facts about all readings; `None` where each is in memory for itself.
    pub(crate) fn reduction(&self) -> Option<&Reduction> {
        match &self.readings {
            Readings::All(_) => None,
            Readings::Supporting { reduction, .. } | Readings::Counted { reduction, .. } => Some(reduction),
        }
    }

    /// Returns whether the rows were read from reductions, which number them anew.
    pub fn is_of_reductions(&self) -> bool {
        self.reduction().is_some_and(|reduction| matches!(reduction.reach, Err(NoEui::Reduced)))
    }

    /// Returns how many readings are fitted, kept or not.
    pub fn fitted(&self) -> usize {
        self.reduction().map_or_else(|| self.kept_count(), |reduction| reduction.count)
    }

    /// Readings of the file that are not fitted, kept where the table was read with
    /// [`TableOptions::keep_others`](boundfit_formats::TableOptions::keep_others).
    pub fn others(&self) -> &[Measurement] {
        &self.others
    }

    /// Returns how many data rows the file has.
    pub fn rows_total(&self) -> usize {
        self.origin.rows_total
    }

    /// Returns which rows of the file were asked for.
    pub fn selection(&self) -> &Selection {
        &self.origin.selection
    }

    /// The columns in which cells are fractions such as `3/4`.
    pub fn fractions(&self) -> &[FractionCells] {
        &self.origin.fractions
    }

    /// Returns which data rows of the file are fitted: first and last of those that follow each other without a gap. Empty where the
    /// readings do not come from a file, or were read without
    /// [`ScanOptions::list_rows`](boundfit_formats::ScanOptions::list_rows).
    pub fn fitted_rows(&self) -> &[[usize; 2]] {
        &self.origin.ranges
    }

    /// Returns how many rows that were asked for were left out since they lack a number.
    pub fn rows_missing(&self) -> usize {
        self.origin.rows_missing
    }

    /// The texts of the cells of a row, fitted or not, as they are written in the file: regressors, response and, where they are
    /// columns, error bounds. `None` unless the table was read with
    /// [`TableOptions::keep_cells`](boundfit_formats::TableOptions::keep_cells) and is text.
    pub fn cells(&self, row: usize) -> Option<&[String]> {
        self.origin.cells.get(&row).map(Vec::as_slice)
    }

    /// The unit that the file states for a column: regressors, response and, with one per row, error bound, from 0.
    pub fn unit(&self, column: usize) -> Option<&Foreign> {
        self.origin.units.get(column)?.as_ref()
    }

    /// The units that the file states of x, which two regressors share, and of y.
    pub fn plane_units(&self) -> [Option<&Foreign>; 2] {
        match self.model() {
            Model::Line { .. } => [self.unit(0), self.unit(1)],
            Model::TwoRegressors { .. } => {
                [self.unit(0).filter(|unit| self.unit(1) == Some(unit)), self.unit(2)]
            }
        }
    }

    /// SHA-256 of the file's bytes in hexadecimal, when the readings come from a file.
    pub fn sha256(&self) -> Option<&str> {
        self.origin.sha256.as_deref()
    }
}
