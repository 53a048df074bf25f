//! A build without the feature `outlines`: texts of an SVG stay texts, and there are neither PNG nor PDF; see `outlines.rs`.

use crate::error::FigureError;

/// Nothing.
#[derive(Debug, Clone)]
pub(crate) struct Outlines;

impl Outlines {
    pub(crate) fn of(_: &str) -> Result<Self, FigureError> {
        Ok(Outlines)
    }

    pub(crate) fn svg(&self) -> Option<String> {
        None
    }

    pub(crate) fn view(&self) -> String {
        String::new()
    }

    pub(crate) fn png(&self, _: u16) -> Result<Vec<u8>, FigureError> {
        missing("PNG")
    }

    pub(crate) fn pdf(&self, _: &str, _: &str) -> Result<Vec<u8>, FigureError> {
        missing("PDF")
    }
}

fn missing<T>(kind: &str) -> Result<T, FigureError> {
    Err(FigureError(format!(
        "this build writes no {kind}: it is without the feature \"outlines\"; SVG has no need of it"
    )))
}
