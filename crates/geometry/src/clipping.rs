//! Intersection by clipping: one half-plane at a time, from the whole plane. This is the definition of the region,
//! and the slow, plain witness for [`crate::envelope`].
//!
//! The region is kept as a convex polygon on the upper half of the sphere of directions `(x : y : w)`, `w ≥ 0`:
//! ordinary points have `w > 0`, points at infinity `w = 0`. There the plane, a half-plane or a strip is a polygon
//! like any other, and one rule (Sutherland and Hodgman 1974) clips all ten kinds.

use std::sync::Arc;

use boundfit_exact::{Integer, Rational, Sign};

use crate::active::Active;
use crate::constructions::{foot, meet};
use crate::fan::{FanSupport, NormalFan};
use crate::half_plane::{Constraint, HalfPlane};
use crate::point::{Direction, Point};
use crate::predicates::{Side, Turn, approach, normal_turn, side, turn};
use crate::proof::{Farkas, Multiplier};
use crate::region::{
    Boundary, EmptyRegion, HalfPlaneRegion, Region, Vertex, from_chain, from_line, from_parallels,
};
use crate::system::System;

/// The effect of one step of clipping.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Step {
    /// The inequality that was added.
    pub index: usize,
    /// The region before.
    pub before: Arc<Region>,
    /// The region after; that of the step before where nothing changed.
    pub after: Arc<Region>,
    /// Vertices of the region after that were none before.
    pub born: Vec<Point>,
    /// Vertices of the region before that are none after.
    pub lost: Vec<Point>,
    /// The reason why the inequality changed nothing, when it did not.
    pub redundant: Option<StepRedundancy>,
}

/// The reason why a step changed nothing.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum StepRedundancy {
    /// The inequality is `0 ≤ b` with `b ≥ 0`.
    Always,
    /// The region was empty already.
    AlreadyEmpty,
    /// Positive multiples of at most two earlier inequalities add up to this one, with a right-hand side smaller
    /// by `slack ≥ 0`.
    Dominated {
        /// The multipliers of the earlier inequalities.
        by: Vec<Multiplier>,
        /// The distance between the region and the boundary, in the units of the inequality's right-hand side.
        slack: Rational,
    },
}

/// The region of a system, by clipping. Exact. Cost: inequalities times vertices.
pub fn intersect(system: &System) -> Region {
    let mut clipper = Clipper::new(system);
    for index in 0..system.len() {
        clipper.clip(index);
    }
    clipper.region()
}

/// The region of a system, by clipping in the given order of indices, with a report of every step.
///
/// Exact. Cost: inequalities times vertices, with a copy of the region for each step that changes it.
///
/// # Panics
/// When an index is out of range.
pub fn steps(system: &System, order: &[usize]) -> Vec<Step> {
    let mut clipper = Clipper::new(system);
    let mut before = Arc::new(clipper.region());
    order
        .iter()
        .map(|&index| {
            let effect = clipper.clip(index);
            // A region that loses something does not satisfy the inequality.
            let redundant = if effect == Effect::Cut { None } else { clipper.redundancy(index, &before) };
            let changed = (effect != Effect::None).then(|| Arc::new(clipper.region()));
            let [born, lost] =
                changed.as_ref().map_or_else(Default::default, |after| born_and_lost(&before, after));
            let after = changed.unwrap_or_else(|| Arc::clone(&before));
            let before = std::mem::replace(&mut before, Arc::clone(&after));
            Step { index, born, lost, redundant, before, after }
        })
        .collect()
}

