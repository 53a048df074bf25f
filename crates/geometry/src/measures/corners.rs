//! The corners of a region, borrowed from its vertices or given.

use std::borrow::Cow;

use crate::point::Point;
use crate::region::Vertex;

/// The points that measures are of, around a region.
#[derive(Debug)]
pub(super) enum Corners<'a> {
    Vertices(&'a [Vertex]),
    Points(Vec<Cow<'a, Point>>),
}

impl Corners<'_> {
    pub(super) fn len(&self) -> usize {
        match self {
            Corners::Vertices(vertices) => vertices.len(),
            Corners::Points(points) => points.len(),
        }
    }

    pub(super) fn iter(&self) -> impl ExactSizeIterator<Item = &Point> + Clone {
        (0..self.len()).map(move |position| match self {
            Corners::Vertices(vertices) => vertices[position].point(),
            Corners::Points(points) => &points[position],
        })
    }
}
