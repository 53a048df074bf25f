//! The few of many readings without directions that decide linearity.
//!
//! A line misses some point by most that touches a hull of all points (x, y). So the best lines, the largest
//! deviations and the span follow from these points. Least squares, the means at both ends and the spreads at
//! one x are taken from integers in columns.

use boundfit_estimation::{CountedBatch, ErrorBound, Keep, LeastSquares, Measurements, Model};
use boundfit_exact::{Column, Count, Rational, Scaled, Unit, WideSum};
use boundfit_formats::RowNumbers;
use boundfit_geometry::Tally;
use boundfit_geometry::grid::{GridPoint, Place, candidates_of_columns, touching_of_columns};

use super::characteristic::line_through;
use super::points::largest;
use super::{CalibrationPoint, CalibrationReading, Difference, Whole};

/// Readings in columns, in the order of the rows.
#[derive(Default)]
pub(super) struct PlainReadings {
    /// x and y.
    columns: Vec<Column>,
    rows: RowNumbers,
}

impl PlainReadings {
    /// Bytes of a reading: two integers, room to grow, and a copy that is sorted.
    pub(super) const ROW_COST: u64 = 48;

    /// Readings with these numbers, in columns for x and y.
    pub(super) fn new(columns: Vec<Column>, rows: RowNumbers) -> Self {
        PlainReadings { columns, rows }
    }

    pub(super) fn len(&self) -> usize {
        self.rows.len()
    }

    /// Adds later readings.
    pub(super) fn append(&mut self, later: &PlainReadings) {
        self.columns.resize(later.columns.len(), Column::default());
        let columns = self.columns.iter_mut().zip(&later.columns);
        columns.for_each(|(own, later)| own.append(later, 0..later.len()));
        self.rows.append(&later.rows);
    }

    /// The same readings, equal ones once.
    pub(super) fn counted(self) -> CountedBatch {
        CountedBatch::new(self.columns, &self.rows, |_| None, 1)
    }

    /// The readings that decide, equal ones once, and the facts about all; `None` for numbers that are no integers of 128 bits
    /// on a common unit. `hold` is asked before the readings that decide, whose number it gets, become fractions. Exact. Cost: O(n log n), to sort the integers.
    ///
    /// # Errors
    /// The errors of `hold`.
    pub(super) fn deciding<E>(
        &self,
        hold: impl FnOnce(usize) -> Result<(), E>,
    ) -> Result<Option<(Vec<CalibrationReading>, Whole)>, E> {
        let [x, y] = self.columns.as_slice() else { return Ok(None) };
        let row = |position: usize| self.rows.get(position) as u64;
        if let (Column::Narrow(x), Column::Narrow(y)) = (x, y) {
            let points = touching_of_columns(x.counts(), y.counts(), &row, usize::MAX);
            let place = |GridPoint { x, y, rows }| Place { x, y, rows };
            return self.decided(x, y, points.into_iter().map(place).collect(), hold);
        }
        let (Some(x), Some(y)) = (x.wide(), y.wide()) else { return Ok(None) };
        let places = candidates_of_columns(x.counts(), y.counts(), &row, usize::MAX);
        self.decided(&x, &y, places, hold)
    }

    /// The answer from places of which some touch a hull, every one that does among them.
    fn decided<C: Count + Ord, E>(
        &self,
        x: &Scaled<C>,
        y: &Scaled<C>,
        mut places: Vec<Place<C>>,
        hold: impl FnOnce(usize) -> Result<(), E>,
    ) -> Result<Option<(Vec<CalibrationReading>, Whole)>, E> {
        if ![x.unit(), y.unit()].into_iter().all(is_short) {
            return Ok(None);
        }
        hold(places.len())?;
        places.sort_unstable_by_key(|place| (place.x, place.y));
        let readings = places.chunk_by(|one, other| (one.x, one.y) == (other.x, other.y)).map(|equal| {
            let rows = Tally::merged(equal.iter().map(|place| place.rows.clone()), usize::MAX);
            let [x, y] = [x.unit().times(equal[0].x.into()), y.unit().times(equal[0].y.into())];
            CalibrationReading { row: rows.first() as usize, x, y, pass: None, equal: Some(rows) }
        });
        let whole = Whole {
            count: self.len(),
            terminal: terminal(x, y),
            least_squares: self.least_squares(),
            repeatability: self.repeatability(x, y),
        };
        Ok(Some((readings.collect(), whole)))
    }

