//! The checks, in the order of `docs/proof.md`.

use std::collections::BTreeMap;
use std::io::{self, Read};

use boundfit_exact::{Foreign, Rational};

use crate::failure::{DataLimits, Failure};
use crate::falsehood::Falsehood;
use crate::name::{Name, Named};
use crate::plane::{HalfPlane, Point, Vector, dot};
use crate::proof::{About, HalfPlanes, Multiples, Proof};
use crate::sides::Sides;

/// What a true proof states of the feasible parameter set, and of which question that is the answer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Statement {
    /// Which rows were read, how, and what they say about the parameters.
    pub about: About,
    /// How many rows the data have.
    pub rows_total: u64,
    /// The names of the columns that are read, where the data have a header; nothing for one that the header does not reach.
    pub names: BTreeMap<u64, Foreign>,
    /// How far the set goes.
    pub extent: Extent,
    /// How many vertices it has.
    pub vertices: usize,
    /// How many sides.
    pub sides: usize,
    /// How many half-planes the data and the conditions give.
    pub half_planes: usize,
    /// The range of each parameter, lower and upper end; an end is `None` where nothing bounds the parameter. `None` for an
    /// empty set.
    pub bounds: Option<[[Option<Rational>; 2]; 2]>,
}

/// How far a set goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Extent {
    /// There is no point in it.
    Empty,
    /// It lies within a circle.
    Bounded,
    /// It does not.
    Unbounded,
}

/// What the first look at the data finds.
struct Found {
    half_planes: HalfPlanes,
    count: usize,
    rows_total: u64,
    names: BTreeMap<u64, Foreign>,
}

impl Proof {
    /// Checks every statement against the data, which are read twice unless the set is empty: `open` gives them from the start.
    /// Exact. One row is in memory at a time; nothing depends on what was read before the hash is known to be right.
    ///
    /// # Errors
    /// The first statement that is false, or why the data cannot be checked.
    pub fn verify<R: Read>(
        &self,
        mut open: impl FnMut() -> io::Result<R>,
        limits: &DataLimits,
    ) -> Result<Statement, Failure> {
        let Found { half_planes, count, rows_total, names } =
            self.first_look(open().map_err(Failure::Unreadable)?, limits)?;
        let (extent, bounds) = if self.farkas.is_empty() {
            let sides = Sides::of(self, &half_planes)?;
            self.check_every_half_plane(&sides, open().map_err(Failure::Unreadable)?, limits)?;
            let bounds = self.check_bounds(&sides, &half_planes)?;
            (if sides.are_closed() { Extent::Bounded } else { Extent::Unbounded }, Some(bounds))
        } else {
            self.check_empty(&half_planes)?;
            (Extent::Empty, None)
        };
        let (vertices, sides) = (self.vertices.len(), self.sides.len());
        let about = self.about.clone();
        Ok(Statement { about, rows_total, names, extent, vertices, sides, half_planes: count, bounds })
    }

    /// Section 2: the hash of the data, that all wanted rows can be read, and the half-planes that the proof names.
    fn first_look<R: Read>(&self, data: R, limits: &DataLimits) -> Result<Found, Failure> {
        let wanted = self.names();
        let (mut half_planes, mut count) = (BTreeMap::new(), 0);
        let look = self.look(data, limits, |name, half_plane| {
            count += 1;
            if wanted.contains(&name) {
                half_planes.insert(name, half_plane());
            }
            Ok(())
        })?;
        if look.hash != self.sha256 {
            return Err(Falsehood::OtherData.into());
        }
        look.found?;
        let Look { rows_total, names, .. } = look;
        Ok(Found { half_planes: HalfPlanes(half_planes), count, rows_total, names })
    }

    /// Reads all data and hands over the half-planes. Rows beyond the limits end it; what else is wrong is kept for after
    /// the hash.
    fn look<R: Read>(
        &self,
        data: R,
        limits: &DataLimits,
        take: impl FnMut(Name, &dyn Fn() -> HalfPlane) -> Result<(), Falsehood>,
    ) -> Result<Look, Failure> {
        let mut rows = self.about.open(data, limits)?;
        let has_header = self.about.header && rows.next()?;
        let names = if has_header { self.about.names(rows.cells()) } else { BTreeMap::new() };
        let found = self.about.for_each_half_plane(&mut rows, limits, self.longest_vertex(), take);
        let found = match found {
            Err(failure) if failure.ends_reading() => return Err(failure),
            found => found,
        };
        let (hash, rows) = rows.finish()?;
        Ok(Look { hash, rows_total: rows - u64::from(has_header), names, found })
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
        sides: &Sides<'_>,
        data: R,
        limits: &DataLimits,
    ) -> Result<(), Failure> {
        let mut is_found = vec![false; self.active.len()];
        let look = self.look(data, limits, |name, half_plane| {
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
        })?;
        if look.hash != self.sha256 {
            return Err(Failure::Changed);
        }
        look.found?;
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

/// What reading all data gives.
struct Look {
    hash: String,
    rows_total: u64,
    names: BTreeMap<u64, Foreign>,
    /// Whether all wanted rows could be read, and all of their half-planes were taken.
    found: Result<(), Failure>,
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
    (multiples, point, ray): &(Multiples, Vector, Vector),
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
