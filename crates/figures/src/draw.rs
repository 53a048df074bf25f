//! From a fit to a picture.

use boundfit_estimation::{Fit, Problem};

use crate::figure::{Figure, PlotOptions};
use crate::picture::{FigureError, Picture};
use crate::text::one_line;
use crate::{data_plane, parameter_plane, render};

/// Draws a figure of a fit. Cost: linear in the readings; [`Figure::Directions`] solves a linear program per direction.
///
/// # Errors
/// Only when a library underneath fails.
pub fn draw(
    problem: &Problem,
    fit: &Fit,
    figure: Figure,
    options: &PlotOptions,
) -> Result<Picture, FigureError> {
    let mut drawing = match figure {
        Figure::Data | Figure::Eui | Figure::Pui | Figure::Corridor => {
            data_plane::drawing(problem, fit, figure, options)
        }
        Figure::Fps => parameter_plane::fps(problem, fit, options),
        Figure::Directions => parameter_plane::directions(problem, fit, options),
    };
    drawing.keep_legend_of_drawn();
    if let Some(title) = &options.title {
        drawing.title = one_line(title, 90);
    }
    render::render(&drawing)
}
