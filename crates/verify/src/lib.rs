//! An independent checker of proofs `boundfit/proof/1`, without any of the geometry that finds the answers: `docs/proof.md`
//! in Rust. The numbers of sections are that page's, which has the fields of the file and the lemmas behind the checks.
#![deny(clippy::expect_used, clippy::indexing_slicing, clippy::panic, clippy::unwrap_used)]

mod data;

use std::collections::{BTreeMap, BTreeSet};

use boundfit_exact::{Limits, Rational, Reading};
use serde::Deserialize;

/// The first statement that is false: its place in the proof or the data, and what is wrong there.
pub type Falsehood = String;
/// A half-plane a·θ ≤ b as (a1, a2, b), a point as (θ1, θ2, -1), a direction as (θ1, θ2, 0).
type Triple = [Rational; 3];
/// A half-plane by its name, and how many times it is taken.
type Term = (String, Rational);
type Named = BTreeMap<String, Triple>;
/// By the angles of their normals: half-plane, and index and place of the vertex where the next side begins.
type Sides = BTreeMap<(bool, Option<Rational>), (Triple, Option<(usize, Triple)>)>;

/// A proof (section 1), whose statements may be true or false.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Proof {
    schema: String,
    sha256: String,
    delimiter: char,
    header: bool,
    rows: [usize; 2],
    reading: Reading,
    model: [Source; 4],
    conditions: Vec<Triple>,
    half_planes: BTreeSet<String>,
    kind: String,
    vertices: Vec<([Rational; 2], BTreeSet<String>)>,
    sides: Vec<(String, Option<usize>)>,
    farkas: Vec<Term>,
    bounds: Vec<Bound>,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum Source {
    Column(usize),
    Constant(Rational),
}

#[derive(Deserialize)]
#[serde(untagged, deny_unknown_fields)]
enum Bound {
    Finite { value: Rational, multipliers: Vec<Term> },
    Infinite { point: [Rational; 2], ray: [Rational; 2] },
}

fn holds(truth: bool, otherwise: impl Into<Falsehood>) -> Result<(), Falsehood> {
    if truth { Ok(()) } else { Err(otherwise.into()) }
}

/// a·θ - b of a half-plane and a point.
fn dot(u: &Triple, v: &Triple) -> Rational {
    u.iter().zip(v).map(|(u, v)| u * v).sum()
}

fn cross([u1, u2, _]: &Triple, [v1, v2, _]: &Triple) -> Rational {
    u1 * v2 - u2 * v1
}

/// Grows with the angle in [0, 2π): the half of the plane, then -cot, which a half begins without. None for no direction.
fn angle([x, y, _]: &Triple) -> Option<(bool, Option<Rational>)> {
    let zero = &Rational::zero();
    ([x, y] != [zero; 2]).then(|| ([y, x] < [zero; 2], (-x).checked_div(y)))
}

/// Section 5: the maximum of a·θ - b over the set, and the vertices where the direction reaches it.
fn most(sides: &Sides, row: &Triple) -> Option<(Rational, [Option<usize>; 2])> {
    let Some(angle) = angle(row) else { return Some((-&row[2], [None; 2])) };
    let before = [sides.range(..&angle).next_back(), sides.range(..=&angle).next_back()];
    let ends = before.map(|side| side.or(sides.last_key_value())?.1.1.as_ref());
    let most = match (ends[0].or(ends[1]), sides.get(&angle)) {
        (Some((_, point)), _) => dot(row, point),
        (None, Some((side, _))) => {
            row[0].checked_div(&side[0]).or_else(|| row[1].checked_div(&side[1]))? * &side[2] - &row[2]
        }
        _ => return None,
    };
    Some((most, ends.map(|end| end.map(|(index, _)| *index))))
}

fn find<'a>(named: &'a Named, name: &str) -> Result<&'a Triple, Falsehood> {
    named.get(name).ok_or_else(|| format!("half_planes: {name}: is not of the data, or not listed"))
}

/// The sum of positive multiples of at most `limit` half-planes.
fn sum(named: &Named, terms: &[Term], limit: usize) -> Result<Triple, Falsehood> {
    holds(terms.len() <= limit, format!("multipliers: more than {limit}"))?;
    terms.iter().try_fold(Triple::default(), |[a1, a2, b], (name, times)| {
        holds(times.is_positive(), format!("multipliers: {name}: is not positive"))?;
        let [c1, c2, d] = find(named, name)?;
        Ok([a1 + times * c1, a2 + times * c2, b + times * d])
    })
}

