//! The reason why a figure cannot be drawn.

use plotters::drawing::DrawingAreaErrorKind;
use thiserror::Error;

/// The reason why a figure could not be drawn. Data cannot be the reason; only the libraries underneath can.
#[derive(Debug, Error)]
#[error("the figure cannot be drawn: {0}")]
pub struct FigureError(pub(crate) String);

impl FigureError {
    /// Returns the error of a canvas.
    pub(crate) fn of_canvas(error: DrawingAreaErrorKind<std::io::Error>) -> Self {
        FigureError(error.to_string())
    }
}
