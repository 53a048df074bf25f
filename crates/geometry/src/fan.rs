//! The normal fan of a region: its irredundant half-planes by the angle of their normals.
//!
//! Neighbours in the fan meet in a vertex of the region unless the region goes on between them. Every linear form
//! therefore finds its maximum, and the proof of it, between two neighbours (linear programming duality).

use std::cmp::Ordering;

use boundfit_exact::{Integer, Rational, Sign};

use crate::active_sets::{ActiveSets, Sets};
use crate::constructions::{direction_between, meet};
use crate::half_plane::{HalfPlane, Inequality};
use crate::point::{Direction, Point};
use crate::predicates::{
    Turn, angle_order, approach, are_concurrent, by_angle, normal, normal_turn, turn, turn_between,
};
use crate::proof::{Farkas, Multiplier};
use crate::region::{PolygonRegion, Region, Vertex};
use crate::system::System;

/// The maximum of a linear form, as the fan sees it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum FanSupport {
    /// Returns at most two multipliers that add up to the form, and the right-hand side they give.
    Bounded { value: Rational, multipliers: Vec<Multiplier> },
    /// No non-negative combination of the region's half-planes gives the form.
    Unbounded,
}

/// A minimal set of half-planes whose intersection is the region, sorted by angle.
///
/// The lowest index stands for coinciding half-planes. Where lower-dimensional regions leave a
/// choice, it is made by a rule that does not depend on how the region was found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct NormalFan {
    spokes: Vec<usize>,
}

impl NormalFan {
    /// The fan of a non-empty region of this system. Cost: the size of the region and of its active sets.
    pub(crate) fn of(system: &System, region: &Region) -> Self {
        let mut spokes: Vec<usize> = match region {
            Region::Empty(_) | Region::Plane => Vec::new(),
            Region::Point(region) => point_generators(system, &region.vertex.active),
            Region::Segment(region) => {
                let [start, end] = &region.ends;
                direction_between(&start.point, &end.point)
                    .map(|along| {
                        let ends = [(start, along.reversed()), (end, along.clone())];
                        flat_generators(system, &start.active, &along, &ends)
                    })
                    .unwrap_or_default()
            }
            Region::Ray(region) => {
                let ends = [(&region.apex, region.direction.reversed())];
                flat_generators(system, &region.apex.active, &region.direction, &ends)
            }
            Region::Line(region) => {
                let along = region.boundary.half_plane.normal().turned_left();
                flat_generators(system, &region.boundary.active, &along, &[])
            }
            Region::Polygon(region) => {
                let vertices = &region.vertices;
                let next = vertices.iter().cycle().skip(1);
                vertices.iter().zip(next).filter_map(|(from, to)| edge(from, to)).collect()
            }
            Region::UnboundedPolygon(region) => {
                let chain: Vec<&Vertex> = region.chain().collect();
                let edges = chain.windows(2).filter_map(|pair| edge(pair[0], pair[1]));
                let incoming = with_normal(system, &chain[0].active, &region.incoming.turned_left());
                let last = chain[chain.len() - 1];
                let outgoing = with_normal(system, &last.active, &region.outgoing.turned_right());
                incoming.into_iter().chain(edges).chain(outgoing).collect()
            }
            Region::Strip(_) | Region::HalfPlane(_) => {
                region.boundaries().iter().filter_map(|boundary| boundary.active.first().copied()).collect()
            }
        };
        let order = |f: usize, g: usize| by_angle(normal_of(system, f), normal_of(system, g));
        match (region, spokes.first()) {
            // These go once around already, from somewhere.
            (Region::Polygon(_) | Region::UnboundedPolygon(_), Some(&first)) => {
                let before_the_end =
                    spokes.partition_point(|&spoke| order(first, spoke) != Ordering::Greater);
                spokes.rotate_left(before_the_end);
            }
            _ => spokes.sort_by(|&f, &g| order(f, g)),
        }
        NormalFan { spokes }
    }

