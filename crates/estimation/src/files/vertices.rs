//! Readings whose bounds meet an envelope in one of its vertices alone, where very many may: one of them stands for all.
//!
//! A vertex of an envelope is where two half-planes meet. Others through it whose slopes are strictly between those two cut
//! nothing off, touch the envelope where the vertex does, and leave it together.

use std::collections::{BTreeMap, HashMap};

use boundfit_exact::{Integer, Rational, Scaled, Sign, Unit};
use boundfit_geometry::grid::touching_of_columns;
use boundfit_geometry::{Constraint, HalfPlane, Tally, Touch, touches_of_envelopes};

use crate::hulls::touching_a_hull;
use crate::scale::Scale;
use crate::ties::TiedReading;

/// The choice of readings that are kept at one vertex.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum AtVertices {
    /// Each.
    Each,
    /// The first.
    First,
    /// The first, and those with extreme regressors: wherever a θ violates one of these readings most, it is one of them.
    Extreme,
    /// The first, and those whose normals are next to the opposite of this one: where a point is all that readings leave, some of
    /// them prove it.
    Opposite([Rational; 2]),
}

impl AtVertices {
    /// Returns the readings, by row, that are kept beside the first one at the same vertex.
    fn decisive(&self, readings: &[TiedReading], through: &[(usize, Touch)]) -> Vec<usize> {
        let normal = |(own, touch): &(usize, Touch)| {
            let [u, v] = &readings[*own].reading.regressor;
            if is_lower(touch.position) { [-u, -v] } else { [u.clone(), v.clone()] }
        };
        match self {
            AtVertices::Each => through.iter().map(|(own, _)| *own).collect(),
            AtVertices::First => Vec::new(),
            AtVertices::Extreme => {
                // A hull leaves out what is within its upright ends.
                let extreme = |is_turned: bool| {
                    let point = |own: &(usize, Touch)| {
                        let [u, v] = normal(own);
                        TiedReading::of_normal(own.0, if is_turned { [v, u] } else { [u, v] })
                    };
                    touching_a_hull(through.iter().map(point).collect(), 1, true)
                };
                [false, true].into_iter().flat_map(extreme).map(|point| point.reading.row).collect()
            }
            AtVertices::Opposite(one) => {
                let minor = |[p, q]: &[Rational; 2], [r, s]: &[Rational; 2]| (p * s - q * r).sign();
                let normals: Vec<[Rational; 2]> = through.iter().map(normal).collect();
                let is_opposite =
                    |own: usize| (&one[0] * &normals[own][0] + &one[1] * &normals[own][1]).is_negative();
                let from_one = |own: usize| (minor(one, &normals[own]), is_opposite(own));
                let nearest =
                    nearest_to_opposite(normals.len(), from_one, |f, g| minor(&normals[f], &normals[g]));
                nearest.map(|own| through[own].0).collect()
            }
        }
    }

    /// The same of rows in columns, whose normals are these at their upper or their lower bounds; `None` where machine integers
    /// do not tell.
    pub(super) fn decisive_in_units(
        &self,
        [u, v]: [&Scaled<i64>; 2],
        rows: &[usize],
        is_lower: bool,
    ) -> Option<Vec<usize>> {
        let regressors = |row: usize| [u.counts()[row], v.counts()[row]];
        match self {
            AtVertices::Each => None,
            AtVertices::First => Some(Vec::new()),
            AtVertices::Extreme => {
                let [u, v]: [Vec<i64>; 2] =
                    [u, v].map(|column| rows.iter().map(|&row| column.counts()[row]).collect());
                let extreme = |[u, v]: [&[i64]; 2]| touching_of_columns(u, v, &|place| rows[place] as u64, 1);
                let extreme = [[&u[..], &v], [&v, &u]].into_iter().flat_map(extreme);
                Some(extreme.map(|point| point.rows.first() as usize).collect())
            }
            AtVertices::Opposite([p, q]) => {
                let [p, q] = integers([&(p * v.unit().value()), &(q * u.unit().value())])?;
                let [p, q] = if is_lower { [-p, -q] } else { [p, q] };
                let product = |f: i64, g: i64| i128::from(f) * i128::from(g);
                let from_one = |own: usize| {
                    let [u, v] = regressors(rows[own]);
                    let along = product(p, u).signum() + product(q, v).signum();
                    (sign(product(p, v) - product(q, u)), along < 0)
                };
                let turn = |f: usize, g: usize| {
                    let ([u, v], [r, s]) = (regressors(rows[f]), regressors(rows[g]));
                    sign(product(u, s) - product(v, r))
                };
                Some(nearest_to_opposite(rows.len(), from_one, turn).map(|own| rows[own]).collect())
            }
        }
    }
}

