//! Sets of half-planes and of generators.

use std::io::Cursor;

use boundfit::ask::{Ask, Form, Polygon, Readings, Refusal, Shows, Subject};
use boundfit::engine::exact::Foreign;
use boundfit::files::{HalfPlaneFile, Source};
use boundfit::report::{Origin, Style};
use boundfit::{Polyhedron, Rational, Reading};
use pyo3::prelude::*;

use crate::forms::named;
use crate::numbers::{Given, Number, pair, reading_named};
use crate::questions::refused;

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
    Ok(Plane { floats, ..plane.map_err(|refusal| refused(py, &refusal, false))? })
}

/// The set of a file of half-planes or generators.
#[pyfunction]
pub(crate) fn polygon_of_file(py: Python<'_>, path: String, reading: &str) -> PyResult<Plane> {
    let reading = reading_named(reading)?;
    let plane = py.detach(|| Plane::read(Source::open(&path)?, Some(path), reading));
    plane.map_err(|refusal| refused(py, &refusal, false))
}

impl Plane {
    fn read(source: Source, name: Option<String>, reading: Reading) -> Result<Self, Refusal> {
        let asked = Readings::default().resolve_for(Subject::HalfPlanes, reading)?;
        let file = Polygon {}.read(&asked, source, Shows::Hash)?;
        let polyhedron = Polygon {}.answer(&file)?;
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

    /// Writes one form of the answer. In JSON a set that is no file has no name.
    fn text(&self, py: Python<'_>, format: &str) -> PyResult<String> {
        let form = named(format)?;
        let file = self.name.as_deref().or((form != Form::Json).then_some("a polygon")).map(Foreign::of);
        let origin = Origin { file, reading: self.reading, is_stored: false };
        let text = || Polygon {}.text(&self.file, &self.polyhedron, form, origin, Style::default());
        Ok(py.detach(text).map_err(|refusal| refused(py, &refusal, false))?.text)
    }
}
