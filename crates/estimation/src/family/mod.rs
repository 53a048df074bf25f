//! The error bound as a coordinate: the whole family of sets FPS(s·ε), s being one factor on every error bound.
//!
//! The triples (θ, s) with θ in FPS(s·ε) are a polyhedron in space, so the family is piecewise linear in s. Between
//! two of finitely many breakpoints the same half-planes meet in the same order, and every vertex moves along a line.
//! (Parametric linear programming in the right-hand side; Gal and Nedoma, "Multiparametric linear programming",
//! *Management Science* 18, 1972.)

mod area;
mod crossing;
mod functions;
mod growing;
mod neighbours;
mod piece;
mod section;
mod shape;
mod short_areas;

use boundfit_exact::{Rational, Rounding};
use boundfit_geometry::RegionKind;

use crate::bound_name::BoundName;
use crate::minimax::Minimax;
use crate::problem::Problem;

pub use area::{AreaGrowth, MovingArea};
pub use functions::{Linear, MovingBoundary, MovingVertex};
pub use piece::Piece;
pub use section::{Section, SectionBoundary, SectionVertex};
pub use short_areas::ShortAreas;

use crossing::Crossing;
use growing::GrowingSystem;
use shape::Shape;

/// The sets FPS(s·ε) for all factors s of a range.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Family {
    least: Option<Rational>,
    breakpoints: Vec<Breakpoint>,
    pieces: Vec<Piece>,
}

/// A factor at which the shape of the set changes, or an end of the range.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Breakpoint {
    /// The factor.
    pub s: Rational,
    /// The set at this factor.
    pub section: Section,
    /// Bounds that shape the set above this factor and not below it, sorted.
    pub entering: Vec<BoundName>,
    /// Bounds that shape the set below this factor and not above it, sorted.
    pub leaving: Vec<BoundName>,
}

impl Family {
    /// The family for s from `from` to `to`. Exact. Negative factors have no meaning: the range is cut at 0; an end
    /// before the start makes a range of one factor.
    ///
    /// Cost: for each piece the number of its vertices, and a look at the half-planes between those by angle that become
    /// neighbours. Where several things happen at one vertex, or the sets are no polygons, a piece takes an intersection
    /// of all half-planes, O(N log N). For a line under a uniform error bound, only half-planes whose readings are on a
    /// hull count.
    pub fn new(problem: &Problem, from: Rational, to: Rational) -> Self {
        // No family has so many vertices.
        Family::within(problem, from, to, usize::MAX).unwrap_or_default()
    }

    /// The family as [`new`](Family::new) gives it. `None` if its sets would have more vertices together than `most_vertices`: the
    /// memory for them is never taken. Readings of a curve have a piece for each, with as many vertices.
    pub fn within(problem: &Problem, from: Rational, to: Rational, most_vertices: usize) -> Option<Self> {
        let from = from.max(Rational::zero());
        let to = to.max(from.clone());
        let system = GrowingSystem::new(problem);
        let least = if problem.measurements.has_widths() {
            let minimax = Minimax::new(&problem.measurements, &problem.conditions);
            minimax.and_then(|minimax| minimax.least_factor(problem.measurements.error_bound()))
        } else {
            // Nothing grows: all sets are the same one.
            (!system.polyhedron(&from).is_empty()).then(Rational::zero)
        };
        // Sets grow with s: empty below the least factor, never above it.
        let born = least
            .as_ref()
            .map_or_else(|| to.clone(), |least| least.clone().max(from.clone()).min(to.clone()));
        let mut found = Vec::new();
        if from < born {
            found.push((Piece::empty(from.clone(), born.clone()), None));
        }
        if least.is_some() {
            found.extend(pieces_between(&system, born, to, most_vertices)?);
        }
        let (pieces, ends): (Vec<Piece>, Vec<Option<Section>>) = found.into_iter().unzip();
        let cuts = pieces.iter().map(|piece| piece.to.clone()).zip(ends);
        let breakpoints = [(from, None)].into_iter().chain(cuts).enumerate().map(|(number, (s, section))| {
            let below = number.checked_sub(1).and_then(|below| pieces.get(below));
            let only = |some: &Piece, others: &Piece| {
                let is_new = |name: &&BoundName| others.shaped_by.binary_search(name).is_err();
                some.shaped_by.iter().filter(is_new).copied().collect()
            };
            let (entering, leaving) = match below.zip(pieces.get(number)) {
                Some((below, above)) => (only(above, below), only(below, above)),
                None => (Vec::new(), Vec::new()),
            };
            let section = section.unwrap_or_else(|| system.section(&s));
            Breakpoint { s, section, entering, leaving }
        });
        let breakpoints = breakpoints.collect();
        Some(Family { least, breakpoints, pieces })
    }

