//! The readings that decide. The readings of a line on a grid stay machine integers until somebody looks at them. As fractions
//! they would take ten times the memory where every reading is extreme.

use std::ops::Deref;
use std::sync::OnceLock;

use boundfit_exact::{Integer, Rational, Unit};
use boundfit_geometry::HalfPlane;
use boundfit_geometry::grid::GridPoint;

use crate::measurement::Measurement;

/// The readings that decide, ascending by row.
#[derive(Debug, Clone)]
pub struct DecidingRows {
    /// The readings as fractions, once somebody has looked at them.
    numbers: OnceLock<Vec<Measurement>>,
    on_grid: Option<OnGrid>,
}

/// Readings of a line under a uniform error bound, each on a corner of a hull or for others within an edge.
#[derive(Debug, Clone)]
pub(crate) struct OnGrid {
    units: [Unit; 2],
    epsilon: Rational,
    scale: Scale,
    places: Vec<Place>,
}

/// A reading in the units of its grid: less than 2⁶² of them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place {
    pub(crate) row: usize,
    pub(crate) x: i64,
    pub(crate) y: i64,
}

/// The units of x and y and the error bound, as integers over a common denominator.
#[derive(Debug, Clone, Copy)]
struct Scale {
    x: i64,
    y: i64,
    epsilon: i64,
    denominator: i64,
}

impl Deref for DecidingRows {
    type Target = [Measurement];

    fn deref(&self) -> &[Measurement] {
        self.numbers.get_or_init(|| {
            let readings =
                |own: &OnGrid| (0..own.places.len()).map(|position| own.reading(position)).collect();
            self.on_grid.as_ref().map_or_else(Vec::new, readings)
        })
    }
}

impl PartialEq for DecidingRows {
    fn eq(&self, other: &Self) -> bool {
        **self == **other
    }
}

impl Eq for DecidingRows {}

impl From<Vec<Measurement>> for DecidingRows {
    fn from(numbers: Vec<Measurement>) -> Self {
        DecidingRows { numbers: numbers.into(), on_grid: None }
    }
}

impl DecidingRows {
    /// The readings at points of a grid, in any order; `None` unless machine words hold all that is made of them.
    pub(crate) fn of_points(units: [Unit; 2], points: &[GridPoint], epsilon: &Rational) -> Option<Self> {
        let scale = Scale::new(units, epsilon)?;
        let place = |GridPoint { x, y, rows }: &GridPoint| {
            let is_narrow = (x.unsigned_abs() | y.unsigned_abs()) >> 62 == 0;
            is_narrow.then(|| Place { row: rows.first() as usize, x: *x, y: *y })
        };
        let mut places: Vec<Place> = points.iter().map(place).collect::<Option<_>>()?;
        if !places.is_sorted_by_key(|place| place.row) {
            places.sort_unstable_by_key(|place| place.row);
        }
        let on_grid = Some(OnGrid { units, epsilon: epsilon.clone(), scale, places });
        Some(DecidingRows { numbers: OnceLock::new(), on_grid })
    }

    /// The number of readings. Cost: constant.
    pub fn len(&self) -> usize {
        self.on_grid.as_ref().map_or_else(|| self.deref().len(), |own| own.places.len())
    }

    /// Returns whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The readings as integers, where they are on a grid.
    pub(crate) fn on_grid(&self) -> Option<&OnGrid> {
        self.on_grid.as_ref()
    }

    /// Gives all readings another error bound.
    pub(crate) fn set_bound(&mut self, epsilon: &Rational) {
        if let Some(own) = &mut self.on_grid
            && let Some(scale) = Scale::new(own.units, epsilon)
        {
            (own.scale, own.epsilon) = (scale, epsilon.clone());
            self.numbers = OnceLock::new();
            return;
        }
        let numbers = std::mem::replace(self, Vec::new().into()).into_numbers();
        *self = Vec::from_iter(numbers.into_iter().map(|row| row.within(epsilon.clone()))).into();
    }

    /// The readings as numbers of their own.
    pub(crate) fn into_numbers(self) -> Vec<Measurement> {
        let _ = self.deref();
        self.numbers.into_inner().unwrap_or_default()
    }
}

impl OnGrid {
    /// The readings as integers, ascending by row.
    pub(crate) fn places(&self) -> &[Place] {
        &self.places
    }

    /// The reading at a position.
    pub(crate) fn reading(&self, position: usize) -> Measurement {
        let Place { row, x, y } = self.places[position];
        let [x, y] = [self.units[0].times(x.into()), self.units[1].times(y.into())];
        Measurement::around(row, [x, Rational::one()], y, self.epsilon.clone())
    }

