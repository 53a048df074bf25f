//! Area, centroid and diameter.

use boundfit_exact::Rational;

use crate::constructions::mean;
use crate::point::Point;
use crate::region::{Region, RegionKind, Vertex};

impl Region {
    /// The area: 0 for everything within a line, `None` when it is infinite. Exact. Cost: linear (shoelace formula).
    pub fn area(&self) -> Option<Rational> {
        match self.kind() {
            RegionKind::Polygon => {
                Some(doubled_triangles(self.vertices()).map(|(area, _)| area).sum::<Rational>().half())
            }
            RegionKind::UnboundedPolygon | RegionKind::Strip | RegionKind::HalfPlane | RegionKind::Plane => {
                None
            }
            _ => Some(Rational::zero()),
        }
    }

    /// The centroid of a bounded region: of the area for a polygon, the mid-point of a segment, the point itself;
    /// `None` when the region is empty or unbounded. Exact.
    pub fn area_centroid(&self) -> Option<Point> {
        let vertices = self.vertices();
        match self.kind() {
            RegionKind::Point | RegionKind::Segment => Some(mean(vertices.iter().map(Vertex::point))),
            RegionKind::Polygon => {
                let mut area = Rational::zero();
                let mut moment = [Rational::zero(), Rational::zero()];
                for (doubled, corners_sum) in doubled_triangles(vertices) {
                    moment =
                        [&moment[0] + &doubled * &corners_sum[0], &moment[1] + &doubled * &corners_sum[1]];
                    area = area + doubled;
                }
                // A triangle's centroid is a third of the sum of its corners.
                let weight = area * Rational::from(3);
                Some(Point::new(&moment[0].checked_div(&weight)?, &moment[1].checked_div(&weight)?))
            }
            _ => None,
        }
    }

    /// The square of the largest distance between two points of a bounded region; `None` when it is empty or
    /// unbounded. Exact. Cost: linear (rotating calipers, Shamos 1978).
    pub fn squared_diameter(&self) -> Option<Rational> {
        if !self.is_bounded() || self.is_empty() {
            return None;
        }
        let corners: Vec<[Rational; 2]> = self.vertices().iter().map(|v| v.point().coordinates()).collect();
        let count = corners.len();
        let height = |edge: usize, corner: usize| {
            doubled_area(&corners[edge], &corners[(edge + 1) % count], &corners[corner % count])
        };
        let mut largest = Rational::zero();
        let mut opposite = 1;
        for edge in 0..count {
            // While the next corner is at least as far from this edge, it is antipodal to the edge's start too. Its end
            // comes with the next edge. The start itself, at no distance, is never the next that is as far.
            loop {
                largest = largest.max(squared_distance(&corners[edge], &corners[opposite % count]));
                if count < 3 || height(edge, opposite + 1) < height(edge, opposite) {
                    break;
                }
                opposite += 1;
            }
        }
        Some(largest)
    }
}

/// Twice the signed area of each triangle of a fan around the first corner, with the sum of its corners.
fn doubled_triangles(vertices: &[Vertex]) -> impl Iterator<Item = (Rational, [Rational; 2])> {
    let corners: Vec<[Rational; 2]> = vertices.iter().map(|vertex| vertex.point().coordinates()).collect();
    (2..corners.len()).map(move |i| {
        let (p, q, r) = (&corners[0], &corners[i - 1], &corners[i]);
        (doubled_area(p, q, r), [&p[0] + &q[0] + &r[0], &p[1] + &q[1] + &r[1]])
    })
}

fn doubled_area(p: &[Rational; 2], q: &[Rational; 2], r: &[Rational; 2]) -> Rational {
    (&q[0] - &p[0]) * (&r[1] - &p[1]) - (&q[1] - &p[1]) * (&r[0] - &p[0])
}

fn squared_distance(p: &[Rational; 2], q: &[Rational; 2]) -> Rational {
    let (dx, dy) = (&p[0] - &q[0], &p[1] - &q[1]);
    &dx * &dx + &dy * &dy
}
