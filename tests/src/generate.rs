//! Generated inputs, the same on every run.

use boundfit_geometry::{Inequality, System};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::oracle::Row;

/// A generator that gives the same numbers for the same seed.
pub fn seeded(seed: u64) -> ChaCha8Rng {
    ChaCha8Rng::seed_from_u64(seed)
}

/// One to twelve integer half-planes, degenerate more often than not: small coefficients make ties, three lines
/// through a point, parallels and zero normals; some rows repeat, scale, oppose or shift an earlier one.
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
