//! The linearity of a calibration by trying all triples, pairs and slopes, in the fractions of another library.

use std::collections::{BTreeMap, BTreeSet};

use num_rational::BigRational;
use num_traits::{Signed, Zero};

/// A fraction of the other library.
pub type Fraction = BigRational;

/// A reading: x, y, and whether x was rising, where that is known.
pub type Reading = (i64, i64, Option<bool>);

/// A whole number.
pub fn whole(number: i64) -> Fraction {
    Fraction::from_integer(number.into())
}

fn mean(values: &[Fraction]) -> Option<Fraction> {
    let sum: Fraction = values.iter().sum();
    (!values.is_empty()).then(|| sum / whole(values.len() as i64))
}

/// The points of a characteristic, with the positions of their readings from 1: of one direction, or of all.
pub fn points(readings: &[Reading], only: Option<bool>) -> Vec<(Fraction, Fraction, BTreeSet<usize>)> {
    let is_plain = readings.iter().all(|(.., up)| up.is_none());
    let numbered = || (1..).zip(readings);
    if is_plain {
        return numbered().map(|(row, (x, y, _))| (whole(*x), whole(*y), [row].into())).collect();
    }
    let places: BTreeSet<i64> = readings.iter().map(|(x, ..)| *x).collect();
    let mut points = Vec::new();
    for place in places {
        let own = |up: bool| -> Vec<(usize, Fraction)> {
            let wanted = |(_, (x, _, pass)): &(usize, &Reading)| {
                *x == place && *pass == Some(up) && only.is_none_or(|only| only == up)
            };
            numbered().filter(wanted).map(|(row, (_, y, _))| (row, whole(*y))).collect()
        };
        let both = [own(true), own(false)];
        let means: Vec<Fraction> = both
            .iter()
            .filter_map(|own| mean(&own.iter().map(|(_, y)| y.clone()).collect::<Vec<_>>()))
            .collect();
        let rows = both.iter().flatten().map(|(row, _)| *row).collect();
        if let Some(y) = mean(&means) {
            points.push((whole(place), y, rows));
        }
    }
    points
}

type Point = (Fraction, Fraction, BTreeSet<usize>);

/// The largest deviation from a line.
pub fn largest(points: &[Point], slope: &Fraction, intercept: &Fraction) -> Fraction {
    let deviation = |(x, y, _): &Point| (y - slope * x - intercept).abs();
    points.iter().map(deviation).max().expect("points")
}

/// The rows of the points where the largest deviation from a line is reached.
pub fn rows(points: &[Point], slope: &Fraction, intercept: &Fraction) -> Vec<usize> {
    let most = largest(points, slope, intercept);
    let is_most = |(x, y, _): &&Point| (y - slope * x - intercept).abs() == most;
    let rows: BTreeSet<usize> =
        points.iter().filter(is_most).flat_map(|(.., rows)| rows.iter().copied()).collect();
    rows.into_iter().collect()
}

/// The least largest deviation of a line: the largest that any three of the points force, or any two with one x (de la Vallée
/// Poussin).
pub fn independent(points: &[Point]) -> Fraction {
    let two = whole(2);
    let mut most = Fraction::zero();
    for (x1, y1, _) in points {
        for (x3, y3, _) in points {
            if x1 == x3 {
                most = most.max((y1 - y3).abs() / &two);
                continue;
            }
            for (x2, y2, _) in points.iter().filter(|(x2, ..)| x1 <= x2 && x2 <= x3) {
                let chord = y1 + (y3 - y1) * (x2 - x1) / (x3 - x1);
                most = most.max((y2 - chord).abs() / &two);
            }
        }
    }
    most
}

/// The least largest deviation of a line through a point: at some slope where two deviations are the same, or one is nothing.
pub fn zero_based(points: &[Point], through: [i64; 2]) -> Fraction {
    let [x0, y0] = through.map(whole);
    let moved: Vec<(Fraction, Fraction)> = points.iter().map(|(x, y, _)| (x - &x0, y - &y0)).collect();
    let mut slopes = vec![Fraction::zero()];
    for (u1, v1) in &moved {
        for (u2, v2) in &moved {
            for (du, dv) in [(u1 - u2, v1 - v2), (u1 + u2, v1 + v2)] {
                if !du.is_zero() {
                    slopes.push(dv / du);
                }
            }
        }
    }
    let of = |slope: &Fraction| moved.iter().map(|(u, v)| (v - slope * u).abs()).max().expect("points");
    slopes.iter().map(of).min().expect("slopes")
}

