//! The JSON report of lines under errors in x, schema `boundfit/x-errors/2`.

use std::collections::BTreeMap;

use boundfit_estimation::{Fit, ParameterBound, ParameterInterval, Ties, least_squares_is_feasible};
use boundfit_exact::{Endpoint, Interval};
use boundfit_geometry::Multiplier;
use boundfit_questions::{Agreement, LeastFactor, Side, SideSet, XBounds, XErrorFit, XErrorProblem};

use crate::answer::input::InputJson;
use crate::answer::parts::{
    ActiveJson, ActiveListJson, BoundJson, IntervalJson, ProgramJson, RangeJson, RegionJson, SlopeJson,
    SlopesJson, TermJson,
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
        eui: plain.eui().map(|eui| eui.each_ref().map(|eui| RangeJson::new(eui, style))),
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
    let farkas = own.contradiction();
    let farkas =
        farkas.map(|terms| terms.iter().map(|(name, times)| TermJson::new(*name, times, style)).collect());
    let interval = |interval: &ParameterInterval| IntervalJson {
        lower: bound(own, &interval.lower, false, style),
        upper: bound(own, &interval.upper, true, style),
    };
    XErrorSideJson {
        side: side_name(own.side),
        fps: RegionJson::new(region, &measures, style, names, farkas),
        pui: own.pui.as_ref().filter(|pui| has_bounded_end(pui)).map(|pui| pui.each_ref().map(interval)),
    }
}

/// Returns whether anything is bounded, as of a fit.
fn has_bounded_end(pui: &[ParameterInterval; 2]) -> bool {
    let ends = pui.iter().flat_map(|own| [&own.lower, &own.upper]);
    ends.into_iter().any(|end| matches!(end, ParameterBound::Bounded { .. }))
}

fn bound(side: &SideSet, bound: &ParameterBound, is_upper: bool, style: &Style) -> BoundJson {
    match bound {
        ParameterBound::Unbounded(_) => BoundJson::unbounded(style),
        ParameterBound::Bounded { value, proof } => {
            let named = |own: &Multiplier| TermJson::new(side.names[own.index], &own.value, style);
            let value = if is_upper { style.upper_number(value) } else { style.lower_number(value) };
            BoundJson::proved(value, proof.multipliers.iter().map(named).collect())
        }
    }
}

/// The intervals of all pieces together, each end with the proof of the piece that reaches it.
fn pui(answer: &XErrorFit, style: &Style) -> Option<[IntervalJson; 2]> {
    let end = |axis: usize, is_upper: bool| {
        let (side, own) = answer.end(axis, is_upper)?;
        Some(bound(side, own, is_upper, style))
    };
    let interval = |axis: usize| Some(IntervalJson { lower: end(axis, false)?, upper: end(axis, true)? });
    let is_bounded = |axis: usize| {
        [false, true]
            .into_iter()
            .any(|is_upper| matches!(answer.end(axis, is_upper), Some((_, ParameterBound::Bounded { .. }))))
    };
    Some([interval(0)?, interval(1)?]).filter(|_| is_bounded(0) || is_bounded(1))
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
