//! The report of the family of sets over the error bound.

use std::sync::Arc;

use boundfit_estimation::{
    BoundName, Breakpoint, Family, Linear, MovingArea, MovingBoundary, MovingVertex, Piece, Problem,
};
use boundfit_exact::english::list;
use boundfit_exact::{Rational, Rounding};

use crate::document::{Block, Document, Facts, Operator, Symbol, THETA, Table, Text};
use crate::formula::{form_text, sum_text};
use crate::region::{endless, kind_text, names_of, vertex_table};
use crate::scale::with_digits_that_differ;
use crate::style::{Style, is_readable, range};

/// The sets FPS(s·ε): where the set changes its shape, then every vertex and every end of the PUI between, as exact
/// functions of s.
pub fn sweep_document(problem: &Problem, family: &Family, style: &Style) -> Document<'static> {
    let breakpoints = family.breakpoints();
    let (Some(first), Some(last)) = (breakpoints.first(), breakpoints.last()) else {
        return Document::default();
    };
    let title = Text::from("Sweep of the error bound: FPS").mark("(").symbol(Symbol::Factor);
    let title = title.operator(Operator::Dot).symbol(Symbol::Epsilon).mark(")").words(" for ");
    let mut blocks = vec![
        Block::Title(title.then(from_to(style.given(&first.s), style.given(&last.s)))),
        Block::Paragraph(birth(family, style)),
        Block::Table(breakpoint_table(problem, breakpoints, style)),
    ];
    if problem.measurements.error_bound().has_middles() {
        let meaning = Text::symbol(Text::new(), Symbol::Factor);
        blocks.insert(
            1,
            Block::Paragraph(meaning.words(" multiplies the width of each interval, about its middle.")),
        );
    }
    family.pieces().iter().for_each(|piece| blocks.extend(piece_blocks(piece, style)));
    Document::new(blocks)
}

fn from_to(from: Text, to: Text) -> Text {
    Text::from(Symbol::Factor).words(" from ").then(from).words(" to ").then(to)
}

/// Returns the factor at which the set is born.
fn birth(family: &Family, style: &Style) -> Text {
    match family.least() {
        None => "No factor, however large, leaves a feasible parameter.".into(),
        Some(least) if least.is_zero() => "The set is never empty.".into(),
        Some(least) => {
            let birth = Text::from("The set is born at ").symbol(Symbol::Factor).operator(Operator::Equals);
            birth.then(style.upper_with_exact(least)).words(".")
        }
    }
}

fn breakpoint_table(problem: &Problem, breakpoints: &[Breakpoint], style: &Style) -> Table {
    let epsilon = problem.measurements.error_bound().uniform();
    let style = &with_digits_that_differ(breakpoints.iter().map(|breakpoint| &breakpoint.s), style);
    let rows = breakpoints.iter().map(|breakpoint| {
        let section = &breakpoint.section;
        // Printed upper bounds, of factors as of error bounds, are never too small.
        let upper = |value: &Rational| Text::new().number(style.upper(value));
        let mut row = vec![upper(&breakpoint.s)];
        if !style.exact {
            row.push(style.proof(&breakpoint.s));
        }
        row.extend(epsilon.map(|epsilon| upper(&(epsilon * &breakpoint.s))));
        row.push(kind_text(section.kind, section.vertices.len()).into());
        row.extend([&breakpoint.entering, &breakpoint.leaving].map(|names| names_text(names)));
        row
    });
    let mut header = vec![Text::from(Symbol::Factor)];
    if !style.exact {
        header.push("exactly".into());
    }
    header.extend(epsilon.map(|_| Symbol::Epsilon.into()));
    header.extend(["set", "begins to shape it", "ceases to"].map(Text::from));
    Table::new(header, rows.collect())
}

