//! A system together with its region, and the questions one asks about them.

use std::sync::OnceLock;

use boundfit_exact::{Endpoint, Integer, Interval, Rational};

use crate::active_sets::{ActiveSets, Sets};
use crate::constructions::{crossing, foot, meet, meet_at};
use crate::envelope::{self, Outline};
use crate::fan::{FanSupport, NormalFan};
use crate::half_plane::HalfPlane;
use crate::point::{Direction, Point};
use crate::predicates::{Turn, turn};
use crate::proof::{BoundProof, Farkas, Multiplier, UnboundedProof};
use crate::region::{Region, RegionKind};
use crate::system::System;

/// A system of inequalities and the region that it describes.
#[derive(Debug, Clone)]
pub struct Polyhedron {
    system: System,
    fan: NormalFan,
    /// The region; a polygon is made when somebody looks at it, since its vertices take more memory than its half-planes.
    region: OnceLock<Region>,
}

/// The maximum of a linear form over a region.
#[derive(Debug, Clone, PartialEq, Eq)]
#[allow(clippy::large_enum_variant, reason = "built once per question and taken apart at once")]
pub enum Support {
    /// The set has no point to take the maximum over.
    Empty(Farkas),
    /// The form grows without end.
    Unbounded(UnboundedProof),
    /// The maximum is attained.
    Bounded {
        /// The value and why it cannot be exceeded.
        proof: BoundProof,
        /// All points that attain it.
        face: Face,
    },
}

/// The place where a linear form attains its maximum.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Face {
    /// One vertex.
    Vertex(Point),
    /// An edge.
    Segment([Point; 2]),
    /// An unbounded edge.
    Ray {
        /// The vertex where the edge starts.
        apex: Point,
        /// The direction in which the edge goes on.
        direction: Direction,
    },
    /// A whole line.
    Line {
        /// The point of the line nearest to the origin.
        point: Point,
        /// The direction along the line; the first non-zero component is positive.
        direction: Direction,
    },
    /// Everywhere: the form is zero.
    Whole,
}

/// The reason why an inequality could be left out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Redundancy {
    /// The inequality is `0 ≤ b` with `b ≥ 0`.
    Always,
    /// The inequality describes the same half-plane as this irredundant one.
    SameAs(usize),
    /// Positive multiples of at most two irredundant inequalities add up to it, with a right-hand side smaller by
    /// `slack ≥ 0`. Slack 0 means that its boundary touches the region.
    Dominated {
        /// The multipliers of the irredundant inequalities.
        by: Vec<Multiplier>,
        /// The rest, in the units of the inequality's right-hand side.
        slack: Rational,
    },
    /// The region is empty without it.
    EmptyWithout,
}

/// The place of a point with respect to a system.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Membership {
    /// The smallest slack `b - a·θ` over all inequalities: negative outside, zero on the boundary. `None` without
    /// inequalities.
    pub slack: Option<Rational>,
    /// The first inequality with that slack.
    pub tightest: Option<usize>,
}

impl Membership {
    /// Returns whether the point belongs to the region.
    pub fn is_inside(&self) -> bool {
        self.slack.as_ref().is_none_or(|slack| !slack.is_negative())
    }
}

impl Polyhedron {
    /// Intersects the half-planes of a system with the fast algorithm. Exact. Cost: O(n log n).
    ///
    /// ```
    /// use boundfit_geometry::{Inequality, Polyhedron, System};
    ///
    /// // θ1 ≥ 0, θ2 ≥ 0 and θ1 + θ2 ≥ 1 leave a set without end, with two vertices.
    /// let row = |a1: i64, a2: i64, b: i64| Inequality::new(a1.into(), a2.into(), b.into());
    /// let system: System = [row(-1, 0, 0), row(0, -1, 0), row(-1, -1, -1)].into_iter().collect();
    /// let set = Polyhedron::intersect(system);
    /// assert_eq!((set.region().vertices().len(), set.region().area()), (2, None));
    /// ```
    pub fn intersect(system: System) -> Self {
        match envelope::outline(&system) {
            Outline::Polygon(fan) => Polyhedron { system, fan, region: OnceLock::new() },
            Outline::Other(region) => {
                Polyhedron { fan: NormalFan::of(&system, &region), system, region: region.into() }
            }
        }
    }

