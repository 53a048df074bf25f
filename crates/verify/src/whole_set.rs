//! One set and its bounds, in the order of `docs/proof.md`, sections 3 to 6.

use std::collections::{BTreeMap, BTreeSet};
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
use crate::sides::{Clearance, Sides};
use crate::theorem::Agreed;

/// The half-planes that may touch or cut the set as far as its vertices tell, which are not known to be true yet.
struct Doubtful {
    /// None where they are too many to keep, or the vertices tell nothing.
    half_planes: Option<Vec<(Name, HalfPlane)>>,
    /// The memory that they take.
    bits: u64,
}

impl Doubtful {
    fn new(vertices_tell: bool) -> Self {
        Doubtful { half_planes: vertices_tell.then(Vec::new), bits: 0 }
    }

    fn add(&mut self, name: Name, half_plane: &dyn Fn() -> HalfPlane) {
        /// Half a mebibyte: eight thousand half-planes of short numbers.
        const MOST_BITS: u64 = 1 << 22;
        if let Some(kept) = &mut self.half_planes {
            let half_plane = half_plane();
            self.bits += half_plane.bits();
            kept.push((name, half_plane));
        }
        self.half_planes.take_if(|_| self.bits > MOST_BITS);
    }
}

/// The statement of version 1.
#[derive(Debug, Clone)]
pub(crate) struct WholeSet {
    vertices: Vec<Vector>,
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

    /// Checks all of it against the data, which `open` gives from the start.
    pub(crate) fn verify<R: Read>(
        &self,
        data: &Data,
        mut open: impl FnMut() -> Result<R, Failure>,
        limits: &DataLimits,
    ) -> Result<(Agreed, SetFound), Failure> {
        let wanted = self.names();
        let mut named = BTreeMap::new();
        let mut half_planes = data.about.conditions_by_name().count();
        let clearance = Clearance::of(&self.vertices);
        let mut doubtful = Doubtful::new(clearance.is_some());
        let take = |name, half_plane: &dyn Fn() -> HalfPlane| {
            if wanted.contains(&name) {
                named.insert(name, half_plane());
            }
            doubtful.add(name, half_plane);
            Ok(())
        };
        let wanted_rows: BTreeSet<u64> = wanted.iter().filter_map(|name| name.row()).collect();
        let mut wanted_rows = wanted_rows.into_iter().peekable();
        let passes_over = |row, model: &Model| {
            half_planes += model.sides().into_iter().filter(|is_there| *is_there).count();
            // Rows come in ascending order.
            while wanted_rows.next_if(|wanted| *wanted < row).is_some() {}
            wanted_rows.peek() != Some(&row)
                && clearance.as_ref().is_none_or(|clearance| clearance.is_clear_of(model))
        };
        let longest = longest(&self.vertices);
        let look = data.look(open()?, limits, |about, rows| {
            about.for_each_half_plane(rows, limits, longest, passes_over, take)
        })?;
        let (rows_total, names) = look.first()?;
        let found = self.check(data, &HalfPlanes(named), doubtful, open, limits)?;
        Ok((Agreed { rows_total, names, half_planes }, found))
    }

    /// The half-planes that sides and multipliers name, which are few.
    fn names(&self) -> BTreeSet<Name> {
        let sides = self.sides.iter().map(|(name, _)| name);
        let multiples = self.bounds.iter().flat_map(|(multiples, ..)| multiples).chain(&self.farkas);
        names(sides.chain(multiples.map(|(name, _)| name)))
    }

    /// Checks all of it against the half-planes that it names and, unless the set is empty, against all others: those in
    /// doubt, or all of the data.
    fn check<R: Read>(
        &self,
        data: &Data,
        half_planes: &HalfPlanes,
        doubtful: Doubtful,
        open: impl FnOnce() -> Result<R, Failure>,
        limits: &DataLimits,
    ) -> Result<SetFound, Failure> {
        let (extent, bounds) = if self.farkas.is_empty() {
            let sides = Sides::of(&self.vertices, &self.sides, half_planes)?;
            self.check_every_half_plane(data, &sides, doubtful, open, limits)?;
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
        doubtful: Doubtful,
        open: impl FnOnce() -> Result<R, Failure>,
        limits: &DataLimits,
    ) -> Result<(), Failure> {
        let mut is_found = vec![false; self.active.len()];
        let mut take = |name, half_plane: &dyn Fn() -> HalfPlane| {
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
        let is_bounded = sides.extent() == Extent::Bounded;
        if let Some(half_planes) = doubtful.half_planes.filter(|_| is_bounded) {
            for (name, half_plane) in half_planes {
                take(name, &|| half_plane.clone())?;
            }
        } else {
            let longest = longest(&self.vertices);
            let clearance = Clearance::of(&self.vertices).filter(|_| is_bounded);
            let is_clear =
                |_, model: &Model| clearance.as_ref().is_some_and(|clearance| clearance.is_clear_of(model));
            let look = data.look(open()?, limits, |about, rows| {
                about.for_each_half_plane(rows, limits, longest, is_clear, take)
            })?;
            look.again()?;
        }
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
fn longest(points: &[Vector]) -> u64 {
    points.iter().map(|[x, y]| x.bits() + y.bits()).max().unwrap_or_default()
}
