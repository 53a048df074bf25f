//! One set and its bounds, in the order of `docs/proof.md`, sections 3 to 6.

use std::collections::BTreeSet;
use std::io::Read;

use boundfit_exact::Rational;

use crate::cells::Model;
use crate::data::Data;
use crate::failure::{DataLimits, Failure};
use crate::falsehood::Falsehood;
use crate::found::{Extent, SetFound};
use crate::half_planes::{End, HalfPlanes, Multiples, end, multiples, names, vector};
use crate::name::{Name, Named};
use crate::plane::{HalfPlane, Point, Vector, dot};
use crate::shape::{NotAProof, Shape, needed};
use crate::sides::Sides;

/// The statement of version 1.
#[derive(Debug, Clone)]
pub(crate) struct WholeSet {
    pub(crate) vertices: Vec<Vector>,
    /// Pairs of a vertex, an index from 0, and a half-plane that touches it; in order, and none twice.
    active: Vec<(u64, Named)>,
    /// Pairs of a half-plane and the vertex where the next side begins; none where a gap comes instead.
    sides: Vec<(Named, Option<u64>)>,
    farkas: Multiples,
    /// The proofs of each end of the parameters' ranges.
    bounds: Vec<End>,
}

impl WholeSet {
    /// Takes the fields that it has out of the file's.
    pub(crate) fn read(shape: &mut Shape) -> Result<Self, NotAProof> {
        let mut active = needed(shape.active.take(), "active")?;
        active.sort_unstable();
        active.dedup();
        Ok(WholeSet {
            vertices: needed(shape.vertices.take(), "vertices")?.into_iter().map(vector).collect(),
            active,
            sides: needed(shape.sides.take(), "sides")?,
            farkas: multiples(needed(shape.farkas.take(), "farkas")?),
            bounds: needed(shape.bounds.take(), "bounds")?.into_iter().map(end).collect(),
        })
    }

    /// The half-planes that sides and multipliers name, which are few.
    pub(crate) fn names(&self) -> BTreeSet<Name> {
        let sides = self.sides.iter().map(|(name, _)| name);
        let multiples = self.bounds.iter().flat_map(|(multiples, ..)| multiples).chain(&self.farkas);
        names(sides.chain(multiples.map(|(name, _)| name)))
    }

    /// Checks all of it against the half-planes that it names and, unless the set is empty, against all data.
    pub(crate) fn check<R: Read>(
        &self,
        data: &Data,
        half_planes: &HalfPlanes,
        open: impl FnOnce() -> Result<R, Failure>,
        limits: &DataLimits,
    ) -> Result<SetFound, Failure> {
        let (extent, bounds) = if self.farkas.is_empty() {
            let sides = Sides::of(&self.vertices, &self.sides, half_planes)?;
            self.check_every_half_plane(data, &sides, open()?, limits)?;
            let bounds = self.check_bounds(&sides, half_planes)?;
            (sides.extent(), Some(bounds))
        } else {
            self.check_empty(half_planes)?;
            (Extent::Empty, None)
        };
        let (vertices, sides) = (self.vertices.len(), self.sides.len());
        Ok(SetFound { extent, vertices, sides, bounds })
    }

    /// Section 3: half-planes add up to 0 ≤ b with b < 0, which no point satisfies.
    fn check_empty(&self, half_planes: &HalfPlanes) -> Result<(), Falsehood> {
        let (a, b) = half_planes.sum(&self.farkas, 3)?;
        let is_false = a == Vector::default() && b.is_negative();
        let has_parts = !(self.sides.is_empty()
            && self.vertices.is_empty()
            && self.active.is_empty()
            && self.bounds.is_empty());
        if is_false && !has_parts { Ok(()) } else { Err(Falsehood::NotEmpty) }
    }

    /// Section 5: each half-plane contains the set, and those that touch a vertex are those that the proof lists.
    fn check_every_half_plane<R: Read>(
        &self,
        data: &Data,
        sides: &Sides<'_>,
        reader: R,
        limits: &DataLimits,
    ) -> Result<(), Failure> {
        let mut is_found = vec![false; self.active.len()];
        let take = |name, half_plane: &dyn Fn() -> HalfPlane| {
            let support = sides.support(&half_plane()).filter(|support| support.against_b.is_le());
            let support = support.ok_or(Falsehood::CutsOff(name))?;
            if support.against_b.is_lt() {
                return Ok(());
            }
            for vertex in support.vertices.into_iter().flatten() {
                let touching = (vertex as u64, Named::A(name));
                let found =
                    self.active.binary_search(&touching).ok().and_then(|index| is_found.get_mut(index));
                let not_touching = || not_touching(&touching);
                *found.ok_or_else(not_touching)? = true;
            }
            Ok(())
        };
        let longest = longest(&self.vertices);
        let clearance = sides.clearance();
        let is_clear = |_, model: &Model| {
            let clearance = clearance.as_ref().zip(model.word_row());
            clearance.is_some_and(|(clearance, row)| clearance.is_clear(&row))
        };
        let look = data.look(reader, limits, |about, rows| {
            about.for_each_half_plane(rows, limits, longest, is_clear, take)
        })?;
        look.again()?;
        match self.active.iter().zip(is_found).find(|(_, is_found)| !is_found) {
            None => Ok(()),
            Some((listed, _)) => Err(not_touching(listed).into()),
        }
    }

    /// Section 6: the range of each parameter.
    fn check_bounds(
        &self,
        sides: &Sides<'_>,
        half_planes: &HalfPlanes,
    ) -> Result<[[Option<Rational>; 2]; 2], Falsehood> {
        let [lower1, upper1, lower2, upper2] = self.bounds.as_slice() else {
            return Err(Falsehood::NotFourBounds);
        };
        let check = |bound, direction| check_bound(bound, direction, sides, half_planes);
        let theta1 = [check(lower1, [-1, 0])?, check(upper1, [1, 0])?];
        let theta2 = [check(lower2, [0, -1])?, check(upper2, [0, 1])?];
        Ok([theta1, theta2])
    }
}

fn not_touching((vertex, name): &(u64, Named)) -> Falsehood {
    let half_plane = match name {
        Named::A(name) => name.to_string().into(),
        Named::NoHalfPlane(text) => text.clone(),
    };
    Falsehood::NotTouching { vertex: *vertex, half_plane }
}

/// Checks multiples, point and ray of the bound in one direction, along an axis or against it. The end of the parameter, or `None` when nothing bounds it.
fn check_bound(
    (multiples, point, ray): &End,
    direction: [i64; 2],
    sides: &Sides<'_>,
    half_planes: &HalfPlanes,
) -> Result<Option<Rational>, Falsehood> {
    let e = direction.map(Rational::from);
    let is_inside = sides.contain(&Point::new(point)) && sides.recede_along(&Point::new(ray));
    let claim = (e.clone(), dot(&e, point));
    let is_reached = half_planes.sum(multiples, 2)? == claim && *ray == Vector::default();
    let goes_on = multiples.is_empty() && dot(&e, ray).is_positive();
    if !is_inside || !(is_reached || goes_on) {
        return Err(Falsehood::NotABound(direction));
    }
    let [theta1, theta2] = point;
    let end = if direction[0] == 0 { theta2 } else { theta1 };
    Ok(is_reached.then(|| end.clone()))
}

/// Returns how many bits the longest of these points has.
pub(crate) fn longest(points: &[Vector]) -> u64 {
    points.iter().map(|[x, y]| x.bits() + y.bits()).max().unwrap_or_default()
}
