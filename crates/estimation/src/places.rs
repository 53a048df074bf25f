//! The readings of a line as points of the plane, on the shortest numbers that hold them.

use std::cmp::Ordering;

use boundfit_exact::{Fraction, Integer, Scaled, Sign, Wide};
use boundfit_geometry::grid::{GridPoint, doubled_area};
use boundfit_geometry::predicates::{by_theta1, lexicographic, orientation};
use boundfit_geometry::{Point, Site, Tally, Tied};

use crate::measurement::Measurement;

/// A reading of a line as a point of the plane of x and y.
pub(crate) trait Place: Tied {
    /// Returns the position of the first reading here.
    fn position(&self) -> usize {
        // Positions in a list that is in memory.
        self.rows().first() as usize
    }

    fn by_x(&self, other: &Self) -> Ordering;
    /// Returns the side of the line through two points, in that order, on which a third point lies.
    fn orientation(&self, second: &Self, third: &Self) -> Sign;
    /// Returns the vertical distance, not negative, from the point to the line through two others, or to their one
    /// point if they are the same. The unit is any that is the same for all points.
    fn distance(&self, edge: [&Self; 2]) -> Fraction;
}

/// Coordinates of a grid are below 2⁶², so that areas are exact.
impl Place for GridPoint {
    fn by_x(&self, other: &Self) -> Ordering {
        self.x.cmp(&other.x)
    }

    fn orientation(&self, second: &Self, third: &Self) -> Sign {
        doubled_area(self, second, third).cmp(&0).into()
    }

    fn distance(&self, [left, right]: [&Self; 2]) -> Fraction {
        let area = doubled_area(left, right, self).unsigned_abs();
        let over_width = Fraction::new(Integer::from(area), Integer::from(right.x - left.x));
        over_width.unwrap_or_else(|| Integer::from(self.y.abs_diff(left.y)).into())
    }
}

/// A reading with numbers of any size.
pub(crate) struct ExactPlace {
    point: Point,
    tied: Tally,
}

impl ExactPlace {
    /// The readings sorted by x, then by y.
    pub(crate) fn sorted(rows: &[Measurement]) -> Vec<Self> {
        let at = |(position, row): (usize, &Measurement)| {
            let point = Point::new(&row.regressor[0], row.y_and_epsilon().0);
            ExactPlace { point, tied: Tally::one(position as u64) }
        };
        let mut points: Vec<ExactPlace> = rows.iter().enumerate().map(at).collect();
        points.sort_by(|p, q| lexicographic(&p.point, &q.point).then_with(|| p.tied.cmp(&q.tied)));
        points
    }
}

impl Site for ExactPlace {
    fn is_above_or_below(&self, other: &Self) -> bool {
        self.by_x(other).is_eq()
    }

    fn coincides(&self, other: &Self) -> bool {
        self.point == other.point
    }
}

impl Tied for ExactPlace {
    fn rows(&self) -> &Tally {
        &self.tied
    }

    fn with_rows(self, tied: Tally) -> Self {
        ExactPlace { tied, ..self }
    }
}

impl Place for ExactPlace {
    fn by_x(&self, other: &Self) -> Ordering {
        by_theta1(&self.point, &other.point)
    }

    fn orientation(&self, second: &Self, third: &Self) -> Sign {
        orientation(&self.point, &second.point, &third.point)
    }

    fn distance(&self, [left, right]: [&Self; 2]) -> Fraction {
        let [[x, y], [left_x, left_y], [right_x, right_y]] =
            [self, left, right].map(|place| place.point.coordinates());
        let slope = (right_y - &left_y).checked_div(&(right_x - &left_x)).unwrap_or_default();
        Fraction::from(&(y - left_y - slope * (x - left_x)).abs())
    }
}

/// A reading on integers of 126 bits, whose differences are machine integers: 17 digits at exponents that differ.
pub(crate) struct WidePlace {
    x: i128,
    y: i128,
    tied: Tally,
}

impl WidePlace {
    /// The readings sorted by x, then y; `None` where they are longer.
    pub(crate) fn sorted(rows: &[Measurement]) -> Option<Vec<Self>> {
        let x = Scaled::<i128>::of_numbers(rows.iter().map(|row| &row.regressor[0]))?;
        let y = Scaled::<i128>::of_numbers(rows.iter().map(|row| row.y_and_epsilon().0))?;
        let place = |(row, (&x, &y)): (u64, (&i128, &i128))| WidePlace { x, y, tied: Tally::one(row) };
        let mut places: Vec<Self> = (0..).zip(x.counts().iter().zip(y.counts())).map(place).collect();
        places.sort_by_key(|place| (place.x, place.y));
        Some(places)
    }

    /// Twice the area of the triangle of three points, positive if the third is to the left of the way from the first to the second.
    fn doubled_area(&self, second: &Self, third: &Self) -> Wide {
        let product = |end: &Self, side: &Self| Wide::product(end.x - self.x, side.y - self.y);
        product(second, third) - product(third, second)
    }
}

impl Site for WidePlace {
    fn is_above_or_below(&self, other: &Self) -> bool {
        self.x == other.x
    }

    fn coincides(&self, other: &Self) -> bool {
        (self.x, self.y) == (other.x, other.y)
    }
}

impl Tied for WidePlace {
    fn rows(&self) -> &Tally {
        &self.tied
    }

    fn with_rows(self, tied: Tally) -> Self {
        WidePlace { tied, ..self }
    }
}

impl Place for WidePlace {
    fn by_x(&self, other: &Self) -> Ordering {
        self.x.cmp(&other.x)
    }

    fn orientation(&self, second: &Self, third: &Self) -> Sign {
        self.doubled_area(second, third).cmp(&Wide::default()).into()
    }

    fn distance(&self, [left, right]: [&Self; 2]) -> Fraction {
        let area = left.doubled_area(right, self);
        let over_width = Fraction::new(area.negated_if(area.is_negative()).into(), (right.x - left.x).into());
        over_width.unwrap_or_else(|| Integer::from((self.y - left.y).abs()).into())
    }
}
