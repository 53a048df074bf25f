//! A float filter for points that are certainly strictly between the two hulls.
//!
//! The hull of a small sample lies within the hull of all points. The x-axis is divided into cells. Each cell has a
//! chord between two points of the sample, from its left end or before to its right end or beyond. The lower hull of
//! all points is convex, so it is nowhere above the chord there, and likewise for the upper hull. A point that is
//! certainly above the one chord and below the other is strictly between the hulls. (The idea is that of Akl and
//! Toussaint 1978.)

use std::collections::BTreeMap;

use super::cells::{Around, Cell, Index, MOST_CELLS, moved};
use super::coordinate::Coordinate;
use super::sample::{BLUR, Sample, Sampled};
use super::strip::Strip;
use crate::tally::Tally;

/// The plan of the filter. Results do not depend on it.
#[derive(Debug, Clone, Copy)]
struct Plan {
    /// The number of rows that make the sample.
    sample: usize,
    /// The division of the x-axis; `None` for whatever suits the sample.
    division: Option<Division>,
    /// The most rows that are not filtered.
    exact: usize,
}

/// The division of the x-axis into cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Division {
    /// Cells of equal width.
    #[cfg_attr(not(test), allow(dead_code, reason = "the tests force it; otherwise the sample decides"))]
    Equal,
    /// Cells that end at corners of the sample's hulls.
    Corners,
}

impl Plan {
    /// The plan for so many rows. A larger sample takes longer to sort, a smaller one leaves more rows: measured flat from
    /// 2·√n to 8·√n.
    fn of(rows: usize) -> Self {
        Plan { sample: 4 * rows.isqrt(), division: None, exact: 256 }
    }
}

/// A place that may be on a hull, and the rows that have been seen there.
#[derive(Debug, Clone, PartialEq)]
pub struct Place<C> {
    /// Abscissa.
    pub x: C,
    /// Ordinate.
    pub y: C,
    /// Numbers of rows.
    pub rows: Tally,
}

/// The facts wanted about the rows of columns.
#[derive(Clone, Copy)]
pub(super) struct Listing<'a> {
    /// The number of the row at a position; ascends.
    pub(super) row: &'a dyn Fn(usize) -> u64,
    /// The most row numbers that are listed for each place.
    pub(super) most: usize,
}

/// The places of the rows of both columns that may be on a hull; every one on a hull is among them, some more than once, with other
/// rows. Cost: linear.
pub(super) fn places<C: Coordinate>(x: &[C], y: &[C], listing: Listing) -> Vec<Place<C>> {
    places_by(x, y, listing, None)
}

/// Returns the places with a given plan in each round, or with the plan that suits the number of rows.
fn places_by<C: Coordinate>(x: &[C], y: &[C], listing: Listing, plan: Option<&Plan>) -> Vec<Place<C>> {
    let rows = x.len().min(y.len());
    let (x, y) = (&x[..rows], &y[..rows]);
    let mut places = match survivors(x, y, plan) {
        Some(positions) => tied(x, y, positions.into_iter(), listing),
        None => return tied(x, y, 0..rows, listing),
    };
    let mut before = rows;
    // Another round has a better sample.
    while 2 * places.len() < before {
        before = places.len();
        let [x, y] = [|place: &Place<C>| place.x, |place: &Place<C>| place.y]
            .map(|of| places.iter().map(of).collect::<Vec<C>>());
        let Some(kept) = survivors(&x, &y, plan) else { break };
        let mut kept = kept.into_iter().peekable();
        let mut position = 0..;
        places.retain(|_| kept.next_if_eq(&position.next().unwrap_or_default()).is_some());
    }
    places
}

/// The place where the rows of a place are counted.
pub(super) enum Counted {
    Nowhere,
    Alone,
    /// The first place of these, by number.
    Among(usize),
}

/// The places of some rows, ascending by position: rows at a place that was seen not long ago are counted there.
pub(super) fn tied<C: Coordinate>(
    x: &[C],
    y: &[C],
    positions: impl Iterator<Item = usize>,
    listing: Listing,
) -> Vec<Place<C>> {
    tied_by(x, y, positions, listing, |_, _| Counted::Alone)
}

