//! The part of the parameter plane that is shown.

use boundfit_estimation::Fit;
use boundfit_exact::{Interval, Rational};
use boundfit_geometry::constructions::foot;
use boundfit_geometry::{Direction, HalfPlane, Point, Region, Vertex};

use crate::extent::Extent;
use crate::figure::PlotOptions;

/// The ends of the view: of θ1 and of θ2.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Window(pub(crate) [[Rational; 2]; 2]);

impl Window {
    /// The smallest window around points; one unit wide around the origin without any.
    pub(crate) fn around(points: &[[Rational; 2]]) -> Self {
        Window([0, 1].map(|j| {
            let mut extent = Extent::default();
            points.iter().for_each(|point| extent.include(&point[j]));
            extent.ends().cloned().unwrap_or_default()
        }))
    }

    /// The ends that were asked for, and its own where none were.
    pub(crate) fn asked_for(self, options: &PlotOptions) -> Self {
        let [first, second] = self.0;
        Window([options.x_range.clone().unwrap_or(first), options.y_range.clone().unwrap_or(second)])
    }

    /// Both ends of both axes moved apart by a part of the width.
    pub(crate) fn padded(self, part: &Rational) -> Self {
        Window(self.0.map(|[lower, upper]| {
            let margin = (&upper - &lower) * part;
            [lower - &margin, upper + margin]
        }))
    }

    /// Shows a point as well, if it is not further away than `most` times the width.
    pub(crate) fn with_near(self, point: &[Rational; 2], most: &Rational) -> Self {
        let near = self.0.iter().zip(point).all(|([lower, upper], value)| {
            let room = (upper - lower) * most;
            *value >= lower - &room && *value <= upper + room
        });
        if near { self.with(point) } else { self }
    }

    /// Shows a point as well.
    pub(crate) fn with(self, point: &[Rational; 2]) -> Self {
        let [first, second] = self.0;
        let grown = |[lower, upper]: [Rational; 2], value: &Rational| {
            [lower.min(value.clone()), upper.max(value.clone())]
        };
        Window([grown(first, &point[0]), grown(second, &point[1])])
    }

    /// Returns whether a box is wholly inside when the window may grow by `most` of its widths on each side.
    pub(crate) fn nearly_holds(&self, corners: &[[Rational; 2]; 2], most: &Rational) -> bool {
        (0..2).all(|j| {
            let [lower, upper] = &self.0[j];
            let room = (upper - lower) * most;
            corners[0][j] >= lower - &room && corners[1][j] <= upper + room
        })
    }

    /// Axes without width take that of another window, around their own place.
    fn widened_by(self, other: &Window) -> Self {
        let [first, second] = self.0;
        let widened = |[lower, upper]: [Rational; 2], other: &[Rational; 2]| {
            if lower < upper {
                return [lower, upper];
            }
            let half = (&other[1] - &other[0]).half();
            [lower - &half, upper + half]
        };
        Window([widened(first, &other.0[0]), widened(second, &other.0[1])])
    }
}

/// The lower left and the upper right corner of a box; `None` when it is unbounded.
pub(crate) fn corners([first, second]: &[Interval; 2]) -> Option<[[Rational; 2]; 2]> {
    let ((lower1, upper1), (lower2, upper2)) = (first.ends()?, second.ends()?);
    Some([[lower1.clone(), lower2.clone()], [upper1.clone(), upper2.clone()]])
}

/// A window that shows a set that is not empty; for an unbounded one its vertices and how it goes on.
pub(crate) fn of_set(fit: &Fit) -> Window {
    let estimates = [
        fit.least_squares.as_ref().ok().map(|estimate| &estimate.theta),
        fit.minimax.as_ref().map(|minimax| &minimax.theta),
    ];
    let estimates: Vec<&[Rational; 2]> = estimates.into_iter().flatten().collect();
    of_region(fit.fps.polyhedron().region(), fit.eui().and_then(corners), &estimates)
}

/// A window that shows a set that is not empty, and of points those that are not far from it. A bounded set without width takes
/// that of a box, given by its corners.
pub(crate) fn of_region(
    region: &Region,
    around: Option<[[Rational; 2]; 2]>,
    near: &[&[Rational; 2]],
) -> Window {
    let points: Vec<[Rational; 2]> = region.vertices().iter().map(|v| v.point().coordinates()).collect();
    let window = match region {
        Region::Point(_) | Region::Segment(_) | Region::Polygon(_) | Region::Empty(_) => {
            bounded(&points, around)
        }
        Region::Ray(_) | Region::UnboundedPolygon(_) => with_rays(region, points),
        Region::Strip(_) | Region::Line(_) | Region::HalfPlane(_) => {
            let lines: Vec<&HalfPlane> = region.boundaries().iter().map(|side| side.half_plane()).collect();
            let centre = match lines.as_slice() {
                [only] => foot(only),
                _ => region.witness().unwrap_or_else(Point::origin),
            };
            around_lines(&centre.coordinates(), &lines)
        }
        Region::Plane => {
            let one = || Rational::one();
            Window([[-one(), one()], [-one(), one()]])
        }
    };
    let most = Rational::ratio(3, 5);
    let window = near.iter().fold(window, |window, theta| window.with_near(theta, &most));
    window.padded(&Rational::ratio(9, 100))
}

