//! Half-planes from text, one a line.

use boundfit_estimation::{Condition, ParseConditionErrorKind};
use boundfit_exact::{Limits, Reading};
use boundfit_geometry::System;
use serde::Serialize;

/// The line that a half-plane comes from.
#[derive(Debug, Clone, Serialize)]
pub(super) struct HalfPlaneLine {
    /// The line of the text, from 1.
    line: usize,
    /// Counted from 1 over the lines that say something: what the half-plane is called.
    number: usize,
    /// The side among the two half-planes of an equation, `upper` (≤) or `lower` (≥).
    side: Option<&'static str>,
    text: String,
}

/// A line that cannot be read.
#[derive(Debug, Serialize)]
pub(super) struct LineError {
    line: usize,
    /// Characters from 1.
    column: usize,
    /// The problem, as a name for programs.
    kind: &'static str,
    /// The fault in words.
    message: String,
}

/// The lines of a text that say something.
#[derive(Debug, Default)]
pub(super) struct Lines {
    pub(super) system: System,
    pub(super) lines: Vec<HalfPlaneLine>,
    pub(super) errors: Vec<LineError>,
}

/// Reads the half-planes of a text.
pub(super) fn read(text: &str, limits: &Limits) -> Lines {
    let mut read = Lines::default();
    let written = (1..).zip(text.lines()).filter(|(_, line)| {
        let line = line.trim();
        !line.is_empty() && !line.starts_with('#')
    });
    for (number, (line, own)) in (1..).zip(written) {
        match Condition::parse_in_plane(own, Reading::Decimal, limits) {
            Ok(condition) => {
                for (side, inequality) in ["upper", "lower"].into_iter().zip(condition.inequalities()) {
                    read.system.push(inequality);
                    let side = condition.is_equation().then_some(side);
                    read.lines.push(HalfPlaneLine { line, number, side, text: own.trim().to_owned() });
                }
            }
            Err(error) => read.errors.push(LineError {
                line,
                column: error.position + 1,
                kind: kind(&error.kind),
                message: error.to_string(),
            }),
        }
    }
    read
}

fn kind(kind: &ParseConditionErrorKind) -> &'static str {
    match kind {
        ParseConditionErrorKind::NotATerm => "not-a-term",
        ParseConditionErrorKind::NotANumber(kind) if kind.is_limit() => "number-too-long",
        ParseConditionErrorKind::NotANumber(_) => "not-a-number",
        ParseConditionErrorKind::NoRelation => "no-relation",
        ParseConditionErrorKind::FactorBehind => "factor-behind",
        ParseConditionErrorKind::WrongRelation => "strict",
        ParseConditionErrorKind::SecondRelation => "second-relation",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_counted_as_they_stand_and_half_planes_as_they_are_called() {
        let read = read("# a square\n\nx >= 0\n  y = 1\n", &Limits::default());
        let names: Vec<_> =
            read.lines.iter().map(|own| (own.line, own.number, own.side, own.text.as_str())).collect();
        assert_eq!(
            names,
            [(3, 1, None, "x >= 0"), (4, 2, Some("upper"), "y = 1"), (4, 2, Some("lower"), "y = 1")]
        );
        assert_eq!((read.system.len(), read.errors.len()), (3, 0));
    }

    #[test]
    fn what_cannot_be_read_has_a_place_and_a_name() {
        let text = "x < 1\nz <= 1\nx <= 1e99\nx + 1\n0 <= x <= 1\nx <= 1.2.3\n1 <= y\ny/3 <= 1";
        let read = read(text, &Limits { digits: 30, exponent: 30 });
        let errors: Vec<_> = read.errors.iter().map(|error| (error.line, error.column, error.kind)).collect();
        assert_eq!(
            errors,
            [
                (1, 3, "strict"),
                (2, 1, "not-a-term"),
                (3, 8, "number-too-long"),
                (4, 6, "no-relation"),
                (5, 8, "second-relation"),
                (6, 9, "not-a-number"),
                (8, 2, "factor-behind"),
            ]
        );
        assert!(read.errors[0].message.starts_with("a strict inequality at character 3: "));
    }
}
