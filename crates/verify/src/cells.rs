//! The way from the cells of a row to its half-planes (section 2).

use std::cell::OnceCell;
use std::io::Read;
use std::iter::successors;
use std::mem;

use boundfit_exact::{
    DecimalMark, Integer, Limit, Limits, PLAIN_DIGITS, PLAIN_EXPONENT, ParseNumberError, Rational, Reading,
    Work, WrittenDigits, is_missing, plain_decimal,
};

use crate::about::{About, ascending};
use crate::failure::{DataLimits, Failure, Refusal};
use crate::falsehood::Falsehood;
use crate::name::Name;
use crate::numbers::{Exact, Number, over_one_denominator, words_over_one_denominator};
use crate::plane::HalfPlane;
use crate::rows::{Cells, Rows};
use crate::shape::Quantity;

/// The meaning of rows: sums of multiples of the numbers in their cells. All of a row is computed in integers
/// over one denominator, which is never computed with: a half-plane is the same times any positive number.
pub(crate) struct Model {
    reading: Reading,
    limits: Limits,
    /// The cells that are read from each row, in this order.
    sources: Vec<Source>,
    phi: [Form; 2],
    bounds: Bounds,
    /// The distance that φ1 may be from its cell.
    x_error: Form,
    /// The denominator of all multiples.
    denominator: Integer,
    /// True if plain decimals keep to the limits of numbers, and are read as they are.
    takes_plain: bool,
    /// The numbers that were read from the row where all are plain decimals: mantissas and places.
    plain: Vec<(i64, u32)>,
    /// The numbers of any other row.
    numbers: Vec<Option<Number>>,
    /// Plain decimals over one denominator, if they are machine words there; none otherwise.
    words: Vec<i64>,
    /// The same in integers of any size, for a row of which something is asked that words do not tell.
    exact: OnceCell<Exact>,
    /// The powers of ten that rows need again and again, and those that are machine words.
    powers: Vec<Integer>,
    word_powers: Vec<i64>,
    /// The number of bits that a row's numbers are multiplied by, the work so far, and its limit.
    longest_vertex: u64,
    work: Work,
    most_work: u64,
}

/// The numbers of a row in integers: those of the data, all of them multiplied by the same positive number.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Row {
    pub(crate) phi: [Integer; 2],
    /// The bounds of φ·θ, as far as they exist.
    pub(crate) lower: Option<Integer>,
    pub(crate) upper: Option<Integer>,
    /// The possible error of φ1.
    pub(crate) x_error: Integer,
    /// The factor that multiplied the numbers.
    pub(crate) times: Integer,
}

/// A row in machine words, all of them the numbers of the data times the same positive number.
#[derive(Debug, Clone, Copy)]
pub(crate) struct WordRow {
    pub(crate) phi: [i64; 2],
    /// The bounds of φ·θ, as far as they exist.
    pub(crate) lower: Option<i64>,
    pub(crate) upper: Option<i64>,
}

/// Vertices of fewer bits cost nothing worth counting beside rows of usual numbers.
const FREE_BITS: u64 = 1 << 12;

/// Something that is read from every row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Source {
    quantity: Quantity,
    /// The column, from 1.
    column: usize,
    /// True if there may be none.
    is_optional: bool,
}

/// A sum of multiples of a row's numbers.
type Form = Vec<Term>;

/// A multiple of a number.
struct Term {
    /// The index of the number.
    index: usize,
    times: Integer,
    /// The multiplier once more, if it is a machine word.
    word: Option<i64>,
}

enum Bounds {
    /// Bounds around y.
    Around { y: Form, above: Form, below: Form },
    /// Bounds as they are read, as far as they exist.
    Between { lower: Option<usize>, upper: Option<usize> },
}

