//! Figures of a fit, and the page about it.

use boundfit::engine::exact::Foreign;
use boundfit::figures::{Figure, PictureFormat, PlotOptions, draw};
use boundfit::lesson::{LessonOptions, page};
use pyo3::prelude::*;

use crate::fitted::Fitted;
use crate::numbers::refuse;

/// What a figure says besides what follows from the readings.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Labels {
    title: Option<String>,
    x_unit: Option<String>,
    y_unit: Option<String>,
    flip: bool,
}

/// A figure as SVG, or as the bytes of a PNG.
#[pyfunction]
pub(crate) fn figure(
    py: Python<'_>,
    fitted: &Fitted,
    figure: &str,
    format: &str,
    labels: Labels,
) -> PyResult<Vec<u8>> {
    let all = || Figure::ALL.map(|own| format!("{:?}", own.name())).join(", ");
    let asked = Figure::ALL.into_iter().find(|own| own.name() == figure);
    let asked = asked.ok_or_else(|| refuse(format_args!("figure={figure:?}: expected one of {}", all())))?;
    let format = if format == "png" { PictureFormat::Png } else { PictureFormat::Svg };
    let foreign = |text: Option<String>| text.map(Foreign::from);
    let options = PlotOptions {
        title: foreign(labels.title),
        x_unit: foreign(labels.x_unit),
        y_unit: foreign(labels.y_unit),
        flip: labels.flip,
        ..PlotOptions::default()
    };
    py.detach(|| draw(&fitted.problem, &fitted.fit, asked, &options)?.encoded(format)).map_err(refuse)
}

/// The web page about these readings.
#[pyfunction]
#[pyo3(signature = (fitted, title))]
pub(crate) fn lesson(py: Python<'_>, fitted: &Fitted, title: Option<String>) -> PyResult<String> {
    let file = fitted.file.clone().unwrap_or_else(|| "readings".to_owned());
    let options =
        LessonOptions { file: file.into(), title: title.map(Foreign::from), ..LessonOptions::default() };
    py.detach(|| page(&fitted.problem, &fitted.fit, fitted.reading, &options)).map_err(refuse)
}
