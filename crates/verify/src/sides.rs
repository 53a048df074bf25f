//! The set that the sides enclose: one walk around it (section 4), and its extent in any direction (section 5).

use std::cmp::Ordering;
use std::collections::BTreeSet;

use boundfit_exact::Integer;

use crate::cells::{Model, WordRow};
use crate::falsehood::Falsehood;
use crate::found::Extent;
use crate::half_planes::HalfPlanes;
use crate::name::{Name, Named};
use crate::plane::{HalfPlane, Point, Vector, compare_angles, turn};

struct Side<'a> {
    name: Name,
    half_plane: &'a HalfPlane,
    /// The index of the vertex where the next side begins; `None` where a gap comes instead.
    end: Option<usize>,
}

/// The sides in the order of the angles of their outer normals.
pub(crate) struct Sides<'a> {
    sides: Vec<Side<'a>>,
    vertices: Vec<Point>,
}

/// The position of a half-plane.
pub(crate) struct Support {
    /// The largest a·θ in the set against b: not greater where the half-plane contains the set.
    pub(crate) against_b: Ordering,
    /// The vertices at the ends of the side where it is attained, one or two of them; `None` where that side has no end.
    pub(crate) vertices: [Option<usize>; 2],
}

/// The vertices of a bounded set on a grid, to tell of almost every row of many that the set is clear of its bounds.
pub(crate) struct Clearance {
    /// The vertices from below: each coordinate is at least this many units of 2^-shift, and less than one more.
    corners: Vec<[i64; 2]>,
    /// A box around them: the least and the most of each coordinate in these units.
    around: [[i128; 2]; 2],
    shift: u32,
}

impl Clearance {
    /// Puts the vertices of a set on a grid. All that it tells holds if the set is bounded. `None` for more than 64 vertices, where
    /// searching for the one that matters takes less time.
    pub(crate) fn of(vertices: &[Vector]) -> Option<Self> {
        const MOST: usize = 64;
        if vertices.len() > MOST {
            return None;
        }
        let points: Vec<Point> = vertices.iter().map(Point::new).collect();
        let shift = points.iter().map(Point::room).min()??;
        let corners: Vec<[i64; 2]> = points.iter().map(|point| point.units(shift)).collect::<Option<_>>()?;
        let side = |of: fn(&[i64; 2]) -> i64| {
            let (least, most) = (corners.iter().map(of).min()?, corners.iter().map(of).max()?);
            Some([i128::from(least), i128::from(most) + 1])
        };
        let around = [side(|[x, _]| *x)?, side(|[_, y]| *y)?];
        Some(Clearance { corners, around, shift })
    }

    /// Returns whether the set is clear of the row that was read, for sure.
    pub(crate) fn is_clear_of(&self, model: &Model) -> bool {
        model.word_row().is_some_and(|row| self.is_clear(&row))
    }

    /// Returns whether φ·θ is strictly between the row's bounds for each θ of the set, for sure. Then both half-planes contain the
    /// set, and touch it nowhere. Exact in this sense.
    ///
    /// On a bounded set φ·θ is largest and smallest at vertices, and between its ends on the box around them. With
    /// v = (u + f)/2^shift and f in [0, 1)², φ·v·2^shift is φ·u + φ·f, and |φ·f| is not above |φ1| + |φ2|: the margin.
    fn is_clear(&self, row: &WordRow) -> bool {
        let scaled = |bound: i64| i128::from(bound) << self.shift;
        let (lower, upper) = (row.lower.map(scaled), row.upper.map(scaled));
        let is_within = |least: i128, most: i128| {
            upper.is_none_or(|upper| most < upper) && lower.is_none_or(|lower| least > lower)
        };
        // |φ| is at most 2^63 and |u| at most 2^61: nothing here reaches 2^126.
        let [phi1, phi2] = row.phi.map(i128::from);
        let [[left, right], [bottom, top]] = self.around;
        let [(least1, most1), (least2, most2)] =
            [(phi1 * left, phi1 * right), (phi2 * bottom, phi2 * top)].map(|(a, b)| (a.min(b), a.max(b)));
        if is_within(least1 + least2, most1 + most2) {
            return true;
        }
        let along = |[x, y]: &[i64; 2]| phi1 * i128::from(*x) + phi2 * i128::from(*y);
        let (mut least, mut most) = (i128::MAX >> 1, i128::MIN >> 1);
        for corner in &self.corners {
            let along = along(corner);
            (least, most) = (least.min(along), most.max(along));
        }
        let margin = phi1.abs() + phi2.abs();
        is_within(least - margin, most + margin)
    }
}

