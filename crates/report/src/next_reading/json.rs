//! The next reading as JSON, schema `boundfit/next/1`.

use std::collections::BTreeMap;

use boundfit_exact::{Rational, Rounding};
use boundfit_questions::{Best, NextReading};

use super::{NextReadingReport, is_short};
use crate::answer::input::InputJson;
use crate::answer::next_reading::{GoalJson, NextReadingJson, SearchRangeJson};
use crate::answer::parts::{FeasibleSetJson, RangeJson};
use crate::answer::predict::NewReadingJson;
use crate::json::to_text;
use crate::number::{Number, Outward};
use crate::origin::Origin;
use crate::style::Style;

/// Writes the report as indented JSON, with a line end.
pub fn next_reading_json(report: &NextReadingReport<'_>, origin: &Origin, style: &Style) -> String {
    let NextReadingReport { problem, fit, epsilon, is_epsilon_given, is_range_given, next } = report;
    // Beyond its ends it is certain: open intervals are rounded inward.
    let range = |[from, to]: [Option<&Rational>; 2]| RangeJson {
        lower: from.map(|from| style.upper_number(from)),
        upper: to.map(|to| style.lower_number(to)),
    };
    let within = next.and_then(|next| next.within.as_ref()).map(|[lower, upper]| SearchRangeJson {
        lower: style.given_number(lower),
        upper: style.given_number(upper),
        given: *is_range_given,
    });
    to_text(&NextReadingJson {
        schema: NextReadingJson::SCHEMA,
        input: InputJson::new(problem, origin, style),
        fps: FeasibleSetJson::new(problem, fit, style),
        new_reading: NewReadingJson {
            epsilon: Some(style.upper_number(epsilon)),
            law: None,
            given: *is_epsilon_given,
        },
        certain: next.map(|next| next.certain().into_iter().map(range).collect()),
        within,
        certain_within: next.and_then(NextReading::is_certain_within),
        goals: next.iter().flat_map(|next| &next.best).map(|best| goal_json(best, style)).collect(),
        reasons: reasons(report),
    })
}

fn goal_json(best: &Best, style: &Style) -> GoalJson {
    GoalJson {
        goal: best.goal.name(),
        now: best.now.as_ref().map(|now| size(now, style)),
        worst: best.worst.as_ref().map(|worst| size(worst, style)),
        at: best.at.iter().map(|x| style.given_number(x)).collect(),
    }
}

fn reasons(report: &NextReadingReport<'_>) -> BTreeMap<&'static str, String> {
    let mut reasons = BTreeMap::new();
    match report.next {
        None => {
            for part in ["certain", "within", "certain_within"] {
                reasons.insert(part, "the FPS is empty".to_owned());
            }
        }
        Some(next) if next.within.is_none() => {
            for part in ["within", "certain_within"] {
                reasons.insert(part, super::NO_RANGE.to_owned());
            }
        }
        Some(_) => {}
    }
    for goal in report.next.iter().flat_map(|next| &next.too_long) {
        reasons.insert(goal.name(), NextReadingReport::too_long());
    }
    reasons
}

/// A length or an area.
fn size(value: &Rational, style: &Style) -> Number {
    match is_short(value, style) {
        true => style.upper_number(value),
        false => {
            let digits = style.significant();
            Number::without_fraction(value.clone(), digits, Rounding::Up, style.reader).outward(Outward::Up)
        }
    }
}
