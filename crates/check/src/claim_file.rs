//! Claims brought from elsewhere.

use boundfit_exact::{Limits, ParseNumberError, Rational, Reading};
use boundfit_lp::{BoundClaim, Claimed};
use serde::Deserialize;
use thiserror::Error;

use crate::answer::{Answer, nothing};

/// Why a claim cannot be used.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ClaimError {
    /// Not JSON, or not of the form of a claim.
    #[error(
        "{0} (expected {{\"source\": \"...\", \"status\": \"optimal|infeasible|unbounded\", \"pui\": [[LO, HI], [LO, HI]]}})"
    )]
    Json(#[from] serde_json::Error),
    /// A text that should be a number.
    #[error("{text:?} is not a number: {error}")]
    Number {
        /// The text.
        text: String,
        /// What is wrong with it.
        error: ParseNumberError,
    },
    /// A status that is none.
    #[error("{0:?} is not a status (expected optimal, infeasible, unbounded or infeasible-or-unbounded)")]
    Status(String),
    /// An optimum without a value.
    #[error("the status is optimal, but there is neither \"pui\" nor \"points\"")]
    NoValue,
    /// A number of values other than four.
    #[error("{0} values (expected four: LO1,HI1,LO2,HI2, each a number, inf or -inf)")]
    Count(usize),
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ClaimFile {
    source: Option<String>,
    status: Option<String>,
    pui: Option<[[Option<NumberOrText>; 2]; 2]>,
    points: Option<[Option<[NumberOrText; 2]>; 4]>,
    duals: Option<[Option<Vec<f64>>; 4]>,
}

/// A JSON number is the binary64 that it is read as; a text is exact.
#[derive(Deserialize)]
#[serde(untagged)]
enum NumberOrText {
    Number(f64),
    Text(String),
}

impl NumberOrText {
    fn exact(&self) -> Result<Rational, ClaimError> {
        match self {
            // JSON has no infinities and no NaN.
            NumberOrText::Number(value) => Ok(Rational::from_f64(*value).unwrap_or_default()),
            NumberOrText::Text(text) => number(text),
        }
    }
}

fn number(text: &str) -> Result<Rational, ClaimError> {
    Reading::Decimal
        .read(text, &Limits::default())
        .map_err(|error| ClaimError::Number { text: text.to_owned(), error })
}

/// Reads a claims file. `name` stands in for a missing source. A missing or null end of an optimal answer is claimed
/// unbounded; without `pui` the ends are read off the points, which come in the order of the four programs: minimum and
/// maximum of θ1, then of θ2.
///
/// # Errors
/// What is wrong with the file.
pub fn parse_claim_file(text: &str, name: &str) -> Result<Answer, ClaimError> {
    let file: ClaimFile = serde_json::from_str(text)?;
    let source = file.source.clone().unwrap_or_else(|| name.to_owned());
    let status = match file.status.as_deref() {
        None | Some("optimal") => None,
        Some("infeasible") => Some(Claimed::Infeasible),
        Some("unbounded") => Some(Claimed::Unbounded),
        Some("infeasible-or-unbounded") => Some(Claimed::InfeasibleOrUnbounded),
        Some(other) => return Err(ClaimError::Status(other.to_owned())),
    };
    if status.is_none() && file.pui.is_none() && file.points.is_none() {
        return Err(ClaimError::NoValue);
    }
    let claim = |axis: usize, end: usize| -> Result<BoundClaim, ClaimError> {
        if let Some(status) = &status {
            return Ok(BoundClaim { claimed: status.clone(), point: None, duals: None });
        }
        let number = 2 * axis + end;
        let point = match file.points.as_ref().and_then(|points| points[number].as_ref()) {
            Some([theta1, theta2]) => Some([theta1.exact()?, theta2.exact()?]),
            None => None,
        };
        let claimed = match (&file.pui, &point) {
            (Some(pui), _) => match &pui[axis][end] {
                Some(value) => Claimed::Value(value.exact()?),
                None => Claimed::Unbounded,
            },
            (None, Some(point)) => Claimed::Value(point[axis].clone()),
            (None, None) => return Ok(nothing("no point given")),
        };
        let duals = file.duals.as_ref().and_then(|duals| duals[number].clone());
        Ok(BoundClaim { claimed, point, duals })
    };
    let claims = [[claim(0, 0)?, claim(0, 1)?], [claim(1, 0)?, claim(1, 1)?]];
    Ok(Answer { source, exact_input: false, claims })
}

/// Reads `LO1,HI1,LO2,HI2`. `-inf` as a lower and `inf` as an upper end claim that it is unbounded.
///
/// # Errors
/// What is wrong with the text.
pub fn parse_claim_pui(text: &str) -> Result<Answer, ClaimError> {
    let values: Vec<&str> = text.split(',').map(str::trim).collect();
    let [lower1, upper1, lower2, upper2] = values.as_slice() else {
        return Err(ClaimError::Count(values.len()));
    };
    let claim = |text: &str, unbounded: &[&str]| -> Result<BoundClaim, ClaimError> {
        let unbounded = unbounded.contains(&text.to_ascii_lowercase().as_str());
        let claimed = if unbounded { Claimed::Unbounded } else { Claimed::Value(number(text)?) };
        Ok(BoundClaim { claimed, point: None, duals: None })
    };
    let lower = |text: &str| claim(text, &["-inf", "-infinity"]);
    let upper = |text: &str| claim(text, &["inf", "+inf", "infinity", "+infinity"]);
    let claims = [[lower(lower1)?, upper(upper1)?], [lower(lower2)?, upper(upper2)?]];
    Ok(Answer { source: "claimed PUI".to_owned(), exact_input: false, claims })
}