impl Model {
    pub(crate) fn new(about: &About, limits: &DataLimits, longest_vertex: u64) -> Self {
        let [(x, times), phi2, y, epsilon] = &about.model;
        let number = |(column, times): &(u64, Rational)| (Quantity::Number, *column, times.clone());
        let phi1 =
            vec![(Quantity::Number, *x, times.clone()), (Quantity::Number, 0, -(&about.x_origin * times))];
        let [above, below] = match (&about.law, &about.interval) {
            (Some(law), None) => law.each_ref().map(|terms| [vec![number(epsilon)], terms.clone()].concat()),
            _ => [vec![number(epsilon)], vec![number(epsilon)]],
        };
        let y = [y].into_iter().chain(&about.response).map(number).collect();
        let x_error: Vec<_> = about.x_error.iter().map(number).collect();
        let sums = [phi1, vec![number(phi2)], y, above, below];
        let denominators = sums.iter().flatten().chain(&x_error).map(|(.., times)| times.denominator());
        let denominator = denominators.fold(Integer::one(), |all, own| all.lcm(&own));
        // In the order in which the sums name them.
        let mut sources = Vec::new();
        let form = |terms: Vec<(Quantity, u64, Rational)>, sources: &mut Vec<Source>| {
            let term = |(quantity, column, times): (Quantity, u64, Rational)| {
                let index = index_of(sources, Source::new(quantity, column));
                let times = times.numerator() * denominator.quotient(&times.denominator());
                Term { index, word: times.to_i64(), times }
            };
            terms.into_iter().map(term).collect::<Form>()
        };
        let [phi1, phi2, y, above, below] = sums.map(|terms| form(terms, &mut sources));
        let bounds = match about.interval {
            None => Bounds::Around { y, above, below },
            Some(sides) => {
                let [lower, upper] = sides.map(|column| {
                    let source =
                        |column| Source { is_optional: true, ..Source::new(Quantity::Number, column) };
                    column.map(|column| index_of(&mut sources, source(column)))
                });
                Bounds::Between { lower, upper }
            }
        };
        let x_error = form(x_error, &mut sources);
        let Limits { digits, exponent } = limits.number;
        // Plain numbers keep to these.
        let takes_plain =
            about.reading == Reading::Decimal && digits >= PLAIN_DIGITS && exponent >= PLAIN_EXPONENT;
        let (reading, most_work, limits, phi) = (about.reading, limits.work, limits.number, [phi1, phi2]);
        let powers = (0..=PLAIN_DIGITS as u32).map(Integer::power_of_ten).collect();
        Model {
            reading,
            limits,
            sources,
            phi,
            bounds,
            x_error,
            denominator,
            takes_plain,
            plain: Vec::new(),
            numbers: Vec::new(),
            words: Vec::new(),
            exact: OnceCell::new(),
            powers,
            word_powers: successors(Some(1_i64), |power| power.checked_mul(10)).collect(),
            longest_vertex,
            work: Work::default(),
            most_work,
        }
    }

    /// Reads a row. Nothing else is computed of it but that its error bound is not negative.
    pub(crate) fn read_row(&mut self, row: u64, cells: Cells<'_>) -> Result<(), Failure> {
        self.numbers.clear();
        if self.read_plain(cells).is_none() {
            self.plain.clear();
            let mut numbers = mem::take(&mut self.numbers);
            for source in &self.sources {
                numbers.push(self.read(*source, row, cells)?);
            }
            self.numbers = numbers;
        }
        self.count_work(row)?;
        self.exact.take();
        if words_over_one_denominator(&self.plain, &self.word_powers, &mut self.words).is_none() {
            self.words.clear();
        }
        let is_negative = |form: &Form| match self.word_sum(form) {
            Some(sum) => sum < 0,
            None => self.sum(form).is_negative(),
        };
        let is_wrong = match &self.bounds {
            Bounds::Around { above, below, .. } => is_negative(above) || is_negative(below),
            Bounds::Between { .. } => false,
        };
        if is_wrong || is_negative(&self.x_error) {
            return Err(Falsehood::NegativeErrorBound(row).into());
        }
        Ok(())
    }

    /// Reads a row of plain decimals, as almost all are; `None` where something in it is none.
    fn read_plain(&mut self, cells: Cells<'_>) -> Option<()> {
        self.plain.clear();
        for Source { quantity, column, .. } in &self.sources {
            let (mantissa, exponent) = match (quantity, column) {
                (Quantity::Number | Quantity::Abs, 0) => (1, 0),
                (Quantity::Number, column) if self.takes_plain => cells.decimal(*column)?,
                _ => return None,
            };
            self.plain.push((mantissa, u32::try_from(-exponent).ok()?));
        }
        Some(())
    }

    /// Adds the row that was read to the work on all of them, and refuses what passes the limit.
    fn count_work(&mut self, row: u64) -> Result<(), Failure> {
        let is_long = |number: &Number| matches!(number, Number::Fraction(_));
        if self.longest_vertex < FREE_BITS && !self.numbers.iter().flatten().any(is_long) {
            return Ok(());
        }
        let long = self.numbers.iter().flatten().filter_map(|number| match number {
            Number::Fraction(number) => Some(number),
            Number::Decimal { .. } => None,
        });
        let bits: u64 = long.clone().map(Rational::bits).sum();
        let row = usize::try_from(row).unwrap_or_default();
        self.work.add_products(row, long, self.longest_vertex.max(bits));
        self.work.check(1, self.most_work).map_err(|refused| Failure::Refused(refused.into()))
    }

