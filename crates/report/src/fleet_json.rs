//! One group of a fleet as a line of JSON, schema `boundfit/fleet/2`. A key that means the same as in
//! `boundfit/fit/2` has the same name and the same shape.

use crate::answer::input::LineInputJson;
use crate::answer::parts::{CertificateJson, RangeJson, TermJson};
use crate::answer::table::TableJson;
use crate::answer::window::{GroupJson, GroupSetJson};
use crate::fit_json::{central, least_squares_of, pui, uniform_minimum};
use crate::fleet_summary::GroupReport;
use crate::style::Style;

/// Appends the line of a group of a table that was taken for this, with its line end.
pub fn write_group_json(
    text: &mut Vec<u8>,
    group: &GroupReport<'_>,
    table: Option<&TableJson>,
    style: &Style,
) {
    let GroupReport { key, problem, fit, line } = *group;
    let region = fit.fps.polyhedron().region();
    let least_squares = fit.least_squares.as_ref().ok();
    let contradiction = fit.contradiction(problem.measurements.error_bound());
    let written = GroupJson {
        schema: GroupJson::SCHEMA,
        input: LineInputJson { table },
        group: key,
        rows: line.rows,
        first_row: line.first_row,
        least_squares: least_squares.map(|estimate| least_squares_of(fit, &estimate.theta, style)),
        eui: fit.eui().map(|eui| eui.each_ref().map(|eui| RangeJson::new(eui, style))),
        fps: GroupSetJson {
            kind: line.kind.name(),
            vertex_count: region.vertices().len(),
            certificate: contradiction.map(|terms| CertificateJson {
                farkas: terms.iter().map(|(name, m)| TermJson::new(*name, m, style)).collect(),
            }),
        },
        pui: pui(fit, style),
        central: central(fit, style),
        epsilon_min: uniform_minimum(problem, fit).map(|epsilon| style.upper_number(epsilon)),
        epsilon_factor: line
            .least
            .as_ref()
            .filter(|_| group.is_bounded_per_row())
            .map(|factor| style.upper_number(factor)),
    };
    // The types hold strings, numbers and lists only, and memory takes whatever is written.
    serde_json::to_writer(&mut *text, &written).expect("a group that is not JSON");
    text.push(b'\n');
}
