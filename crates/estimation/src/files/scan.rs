//! Tables of any size.

use boundfit_exact::Column;
use boundfit_formats::{
    Batch, InputError, ReductionError, Reductions, RowNumbers, ScanOptions, Scanned, Source, TableNotes,
};

use super::columns::Columns;
use super::first_look::{Collected, FirstLook};
use super::fixed::{FixedBounds, FixedSummary};
use super::in_columns::InColumns;
use super::looks::Looks;
use super::outline::Outline;
use super::seen::Seen;
use super::stated::{Stated, asked_by_fit, counts_of, refuse_late};
use crate::condition::Condition;
use crate::line_form::LineForm;
use crate::meaning::Meaning;
use crate::measurement::Measurement;
use crate::measurements::{Measurements, Origin, Readings};
use crate::moments::Sums;
use crate::reduction::{DecidingMinimax, NoEui, NoMinimax, Reach, Reduction};
use crate::scale::Scale;
use crate::selection::{FractionCells, Selection};
use crate::summary::{Keep, Spread, Thresholds};
use crate::ties::Ties;

impl Measurements {
    /// Reads the columns of a table in memory that does not grow with it: see [`Keep`]. Rows and numbers are those of
    /// [`Measurements::read`]. The conditions are those of the problem to come: ε_min under bounds that are not the same for all
    /// readings of a line depends on them.
    ///
    /// Exact. Cost: one pass, and another where the EUI is asked for of a file with more readings than are kept for
    /// it. The factor ε_min then takes some more passes, in practice two or three, unless the model is a line under a uniform
    /// error bound.
    ///
    /// # Errors
    /// The first thing wrong with the file, a negative error bound included.
    pub fn scan(
        source: Source,
        columns: &Columns,
        conditions: &[Condition],
        options: &ScanOptions,
        keep: Keep,
    ) -> Result<Self, InputError> {
        let nothing = |_: &Seen<'_>| ();
        Measurements::scan_and_see(source, columns, conditions, options, keep, nothing, |()| ())
    }

    /// Scans as [`Measurements::scan`] does, and shows every reading on the way. `see` gets the readings of each part
    /// of the table, on the threads of the current pool. `seen` gets its results, in the order of the table. Readings
    /// under a law that takes something from all of them are shown without it.
    ///
    /// # Errors
    /// The errors of [`Measurements::scan`].
    pub fn scan_and_see<T: Send + 'static>(
        source: Source,
        columns: &Columns,
        conditions: &[Condition],
        options: &ScanOptions,
        keep: Keep,
        see: impl Fn(&Seen<'_>) -> T + Sync + Send,
        seen: impl FnMut(T),
    ) -> Result<Self, InputError> {
        let unnamed = columns.meaning(&[]);
        let (look, source) = FirstLook::new(source, columns, &unnamed, options, keep)?;
        let (all, scanned) = look.take(source, see, seen)?;
        let mut meaning = columns.meaning(&scanned.names);
        let selection = Selection::of(&look.options.table);
        if let Some(reductions) = &look.reductions {
            let readings = readings_of_reductions(&look, reductions, all, &mut meaning, &scanned)?;
            let mut own = measurements(meaning, selection, scanned, readings);
            // The records say how rows are told apart; the notation of numbers may be found out.
            let table = own.origin.table.take().and_then(TableNotes::of_reductions);
            own.origin = Origin { rows_total: own.fitted(), layout: None, table, ..own.origin };
            return Ok(own);
        }
        columns.refuse_unbounded(&look.name, all.unbounded)?;
        let mut in_columns = None;
        let readings = if all.are_plain(&look) {
            let mut rows = all.readings(&meaning);
            meaning.settle(&mut rows);
            Readings::All(rows)
        } else if meaning.is_open() {
            let mut all = all;
            let batches = std::mem::take(&mut all.batches);
            let readings = readings_of_line(&look, all, &batches, &mut meaning, &scanned)?;
            in_columns = InColumns::new(batches);
            readings
        } else {
            let mut all = all;
            in_columns = InColumns::new(std::mem::take(&mut all.batches));
            readings_under_fixed_bounds(&look, all, &meaning, conditions, &scanned)?
        };
        let mut own = measurements(meaning, selection, scanned, readings);
        own.origin.in_columns = in_columns;
        Ok(own)
    }
}

