//! The diameter of a bounded region.

use boundfit_exact::{Fraction, Integer, Rational, Sign};

use crate::point::Point;
use crate::region::{Region, Vertex};

impl Region {
    /// The square of the largest distance between two points of a bounded region; `None` when it is empty or
    /// unbounded. Exact. Cost: linear (rotating calipers, Shamos 1978).
    pub fn squared_diameter(&self) -> Option<Rational> {
        if !self.is_bounded() || self.is_empty() {
            return None;
        }
        let corners: Vec<&Point> = self.vertices().iter().map(Vertex::point).collect();
        let count = corners.len();
        let corner = |index: usize| corners[index % count];
        let mut largest = Fraction::from(Integer::zero());
        let mut opposite = 1;
        for edge in 0..count {
            let along = step(corner(edge), corner(edge + 1));
            // While the next corner is at least as far from this edge, it is antipodal to the edge's start too. Its end
            // comes with the next edge. The start itself, at no distance, is never the next that is as far.
            loop {
                largest = largest.max(squared_distance(corner(edge), corner(opposite)));
                if count < 3 || turn(&along, &step(corner(opposite), corner(opposite + 1))) == Sign::Negative
                {
                    break;
                }
                opposite += 1;
            }
        }
        Some(largest.into())
    }
}

/// A positive multiple of the way from one point to another.
fn step(p: &Point, q: &Point) -> [Integer; 2] {
    let ((px, py, pw), (qx, qy, qw)) = (p.homogeneous(), q.homogeneous());
    [qx * pw - px * qw, qy * pw - py * qw]
}

/// Returns the side of one step on which another goes.
fn turn(along: &[Integer; 2], step: &[Integer; 2]) -> Sign {
    Integer::compare([(&along[0], &step[1])], [(&along[1], &step[0])]).into()
}

fn squared_distance(p: &Point, q: &Point) -> Fraction {
    let [dx, dy] = step(p, q);
    let weight = p.homogeneous().2 * q.homogeneous().2;
    let square = Fraction::new(&dx * &dx + &dy * &dy, &weight * &weight);
    square.unwrap_or_else(|| Integer::zero().into())
}
