//! Generated inputs, the same on every run.

use boundfit_exact::Rational;
use boundfit_geometry::{Inequality, System};
use rand::seq::SliceRandom;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::oracle::Row;

/// One generated case in this many is tried. `ONE_CASE_IN` sets another number; 1 tries all.
pub fn one_in() -> usize {
    let Ok(text) = std::env::var("ONE_CASE_IN") else { return 8 };
    text.parse().ok().filter(|&number| number > 0).expect("ONE_CASE_IN is a number above 0")
}

/// Returns the part of a number of cases that is tried. The number of hits that a test expects shrinks by the same factor.
pub fn share(all: usize) -> usize {
    all.div_ceil(one_in())
}

/// A generator that gives the same numbers for the same seed.
pub fn seeded(seed: u64) -> ChaCha8Rng {
    ChaCha8Rng::seed_from_u64(seed)
}

/// Returns one to twelve integer half-planes, degenerate more often than not. Small coefficients make ties, three
/// lines through a point, parallels and zero normals. Some rows repeat, scale, oppose or shift an earlier row.
pub fn half_planes(rng: &mut ChaCha8Rng) -> Vec<Row> {
    let count = rng.random_range(1..=12);
    let size: i128 = [1, 2, 4, 30][rng.random_range(0..4)];
    // Some systems keep to one direction or to the axes, or all contain the origin: the flat and unbounded kinds.
    let style = rng.random_range(0..8);
    // In the others every row is fresh, so that polygons with many sides occur too.
    let degenerate = rng.random_bool(0.6);
    let own: [i128; 2] = [rng.random_range(-size..=size), rng.random_range(-size..=size)];
    let mut rows: Vec<Row> = Vec::new();
    while rows.len() < count {
        let mut coefficient = || rng.random_range(-size..=size);
        let fresh = match style {
            0 => [own[0] * coefficient().signum(), own[1], coefficient()],
            1 => [coefficient(), 0, coefficient().abs()],
            2 | 6 | 7 => [coefficient(), coefficient(), coefficient().abs()],
            3 => [coefficient(), coefficient().signum(), 0],
            _ => [coefficient(), coefficient(), coefficient()],
        };
        let row = match (rows.last().copied().filter(|_| degenerate), rng.random_range(0..8)) {
            (Some([a, b, c]), 0) => [3 * a, 3 * b, 3 * c],
            (Some([a, b, c]), 1) => [-a, -b, -c],
            (Some([a, b, c]), 2) => [a, b, c + rng.random_range(-1..=1)],
            (Some([a, b, c]), 3) => [-2 * a, -2 * b, rng.random_range(-1..=1) - 2 * c],
            _ => fresh,
        };
        // Repeated scaling must stay within the oracle's range.
        if row.iter().all(|value| value.abs() < 1 << 20) {
            rows.push(row);
        }
    }
    rows
}

/// The system of integer rows.
pub fn system(rows: &[Row]) -> System {
    rows.iter().map(|&[a1, a2, b]| Inequality::new(a1.into(), a2.into(), b.into())).collect()
}

/// A small rational number.
pub fn rational(rng: &mut ChaCha8Rng) -> Rational {
    Rational::ratio(rng.random_range(-12..=12), rng.random_range(1..=4))
}

/// A small positive rational number; often 1.
pub fn positive(rng: &mut ChaCha8Rng) -> Rational {
    if rng.random_bool(0.3) {
        return Rational::one();
    }
    Rational::ratio(rng.random_range(1..=6), rng.random_range(1..=6))
}

/// The inequality times a positive number: the same half-plane in other units.
pub fn rescaled(inequality: &Inequality, times: &Rational) -> Inequality {
    let Inequality { a: [a1, a2], b } = inequality;
    Inequality::new(a1 * times, a2 * times, b * times)
}

/// The half-planes of [`half_planes`] with rational coefficients: each row in units of its own. Sometimes no row at
/// all.
pub fn rational_system(rng: &mut ChaCha8Rng) -> System {
    let rows = if rng.random_bool(0.01) { Vec::new() } else { half_planes(rng) };
    system(&rows).inequalities().iter().map(|inequality| rescaled(inequality, &positive(rng))).collect()
}

