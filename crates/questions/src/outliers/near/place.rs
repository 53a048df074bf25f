//! A box that is divided into parts until few bounds cross what is left of it.

use boundfit_exact::{Integer, Rational};

/// The weight of a missed condition: more than all readings.
pub(crate) const FORBIDDEN: u64 = 1 << 40;

/// A box is divided into 2³ parts along each parameter.
const PARTS: i128 = 8;

/// The first box has at least 2²⁸ units along each parameter.
const BOX_BITS: i64 = 28;

/// More cells are not divided.
const MOST_CELLS: usize = 1024;

/// Cells are not divided where each bound crosses more of them.
const MOST_CROSSED: usize = 2;

/// Cells that fewer bounds cross are not divided.
const FEW_CROSSINGS: usize = 64;

/// The bits of a product of two machine integers, so that the sum of two products and a bound fits.
pub(super) const MOST_BITS: u32 = 124;

/// A bound `form·τ ≤ most` in the units of a place.
pub(super) struct Side {
    pub(super) form: [i128; 2],
    pub(super) most: i128,
    pub(super) weight: u64,
    pub(super) owner: usize,
    pub(super) is_lower: bool,
}

impl Side {
    pub(super) fn value(&self, point: &[i128; 2]) -> i128 {
        self.form[0] * point[0] + self.form[1] * point[1]
    }
}

/// A box on a grid of units 2^-scale.
pub(super) struct Place {
    pub(super) from: [i128; 2],
    /// Powers of two while the box is divided.
    pub(super) widths: [i128; 2],
    pub(super) scale: u32,
    /// A lower bound on the number of readings that a point outside the first box misses.
    pub(super) certain: u64,
}

impl Place {
    /// A box around these ranges; `None` where one is empty.
    pub(super) fn around(ranges: &[[Rational; 2]; 2], certain: u64) -> Option<Self> {
        let width = |[lower, upper]: &[Rational; 2]| upper - lower;
        let narrowest = ranges.iter().map(width).min().filter(Rational::is_positive)?;
        // 2^log ≤ 2·narrowest.
        let log = narrowest.numerator().bits() as i64 - narrowest.denominator().bits() as i64;
        let scale = u32::try_from(BOX_BITS.checked_sub(log)?.max(0)).ok()?;
        if scale > MOST_BITS {
            return None;
        }
        let units = Rational::from(&Integer::power_of_two(u64::from(scale)));
        let (mut from, mut widths) = ([0; 2], [0; 2]);
        for (k, [lower, upper]) in ranges.iter().enumerate() {
            let floor = |value: Rational| value.numerator().div_rem_floor(&value.denominator()).0.to_i128();
            let last = floor(upper * &units)?.checked_add(1)?;
            from[k] = floor(lower * &units).filter(|from| bits(*from) < MOST_BITS)?;
            let width = u128::try_from(last.checked_sub(from[k])?).ok()?;
            let width = width.checked_next_power_of_two()?.max((2 * PARTS) as u128);
            widths[k] = i128::try_from(width).ok().filter(|width| bits(*width) < MOST_BITS)?;
        }
        Some(Place { from, widths, scale, certain })
    }

    /// The smallest and the largest value of a form on the box.
    pub(super) fn reach(&self, side: &Side) -> [i128; 2] {
        let mut ends = [0; 2];
        for ((part, from), width) in side.form.iter().zip(self.from).zip(self.widths) {
            let (start, along) = (part * from, part * width);
            ends[0] += start + along.min(0);
            ends[1] += start + along.max(0);
        }
        ends
    }

