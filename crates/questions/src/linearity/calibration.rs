//! A calibration from a table.

use boundfit_estimation::{FractionCells, Selection};
use boundfit_exact::{Foreign, Rational};
use boundfit_formats::{
    Batch, ColumnSelector, HeldRows, InputError, Missing, ScanOptions, Scanned, Source, TableRow, scan,
};
use thiserror::Error;

use super::directions::{Directions, Word};
use super::input::{LinearityInput, ResponseColumns};
use super::{CalibrationReading, Pass};

/// Which columns of a table are a calibration.
#[derive(Debug, Clone)]
pub struct CalibrationColumns {
    /// What was applied.
    pub x: ColumnSelector,
    /// What the sensor gave.
    pub response: CalibrationResponse,
}

/// Columns of what a sensor gave.
#[derive(Debug, Clone)]
pub enum CalibrationResponse {
    /// One, of which no direction is known.
    One(ColumnSelector),
    /// One, beside a column that says whether x was rising (up, upscale, rising, increasing, +, 1) or falling (down, downscale,
    /// falling, decreasing, -, -1, 0); of two other words the first is up.
    Directed {
        /// The readings.
        y: ColumnSelector,
        /// The direction.
        direction: ColumnSelector,
    },
    /// One for each direction, of which a cell may be missing where only the other one was read.
    Two {
        /// While x was rising.
        up: ColumnSelector,
        /// While x was falling.
        down: ColumnSelector,
    },
}

/// A calibration: its readings, and where they come from.
#[derive(Debug, Clone)]
pub struct Calibration {
    /// The readings, in the order of the rows.
    pub readings: Vec<CalibrationReading>,
    /// What they were read from.
    pub input: LinearityInput,
}

/// Why a table is no calibration.
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
        /// What is wrong with which row.
        problem: String,
    },
}

/// A row: x, y of both columns where it has them, and its word for the direction.
struct Row {
    row: usize,
    x: Rational,
    y: [Option<Rational>; 2],
    word: Option<String>,
}

impl Calibration {
    /// Reads a calibration. Exact.
    ///
    /// # Errors
    /// The first thing wrong with the table; a row with a reading in neither direction, and words for three directions.
    pub fn read(
        source: Source,
        columns: &CalibrationColumns,
        options: &ScanOptions,
    ) -> Result<Self, CalibrationError> {
        let file = source.name().to_owned();
        let key = match &columns.response {
            CalibrationResponse::Directed { direction, .. } => Some(direction.clone()),
            _ => None,
        };
        let mut options = ScanOptions { key, unbounded_rows: true, ..options.clone() };
        let held = HeldRows::limiting(&mut options);
        let mut rows: Vec<Row> = Vec::new();
        let scanned = scan(source, &columns.selectors(), &options, rows_of, |batch: Vec<Row>| {
            held.add(batch.len());
            rows.extend(batch);
        });
        held.check(file.raw()).map_err(CalibrationError::Input)?;
        let scanned = scanned.map_err(CalibrationError::Input)?;
        let fail = |problem: String| CalibrationError::Row { file: file.clone(), problem };
        let has_two = matches!(columns.response, CalibrationResponse::Two { .. });
        let count = rows.len();
        let mut directions = Directions::default();
        let mut lacking = 0;
        let mut readings: Vec<(CalibrationReading, Option<Word>)> = Vec::new();
        for Row { row, x, y: [first, second], word } in rows {
            if first.is_none() && second.is_none() {
                if options.table.missing == Missing::Refuse {
                    return Err(fail(format!("data row {row} has a reading in neither direction")));
                }
                lacking += 1;
                continue;
            }
            let word = word.map(|word| directions.word(&word, row)).transpose().map_err(fail)?;
            let pass = |pass| has_two.then_some(pass);
            let both = [(first, pass(Pass::Up)), (second, pass(Pass::Down))];
            for (y, pass) in both.into_iter().filter_map(|(y, pass)| Some((y?, pass))) {
                readings.push((CalibrationReading { row, x: x.clone(), y, pass }, word));
            }
        }
        let words = directions.words();
        let told = |(reading, word): (CalibrationReading, Option<Word>)| CalibrationReading {
            pass: reading.pass.or(word.map(|word| directions.pass(word))),
            ..reading
        };
        let readings = readings.into_iter().map(told).collect();
        let input = columns.input(&options, scanned, (count, lacking), words);
        Ok(Calibration { readings, input })
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

    /// What was read, for reports.
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
            written: scanned.layout.as_ref().and_then(|layout| layout.dialect.words()),
            units: [unit(0), unit(1)],
            sha256: scanned.sha256,
        }
    }
}

/// The rows of a batch.
fn rows_of(batch: Batch) -> Vec<Row> {
    let words = batch.keys.as_ref();
    let row = |(position, row): (usize, TableRow)| {
        let word = words.map(|words| words.get(position).to_owned());
        let mut numbers = row.numbers.into_iter();
        let x = numbers.next().unwrap_or_default();
        let y: Vec<Rational> = numbers.collect();
        let y = match <[Rational; 4]>::try_from(y) {
            Ok([up, has_up, down, has_down]) => {
                [(!has_up.is_zero()).then_some(up), (!has_down.is_zero()).then_some(down)]
            }
            Err(y) => [y.into_iter().next(), None],
        };
        Row { row: row.row, x, y, word }
    };
    batch.table_rows().enumerate().map(row).collect()
}
