//! The JSON report of a fit, schema `boundfit/fit/2`.

use std::collections::BTreeMap;

use boundfit_estimation::{
    Central, Family, Fit, FloatEstimate, InverseParameter, LeastSquares, Measurements, Model, Problem, Ties,
    least_squares_is_feasible, mending_rows,
};
use boundfit_exact::{Interval, Rational};
use boundfit_geometry::Measures;
use boundfit_questions::Guarantee;

use crate::answer::fit::{
    FitJson, FitLeastSquaresJson, FloatJson, GuaranteeJson, InverseJson, InversesJson, MinimaxJson,
};
use crate::answer::input::InputJson;
use crate::answer::parts::{
    ActiveJson, CentralJson, CertificateJson, IntervalJson, LeastSquaresJson, ProgramJson, RangeJson,
    RegionJson, SlopeJson, SlopesJson, TermJson,
};
use crate::answer::sweep::SweepJson;
use crate::json::{centroid_json, has_bounded_end, long_fractions, to_text};
use crate::number::Number;
use crate::origin::Origin;
use crate::style::Style;

/// The reason why a report omits binary64 least squares.
pub(crate) fn no_binary64(measurements: &Measurements) -> String {
    format!("not computed, {}", not_every_reading(measurements))
}

/// The reason why something that takes every reading is not known, such as the row that would mend an empty set.
pub(crate) fn not_every_reading(measurements: &Measurements) -> &'static str {
    if measurements.is_of_reductions() {
        "since the data are a reduction"
    } else {
        "since not every reading is kept in memory"
    }
}

/// The report as indented JSON, with a line end.
pub fn fit_json(
    problem: &Problem,
    fit: &Fit,
    family: Option<&Family>,
    guarantee: Option<&Guarantee>,
    origin: &Origin,
    style: &Style,
) -> String {
    let report = FitJson::new(problem, fit, family, origin, style);
    to_text(&match guarantee {
        Some(guarantee) => report.with_guarantee(problem, fit, guarantee, style),
        None => report,
    })
}

impl FitJson {
    /// The report of a fit, and of the family over the error bound if there is one.
    pub fn new(
        problem: &Problem,
        fit: &Fit,
        family: Option<&Family>,
        origin: &Origin,
        style: &Style,
    ) -> Self {
        let measures = fit.fps.polyhedron().region().measures();
        let fps = fps(problem, fit, &measures, style);
        let tightness = fit.share_of_box(&measures).map(|share| style.measure_number(&share));
        let area_centroid = centroid_json(&measures, style);
        let mut reasons = reasons(problem, fit);
        reasons.extend(long_fractions("fps.area", fps.area(), area_centroid.as_ref(), style));
        let sweep = family.map(|family| SweepJson::new(problem, family, style));
        if sweep.as_ref().is_some_and(SweepJson::lacks_fraction) {
            reasons.insert("sweep.area", style.too_long());
        }
        if tightness.as_ref().is_some_and(Number::lacks_fraction) {
            reasons.insert("tightness", style.too_long());
        }
        FitJson {
            schema: Self::SCHEMA,
            program: ProgramJson::OWN,
            input: InputJson::new(problem, origin, style),
            least_squares: least_squares(problem, fit, style),
            eui: fit.eui().map(|eui| RangeJson::both(eui, style)),
            fps,
            pui: pui(fit, style),
            central: central(fit, style),
            slopes: slopes(problem, fit, style),
            epsilon_min: uniform_minimum(problem, fit).map(|epsilon| style.upper_number(epsilon)),
            inverse: fit.inverse(problem.measurements.model()).as_ref().map(|inverse| InversesJson {
                gain: inverse_parameter(&inverse.gain, style),
                offset: inverse_parameter(&inverse.offset, style),
            }),
            minimax: minimax(problem, fit, style),
            tightness,
            area_centroid,
            mended_without: mending_rows(problem, fit),
            reasons,
            sweep,
            guarantee: None,
        }
    }

