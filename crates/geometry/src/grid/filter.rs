//! A float filter for points that are certainly strictly between the two hulls.
//!
//! The hull of a small sample lies within the hull of all points. The x-axis is divided into cells, and each cell has a
//! chord between two points of the sample from its left end or before to its right end or beyond: as the lower hull of
//! all points is convex, it is nowhere above the chord there, and likewise for the upper hull. A point that is certainly
//! above the one chord and below the other is strictly between the hulls. (The idea is that of Akl and Toussaint 1978.)

use super::cells::{Cell, Index, MOST_CELLS};
use super::sample::Sample;

/// A column's type: numbers with an exact order and a rounded value.
pub(super) trait Coordinate: Copy + PartialOrd {
    /// The nearest binary64.
    fn value(self) -> f64;
    /// The nearest binary64 to `self - origin`, for numbers from `origin` to one within its [reach](Self::reaches).
    fn offset(self, origin: Self) -> f64;
    /// Whether all numbers up to `end` have finite offsets from this one.
    fn reaches(self, end: Self) -> bool;
    /// Whether a number is from `origin` to `end`, one within its reach.
    fn is_within(self, origin: Self, end: Self) -> bool;
}

macro_rules! integer_coordinate {
    ($integer:ty, $unsigned:ty) => {
        impl Coordinate for $integer {
            fn value(self) -> f64 {
                self as f64
            }

            fn offset(self, origin: Self) -> f64 {
                // Wraps beyond its reach only.
                self.wrapping_sub(origin) as f64
            }

            fn reaches(self, end: Self) -> bool {
                end.checked_sub(self).is_some()
            }

            #[inline]
            fn is_within(self, origin: Self, end: Self) -> bool {
                // One comparison: what is before the origin wraps to beyond the end.
                self.wrapping_sub(origin) as $unsigned <= end.wrapping_sub(origin) as $unsigned
            }
        }
    };
}

integer_coordinate!(i64, u64);
integer_coordinate!(i128, u128);

impl Coordinate for f64 {
    fn value(self) -> f64 {
        self
    }

    fn offset(self, origin: Self) -> f64 {
        self - origin
    }

    fn reaches(self, end: Self) -> bool {
        (end - self).is_finite()
    }

    #[inline]
    fn is_within(self, origin: Self, end: Self) -> bool {
        (self >= origin) & (self <= end)
    }
}

/// How the filter works. Results do not depend on it.
#[doc(hidden)]
#[derive(Debug, Clone, Copy)]
pub struct Plan {
    /// How many rows make the sample.
    pub sample: usize,
    /// How the x-axis is divided; `None` for whatever suits the sample.
    pub division: Option<Division>,
    /// Up to how many rows are not filtered.
    pub exact: usize,
}

/// How the x-axis is divided into cells.
#[doc(hidden)]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Division {
    /// Into cells of equal width.
    Equal,
    /// At corners of the sample's hulls.
    Corners,
}

impl Plan {
    /// The plan for so many rows. A larger sample takes longer to sort, a smaller one leaves more rows: measured flat from
    /// 2·√n to 8·√n.
    pub(super) fn of(rows: usize) -> Self {
        Plan { sample: 4 * rows.isqrt(), division: None, exact: 256 }
    }
}

