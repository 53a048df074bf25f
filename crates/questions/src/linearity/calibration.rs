//! A calibration from a table.

use std::collections::HashMap;

use boundfit_estimation::{CountedBatch, CountedRows, FractionCells, Keep, Selection};
use boundfit_exact::{Column, Foreign, Rational, Unit};
use boundfit_formats::{
    Batch, ColumnSelector, HeldRows, InputError, Missing, ScanOptions, Scanned, Source, scan,
};
use thiserror::Error;

use super::deciding::PlainReadings;
use super::directions::{Directions, Word};
use super::input::{LinearityInput, ResponseColumns};
use super::{CalibrationReading, Linearity, LinearityOptions, Pass, Whole};

/// The columns of a table that are a calibration.
#[derive(Debug, Clone)]
pub struct CalibrationColumns {
    /// The column of the applied x.
    pub x: ColumnSelector,
    /// The columns of the sensor's output.
    pub response: CalibrationResponse,
}

/// Columns of what a sensor gave.
#[derive(Debug, Clone)]
pub enum CalibrationResponse {
    /// One, of which no direction is known.
    One(ColumnSelector),
    /// One column of readings, beside a column of directions. Rising x is up, upscale, rising, increasing, + or 1;
    /// falling x is down, downscale, falling, decreasing, -, -1 or 0. If the column has two other words, the first is
    /// up.
    Directed {
        /// The readings.
        y: ColumnSelector,
        /// The direction.
        direction: ColumnSelector,
    },
    /// One for each direction, of which a cell may be missing where only the other one was read.
    Two {
        /// The column for rising x.
        up: ColumnSelector,
        /// The column for falling x.
        down: ColumnSelector,
    },
}

/// A calibration: its readings, and where they come from.
#[derive(Debug, Clone)]
pub struct Calibration {
    /// The readings, in the order of the rows: all, or those that decide.
    pub readings: Vec<CalibrationReading>,
    /// The input.
    pub input: LinearityInput,
    /// The facts about all readings; `None` where these are all.
    whole: Option<Whole>,
}

/// The reason why a table is no calibration.
#[derive(Debug, Error)]
pub enum CalibrationError {
    /// Something is wrong with a number, or the table as a whole.
    #[error(transparent)]
    Input(InputError),
    /// Something is wrong with a row.
    #[error("{file}: {problem}")]
    Row {
        /// The table.
        file: Foreign,
        /// The problem, with its row.
        problem: String,
    },
}

/// The rows of a batch.
enum Rows {
    /// Each by itself.
    Plain(PlainReadings),
    /// Equal ones once, where each kind's word is one of a list.
    Counted {
        batch: CountedBatch,
        /// The different words, each with the first row that has it.
        words: Vec<(String, usize)>,
        /// The word of each kind.
        word_of: Vec<usize>,
    },
}

impl Calibration {
    /// Reads a calibration. From some dozen readings without directions on, only those that decide its linearity become
    /// readings. The others are numbers in columns. Exact.
    ///
    /// # Errors
    /// The first thing wrong with the table; a row with a reading in neither direction, and words for three directions.
    pub fn read(
        source: Source,
        columns: &CalibrationColumns,
        options: &ScanOptions,
    ) -> Result<Self, CalibrationError> {
        let most_plain = Keep::DECIDING.most_plain;
        Calibration::read_as(source, columns, options, (Keep::MOST_ROWS, most_plain))
    }

    /// Reads every reading of a calibration. Keeps equal rows once if there are more than `most_rows` rows and at
    /// least half of them equal an earlier row.
    ///
    /// # Errors
    /// The errors of [`Calibration::read`].
    pub fn read_counted(
        source: Source,
        columns: &CalibrationColumns,
        options: &ScanOptions,
        most_rows: usize,
    ) -> Result<Self, CalibrationError> {
        Calibration::read_as(source, columns, options, (most_rows, usize::MAX))
    }

