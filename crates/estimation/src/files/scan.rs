//! Tables of any size.

use std::sync::Arc;

use boundfit_exact::{Column, Rational};
use boundfit_formats::{
    AskedBlock, Batch, HeldRows, InputError, RowNumbers, ScanOptions, Scanned, Source, TableRow,
    open_reduction, scan,
};

use super::agreement::KeptRows;
use super::columns::Columns;
use super::kept_columns::{KeptColumns, KeptNumbers, KeptPart};
use super::looks::Looks;
use super::outline::Outline;
use super::stated::{Stated, asked_by_fit, counts_of, refuse_late};
use crate::condition::Condition;
use crate::line_form::LineForm;
use crate::meaning::Meaning;
use crate::measurement::Measurement;
use crate::measurements::{Measurements, Origin, Readings};
use crate::reduction::{DecidingMinimax, NoEui, NoMinimax, Reach, Reduction};
use crate::selection::{FractionCells, Selection};
use crate::summary::{
    Brackets, FixedBounds, FixedPart, FixedSummary, Keep, LineSummary, Scale, SharedBrackets, SharedSieve,
    Spread, Thresholds,
};
use crate::sums::{Sums, column_totals};
use crate::ties::Ties;

/// Bytes of numbers kept from a file before it is rather read again: twelve million x at four bytes each.
const MOST_BYTES_OF_FILE: usize = 48 << 20;
/// Bytes of numbers kept from standard input, which cannot be read again: 134 million x at four bytes each.
const MOST_BYTES_OF_STREAM: usize = 512 << 20;

/// One batch with what is made of it at once.
struct Digest {
    batch: Batch,
    /// The first row without bounds.
    unbounded: Option<usize>,
    part: Part,
    kept: Option<KeptNumbers>,
}

/// What is kept of the readings of a batch.
enum Part {
    /// Of a line under a uniform bound, whatever it is.
    Open(LineSummary),
    /// Under bounds that are fixed, with the sums of each column.
    Fixed(FixedPart, Vec<Rational>),
    /// Nothing where bounds are only known when all readings are.
    Nothing,
}

/// Everything taken so far.
struct Collected {
    batches: Vec<Batch>,
    rows: usize,
    open: LineSummary,
    fixed: FixedSummary,
    totals: Vec<Rational>,
    kept: KeptColumns,
}