/// [`tied`], with a function that tells where the rows of a place are counted.
pub(super) fn tied_by<C: Coordinate>(
    x: &[C],
    y: &[C],
    positions: impl Iterator<Item = usize>,
    Listing { row, most }: Listing,
    counted: impl Fn(C, C) -> Counted,
) -> Vec<Place<C>> {
    /// The most places that are remembered, as 2 to this power: few enough for a first-level cache.
    const MOST_BITS: u32 = 10;
    /// Odd numbers of which the products have no pattern: 2⁶⁴ over the golden ratio, and another.
    const FACTORS: [u64; 2] = [0x9e37_79b9_7f4a_7c15, 0xc2b2_ae3d_27d4_eb4f];
    /// The rows for which there is room from the start.
    const FEW: usize = 64;
    // Twice as many as there are rows, where these are few.
    let bits = (usize::BITS + 1 - x.len().leading_zeros()).min(MOST_BITS);
    let mut recent: Vec<Option<(C, C, Option<usize>)>> = vec![None; 1 << bits];
    let mut places: Vec<Place<C>> = Vec::with_capacity(x.len().min(FEW));
    let mut among = BTreeMap::new();
    for position in positions {
        let (x, y) = (x[position], y[position]);
        let mixed = x.bits().wrapping_mul(FACTORS[0]) ^ y.bits().wrapping_mul(FACTORS[1]);
        let slot = &mut recent[(mixed.wrapping_mul(FACTORS[0]) >> (u64::BITS - bits)) as usize];
        let place = match slot {
            Some((known_x, known_y, place)) if *known_x == x && *known_y == y => *place,
            _ => {
                let next = places.len();
                let place = match counted(x, y) {
                    Counted::Nowhere => None,
                    Counted::Alone => Some(next),
                    Counted::Among(number) => Some(*among.entry(number).or_insert(next)),
                };
                *slot = Some((x, y, place));
                if place == Some(next) {
                    places.push(Place { x, y, rows: Tally::one(row(position)) });
                    continue;
                }
                place
            }
        };
        if let Some(place) = place {
            places[place].rows.push(|| row(position), most);
        }
    }
    places
}

/// Returns whether something is true of most of sixteen rows, taken at equal distances.
pub(super) fn holds_of_most(rows: usize, is_true: impl Fn(usize) -> bool) -> bool {
    let some = || (0..rows).step_by(rows.div_ceil(16).max(1));
    2 * some().filter(|&row| is_true(row)).count() > some().count()
}

/// One round; `None` when it would hardly discard anything.
fn survivors<C: Coordinate>(x: &[C], y: &[C], plan: Option<&Plan>) -> Option<Vec<usize>> {
    let rows = x.len();
    let plan = plan.copied().unwrap_or_else(|| Plan::of(rows));
    if rows <= plan.exact {
        return None;
    }
    let sample = Sample::of(x, y, plan.sample)?;
    let size = sample.points.len();
    if plan.division != Some(Division::Corners) {
        let filter = Filter::new(&sample, sample.equal_cells()?);
        let kept = filter.count(&sample);
        if plan.division.is_some() || 32 * kept <= size {
            return Some(filter.with_strip(&sample).survivors(x, y));
        }
    }
    // Finding one of these cells takes twice as long, but they follow the sample wherever it is.
    let filter = Filter::new(&sample, sample.cells_between_corners()?);
    (plan.division.is_some() || 2 * filter.count(&sample) <= size).then(|| filter.survivors(x, y))
}

/// Cells from the least to the greatest x of a sample.
pub(super) struct Filter<C, I> {
    /// The strip that discards most rows, if there is one.
    strip: Option<Strip>,
    origin: C,
    /// The two x between which rows are certainly between the ends of the sample.
    least: C,
    greatest: C,
    index: I,
    cells: Box<[Cell; MOST_CELLS]>,
}

impl<I: Index<f64>> Filter<f64, I> {
    /// Returns a filter of numbers that are rounded already, on an index that knows this.
    pub(super) fn of_rounded(sample: &Sample<f64>, index: I) -> Self {
        let filter = Filter::new(sample, index);
        let (least, greatest) = (filter.least + sample.blur(), filter.greatest - sample.blur());
        Filter { least, greatest, ..filter }
    }
}