/// The vertices that only the second of two regions has, and those that only the first has. Most are vertices of both, in the
/// same order around them, so that each is looked for behind the one found last.
fn born_and_lost(before: &Region, after: &Region) -> [Vec<Point>; 2] {
    let olds = before.vertices();
    let (mut next, mut is_kept) = (0, vec![false; olds.len()]);
    let is_born = |vertex: &&Vertex| {
        let mut behind = (next..olds.len()).chain(0..next);
        let found = behind.find(|&number| olds[number].point() == vertex.point());
        if let Some(number) = found {
            (next, is_kept[number]) = (number + 1, true);
        }
        found.is_none()
    };
    let point = |vertex: &Vertex| vertex.point().clone();
    let born = after.vertices().iter().filter(is_born).map(point).collect();
    let lost = olds.iter().zip(&is_kept).filter(|(_, is_kept)| !**is_kept).map(|(vertex, _)| point(vertex));
    [born, lost.collect()]
}

/// A corner of the polygon on the sphere.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Node {
    /// An ordinary point with the half-planes active there. A point in the middle of an edge (a *knot*) keeps every
    /// edge shorter than a half turn.
    Finite { point: Point, active: Active },
    /// A point at infinity.
    Ideal(Direction),
}

impl Node {
    fn sign(&self, half_plane: &HalfPlane) -> Sign {
        match self {
            Node::Finite { point, .. } => match side(half_plane, point) {
                Side::Inside => Sign::Negative,
                Side::Boundary => Sign::Zero,
                Side::Outside => Sign::Positive,
            },
            Node::Ideal(direction) => approach(half_plane, direction),
        }
    }

    /// `a·(x, y) - b·w` and the coordinates that it was computed from.
    fn excess(&self, half_plane: &HalfPlane) -> (Integer, [Integer; 3]) {
        let coordinates = match self {
            Node::Finite { point, .. } => {
                let (x, y, w) = point.homogeneous();
                [x.clone(), y.clone(), w.clone()]
            }
            Node::Ideal(direction) => [direction.dx().clone(), direction.dy().clone(), Integer::zero()],
        };
        let [x, y, w] = &coordinates;
        (half_plane.a1() * x + half_plane.a2() * y - half_plane.b() * w, coordinates)
    }

    fn active(&self) -> &[usize] {
        match self {
            Node::Finite { active, .. } => active,
            Node::Ideal(_) => &[],
        }
    }

    fn same_place(&self, other: &Node) -> bool {
        match (self, other) {
            (Node::Finite { point, .. }, Node::Finite { point: other, .. }) => point == other,
            (Node::Ideal(direction), Node::Ideal(other)) => direction == other,
            _ => false,
        }
    }
}

#[derive(Debug, Clone)]
enum State {
    /// Nothing has cut the plane yet.
    Plane,
    /// One or more half-planes have cut the plane.
    Cut,
    Empty(Farkas),
}

/// The effect of an inequality on the region.
#[derive(PartialEq, Eq)]
enum Effect {
    None,
    /// The boundary meets the region, which loses nothing.
    Touch,
    Cut,
}

/// The region cut so far.
#[derive(Debug, Clone)]
struct Clipper<'a> {
    system: &'a System,
    state: State,
    /// Counter-clockwise; a region within a line is run along in both directions.
    nodes: Vec<Node>,
}

impl<'a> Clipper<'a> {
    fn new(system: &'a System) -> Self {
        let corners = [(1, 0), (0, 1), (-1, 0), (0, -1)];
        let nodes = corners.iter().filter_map(|&(x, y)| Direction::new(x.into(), y.into())).map(Node::Ideal);
        Clipper { system, state: State::Plane, nodes: nodes.collect() }
    }

    /// Adds an inequality.
    fn clip(&mut self, index: usize) -> Effect {
        match &self.system.constraints()[index] {
            _ if matches!(self.state, State::Empty(_)) => Effect::None,
            Constraint::Always => Effect::None,
            Constraint::Never => {
                self.state = State::Empty(Farkas::new(vec![Multiplier { index, value: Rational::one() }]));
                Effect::Cut
            }
            Constraint::HalfPlane(half_plane) => self.clip_by(index, half_plane),
        }
    }

