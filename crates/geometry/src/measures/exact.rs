//! Area and moments of a polygon as fractions.

use std::cell::OnceCell;

use boundfit_exact::{Fraction, Integer, LongSum};

use super::corners::Corners;
use crate::point::Point;

/// The sums of the shoelace formula: twice the area, and six times the integrals of both coordinates where they are asked for.
#[derive(Debug)]
pub(super) struct ExactMoments {
    doubled_area: LongSum,
    sixfold_moments: [OnceCell<LongSum>; 2],
    total: OnceCell<Fraction>,
}

impl ExactMoments {
    /// Returns the moments of the corners of a polygon. Adds nothing yet.
    pub(super) fn new(corners: &Corners) -> Self {
        let edges = edges(corners).map(|(p, q)| doubled_triangle(p, q));
        ExactMoments {
            doubled_area: edges.filter_map(|(doubled, weight)| Fraction::new(doubled, weight)).collect(),
            sixfold_moments: Default::default(),
            total: OnceCell::new(),
        }
    }

    fn doubled_area(&self) -> &Fraction {
        self.total.get_or_init(|| self.doubled_area.total())
    }

    fn sixfold_moment(&self, corners: &Corners, axis: usize) -> &LongSum {
        let term = |(p, q): (&Point, &Point)| {
            let (doubled, weight) = doubled_triangle(p, q);
            let (sum, _) = corners_sum(p, q, axis);
            Fraction::new(doubled * sum, &weight * &weight)
        };
        self.sixfold_moments[axis].get_or_init(|| edges(corners).filter_map(term).collect())
    }

    pub(super) fn area(&self) -> Fraction {
        halved(self.doubled_area())
    }

    /// The centroid of the corners that these moments are of.
    pub(super) fn centroid(&self, corners: &Corners, axis: usize) -> Fraction {
        quotient(&self.sixfold_moment(corners, axis).total(), self.doubled_area())
    }

    /// Computes [`ExactMoments::area`], where the common denominator has at most so many bits.
    pub(super) fn area_within(&self, bits: u64) -> Option<Fraction> {
        Some(halved(&self.doubled_area.total_within(bits)?))
    }

    /// Computes [`ExactMoments::centroid`], where both common denominators have at most so many bits.
    pub(super) fn centroid_within(&self, corners: &Corners, axis: usize, bits: u64) -> Option<Fraction> {
        let moment = self.sixfold_moment(corners, axis).total_within(bits)?;
        Some(quotient(&moment, &self.doubled_area.total_within(bits)?))
    }
}

/// Each corner with the next one.
fn edges<'a>(corners: &'a Corners) -> impl Iterator<Item = (&'a Point, &'a Point)> {
    corners.iter().zip(corners.iter().cycle().skip(1))
}

/// Twice the area of the triangle of the origin and two points, as numerator and denominator.
fn doubled_triangle(p: &Point, q: &Point) -> (Integer, Integer) {
    let ((px, py, pw), (qx, qy, qw)) = (p.homogeneous(), q.homogeneous());
    (px * qy - py * qx, pw * qw)
}

/// The sum of a coordinate of two points, as numerator and denominator.
fn corners_sum(p: &Point, q: &Point, axis: usize) -> (Integer, Integer) {
    let ((px, py, pw), (qx, qy, qw)) = (p.homogeneous(), q.homogeneous());
    let (p, q) = if axis == 0 { (px, qx) } else { (py, qy) };
    (p * qw + q * pw, pw * qw)
}

fn halved(doubled: &Fraction) -> Fraction {
    fraction(doubled.numerator().clone(), doubled.denominator() + doubled.denominator())
}

/// Six times a moment over three times twice the area, which is not 0.
fn quotient(moment: &Fraction, doubled_area: &Fraction) -> Fraction {
    let weight = Integer::from(3) * doubled_area.numerator();
    fraction(moment.numerator() * doubled_area.denominator(), moment.denominator() * weight)
}

fn fraction(numerator: Integer, denominator: Integer) -> Fraction {
    Fraction::new(numerator, denominator).unwrap_or_else(|| Integer::zero().into())
}
