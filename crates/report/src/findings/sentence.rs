//! The finding about one aspect, as a sentence.

use boundfit_exact::{Foreign, Rational, Rounding};
use boundfit_judge::{Excuse, Fault, Finding, Item, OtherProgram, Part, Side, Worth};
use boundfit_lp::{End, Model, ObjectiveSense};

/// Significant digits up to which a number is shown in full.
const FULL: usize = 20;
/// Significant digits that tell binary64 numbers apart.
const DOUBLE: usize = 17;

/// The note on prices of the opposite sign.
const NEGATED: &str = "all prices have the opposite sign, as of the opposite objective";

/// The tolerances in words.
fn excuse_text(excuse: &Excuse) -> String {
    format!(
        "excused by a tolerance of {} absolute, {} relative, {} scaled",
        bounded(&excuse.absolute),
        bounded(&excuse.relative),
        bounded(&excuse.scaled)
    )
}

/// The sentence, without its end. The proportion comes first, the tolerances that excuse it last.
pub(super) fn sentence(model: &Model, finding: &Finding) -> String {
    let Some(fault) = &finding.fault else { return finding.aspect.question().to_owned() };
    let relative = finding.relative.as_ref().map(bounded).unwrap_or_default();
    let error = finding.error.as_ref().map(bounded).unwrap_or_default();
    let what = match fault {
        Fault::Status { claimed, exact } => {
            format!("{} is claimed, the program is {exact}", short(claimed))
        }
        Fault::NotFinite { part, item } => {
            let of = item.map(|item| format!(" of {}", name(model, Side { item, end: End::Lower })));
            format!("{}{} is not a finite number", part_name(*part), of.unwrap_or_default())
        }
        Fault::Value { claimed, exact, answers } => {
            let answers = answers.filter(|_| finding.worth == Worth::Refuted);
            let other = answers.map_or("", |other| other_program(other, model.sense));
            format!("off by {relative} of its size: {} instead of {}{other}", number(claimed), number(exact))
        }
        Fault::Beyond { side, bound, value } => format!(
            "off by {relative} of its size: {} is {}, {error} {} its {} bound {}",
            name(model, *side),
            number(value),
            if side.end == End::Lower { "below" } else { "above" },
            side.end.name(),
            number(bound)
        ),
        Fault::NoSuchBound { side, price } => format!(
            "off by {relative} of its size: the price {} of {} leans on its {} bound, which is not there",
            number(price),
            name(model, *side),
            side.end.name()
        ),
        Fault::ReducedCost { column, claimed, exact } => format!(
            "off by {relative} of its size: the reduced cost of {} is {}, the duals leave {}",
            name(model, Side { item: Item::Column(*column), end: End::Lower }),
            number(claimed),
            number(exact)
        ),
        Fault::Slack { side, price, slack } => format!(
            "off by {relative}: {} has the price {} at its {} bound, but is {} away from it",
            name(model, *side),
            number(price),
            side.end.name(),
            number(slack)
        ),
        Fault::Leaves { side, change } => format!(
            "off by {relative} of its size: {} changes by {} along the ray and has a bound there ({})",
            name(model, *side),
            number(change),
            side.end.name()
        ),
        Fault::DoesNotImprove { change } => {
            format!("the objective does not improve along the ray, it gets worse by {}", number(change))
        }
        Fault::NoContradiction { total } => {
            format!("the multiplied bounds add up to {}, which is no contradiction", number(total))
        }
    };
    let what = if finding.is_negated { format!("{what}; {NEGATED}") } else { what };
    match &finding.excuse {
        Some(excuse) if finding.worth >= Worth::WithinTolerance => format!("{what}; {}", excuse_text(excuse)),
        _ => what,
    }
}

/// The program that a wrong number is the optimum of.
fn other_program(other: OtherProgram, sense: ObjectiveSense) -> &'static str {
    match (other, sense) {
        (OtherProgram::OtherConstant, _) => {
            ", the optimum if the constant of the objective has the other sign, as GLPK reads it in MPS"
        }
        (OtherProgram::OppositeSense, ObjectiveSense::Minimize) => {
            ", which is the maximum, but the program asks for the minimum"
        }
        (OtherProgram::OppositeSense, ObjectiveSense::Maximize) => {
            ", which is the minimum, but the program asks for the maximum"
        }
    }
}

/// A number of a part of a solution.
fn part_name(part: Part) -> &'static str {
    match part {
        Part::Objective => "the objective",
        Part::Point => "the value",
        Part::Duals => "the dual",
        Part::ReducedCosts => "the reduced cost",
        Part::Ray => "the direction",
        Part::Farkas => "the multiplier",
    }
}

/// A row or a column by its name.
fn name(model: &Model, side: Side) -> String {
    let name = match side.item {
        Item::Row(row) => model.rows.get(row).map(|row| &row.name),
        Item::Column(column) => model.columns.get(column).map(|column| &column.name),
    };
    name.map(short).unwrap_or_default()
}

/// A text on one line, cut where it is long.
pub(super) fn short(text: &Foreign) -> String {
    const LONGEST: usize = 60;
    let shown: String = text.raw().chars().take(LONGEST).collect();
    let more = if shown.len() < text.raw().len() { "..." } else { "" };
    format!("{}{more}", Foreign::from(shown))
}

/// A number in full where it is short, otherwise with the digits that tell doubles apart.
fn number(value: &Rational) -> String {
    match value.exact_decimal(FULL) {
        Some(decimal) => decimal.to_string(),
        None => format!("about {}", value.decimal(DOUBLE, Rounding::Nearest)),
    }
}

/// The size of an error, rounded up.
pub(super) fn bounded(error: &Rational) -> String {
    error.decimal(2, Rounding::Up).compact().to_string()
}
