//! The report of a fit as blocks.

use boundfit_estimation::{Family, Fit, Problem};

use crate::document::{Block, Text};
use crate::fit_text::{FPS, Origin, PROOF_HEADER, PROOFS, TITLE, Writer};
use crate::region::{VERTEX_HEADER, region_lines, region_title, vertex_rows};
use crate::style::Style;
use crate::sweep_text::sweep_blocks;

/// The report, and that of a family over the error bound, as blocks.
pub(crate) fn fit_blocks(
    problem: &Problem,
    fit: &Fit,
    family: Option<&Family>,
    origin: &Origin,
    style: &Style,
) -> Vec<Block> {
    let writer = Writer::new(problem, fit, style);
    let region = fit.fps.polyhedron().region();
    let mut blocks = vec![Block::Title(TITLE.to_owned()), Block::Facts(writer.facts(origin))];
    if let Some((header, rows)) = writer.estimates() {
        blocks.push(Block::table(header, rows));
        blocks.push(Block::Paragraph(Text::own(writer.note())));
    }
    blocks.push(Block::Title(format!("{FPS}: {}", region_title(region))));
    blocks.push(Block::table(
        &VERTEX_HEADER,
        vertex_rows(region, &writer.theta, |indices| writer.names(indices)),
    ));
    let lines = region_lines(region, |indices| writer.names(indices)).into_iter().map(Text::own);
    let lines = lines.chain(writer.emptiness().into_iter().map(Text::own));
    let advice = writer.advice().map(Text::given);
    blocks.extend(lines.chain(advice).map(Block::Paragraph));
    let proofs = writer.proofs();
    if !proofs.is_empty() {
        blocks.push(Block::Title(PROOFS.to_owned()));
        blocks.push(Block::table(&PROOF_HEADER, proofs));
    }
    blocks.push(Block::Title("Further results".to_owned()));
    let remarks = writer.remarks().into_iter().map(|(label, text)| (label.to_owned(), Text::own(text)));
    blocks.push(Block::Facts(remarks.collect()));
    if let Some(family) = family {
        blocks.extend(sweep_blocks(problem, family, style));
    }
    blocks
}
