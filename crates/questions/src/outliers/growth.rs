//! The growth of the q-relaxed set with q.

use std::collections::HashMap;
use std::ops::RangeInclusive;

use boundfit_exact::{Endpoint, Fraction, Integer, Interval, LongSum, Rational};
use boundfit_geometry::predicates::by_tightness;
use boundfit_geometry::{LayerOf, Point};

use super::kept::Kept;
use super::lines::{Edge, Line, Lines, Place, Visitor};
use super::near::FORBIDDEN;
use super::{NoOutliers, OutlierLimits, triangle};

/// The q-relaxed set for one q: all θ that miss at most so many readings.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Growth {
    /// q.
    pub most: usize,
    /// The number of its pieces; parts that touch in a point are one.
    pub pieces: usize,
    /// The number of holes of all pieces together.
    pub holes: usize,
    /// The ranges of both parameters over all pieces; `None` when there is nothing.
    pub pui: Option<[Interval; 2]>,
    /// The area; `None` when it is infinite.
    pub area: Option<LongSum>,
}

impl Growth {
    /// Nothing agrees with so many readings.
    pub(super) fn none(most: usize) -> Self {
        Growth { most, pieces: 0, holes: 0, pui: None, area: Some(LongSum::default()) }
    }
}

/// The number of crossings that are kept in memory, some 150 bytes each.
const MOST_KEPT: usize = 100_000;

/// The growth from one q to another. The rows that no θ meets count in every q.
pub(super) fn of(
    kept: &Kept,
    from: usize,
    to: usize,
    limits: &OutlierLimits,
) -> Result<Vec<Growth>, NoOutliers> {
    let never = kept.never.len();
    let most = to.saturating_sub(never);
    let rows = kept.in_layers(LayerOf::Corners, most);
    let lines = Lines::new(kept, &rows);
    if lines.steps() > limits.steps {
        return Err(NoOutliers::GrowthSteps { needed: lines.steps() });
    }
    let within = (from - never) as u64..=(to - never) as u64;
    let with_all = |set: Growth| Growth { most: set.most + never, ..set };
    if lines.are_parallel() {
        return Ok(within.map(|q| with_all(along_parallels(&lines, q))).collect());
    }
    let mut near = Near { most: most as u64, places: HashMap::new(), missed: Vec::new(), edges: Vec::new() };
    lines.walk(&mut near);
    if near.missed.len() > MOST_KEPT {
        return Err(NoOutliers::Corners);
    }
    Ok(near.grown(&lines, within).into_iter().map(with_all).collect())
}

/// The crossings and edges on which at most so many are missed.
struct Near {
    most: u64,
    places: HashMap<Place, u32>,
    /// The number of readings that are missed at each crossing.
    missed: Vec<u64>,
    /// Edges between numbered crossings.
    edges: Vec<Edge<u32>>,
}

impl Near {
    /// The number of a crossing, while there is room for it.
    fn number(&mut self, place: Place) -> Option<u32> {
        let next = self.missed.len() as u32;
        // One more than are kept tells that there are too many.
        if self.missed.len() > MOST_KEPT {
            return None;
        }
        let number = *self.places.entry(place).or_insert(next);
        if number == next {
            self.missed.push(FORBIDDEN);
        }
        Some(number)
    }

    fn points(&self, lines: &Lines) -> Vec<Point> {
        let mut points = vec![Point::origin(); self.missed.len()];
        for (&place, &number) in &self.places {
            points[number as usize] = lines.point(place);
        }
        points
    }

    /// The sets from one q to another, in which so many of the rows may be missed that can be met. Each crossing and edge comes
    /// in once.
    fn grown(&mut self, lines: &Lines, within: RangeInclusive<u64>) -> Vec<Growth> {
        self.edges.sort_by_key(|edge| edge.on);
        let points = self.points(lines);
        let mut crossings: Vec<usize> = (0..self.missed.len()).collect();
        crossings.sort_by_key(|&number| self.missed[number]);
        let mut joined = Joined::new(self.missed.len());
        let (mut pieces, mut edges, mut rays) = (0, 0, 0);
        let (mut crossings, mut coming) = (crossings.into_iter().peekable(), self.edges.iter().peekable());
        let (mut corners, mut reach) = (0, Reach::default());
        let cells = self.cells(lines);
        let areas = self.areas(&points, &within);
        let mut sets = Vec::new();
        for (q, area) in within.zip(areas) {
            while let Some(number) = crossings.next_if(|&number| self.missed[number] <= q) {
                reach.add(&points[number]);
                corners += 1;
                pieces += 1;
            }
            while let Some(edge) = coming.next_if(|edge| edge.on <= q) {
                edges += 1;
                if let [Some(from), Some(to)] = edge.ends {
                    pieces -= usize::from(joined.join(from as usize, to as usize));
                }
                for (place, _) in edge.ends.iter().enumerate().filter(|(_, end)| end.is_none()) {
                    rays += 1;
                    reach.add_direction(&lines.0[edge.line as usize], place == 1);
                }
            }
            // For a set that is drawn together to its bounded part, pieces less holes are corners less edges and
            // cells.
            let bounded_cells = cells.partition_point(|&missed| missed <= q);
            let holes = (pieces + edges - rays) - (corners + bounded_cells);
            sets.push(Growth { most: q as usize, pieces, holes, pui: reach.intervals(), area });
        }
        sets
    }

