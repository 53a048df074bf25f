//! The form of a family between two breakpoints.

use std::sync::Arc;

use boundfit_exact::{Endpoint, Interval, Rational};
use boundfit_geometry::{Direction, Point, Polyhedron, RegionKind, Support};

use super::area::{AreaGrowth, MovingArea};
use super::functions::{Linear, MovingBoundary, MovingVertex};
use super::growing::GrowingSystem;
use super::section::{Section, SectionBoundary, SectionVertex};
use super::shape::{Shape, around};
use crate::bound_name::BoundName;

/// The sets strictly between two factors: the same half-planes meet in the same order.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Piece {
    /// The factor after which the piece begins.
    pub from: Rational,
    /// The factor before which it ends.
    pub to: Rational,
    /// The kind of region of the sets.
    pub kind: RegionKind,
    /// Counter-clockwise, the lexicographically smallest first. Pieces share most of them.
    pub vertices: Vec<Arc<MovingVertex>>,
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

    /// The piece around a factor, from the set there, whose half-planes by angle come last. The ends of the piece are
    /// left to the caller.
    pub(super) fn around(shape: &mut Shape, polyhedron: &Polyhedron, spokes: &[usize]) -> Self {
        let (system, region) = (shape.system, polyhedron.region());
        if region.kind() == RegionKind::Polygon
            && let Some(polygon) = Piece::polygon(shape, spokes)
        {
            return polygon;
        }
        let vertices = moving_vertices(polyhedron, shape);
        let boundaries = region.boundaries().iter().filter_map(|boundary| {
            let normal = boundary.half_plane().normal();
            let first = *boundary.active().first()?;
            let offset = system.bound(first).times(&length(system.form(first), &normal)?.recip()?);
            Some(MovingBoundary { normal, offset, active: system.active(boundary.active()) })
        });
        Piece {
            kind: region.kind(),
            vertices,
            rays: region.rays(),
            lines: region.lines(),
            boundaries: boundaries.collect(),
            pui: Some([0, 1].map(|axis| ends(system, polyhedron, axis))),
            shaped_by: system.named(spokes),
            ..Piece::empty(Rational::zero(), Rational::zero())
        }
    }

    /// The polygons that have edges along these half-planes, by angle from behind that of (-1, 0). `None` if they
    /// shape no polygon. The ends of the piece are left to the caller.
    pub(super) fn polygon(shape: &mut Shape, spokes: &[usize]) -> Option<Self> {
        let corners = around(spokes).map(|[before, spoke, _]| shape.neighbours(before, spoke).corner.clone());
        let vertices = corners.collect::<Option<Vec<_>>>()?;
        // The vertex furthest in a direction: the half-planes up to that angle come before it, the others behind it.
        let end = |axis: usize, is_before: fn(&[Rational; 2]) -> bool| {
            let number = spokes.partition_point(|&spoke| is_before(shape.system.form(spoke)));
            Some(vertices[number % spokes.len()].theta[axis].clone())
        };
        let upper1 = |[a1, a2]: &[Rational; 2]| a2.is_negative() || a2.is_zero() && a1.is_positive();
        let pui = [
            [end(0, |_| false), end(0, upper1)],
            [
                end(1, |[a1, a2]| a2.is_negative() && !a1.is_positive()),
                end(1, |[a1, a2]| a2.is_negative() || !a1.is_negative()),
            ],
        ];
        Some(Piece {
            kind: RegionKind::Polygon,
            pui: Some(pui),
            vertices,
            shaped_by: shape.system.named(spokes),
            growth: shape.growth(spokes),
            ..Piece::empty(Rational::zero(), Rational::zero())
        })
    }

    /// The piece from one factor to another.
    pub(super) fn within(self, from: Rational, to: Rational) -> Self {
        Piece { from, to, ..self }
    }

    /// The set at a factor within the piece.
    pub(super) fn at(&self, s: &Rational) -> Section {
        let vertex = |vertex: &Arc<MovingVertex>| SectionVertex {
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
fn moving_vertices(polyhedron: &Polyhedron, shape: &mut Shape) -> Vec<Arc<MovingVertex>> {
    let spokes = polyhedron.irredundant_by_angle();
    let mut next = 0;
    let mut found = Vec::with_capacity(spokes.len());
    for vertex in polyhedron.region().vertices() {
        let is_active = |index: usize| vertex.active().binary_search(&index).is_ok();
        let theta = (next..next + spokes.len()).find_map(|number| {
            let (f, g) = (spokes[number % spokes.len()], spokes[(number + 1) % spokes.len()]);
            let corner = (is_active(f) && is_active(g)).then(|| shape.neighbours(f, g).corner.as_ref());
            next = number + 1;
            Some(corner.flatten()?.theta.clone())
        });
        let moving = |theta| MovingVertex { theta, active: shape.system.active(vertex.active()) };
        found.extend(theta.map(moving).map(Arc::new));
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
        let at_zero = corners.iter().map(|corner| {
            let [theta1, theta2] = &corner.theta;
            Point::new(&theta1.constant, &theta2.constant)
        });
        Some(MovingArea::new(at_zero.collect(), &self.growth))
    }
}
