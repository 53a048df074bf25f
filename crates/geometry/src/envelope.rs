//! Intersection in O(n log n): sort the half-planes by angle, take two envelopes, walk along both.
//!
//! A half-plane with `a2 > 0` bounds θ2 from above by a linear function of θ1, one with `a2 < 0` from below. The region lies
//! between the two envelopes of these bounds.

use boundfit_exact::{Rational, Sign};

use crate::active::Active;
use crate::angle_key;
use crate::bounds::{Bounds, Facet};
use crate::constructions::meet;
use crate::fan::NormalFan;
use crate::half_plane::{Constraint, HalfPlane};
use crate::predicates::{Side, Turn, are_concurrent, normal_turn, side};
use crate::proof::{Farkas, Multiplier};
use crate::region::{
    Boundary, EmptyRegion, HalfPlaneRegion, Region, Vertex, from_chain, from_line, from_parallels,
};
use crate::system::System;

/// The region of a system, by the two envelopes. Exact. Cost: O(n log n), also when the region is empty.
///
/// The result equals that of [`crate::clipping::intersect`] in every part.
pub fn intersect(system: &System) -> Region {
    match outline(system) {
        Outline::Polygon(fan) => fan.polygon(system),
        Outline::Other(region) => region,
    }
}

/// A region as the envelopes find it.
pub(crate) enum Outline {
    /// A polygon, by its sides alone: its vertices would take more memory than the half-planes.
    Polygon(NormalFan),
    /// Any other region, or a polygon with half-planes between two sides that both envelopes keep.
    Other(Region),
}

/// The outline of the region of a system. Exact. Cost: O(n log n).
pub(crate) fn outline(system: &System) -> Outline {
    let mut sorted = angle_key::sorted(system.half_planes());
    let copies: Vec<HalfPlane> =
        if is_scattered(&sorted) { sorted.iter().map(|(_, h)| (*h).clone()).collect() } else { Vec::new() };
    for ((_, half_plane), copy) in sorted.iter_mut().zip(&copies) {
        *half_plane = copy;
    }
    let sorted = SortedHalfPlanes { sorted };
    let prefix = first_never(system).unwrap_or(system.len());
    match sorted.facets(prefix) {
        None => {
            let last = sorted.first_contradiction(prefix);
            let before = sorted.region(&sorted.facets(last).unwrap_or_default(), last);
            let certificate = NormalFan::of(system, &before).contradiction(system, last);
            Outline::Other(Region::Empty(EmptyRegion { certificate }))
        }
        Some(_) if prefix < system.len() => {
            let multipliers = vec![Multiplier { index: prefix, value: Rational::one() }];
            Outline::Other(Region::Empty(EmptyRegion { certificate: Farkas::new(multipliers) }))
        }
        Some(facets) if are_sides_of_polygon(&facets) => {
            Outline::Polygon(NormalFan::of_sides(facets.into_iter().map(|(index, _)| index).collect()))
        }
        Some(facets) => Outline::Other(sorted.region(&facets, prefix)),
    }
}

/// Returns whether each of the facets goes from one vertex to another one, and the last leads to the first.
fn are_sides_of_polygon(facets: &[Facet]) -> bool {
    let count = facets.len();
    let is_side = |position: usize| {
        let three = [0, 1, 2].map(|step| facets[(position + step) % count].1);
        // Three that follow each other on one envelope do not meet in a point, or the middle one would be gone.
        let [first, second, third] = three.map(|half_plane| half_plane.a2().sign());
        if position + 2 < count && first == second && second == third && first != Sign::Zero {
            return true;
        }
        let [before, own, next] = three;
        normal_turn(own, next) == Turn::Left && !are_concurrent(before, own, next)
    };
    count >= 3 && (0..count).all(is_side)
}

fn first_never(system: &System) -> Option<usize> {
    system.constraints().iter().position(|constraint| *constraint == Constraint::Never)
}

