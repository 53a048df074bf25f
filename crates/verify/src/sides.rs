//! The set that the sides enclose: one walk around it (section 4), and its extent in any direction (section 5).

use std::collections::BTreeSet;

use boundfit_exact::Rational;

use crate::falsehood::Falsehood;
use crate::plane::{Angle, HalfPlane, Vector, cross, dot};
use crate::proof::{Named, Proof};

/// A vertex of the proof, with its index there.
#[derive(Clone, Copy)]
struct Vertex<'a> {
    index: usize,
    point: &'a Vector,
}

struct Side<'a> {
    name: &'a str,
    /// That of the outer normal.
    angle: Angle,
    half_plane: &'a HalfPlane,
    /// Where the next side begins; `None` where a gap comes instead.
    end: Option<Vertex<'a>>,
}

/// The sides in the order of their angles.
pub(crate) struct Sides<'a>(Vec<Side<'a>>);

/// The maximum of a form over the set, and the vertices at the ends of the side where it is attained, one or two of them; `None`
/// where that side has no end.
pub(crate) struct Support {
    pub(crate) maximum: Rational,
    pub(crate) vertices: [Option<usize>; 2],
}

impl<'a> Sides<'a> {
    /// Takes the sides of a proof and checks that they are in order, meet, and name every vertex.
    pub(crate) fn of(proof: &'a Proof, named: &'a Named) -> Result<Self, Falsehood> {
        let sides = Sides::in_order(proof, named)?;
        sides.walk()?;
        let ends: BTreeSet<&Vector> =
            sides.0.iter().filter_map(|side| side.end).map(|end| end.point).collect();
        if ends.len() != proof.vertices.len() {
            return Err(Falsehood::StrayVertex);
        }
        Ok(sides)
    }

    /// The sides, their angles strictly increasing.
    fn in_order(proof: &'a Proof, named: &'a Named) -> Result<Self, Falsehood> {
        let mut sides: Vec<Side<'a>> = Vec::new();
        for (name, vertex) in &proof.sides {
            let end = match *vertex {
                None => None,
                Some(index) => {
                    let point = proof.vertices.get(index);
                    let point = point.ok_or_else(|| Falsehood::UnknownVertex(name.clone()))?;
                    Some(Vertex { index, point })
                }
            };
            let half_plane = named.get(name)?;
            match Angle::of(&half_plane.a) {
                Some(angle) if sides.last().is_none_or(|last| last.angle < angle) => {
                    sides.push(Side { name, angle, half_plane, end });
                }
                _ => return Err(Falsehood::OutOfOrder(name.clone())),
            }
        }
        Ok(Sides(sides))
    }

    /// Goes around once. After the last side comes the first again, which may be the same one.
    fn walk(&self) -> Result<(), Falsehood> {
        let next = self.0.iter().cycle().skip(1);
        for (side, next) in self.0.iter().zip(next) {
            let turns_left = cross(&side.half_plane.a, &next.half_plane.a).is_positive();
            let meet = match side.end {
                // A gap is where the next normal is half a turn away or more, and nowhere else.
                None => !turns_left,
                Some(end) => {
                    turns_left && side.has_on_line(end) && next.has_on_line(end) && next.goes_on_from(end)
                }
            };
            if !meet {
                return Err(Falsehood::DoNotMeet(side.name.to_owned()));
            }
        }
        Ok(())
    }

    /// Whether a point satisfies every side.
    pub(crate) fn contain(&self, point: &Vector) -> bool {
        self.0.iter().all(|side| dot(&side.half_plane.a, point) <= side.half_plane.b)
    }

    /// Whether one may go on for ever in a direction, from any point of the set.
    pub(crate) fn recede_along(&self, ray: &Vector) -> bool {
        self.0.iter().all(|side| !dot(&side.half_plane.a, ray).is_positive())
    }

    /// Whether the set is bounded: it has sides and no gap.
    pub(crate) fn are_closed(&self) -> bool {
        !self.0.is_empty() && self.0.iter().all(|side| side.end.is_some())
    }

    /// The maximum of a·θ over the set; `None` when there is none. Cost: a binary search.
    pub(crate) fn support(&self, a: &Vector) -> Option<Support> {
        let Some(angle) = Angle::of(a) else {
            return Some(Support { maximum: Rational::zero(), vertices: [None; 2] });
        };
        // They differ only if a side has this very angle: then one is where it begins, the other where it ends.
        let before = self.last_side(|own| *own < angle)?;
        let up_to = self.last_side(|own| *own <= angle)?;
        let maximum = match before.end.or(up_to.end) {
            Some(vertex) => dot(a, vertex.point),
            None if up_to.angle == angle => multiple(a, &up_to.half_plane.a)? * &up_to.half_plane.b,
            None => return None,
        };
        Some(Support { maximum, vertices: [before.end, up_to.end].map(|end| end.map(|vertex| vertex.index)) })
    }

    /// The last side, around the circle, among those that come first by their angles.
    fn last_side(&self, comes_first: impl Fn(&Angle) -> bool) -> Option<&Side<'a>> {
        let count = self.0.partition_point(|side| comes_first(&side.angle));
        let last = count.checked_sub(1).and_then(|index| self.0.get(index));
        last.or(self.0.last())
    }
}

impl Side<'_> {
    fn has_on_line(&self, vertex: Vertex<'_>) -> bool {
        dot(&self.half_plane.a, vertex.point) == self.half_plane.b
    }

    /// Whether the side, which begins at a vertex, does not run backwards from there to its own end.
    fn goes_on_from(&self, start: Vertex<'_>) -> bool {
        let [a1, a2] = &self.half_plane.a;
        let along = [-a2, a1.clone()];
        self.end.is_none_or(|end| dot(&along, end.point) >= dot(&along, start.point))
    }
}

/// λ with u = λ·v, for parallel vectors and v ≠ 0.
fn multiple(u: &Vector, v: &Vector) -> Option<Rational> {
    let [[u1, u2], [v1, v2]] = [u, v];
    u1.checked_div(v1).or_else(|| u2.checked_div(v2))
}