/// A linear form that asks for ties: zero, along an axis, along a normal of the system or between two of them, or
/// any small one.
pub fn form(rng: &mut ChaCha8Rng, system: &System) -> [Rational; 2] {
    let axis = |rng: &mut ChaCha8Rng| Rational::from(rng.random_range(-1..=1));
    let normal = |rng: &mut ChaCha8Rng| match system.len() {
        0 => [Rational::one(), Rational::zero()],
        count => system.inequalities()[rng.random_range(0..count)].a.clone(),
    };
    match rng.random_range(0..12) {
        0 => [Rational::zero(), Rational::zero()],
        1 => [axis(rng), Rational::zero()],
        2 => [Rational::zero(), axis(rng)],
        3..=6 => {
            let sign = [Rational::one(), -Rational::one()][rng.random_range(0..2)].clone();
            let times = positive(rng) * sign;
            normal(rng).map(|coefficient| coefficient * &times)
        }
        7 => {
            let ([f1, f2], [g1, g2]) = (normal(rng), normal(rng));
            [f1 + &g1, f2 + &g2]
        }
        _ => [rational(rng), rational(rng)],
    }
}

/// The numbers below `count` in random order.
pub fn shuffled(rng: &mut ChaCha8Rng, count: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    order.shuffle(rng);
    order
}

/// Tangents to the unit circle at rational points, the circle inside: polygons with almost as many sides as rows.
/// Every other time each side has a parallel one.
pub fn tangents(rng: &mut ChaCha8Rng, count: usize) -> Vec<Row> {
    let paired = rng.random_bool(0.5);
    let tangent = |rng: &mut ChaCha8Rng| -> Row {
        let (p, q): (i128, i128) = (rng.random_range(-700..=700), rng.random_range(1..=700));
        [q * q - p * p, 2 * p * q, q * q + p * p]
    };
    let mut rows: Vec<Row> = (0..count).map(|_| tangent(rng)).collect();
    if paired {
        rows.truncate(count.div_ceil(2));
        rows.extend(rows.clone().into_iter().map(|[a, b, c]| [-a, -b, c]));
    }
    rows
}

/// The kinds of large system.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Large {
    /// Every half-plane contains the origin.
    AroundOrigin,
    /// Half-planes anywhere: nearly always empty.
    Anywhere,
    /// Lower bounds of θ2 only.
    LowerBounds,
    /// Lower bounds of θ2 that touch a parabola: unbounded with many vertices.
    Parabola,
    /// Every boundary passes through one point.
    Pencil,
    /// Tangents to a circle: bounded with many vertices.
    Circle,
    /// Tangents to a circle, the last quarter from inside: empty, but only late.
    CircleInsideOut,
}

impl Large {
    /// All of them.
    pub const ALL: [Large; 7] = [
        Large::AroundOrigin,
        Large::Anywhere,
        Large::LowerBounds,
        Large::Parabola,
        Large::Pencil,
        Large::Circle,
        Large::CircleInsideOut,
    ];

    /// 200 to 2000 half-planes with coefficients up to 10⁶, as integers or over denominators up to 1000.
    pub fn system(self, rng: &mut ChaCha8Rng) -> System {
        let count = rng.random_range(200..=2000);
        let denominators = if rng.random_bool(0.5) { 1000 } else { 1 };
        let centre = [rational(rng), rational(rng)];
        let touching = tangents(rng, count);
        let row = |index: usize| {
            let mut from = |low: i64| {
                Rational::ratio(rng.random_range(low..=1_000_000), rng.random_range(1..=denominators))
            };
            let [least, positive] = [-1_000_000, 1];
            match self {
                Large::AroundOrigin => Inequality::new(from(least), from(least), from(positive)),
                Large::Anywhere => Inequality::new(from(least), from(least), from(least)),
                Large::LowerBounds => Inequality::new(from(least), -from(positive), from(least)),
                Large::Parabola => {
                    let slope = from(least) * Rational::ratio(1, 1000);
                    Inequality::new(&slope + &slope, -Rational::one(), &slope * &slope)
                }
                Large::Pencil => {
                    let [a1, a2] = [from(least), from(least)];
                    let b = &a1 * &centre[0] + &a2 * &centre[1];
                    Inequality::new(a1, a2, b)
                }
                Large::Circle | Large::CircleInsideOut => {
                    let inside_out = self == Large::CircleInsideOut && 4 * index > 3 * count;
                    let sign = Rational::from(if inside_out { -1 } else { 1 });
                    let [a1, a2, b] = touching[index].map(|value| Rational::from(value) * &sign);
                    let times =
                        Rational::ratio(rng.random_range(1..=1000), rng.random_range(1..=denominators));
                    rescaled(&Inequality::new(a1, a2, b), &times)
                }
            }
        };
        (0..count).map(row).collect()
    }
}