    fn least_squares(&self) -> Option<[Rational; 2]> {
        let (model, bound) = (Model::Line { x: "x".into() }, ErrorBound::Uniform(Rational::zero()));
        let keep = Keep { most_rows: 0, eui: false, ..Keep::DECIDING };
        let measurements = Measurements::of_columns(model, "y".into(), bound, &self.columns, keep).ok()?;
        Some(LeastSquares::new(&measurements).ok()?.theta)
    }

    /// The largest spread of readings at one x.
    fn repeatability<C: Count + Ord>(&self, x: &Scaled<C>, y: &Scaled<C>) -> Option<Difference> {
        let (spread, places) = largest_spread(x.counts(), y.counts())?;
        let mut rows: Vec<Option<Tally>> = vec![None; places.len()];
        for (position, own) in x.counts().iter().enumerate() {
            let Some(rows) = places.binary_search(own).ok().and_then(|place| rows.get_mut(place)) else {
                continue;
            };
            let row = self.rows.get(position) as u64;
            match rows {
                Some(rows) => rows.push(|| row, usize::MAX),
                None => *rows = Some(Tally::one(row)),
            }
        }
        let value = y.unit().times(spread);
        let point = |(place, rows): (C, Option<Tally>)| {
            let (x, y) = (x.unit().times(place.into()), value.clone());
            Some(CalibrationPoint { x, y, rows: rows?, equal: None })
        };
        let at = places.into_iter().zip(rows).filter_map(point).collect();
        Some(Difference { value, at })
    }
}

/// Returns whether numbers on a unit are so short that no work on them is ever refused.
fn is_short(unit: Unit) -> bool {
    match unit {
        Unit::Any | Unit::OneOver(_) => true,
        Unit::TenTo(exponent) => exponent.unsigned_abs() <= 300,
    }
}

/// The line through the means at both ends; `None` where all x are the same.
fn terminal<C: Count + Ord>(x: &Scaled<C>, y: &Scaled<C>) -> Option<[Rational; 2]> {
    let ends = [x.counts().iter().min()?, x.counts().iter().max()?];
    let [from, to] = ends.map(|&end| {
        let mut sum = WideSum::default();
        let mut count = 0_usize;
        for (_, &own) in x.counts().iter().zip(y.counts()).filter(|(own, _)| **own == end) {
            sum.add(own.into());
            count += 1;
        }
        let mean = (Rational::from(sum.total()) * y.unit().value()).checked_div(&Rational::from(count));
        mean.map(|mean| [x.unit().times(end.into()), mean])
    });
    let ([x1, y1], [x2, y2]) = (from?, to?);
    line_through([&x1, &y1], [&x2, &y2])
}

/// The largest difference of two y at one x, and each x where it is reached, ascending; `None` where no x is there twice.
/// Exact. Cost: O(n log n).
fn largest_spread<C: Count + Ord>(x: &[C], y: &[C]) -> Option<(i128, Vec<C>)> {
    let (x_range, y_range) = (Range::of(x)?, Range::of(y)?);
    let rows = x.iter().copied().zip(y.iter().copied());
    if x_range.bits + y_range.bits < u64::BITS {
        // One word for both numbers is sorted in half the time.
        let word = |(x, y)| x_range.above(x) << y_range.bits | y_range.above(y);
        let mut words: Vec<u64> = rows.map(word).collect();
        words.sort_unstable();
        let place = |word: u64| word >> y_range.bits;
        let spreads = words.chunk_by(|one, other| place(*one) == place(*other)).filter_map(|own| {
            let [least, .., most] = *own else { return None };
            Some((i128::from(most - least), place(least)))
        });
        let (spread, places) = largest(spreads)?;
        let x = |above: u64| C::new(x_range.least + i128::from(above));
        return Some((spread, places.into_iter().filter_map(x).collect()));
    }
    let mut pairs: Vec<(C, C)> = rows.collect();
    pairs.sort_unstable();
    largest(pairs.chunk_by(|one, other| one.0 == other.0).filter_map(|own| {
        let [(place, least), .., (_, most)] = *own else { return None };
        // Integers of 126 bits.
        Some((most.into().wrapping_sub(least.into()), place))
    }))
}

/// The range of some integers.
struct Range {
    least: i128,
    /// The bits of the largest difference from the least.
    bits: u32,
}

impl Range {
    fn of<C: Count + Ord>(counts: &[C]) -> Option<Self> {
        let [least, most]: [i128; 2] = [(*counts.iter().min()?).into(), (*counts.iter().max()?).into()];
        Some(Range { least, bits: u128::BITS - least.abs_diff(most).leading_zeros() })
    }

    /// The difference from the least, of at most 64 bits.
    #[inline]
    fn above<C: Count>(&self, count: C) -> u64 {
        count.into().wrapping_sub(self.least) as u64
    }
}
