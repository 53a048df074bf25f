//! Readings as floats, for filters that bear their roundings.

use boundfit_exact::Rational;
use boundfit_geometry::grid::{RoundedStrip, RoundedStrips, in_range};

use crate::measurement::{Bounds, Measurement};
use crate::scale::Scale;

/// The relative margin, 2⁻⁴⁸, that exceeds the error of a sum of two rounded numbers. Numbers of columns are within a
/// relative error of 2⁻⁵⁰, their products with a factor within 2⁻⁴⁹, and each operation adds 2⁻⁵³.
pub(crate) const MARGIN: f64 = 1.0 / (1_u64 << 48) as f64;

/// A number within a relative error of 2⁻⁵⁰, or NaN where a filter may not compute with it. Exact zeros are
/// exactly 0.
pub(crate) fn float(number: &Rational) -> f64 {
    let float = number.near_f64();
    if float == 0.0 && !number.is_zero() { f64::NAN } else { in_range(float) }
}

/// Readings in memory as the filter sees them.
pub(crate) fn strips_of(rows: &[Measurement], scale: &Scale) -> RoundedStrips {
    let mut strips = RoundedStrips::default();
    for row in rows {
        let RoundedStrip { phi, lower, upper } = strip(row, scale);
        strips.phi[0].push(phi[0]);
        strips.phi[1].push(phi[1]);
        strips.lower.push(lower);
        strips.upper.push(upper);
    }
    strips
}

fn strip(reading: &Measurement, scale: &Scale) -> RoundedStrip {
    let known = || exact_bounds(scale.bounds(reading));
    let [lower, upper] = match (&reading.bounds, scale) {
        (Bounds::Around { response, epsilon }, Scale::AsStated) => around(float(response), float(epsilon)),
        (Bounds::Around { response, epsilon }, Scale::Times(factor)) => {
            around(float(response), float(epsilon) * float(factor))
        }
        (Bounds::Around { response, .. }, Scale::Within(epsilon)) => around(float(response), float(epsilon)),
        (Bounds::Between { lower: Some(lower), upper: Some(upper), .. }, Scale::Times(factor)) => {
            let stated = [float(lower), float(upper)];
            if are_apart(stated) { about_middle(stated, float(factor)) } else { known() }
        }
        (Bounds::Between { .. }, _) => known(),
    };
    RoundedStrip { phi: reading.regressor.each_ref().map(float), lower, upper }
}

/// Bounds that lie this far around a number, certainly not too far apart.
pub(crate) fn around(middle: f64, reach: f64) -> [f64; 2] {
    let margin = MARGIN * (middle.abs() + reach);
    [middle - reach + margin, middle + reach - margin]
}

/// Returns false where two bounds may cross or are too close to tell. A number that is not known stays so in all that comes of it.
pub(crate) fn are_apart([lower, upper]: [f64; 2]) -> bool {
    let are_close = upper - lower <= MARGIN * (lower.abs() + upper.abs());
    !are_close
}

/// Two bounds that [are apart](are_apart) about their middle at a factor on their distance, certainly not too far apart.
pub(crate) fn about_middle([lower, upper]: [f64; 2], factor: f64) -> [f64; 2] {
    let size = lower.abs() + upper.abs();
    let (middle, reach) = ((lower + upper) / 2.0, (upper - lower) / 2.0 * factor);
    let margin = 4.0 * MARGIN * size * (1.0 + factor);
    [middle - reach + margin, middle + reach - margin]
}

/// Bounds that are known exactly.
pub(crate) fn exact_bounds([lower, upper]: [Option<Rational>; 2]) -> [f64; 2] {
    let rounded = |bound: &Rational, sign: f64| {
        let bound = float(bound);
        bound + sign * MARGIN * bound.abs()
    };
    let lower = lower.map_or(f64::NEG_INFINITY, |bound| rounded(&bound, 1.0));
    [lower, upper.map_or(f64::INFINITY, |bound| rounded(&bound, -1.0))]
}

/// Returns the positions of the readings that may be the first with the least slack at a point. Cost: linear.
pub(crate) fn may_be_tightest(strips: &RoundedStrips, theta: [f64; 2]) -> Vec<usize> {
    /// The relative margin, 2⁻⁴⁴, that exceeds the error of the slack, for all terms together.
    const ALL: f64 = 16.0 * MARGIN;
    let size = |bound: f64| if bound.is_infinite() { 0.0 } else { bound.abs() };
    // The least that a slack may be, and the most; NaN where that is not known.
    let slack = |[phi1, phi2, lower, upper]: [f64; 4]| {
        let [p, q] = [phi1 * theta[0], phi2 * theta[1]];
        let margin = ALL * (p.abs() + q.abs() + size(lower) + size(upper));
        let (above, below) = (upper - (p + q), (p + q) - lower);
        // Not `min`, which would pass over what is not a number.
        let slack = if above < below { above } else { below };
        let slack = if above.is_nan() | below.is_nan() { f64::NAN } else { slack };
        [slack - margin, slack + margin]
    };
    let [phi1, phi2] = &strips.phi;
    let numbers = || phi1.iter().zip(phi2).zip(strips.lower.iter().zip(&strips.upper));
    let rows = || numbers().map(|((&phi1, &phi2), (&lower, &upper))| [phi1, phi2, lower, upper]);
    let lows: Vec<f64> = rows().map(|row| slack(row)[0]).collect();
    // Comparisons with what is not a number leave the least as it is.
    let lowest = lows.iter().fold(f64::INFINITY, |least, &low| if low < least { low } else { least });
    let lowest = lows.iter().position(|&low| low == lowest).and_then(|row| rows().nth(row));
    let least = lowest.map_or(f64::INFINITY, |row| slack(row)[1]);
    let is_more = |row: &usize| lows[*row] > least;
    (0..lows.len()).filter(|row| !is_more(row)).collect()
}