/// Returns whether a walk over half-planes in this order would wait for memory at most steps: there are many, and
/// most neighbours are far from each other in the system. Copies in this order are faster then.
fn is_scattered(sorted: &[Facet<'_>]) -> bool {
    /// The number of half-planes that fit into a cache.
    const FEW: usize = 4096;
    /// The distance in the system up to which a walk finds the next half-plane in a cache.
    const NEAR: usize = 16;
    let far = |pair: &&[Facet<'_>]| pair[0].0.abs_diff(pair[1].0) > NEAR;
    sorted.len() > FEW && sorted.windows(2).filter(far).count() > sorted.len() / 4
}

/// The half-planes of a system in angular order; of those with the same direction, the tightest first.
struct SortedHalfPlanes<'a> {
    sorted: Vec<Facet<'a>>,
}

impl SortedHalfPlanes<'_> {
    /// The half-planes of the first `prefix` inequalities.
    fn iter(&self, prefix: usize) -> impl Iterator<Item = Facet<'_>> {
        self.sorted.iter().copied().filter(move |(index, _)| *index < prefix)
    }

    /// The half-planes on the boundary of the region of the first `prefix` inequalities, by angle; `None` when
    /// that region is empty.
    fn facets(&self, prefix: usize) -> Option<Vec<Facet<'_>>> {
        let mut bounds = Bounds::default();
        let mut last: Option<&HalfPlane> = None;
        for (index, half_plane) in self.iter(prefix) {
            if last.is_none_or(|last| normal_turn(last, half_plane) != Turn::None) {
                bounds.push((index, half_plane));
                last = Some(half_plane);
            }
        }
        bounds.facets()
    }

    /// The index of the inequality that first contradicts those before it. Emptiness is monotone, so a binary search
    /// finds it; the angular order is reused.
    fn first_contradiction(&self, infeasible_prefix: usize) -> usize {
        let (mut feasible, mut infeasible) = (0, infeasible_prefix);
        while infeasible - feasible > 1 {
            let middle = feasible + (infeasible - feasible) / 2;
            if self.facets(middle).is_some() { feasible = middle } else { infeasible = middle }
        }
        feasible
    }

    /// The region of the first `prefix` inequalities, from its facets.
    fn region(&self, facets: &[Facet<'_>], prefix: usize) -> Region {
        let count = facets.len();
        let follower = |position: usize| facets[(position + 1) % count].1;
        // Neighbours meet in a corner unless the region goes on between them.
        let is_corner = |&position: &usize| normal_turn(facets[position].1, follower(position)) == Turn::Left;
        let gaps: Vec<usize> = (0..count).filter(|position| !is_corner(position)).collect();
        let rays = match gaps.as_slice() {
            [] if count == 0 => return Region::Plane,
            [] => None,
            [_] if count == 1 => {
                return Region::HalfPlane(HalfPlaneRegion { boundary: self.boundary(facets[0].1, prefix) });
            }
            [gap] => {
                let outgoing = facets[*gap].1.normal().turned_left();
                let incoming = follower(*gap).normal().turned_right();
                Some((outgoing, incoming))
            }
            _ if facets[0].1.opposite() == *facets[1].1 => {
                let mut line = self.boundary(facets[0].1, prefix);
                line.active.extend(self.boundary(facets[1].1, prefix).active);
                line.active.sort_unstable();
                return from_line(line);
            }
            _ => {
                return from_parallels(
                    self.boundary(facets[0].1, prefix),
                    self.boundary(facets[1].1, prefix),
                );
            }
        };
        let start = gaps.first().map_or(0, |gap| gap + 1);
        let (mut vertices, vertex_after) = self.chain(facets, start, gaps.is_empty());
        self.attach_active(facets, &vertex_after, prefix, &mut vertices);
        from_chain(vertices, rays)
    }

    /// The distinct corners in the order of the boundary, and for each facet which of them follows it.
    fn chain(&self, facets: &[Facet<'_>], start: usize, closed: bool) -> (Vec<Vertex>, Vec<Option<usize>>) {
        let count = facets.len();
        let corners = if closed { count } else { count - 1 };
        let mut vertices: Vec<Vertex> = Vec::with_capacity(corners);
        let mut vertex_after = vec![None; count];
        for position in (0..corners).map(|step| (start + step) % count) {
            let Some(point) = meet(facets[position].1, facets[(position + 1) % count].1) else { continue };
            if vertices.last().is_none_or(|last| last.point != point) {
                vertices.push(Vertex { point, active: Active::none() });
            }
            vertex_after[position] = Some(vertices.len() - 1);
        }
        if closed && vertices.len() > 1 && vertices[0].point == vertices[vertices.len() - 1].point {
            vertices.pop();
            for vertex in vertex_after.iter_mut().flatten() {
                *vertex %= vertices.len();
            }
        }
        (vertices, vertex_after)
    }

    /// Enters every half-plane at the vertices through which its boundary passes. Its normal lies between those of
    /// two neighbouring facets, and it can touch the region only where they meet.
    fn attach_active(
        &self,
        facets: &[Facet<'_>],
        vertex_after: &[Option<usize>],
        prefix: usize,
        vertices: &mut [Vertex],
    ) {
        let count = facets.len();
        let mut upto = 0;
        for (index, half_plane) in self.iter(prefix) {
            // Both are in angular order, and of each direction the first is the facet, if one is.
            if facets.get(upto).is_some_and(|(facet, _)| *facet == index) {
                upto += 1;
            }
            let position = (upto + count - 1) % count;
            let facet = facets[position].1;
            if half_plane == facet {
                let around = [vertex_after[(position + count - 1) % count], vertex_after[position]];
                for vertex in around.into_iter().flatten() {
                    vertices[vertex].active.push(index);
                }
            } else if normal_turn(facet, half_plane) != Turn::None
                && let Some(vertex) = vertex_after[position]
                && side(half_plane, &vertices[vertex].point) == Side::Boundary
            {
                vertices[vertex].active.push(index);
            }
        }
        for vertex in vertices {
            vertex.active.settle();
        }
    }

    /// A whole line of the boundary with the half-planes that coincide with it.
    fn boundary(&self, half_plane: &HalfPlane, prefix: usize) -> Boundary {
        let same = self.iter(prefix).filter(|(_, other)| *other == half_plane);
        let mut active: Vec<usize> = same.map(|(index, _)| index).collect();
        active.sort_unstable();
        Boundary { half_plane: half_plane.clone(), active }
    }
}
