//! The feasible set of a window of readings that moves on: one reading comes, the oldest one goes.
//!
//! A set that shrinks with every reading cannot grow again, so a window is a queue of two stacks. The newer readings
//! are one running intersection. The older readings were intersected from the youngest of them back to the oldest,
//! with a note of each change: taking back the last note removes the oldest reading. When none of them is left, the
//! newer ones become the older ones. Every reading is added twice and taken out once; questions look at both
//! intersections at once (`search.rs`).

mod answer;
mod chain;
mod gap;
mod known;
mod moving;
mod part;
mod search;
mod store;

use std::collections::VecDeque;
use std::sync::{Arc, OnceLock};

use boundfit_estimation::{
    BoundName, Bounds, Condition, Measurement, ParameterInterval, central_of, parameter_intervals,
};
use boundfit_exact::Rational;
use boundfit_geometry::predicates::{Side as Where, side};
use boundfit_geometry::{Inequality, Point, Polyhedron, RegionKind, System};

use answer::contradiction_of;
pub use answer::{Contradiction, WindowFit, WindowSet};
use gap::Gap;
use known::Known;
pub use moving::{Extent, Moved, Moving, Turn};
use part::{Part, Undo};
use search::{Both, Goal};
use store::{Id, Store};

/// The reason why a reading does not come to a window.
#[derive(Debug)]
pub(crate) struct Refusal {
    pub(crate) contradiction: Contradiction,
    /// The position of the oldest reading of the contradiction, or of the refused reading if it needs no other. As
    /// long as this reading is in the window, the refused one stays out.
    pub(crate) oldest: usize,
}

/// The readings of a window that moves on, in the order in which they came, and their feasible set under conditions that stay.
///
/// Exact: every answer is that of a fit of the same readings, whatever came and went before. Cost of a step, in the
/// number of half-planes that are not superfluous: amortised a logarithm of comparisons to add and to remove, and a
/// squared logarithm to answer. If n readings have random errors, that number is itself about log n. If x neither
/// ascends nor descends, each step also moves that many numbers of 8 bytes.
///
/// ```
/// use boundfit_estimation::Measurement;
/// use boundfit_exact::Rational;
/// use boundfit_questions::Window;
///
/// let mut window = Window::new(&[]);
/// for (row, (x, y)) in (1..).zip([(0, 0), (1, 1), (2, 2), (3, 9)]) {
///     let regressor = [Rational::from(x), Rational::one()];
///     window.push(Measurement::around(row, regressor, Rational::from(y), Rational::ratio(1, 2)));
/// }
/// assert_eq!(window.contradiction().unwrap().rows(), [1, 3, 4]);
/// window.pop();
/// window.pop();
/// assert_eq!(window.fit().pui.as_ref().unwrap()[0].interval().ends(), Some((&Rational::from(6), &Rational::from(8))));
/// ```
#[derive(Debug)]
pub struct Window {
    store: Store,
    older: Part,
    /// The changes by each of the older readings, the youngest first.
    notes: Vec<[Option<Undo>; 2]>,
    newer: Part,
    /// A point of the set, as far as one is known.
    witness: Option<Point>,
    /// The last answer, while it holds.
    known: OnceLock<Known>,
    /// The number of times that each error bound follows itself: one entry when all readings have the same bound.
    epsilons: VecDeque<(Option<Rational>, usize)>,
}

impl Window {
    /// Finds the answer from few half-planes.
    fn known(&self) -> Known {
        let both = self.both();
        let [gap, ends @ ..] = both.search([Goal::Gap, Goal::Left, Goal::Right, Goal::Bottom, Goal::Top]);
        let gap = Gap::at(&both, gap);
        let least = gap.value().and_then(|value| self.least(value));
        let mut ids = gap.ids();
        ids.extend(ends.into_iter().flat_map(|found| found.lower.into_iter().chain(found.upper)));
        let mut set = self.set_of(ids.clone());
        if set.polyhedron.kind() != RegionKind::Polygon {
            // The outermost ones tell in which directions the set goes on.
            for part in both.parts {
                for chain in [&part.lower, &part.upper] {
                    ids.extend(chain.ids().first().into_iter().chain(chain.ids().last()));
                }
            }
            set = self.set_of(ids.clone());
        }
        let WindowSet { polyhedron, names } = set;
        let pui = parameter_intervals(&polyhedron);
        let intervals = pui.as_ref().map(|pui| pui.each_ref().map(ParameterInterval::interval));
        let fit = WindowFit {
            kind: polyhedron.kind(),
            central: intervals.as_ref().and_then(central_of),
            contradiction: contradiction_of(&polyhedron, &names),
            least,
            system: polyhedron.system().clone(),
            pui,
            names,
        };
        Known::new(fit, ids, polyhedron)
    }

