//! Columns of exact numbers, as compact as the numbers allow.

mod alike;
mod decimals;
mod long;
mod places;
mod rounded;
mod scaled;
mod scattered;
mod unit;

use std::borrow::Cow;
use std::ops::Range;

use crate::Rational;
use long::long_number;

pub use long::{Long, LongProducts, LongTotal, compare_words};
pub use scaled::{Count, NarrowCount, NarrowUnit, Scaled};
pub use scattered::Scattered;
pub use unit::Unit;

/// Exact numbers in the order in which they were added. The storage follows from the lengths of the numbers, and no
/// answer depends on it.
///
/// ```
/// use boundfit_exact::{Column, Rational};
///
/// let mut column = Column::default();
/// column.push_decimal(15, -1);
/// column.push(Rational::ratio(1, 3));
/// assert_eq!([column.get(0), column.get(1)], [Rational::ratio(3, 2), Rational::ratio(1, 3)]);
/// assert!(matches!(column, Column::Narrow(scaled) if scaled.counts() == [45, 10]));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum Column {
    /// Integers of 64 bits on a common unit.
    Narrow(Scaled<i64>),
    /// Integers of 128 bits on a common unit.
    Wide(Scaled<i128>),
    /// Decimals of more digits, in words.
    Long(Long),
    /// Finite doubles, each meant exactly; zero is never negative. They are a kind of their own because no integers of
    /// these sizes hold numbers whose exponents differ by 2000, and because floats compare and add them faster.
    Doubles(Vec<f64>),
    /// Decimals of few digits that differ so much in size that no words on a common unit hold them.
    Scattered(Scattered),
    /// Numbers that are none of these.
    Fractions(Vec<Rational>),
}

impl Default for Column {
    fn default() -> Self {
        Column::Narrow(Scaled::default())
    }
}

impl FromIterator<Rational> for Column {
    fn from_iter<T: IntoIterator<Item = Rational>>(numbers: T) -> Self {
        let mut column = Column::default();
        numbers.into_iter().for_each(|number| column.push(number));
        column
    }
}

impl Column {
    /// Returns a column of these counts of units. Exact.
    pub fn of_counts(counts: impl Iterator<Item = i128> + Clone, unit: Unit) -> Self {
        if let Some(narrow) = Scaled::new(counts.clone(), unit) {
            return Column::Narrow(narrow);
        }
        if let Some(wide) = Scaled::new(counts.clone(), unit) {
            return Column::Wide(wide);
        }
        Column::Fractions(counts.map(|count| unit.times(count)).collect())
    }

    /// Returns a column of these counts of units; `None` where one of them has more than 62 bits. Exact. Cost: a look at each.
    pub fn of_short_counts(counts: Vec<i64>, unit: Unit) -> Option<Self> {
        let all = counts.iter().fold(0, |all, &count| all | count.unsigned_abs());
        (all >> <i64 as Count>::BITS == 0).then(|| Column::Narrow(Scaled::of_counts(counts, unit)))
    }

    /// Returns a column of these counts of units, given by their offsets above one of them. Exact. Cost: an addition
    /// each.
    pub fn of_offsets(base: i64, offsets: &[u32], unit: Unit) -> Self {
        let widest = base.unsigned_abs().saturating_add(u32::MAX.into());
        if widest >> <i64 as Count>::BITS != 0 {
            return Column::of_counts(
                offsets.iter().map(|&offset| i128::from(base) + i128::from(offset)),
                unit,
            );
        }
        // Neither a sum of fewer bits than a word has overflows, nor is a look needed at any.
        let counts = offsets.iter().map(|&offset| base.wrapping_add(offset.into())).collect();
        Column::Narrow(Scaled::of_counts(counts, unit))
    }

