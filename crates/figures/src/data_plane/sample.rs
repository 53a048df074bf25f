//! The choice by floats of the visible readings among very many.
//!
//! Thinned out, a panel shows of each column the reading that reaches lowest and the one that reaches highest. Floats leave out
//! what is certain to be neither, by a margin a thousand times wider than all their roundings; what is left is placed exactly.

use boundfit_exact::Rational;

/// The width of a column in which the extreme readings are kept, in pixels.
pub(super) const COLUMN: f64 = 3.0;
/// Fewer readings than this are all placed.
const FEW: usize = 2_000;
/// Half of the band around the end of a column in which a reading may belong to either, in columns.
const EDGE: f64 = 1e-3;
/// The possible error of floats, in parts of the largest number that they are made of.
const MARGIN: f64 = 1e-12;
/// Numbers below this lose digits in a float.
const LEAST: f64 = 1e-290;

/// x, y and ε of a reading of a line.
pub(super) type Floats = [f64; 3];

/// The reach of a column: with levels down and up, and with distances down and up, all taken as "down".
type Depths = [f64; 4];

/// Readings as floats.
struct Rough {
    /// The lower end of the axis of x, and the columns in a unit of it.
    lower: f64,
    scale: f64,
    /// The line that distances are taken from.
    theta: [f64; 2],
    margin: f64,
}

/// Returns the number of columns in which readings are thinned out on an axis of x of so many pixels.
pub(super) fn columns(length: f64) -> f64 {
    length / COLUMN
}

/// Returns whether each reading may be the lowest or the highest of its column on a panel, by its level or by its
/// distance from a line. Returns `None` where every reading needs a look. The floats are those of
/// [`Measurements::near_f64`](boundfit_estimation::Measurements::near_f64); whether two readings are the same is asked of few. Cost: some hundred instructions for each.
pub(super) fn may_be_seen(
    floats: &[Floats],
    are_same: impl Fn(usize, usize) -> bool,
    theta: Option<&[Rational; 2]>,
    abscissas: &[Rational; 2],
    columns: f64,
) -> Option<Vec<bool>> {
    if floats.len() < FEW {
        return None;
    }
    let rough = Rough::new(floats, theta, abscissas, columns)?;
    let mut deepest = vec![[f64::INFINITY; 4]; columns as usize + 2];
    for reading in floats {
        let (column, depths) = rough.place(reading);
        let deepest = deepest.get_mut(column as usize)?;
        deepest.iter_mut().zip(depths).for_each(|(deepest, depth)| *deepest = deepest.min(depth));
    }
    // Readings that are the same are in the same place: of those the first is seen.
    let mut last: Vec<[Option<usize>; 4]> = vec![[None; 4]; deepest.len()];
    let mut seen = Vec::with_capacity(floats.len());
    for (position, reading) in floats.iter().enumerate() {
        let (column, depths) = rough.place(reading);
        let (deepest, last) = (deepest.get(column as usize)?, last.get_mut(column as usize)?);
        let from_end = (column - column.round()).abs();
        let mut is_seen = from_end <= EDGE;
        for ((depth, deepest), last) in depths.iter().zip(deepest).zip(last) {
            let is_same = |other: usize| floats.get(other) == Some(reading) && are_same(other, position);
            if *depth <= deepest + rough.margin && !last.is_some_and(is_same) {
                *last = Some(position);
                is_seen = true;
            }
        }
        seen.push(is_seen);
    }
    Some(seen)
}

impl Rough {
    fn new(
        floats: &[Floats],
        theta: Option<&[Rational; 2]>,
        abscissas: &[Rational; 2],
        columns: f64,
    ) -> Option<Self> {
        let theta = theta.map_or([0.0; 2], |theta| theta.each_ref().map(Rational::to_f64));
        let [lower, upper] = abscissas.each_ref().map(Rational::to_f64);
        let mut most = [lower.abs().max(upper.abs()), 0.0, 0.0];
        for [_, y, epsilon] in floats {
            most = [most[0], most[1].max(y.abs()), most[2].max(*epsilon)];
        }
        let [x, y, epsilon] = most;
        let size = y + epsilon + theta[0].abs() * x + theta[1].abs();
        let is_fine = size.is_finite() && size > LEAST && x.is_finite();
        let width = upper - lower;
        let is_fine = is_fine && width > LEAST && width > 1e-9 * x;
        is_fine.then(|| Rough { lower, scale: columns / width, theta, margin: MARGIN * size })
    }

