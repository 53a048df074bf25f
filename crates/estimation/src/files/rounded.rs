//! Columns of readings as floats, for a filter that bears their roundings.

use boundfit_exact::{Column, Foreign};
use boundfit_geometry::grid::{RoundedStrips, in_range};

use crate::meaning::{ErrorBound, Meaning, Model};
use crate::measurement::Measurement;
use crate::rounded::{MARGIN, about_middle, around, exact_bounds, float};
use crate::scale::Scale;

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
    let (lower, upper) = match uniform {
        Some(epsilon) => {
            let reach = in_range(epsilon.to_f64()) * factor;
            response.iter().map(|&y| around(y, reach).into()).unzip()
        }
        None => {
            let epsilon = floats(columns.get(1)?);
            response.iter().zip(&epsilon).map(|(&y, epsilon)| around(y, epsilon * factor).into()).unzip()
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
        let has_both = has_lower[row] != 0.0 && has_upper[row] != 0.0;
        let known = has_both.then(|| about_middle([lower[row], upper[row]], factor)).flatten();
        <(f64, f64)>::from(known.unwrap_or_else(|| other(row)))
    };
    let (lower, upper) = (0..lower.len()).map(bounds).unzip();
    [lower, upper]
}
