//! The place of the next reading of a line that certainly makes the feasible set smaller, and the least reduction
//! there.
//!
//! A further reading at x has an outcome y, which nobody knows before, and an error bound ε, which is known. It keeps the lines of
//! a slab: abs(y - θ1·x - θ2) ≤ ε. The outcome leaves something where y lies in [m(x) - ε, M(x) + ε], with m(x) and M(x) the least
//! and the largest value of the feasible lines at x.
//!
//! **Where a reading certainly helps.** The width w(x) = M(x) - m(x) is convex and piecewise linear, with corners where the form
//! (x, 1) is perpendicular to an edge of the set S. Where w(x) ≤ 2ε the outcome (m(x) + M(x))/2 cuts nothing off. Where w(x) > 2ε no
//! slab has room for the whole set, so that every outcome cuts something off. The x without certainty are therefore a closed
//! interval with rational ends, a single x, all of them or none. It has two ends whenever θ1 has a range: w grows without end on
//! both sides. Where S is not bounded, w is finite for one x at most.
//!
//! **The worst outcome.** The difference body D = S - S has the pairs of parameters of S as points d = θ - θ'. Its
//! support function is w: the pieces of w are the corners of the upper half of D. Two lines of S are in one slab at x
//! exactly where abs(d1·x + d2) ≤ 2ε. The worst outcome therefore leaves an interval of θj of the length
//!
//! > L_j(x) = max { dj : d in D, abs(d1·x + d2) ≤ 2ε },
//!
//! the largest coordinate of D cut by a slab around the origin. The worst area is the area of the best slab of the
//! direction. As y moves on, the area grows by the chord of S that comes in less the chord that leaves. Chords are
//! linear in y between corners, and by Brunn and Minkowski the area has one maximum, so that the best y is rational,
//! and so is the area.
//!
//! **The best x.** For a length s ≥ 0 the set of all x with L_1(x) ≥ s is an interval. Let [l(s), u(s)] be the slice
//! of D at d1 = s. For s > 0 a point of the slice lies in the slab where x is between -(2ε + u(s))/s and (2ε -
//! l(s))/s. So L_1 rises and falls once at most, and its least value within a range is at an end. On each side of x =
//! 0, L_2 does so too, by the same argument for the slice at d2 = s. Its least value is at an end or at x = 0, where
//! a reading measures θ2 itself. The reciprocal of the area is convex in x, since the largest parallel sections of a
//! convex body in space are the radii of a convex body (Meyer 1999). The body here is S × [-ε, ε], whose sections
//! project onto slabs. So the least worst area is at an end, too. Nothing is searched for, and nothing rounded.

mod area;
mod reading;
mod width;

use boundfit_estimation::Corridor;
use boundfit_exact::{Interval, Rational};
use boundfit_geometry::{Direction, Polyhedron};

pub use reading::NextReading;

use area::worst_area;
use width::Width;

/// The quantity that is to become small.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Goal {
    /// The length of θ1's interval.
    Theta1,
    /// The length of θ2's interval.
    Theta2,
    /// The area of the set.
    Area,
}

impl Goal {
    /// Every goal.
    pub const ALL: [Goal; 3] = [Goal::Theta1, Goal::Theta2, Goal::Area];

    /// Returns the name of the goal: `theta1`, `theta2` or `area`.
    pub const fn name(self) -> &'static str {
        match self {
            Goal::Theta1 => "theta1",
            Goal::Theta2 => "theta2",
            Goal::Area => "area",
        }
    }
}

/// The reliable effect of a further reading on a set of lines that is not empty.
#[derive(Debug, Clone)]
pub struct Next<'a> {
    set: &'a Polyhedron,
    epsilon: Rational,
    shape: Shape,
}

/// The difference body of the set.
#[derive(Debug, Clone)]
enum Shape {
    /// The set is bounded.
    Bounded(Width),
    /// The set goes on along a line in both directions, and is bounded across.
    Along {
        /// A direction of the line.
        along: [Rational; 2],
        /// Half its width: the width of the set, measured by (-along2, along1).
        across: Rational,
    },
    /// The set is the whole plane.
    Plane,
}

