//! The share of further readings that the band of ε_min holds: against the sum itself, in rational arithmetic, and against
//! what sources of readings do.

use boundfit_estimation::{ErrorBound, Measurement, Measurements, Minimax, Model, half_planes};
use boundfit_exact::Rational;
use boundfit_geometry::{Polyhedron, System};
use boundfit_questions::guaranteed_share;
use boundfit_tests::generate::seeded;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// Σ_{i<d} C(N, i)·p^i·(1 − p)^(N − i).
fn sum(readings: u32, unknowns: u32, p: &BigRational) -> BigRational {
    let mut choices = BigInt::one();
    let mut sum = BigRational::zero();
    for index in 0..unknowns.min(readings + 1) {
        let term = p.pow(index as i32) * (BigRational::one() - p).pow((readings - index) as i32);
        sum += term * BigRational::from(choices.clone());
        choices = choices * (readings - index) / (index + 1);
    }
    sum
}

fn big(number: &Rational) -> BigRational {
    let part = |text: String| text.parse::<BigInt>().unwrap();
    BigRational::new(part(number.numerator().to_string()), part(number.denominator().to_string()))
}

#[test]
fn the_share_is_not_larger_than_the_sum_allows_nor_much_smaller() {
    let step = BigRational::new(BigInt::from(2), BigInt::from(10).pow(18));
    for unknowns in [2, 3] {
        for readings in (0..=12).chain([23, 46, 100]) {
            for confidence in ["1/1000000", "1/2", "9/10", "99/100", "999999/1000000"] {
                let (above, below) = confidence.split_once('/').unwrap();
                let confidence = Rational::ratio(above.parse().unwrap(), below.parse().unwrap());
                let share = guaranteed_share(readings, unknowns, &confidence).unwrap();
                let missed = BigRational::one() - big(&share);
                let doubt = BigRational::one() - big(&confidence);
                if readings < unknowns as usize {
                    assert!(share.is_zero(), "{readings}");
                    continue;
                }
                assert!(sum(readings as u32, unknowns, &missed) <= doubt, "{readings} {confidence}");
                assert!(
                    sum(readings as u32, unknowns, &(&missed - &step)) > doubt,
                    "{readings} {confidence}"
                );
            }
        }
    }
}

#[test]
fn more_readings_guarantee_more_and_more_confidence_less() {
    let share = |readings, confidence: &Rational| guaranteed_share(readings, 3, confidence).unwrap();
    let high = Rational::one() - Rational::scientific(1, -100);
    let confidences = [Rational::ratio(1, 10), Rational::ratio(99, 100), high];
    for pair in confidences.windows(2) {
        assert!(share(1000, &pair[0]) > share(1000, &pair[1]));
    }
    for confidence in &confidences {
        let shares = [3, 4, 10, 1000, 100_000, 10_000_000].map(|readings| share(readings, confidence));
        let is_more = |one: &Rational, other: &Rational| one < other || other.is_zero();
        assert!(shares.is_sorted_by(is_more), "{shares:?}");
    }
    assert!(guaranteed_share(1000, 2, &confidences[1]) > guaranteed_share(1000, 3, &confidences[1]));
    // (1 - p)^N is about exp(-N·p): p is about 8.4/N.
    let most = share(10_000_000, &confidences[1]);
    assert!(most > Rational::ratio(9_999_991, 10_000_000) && most < Rational::ratio(9_999_992, 10_000_000));
}

#[test]
fn a_confidence_lies_between_0_and_1() {
    for confidence in [Rational::zero(), Rational::one(), Rational::ratio(-1, 2), Rational::from(2)] {
        assert_eq!(guaranteed_share(10, 3, &confidence), None);
    }
}

const READINGS: usize = 8;
const DRAWS: usize = 100_000;

/// The band that readings leave: ε_min and, of all lines that are as good, the one nearest to θ = (0, 0).
fn band(readings: &[[i64; 2]]) -> (f64, [f64; 2]) {
    let one = Rational::one();
    let rows = |epsilon: &Rational| {
        let row = |(&[x, y], row): (&[i64; 2], usize)| {
            Measurement::around(row, [Rational::from(x), one.clone()], Rational::from(y), epsilon.clone())
        };
        readings.iter().zip(1..).map(row).collect::<Vec<_>>()
    };
    let model = Model::Line { x: "x".into() };
    let measurements = Measurements::new(model, "y".into(), ErrorBound::Uniform(one.clone()), rows(&one));
    let minimax = Minimax::new(&measurements, &[]).unwrap();
    let float = |number: &Rational| number.to_f64();
    let theta = if minimax.unique { minimax.theta.clone() } else { nearest(&rows(&minimax.least)) };
    (float(&minimax.least), theta.each_ref().map(float))
}

/// The point nearest to the origin of a segment or a line of parameters.
fn nearest(rows: &[Measurement]) -> [Rational; 2] {
    let system: System = rows.iter().flat_map(half_planes).map(|(_, own)| own).collect();
    let polyhedron = Polyhedron::intersect(system);
    let region = polyhedron.region();
    let points: Vec<_> = region.vertices().iter().map(|vertex| vertex.point().coordinates()).collect();
    let start = points.first().cloned().unwrap_or_else(|| region.witness().unwrap().coordinates());
    let along = match (points.get(1), region.lines().first()) {
        (Some(end), _) => [&end[0] - &start[0], &end[1] - &start[1]],
        (None, Some(line)) => [Rational::from(line.dx()), Rational::from(line.dy())],
        (None, None) => return start,
    };
    let dot = |u: &[Rational; 2], v: &[Rational; 2]| &u[0] * &v[0] + &u[1] * &v[1];
    let mut share = (-dot(&start, &along)).checked_div(&dot(&along, &along)).unwrap();
    if points.len() > 1 {
        share = share.max(Rational::zero()).min(Rational::one());
    }
    [&start[0] + &along[0] * &share, &start[1] + &along[1] * &share]
}