fn sign(number: i128) -> Sign {
    number.cmp(&0).into()
}

/// Returns the first normal that is opposite to a given one, and on either side the first of the normals next to its
/// opposite. `from_one` tells on which side of it one is, and whether it turns away; `turn` on which side of another
/// one.
fn nearest_to_opposite(
    count: usize,
    from_one: impl Fn(usize) -> (Sign, bool),
    turn: impl Fn(usize, usize) -> Sign,
) -> impl Iterator<Item = usize> {
    let [mut left, mut right, mut opposite] = [None; 3];
    for own in 0..count {
        let (side, turns_away) = from_one(own);
        let best = match side {
            Sign::Positive => &mut left,
            Sign::Negative => &mut right,
            Sign::Zero if turns_away => &mut opposite,
            Sign::Zero => continue,
        };
        if best.is_none_or(|best| side != Sign::Zero && turn(best, own) == side) {
            *best = Some(own);
        }
    }
    [left, right, opposite].into_iter().flatten()
}

/// Returns whether a half-plane is a lower bound, by its position among those of readings that have both.
fn is_lower(position: usize) -> bool {
    position % 2 == 1
}

/// Returns the readings by row of which some half-plane touches an envelope, at vertices as `keep` asks; `touches`
/// gives each touching half-plane by its position. At most so many numbers are listed of those that one stands for.
/// Exact.
pub(super) fn told_at_vertices(
    readings: Vec<TiedReading>,
    touches: &[(usize, Touch)],
    keep: &AtVertices,
    most: usize,
) -> Vec<TiedReading> {
    let mut is_kept = vec![false; readings.len()];
    let mut vertices = vec![[None; 2]; readings.len()];
    let mut through: HashMap<[usize; 2], Vec<(usize, Touch)>> = HashMap::new();
    for &(own, touch) in touches {
        match touch.vertex.filter(|_| *keep != AtVertices::Each) {
            None => is_kept[own] = true,
            Some(vertex) => {
                vertices[own][usize::from(is_lower(touch.position))] = Some(vertex);
                through.entry(vertex).or_default().push((own, touch));
            }
        }
    }
    let decisive = through.values().flat_map(|through| keep.decisive(&readings, through));
    decisive.for_each(|own| is_kept[own] = true);
    let (mut first_of, mut others) = (HashMap::new(), BTreeMap::<usize, Vec<Tally>>::new());
    let mut kept = Vec::new();
    for ((reading, is_kept), vertices) in readings.into_iter().zip(is_kept).zip(vertices) {
        if !is_kept && vertices == [None; 2] {
            continue;
        }
        let first = if is_kept { kept.len() } else { *first_of.entry(vertices).or_insert(kept.len()) };
        match first < kept.len() {
            true => others.entry(first).or_default().push(reading.rows),
            false => kept.push(reading),
        }
    }
    with_others(&mut kept, others, most);
    kept
}

/// Has readings, by position, stand for others too.
pub(super) fn with_others(readings: &mut [TiedReading], others: BTreeMap<usize, Vec<Tally>>, most: usize) {
    for (position, tallies) in others {
        let all = [readings[position].rows.clone()].into_iter().chain(tallies);
        readings[position].rows = Tally::merged(all, most);
    }
}

/// A vertex of an envelope that many readings go through.
#[derive(Debug)]
pub(super) struct Vertex {
    /// The coefficients for a1, a2 and b whose sum is 0 for each half-plane through the vertex.
    through: [Rational; 3],
    /// The normals of the two that meet there.
    ends: [[Rational; 2]; 2],
    /// True if it is one of the upper bounds of θ2.
    is_above: bool,
}