    /// The report with the guarantee for further readings; where there is none, with the reason.
    #[must_use]
    pub fn with_guarantee(
        mut self,
        problem: &Problem,
        fit: &Fit,
        guarantee: &Guarantee,
        style: &Style,
    ) -> Self {
        self.guarantee = GuaranteeJson::new(problem, fit, guarantee, style);
        if self.guarantee.is_none() {
            self.reasons.insert("guarantee", "see minimax".to_owned());
        }
        self
    }
}

fn least_squares(problem: &Problem, fit: &Fit, style: &Style) -> Option<FitLeastSquaresJson> {
    let estimate = fit.least_squares.as_ref().ok()?;
    let float = |float: &Option<FloatEstimate>| {
        float.as_ref().map(|float| FloatJson {
            theta: float.theta,
            distance: float.distance.each_ref().map(|distance| style.upper_number(distance)),
        })
    };
    let float = fit.float_least_squares(&problem.measurements).map(|floats| {
        BTreeMap::from([("qr", float(&floats.qr)), ("pseudo_inverse", float(&floats.pseudo_inverse))])
    });
    let in_fps = least_squares_is_feasible(fit).unwrap_or(false);
    let errors = fit.least_squares_guaranteed_error();
    Some(FitLeastSquaresJson {
        estimate: least_squares_of(&estimate.theta, in_fps, errors.as_ref(), style),
        binary64: float.unwrap_or_default(),
    })
}

/// A least-squares estimate, with its guaranteed error where it has one.
pub(crate) fn least_squares_of(
    theta: &[Rational; 2],
    in_fps: bool,
    guaranteed_error: Option<&[Rational; 2]>,
    style: &Style,
) -> LeastSquaresJson {
    let (theta, guaranteed_error) = match guaranteed_error {
        Some(errors) => {
            let (theta, errors) = style.estimate_numbers(theta, errors);
            (theta, Some(errors))
        }
        None => (style.numbers(theta), None),
    };
    LeastSquaresJson { theta, in_fps, guaranteed_error }
}

fn fps(problem: &Problem, fit: &Fit, measures: &Measures, style: &Style) -> RegionJson<ActiveJson> {
    let contradiction = fit.contradiction(problem.measurements.error_bound());
    let certificate = contradiction.map(|terms| CertificateJson::new(&terms, style));
    let name = |indices: &[usize]| (&fit.fps.active(indices, Ties::MOST_LISTED)).into();
    RegionJson::new(fit.fps.polyhedron().region(), measures, style, name, certificate)
}

/// The parameter uncertainty intervals with their proofs; `None` when no end is bounded.
pub(crate) fn pui(fit: &Fit, style: &Style) -> Option<[IntervalJson; 2]> {
    IntervalJson::both(fit.pui.as_ref()?, |index| fit.fps.name(index), style)
}

pub(crate) fn central(fit: &Fit, style: &Style) -> Option<CentralJson> {
    fit.central.as_ref().map(|central| central_of(central, style))
}

/// The lines at the two ends of the PUI of θ1; `None` for an empty set and for two regressors.
fn slopes(problem: &Problem, fit: &Fit, style: &Style) -> Option<SlopesJson> {
    let (Model::Line { .. }, Some([pui, _])) = (problem.measurements.model(), &fit.pui) else { return None };
    let line = |bound| SlopeJson::new(bound, None, |index| fit.fps.name(index), style);
    Some(SlopesJson { largest: line(&pui.upper), smallest: line(&pui.lower) })
}

/// A central estimate with its guaranteed error.
pub(crate) fn central_of(central: &Central, style: &Style) -> CentralJson {
    let (theta, guaranteed_error) = style.estimate_numbers(&central.theta, &central.guaranteed_error);
    CentralJson { theta, guaranteed_error }
}

/// ε_min exists under a uniform error bound only.
pub(crate) fn uniform_minimum<'a>(problem: &Problem, fit: &'a Fit) -> Option<&'a Rational> {
    let uniform = problem.measurements.error_bound().is_uniform();
    fit.minimax.as_ref().filter(|_| uniform).map(|minimax| &minimax.least)
}

