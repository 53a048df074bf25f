//! A set of half-planes with what holds it.

use boundfit_exact::Rational;
use boundfit_geometry::{Boundary, Direction, Multiplier, NormalCone, Point, Region, System, Vertex};
use serde::Serialize;

use crate::redundancy::{self, MultiplierJson};

/// Multiples of half-planes, as fractions.
pub(super) type Multipliers = Vec<MultiplierJson<String>>;

pub(super) fn multipliers(terms: &[Multiplier]) -> Multipliers {
    redundancy::multipliers(terms, Rational::to_string)
}

/// A set: half-planes are indices, numbers fractions, rays and lines integer directions.
#[derive(Debug, Serialize)]
pub(super) struct SetJson {
    kind: &'static str,
    vertices: Vec<VertexJson>,
    rays: Vec<[String; 2]>,
    lines: Vec<[String; 2]>,
    /// The half-planes that whole lines of the boundary belong to, line by line.
    boundaries: Vec<Vec<usize>>,
    /// The positive multiples of half-planes of an empty set, which add up to `0 ≤ sum`.
    contradiction: Option<ContradictionJson>,
    area: Option<String>,
}

#[derive(Debug, Serialize)]
struct VertexJson {
    theta: [String; 2],
    active: Vec<usize>,
    cone: ConeJson,
}

/// The normal cone: counter-clockwise from one direction to the other.
#[derive(Debug, Serialize)]
struct ConeJson {
    kind: &'static str,
    generators: Vec<[String; 2]>,
}

#[derive(Debug, Serialize)]
struct ContradictionJson {
    by: Multipliers,
    sum: String,
}

impl SetJson {
    pub(super) fn new(system: &System, region: &Region) -> Self {
        let vertex = |vertex: &Vertex| VertexJson {
            theta: theta(vertex.point()),
            active: vertex.active().to_vec(),
            cone: cone(&NormalCone::at(system, vertex)),
        };
        SetJson {
            kind: region.kind().name(),
            vertices: region.vertices().iter().map(vertex).collect(),
            rays: region.rays().iter().map(direction).collect(),
            lines: region.lines().iter().map(direction).collect(),
            boundaries: region.boundaries().iter().map(Boundary::active).map(<[usize]>::to_vec).collect(),
            contradiction: region.certificate().map(|farkas| contradiction(system, farkas.multipliers())),
            area: region.area().map(|area| area.to_string()),
        }
    }
}

fn contradiction(system: &System, terms: &[Multiplier]) -> ContradictionJson {
    let right = terms.iter().filter_map(|m| Some(&system.inequalities().get(m.index)?.b * &m.value));
    ContradictionJson {
        by: multipliers(terms),
        sum: right.fold(Rational::zero(), |sum, b| sum + b).to_string(),
    }
}

fn cone(cone: &NormalCone) -> ConeJson {
    let kind = match cone {
        NormalCone::Wedge(_) => "wedge",
        NormalCone::HalfPlane(_) => "half-plane",
        NormalCone::Plane => "plane",
    };
    ConeJson { kind, generators: cone.generators().iter().map(direction).collect() }
}

pub(super) fn theta(point: &Point) -> [String; 2] {
    point.coordinates().each_ref().map(ToString::to_string)
}

pub(super) fn direction(direction: &Direction) -> [String; 2] {
    [direction.dx().to_string(), direction.dy().to_string()]
}