/// [`Vertex`] in the units of columns: integers of which products with theirs, added, fit into 128 bits.
pub(super) struct VertexInUnits {
    through: [i64; 3],
    reach: i64,
    ends: [[i64; 2]; 2],
    is_above: bool,
}

impl Vertex {
    /// The vertices that most readings go through, of some that touch an envelope.
    pub(super) fn busiest(readings: &[TiedReading], scale: &Scale) -> Vec<Self> {
        const MOST: usize = 8;
        let (of, constraints) = scale.constraints(readings.iter().map(|own| &own.reading));
        let mut counts: BTreeMap<[usize; 2], u64> = BTreeMap::new();
        for Touch { position, vertex, .. } in touches_of_envelopes(&constraints) {
            let count = readings[of[position]].rows.count();
            vertex.into_iter().for_each(|vertex| *counts.entry(vertex).or_default() += count);
        }
        let mut busiest: Vec<_> = counts.into_iter().collect();
        busiest.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
        let vertex = |(ends, _): ([usize; 2], u64)| {
            let [Constraint::HalfPlane(f), Constraint::HalfPlane(g)] = ends.map(|end| &constraints[end])
            else {
                return None;
            };
            let minor = |p: [Integer; 2], q: [Integer; 2]| Rational::from(&p[0] * &q[1] - &p[1] * &q[0]);
            let normal = |own: &HalfPlane| [own.a1(), own.a2()].map(Rational::from);
            Some(Vertex {
                through: [
                    minor([f.a2(), f.b()], [g.a2(), g.b()]),
                    minor([f.b(), f.a1()], [g.b(), g.a1()]),
                    minor([f.a1(), f.a2()], [g.a1(), g.a2()]),
                ],
                ends: [normal(f), normal(g)],
                is_above: f.a2().is_positive(),
            })
        };
        busiest.into_iter().take(MOST).filter_map(vertex).collect()
    }

    /// Returns the vertex for columns with these units and bounds at this distance from y; `None` where the integers
    /// would be too long.
    pub(super) fn in_units(&self, [u, v, y]: [Unit; 3], epsilon: &Rational) -> Option<VertexInUnits> {
        let [u, v, y] = [u, v, y].map(Unit::value);
        let Vertex { through: [a1, a2, b], ends, is_above } = self;
        let [a1, a2, of_y, reach] = integers([&(a1 * &u), &(a2 * &v), &(b * y), &(b * epsilon)])?;
        let [Some(one), Some(other)] = ends.each_ref().map(|[p, q]| integers([&(p * &v), &(q * &u)])) else {
            return None;
        };
        Some(VertexInUnits { through: [a1, a2, of_y], reach, ends: [one, other], is_above: *is_above })
    }
}

/// Such integers in the ratio of these numbers.
fn integers<const N: usize>(numbers: [&Rational; N]) -> Option<[i64; N]> {
    let (integers, _) = Rational::over_common_denominator(numbers);
    let narrow = integers.map(|own| own.to_i64().filter(|own| own.unsigned_abs() >> 62 == 0));
    narrow.iter().all(Option::is_some).then(|| narrow.map(Option::unwrap_or_default))
}

impl VertexInUnits {
    /// Returns whether a reading goes through this vertex, between the two that meet there: with its upper bound (0), or its lower one (1).
    /// Exact.
    pub(super) fn side_through(&self, [u, v, y]: [i64; 3]) -> Option<usize> {
        let wide = |[p, q]: [i64; 2]| i128::from(p) * i128::from(q);
        let [a1, a2, b] = self.through;
        let value = wide([a1, u]) + wide([a2, v]) + wide([b, y]);
        let side = usize::from((v > 0) != self.is_above);
        let reach = i128::from(self.reach);
        if v == 0 || value != if side == 0 { -reach } else { reach } {
            return None;
        }
        let turn = |[p, q]: [i64; 2]| (wide([p, v]) - wide([q, u])).signum();
        let [one, other] = self.ends.map(turn);
        (one * other < 0).then_some(side)
    }
}

/// The numbers of a row.
pub(super) fn counts_at([u, v, y]: [&Scaled<i64>; 3], row: usize) -> [i64; 3] {
    [u, v, y].map(|column| column.counts()[row])
}
