//! Which readings of a line can bound anything, from the two hulls of the readings, and ε_min.
//!
//! A line within ε of every reading passes above the upper hull of (x, y - ε) and below the lower hull of (x, y + ε), so
//! the smallest ε is half of the largest vertical distance between the upper and the lower hull of (x, y). It is found
//! between a vertex of one hull and an edge of the other, and those three readings prove it.

use std::cmp::Ordering;

use boundfit_exact::{Integer, Rational, Sign};
use boundfit_geometry::grid::{GridPoint, touching_of_columns};
use boundfit_geometry::predicates::{by_theta1, lexicographic, orientation};
use boundfit_geometry::{Hulls, Point};

use crate::grid::{Column, Grid};
use crate::measurements::Measurement;

/// From so many readings on, those inside are discarded before the others are sorted.
const FEWEST_TO_FILTER: usize = 64;

/// The readings on the two hulls of (x, y), as positions among the rows.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Extremes {
    /// The readings that can have an active bound: those on a hull, those within its edges and repeated ones included,
    /// ascending. Under a uniform error bound, however large, no other reading has one.
    pub(crate) touching: Vec<Touching>,
    /// The largest vertical distance between the hulls; `None` without readings.
    pub(crate) widest: Option<Gap>,
    /// The corners of both hulls, ascending.
    pub(crate) corners: Vec<usize>,
}

/// A reading on a hull.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Touching {
    pub(crate) position: usize,
    /// On the lower hull: its upper bound can be active.
    pub(crate) lower: bool,
    /// On the upper hull: its lower bound can be active.
    pub(crate) upper: bool,
}

/// A corner of one hull and the edge of the other hull above or below it; both ends of the edge are the same where the
/// corner is at an end of the other hull.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Gap {
    pub(crate) corner: usize,
    pub(crate) edge: [usize; 2],
    pub(crate) corner_is_lower: bool,
}

impl Extremes {
    /// The extremes of the readings of a line. Exact. Cost: O(N log N).
    pub(crate) fn new(rows: &[Measurement], grid: Option<&Grid>) -> Self {
        grid.map_or_else(|| Extremes::in_general(rows), Extremes::on_grid)
    }

    /// On machine integers: the coordinates of a grid are small enough for every decision.
    pub(crate) fn on_grid(grid: &Grid) -> Self {
        Extremes::of_columns(&grid.phi1, &grid.response)
    }

    fn of_columns(x: &Column, y: &Column) -> Self {
        let (x, y) = (&x.mantissas, &y.mantissas);
        if x.len() >= FEWEST_TO_FILTER {
            return Extremes::of_sorted(&touching_of_columns(x, y, 0));
        }
        let mut points: Vec<GridPoint> =
            (0..).zip(x.iter().zip(y)).map(|(id, (&x, &y))| GridPoint { x, y, id }).collect();
        points.sort_unstable();
        Extremes::of_sorted(&points)
    }

    /// For numbers of any size.
    pub(crate) fn in_general(rows: &[Measurement]) -> Self {
        let mut points: Vec<(Point, usize)> = rows
            .iter()
            .enumerate()
            .map(|(position, row)| (Point::new(&row.regressor[0], &row.response), position))
            .collect();
        points.sort_by(|p, q| lexicographic(&p.0, &q.0).then(p.1.cmp(&q.1)));
        Extremes::of_sorted(&points)
    }

    /// From at least the readings that touch a hull, sorted by x, then by y, then by position.
    fn of_sorted<P: Place>(points: &[P]) -> Self {
        let Hulls { lower, upper } = Hulls::by(
            points.len(),
            |p, q| points[p].by_x(&points[q]).is_eq(),
            |p, q, r| points[p].orientation(&points[q], &points[r]),
        );
        let (on_lower, on_upper) = (on_hull(points, &lower), on_hull(points, &upper));
        let mut touching: Vec<Touching> = points
            .iter()
            .zip(on_lower.into_iter().zip(on_upper))
            .filter(|(_, (lower, upper))| *lower || *upper)
            .map(|(point, (lower, upper))| Touching { position: point.position(), lower, upper })
            .collect();
        touching.sort_unstable_by_key(|touching| touching.position);
        let positions_of =
            |hull: &[usize]| -> Vec<usize> { hull.iter().map(|&k| points[k].position()).collect() };
        let mut corners = positions_of(&lower);
        corners.extend(positions_of(&upper));
        corners.sort_unstable();
        corners.dedup();
        Extremes { touching, widest: widest(points, &lower, &upper), corners }
    }
}