    /// The inequalities.
    pub fn system(&self) -> &System {
        &self.system
    }

    /// The intersection of the system's half-planes. Cost: O(n log n) for a polygon at which somebody looks for the first time.
    pub fn region(&self) -> &Region {
        self.region.get_or_init(|| self.fan.polygon(&self.system))
    }

    /// Returns the kind of the region, one of ten. Cost: constant.
    pub fn kind(&self) -> RegionKind {
        self.region.get().map_or(RegionKind::Polygon, Region::kind)
    }

    /// Returns whether there is no point in the region. Cost: constant.
    pub fn is_empty(&self) -> bool {
        self.kind() == RegionKind::Empty
    }

    /// The number of vertices. Cost: constant.
    pub fn vertex_count(&self) -> usize {
        self.region.get().map_or(self.fan.indices().len(), |region| region.vertices().len())
    }

    /// The vertices, counter-clockwise from the lexicographically smallest, each as (x : y : w): θ1 is x/w, θ2 is y/w, and `w` is
    /// positive. The three may have common divisors. Exact. Cost: constant for each, without greatest common divisors, and no memory.
    pub fn homogeneous_vertices(&self) -> impl Iterator<Item = [Integer; 3]> + '_ {
        let kept = self.region.get().map(|region| {
            region.vertices().iter().map(|vertex| {
                let (x, y, w) = vertex.point().homogeneous();
                [x, y, w].map(Integer::clone)
            })
        });
        let made = kept.is_none().then(|| {
            let (count, first) = (self.fan.indices().len(), self.fan.first_side(&self.system));
            (first..first + count).map(|place| {
                let [before, own] = self.fan.sides_at(&self.system, place);
                crossing(before, own)
            })
        });
        kept.into_iter().flatten().chain(made.into_iter().flatten())
    }

    /// The half-planes that are active at the vertices of [`Polyhedron::homogeneous_vertices`]. Cost: O(n log n) in the number of redundant
    /// half-planes. Memory: that of those that touch the set.
    pub fn active_sets(&self) -> ActiveSets<'_> {
        match self.region.get() {
            Some(region) => ActiveSets(Sets::Kept(region.vertices())),
            None => self.fan.active_sets(&self.system),
        }
    }

    /// The irredundant half-planes by angle.
    pub(crate) fn fan(&self) -> &NormalFan {
        &self.fan
    }

    /// The maximum of `form·θ` over the region, with its proof. Exact. Cost: linear in the number of vertices.
    pub fn support(&self, form: &[Rational; 2]) -> Support {
        if let Some(certificate) = self.certificate() {
            return Support::Empty(certificate.clone());
        }
        match self.fan.support(&self.system, form) {
            FanSupport::Bounded { value, multipliers } => {
                let (face, attained_at) = self.face(form, &value, &multipliers);
                let form = form.clone();
                Support::Bounded { proof: BoundProof { form, value, multipliers, attained_at }, face }
            }
            FanSupport::Unbounded => Support::Unbounded(UnboundedProof {
                form: form.clone(),
                point: self.region().witness().unwrap_or_else(Point::origin),
                ray: self.growing_ray(form),
            }),
        }
    }

    /// The box of the region: the range of θ1 and of θ2, or `None` when it is empty.
    pub fn bounding_box(&self) -> Option<[Interval; 2]> {
        let (zero, one) = (Rational::zero(), Rational::one());
        Some([self.range(&[one.clone(), zero.clone()])?, self.range(&[zero, one])?])
    }

    /// The values that `form·θ` takes over the region, or `None` when it is empty. Exact. Cost: logarithmic in the number of
    /// irredundant half-planes.
    pub fn range(&self, form: &[Rational; 2]) -> Option<Interval> {
        let upper = self.maximum(form)?;
        let lower = match self.maximum(&form.each_ref().map(|c| -c))? {
            Endpoint::Finite(value) => Endpoint::Finite(-value),
            Endpoint::Unbounded => Endpoint::Unbounded,
        };
        Interval::new(lower, upper)
    }

    /// The width `max form·θ - min form·θ`, in the units of the form; `None` when the region is empty or unbounded
    /// that way.
    pub fn width(&self, form: &[Rational; 2]) -> Option<Rational> {
        let opposite = [-&form[0], -&form[1]];
        match (self.maximum(form)?, self.maximum(&opposite)?) {
            (Endpoint::Finite(upper), Endpoint::Finite(lower)) => Some(upper + lower),
            _ => None,
        }
    }

    /// Indices of a minimal set of inequalities with the same region, ascending. The first of coinciding inequalities
    /// is kept. For an empty region: those of the certificate.
    pub fn irredundant(&self) -> Vec<usize> {
        let mut indices = match self.certificate() {
            Some(certificate) => certificate.multipliers().iter().map(|m| m.index).collect(),
            None => self.fan.indices().to_vec(),
        };
        indices.sort_unstable();
        indices
    }

    /// The half-planes that are not redundant, by the angle of their normals from the positive θ1 axis: neighbours meet
    /// in a vertex, unless the region goes on between them. Nothing for an empty region.
    pub fn irredundant_by_angle(&self) -> &[usize] {
        self.fan.indices()
    }

    /// Returns for every inequality why it could be left out, or `None` when it is one of [`Polyhedron::irredundant`].
    /// Exact. Cost: O(n log n).
    pub fn redundancies(&self) -> Vec<Option<Redundancy>> {
        let irredundant = self.irredundant();
        (0..self.system.len())
            .map(|index| irredundant.binary_search(&index).is_err().then(|| self.reason(index)))
            .collect()
    }

    /// The irredundant half-planes whose normals come last at or before that of an inequality, and first after it, by angle;
    /// `None` where that has no normal, or there are none. They alone decide on what [`Polyhedron::reason`] says of it. Cost:
    /// logarithmic.
    pub fn neighbours(&self, index: usize) -> Option<(usize, usize)> {
        self.neighbours_of(self.system.half_plane(index)?)
    }

    /// Answers as [`Polyhedron::neighbours`] does, for a half-plane that need not be one of the system's. The
    /// neighbours of a half-plane that contains the region are those that dominate it. Cost: logarithmic.
    pub fn neighbours_of(&self, half_plane: &HalfPlane) -> Option<(usize, usize)> {
        self.fan.around(&self.system, half_plane)
    }

    /// The reason why an inequality, one that is redundant, could be left out. Exact. Cost: logarithmic.
    pub fn reason(&self, index: usize) -> Redundancy {
        if self.is_empty() {
            return Redundancy::EmptyWithout;
        }
        let inequality = self.system.inequality(index);
        let FanSupport::Bounded { value, multipliers } = self.fan.support(&self.system, &inequality.a) else {
            // Not reached: the region satisfies the inequality, so its form is bounded there.
            return Redundancy::Dominated { by: Vec::new(), slack: Rational::zero() };
        };
        let constraints = self.system.constraints();
        match multipliers.as_slice() {
            [] => Redundancy::Always,
            [only] if constraints[only.index] == constraints[index] => Redundancy::SameAs(only.index),
            _ => Redundancy::Dominated { by: multipliers, slack: &inequality.b - value },
        }
    }

    /// Returns whether a point satisfies every inequality, and with how much to spare. Exact. Cost: linear.
    pub fn membership(&self, theta: &[Rational; 2]) -> Membership {
        let (theta, common) = Rational::over_common_denominator([&theta[0], &theta[1]]);
        let slacks = (0..self.system.len()).map(|index| self.system.slack_over(index, &theta, &common));
        let tightest = slacks.enumerate().reduce(|best, next| if next.1 < best.1 { next } else { best });
        let (tightest, slack) = tightest.unzip();
        let slack = slack.flatten().and_then(|slack| Rational::from(slack).checked_div(&common.into()));
        Membership { slack, tightest }
    }

    /// The proof of emptiness, when the region is empty. Cost: constant.
    pub fn certificate(&self) -> Option<&Farkas> {
        self.region.get().and_then(Region::certificate)
    }

    fn maximum(&self, form: &[Rational; 2]) -> Option<Endpoint> {
        if self.is_empty() {
            return None;
        }
        Some(match self.fan.support(&self.system, form) {
            FanSupport::Bounded { value, .. } => Endpoint::Finite(value),
            FanSupport::Unbounded => Endpoint::Unbounded,
        })
    }

    /// The points of the region where the form has the value of its maximum, and one of them.
    ///
    /// A point attains the maximum exactly when every inequality of its proof is active there (complementary slackness).
    fn face(&self, form: &[Rational; 2], value: &Rational, proof: &[Multiplier]) -> (Face, Point) {
        let Some(direction) = Direction::from_rational(form) else {
            return (Face::Whole, self.region().witness().unwrap_or_else(Point::origin));
        };
        if let [f, g] = proof
            && let [Some(f), Some(g)] = [f, g].map(|own| self.system.half_plane(own.index))
            && let Some(vertex) = corner(f, g, form, value)
        {
            return (Face::Vertex(vertex.clone()), vertex);
        }
        if let ([side], RegionKind::Polygon) = (proof, self.kind()) {
            let ends = self.fan.ends_of_side(&self.system, side.index);
            return (Face::Segment(ends.clone()), ends[0].clone());
        }
        let attaining: Vec<&Point> = self
            .region()
            .vertices()
            .iter()
            .filter(|vertex| proof.iter().all(|m| vertex.active().binary_search(&m.index).is_ok()))
            .map(|vertex| vertex.point())
            .collect();
        match attaining.as_slice() {
            [one, other, ..] => (Face::Segment([(*one).clone(), (*other).clone()]), (*one).clone()),
            [apex] => {
                let apex = (*apex).clone();
                let along = self.region().rays().into_iter().find(|ray| along(form, ray).is_zero());
                match along {
                    Some(direction) => (Face::Ray { apex: apex.clone(), direction }, apex),
                    None => (Face::Vertex(apex.clone()), apex),
                }
            }
            [] => {
                let faces_it = |normal: &Direction| turn(normal, &direction) == Turn::None;
                let boundary = self.region().boundaries().iter().find(|b| faces_it(&b.half_plane().normal()));
                // A line is kept from one side only; the form may look at it from the other.
                let boundary = boundary.or(self.region().boundaries().first());
                let point = boundary.map_or_else(Point::origin, |boundary| foot(boundary.half_plane()));
                (Face::Line { point: point.clone(), direction: direction.turned_left().of_line() }, point)
            }
        }
    }

    /// A recession direction along which a form grows that the region does not bound.
    fn growing_ray(&self, form: &[Rational; 2]) -> Direction {
        let lines = self.region().lines().into_iter().flat_map(|line| [line.reversed(), line]);
        self.region()
            .rays()
            .into_iter()
            .chain(lines)
            .find(|direction| along(form, direction).is_positive())
            .expect("a form without a bound grows along a recession direction")
    }
}

/// The common point of two boundaries, where a form has this value. The value of a parameter is a coordinate.
fn corner(f: &HalfPlane, g: &HalfPlane, form: &[Rational; 2], value: &Rational) -> Option<Point> {
    let one = Rational::one();
    let known = match form {
        [first, second] if second.is_zero() && *first == one => meet_at(f, g, 0, value),
        [first, second] if second.is_zero() && -first == one => meet_at(f, g, 0, &-value),
        [first, second] if first.is_zero() && *second == one => meet_at(f, g, 1, value),
        [first, second] if first.is_zero() && -second == one => meet_at(f, g, 1, &-value),
        _ => None,
    };
    known.or_else(|| meet(f, g))
}

/// `form·direction`.
fn along(form: &[Rational; 2], direction: &Direction) -> Rational {
    &form[0] * Rational::from(direction.dx()) + &form[1] * Rational::from(direction.dy())
}
