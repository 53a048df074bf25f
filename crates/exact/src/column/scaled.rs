//! Integers on a common unit.

use super::unit::Unit;
use crate::Rational;
use crate::long_decimal::{WORD_DIGITS, power_of_ten};
use crate::plain::{ShortPrefix, signed};
use crate::powers_of_ten;

/// Integers on a common unit: number `i` is `counts[i]` units. Their size is limited by [`Count`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Scaled<I> {
    counts: Vec<I>,
    unit: Unit,
}

/// The integers of a column, and how large they may be.
pub trait Count: Copy + Ord + Into<i128> {
    /// 1.
    const ONE: Self;
    /// The number of bits that every magnitude keeps to.
    const BITS: u32;

    /// The integer with this value, if it is not too large.
    fn new(value: i128) -> Option<Self>;

    /// The product, if it is not too large.
    fn times(self, factor: Self) -> Option<Self>;

    /// The quotient, if it is an integer.
    fn over(self, divisor: Self) -> Option<Self>;

    /// Numerator and denominator of a number, if both are machine integers of this size.
    fn parts(number: &Rational) -> Option<(Self, Self)>;
}

macro_rules! count {
    ($integer:ty, $bits:literal, $parts:expr) => {
        impl Count for $integer {
            const ONE: Self = 1;
            const BITS: u32 = $bits;

            #[inline]
            fn new(value: i128) -> Option<Self> {
                (value.unsigned_abs() >> $bits == 0).then_some(value as $integer)
            }

            #[inline]
            fn times(self, factor: Self) -> Option<Self> {
                self.checked_mul(factor).filter(|product| product.unsigned_abs() >> $bits == 0)
            }

            #[inline]
            fn over(self, divisor: Self) -> Option<Self> {
                (self.checked_rem(divisor)? == 0).then(|| self / divisor)
            }

            #[inline]
            fn parts(number: &Rational) -> Option<(Self, Self)> {
                $parts(number)
            }
        }
    };
}

// Differences of two integers of 62 bits fit into 64 bits, products of two differences into 127.
count!(i64, 62, Rational::to_words);
// Differences of two integers of 126 bits fit into 128: 37 digits, or the 17 with which other programs print binary64 and
// exponents that differ by twenty.
count!(i128, 126, |number: &Rational| Some((number.numerator().to_i128()?, number.denominator().to_i128()?)));

fn bits(magnitude: u128) -> u32 {
    u128::BITS - magnitude.leading_zeros()
}

impl<I> Default for Scaled<I> {
    fn default() -> Self {
        Scaled { counts: Vec::new(), unit: Unit::Any }
    }
}

impl<I: Count> Scaled<I> {
    /// Returns a column of these counts of units; `None` when one is too large.
    pub fn new(counts: impl IntoIterator<Item = i128>, unit: Unit) -> Option<Self> {
        let counts = counts.into_iter();
        // An `Option` of a list does not know how long it gets, and takes memory again and again.
        let mut own = Vec::with_capacity(counts.size_hint().0);
        for count in counts {
            own.push(I::new(count)?);
        }
        Some(Scaled { counts: own, unit })
    }

    /// Returns a column of these counts of units; `None` when one is missing or too large.
    pub(super) fn of_options(counts: impl Iterator<Item = Option<i128>>, unit: Unit) -> Option<Self> {
        Some(Scaled { counts: counts.map(|count| I::new(count?)).collect::<Option<_>>()?, unit })
    }

    /// Returns a column of these counts of units, of which none is too large.
    pub(super) fn of_counts(counts: Vec<I>, unit: Unit) -> Self {
        Scaled { counts, unit }
    }

