//! One characteristic, and the four lines that it is measured from.

use boundfit_estimation::{
    BoundName, Condition, ErrorBound, LeastSquares, Measurement, Measurements, Minimax, Model,
};
use boundfit_exact::{Endpoint, Interval, Rational};
use boundfit_geometry::Tally;
use thiserror::Error;

use super::points::CalibrationPoint;
use super::{LinearityOptions, Whole};

/// A characteristic with its linearity.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Characteristic {
    /// The points, by x and then by row; at least one. There are those that decide alone, of many readings without directions.
    pub points: Vec<CalibrationPoint>,
    /// The number of points that are not among these.
    others: usize,
    /// Largest less smallest y of its points.
    pub span: Rational,
    /// The full scale of percents: the span, or a given number.
    pub full_scale: Rational,
    /// The linearity about the line whose largest deviation is smallest.
    pub independent: LinearityLine,
    /// The points that prove that no line has a smaller largest deviation, by x; none where it is 0.
    pub proof: Vec<AlternatingPoint>,
    /// The linearity about the line through the points at both ends of the range of x, averages where there are
    /// several at an end.
    pub terminal: Result<LinearityLine, NoLine>,
    /// The linearity about the line through the given point whose largest deviation is smallest.
    pub zero_based: LinearityLine,
    /// The linearity about the least-squares line of the points.
    pub least_squares: Result<LinearityLine, NoLine>,
}

/// The deviation of a characteristic from a line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LinearityLine {
    /// The largest |y - line|.
    pub deviation: Rational,
    /// The largest deviation in percent of full scale; `None` where full scale is 0.
    pub percent: Option<Rational>,
    /// Slope and intercept.
    pub theta: [Rational; 2],
    /// `true` if no other line serves as well. If several slopes serve the zero-based line, it has the middle one.
    pub unique: bool,
    /// The positions of the points where the largest deviation is reached, ascending.
    pub at: Vec<usize>,
}

/// A point of the proof of independent linearity. The deviations, each times its weight and its sign, add up to the
/// same for every line, so that the largest is at least their sum. Weights add up to 1.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct AlternatingPoint {
    /// The position of the point.
    pub position: usize,
    /// The deviation of the point, y - line; positive above the line.
    pub deviation: Rational,
    /// The weight of the point in the sum.
    pub weight: Rational,
}

/// The reason why there is no line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum NoLine {
    /// A vertical line is no characteristic.
    #[error("all readings have the same x, and no range that a line could run through")]
    OneX,
}

impl LinearityLine {
    /// y less the line's value at a point. Exact.
    pub fn deviation_at(&self, point: &CalibrationPoint) -> Rational {
        &point.y - (&self.theta[0] * &point.x + &self.theta[1])
    }

    /// The data rows where the largest deviation is reached; `None` without any.
    pub fn tally(&self, characteristic: &Characteristic) -> Option<Tally> {
        let points = self.at.iter().filter_map(|&position| characteristic.points.get(position));
        Tally::union(points.map(CalibrationPoint::all_rows))
    }

    /// The data rows where the largest deviation is reached, ascending.
    pub fn rows(&self, characteristic: &Characteristic) -> Vec<usize> {
        let rows = self.tally(characteristic);
        rows.iter().flat_map(Tally::rows).map(|row| row as usize).collect()
    }
}

impl Characteristic {
    /// Returns the number of points; equal readings that are told once are points of their own.
    pub fn count(&self) -> usize {
        count(&self.points) + self.others
    }

    /// The linearity of points that are sorted by x; `None` without any. Where facts about the whole are given, the points
    /// are all that touch its hulls, and maybe others. Exact. Cost: O(n log n).
    pub(super) fn new(
        points: Vec<CalibrationPoint>,
        whole: Option<&Whole>,
        options: &LinearityOptions,
    ) -> Option<Self> {
        let y = || points.iter().map(|point| &point.y);
        let span = y().max()? - y().min()?;
        let full_scale = options.full_scale.clone().unwrap_or_else(|| span.clone());
        let measured = |theta, unique| measured(&points, theta, unique, &full_scale);
        let measurements = measurements(&points, [&Rational::zero(), &Rational::zero()]);
        // Without conditions some bound leaves something.
        let minimax = Minimax::new(&measurements, &[])?;
        let independent = measured(minimax.theta.clone(), minimax.unique);
        let proof = alternation(&points, &independent, &minimax);
        let (slope, is_only) = slope_through(&points, &options.through)?;
        let intercept = &options.through[1] - &slope * &options.through[0];
        let zero_based = measured([slope, intercept], is_only);
        let (terminal, least_squares) = match whole {
            Some(whole) => (whole.terminal.clone(), whole.least_squares.clone()),
            None => {
                let estimate = LeastSquares::new(&measurements).ok();
                (terminal(&points), estimate.map(|estimate| estimate.theta))
            }
        };
        let line =
            |theta: Option<[Rational; 2]>| theta.map(|theta| measured(theta, true)).ok_or(NoLine::OneX);
        let [terminal, least_squares] = [terminal, least_squares].map(line);
        let others = whole.map_or(0, |whole| whole.count.saturating_sub(count(&points)));
        Some(Characteristic {
            others,
            span,
            full_scale,
            independent,
            proof,
            terminal,
            zero_based,
            least_squares,
            points,
        })
    }
}