    /// Returns whether the row that was read says something from below, and from above.
    pub(crate) fn sides(&self) -> [bool; 2] {
        let is_there = |index: usize| {
            self.plain.get(index).is_some() || self.numbers.get(index).is_some_and(Option::is_some)
        };
        match &self.bounds {
            Bounds::Around { .. } => [true; 2],
            Bounds::Between { lower, upper } => [lower, upper].map(|side| side.is_some_and(is_there)),
        }
    }

    /// -φ·θ ≤ -(what the row that was read says from below).
    pub(crate) fn lower(&self) -> HalfPlane {
        HalfPlane {
            a: self.phi.each_ref().map(|form| -self.sum(form)),
            b: -self.lower_bound(),
            times: self.times(),
        }
    }

    /// φ·θ ≤ what the row that was read says from above.
    pub(crate) fn upper(&self) -> HalfPlane {
        HalfPlane {
            a: self.phi.each_ref().map(|form| self.sum(form)),
            b: self.upper_bound(),
            times: self.times(),
        }
    }

    /// The row that was read.
    pub(crate) fn row(&self) -> Row {
        let [lower, upper] = self.sides();
        Row {
            phi: self.phi.each_ref().map(|form| self.sum(form)),
            lower: lower.then(|| self.lower_bound()),
            upper: upper.then(|| self.upper_bound()),
            x_error: self.sum(&self.x_error),
            times: self.times(),
        }
    }

    /// The row that was read in machine words; `None` where a number or a sum does not fit.
    pub(crate) fn word_row(&self) -> Option<WordRow> {
        let [phi1, phi2] = &self.phi;
        let (lower, upper) = match &self.bounds {
            Bounds::Around { y, above, below } => {
                let y = self.word_sum(y)?;
                (Some(y.checked_sub(self.word_sum(below)?)?), Some(y.checked_add(self.word_sum(above)?)?))
            }
            Bounds::Between { lower, upper } => {
                let denominator = self.denominator.to_i64()?;
                let bound = |side: &Option<usize>| match side {
                    None => Some(None),
                    Some(index) => self.words.get(*index)?.checked_mul(denominator).map(Some),
                };
                (bound(lower)?, bound(upper)?)
            }
        };
        Some(WordRow { phi: [self.word_sum(phi1)?, self.word_sum(phi2)?], lower, upper })
    }

    /// A sum in machine words; `None` where something does not fit.
    fn word_sum(&self, form: &Form) -> Option<i64> {
        form.iter().try_fold(0_i64, |sum, term| {
            sum.checked_add(self.words.get(term.index)?.checked_mul(term.word?)?)
        })
    }

    fn lower_bound(&self) -> Integer {
        match &self.bounds {
            Bounds::Around { y, below, .. } => self.sum(y) - self.sum(below),
            Bounds::Between { lower, .. } => self.bound(*lower),
        }
    }

    fn upper_bound(&self) -> Integer {
        match &self.bounds {
            Bounds::Around { y, above, .. } => self.sum(y) + self.sum(above),
            Bounds::Between { upper, .. } => self.bound(*upper),
        }
    }

    /// The numbers of the row that was read, in integers of any size.
    fn exact(&self) -> &Exact {
        self.exact.get_or_init(|| {
            let decimal = |&(mantissa, places): &(i64, u32)| Some(Number::Decimal { mantissa, places });
            let plain: Vec<Option<Number>> = self.plain.iter().map(decimal).collect();
            over_one_denominator(if plain.is_empty() { &self.numbers } else { &plain }, &self.powers)
        })
    }

    /// Returns the factor that multiplies all numbers of the row.
    fn times(&self) -> Integer {
        &self.denominator * &self.exact().one
    }

    /// A bound that is read itself.
    fn bound(&self, index: Option<usize>) -> Integer {
        let integer = index.and_then(|index| self.exact().integers.get(index));
        integer.map_or_else(Integer::zero, |integer| integer * &self.denominator)
    }

