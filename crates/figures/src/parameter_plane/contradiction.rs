//! Half-planes without a common point: those that contradict each other, as [`empty`] shows readings that do.

use boundfit_exact::{Rational, Rounding};
use boundfit_geometry::constructions::between_parallels;
use boundfit_geometry::{Constraint, Farkas, HalfPlane, Inequality, Point, Polyhedron, System};

use super::empty::{FILL, STYLES, THICK, corners, triangle};
use super::region;
use super::view::{Window, around_lines};
use crate::drawing::{LegendEntry, Panel, Swatch};
use crate::labels::number;
use crate::palette::{Fill, Stroke};
use crate::text::one_line;

/// Significant digits of a coefficient, and the longest inequality that fits a legend.
const DIGITS: usize = 12;
const LONGEST: usize = 60;

/// The inequalities of a proof that a set is empty, at most three.
pub(super) fn rows(polyhedron: &Polyhedron, certificate: &Farkas) -> Vec<Inequality> {
    let inequalities = polyhedron.system().inequalities();
    certificate.multipliers().iter().filter_map(|term| inequalities.get(term.index).cloned()).collect()
}

/// A window around the place where the half-planes come nearest to a common point.
pub(super) fn window(rows: &[Inequality]) -> Window {
    let lines = lines(rows);
    let lines: Vec<&HalfPlane> = lines.iter().flatten().collect();
    let corners = corners(&lines);
    triangle(&corners).unwrap_or_else(|| {
        let between = || match lines.as_slice() {
            [f, g, ..] => between_parallels(f, g),
            _ => Point::origin(),
        };
        let centre = corners.first().cloned().unwrap_or_else(|| between().coordinates());
        around_lines(&centre, &lines)
    })
}

/// Draws what each half-plane allows and returns the legend, with these names of parameters. What holds nowhere
/// has no boundary: the heading says it.
pub(super) fn draw(panel: &mut Panel, rows: &[Inequality], names: &[String; 2]) -> Vec<LegendEntry> {
    let mut legend = Vec::new();
    for ((row, line), (fill, edge, dash)) in rows.iter().zip(lines(rows)).zip(STYLES) {
        let fill = Fill { colour: fill, opacity: FILL };
        let stroke = Stroke::new(edge, THICK, dash);
        let Some(line) = line else {
            panel.heading = format!("{} holds nowhere", words(row, names));
            continue;
        };
        let allowed = Polyhedron::intersect([row.clone()].into_iter().collect::<System>());
        region::draw(panel, &allowed, fill, stroke);
        region::whole_line(panel, &line, stroke);
        legend
            .push(LegendEntry::new(Swatch::area(fill, stroke), format!("allowed by {}", words(row, names))));
    }
    legend
}

/// The boundaries; `None` of an inequality without parameters.
fn lines(rows: &[Inequality]) -> Vec<Option<HalfPlane>> {
    let line = |row: &Inequality| match row.constraint() {
        Constraint::HalfPlane(half_plane) => Some(half_plane),
        Constraint::Always | Constraint::Never => None,
    };
    rows.iter().map(line).collect()
}

/// An inequality as `θ₁ + 2·θ₂ ≥ 1`: its first coefficient is positive.
fn words(row: &Inequality, names: &[String; 2]) -> String {
    let first = row.a.iter().find(|coefficient| !coefficient.is_zero());
    let (sign, relation) = if first.is_some_and(Rational::is_negative) {
        (-Rational::one(), '≥')
    } else {
        (Rational::one(), '≤')
    };
    let mut text = String::new();
    for (coefficient, name) in row.a.iter().zip(names).filter(|(coefficient, _)| !coefficient.is_zero()) {
        let coefficient = coefficient * &sign;
        text.push_str(match (text.is_empty(), coefficient.is_negative()) {
            (true, _) => "",
            (false, true) => " − ",
            (false, false) => " + ",
        });
        if coefficient.abs() != Rational::one() {
            text.push_str(&number(&coefficient.abs(), DIGITS, Rounding::Nearest));
            text.push('·');
        }
        text.push_str(name);
    }
    let left = if text.is_empty() { "0" } else { &text };
    let right = number(&(&row.b * &sign), DIGITS, Rounding::Nearest);
    one_line(&format!("{left} {relation} {right}").into(), LONGEST)
}