/// Positions of the readings of a line on either hull of (x, y), ascending; see [`Extremes::touching`]. Exact.
/// Cost: O(N log N).
pub(crate) fn touching_a_hull(rows: &[Measurement]) -> Vec<usize> {
    let columns = Column::new(rows.iter().map(|row| &row.regressor[0]))
        .zip(Column::new(rows.iter().map(|row| &row.response)));
    let extremes = columns.map_or_else(|| Extremes::in_general(rows), |(x, y)| Extremes::of_columns(&x, &y));
    extremes.touching.iter().map(|touching| touching.position).collect()
}

/// A reading of a line as a point of the plane of x and y.
trait Place {
    fn position(&self) -> usize;
    fn by_x(&self, other: &Self) -> Ordering;
    fn is_same(&self, other: &Self) -> bool;
    /// On which side of the line through two points, in that order, a third lies.
    fn orientation(&self, second: &Self, third: &Self) -> Sign;
    /// The vertical distance, not negative, from the point to the line through two others, or to the one point if they are
    /// the same; in any unit that is the same for all points.
    fn distance(&self, edge: [&Self; 2]) -> Fraction;
}

/// A number as `numerator / denominator`, `denominator > 0`, not reduced: it is only ever compared.
struct Fraction {
    numerator: Integer,
    denominator: Integer,
}

impl Fraction {
    fn is_less_than(&self, other: &Self) -> bool {
        &self.numerator * &other.denominator < &other.numerator * &self.denominator
    }
}

impl Place for GridPoint {
    fn position(&self) -> usize {
        // Identifiers are positions in a list that is in memory.
        self.id as usize
    }

    fn by_x(&self, other: &Self) -> Ordering {
        self.x.cmp(&other.x)
    }

    fn is_same(&self, other: &Self) -> bool {
        (self.x, self.y) == (other.x, other.y)
    }

    fn orientation(&self, second: &Self, third: &Self) -> Sign {
        cross(self, second, third).cmp(&0).into()
    }

    fn distance(&self, [left, right]: [&Self; 2]) -> Fraction {
        if left.x == right.x {
            return Fraction {
                numerator: Integer::from(self.y.abs_diff(left.y)),
                denominator: Integer::one(),
            };
        }
        let area = cross(left, right, self).unsigned_abs();
        Fraction { numerator: Integer::from(area), denominator: Integer::from(right.x - left.x) }
    }
}

/// The cross product of two differences from `p`. Coordinates of a grid are below 2⁶², so that differences fit into 64
/// bits, products into 127 and their difference into 128.
fn cross(p: &GridPoint, q: &GridPoint, r: &GridPoint) -> i128 {
    let product = |left: i64, right: i64| i128::from(left) * i128::from(right);
    product(q.x - p.x, r.y - p.y) - product(q.y - p.y, r.x - p.x)
}

impl Place for (Point, usize) {
    fn position(&self) -> usize {
        self.1
    }

    fn by_x(&self, other: &Self) -> Ordering {
        by_theta1(&self.0, &other.0)
    }

    fn is_same(&self, other: &Self) -> bool {
        self.0 == other.0
    }

    fn orientation(&self, second: &Self, third: &Self) -> Sign {
        orientation(&self.0, &second.0, &third.0)
    }

    fn distance(&self, [left, right]: [&Self; 2]) -> Fraction {
        let [[x, y], [left_x, left_y], [right_x, right_y]] =
            [self, left, right].map(|place| place.0.coordinates());
        let slope = (right_y - &left_y).checked_div(&(right_x - &left_x)).unwrap_or_default();
        let distance = (y - left_y - slope * (x - left_x)).abs();
        Fraction { numerator: distance.numerator(), denominator: distance.denominator() }
    }
}