    /// No readings, under these conditions.
    pub fn new(conditions: &[Condition]) -> Self {
        let store = Store::new(conditions);
        let mut window = Window {
            older: Part::default(),
            notes: Vec::new(),
            newer: Part::default(),
            witness: None,
            known: OnceLock::new(),
            epsilons: VecDeque::new(),
            store,
        };
        window.begin_newer();
        window
    }

    /// Returns the number of readings.
    pub fn len(&self) -> usize {
        self.store.entries().len()
    }

    /// Returns whether there are no readings.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The readings, the oldest one first.
    pub fn readings(&self) -> impl DoubleEndedIterator<Item = &Measurement> {
        self.store.entries().iter().map(|entry| &entry.reading)
    }

    /// Adds a reading at the end. Cost: amortised a logarithm of comparisons.
    pub fn push(&mut self, reading: Measurement) {
        self.add(reading);
        self.keep_witness();
    }

    /// Adds a reading at the end unless nothing would be left. Then the error has the readings that contradict each
    /// other, with this reading unless they did so before, and the window stays as it is. Cost: as [`Window::push`];
    /// where the reading excludes the point that is known to be in the set, that of an answer.
    ///
    /// # Errors
    /// The contradiction.
    pub fn push_if_feasible(&mut self, reading: Measurement) -> Result<(), Contradiction> {
        self.push_or_refuse(reading).map_err(|refusal| refusal.contradiction)
    }

    /// Adds a reading as [`Window::push_if_feasible`] does, and returns how long a contradiction stays.
    pub(crate) fn push_or_refuse(&mut self, reading: Measurement) -> Result<(), Refusal> {
        let notes = self.add(reading);
        self.known.take();
        self.keep_witness();
        if self.witness.is_some() {
            return Ok(());
        }
        let gap = self.gap();
        if let Gap::Least { point: Some(point), .. } = gap {
            self.witness = Some(point);
            return Ok(());
        }
        let refusal = self.refusal_at(&gap);
        for undo in notes.into_iter().rev().flatten() {
            self.newer.undo(undo);
        }
        self.store.pop_newest();
        self.forget_newest_epsilon();
        match refusal {
            Some(refusal) => Err(refusal),
            // Not reached: a gap without a point is a contradiction.
            None => Ok(()),
        }
    }

    /// Takes out the oldest reading, if there is one. Cost: amortised a logarithm of comparisons.
    pub fn pop(&mut self) -> Option<Measurement> {
        if self.notes.is_empty() {
            self.turn();
        }
        let notes = self.notes.pop()?;
        for undo in notes.into_iter().rev().flatten() {
            self.older.undo(undo);
        }
        if let Some((_, count)) = self.epsilons.front_mut() {
            *count -= 1;
            if *count == 0 {
                self.epsilons.pop_front();
                self.known.take();
            }
        }
        let mut oldest = self.store.ids_of_reading(0);
        if self.known.get().is_some_and(|known| !oldest.all(|id| known.stays_without(id))) {
            self.known.take();
        }
        self.store.pop_oldest()
    }

    /// Returns whether a θ agrees with all readings and conditions. Exact. Cost: a squared logarithm.
    pub fn is_feasible(&self) -> bool {
        self.witness.is_some() || matches!(self.gap(), Gap::Least { point: Some(_), .. })
    }

    /// Returns the reason why no θ agrees with all readings and conditions, if none does. Exact. Cost: a squared
    /// logarithm.
    pub fn contradiction(&self) -> Option<Contradiction> {
        if self.witness.is_some() { None } else { self.contradiction_at(&self.gap()) }
    }

    /// The kind of the set, its intervals and the central estimate, each equal to that of a fit of these readings. Exact.
    /// Cost: a squared logarithm, unless no reading that came or went since the last answer can have changed it.
    pub fn fit(&self) -> Arc<WindowFit> {
        Arc::clone(&self.known.get_or_init(|| self.known()).fit)
    }

    /// The set with its vertices, from all half-planes that are not superfluous. Exact. Cost: k log k for k of them.
    pub fn set(&self) -> WindowSet {
        let both = self.both();
        self.set_of(both.parts.iter().flat_map(|part| part.ids()).collect())
    }

    /// ε_min, from the least value of L - U.
    fn least(&self, gap: &Rational) -> Option<Rational> {
        match (self.epsilons.front(), self.epsilons.len()) {
            (Some((Some(epsilon), _)), 1) if !self.store.has_conditions() => Some(epsilon + gap.half()),
            _ => None,
        }
    }

