//! Claims about all four ends at once: JSON files, and texts of the command line.

use boundfit_exact::{Foreign, Limits, Rational, Reading};
use boundfit_lp::{BoundClaim, Claimed, Printed, PuiEnd};
use serde::Deserialize;

use super::error::ClaimError;
use super::limits::ClaimLimits;
use crate::answer::Answer;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ClaimFile {
    source: Option<Foreign>,
    status: Option<String>,
    pui: Option<[[Option<NumberOrText>; 2]; 2]>,
    points: Option<[Option<[NumberOrText; 2]>; 4]>,
    duals: Option<[Option<Vec<NumberOrText>>; 4]>,
}

/// A JSON number is the binary64 that it is read as; a text is what it spells, with the precision of its digits.
#[derive(Deserialize)]
#[serde(untagged)]
enum NumberOrText {
    Number(f64),
    Text(String),
}

impl NumberOrText {
    fn printed(&self, limits: &Limits) -> Result<Printed, ClaimError> {
        match self {
            // JSON has no infinities and no NaN.
            NumberOrText::Number(value) => Ok(Rational::from_f64(*value).unwrap_or_default().into()),
            NumberOrText::Text(text) => number(text, limits),
        }
    }
}

fn number(text: &str, limits: &Limits) -> Result<Printed, ClaimError> {
    let read = Reading::Decimal.read(text, limits);
    let value = read.map_err(|error| ClaimError::Number { text: text.into(), error })?;
    Ok(Printed::typed(text, value))
}

/// Reads a claims file in JSON. `name` stands in for a missing source. A missing or null end of an optimal answer is
/// claimed unbounded. Without `pui` the ends come from the points, in the order of the four programs: minimum and
/// maximum of θ1, then of θ2. Ends beside another status are not looked at; points are measured.
///
/// # Errors
/// Returns an error that says what is wrong with the file.
pub(super) fn parse_claim_file(
    text: &str,
    name: &Foreign,
    limits: &ClaimLimits,
) -> Result<Answer, ClaimError> {
    if let Some((line, column)) = nested_beyond(text, limits.nesting) {
        return Err(ClaimError::Nesting { limit: limits.nesting, line, column });
    }
    if !text.trim_start_matches('\u{feff}').trim_start().starts_with('{') {
        return Err(ClaimError::NoObject);
    }
    let file: ClaimFile = serde_json::from_str(text.trim_start_matches('\u{feff}'))?;
    let source = file.source.clone().unwrap_or_else(|| name.clone());
    let status = match file.status.as_deref() {
        None | Some("optimal") => None,
        Some("infeasible") => Some(Claimed::Infeasible),
        Some("unbounded") => Some(Claimed::Unbounded),
        Some("infeasible-or-unbounded") => Some(Claimed::InfeasibleOrUnbounded),
        Some(other) => return Err(ClaimError::Status(other.into())),
    };
    if status.is_none() && file.pui.is_none() && file.points.is_none() {
        return Err(ClaimError::NoValue);
    }
    let claims = PuiEnd::try_each(|end| -> Result<BoundClaim, ClaimError> {
        // Points and duals come in the order of `PuiEnd::ALL`.
        let place = end as usize;
        let point = match file.points.as_ref().and_then(|points| points.get(place)?.as_ref()) {
            Some([theta1, theta2]) => {
                Some([theta1.printed(&limits.number)?, theta2.printed(&limits.number)?])
            }
            None => None,
        };
        let duals = file.duals.as_ref().and_then(|duals| duals.get(place)?.as_ref());
        let size = |dual: &NumberOrText| Ok::<_, ClaimError>(dual.printed(&limits.number)?.value.to_f64());
        let duals = duals.map(|duals| duals.iter().map(size).collect::<Result<Vec<f64>, _>>()).transpose()?;
        if let Some(status) = &status {
            return Ok(BoundClaim { claimed: status.clone(), point, duals });
        }
        match (&file.pui, point) {
            (Some(pui), point) => {
                let claimed = match end.of(pui) {
                    Some(value) => Claimed::Value(value.printed(&limits.number)?),
                    None => Claimed::Unbounded,
                };
                Ok(BoundClaim { claimed, point, duals })
            }
            (None, Some(point)) => Ok(BoundClaim::attained(end, point, duals)),
            (None, None) => Ok(BoundClaim::nothing("no point given")),
        }
    })?;
    Ok(Answer { source, exact_input: false, claims })
}

/// The line and column, from 1 and in bytes, where arrays and objects of a JSON text are first nested deeper
/// than a limit. Brackets in a string do not count. Asked before a text is parsed, so that no stack
/// overflows. Cost: one look at each byte.
pub fn nested_beyond(text: &str, limit: usize) -> Option<(usize, usize)> {
    let (mut depth, mut is_text, mut is_escaped) = (0_usize, false, false);
    let (mut line, mut column) = (1, 0);
    for byte in text.bytes() {
        column += 1;
        match byte {
            _ if is_escaped => is_escaped = false,
            b'\\' if is_text => is_escaped = true,
            b'"' => is_text = !is_text,
            b'[' | b'{' if !is_text => depth += 1,
            b']' | b'}' if !is_text => depth = depth.saturating_sub(1),
            b'\n' => (line, column) = (line + 1, 0),
            _ => {}
        }
        if depth > limit {
            return Some((line, column));
        }
    }
    None
}

/// Reads `LO1,HI1,LO2,HI2`. `-inf` as a lower and `inf` as an upper end claim that it is unbounded.
///
/// # Errors
/// Returns an error that says what is wrong with the text.
pub fn parse_claim_pui(text: &str) -> Result<Answer, ClaimError> {
    let values: Vec<&str> = text.split(',').map(str::trim).collect();
    let [lower1, upper1, lower2, upper2] = values.as_slice() else {
        return Err(ClaimError::Count(values.len()));
    };
    let claim = |text: &str, unbounded: &[&str]| -> Result<BoundClaim, ClaimError> {
        let unbounded = unbounded.contains(&text.to_ascii_lowercase().as_str());
        let claimed =
            if unbounded { Claimed::Unbounded } else { Claimed::Value(number(text, &Limits::default())?) };
        Ok(BoundClaim::bare(claimed))
    };
    let lower = |text: &str| claim(text, &["-inf", "-infinity"]);
    let upper = |text: &str| claim(text, &["inf", "+inf", "infinity", "+infinity"]);
    let claims = [[lower(lower1)?, upper(upper1)?], [lower(lower2)?, upper(upper2)?]];
    Ok(Answer { source: "claimed PUI".into(), exact_input: false, claims })
}
