//! The statements of reductions about all their readings, and the check that they serve the question.

use boundfit_exact::{Foreign, Limits};
use boundfit_formats::{
    AskedReduction, InputError, ReducedBounds, ReducedModel, ReductionError, Reductions, ScanOptions,
};

use crate::meaning::{ErrorBound, Meaning, Model};
use crate::moments::Sums;
use crate::reduction::NoLeastSquares;

/// The number of times as many digits as a reading that a sum may have. Squares have twice as many digits, and the
/// digits of fractions come on top.
const DIGITS_OF_SUMS: usize = 10;

/// The statements of successive reductions about all their readings.
pub(super) struct Stated {
    /// The number of readings.
    pub(super) count: usize,
    /// The sums, with x as it is.
    pub(super) sums: Result<Sums, NoLeastSquares>,
    /// True if a reading has two bounds.
    pub(super) has_widths: bool,
    /// True if the rows decide under every multiple of the bounds.
    pub(super) is_open: bool,
    /// True if the rows decide under every bound that all readings have: then nothing lies beyond them.
    pub(super) is_hull: bool,
}

impl Stated {
    /// Returns what reductions of this file say, if they serve what is asked for.
    ///
    /// # Errors
    /// The first thing in which one of them does not.
    pub(super) fn of(
        reductions: &Reductions,
        file: &Foreign,
        asked: &AskedReduction,
        options: &ScanOptions,
    ) -> Result<Self, InputError> {
        let fail = |error: ReductionError| InputError::of_file(file, error);
        if options.table.selects_rows() {
            return Err(fail(ReductionError::NoRowNumbers));
        }
        let digits = options.table.limits.digits.saturating_mul(DIGITS_OF_SUMS);
        let limits = Limits { digits, exponent: 0 };
        let mut total =
            Stated { count: 0, sums: Ok(Sums::default()), has_widths: false, is_open: false, is_hull: false };
        for record in reductions.records() {
            record.check(asked, options.table.reading).map_err(fail)?;
            let count = total.count.checked_add(record.rows);
            total.count = count.ok_or_else(|| fail(ReductionError::TooManyRows))?;
            let sums = record.sums(&limits).map_err(fail)?.map(|sums| Sums::new(record.rows, sums));
            total.sums = total.sums.and_then(|own| Ok(own.merged(&sums.ok_or(NoLeastSquares::NoResponse)?)));
            total.has_widths |= record.widths;
            // They do not differ in this.
            total.is_open = matches!(record.model.bounds, ReducedBounds::Any | ReducedBounds::Multiples(_));
            total.is_hull = record.model.bounds == ReducedBounds::Any;
        }
        Ok(total)
    }
}

/// Returns how many readings each row of reductions stands for, of so many rows; `None` where they do not say so.
///
/// # Errors
/// When it is not known which row is which.
pub(super) fn counts_of(
    reductions: &Reductions,
    file: &Foreign,
    rows: usize,
) -> Result<Option<Vec<u64>>, InputError> {
    reductions.counts(rows).map_err(|error| InputError::of_file(file, error))
}

/// Returns what a fit asks of a reduction.
pub(super) fn asked_by_fit(meaning: &Meaning) -> AskedReduction {
    let regressors = match &meaning.model {
        Model::Line { x } => vec![x.clone()],
        Model::TwoRegressors { regressors } => regressors.to_vec(),
    };
    let mut words = None;
    let bounds = match &meaning.error_bound {
        ErrorBound::Uniform(epsilon) => ReducedBounds::Uniform(epsilon.to_string().into()),
        ErrorBound::Column(column) => ReducedBounds::Column(column.clone()),
        ErrorBound::Interval { lower, upper } => {
            ReducedBounds::Interval { lower: lower.clone(), upper: upper.clone() }
        }
        ErrorBound::Law(law) => {
            words = Some(law.text().to_owned());
            ReducedBounds::Law(law.formula().into())
        }
    };
    let response = meaning.has_response.then(|| meaning.response.clone());
    AskedReduction { model: ReducedModel { regressors, response, bounds }, bounds: words }
}

/// Returns what a reduction asks of others: of a line under one bound for all readings, or one in a column, all that serve any multiple.
pub(super) fn asked_by_reduction(meaning: &Meaning) -> AskedReduction {
    let mut asked = asked_by_fit(meaning);
    if meaning.regressors() == 1 {
        let bounds = &mut asked.model.bounds;
        *bounds = match std::mem::replace(bounds, ReducedBounds::Any) {
            ReducedBounds::Uniform(_) => ReducedBounds::Any,
            ReducedBounds::Column(column) => ReducedBounds::Multiples(column),
            fixed => fixed,
        };
    }
    asked
}

/// Refuses bounds that are only known when all readings are: of a reading before no one can tell whether it decides.
pub(super) fn refuse_late(file: &Foreign, meaning: &Meaning) -> Result<(), InputError> {
    if meaning.is_open() || meaning.are_bounds_known() {
        return Ok(());
    }
    Err(InputError::of_file(file, ReductionError::LateBounds))
}
