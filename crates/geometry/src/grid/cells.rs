//! Division of the x-axis into cells.

use super::coordinate::Coordinate;

/// A line `slope·offset + intercept`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Chord {
    pub(super) slope: f64,
    pub(super) intercept: f64,
}

impl Chord {
    #[inline]
    pub(super) fn at(self, offset: f64) -> f64 {
        self.slope * offset + self.intercept
    }

    /// The mirror image in the x-axis.
    pub(super) fn mirrored(self) -> Self {
        Chord { slope: -self.slope, intercept: -self.intercept }
    }
}

/// The place of a point in this cell that is discarded: above one chord and below another.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cell {
    pub(super) above: Chord,
    pub(super) below: Chord,
}

impl Cell {
    /// Nothing is above an infinity.
    pub(super) const KEEPS_ALL: Self = Cell {
        above: Chord { slope: 0.0, intercept: f64::INFINITY },
        below: Chord { slope: 0.0, intercept: f64::NEG_INFINITY },
    };
}

/// No division has more cells: 16 KiB of them, half of a first-level cache.
pub(super) const MOST_CELLS: usize = 512;

/// Finds the cell of an x.
pub(super) trait Index<C> {
    /// Number of cells.
    const CELLS: usize;
    /// Less than the number of cells for every x; does not decrease from the least to the greatest x of the sample.
    fn cell(&self, x: C, offset: f64) -> usize;
    /// Returns whether nothing in the cell is left of this x.
    fn is_before(&self, x: C, offset: f64, cell: usize) -> bool;
    /// Returns whether nothing in the cell is right of this x.
    fn is_after(&self, x: C, offset: f64, cell: usize) -> bool;
}

/// Cells of equal width.
pub(super) struct Equal {
    scale: f64,
    span: f64,
    /// The distance from which on one number is certainly on one side of another.
    blur: f64,
}

impl Equal {
    /// Returns an index for offsets from 0 to `span`, which order their numbers where they differ by `blur` or more.
    pub(super) fn of_span(span: f64, blur: f64) -> Option<Self> {
        let scale = if span > 0.0 { (MOST_CELLS - 1) as f64 / span } else { 0.0 };
        scale.is_finite().then_some(Equal { scale, span, blur })
    }
}

impl<C> Index<C> for Equal {
    const CELLS: usize = MOST_CELLS;

    #[inline]
    fn cell(&self, _: C, offset: f64) -> usize {
        /// Added to a number from 0 to 2⁵¹, it leaves the nearest integer in the last bits of the sum.
        const ROUNDING: f64 = (1_u64 << 52) as f64;
        // Subtraction, product and sum round monotonically, and `span * scale` is less than half above the last cell.
        (offset * self.scale + ROUNDING).to_bits() as usize % MOST_CELLS
    }

    fn is_before(&self, x: C, offset: f64, cell: usize) -> bool {
        self.cell(x, (offset + self.blur).min(self.span)) < cell
    }

    fn is_after(&self, x: C, offset: f64, cell: usize) -> bool {
        self.cell(x, (offset - self.blur).max(0.0)) > cell
    }
}

/// Cells between ascending knots: cell k from knot k - 1 on until before knot k.
pub(super) struct Between<C> {
    knots: [C; KNOTS],
}

const KNOTS: usize = 63;

impl<C: Coordinate> Between<C> {
    /// Returns cells between some of ascending places, evenly chosen if there are many; `None` without any.
    pub(super) fn places(places: &[C]) -> Option<Self> {
        let last = places.len().checked_sub(1)?;
        let knots = std::array::from_fn(|k| if last < KNOTS { k.min(last) } else { k * last / (KNOTS - 1) });
        Some(Between { knots: knots.map(|place| places[place]) })
    }
}

impl<C: Coordinate> Index<C> for Between<C> {
    const CELLS: usize = KNOTS + 1;

    #[inline]
    fn cell(&self, x: C, _: f64) -> usize {
        // Binary search for the number of knots that are not right of x, without branches.
        [32, 16, 8, 4, 2, 1]
            .into_iter()
            .fold(0, |cell, step| cell + step * usize::from(self.knots[(cell + step - 1) % KNOTS] <= x))
    }

    fn is_before(&self, x: C, _: f64, cell: usize) -> bool {
        cell > 0 && x <= self.knots[cell - 1]
    }