impl Proof {
    /// Checks every statement against the data, whose SHA-256 in hexadecimal the caller computes; `limits` hold for the
    /// numbers of the data. Returns how many half-planes the data and the conditions give. Exact; two passes over the data.
    ///
    /// # Errors
    /// The first statement that is false.
    pub fn verify(&self, data: &[u8], sha256: &str, limits: &Limits) -> Result<usize, Falsehood> {
        holds(self.schema == "boundfit/proof/1", "schema: is another one")?;
        holds(self.sha256 == sha256, "sha256: is not that of the data")?;
        let mut named = Named::new();
        for rows in self.half_planes(data, limits) {
            named.extend(rows?.into_iter().filter(|(name, _)| self.half_planes.contains(name)));
        }
        let (sides, is_empty) = (self.sides(&named)?, !self.farkas.is_empty());
        let kind = if is_empty { self.contradiction(&named) } else { self.kind(&sides) }?;
        holds(self.kind == kind, format!("kind: is {kind}"))?;
        let (mut count, mut touching) = (0, vec![BTreeSet::new(); self.vertices.len()]);
        for (name, row) in self.half_planes(data, limits).map_while(Result::ok).flatten() {
            count += 1;
            let most = most(&sides, &row).filter(|(most, _)| !most.is_positive());
            holds(is_empty || most.is_some(), format!("{name}: cuts off a part of the set"))?;
            for end in
                most.filter(|(most, _)| most.is_zero()).into_iter().flat_map(|(_, ends)| ends).flatten()
            {
                touching.get_mut(end).map(|own| own.insert(name.clone()));
            }
        }
        let rows = self.rows[1].saturating_sub(self.rows[0]).saturating_add(1);
        let rows_and_conditions = rows.saturating_mul(2).saturating_add(self.conditions.len());
        holds(count == rows_and_conditions, "rows: the data do not have them")?;
        for ((theta, active), touching) in self.vertices.iter().zip(&touching) {
            let wrong = active.symmetric_difference(touching).next();
            holds(wrong.is_none(), format!("vertices: {theta:?}: {wrong:?} is missing or does not touch"))?;
        }
        holds(is_empty || self.bounds.len() == 4, "bounds: are not four")?;
        for (bound, (e, what)) in
            self.bounds.iter().zip([[-1, 0], [1, 0], [0, -1], [0, 1]].into_iter().zip(1..))
        {
            holds(bound.is_true(e, &sides, &named)?, format!("bounds: number {what} is not proved"))?;
        }
        Ok(count)
    }

    /// Section 3.
    fn contradiction(&self, named: &Named) -> Result<&'static str, Falsehood> {
        let [a1, a2, b] = sum(named, &self.farkas, 3)?;
        let is_bare = self.sides.is_empty() && self.vertices.is_empty() && self.bounds.is_empty();
        let is_true = a1.is_zero() && a2.is_zero() && b.is_negative() && is_bare;
        holds(is_true, "farkas: the sum is not 0 <= a negative number, or the set has parts")
            .map(|()| "empty")
    }

    /// Section 4: the sides in the order of their angles.
    fn sides(&self, named: &Named) -> Result<Sides, Falsehood> {
        let mut sides = Sides::new();
        for (name, end) in &self.sides {
            let point = end
                .and_then(|end| self.vertices.get(end))
                .map(|([x, y], _)| [x.clone(), y.clone(), (-1).into()]);
            holds(end.is_some() == point.is_some(), format!("sides: {name}: there is no such vertex"))?;
            let side = find(named, name)?;
            let angle = angle(side).filter(|own| sides.last_key_value().is_none_or(|(last, _)| last < own));
            let angle = angle.ok_or_else(|| format!("sides: {name}: does not come next by its angle"))?;
            sides.insert(angle, (side.clone(), end.zip(point)));
        }
        Ok(sides)
    }

    /// Section 4: one walk around the sides.
    fn kind(&self, sides: &Sides) -> Result<&'static str, Falsehood> {
        let (mut gaps, mut corners) = (Vec::new(), BTreeSet::new());
        let around = sides.values().zip(sides.values().cycle().skip(1)).zip(&self.sides);
        for (((side, end), (next, next_end)), (name, _)) in around {
            let turn = cross(side, next);
            let is_true = end.as_ref().map_or(!turn.is_positive(), |(_, from)| {
                let is_tight = dot(side, from).is_zero() && dot(next, from).is_zero();
                let goes_on = |(_, to): &(_, _)| cross(next, to) >= cross(next, from);
                turn.is_positive() && is_tight && next_end.as_ref().is_none_or(goes_on)
            });
            holds(is_true, format!("sides: {name}: does not meet the next side like that"))?;
            match end {
                Some((_, point)) => _ = corners.insert(point),
                None => gaps.push((turn, most(sides, &side.each_ref().map(|part| -part)))),
            }
        }
        holds(corners.len() == self.vertices.len(), "vertices: one is on no side, or there twice")?;
        Ok(match (sides.len(), gaps.as_slice(), corners.len()) {
            (0, ..) => "plane",
            (1, ..) => "half-plane",
            (_, [(_, Some((most, _))), _], _) if most.is_zero() => "line",
            (_, [(_, Some((most, _))), _], _) if most.is_positive() => "strip",
            (_, [_, _, ..], _) => "empty, which needs farkas",
            (_, [(turn, _)], 1) if turn.is_zero() => "ray",
            (_, [_], _) => "unbounded-polygon",
            (_, _, 1) => "point",
            (_, _, 2) => "segment",
            _ => "polygon",
        })
    }
}

impl Bound {
    /// Section 6: the bound in direction e.
    fn is_true(&self, e: [i32; 2], sides: &Sides, named: &Named) -> Result<bool, Falsehood> {
        let ([e1, e2], sign) = (e.map(Rational::from), Rational::from(e[0] + e[1]));
        Ok(match self {
            Bound::Finite { value, multipliers } => {
                let claim = [e1, e2, sign * value];
                let is_attained = most(sides, &claim).is_some_and(|(most, _)| most.is_zero());
                is_attained && sum(named, multipliers, 2)? == claim
            }
            Bound::Infinite { point: [p1, p2], ray: [r1, r2] } => {
                let [p1, p2, r1, r2] = [p1, p2, r1, r2].map(Rational::clone);
                let (grows, goes) = (&e1 * &r1 + &e2 * &r2, [[p1, p2, (-1).into()], [r1, r2, 0.into()]]);
                let stays = |(side, _): &(_, _)| goes.iter().all(|v| !dot(side, v).is_positive());
                grows.is_positive() && sides.values().all(stays)
            }
        })
    }
}