/// The best x of a range for a goal.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Best {
    /// The goal.
    pub goal: Goal,
    /// The present value; `None` without end.
    pub now: Option<Rational>,
    /// The value after the worst outcome of a reading at the best x; `None` without end.
    pub worst: Option<Rational>,
    /// The best x, ascending; none where a reading at any x of the range may leave the goal as it is.
    pub at: Vec<Rational>,
}

impl<'a> Next<'a> {
    /// The area's fraction is as long as all corners together: of more of them it is not computed.
    pub const MOST_CORNERS: usize = 1_000;

    /// Gets ready for a reading with this error bound, which is not negative; `None` where the set is empty. Cost: O(n log n) for
    /// n vertices.
    ///
    /// ```
    /// use boundfit_exact::{Interval, Rational};
    /// use boundfit_geometry::{Inequality, Polyhedron};
    /// use boundfit_questions::{Goal, Next};
    ///
    /// // Readings 0 at x = 0 and 2 at x = 2, each known to 1/2.
    /// let row = |a1: i64, a2: i64, b: i64| Inequality::new(a1.into(), a2.into(), Rational::from(b).half());
    /// let rows = [row(0, 1, 1), row(0, -1, 1), row(2, 1, 5), row(-2, -1, -3)];
    /// let set = Polyhedron::intersect(rows.into_iter().collect());
    /// let next = Next::new(&set, Rational::ratio(1, 2)).unwrap();
    /// assert_eq!(next.unsure(), Interval::around(&Rational::one(), &Rational::one()));
    /// // A reading at 4 leaves half of the slope's interval at most.
    /// let best = next.best(Goal::Theta1, [&Rational::zero(), &Rational::from(4)]);
    /// assert_eq!((best.now, best.at), (Some(Rational::one()), vec![Rational::from(4)]));
    /// assert_eq!(best.worst, Some(Rational::ratio(1, 2)));
    /// ```
    pub fn new(set: &'a Polyhedron, epsilon: Rational) -> Option<Self> {
        let corridor = Corridor::new(set)?;
        let region = set.region();
        let directions: Vec<Direction> = region.rays().into_iter().chain(region.lines()).collect();
        let directions: Vec<[Rational; 2]> =
            directions.iter().map(|own| [Rational::from(own.dx()), Rational::from(own.dy())]).collect();
        let shape = match directions.as_slice() {
            [] => Shape::Bounded(Width::of(&corridor)),
            [along, others @ ..] => {
                let is_parallel = |other: &[Rational; 2]| &along[0] * &other[1] == &along[1] * &other[0];
                let across = set.width(&[-&along[1], along[0].clone()]);
                match across.filter(|_| others.iter().all(is_parallel)) {
                    Some(across) => Shape::Along { along: along.clone(), across },
                    None => Shape::Plane,
                }
            }
        };
        Some(Next { set, epsilon, shape })
    }

    /// The error bound of the reading.
    pub fn epsilon(&self) -> &Rational {
        &self.epsilon
    }

    /// Returns the distance of the lines from each other at x; `None` without end. Exact. Cost: logarithmic.
    pub fn width(&self, x: &Rational) -> Option<Rational> {
        match &self.shape {
            Shape::Bounded(width) => Some(width.at(x)),
            Shape::Along { along, across } if slope(along, x).is_zero() => {
                across.checked_div(&along[0].abs())
            }
            _ => None,
        }
    }

    /// Returns the x where the width has corners, ascending.
    pub fn breaks(&self) -> &[Rational] {
        match &self.shape {
            Shape::Bounded(width) => width.breaks(),
            _ => &[],
        }
    }

    /// The x where the lines are at most this far apart; `None` where there are none.
    fn no_wider_than(&self, most: &Rational) -> Option<Interval> {
        match &self.shape {
            Shape::Bounded(width) => width.at_most(most),
            Shape::Along { along, .. } => {
                let x = (-&along[1]).checked_div(&along[0])?;
                let is_narrow = self.width(&x).is_some_and(|width| width <= *most);
                Interval::around(&x, &Rational::zero()).filter(|_| is_narrow)
            }
            Shape::Plane => None,
        }
    }