    /// Returns the place of a reading along the axis of x, in columns, and its depths.
    fn place(&self, [x, y, epsilon]: &Floats) -> (f64, Depths) {
        let distance = y - (self.theta[0] * x + self.theta[1]);
        let column = (x - self.lower) * self.scale;
        (column, [y - epsilon, -(y + epsilon), distance - epsilon, -(distance + epsilon)])
    }
}

#[cfg(test)]
mod tests {
    use boundfit_estimation::{Bounds, Measurement};

    use super::*;

    /// Numbers that look random, the same on every run.
    struct Numbers(u64);

    impl Numbers {
        fn below(&mut self, most: i64) -> i64 {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (self.0 >> 33) as i64 % most
        }
    }

    /// Returns, for each column, the first reading that reaches lowest and highest, by level and by distance, in
    /// fractions.
    fn outermost(
        readings: &[Measurement],
        theta: &[Rational; 2],
        ends: &[Rational; 2],
        columns: i64,
    ) -> Vec<usize> {
        let mut found: std::collections::BTreeMap<(Rational, usize), (Rational, usize)> = Default::default();
        for (index, reading) in readings.iter().enumerate() {
            let x = &reading.regressor[0];
            let at = (x - &ends[0]) * Rational::from(columns);
            let at = at.checked_div(&(&ends[1] - &ends[0])).unwrap();
            let column = Rational::from(&at.numerator().div_rem_floor(&at.denominator()).0);
            let line = &theta[0] * x + &theta[1];
            let (low, high) = (reading.lower().unwrap(), reading.upper().unwrap());
            let depths = [low.clone(), -&high, &low - &line, &line - &high];
            for (kind, depth) in depths.into_iter().enumerate() {
                let deepest = found.entry((column.clone(), kind)).or_insert((depth.clone(), index));
                if depth < deepest.0 {
                    *deepest = (depth, index);
                }
            }
        }
        found.into_values().map(|(_, index)| index).collect()
    }

    #[test]
    fn what_reaches_lowest_or_highest_is_never_left_out() {
        let mut numbers = Numbers(7);
        let mut left_out = 0;
        for (places, steps, offset, slope) in [
            (3, 100_000, 0, 2),
            (3, 7, 0, 2),
            (0, 1, 5, 0),
            (6, 1_000_000_000, 0, -3),
            (9, 1_000, 1_000_000, 1),
            (9, 1_000, 1_000_000_000_000_000_i64, 1),
            (300, 1_000, 0, 1),
        ] {
            let number = |count: i64| Rational::scientific(count, -places) + Rational::from(offset);
            let readings: Vec<Measurement> = (0..FEW + 500)
                .map(|row| {
                    let (x, noise) = (number(numbers.below(steps)), number(numbers.below(steps)));
                    let y = Rational::from(slope) * &x + noise;
                    let epsilon = Rational::ratio(numbers.below(3), 7);
                    Measurement::around(row + 1, [x, Rational::one()], y, epsilon)
                })
                .collect();
            let x = || readings.iter().map(|reading| reading.regressor[0].clone());
            let (least, most) = (x().min().unwrap(), x().max().unwrap());
            let half = Rational::ratio(1, 2);
            let ends = if least == most { [&least - &half, &most + &half] } else { [least, most] };
            let theta = [Rational::from(slope), Rational::ratio(1, 3)];
            let floats = |own: &Measurement| {
                let Bounds::Around { response, epsilon } = &own.bounds else {
                    unreachable!("bounds around y")
                };
                [&own.regressor[0], response, epsilon].map(Rational::near_f64)
            };
            let floats: Vec<Floats> = readings.iter().map(floats).collect();
            let are_same = |one: usize, other: usize| {
                let [one, other] = [one, other].map(|own| &readings[own]);
                (&one.regressor, &one.bounds) == (&other.regressor, &other.bounds)
            };
            let Some(seen) = may_be_seen(&floats, are_same, Some(&theta), &ends, 50.0) else { continue };
            left_out += seen.iter().filter(|&&is_seen| !is_seen).count();
            for index in outermost(&readings, &theta, &ends, 50) {
                assert!(seen[index], "{index} of {places} {steps} {offset} {slope}");
            }
        }
        assert!(left_out > 6_000, "only {left_out}");
    }
}
