//! A float filter for points that are certainly strictly between the two hulls.
//!
//! The hull of a small sample lies within the hull of all points. The x-axis is divided into cells, and each cell has a
//! chord between two points of the sample from its left end or before to its right end or beyond: as the lower hull of
//! all points is convex, it is nowhere above the chord there, and likewise for the upper hull. A point that is certainly
//! above the one chord and below the other is strictly between the hulls. (The idea is that of Akl and Toussaint 1978.)

use super::cells::{Cell, Index, MOST_CELLS};
use super::coordinate::Coordinate;
use super::sample::Sample;

/// How the filter works. Results do not depend on it.
#[derive(Debug, Clone, Copy)]
struct Plan {
    /// How many rows make the sample.
    sample: usize,
    /// How the x-axis is divided; `None` for whatever suits the sample.
    division: Option<Division>,
    /// Up to how many rows are not filtered.
    exact: usize,
}

/// How the x-axis is divided into cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Division {
    /// Into cells of equal width.
    #[cfg_attr(not(test), allow(dead_code, reason = "the tests force it; otherwise the sample decides"))]
    Equal,
    /// At corners of the sample's hulls.
    Corners,
}

impl Plan {
    /// The plan for so many rows. A larger sample takes longer to sort, a smaller one leaves more rows: measured flat from
    /// 2·√n to 8·√n.
    fn of(rows: usize) -> Self {
        Plan { sample: 4 * rows.isqrt(), division: None, exact: 256 }
    }
}

/// Positions of the rows of both columns that may be on a hull, ascending; every row on a hull is among them. Cost: linear.
pub(super) fn candidates<C: Coordinate>(x: &[C], y: &[C]) -> Vec<usize> {
    candidates_by(x, y, None)
}

/// With a given plan in each round, or the one that suits the number of rows.
fn candidates_by<C: Coordinate>(x: &[C], y: &[C], plan: Option<&Plan>) -> Vec<usize> {
    let rows = x.len().min(y.len());
    let (x, y) = (&x[..rows], &y[..rows]);
    let Some(mut positions) = survivors(x, y, plan) else { return (0..rows).collect() };
    let mut before = rows;
    // Another round has a better sample.
    while 2 * positions.len() < before {
        before = positions.len();
        let [x, y] = [x, y].map(|column| positions.iter().map(|&row| column[row]).collect::<Vec<C>>());
        let Some(kept) = survivors(&x, &y, plan) else { break };
        positions = kept.into_iter().map(|kept| positions[kept]).collect();
    }
    positions
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
            return Some(filter.survivors(x, y));
        }
    }
    // Finding one of these cells takes twice as long, but they follow the sample wherever it is.
    let filter = Filter::new(&sample, sample.cells_between_corners()?);
    (plan.division.is_some() || 2 * filter.count(&sample) <= size).then(|| filter.survivors(x, y))
}

/// Cells from the least to the greatest x of a sample.
pub(super) struct Filter<C, I> {
    origin: C,
    end: C,
    index: I,
    cells: Box<[Cell; MOST_CELLS]>,
}

impl<C: Coordinate, I: Index<C>> Filter<C, I> {
    pub(super) fn new(sample: &Sample<C>, index: I) -> Self {
        let cells = sample.cells(&index);
        Filter { origin: sample.origin, end: sample.end, index, cells }
    }

    #[inline]
    fn discards(&self, x: C, y: f64) -> bool {
        let offset = x.offset(self.origin);
        let Cell { above, below } = &self.cells[self.index.cell(x, offset) % MOST_CELLS];
        // Not `&&`: a branch on each of these would be mispredicted too often.
        x.is_within(self.origin, self.end) & (y > above.at(offset)) & (y < below.at(offset))
    }

    /// Positions of the rows that may be on a hull, ascending.
    pub(super) fn survivors(&self, x: &[C], y: &[C]) -> Vec<usize> {
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

    /// How many of the sample survive.
    fn count(&self, sample: &Sample<C>) -> usize {
        sample.points.iter().filter(|point| !self.discards(point.x, point.y)).count()
    }
}

#[cfg(test)]
mod tests;
