//! The form of a family between two breakpoints.

use boundfit_exact::{Endpoint, Interval, Rational};
use boundfit_geometry::{Direction, Point, Polyhedron, RegionKind, Support};

use super::area::{AreaGrowth, MovingArea};
use super::functions::Linear;
use super::growing::GrowingSystem;
use super::section::{Section, SectionBoundary, SectionVertex};
use super::shape::{Reach, Shape};
use crate::bound_name::BoundName;
use crate::ties::ActiveBounds;

/// The sets strictly between two factors: the same half-planes meet in the same order.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Piece {
    /// The factor after which the piece begins.
    pub from: Rational,
    /// The factor before which it ends.
    pub to: Rational,
    /// The kind of region of the sets.
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
    /// A minimal set of bounds that describes the sets, sorted.
    pub shaped_by: Vec<BoundName>,
    /// The growth of the area of a polygon with s.
    pub growth: AreaGrowth,
}

/// A vertex as a function of s.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MovingVertex {
    /// The place of the vertex.
    pub theta: [Linear; 2],
    /// The bounds met with equality.
    pub active: ActiveBounds,
}

/// The line normal·θ = offset as a function of s, on the boundary of normal·θ ≤ offset.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MovingBoundary {
    /// The outer normal.
    pub normal: Direction,
    /// The right-hand side.
    pub offset: Linear,
    /// The bounds met with equality.
    pub active: ActiveBounds,
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
            shaped_by: Vec::new(),
            growth: AreaGrowth::default(),
        }
    }

    /// The shape at a sample, at which the set must not be empty, and how far it reaches. The ends of the piece are
    /// left to the caller; where the sample is an end of its own reach, the shape is that of a breakpoint, no piece.
    pub(super) fn around(system: &GrowingSystem, shape: &mut Shape, sample: &Rational) -> (Self, Reach) {
        let polyhedron = system.polyhedron(sample);
        let reach = shape.reach(system, &polyhedron, sample);
        let region = polyhedron.region();
        let vertices = moving_vertices(system, &polyhedron, shape);
        let boundaries = region.boundaries().iter().filter_map(|boundary| {
            let normal = boundary.half_plane().normal();
            let first = *boundary.active().first()?;
            let offset = system.bound(first).times(&length(system.form(first), &normal)?.recip()?);
            Some(MovingBoundary { normal, offset, active: system.active(boundary.active()) })
        });
        let piece = Piece {
            from: sample.clone(),
            to: sample.clone(),
            kind: region.kind(),
            vertices,
            rays: region.rays(),
            lines: region.lines(),
            boundaries: boundaries.collect(),
            pui: Some([0, 1].map(|axis| ends(system, &polyhedron, axis))),
            shaped_by: system.named(polyhedron.irredundant_by_angle()),
            growth: match region.kind() {
                RegionKind::Polygon => shape.growth(system, polyhedron.irredundant_by_angle()),
                _ => AreaGrowth::default(),
            },
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
        }
    }
}

/// The moving corner at each vertex: that of two irredundant half-planes, next to each other by angle, which are both active
/// there. Vertices and corners go around the set in the same way.
fn moving_vertices(system: &GrowingSystem, polyhedron: &Polyhedron, shape: &mut Shape) -> Vec<MovingVertex> {
    let spokes = polyhedron.irredundant_by_angle();
    let mut next = 0;
    let mut found = Vec::with_capacity(spokes.len());
    for vertex in polyhedron.region().vertices() {
        let is_active = |index: usize| vertex.active().binary_search(&index).is_ok();
        let theta = (next..next + spokes.len()).find_map(|number| {
            let (f, g) = (spokes[number % spokes.len()], spokes[(number + 1) % spokes.len()]);
            let theta = (is_active(f) && is_active(g)).then(|| shape.corner(system, f, g)).flatten()?;
            next = number + 1;
            Some(theta.clone())
        });
        found.extend(theta.map(|theta| MovingVertex { theta, active: system.active(vertex.active()) }));
    }
    found
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

impl Piece {
    /// The area as a function of s; `None` when it is infinite or the sets are empty.
    pub fn area(&self) -> Option<MovingArea<'_>> {
        let corners = match self.kind {
            RegionKind::Polygon => self.vertices.as_slice(),
            RegionKind::Point | RegionKind::Segment | RegionKind::Ray | RegionKind::Line => &[],
            _ => return None,
        };
        let at_zero = corners.iter().map(|MovingVertex { theta: [theta1, theta2], .. }| {
            Point::new(&theta1.constant, &theta2.constant)
        });
        Some(MovingArea::new(at_zero.collect(), &self.growth))
    }
}
