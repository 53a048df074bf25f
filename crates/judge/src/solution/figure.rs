//! Numbers as solvers print them.

use boundfit_lp::Printed;

/// A number as a solver prints it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Figure {
    /// A number, exactly as the text spells it.
    Finite(Printed),
    /// `inf`, `nan` or a relative of theirs.
    NotFinite,
}

impl Figure {
    /// The number, if it is finite.
    pub fn finite(&self) -> Option<&Printed> {
        match self {
            Figure::Finite(printed) => Some(printed),
            Figure::NotFinite => None,
        }
    }
}
