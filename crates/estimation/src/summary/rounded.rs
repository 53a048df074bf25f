//! Columns of readings as floats, for a filter that bears their roundings.

use boundfit_exact::{Column, Foreign, Rational, Unit};
use boundfit_geometry::grid::{RoundedStrip, in_range};

use super::scale::Scale;
use crate::meaning::{ErrorBound, Meaning, Model};
use crate::measurement::Measurement;

/// Of a sum of two rounded numbers, more than it may be off: 2⁻⁴⁹.
const MARGIN: f64 = 1.0 / (1_u64 << 49) as f64;

/// A column, or a number that all rows have, each within a relative error of 2⁻⁵¹.
enum Floats<'a> {
    Narrow(&'a [i64], f64),
    Wide(&'a [i128], f64),
    Doubles(&'a [f64]),
    Any(&'a Column),
    Same(f64),
}

impl<'a> Floats<'a> {
    fn new(column: &'a Column) -> Self {
        let unit = |unit: Unit| unit.value().to_f64();
        match column {
            Column::Narrow(scaled) => Floats::Narrow(scaled.counts(), unit(scaled.unit())),
            Column::Wide(scaled) => Floats::Wide(scaled.counts(), unit(scaled.unit())),
            Column::Doubles(doubles) => Floats::Doubles(doubles),
            Column::Long(_) | Column::Fractions(_) => Floats::Any(column),
        }
    }

    fn same(number: &Rational) -> Self {
        Floats::Same(number.to_f64())
    }

    #[inline]
    fn get(&self, row: usize) -> f64 {
        in_range(match self {
            Floats::Narrow(counts, unit) => counts[row] as f64 * unit,
            Floats::Wide(counts, unit) => counts[row] as f64 * unit,
            Floats::Doubles(doubles) => doubles[row],
            Floats::Any(column) => column.get(row).to_f64(),
            Floats::Same(number) => *number,
        })
    }
}

/// Readings in columns as the filter sees them.
pub(super) struct RoundedReadings<'a> {
    phi: [Floats<'a>; 2],
    /// Whether x is counted from another origin: a difference of rounded numbers may have no digit that is right.
    is_moved: bool,
    bounds: RoundedBounds<'a>,
}

enum RoundedBounds<'a> {
    Around(Around<'a>),
    /// The lower and the upper bound, each with what is 0 where it is not there.
    Between([Option<[Floats<'a>; 2]>; 2]),
    /// Both, at a factor on their distance.
    Times([[Floats<'a>; 2]; 2], f64),
    /// What the columns alone do not say.
    Other,
}

/// y, and a multiple of the error bounds.
struct Around<'a> {
    response: Floats<'a>,
    epsilon: Floats<'a>,
    factor: f64,
}

impl<'a> RoundedReadings<'a> {
    pub(super) fn new(meaning: &Meaning, scale: &Scale, columns: &'a [Column]) -> Self {
        let regressors = if matches!(meaning.model, Model::Line { .. }) { 1 } else { 2 };
        let second = if regressors == 1 { Floats::Same(1.0) } else { Floats::new(&columns[1]) };
        let around = || {
            let (response, own) = (columns.get(regressors)?, columns.get(regressors + 1));
            let (epsilon, factor) = match scale {
                Scale::Within(epsilon) => (Floats::same(epsilon), 1.0),
                Scale::AsStated | Scale::Times(_) => {
                    let stated = match meaning.error_bound.uniform() {
                        Some(epsilon) => Floats::same(epsilon),
                        None => Floats::new(own?),
                    };
                    (stated, if let Scale::Times(factor) = scale { factor.to_f64() } else { 1.0 })
                }
            };
            Some(Around { response: Floats::new(response), epsilon, factor: in_range(factor) })
        };
        let bounds = match &meaning.error_bound {
            _ if meaning.is_around_y() => around().map_or(RoundedBounds::Other, RoundedBounds::Around),
            ErrorBound::Interval { lower, upper } => {
                let mut rest = columns.iter().skip(regressors + usize::from(meaning.has_response));
                let mut side = |column: &Option<Foreign>| {
                    column.as_ref()?;
                    Some([Floats::new(rest.next()?), Floats::new(rest.next()?)])
                };
                match (scale, [side(lower), side(upper)]) {
                    (Scale::AsStated, sides) => RoundedBounds::Between(sides),
                    (Scale::Times(factor), [Some(lower), Some(upper)]) => {
                        RoundedBounds::Times([lower, upper], in_range(factor.to_f64()))
                    }
                    _ => RoundedBounds::Other,
                }
            }
            _ => RoundedBounds::Other,
        };
        let is_moved = regressors == 1 && !meaning.form.x_origin.is_zero();
        RoundedReadings { phi: [Floats::new(&columns[0]), second], is_moved, bounds }
    }

    /// The strip of a row. `reading` gives the reading itself where the columns do not say its bounds.
    #[inline]
    pub(super) fn strip(&self, row: usize, scale: &Scale, reading: impl Fn() -> Measurement) -> RoundedStrip {
        let mut phi = self.phi.each_ref().map(|column| column.get(row));
        if self.is_moved {
            phi[0] = in_range(reading().regressor[0].to_f64());
        }
        match &self.bounds {
            RoundedBounds::Around(Around { response, epsilon, factor }) => {
                let (y, reach) = (response.get(row), epsilon.get(row) * factor);
                let margin = MARGIN * (y.abs() + reach);
                RoundedStrip { phi, lower: y - reach + margin, upper: y + reach - margin }
            }
            RoundedBounds::Between(sides) => {
                let side = |side: &Option<[Floats; 2]>, sign: f64| {
                    let there = side.as_ref().filter(|[_, presence]| presence.get(row) != 0.0);
                    there.map_or(sign * f64::NEG_INFINITY, |[bound, _]| {
                        let bound = bound.get(row);
                        bound + sign * MARGIN * bound.abs()
                    })
                };
                RoundedStrip { phi, lower: side(&sides[0], 1.0), upper: side(&sides[1], -1.0) }
            }
            RoundedBounds::Times(sides, factor) => {
                let [[lower, has_lower], [upper, has_upper]] = sides;
                let (lower, upper) = (lower.get(row), upper.get(row));
                let size = lower.abs() + upper.abs();
                // Bounds that cross, or of which one is missing, stay as they are, and others may be too close to tell.
                let has_both = has_lower.get(row) != 0.0 && has_upper.get(row) != 0.0;
                if !has_both || upper - lower <= MARGIN * size {
                    return exact_strip(phi, scale.bounds(&reading()));
                }
                let (middle, reach) = ((lower + upper) / 2.0, (upper - lower) / 2.0 * factor);
                let margin = 4.0 * MARGIN * size * (1.0 + factor);
                RoundedStrip { phi, lower: middle - reach + margin, upper: middle + reach - margin }
            }
            RoundedBounds::Other => exact_strip(phi, scale.bounds(&reading())),
        }
    }
}

/// The strip with bounds that are known exactly.
fn exact_strip(phi: [f64; 2], [lower, upper]: [Option<Rational>; 2]) -> RoundedStrip {
    let rounded = |bound: &Rational, sign: f64| {
        let bound = in_range(bound.to_f64());
        bound + sign * MARGIN * bound.abs()
    };
    RoundedStrip {
        phi,
        lower: lower.map_or(f64::NEG_INFINITY, |bound| rounded(&bound, 1.0)),
        upper: upper.map_or(f64::INFINITY, |bound| rounded(&bound, -1.0)),
    }
}

/// Of so many readings, those that may be the first with the least slack at a point, by position. Cost: linear.
pub(super) fn may_be_tightest(
    readings: &RoundedReadings,
    count: usize,
    theta: [f64; 2],
    reading: impl Fn(usize) -> Measurement,
) -> Vec<usize> {
    /// Of all terms together, more than the slack may be off: 2⁻⁴⁵.
    const ALL: f64 = 16.0 * MARGIN;
    let slack = |row: usize| {
        let RoundedStrip { phi, lower, upper } = readings.strip(row, &Scale::AsStated, || reading(row));
        let [p, q] = [phi[0] * theta[0], phi[1] * theta[1]];
        let size = |bound: f64| if bound.is_infinite() { 0.0 } else { bound.abs() };
        let margin = ALL * (p.abs() + q.abs() + size(lower) + size(upper));
        // Not `min`, which would pass over what is not a number.
        let (above, below) = (upper - (p + q), (p + q) - lower);
        let slack = if above < below { above } else { below };
        (slack, if above.is_nan() || below.is_nan() { f64::NAN } else { margin })
    };
    let slacks: Vec<(f64, f64)> = (0..count).map(slack).collect();
    let least = slacks.iter().map(|(slack, margin)| slack + margin).filter(|own| !own.is_nan());
    let least = least.fold(f64::INFINITY, f64::min);
    let is_more = |(slack, margin): &(f64, f64)| slack - margin > least;
    (0..count).filter(|&row| !is_more(&slacks[row])).collect()
}
