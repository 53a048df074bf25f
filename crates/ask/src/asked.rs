//! The readings that something is asked of.

use std::sync::Arc;

use boundfit_estimation::{EpsilonColumn, Keep, Measurements, Problem, Question};
use boundfit_exact::{Rational, Work};
use boundfit_formats::{ColumnSelector, ScanOptions, Source, TableOptions};
use boundfit_questions::{Agreement, XBounds, XErrorProblem, times};
use boundfit_report::rows_left_out;

use crate::form::Shows;
use crate::misuse::Misuse;
use crate::refusal::Refusal;
use crate::tables::Tables;

/// The readings that something is asked of: columns, bounds and conditions, and the dialect of the table.
#[derive(Clone)]
pub struct Asked {
    /// The columns, the bounds on the errors, and what is known of the parameters besides.
    pub question: Question,
    /// The errors of x, where it has any.
    pub x_errors: Option<XErrors>,
    /// The options for reading the table, and the limits.
    pub options: ScanOptions,
    /// The place of further tables that a question names; none by default.
    pub tables: Option<Arc<dyn Tables>>,
}

/// Bounds on the errors of x, and which lines agree with readings under them.
#[derive(Debug, Clone)]
pub struct XErrors {
    /// The bounds.
    pub bounds: AskedXBounds,
    /// The agreement that is asked for: for some x that the bounds allow, or for all of them.
    pub agreement: Agreement,
}

/// The bounds on the errors of x.
#[derive(Debug, Clone)]
pub enum AskedXBounds {
    /// One for all readings.
    Uniform(Rational),
    /// A column with the bound of each reading.
    Column(ColumnSelector),
}

impl Asked {
    /// Bytes that the budget counts for each reading of a fit that is kept.
    pub const ROW_COST: usize = 400;

    /// Asked of a table that is read in the usual way, whose x have no errors.
    pub fn new(question: Question) -> Self {
        Asked { question, x_errors: None, options: ScanOptions::default(), tables: None }
    }

    /// Returns the place of further tables.
    pub(crate) fn tables(&self) -> Result<&dyn Tables, Refusal> {
        self.tables.as_deref().ok_or(Refusal::Misuse(Misuse::NoTables))
    }

    /// Returns the limit on the work on long numbers.
    pub fn most_work(&self) -> u64 {
        self.options.table.sizes.work
    }

    /// Returns the options for reading the table where a reading that is held takes `row_cost` bytes.
    pub(crate) fn held(&self, row_cost: usize, shows: Shows) -> ScanOptions {
        let own = self.options.clone();
        let (hash, list_rows) = (own.hash && shows >= Shows::Hash, own.list_rows && shows >= Shows::Rows);
        ScanOptions { hash, list_rows, table: TableOptions { row_cost, ..own.table }, ..own }
    }

    /// The problem of readings, which are not too long for a fit.
    fn problem(&self, measurements: Measurements) -> Result<Problem, Refusal> {
        Ok(self.question.problem_within(measurements, self.most_work())?)
    }

    /// Reads the readings in memory that does not grow with the table beyond what `keep` says.
    ///
    /// # Errors
    /// When the table cannot be read, its numbers are too long, or it has other bounds than those that are asked for.
    pub fn scanned(
        &self,
        source: Source,
        (row_cost, shows): (usize, Shows),
        keep: Keep,
    ) -> Result<Problem, Refusal> {
        self.refuse_moving(&source)?;
        let measurements = self.question.measurements(source, &self.held(row_cost, shows), keep)?;
        self.problem(measurements)
    }

    /// Reads the readings that this says how to read, with what it says to keep of each.
    ///
    /// # Errors
    /// Errors are those of [`Asked::scanned`].
    pub fn read(&self, source: Source, table: &TableOptions) -> Result<Problem, Refusal> {
        self.refuse_moving(&source)?;
        self.problem(Measurements::read(source, &self.question.columns, table)?)
    }

    /// Reads every reading. Refuses reductions, which have them no more.
    pub(crate) fn every_reading(
        &self,
        source: Source,
        row_cost: usize,
        shows: Shows,
        ask: &'static str,
    ) -> Result<Problem, Refusal> {
        let keep = Keep { eui: false, ..Keep::EVERY };
        let problem = self.scanned(source, (row_cost, shows), keep)?;
        match problem.measurements.is_of_reductions() {
            true => Err(Refusal::Reduction { ask }),
            false => Ok(problem),
        }
    }

