//! A calibration from a table.

use boundfit_estimation::{FractionCells, Selection};
use boundfit_exact::{Foreign, Rational};
use boundfit_formats::{Batch, ColumnSelector, HeldRows, Missing, ScanOptions, Scanned, Source, scan};
use boundfit_questions::{CalibrationReading, Pass};
use boundfit_report::{LinearityInput, ResponseColumns};

use super::directions::{Directions, Word};
use crate::arguments::LinearityArguments;
use crate::exit::Failure;

/// Readings, and where they come from.
pub(super) struct Calibration {
    pub(super) readings: Vec<CalibrationReading>,
    pub(super) input: LinearityInput,
}

/// A row: x, y of both columns where it has them, and its word for the direction.
struct Row {
    row: usize,
    x: Rational,
    y: [Option<Rational>; 2],
    word: Option<String>,
}

impl Calibration {
    /// Reads a calibration.
    pub(super) fn read(source: Source, arguments: &LinearityArguments) -> Result<Self, Failure> {
        let file = source.name().to_owned();
        let selectors = selectors(arguments);
        let mut options = ScanOptions {
            key: arguments.direction.clone(),
            unbounded_rows: true,
            ..arguments.table.scan_options(&source, Some(&arguments.rows))?
        };
        let held = HeldRows::limiting(&mut options);
        let mut rows: Vec<Row> = Vec::new();
        let scanned = scan(source, &selectors, &options, rows_of, |batch: Vec<Row>| {
            held.add(batch.len());
            rows.extend(batch);
        });
        held.check(file.raw()).map_err(Failure::data)?;
        let scanned = scanned.map_err(Failure::data)?;
        let fail = |problem: String| Failure::data(format_args!("{file}: {problem}"));
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
            let pass = |pass| arguments.up.is_some().then_some(pass);
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
        let input = input(arguments, &options, scanned, (count, lacking), words);
        Ok(Calibration { readings, input })
    }
}

/// The columns of numbers.
fn selectors(arguments: &LinearityArguments) -> Vec<ColumnSelector> {
    let x = arguments.x.clone();
    match (&arguments.y, &arguments.up, &arguments.down) {
        (None, Some(up), Some(down)) => {
            let both = [up, down].map(|column| [column.clone().optional(), column.clone().presence()]);
            [x].into_iter().chain(both.into_iter().flatten()).collect()
        }
        // The command line asks for one or the other.
        (y, ..) => [x].into_iter().chain(y.clone()).collect(),
    }
}

/// The rows of a batch.
fn rows_of(batch: Batch) -> Vec<Row> {
    let words = batch.keys.as_ref();
    let row = |(position, row): (usize, boundfit_formats::TableRow)| {
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

/// What was read, for reports.
fn input(
    arguments: &LinearityArguments,
    options: &ScanOptions,
    scanned: Scanned,
    (rows, lacking): (usize, usize),
    words: [Vec<Foreign>; 2],
) -> LinearityInput {
    let name = |position: usize| scanned.names.get(position).cloned().unwrap_or_default();
    let response = match (&arguments.up, &scanned.key_name) {
        (Some(_), _) => ResponseColumns::Two { up: name(1), down: name(3) },
        (None, Some(direction)) => {
            ResponseColumns::Directed { y: name(1), direction: direction.clone(), words }
        }
        (None, None) => ResponseColumns::One(name(1)),
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
