//! A model of at most two columns that are not fixed, as half-planes that know where they come from.

use std::array;

use boundfit_exact::Rational;
use boundfit_geometry::{HalfPlane, Inequality, Polyhedron, System};
use boundfit_lp::{Bounds, End, Model, ObjectiveSense};

use crate::answer::{Item, Side};
use crate::error::SolveError;

/// The feasible set of a [`Model`] in the plane of its columns that bounds do not fix. Where fewer than two are left, what is
/// missing of the plane is 0.
#[derive(Debug, Clone)]
pub struct Plane {
    columns: Vec<usize>,
    /// The values of fixed columns, and 0 for the others.
    fixed: Vec<Rational>,
    polyhedron: Polyhedron,
    /// The bound behind each half-plane; none behind those that hold a missing coordinate at 0.
    sides: Vec<Option<Side>>,
    /// The form to be made large: the costs of the columns that are left, negated for a minimum.
    gain: [Rational; 2],
}

impl Plane {
    /// Puts fixed columns into the rows and intersects what is left. Exact. Cost: O(n log n) in the number of bounds.
    ///
    /// # Errors
    /// When more than two columns are left, and when a row names a column that the model has not.
    pub fn new(model: &Model) -> Result<Self, SolveError> {
        let is_left = |&index: &usize| model.columns.get(index).is_some_and(|c| c.bounds.fixed().is_none());
        let columns: Vec<usize> = (0..model.columns.len()).filter(is_left).collect();
        if columns.len() > 2 {
            let first = columns.iter().filter_map(|&index| model.columns.get(index)).take(3);
            let first = first.map(|column| column.name.clone()).collect();
            return Err(SolveError::TooManyColumns { count: columns.len(), first });
        }
        let fixed = model.columns.iter().map(|column| column.bounds.fixed().cloned().unwrap_or_default());
        let mut sides = Sides { system: System::default(), sides: Vec::new() };
        let mut plane = Plane {
            columns,
            fixed: fixed.collect(),
            polyhedron: Polyhedron::intersect(System::default()),
            sides: Vec::new(),
            gain: [Rational::zero(), Rational::zero()],
        };
        plane.gain = plane.gain_of(model);
        for (index, row) in model.rows.iter().enumerate() {
            let (form, constant) =
                plane.form(row.coefficients.iter().map(|(column, value)| (*column, value)));
            if row.coefficients.iter().any(|(column, _)| *column >= model.columns.len()) {
                return Err(SolveError::NoSuchColumn { row: row.name.clone() });
            }
            sides.push(Some(Item::Row(index)), &form, &constant, &row.bounds);
        }
        for axis in 0..2 {
            let column = plane.columns.get(axis).copied();
            let zero = Bounds { lower: Some(Rational::zero()), upper: Some(Rational::zero()) };
            let bounds = column.map_or(Some(&zero), |index| model.columns.get(index).map(|c| &c.bounds));
            let bounds = bounds.unwrap_or(&zero);
            sides.push(column.map(Item::Column), &unit(axis), &Rational::zero(), bounds);
        }
        plane.sides = sides.sides;
        plane.polyhedron = Polyhedron::intersect(sides.system);
        Ok(plane)
    }

    /// The columns that are left, at most two, by their place in the model: the axes of the plane.
    pub fn columns(&self) -> &[usize] {
        &self.columns
    }

    /// The half-planes and their intersection.
    pub fn polyhedron(&self) -> &Polyhedron {
        &self.polyhedron
    }

    /// The bound behind a half-plane; `None` for one that holds a missing coordinate at 0.
    pub fn side(&self, half_plane: usize) -> Option<Side> {
        self.sides.get(half_plane).copied().flatten()
    }

    /// The form that the objective makes large: its costs for a maximum, the costs negated for a minimum.
    pub fn gain(&self) -> &[Rational; 2] {
        &self.gain
    }

    /// A point of the plane with a value for each column of the model.
    pub fn point(&self, theta: &[Rational; 2]) -> Vec<Rational> {
        self.placed(self.fixed.clone(), theta)
    }

    /// A direction of the plane with an entry for each column of the model.
    pub fn direction(&self, along: &[Rational; 2]) -> Vec<Rational> {
        self.placed(vec![Rational::zero(); self.fixed.len()], along)
    }

    fn placed(&self, mut vector: Vec<Rational>, entries: &[Rational; 2]) -> Vec<Rational> {
        for (&column, entry) in self.columns.iter().zip(entries) {
            if let Some(place) = vector.get_mut(column) {
                *place = entry.clone();
            }
        }
        vector
    }

    /// A form on the columns of the model as one on the plane, and what the fixed columns add to it.
    fn form<'a>(&self, terms: impl Iterator<Item = (usize, &'a Rational)>) -> ([Rational; 2], Rational) {
        let mut form = [Rational::zero(), Rational::zero()];
        let mut constant = Rational::zero();
        for (column, coefficient) in terms {
            let axis = self.columns.iter().position(|own| *own == column);
            match axis.and_then(|axis| form.get_mut(axis)) {
                Some(entry) => *entry = &*entry + coefficient,
                None => {
                    constant = constant + coefficient * self.fixed.get(column).unwrap_or(&Rational::zero());
                }
            }
        }
        (form, constant)
    }

    fn gain_of(&self, model: &Model) -> [Rational; 2] {
        let (cost, _) = self.form(model.columns.iter().map(|column| &column.cost).enumerate());
        match model.sense {
            ObjectiveSense::Maximize => cost,
            ObjectiveSense::Minimize => cost.map(|value| -value),
        }
    }
}

/// Half-planes with the bounds behind them.
struct Sides {
    system: System,
    sides: Vec<Option<Side>>,
}

impl Sides {
    /// `lower ≤ form + constant ≤ upper`, as far as there are bounds.
    fn push(&mut self, item: Option<Item>, form: &[Rational; 2], constant: &Rational, bounds: &Bounds) {
        let [a1, a2] = form;
        let side = |end: End| item.map(|item| Side { item, end });
        if let Some(lower) = &bounds.lower {
            self.system.push(Inequality::new(-a1, -a2, constant - lower));
            self.sides.push(side(End::Lower));
        }
        if let Some(upper) = &bounds.upper {
            self.system.push(Inequality::new(a1.clone(), a2.clone(), upper - constant));
            self.sides.push(side(End::Upper));
        }
    }
}

/// The form that is a coordinate of the plane.
fn unit(axis: usize) -> [Rational; 2] {
    array::from_fn(|own| Rational::from(i64::from(own == axis)))
}

/// The point of a line where the second coordinate is 0, or the first one where the line does not meet that axis in a point.
pub(crate) fn point_on_axis(line: &HalfPlane) -> [Rational; 2] {
    match Rational::new(line.b(), line.a1()) {
        Some(first) => [first, Rational::zero()],
        None => [Rational::zero(), Rational::new(line.b(), line.a2()).unwrap_or_default()],
    }
}