/// Measures the distance of points from a line.
fn measured(
    points: &[CalibrationPoint],
    theta: [Rational; 2],
    unique: bool,
    full_scale: &Rational,
) -> LinearityLine {
    let mut line =
        LinearityLine { deviation: Rational::zero(), percent: None, theta, unique, at: Vec::new() };
    for (position, point) in points.iter().enumerate() {
        let deviation = line.deviation_at(point).abs();
        if deviation > line.deviation {
            line.deviation = deviation;
            line.at.clear();
            line.at.push(position);
        } else if deviation == line.deviation {
            line.at.push(position);
        }
    }
    line.percent = (&line.deviation * Rational::from(100)).checked_div(full_scale);
    line
}

/// The points as readings of a line, counted from a point of the plane. Their rows are their positions.
fn measurements(points: &[CalibrationPoint], [x, y]: [&Rational; 2]) -> Measurements {
    let reading = |(position, point): (usize, &CalibrationPoint)| {
        let regressor = [&point.x - x, Rational::one()];
        Measurement::around(position, regressor, &point.y - y, Rational::zero())
    };
    let rows = points.iter().enumerate().map(reading).collect();
    let (model, bound) = (Model::Line { x: "x".into() }, ErrorBound::Uniform(Rational::zero()));
    if points.iter().all(|point| point.equal.is_none()) {
        return Measurements::new(model, "y".into(), bound, rows);
    }
    let counts: Vec<u64> = points.iter().map(CalibrationPoint::count).collect();
    Measurements::counted(model, "y".into(), bound, rows, &counts)
}

/// Returns the points that prove that no line is nearer, from the multipliers of their half-planes.
fn alternation(
    points: &[CalibrationPoint],
    line: &LinearityLine,
    minimax: &Minimax,
) -> Vec<AlternatingPoint> {
    let point = |(name, weight): &(BoundName, Rational)| {
        let position = name.row()?;
        let deviation = line.deviation_at(points.get(position)?);
        Some(AlternatingPoint { position, deviation, weight: weight.clone() })
    };
    let mut proof: Vec<AlternatingPoint> = minimax.proof.multipliers.iter().filter_map(point).collect();
    proof.sort_by_key(|point| point.position);
    proof
}

/// The slope of the line through a point whose largest deviation is smallest, the middle one where several are, and whether it
/// is the only one.
fn slope_through(points: &[CalibrationPoint], through: &[Rational; 2]) -> Option<(Rational, bool)> {
    let [x, y] = through;
    let counted = measurements(points, [x, y]);
    let least = Minimax::new(&counted, &[Condition::no_intercept()])?.least;
    let mut slopes: Option<[Rational; 2]> = None;
    for row in counted.kept() {
        let (Some(response), [dx, _]) = (row.response(), &row.regressor) else { continue };
        let ends = [response - &least, response + &least].map(|end| end.checked_div(dx));
        let [Some(one), Some(other)] = ends else { continue };
        let own = if one <= other { [one, other] } else { [other, one] };
        slopes = Some(match slopes {
            None => own,
            Some([from, to]) => [from.max(own[0].clone()), to.min(own[1].clone())],
        });
    }
    // Where every x is that of the point, any line through it serves; the level one is one of them.
    let Some([from, to]) = slopes else { return Some((Rational::zero(), false)) };
    let is_only = from == to;
    let slopes = Interval::new(Endpoint::Finite(from), Endpoint::Finite(to))?;
    Some((slopes.midpoint()?, is_only))
}

/// The number of points that some stand for.
fn count(points: &[CalibrationPoint]) -> usize {
    points.iter().map(|point| point.count() as usize).sum()
}

/// The line through both ends of points that are sorted by x; `None` where they have the same x.
fn terminal(points: &[CalibrationPoint]) -> Option<[Rational; 2]> {
    let end = |x: &Rational| {
        let own = || points.iter().filter(|point| point.x == *x);
        let sum: Rational = own().map(|point| &point.y * Rational::from(point.count())).sum();
        sum.checked_div(&Rational::from(own().map(CalibrationPoint::count).sum::<u64>()))
    };
    let [from, to] = [&points.first()?.x, &points.last()?.x];
    line_through([from, &end(from)?], [to, &end(to)?])
}

/// The line through two points; `None` where they have the same x.
pub(super) fn line_through([x1, y1]: [&Rational; 2], [x2, y2]: [&Rational; 2]) -> Option<[Rational; 2]> {
    let slope = (y2 - y1).checked_div(&(x2 - x1))?;
    let intercept = y1 - &slope * x1;
    Some([slope, intercept])
}
