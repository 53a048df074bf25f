//! A window as a line of JSON, schema `boundfit/window/1`. A key that means the same as in `boundfit/fit/2` has the
//! same name and the same shape.

use crate::answer::parts::{CertificateJson, FeasibleSetJson, IntervalJson};
use crate::answer::window::WindowJson;
use crate::fit_json::central_of;
use crate::json_line::{JsonLine, LineInput};
use crate::style::Style;
use crate::window::WindowReport;

/// Appends the line of a window of this input, with its line end.
pub fn write_window_json(text: &mut Vec<u8>, window: &WindowReport, input: &LineInput, style: &Style) {
    let WindowReport { rows: [first_row, last_row], readings, x, fit, least, .. } = window;
    let contradiction = fit.contradiction.as_ref();
    let written = WindowJson {
        schema: WindowJson::SCHEMA,
        input: input.json(),
        first_row: *first_row,
        last_row: *last_row,
        rows: *readings,
        x: x.as_ref().map(|x| style.numbers(x)),
        fps: FeasibleSetJson {
            kind: fit.kind.name(),
            certificate: contradiction.map(|why| CertificateJson::new(&why.terms, style)),
        },
        pui: fit.pui.as_ref().and_then(|pui| IntervalJson::both(pui, |index| fit.names[index], style)),
        central: fit.central.as_ref().map(|central| central_of(central, style)),
        epsilon_min: least.as_ref().map(|least| style.upper_number(least)),
    };
    written.write(text);
    text.push(b'\n');
}
