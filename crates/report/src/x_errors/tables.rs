//! Lines under errors in x as CSV and as well-known text.

use boundfit_estimation::{Fit, ParameterInterval};
use boundfit_exact::{Endpoint, Interval};
use boundfit_questions::{Side, XErrorFit};

use crate::fit_csv::Table;
use crate::style::Style;
use crate::wkt::region_wkt;

/// Estimates and intervals as a table with the columns of [`fit_csv`](crate::fit_csv). The quantities `least_squares`
/// and `eui` are those without errors in x. `pui` belongs to all pieces together, and `pui_rising` and `pui_falling`
/// to each of two. `central`, `guaranteed_error` and `least_factor` follow; the last is an interval where it is
/// enclosed.
pub fn x_error_csv(answer: &XErrorFit, plain: &Fit) -> String {
    let mut table = Table::new();
    let kinds: Vec<&str> =
        answer.pieces().iter().map(|piece| piece.polyhedron.region().kind().name()).collect();
    let kinds = if kinds.is_empty() { "empty".to_owned() } else { kinds.join("; ") };
    table.text("set", "kind", &kinds);
    if let Ok(estimate) = &plain.least_squares {
        table.values("least_squares", &estimate.theta);
    }
    if let Some(eui) = plain.eui() {
        table.intervals("eui", eui);
    }
    if let Some(pui) = answer.pui() {
        table.intervals("pui", &pui);
    }
    for side in answer.pieces() {
        let name = match side.side {
            Side::Rising => "pui_rising",
            Side::Falling => "pui_falling",
            Side::Both => continue,
        };
        if let Some(pui) = &side.pui {
            table.intervals(name, &pui.each_ref().map(ParameterInterval::interval));
        }
    }
    if let Some(central) = &answer.central {
        table.central(central);
    }
    if let Ok(least) = &answer.least {
        match least.exact() {
            Some(value) => table.value("least_factor", "", value.ceil_to_f64(), value),
            None => {
                let [lower, upper] = [&least.lower, &least.upper].map(|end| Endpoint::Finite(end.clone()));
                if let Some(interval) = Interval::new(lower, upper) {
                    table.interval("least_factor", "", &interval);
                }
            }
        }
    }
    table.into_text()
}

/// The pieces as well-known text, with a line end: as [`region_wkt`] has a single one; two polygons with a gap between them are a
/// `MULTIPOLYGON`, any other two a `GEOMETRYCOLLECTION`.
///
/// # Errors
/// The reason when a piece is unbounded, or thinner than any decimals can say.
pub fn x_error_wkt(answer: &XErrorFit, style: &Style) -> Result<String, String> {
    let pieces = answer.pieces();
    let texts =
        pieces.iter().map(|piece| region_wkt(&piece.polyhedron, style)).collect::<Result<Vec<_>, _>>()?;
    let texts: Vec<&str> = texts.iter().map(|text| text.trim_end()).collect();
    let rings: Option<Vec<&str>> = texts.iter().map(|text| text.strip_prefix("POLYGON ")).collect();
    Ok(match (texts.as_slice(), rings, answer.are_joined()) {
        ([], ..) => "POLYGON EMPTY\n".to_owned(),
        ([one], ..) => format!("{one}\n"),
        (_, Some(rings), Some(false)) => format!("MULTIPOLYGON ({})\n", rings.join(", ")),
        _ => format!("GEOMETRYCOLLECTION ({})\n", texts.join(", ")),
    })
}
