//! The surface that is drawn on.
//!
//! Plotters counts in whole pixels. The canvas is therefore ten times larger than the nominal size, and the picture
//! scaled back when it is written.

use plotters::coord::Shift;
use plotters::drawing::DrawingAreaErrorKind;
use plotters::prelude::{DrawingArea, SVGBackend};

/// Distance of texts from the left edge of the picture.
pub(super) const MARGIN: f64 = 14.0;
/// Canvas units per nominal pixel.
pub(super) const FINE: f64 = 10.0;

pub(super) type Canvas<'a> = DrawingArea<SVGBackend<'a>, Shift>;
pub(super) type CanvasResult<T = ()> = Result<T, DrawingAreaErrorKind<std::io::Error>>;