    /// Returns the number of readings missed in each bounded cell, ascending.
    fn cells(&self, lines: &Lines) -> Vec<u64> {
        // A cell without end that has a first corner lies to the left of one of the ways to the right, but for the last.
        let last = lines.last_to_the_right();
        let is_endless = |edge: &&Edge<u32>| edge.ends[1].is_none() && Some(edge.line) != last;
        let mut endless: HashMap<u64, usize> = HashMap::new();
        self.edges.iter().filter(is_endless).for_each(|edge| *endless.entry(edge.left).or_default() += 1);
        let first = self.edges.iter().filter(|edge| edge.is_first_of_cell).map(|edge| edge.left);
        let is_bounded = |missed: &u64| match endless.get_mut(missed) {
            Some(count) if *count > 0 => {
                *count -= 1;
                false
            }
            _ => true,
        };
        let mut cells: Vec<u64> = first.filter(is_bounded).collect();
        cells.sort_unstable();
        cells
    }

    /// The areas, by Green's theorem along the edges that have the set on one side.
    fn areas(&self, points: &[Point], within: &RangeInclusive<u64>) -> Vec<Option<LongSum>> {
        let (from, to) = (*within.start(), *within.end());
        let mut terms: Vec<Vec<Fraction>> = (from..=to).map(|_| Vec::new()).collect();
        let mut infinite = u64::MAX;
        for edge in &self.edges {
            let (least, most) = (edge.left.min(edge.right), edge.left.max(edge.right));
            let [Some(start), Some(end)] = edge.ends else {
                infinite = infinite.min(least);
                continue;
            };
            for q in least.max(from)..most.min(to + 1) {
                let triangle = triangle(&points[start as usize], &points[end as usize], edge.right <= q);
                terms[(q - from) as usize].extend(triangle);
            }
        }
        (from..).zip(terms).map(|(q, terms)| (q < infinite).then(|| terms.into_iter().collect())).collect()
    }
}

impl Visitor for Near {
    fn crossing(&mut self, place: Place, missed: u64) {
        if missed <= self.most
            && let Some(number) = self.number(place)
        {
            self.missed[number as usize] = missed;
        }
    }

    fn edge(&mut self, edge: Edge) {
        let Edge { line, ends, on, left, right, is_first_of_cell } = edge;
        if on > self.most {
            return;
        }
        let numbers = ends.map(|end| end.map(|end| self.number(end)));
        let has_room = numbers.iter().flatten().all(Option::is_some);
        if has_room {
            let ends = numbers.map(Option::flatten);
            self.edges.push(Edge { line, ends, on, left, right, is_first_of_cell });
        }
    }
    fn has_room(&self) -> bool {
        self.missed.len() <= MOST_KEPT
    }
}

impl Lines {
    /// The one that goes on to the right as the last, counter-clockwise.
    fn last_to_the_right(&self) -> Option<u32> {
        let lines = (0..).zip(&self.0);
        let last = lines.max_by(|(_, one), (_, other)| {
            // By the angle of the way: a vertical boundary goes up and comes last.
            let (f, g) = (&one.below, &other.below);
            let is_vertical = f.a2().is_zero().cmp(&g.a2().is_zero());
            let steeper = || Integer::compare([(&g.a1(), &f.a2())], [(&f.a1(), &g.a2())]);
            // Among parallel boundaries it is the leftmost, which is the uppermost unless they are vertical.
            let leftmost = || {
                let upper = by_tightness(f, g);
                if f.a2().is_zero() { upper.reverse() } else { upper }
            };
            is_vertical.then_with(steeper).then_with(leftmost)
        });
        last.map(|(number, _)| number)
    }
}

