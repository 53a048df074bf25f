//! V-representations: a row `1 x y` is a point, `0 x y` a ray, and `0 x y` on a `linearity` line a line.
//!
//! As in cdd and lrs, any positive first number makes the row a point in homogeneous coordinates: `w x y` is
//! `(x / w, y / w)`. A file with rays or lines but no point is the cone with its apex at the origin. Without any row
//! the set is empty, as cdd writes it. A negative first number and a point on a `linearity` line are refused. Both
//! programs take them for generators of the cone above the plane, and their formats do not describe that.

use boundfit_geometry::{Direction, Generator, Generators, Point};

use crate::error::{InputError, InputErrorKind};
use crate::half_planes::file::{GeneratorRows, HalfPlaneFile, RowOrigin};

use super::words::MatrixRow;

/// The half-planes of the set that rows generate.
pub(super) fn from_generators(
    file: &str,
    rows: &[MatrixRow<'_>],
    sha256: String,
) -> Result<HalfPlaneFile, InputError> {
    let generator = |row: &MatrixRow<'_>| generator(row).map_err(|problem| row.start.error(file, problem));
    let mut generators = rows.iter().map(generator).collect::<Result<Generators, _>>()?;
    let has_point = generators.as_slice().iter().any(|generator| matches!(generator, Generator::Point(_)));
    if !has_point && !rows.is_empty() {
        generators.push(Generator::Point(Point::origin()));
    }
    let polyhedron = generators.polyhedron();
    let rows_spanning = |indices: Vec<usize>| -> Vec<usize> {
        indices.into_iter().map(|index| index + 1).filter(|row| *row <= rows.len()).collect()
    };
    let spanning = generators.spanning(&polyhedron).into_iter().map(rows_spanning).collect();
    let system = polyhedron.system().clone();
    let origins = (1..=system.len()).map(|row| RowOrigin { row, reversed: false }).collect();
    let generators = Some(GeneratorRows { generators, spanning });
    Ok(HalfPlaneFile { system, origins, rows: rows.len(), sha256, generators, table: None, layout: None })
}

/// The meaning of a row.
fn generator(row: &MatrixRow<'_>) -> Result<Generator, InputErrorKind> {
    let [w, x, y] = &row.numbers;
    if w.is_negative() {
        return Err(InputErrorKind::NegativeWeight);
    }
    if let (Some(theta1), Some(theta2)) = (x.checked_div(w), y.checked_div(w)) {
        let point = Generator::Point(Point::new(&theta1, &theta2));
        return if row.is_linear { Err(InputErrorKind::LinearPoint) } else { Ok(point) };
    }
    let direction = Direction::from_rational(&[x.clone(), y.clone()]);
    Ok(match direction {
        None => Generator::Zero,
        Some(direction) if row.is_linear => Generator::Line(direction),
        Some(direction) => Generator::Ray(direction),
    })
}
