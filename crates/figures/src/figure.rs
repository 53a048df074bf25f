//! The figures that exist, and the options for drawing them.

use boundfit_exact::{Foreign, Rational};

/// The figure to draw.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Figure {
    /// All readings of the file with their error bars, the fitted ones marked, and the least-squares line.
    Data,
    /// The band of all lines with parameters in the EUI box.
    Eui,
    /// The band of all lines with parameters in the PUI box.
    Pui,
    /// The feasible parameter set with its boxes and estimates.
    Fps,
    /// The band that the feasible lines really cover, inside that of the PUI box.
    Corridor,
    /// The hull of the optimisers of linear programs and the polygon of their supporting half-planes, around the set.
    Directions,
    /// Every reading by its residual and leverage against the set of the others, with the regions of statuses.
    Status,
    /// The remaining set without the fewest readings that have to be left out.
    Outliers,
    /// The readings with the line of the longest run that fits, and a bar for every run.
    Range,
    /// The distance of the feasible lines over x, and where a further reading certainly makes the set smaller.
    Next,
}

impl Figure {
    /// The figures of every fit: what `--figure all` draws.
    pub const OF_FIT: [Figure; 6] =
        [Figure::Data, Figure::Eui, Figure::Pui, Figure::Fps, Figure::Corridor, Figure::Directions];
    /// All figures: those of every fit, and those that answer a question of their own.
    pub const ALL: [Figure; 10] = [
        Figure::Data,
        Figure::Eui,
        Figure::Pui,
        Figure::Fps,
        Figure::Corridor,
        Figure::Directions,
        Figure::Status,
        Figure::Outliers,
        Figure::Range,
        Figure::Next,
    ];

    /// A short name, fit for a file: `data`, `eui` and so on.
    pub fn name(self) -> &'static str {
        match self {
            Figure::Data => "data",
            Figure::Eui => "eui",
            Figure::Pui => "pui",
            Figure::Fps => "fps",
            Figure::Corridor => "corridor",
            Figure::Directions => "directions",
            Figure::Status => "status",
            Figure::Outliers => "outliers",
            Figure::Range => "range",
            Figure::Next => "next",
        }
    }

    /// The content, in a few words.
    pub fn title(self) -> &'static str {
        match self {
            Figure::Data => "Readings with error bars and the least-squares line",
            Figure::Eui => "Band of the lines at the corners of the EUI box",
            Figure::Pui => "Band of the lines at the corners of the PUI box",
            Figure::Fps => "The feasible parameter set",
            Figure::Corridor => "Band of all feasible lines, inside that of the PUI box",
            Figure::Directions => "Inner and outer approximation from linear programs",
            Figure::Status => "Statuses: residual and leverage of each reading against the others",
            Figure::Outliers => "What is left without the fewest readings that have to be left out",
            Figure::Range => "Linear range: the line of the longest run that fits, and all runs",
            Figure::Next => "Where a further reading certainly makes the set smaller",
        }
    }
}

/// The options for drawing a figure.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PlotOptions {
    /// Unit of x for the axes; with two regressors, of both.
    pub x_unit: Option<Foreign>,
    /// Unit of y for the axes.
    pub y_unit: Option<Foreign>,
    /// The line above the figure; a plain description when left out. An empty one leaves out what stands above the panels.
    pub title: Option<Foreign>,
    /// The name of the horizontal axis, or of its coordinate where axes are flipped, in place of the one that follows from the
    /// data; it may be empty.
    pub x_label: Option<Foreign>,
    /// The name of the other axis.
    pub y_label: Option<Foreign>,
    /// The ends of the axis of x, or of θ1, the lower one first.
    pub x_range: Option<[Rational; 2]>,
    /// The ends of the axis of y, or of θ2.
    pub y_range: Option<[Rational; 2]>,
    /// The width of the picture in micrometres: everything on it is scaled alike, but for letters of a size of their own. 800 pixels of 1/96 inch when left out.
    pub width: Option<u32>,
    /// The size of letters in micrometres: panels get what these leave. 3/200 of the width when left out.
    pub letters: Option<u32>,
    /// `true` if it is drawn in greys.
    pub greyscale: bool,
    /// `true` if the response runs along the horizontal axis of figures of the data plane.
    pub flip: bool,
    /// The number of directions of [`Figure::Directions`], at least 3.
    pub directions: usize,
    /// `true` if these are spread evenly where the box of both intervals is a square, and not in the plane of the parameters.
    pub are_directions_scaled: bool,
}

impl Default for PlotOptions {
    /// No units, plain titles and names, all that there is to see, the usual size in colours, the response upwards, 16 directions.
    fn default() -> Self {
        PlotOptions {
            x_unit: None,
            y_unit: None,
            title: None,
            x_label: None,
            y_label: None,
            x_range: None,
            y_range: None,
            width: None,
            letters: None,
            greyscale: false,
            flip: false,
            directions: 16,
            are_directions_scaled: false,
        }
    }
}
