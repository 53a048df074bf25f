//! The values that predictions are asked about.

use std::sync::Arc;

use boundfit_exact::{Column, Limit, Rational, Reading, Work};
use boundfit_formats::{Batch, ColumnSelector, HeldRows, ScanOptions, TableOptions, scan};

use crate::asked::Asked;
use crate::given;
use crate::refusal::{Refusal, ValueProblem};

/// The most values of a grid: JSON has 2 kB about each, and nobody types them one by one.
const MOST_STEPS: usize = 100_000;

/// Values of one key.
#[derive(Default)]
pub(super) struct Values {
    parts: Vec<Part>,
    /// The second number of a value with a single number.
    second: Rational,
}

/// Some of them.
enum Part {
    Given(Vec<[Rational; 2]>),
    /// Columns of a file, a part of it each.
    Read(Vec<Vec<Column>>),
    Grid {
        from: Rational,
        step: Rational,
        count: usize,
    },
}

/// A key of values.
#[derive(Clone, Copy)]
pub(super) struct ValueKey {
    pub(super) key: &'static str,
    /// The number of numbers in a value.
    pub(super) numbers: usize,
    /// The second number of a value with a single number.
    pub(super) second: i64,
}

impl ValueKey {
    /// The values of a text: numbers, or what the columns of a table hold.
    fn read(self, text: &str, asked: &Asked) -> Result<Part, Refusal> {
        let expected = match self.numbers {
            1 => "expected numbers such as 3.7,9/2, or FILE:COL",
            _ => "expected pairs of numbers such as '1;2,3;4', or FILE:COL;COL2",
        };
        let limits = &asked.options.table.limits;
        let numbers = |value: &str| {
            let parts: Vec<&str> = value.split(';').collect();
            if parts.len() != self.numbers {
                return Err(ValueProblem::Expected(expected));
            }
            let read = parts.iter().map(|part| Reading::Decimal.read(part.trim(), limits));
            let read = read.collect::<Result<Vec<Rational>, _>>();
            let mut read = read.map_err(|error| ValueProblem::Number { error, expected })?.into_iter();
            let first = read.next().unwrap_or_default();
            Ok([first, read.next().unwrap_or_else(|| Rational::from(self.second))])
        };
        let all = text.split(',').map(numbers).collect::<Result<Vec<[Rational; 2]>, ValueProblem>>();
        let problem = match (all, text.rsplit_once(':')) {
            (Ok(all), _) => return Ok(Part::Given(all)),
            (Err(problem), None) => problem,
            (Err(_), Some((name, columns))) => {
                let columns: Vec<&str> = columns.split(';').collect();
                let are_named = columns.iter().all(|column| !column.trim().is_empty());
                if columns.len() == self.numbers && are_named && !name.is_empty() {
                    let columns: Vec<ColumnSelector> =
                        columns.into_iter().map(ColumnSelector::name_or_number).collect();
                    return Ok(Part::Read(read(name, &columns, asked)?));
                }
                ValueProblem::Expected(expected)
            }
        };
        Err(Refusal::Value { key: self.key, text: text.to_owned(), problem })
    }
}

impl Values {
    /// The values of texts, each of which is numbers or columns of a table.
    pub(super) fn read(key: ValueKey, texts: &[String], asked: &Asked) -> Result<Self, Refusal> {
        let parts = texts.iter().map(|text| key.read(text, asked)).collect::<Result<_, _>>()?;
        Ok(Values { parts, second: Rational::from(key.second) })
    }