/// The rows of reductions, and what these say of all readings.
fn readings_of_reductions(
    look: &FirstLook,
    reductions: &Reductions,
    all: Collected,
    meaning: &mut Meaning,
    scanned: &Scanned,
) -> Result<Readings, InputError> {
    let FirstLook { name, columns, .. } = look;
    let stated = Stated::of(reductions, name, &asked_by_fit(meaning), &look.options)?;
    let skipped = scanned.table.as_ref().map_or(0, |table| table.skipped.lines + table.skipped.comments);
    if look.options.table.dialect.skip_lines + skipped + scanned.rows_missing as u64 > 0 {
        return Err(InputError::of_file(name, ReductionError::RowsLeftOut));
    }
    refuse_late(name, meaning)?;
    columns.refuse_unbounded(name, all.unbounded)?;
    let counts = counts_of(reductions, name, scanned.rows_total)?;
    let check = |outline: Option<Outline>| {
        all.kept_rows.check(&stated, outline.as_ref()).map_err(|error| InputError::of_file(name, error))
    };
    let (mut rows, mut ties, minimax) = match meaning.error_bound.uniform() {
        Some(epsilon) if meaning.is_open() => {
            let (_, rows, ties) = all.open.into_parts(epsilon, &look.sieve);
            let mut rows = rows.into_numbers();
            check(stated.is_hull.then(|| Outline::of(&rows)))?;
            columns.form.count_rows(&mut rows);
            (rows, ties, DecidingMinimax::Kept)
        }
        _ if stated.is_open => {
            check(None)?;
            (all.readings(meaning), Ties::default(), DecidingMinimax::Kept)
        }
        _ => {
            check(None)?;
            // Without widths there is nothing that a factor could multiply.
            let minimax = match stated.has_widths {
                true => DecidingMinimax::Unknown(NoMinimax::Reduced),
                false => DecidingMinimax::Kept,
            };
            let (rows, ties) = all.fixed.support.into_rows(&look.bounds);
            (rows, ties, minimax)
        }
    };
    if let Some(counts) = counts {
        ties = ties.weighted(&rows, &counts);
    }
    meaning.settle(&mut rows);
    let Stated { count, sums, has_widths, .. } = stated;
    let is_line = meaning.regressors() == 1;
    let sums = sums.map(|sums| if is_line { sums.counted_from(&columns.form.x_origin) } else { sums });
    let reduction = Reduction { count, sums, reach: Err(NoEui::Reduced), minimax, has_widths };
    Ok(Readings::Supporting { rows: rows.into(), ties, reduction })
}

/// The readings that support a hull, of more readings of a line under a uniform error bound than become numbers. `batches` has all
/// readings or none.
fn readings_of_line(
    look: &FirstLook,
    all: Collected,
    batches: &[Batch],
    meaning: &mut Meaning,
    scanned: &Scanned,
) -> Result<Readings, InputError> {
    let form = &look.columns.form;
    let epsilon = meaning.error_bound.uniform().cloned().unwrap_or_default();
    let (sums, rows, ties) = all.open.into_parts(&epsilon, &look.sieve);
    let rows = meaning.settled(rows);
    let totals = [sums.uv.clone()];
    let sums = sums.counted_from(&form.x_origin);
    // Only all columns together tell which rows lack a number.
    let seen = if scanned.rows_missing > 0 { look.selectors.len() } else { 1 };
    let looks = Looks {
        kept: &all.kept,
        file: look.path.as_deref().map(|path| (path, scanned.bytes)),
        options: &look.options,
        selectors: &look.selectors[..seen],
        count: all.rows,
        totals: &totals,
    };
    let reach = reach_of_line(looks, batches, form, &sums, look.keep.eui)?;
    let (minimax, has_widths) = (DecidingMinimax::Kept, true);
    let reduction = Reduction { count: all.rows, sums: Ok(sums), reach, minimax, has_widths };
    Ok(Readings::Supporting { rows, ties, reduction })
}

