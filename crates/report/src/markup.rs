//! Reports in markup languages.

use boundfit_estimation::{Family, Fit, Problem};
use boundfit_formats::HalfPlaneFile;
use boundfit_geometry::Polyhedron;

use crate::document::Block;
use crate::fit_blocks::fit_blocks;
use crate::fit_text::Origin;
use crate::latex::latex;
use crate::markdown::markdown;
use crate::polygon_text::polygon_blocks;
use crate::style::Style;

/// A markup language.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Markup {
    /// LaTeX: a fragment to be read into a document that uses the package `booktabs`.
    Latex,
    /// Markdown as GitHub and Pandoc read it.
    Markdown,
}

impl Markup {
    /// The report of a fit: the tables of the text report, with the same numbers, and those of a family over the error bound.
    pub fn fit(
        self,
        problem: &Problem,
        fit: &Fit,
        family: Option<&Family>,
        origin: &Origin,
        style: &Style,
    ) -> String {
        self.write(&fit_blocks(problem, fit, family, origin, style))
    }

    /// The report of half-planes: the tables of the text report, with the same numbers.
    pub fn polygon(self, file: &HalfPlaneFile, polyhedron: &Polyhedron, name: &str, style: &Style) -> String {
        self.write(&polygon_blocks(file, polyhedron, name, style))
    }

    fn write(self, blocks: &[Block]) -> String {
        match self {
            Markup::Latex => latex(blocks),
            Markup::Markdown => markdown(blocks),
        }
    }
}