    /// Numbers on their least common denominator; `None` when they are too large on it. Exact. Cost: linear, with few
    /// divisions where neighbours have the same denominator.
    pub fn of_numbers<'a>(numbers: impl ExactSizeIterator<Item = &'a Rational>) -> Option<Self> {
        let mut column =
            Scaled { counts: Vec::with_capacity(numbers.len()), unit: Unit::OneOver(I::ONE.into()) };
        // The common denominator, the denominator of the number before, and how often it divides the common one: a
        // division takes longer than all the rest.
        let (mut common, mut last, mut factor) = (I::ONE, I::ONE, I::ONE);
        for number in numbers {
            let (numerator, denominator) = I::parts(number)?;
            if denominator != last {
                factor = match common.over(denominator) {
                    Some(factor) => factor,
                    None => {
                        column.refine(Unit::OneOver(denominator.into()))?;
                        common = I::new(Unit::TenTo(0).counted_in(column.unit)?)?;
                        common.over(denominator)?
                    }
                };
                last = denominator;
            }
            column.counts.push(numerator.times(factor)?);
        }
        Some(column)
    }

    /// Returns how many units each number is.
    #[inline]
    pub fn counts(&self) -> &[I] {
        &self.counts
    }

    /// Returns what they count.
    #[inline]
    pub fn unit(&self) -> Unit {
        self.unit
    }

    pub(super) fn reserve(&mut self, more: usize) {
        self.counts.reserve_exact(more);
    }

    /// Adds so many units of any kind. Afterwards the numbers are on the finer unit, or, when they would become too large,
    /// without the new one: `None`.
    #[inline]
    pub(super) fn push(&mut self, count: i128, unit: Unit) -> Option<()> {
        let count = I::new(count)?;
        let factor = match unit.counted_in(self.unit) {
            // A zero needs no unit of its own.
            _ if count.into() == 0 => 1,
            Some(factor) => factor,
            None => {
                self.refine(unit)?;
                unit.counted_in(self.unit)?
            }
        };
        self.counts.push(count.times(I::new(factor)?)?);
        Some(())
    }

    /// Adds several like [`Scaled::push`]: all of them or none.
    pub(super) fn append(&mut self, counts: impl IntoIterator<Item = i128>, unit: Unit) -> Option<()> {
        let before = self.counts.len();
        for count in counts {
            if self.push(count, unit).is_none() {
                self.counts.truncate(before);
                return None;
            }
        }
        Some(())
    }

    /// Adds numbers that are counted on the unit of the column. Cost: a copy.
    pub(super) fn append_counts(&mut self, counts: &[I]) {
        self.counts.extend_from_slice(counts);
    }

    /// Makes another unit a multiple of that of the column, which at least halves, so that this happens rarely.
    #[cold]
    fn refine(&mut self, unit: Unit) -> Option<()> {
        let common = self.unit.common(unit)?;
        let factor = I::new(self.unit.counted_in(common)?)?;
        // The bits of all magnitudes together reach as far as those of the largest, whose product tells about all.
        let all = self.counts.iter().fold(0, |all: u128, &count| all | count.into().unsigned_abs());
        let is_short = bits(all) + bits(factor.into().unsigned_abs()) < I::BITS;
        if !is_short && self.counts.iter().any(|count| count.times(factor).is_none()) {
            return None;
        }
        for count in &mut self.counts {
            *count = count.times(factor).unwrap_or(*count);
        }
        self.unit = common;
        Some(())
    }

    /// The numbers at these places.
    #[allow(clippy::indexing_slicing, reason = "the caller's, which is documented to panic")]
    pub(super) fn at(&self, places: impl Iterator<Item = usize>) -> Self {
        Scaled { counts: places.map(|place| self.counts[place]).collect(), unit: self.unit }
    }

    /// Some of the numbers; those that there are.
    pub(super) fn part(&self, range: std::ops::Range<usize>) -> Self {
        Scaled { counts: self.counts.get(range).unwrap_or_default().to_vec(), unit: self.unit }
    }
}

impl Scaled<i128> {
    /// Adds `mantissa · 10^exponent` where that is so many units that are counted already; gives `false` when it may not be.
    /// Cost: a product of words.
    #[inline]
    pub(super) fn push_word(&mut self, mantissa: i128, exponent: i32) -> bool {
        let Unit::TenTo(own) = self.unit else { return false };
        let finer = exponent.wrapping_sub(own) as usize;
        if finer >= WORD_DIGITS || exponent < own || mantissa.unsigned_abs() >> u64::BITS != 0 {
            return false;
        }
        // 64 bits and 60 are less than 126.
        self.counts.push(mantissa.wrapping_mul(i128::from(power_of_ten(finer))));
        true
    }
}

impl Scaled<i64> {
    /// Returns what counts decimals in the unit of the column.
    #[inline(always)]
    pub fn narrow_unit(&self) -> NarrowUnit {
        NarrowUnit::new(self.unit)
    }

    /// Adds a count of its [`NarrowUnit`]. Cost: some instructions.
    #[inline(always)]
    pub fn push_narrow(&mut self, count: NarrowCount) {
        self.counts.push(count.get());
    }

