//! From the cells of a row to its half-planes (section 2).

use std::borrow::Cow;
use std::mem;

use boundfit_exact::{
    DecimalMark, Integer, Limit, Limits, PLAIN_DIGITS, PLAIN_EXPONENT, ParseNumberError, Rational, Reading,
    WrittenDigits, is_missing, plain_decimal,
};

use crate::failure::{Failure, Refusal};
use crate::falsehood::Falsehood;
use crate::plane::HalfPlane;
use crate::proof::About;
use crate::rows::Cells;
use crate::shape::Quantity;

/// What rows stand for: sums of multiples of what is in their cells. All of a row is computed in integers over one
/// denominator, which is never computed with: a half-plane is the same times any positive number.
pub(crate) struct Model {
    reading: Reading,
    limits: Limits,
    /// What is read from each row, in this order.
    sources: Vec<Source>,
    phi: [Form; 2],
    bounds: Bounds,
    /// The denominator of all multiples.
    denominator: Integer,
    /// What was read from the row, and the same over one denominator.
    numbers: Vec<Option<Number>>,
    integers: Vec<Integer>,
    /// The powers of ten that rows need again and again.
    powers: Vec<Integer>,
}

/// Something that is read from every row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Source {
    quantity: Quantity,
    /// From 1.
    column: usize,
    /// Whether there may be none.
    is_optional: bool,
}

/// A sum: an index of `integers`, and how many times it is taken.
type Form = Vec<(usize, Integer)>;

enum Bounds {
    /// Around y.
    Around { y: Form, above: Form, below: Form },
    /// Between what is read, as far as there is something.
    Between { lower: Option<usize>, upper: Option<usize> },
}

/// numerator / (divisor · 10^places).
struct Number {
    numerator: Integer,
    places: u32,
    divisor: Integer,
}

impl Number {
    /// mantissa · 10^exponent.
    fn decimal(mantissa: impl Into<Integer>, exponent: i64) -> Self {
        let power = u32::try_from(exponent.unsigned_abs()).unwrap_or(u32::MAX);
        let (numerator, places) = match exponent {
            ..=0 => (mantissa.into(), power),
            _ => (mantissa.into() * Integer::power_of_ten(power), 0),
        };
        Number { numerator, places, divisor: Integer::one() }
    }
}

impl From<Rational> for Number {
    fn from(number: Rational) -> Self {
        Number { numerator: number.numerator(), places: 0, divisor: number.denominator() }
    }
}

impl Model {
    pub(crate) fn new(about: &About, limits: &Limits) -> Self {
        let [(x, times), phi2, y, epsilon] = &about.model;
        let number = |(column, times): &(u64, Rational)| (Quantity::Number, *column, times.clone());
        let phi1 =
            vec![(Quantity::Number, *x, times.clone()), (Quantity::Number, 0, -(&about.x_origin * times))];
        let [above, below] = match (&about.law, &about.interval) {
            (Some(law), None) => law.each_ref().map(|terms| [vec![number(epsilon)], terms.clone()].concat()),
            _ => [vec![number(epsilon)], vec![number(epsilon)]],
        };
        let sums = [phi1, vec![number(phi2)], vec![number(y)], above, below];
        let denominators = sums.iter().flatten().map(|(.., times)| times.denominator());
        let denominator = denominators.fold(Integer::one(), |all, own| all.lcm(&own));
        // In the order in which the sums name them.
        let mut sources = Vec::new();
        let [phi1, phi2, y, above, below] = sums.map(|terms| {
            let term = |(quantity, column, times): (Quantity, u64, Rational)| {
                let index = index_of(&mut sources, Source::new(quantity, column));
                (index, times.numerator() * denominator.quotient(&times.denominator()))
            };
            terms.into_iter().map(term).collect::<Form>()
        });
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
        let (reading, limits, phi) = (about.reading, *limits, [phi1, phi2]);
        let powers = (0..=PLAIN_DIGITS as u32).map(Integer::power_of_ten).collect();
        Model {
            reading,
            limits,
            sources,
            phi,
            bounds,
            denominator,
            numbers: Vec::new(),
            integers: Vec::new(),
            powers,
        }
    }

