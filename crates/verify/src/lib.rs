#![doc = include_str!("../README.md")]
#![deny(clippy::expect_used, clippy::indexing_slicing, clippy::panic, clippy::unwrap_used)]

use std::collections::{BTreeMap, BTreeSet};

use boundfit_exact::{Limits, Rational, Reading};
use serde::Deserialize;

/// The first statement that is false: its place in the proof or the data, and what is wrong there.
pub type Falsehood = String;
type Checked<T> = Result<T, Falsehood>;
/// A half-plane a·θ ≤ b as (a1, a2, b).
type HalfPlane = [Rational; 3];
type Named = BTreeMap<String, HalfPlane>;
type Take<'a> = dyn FnMut(String, HalfPlane) -> Checked<()> + 'a;
/// Names of half-planes, and how many times each is taken.
type Terms = Vec<(String, Rational)>;
/// A point or a direction.
type Vector = [Rational; 2];
/// By the angles of their normals: half-plane, and index and place of the vertex where the next side begins.
type Sides<'a> = BTreeMap<(bool, Option<Rational>), (&'a HalfPlane, Option<(usize, &'a Vector)>)>;

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
    model: [(usize, Rational); 4],
    conditions: Vec<HalfPlane>,
    vertices: Vec<Vector>,
    active: BTreeSet<(usize, String)>,
    sides: Vec<(String, Option<usize>)>,
    farkas: Terms,
    bounds: Vec<(Terms, Vector, Vector)>,
}

fn holds(truth: bool, otherwise: impl Into<Falsehood>) -> Checked<()> {
    if truth { Ok(()) } else { Err(otherwise.into()) }
}

/// u·v, of as many parts as both have.
fn dot(u: &[Rational], v: &[Rational]) -> Rational {
    u.iter().zip(v).map(|(u, v)| u * v).sum()
}

/// Grows with the angle in [0, 2π): the half of the plane, then -cot, which a half begins without. None for no direction.
fn angle([x, y, _]: &HalfPlane) -> Option<(bool, Option<Rational>)> {
    let zero = &Rational::zero();
    ([x, y] != [zero; 2]).then(|| ([y, x] < [zero; 2], (-x).checked_div(y)))
}

/// Section 5: the maximum of a·θ over the set, and the vertices where it is attained.
fn support(sides: &Sides, row: &HalfPlane) -> Option<(Rational, [Option<usize>; 2])> {
    let Some(angle) = angle(row) else { return Some((Rational::zero(), [None; 2])) };
    let before = [sides.range(..&angle).next_back(), sides.range(..=&angle).next_back()];
    let ends = before.map(|side| side.or(sides.last_key_value())?.1.1);
    let most = ends[0].or(ends[1]).map(|(_, point)| dot(row, point)).or_else(|| {
        let (side, _) = sides.get(&angle)?;
        Some(row.iter().zip(*side).find_map(|(a, c)| a.checked_div(c))? * &side[2])
    });
    Some((most?, ends.map(|end| end.map(|(index, _)| index))))
}

fn find<'a>(named: &'a Named, name: &str) -> Checked<&'a HalfPlane> {
    named.get(name).ok_or_else(|| format!("{name}: is no half-plane of the data"))
}

/// The sum of positive multiples of at most `limit` half-planes.
fn sum(named: &Named, terms: &Terms, limit: usize) -> Checked<HalfPlane> {
    holds(terms.len() <= limit, format!("multipliers: more than {limit}"))?;
    terms.iter().try_fold(HalfPlane::default(), |[a1, a2, b], (name, times)| {
        holds(times.is_positive(), format!("multipliers: {name}: is not positive"))?;
        let [c1, c2, d] = find(named, name)?;
        Ok([a1 + times * c1, a2 + times * c2, b + times * d])
    })
}

/// The rows of delimited text that are not blank, as cells (section 2).
fn rows(data: &[u8], delimiter: char) -> impl Iterator<Item = Vec<Vec<u8>>> {
    let mut bytes = data.iter().copied().peekable();
    let row = std::iter::from_fn(move || {
        bytes.peek()?;
        let (mut cells, mut in_quotes) = (vec![Vec::new()], bytes.next_if_eq(&b'"').is_some());
        loop {
            match bytes.next() {
                Some(b'"') if in_quotes && bytes.next_if_eq(&b'"').is_none() => in_quotes = false,
                Some(byte) if char::from(byte) == delimiter && !in_quotes => {
                    cells.push(Vec::new());
                    in_quotes = bytes.next_if_eq(&b'"').is_some();
                }
                Some(byte) if in_quotes || ![b'\r', b'\n'].contains(&byte) => cells.last_mut()?.push(byte),
                _ => return Some(cells),
            }
        }
    });
    row.filter(|cells| cells.len() > 1 || !cells.concat().trim_ascii().is_empty())
}