    /// Adds `mantissa · 10^exponent` `times` times. Returns `false` and adds nothing if it has no count on this unit.
    pub(super) fn push_repeated(&mut self, mantissa: i64, exponent: i32, times: usize) -> bool {
        let Some(count) = self.narrow_unit().count(mantissa, exponent) else { return false };
        self.counts.extend(std::iter::repeat_n(count.get(), times));
        true
    }

    /// These numbers as wider integers, with room for as many.
    pub(super) fn widened(&self) -> Scaled<i128> {
        let mut counts = Vec::with_capacity(self.counts.capacity());
        counts.extend(self.counts.iter().map(|&count| i128::from(count)));
        Scaled { counts, unit: self.unit }
    }
}

/// Ten to this power times a number of seven digits has less than 62 bits, even with as many digits below.
const MOST_PLACES: i32 = 11;

/// The unit of a narrow column, which counts decimals.
#[derive(Debug, Clone, Copy)]
pub struct NarrowUnit {
    /// `None` for a unit that is no power of ten.
    exponent: Option<i32>,
    /// The number of decimal places, if there are at most [`MOST_PLACES`]; a huge number otherwise.
    places: usize,
}

/// A count of a [`NarrowUnit`].
#[derive(Debug, Clone, Copy, Default)]
pub struct NarrowCount(i64);

impl NarrowCount {
    /// Returns the count.
    #[inline(always)]
    pub fn get(self) -> i64 {
        self.0
    }
}

impl NarrowUnit {
    #[inline(always)]
    pub(super) fn new(unit: Unit) -> Self {
        let exponent = if let Unit::TenTo(exponent) = unit { Some(exponent) } else { None };
        let places = exponent.filter(|exponent| (-MOST_PLACES..=0).contains(exponent));
        NarrowUnit {
            exponent,
            places: places.map_or(usize::MAX, |exponent| exponent.unsigned_abs() as usize),
        }
    }

    /// Returns how many units `mantissa · 10^exponent` is, where the unit is that power of ten or a lower one and the integer is not
    /// too large. Exact.
    #[inline(always)]
    pub fn count(&self, mantissa: i64, exponent: i32) -> Option<NarrowCount> {
        // A finer unit wraps to what is no index.
        let finer = exponent.wrapping_sub(self.exponent?) as u32 as usize;
        mantissa.times(*powers_of_ten::OF_I64.get(finer)?).map(NarrowCount)
    }

