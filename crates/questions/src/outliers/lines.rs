//! The numbers of readings that are missed along every boundary.

use std::cmp::Ordering;
use std::collections::HashMap;

use boundfit_exact::{Fraction, Integer, Sign};
use boundfit_geometry::constructions::{foot, meet};
use boundfit_geometry::{Constraint, HalfPlane, Point};

use super::kept::Kept;
use super::near::FORBIDDEN;

/// A boundary, and how many readings are missed beyond it.
pub(super) struct Line {
    /// The side `a·θ ≤ b` with a2 > 0, or a2 = 0 and a1 > 0.
    pub(super) below: HalfPlane,
    /// The number of readings missed where `a·θ > b`.
    missed_above: u64,
    /// The number of readings missed where `a·θ < b`.
    missed_below: u64,
}

/// The different boundaries of rows and conditions.
pub(super) struct Lines(pub(super) Vec<Line>);

/// A part of a boundary between two crossings, by their places or otherwise, or from one without end. It goes from small to large θ1 or, where that is the
/// same, θ2.
pub(super) struct Edge<P = Place> {
    /// The boundary that it is a part of.
    pub(super) line: u32,
    /// The places where the stretch begins and ends.
    pub(super) ends: [Option<P>; 2],
    /// The number of readings missed on the stretch.
    pub(super) on: u64,
    /// The number of readings missed to the left of the stretch.
    pub(super) left: u64,
    /// The number of readings missed to the right of the stretch.
    pub(super) right: u64,
    /// `true` if the cell to the left has its smallest corner, by θ1 and then θ2, where the edge begins.
    pub(super) is_first_of_cell: bool,
}

/// A crossing, by the two first of the boundaries that go through it.
pub(super) type Place = [u32; 2];

/// Receives crossings and edges.
pub(super) trait Visitor {
    /// A crossing, told once, and how many are missed there.
    fn crossing(&mut self, place: Place, missed: u64);
    /// An edge.
    fn edge(&mut self, edge: Edge);
    /// Returns whether it has room for what comes next: the walk ends where it has none.
    fn has_room(&self) -> bool {
        true
    }
}

/// The place where a boundary crosses the one that is walked along.
struct Crossing {
    /// The place of the crossing along the way.
    place: Fraction,
    /// The double nearest to it. Rounding keeps the order: where these differ, the places do.
    nearest: f64,
    line: u32,
    /// The numbers of readings missed beyond the crossing boundary, before the crossing and behind.
    before: u64,
    behind: u64,
    /// `true` if it is steeper than the boundary walked along.
    is_steeper: bool,
}

impl Lines {
    /// Collects the boundaries of some rows, and of all conditions.
    pub(super) fn new(kept: &Kept, rows: &[u32]) -> Self {
        let mut lines: Vec<Line> = Vec::new();
        let mut places: HashMap<HalfPlane, usize> = HashMap::new();
        let mut add = |half_plane: &HalfPlane, weight: u64| {
            let is_below =
                half_plane.a2().is_positive() || (half_plane.a2().is_zero() && half_plane.a1().is_positive());
            let below = if is_below { half_plane.clone() } else { half_plane.opposite() };
            let place = *places.entry(below.clone()).or_insert_with(|| {
                lines.push(Line { below, missed_above: 0, missed_below: 0 });
                lines.len() - 1
            });
            let line = &mut lines[place];
            *(if is_below { &mut line.missed_above } else { &mut line.missed_below }) += weight;
        };
        for &row in rows {
            let row = &kept.rows[row as usize];
            row.half_planes.iter().for_each(|own| add(own, row.weight));
        }
        for condition in &kept.conditions {
            if let Constraint::HalfPlane(own) = condition.constraint() {
                add(&own, FORBIDDEN);
            }
        }
        Lines(lines)
    }

    /// Returns the number of crossings that a walk along all boundaries looks at.
    pub(super) fn steps(&self) -> u64 {
        (self.0.len() as u64).saturating_mul(self.0.len() as u64)
    }

    /// Returns whether no two of them cross.
    pub(super) fn are_parallel(&self) -> bool {
        let Some((first, more)) = self.0.split_first() else { return true };
        more.iter().all(|line| minor(&first.below, &line.below).is_zero())
    }

    /// A crossing as a point.
    pub(super) fn point(&self, [one, other]: Place) -> Point {
        let [one, other] = [one, other].map(|line| &self.0[line as usize].below);
        meet(one, other).unwrap_or_else(|| foot(one))
    }