    /// The half-planes of a row: what it says from below, and from above.
    pub(crate) fn half_planes(
        &mut self,
        row: u64,
        cells: Cells<'_>,
    ) -> Result<[Option<HalfPlane>; 2], Failure> {
        let mut numbers = mem::take(&mut self.numbers);
        numbers.clear();
        for source in &self.sources {
            numbers.push(self.read(*source, row, cells)?);
        }
        let one = over_one_denominator(&numbers, &self.powers, &mut self.integers);
        let is_there = |index: &usize| numbers.get(*index).is_some_and(Option::is_some);
        let phi = [self.sum(&self.phi[0]), self.sum(&self.phi[1])];
        let [lower, upper] = match &self.bounds {
            Bounds::Around { y, above, below } => {
                let (y, above, below) = (self.sum(y), self.sum(above), self.sum(below));
                if above.is_negative() || below.is_negative() {
                    return Err(Falsehood::NegativeErrorBound(row).into());
                }
                [Some(&y - below), Some(y + above)]
            }
            Bounds::Between { lower, upper } => [lower, upper].map(|side| {
                let integer = side.filter(is_there).and_then(|index| self.integers.get(index));
                integer.map(|integer| integer * &self.denominator)
            }),
        };
        self.numbers = numbers;
        let times = &self.denominator * &one;
        let opposite = [-&phi[0], -&phi[1]];
        let lower = lower.map(|b| HalfPlane { a: opposite, b: -b, times: times.clone() });
        let upper = upper.map(|b| HalfPlane { a: phi, b, times });
        Ok([lower, upper])
    }

    fn sum(&self, form: &Form) -> Integer {
        let term =
            |(index, times): &(usize, Integer)| self.integers.get(*index).map(|integer| integer * times);
        let mut terms = form.iter().filter_map(term);
        let first = terms.next().unwrap_or_default();
        terms.fold(first, |sum, term| sum + term)
    }

    /// What a source has in a row; `None` where it may have nothing and has nothing.
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
            Quantity::Abs => Number { numerator: number.numerator.abs(), ..number },
            Quantity::Written => {
                let digits = WrittenDigits::of(&String::from_utf8_lossy(cell), Some(DecimalMark::Point));
                let digits = digits.ok_or(Falsehood::NoLastDigit { row, column })?;
                Number::decimal(5, digits.last_place - 1)
            }
        }))
    }

    /// The number that a cell spells.
    fn number(&self, cell: &[u8]) -> Result<Number, ParseNumberError> {
        let Limits { digits, exponent } = self.limits;
        // What is plain keeps to these.
        let is_fast =
            self.reading == Reading::Decimal && digits >= PLAIN_DIGITS && exponent >= PLAIN_EXPONENT;
        match plain_decimal(cell).filter(|_| is_fast) {
            Some((mantissa, exponent)) => Ok(Number::decimal(mantissa, exponent.into())),
            None => self.reading.read(&String::from_utf8_lossy(cell), &self.limits).map(Number::from),
        }
    }
}

impl Source {
    fn new(quantity: Quantity, column: u64) -> Self {
        let column = usize::try_from(column).unwrap_or(usize::MAX);
        Source { quantity, column, is_optional: false }
    }
}

/// Where a source is among those that are read, at the end if it was not there.
fn index_of(sources: &mut Vec<Source>, source: Source) -> usize {
    let known = sources.iter().position(|known| *known == source);
    known.unwrap_or_else(|| {
        sources.push(source);
        sources.len() - 1
    })
}

/// Multiplies numbers, 0 in place of one that is not there, by a common denominator, which it gives back.
fn over_one_denominator(
    numbers: &[Option<Number>],
    powers: &[Integer],
    integers: &mut Vec<Integer>,
) -> Integer {
    let power = |places: u32| match powers.get(places as usize) {
        Some(power) => Cow::Borrowed(power),
        None => Cow::Owned(Integer::power_of_ten(places)),
    };
    let there = || numbers.iter().flatten();
    let places = there().map(|number| number.places).max().unwrap_or(0);
    let divisor = there().fold(Integer::one(), |all, number| all.lcm(&number.divisor));
    integers.clear();
    integers.extend(numbers.iter().map(|number| match number {
        None => Integer::zero(),
        Some(Number { numerator, places: own, divisor: own_divisor }) => {
            numerator * &*power(places - own) * divisor.quotient(own_divisor)
        }
    }));
    &*power(places) * divisor
}