impl<'a> Sides<'a> {
    /// Takes sides by their names and checks that they are in order, meet, and name every vertex.
    pub(crate) fn of(
        vertices: &[Vector],
        sides: &[(Named, Option<u64>)],
        half_planes: &'a HalfPlanes,
    ) -> Result<Self, Falsehood> {
        let sides = in_order(sides, vertices.len(), half_planes)?;
        let sides = Sides { sides, vertices: vertices.iter().map(Point::new).collect() };
        sides.walk()?;
        let points = sides.sides.iter().filter_map(|side| vertices.get(side.end?));
        let points: BTreeSet<&Vector> = points.collect();
        if points.len() != vertices.len() {
            return Err(Falsehood::StrayVertex);
        }
        Ok(sides)
    }

    /// Goes around once. After the last side comes the first again, which may be the same one.
    fn walk(&self) -> Result<(), Falsehood> {
        let next = self.sides.iter().cycle().skip(1);
        for (side, next) in self.sides.iter().zip(next) {
            let (own, after) = (&side.half_plane, &next.half_plane);
            let turns_left = turn(&own.a, &after.a).is_gt();
            let meet = match self.end(side) {
                // A gap is where the next normal is half a turn away or more, and nowhere else.
                None => !turns_left,
                Some(end) => {
                    turns_left
                        && own.compare_at(end).is_eq()
                        && after.compare_at(end).is_eq()
                        && self.goes_on_from(next, end)
                }
            };
            if !meet {
                return Err(Falsehood::DoNotMeet(side.name));
            }
        }
        Ok(())
    }

    fn end(&self, side: &Side<'_>) -> Option<&Point> {
        self.vertices.get(side.end?)
    }

    /// Returns whether a side, which begins at a vertex, does not run backwards from there to its own end.
    fn goes_on_from(&self, side: &Side<'_>, start: &Point) -> bool {
        let [a1, a2] = &side.half_plane.a;
        let along = [-a2, a1.clone()];
        self.end(side).is_none_or(|end| end.compare_along(&along, start).is_ge())
    }

    /// Returns whether a point satisfies every side.
    pub(crate) fn contain(&self, point: &Point) -> bool {
        self.sides.iter().all(|side| side.half_plane.compare_at(point).is_le())
    }

    /// Returns whether one may go on for ever in a direction, from any point of the set.
    pub(crate) fn recede_along(&self, ray: &Point) -> bool {
        self.sides.iter().all(|side| side.half_plane.compare_along(ray).is_le())
    }

    /// The set is bounded where it has sides and no gap.
    pub(crate) fn extent(&self) -> Extent {
        let are_closed = !self.sides.is_empty() && self.sides.iter().all(|side| side.end.is_some());
        if are_closed { Extent::Bounded } else { Extent::Unbounded }
    }

    /// The largest a·θ in the set against b; `None` when there is none. Cost: a binary search.
    pub(crate) fn support(&self, half_plane: &HalfPlane) -> Option<Support> {
        let a = &half_plane.a;
        if a.iter().all(Integer::is_zero) {
            return Some(Support { against_b: Integer::zero().cmp(&half_plane.b), vertices: [None; 2] });
        }
        let first = self.sides.partition_point(|side| compare_angles(&side.half_plane.a, a).is_lt());
        let before = self.sides.get(first.checked_sub(1).unwrap_or(self.sides.len().checked_sub(1)?))?;
        // A side of this very angle: one vertex is where it begins, the other where it ends.
        let same = self.sides.get(first).filter(|side| compare_angles(&side.half_plane.a, a).is_eq());
        let up_to = same.unwrap_or(before);
        let against_b = match (before.end.or(up_to.end).and_then(|end| self.vertices.get(end)), same) {
            (Some(vertex), _) => half_plane.compare_at(vertex),
            (None, Some(side)) => compare_parallel(side.half_plane, half_plane),
            (None, None) => return None,
        };
        Some(Support { against_b, vertices: [before.end, up_to.end] })
    }
}

/// The sides, their angles strictly increasing.
fn in_order<'a>(
    names: &[(Named, Option<u64>)],
    vertices: usize,
    half_planes: &'a HalfPlanes,
) -> Result<Vec<Side<'a>>, Falsehood> {
    let mut sides: Vec<Side<'a>> = Vec::new();
    for (name, vertex) in names {
        let (name, half_plane) = half_planes.get(name)?;
        let end = vertex.map(|vertex| usize::try_from(vertex).unwrap_or(usize::MAX));
        if end.is_some_and(|end| end >= vertices) {
            return Err(Falsehood::UnknownVertex(name));
        }
        let has_angle = !half_plane.a.iter().all(Integer::is_zero);
        let comes_next = |last: &Side<'_>| compare_angles(&last.half_plane.a, &half_plane.a).is_lt();
        if !(has_angle && sides.last().is_none_or(comes_next)) {
            return Err(Falsehood::OutOfOrder(name));
        }
        sides.push(Side { name, half_plane, end });
    }
    Ok(sides)
}

