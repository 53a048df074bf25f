//! The JSON report of lines under errors in x, schema `boundfit/x-errors/2`.

use std::collections::BTreeMap;

use boundfit_estimation::{Fit, Ties, least_squares_is_feasible};
use boundfit_exact::{Endpoint, Interval};
use boundfit_questions::{Agreement, LeastFactor, Side, SideSet, XBounds, XErrorFit, XErrorProblem};

use crate::answer::input::InputJson;
use crate::answer::parts::{
    ActiveJson, ActiveListJson, BoundJson, CertificateJson, IntervalJson, ProgramJson, RangeJson, RegionJson,
    SlopeJson, SlopesJson,
};
use crate::answer::x_errors::{
    FactorJson, XErrorCentralJson, XErrorJson, XErrorLeastSquaresJson, XErrorSideJson,
};
use crate::fit_json::central_of;
use crate::json::to_text;
use crate::origin::Origin;
use crate::style::Style;

/// The report as indented JSON, with a line end.
pub fn x_error_json(
    problem: &XErrorProblem,
    answer: &XErrorFit,
    plain: &Fit,
    origin: &Origin,
    style: &Style,
) -> String {
    let (x_epsilon, x_epsilon_column) = match problem.bounds() {
        XBounds::Uniform(bound) => (Some(style.upper_number(bound)), None),
        XBounds::PerRow { column, .. } => (None, Some(column.clone())),
    };
    let agreement = match problem.agreement() {
        Agreement::Weak => "weak",
        Agreement::Strong => "strong",
    };
    to_text(&XErrorJson {
        schema: XErrorJson::SCHEMA,
        program: ProgramJson::OWN,
        input: InputJson::new(problem.problem(), origin, style),
        x_epsilon,
        x_epsilon_column,
        agreement,
        sides: answer.sides.iter().map(|own| side(own, style)).collect(),
        pieces: answer.pieces().len(),
        joined: answer.are_joined(),
        pui: pui(answer, style),
        central: answer.central.as_ref().map(|central| XErrorCentralJson {
            estimate: central_of(central, style),
            in_fps: answer.contains(&central.theta),
        }),
        slopes: (!answer.is_empty()).then(|| SlopesJson {
            largest: slope(answer, true, style),
            smallest: slope(answer, false, style),
        }),
        factor: answer.least.as_ref().ok().map(|least| factor(least, style)),
        least_squares: plain.least_squares.as_ref().ok().map(|estimate| XErrorLeastSquaresJson {
            theta: style.numbers(&estimate.theta),
            in_fps: answer.contains(&estimate.theta),
            in_fps_without_x_errors: least_squares_is_feasible(plain),
        }),
        eui: plain.eui().map(|eui| RangeJson::both(eui, style)),
        reasons: reasons(answer, plain),
    })
}

fn side_name(side: Side) -> &'static str {
    match side {
        Side::Rising => "+",
        Side::Falling => "-",
        Side::Both => "both",
    }
}

fn side(own: &SideSet, style: &Style) -> XErrorSideJson {
    let region = own.polyhedron.region();
    let measures = region.measures();
    let names = |indices: &[usize]| {
        let (names, more) = own.active(indices, Ties::MOST_LISTED);
        ActiveListJson::of(names.into_iter().map(ActiveJson::from).collect(), more)
    };
    let certificate = own.contradiction().map(|terms| CertificateJson::new(&terms, style));
    XErrorSideJson {
        side: side_name(own.side),
        fps: RegionJson::new(region, &measures, style, names, certificate),
        pui: own.pui.as_ref().and_then(|pui| IntervalJson::both(pui, |index| own.names[index], style)),
    }
}

/// The intervals of all pieces together, each end with the proof of the piece that reaches it.
fn pui(answer: &XErrorFit, style: &Style) -> Option<[IntervalJson; 2]> {
    let end = |axis: usize, is_upper: bool| {
        let (side, own) = answer.end(axis, is_upper)?;
        Some(BoundJson::new(own, is_upper, |index| side.names[index], style))
    };
    let interval = |axis: usize| Some(IntervalJson { lower: end(axis, false)?, upper: end(axis, true)? });
    Some([interval(0)?, interval(1)?]).filter(|both| both.iter().any(IntervalJson::is_bounded))
}

/// The line with the largest or the smallest slope, and the bounds that it touches.
fn slope(answer: &XErrorFit, is_upper: bool, style: &Style) -> Option<SlopeJson> {
    let (side, bound) = answer.end(0, is_upper)?;
    SlopeJson::new(bound, Some(side_name(side.side)), |index| side.names[index], style)
}

fn factor(least: &LeastFactor, style: &Style) -> FactorJson {
    FactorJson {
        lower: style.lower_number(&least.lower),
        upper: style.upper_number(&least.upper),
        attained: least.theta.is_some(),
        side: side_name(least.side),
        theta: least.theta.as_ref().map(|theta| style.numbers(theta)),
        fixed_by: least.fixed_by.iter().map(|name| (*name).into()).collect(),
    }
}

/// Returns the reason why each null part is null.
fn reasons(answer: &XErrorFit, plain: &Fit) -> BTreeMap<&'static str, String> {
    let mut reasons = BTreeMap::new();
    if let Err(reason) = &answer.least {
        reasons.insert("factor", reason.to_string());
    }
    if answer.is_empty() {
        for part in ["pui", "central", "slopes"] {
            reasons.insert(part, "no line agrees with all readings".to_owned());
        }
    } else if answer.central.is_none() {
        reasons.insert("central", "the set is unbounded".to_owned());
        let is_bounded =
            |interval: &Interval| [interval.lower(), interval.upper()] != [&Endpoint::Unbounded; 2];
        if !answer.pui().is_some_and(|pui| pui.iter().any(is_bounded)) {
            reasons.insert("pui", "no end is bounded".to_owned());
        }
    }
    match &plain.least_squares {
        Err(reason) => {
            reasons.insert("least_squares", reason.to_string());
            reasons.insert("eui", reason.to_string());
        }
        Ok(estimate) => {
            if let Err(reason) = &estimate.eui {
                reasons.insert("eui", reason.to_string());
            }
        }
    }
    reasons
}