impl Measurements {
    /// Reads the columns of a table in memory that does not grow with it: see [`Keep`]. Rows and numbers are those of
    /// [`Measurements::read`]. The conditions are those of the problem to come: ε_min under bounds that are not the same for all
    /// readings of a line depends on them.
    ///
    /// Exact. Cost: one pass; another where the EUI is asked for of a file with more readings than are kept for it, and then
    /// also some more, in practice two or three, for ε_min unless the model is a line under a uniform error bound.
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
        let nothing = |_: &mut dyn Iterator<Item = Measurement>| ();
        Measurements::scan_and_see(source, columns, conditions, options, keep, nothing, |()| ())
    }

    /// As [`Measurements::scan`], and shows every reading on the way: `see` is given the readings of one part of the table after
    /// the other, on the threads of the current pool, and `seen` what it made of them, in the order of the table. Readings under
    /// a law that takes something from all of them are shown without it.
    ///
    /// # Errors
    /// Those of [`Measurements::scan`].
    pub fn scan_and_see<T: Send>(
        source: Source,
        columns: &Columns,
        conditions: &[Condition],
        options: &ScanOptions,
        keep: Keep,
        see: impl Fn(&mut dyn Iterator<Item = Measurement>) -> T + Sync + Send,
        mut seen: impl FnMut(T),
    ) -> Result<Self, InputError> {
        let name = source.name().to_owned();
        let path = source.path().map(str::to_owned);
        let usual = if path.is_some() { MOST_BYTES_OF_FILE } else { MOST_BYTES_OF_STREAM };
        let memory = usize::try_from(options.table.sizes.memory.limit() / 2).unwrap_or(usize::MAX);
        let usual = usual.min(memory);
        let mut all = Collected::new(keep.most_bytes.unwrap_or(usual));
        let unnamed = columns.meaning(&[]);
        let scale = Scale::AsStated;
        let brackets = SharedBrackets::default();
        let (source, reductions) = open_reduction(source, &options.table.sizes)?;
        let mut options = options.clone();
        if let Some(reductions) = &reductions {
            options.table.header = reductions.header();
            // Records stand between the rows of several.
            options.table.block = Some(AskedBlock::All);
            // Whether the reduction serves these bounds comes first.
            (options.unbounded_rows, options.same_columns) = (true, true);
        }
        let summarises = unnamed.is_open() || unnamed.are_bounds_known();
        // A proof names every row that touches; of a reduction the rows are few, and stand for others by their numbers.
        let most_listed =
            if options.list_rows || reductions.is_some() { usize::MAX } else { Ties::MOST_LISTED };
        let sieve = SharedSieve::listing(most_listed);
        let bounds = FixedBounds::new(&unnamed, &scale, most_listed);
        // Rows that stand for others are looked for again where a proof takes them.
        let can_look = reductions.is_none() && (keep.eui || path.is_some());
        let bounds = if can_look { bounds.telling_vertices_as_one() } else { bounds };
        // Of a reduction what was kept was kept for a reason.
        let keeps_all = reductions.is_some() || !summarises;
        let most_rows = if keeps_all { usize::MAX } else { keep.most_rows };
        // Others are kept only as long as they are few.
        let held = (most_rows == usize::MAX).then(|| HeldRows::limiting(&mut options));
        let mut unbounded = None;
        let mut held_rows = 0;
        let selectors = columns.selectors();
        // Sums are told of x as it is.
        let as_it_is = Columns { form: LineForm::default(), ..columns.clone() }.meaning(&[]);
        let digest = |batch: Batch| {
            let unbounded = columns.first_unbounded(&batch);
            let rows = reductions.as_ref().map(|own| KeptRows::of_batch(&as_it_is, &batch, own));
            let keeps = (keep.eui && !keeps_all).then_some(&brackets);
            let reading = |k: usize| unnamed.of_columns(&batch.columns, k, batch.rows.get(k));
            let shown = see(&mut (0..batch.rows.len()).map(reading));
            (rows, shown, Digest { unbounded, ..Digest::new(batch, &sieve, &bounds, keeps) })
        };
        let mut kept_rows = KeptRows::default();
        let scanned = scan(source, &selectors, &options, digest, |(rows, shown, digest)| {
            seen(shown);
            rows.into_iter().for_each(|rows| kept_rows.add(rows));
            held.iter().for_each(|held| held.add(digest.batch.rows.len()));
            held_rows += digest.batch.rows.len();
            unbounded = unbounded.or(digest.unbounded);
            let guess = |sums: &Sums| {
                let guess =
                    Brackets::of_form(&columns.form, &sums.clone().counted_from(&columns.form.x_origin))?;
                Some(brackets.set(guess))
            };
            all.take(digest, most_rows, &sieve, &bounds, guess);
        });
        let holds_all = held.is_some();
        held.map_or(Ok(()), |held| held.check(name.raw()))?;
        let mut scanned = scanned?;
        if reductions.is_some() {
            // What its table was taken for is said in its record.
            scanned.table = None;
        }
        if holds_all {
            columns.refuse_long_in_each(&name, held_rows, options.table.sizes.work)?;
        }
        let (mut meaning, selection) = (columns.meaning(&scanned.names), Selection::of(&options.table));
        if let Some(reductions) = &reductions {
            let stated = Stated::of(reductions, &name, &asked_by_fit(&meaning), &options)?;
            refuse_late(&name, &meaning)?;
            columns.refuse_unbounded(&name, unbounded)?;
            let counts = counts_of(reductions, &name, scanned.rows_total)?;
            let check = |outline: Option<Outline>| {
                kept_rows.check(&stated, outline.as_ref()).map_err(|error| InputError::of_file(&name, error))
            };
            let (mut rows, mut ties, minimax) = match meaning.error_bound.uniform() {
                Some(epsilon) if meaning.is_open() => {
                    let (_, mut rows, ties) = all.open.into_parts(epsilon, &sieve);
                    check(stated.is_hull.then(|| Outline::of(&rows)))?;
                    columns.form.count_rows(&mut rows);
                    (rows, ties, DecidingMinimax::Kept)
                }
                _ if stated.is_open => {
                    check(None)?;
                    (rows_of(&all.batches, &meaning), Ties::default(), DecidingMinimax::Kept)
                }
                _ => {
                    check(None)?;
                    // Without widths there is nothing that a factor could multiply.
                    let minimax = match stated.has_widths {
                        true => DecidingMinimax::Unknown(NoMinimax::Reduced),
                        false => DecidingMinimax::Kept,
                    };
                    let (rows, ties) = all.fixed.support.into_rows(&bounds);
                    (rows, ties, minimax)
                }
            };
            if let Some(counts) = counts {
                ties = ties.weighted(&rows, &counts);
            }
            meaning.settle(&mut rows);
            let Stated { count, sums, has_widths, .. } = stated;
            let is_line = meaning.regressors() == 1;
            let sums =
                sums.map(|sums| if is_line { sums.counted_from(&columns.form.x_origin) } else { sums });
            let scanned = Scanned { rows_total: count, layout: None, ..scanned };
            let reduction = Reduction { count, sums, reach: Err(NoEui::Reduced), minimax, has_widths };
            return Ok(measurements(
                meaning,
                selection,
                scanned,
                Readings::Supporting { rows, ties, reduction },
            ));
        }
        columns.refuse_unbounded(&name, unbounded)?;
        if all.rows <= most_rows {
            let mut rows = rows_of(&all.batches, &meaning);
            meaning.settle(&mut rows);
            return Ok(measurements(meaning, selection, scanned, Readings::All(rows)));
        }
        let Collected { rows: count, open, fixed, totals, kept, .. } = all;
        let looks = Looks {
            kept: &kept,
            file: path.as_deref().map(|path| (path, scanned.bytes)),
            options: &options,
            selectors: &selectors,
            count,
            totals: &totals,
        };
        let readings = match meaning.error_bound.uniform().cloned() {
            Some(epsilon) if meaning.is_open() => {
                let (sums, mut rows, ties) = open.into_parts(&epsilon, &sieve);
                columns.form.count_rows(&mut rows);
                // A reading with the largest or the smallest y of all is on a hull.
                meaning.settle(&mut rows);
                let totals = [sums.uv.clone()];
                let sums = sums.counted_from(&columns.form.x_origin);
                // Which rows lack a number is told by all columns.
                let seen = if scanned.rows_missing > 0 { selectors.len() } else { 1 };
                let looks = Looks { selectors: &selectors[..seen], totals: &totals, ..looks };
                let reach = reach_of_line(looks, &columns.form, &sums, keep.eui)?;
                let (minimax, has_widths) = (DecidingMinimax::Kept, true);
                let reduction = Reduction { count, sums: Ok(sums), reach, minimax, has_widths };
                Readings::Supporting { rows, ties, reduction }
            }
            _ => {
                let FixedSummary { support, sums, has_widths } = fixed;
                let kept = support.into_rows(&bounds);
                let proving = looks.proving_bounds(&bounds, conditions, &kept);
                let (mut rows, mut ties) = match &proving {
                    Some(proving) => looks.touching(proving)?,
                    None => kept,
                };
                let bounds = proving.unwrap_or(bounds);
                let (reach, minimax) = if !keep.eui {
                    (Err(NoEui::NotAsked), DecidingMinimax::Unknown(NoMinimax::NotAsked))
                } else if !looks.are_possible() {
                    (Err(NoEui::TooManyOnce), DecidingMinimax::Unknown(NoMinimax::TooManyOnce))
                } else {
                    let own = looks.deciding_minimax(&meaning, conditions, &rows)?;
                    let (reach, tightest) = match &sums {
                        Ok(sums) => looks.reach_and_tightest(&meaning, sums)?,
                        Err(_) => (Err(NoEui::NotAsked), None),
                    };
                    if let Some(tightest) = tightest
                        && let Err(place) = rows.binary_search_by_key(&tightest.row, |reading| reading.row)
                    {
                        if let Some(speaker) = bounds.speaker(&rows, &tightest) {
                            ties.set_apart(tightest.row, speaker);
                        }
                        rows.insert(place, tightest);
                    }
                    (reach, DecidingMinimax::Own(own))
                };
                Readings::Supporting {
                    rows,
                    ties,
                    reduction: Reduction { count, sums, reach, minimax, has_widths },
                }
            }
        };
        Ok(measurements(meaning, selection, scanned, readings))
    }
}