    fn is_after(&self, x: C, _: f64, cell: usize) -> bool {
        cell < KNOTS && x >= self.knots[cell]
    }
}

/// Cells around and between ascending places that are rounded: a knot certainly left of each place, and one certainly right of it.
/// One more knot is 0, so that each cell is on one side of it.
pub(super) struct Around {
    between: Between<f64>,
    /// The difference from which on, relatively, one number is certainly on one side of another.
    blur: f64,
}

impl Around {
    /// Returns cells around some of ascending places, evenly chosen if there are many; `None` without any.
    pub(super) fn places(places: &[f64], blur: f64) -> Option<Self> {
        const MOST: usize = KNOTS / 2;
        let last = places.len().checked_sub(1)?;
        let chosen: Vec<f64> = match last < MOST {
            true => places.to_vec(),
            false => (0..MOST).map(|k| places[k * last / (MOST - 1)]).collect(),
        };
        let mut knots: Vec<f64> =
            chosen.into_iter().flat_map(|place| [moved(place, -blur), moved(place, blur)]).collect();
        knots.push(0.0);
        knots.sort_unstable_by(f64::total_cmp);
        Some(Around { between: Between::places(&knots)?, blur })
    }

    /// Returns whether a cell is right of x = 0, and not left of it.
    pub(super) fn is_right_of_zero(&self, cell: usize) -> bool {
        cell > 0 && self.between.knots[cell - 1] >= 0.0
    }
}

/// A number moved by a part of its magnitude.
pub(super) fn moved(number: f64, part: f64) -> f64 {
    number + number.abs() * part
}

impl Index<f64> for Around {
    const CELLS: usize = <Between<f64> as Index<f64>>::CELLS;

    #[inline]
    fn cell(&self, x: f64, offset: f64) -> usize {
        self.between.cell(x, offset)
    }

    fn is_before(&self, x: f64, offset: f64, cell: usize) -> bool {
        self.between.is_before(moved(x, self.blur), offset, cell)
    }

    fn is_after(&self, x: f64, offset: f64, cell: usize) -> bool {
        self.between.is_after(moved(x, -self.blur), offset, cell)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns, for each place of 0, 10, 20, …, the cells that begin there or later, and the cells that end there or
    /// before.
    fn around(count: i64) -> Vec<(usize, usize, usize)> {
        let places: Vec<i64> = (0..count).map(|k| 10 * k).collect();
        let between = Between::places(&places).unwrap();
        let cells = || 0..<Between<i64> as Index<i64>>::CELLS;
        let of = |x: i64| {
            let behind = cells().filter(|&cell| between.is_before(x, 0.0, cell)).count();
            let ahead = cells().filter(|&cell| between.is_after(x, 0.0, cell)).count();
            // A place left or right of a cell is in another cell.
            assert!(!between.is_before(x + 1, 0.0, between.cell(x, 0.0)));
            assert!(!between.is_after(x - 1, 0.0, between.cell(x, 0.0)));
            (between.cell(x, 0.0), behind, ahead)
        };
        assert_eq!(between.cell(-1, 0.0), 0);
        places.into_iter().map(of).collect()
    }

    #[test]
    fn up_to_63_places_are_knots_each() {
        assert!(Between::<i64>::places(&[]).is_none());
        for count in [1, 2, 3, 62, 63] {
            let last = count - 1;
            for (place, (cell, behind, ahead)) in around(count).into_iter().enumerate() {
                // Behind the last place are all cells that are left over, of no width but for the last.
                assert_eq!(cell, if place == last as usize { 63 } else { place + 1 }, "{count}");
                assert_eq!((behind, ahead), (63 - place, cell), "{count} {place}");
            }
        }
    }

    #[test]
    fn of_more_places_63_are_knots_evenly_from_the_first_to_the_last() {
        for count in [64, 125, 1000] {
            let around = around(count);
            assert_eq!(around[0], (1, 63, 1), "{count}");
            assert_eq!(around[count as usize - 1], (63, 1, 63), "{count}");
            let widest = around.chunk_by(|p, q| p.0 == q.0).map(<[_]>::len).max();
            assert_eq!(widest, Some((count as usize - 1).div_ceil(62)), "{count}");
        }
    }
}