    /// s_min, the smallest factor, at least 0, that leaves a feasible parameter, in the range or not; `None` when no
    /// factor does. Exact.
    pub fn least(&self) -> Option<&Rational> {
        self.least.as_ref()
    }

    /// The ends of the range and every factor between them at which the set is born or a bound begins or ceases to
    /// shape it, ascending.
    pub fn breakpoints(&self) -> &[Breakpoint] {
        &self.breakpoints
    }

    /// Returns what lies between each breakpoint and the next: one fewer than breakpoints.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// The areas of the polygons of the family. Areas are continuous in s, so that one sum over corners gives those of all pieces.
    /// An area is `None` for other sets, and where its denominator may have more than `digits` digits. Exact. Cost: a common
    /// divisor for each corner that moves along its own line.
    pub fn short_areas(&self, digits: usize) -> ShortAreas {
        let is_polygon = |own: &Breakpoint| own.section.kind == RegionKind::Polygon;
        let breakpoints = self.breakpoints.iter().map(|own| (&own.s, is_polygon(own)));
        ShortAreas::new(&self.pieces, breakpoints, digits)
    }

    /// The set at a factor; `None` outside the range. Exact: equal to a fit with every error bound multiplied by s.
    /// Cost: linear in the number of vertices.
    pub fn at(&self, s: &Rational) -> Option<Section> {
        match self.breakpoints.binary_search_by(|breakpoint| breakpoint.s.cmp(s)) {
            Ok(found) => Some(self.breakpoints[found].section.clone()),
            Err(above) => Some(self.pieces.get(above.checked_sub(1)?)?.at(s)),
        }
    }
}

/// A decimal in the middle half between two numbers, with few digits: whatever is computed with it is then short.
fn between(from: &Rational, to: &Rational) -> Rational {
    let (middle, room) = ((from + to).half(), (to - from).half().half());
    let is_near = |decimal: &Rational| (decimal - &middle).abs() <= room;
    let mut decimals = (0..12).map(|power| middle.rounded(1 << power, Rounding::Nearest));
    decimals.find(is_near).unwrap_or(middle)
}

/// The pieces from one factor to another, ascending, each with the set at its end where that follows from it. The
/// sets between them must not be empty.
///
/// A sample in the middle of a gap shows the shape there; its half-planes tell how far that shape reaches, and often
/// the shapes behind it. What is left on both sides are smaller gaps. `None` if the sets have more vertices than
/// `most_vertices`.
fn pieces_between(
    system: &GrowingSystem,
    from: Rational,
    to: Rational,
    most_vertices: usize,
) -> Option<Vec<(Piece, Option<Section>)>> {
    let mut vertices = 0;
    let mut pieces = Vec::new();
    let mut shape = Shape::new(system);
    let mut gaps = vec![(from, to)];
    while let Some((from, to)) = gaps.pop() {
        if from >= to {
            continue;
        }
        let sample = between(&from, &to);
        let polyhedron = system.polyhedron(&sample);
        let mut spokes = polyhedron.irredundant_by_angle().to_vec();
        shape.sort(&mut spokes);
        let reach = shape.reach(&spokes);
        debug_assert!(reach.from <= sample, "a shape that is not there at its own sample");
        let starts = reach.from.max(from.clone());
        let mut ends = reach.to.map_or_else(|| to.clone(), |end| end.min(to.clone()));
        // A sample that is itself a breakpoint has no piece around it: starts and ends are both there, or one is.
        if starts >= sample || ends <= sample {
            gaps.extend([(from, sample.clone()), (sample, to)]);
            continue;
        }
        let mut next =
            Some(Piece::around(&mut shape, &polyhedron, &spokes).within(starts.clone(), ends.clone()));
        while let Some(piece) = next.take() {
            let crossing = Crossing::new(&mut shape, &piece, &spokes);
            let (section, behind) = crossing.map(|crossing| (crossing.section, crossing.spokes)).unzip();
            // The set at its end has about as many.
            vertices += 2 * piece.vertices.len();
            pieces.push((piece, section));
            if vertices > most_vertices {
                return None;
            }
            if let Some(behind) = behind.filter(|_| ends < to)
                && let Some(piece) = Piece::polygon(&mut shape, &behind)
            {
                spokes = behind;
                let reach = shape.reach(&spokes);
                debug_assert!(reach.from == ends, "a shape that does not begin where the one before it ends");
                let starts = ends;
                ends = reach.to.map_or_else(|| to.clone(), |end| end.min(to.clone()));
                next = Some(piece.within(starts, ends.clone()));
            }
        }
        gaps.extend([(from, starts), (ends, to)]);
    }
    pieces.sort_by(|(piece, _), (other, _)| piece.from.cmp(&other.from));
    Some(pieces)
}
