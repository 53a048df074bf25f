//! The way from a fit to a picture.

use boundfit_estimation::{Family, Fit, Problem};
use boundfit_exact::{Foreign, Rational};
use boundfit_geometry::Polyhedron;
use boundfit_questions::{OutlierLimits, Outliers, XErrorFit, XErrorProblem};

use crate::drawing::Drawing;
use crate::error::FigureError;
use crate::figure::{Figure, PlotOptions};
use crate::page::Page;
use crate::picture::Picture;
use crate::render::Look;
use crate::series::{Compared, Series};
use crate::text::{self, one_line};
use crate::{data_plane, groups, next, parameter_plane, render, status};

/// Draws a figure of a fit. Cost: linear in the readings; [`Figure::Directions`] solves a linear program per direction, and
/// [`Figure::Status`] and [`Figure::Range`] take O(N log N). [`Figure::Outliers`] looks for them first: where that has no answer or
/// takes too long, it is the feasible set.
///
/// # Errors
/// Only when a library underneath fails.
pub fn draw(
    problem: &Problem,
    fit: &Fit,
    figure: Figure,
    options: &PlotOptions,
) -> Result<Picture, FigureError> {
    let drawing = match figure {
        Figure::Data | Figure::Eui | Figure::Pui | Figure::Corridor => {
            data_plane::drawing(problem, fit, figure, options)
        }
        Figure::Fps => parameter_plane::fps(problem, fit, options),
        Figure::Directions => parameter_plane::directions(problem, fit, options),
        Figure::Range => data_plane::runs(problem, options),
        Figure::Next => next::drawing(problem, fit, options),
        Figure::Status => status::drawing(problem, fit, options),
        Figure::Outliers => match Outliers::new(problem, &OutlierLimits::default()) {
            Ok(outliers) => parameter_plane::outliers(problem, &outliers, options),
            Err(_) => parameter_plane::fps(problem, fit, options),
        },
    };
    finished(drawing, options)
}

/// Draws what is left without outliers, which are known. Cost: linear in the vertices of what is left.
///
/// # Errors
/// Only when a library underneath fails.
pub fn draw_outliers(
    problem: &Problem,
    outliers: &Outliers,
    options: &PlotOptions,
) -> Result<Picture, FigureError> {
    finished(parameter_plane::outliers(problem, outliers, options), options)
}

/// Draws feasible sets under growing error bounds, one in another. It shows five of the family, evenly spread from
/// the smallest that is not empty, and the set of the bounds as given. Returns `None` where no factor of the family
/// leaves any parameters. Cost: linear in the vertices.
///
/// # Errors
/// Only when a library underneath fails.
pub fn draw_sweep(
    problem: &Problem,
    family: &Family,
    options: &PlotOptions,
) -> Result<Option<Picture>, FigureError> {
    parameter_plane::nested::drawing(problem, family, options)
        .map(|drawing| finished(drawing, options))
        .transpose()
}

/// Draws the corridors of the lines of feasible sets under growing error bounds, one in another, as [`draw_sweep`]
/// draws the sets. Returns `None` where no factor of the family leaves any parameters. Cost: linear in the readings
/// and in the vertices.
///
/// # Errors
/// Only when a library underneath fails.
pub fn draw_sweep_of_corridors(
    problem: &Problem,
    fit: &Fit,
    family: &Family,
    options: &PlotOptions,
) -> Result<Option<Picture>, FigureError> {
    let drawing = data_plane::nested(problem, fit, family, options);
    drawing.map(|drawing| finished(drawing, options)).transpose()
}

/// Draws several fits in one panel, in colours and dashes that differ: more than [`crate::MOST_COMPARED`] begin again with the first ones.
/// The legend names each, an empty one as well. Units that the options leave out are those that each file states. Cost: linear in the
/// readings.
///
/// # Errors
/// Only when a library underneath fails.
pub fn draw_compared(
    series: &[Series],
    what: Compared,
    options: &PlotOptions,
) -> Result<Picture, FigureError> {
    let drawing = match what {
        Compared::Sets => parameter_plane::several(series, options),
        Compared::Readings => data_plane::several(series, options),
    };
    finished(drawing, options)
}