/// The readings that touch an envelope, of more readings under bounds that are fixed than are kept.
fn readings_under_fixed_bounds(
    look: &FirstLook,
    all: Collected,
    meaning: &Meaning,
    conditions: &[Condition],
    scanned: &Scanned,
) -> Result<Readings, InputError> {
    let looks = Looks {
        kept: &all.kept,
        file: look.path.as_deref().map(|path| (path, scanned.bytes)),
        options: &look.options,
        selectors: &look.selectors,
        count: all.rows,
        totals: &all.totals,
    };
    let FixedSummary { support, sums, has_widths } = all.fixed;
    let kept = support.into_rows(&look.bounds);
    let proving = looks.proving_bounds(&look.bounds, conditions, &kept);
    let (mut rows, mut ties) = match &proving {
        Some(proving) => looks.touching(proving)?,
        None => kept,
    };
    let bounds = proving.as_ref().unwrap_or(&look.bounds);
    let (reach, minimax) = if !look.keep.eui {
        (Err(NoEui::NotAsked), DecidingMinimax::Unknown(NoMinimax::NotAsked))
    } else if !looks.are_possible() {
        (Err(NoEui::TooManyOnce), DecidingMinimax::Unknown(NoMinimax::TooManyOnce))
    } else {
        let mut known = rows.clone();
        let mut reach = Err(NoEui::NotAsked);
        if let Ok(sums) = &sums {
            let least = Scale::least_at(rows.iter(), meaning.error_bound.is_uniform(), conditions);
            let reached = looks.reach_and_tightest(meaning, sums, least.as_ref())?;
            reach = reached.reach;
            known.extend(reached.missing);
            add_tightest(&mut rows, &mut ties, reached.tightest, bounds);
        }
        let own = looks.deciding_minimax(meaning, conditions, known)?;
        (reach, DecidingMinimax::Own(own))
    };
    let reduction = Reduction { count: all.rows, sums, reach, minimax, has_widths };
    Ok(Readings::Supporting { rows: rows.into(), ties, reduction })
}

/// Keeps the reading that least squares misses most too, apart from the one that stands for it.
fn add_tightest(
    rows: &mut Vec<Measurement>,
    ties: &mut Ties,
    tightest: Option<Measurement>,
    bounds: &FixedBounds,
) {
    let Some(tightest) = tightest else { return };
    let Err(place) = rows.binary_search_by_key(&tightest.row, |reading| reading.row) else { return };
    if let Some(speaker) = bounds.speaker(rows, &tightest) {
        ties.set_apart(tightest.row, speaker);
    }
    rows.insert(place, tightest);
}

/// Returns how far least squares of a line may move under a uniform bound of 1: a second look at x.
fn reach_of_line(
    looks: Looks,
    batches: &[Batch],
    form: &LineForm,
    sums: &Sums,
    is_asked: bool,
) -> Result<Result<Reach, NoEui>, InputError> {
    let thresholds = Thresholds::of_form(form, sums);
    let in_memory = batches.iter().map(|batch| thresholds.of_column(&batch.columns[0]));
    let in_memory = in_memory.reduce(|total, part| total.merged(&part));
    if in_memory.is_none() && !is_asked {
        return Ok(Err(NoEui::NotAsked));
    }
    let spread = match in_memory.or_else(|| looks.kept.spread(&thresholds)) {
        Some(spread) => spread,
        None if looks.file.is_none() => return Ok(Err(NoEui::TooManyOnce)),
        None => {
            let mut spread = Spread::default();
            let look = |columns: &[Column], _: &RowNumbers| thresholds.of_column(&columns[0]);
            looks.look(look, |part| spread = spread.merged(&part))?;
            spread
        }
    };
    let spread = spread.counted_from(&form.x_origin);
    let (radii, absolute) = (spread.absolute_weights(sums), spread.absolute_x(sums));
    Ok(Ok(Reach { radii, absolute, middles: None }))
}

/// Readings of a table that was read in batches.
pub(super) fn measurements(
    meaning: Meaning,
    selection: Selection,
    scanned: Scanned,
    readings: Readings,
) -> Measurements {
    let Scanned { names, fractions, rows_total, rows_missing, ranges, units, layout, table, sha256, .. } =
        scanned;
    let fractions = FractionCells::of(&names, &fractions);
    let known = Origin { rows_total, rows_missing, selection, fractions, ranges, ..Origin::default() };
    let origin = Origin { table, units, layout, sha256, ..known };
    Measurements { meaning, readings, others: Vec::new(), origin }
}