    /// Returns how many units a number is, if it has no more places than the unit, and the unit has few. Exact. Cost: two products,
    /// without a look at their size.
    #[inline(always)]
    pub fn count_short(&self, short: ShortPrefix) -> Option<NarrowCount> {
        // More places than the unit has, and the huge number, wrap to what is no index.
        let finer = powers_of_ten::OF_U64.get(self.places.wrapping_sub(short.fraction_digits))?;
        let unit = powers_of_ten::OF_U64.get(self.places)?;
        let magnitude = short.whole.wrapping_mul(*unit).wrapping_add(short.fraction.wrapping_mul(*finer));
        Some(NarrowCount(signed(magnitude, short.negative)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Limits, Others, PlainPrefix, Reading, plain_prefix, short_prefix};

    fn narrow(numbers: &[(i64, i64)]) -> Option<Scaled<i64>> {
        let numbers: Vec<Rational> = numbers.iter().map(|&(n, d)| Rational::ratio(n, d)).collect();
        Scaled::of_numbers(numbers.iter())
    }

    #[test]
    fn numbers_share_their_least_common_denominator() {
        let column = narrow(&[(1, 2), (-3, 5), (7, 1), (1, 1000), (1, 5)]).unwrap();
        assert_eq!(column.counts(), [500, -600, 7000, 1, 200]);
        assert_eq!(column.unit(), Unit::OneOver(1000));
        assert_eq!(narrow(&[]).unwrap().unit(), Unit::OneOver(1));
    }

    #[test]
    fn what_leaves_62_bits_is_not_narrow() {
        let largest = (1 << 62) - 1;
        assert_eq!(narrow(&[(largest, 1), (-largest, 1)]).unwrap().counts(), [largest, -largest]);
        assert!(narrow(&[(largest + 1, 1)]).is_none());
        assert!(narrow(&[(-largest - 1, 1)]).is_none());
        assert!(narrow(&[(largest, 1), (1, 2)]).is_none(), "the number before no longer fits");
        assert!(narrow(&[(1, 2), (largest, 1)]).is_none());
        assert!(narrow(&[(1, 3), (1, 1 << 61)]).is_none(), "the denominator does not fit");
        assert!(narrow(&[(0, 1), (1, i64::MAX)]).is_none());
        assert!(Scaled::<i64>::of_numbers([Rational::from(1_i128 << 64)].iter()).is_none());
    }

    #[test]
    fn wide_numbers_keep_their_values() {
        let read = |text| Reading::Decimal.read(text, &Limits::default()).unwrap();
        let numbers = ["1/3", "0.1", "-7", "12345678901234567.89", "2e-9", "5/6"].map(read);
        let column = Scaled::<i128>::of_numbers(numbers.iter()).unwrap();
        let values: Vec<Rational> = column.counts().iter().map(|&count| column.unit().times(count)).collect();
        assert_eq!(values, numbers);
        for too_wide in ["1e38", "1e-38"].map(|text| read(text) + Rational::ratio(1, 7)) {
            assert!(Scaled::<i128>::of_numbers([too_wide].iter()).is_none());
        }
    }

    #[test]
    fn what_does_not_fit_leaves_the_others_as_they_were() {
        let mut column = Scaled::<i64>::new([1, 1 << 61], Unit::TenTo(0)).unwrap();
        assert!(column.append([3, 5], Unit::TenTo(-1)).is_none());
        assert_eq!((column.counts(), column.unit()), (&[1, 1 << 61][..], Unit::TenTo(0)));
        assert!(column.append([7, i128::from(i64::MAX)], Unit::TenTo(0)).is_none());
        assert_eq!(column.counts(), [1, 1 << 61]);
        assert!(Scaled::<i64>::new([1 << 62], Unit::TenTo(0)).is_none());
    }

    #[test]
    fn short_numbers_are_counted_like_all() {
        let texts = ["0", "-0.0", "9999999.9999999", "-9999999", "0.0000001", "12.5", "-.25", "3."];
        let units = (-14..3).map(Unit::TenTo).chain([Unit::Any, Unit::OneOver(3)]);
        let mut counted = 0;
        for unit in units.map(NarrowUnit::new) {
            for text in texts {
                let padded: [u8; 32] = format!("{text:,<32}").into_bytes().try_into().unwrap();
                let short = short_prefix(&padded, Others::default().behind(&padded.repeat(8), 0)).unwrap();
                let PlainPrefix { mantissa, fraction_digits, .. } = plain_prefix(text.as_bytes()).unwrap();
                let expected = unit.count(mantissa, -fraction_digits).map(NarrowCount::get);
                let own = unit.count_short(short).map(NarrowCount::get);
                assert!(own == expected || own.is_none(), "{unit:?} {text}: {own:?}, {expected:?}");
                counted += usize::from(own.is_some());
            }
        }
        // By all numbers in units with 7 to 11 places, by those with fewer places in others.
        assert_eq!(counted, 5 * 8 + 5 * 6 + 5 + 3);
    }

    #[test]
    fn a_number_is_repeated_as_if_it_came_each_time() {
        use crate::{Column, Unit};

        let largest = (1 << 62) - 1;
        for before in [None, Some((15, -1)), Some((largest, 0)), Some((1, -30)), Some((1, -200))] {
            for (mantissa, exponent) in [(1, 0), (-7, -3), (0, 5), (3, 300), (i64::MAX, -2)] {
                for times in 0..4 {
                    let mut column = Column::default();
                    before
                        .into_iter()
                        .for_each(|(mantissa, exponent)| column.push_decimal(mantissa, exponent));
                    let mut expected = column.clone();
                    column.push_repeated(mantissa, exponent, times);
                    (0..times).for_each(|_| expected.push_decimal(mantissa, exponent));
                    assert_eq!(column, expected, "{before:?} {mantissa} {exponent} {times}");
                }
            }
        }
        for counts in
            [vec![], vec![0, -largest, largest], vec![largest + 1], vec![-largest - 1], vec![i64::MIN]]
        {
            let expected = Column::of_counts(counts.iter().map(|&count| count.into()), Unit::TenTo(-2));
            let is_narrow = matches!(expected, Column::Narrow(_));
            assert_eq!(Column::of_short_counts(counts, Unit::TenTo(-2)), is_narrow.then_some(expected));
        }
    }
}
