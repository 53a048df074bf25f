//! The families of generated half-planes, each hard for some reason.

use boundfit_exact::Rational;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use super::half_planes::PlacedCase;
use super::placement::Placement;
use crate::generate::{half_planes, positive, tangents};
use crate::lp_cases::ten_to;
use crate::oracle::Row;

/// The difficulty of a set of half-planes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// Small integers: ties, parallels, repeated rows, zero normals. All ten kinds of region.
    Degenerate,
    /// The same over denominators, each row in units of its own.
    Rational,
    /// Normals that differ in the last of thirty bits.
    NearParallel,
    /// Boundaries through one or two points, coinciding in other units.
    Coinciding,
    /// Tangents to a circle: many sides.
    Circle,
    /// Any of these, sheared and moved: coefficients of up to eighty digits.
    Huge,
    /// Any of these, rows in units from 1e-30 to 1e30.
    Scaled,
}

impl Family {
    /// All of them.
    pub const ALL: [Family; 7] = [
        Family::Degenerate,
        Family::Rational,
        Family::NearParallel,
        Family::Coinciding,
        Family::Circle,
        Family::Huge,
        Family::Scaled,
    ];

    /// The name in the table of counts.
    pub fn name(self) -> &'static str {
        match self {
            Family::Degenerate => "degenerate",
            Family::Rational => "rational",
            Family::NearParallel => "near-parallel",
            Family::Coinciding => "coinciding",
            Family::Circle => "circle",
            Family::Huge => "huge",
            Family::Scaled => "scaled",
        }
    }

    /// A set of this family.
    pub fn case(self, rng: &mut ChaCha8Rng) -> PlacedCase {
        let rows = match self {
            Family::Degenerate | Family::Rational => half_planes(rng),
            Family::NearParallel => near_parallel(rng),
            Family::Coinciding => coinciding(rng),
            Family::Circle => circle(rng),
            Family::Huge | Family::Scaled => match rng.random_range(0..6) {
                0 => near_parallel(rng),
                1 => coinciding(rng),
                2 => circle(rng),
                _ => half_planes(rng),
            },
        };
        let placement = match self {
            Family::Huge => Placement::generated(rng),
            Family::Scaled if rng.random_bool(0.3) => Placement::generated(rng),
            _ => Placement::identity(),
        };
        let unit = |_: &Row| match self {
            Family::Rational | Family::Coinciding => positive(rng),
            Family::Scaled => positive(rng) * ten_to(rng.random_range(-30..=30)),
            _ => Rational::one(),
        };
        let units = rows.iter().map(unit).collect();
        PlacedCase::new(rows, units, placement, rng)
    }
}

/// Normals (n ± i, n ± j) for a large n, their boundaries close together or through one point.
fn near_parallel(rng: &mut ChaCha8Rng) -> Vec<Row> {
    let size: i128 = 1 << rng.random_range(8..=30);
    let spread = [1, 2, 40][rng.random_range(0..3)];
    let through = [rng.random_range(-1..=1_i128), rng.random_range(-1..=1_i128)];
    let apart = if rng.random_bool(0.5) { 1 } else { 50 };
    let count = rng.random_range(2..=10);
    let row = |_| {
        let a = size + rng.random_range(-spread..=spread);
        let b = size + rng.random_range(-spread..=spread);
        let c = a * through[0] + b * through[1] + rng.random_range(-apart..=apart);
        if rng.random_bool(0.5) { [a, b, c] } else { [-a, -b, -c] }
    };
    let mut rows: Vec<Row> = (0..count).map(row).collect();
    // Something across, now and then, so that not everything is a thin wedge.
    if rng.random_bool(0.5) {
        rows.push([1, -1, rng.random_range(-2..=2)]);
    }
    if rng.random_bool(0.3) {
        rows.push([-1, 1, rng.random_range(-2..=2)]);
    }
    rows
}

/// Boundaries through one of two lattice points, few directions, some rows multiples of others.
fn coinciding(rng: &mut ChaCha8Rng) -> Vec<Row> {
    let size = [3, 1_000][rng.random_range(0..2)];
    let points: [[i128; 2]; 2] = [[(); 2]; 2].map(|point| point.map(|()| rng.random_range(-size..=size)));
    let beside = if rng.random_bool(0.3) { 1 } else { 0 };
    let outward = rng.random_bool(0.5);
    let mut rows: Vec<Row> = Vec::new();
    for _ in 0..rng.random_range(2..=12) {
        let [a, b] = [rng.random_range(-4..=4), rng.random_range(-4..=4)];
        let [p, q] = points[rng.random_range(0..2)];
        let side = if outward && a * p + b * q < 0 { -1 } else { 1 };
        let times = rng.random_range(1..=3);
        let c = a * p + b * q + rng.random_range(-beside..=beside);
        rows.push([a, b, c].map(|value| side * times * value));
    }
    rows
}

/// Three to sixteen tangents, a few of them twice.
fn circle(rng: &mut ChaCha8Rng) -> Vec<Row> {
    let count = rng.random_range(3..=16);
    let mut rows = tangents(rng, count);
    for _ in 0..rng.random_range(0..=2) {
        rows.push(rows[rng.random_range(0..rows.len())].map(|value| 2 * value));
    }
    rows
}