    /// Puts values in equal steps before the others.
    pub(super) fn with_grid(mut self, text: &str, asked: &Asked) -> Result<Self, Refusal> {
        const EXPECTED: &str =
            "expected FROM..TO/N with FROM < TO and N steps between them, such as 0..10/100";
        let refuse = |problem| Refusal::Value { key: "grid", text: text.to_owned(), problem };
        let bad = || refuse(ValueProblem::Expected(EXPECTED));
        let TableOptions { limits, sizes, .. } = &asked.options.table;
        let most = sizes.rows;
        // The last stroke stands before N: both ends may be fractions.
        let (ends, count) = text.rsplit_once('/').ok_or_else(bad)?;
        let (from, to) = given::ends(ends).ok_or_else(bad)?;
        let number = |text: &str| {
            let number = Reading::Decimal.read(text.trim(), limits);
            number.map_err(|error| {
                refuse(ValueProblem::Part { part: text.to_owned(), error, expected: EXPECTED })
            })
        };
        let (from, to) = (number(from)?, number(to)?);
        let steps: usize = count.trim().parse().map_err(|_| bad())?;
        if steps >= MOST_STEPS && most > MOST_STEPS {
            let problem = match asked.tables {
                Some(_) => "refused: more than 100000 values (expected fewer, or FILE:COL)",
                None => "refused: more than 100000 values (expected fewer)",
            };
            return Err(refuse(ValueProblem::Expected(problem)));
        }
        if steps >= most {
            return Err(refuse(ValueProblem::TooMany { most, limit: Limit::Rows }));
        }
        let step = (&to - &from).checked_div(&Rational::from(steps)).ok_or_else(bad)?;
        if !step.is_positive() {
            return Err(bad());
        }
        self.parts.insert(0, Part::Grid { from, step, count: steps + 1 });
        Ok(self)
    }

    pub(super) fn len(&self) -> usize {
        let of = |part: &Part| match part {
            Part::Given(values) => values.len(),
            Part::Read(batches) => batches.iter().map(|columns| columns.first().map_or(0, Column::len)).sum(),
            Part::Grid { count, .. } => *count,
        };
        self.parts.iter().map(of).sum()
    }

    /// The values, in the order in which they were asked for.
    pub(super) fn iter(&self) -> Box<dyn Iterator<Item = [Rational; 2]> + '_> {
        Box::new(self.parts.iter().flat_map(|part| self.values(part)))
    }

    fn values<'a>(&'a self, part: &'a Part) -> Box<dyn Iterator<Item = [Rational; 2]> + 'a> {
        match part {
            Part::Given(values) => Box::new(values.iter().cloned()),
            Part::Grid { from, step, count } => {
                let at = move |index| from + step * Rational::from(index);
                Box::new((0..*count).map(move |index| [at(index), self.second.clone()]))
            }
            Part::Read(batches) => Box::new(batches.iter().flat_map(move |columns| {
                let rows = columns.first().map_or(0, Column::len);
                let second = move |row| match columns.get(1) {
                    Some(column) => column.get(row),
                    None => self.second.clone(),
                };
                (0..rows).filter_map(move |row| Some([columns.first()?.get(row), second(row)]))
            })),
        }
    }

    /// Returns the work of arithmetic on the values and on other numbers with the given bits.
    pub(super) fn work(&self, bits: u64) -> Work {
        let mut work = Work::default();
        for part in &self.parts {
            // Steps are all about as long as the last one: where that costs nothing, none does.
            if let Part::Grid { from, step, count } = part {
                let last = from + step * Rational::from(*count);
                let mut longest = Work::default();
                longest.add_products(1, [&last, from], bits);
                if longest.products(1) == 0 {
                    continue;
                }
            }
            for (value, row) in self.values(part).zip(1..) {
                work.add_products(row, value.iter(), bits);
            }
        }
        work
    }
}

/// The columns of a table.
fn read(name: &str, columns: &[ColumnSelector], asked: &Asked) -> Result<Vec<Vec<Column>>, Refusal> {
    let tables = asked.tables()?;
    let (source, options) = tables.open(name)?;
    let file = source.name().to_owned();
    let mut options = ScanOptions { hash: false, list_rows: false, ..options };
    let held: Arc<HeldRows> = HeldRows::limiting(&mut options);
    let mut batches = Vec::new();
    let scanned = scan(
        source,
        columns,
        &options,
        |batch: Batch| batch.columns,
        |columns| {
            held.add(columns.first().map_or(0, Column::len));
            batches.push(columns);
        },
    );
    held.check(file.raw())?;
    let scanned = scanned?;
    tables.was_read(name, scanned.table.as_ref(), scanned.rows_missing);
    Ok(batches)
}
