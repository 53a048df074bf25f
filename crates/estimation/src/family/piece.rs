//! What a family looks like between two breakpoints.

use boundfit_exact::{Endpoint, Interval, Rational};
use boundfit_geometry::predicates::{Turn, normal_turn};
use boundfit_geometry::{Direction, Point, Polyhedron, Redundancy, Region, RegionKind, Support, System};

use super::functions::{Linear, Quadratic};
use super::growing::GrowingSystem;
use super::section::{Section, SectionBoundary, SectionVertex};
use crate::fps::BoundName;

/// The sets strictly between two factors: the same half-planes meet in the same order.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Piece {
    /// The factor after which the piece begins.
    pub from: Rational,
    /// The factor before which it ends.
    pub to: Rational,
    /// What kind of region the sets are.
    pub kind: RegionKind,
    /// Counter-clockwise, the lexicographically smallest first.
    pub vertices: Vec<MovingVertex>,
    /// Extreme recession directions.
    pub rays: Vec<Direction>,
    /// Directions of the lines in the sets.
    pub lines: Vec<Direction>,
    /// The whole lines of the boundary of sets without vertices.
    pub boundaries: Vec<MovingBoundary>,
    /// Lower and upper end of each parameter uncertainty interval, `None` where unbounded; `None` for empty sets.
    pub pui: Option<[[Option<Linear>; 2]; 2]>,
    /// The area; `None` when it is infinite or the sets are empty.
    pub area: Option<Quadratic>,
    /// A minimal set of bounds that describes the sets, sorted.
    pub shaped_by: Vec<BoundName>,
}

/// A vertex as a function of s.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MovingVertex {
    /// Where it is.
    pub theta: [Linear; 2],
    /// The bounds met with equality, sorted.
    pub active: Vec<BoundName>,
}

/// The line normal·θ = offset as a function of s, on the boundary of normal·θ ≤ offset.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MovingBoundary {
    /// The outer normal.
    pub normal: Direction,
    /// The right-hand side.
    pub offset: Linear,
    /// The bounds met with equality, sorted.
    pub active: Vec<BoundName>,
}

/// The closed range of factors in which the shape found at a sample lasts; without end when `to` is `None`.
pub(super) struct Reach {
    pub(super) from: Rational,
    pub(super) to: Option<Rational>,
}

impl Piece {
    /// No set at all.
    pub(super) fn empty(from: Rational, to: Rational) -> Self {
        Piece {
            from,
            to,
            kind: RegionKind::Empty,
            vertices: Vec::new(),
            rays: Vec::new(),
            lines: Vec::new(),
            boundaries: Vec::new(),
            pui: None,
            area: None,
            shaped_by: Vec::new(),
        }
    }

    /// The shape at a sample, at which the set must not be empty, and how far it reaches. The ends of the piece are
    /// left to the caller; where the sample is an end of its own reach, the shape is that of a breakpoint, no piece.
    pub(super) fn around(system: &GrowingSystem, sample: &Rational) -> (Self, Reach) {
        let polyhedron = system.polyhedron(sample);
        let corners = corners(system, &polyhedron);
        let reach = reach(system, &polyhedron, &corners, sample);
        let region = polyhedron.region();
        let vertices: Vec<MovingVertex> = region
            .vertices()
            .iter()
            .filter_map(|vertex| {
                let moving = corners.iter().flatten().find(|theta| at(theta, sample) == *vertex.point())?;
                Some(MovingVertex { theta: moving.clone(), active: system.named(vertex.active()) })
            })
            .collect();
        let boundaries = region.boundaries().iter().filter_map(|boundary| {
            let normal = boundary.half_plane().normal();
            let first = *boundary.active().first()?;
            let offset = system.bound(first).times(&length(system.form(first), &normal)?.recip()?);
            Some(MovingBoundary { normal, offset, active: system.named(boundary.active()) })
        });
        let piece = Piece {
            from: sample.clone(),
            to: sample.clone(),
            kind: region.kind(),
            area: area(region, &vertices),
            vertices,
            rays: region.rays(),
            lines: region.lines(),
            boundaries: boundaries.collect(),
            pui: Some([0, 1].map(|axis| ends(system, &polyhedron, axis))),
            shaped_by: system.named(polyhedron.irredundant_by_angle()),
        };
        (piece, reach)
    }

    /// The set at a factor within the piece.
    pub(super) fn at(&self, s: &Rational) -> Section {
        let vertex = |vertex: &MovingVertex| SectionVertex {
            theta: vertex.theta.each_ref().map(|coordinate| coordinate.at(s)),
            active: vertex.active.clone(),
        };
        let boundary = |boundary: &MovingBoundary| SectionBoundary {
            normal: boundary.normal.clone(),
            offset: boundary.offset.at(s),
            active: boundary.active.clone(),
        };
        let endpoint = |end: &Option<Linear>| {
            end.as_ref().map_or(Endpoint::Unbounded, |end| Endpoint::Finite(end.at(s)))
        };
        let interval = |[lower, upper]: &[Option<Linear>; 2]| Interval::new(endpoint(lower), endpoint(upper));
        Section {
            kind: self.kind,
            vertices: self.vertices.iter().map(vertex).collect(),
            rays: self.rays.clone(),
            lines: self.lines.clone(),
            boundaries: self.boundaries.iter().map(boundary).collect(),
            pui: self.pui.as_ref().and_then(|[first, second]| Some([interval(first)?, interval(second)?])),
            area: self.area.as_ref().map(|area| area.at(s)),
        }
    }
}

