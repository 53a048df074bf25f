//! The share of further readings in the band of the least error bound, in words and as JSON.

use boundfit_estimation::{ErrorBound, Fit, Minimax, Problem};
use boundfit_exact::Rational;
use boundfit_exact::english::counted;
use boundfit_questions::Guarantee;

use crate::answer::fit::GuaranteeJson;
use crate::document::{Block, Document, Symbol, Text};
use crate::style::Style;

/// The source of the theorem.
const SOURCE: &str = "Campi and Garatti, SIAM J. Optim. 19 (2008); of such bands Campi, Calafiore and Garatti, Automatica 45 (2009)";

impl GuaranteeJson {
    /// `None` where there is no band.
    pub(crate) fn new(problem: &Problem, fit: &Fit, guarantee: &Guarantee, style: &Style) -> Option<Self> {
        let minimax = fit.minimax.as_ref()?;
        Some(GuaranteeJson {
            confidence: style.given_number(&guarantee.confidence),
            covered: style.lower_number(&guarantee.covered),
            readings: guarantee.readings,
            unknowns: guarantee.unknowns,
            assumes: assumptions(problem, minimax).into_iter().map(ToOwned::to_owned).collect(),
            source: SOURCE,
        })
    }
}

/// The guarantee of a fit, with what it assumes and where it comes from.
pub fn guarantee_document(
    problem: &Problem,
    fit: &Fit,
    guarantee: &Guarantee,
    style: &Style,
) -> Document<'static> {
    let Guarantee { confidence, covered, readings, unknowns } = guarantee;
    let mut blocks = vec![Block::Title("Guarantee for further readings".into())];
    let Some(minimax) = &fit.minimax else {
        let none =
            Text::from("None: there is no ").symbol(Symbol::LeastEpsilon).words(", so there is no band.");
        blocks.push(Block::Paragraph(none));
        return Document::new(blocks);
    };
    let all = counted(*readings, "reading", "readings");
    if covered.is_zero() {
        let few = if *readings < *unknowns as usize {
            format!("None: {all} do not fix a band of {unknowns} unknowns.")
        } else {
            format!("None: {all} are too few for this confidence.")
        };
        blocks.push(Block::Paragraph(few.into()));
        return Document::new(blocks);
    }
    let percent = covered * Rational::from(100);
    let statement = Text::from("At least ")
        .number(style.lower(&percent))
        .words(" % of further readings lie in the band of ")
        .symbol(Symbol::LeastEpsilon)
        .words(", with confidence ")
        .then(style.given(confidence))
        .words(": no more than ");
    let band = match problem.measurements.error_bound() {
        ErrorBound::Uniform(_) => statement.number(style.upper(&minimax.least)),
        _ => statement.number(style.upper(&minimax.least)).words(" times their own error bound"),
    };
    blocks.push(Block::Paragraph(band.words(" off the minimax estimate.")));
    let assumes =
        format!("It follows from {all} alone and assumes {}.", assumptions(problem, minimax).join("; "));
    blocks.push(Block::Paragraph(assumes.into()));
    blocks.push(Block::Paragraph(format!("Source: {SOURCE}.").into()));
    Document::new(blocks)
}

/// The assumptions.
fn assumptions(problem: &Problem, minimax: &Minimax) -> Vec<&'static str> {
    let measurements = &problem.measurements;
    let is_uniform = measurements.error_bound().is_uniform();
    let draws = if is_uniform {
        "that all readings, these and further ones, are independent draws from one source, whatever it is"
    } else {
        "that all readings, these and further ones, are with their error bounds, which are not 0, independent draws from \
         one source, whatever it is"
    };
    let chosen = !measurements.selection().is_all();
    let chosen = chosen.then_some("that the rows were chosen without a look at the readings");
    let missing = measurements.rows_missing() > 0;
    let missing = missing.then_some("that values are not missing because of what they would have been");
    let many = (!minimax.unique)
        .then_some("that of all lines that are as good the one nearest to theta = (0, 0) is meant");
    [draws].into_iter().chain(chosen).chain(missing).chain(many).collect()
}