    fn clip_by(&mut self, index: usize, half_plane: &HalfPlane) -> Effect {
        let signs: Vec<Sign> = self.nodes.iter().map(|node| node.sign(half_plane)).collect();
        if signs.iter().all(|sign| *sign == Sign::Negative) {
            return Effect::None;
        }
        if signs.contains(&Sign::Positive) {
            // A finite point on the near side, or a direction that leads there, shows that something is left.
            let survives = self.nodes.iter().zip(&signs).any(|(node, sign)| match node {
                Node::Finite { .. } => *sign != Sign::Positive,
                Node::Ideal(_) => *sign == Sign::Negative,
            });
            if !survives {
                self.state = State::Empty(
                    NormalFan::of(self.system, &self.region()).contradiction(self.system, index),
                );
                return Effect::Cut;
            }
            self.state = State::Cut;
        }
        for (node, _) in self.nodes.iter_mut().zip(&signs).filter(|(_, sign)| **sign == Sign::Zero) {
            if let Node::Finite { active, .. } = node {
                active.push(index);
                active.settle();
            }
        }
        if !signs.contains(&Sign::Positive) {
            return Effect::Touch;
        }
        self.cut((index, half_plane), &signs);
        Effect::Cut
    }

    /// Keeps what lies on the near side: nodes that do, and a new node wherever an edge crosses.
    fn cut(&mut self, cut: (usize, &HalfPlane), signs: &[Sign]) {
        let (index, half_plane) = cut;
        let nexts = self.nodes.iter().zip(signs).cycle().skip(1);
        let crossings =
            self.nodes.iter().zip(signs).zip(nexts).map(|((node, sign), (next, sign_of_next))| {
                let is_crossed = matches!(
                    (sign, sign_of_next),
                    (Sign::Negative, Sign::Positive) | (Sign::Positive, Sign::Negative)
                );
                is_crossed.then(|| self.crossing(node, next, cut)).flatten()
            });
        let crossings: Vec<Option<Node>> = crossings.collect();
        let (mut kept, mut dropped) = (Vec::with_capacity(self.nodes.len() + 2), Vec::new());
        for ((node, sign), crossing) in std::mem::take(&mut self.nodes).into_iter().zip(signs).zip(crossings)
        {
            if *sign == Sign::Positive { &mut dropped } else { &mut kept }.push(node);
            kept.extend(crossing);
        }
        kept.dedup_by(|next, node| node.same_place(next));
        while kept.len() > 1 && kept[0].same_place(&kept[kept.len() - 1]) {
            kept.pop();
        }
        // Where the whole boundary line is new, its two ends at infinity are opposite: tie it down with a knot.
        let count = kept.len();
        let gap = (0..count).find(|&i| match (&kept[i], &kept[(i + 1) % count]) {
            (Node::Ideal(out), Node::Ideal(back)) => turn(out, back) == Turn::Half,
            _ => false,
        });
        if let Some(position) = gap {
            let point = foot(half_plane);
            let active = kept.iter().chain(&dropped).flat_map(Node::active).chain([&index]);
            let active = self.touching(active, &point);
            kept.insert(position + 1, Node::Finite { point, active });
        }
        self.nodes = kept;
    }

    /// Returns where the edge between two nodes on different sides meets the boundary.
    fn crossing(&self, from: &Node, to: &Node, (index, half_plane): (usize, &HalfPlane)) -> Option<Node> {
        let active =
            |point: &Point| self.touching(from.active().iter().chain(to.active()).chain([&index]), point);
        // The edge lies on a boundary that passes through both nodes, whose numbers are shorter than those of the nodes.
        let is_common = |index: &&usize| to.active().binary_search(index).is_ok();
        if let Some(own) = from.active().iter().find(is_common).and_then(|&own| self.system.half_plane(own)) {
            let point = meet(own, half_plane)?;
            return Some(Node::Finite { active: active(&point), point });
        }
        let ((from_excess, p), (to_excess, q)) = (from.excess(half_plane), to.excess(half_plane));
        let (from_weight, to_weight) = (to_excess.abs(), from_excess.abs());
        let [x, y, w] = [0, 1, 2].map(|i| &p[i] * &from_weight + &q[i] * &to_weight);
        if w.is_zero() {
            return Direction::new(x, y).map(Node::Ideal);
        }
        let point = Point::from_homogeneous(x, y, w)?;
        Some(Node::Finite { active: active(&point), point })
    }

