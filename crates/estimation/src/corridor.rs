//! The corridor of a line model: where the lines of all feasible parameters run.
//!
//! At an abscissa x the feasible lines reach from min θ1·x + θ2 to max θ1·x + θ2 over the FPS. As functions of x,
//! these bounds are piecewise linear: the upper one is convex, the lower one concave. Each piece is the line of one
//! vertex. Pieces meet where the form (x, 1) is perpendicular to an edge.

use boundfit_exact::{Endpoint, Interval, Rational};
use boundfit_geometry::predicates::lexicographic;
use boundfit_geometry::{Hulls, Point, Polyhedron, Region, Support};

/// Both edges of the corridor.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Corridor {
    /// max θ1·x + θ2.
    pub upper: CorridorEdge,
    /// min θ1·x + θ2.
    pub lower: CorridorEdge,
}

/// One edge of a corridor: a piecewise linear function of x, exact.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CorridorEdge {
    domain: Option<Interval>,
    lines: Vec<[Rational; 2]>,
    breakpoints: Vec<Rational>,
}

impl Corridor {
    /// The corridor of a set of parameters (θ1, θ2) of lines; `None` when it is empty. Exact. Cost: O(n log n) for n
    /// vertices.
    pub fn new(polyhedron: &Polyhedron) -> Option<Self> {
        let region = polyhedron.region();
        (!region.is_empty()).then(|| Corridor {
            upper: CorridorEdge::new(polyhedron, Side::Upper),
            lower: CorridorEdge::new(polyhedron, Side::Lower),
        })
    }
}

impl CorridorEdge {
    /// The x for which the edge is finite: all for a bounded set; `None` when there are none. Exact.
    pub fn domain(&self) -> Option<&Interval> {
        self.domain.as_ref()
    }

    /// The lines (θ1, θ2) that the edge follows, by x. Each is feasible.
    pub fn lines(&self) -> &[[Rational; 2]] {
        &self.lines
    }

    /// Returns where one line gives way to the next, ascending, within the domain: one fewer than lines. Exact.
    pub fn breakpoints(&self) -> &[Rational] {
        &self.breakpoints
    }

    /// The edge at an abscissa; `None` where it is not finite. Exact. Cost: logarithmic.
    pub fn value(&self, x: &Rational) -> Option<Rational> {
        if !self.domain.as_ref()?.contains(x) {
            return None;
        }
        let [theta1, theta2] =
            self.lines.get(self.breakpoints.partition_point(|breakpoint| breakpoint < x))?;
        Some(theta1 * x + theta2)
    }

    fn new(polyhedron: &Polyhedron, side: Side) -> Self {
        let region = polyhedron.region();
        if region.vertices().is_empty() {
            CorridorEdge::of_parallels(polyhedron, side)
        } else {
            CorridorEdge::of_vertices(region, side)
        }
    }

    /// The edge of a set with vertices: its upper or lower hull, as far as its rays let it be finite.
    fn of_vertices(region: &Region, side: Side) -> Self {
        let Some(domain) = domain(region, side) else { return CorridorEdge::nowhere() };
        let mut points: Vec<Point> = region.vertices().iter().map(|vertex| vertex.point().clone()).collect();
        points.sort_by(lexicographic);
        let Hulls { mut lower, upper } = Hulls::of_sorted(&points);
        // The form (x, 1) turns over the upper hull from left to right as x grows, over the lower one from right to left.
        lower.reverse();
        let chain = match side {
            Side::Upper => upper,
            Side::Lower => lower,
        };
        let mut lines: Vec<[Rational; 2]> = chain.into_iter().map(|k| points[k].coordinates()).collect();
        let mut breakpoints: Vec<Rational> =
            lines.windows(2).map(|pair| crossing(&pair[0], &pair[1])).collect();
        if let Endpoint::Finite(from) = domain.lower() {
            let before = breakpoints.partition_point(|breakpoint| breakpoint <= from);
            breakpoints.drain(..before);
            lines.drain(..before);
        }
        if let Endpoint::Finite(to) = domain.upper() {
            let kept = breakpoints.partition_point(|breakpoint| breakpoint < to);
            breakpoints.truncate(kept);
            lines.truncate(kept + 1);
        }
        CorridorEdge { domain: Some(domain), lines, breakpoints }
    }

    /// The edge of a set with a line in it: finite at most where the form (x, 1) is constant along that line.
    fn of_parallels(polyhedron: &Polyhedron, side: Side) -> Self {
        let finite = || {
            let [line] = <[_; 1]>::try_from(polyhedron.region().lines()).ok()?;
            let x = (-Rational::from(line.dy())).checked_div(&Rational::from(line.dx()))?;
            let form = match side {
                Side::Upper => [x.clone(), Rational::one()],
                Side::Lower => [-&x, -Rational::one()],
            };
            let Support::Bounded { proof, .. } = polyhedron.support(&form) else { return None };
            let domain = Interval::around(&x, &Rational::zero());
            Some(CorridorEdge {
                domain,
                lines: vec![proof.attained_at.coordinates()],
                breakpoints: Vec::new(),
            })
        };
        finite().unwrap_or_else(CorridorEdge::nowhere)
    }

    fn nowhere() -> Self {
        CorridorEdge { domain: None, lines: Vec::new(), breakpoints: Vec::new() }
    }
}

#[derive(Clone, Copy)]
enum Side {
    Upper,
    Lower,
}

/// Returns where the form (x, 1) does not grow (upper) or fall (lower) along any ray of the region.
fn domain(region: &Region, side: Side) -> Option<Interval> {
    let (mut from, mut to): (Option<Rational>, Option<Rational>) = (None, None);
    for ray in region.rays() {
        let (dx, dy) = match side {
            Side::Upper => (Rational::from(ray.dx()), Rational::from(ray.dy())),
            Side::Lower => (-Rational::from(ray.dx()), -Rational::from(ray.dy())),
        };
        // dx·x + dy ≤ 0
        match (-&dy).checked_div(&dx) {
            Some(end) if dx.is_positive() => {
                to = Some(to.map_or_else(|| end.clone(), |old: Rational| old.min(end.clone())));
            }
            Some(end) => from = Some(from.map_or_else(|| end.clone(), |old| old.max(end.clone()))),
            None if dy.is_positive() => return None,
            None => {}
        }
    }
    let end = |value: Option<Rational>| value.map_or(Endpoint::Unbounded, Endpoint::Finite);
    Interval::new(end(from), end(to))
}

/// The x at which two lines of different slope meet.
fn crossing(line: &[Rational; 2], other: &[Rational; 2]) -> Rational {
    (&line[1] - &other[1]).checked_div(&(&other[0] - &line[0])).unwrap_or_default()
}
