//! One group of a fleet as a line of JSON, schema `boundfit/fleet/2`. A key that means the same as in
//! `boundfit/fit/2` has the same name and the same shape.

use boundfit_estimation::GroupAnswer;
use boundfit_exact::Foreign;

use crate::answer::parts::{BoundJson, CertificateJson, IntervalJson, RangeJson};
use crate::answer::window::{GroupJson, GroupSetJson};
use crate::fit_json::{central_of, least_squares_of};
use crate::json_line::{JsonLine, LineInput};
use crate::style::Style;

/// Appends the line of a group of this input, whose rows have this text in common, with its line end.
pub fn write_group_json(
    text: &mut Vec<u8>,
    key: Foreign<&str>,
    group: &GroupAnswer,
    input: &LineInput,
    style: &Style,
) {
    group_json(key, group, input, style).write(text);
    text.push(b'\n');
}

pub(crate) fn group_json<'a>(
    key: Foreign<&'a str>,
    group: &GroupAnswer,
    input: &'a LineInput,
    style: &Style,
) -> GroupJson<'a> {
    let GroupAnswer { fit, guaranteed_error, is_feasible, .. } = group;
    let [epsilon_min, epsilon_factor] = [true, false].map(|is_bound| {
        fit.least
            .as_ref()
            .filter(|_| is_bound == group.is_bounded_alike)
            .map(|least| style.upper_number(least))
    });
    GroupJson {
        schema: GroupJson::SCHEMA,
        input: input.json(),
        group: key,
        rows: fit.rows,
        first_row: fit.first_row,
        least_squares: fit
            .least_squares
            .as_ref()
            .map(|theta| least_squares_of(theta, *is_feasible, guaranteed_error.as_ref(), style)),
        eui: group.eui.as_ref().map(|eui| RangeJson::both(eui, style)),
        fps: GroupSetJson {
            kind: fit.kind.name(),
            vertex_count: group.vertex_count,
            certificate: group.contradiction.as_ref().map(|terms| CertificateJson::new(terms, style)),
        },
        pui: pui(group, style),
        central: fit.central.as_ref().map(|central| central_of(central, style)),
        epsilon_min,
        epsilon_factor,
    }
}

/// The parameter uncertainty intervals with their proofs; `None` when no end is bounded.
fn pui(group: &GroupAnswer, style: &Style) -> Option<[IntervalJson; 2]> {
    let (pui, proofs) = (group.fit.pui.as_ref()?, group.proofs.as_ref()?);
    let interval = |axis: usize| {
        let [lower, upper] = &proofs[axis];
        IntervalJson {
            lower: BoundJson::of_terms(pui[axis].lower(), lower, false, style),
            upper: BoundJson::of_terms(pui[axis].upper(), upper, true, style),
        }
    };
    let intervals = [interval(0), interval(1)];
    intervals.iter().any(IntervalJson::is_bounded).then_some(intervals)
}