fn minimax(problem: &Problem, fit: &Fit, style: &Style) -> Option<MinimaxJson> {
    let minimax = fit.minimax.as_ref()?;
    let least = Some(style.upper_number(&minimax.least));
    let (epsilon, epsilon_factor) =
        if uniform_minimum(problem, fit).is_some() { (least, None) } else { (None, least) };
    let proof = TermJson::all(&minimax.proof.multipliers, style);
    let theta = style.numbers(&minimax.theta);
    Some(MinimaxJson { theta, unique: minimax.unique, epsilon, epsilon_factor, proof })
}

fn inverse_parameter(parameter: &InverseParameter, style: &Style) -> InverseJson {
    let ranges = |intervals: &Vec<Interval>| {
        intervals.iter().map(|interval| RangeJson::new(interval, style)).collect()
    };
    InverseJson {
        exact_range: ranges(&parameter.exact_range),
        box_range: ranges(&parameter.box_range),
        eui_range: parameter.eui_range.as_ref().map(ranges),
        central: parameter.central.as_ref().map(|value| style.number(value)),
        least_squares: parameter.least_squares.as_ref().map(|value| style.number(value)),
    }
}

/// The reason why there is no least factor.
pub(crate) const NO_WIDTHS: &str = "no row has both bounds, so there is no width that could grow";

/// Returns the reason why each null part is null.
fn reasons(problem: &Problem, fit: &Fit) -> BTreeMap<&'static str, String> {
    let mut reasons = BTreeMap::new();
    let region = fit.fps.polyhedron().region();
    let without_fps =
        || if region.is_empty() { "the FPS is empty" } else { "the FPS is unbounded" }.to_owned();
    if let Err(singular) = &fit.least_squares {
        reasons.insert("least_squares", singular.to_string());
        reasons.insert("eui", singular.to_string());
    }
    if let Ok(LeastSquares { eui: Err(reason), .. }) = &fit.least_squares {
        reasons.insert("eui", reason.to_string());
    }
    if fit.least_squares.is_ok() && problem.measurements.all().is_none() {
        reasons.insert("binary64", no_binary64(&problem.measurements));
    }
    if !fit.pui.as_ref().is_some_and(has_bounded_end) {
        reasons.insert("pui", if region.is_empty() { without_fps() } else { "no end is bounded".to_owned() });
    }
    if fit.central.is_none() {
        reasons.insert("central", without_fps());
    }
    if !fit.has_box_with_area() {
        let flat = region.is_bounded() && !region.is_empty();
        reasons.insert("tightness", if flat { "the PUI box has no area".to_owned() } else { without_fps() });
    }
    if fit.minimax.is_none() {
        let never = if problem.measurements.has_widths() {
            "no error bound, however large, leaves a feasible parameter"
        } else {
            NO_WIDTHS
        };
        let unknown = problem.measurements.unknown_minimax();
        reasons.insert("minimax", unknown.map_or_else(|| never.to_owned(), |reason| reason.to_string()));
    }
    if uniform_minimum(problem, fit).is_none() {
        let reason = match problem.measurements.error_bound() {
            bound if bound.is_uniform() => "see minimax",
            bound if bound.has_middles() => "every reading has its own interval",
            _ => "every reading has its own error bound",
        };
        reasons.insert("epsilon_min", reason.to_owned());
    }
    if region.is_empty() && problem.measurements.all().is_none() {
        reasons.insert("mended_without", not_every_reading(&problem.measurements).to_owned());
    }
    if !matches!(problem.measurements.model(), Model::Line { .. }) {
        reasons.insert("inverse", "the model is not a line".to_owned());
        reasons.insert("slopes", "the model is not a line".to_owned());
    } else if region.is_empty() {
        reasons.insert("slopes", without_fps());
    }
    reasons
}