    /// The number of numbers there are.
    pub fn len(&self) -> usize {
        match self {
            Column::Narrow(scaled) => scaled.counts().len(),
            Column::Wide(scaled) => scaled.counts().len(),
            Column::Long(long) => long.len(),
            Column::Doubles(doubles) => doubles.len(),
            Column::Scattered(scattered) => scattered.numbers().len(),
            Column::Fractions(numbers) => numbers.len(),
        }
    }

    /// Returns whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// A number, exactly.
    ///
    /// # Panics
    /// When there are not that many.
    #[allow(
        clippy::indexing_slicing,
        reason = "documented to panic; who asks counts the rows of the same column"
    )]
    pub fn get(&self, index: usize) -> Rational {
        match self {
            Column::Narrow(scaled) => scaled.unit().times(scaled.counts()[index].into()),
            Column::Wide(scaled) => scaled.unit().times(scaled.counts()[index]),
            Column::Long(long) => long.get(index),
            Column::Doubles(doubles) => Rational::from_f64(doubles[index]).unwrap_or_default(),
            Column::Scattered(scattered) => Scattered::number(scattered.numbers()[index]),
            Column::Fractions(numbers) => numbers[index].clone(),
        }
    }

    /// The position of the first number below 0.
    pub fn first_negative(&self) -> Option<usize> {
        match self {
            Column::Narrow(scaled) => scaled.counts().iter().position(|&count| count < 0),
            Column::Wide(scaled) => scaled.counts().iter().position(|&count| count < 0),
            Column::Long(long) => long.numbers().position(|words| words.iter().any(|&word| word < 0)),
            Column::Doubles(doubles) => doubles.iter().position(|&double| double < 0.0),
            Column::Scattered(scattered) => scattered.numbers().iter().position(|number| number.0 < 0),
            Column::Fractions(numbers) => numbers.iter().position(Rational::is_negative),
        }
    }

    /// Returns whether there is a 0. Cost: linear.
    pub fn has_zero(&self) -> bool {
        match self {
            Column::Narrow(scaled) => scaled.counts().contains(&0),
            Column::Wide(scaled) => scaled.counts().contains(&0),
            Column::Long(long) => long.numbers().any(|words| words.iter().all(|&word| word == 0)),
            Column::Doubles(doubles) => doubles.contains(&0.0),
            Column::Scattered(scattered) => scattered.numbers().iter().any(|number| number.0 == 0),
            Column::Fractions(numbers) => numbers.iter().any(Rational::is_zero),
        }
    }

    /// The integers of 64 bits, if it is a column of these.
    pub fn as_narrow_mut(&mut self) -> Option<&mut Scaled<i64>> {
        if let Column::Narrow(scaled) = self { Some(scaled) } else { None }
    }

    /// The numbers as wide integers, unless these do not hold them.
    pub fn wide(&self) -> Option<Cow<'_, Scaled<i128>>> {
        match self {
            Column::Narrow(scaled) => Some(Cow::Owned(scaled.widened())),
            Column::Wide(scaled) => Some(Cow::Borrowed(scaled)),
            Column::Long(_) | Column::Doubles(_) | Column::Scattered(_) | Column::Fractions(_) => None,
        }
    }

    /// The numbers in words, unless these do not hold them.
    pub fn long(&self) -> Option<Cow<'_, Long>> {
        let of_counts = |counts: &mut dyn Iterator<Item = i128>, unit| Long::of_counts(counts, unit);
        match self {
            Column::Narrow(scaled) => {
                of_counts(&mut scaled.counts().iter().map(|&count| count.into()), scaled.unit())
                    .map(Cow::Owned)
            }
            Column::Wide(scaled) => {
                of_counts(&mut scaled.counts().iter().copied(), scaled.unit()).map(Cow::Owned)
            }
            Column::Long(long) => Some(Cow::Borrowed(long)),
            Column::Doubles(_) | Column::Scattered(_) | Column::Fractions(_) => None,
        }
    }

    /// Makes room for exactly so many more numbers.
    pub fn reserve(&mut self, more: usize) {
        match self {
            Column::Narrow(scaled) => scaled.reserve(more),
            Column::Wide(scaled) => scaled.reserve(more),
            Column::Long(long) => long.reserve(more),
            Column::Doubles(doubles) => doubles.reserve_exact(more),
            Column::Scattered(scattered) => scattered.numbers_mut().reserve_exact(more),
            Column::Fractions(numbers) => numbers.reserve_exact(more),
        }
    }

    /// Adds `mantissa · 10^exponent`. Cost: a few nanoseconds when a number before has this exponent or a lower one.
    #[inline]
    pub fn push_decimal(&mut self, mantissa: i64, exponent: i32) {
        if let Column::Narrow(scaled) = self
            && let Some(count) = scaled.narrow_unit().count(mantissa, exponent)
        {
            scaled.push_narrow(count);
            return;
        }
        if let Column::Wide(scaled) = self
            && scaled.push_word(mantissa.into(), exponent)
        {
            return;
        }
        self.push_count(mantissa.into(), Unit::TenTo(exponent));
    }

    /// Adds `mantissa · 10^exponent` `times` times. Cost: a word for each number if the column is narrow.
    pub fn push_repeated(&mut self, mantissa: i64, exponent: i32, times: usize) {
        // The first one settles the unit.
        let Some(more) = times.checked_sub(1) else { return };
        self.push_decimal(mantissa, exponent);
        let is_added =
            self.as_narrow_mut().is_some_and(|scaled| scaled.push_repeated(mantissa, exponent, more));
        if !is_added {
            (0..more).for_each(|_| self.push_decimal(mantissa, exponent));
        }
    }

    /// Adds `mantissa · 10^exponent` with a long mantissa.
    #[inline]
    pub fn push_long_decimal(&mut self, mantissa: i128, exponent: i32) {
        if let Column::Wide(scaled) = self
            && scaled.push_word(mantissa, exponent)
        {
            return;
        }
        match i64::try_from(mantissa) {
            Ok(mantissa) => self.push_decimal(mantissa, exponent),
            Err(_) => self.push_count(mantissa, Unit::TenTo(exponent)),
        }
    }

    /// Adds the decimal that is all of a text, if it has more digits than other columns take. Its form is a sign or
    /// none, digits with or without a point, an exponent or none. Gives `false` for other texts, and for numbers so
    /// long that only fractions hold them beside the others.
    pub fn push_text(&mut self, text: &[u8]) -> bool {
        let Some(number) = long_number(text) else { return false };
        if !matches!(self, Column::Long(_)) {
            match self.long() {
                Some(long) => *self = Column::Long(long.into_owned()),
                None => return false,
            }
        }
        let Column::Long(long) = self else { return false };
        long.push(&number).is_some()
    }

    /// Adds a number.
    pub fn push(&mut self, number: Rational) {
        match (number.numerator().to_i128(), number.denominator().to_i128()) {
            (Some(numerator), Some(denominator)) => self.push_count(numerator, Unit::OneOver(denominator)),
            _ => self.push_fraction(number),
        }
    }

    /// Adds a finite double, meant exactly. A column of nothing else stays one.
    #[inline]
    pub fn push_double(&mut self, double: f64) {
        // Zero has one sign.
        let double = double + 0.0;
        match self {
            Column::Doubles(doubles) => doubles.push(double),
            other => other.push_other_double(double),
        }
    }

    #[cold]
    fn push_other_double(&mut self, double: f64) {
        match self.is_empty() {
            true => *self = Column::Doubles(vec![double]),
            false => self.push(Rational::from_f64(double).unwrap_or_default()),
        }
    }

    /// Finite doubles, each meant exactly; `Err` with the position of the first infinity or NaN.
    pub fn of_doubles(doubles: &[f64]) -> Result<Self, usize> {
        // Zero has one sign.
        let column: Vec<f64> = doubles.iter().map(|double| double + 0.0).collect();
        let are_finite = column.iter().fold(true, |all, double| all & double.is_finite());
        let first = || doubles.iter().position(|double| !double.is_finite());
        match if are_finite { None } else { first() } {
            Some(position) => Err(position),
            None if column.is_empty() => Ok(Column::default()),
            None => Ok(Column::Doubles(column)),
        }
    }

    /// Returns the counts of a column of doubles that are all integers of up to 53 bits. Exact. Cost: linear, and nothing where the first
    /// one is no such integer.
    pub fn integers(&self) -> Option<Self> {
        let Column::Doubles(doubles) = self else { return None };
        let count = |&double: &f64| double as i64;
        let is_integer =
            |double: &f64| count(double) as f64 == *double && count(double).unsigned_abs() >> 53 == 0;
        doubles
            .iter()
            .all(is_integer)
            .then(|| Column::Narrow(Scaled::of_counts(doubles.iter().map(count).collect(), Unit::TenTo(0))))
    }

    /// Adds some of the numbers of another column.
    ///
    /// # Panics
    /// When there are not that many.
    #[allow(clippy::indexing_slicing, reason = "documented to panic")]
    pub fn append(&mut self, other: &Column, range: Range<usize>) {
        match (&mut *self, other) {
            (own, other) if own.is_empty() => *own = other.part(range),
            (Column::Doubles(own), Column::Doubles(other)) => own.extend_from_slice(&other[range]),
            (Column::Narrow(own), Column::Narrow(other)) if own.unit() == other.unit() => {
                own.append_counts(&other.counts()[range]);
            }
            (Column::Wide(own), Column::Wide(other)) if own.unit() == other.unit() => {
                own.append_counts(&other.counts()[range]);
            }
            (_, Column::Narrow(other)) => {
                self.append_counts(other.counts()[range].iter().map(|&count| count.into()), other.unit());
            }
            (_, Column::Wide(other)) => {
                self.append_counts(other.counts()[range].iter().copied(), other.unit());
            }
            (own, Column::Long(other)) => {
                let mut long = own.long().map(Cow::into_owned);
                match long.as_mut().and_then(|long| long.append(other, range.clone())).and(long) {
                    Some(long) => *own = Column::Long(long),
                    None => range.for_each(|index| own.push(other.get(index))),
                }
            }
            (own, Column::Scattered(other)) => {
                let numbers = other.numbers()[range].iter();
                numbers.for_each(|&(mantissa, exponent)| own.push_decimal(mantissa, exponent));
            }
            _ => range.for_each(|index| self.push(other.get(index))),
        }
    }

    fn append_counts(&mut self, counts: impl Iterator<Item = i128> + Clone, unit: Unit) {
        if let Column::Narrow(own) = self
            && own.append(counts.clone(), unit).is_some()
        {
            return;
        }
        counts.for_each(|count| self.push_count(count, unit));
    }

    #[inline(never)]
    fn push_count(&mut self, count: i128, unit: Unit) {
        if let Column::Narrow(scaled) = self {
            if scaled.push(count, unit).is_some() {
                return;
            }
            *self = Column::Wide(scaled.widened());
        }
        if let Column::Wide(scaled) = self {
            if scaled.push(count, unit).is_some() {
                return;
            }
            if let Some(long) = Long::of_counts(scaled.counts().iter().copied(), scaled.unit()) {
                *self = Column::Long(long);
            }
        }
        if let Column::Long(long) = self {
            if long.push_count(count, unit).is_some() {
                return;
            }
            if let Some(scattered) = Scattered::of_long(long) {
                *self = Column::Scattered(scattered);
            }
        }
        if let Column::Scattered(scattered) = self
            && scattered.push(count, unit).is_some()
        {
            return;
        }
        self.push_fraction(unit.times(count));
    }

    fn push_fraction(&mut self, number: Rational) {
        if let Column::Fractions(numbers) = self {
            numbers.push(number);
            return;
        }
        let numbers = (0..self.len()).map(|index| self.get(index)).chain([number]);
        *self = Column::Fractions(numbers.collect());
    }
}
