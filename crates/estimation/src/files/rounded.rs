//! Columns of readings as floats, for a filter that bears their roundings.

use boundfit_exact::{Column, Foreign, Unit};
use boundfit_geometry::grid::{RoundedStrips, in_range};

use crate::meaning::{ErrorBound, Meaning, Model};
use crate::measurement::Measurement;
use crate::rounded::{MARGIN, about_middle, are_apart, around, exact_bounds, float};
use crate::scale::Scale;

/// The numbers of a column in this sense. Cost: a nanosecond or two each, but for those that are far beyond the range.
fn floats(column: &Column) -> Vec<f64> {
    let unit = match column {
        Column::Narrow(scaled) => Some(scaled.unit()),
        Column::Wide(scaled) => Some(scaled.unit()),
        _ => None,
    };
    // Integers of 126 bits are in range on any unit but that of a far exponent.
    let is_in_range = match unit {
        Some(Unit::TenTo(exponent)) => exponent.unsigned_abs() <= 100,
        Some(Unit::Any | Unit::OneOver(_)) => true,
        None => false,
    };
    match column.rounded() {
        Some(floats) if is_in_range => floats,
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
    Some(match uniform {
        Some(epsilon) => {
            let reach = in_range(epsilon.to_f64()) * factor;
            both(response.iter().map(|&y| around(y, reach)))
        }
        None => {
            let epsilon = floats(columns.get(1)?);
            both(response.iter().zip(&epsilon).map(|(&y, epsilon)| around(y, epsilon * factor)))
        }
    })
}

/// The first and the second number of all pairs. Two loops without branches compute many of them at a time.
fn both(pairs: impl Iterator<Item = [f64; 2]> + Clone) -> [Vec<f64>; 2] {
    [pairs.clone().map(|[first, _]| first).collect(), pairs.map(|[_, second]| second).collect()]
}

/// Bounds as they are stated, `sign` times infinity away where there is none; behind each bound stands whether it is there.
fn stated(side: Option<[&Column; 2]>, sign: f64, count: usize) -> Vec<f64> {
    let Some([bound, presence]) = side else { return vec![sign * f64::NEG_INFINITY; count] };
    let mut bounds = floats(bound);
    bounds.iter_mut().for_each(|bound| *bound += sign * MARGIN * bound.abs());
    if presence.has_zero() {
        let missing = bounds.iter_mut().zip(floats(presence)).filter(|(_, presence)| *presence == 0.0);
        missing.for_each(|(bound, _)| *bound = sign * f64::NEG_INFINITY);
    }
    bounds
}

/// Bounds about their middles at a factor on their distance. Bounds that cross, or of which one is missing, stay as
/// they are. Other bounds may be too close to tell: `other` gives their values.
fn about_middles(sides: [[&Column; 2]; 2], factor: f64, other: impl Fn(usize) -> [f64; 2]) -> [Vec<f64>; 2] {
    let stated = sides.map(|[bound, _]| floats(bound));
    let pairs = || stated[0].iter().zip(&stated[1]).map(|(&lower, &upper)| [lower, upper]);
    let [mut lower, mut upper] = both(pairs().map(|pair| about_middle(pair, factor)));
    let mut set = |row: usize| [lower[row], upper[row]] = other(row);
    (0..).zip(pairs()).filter(|(_, pair)| !are_apart(*pair)).for_each(|(row, _)| set(row));
    for presence in sides.iter().map(|[_, presence]| presence).filter(|presence| presence.has_zero()) {
        (0..).zip(floats(presence)).filter(|(_, presence)| *presence == 0.0).for_each(|(row, _)| set(row));
    }
    [lower, upper]
}