    /// The fan of a polygon with these sides, by angle, each the first of those that coincide.
    pub(crate) fn of_sides(spokes: Vec<usize>) -> Self {
        NormalFan { spokes }
    }

    /// The place of the side of a polygon that leads away from its lexicographically smallest vertex, the first one. Cost:
    /// logarithmic.
    pub(crate) fn first_side(&self, system: &System) -> usize {
        // That vertex lies behind the half-planes up to the angle of (-1, 0).
        self.spokes.partition_point(|&spoke| !normal_of(system, spoke).a2().is_negative())
    }

    /// The half-planes of the side at a place and of the side before it, all places taken around the polygon. They meet in a vertex.
    pub(crate) fn sides_at<'a>(&self, system: &'a System, place: usize) -> [&'a HalfPlane; 2] {
        let count = self.spokes.len();
        [place + count - 1, place].map(|place| normal_of(system, self.spokes[place % count]))
    }

    /// The vertex of a polygon between the side at a place and the side before it.
    fn corner(&self, system: &System, place: usize) -> Point {
        let [before, own] = self.sides_at(system, place);
        meet(before, own).expect("parallel sides of a polygon that follow each other")
    }

    /// The ends of a side of a polygon, in the order of its vertices. Cost: logarithmic.
    pub(crate) fn ends_of_side(&self, system: &System, side: usize) -> [Point; 2] {
        let after = self.place_after(system, normal(&normal_of(system, side).triple()));
        let [start, end] = [after - 1, after].map(|place| self.corner(system, place));
        if after == self.first_side(system) { [end, start] } else { [start, end] }
    }

    /// The half-planes that touch a polygon beside its sides, each behind the number of the vertex that it touches, ascending. Vertices
    /// are counted from the lexicographically smallest. Exact. Cost: O(n log n) in the number of half-planes that are no sides.
    fn touching(&self, system: &System) -> Vec<(usize, usize)> {
        let (count, first) = (self.spokes.len(), self.first_side(system));
        let mut is_side = vec![false; system.len()];
        self.spokes.iter().for_each(|&spoke| is_side[spoke] = true);
        let mut touching = Vec::new();
        let mut after = 0;
        for (index, half_plane) in system.half_planes().filter(|(index, _)| !is_side[*index]) {
            // A half-plane touches the polygon, if at all, between the two sides that its normal lies between.
            after = self.place_behind(system, half_plane, after);
            let [own, next] = [after + count - first - 1, after + count - first].map(|place| place % count);
            let [before, behind] = self.sides_at(system, after);
            if half_plane == before {
                touching.extend([(own, index), (next, index)]);
            } else if normal_turn(before, half_plane) != Turn::None
                && are_concurrent(before, half_plane, behind)
            {
                touching.push((next, index));
            }
        }
        touching.sort_unstable();
        touching
    }

    /// The half-planes that are active at each vertex of a polygon. Cost: that of the half-planes that are no sides, O(n log n).
    pub(crate) fn active_sets(&self, system: &System) -> ActiveSets<'_> {
        let (first, touching) = (self.first_side(system), self.touching(system));
        ActiveSets(Sets::OfSides { sides: &self.spokes, first, touching })
    }

    /// The polygon of this fan, its vertices with all half-planes that are active there. Exact. Cost: O(n log n) in the number of
    /// half-planes.
    pub(crate) fn polygon(&self, system: &System) -> Region {
        let (first, active) = (self.first_side(system), self.active_sets(system));
        let vertex =
            |number: usize| Vertex { point: self.corner(system, first + number), active: active.at(number) };
        Region::Polygon(PolygonRegion { vertices: (0..self.spokes.len()).map(vertex).collect() })
    }

    /// Indices of the irredundant half-planes, by angle.
    pub(crate) fn indices(&self) -> &[usize] {
        &self.spokes
    }

    /// The maximum of a form over the region. Cost: logarithmic in the number of irredundant half-planes.
    pub(crate) fn support(&self, system: &System, form: &[Rational; 2]) -> FanSupport {
        let Some(form) = IntegerForm::new(form) else {
            return FanSupport::Bounded { value: Rational::zero(), multipliers: Vec::new() };
        };
        let Some((before, after)) = self.neighbours(system, &form) else {
            return FanSupport::Unbounded;
        };
        let (f, g) = (normal_of(system, before), normal_of(system, after));
        let turn_in = turn_between(normal(&f.triple()), form.vector());
        if turn_in == Turn::None {
            let inequality = system.inequality(before);
            let multiplier = form.multiple(&inequality, f);
            let value = &inequality.b * &multiplier;
            let multipliers = vec![Multiplier { index: before, value: multiplier }];
            return FanSupport::Bounded { value, multipliers };
        }
        let within = turn_in == Turn::Left
            && turn_between(form.vector(), normal(&g.triple())) == Turn::Left
            && normal_turn(f, g) == Turn::Left;
        if !within {
            return FanSupport::Unbounded;
        }
        let inequalities = [before, after].map(|index| system.inequality(index));
        let (value, [s, t]) = form.combination(inequalities.each_ref().map(AsRef::as_ref), [f, g]);
        let mut multipliers =
            vec![Multiplier { index: before, value: s }, Multiplier { index: after, value: t }];
        multipliers.sort_by_key(|multiplier| multiplier.index);
        FanSupport::Bounded { value, multipliers }
    }

    /// The proof that nothing of this fan's region satisfies one more inequality. The region must not be empty and
    /// the inequality must exclude all of it.
    pub(crate) fn contradiction(&self, system: &System, index: usize) -> Farkas {
        let inequality = system.inequality(index);
        let [a1, a2] = &inequality.a;
        let mut multipliers = match self.support(system, &[-a1, -a2]) {
            FanSupport::Bounded { multipliers, .. } => multipliers,
            FanSupport::Unbounded => Vec::new(),
        };
        multipliers.push(Multiplier { index, value: Rational::one() });
        Farkas::new(multipliers)
    }

    /// The irredundant half-planes whose normals come last at or before, and first after, that of a half-plane.
    pub(crate) fn around(&self, system: &System, half_plane: &HalfPlane) -> Option<(usize, usize)> {
        self.around_direction(system, normal(&half_plane.triple()))
    }

    fn neighbours(&self, system: &System, form: &IntegerForm) -> Option<(usize, usize)> {
        self.around_direction(system, form.vector())
    }

    fn around_direction(&self, system: &System, direction: (&Integer, &Integer)) -> Option<(usize, usize)> {
        let count = self.spokes.len();
        if count == 0 {
            return None;
        }
        let after = self.place_after(system, direction);
        Some((self.spokes[(after + count - 1) % count], self.spokes[after % count]))
    }

    /// The place of the first half-plane behind the normal of another one. A guess is tried before a search, since readings that follow
    /// each other often have their place in common.
    fn place_behind(&self, system: &System, half_plane: &HalfPlane, guess: usize) -> usize {
        let is_before = |spoke: usize| by_angle(half_plane, normal_of(system, spoke)).is_lt();
        let is_right = guess.checked_sub(1).is_none_or(|before| !is_before(self.spokes[before]))
            && self.spokes.get(guess).is_none_or(|&spoke| is_before(spoke));
        if is_right { guess } else { self.spokes.partition_point(|&spoke| !is_before(spoke)) }
    }

    /// The place of the first half-plane behind a direction; the number of places where there is none.
    fn place_after(&self, system: &System, direction: (&Integer, &Integer)) -> usize {
        self.spokes.partition_point(|&index| {
            angle_order(direction, normal(&normal_of(system, index).triple())) != Ordering::Less
        })
    }
}