/// For each of some sorted points, whether it is on a hull that reaches as far in both directions.
fn on_hull<P: Place>(points: &[P], hull: &[usize]) -> Vec<bool> {
    let mut edges = Edges { points, hull, left: 0 };
    let is_on = |point: &P| {
        let [left, right] = edges.at(point);
        if left.by_x(point).is_lt() && left.by_x(right).is_lt() {
            left.orientation(right, point) == Sign::Zero
        } else {
            left.is_same(point)
        }
    };
    points.iter().map(is_on).collect()
}

/// The widest gap between the hulls: that of the first corner of the upper hull with it, by x, or else of the lower one.
fn widest<P: Place>(points: &[P], lower: &[usize], upper: &[usize]) -> Option<Gap> {
    let gaps_of = |corners: &'_ [usize], other: &'_ [usize], corner_is_lower: bool| {
        let mut widest: Option<(Fraction, Gap)> = None;
        let mut edges = Edges { points, hull: other, left: 0 };
        for &corner in corners {
            let corner = &points[corner];
            let edge = edges.at(corner);
            let distance = corner.distance(edge);
            if widest.as_ref().is_none_or(|(most, _)| most.is_less_than(&distance)) {
                let edge = edge.map(P::position);
                widest = Some((distance, Gap { corner: corner.position(), edge, corner_is_lower }));
            }
        }
        widest
    };
    let (above, below) = (gaps_of(upper, lower, false)?, gaps_of(lower, upper, true)?);
    Some(if above.0.is_less_than(&below.0) { below.1 } else { above.1 })
}

/// The edges of a hull from left to right.
struct Edges<'a, P> {
    points: &'a [P],
    hull: &'a [usize],
    left: usize,
}

impl<'a, P: Place> Edges<'a, P> {
    /// The edge above or below a point; points must come by x, and none may be left of the hull. From its right end on,
    /// both ends are that corner.
    fn at(&mut self, point: &P) -> [&'a P; 2] {
        let corner = |position: usize| self.hull.get(position).map(|&k| &self.points[k]);
        while corner(self.left + 1).is_some_and(|next| next.by_x(point).is_le()) {
            self.left += 1;
        }
        let left = &self.points[self.hull[self.left]];
        [left, corner(self.left + 1).unwrap_or(left)]
    }
}

/// ε_min with its proof.
#[derive(Debug)]
pub(crate) struct HullMinimum {
    /// ε_min.
    pub(crate) epsilon: Rational,
    /// Positions of the readings whose lower (`true`) or upper bound proves it, with multipliers that sum to 1.
    pub(crate) proof: Vec<(usize, bool, Rational)>,
    /// The minimiser, when these readings leave only one.
    pub(crate) theta: Option<[Rational; 2]>,
}

impl Gap {
    /// ε_min when no gap is wider: half of its height.
    pub(crate) fn minimum(&self, rows: &[Measurement]) -> HullMinimum {
        let Gap { corner, edge: [left, right], corner_is_lower } = *self;
        let place = |position: usize| {
            let Measurement { regressor: [x, _], response, .. } = &rows[position];
            (x, response)
        };
        let ((x, y), (left_x, left_y), (right_x, right_y)) = (place(corner), place(left), place(right));
        let run = right_x - left_x;
        let along = x - left_x;
        let weight = along.checked_div(&run).unwrap_or_default();
        let slope = (right_y - left_y).checked_div(&run);
        let rise = slope.as_ref().map_or_else(Rational::zero, |slope| slope * &along);
        let distance = y - left_y - rise;
        let epsilon = if corner_is_lower { -distance } else { distance }.half();
        let opposite = Rational::one() - &weight;
        // A reading on the upper hull pushes the line up: its lower bound is the one that counts.
        let proof = vec![
            (corner, !corner_is_lower, Rational::ratio(1, 2)),
            (left, corner_is_lower, opposite.half()),
            (right, corner_is_lower, weight.half()),
        ];
        let proof: Vec<_> = proof.into_iter().filter(|(_, _, multiplier)| !multiplier.is_zero()).collect();
        // Every minimiser keeps the greatest distance from each of these: three readings at different x leave one line, in
        // parallel to the edge.
        let theta = slope.filter(|_| proof.len() == 3).map(|slope| {
            let edge_offset = left_y - &slope * left_x;
            let offset = if corner_is_lower { edge_offset - &epsilon } else { edge_offset + &epsilon };
            [slope, offset]
        });
        HullMinimum { epsilon, proof, theta }
    }
}
