//! The set that the sides enclose: one walk around it (section 4), and its extent in any direction (section 5).

use std::cmp::Ordering;
use std::collections::BTreeSet;

use boundfit_exact::Integer;

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
