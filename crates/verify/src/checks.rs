//! The checks, in the order of `docs/proof.md`.

use std::collections::BTreeSet;

use boundfit_exact::{Limits, Rational};

use crate::falsehood::Falsehood;
use crate::plane::{HalfPlane, Vector, dot};
use crate::proof::{Multiples, Named, Proof};
use crate::sides::Sides;

/// What a true proof states of the feasible parameter set.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Statement {
    /// How far the set goes.
    pub extent: Extent,
    /// How many vertices it has.
    pub vertices: usize,
    /// How many sides.
    pub sides: usize,
    /// How many half-planes the data and the conditions give.
    pub half_planes: usize,
    /// The first and the last of the rows of the data that they are made of and that follow each other, then those of the
    /// next ones, from 1.
    pub rows: Vec<usize>,
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

impl Proof {
    /// Checks every statement against the data, whose SHA-256 in hexadecimal the caller computes; `limits` hold for the
    /// numbers of the data. Exact; two passes over the data.
    ///
    /// # Errors
    /// The first statement that is false.
    pub fn verify(&self, data: &[u8], sha256: &str, limits: &Limits) -> Result<Statement, Falsehood> {
        if self.schema != "boundfit/proof/1" {
            return Err(Falsehood::OtherSchema);
        }
        if self.sha256 != sha256 {
            return Err(Falsehood::OtherData);
        }
        let (named, half_planes) = self.named_half_planes(data, limits)?;
        let (extent, bounds) = if self.farkas.is_empty() {
            let sides = Sides::of(self, &named)?;
            self.check_every_half_plane(&sides, data, limits)?;
            let bounds = self.check_bounds(&sides, &named)?;
            (if sides.are_closed() { Extent::Bounded } else { Extent::Unbounded }, Some(bounds))
        } else {
            self.check_empty(&named)?;
            (Extent::Empty, None)
        };
        let (vertices, sides) = (self.vertices.len(), self.sides.len());
        Ok(Statement { extent, vertices, sides, half_planes, rows: self.rows.clone(), bounds })
    }

    /// Section 3: half-planes add up to 0 ≤ b with b < 0, which no point satisfies.
    fn check_empty(&self, named: &Named) -> Result<(), Falsehood> {
        let sum = named.sum(&self.farkas, 3)?;
        let is_false = sum.a == Vector::default() && sum.b.is_negative();
        let has_parts = !(self.sides.is_empty()
            && self.vertices.is_empty()
            && self.active.is_empty()
            && self.bounds.is_empty());
        if is_false && !has_parts { Ok(()) } else { Err(Falsehood::NotEmpty) }
    }

    /// Section 5: each half-plane contains the set, and those that touch a vertex are those that the proof lists.
    fn check_every_half_plane(&self, sides: &Sides, data: &[u8], limits: &Limits) -> Result<(), Falsehood> {
        let mut touching = BTreeSet::new();
        self.for_each_half_plane(data, limits, |name, HalfPlane { a, b }| {
            let Some(support) = sides.support(&a).filter(|support| support.maximum <= b) else {
                return Err(Falsehood::CutsOff(name));
            };
            if support.maximum == b {
                let vertices = support.vertices.into_iter().flatten();
                touching.extend(vertices.map(|vertex| (vertex, name.clone())));
            }
            Ok(())
        })?;
        match touching.symmetric_difference(&self.active).next().cloned() {
            None => Ok(()),
            Some((vertex, half_plane)) => Err(Falsehood::NotTouching { vertex, half_plane }),
        }
    }

    /// Section 6: the range of each parameter.
    fn check_bounds(&self, sides: &Sides, named: &Named) -> Result<[[Option<Rational>; 2]; 2], Falsehood> {
        let [lower1, upper1, lower2, upper2] = self.bounds.as_slice() else {
            return Err(Falsehood::NotFourBounds);
        };
        let check = |bound, direction| check_bound(bound, direction, sides, named);
        let theta1 = [check(lower1, [-1, 0])?, check(upper1, [1, 0])?];
        let theta2 = [check(lower2, [0, -1])?, check(upper2, [0, 1])?];
        Ok([theta1, theta2])
    }
}

/// Checks multiples, point and ray of the bound in one direction, along an axis or against it. The end of the parameter, or `None` when nothing bounds it.
fn check_bound(
    (multiples, point, ray): &(Multiples, Vector, Vector),
    direction: [i64; 2],
    sides: &Sides,
    named: &Named,
) -> Result<Option<Rational>, Falsehood> {
    let e = direction.map(Rational::from);
    let is_inside = sides.contain(point) && sides.recede_along(ray);
    let claim = HalfPlane { a: e.clone(), b: dot(&e, point) };
    let is_reached = named.sum(multiples, 2)? == claim && *ray == Vector::default();
    let goes_on = multiples.is_empty() && dot(&e, ray).is_positive();
    if !is_inside || !(is_reached || goes_on) {
        return Err(Falsehood::NotABound(direction));
    }
    let [theta1, theta2] = point;
    let end = if direction[0] == 0 { theta2 } else { theta1 };
    Ok(is_reached.then(|| end.clone()))
}
