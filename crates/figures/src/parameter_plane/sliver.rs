//! A thin set along and across its longest diagonal, where it can still be seen.

use boundfit_exact::Rational;
use boundfit_geometry::Region;

use super::layout::side_frame;
use crate::axis::Axis;
use crate::clip::Place;
use crate::drawing::Panel;
use crate::extent::Extent;
use crate::page::Page;

/// A set with a width below this part of its length, seen in its own box, is thin.
const THIN: (i64, i64) = (3, 100);

/// Coordinates along and across the longest diagonal of a set in its box, whose sides count 1. The diagonal has length 1
/// in both. Exact.
pub(crate) struct Sliver {
    origin: [Rational; 2],
    sides: [Rational; 2],
    diagonal: [Rational; 2],
    square: Rational,
    across: [Rational; 2],
}

impl Sliver {
    /// The coordinates of a thin bounded set; `None` for any other.
    pub(crate) fn of(region: &Region) -> Option<Self> {
        let Region::Polygon(_) = region else { return None };
        Sliver::of_corners(&region.vertices().iter().map(|v| v.point().coordinates()).collect::<Vec<_>>())
    }

    /// The coordinates of a polygon with these corners; `None` when it is not thin.
    pub(crate) fn of_corners(vertices: &[[Rational; 2]]) -> Option<Self> {
        let sides = [0, 1].map(|j| {
            let mut extent = Extent::default();
            vertices.iter().for_each(|vertex| extent.include(&vertex[j]));
            let [lower, upper] = extent.into_ends();
            upper - lower
        });
        let first = vertices.first()?;
        let one_end = farthest(vertices, first, &sides)?;
        let other_end = farthest(vertices, one_end, &sides)?;
        let diagonal = scaled(one_end, other_end, &sides)?;
        let square = &diagonal[0] * &diagonal[0] + &diagonal[1] * &diagonal[1];
        let (origin, across) = (one_end.clone(), [Rational::zero(), Rational::zero()]);
        let mut sliver = Sliver { origin, sides, diagonal, square, across };
        let mut extent = Extent::default();
        for vertex in vertices {
            extent.include(&sliver.coordinates(vertex)?[1]);
        }
        sliver.across = extent.into_ends();
        let width = &sliver.across[1] - &sliver.across[0];
        (width < Rational::ratio(THIN.0, THIN.1)).then_some(sliver)
    }

    /// Returns the place of a point on a panel in these coordinates.
    pub(crate) fn place(&self, panel: &Panel, theta: &[Rational; 2]) -> Option<Place> {
        let [along, across] = self.coordinates(theta)?;
        Some(panel.place([&along, &across]))
    }

    /// Returns the content of the panel in these coordinates, in words.
    pub(crate) fn note(whose: &str) -> String {
        format!(
            "Principal axes: along and across the longest diagonal of {whose}, scaled so that its box is 1 by 1 and the diagonal is 1."
        )
    }

    /// Returns the coordinates of a point along and across the diagonal.
    fn coordinates(&self, theta: &[Rational; 2]) -> Option<[Rational; 2]> {
        let [u, v] = scaled(&self.origin, theta, &self.sides)?;
        let [d, e] = &self.diagonal;
        Some([(d * &u + e * &v).checked_div(&self.square)?, (d * v - e * u).checked_div(&self.square)?])
    }

    /// An empty panel in these coordinates.
    pub(crate) fn panel(&self, index: usize, page: Page) -> Panel {
        let frame = side_frame(index, page);
        // Room for the numbers of the vertices.
        let margin = Rational::ratio(1, 6);
        let width = &self.across[1] - &self.across[0];
        let [lower, upper] = [&self.across[0] - &width * &margin, &self.across[1] + &width * &margin];
        let along = Axis::new("along".to_owned(), &-&margin, &(Rational::one() + &margin), 3);
        let across = Axis::new("across".to_owned(), &lower, &upper, 4);
        let mut panel = Panel::new(frame, [along, across], false);
        panel.heading = "in principal axes".to_owned();
        panel
    }
}

/// A difference in units of the box's sides.
fn scaled(from: &[Rational; 2], to: &[Rational; 2], sides: &[Rational; 2]) -> Option<[Rational; 2]> {
    Some([(&to[0] - &from[0]).checked_div(&sides[0])?, (&to[1] - &from[1]).checked_div(&sides[1])?])
}

/// The vertex that is farthest from another one, in units of the box's sides.
fn farthest<'a>(
    vertices: &'a [[Rational; 2]],
    from: &[Rational; 2],
    sides: &[Rational; 2],
) -> Option<&'a [Rational; 2]> {
    let distance = |vertex: &[Rational; 2]| {
        let [u, v] = scaled(from, vertex, sides)?;
        Some(&u * &u + &v * &v)
    };
    let mut farthest: Option<(&[Rational; 2], Rational)> = None;
    for vertex in vertices {
        let distance = distance(vertex)?;
        if farthest.as_ref().is_none_or(|(_, most)| distance > *most) {
            farthest = Some((vertex, distance));
        }
    }
    farthest.map(|(vertex, _)| vertex)
}
