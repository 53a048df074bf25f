//! Figures of a bounded-error fit: readings, bands and the feasible parameter set as SVG, PNG, PDF and source for TikZ.
//!
//! [`draw`] makes a [`Picture`] of a [`Figure`]; the picture is one and the same in all encodings. Every number goes
//! into a figure exactly and becomes a float only as a fraction of the axis it is shown on. Unbounded sets are cut at
//! the edge of the view when they are drawn, and nowhere else. Equal input gives equal bytes.
//!
//! | to | modules |
//! |---|---|
//! | choose and describe a figure | `figure`, `series`, `labels`, `extent` |
//! | collect what is on it | `draw`, `drawing`, `data_plane`, `parameter_plane`, `status`, `linearity`, `next`, `groups`, `x_errors` |
//! | place it | `axis`, `clip`, `page`, `text`, `palette`, `outside` |
//! | write it | `picture`, `render`, `outlines`, `pdf`, `tex` |
//!
//! ```
//! use boundfit_estimation::{ErrorBound, Measurement, Measurements, Model, Problem, fit};
//! use boundfit_exact::Rational;
//! use boundfit_figures::{Figure, PlotOptions, draw};
//!
//! let bound = Rational::ratio(1, 2);
//! let rows = [(1, 1), (2, 3), (3, 4)].iter().zip(1..).map(|(&(x, y), row)| {
//!     let regressor = [Rational::from(x), Rational::one()];
//!     Measurement::around(row, regressor, Rational::from(y), bound.clone())
//! });
//! let (model, rows) = (Model::Line { x: "x".into() }, rows.collect());
//! let measurements = Measurements::new(model, "y".into(), ErrorBound::Uniform(bound.clone()), rows);
//! let problem = Problem { measurements, conditions: Vec::new() };
//! let picture = draw(&problem, &fit(&problem), Figure::Fps, &PlotOptions::default())?;
//! assert!(picture.svg()?.starts_with("<svg"));
//! # Ok::<(), boundfit_figures::FigureError>(())
//! ```

mod axis;
mod clip;
mod data_plane;
mod draw;
mod drawing;
mod error;
mod extent;
mod figure;
mod groups;
mod labels;
mod linearity;
mod next;
#[cfg_attr(not(feature = "outlines"), path = "no_outlines.rs")]
mod outlines;
mod outside;
mod page;
mod palette;
mod parameter_plane;
#[cfg(feature = "outlines")]
mod pdf;
mod picture;
mod render;
#[cfg(test)]
mod samples;
mod series;
mod status;
#[cfg(feature = "tikz")]
mod tex;
mod text;
mod x_errors;

pub use draw::{
    draw, draw_boxes, draw_compared, draw_groups, draw_outliers, draw_program, draw_region, draw_sweep,
    draw_sweep_of_corridors, draw_x_errors,
};
pub use error::FigureError;
pub use figure::{Figure, PlotOptions};
pub use groups::MOST_PANELS;
pub use linearity::draw_linearity;
pub use picture::{Encoding, Picture, PictureFormat};
pub use series::{Compared, MOST_COMPARED, Series};
