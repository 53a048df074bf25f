//! The options of a lesson, and the reasons why there is none.

use boundfit_exact::Foreign;
use boundfit_exact::english::counted;
use thiserror::Error;

use crate::texts::Language;

/// The most readings that a lesson is made for unless more are asked for: what the page shows grows with their square.
pub const MOST_ROWS: usize = 300;

/// The most readings that can be asked for.
pub const MOST_ROWS_EVER: u16 = 2000;

/// The page's statements about the data besides those that follow from them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LessonOptions {
    /// The source of the readings; only the file's name of a path is shown.
    pub file: Foreign,
    /// The title; made of the file and the columns when `None`.
    pub title: Option<Foreign>,
    /// Unit of x, or of both regressors.
    pub x_unit: Option<Foreign>,
    /// Unit of y.
    pub y_unit: Option<Foreign>,
    /// The language that the page speaks at first; it has all of them.
    pub language: Language,
    /// The most readings that a page is made for.
    pub most_rows: usize,
}

impl Default for LessonOptions {
    /// No words but those that follow from the data, and at most [`MOST_ROWS`] readings.
    fn default() -> Self {
        LessonOptions {
            file: Foreign::default(),
            title: None,
            x_unit: None,
            y_unit: None,
            language: Language::default(),
            most_rows: MOST_ROWS,
        }
    }
}

/// The reason why there is no lesson.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum LessonError {
    /// More readings than a page can show.
    #[error(
        "more than {} for a lesson",
        counted(*.limit, "reading is too many", "readings are too many")
    )]
    TooManyRows {
        /// The number of readings, as far as they were read.
        rows: usize,
        /// The largest number of readings.
        limit: usize,
    },
    /// A page that the engine alone fills, where there is none.
    #[error("this build has no engine for pages (feature engine, which `cargo install` turns on)")]
    NoEngine,
    /// A picture that cannot be drawn.
    #[cfg(feature = "figures")]
    #[error(transparent)]
    Figure(#[from] boundfit_figures::FigureError),
    /// A report that cannot be embedded.
    #[error("cannot embed a report: {0}")]
    Json(#[from] serde_json::Error),
}