/// Returns the number of bands that miss more than is guaranteed, for each confidence.
fn beyond(
    rng: &mut ChaCha8Rng,
    draw: impl Fn(&mut ChaCha8Rng) -> [i64; 2],
    missed: impl Fn(f64, [f64; 2]) -> f64,
    confidences: &[f64],
) -> Vec<f64> {
    let allowed: Vec<f64> = confidences
        .iter()
        .map(|confidence| {
            let confidence = Rational::ratio((confidence * 100.0).round() as i64, 100);
            1.0 - guaranteed_share(READINGS, 3, &confidence).unwrap().to_f64()
        })
        .collect();
    let mut counts = vec![0_usize; confidences.len()];
    for _ in 0..DRAWS {
        let readings: [[i64; 2]; READINGS] = std::array::from_fn(|_| draw(rng));
        let (epsilon, theta) = band(&readings);
        let missed = missed(epsilon, theta);
        for (count, allowed) in counts.iter_mut().zip(&allowed) {
            *count += usize::from(missed > allowed + 1e-12);
        }
    }
    counts.into_iter().map(|count| count as f64 / DRAWS as f64).collect()
}

/// Five standard deviations of a share that is counted in so many draws.
fn tolerance(doubt: f64) -> f64 {
    5.0 * (doubt * (1.0 - doubt) / DRAWS as f64).sqrt()
}

const CONFIDENCES: [f64; 3] = [0.5, 0.9, 0.99];

/// x and the error uniform and as good as continuous: the chance to miss more than is allowed is just what is left of the
/// confidence.
#[test]
fn of_a_continuous_source_the_guarantee_holds_as_often_as_it_says() {
    const UNIT: i64 = 1 << 30;
    let draw = |rng: &mut ChaCha8Rng| [rng.random_range(0..UNIT), rng.random_range(-UNIT..UNIT)];
    let missed = |epsilon: f64, [theta1, theta2]: [f64; 2]| {
        let unit = UNIT as f64;
        let (epsilon, theta2) = (epsilon / unit, theta2 / unit);
        let covered_at = |x: f64| {
            let middle = theta1 * x + theta2;
            ((middle + epsilon).min(1.0) - (middle - epsilon).max(-1.0)).max(0.0) / 2.0
        };
        // Linear between the x where the band crosses the ends of what is drawn.
        let crossing = |level: f64| (level - theta2) / theta1;
        let levels = [1.0 - epsilon, 1.0 + epsilon, -1.0 - epsilon, -1.0 + epsilon];
        let mut ends: Vec<f64> =
            levels.map(crossing).into_iter().filter(|x| (0.0..1.0).contains(x)).collect();
        ends.extend([0.0, 1.0]);
        ends.sort_by(f64::total_cmp);
        let piece = |pair: &[f64]| (covered_at(pair[0]) + covered_at(pair[1])) / 2.0 * (pair[1] - pair[0]);
        1.0 - ends.windows(2).map(piece).sum::<f64>()
    };
    let found = beyond(&mut seeded(1631), draw, missed, &CONFIDENCES);
    println!("missed more than allowed: {found:?} of the draws");
    for (found, confidence) in found.iter().zip(CONFIDENCES) {
        let doubt = 1.0 - confidence;
        assert!((found - doubt).abs() <= tolerance(doubt), "{found} against {doubt}");
    }
}

/// Rounded readings, of which many are alike: it holds at least as often.
#[test]
fn of_a_discrete_source_the_guarantee_holds_at_least_as_often() {
    const X: [i64; 3] = [0, 1, 2];
    const Y: [(i64, f64); 4] = [(-1, 0.25), (0, 0.5), (1, 0.125), (3, 0.125)];
    let draw = |rng: &mut ChaCha8Rng| {
        let y = match rng.random_range(0..8) {
            0 | 1 => -1,
            2..=5 => 0,
            6 => 1,
            _ => 3,
        };
        [X[rng.random_range(0..3)], y]
    };
    let missed = |epsilon: f64, [theta1, theta2]: [f64; 2]| {
        // The band is closed.
        let is_missed = |x: i64, y: i64| (y as f64 - theta1 * x as f64 - theta2).abs() > epsilon + 1e-9;
        X.iter()
            .flat_map(|x| Y.iter().map(move |(y, share)| (*x, *y, share)))
            .map(|(x, y, share)| if is_missed(x, y) { share / 3.0 } else { 0.0 })
            .sum()
    };
    let found = beyond(&mut seeded(1632), draw, missed, &CONFIDENCES);
    println!("missed more than allowed: {found:?} of the draws");
    for (found, confidence) in found.iter().zip(CONFIDENCES) {
        let doubt = 1.0 - confidence;
        assert!(*found <= doubt + tolerance(doubt), "{found} against {doubt}");
    }
}
