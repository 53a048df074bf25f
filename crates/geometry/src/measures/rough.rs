//! Area and moments of a polygon between bounds, from vertices rounded to a grid.

use boundfit_exact::{Integer, Rational};

use super::corners::Corners;
use crate::point::Point;

/// The moments of a closed polygon `Q`, with bounds on their distance from the moments of `P`. The vertices of `Q`
/// are those of `P`, rounded down to a grid that is as fine as was asked for.
///
/// Each coordinate moves by less than a unit of the grid. Let the vertices move from `Q` to `P`, each in a straight
/// line. The integral of a function over the polygon then changes at the rate of its integral over the boundary times
/// the speed outwards (Reynolds). So its total change is at most its largest absolute value times the sum of
/// `|dθ1| + |dθ2|` over the edges. An edge on the way is longer than that of `Q` by at most a unit in each
/// coordinate.
#[derive(Debug)]
pub(super) struct RoughMoments {
    /// The grid's units are `2^-scale`.
    scale: [i64; 2],
    /// The point about which the moments are taken, in units.
    origin: [Integer; 2],
    /// Twice the area, and six times the integrals of both coordinates, in units.
    doubled_area: Integer,
    sixfold_moments: [Integer; 2],
    /// The bound on what the integral of a function no larger than 1 changes by.
    change: Integer,
    /// The largest absolute value of each coordinate, rounded up.
    reach: [Integer; 2],
}

impl RoughMoments {
    /// Computes the moments on a grid on which the polygon is at least `2^bits` units wide and high. Exact but for
    /// the rounding that it bounds. Cost: linear. `None` where there is no polygon.
    pub(super) fn new(corners: &Corners, bits: u64) -> Option<Self> {
        let scale = [0, 1].map(|axis| scale(corners, axis, bits));
        let [Some(x_scale), Some(y_scale)] = scale else { return None };
        let scale = [x_scale, y_scale];
        let power = scale.map(|scale| Integer::power_of_two(scale.unsigned_abs()));
        let on_grid = |point: &Point| {
            let (x, y, w) = point.homogeneous();
            let floor = |axis: usize, coordinate: &Integer| match scale[axis] {
                0.. => (coordinate * &power[axis]).div_rem_floor(w).0,
                _ => coordinate.div_rem_floor(&(w * &power[axis])).0,
            };
            [floor(0, x), floor(1, y)]
        };
        let origin = on_grid(corners.iter().next()?);
        let mut moments = RoughMoments {
            scale,
            origin: origin.clone(),
            doubled_area: Integer::zero(),
            sixfold_moments: Default::default(),
            change: Integer::from(2 * corners.len()),
            reach: [Integer::one(), Integer::one()],
        };
        let first = || [Integer::zero(), Integer::zero()];
        let mut last = first();
        for corner in corners.iter().skip(1) {
            let [x, y] = on_grid(corner);
            let next = [x - &origin[0], y - &origin[1]];
            moments.add_edge(&last, &next);
            last = next;
        }
        moments.add_edge(&last, &first());
        Some(moments)
    }

    /// The triangle of the origin and an edge.
    fn add_edge(&mut self, p: &[Integer; 2], q: &[Integer; 2]) {
        let doubled = &p[0] * &q[1] - &p[1] * &q[0];
        for axis in [0, 1] {
            self.change = &self.change + (&q[axis] - &p[axis]).abs();
            // The third corner is the origin.
            self.sixfold_moments[axis] = &self.sixfold_moments[axis] + (&p[axis] + &q[axis]) * &doubled;
            let reach = p[axis].abs() + Integer::one();
            if reach > self.reach[axis] {
                self.reach[axis] = reach;
            }
        }
        self.doubled_area = &self.doubled_area + doubled;
    }

    /// Bounds on twice the area, in units.
    fn doubled_area(&self) -> (Integer, Integer) {
        let error = &self.change + &self.change;
        (&self.doubled_area - &error, &self.doubled_area + error)
    }

    /// Bounds on the area.
    pub(super) fn area(&self) -> (Rational, Rational) {
        let unit = -self.scale[0] - self.scale[1] - 1;
        let (lower, upper) = self.doubled_area();
        (Rational::binary(lower, unit), Rational::binary(upper, unit))
    }

    /// Bounds on a coordinate of the centroid; `None` where those on the area leave it without a sign.
    pub(super) fn centroid(&self, axis: usize) -> Option<(Rational, Rational)> {
        let (least, most) = self.doubled_area();
        if !least.is_positive() {
            return None;
        }
        let error = Integer::from(6) * &self.reach[axis] * &self.change;
        let moment = &self.sixfold_moments[axis];
        let end = |moment: Integer, weight: &Integer| {
            let from_origin = Rational::new(moment, Integer::from(3) * weight)?;
            let power = Rational::binary(Integer::one(), -self.scale[axis]);
            Some((from_origin + Rational::from(&self.origin[axis])) * power)
        };
        let (lower, upper) = (moment - &error, moment + &error);
        let lower_weight = if lower.is_negative() { &least } else { &most };
        let upper_weight = if upper.is_negative() { &most } else { &least };
        Some((end(lower, lower_weight)?, end(upper, upper_weight)?))
    }
}

/// A scale on which some of the corners are at least `2^bits` units apart in a coordinate; `None` where those that are looked
/// at are not apart. Three corners of a polygon that is strictly convex are on no line.
fn scale(corners: &Corners, axis: usize, bits: u64) -> Option<i64> {
    const LOOKS: usize = 3;
    let coordinate = |point: &Point| {
        let (x, y, w) = point.homogeneous();
        (if axis == 0 { x.clone() } else { y.clone() }, w.clone())
    };
    let (first, first_weight) = coordinate(corners.iter().next()?);
    let others = corners.iter().step_by(corners.len().div_ceil(LOOKS)).skip(1);
    let apart = others.filter_map(|other| {
        let (other, weight) = coordinate(other);
        let difference = other * &first_weight - &first * &weight;
        // It is at least 2^(exponent - 1).
        (!difference.is_zero()).then(|| difference.bits() as i64 - (weight * &first_weight).bits() as i64)
    });
    Some(bits as i64 + 1 - apart.max()?)
}
