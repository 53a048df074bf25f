//! Systems moved to where the numbers are hard: the oracle judges them where they came from.

use boundfit_exact::{Integer, Rational};
use boundfit_geometry::{Direction, Inequality, Point, Region, RegionKind, Vertex};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use crate::oracle::{Answer, Row};

/// The map θ ↦ M·θ + t with an integer matrix of determinant 1. A large shear makes all normals nearly parallel and all
/// coefficients huge, and maps lattice directions one to one.
#[derive(Debug, Clone)]
pub struct Placement {
    matrix: [[Integer; 2]; 2],
    inverse: [[Integer; 2]; 2],
    translation: [Rational; 2],
}

impl Placement {
    /// Returns where everything stays.
    pub fn identity() -> Self {
        Placement::sheared(Integer::zero(), Integer::zero(), [Rational::zero(), Rational::zero()])
    }

    /// Two shears of up to 10²⁰ each, and a translation with up to 20 decimals.
    pub fn generated(rng: &mut ChaCha8Rng) -> Self {
        let size = |rng: &mut ChaCha8Rng| Integer::power_of_ten(rng.random_range(0..=20));
        let mut shear = || size(rng) * Integer::from(rng.random_range(-3..=3_i64));
        let (along, up) = (shear(), shear());
        let mut shift = || {
            let whole = size(rng) + Integer::from(rng.random_range(-9..=9_i64));
            Rational::new(whole, size(rng)).unwrap_or_default() * Rational::from(rng.random_range(-1..=1_i64))
        };
        Placement::sheared(along, up, [shift(), shift()])
    }

    /// [[1, s], [0, 1]]·[[1, 0], [r, 1]] and its inverse.
    fn sheared(s: Integer, r: Integer, translation: [Rational; 2]) -> Self {
        let one = Integer::one;
        let corner = &s * &r + one();
        Placement {
            matrix: [[corner.clone(), s.clone()], [r.clone(), one()]],
            inverse: [[one(), -s], [-r, corner]],
            translation,
        }
    }

    /// a·θ ≤ b as an inequality of the moved points: (a·M⁻¹)·θ' ≤ b + (a·M⁻¹)·t.
    pub fn inequality(&self, [a1, a2, b]: Row) -> Inequality {
        let [a1, a2] = [a1, a2].map(Integer::from);
        let form = [0, 1].map(|k| Rational::from(&a1 * &self.inverse[0][k] + &a2 * &self.inverse[1][k]));
        let shift = &form[0] * &self.translation[0] + &form[1] * &self.translation[1];
        let [f1, f2] = form;
        Inequality::new(f1, f2, Rational::from(Integer::from(b)) + shift)
    }

    /// A region of moved points in the oracle's terms, where they came from; `None` when a number does not fit.
    pub fn answer(&self, region: &Region) -> Option<Answer> {
        let vertex = |vertex: &Vertex| {
            let [x, y] = vertex.point().coordinates();
            let moved = [x - &self.translation[0], y - &self.translation[1]];
            let back = |row: &[Integer; 2]| {
                Rational::from(&row[0]) * &moved[0] + Rational::from(&row[1]) * &moved[1]
            };
            let point = Point::new(&back(&self.inverse[0]), &back(&self.inverse[1]));
            let (x, y, w) = point.homogeneous();
            Some(([x.to_i128()?, y.to_i128()?, w.to_i128()?], vertex.active().to_vec()))
        };
        // Directions are points' differences; the ray of a half-plane is a normal, which maps by the transpose.
        let [[m11, m12], [m21, m22]] = &self.matrix;
        let transposed = [[m11.clone(), m21.clone()], [m12.clone(), m22.clone()]];
        let is_normal = region.kind() == RegionKind::HalfPlane;
        let ray = |ray: &Direction| pair(&mapped(if is_normal { &transposed } else { &self.inverse }, ray)?);
        let line = |line: &Direction| match region.kind() {
            RegionKind::Plane => pair(line),
            _ => pair(&mapped(&self.inverse, line)?.of_line()),
        };
        Some(Answer {
            kind: region.kind().name(),
            vertices: region.vertices().iter().map(vertex).collect::<Option<_>>()?,
            rays: region.rays().iter().map(ray).collect::<Option<_>>()?,
            lines: region.lines().iter().map(line).collect::<Option<_>>()?,
        })
    }
}

fn mapped(matrix: &[[Integer; 2]; 2], direction: &Direction) -> Option<Direction> {
    let [x, y] = [0, 1].map(|k| &matrix[k][0] * direction.dx() + &matrix[k][1] * direction.dy());
    Direction::new(x, y)
}

fn pair(direction: &Direction) -> Option<[i128; 2]> {
    Some([direction.dx().to_i128()?, direction.dy().to_i128()?])
}
