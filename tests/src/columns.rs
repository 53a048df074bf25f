//! Generated points with integer coordinates, degenerate more often than not.

use boundfit_geometry::grid::GridPoint;
use rand::RngExt;
use rand::seq::IndexedRandom as _;
use rand_chacha::ChaCha8Rng;

/// Two columns of equal length.
pub type Columns = (Vec<i64>, Vec<i64>);

/// Shapes of sets of points, each hard for some reason.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// A few levels of x and of y: ties, repeated points, vertical runs and collinear runs.
    Levels,
    /// All on one line, or all above each other.
    Collinear,
    /// A line with noise.
    NoisyLine,
    /// All on a parabola, or between two.
    Parabola,
    /// Two clusters far from each other.
    Clusters,
    /// A cluster and one point far away.
    Outlier,
    /// x over many powers of two.
    Decades,
    /// Coordinates around ±2⁶¹, ±2⁶² and the ends of 64 bits.
    Edges,
    /// Points on a line of huge numbers, except the last bits, which no float sees.
    LastBits,
}

impl Shape {
    /// All of them.
    pub const ALL: [Shape; 9] = [
        Shape::Levels,
        Shape::Collinear,
        Shape::NoisyLine,
        Shape::Parabola,
        Shape::Clusters,
        Shape::Outlier,
        Shape::Decades,
        Shape::Edges,
        Shape::LastBits,
    ];

    /// Returns this many points of the shape.
    pub fn columns(self, rng: &mut ChaCha8Rng, count: usize) -> Columns {
        let levels = rng.random_range(1..=6);
        let slope = rng.random_range(-5..=5);
        let offset = [0, 7, -1_000_000_007][rng.random_range(0..3)];
        let noise = [1, 2, 1_000][rng.random_range(0..3)];
        let bend = rng.random_range(-1..=1);
        let is_vertical = rng.random_bool(0.2);
        let edges: Vec<i64> = [1_i64 << 61, 1 << 62, i64::MAX - 1, -(1 << 61), -(1 << 62), i64::MIN + 1, 0]
            .into_iter()
            .flat_map(|edge| [edge - 1, edge, edge + 1])
            .collect();
        let point = |k: usize| -> (i64, i64) {
            let any = |rng: &mut ChaCha8Rng, size: i64| rng.random_range(-size..=size);
            match self {
                Shape::Levels => (offset + any(rng, levels), any(rng, levels)),
                Shape::Collinear if is_vertical => (offset, any(rng, 1_000)),
                Shape::Collinear => {
                    let x = any(rng, 50);
                    (x, slope * x + offset)
                }
                Shape::NoisyLine => {
                    let x = any(rng, 100_000);
                    (x, slope * x + offset + any(rng, noise))
                }
                Shape::Parabola => {
                    let x = any(rng, 100_000);
                    let sign = if k.is_multiple_of(2) { 1 } else { bend };
                    (x, sign * (x * x - 10_000_000_000))
                }
                Shape::Clusters | Shape::Outlier => {
                    let is_far = if self == Shape::Outlier { k == count / 2 } else { k.is_multiple_of(2) };
                    let x = any(rng, 1_000) + if is_far { 1_000_000_000_000 } else { 0 };
                    (x, slope * x + any(rng, noise))
                }
                Shape::Decades => {
                    let size = 1 << rng.random_range(0..50);
                    let x = any(rng, size);
                    (x, slope * x + any(rng, noise))
                }
                Shape::Edges => {
                    let edge = |rng: &mut ChaCha8Rng| edges.choose(rng).copied().unwrap_or(0);
                    (edge(rng), edge(rng))
                }
                Shape::LastBits => {
                    let x = any(rng, 1 << 58);
                    (x, slope * x + any(rng, 2))
                }
            }
        };
        (0..count).map(point).unzip()
    }
}

/// The rows of columns as points, numbered from 0.
pub fn points((x, y): &Columns) -> Vec<GridPoint> {
    let point = |(row, (&x, &y)): (usize, (&i64, &i64))| GridPoint::of_row(x, y, row as u64);
    x.iter().zip(y).enumerate().map(point).collect()
}
