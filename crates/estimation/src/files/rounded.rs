//! Columns of readings as floats, for a filter that bears their roundings.

use boundfit_exact::{Column, Foreign, Rational};
use boundfit_geometry::grid::{RoundedStrips, in_range};

use super::scale::Scale;
use crate::meaning::{ErrorBound, Meaning, Model};
use crate::measurement::Measurement;

/// The relative margin, 2⁻⁴⁸, that exceeds the error of a sum of two rounded numbers. Numbers of columns are within a
/// relative error of 2⁻⁵⁰, their products with a factor within 2⁻⁴⁹, and each operation adds 2⁻⁵³.
const MARGIN: f64 = 1.0 / (1_u64 << 48) as f64;

/// A number within a relative error of 2⁻⁵⁰, or NaN where a filter may not compute with it. Exact zeros are
/// exactly 0.
pub(super) fn float(number: &Rational) -> f64 {
    let float = number.to_f64();
    if float == 0.0 && !number.is_zero() { f64::NAN } else { in_range(float) }
}

/// The numbers of a column in this sense. Cost: a nanosecond or two each, but for those that are far beyond the range.
pub(super) fn floats(column: &Column) -> Vec<f64> {
    match column.rounded() {
        Some(mut floats) => {
            floats.iter_mut().for_each(|number| *number = in_range(*number));
            floats
        }
        None => (0..column.len()).map(|row| float(&column.get(row))).collect(),
    }
}

/// Readings in columns as the filter sees them. `reading` gives a reading itself where the columns do not say its bounds.
pub(super) fn rounded_strips(
    meaning: &Meaning,
    scale: &Scale,
    columns: &[Column],
    reading: impl Fn(usize) -> Measurement,
) -> RoundedStrips {
    let count = columns.first().map_or(0, Column::len);
    let is_line = matches!(meaning.model, Model::Line { .. });
    // A difference of rounded numbers may have no digit that is right.
    let first = match is_line && !meaning.form.x_origin.is_zero() {
        true => (0..count).map(|row| float(&reading(row).regressor[0])).collect(),
        false => floats(&columns[0]),
    };
    let phi = [first, if is_line { vec![1.0; count] } else { floats(&columns[1]) }];
    let regressors = phi.len() - usize::from(is_line);
    let bounds = match &meaning.error_bound {
        _ if meaning.is_around_y() => around_y(meaning, scale, &columns[regressors..]),
        ErrorBound::Interval { lower, upper } => {
            let mut rest = columns.iter().skip(regressors + usize::from(meaning.has_response));
            let mut side = |column: &Option<Foreign>| {
                column.as_ref()?;
                Some([rest.next()?, rest.next()?])
            };
            let sides = [side(lower), side(upper)];
            match (scale, sides) {
                (Scale::AsStated, [lower, upper]) => {
                    Some([stated(lower, 1.0, count), stated(upper, -1.0, count)])
                }
                (Scale::Times(factor), [Some(lower), Some(upper)]) => {
                    let other = |row: usize| exact_bounds(scale.bounds(&reading(row)));
                    Some(about_middles([lower, upper], in_range(factor.to_f64()), other))
                }
                _ => None,
            }
        }
        _ => None,
    };
    let [lower, upper] = bounds.unwrap_or_else(|| {
        let (lower, upper) =
            (0..count).map(|row| <(f64, f64)>::from(exact_bounds(scale.bounds(&reading(row))))).unzip();
        [lower, upper]
    });
    RoundedStrips { phi, lower, upper }
}

/// The bounds about y at a multiple of those that are stated, or at a distance that all have: of columns that start with y.
fn around_y(meaning: &Meaning, scale: &Scale, columns: &[Column]) -> Option<[Vec<f64>; 2]> {
    let response = floats(columns.first()?);
    let uniform = match scale {
        Scale::Within(epsilon) => Some(epsilon),
        Scale::AsStated | Scale::Times(_) => meaning.error_bound.uniform(),
    };
    let factor = if let Scale::Times(factor) = scale { in_range(factor.to_f64()) } else { 1.0 };
    let around = |y: f64, reach: f64| {
        let margin = MARGIN * (y.abs() + reach);
        (y - reach + margin, y + reach - margin)
    };
    let (lower, upper) = match uniform {
        Some(epsilon) => {
            let reach = in_range(epsilon.to_f64()) * factor;
            response.iter().map(|&y| around(y, reach)).unzip()
        }
        None => {
            let epsilon = floats(columns.get(1)?);
            response.iter().zip(&epsilon).map(|(&y, epsilon)| around(y, epsilon * factor)).unzip()
        }
    };
    Some([lower, upper])
}

