//! A fit as a MATLAB or Octave script.

use boundfit_estimation::{Fit, InverseParameter, Problem};
use boundfit_exact::{Endpoint, Interval, Rational};

use crate::answer::parts::ProgramJson;
use crate::fit::bound_found;
use crate::fit_json::uniform_minimum;
use crate::generators::ActiveNames;
use crate::script::{assignment, literal, quoted, region_script};
use crate::style::{LONGEST_FRACTION, USUAL_DIGITS};

/// A script that defines what [`region_script`] defines of the feasible set, and:
///
/// - `pui`, `eui` (2-by-2): a row for each parameter with its lower and upper end, rounded outward, `-Inf` and `Inf` where
///   there is none;
/// - `central`, `least_squares`, `minimax` (1-by-2): estimates to nearest, and `central_error`, `least_squares_error`: how far the
///   true parameters can be from the doubles, rounded up;
/// - `eps_min`, or where the readings have bounds of their own `eps_factor`, rounded up;
/// - `gain_pui`, `gain_fps`, `gain_eui` (a row for each part) and `gain_central`, `gain_least_squares`, and the same
///   of `offset`. They describe the inverse line over the box of both intervals, over the set and over the box of the
///   EUI;
/// - `area`, to nearest, `Inf` of a set without end;
/// - `error_bound`, rounded up, where it is a multiple of ε_min;
/// - `program`, the program and its version.
///
/// Each has its exact numbers as text beside it, in a cell array of the same size: `pui_exact`. A quantity that a fit
/// lacks has 0 rows.
pub fn fit_script(problem: &Problem, fit: &Fit, names: &ActiveNames<'_>) -> String {
    let mut text = region_script(fit.fps.polyhedron(), names);
    text.push_str(
        "% Intervals have a row for each parameter or part: lower end, upper end, rounded outward.\n\
         % Estimates are 1-by-2, rounded to nearest; errors and least bounds are rounded up.\n",
    );
    text.push_str(&format!("program = {};\n", quoted(&ProgramJson::OWN.to_string())));
    if let Some(multiple) = problem.measurements.multiple_of_least() {
        let epsilon = multiple.bound();
        text.push_str(&format!("% The error bound: {}.\n", bound_found(multiple)));
        text.push_str(&scalar("error_bound", Some((epsilon.ceil_to_f64(), epsilon.to_string()))));
    }
    text.push_str(&intervals("pui", fit.pui_intervals().as_ref().map_or(&[], |pui| pui)));
    text.push_str(&intervals("eui", fit.eui().map_or(&[], |eui| eui)));
    let central = fit.central.as_ref();
    text.push_str(&estimate("central", central.map(|own| &own.theta)));
    text.push_str(&errors("central_error", central.map(|own| [&own.theta, &own.guaranteed_error])));
    let squares = fit.least_squares.as_ref().ok().map(|own| &own.theta);
    let squares_errors = fit.least_squares_guaranteed_error();
    text.push_str(&estimate("least_squares", squares));
    text.push_str(&errors("least_squares_error", squares.zip(squares_errors.as_ref()).map(<[_; 2]>::from)));
    text.push_str(&estimate("minimax", fit.minimax.as_ref().map(|own| &own.theta)));
    let least = fit.minimax.as_ref().map(|own| &own.least);
    let uniform = uniform_minimum(problem, fit);
    text.push_str(&scalar("eps_min", uniform.map(|value| (value.ceil_to_f64(), value.to_string()))));
    let factor = least.filter(|_| uniform.is_none());
    text.push_str(&scalar("eps_factor", factor.map(|value| (value.ceil_to_f64(), value.to_string()))));
    let inverse = fit.inverse(problem.measurements.model());
    for (name, own) in
        [("gain", inverse.as_ref().map(|own| &own.gain)), ("offset", inverse.as_ref().map(|own| &own.offset))]
    {
        text.push_str(&inverse_parameter(name, own));
    }
    let region = fit.fps.polyhedron().region();
    let area = match region.measures().area() {
        _ if region.is_empty() => (0.0, "0".to_owned()),
        None => (f64::INFINITY, "Inf".to_owned()),
        Some(area) => {
            let exact = area.exact_within(LONGEST_FRACTION);
            let double = area.rounding_alike_in_binary64(USUAL_DIGITS).to_f64();
            (double, exact.map_or_else(String::new, |exact| exact.to_string()))
        }
    };
    text + &scalar("area", Some(area))
}

fn inverse_parameter(name: &str, own: Option<&InverseParameter>) -> String {
    let none: &[Interval] = &[];
    let nearest = |value: &Option<Rational>| value.as_ref().map(|value| (value.to_f64(), value.to_string()));
    [
        intervals(&format!("{name}_pui"), own.map_or(none, |own| &own.box_range)),
        intervals(&format!("{name}_fps"), own.map_or(none, |own| &own.exact_range)),
        intervals(&format!("{name}_eui"), own.and_then(|own| own.eui_range.as_deref()).unwrap_or(none)),
        scalar(&format!("{name}_central"), own.and_then(|own| nearest(&own.central))),
        scalar(&format!("{name}_least_squares"), own.and_then(|own| nearest(&own.least_squares))),
    ]
    .concat()
}

/// Doubles and exact texts, row by row.
fn both(name: &str, columns: usize, rows: Vec<Vec<(f64, String)>>) -> String {
    let exact = rows.iter().map(|row| row.iter().map(|(_, exact)| quoted(exact)).collect()).collect();
    let doubles = rows.iter().map(|row| row.iter().map(|(double, _)| literal(*double)).collect()).collect();
    assignment(&format!("{name}_exact"), &format!("cell(0, {columns})"), ['{', '}'], exact)
        + &assignment(name, &format!("zeros(0, {columns})"), ['[', ']'], doubles)
}

fn scalar(name: &str, value: Option<(f64, String)>) -> String {
    both(name, 1, value.into_iter().map(|value| vec![value]).collect())
}

fn estimate(name: &str, theta: Option<&[Rational; 2]>) -> String {
    let row = |theta: &[Rational; 2]| theta.iter().map(|own| (own.to_f64(), own.to_string())).collect();
    both(name, 2, theta.into_iter().map(row).collect())
}

/// Error bounds of an estimate, which cover the rounding of the estimate.
fn errors(name: &str, of: Option<[&[Rational; 2]; 2]>) -> String {
    let row = |[theta, errors]: [&[Rational; 2]; 2]| {
        let both = theta.iter().zip(errors);
        both.map(|(theta, error)| (error.ceil_to_f64_beside(theta), error.to_string())).collect()
    };
    both(name, 2, of.into_iter().map(row).collect())
}

fn intervals(name: &str, intervals: &[Interval]) -> String {
    let end = |end: &Endpoint, double: fn(&Rational) -> f64, none: f64, word: &str| match end {
        Endpoint::Finite(value) => (double(value), value.to_string()),
        Endpoint::Unbounded => (none, word.to_owned()),
    };
    let row = |own: &Interval| {
        vec![
            end(own.lower(), Rational::floor_to_f64, f64::NEG_INFINITY, "-Inf"),
            end(own.upper(), Rational::ceil_to_f64, f64::INFINITY, "Inf"),
        ]
    };
    both(name, 2, intervals.iter().map(row).collect())
}
