//! The points of the parameter plane, each kept once.

use boundfit_exact::Rational;
use boundfit_geometry::Point;
use boundfit_report::{Number, Style};

use crate::number::point;
use crate::numbered::Numbered;

/// A pool of points; the rest of the data refers to them by index, in the order in which they first came up.
#[derive(Debug)]
pub(crate) struct Points {
    styles: [Style; 2],
    known: Numbered<Point>,
    numbers: Vec<[Number; 2]>,
}

impl Points {
    pub(crate) fn new(styles: [Style; 2]) -> Self {
        Points { styles, known: Numbered::default(), numbers: Vec::new() }
    }

    /// The index of a point, which is added when it is new.
    pub(crate) fn index(&mut self, at: &Point) -> usize {
        let (index, is_new) = self.known.number(at);
        if is_new {
            self.numbers.push(point(&self.styles, &at.coordinates()));
        }
        index
    }

    pub(crate) fn index_of(&mut self, theta: &[Rational; 2]) -> usize {
        self.index(&Point::new(&theta[0], &theta[1]))
    }

    pub(crate) fn into_numbers(self) -> Vec<[Number; 2]> {
        self.numbers
    }
}