    fn sum(&self, form: &Form) -> Integer {
        let integers = &self.exact().integers;
        let term = |Term { index, times, .. }: &Term| integers.get(*index).map(|integer| integer * times);
        let mut terms = form.iter().filter_map(term);
        let first = terms.next().unwrap_or_default();
        terms.fold(first, |sum, term| sum + term)
    }

    /// Returns what a source has in a row; `None` where it may have nothing and has nothing.
    fn read(&self, source: Source, row: u64, cells: Cells<'_>) -> Result<Option<Number>, Failure> {
        let Source { quantity, column, is_optional } = source;
        if column == 0 {
            return match quantity {
                Quantity::Written => Err(Falsehood::NoLastDigit { row, column }.into()),
                Quantity::Number | Quantity::Abs => Ok(Some(Number::decimal(1, 0))),
            };
        }
        let cell = cells.get(column).ok_or(Falsehood::MissingCell { row, column })?;
        if is_optional && is_missing(&String::from_utf8_lossy(cell)) {
            return Ok(None);
        }
        let number = self.number(cell).map_err(|error| match Limit::of_number(&error.kind) {
            Some(_) => Failure::Refused(Refusal::Number { row, column, error }),
            None => Falsehood::NotANumber { row, column, error }.into(),
        })?;
        Ok(Some(match quantity {
            Quantity::Number => number,
            Quantity::Abs => number.abs(),
            Quantity::Written => {
                let digits = WrittenDigits::of(&String::from_utf8_lossy(cell), Some(DecimalMark::Point));
                let digits = digits.ok_or(Falsehood::NoLastDigit { row, column })?;
                Number::decimal(5, digits.last_place - 1)
            }
        }))
    }

    /// The number that a cell spells.
    fn number(&self, cell: &[u8]) -> Result<Number, ParseNumberError> {
        match plain_decimal(cell).filter(|_| self.takes_plain) {
            Some((mantissa, exponent)) => Ok(Number::decimal(mantissa, exponent.into())),
            None => self.reading.read(&String::from_utf8_lossy(cell), &self.limits).map(Number::Fraction),
        }
    }
}

impl About {
    /// Hands over each half-plane of the wanted rows, but of those that may be passed over, then of the conditions, by its name
    /// and what computes it (section 2).
    pub(crate) fn for_each_half_plane<R: Read>(
        &self,
        rows: &mut Rows<R>,
        limits: &DataLimits,
        longest_vertex: u64,
        mut passes_over: impl FnMut(u64, &Model) -> bool,
        mut take: impl FnMut(Name, &dyn Fn() -> HalfPlane) -> Result<(), Falsehood>,
    ) -> Result<(), Failure> {
        self.for_each_row(rows, limits, longest_vertex, |row, model| {
            if passes_over(row, model) {
                return Ok(());
            }
            let [lower, upper] = model.sides();
            if lower {
                take(Name::Lower(row), &|| model.lower())?;
            }
            if upper {
                take(Name::Upper(row), &|| model.upper())?;
            }
            Ok(())
        })?;
        for (name, half_plane) in self.conditions_by_name() {
            take(name, &|| half_plane.clone())?;
        }
        Ok(())
    }

    /// Hands over each wanted row as it is read (section 2).
    pub(crate) fn for_each_row<R: Read>(
        &self,
        rows: &mut Rows<R>,
        limits: &DataLimits,
        longest_vertex: u64,
        mut take: impl FnMut(u64, &Model) -> Result<(), Falsehood>,
    ) -> Result<(), Failure> {
        let mut model = Model::new(self, limits, longest_vertex);
        let start = rows.count();
        for [first, last] in ascending(&self.rows)? {
            while rows.count() - start < first - 1 {
                if !rows.next()? {
                    return Err(Falsehood::MissingRow(first).into());
                }
            }
            for row in first..=last {
                if !rows.next()? {
                    return Err(Falsehood::MissingRow(row).into());
                }
                model.read_row(row, rows.cells())?;
                take(row, &model)?;
            }
        }
        Ok(())
    }
}

impl Source {
    fn new(quantity: Quantity, column: u64) -> Self {
        let column = usize::try_from(column).unwrap_or(usize::MAX);
        Source { quantity, column, is_optional: false }
    }
}

/// Returns where a source is among those that are read, at the end if it was not there.
fn index_of(sources: &mut Vec<Source>, source: Source) -> usize {
    let known = sources.iter().position(|known| *known == source);
    known.unwrap_or_else(|| {
        sources.push(source);
        sources.len() - 1
    })
}
