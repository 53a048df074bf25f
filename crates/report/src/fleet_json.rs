//! One group of a fleet as a line of JSON, schema `boundfit/fleet/2`. What means the same as in `boundfit/fit/2` has the
//! same name and the same shape.

use boundfit_estimation::least_squares_is_feasible;
use boundfit_exact::Foreign;
use serde::Serialize;

use crate::fit_json::{CentralJson, central, least_squares_numbers, pui, uniform_minimum};
use crate::fleet_summary::GroupReport;
use crate::json::{CertificateJson, IntervalJson, RangeJson, TermJson};
use crate::number::Number;
use crate::style::Style;
use crate::table_json::{LineInputJson, TableJson};

#[derive(Serialize)]
struct GroupJson<'a> {
    schema: &'static str,
    input: LineInputJson<'a>,
    group: Foreign<&'a str>,
    rows: usize,
    first_row: Option<usize>,
    least_squares: Option<LeastSquaresJson>,
    eui: Option<[RangeJson; 2]>,
    fps: FpsJson,
    pui: Option<[IntervalJson; 2]>,
    central: Option<CentralJson>,
    epsilon_min: Option<Number>,
    epsilon_factor: Option<Number>,
}

#[derive(Serialize)]
struct LeastSquaresJson {
    theta: [Number; 2],
    in_fps: bool,
    guaranteed_error: Option<[Number; 2]>,
}

#[derive(Serialize)]
struct FpsJson {
    kind: &'static str,
    vertex_count: usize,
    certificate: Option<CertificateJson>,
}

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
        schema: "boundfit/fleet/2",
        input: LineInputJson { table },
        group: key,
        rows: line.rows,
        first_row: line.first_row,
        least_squares: least_squares.map(|estimate| {
            let (theta, guaranteed_error) = least_squares_numbers(fit, &estimate.theta, style);
            let in_fps = least_squares_is_feasible(fit).unwrap_or(false);
            LeastSquaresJson { theta, in_fps, guaranteed_error }
        }),
        eui: fit.eui().map(|eui| eui.each_ref().map(|eui| RangeJson::new(eui, style))),
        fps: FpsJson {
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