    fn read_as(
        source: Source,
        columns: &CalibrationColumns,
        options: &ScanOptions,
        (most_rows, most_plain): (usize, usize),
    ) -> Result<Self, CalibrationError> {
        let file = source.name().to_owned();
        let key = match &columns.response {
            CalibrationResponse::Directed { direction, .. } => Some(direction.clone()),
            _ => None,
        };
        let has_words = key.is_some();
        let mut options = ScanOptions { key, unbounded_rows: true, ..options.clone() };
        let held = HeldRows::limiting(&mut options);
        let row_cost = options.table.row_cost as u64;
        let is_plain = matches!(columns.response, CalibrationResponse::One(_)) && most_plain < usize::MAX;
        let mut plain = PlainReadings::default();
        let mut counted = CountedRows::default();
        let mut directions = Directions::default();
        let mut wrong_word = None;
        let look_for_equals = |plain: &mut PlainReadings, counted: &mut CountedRows| {
            if plain.len() > 0 {
                counted.push(std::mem::take(plain).counted(), None);
                // Their number has been told.
                held.add_bytes(0, 0, counted.kinds() as u64 * row_cost + counted.bytes() as u64);
            }
        };
        let digest = |batch: Batch| Rows::of(batch, is_plain);
        let scanned = scan(source, &columns.selectors(), &options, digest, |rows: Rows| {
            if let (Rows::Plain(more), 0) = (&rows, counted.rows()) {
                held.add_bytes(more.len(), more.len(), more.len() as u64 * PlainReadings::ROW_COST);
                plain.append(more);
                return;
            }
            look_for_equals(&mut plain, &mut counted);
            let before = (counted.rows(), counted.kinds(), counted.bytes());
            if let Err(problem) = rows.add_to(&mut counted, &mut directions, has_words) {
                wrong_word = wrong_word.take().or(Some(problem));
            }
            let more = counted.bytes().saturating_sub(before.2);
            held.add_counted(counted.rows() - before.0, counted.kinds() - before.1, more);
        });
        held.check(file.raw()).map_err(CalibrationError::Input)?;
        let scanned = scanned.map_err(CalibrationError::Input)?;
        let hold = |readings: usize| {
            held.add_bytes(0, 0, readings as u64 * row_cost);
            held.check(file.raw()).map_err(CalibrationError::Input)
        };
        if plain.len() > most_plain
            && let Some((readings, whole)) = plain.deciding(hold)?
        {
            let input = columns.input(&options, scanned, (plain.len(), 0), directions.words());
            return Ok(Calibration { readings, input, whole: Some(whole) });
        }
        look_for_equals(&mut plain, &mut counted);
        held.check(file.raw()).map_err(CalibrationError::Input)?;
        let fail = |problem: String| CalibrationError::Row { file: file.clone(), problem };
        if let Some(problem) = wrong_word {
            return Err(fail(problem));
        }
        let is_counted = counted.rows() > most_rows && 2 * counted.kinds() <= counted.rows();
        let rows = if is_counted { counted.first_rows() } else { counted.in_order() };
        let has_two = matches!(columns.response, CalibrationResponse::Two { .. });
        let mut lacking = 0;
        let mut readings = Vec::new();
        for (row, kind) in rows {
            let mut numbers = counted.numbers(kind);
            let word = if has_words { numbers.next() } else { None };
            let equal = is_counted.then(|| counted.tally(kind).clone());
            let x = numbers.next().unwrap_or_default();
            let ys = y_of(numbers.collect());
            if ys.iter().all(Option::is_none) {
                if options.table.missing == Missing::Refuse {
                    return Err(fail(format!("data row {row} has a reading in neither direction")));
                }
                lacking += equal.as_ref().map_or(1, |equal| equal.count() as usize);
                continue;
            }
            let told = word.and_then(|number| directions.pass_of(&number));
            for (y, pass) in ys.into_iter().zip([Pass::Up, Pass::Down]) {
                let Some(y) = y else { continue };
                let pass = if has_two { Some(pass) } else { told };
                readings.push(CalibrationReading { row, x: x.clone(), y, pass, equal: equal.clone() });
            }
        }
        let input = columns.input(&options, scanned, (counted.rows(), lacking), directions.words());
        Ok(Calibration { readings, input, whole: None })
    }

    /// Finds the linearity of all readings; `None` without any. Exact. Cost: O(n log n) in the readings kept.
    pub fn linearity(&self, options: &LinearityOptions) -> Option<Linearity> {
        Linearity::of(&self.readings, self.whole.as_ref(), options)
    }
}

