//! A window as a line of JSON, schema `boundfit/window/1`. A key that means the same as in `boundfit/fit/2` has the
//! same name and the same shape.

use boundfit_estimation::{ParameterBound, ParameterInterval};
use boundfit_exact::Rational;

use crate::answer::input::LineInputJson;
use crate::answer::parts::{BoundJson, CertificateJson, FeasibleSetJson, IntervalJson, TermJson};
use crate::answer::table::TableJson;
use crate::answer::window::WindowJson;
use crate::fit_json::central_of;
use crate::number::Number;
use crate::style::Style;
use crate::window::WindowReport;

/// Appends the line of a window of a table that was taken for this, with its line end.
pub fn write_window_json(
    text: &mut Vec<u8>,
    window: &WindowReport,
    table: Option<&TableJson>,
    style: &Style,
) {
    let WindowReport { rows: [first_row, last_row], readings, x, fit, least, .. } = window;
    let name = |index: usize| fit.names[index];
    let bound = |bound: &ParameterBound, number: &dyn Fn(&Rational) -> Number| match bound {
        ParameterBound::Unbounded(_) => BoundJson::unbounded(style),
        ParameterBound::Bounded { value, proof } => BoundJson::proved(
            number(value),
            proof.multipliers.iter().map(|m| TermJson::new(name(m.index), &m.value, style)).collect(),
        ),
    };
    let interval = |interval: &ParameterInterval| IntervalJson {
        lower: bound(&interval.lower, &|value| style.lower_number(value)),
        upper: bound(&interval.upper, &|value| style.upper_number(value)),
    };
    let has_end = |interval: &ParameterInterval| {
        [&interval.lower, &interval.upper].iter().any(|end| matches!(end, ParameterBound::Bounded { .. }))
    };
    let pui = fit.pui.as_ref().filter(|pui| pui.iter().any(has_end));
    let farkas = fit.contradiction.as_ref().map(|why| {
        why.terms.iter().map(|(name, multiplier)| TermJson::new(*name, multiplier, style)).collect()
    });
    let written = WindowJson {
        schema: WindowJson::SCHEMA,
        input: LineInputJson { table },
        first_row: *first_row,
        last_row: *last_row,
        rows: *readings,
        x: x.as_ref().map(|x| style.numbers(x)),
        fps: FeasibleSetJson {
            kind: fit.kind.name(),
            certificate: farkas.map(|farkas| CertificateJson { farkas }),
        },
        pui: pui.map(|pui| pui.each_ref().map(interval)),
        central: fit.central.as_ref().map(|central| central_of(central, style)),
        epsilon_min: least.as_ref().map(|least| style.upper_number(least)),
    };
    // The types hold strings, numbers and lists only, and memory takes whatever is written.
    serde_json::to_writer(&mut *text, &written).expect("a window that is not JSON");
    text.push(b'\n');
}