impl Filter<f64, Around> {
    /// Returns a filter of numbers that are rounded already and of all sizes, with cells around the corners of the hulls.
    pub(super) fn of_all_sizes(sample: &Sample<f64>) -> Option<Self> {
        let index = sample.cells_around_corners()?;
        let cells = sample.cells_of_all_sizes(&index);
        let (least, greatest) = (moved(sample.origin, BLUR), moved(sample.end, -BLUR));
        // Its lines are over x itself.
        Some(Filter { strip: None, origin: 0.0, least, greatest, index, cells })
    }
}

impl<C: Coordinate, I: Index<C>> Filter<C, I> {
    pub(super) fn new(sample: &Sample<C>, index: I) -> Self {
        let cells = sample.cells(&index);
        let (origin, end) = (sample.origin, sample.end);
        Filter { strip: None, origin, least: origin, greatest: end, index, cells }
    }

    /// Adds a strip, if it discards most of a sample of the rows.
    fn with_strip(self, sample: &Sample<C>) -> Self {
        /// The number of rows of the sample of which at most one may remain: more branches would not be foreseen.
        const RARE: usize = 8;
        let discards = |strip: &Strip| {
            let is_left =
                |point: &&Sampled<C>| !point.x.word().is_some_and(|x| strip.contains(x, point.y as i64));
            RARE * sample.points.iter().filter(is_left).count() <= sample.points.len()
        };
        Filter { strip: Strip::of(sample).filter(discards), ..self }
    }

    #[inline]
    pub(super) fn discards(&self, x: C, y: f64) -> bool {
        let offset = x.offset(self.origin);
        let Cell { above, below } = &self.cells[self.index.cell(x, offset) % MOST_CELLS];
        // Not `&&`: a branch on each of these would be mispredicted too often.
        x.is_within(self.least, self.greatest) & (y > above.at(offset)) & (y < below.at(offset))
    }

    /// Returns whether most of some rows, taken at equal distances, are left or right of the sample. The filter discards none of
    /// these. Where x ascend, all rows are right of those before.
    pub(super) fn is_beside(&self, x: &[C]) -> bool {
        holds_of_most(x.len(), |row| !x[row].is_within(self.least, self.greatest))
    }

    /// Positions of the rows that may be on a hull, ascending.
    pub(super) fn survivors(&self, x: &[C], y: &[C]) -> Vec<usize> {
        if let Some(strip) = &self.strip {
            let is_within = |x: C, y: C| x.word().zip(y.word()).is_some_and(|(x, y)| strip.contains(x, y));
            let rows = x.iter().zip(y).enumerate();
            // Both comparisons are almost always true, so that a branch is foreseen.
            let left = rows.filter(|(_, (x, y))| !is_within(**x, **y) && !self.discards(**x, y.value()));
            return left.map(|(row, _)| row).collect();
        }
        const BLOCK: usize = u64::BITS as usize;
        let ((x_blocks, x_rest), (y_blocks, y_rest)) = (x.as_chunks::<BLOCK>(), y.as_chunks::<BLOCK>());
        let mut survivors = Vec::new();
        for (block, (xs, ys)) in x_blocks.iter().zip(y_blocks).enumerate() {
            // One bit per row, so that rows are tested without a branch.
            let mut kept = 0_u64;
            for (&x, &y) in xs.iter().zip(ys) {
                kept = kept >> 1 | u64::from(!self.discards(x, y.value())) << (BLOCK - 1);
            }
            while kept != 0 {
                survivors.push(block * BLOCK + kept.trailing_zeros() as usize);
                kept &= kept - 1;
            }
        }
        let rest = x_rest.iter().zip(y_rest).zip(BLOCK * x_blocks.len()..);
        survivors.extend(rest.filter(|((x, y), _)| !self.discards(**x, y.value())).map(|(_, row)| row));
        survivors
    }

    /// Returns how many of the sample survive.
    fn count(&self, sample: &Sample<C>) -> usize {
        sample.points.iter().filter(|point| !self.discards(point.x, point.y)).count()
    }
}

#[cfg(test)]
mod tests;