/// The ranges of both parameters.
#[derive(Default)]
struct Reach {
    ends: [Option<[Rational; 2]>; 2],
    is_endless: [[bool; 2]; 2],
    is_anything: bool,
}

impl Reach {
    fn add(&mut self, point: &Point) {
        let [theta1, theta2] = point.coordinates();
        self.add_value(0, theta1);
        self.add_value(1, theta2);
    }

    fn add_value(&mut self, axis: usize, value: Rational) {
        self.is_anything = true;
        match &mut self.ends[axis] {
            Some([lower, _]) if value < *lower => *lower = value,
            Some([_, upper]) if value > *upper => *upper = value,
            Some(_) => {}
            empty => *empty = Some([value.clone(), value]),
        }
    }

    /// A way along a boundary without end, to the right or to the left.
    fn add_direction(&mut self, line: &Line, to_the_right: bool) {
        self.is_anything = true;
        let (a1, a2) = (line.below.a1(), line.below.a2());
        if a2.is_zero() {
            self.is_endless[1][usize::from(to_the_right)] = true;
            return;
        }
        self.is_endless[0][usize::from(to_the_right)] = true;
        if !a1.is_zero() {
            self.is_endless[1][usize::from(to_the_right == a1.is_negative())] = true;
        }
    }

    fn intervals(&self) -> Option<[Interval; 2]> {
        let Reach { ends, is_endless, is_anything } = self;
        if !*is_anything {
            return None;
        }
        let end = |axis: usize, side: usize| -> Endpoint {
            let value = ends[axis].as_ref().map(|ends| ends[side].clone());
            value.filter(|_| !is_endless[axis][side]).into()
        };
        let [first, second] = [0, 1].map(|axis| Interval::new(end(axis, 0), end(axis, 1)));
        Some([first?, second?])
    }
}

/// The crossings that are joined by edges.
struct Joined(Vec<usize>);

impl Joined {
    fn new(count: usize) -> Self {
        Joined((0..count).collect())
    }

    fn root(&mut self, mut number: usize) -> usize {
        while self.0[number] != number {
            self.0[number] = self.0[self.0[number]];
            number = self.0[number];
        }
        number
    }

    /// Joins two, and tells whether they were apart.
    fn join(&mut self, one: usize, other: usize) -> bool {
        let (one, other) = (self.root(one), self.root(other));
        self.0[one] = other;
        one != other
    }
}

/// Returns the set where no two boundaries cross: strips between them.
fn along_parallels(lines: &Lines, within: u64) -> Growth {
    let most = within as usize;
    let mut sorted: Vec<&Line> = lines.0.iter().collect();
    sorted.sort_by(|one, other| by_tightness(&one.below, &other.below));
    let Some(first) = sorted.first() else {
        let everything = || Interval::new(Endpoint::Unbounded, Endpoint::Unbounded);
        let pui = everything().zip(everything()).map(|(first, second)| [first, second]);
        return Growth { most, pieces: 1, holes: 0, pui, area: None };
    };
    // Missed below the first, then on each and above it.
    let mut missed: u64 = sorted.iter().map(|line| line.missed()[1]).sum();
    let mut reach = Reach::default();
    let axis = match (first.below.a1().is_zero(), first.below.a2().is_zero()) {
        (true, _) => Some(1),
        (_, true) => Some(0),
        _ => None,
    };
    let (mut pieces, mut is_infinite, mut is_joined) = (0, false, missed <= within);
    if let Some(axis) = axis.filter(|_| is_joined) {
        reach.is_endless[axis][0] = true;
    }
    is_infinite |= is_joined;
    for line in &sorted {
        let [above, below] = line.missed();
        missed -= below;
        if missed <= within {
            pieces += usize::from(!is_joined || pieces == 0);
            reach.add_direction(line, true);
            reach.add_direction(line, false);
            if let Some(axis) = axis {
                let a = if axis == 0 { line.below.a1() } else { line.below.a2() };
                let value = Rational::new(line.below.b(), a).unwrap_or_default();
                reach.add_value(axis, value);
            }
        }
        missed += above;
        is_joined = missed <= within;
        is_infinite |= is_joined;
    }
    if let Some(axis) = axis.filter(|_| is_joined) {
        reach.is_endless[axis][1] = true;
    }
    let area = (!is_infinite).then(LongSum::default);
    Growth { most, pieces, holes: 0, pui: reach.intervals(), area }
}