/// A linear form other than zero as integers over a common denominator.
struct IntegerForm {
    vector: [Integer; 2],
    denominator: Integer,
}

impl IntegerForm {
    fn new(form: &[Rational; 2]) -> Option<Self> {
        let (vector, denominator) = Rational::over_common_denominator(form.each_ref());
        let is_zero = vector.iter().all(Integer::is_zero);
        (!is_zero).then_some(IntegerForm { vector, denominator })
    }

    fn vector(&self) -> (&Integer, &Integer) {
        (&self.vector[0], &self.vector[1])
    }

    /// The multiplier `s` with `s·a = form` for an inequality whose normal has the direction of the form.
    fn multiple(&self, inequality: &Inequality, half_plane: &HalfPlane) -> Rational {
        let axis = usize::from(half_plane.a1().is_zero());
        let coefficient = &inequality.a[axis];
        quotient(&self.vector[axis] * coefficient.denominator(), &self.denominator * coefficient.numerator())
    }

    /// The maximum of the form at the corner of two half-planes, by Cramer's rule, and the multipliers `(s, t)` of
    /// their inequalities with `s·a + t·a' = form`. The normals must not be parallel. Every fraction is reduced once.
    fn combination(
        &self,
        inequalities: [&Inequality; 2],
        half_planes: [&HalfPlane; 2],
    ) -> (Rational, [Rational; 2]) {
        let [f, g] = half_planes;
        let (f_triple, g_triple) = (f.triple(), g.triple());
        let (f_normal, g_normal) = (normal(&f_triple), normal(&g_triple));
        let minor = |u: (&Integer, &Integer), v: (&Integer, &Integer)| u.0 * v.1 - u.1 * v.0;
        let determinant = minor(f_normal, g_normal) * &self.denominator;
        // In multiples of the half-planes' integer triples.
        let (s, t) = (minor(self.vector(), g_normal), minor(f_normal, self.vector()));
        let value = quotient(f.b() * &s + g.b() * &t, determinant.clone());
        let of_inequality = |times: Integer, inequality: &Inequality, half_plane: &HalfPlane| {
            // The triple is a positive multiple of the inequality: this often, with a second coefficient of 1, an integer.
            let axis = usize::from(!half_plane.a2().is_zero());
            let (given, integer) = (&inequality.a[axis], &half_plane.triple()[axis]);
            quotient(times * integer * given.denominator(), &determinant * given.numerator())
        };
        let first = of_inequality(s, inequalities[0], f);
        let second = self.rest(inequalities, &first).unwrap_or_else(|| of_inequality(t, inequalities[1], g));
        (value, [first, second])
    }