/// How far least squares of a line may move under a uniform bound of 1: a second look at x.
fn reach_of_line(
    looks: Looks,
    form: &LineForm,
    sums: &Sums,
    is_asked: bool,
) -> Result<Result<Reach, NoEui>, InputError> {
    if !is_asked {
        return Ok(Err(NoEui::NotAsked));
    }
    let thresholds = Thresholds::of_form(form, sums);
    let spread = match looks.kept.spread(&thresholds) {
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

impl Digest {
    fn new(batch: Batch, sieve: &SharedSieve, bounds: &FixedBounds, keeps: Option<&SharedBrackets>) -> Self {
        let (columns, meaning) = (&batch.columns, bounds.meaning);
        let row = |k| batch.rows.get(k);
        let is_open = meaning.is_open();
        let part = if is_open {
            Part::Open(LineSummary::of_columns([&columns[0], &columns[1]], None, &row, sieve))
        } else if meaning.are_bounds_known() {
            Part::Fixed(bounds.part(columns, &row), column_totals(columns))
        } else {
            Part::Nothing
        };
        let kept = keeps.map(|brackets| match brackets.get() {
            Some(brackets) => KeptNumbers::Narrowed(brackets.narrow(&columns[0])),
            None => {
                let wanted = if is_open { &columns[..1] } else { columns };
                KeptNumbers::Part(KeptPart::new(wanted, batch.rows.clone()))
            }
        });
        Digest { batch, unbounded: None, part, kept }
    }
}

impl Collected {
    fn new(most_bytes: usize) -> Self {
        Collected {
            batches: Vec::new(),
            rows: 0,
            open: LineSummary::default(),
            fixed: FixedSummary::default(),
            totals: Vec::new(),
            kept: KeptColumns::new(most_bytes),
        }
    }

    fn take(
        &mut self,
        Digest { batch, part, kept, .. }: Digest,
        most_rows: usize,
        sieve: &SharedSieve,
        bounds: &FixedBounds,
        guess: impl FnOnce(&Sums) -> Option<Arc<Brackets>>,
    ) {
        let rows = batch.rows.len();
        self.rows += rows;
        if self.rows <= most_rows {
            self.batches.push(batch);
        } else {
            self.batches = Vec::new();
        }
        match part {
            Part::Open(summary) => self.open.merge(summary, sieve),
            Part::Nothing => {}
            Part::Fixed(part, totals) => {
                self.fixed.merge(part, rows, bounds);
                self.totals.resize(totals.len(), Rational::zero());
                self.totals.iter_mut().zip(totals).for_each(|(total, part)| *total = &*total + part);
            }
        }
        if let Some(kept) = kept {
            let is_open = bounds.meaning.is_open();
            self.kept.push(kept, || is_open.then(|| guess(&self.open.sums.total())).flatten());
        }
    }
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

/// All readings of batches.
fn rows_of(batches: &[Batch], meaning: &Meaning) -> Vec<Measurement> {
    let row = |row: TableRow| meaning.measurement(row.row, row.numbers.into_iter());
    batches.iter().flat_map(Batch::table_rows).map(row).collect()
}