    fn both(&self) -> Both<'_> {
        Both { store: &self.store, parts: [&self.older, &self.newer] }
    }

    fn gap(&self) -> Gap {
        Gap::of(&self.both())
    }

    fn contradiction_at(&self, gap: &Gap) -> Option<Contradiction> {
        self.refusal_at(gap).map(|refusal| refusal.contradiction)
    }

    fn refusal_at(&self, gap: &Gap) -> Option<Refusal> {
        let named = self.named(gap.ids());
        let ids: Vec<(Id, BoundName)> = named.iter().map(|(id, (name, _))| (*id, *name)).collect();
        let WindowSet { polyhedron, names } = set_of_named(named);
        let contradiction = contradiction_of(&polyhedron, &names)?;
        let is_in = |name: &BoundName| contradiction.terms.iter().any(|(own, _)| own == name);
        let positions = ids.iter().filter(|(_, name)| is_in(name)).map(|(id, _)| self.store.position(*id));
        let oldest = positions.flatten().min().unwrap_or(self.len());
        Some(Refusal { contradiction, oldest })
    }

    /// The set of some half-planes, in the order of their names.
    fn set_of(&self, ids: Vec<Id>) -> WindowSet {
        set_of_named(self.named(ids))
    }

    /// Some half-planes in the order of their names.
    fn named(&self, mut ids: Vec<Id>) -> Vec<(Id, (BoundName, Inequality))> {
        ids.sort_unstable();
        ids.dedup();
        let mut named: Vec<_> = ids.into_iter().filter_map(|id| Some((id, self.store.named(id)?))).collect();
        named.sort_by_key(|(_, (name, _))| *name);
        named
    }

    /// Adds a reading, and tells what changed.
    fn add(&mut self, reading: Measurement) -> Vec<Option<Undo>> {
        self.add_epsilon(&reading);
        let position = self.store.entries().len();
        self.store.push(reading);
        let mut new = self.store.ids_of_reading(position);
        if self.known.get().is_some_and(|known| !new.all(|id| known.stays_with(&self.store, id))) {
            self.known.take();
        }
        let ids = self.store.ids_of_reading(position);
        ids.map(|id| self.newer.insert(&self.store, id)).collect()
    }

    /// Forgets the known point of the set when the newest reading excludes it.
    fn keep_witness(&mut self) {
        let Some(witness) = &self.witness else { return };
        let newest = self.store.entries().len().saturating_sub(1);
        let agrees = |id: Id| match self.store.constraint(id) {
            Some(boundfit_geometry::Constraint::Never) => false,
            _ => self.store.half_plane(id).is_none_or(|own| side(own, witness) != Where::Outside),
        };
        if !self.store.ids_of_reading(newest).all(agrees) {
            self.witness = None;
        }
    }

    /// Makes the newer readings the older ones.
    fn turn(&mut self) {
        // Another one of several half-planes that coincide may be named.
        self.known.take();
        self.older = Part::default();
        for position in (0..self.store.entries().len()).rev() {
            let mut ids = self.store.ids_of_reading(position);
            let mut note = || ids.next().and_then(|id| self.older.insert(&self.store, id));
            let notes = [note(), note()];
            self.notes.push(notes);
        }
        self.begin_newer();
    }

    /// The newer part without readings: the conditions alone.
    fn begin_newer(&mut self) {
        self.newer = Part::default();
        for id in self.store.ids_of_conditions() {
            self.newer.insert(&self.store, id);
        }
    }

    fn add_epsilon(&mut self, reading: &Measurement) {
        let is_line = reading.regressor[1] == Rational::one();
        let epsilon = match &reading.bounds {
            Bounds::Around { epsilon, .. } if is_line => Some(epsilon),
            _ => None,
        };
        match self.epsilons.back_mut() {
            Some((last, count)) if last.as_ref() == epsilon => *count += 1,
            _ => {
                self.epsilons.push_back((epsilon.cloned(), 1));
                self.known.take();
            }
        }
    }

    fn forget_newest_epsilon(&mut self) {
        if let Some((_, count)) = self.epsilons.back_mut() {
            *count -= 1;
            if *count == 0 {
                self.epsilons.pop_back();
            }
        }
    }
}

fn set_of_named(named: Vec<(Id, (BoundName, Inequality))>) -> WindowSet {
    let (names, inequalities): (Vec<_>, Vec<_>) = named.into_iter().map(|(_, own)| own).unzip();
    WindowSet { polyhedron: Polyhedron::intersect(System::new(inequalities)), names }
}