impl Rows {
    /// Takes the rows of a batch: as they are where that is asked for and few are equal.
    fn of(mut batch: Batch, is_plain: bool) -> Self {
        let columns = std::mem::take(&mut batch.columns);
        if is_plain && !CountedBatch::are_few(&columns, 2) {
            return Rows::Plain(PlainReadings::new(columns, batch.rows));
        }
        let Some(keys) = &batch.keys else {
            let batch = CountedBatch::new(columns, &batch.rows, |_| None, 1);
            return Rows::Counted { batch, words: Vec::new(), word_of: Vec::new() };
        };
        let mut words: Vec<(String, usize)> = Vec::new();
        let mut numbers: HashMap<&str, usize> = HashMap::new();
        let mut number_of = Vec::with_capacity(batch.rows.len());
        for (position, row) in batch.rows.ranges().flat_map(|[first, last]| first..=last).enumerate() {
            let word = keys.get(position);
            number_of.push(*numbers.entry(word).or_insert_with(|| {
                words.push((word.to_owned(), row));
                words.len() - 1
            }));
        }
        let key = |row: usize| number_of.get(row).map(|&number| number as u32);
        let counted = CountedBatch::new(columns, &batch.rows, key, 1);
        let word_of = counted.positions().filter_map(|row| number_of.get(row).copied()).collect();
        Rows::Counted { batch: counted, words, word_of }
    }

    /// Adds these rows, each with the number of its word before its own numbers where there are words.
    fn add_to(
        self,
        counted: &mut CountedRows,
        directions: &mut Directions,
        has_words: bool,
    ) -> Result<(), String> {
        let (batch, words, word_of) = match self {
            Rows::Plain(rows) => (rows.counted(), Vec::new(), Vec::new()),
            Rows::Counted { batch, words, word_of } => (batch, words, word_of),
        };
        if !has_words {
            counted.push(batch, None);
            return Ok(());
        }
        let words = words.iter().map(|(word, row)| directions.word(word, *row).map(Word::number));
        let words: Vec<i128> = words.collect::<Result<_, _>>()?;
        let own: Vec<i128> = word_of.iter().filter_map(|&word| words.get(word).copied()).collect();
        counted.push(batch, Some(&Column::of_counts(own.into_iter(), Unit::TenTo(0))));
        Ok(())
    }
}

/// The readings of both columns, or of one.
fn y_of(numbers: Vec<Rational>) -> [Option<Rational>; 2] {
    match <[Rational; 4]>::try_from(numbers) {
        Ok([up, has_up, down, has_down]) => {
            [(!has_up.is_zero()).then_some(up), (!has_down.is_zero()).then_some(down)]
        }
        Err(numbers) => [numbers.into_iter().next(), None],
    }
}

impl CalibrationColumns {
    /// The columns of numbers.
    fn selectors(&self) -> Vec<ColumnSelector> {
        let x = self.x.clone();
        match &self.response {
            CalibrationResponse::Two { up, down } => {
                let both = [up, down].map(|column| [column.clone().optional(), column.clone().presence()]);
                [x].into_iter().chain(both.into_iter().flatten()).collect()
            }
            CalibrationResponse::One(y) | CalibrationResponse::Directed { y, .. } => vec![x, y.clone()],
        }
    }

    /// The input, for reports.
    fn input(
        &self,
        options: &ScanOptions,
        scanned: Scanned,
        (rows, lacking): (usize, usize),
        words: [Vec<Foreign>; 2],
    ) -> LinearityInput {
        let name = |position: usize| scanned.names.get(position).cloned().unwrap_or_default();
        let response = match (&self.response, &scanned.key_name) {
            (CalibrationResponse::Two { .. }, _) => ResponseColumns::Two { up: name(1), down: name(3) },
            (_, Some(direction)) => {
                ResponseColumns::Directed { y: name(1), direction: direction.clone(), words }
            }
            (_, None) => ResponseColumns::One(name(1)),
        };
        let unit = |position: usize| scanned.units.get(position).cloned().flatten();
        LinearityInput {
            x: name(0),
            response,
            rows: rows - lacking,
            rows_total: scanned.rows_total,
            rows_missing: scanned.rows_missing + lacking,
            selection: Selection::of(&options.table),
            fractions: FractionCells::of(&scanned.names, &scanned.fractions),
            table: scanned.table,
            units: [unit(0), unit(1)],
            sha256: scanned.sha256,
        }
    }
}
