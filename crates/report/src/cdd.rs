//! The representations of cdd and lrs (Fukuda, *cddlib Reference Manual*, "Polyhedra H- and V-Formats").

use std::fmt::Write;

use boundfit_exact::Rational;
use boundfit_geometry::{Constraint, Inequality, Polyhedron, RegionKind};

use crate::generators::{Generator, GeneratorKind, generators};

/// A matrix under construction.
struct Matrix {
    /// A line for each row.
    lines: String,
    rows: usize,
    /// The rows on the `linearity` line, from 1.
    linear: Vec<usize>,
    /// True while every number is an integer.
    is_whole: bool,
}

impl Default for Matrix {
    fn default() -> Self {
        Matrix { lines: String::new(), rows: 0, linear: Vec::new(), is_whole: true }
    }
}

impl Matrix {
    fn push(&mut self, row: [Rational; 3]) {
        let [first, second, third] = &row;
        // Writing to a String never fails.
        let _ = writeln!(self.lines, "{first} {second} {third}");
        self.rows += 1;
        self.is_whole &= row.iter().all(|number| number.denominator() == 1.into());
    }

    fn push_linear(&mut self, row: [Rational; 3]) {
        self.push(row);
        self.linear.push(self.rows);
    }

    /// The file, with `integer` when every number is one.
    fn text(&self, representation: &str) -> String {
        let mut text = format!("{representation}\n");
        if !self.linear.is_empty() {
            text += &format!("linearity {}", self.linear.len());
            self.linear.iter().for_each(|row| text += &format!(" {row}"));
            text.push('\n');
        }
        let kind = if self.is_whole { "integer" } else { "rational" };
        text += &format!("begin\n{} 3 {kind}\n", self.rows);
        text + &self.lines + "end\n"
    }
}

/// A minimal H-representation: a row `b -a1 -a2` for each irredundant inequality a1·θ1 + a2·θ2 ≤ b, with the numbers as
/// given. Exact.
///
/// A set within a line has its equations as linearity rows: one for the line, two for a point. The plane has the row
/// `1 0 0`, since lrs takes no matrix without rows; the empty set has the at most three inequalities that prove it empty.
/// Cost: linear.
pub fn h_representation(polyhedron: &Polyhedron) -> String {
    let system = polyhedron.system();
    let row = |Inequality { a: [a1, a2], b }: &Inequality| [b.clone(), -a1, -a2];
    let mut matrix = Matrix::default();
    match polyhedron.kind() {
        RegionKind::Plane => matrix.push([1, 0, 0].map(Rational::from)),
        RegionKind::Point => {
            for point in polyhedron.region().vertices() {
                let [theta1, theta2] = point.point().coordinates();
                matrix.push_linear([-theta1, Rational::one(), Rational::zero()]);
                matrix.push_linear([-theta2, Rational::zero(), Rational::one()]);
            }
        }
        kind => {
            let irredundant = polyhedron.irredundant();
            let constraints = system.constraints();
            let opposite = |index: usize| match constraints.get(index) {
                Some(Constraint::HalfPlane(half_plane)) => {
                    let opposite = Constraint::HalfPlane(half_plane.opposite());
                    irredundant.iter().copied().find(|&other| constraints.get(other) == Some(&opposite))
                }
                _ => None,
            };
            let is_flat = matches!(kind, RegionKind::Segment | RegionKind::Ray | RegionKind::Line);
            for &index in &irredundant {
                let inequality = &system.inequality(index);
                // Only a set within a line has few sides, so that each may be looked for among all.
                match if is_flat { opposite(index) } else { None } {
                    Some(other) if other < index => {}
                    Some(_) => matrix.push_linear(row(inequality)),
                    None => matrix.push(row(inequality)),
                }
            }
        }
    }
    matrix.text("H-representation")
}

/// A minimal V-representation: the vertices as rows `1 x y` in their order, then rays and lines `0 x y`, the lines as
/// linearity rows. Exact.
///
/// A set without vertices has the points of its boundary lines nearest to the origin in their place, the plane the
/// origin. The empty set has no row, as cdd writes it; neither cdd nor lrs reads that. Cost: linear.
pub fn v_representation(polyhedron: &Polyhedron) -> String {
    let mut matrix = Matrix::default();
    for Generator { kind, coordinates: [theta1, theta2], .. } in generators(polyhedron.region()) {
        match kind {
            GeneratorKind::Vertex | GeneratorKind::Point => matrix.push([Rational::one(), theta1, theta2]),
            GeneratorKind::Ray => matrix.push([Rational::zero(), theta1, theta2]),
            GeneratorKind::Line => matrix.push_linear([Rational::zero(), theta1, theta2]),
        }
    }
    matrix.text("V-representation")
}
