//! The reach of a set in the direction of an objective, and its proof.

use boundfit_exact::Rational;
use boundfit_geometry::{Face, Multiplier, Polyhedron, Region, RegionKind, Support, System};
use serde::Serialize;

use super::set::{Multipliers, direction, multipliers, theta};

/// The most sets of multipliers that are written down.
const MOST_WAYS: usize = 12;

#[derive(Debug, Serialize)]
pub(super) struct ObjectiveJson {
    form: [String; 2],
    #[serde(flatten)]
    outcome: OutcomeJson,
}

#[derive(Debug, Serialize)]
#[serde(tag = "outcome", rename_all = "kebab-case")]
enum OutcomeJson {
    /// The set has no point to take the maximum over.
    Empty,
    /// The objective grows for ever along a ray from a point of the set.
    Unbounded { point: [String; 2], ray: [String; 2] },
    /// The maximum is attained on a face, and multiples of half-planes add up to the objective.
    Bounded { value: String, proof: Multipliers, face: FaceJson, ways: WaysJson },
}

#[derive(Debug, Serialize)]
struct FaceJson {
    kind: &'static str,
    points: Vec<[String; 2]>,
    direction: Option<[String; 2]>,
}

/// All sets of at most two half-planes with multipliers that prove the maximum, and whether no others do, of any number.
#[derive(Debug, Serialize)]
struct WaysJson {
    count: usize,
    unique: bool,
    first: Vec<Multipliers>,
}

impl ObjectiveJson {
    pub(super) fn new(polyhedron: &Polyhedron, form: &[Rational; 2]) -> Self {
        let outcome = match polyhedron.support(form) {
            Support::Empty(_) => OutcomeJson::Empty,
            Support::Unbounded(proof) => {
                OutcomeJson::Unbounded { point: theta(&proof.point), ray: direction(&proof.ray) }
            }
            Support::Bounded { proof, face } => OutcomeJson::Bounded {
                value: proof.value.to_string(),
                ways: ways(polyhedron, form, &face),
                proof: multipliers(&proof.multipliers),
                face: face_json(&face),
            },
        };
        ObjectiveJson { form: form.each_ref().map(ToString::to_string), outcome }
    }
}

fn face_json(face: &Face) -> FaceJson {
    let (kind, points, along) = match face {
        Face::Vertex(point) => ("vertex", vec![theta(point)], None),
        Face::Segment(ends) => ("segment", ends.iter().map(theta).collect(), None),
        Face::Ray { apex, direction } => ("ray", vec![theta(apex)], Some(direction)),
        Face::Line { point, direction } => ("line", vec![theta(point)], Some(direction)),
        Face::Whole => ("whole", Vec::new(), None),
    };
    FaceJson { kind, points, direction: along.map(direction) }
}

/// The basic solutions of the dual program, found by trying every pair of the half-planes that are active on the whole face:
/// only these have multipliers (complementary slackness).
fn ways(polyhedron: &Polyhedron, form: &[Rational; 2], face: &Face) -> WaysJson {
    let (system, region) = (polyhedron.system(), polyhedron.region());
    let active = active_on(region, face);
    let mut found: Vec<Vec<Multiplier>> = Vec::new();
    if form.iter().all(Rational::is_zero) {
        found.push(Vec::new());
    } else {
        let single = |&index: &usize| alone(system, index, form);
        found.extend(active.iter().filter_map(single));
        for (position, &one) in active.iter().enumerate() {
            found
                .extend(active.iter().skip(position + 1).filter_map(|&other| pair(system, one, other, form)));
        }
    }
    // Where half-planes add up to nothing, which leaves the set no interior, multiples of that can be added to any proof.
    let has_interior = matches!(
        region.kind(),
        RegionKind::Polygon
            | RegionKind::UnboundedPolygon
            | RegionKind::Strip
            | RegionKind::HalfPlane
            | RegionKind::Plane
    );
    WaysJson {
        count: found.len(),
        unique: has_interior && found.len() == 1,
        first: found.iter().take(MOST_WAYS).map(|way| multipliers(way)).collect(),
    }
}

/// The half-planes that are active on all of a face, ascending.
fn active_on(region: &Region, face: &Face) -> Vec<usize> {
    let at =
        |point| region.vertices().iter().find(|vertex| vertex.point() == point).map(|vertex| vertex.active());
    match face {
        Face::Vertex(point) => at(point).unwrap_or_default().to_vec(),
        Face::Segment([one, other]) => {
            let others = at(other).unwrap_or_default();
            let shared = at(one).unwrap_or_default().iter().copied().filter(|index| others.contains(index));
            shared.collect()
        }
        // The half-planes that end the ray are parallel to no multiple of the form: the sums find them.
        Face::Ray { apex, .. } => at(apex).unwrap_or_default().to_vec(),
        Face::Line { .. } => {
            region.boundaries().iter().flat_map(|boundary| boundary.active()).copied().collect()
        }
        Face::Whole => Vec::new(),
    }
}

/// The one half-plane whose normal has the direction of the form.
fn alone(system: &System, index: usize, form: &[Rational; 2]) -> Option<Vec<Multiplier>> {
    let a = &system.inequalities().get(index)?.a;
    if !minor(a, form).is_zero() {
        return None;
    }
    let [a1, a2] = a;
    let [c1, c2] = form;
    let value = c1.checked_div(a1).or_else(|| c2.checked_div(a2))?;
    value.is_positive().then(|| vec![Multiplier { index, value }])
}

/// Positive multiples of two half-planes that add up to the form (Cramer's rule).
fn pair(system: &System, one: usize, other: usize, form: &[Rational; 2]) -> Option<Vec<Multiplier>> {
    let (f, g) = (&system.inequalities().get(one)?.a, &system.inequalities().get(other)?.a);
    let determinant = minor(f, g);
    let values = [minor(form, g).checked_div(&determinant)?, minor(f, form).checked_div(&determinant)?];
    let are_positive = values.iter().all(Rational::is_positive);
    let [s, t] = values;
    are_positive.then(|| vec![Multiplier { index: one, value: s }, Multiplier { index: other, value: t }])
}

fn minor(u: &[Rational; 2], v: &[Rational; 2]) -> Rational {
    &u[0] * &v[1] - &u[1] * &v[0]
}