impl Proof {
    /// Checks every statement against the data, whose SHA-256 in hexadecimal the caller computes; `limits` hold for the
    /// numbers of the data. Returns how many half-planes the data and the conditions give, or the first statement that is
    /// false. Exact; two passes over the data.
    pub fn verify(&self, data: &[u8], sha256: &str, limits: &Limits) -> Checked<usize> {
        holds(self.schema == "boundfit/proof/1", "schema: is another one")?;
        holds(self.sha256 == sha256, "sha256: is not that of the data")?;
        let terms =
            self.bounds.iter().flat_map(|(terms, ..)| terms).chain(&self.farkas).map(|(name, _)| name);
        let used: BTreeSet<_> = self.sides.iter().map(|(name, _)| name).chain(terms).collect();
        let (mut named, mut count, zero) = (Named::new(), 0, Vector::default());
        self.half_planes(data, limits, &mut |name, row| {
            count += 1;
            named.extend(used.contains(&name).then_some((name, row)));
            Ok(())
        })?;
        if !self.farkas.is_empty() {
            let [a1, a2, b] = sum(&named, &self.farkas, 3)?;
            let parts = self.sides.len() + self.vertices.len() + self.active.len() + self.bounds.len();
            let is_true = [a1, a2] == zero && b.is_negative() && parts == 0;
            return holds(is_true, "farkas: the sum is true, or the set has parts").map(|()| count);
        }
        let (sides, mut touching) = (self.sides(&named)?, BTreeSet::new());
        self.half_planes(data, limits, &mut |name, row| {
            let most = support(&sides, &row).filter(|(most, _)| *most <= row[2]);
            let (most, ends) = most.ok_or_else(|| format!("{name}: cuts off a part of the set"))?;
            let ends = ends.into_iter().flatten().filter(|_| most == row[2]);
            touching.extend(ends.map(|end| (end, name.clone())));
            Ok(())
        })?;
        let wrong = touching.symmetric_difference(&self.active).next();
        holds(wrong.is_none(), format!("active: {wrong:?} is missing or does not touch"))?;
        holds(self.bounds.len() == 4, "bounds: are not four")?;
        let forms = [[-1, 0], [1, 0], [0, -1], [0, 1]].map(|e| e.map(Rational::from));
        for ((terms, point, ray), e) in self.bounds.iter().zip(&forms) {
            let is_inside =
                sides.values().all(|(c, _)| dot(*c, point) <= c[2] && !dot(*c, ray).is_positive());
            let claim = [e[0].clone(), e[1].clone(), dot(e, point)];
            let is_finite = sum(&named, terms, 2)? == claim && *ray == zero;
            let is_true = is_inside && (is_finite || terms.is_empty() && dot(e, ray).is_positive());
            holds(is_true, format!("bounds: in direction {e:?}: is not proved"))?;
        }
        Ok(count)
    }

    /// Section 2: hands over the half-planes of the wanted rows and the conditions, with their names.
    fn half_planes(&self, data: &[u8], limits: &Limits, take: &mut Take) -> Checked<()> {
        let [first, last] = self.rows;
        holds((1..=last).contains(&first), "rows: are none")?;
        // A byte order mark, and one more.
        let data = [(); 2].iter().fold(data, |data, ()| data.strip_prefix(b"\xef\xbb\xbf").unwrap_or(data));
        let mut rows = rows(data, self.delimiter).skip(first - usize::from(!self.header));
        for row in first..=last {
            let mut cells = rows.next().ok_or_else(|| format!("row {row}: is not in the data"))?;
            cells.insert(0, b"1".to_vec());
            let [x1, x2, y, epsilon] = self.model.each_ref().map(|(column, factor)| {
                let place = format!("row {row}, column {column}");
                let text = String::from_utf8_lossy(cells.get(*column).ok_or(format!("{place}: is missing"))?);
                let number = self.reading.read(&text, limits).map_err(|error| format!("{place}: {error}"))?;
                Checked::Ok(number * factor)
            });
            let (x1, x2, y, epsilon) = (x1?, x2?, y?, epsilon?);
            holds(!epsilon.is_negative(), format!("row {row}: the error bound is negative"))?;
            take(format!("{row} lower"), [-&x1, -&x2, &epsilon - &y])?;
            take(format!("{row} upper"), [x1, x2, y + epsilon])?;
        }
        (1..).zip(&self.conditions).try_for_each(|(k, own)| take(format!("where:{k}"), own.clone()))
    }

    /// Section 4: the sides in the order of their angles, after one walk around them.
    fn sides<'a>(&'a self, named: &'a Named) -> Checked<Sides<'a>> {
        let (mut sides, mut corners) = (Sides::new(), BTreeSet::new());
        for (name, end) in &self.sides {
            let vertex = end.and_then(|end| Some((end, self.vertices.get(end)?)));
            holds(end.is_some() == vertex.is_some(), format!("sides: {name}: there is no such vertex"))?;
            let side = find(named, name)?;
            let angle = angle(side).filter(|own| sides.last_key_value().is_none_or(|(last, _)| last < own));
            let angle = angle.ok_or_else(|| format!("sides: {name}: does not come next by its angle"))?;
            sides.insert(angle, (side, vertex));
        }
        let along = |[a1, a2, _]: &HalfPlane| [-a2, a1.clone()];
        let around = sides.values().zip(sides.values().cycle().skip(1)).zip(&self.sides);
        for (((side, end), (next, next_end)), (name, _)) in around {
            let turns_left = dot(&along(side), *next).is_positive();
            let is_true = end.map_or(!turns_left, |(_, from)| {
                let is_tight = [side, next].iter().all(|side| dot(**side, from) == side[2]);
                let goes_on = |(_, to): (_, &Vector)| dot(&along(next), to) >= dot(&along(next), from);
                turns_left && is_tight && next_end.is_none_or(goes_on)
            });
            holds(is_true, format!("sides: {name}: does not meet the next side like that"))?;
            corners.extend(end.map(|(_, point)| point));
        }
        holds(corners.len() == self.vertices.len(), "vertices: one is on no side, or there twice")?;
        Ok(sides)
    }
}