/// Draws a panel for each of the first [`crate::MOST_PANELS`] groups, of `all`, that the column `by` makes; all have the same axes.
/// Cost: linear in the readings.
///
/// # Errors
/// Only when a library underneath fails.
pub fn draw_groups(
    groups: &[Series],
    by: &Foreign,
    all: usize,
    what: Compared,
    options: &PlotOptions,
) -> Result<Picture, FigureError> {
    finished(groups::drawing(groups, by, all, what, options), options)
}

/// Draws readings with errors in x as boxes, with the steepest and the shallowest line that agree with all of them.
/// If there are many readings, it draws some, evenly spread, and those that fix the lines. Cost: linear in the
/// readings.
///
/// # Errors
/// Only when a library underneath fails.
pub fn draw_boxes(
    problem: &XErrorProblem,
    answer: &XErrorFit,
    options: &PlotOptions,
) -> Result<Picture, FigureError> {
    finished(data_plane::boxes(problem, answer, options), options)
}

/// Draws the parameters of the lines that agree under errors in x: at most two convex sets, or of none the readings that contradict
/// each other. Cost: linear in the vertices, and of none in the readings.
///
/// # Errors
/// Only when a library underneath fails.
pub fn draw_x_errors(
    problem: &XErrorProblem,
    answer: &XErrorFit,
    options: &PlotOptions,
) -> Result<Picture, FigureError> {
    finished(parameter_plane::x_errors(problem, answer, options), options)
}

/// The last touches: the title that is asked for, no more legend than there is to explain, size and colours.
pub(crate) fn finished(mut drawing: Drawing, options: &PlotOptions) -> Result<Picture, FigureError> {
    drawing.keep_legend_of_drawn();
    if let Some(title) = &options.title {
        drawing.title = one_line(title, 90);
        if drawing.title.is_empty() {
            drawing.subtitle.clear();
        }
    }
    let look = Look { page: Page::of(options), greyscale: options.greyscale };
    let mut source = render::svg(&drawing, &look)?;
    if text::has_missing(&source) {
        drawing.notes.push(text::NOTE_OF_MISSING.to_owned());
        source = render::svg(&drawing, &look)?;
    }
    Ok(Picture::new(source, drawing, look))
}

/// Draws a linear program in two variables: the feasible set, the optimal points, and the direction in which the
/// objective improves. The objective is to be made large. The given title serves if the options have none. Of an empty
/// set it draws the half-planes that contradict each other. Cost: linear in the half-planes of the set.
///
/// # Errors
/// Only when a library underneath fails.
///
/// ```
/// use boundfit_exact::Rational;
/// use boundfit_figures::{PlotOptions, draw_program};
/// use boundfit_geometry::{Inequality, Polyhedron};
///
/// let row = |a1: i64, a2: i64, b: i64| Inequality::new(a1.into(), a2.into(), b.into());
/// let triangle = Polyhedron::intersect([row(-1, 0, 0), row(0, -1, 0), row(2, 3, 6)].into_iter().collect());
/// let names = ["x".into(), "y".into()];
/// let (gain, options) = ([Rational::one(), Rational::one()], PlotOptions::default());
/// let picture = draw_program(&triangle, &gain, &names, &"a triangle".into(), &options)?;
/// assert!(picture.svg()?.contains("optimal"));
/// # Ok::<(), boundfit_figures::FigureError>(())
/// ```
pub fn draw_program(
    polyhedron: &Polyhedron,
    gain: &[Rational; 2],
    names: &[Foreign; 2],
    title: &Foreign,
    options: &PlotOptions,
) -> Result<Picture, FigureError> {
    finished(parameter_plane::program(polyhedron, gain, names, title, options), options)
}

/// Draws a set of half-planes with its vertices, and arrows where it goes on without end, with this title where the options have
/// none. Of an empty set it draws the half-planes that contradict each other.
/// Cost: linear in the half-planes of the set.
///
/// # Errors
/// Only when a library underneath fails.
pub fn draw_region(
    polyhedron: &Polyhedron,
    names: &[Foreign; 2],
    title: &Foreign,
    options: &PlotOptions,
) -> Result<Picture, FigureError> {
    finished(parameter_plane::region_of_half_planes(polyhedron, names, title, options), options)
}