    /// Returns the candidates whose boundary passes through the point, ascending.
    fn touching<'b>(&self, candidates: impl Iterator<Item = &'b usize>, point: &Point) -> Active {
        let touches = |index: &usize| {
            self.system.half_plane(*index).is_some_and(|half_plane| side(half_plane, point) == Side::Boundary)
        };
        let mut touching: Vec<usize> = candidates.copied().filter(touches).collect();
        touching.sort_unstable();
        touching.dedup();
        touching.into()
    }

    fn redundancy(&self, index: usize, region: &Region) -> Option<StepRedundancy> {
        let inequality = self.system.inequality(index);
        match (&self.state, &self.system.constraints()[index]) {
            (State::Empty(_), _) => Some(StepRedundancy::AlreadyEmpty),
            (_, Constraint::Always) => Some(StepRedundancy::Always),
            (_, Constraint::Never) => None,
            (_, Constraint::HalfPlane(_)) => {
                match NormalFan::of(self.system, region).support(self.system, &inequality.a) {
                    FanSupport::Bounded { value, multipliers } if value <= inequality.b => {
                        Some(StepRedundancy::Dominated { by: multipliers, slack: &inequality.b - value })
                    }
                    _ => None,
                }
            }
        }
    }

    /// The region, read off the nodes.
    fn region(&self) -> Region {
        match &self.state {
            State::Plane => return Region::Plane,
            State::Empty(certificate) => {
                return Region::Empty(EmptyRegion { certificate: certificate.clone() });
            }
            State::Cut => {}
        }
        // Start behind the points at infinity, so that they come last and in one run.
        let count = self.nodes.len();
        let ideal_at = |position: usize| matches!(self.nodes[position % count], Node::Ideal(_));
        let start = (0..count).find(|&i| !ideal_at(i) && ideal_at(i + count - 1)).unwrap_or(0);
        let mut vertices: Vec<Vertex> = Vec::new();
        let mut lines: Vec<Boundary> = Vec::new();
        let mut ideal: Vec<&Direction> = Vec::new();
        for node in self.nodes[start..].iter().chain(&self.nodes[..start]) {
            match node {
                Node::Ideal(direction) => ideal.push(direction),
                Node::Finite { point, active } => match self.line_through(active) {
                    None => vertices.push(Vertex { point: point.clone(), active: active.clone() }),
                    Some(line) => lines.push(line),
                },
            }
        }
        if vertices.is_empty() {
            return from_lines(lines, &ideal);
        }
        let rays = ideal.first().zip(ideal.last());
        from_chain(vertices, rays.map(|(&outgoing, &incoming)| (outgoing.clone(), incoming.clone())))
    }

    /// The line shared by the half-planes active at a point, unless they make it a corner.
    fn line_through(&self, active: &[usize]) -> Option<Boundary> {
        let mut half_planes = active.iter().filter_map(|&index| self.system.half_plane(index));
        let first = half_planes.next()?;
        half_planes
            .all(|other| matches!(normal_turn(first, other), Turn::None | Turn::Half))
            .then(|| Boundary { half_plane: first.clone(), active: active.to_vec() })
    }
}

/// A region without vertices: what lies on one side of a line, between two, or on one.
fn from_lines(mut lines: Vec<Boundary>, ideal: &[&Direction]) -> Region {
    let Some(boundary) = lines.pop() else { return Region::Plane };
    let leaves_line = |direction: &&Direction| approach(&boundary.half_plane, direction) != Sign::Zero;
    if ideal.iter().any(leaves_line) {
        return Region::HalfPlane(HalfPlaneRegion { boundary });
    }
    match lines.pop() {
        Some(other) if other.active != boundary.active => from_parallels(boundary, other),
        _ => from_line(boundary),
    }
}
