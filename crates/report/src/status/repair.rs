//! The least total widening as text.

use boundfit_exact::Rational;
use boundfit_exact::english::counted;
use boundfit_questions::{NoRepair, Repair, Widened};

use crate::document::{Block, Operator, Symbol, Table, Text};
use crate::style::Style;

/// Returns the bounds that must be wider, and their factors.
pub(super) fn blocks(repair: &Result<Repair, NoRepair>, style: &Style) -> Vec<Block<'static>> {
    let mut blocks = vec![Block::Title("Least total widening".into())];
    let repair = match repair {
        Ok(repair) if repair.widened.is_empty() => {
            blocks.push(Block::Paragraph("No bound has to be wider.".into()));
            return blocks;
        }
        Ok(repair) => repair,
        Err(NoRepair::Contradiction(terms)) => {
            let names: Vec<String> = terms.iter().map(|(name, _)| name.to_string()).collect();
            let text = format!(
                "No widening helps: what has no width to grow contradicts itself ({}).",
                names.join(", ")
            );
            blocks.push(Block::Paragraph(text.into()));
            return blocks;
        }
        Err(NoRepair::NotInMemory) => {
            blocks.push(Block::Paragraph("Not known, since not every reading is kept in memory.".into()));
            return blocks;
        }
    };
    let excess = &repair.total - Rational::from(repair.count as u64);
    let [theta1, theta2] = repair.theta.each_ref().map(|own| Text::new().number(style.nearest(own)));
    let readings = counted(repair.count, "factor", "factors");
    let words = Text::from(format!("Factors w >= 1 of the bounds under which something meets all of them: their sum, of {readings}, is at least "))
        .number(style.upper(&repair.total))
        .words(", which is ")
        .number(style.upper(&excess))
        .words(" more than without widening. It is attained at ")
        .symbol(Symbol::Theta1)
        .operator(Operator::Equals)
        .then(theta1)
        .words(", ")
        .symbol(Symbol::Theta2)
        .operator(Operator::Equals)
        .then(theta2)
        .words(" with these above 1:");
    blocks.push(Block::Paragraph(words));
    let row = |Widened { row, factor, half_width }: &Widened| {
        vec![
            Text::new().number(row),
            Text::new().number(style.upper(factor)),
            Text::new().number(style.upper(half_width)),
        ]
    };
    let header = ["row", "factor w", "bound needed"];
    blocks.push(Block::Table(Table::new(header, repair.widened.iter().map(row).collect())));
    let multipliers = counted(repair.multipliers.len(), "reading", "readings");
    let held = match repair.held.len() {
        0 => String::new(),
        more => format!(
            " and {}",
            counted(more, "half-plane that holds as it is", "half-planes that hold as they are")
        ),
    };
    let proof =
        format!("No smaller sum is possible: multipliers of {multipliers}{held} prove it (JSON has them).");
    blocks.push(Block::Paragraph(proof.into()));
    blocks
}