    /// The x where a reading may leave the set as it is; at all others it certainly makes it smaller. `None` where there are no such
    /// x; an interval without ends has all. Exact. Cost: linear in the number of vertices.
    pub fn unsure(&self) -> Option<Interval> {
        self.no_wider_than(&self.twice())
    }

    /// Returns the present value of a goal; `None` without end. Exact.
    pub fn now(&self, goal: Goal) -> Option<Rational> {
        let (zero, one) = (Rational::zero, Rational::one);
        match goal {
            Goal::Theta1 => self.set.width(&[one(), zero()]),
            Goal::Theta2 => self.set.width(&[zero(), one()]),
            Goal::Area => self.set.region().area(),
        }
    }

    /// Returns the value of a goal after the worst outcome of a reading at x, or its limit; `None` without end.
    /// Exact. Cost: linear in the number n of vertices, of the area O(n log n).
    pub fn worst(&self, goal: Goal, x: &Rational) -> Option<Rational> {
        match &self.shape {
            Shape::Bounded(width) if width.at(x) <= self.twice() => self.now(goal),
            Shape::Bounded(width) => Some(match goal {
                Goal::Theta1 => width.longest(0, x, &self.twice()),
                Goal::Theta2 => width.longest(1, x, &self.twice()),
                Goal::Area => worst_area(self.set.region(), x, &self.epsilon),
            }),
            Shape::Along { along, across } => self.worst_along(goal, x, along, across),
            Shape::Plane => match goal {
                Goal::Theta2 if x.is_zero() => Some(self.twice()),
                Goal::Area if self.epsilon.is_zero() => Some(Rational::zero()),
                _ => None,
            },
        }
    }

    /// The best x of a range, its ends included, the lower one first. Exact.
    pub fn best(&self, goal: Goal, [lower, upper]: [&Rational; 2]) -> Best {
        let zero = Rational::zero();
        let middle = (goal == Goal::Theta2 && *lower < zero && zero < *upper).then_some(&zero);
        let mut places: Vec<&Rational> = [Some(lower), middle, Some(upper)].into_iter().flatten().collect();
        places.dedup();
        let now = self.now(goal);
        let (mut worst, mut at) = (now.clone(), Vec::new());
        for x in places {
            let own = self.worst(goal, x);
            match is_less(&own, &worst) {
                true => (worst, at) = (own, vec![x.clone()]),
                false if own == worst && !at.is_empty() => at.push(x.clone()),
                false => {}
            }
        }
        Best { goal, now, worst, at }
    }

    /// Returns `true` if a goal is omitted because the fraction of its area would be too long.
    pub fn is_too_long(&self, goal: Goal) -> bool {
        goal == Goal::Area && self.set.region().vertices().len() > Next::MOST_CORNERS
    }

    fn twice(&self) -> Rational {
        &self.epsilon + &self.epsilon
    }

    /// The worst of a reading about a set that goes on along a line: what is left is at most a parallelogram of two strips, unless
    /// these are parallel.
    fn worst_along(
        &self,
        goal: Goal,
        x: &Rational,
        along: &[Rational; 2],
        across: &Rational,
    ) -> Option<Rational> {
        let (slope, twice) = (slope(along, x).abs(), self.twice());
        let over = match goal {
            Goal::Theta1 => across + along[0].abs() * &twice,
            Goal::Theta2 => x.abs() * across + along[1].abs() * &twice,
            Goal::Area => across * &twice,
        };
        match goal {
            _ if !slope.is_zero() => over.checked_div(&slope),
            // Only θ1 goes on, and the reading measures θ2.
            Goal::Theta2 if x.is_zero() => Some(twice.min(across.checked_div(&along[0].abs())?)),
            Goal::Area => over.is_zero().then_some(over),
            _ => None,
        }
    }
}

/// Returns the growth of the value at x along a direction.
fn slope(along: &[Rational; 2], x: &Rational) -> Rational {
    &along[0] * x + &along[1]
}

/// Returns whether one is less than the other, where `None` has no end.
fn is_less(one: &Option<Rational>, other: &Option<Rational>) -> bool {
    one.as_ref().is_some_and(|one| other.as_ref().is_none_or(|other| one < other))
}
