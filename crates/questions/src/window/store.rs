//! The half-planes of the readings in a window, and of the conditions, by number.

use std::collections::VecDeque;

use boundfit_estimation::{BoundName, Condition, Measurement, conditions_by_name, half_planes};
use boundfit_geometry::{Constraint, HalfPlane, Inequality};

/// The number of a half-plane: first the conditions, then the bounds of the readings as they came.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Id(u64);

/// A reading with what its bounds say.
#[derive(Debug, Clone)]
pub(super) struct Entry {
    pub(super) reading: Measurement,
    bounds: [Option<Constraint>; 2],
}

/// All half-planes.
#[derive(Debug, Clone, Default)]
pub(super) struct Store {
    conditions: Vec<(BoundName, Inequality, Constraint)>,
    entries: VecDeque<Entry>,
    /// The number of readings that left before the first of these.
    gone: u64,
}

impl Store {
    pub(super) fn new(conditions: &[Condition]) -> Self {
        let conditions = conditions_by_name(conditions).map(|(name, inequality)| {
            let constraint = inequality.constraint();
            (name, inequality, constraint)
        });
        Store { conditions: conditions.collect(), ..Store::default() }
    }

    pub(super) fn entries(&self) -> &VecDeque<Entry> {
        &self.entries
    }

    pub(super) fn has_conditions(&self) -> bool {
        !self.conditions.is_empty()
    }

    pub(super) fn push(&mut self, reading: Measurement) {
        let mut constraints = half_planes(&reading).map(|(_, inequality)| inequality.constraint());
        let bounds = [constraints.next(), constraints.next()];
        drop(constraints);
        self.entries.push_back(Entry { reading, bounds });
    }

    pub(super) fn pop_newest(&mut self) -> Option<Measurement> {
        self.entries.pop_back().map(|entry| entry.reading)
    }

    pub(super) fn pop_oldest(&mut self) -> Option<Measurement> {
        let oldest = self.entries.pop_front()?;
        self.gone += 1;
        Some(oldest.reading)
    }

    /// The numbers of the conditions.
    pub(super) fn ids_of_conditions(&self) -> impl Iterator<Item = Id> + use<> {
        (0..self.conditions.len() as u64).map(Id)
    }

    /// The numbers of the bounds of the reading at a position.
    pub(super) fn ids_of_reading(&self, position: usize) -> impl Iterator<Item = Id> + use<> {
        let first = self.conditions.len() as u64 + 2 * (self.gone + position as u64);
        let count = self.entries.get(position).map_or(0, |entry| entry.bounds.iter().flatten().count());
        (first..).take(count).map(Id)
    }

    /// The position of the reading with the bound of a number; `None` for conditions and for a reading that is gone.
    pub(super) fn position(&self, Id(id): Id) -> Option<usize> {
        let bound = id.checked_sub(self.conditions.len() as u64)?;
        Some((bound / 2).checked_sub(self.gone)? as usize)
    }

    /// The half-plane of a number; `None` for a removed reading.
    pub(super) fn constraint(&self, Id(id): Id) -> Option<&Constraint> {
        match id.checked_sub(self.conditions.len() as u64) {
            None => self.conditions.get(id as usize).map(|(.., constraint)| constraint),
            Some(bound) => {
                let position = (bound / 2).checked_sub(self.gone)?;
                self.entries.get(position as usize)?.bounds[(bound % 2) as usize].as_ref()
            }
        }
    }

    /// The half-plane with a number, unless it says something of no θ or of all.
    pub(super) fn half_plane(&self, id: Id) -> Option<&HalfPlane> {
        match self.constraint(id)? {
            Constraint::HalfPlane(half_plane) => Some(half_plane),
            Constraint::Always | Constraint::Never => None,
        }
    }

    /// The name of a half-plane and its inequality as given.
    pub(super) fn named(&self, Id(id): Id) -> Option<(BoundName, Inequality)> {
        match id.checked_sub(self.conditions.len() as u64) {
            None => {
                let (name, inequality, _) = self.conditions.get(id as usize)?;
                Some((*name, inequality.clone()))
            }
            Some(bound) => {
                let position = (bound / 2).checked_sub(self.gone)?;
                half_planes(&self.entries.get(position as usize)?.reading).nth((bound % 2) as usize)
            }
        }
    }
}
