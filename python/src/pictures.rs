//! Figures of a fit, and the page about it.

use boundfit::Rational;
use boundfit::engine::exact::Foreign;
use boundfit::figures::{Encoding, Figure, PictureFormat, PlotOptions, draw};
use boundfit::lesson::{LessonOptions, page};
use pyo3::prelude::*;

use crate::fitted::Fitted;
use crate::numbers::{decimal, refuse};
use crate::waiting::waiting;

/// The words of a figure that do not follow from the readings, and its looks.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Labels {
    title: Option<String>,
    x_unit: Option<String>,
    y_unit: Option<String>,
    x_label: Option<String>,
    y_label: Option<String>,
    x_range: Option<[String; 2]>,
    y_range: Option<[String; 2]>,
    /// The width of the picture in millimetres.
    width: Option<f64>,
    /// The size of letters in points of 1/72 inch.
    font_size: Option<f64>,
    dpi: Option<u16>,
    greyscale: bool,
    real_text: bool,
    flip: bool,
    directions: usize,
    scaled: bool,
}

impl Labels {
    fn options(self) -> PyResult<PlotOptions> {
        let foreign = |text: Option<String>| text.map(Foreign::from);
        let options = PlotOptions {
            title: foreign(self.title),
            x_unit: foreign(self.x_unit),
            y_unit: foreign(self.y_unit),
            x_label: foreign(self.x_label),
            y_label: foreign(self.y_label),
            x_range: range(self.x_range, "x_range")?,
            y_range: range(self.y_range, "y_range")?,
            width: length(self.width, 1e3, [10.0, 2000.0], "width", "millimetres")?,
            letters: length(self.font_size, 25_400.0 / 72.0, [1.0, 200.0], "font_size", "points")?,
            greyscale: self.greyscale,
            flip: self.flip,
            directions: self.directions,
            are_directions_scaled: self.scaled,
        };
        match options.have_letters_room() {
            true => Ok(options),
            false => Err(refuse(
                "with font_size a picture has to be 27 to 266 times as wide as its letters are large: change it, or width",
            )),
        }
    }
}

/// The ends of an axis, the lower one first.
fn range(ends: Option<[String; 2]>, name: &str) -> PyResult<Option<[Rational; 2]>> {
    let Some([lower, upper]) = ends else { return Ok(None) };
    let ends = [decimal(&lower, name)?, decimal(&upper, name)?];
    match ends[0] < ends[1] {
        true => Ok(Some(ends)),
        false => Err(refuse(format_args!("{name}: the lower end is not below the upper one"))),
    }
}

/// A length in micrometres from one in other units, between these.
fn length(
    length: Option<f64>,
    micrometres: f64,
    [least, most]: [f64; 2],
    name: &str,
    units: &str,
) -> PyResult<Option<u32>> {
    match length {
        None => Ok(None),
        Some(length) if (least..=most).contains(&length) => Ok(Some((length * micrometres).round() as u32)),
        Some(length) => Err(refuse(format_args!("{name}={length}: expected {least} to {most} {units}"))),
    }
}

/// A figure as the bytes of a file of this format.
#[pyfunction]
pub(crate) fn figure(
    fitted: &Bound<'_, Fitted>,
    figure: &str,
    format: &str,
    labels: Labels,
) -> PyResult<Vec<u8>> {
    let all = || Figure::ALL.map(|own| format!("{:?}", own.name())).join(", ");
    let asked = Figure::ALL.into_iter().find(|own| own.name() == figure);
    let asked = asked.ok_or_else(|| refuse(format_args!("figure={figure:?}: expected one of {}", all())))?;
    let formats = || PictureFormat::ALL.map(|own| format!("{:?}", own.name())).join(", ");
    let wanted = PictureFormat::ALL.into_iter().find(|own| own.name() == format);
    let format =
        wanted.ok_or_else(|| refuse(format_args!("format={format:?}: expected one of {}", formats())))?;
    let plain = Encoding::default();
    let encoding = Encoding { real_text: labels.real_text, dpi: labels.dpi.unwrap_or(plain.dpi) };
    if asked == Figure::Status && (labels.x_range.is_some() || labels.y_range.is_some()) {
        return Err(refuse("x_range, y_range: the axes of \"status\" are residuals and leverages"));
    }
    let options = labels.options()?;
    let held = fitted.clone().unbind();
    let picture = waiting(fitted.py(), move |_| {
        let own = held.get();
        draw(own.problem(), own.fit(), asked, &options)?.encoded_as(format, &encoding)
    })?;
    picture.map_err(refuse)
}

/// The web page about these readings.
#[pyfunction]
#[pyo3(signature = (fitted, title))]
pub(crate) fn lesson(fitted: &Bound<'_, Fitted>, title: Option<String>) -> PyResult<String> {
    let file = fitted.get().file.clone().unwrap_or_else(|| "readings".to_owned());
    let options =
        LessonOptions { file: file.into(), title: title.map(Foreign::from), ..LessonOptions::default() };
    let held = fitted.clone().unbind();
    let page = waiting(fitted.py(), move |_| {
        let own = held.get();
        page(own.problem(), own.fit(), own.reading, &options)
    })?;
    page.map_err(refuse)
}
