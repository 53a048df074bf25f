//! One side of a feasible set: the half-planes that bound θ2 from one side, as far as none is implied by the others.

use std::cmp::Ordering;

use boundfit_exact::Integer;
use boundfit_geometry::HalfPlane;
use boundfit_geometry::predicates::{Turn, by_tightness, middle_is_implied, normal_turn};

use super::store::{Id, Store};

/// A value of θ1 as a fraction with a positive denominator.
#[derive(Debug, Clone)]
pub(super) struct Place {
    pub(super) numerator: Integer,
    pub(super) denominator: Integer,
}

/// The side of the set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    /// Half-planes with a2 < 0: θ2 is at least their largest bound. By angle they follow each other as θ1 grows.
    Lower,
    /// Half-planes with a2 > 0: θ2 is at most their least bound. By angle they follow each other as θ1 falls.
    Upper,
}

/// Half-planes of one side by the angle of their normals, every one of which bounds θ2 somewhere: an envelope.
#[derive(Debug, Clone, Default)]
pub(super) struct Chain(Vec<Id>);

/// The state of a chain before a half-plane came to it.
#[derive(Debug)]
pub(super) struct ChainUndo {
    at: usize,
    removed: Vec<Id>,
}

impl Chain {
    pub(super) fn ids(&self) -> &[Id] {
        &self.0
    }

    /// Adds a half-plane, and drops those that it makes superfluous. `None` when it is superfluous itself. If two
    /// coincide, the older one stays. Cost: a logarithm of comparisons, one for each that is dropped, and a move of
    /// what follows.
    pub(super) fn insert(&mut self, store: &Store, id: Id) -> Option<ChainUndo> {
        let new = store.half_plane(id)?;
        let own = |position: usize| store.half_plane(self.0[position]);
        let at = self.0.partition_point(|&other| {
            store.half_plane(other).is_some_and(|other| normal_turn(other, new) == Turn::Left)
        });
        let count = self.0.len();
        let implied = |f: Option<&HalfPlane>, g: Option<&HalfPlane>, h: Option<&HalfPlane>| match (f, g, h) {
            (Some(f), Some(g), Some(h)) => middle_is_implied(f, g, h),
            _ => false,
        };
        let (mut start, mut end) = (at, at);
        let parallel = (at < count).then(|| own(at)).flatten();
        if let Some(parallel) = parallel.filter(|parallel| normal_turn(parallel, new) == Turn::None) {
            match by_tightness(new, parallel) {
                Ordering::Greater => return None,
                Ordering::Equal if id > self.0[at] => return None,
                Ordering::Equal | Ordering::Less => end = at + 1,
            }
        } else if at > 0 && at < count && implied(own(at - 1), Some(new), own(at)) {
            return None;
        }
        while start >= 2 && implied(own(start - 2), own(start - 1), Some(new)) {
            start -= 1;
        }
        while end + 1 < count && implied(Some(new), own(end), own(end + 1)) {
            end += 1;
        }
        let removed = self.0.splice(start..end, [id]).collect();
        Some(ChainUndo { at: start, removed })
    }

    /// Takes back the newest addition. Cost: what that was.
    pub(super) fn undo(&mut self, ChainUndo { at, removed }: ChainUndo) {
        self.0.splice(at..=at, removed);
    }

    /// Returns the place on the θ1 axis where two neighbours hand over.
    pub(super) fn boundary(&self, store: &Store, position: usize) -> Option<Place> {
        let (x, w) = self.corner(store, position)?;
        Some(Place { numerator: x, denominator: w })
    }

    /// θ1 of the corner between a half-plane and the next one by angle, times a positive weight, and that weight.
    fn corner(&self, store: &Store, position: usize) -> Option<(Integer, Integer)> {
        let f = store.half_plane(*self.0.get(position)?)?;
        let g = store.half_plane(*self.0.get(position + 1)?)?;
        Some((f.b() * g.a2() - g.b() * f.a2(), f.a1() * g.a2() - f.a2() * g.a1()))
    }

    /// Returns the half-planes, among those at these positions, that bound θ2 just left and just right of a place.
    pub(super) fn around(
        &self,
        store: &Store,
        side: Side,
        [first, last]: [usize; 2],
        place: &Place,
    ) -> [usize; 2] {
        let compare = |position: usize| match self.corner(store, position) {
            Some((x, w)) => Integer::compare([(&x, &place.denominator)], [(&place.numerator, &w)]),
            None => Ordering::Greater,
        };
        // Corners lie from left to right by angle below, and from right to left above.
        let is_passed = |position: usize| match side {
            Side::Lower => compare(position) == Ordering::Less,
            Side::Upper => compare(position) == Ordering::Greater,
        };
        let (mut low, mut high) = (first, last);
        while low < high {
            let middle = low + (high - low) / 2;
            if is_passed(middle) { low = middle + 1 } else { high = middle }
        }
        let is_corner = low < last && compare(low) == Ordering::Equal;
        let next = if is_corner { low + 1 } else { low };
        match side {
            Side::Lower => [low, next],
            Side::Upper => [next, low],
        }
    }
}