/// The moving corner of each irredundant half-plane with the next by angle; `None` where the set goes on between them.
fn corners(system: &GrowingSystem, polyhedron: &Polyhedron) -> Vec<Option<[Linear; 2]>> {
    let spokes = polyhedron.irredundant_by_angle();
    let next = spokes.iter().cycle().skip(1);
    spokes.iter().zip(next).map(|(&f, &g)| corner(system, polyhedron.system(), f, g)).collect()
}

/// The common point of two moving boundaries (Cramer's rule), unless the second is half a turn or more further on.
fn corner(system: &GrowingSystem, at_sample: &System, f: usize, g: usize) -> Option<[Linear; 2]> {
    if normal_turn(at_sample.half_plane(f)?, at_sample.half_plane(g)?) != Turn::Left {
        return None;
    }
    let ([f1, f2], [g1, g2]) = (system.form(f), system.form(g));
    let reciprocal = (f1 * g2 - f2 * g1).recip()?;
    let (bf, bg) = (system.bound(f), system.bound(g));
    let theta1 = &bf.times(g2) - &bg.times(f2);
    let theta2 = &bg.times(f1) - &bf.times(g1);
    Some([theta1.times(&reciprocal), theta2.times(&reciprocal)])
}

/// How far the shape at a sample reaches: as far as no edge of it has shrunk to nothing, its parallel sides have not
/// met, and every other half-plane still contains it. Each of these is a linear function of s that must not be negative.
fn reach(
    system: &GrowingSystem,
    polyhedron: &Polyhedron,
    corners: &[Option<[Linear; 2]>],
    sample: &Rational,
) -> Reach {
    let mut reach = Reach { from: Rational::zero(), to: None };
    let mut require = |slack: &Linear| {
        let Some(root) = slack.root() else { return };
        if slack.slope.is_positive() {
            if root > reach.from {
                reach.from = root;
            }
        } else if reach.to.as_ref().is_none_or(|to| root < *to) {
            reach.to = Some(root);
        }
    };
    let spokes = polyhedron.irredundant_by_angle();
    for (number, &spoke) in spokes.iter().enumerate() {
        let before = &corners[(number + spokes.len() - 1) % spokes.len()];
        if let (Some(start), Some(end)) = (before, &corners[number]) {
            // The boundary runs to the left of its normal.
            let [a1, a2] = system.form(spoke);
            let along = [&end[0] - &start[0], &end[1] - &start[1]];
            require(&(&along[1].times(a1) - &along[0].times(a2)));
        }
        let next = spokes[(number + 1) % spokes.len()];
        let opposite = system.form(next).each_ref().map(|coefficient| -coefficient);
        if let Some(factor) = multiple_of(&opposite, system.form(spoke)) {
            require(&(system.bound(next) + &system.bound(spoke).times(&factor)));
        }
    }
    for (index, redundancy) in polyhedron.redundancies().into_iter().enumerate() {
        let implied = match redundancy {
            None => continue,
            Some(Redundancy::Dominated { by, .. }) => system.combined(&by),
            Some(Redundancy::SameAs(other)) => {
                let factor = multiple_of(system.form(index), system.form(other)).unwrap_or_default();
                system.bound(other).times(&factor)
            }
            Some(Redundancy::Always | Redundancy::EmptyWithout) => Linear::default(),
        };
        require(&(system.bound(index) - &implied));
    }
    debug_assert!(reach.from <= *sample, "a shape that is not there at its own sample");
    reach
}

/// The positive factor with `vector = factor·other`, if there is one.
fn multiple_of(vector: &[Rational; 2], other: &[Rational; 2]) -> Option<Rational> {
    let parallel = &vector[0] * &other[1] == &vector[1] * &other[0];
    let factor = vector[0].checked_div(&other[0]).or_else(|| vector[1].checked_div(&other[1]))?;
    (parallel && factor.is_positive()).then_some(factor)
}

/// The factor with `form = factor·direction` for a form along a direction.
fn length(form: &[Rational; 2], direction: &Direction) -> Option<Rational> {
    form[0]
        .checked_div(&Rational::from(direction.dx()))
        .or_else(|| form[1].checked_div(&Rational::from(direction.dy())))
}

/// Lower and upper end of the range of one parameter.
fn ends(system: &GrowingSystem, polyhedron: &Polyhedron, axis: usize) -> [Option<Linear>; 2] {
    [-Rational::one(), Rational::one()].map(|sign| {
        let mut form = [Rational::zero(), Rational::zero()];
        form[axis] = sign.clone();
        match polyhedron.support(&form) {
            Support::Bounded { proof, .. } => Some(system.combined(&proof.multipliers).times(&sign)),
            Support::Unbounded(_) | Support::Empty(_) => None,
        }
    })
}

/// The area of moving vertices (the shoelace formula).
fn area(region: &Region, vertices: &[MovingVertex]) -> Option<Quadratic> {
    if region.kind() != RegionKind::Polygon {
        return region.area().map(Quadratic::constant);
    }
    let next = vertices.iter().cycle().skip(1);
    let doubled = vertices
        .iter()
        .zip(next)
        .map(|(p, q)| &p.theta[0] * &q.theta[1] - &p.theta[1] * &q.theta[0])
        .fold(Quadratic::default(), |total, term| total + term);
    Some(doubled.times(&Rational::ratio(1, 2)))
}

fn at(theta: &[Linear; 2], s: &Rational) -> Point {
    Point::new(&theta[0].at(s), &theta[1].at(s))
}