/// The largest deviation from the least-squares line, and its slope and intercept, from the normal equations.
pub fn least_squares(points: &[Point]) -> Option<(Fraction, [Fraction; 2])> {
    let sum = |of: &dyn Fn(&Point) -> Fraction| points.iter().map(of).sum::<Fraction>();
    let n = whole(points.len() as i64);
    let (sx, sy) = (sum(&|(x, ..)| x.clone()), sum(&|(_, y, _)| y.clone()));
    let (sxx, sxy) = (sum(&|(x, ..)| x * x), sum(&|(x, y, _)| x * y));
    let determinant = &n * &sxx - &sx * &sx;
    if determinant.is_zero() {
        return None;
    }
    let slope = (&n * sxy - &sx * &sy) / determinant;
    let intercept = (sy - &slope * sx) / n;
    Some((largest(points, &slope, &intercept), [slope, intercept]))
}

/// The largest deviation from the line through both ends, and the line.
pub fn terminal(points: &[Point]) -> Option<(Fraction, [Fraction; 2])> {
    let x = || points.iter().map(|(x, ..)| x);
    let (from, to) = (x().min()?, x().max()?);
    let end = |place: &Fraction| {
        mean(&points.iter().filter(|(x, ..)| x == place).map(|(_, y, _)| y.clone()).collect::<Vec<_>>())
    };
    if from == to {
        return None;
    }
    let (at_from, at_to) = (end(from)?, end(to)?);
    let slope = (at_to - &at_from) / (to - from);
    let intercept = at_from - &slope * from;
    Some((largest(points, &slope, &intercept), [slope, intercept]))
}

/// The largest less the smallest y.
pub fn span(points: &[Point]) -> Fraction {
    let y = || points.iter().map(|(_, y, _)| y);
    y().max().expect("points") - y().min().expect("points")
}

/// The largest difference of both averages at one x.
pub fn hysteresis(readings: &[Reading]) -> Option<Fraction> {
    let [up, down] = [true, false].map(|up| points(readings, Some(up)));
    if readings.iter().all(|(.., up)| up.is_none()) {
        return None;
    }
    let pairs = up.iter().flat_map(|(x1, y1, _)| {
        down.iter().filter(move |(x2, ..)| x1 == x2).map(move |(_, y2, _)| (y1 - y2).abs())
    });
    pairs.max()
}

/// The largest difference of two readings at one x in one direction.
pub fn repeatability(readings: &[Reading]) -> Option<Fraction> {
    let mut own: BTreeMap<(i64, Option<bool>), Vec<i64>> = BTreeMap::new();
    for (x, y, up) in readings {
        own.entry((*x, *up)).or_default().push(*y);
    }
    let spreads = own.values().filter(|values| values.len() > 1);
    spreads.map(|values| whole(values.iter().max().expect("two") - values.iter().min().expect("two"))).max()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tent_by_hand() {
        let readings: Vec<Reading> = [(0, 0), (1, 3), (2, 4)].map(|(x, y)| (x, y, None)).into();
        let points = points(&readings, None);
        let half = |number: i64| whole(number) / whole(2);
        assert_eq!(independent(&points), half(1));
        assert_eq!(terminal(&points), Some((whole(1), [whole(2), whole(0)])));
        // 3 - s and 2·s - 4 are the same where s is 7/3.
        assert_eq!(zero_based(&points, [0, 0]), whole(2) / whole(3));
        assert_eq!(least_squares(&points).unwrap().0, whole(2) / whole(3));
        assert_eq!((span(&points), hysteresis(&readings), repeatability(&readings)), (whole(4), None, None));
    }

    #[test]
    fn two_directions_by_hand() {
        let readings = [
            (0, 0, Some(true)),
            (0, 2, Some(false)),
            (1, 4, Some(true)),
            (1, 6, Some(true)),
            (2, 8, Some(false)),
        ];
        assert_eq!(hysteresis(&readings), Some(whole(2)));
        assert_eq!(repeatability(&readings), Some(whole(2)));
        let found: Vec<Fraction> = points(&readings, None).into_iter().map(|(_, y, _)| y).collect();
        assert_eq!(found, [1, 5, 8].map(whole));
    }
}