/// Positions of the rows of both columns that may be on a hull, ascending; every row on a hull is among them. Cost: linear.
pub(super) fn candidates<C: Coordinate>(x: &[C], y: &[C], plan: Option<&Plan>) -> Vec<usize> {
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
mod tests {
    use super::*;

    /// Rows all over a parallelogram, the same ones every time.
    fn rows(count: usize) -> (Vec<i64>, Vec<i64>) {
        let mut state = 0x2545_f491_4f6c_dd1d_u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 34) as i64 % 1_000_000
        };
        (0..count)
            .map(|_| {
                let (x, above) = (next(), next());
                (x - 300_000, 3 * x + above)
            })
            .unzip()
    }

    fn plan(division: Option<Division>) -> Plan {
        Plan { sample: 4_000, division, exact: 256 }
    }

    #[test]
    fn of_rows_all_over_the_place_few_survive_whatever_their_type_and_unit() {
        let (x, y) = rows(40_000);
        for division in [None, Some(Division::Equal), Some(Division::Corners)] {
            let kept = survivors(&x, &y, Some(&plan(division))).unwrap();
            assert!(kept.len() < 300, "{division:?}: {}", kept.len());
            let wide = [&x, &y].map(|column| column.iter().map(|&value| value.into()).collect::<Vec<i128>>());
            assert!(survivors(&wide[0], &wide[1], Some(&plan(division))).unwrap() == kept);
            // Products with powers of two are exact.
            for (x_power, y_power) in [(0, 0), (-60, -60), (0, -60), (-60, 0), (300, 0), (0, 300)] {
                let doubles = |column: &[i64], power: i32| -> Vec<f64> {
                    column.iter().map(|&value| value as f64 * 2_f64.powi(power)).collect()
                };
                let (x, mut y) = (doubles(&x, x_power), doubles(&y, y_power));
                assert!(survivors(&x, &y, Some(&plan(division))).unwrap() == kept, "{x_power} {y_power}");
                // A row that has no place is in the sample, and spoils nothing.
                y[0] = f64::INFINITY;
                let others = survivors(&x, &y, Some(&plan(division))).unwrap();
                assert!(others.len() < 300 && others[0] == 0, "{division:?}: {}", others.len());
            }
        }
        // Another round, with a sample of what was left.
        assert!(2 * candidates(&x, &y, None).len() < survivors(&x, &y, None).unwrap().len());
    }

    #[test]
    fn the_division_that_suits_the_sample_is_taken() {
        let [equal, corners] = [Some(Division::Equal), Some(Division::Corners)];
        let by = |x: &[i64], y: &[i64], division| survivors(x, y, Some(&plan(division))).unwrap();
        let (mut x, mut y) = rows(40_000);
        assert!(by(&x, &y, equal) != by(&x, &y, corners));
        assert!(by(&x, &y, None) == by(&x, &y, equal));
        // All but one row in the same of the equal cells.
        (x[0], y[0]) = (1_000_000_000_000, 3_000_000_000_000);
        assert!(by(&x, &y, equal).len() > 2 * by(&x, &y, corners).len());
        assert!(by(&x, &y, None) == by(&x, &y, corners));
    }

    #[test]
    fn without_rows_between_the_hulls_there_is_nothing_to_filter() {
        let x: Vec<i64> = (0..10_000).collect();
        let parabola: Vec<i64> = x.iter().map(|x| x * x).collect();
        assert_eq!(survivors(&x, &parabola, None), None);
        assert_eq!(candidates(&x, &parabola, None), (0..10_000).collect::<Vec<usize>>());
        // A third of them would not be worth it either.
        let third: Vec<i64> = x.iter().map(|&x| if x % 3 == 0 { x * x + 100_000 } else { x * x }).collect();
        assert_eq!(survivors(&x, &third, None), None);
        let forced = survivors(&x, &third, Some(&plan(Some(Division::Corners)))).unwrap();
        assert!(forced.len() < 7_000, "{}", forced.len());
    }

    #[test]
    fn a_column_reaches_as_far_as_its_offsets_are_finite() {
        assert!(Coordinate::reaches(-f64::MAX, 0.0) && Coordinate::reaches(1.0, f64::MAX));
        assert!(!Coordinate::reaches(-f64::MAX, f64::MAX));
        assert!(Coordinate::reaches(0, i64::MAX) && Coordinate::reaches(i64::MIN, -1));
        assert!(!Coordinate::reaches(-1, i64::MAX) && !Coordinate::reaches(i64::MIN, 0));
        assert!(Coordinate::reaches(0, i128::MAX) && !Coordinate::reaches(i128::MIN, 0));
    }
}