    /// Reads as [`Asked::every_reading`] does; equal readings are kept once where there are many.
    pub(crate) fn counted_readings(
        &self,
        source: Source,
        row_cost: usize,
        shows: Shows,
        ask: &'static str,
    ) -> Result<Problem, Refusal> {
        self.refuse_moving(&source)?;
        if source.is_reduction() {
            return Err(Refusal::Reduction { ask });
        }
        let options = self.held(row_cost, shows);
        let read = Measurements::read_counted(source, &self.question.columns, &[], &options, Keep::MOST_ROWS);
        self.problem(read?.0)
    }

    /// Reads the readings with the bounds on the errors of x; where it is asked for those that are not fitted too, for pictures.
    ///
    /// # Errors
    /// When errors of x and what else is asked exclude each other, the table cannot be read, or its numbers are too long.
    pub fn x_error_problem(
        &self,
        source: Source,
        row_cost: usize,
        shows: Shows,
        keep_others: bool,
    ) -> Result<XErrorProblem, Refusal> {
        let asked = self.x_errors.as_ref().ok_or(Refusal::Misuse(Misuse::NoXErrors))?;
        if self.question.columns.second.is_some() {
            return Err(Refusal::Misuse(Misuse::XErrorsOfTwoRegressors));
        }
        if self.question.multiple_of_least.is_some() {
            return Err(Refusal::Misuse(Misuse::LeastBesideXErrors));
        }
        if source.is_reduction() {
            return Err(Refusal::Reduction { ask: "fit-x-errors" });
        }
        let beside: Vec<ColumnSelector> = match &asked.bounds {
            AskedXBounds::Column(column) => vec![column.clone().non_negative()],
            AskedXBounds::Uniform(_) => Vec::new(),
        };
        let columns = &self.question.columns;
        let mut options = self.held(row_cost, shows);
        options.table.keep_others = keep_others;
        let are_alike = beside.is_empty() && matches!(columns.epsilon, EpsilonColumn::Uniform(_));
        let (measurements, mut further) = match keep_others {
            true => Measurements::read_beside(source, columns, &beside, &options.table)?,
            // Only those on the hulls decide of very many readings.
            false if are_alike => {
                let keep = Keep { eui: false, ..Keep::DECIDING };
                let options = self.held(Self::ROW_COST, shows);
                (self.question.measurements(source, &options, keep)?, Vec::new())
            }
            false => Measurements::read_counted(source, columns, &beside, &options, Keep::MOST_ROWS)?,
        };
        let bounds = match &asked.bounds {
            AskedXBounds::Uniform(bound) => XBounds::Uniform(bound.clone()),
            AskedXBounds::Column(column) => {
                XBounds::PerRow { column: column.text().clone(), bounds: further.pop().unwrap_or_default() }
            }
        };
        let problem = XErrorProblem::new(self.problem(measurements)?, bounds, asked.agreement);
        let problem = problem.map_err(|error| Refusal::XErrors(error.to_string()))?;
        let mut work = Work::default();
        for (row, width) in problem.readings() {
            let numbers = [row.lower(), row.upper()];
            work.add(row.row, row.regressor.iter().chain(numbers.iter().flatten()).chain([width]));
        }
        work.check(times::X_ERRORS, self.most_work())?;
        work.of_every_word().check(times::X_ERROR_STEPS, self.most_work())?;
        Ok(problem)
    }

    fn refuse_moving(&self, source: &Source) -> Result<(), Refusal> {
        match self.question.moves_fixed_bounds(source) {
            true => Err(Refusal::Misuse(Misuse::LeastOfFixed)),
            false => Ok(()),
        }
    }
}

/// Lines below many answers: about the rows that are left out since they lack a number, and others.
pub(crate) fn remarks(rows_missing: usize, more: impl IntoIterator<Item = String>) -> String {
    rows_left_out(rows_missing).into_iter().chain(more).map(|line| line + "\n").collect()
}

/// The assumption that a multiple of ε_min of these readings makes.
pub(crate) fn assumed(factor: &Rational, whose: &str) -> String {
    let times = if *factor == Rational::one() { String::new() } else { format!("{factor} times ") };
    format!(
        "Assumed: no error is larger than {times}eps_min of {whose}, a bound found from these very readings"
    )
}