    /// Splits bounds into the weight of those missed throughout the box, and those that cross it.
    fn split<'a>(&self, sides: impl Iterator<Item = &'a Side>) -> (u64, Vec<&'a Side>) {
        let (mut missed, mut crossing) = (0, Vec::new());
        for side in sides {
            let [least, most] = self.reach(side);
            if least > side.most {
                missed += side.weight;
            } else if most > side.most {
                crossing.push(side);
            }
        }
        (missed, crossing)
    }

    /// Divides the box into parts, and leaves those in which more readings are missed than at the best point found. `None` where
    /// conditions are missed at every point that was tried.
    pub(super) fn divided(&self, sides: &[Side]) -> Option<Cells> {
        let (missed, crossing) = self.split(sides.iter());
        let mut cells = vec![Cell { index: [0; 2], missed, crossing }];
        let (mut widths, mut fewest) = (self.widths, FORBIDDEN);
        let crossings = |cells: &[Cell<'_>]| cells.iter().map(|cell| cell.crossing.len()).sum::<usize>();
        while widths.iter().all(|width| *width >= 2 * PARTS) {
            let parts: Vec<Vec<Part>> = cells
                .iter()
                .map(|cell| self.cell(cell.index, widths).parts(cell.missed, &cell.crossing))
                .collect();
            fewest = parts.iter().flatten().map(|part| part.at_centre).fold(fewest, u64::min);
            widths = widths.map(|width| width / PARTS);
            let finer = cells.iter().zip(&parts).flat_map(|(cell, parts)| {
                cell.left(parts, fewest).map(|(index, part)| {
                    let (_, crossing) = self.cell(index, widths).split(cell.crossing.iter().copied());
                    Cell { index, missed: part.throughout, crossing }
                })
            });
            cells = finer.collect();
            let pays = FEW_CROSSINGS..MOST_CROSSED * sides.len();
            if cells.len() > MOST_CELLS || !pays.contains(&crossings(&cells)) {
                break;
            }
        }
        let cells: Vec<[i128; 2]> = cells.iter().map(|cell| cell.index).collect();
        (fewest < FORBIDDEN).then(|| Cells { corners: hull(&cells), widths, fewest })
    }

    /// A cell of these widths.
    fn cell(&self, index: [i128; 2], widths: [i128; 2]) -> Place {
        let from = [0, 1].map(|axis| self.from[axis] + index[axis] * widths[axis]);
        Place { from, widths, ..*self }
    }

    /// The box of a convex polygon in cells, as a box and as corners.
    pub(super) fn around_cells(&self, Cells { corners, widths, .. }: &Cells) -> (Place, Vec<[i128; 2]>) {
        let corners: Vec<[i128; 2]> = corners.iter().map(|own| self.cell(*own, *widths).from).collect();
        let ends = [0, 1].map(|axis| {
            let own = corners.iter().map(move |corner| corner[axis]);
            [own.clone().min().unwrap_or_default(), own.max().unwrap_or_default()]
        });
        let place =
            Place { from: ends.map(|[from, _]| from), widths: ends.map(|[from, to]| to - from), ..*self };
        (place, corners)
    }

    /// The numbers of readings that are missed in each part: throughout it, and at its centre.
    fn parts(&self, missed: u64, crossing: &[&Side]) -> Vec<Part> {
        let mut parts = vec![Part { throughout: missed, at_centre: missed }; (PARTS * PARTS) as usize];
        for side in crossing {
            let mut start = side.form[0] * self.from[0] + side.form[1] * self.from[1] - side.most;
            let [along, up] = [0, 1].map(|axis| side.form[axis] * (self.widths[axis] / PARTS / 2));
            let least = along.min(-along) + up.min(-up);
            start += along + up;
            for column in parts.chunks_exact_mut(PARTS as usize) {
                let mut centre = start;
                for part in column {
                    part.at_centre += if centre > 0 { side.weight } else { 0 };
                    part.throughout += if centre + least > 0 { side.weight } else { 0 };
                    centre += 2 * up;
                }
                start += 2 * along;
            }
        }
        parts
    }
}

/// A part of a box: its place in units of its widths, the weight of what is missed throughout, and the bounds that cross it.
struct Cell<'a> {
    index: [i128; 2],
    missed: u64,
    crossing: Vec<&'a Side>,
}

impl Cell<'_> {
    /// The parts in which at most the fewest are missed, each with its place. Where no bound crosses the cell, its corners are
    /// enough, since a convex polygon around them is asked for.
    fn left<'a>(&'a self, parts: &'a [Part], fewest: u64) -> impl Iterator<Item = ([i128; 2], &'a Part)> {
        let placed = (0..).zip(parts).map(|(place, part)| ([place / PARTS, place % PARTS], part));
        let is_corner = |place: &[i128; 2]| place.iter().all(|own| [0, PARTS - 1].contains(own));
        let kept = placed.filter(move |(place, part)| {
            part.throughout <= fewest && (!self.crossing.is_empty() || is_corner(place))
        });
        kept.map(|(place, part)| ([0, 1].map(|axis| self.index[axis] * PARTS + place[axis]), part))
    }
}

/// The cells that are left of a box.
pub(super) struct Cells {
    /// The corners, counter-clockwise, of a convex polygon with all cells strictly within, in units of the widths.
    corners: Vec<[i128; 2]>,
    widths: [i128; 2],
    /// The number of readings that are missed at some point in them.
    pub(super) fewest: u64,
}

/// The numbers of readings missed in a part of a box.
#[derive(Clone, Copy)]
struct Part {
    throughout: u64,
    at_centre: u64,
}

/// The corners of the convex hull of cells and of those next to them, counter-clockwise.
fn hull(cells: &[[i128; 2]]) -> Vec<[i128; 2]> {
    let around = |&[x, y]: &[i128; 2]| [[x - 1, y - 1], [x - 1, y + 2], [x + 2, y - 1], [x + 2, y + 2]];
    let mut points: Vec<[i128; 2]> = cells.iter().flat_map(around).collect();
    points.sort_unstable();
    points.dedup();
    let chain = |walk: &mut dyn Iterator<Item = &[i128; 2]>| {
        let mut chain: Vec<[i128; 2]> = Vec::new();
        for &[x, y] in walk {
            while let [.., [px, py], [qx, qy]] = chain.as_slice()
                && (qx - px) * (y - py) <= (qy - py) * (x - px)
            {
                chain.pop();
            }
            chain.push([x, y]);
        }
        // The last point begins the other chain.
        chain.pop();
        chain
    };
    let mut corners = chain(&mut points.iter());
    corners.extend(chain(&mut points.iter().rev()));
    corners
}

/// The number of bits of a size.
pub(super) fn bits(value: i128) -> u32 {
    u128::BITS - value.unsigned_abs().leading_zeros()
}