/// Bounds as they are stated, `sign` times infinity away where there is none; behind each bound stands whether it is there.
fn stated(side: Option<[&Column; 2]>, sign: f64, count: usize) -> Vec<f64> {
    let Some([bound, presence]) = side else { return vec![sign * f64::NEG_INFINITY; count] };
    let bounds = floats(bound).into_iter().zip(floats(presence));
    let is_there = |(bound, presence): (f64, f64)| match presence == 0.0 {
        true => sign * f64::NEG_INFINITY,
        false => bound + sign * MARGIN * bound.abs(),
    };
    bounds.map(is_there).collect()
}

/// Bounds about their middles at a factor on their distance. Bounds that cross, or of which one is missing, stay as
/// they are. Other bounds may be too close to tell: `other` gives their values.
fn about_middles(sides: [[&Column; 2]; 2], factor: f64, other: impl Fn(usize) -> [f64; 2]) -> [Vec<f64>; 2] {
    let [[lower, has_lower], [upper, has_upper]] = sides.map(|side| side.map(floats));
    let bounds = |row: usize| {
        let (lower, upper) = (lower[row], upper[row]);
        let size = lower.abs() + upper.abs();
        let has_both = has_lower[row] != 0.0 && has_upper[row] != 0.0;
        if !has_both || upper - lower <= MARGIN * size {
            return <(f64, f64)>::from(other(row));
        }
        let (middle, reach) = ((lower + upper) / 2.0, (upper - lower) / 2.0 * factor);
        let margin = 4.0 * MARGIN * size * (1.0 + factor);
        (middle - reach + margin, middle + reach - margin)
    };
    let (lower, upper) = (0..lower.len()).map(bounds).unzip();
    [lower, upper]
}

/// Bounds that are known exactly.
fn exact_bounds([lower, upper]: [Option<Rational>; 2]) -> [f64; 2] {
    let rounded = |bound: &Rational, sign: f64| {
        let bound = float(bound);
        bound + sign * MARGIN * bound.abs()
    };
    let lower = lower.map_or(f64::NEG_INFINITY, |bound| rounded(&bound, 1.0));
    [lower, upper.map_or(f64::INFINITY, |bound| rounded(&bound, -1.0))]
}

/// Returns the positions of the readings that may be the first with the least slack at a point. Cost: linear.
pub(super) fn may_be_tightest(strips: &RoundedStrips, theta: [f64; 2]) -> Vec<usize> {
    /// The relative margin, 2⁻⁴⁴, that exceeds the error of the slack, for all terms together.
    const ALL: f64 = 16.0 * MARGIN;
    let size = |bound: f64| if bound.is_infinite() { 0.0 } else { bound.abs() };
    // The least that a slack may be, and the most; NaN where that is not known.
    let slack = |row: usize| {
        let (lower, upper) = (strips.lower[row], strips.upper[row]);
        let [p, q] = [strips.phi[0][row] * theta[0], strips.phi[1][row] * theta[1]];
        let margin = ALL * (p.abs() + q.abs() + size(lower) + size(upper));
        let (above, below) = (upper - (p + q), (p + q) - lower);
        // Not `min`, which would pass over what is not a number.
        let slack = if above < below { above } else { below };
        let is_known = !(above.is_nan() | below.is_nan());
        if is_known { [slack - margin, slack + margin] } else { [f64::NAN; 2] }
    };
    // Comparisons with what is not a number leave the least as it is.
    let least = (0..strips.len())
        .map(slack)
        .fold(f64::INFINITY, |least, [_, most]| if most < least { most } else { least });
    let is_more = |row: &usize| slack(*row)[0] > least;
    (0..strips.len()).filter(|row| !is_more(row)).collect()
}
