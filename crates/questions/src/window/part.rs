//! The feasible set of some readings as two chains and two bounds on θ1.

use std::cmp::Ordering;

use boundfit_geometry::predicates::by_tightness;
use boundfit_geometry::{Constraint, HalfPlane};

use super::chain::{Chain, ChainUndo};
use super::store::{Id, Store};

/// The half-planes of some readings, as far as they are not superfluous.
#[derive(Debug, Clone, Default)]
pub(super) struct Part {
    pub(super) lower: Chain,
    pub(super) upper: Chain,
    /// θ1 is at least what this half-plane says.
    pub(super) left: Option<Id>,
    /// θ1 is at most what this half-plane says.
    pub(super) right: Option<Id>,
    /// An inequality 0 ≤ b that is false.
    pub(super) never: Option<Id>,
}

/// The state of a part before a half-plane came to it.
#[derive(Debug)]
pub(super) enum Undo {
    Lower(ChainUndo),
    Upper(ChainUndo),
    Left(Option<Id>),
    Right(Option<Id>),
    Never,
}

impl Part {
    /// Adds a half-plane; `None` where nothing changes.
    pub(super) fn insert(&mut self, store: &Store, id: Id) -> Option<Undo> {
        match store.constraint(id)? {
            Constraint::Always => None,
            Constraint::Never if self.never.is_some() => None,
            Constraint::Never => {
                self.never = Some(id);
                Some(Undo::Never)
            }
            Constraint::HalfPlane(own) if own.a2().is_negative() => {
                self.lower.insert(store, id).map(Undo::Lower)
            }
            Constraint::HalfPlane(own) if !own.a2().is_zero() => {
                self.upper.insert(store, id).map(Undo::Upper)
            }
            Constraint::HalfPlane(own) => {
                let (kept, undo): (_, fn(Option<Id>) -> Undo) = match own.a1().is_negative() {
                    true => (&mut self.left, Undo::Left),
                    false => (&mut self.right, Undo::Right),
                };
                let is_new = kept.is_none_or(|kept| is_tighter(store, own, id, kept));
                is_new.then(|| undo(kept.replace(id)))
            }
        }
    }

    /// Takes back the newest addition.
    pub(super) fn undo(&mut self, undo: Undo) {
        match undo {
            Undo::Lower(undo) => self.lower.undo(undo),
            Undo::Upper(undo) => self.upper.undo(undo),
            Undo::Left(before) => self.left = before,
            Undo::Right(before) => self.right = before,
            Undo::Never => self.never = None,
        }
    }

    /// All half-planes.
    pub(super) fn ids(&self) -> impl Iterator<Item = Id> + '_ {
        let flat = [self.left, self.right, self.never].into_iter().flatten();
        self.lower.ids().iter().chain(self.upper.ids()).copied().chain(flat)
    }
}

/// Returns whether a bound on θ1 is tighter than another one on the same side, or the same and older.
fn is_tighter(store: &Store, own: &HalfPlane, id: Id, other: Id) -> bool {
    store.half_plane(other).is_none_or(|half_plane| match by_tightness(own, half_plane) {
        Ordering::Less => true,
        Ordering::Equal => id < other,
        Ordering::Greater => false,
    })
}