    /// The half-plane of the upper bound of the reading at a position, x·θ1 + θ2 ≤ y + ε. Exact.
    pub(crate) fn upper(&self, position: usize) -> Option<HalfPlane> {
        self.half_plane(position, 1)
    }

    /// The half-plane of the lower bound of the reading at a position, -x·θ1 - θ2 ≤ ε - y. Exact.
    pub(crate) fn lower(&self, position: usize) -> Option<HalfPlane> {
        self.half_plane(position, -1)
    }

    fn half_plane(&self, position: usize, side: i64) -> Option<HalfPlane> {
        let (Place { x, y, .. }, scale) = (self.places[position], self.scale);
        // 62 bits, 63 bits and a sign: no product fills 127 bits.
        let product = |left: i64, right: i64| i128::from(left) * i128::from(right);
        let bound = product(side * y, scale.y) + i128::from(scale.epsilon);
        HalfPlane::new(
            Integer::from(product(side * x, scale.x)),
            Integer::from(product(side, scale.denominator)),
            Integer::from(bound),
        )
    }

    /// The readings as points of the plane, each with its position as its number, sorted by x, then by y.
    pub(crate) fn sorted_points(&self) -> Vec<GridPoint> {
        let point = |(position, place): (u64, &Place)| GridPoint::of_row(place.x, place.y, position);
        let mut points: Vec<GridPoint> = (0..).zip(&self.places).map(point).collect();
        if !points.is_sorted() {
            points.sort_unstable();
        }
        points
    }
}

impl Scale {
    /// The scale of these units, if it is made of machine words.
    fn new(units: [Unit; 2], epsilon: &Rational) -> Option<Self> {
        let [x, y] = units.map(Unit::value);
        let (numbers, denominator) = Rational::over_common_denominator([&x, &y, epsilon]);
        let [x, y, epsilon] = numbers.map(|number| number.to_i64());
        Some(Scale { x: x?, y: y?, epsilon: epsilon?, denominator: denominator.to_i64()? })
    }
}

#[cfg(test)]
mod tests {
    use boundfit_geometry::{Constraint, Inequality};

    use super::*;

    #[test]
    fn places_say_what_their_numbers_say() {
        let points = [(9, -7, 250), (2, 0, -5), (4, 35, 0)].map(|(row, x, y)| GridPoint::of_row(x, y, row));
        for (units, epsilon) in [
            ([Unit::TenTo(-1), Unit::TenTo(-2)], Rational::ratio(1, 8)),
            ([Unit::OneOver(6), Unit::TenTo(3)], Rational::zero()),
            ([Unit::Any, Unit::OneOver(7)], Rational::ratio(10, 3)),
        ] {
            let rows = DecidingRows::of_points(units, &points, &epsilon).unwrap();
            let grid = rows.on_grid().unwrap();
            assert_eq!(rows.iter().map(|reading| reading.row).collect::<Vec<_>>(), [2, 4, 9]);
            assert_eq!((rows.len(), rows.is_empty()), (3, false));
            for (position, reading) in rows.iter().enumerate() {
                let [x, one] = reading.regressor.clone();
                let upper = Inequality::new(x.clone(), one.clone(), reading.upper().unwrap());
                let lower = Inequality::new(-x, -one, -reading.lower().unwrap());
                let own = [grid.upper(position), grid.lower(position)].map(Option::unwrap);
                assert_eq!(own.map(Constraint::HalfPlane), [upper, lower].map(|own| own.constraint()));
            }
            let sorted: Vec<u64> = grid.sorted_points().iter().map(|point| point.rows.first()).collect();
            assert_eq!(sorted, [2, 0, 1]);
            assert_eq!(DecidingRows::from(rows.to_vec()), rows);
            assert_eq!(rows.clone().into_numbers(), *rows);
            for bound in [Rational::ratio(2, 3), Rational::ratio(1, i64::MAX)] {
                let mut others = rows.clone();
                others.set_bound(&bound);
                let expected: Vec<_> = rows.iter().map(|row| row.clone().within(bound.clone())).collect();
                assert_eq!(*others, expected);
            }
        }
    }

    #[test]
    fn what_leaves_machine_words_is_no_grid() {
        let is_grid = |exponent: i32, x: i64, epsilon: Rational| {
            let units = [Unit::TenTo(exponent), Unit::TenTo(0)];
            DecidingRows::of_points(units, &[GridPoint::of_row(x, 0, 1)], &epsilon).is_some()
        };
        assert!(is_grid(0, -(1 << 62) + 1, Rational::one()));
        assert!(!is_grid(0, 1 << 62, Rational::one()));
        assert!(!is_grid(-19, 0, Rational::one()));
        assert!(is_grid(0, 0, Rational::ratio(1, i64::MAX)));
        assert!(!is_grid(-1, 0, Rational::ratio(1, i64::MAX)));
    }
}