/// Compares the bounds of two half-planes whose normals have the same direction: that of a·θ in the one with that of the other.
fn compare_parallel(one: &HalfPlane, other: &HalfPlane) -> Ordering {
    let index = usize::from(one.a[0].is_zero());
    let length = |half_plane: &HalfPlane| half_plane.a.get(index).map_or_else(Integer::zero, Integer::abs);
    (&one.b * length(other)).cmp(&(&other.b * length(one)))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use std::collections::BTreeMap;

    use boundfit_exact::Rational;

    use super::*;

    fn word(state: &mut u64) -> i64 {
        *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*state >> 33) as i64 - (1 << 30)
    }

    /// Boxes from (x, y) to (x + w, y + h), of any size and anywhere, against rows of which many touch them.
    #[test]
    fn bounds_that_are_clear_are_so_exactly() {
        let mut state = 11;
        let [mut clear, mut strict, mut touching] = [0; 3];
        for case in 0..3_000 {
            let denominator = [1, 7, 1000, 1 << 30][case % 4];
            let number = |state: &mut u64, size: i64| Rational::ratio(word(state) % size, denominator);
            let size = [2, 100, 1 << 29][case % 3];
            let (x, y) = (number(&mut state, size), number(&mut state, size));
            let (w, h) = (number(&mut state, size).abs(), number(&mut state, size).abs());
            if w.is_zero() || h.is_zero() {
                continue;
            }
            let (right, top) = (&x + w, &y + h);
            let vertices =
                [[&right, &top], [&x, &top], [&x, &y], [&right, &y]].map(|own| own.map(Clone::clone));
            let of = |a: [i64; 2], b: Rational| HalfPlane::new(&[a[0].into(), a[1].into(), b]);
            let half_planes =
                [of([1, 0], right.clone()), of([0, 1], top.clone()), of([-1, 0], -&x), of([0, -1], -&y)];
            let half_planes: BTreeMap<Name, HalfPlane> = (1..).map(Name::Where).zip(half_planes).collect();
            let half_planes = HalfPlanes(half_planes);
            let sides: Vec<_> = (1..=4).map(|own| (Named::A(Name::Where(own)), Some(own - 1))).collect();
            let sides = Sides::of(&vertices, &sides, &half_planes).unwrap();
            let clearance = Clearance::of(&vertices).unwrap();
            for _ in 0..20 {
                let phi = [word(&mut state) % size, word(&mut state) % size];
                // On the grid of the box, so that bounds can touch it.
                let along = |own: &[Rational; 2]| {
                    let [a, b] = phi.map(|phi| Rational::from(phi * denominator));
                    (a * &own[0] + b * &own[1]).numerator().to_i64()
                };
                let along: Option<Vec<i64>> = vertices.iter().map(along).collect();
                let Some((least, most)) =
                    along.and_then(|all| Some((*all.iter().min()?, *all.iter().max()?)))
                else {
                    continue;
                };
                let room = [word(&mut state) % 3, word(&mut state) % size];
                let bounds = [Some(least.saturating_sub(room[0])), Some(most.saturating_add(room[1]))];
                let [lower, upper] = if word(&mut state) % 5 == 0 { [None, bounds[1]] } else { bounds };
                let row = WordRow { phi: phi.map(|phi| phi * denominator), lower, upper };
                let own = |a: [i64; 2], b: i64| {
                    let half_plane = HalfPlane::new(&[a[0].into(), a[1].into(), b.into()]);
                    sides.support(&half_plane).unwrap().against_b
                };
                let phi = row.phi;
                let above = row.upper.map(|upper| own(phi, upper));
                let below = row.lower.map(|lower| own(phi.map(|phi| -phi), -lower));
                let is_strict = [above, below].into_iter().flatten().all(Ordering::is_lt);
                let is_clear = clearance.is_clear(&row);
                assert!(is_strict || !is_clear, "{vertices:?} {row:?}");
                clear += usize::from(is_clear);
                strict += usize::from(is_strict);
                touching += usize::from(!is_strict);
            }
        }
        assert!(
            clear > 5_000 && 100 * clear > 95 * strict && touching > 10_000,
            "{clear} {strict} {touching}"
        );
    }
}
