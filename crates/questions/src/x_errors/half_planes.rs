//! The half-planes of a reading with a box, for the lines of one side.

use std::fmt;

use boundfit_estimation::{BoundName, conditions_by_name, half_planes};
use boundfit_exact::Rational;
use boundfit_geometry::Inequality;

use super::{Agreement, XErrorProblem};

/// The lines that a set holds. On each side |θ1| is linear.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Side {
    /// Lines that do not fall: θ1 ≥ 0.
    Rising,
    /// Lines that do not rise: θ1 ≤ 0.
    Falling,
    /// All.
    Both,
}

/// A corner of the box of a reading.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Corner {
    /// The corner at x - δ.
    Left,
    /// The corner at x + δ.
    Right,
}

/// The name of a half-plane of a set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum BoxBound {
    /// The line passes below (a bound that is upper) or above (lower) a corner of the box of a reading. Without a corner the
    /// box has no width, or it is a condition.
    Bound(BoundName, Option<Corner>),
    /// The line is one of the side.
    Slope(Side),
}

impl BoxBound {
    /// The bound of a reading, or the condition.
    pub fn name(self) -> Option<BoundName> {
        match self {
            BoxBound::Bound(name, _) => Some(name),
            BoxBound::Slope(_) => None,
        }
    }

    /// The bound of another data row that is equal; a condition stays itself.
    pub(super) fn of_row(self, row: usize) -> Self {
        match self {
            BoxBound::Bound(name, corner) => BoxBound::Bound(name.of_row(row), corner),
            of_side => of_side,
        }
    }

    /// The data row that it is a bound of.
    pub fn row(self) -> Option<usize> {
        self.name().and_then(BoundName::row)
    }
}

impl From<BoundName> for BoxBound {
    fn from(name: BoundName) -> Self {
        BoxBound::Bound(name, None)
    }
}

impl fmt::Display for Corner {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Corner::Left => "left",
            Corner::Right => "right",
        })
    }
}

impl fmt::Display for BoxBound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BoxBound::Bound(name, None) => name.fmt(f),
            BoxBound::Bound(name, Some(corner)) => write!(f, "{name} {corner}"),
            BoxBound::Slope(Side::Falling) => f.write_str("theta1 <= 0"),
            BoxBound::Slope(_) => f.write_str("theta1 >= 0"),
        }
    }
}

/// The half-planes of the readings, the conditions, and of the side itself. Exact.
pub(super) fn of_side(
    problem: &XErrorProblem,
    side: Side,
) -> impl Iterator<Item = (BoxBound, Inequality)> + '_ {
    let readings = problem.readings().flat_map(move |(row, width)| {
        half_planes(row).flat_map(move |(name, own)| {
            let corners = corners(problem.agreement(), side, name, width).into_iter().flatten();
            corners.map(move |corner| (BoxBound::Bound(name, corner), at_corner(&own, name, corner, width)))
        })
    });
    let conditions = conditions_by_name(&problem.problem().conditions).map(|(name, own)| (name.into(), own));
    let zero = Rational::zero;
    let slope = match side {
        Side::Rising => Some(-Rational::one()),
        Side::Falling => Some(Rational::one()),
        Side::Both => None,
    };
    let slope = slope.map(|a1| (BoxBound::Slope(side), Inequality::new(a1, zero(), zero())));
    readings.chain(conditions).chain(slope)
}

/// Returns the corners of a box, of half the width δ, that a bound of φ·θ is about. Rising lines meet a box that they
/// pass below the upper left corner of, and above the lower right one.
fn corners(
    agreement: Agreement,
    side: Side,
    name: BoundName,
    width: &Rational,
) -> [Option<Option<Corner>>; 2] {
    let is_upper = matches!(name, BoundName::Upper(_));
    match (agreement, side) {
        _ if width.is_zero() => [Some(None), None],
        (Agreement::Strong, _) | (Agreement::Weak, Side::Both) => {
            [Some(Some(Corner::Left)), Some(Some(Corner::Right))]
        }
        (Agreement::Weak, side) if is_upper == (side == Side::Rising) => [Some(Some(Corner::Left)), None],
        (Agreement::Weak, _) => [Some(Some(Corner::Right)), None],
    }
}

/// The bound of a reading at a corner of its box.
fn at_corner(own: &Inequality, name: BoundName, corner: Option<Corner>, width: &Rational) -> Inequality {
    let Inequality { a: [a1, a2], b } = own;
    let is_upper = matches!(name, BoundName::Upper(_));
    let a1 = match corner {
        None => a1.clone(),
        // x - δ, or of a lower bound -(x + δ).
        Some(corner) if is_upper == (corner == Corner::Left) => a1 - width,
        Some(_) => a1 + width,
    };
    Inequality::new(a1, a2.clone(), b.clone())
}