/// A window that shows sets that are not empty; with some room around several.
pub(crate) fn of_regions<'a>(regions: impl Iterator<Item = &'a Region>, several: bool) -> Window {
    let windows = regions.map(|region| of_region(region, None, &[]));
    let corners = |window: Window| {
        let [[left, right], [bottom, top]] = window.0;
        [[left, bottom], [right, top]]
    };
    let corners: Vec<[Rational; 2]> = windows.flat_map(corners).collect();
    let window = Window::around(&corners);
    if several { window.padded(&Rational::ratio(1, 20)) } else { window }
}

/// The box of the vertices; where it has no width, another one around it.
fn bounded(points: &[[Rational; 2]], around: Option<[[Rational; 2]; 2]>) -> Window {
    let window = Window::around(points);
    match around {
        Some([lower, upper]) => window.widened_by(&Window::around(&[lower, upper])),
        None => window,
    }
}

/// Vertices, and a piece of each ray about as long as the vertices are apart.
fn with_rays(region: &Region, mut points: Vec<[Rational; 2]>) -> Window {
    let apart = Window::around(&points);
    let widths = apart.0.each_ref().map(|[lower, upper]| upper - lower);
    let ends: Vec<(Vertex, Direction)> = match region {
        Region::UnboundedPolygon(polygon) => {
            let (first, last) = (polygon.chain().next().cloned(), polygon.chain().last().cloned());
            let rays = [polygon.incoming().clone(), polygon.outgoing().clone()];
            first.into_iter().chain(last).zip(rays).collect()
        }
        Region::Ray(ray) => {
            region.vertices().iter().cloned().map(|apex| (apex, ray.direction().clone())).collect()
        }
        _ => Vec::new(),
    };
    for (vertex, direction) in ends {
        let step = [direction.dx(), direction.dy()].map(Rational::from);
        let origin = vertex.point().coordinates();
        // Lengths along both axes, in units of the distance of the vertices.
        let length: Rational = (0..2).filter_map(|j| step[j].abs().checked_div(&widths[j])).sum();
        let plain = || {
            let size = origin[0].abs() + origin[1].abs();
            let size = if size.is_zero() { Rational::one() } else { size };
            size.checked_div(&(step[0].abs() + step[1].abs())).unwrap_or_default()
        };
        let factor = length.recip().unwrap_or_else(plain);
        points.push([0, 1].map(|j| &origin[j] + &step[j] * &factor));
    }
    let window = Window::around(&points);
    let sizes = Window(points.first().map_or_else(Default::default, |point| {
        point.each_ref().map(|value| [Rational::zero(), size_of(value)])
    }));
    window.widened_by(&sizes).padded(&Rational::ratio(1, 4))
}

/// The size of a number, for want of a better measure: its absolute value, or 1.
fn size_of(value: &Rational) -> Rational {
    if value.is_zero() { Rational::one() } else { value.abs() }
}

/// Returns a window around a point near lines, wide enough to see where they run. In each coordinate it reaches as
/// far as the lines cut the axis through the point. Otherwise it reaches far enough for the lines to cross the window
/// on a slant.
pub(crate) fn around_lines(centre: &[Rational; 2], lines: &[&HalfPlane]) -> Window {
    Window([0, 1].map(|j| {
        let other = 1 - j;
        let mut reach = Rational::zero();
        let mut slant = None;
        for line in lines {
            let a = [line.a1(), line.a2()].map(Rational::from);
            let rest = Rational::from(line.b()) - &a[other] * &centre[other];
            if let Some(cut) = rest.checked_div(&a[j]) {
                reach = reach.max((cut - &centre[j]).abs());
                slant = size_of(&Rational::from(line.b())).checked_div(&a[j].abs());
            }
        }
        let half = if reach.is_positive() {
            reach * Rational::ratio(5, 2)
        } else {
            slant.unwrap_or_else(|| size_of(&centre[j]))
        };
        [&centre[j] - &half, &centre[j] + &half]
    }))
}