    /// Walks along every one of them. Exact. Cost: O(m² log m), and memory for one of them at a time.
    pub(super) fn walk(&self, visitor: &mut impl Visitor) {
        let mut crossings = Vec::new();
        for line in 0..self.0.len() as u32 {
            if !visitor.has_room() {
                return;
            }
            self.walk_along(line, &mut crossings, visitor);
        }
    }

    fn walk_along(&self, own: u32, crossings: &mut Vec<Crossing>, visitor: &mut impl Visitor) {
        let line = &self.0[own as usize];
        crossings.clear();
        let mut missed = 0;
        for (other, crossed) in (0..).zip(&self.0) {
            if other == own {
                continue;
            }
            match self.crossing(own, other) {
                Some(crossing) => {
                    missed += crossing.before;
                    crossings.push(crossing);
                }
                None => missed += crossed.missed_on(&line.below),
            }
        }
        crossings.sort_unstable_by(Crossing::by_place);
        let goes_right = !line.below.a2().is_zero();
        // Where it goes to the right, what lies to the left is above.
        let [left, right] = if goes_right {
            [line.missed_above, line.missed_below]
        } else {
            [line.missed_below, line.missed_above]
        };
        let edge = |ends: [Option<Place>; 2], on: u64, is_first_of_cell: bool| Edge {
            line: own,
            ends,
            on,
            left: on + left,
            right: on + right,
            is_first_of_cell,
        };
        let (mut last, mut has_steeper) = (None, false);
        for group in crossings.chunk_by(|p, q| p.by_place(q).is_eq()) {
            let place = first_two(own, group);
            visitor.edge(edge([last, Some(place)], missed, has_steeper));
            missed -= group.iter().map(|crossing| crossing.before).sum::<u64>();
            if place[0] == own {
                visitor.crossing(place, missed);
            }
            missed += group.iter().map(|crossing| crossing.behind).sum::<u64>();
            last = Some(place);
            has_steeper = goes_right && group.iter().any(|crossing| crossing.is_steeper);
        }
        visitor.edge(edge([last, None], missed, has_steeper));
    }

    /// Returns the place where one boundary is crossed by another; `None` where they are parallel.
    fn crossing(&self, own: u32, other: u32) -> Option<Crossing> {
        let (f, crossed) = (&self.0[own as usize].below, &self.0[other as usize]);
        let g = &crossed.below;
        let weight = minor(f, g);
        if weight.is_zero() {
            return None;
        }
        let goes_right = !f.a2().is_zero();
        // Cramer's rule: θ1, or along a vertical boundary θ2.
        let above =
            if goes_right { f.b() * g.a2() - g.b() * f.a2() } else { f.a1() * g.b() - g.a1() * f.b() };
        let is_positive = weight.sign() == Sign::Positive;
        // Along (a2, -a1) the form g grows by -weight, along (0, a1) by weight.
        let grows = is_positive != goes_right;
        let [before, behind] = if grows {
            [crossed.missed_below, crossed.missed_above]
        } else {
            [crossed.missed_above, crossed.missed_below]
        };
        let place = Fraction::new(above, weight)?;
        // By slopes -a1/a2; a vertical boundary is the steepest.
        let is_steeper = g.a2().is_zero() || is_positive;
        Some(Crossing { nearest: place.to_f64(), place, line: other, before, behind, is_steeper })
    }
}

impl Crossing {
    fn by_place(&self, other: &Self) -> Ordering {
        self.nearest.total_cmp(&other.nearest).then_with(|| self.place.cmp(&other.place))
    }
}

impl Line {
    /// Returns the number of readings that miss the line along a parallel boundary.
    fn missed_on(&self, parallel: &HalfPlane) -> u64 {
        match boundfit_geometry::predicates::by_tightness(&self.below, parallel) {
            Ordering::Less => self.missed_above,
            Ordering::Equal => 0,
            Ordering::Greater => self.missed_below,
        }
    }

    /// Returns the numbers of readings missed on either side, above first.
    pub(super) fn missed(&self) -> [u64; 2] {
        [self.missed_above, self.missed_below]
    }
}

/// a1·c2 - a2·c1.
fn minor(f: &HalfPlane, g: &HalfPlane) -> Integer {
    f.a1() * g.a2() - f.a2() * g.a1()
}

/// The two first of the boundaries through a crossing.
fn first_two(own: u32, group: &[Crossing]) -> Place {
    let [mut first, mut second] = [own, u32::MAX];
    for line in group.iter().map(|crossing| crossing.line) {
        if line < first {
            (first, second) = (line, first);
        } else if line < second {
            second = line;
        }
    }
    [first, second]
}
