//! The point set of a region, and the values of forms and multipliers, computed without the engine.

use std::collections::BTreeMap;

use boundfit_exact::Rational;
use boundfit_geometry::{
    Boundary, Direction, HalfPlane, Inequality, Multiplier, Point, Region, RegionKind, System, Vertex,
};

use crate::generate::one_in;

/// A region as a set: everything about it but the indices of inequalities. Equal exactly for equal sets.
#[derive(Debug, PartialEq, Eq)]
pub struct Shape {
    /// The kind, one of ten.
    pub kind: RegionKind,
    /// The vertices.
    pub points: Vec<Point>,
    /// Extreme recession directions that are not lines.
    pub rays: Vec<Direction>,
    /// A basis of the lineality space.
    pub lines: Vec<Direction>,
    /// The boundaries of a region without vertices.
    pub boundaries: Vec<HalfPlane>,
}

/// The set that a region is.
pub fn shape(region: &Region) -> Shape {
    Shape {
        kind: region.kind(),
        points: region.vertices().iter().map(|vertex| vertex.point().clone()).collect(),
        rays: region.rays(),
        lines: region.lines(),
        boundaries: region.boundaries().iter().map(|boundary| boundary.half_plane().clone()).collect(),
    }
}

/// The active set of every vertex, then of every boundary line.
pub fn active_sets(region: &Region) -> Vec<Vec<usize>> {
    let vertices = region.vertices().iter().map(Vertex::active);
    vertices.chain(region.boundaries().iter().map(Boundary::active)).map(<[usize]>::to_vec).collect()
}

/// The directions in which the region goes on: its rays, and its lines both ways. Their cone is the recession cone.
pub fn recession(region: &Region) -> Vec<Direction> {
    let lines = region.lines().into_iter().flat_map(|line| [line.reversed(), line]);
    region.rays().into_iter().chain(lines).collect()
}

/// `form·point`.
pub fn value(form: &[Rational; 2], point: &Point) -> Rational {
    &form[0] * point.theta1() + &form[1] * point.theta2()
}

/// `form·direction`: by how much the form grows with every step in that direction.
pub fn growth(form: &[Rational; 2], direction: &Direction) -> Rational {
    &form[0] * Rational::from(direction.dx()) + &form[1] * Rational::from(direction.dy())
}

/// The sum of multiples of inequalities.
pub fn combined(system: &System, multipliers: &[Multiplier]) -> Inequality {
    let total = |part: fn(&Inequality) -> &Rational| -> Rational {
        multipliers.iter().map(|m| part(&system.inequalities()[m.index]) * &m.value).sum()
    };
    Inequality::new(total(|row| &row.a[0]), total(|row| &row.a[1]), total(|row| &row.b))
}

/// The inequalities with these indices, in that order.
pub fn subsystem(system: &System, indices: &[usize]) -> System {
    indices.iter().map(|&index| system.inequalities()[index].clone()).collect()
}

/// The system with one more inequality.
pub fn with(system: &System, inequality: Inequality) -> System {
    let mut more = system.clone();
    more.push(inequality);
    more
}

/// The number of times that each case of a test came up.
#[derive(Debug, Default)]
pub struct Tally(BTreeMap<&'static str, usize>);

impl Tally {
    /// Counts one more of a case.
    pub fn count(&mut self, case: &'static str) {
        *self.0.entry(case).or_default() += 1;
    }

    /// Fails unless every one of these cases came up that often: a test that never meets a case does not test it. Where
    /// not all cases are tried, fewer hits are enough in proportion.
    pub fn assert_each(&self, least: usize, cases: &[&'static str]) {
        for case in cases {
            assert!(
                self.0.get(case).copied().unwrap_or_default() >= least / one_in(),
                "{case} was hit too seldom: {self:?}"
            );
        }
    }

    /// The same for all ten kinds of region.
    pub fn assert_each_kind(&self, least: usize) {
        self.assert_each(least, &RegionKind::ALL.map(RegionKind::name));
    }
}
