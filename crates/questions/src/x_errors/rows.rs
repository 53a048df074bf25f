//! The half-planes of one side, and what they leave at a factor on all bounds.

use std::iter;

use boundfit_estimation::{BoundName, conditions_by_name, growing_half_planes};
use boundfit_exact::Rational;
use boundfit_geometry::{Inequality, Point, Region, envelope};

use super::row::Row;
use super::{Agreement, Side, XErrorProblem, deciding};

/// The place of the least factor of some rows, seen from another factor.
pub(super) enum Seen {
    /// The least factor is larger: at most three of the rows leave nothing, nor do they at factors that are hardly
    /// larger.
    Above(Vec<usize>),
    /// The least factor is this one, with a point of a line that is left, if there is one.
    Here(Option<Point>),
    /// The least factor is smaller, with a point of a line that is left.
    Below(Point),
}

/// The rows of one side that decide at some factor, with |θ1| as a variable.
pub(super) struct SideRows {
    pub(super) side: Side,
    pub(super) names: Vec<BoundName>,
    rows: Vec<Row>,
    /// The largest λ at which no row gets stricter as the factor grows.
    top: Rational,
}

impl SideRows {
    pub(super) fn new(problem: &XErrorProblem, side: Side) -> Self {
        let is_strong = problem.agreement() == Agreement::Strong;
        let towards = |slope: &Rational| if side == Side::Falling { -slope } else { slope.clone() };
        let readings = problem.readings().flat_map(|(row, width)| {
            let of_x = if is_strong { -width } else { width.clone() };
            growing_half_planes(row).map(move |(name, own)| {
                let Inequality { a: [slope, offset], b: bound } = own.at_zero;
                let slope = towards(&slope);
                (name, Row { slope, offset, bound, of_y: own.growth, of_x: of_x.clone() })
            })
        });
        let conditions = conditions_by_name(&problem.problem().conditions).map(|(name, own)| {
            let Inequality { a: [slope, offset], b: bound } = own;
            let (of_y, of_x) = (Rational::zero(), Rational::zero());
            (name, Row { slope: towards(&slope), offset, bound, of_y, of_x })
        });
        let (names, rows) = deciding::of(readings.chain(conditions));
        let rows: Vec<Row> = rows.iter().map(Row::over_integers).collect();
        // of_y·(1 - λ) + of_x·λ ≥ 0
        let tops = rows.iter().filter(|row| row.of_x.is_negative());
        let tops = tops.filter_map(|row| row.of_y.checked_div(&(&row.of_y - &row.of_x)));
        let top = tops.min().unwrap_or_else(Rational::one);
        SideRows { side, names, rows, top }
    }

    /// The positions of all these rows.
    pub(super) fn every(&self) -> Vec<usize> {
        (0..self.rows.len()).collect()
    }

    /// The (λ, v) with λ within some bounds that some rows leave at a factor.
    fn region(&self, indices: &[usize], factor: &Rational, [low, high]: [&Rational; 2]) -> Region {
        let ends = [
            Inequality::new(-Rational::one(), Rational::zero(), -low),
            Inequality::new(Rational::one(), Rational::zero(), high.clone()),
        ];
        let rows = indices.iter().filter_map(|&index| self.rows.get(index));
        envelope::intersect(&rows.map(|row| row.at(factor)).chain(ends).collect())
    }

    /// Returns whether any factor leaves a line.
    ///
    /// Some factor is large enough for all rows that grow at a point. A point in the relative interior of what the others leave has few
    /// of these: only where one λ is left may a row not grow that grows elsewhere.
    pub(super) fn have_a_factor(&self) -> bool {
        let mut lambda = None;
        for _ in 0..2 {
            let is_fixed = |row: &Row| match &lambda {
                None => row.of_y.is_zero() && row.of_x.is_zero(),
                Some(lambda) => !row.grows(lambda),
            };
            let fixed: Vec<usize> = self
                .rows
                .iter()
                .enumerate()
                .filter(|(_, row)| is_fixed(row))
                .map(|(index, _)| index)
                .collect();
            let zero = Rational::zero();
            match self.region(&fixed, &zero, [&zero, &self.top]).witness() {
                Some(point) if !is_steepest(&point) => lambda = Some(point.theta1()),
                _ => return false,
            }
        }
        true
    }

    /// Returns the place of the least factor of some rows, seen from this one. Exact. Cost: O(n log n).
    pub(super) fn seen_from(&self, factor: &Rational, among: &[usize]) -> Seen {
        let zero = Rational::zero();
        let region = self.region(among, factor, [&zero, &self.top]);
        let Some(point) = region.witness() else {
            return Seen::Above(rows_of(&region, among));
        };
        if is_steepest(&point) {
            // Nothing but one point with λ = 1 is left, where rows of one x without an error in it have no say, though steep lines
            // have to meet them. All other rows make room around the point as the factor grows.
            let v = point.theta2();
            let is_asymptote = |index: &usize| self.rows.get(*index).is_some_and(|row| row.is_asymptote(&v));
            let there: Vec<usize> = among.iter().copied().filter(is_asymptote).collect();
            // If all readings have one x, the slope does not matter.
            let left = self.region(&there, factor, [&zero, &zero]);
            return if left.is_empty() { Seen::Above(rows_of(&left, &there)) } else { Seen::Here(None) };
        }
        // A smaller factor leaves something where all rows that grow at some λ have room. A point in the relative interior touches a row
        // only where all points do. At both ends of λ other rows may grow than between them.
        let has_room = |point: &Point| {
            // To bring the coordinates to fractions in lowest terms costs more than all the rest where numbers are long.
            let (x, y, w) = point.homogeneous();
            let scaled = [x, y, w].map(Rational::from);
            !among.iter().filter_map(|&index| self.rows.get(index)).any(|row| row.is_touched(factor, &scaled))
        };
        let at_end = |end: &Rational| self.region(among, factor, [end, end]).witness();
        let points = iter::once(Some(point.clone())).chain([&zero, &self.top].into_iter().map(at_end));
        match points.flatten().find(has_room).filter(|own| !is_steepest(own)) {
            Some(own) => Seen::Below(own),
            None => Seen::Here(Some(point)),
        }
    }

    /// The line that a point stands for; `None` where λ = 1.
    pub(super) fn line(&self, point: &Point) -> Option<[Rational; 2]> {
        let [lambda, v] = point.coordinates();
        let over = (Rational::one() - &lambda).recip()?;
        let theta1 = lambda * &over;
        Some([if self.side == Side::Falling { -theta1 } else { theta1 }, v * over])
    }
}

/// Returns whether λ = 1, which is no line.
fn is_steepest(point: &Point) -> bool {
    let (x, _, w) = point.homogeneous();
    x == w
}

/// The rows that prove a region empty.
fn rows_of(region: &Region, among: &[usize]) -> Vec<usize> {
    let multipliers = region.certificate().into_iter().flat_map(|own| own.multipliers());
    multipliers.filter_map(|own| among.get(own.index).copied()).collect()
}