    /// The second multiplier, where it follows from the first without a greatest common divisor. It does if the form is of integers and
    /// the second coefficients are 1 or -1, as of readings of a line.
    fn rest(&self, inequalities: [&Inequality; 2], first: &Rational) -> Option<Rational> {
        let one = Rational::one();
        let is_positive = |own: &Inequality| (own.a[1].abs() == one).then(|| own.a[1].is_positive());
        let [of_first, of_second] = inequalities.map(is_positive);
        let (of_first, of_second) = (of_first?, of_second?);
        if self.denominator != Integer::one() {
            return None;
        }
        let form = Rational::from(&self.vector[1]);
        let rest = if of_first { form - first } else { form + first };
        Some(if of_second { rest } else { -rest })
    }
}

/// A fraction whose denominator is not 0.
fn quotient(numerator: Integer, denominator: Integer) -> Rational {
    Rational::new(numerator, denominator).expect("a form between two normals that are not parallel")
}

/// The half-plane of an index that came from an active set: those have a normal.
pub(crate) fn normal_of(system: &System, index: usize) -> &HalfPlane {
    system.half_plane(index).expect("an active inequality without a normal")
}

/// The lowest active index whose outward normal has this direction.
fn with_normal(system: &System, active: &[usize], normal: &Direction) -> Option<usize> {
    let vector = (normal.dx(), normal.dy());
    let faces_it =
        |&index: &usize| turn_between(self::normal(&normal_of(system, index).triple()), vector) == Turn::None;
    active.iter().copied().find(faces_it)
}

