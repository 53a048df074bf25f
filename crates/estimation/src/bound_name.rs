//! Names of half-planes.

use std::cmp::Ordering;
use std::fmt;

/// The name of one half-plane of an FPS.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum BoundName {
    /// φ·θ ≤ y + ε, or the upper bound, of this data row.
    Upper(usize),
    /// φ·θ ≥ y - ε, or the lower bound, of this data row.
    Lower(usize),
    /// The condition with this number, from 1: an inequality.
    Where(usize),
    /// a·θ ≤ b of the condition with this number, an equation a·θ = b.
    WhereUpper(usize),
    /// a·θ ≥ b of the condition with this number, an equation a·θ = b.
    WhereLower(usize),
}

impl BoundName {
    /// Returns what reports sort by: rows first, each with its upper bound before its lower one, then conditions.
    fn rank(self) -> (bool, usize, bool) {
        match self {
            BoundName::Upper(row) => (false, row, false),
            BoundName::Lower(row) => (false, row, true),
            BoundName::Where(number) | BoundName::WhereUpper(number) => (true, number, false),
            BoundName::WhereLower(number) => (true, number, true),
        }
    }

    /// The data row that it is a bound of; `None` for a condition.
    pub fn row(self) -> Option<usize> {
        match self {
            BoundName::Upper(row) | BoundName::Lower(row) => Some(row),
            BoundName::Where(_) | BoundName::WhereUpper(_) | BoundName::WhereLower(_) => None,
        }
    }

    /// The bound on the same side of another data row; a condition stays itself.
    pub fn of_row(self, row: usize) -> Self {
        match self {
            BoundName::Upper(_) => BoundName::Upper(row),
            BoundName::Lower(_) => BoundName::Lower(row),
            of_condition => of_condition,
        }
    }

    /// The number of the condition that it belongs to, from 1; `None` for a reading.
    pub fn condition(self) -> Option<usize> {
        match self {
            BoundName::Upper(_) | BoundName::Lower(_) => None,
            BoundName::Where(number) | BoundName::WhereUpper(number) | BoundName::WhereLower(number) => {
                Some(number)
            }
        }
    }
}

impl Ord for BoundName {
    fn cmp(&self, other: &Self) -> Ordering {
        self.rank().cmp(&other.rank())
    }
}

impl PartialOrd for BoundName {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl fmt::Display for BoundName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BoundName::Upper(row) => write!(f, "{row} upper"),
            BoundName::Lower(row) => write!(f, "{row} lower"),
            BoundName::Where(number) => write!(f, "where:{number}"),
            BoundName::WhereUpper(number) => write!(f, "where:{number} upper"),
            BoundName::WhereLower(number) => write!(f, "where:{number} lower"),
        }
    }
}