/// The vertices between two breakpoints, where the set goes on for ever, which lines bound it, the ends of the PUI and the
/// area.
fn piece_blocks(piece: &Piece, style: &Style) -> Vec<Block<'static>> {
    let function = |function: &Linear| linear_text(function, style);
    let title = Text::from("For ").then(from_to(style.proof(&piece.from), style.proof(&piece.to)));
    let title = title.words(format!(": {}", kind_text(piece.kind, piece.vertices.len())));
    let vertex = |(number, vertex): (usize, &Arc<MovingVertex>)| {
        let [theta1, theta2] = vertex.theta.each_ref().map(function);
        vec![Text::new().number(number), theta1, theta2, names_of(&vertex.active).into()]
    };
    let vertices = vertex_table((1..).zip(&piece.vertices).map(vertex).collect());
    let boundaries = piece.boundaries.iter().map(|MovingBoundary { normal, offset, active }| {
        let bound = form_text(normal).operator(Operator::AtMost).then(function(offset));
        Text::from("bounded by ").then(bound).words(": ").words(names_of(active))
    });
    let lines = endless(&piece.rays, &piece.lines).into_iter().chain(boundaries).map(Block::Paragraph);
    let pui = piece.pui.iter().flatten().zip(THETA).map(|([lower, upper], theta)| {
        let range = range(lower.as_ref().map(function), upper.as_ref().map(function));
        (Text::from("PUI ").symbol(theta), range)
    });
    let area = piece.area().map(|area| ("area".into(), area_text(&area, style)));
    let facts = Facts { width: 10, rows: pui.chain(area).collect() };
    [Block::Title(title), vertices].into_iter().chain(lines).chain([Block::Facts(facts)]).collect()
}

fn names_text(names: &[BoundName]) -> Text {
    list(names.iter().map(BoundName::to_string)).into()
}

fn linear_text(Linear { constant, slope }: &Linear, style: &Style) -> Text {
    let is_whole = |coefficient: &Rational| style.exact || is_readable(&coefficient.abs());
    polynomial_text([constant, slope].map(|coefficient| (coefficient.clone(), is_whole(coefficient))), style)
}

fn area_text(area: &MovingArea, style: &Style) -> Text {
    let coefficients = [area.constant(), area.slope(), area.quadratic()];
    let shown = coefficients.map(|coefficient| style.readable_or_alike(&coefficient));
    let lacks_fraction = style.exact && shown.iter().any(|(_, is_whole)| !is_whole);
    let text = polynomial_text(shown, style);
    if lacks_fraction { text.words(format!(" ({})", style.too_long())) } else { text }
}

/// A polynomial in s with these coefficients, from the constant on, each with whether all of it is shown.
fn polynomial_text<const N: usize>(coefficients: [(Rational, bool); N], style: &Style) -> Text {
    let s = Text::from(Symbol::Factor);
    let powers = [None, Some(s.clone()), Some(s.mark("^2"))];
    sum_text(coefficients.into_iter().zip(powers).map(|((value, is_whole), power)| {
        let size = value.abs();
        let shown = if is_whole {
            Text::new().number(&size)
        } else {
            Text::new()
                .mark("(")
                .words("about ")
                .number(size.decimal(style.significant(), Rounding::Nearest))
                .mark(")")
        };
        (value, shown, power)
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn functions_read_like_formulas() {
        let text = |coefficients: &[i64]| {
            let values: Vec<Rational> = coefficients.iter().map(|&value| Rational::ratio(value, 2)).collect();
            let [constant, slope, quadratic] =
                [0, 1, 2].map(|index| values.get(index).cloned().unwrap_or_default());
            let whole = [constant, slope, quadratic].map(|value| (value, true));
            polynomial_text(whole, &Style::default()).to_string()
        };
        for (coefficients, expected) in [
            (&[1, -3][..], "1/2 - 3/2*s"),
            (&[0, 2], "s"),
            (&[2, 0], "1"),
            (&[0, 0, 0], "0"),
            (&[-2, -2, 1], "-1 - s + 1/2*s^2"),
            (&[0, -2, 4], "-s + 2*s^2"),
        ] {
            assert_eq!(text(coefficients), expected);
        }
    }
}