/// Returns the lowest index of a half-plane that bounds the edge between neighbouring vertices of a region with an
/// interior. It is active at both vertices, and such a half-plane has its boundary along the edge.
fn edge(from: &Vertex, to: &Vertex) -> Option<usize> {
    let (mut own, mut others) = (from.active.iter().peekable(), to.active.iter().peekable());
    loop {
        match own.peek()?.cmp(others.peek()?) {
            Ordering::Less => own.next(),
            Ordering::Greater => others.next(),
            Ordering::Equal => return own.next().copied(),
        };
    }
}

/// Generators of a region inside a line: the line from both sides, and at each end one half-plane that cuts it
/// there. `ends` gives each end with the direction in which the region stops.
fn flat_generators(
    system: &System,
    active: &[usize],
    along: &Direction,
    ends: &[(&Vertex, Direction)],
) -> Vec<usize> {
    let carriers = [along.turned_left(), along.turned_right()];
    let carriers = carriers.iter().filter_map(|normal| with_normal(system, active, normal));
    let stops = ends.iter().filter_map(|(vertex, outward)| {
        vertex
            .active
            .iter()
            .copied()
            .find(|&index| approach(normal_of(system, index), outward) == Sign::Positive)
    });
    carriers.chain(stops).collect()
}

/// A minimal subset of the half-planes through a point whose intersection is the point alone: normals that
/// positively span the plane. The lowest index is tried first, completed by its nearest partners around the
/// opposite direction.
fn point_generators(system: &System, active: &[usize]) -> Vec<usize> {
    let mut by_direction: Vec<usize> = active.to_vec();
    by_direction.sort_by(|&f, &g| by_angle(normal_of(system, f), normal_of(system, g)).then(f.cmp(&g)));
    by_direction.dedup_by(|g, f| normal_turn(normal_of(system, *f), normal_of(system, *g)) == Turn::None);
    let Some(&first) = by_direction.iter().min() else { return Vec::new() };

    let own = normal_of(system, first).normal();
    let opposite = own.reversed();
    let mut chosen = vec![first];
    chosen.extend(with_normal(system, active, &opposite));
    // The partners strictly left and strictly right of `first` that lie nearest to its opposite.
    for (side, further) in [(Turn::Left, Turn::Left), (Turn::Right, Turn::Right)] {
        let partner = by_direction
            .iter()
            .copied()
            .filter(|&index| turn(&own, &normal_of(system, index).normal()) == side)
            .reduce(|best, index| {
                let closer = normal_turn(normal_of(system, best), normal_of(system, index)) == further;
                if closer { index } else { best }
            });
        chosen.extend(partner);
    }
    // With an opposite pair among them, one of the four may be superfluous.
    for index in chosen.clone().into_iter().rev() {
        let rest: Vec<usize> = chosen.iter().copied().filter(|&other| other != index).collect();
        if chosen.len() > 3 && positively_span(system, &rest) {
            chosen = rest;
        }
    }
    chosen
}

/// Returns whether no open half-plane contains all normals, nor a closed one with nothing on its other side: whether
/// consecutive normals are always less than a half turn apart.
fn positively_span(system: &System, indices: &[usize]) -> bool {
    let mut sorted = indices.to_vec();
    sorted.sort_by(|&f, &g| by_angle(normal_of(system, f), normal_of(system, g)));
    let next = sorted.iter().cycle().skip(1);
    sorted
        .iter()
        .zip(next)
        .all(|(&f, &g)| normal_turn(normal_of(system, f), normal_of(system, g)) == Turn::Left)
}
