//! Sets of half-planes and of generators.

use std::io::Cursor;

use boundfit::engine::exact::Foreign;
use boundfit::files::{HalfPlaneFile, SizeLimits, Source, TableOptions, read_half_planes};
use boundfit::report::{
    Style, h_representation, polygon_document, polygon_json, region_wkt, v_representation,
};
use boundfit::{Polyhedron, Rational, Reading};
use pyo3::prelude::*;

use crate::numbers::{Given, Number, pair, reading_named, refuse};
use crate::words::{in_words, refused};

/// Half-planes with the set that they leave.
#[pyclass(frozen, module = "boundfit._boundfit")]
pub(crate) struct Plane {
    file: HalfPlaneFile,
    polyhedron: Polyhedron,
    name: Option<String>,
    reading: Reading,
    /// The meaning of a float.
    floats: Reading,
}

/// The set of an H- or V-representation, whose numbers are exactly as written; what a float means in questions about it.
#[pyfunction]
pub(crate) fn polygon_of_text(py: Python<'_>, text: String, floats: &str) -> PyResult<Plane> {
    let floats = reading_named(floats)?;
    let plane = py.detach(|| Plane::read(Source::new("polygon", Cursor::new(text)), None, Reading::Decimal));
    Ok(Plane { floats, ..plane.map_err(refuse)? })
}

/// The set of a file of half-planes or generators.
#[pyfunction]
pub(crate) fn polygon_of_file(py: Python<'_>, path: String, reading: &str) -> PyResult<Plane> {
    let reading = reading_named(reading)?;
    let plane = py.detach(|| {
        let source = Source::open(&path)?;
        Ok(Plane::read(source, Some(path), reading))
    });
    plane.map_err(|error| refused(py, &error, false))?.map_err(refuse)
}

impl Plane {
    fn read(source: Source, name: Option<String>, reading: Reading) -> Result<Self, String> {
        let options = TableOptions { reading, ..TableOptions::default() };
        let file = read_half_planes(source, &options).map_err(|error| in_words(&error, false))?;
        file.system.work().check(2, SizeLimits::default().work).map_err(|error| error.to_string())?;
        let polyhedron = Polyhedron::intersect(file.system.clone());
        Ok(Plane { file, polyhedron, name, reading, floats: reading })
    }
}

#[pymethods]
impl Plane {
    #[getter]
    fn kind(&self) -> &'static str {
        self.polyhedron.region().kind().name()
    }

    /// Returns the meaning of floats in questions about it.
    #[getter]
    fn reading(&self) -> &'static str {
        self.floats.name()
    }

    fn vertices<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let vertices = self.polyhedron.region().vertices().iter();
        vertices.map(|vertex| Ok(pair(&vertex.point().coordinates()).into_pyobject(py)?.into_any())).collect()
    }

    fn directions<'py>(&self, py: Python<'py>, lines: bool) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let region = self.polyhedron.region();
        let directions = if lines { region.lines() } else { region.rays() };
        let numbers = directions.iter().map(|d| [d.dx(), d.dy()].map(Rational::from));
        numbers.map(|theta| Ok(pair(&theta).into_pyobject(py)?.into_any())).collect()
    }

    fn area<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        let area = self.polyhedron.region().area();
        area.map(|area| Number(&area).into_pyobject(py)).transpose()
    }

    /// The box around the set, two ends for each axis; nothing of an empty set.
    fn bounds<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        let Some(bounds) = self.polyhedron.bounding_box() else { return Ok(None) };
        let ends =
            bounds.each_ref().map(|own| [own.lower().value().map(Number), own.upper().value().map(Number)]);
        Ok(Some(ends.into_pyobject(py)?.into_any()))
    }

    /// The rows, from 0, without which the set is the same.
    fn redundant(&self) -> Vec<usize> {
        let needed = self.polyhedron.irredundant();
        (0..self.file.system.len()).filter(|index| needed.binary_search(index).is_err()).collect()
    }

    fn contains(&self, theta1: Given, theta2: Given) -> PyResult<bool> {
        let theta = [theta1.number(self.floats, "theta1")?, theta2.number(self.floats, "theta2")?];
        Ok(!self.polyhedron.region().is_empty() && self.polyhedron.membership(&theta).is_inside())
    }

    fn json(&self, py: Python<'_>) -> String {
        let name = self.name.as_deref().map(Foreign::of);
        py.detach(|| polygon_json(&self.file, &self.polyhedron, name, self.reading, &Style::default()))
    }

    fn text(&self, format: &str) -> PyResult<String> {
        let name = Foreign::of(self.name.as_deref().unwrap_or("a polygon"));
        let document = || polygon_document(&self.file, &self.polyhedron, name, &Style::default());
        Ok(match format {
            "text" => document().to_text(),
            "markdown" => document().to_markdown(),
            "latex" => document().to_latex(),
            "wkt" => region_wkt(&self.polyhedron, &Style::default()).map_err(refuse)?,
            "ine" => h_representation(&self.polyhedron),
            "ext" => v_representation(&self.polyhedron),
            other => {
                return Err(refuse(format_args!(
                    "format={other:?}: expected \"text\", \"markdown\", \"latex\", \"wkt\", \"ine\" or \"ext\""
                )));
            }
        })
    }
}
