//! The few half-planes of two parts that decide a question about the set of both.
//!
//! The set is {θ : L(θ1) ≤ θ2 ≤ U(θ1), left ≤ θ1 ≤ right} with L convex and U concave, each the tighter one of two
//! chains. The search moves along the θ1 axis: at a corner of a chain the slopes of L and U there show whether the
//! answer lies further left or right. In the end each chain has one half-plane left, or two that meet at the answer.
//! These few half-planes have a set of their own with the same answer, since what is convex cannot turn twice.

use std::cmp::Ordering;

use boundfit_exact::{Integer, Sign};
use boundfit_geometry::HalfPlane;
use boundfit_geometry::predicates::{Turn, normal_turn};

use super::chain::{Chain, Place, Side};
use super::part::Part;
use super::store::{Id, Store};

/// The question about a set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Goal {
    /// The place where L - U is least: the set is empty exactly when it is positive there, or left is right of right.
    Gap,
    /// The least θ1.
    Left,
    /// The largest θ1.
    Right,
    /// The least θ2.
    Bottom,
    /// The largest θ2.
    Top,
}

/// The direction of an answer, seen from a place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Way {
    Left,
    Here,
    Right,
}

/// Two parts and what is known of θ1 from both.
#[derive(Debug, Clone, Copy)]
pub(super) struct Both<'a> {
    pub(super) store: &'a Store,
    pub(super) parts: [&'a Part; 2],
}

/// The result of a search.
#[derive(Debug, Default)]
pub(super) struct Found {
    /// The half-planes that bound θ2 from below where the answer lies.
    pub(super) lower: Vec<Id>,
    /// The half-planes that bound it from above.
    pub(super) upper: Vec<Id>,
    /// θ1 of the answer, where a corner of a chain has it, or two chains of one side meet there.
    pub(super) place: Option<Place>,
    /// The places that the answer lies between, if it is not known.
    pub(super) between: [Option<Place>; 2],
}

/// The half-planes that are L or U just left and just right of a place.
type Active<'a> = Option<[&'a HalfPlane; 2]>;

/// The positions of a chain at which the answer may lie, first and last.
type Range = Option<[usize; 2]>;

/// The parts of the chains at which an answer may lie, and the places that it lies between.
#[derive(Debug, Clone)]
struct Narrowed {
    ranges: [Range; 4],
    between: [Option<Place>; 2],
}

/// The bounds on θ2 at a place, which every goal looks at.
#[derive(Debug)]
struct View<'a> {
    /// The place beside the bounds on θ1 from the left and from the right.
    walls: [Ordering; 2],
    lower: Active<'a>,
    upper: Active<'a>,
    /// L beside U.
    gap: Ordering,
    /// The trend of L - U to the right of the place.
    falls: Turn,
    /// The trend from the left up to the place.
    grows: Turn,
}

/// The chains: a side and a part of each.
const CHAINS: [(Side, usize); 4] = [(Side::Lower, 0), (Side::Lower, 1), (Side::Upper, 0), (Side::Upper, 1)];

impl<'a> Both<'a> {
    pub(super) fn chain(&self, side: Side, part: usize) -> &'a Chain {
        match side {
            Side::Lower => &self.parts[part].lower,
            Side::Upper => &self.parts[part].upper,
        }
    }

    /// The bounds on θ1 from the left and from the right, at most one of each part.
    pub(super) fn walls(&self) -> [Vec<Id>; 2] {
        let of = |own: fn(&Part) -> Option<Id>| self.parts.iter().filter_map(|part| own(part)).collect();
        [of(|part| part.left), of(|part| part.right)]
    }

    /// Narrows every chain down to the part with the answer, for each goal. Goals share places as long as their answers lie on the
    /// same side. Cost: a squared logarithm of comparisons.
    pub(super) fn search<const N: usize>(&self, goals: [Goal; N]) -> [Found; N] {
        let whole = |(side, part): (Side, usize)| {
            let last = self.chain(side, part).ids().len().checked_sub(1)?;
            Some([0, last])
        };
        let mut found = goals.map(|_| Found::default());
        let mut open =
            vec![((0..N).collect::<Vec<_>>(), Narrowed { ranges: CHAINS.map(whole), between: [None, None] })];
        while let Some((asking, narrowed)) = open.pop() {
            let Some(place) = self.next_place(&narrowed.ranges) else {
                asking
                    .into_iter()
                    .for_each(|number| found[number] = self.found(goals[number], narrowed.clone(), None));
                continue;
            };
            let around: [Range; 4] = std::array::from_fn(|index| {
                let (side, part) = CHAINS[index];
                narrowed.ranges[index]
                    .map(|range| self.chain(side, part).around(self.store, side, range, &place))
            });
            let view = self.view(&place, &around);
            let ways: Vec<Way> = asking.iter().map(|&number| view.way(goals[number])).collect();
            for way in [Way::Left, Way::Here, Way::Right] {
                let own = asking.iter().zip(&ways).filter(|(_, own)| **own == way).map(|(number, _)| *number);
                let own: Vec<usize> = own.collect();
                if own.is_empty() {
                    continue;
                }
                let next = narrowed.clone().towards(way, &around, &place);
                match way {
                    Way::Here => own.into_iter().for_each(|number| {
                        found[number] = self.found(goals[number], next.clone(), Some(place.clone()));
                    }),
                    Way::Left | Way::Right => open.push((own, next)),
                }
            }
        }
        found
    }

    /// A corner in the middle of the longest chain; `None` where one half-plane of each chain is left.
    fn next_place(&self, ranges: &[Range; 4]) -> Option<Place> {
        let length = |range: &Range| range.map_or(0, |[first, last]| last - first);
        let longest =
            (0..4).filter(|&index| length(&ranges[index]) > 0).max_by_key(|&index| length(&ranges[index]))?;
        let ((side, part), [first, last]) = (CHAINS[longest], ranges[longest]?);
        self.chain(side, part).boundary(self.store, first + (last - first) / 2)
    }

    /// The result of a search that ends, with the place if it is known.
    fn found(&self, goal: Goal, Narrowed { ranges, between }: Narrowed, place: Option<Place>) -> Found {
        let place = match place {
            None if goal == Goal::Gap => self.meeting(&ranges),
            place => place,
        };
        let mut found = Found { place, between, ..Found::default() };
        for (&(side, part), range) in CHAINS.iter().zip(ranges) {
            let own = range.map_or(&[][..], |[first, last]| &self.chain(side, part).ids()[first..=last]);
            match side {
                Side::Lower => found.lower.extend(own),
                Side::Upper => found.upper.extend(own),
            }
        }
        found
    }

    /// Returns the place where the chains of one side meet, if L - U is least there: one half-plane of each chain is
    /// left.
    fn meeting(&self, ranges: &[Range; 4]) -> Option<Place> {
        let only = |index: usize| {
            let (side, part) = CHAINS[index];
            self.store.half_plane(self.chain(side, part).ids()[ranges[index]?[0]])
        };
        [[0, 1], [2, 3]].into_iter().find_map(|[older, newer]| {
            let place = place_of(only(older)?, only(newer)?)?;
            (self.view(&place, ranges).way(Goal::Gap) == Way::Here).then_some(place)
        })
    }

    /// Looks at a place, around which the chains are at these positions.
    fn view(&self, place: &Place, around: &[Range; 4]) -> View<'a> {
        let [left_walls, right_walls] = self.walls();
        let wall = |id: &Id| match self.store.half_plane(*id) {
            Some(wall) => compare_with_wall(place, wall),
            None => Ordering::Equal,
        };
        let from_left = left_walls.iter().map(wall).min().unwrap_or(Ordering::Greater);
        let from_right = right_walls.iter().map(wall).max().unwrap_or(Ordering::Less);
        let lower = self.active(Side::Lower, [around[0], around[1]], place);
        let upper = self.active(Side::Upper, [around[2], around[3]], place);
        // L - U and its trend: whether it falls to the right of here, or grows from the left up to here.
        let (gap, falls, grows) = match (lower, upper) {
            (Some([lower_left, lower_right]), Some([upper_left, upper_right])) => (
                compare_at(lower_left, upper_left, place),
                normal_turn(lower_right, upper_right),
                normal_turn(lower_left, upper_left),
            ),
            // Without bounds from one side nothing is empty.
            _ => (Ordering::Less, Turn::Half, Turn::Half),
        };
        View { walls: [from_left, from_right], lower, upper, gap, falls, grows }
    }

    /// The values of L or U just left and just right of a place.
    fn active(&self, side: Side, around: [Range; 2], place: &Place) -> Active<'a> {
        let mut both = (0..2).filter_map(|part| {
            let own = around[part]?.map(|position| self.chain(side, part).ids()[position]);
            let [left, right] = own.map(|id| self.store.half_plane(id));
            Some([left?, right?])
        });
        let first = both.next()?;
        let Some(second) = both.next() else { return Some(first) };
        Some(match compare_at(first[0], second[0], place) {
            // The larger one bounds from below, the smaller one from above.
            Ordering::Greater if side == Side::Lower => first,
            Ordering::Less if side == Side::Lower => second,
            Ordering::Greater => second,
            Ordering::Less => first,
            Ordering::Equal => {
                // Slopes grow with the angle: of those that meet here the steepest one is L right of here, and U left of here.
                let steepest = |f: &'a HalfPlane, g: &'a HalfPlane| match normal_turn(f, g) {
                    Turn::Left => [f, g],
                    _ => [g, f],
                };
                let ([flat_left, steep_left], [flat_right, steep_right]) =
                    (steepest(first[0], second[0]), steepest(first[1], second[1]));
                match side {
                    Side::Lower => [flat_left, steep_right],
                    Side::Upper => [steep_left, flat_right],
                }
            }
        })
    }

    /// The half-planes of a side that bound θ2 at a place.
    pub(super) fn tightest_at(&self, side: Side, ids: &[Id], place: &Place) -> Option<&'a HalfPlane> {
        let own = ids.iter().filter_map(|&id| self.store.half_plane(id));
        match side {
            Side::Lower => own.max_by(|f, g| compare_at(f, g, place)),
            Side::Upper => own.min_by(|f, g| compare_at(f, g, place)),
        }
    }

    /// The bound on θ2 from a side at a place.
    pub(super) fn bound_at(&self, side: Side, place: &Place) -> Option<&'a HalfPlane> {
        let around = [0, 1].map(|part| {
            let last = self.chain(side, part).ids().len().checked_sub(1)?;
            Some(self.chain(side, part).around(self.store, side, [0, last], place))
        });
        self.active(side, around, place).map(|[left, _]| left)
    }
}

/// Returns the place where the boundaries of two half-planes meet, unless they are parallel.
fn place_of(f: &HalfPlane, g: &HalfPlane) -> Option<Place> {
    let (f, g) = match normal_turn(f, g) {
        Turn::Left => (f, g),
        Turn::Right => (g, f),
        Turn::None | Turn::Half => return None,
    };
    let numerator = f.b() * g.a2() - g.b() * f.a2();
    Some(Place { numerator, denominator: f.a1() * g.a2() - f.a2() * g.a1() })
}

impl Narrowed {
    /// Drops the other side of a place, or both sides. Around the place the chains are at these positions.
    fn towards(mut self, way: Way, around: &[Range; 4], place: &Place) -> Self {
        for (index, (range, around)) in self.ranges.iter_mut().zip(around).enumerate() {
            let (Some([first, last]), Some([left, right])) = (range, *around) else { continue };
            match (way, CHAINS[index].0) {
                (Way::Here, _) => (*first, *last) = (left.min(right), left.max(right)),
                (Way::Right, Side::Lower) => *first = right,
                (Way::Left, Side::Lower) => *last = left,
                (Way::Right, Side::Upper) => *last = right,
                (Way::Left, Side::Upper) => *first = left,
            }
        }
        match way {
            Way::Left => self.between[1] = Some(place.clone()),
            Way::Right => self.between[0] = Some(place.clone()),
            Way::Here => {}
        }
        self
    }
}

impl View<'_> {
    /// Returns the direction of an answer.
    fn way(&self, goal: Goal) -> Way {
        let [from_left, from_right] = self.walls;
        match (from_left, from_right) {
            (Ordering::Less, _) => return Way::Right,
            (_, Ordering::Greater) => return Way::Left,
            _ => {}
        }
        match self.way_between(goal) {
            Way::Left if from_left == Ordering::Equal => Way::Here,
            Way::Right if from_right == Ordering::Equal => Way::Here,
            way => way,
        }
    }

    /// Returns the direction of an answer from a place between the walls.
    fn way_between(&self, goal: Goal) -> Way {
        let View { gap, falls, grows, .. } = *self;
        if goal == Goal::Gap || gap == Ordering::Greater {
            return match (falls, grows) {
                (Turn::Right, _) => Way::Right,
                (_, Turn::Left) => Way::Left,
                _ => Way::Here,
            };
        }
        let is_last = |way: Way| {
            gap == Ordering::Equal
                && if way == Way::Right { falls == Turn::Left } else { grows == Turn::Right }
        };
        let slope = |of: &HalfPlane| if of.a2().is_negative() { of.a1().sign() } else { (-of.a1()).sign() };
        let way = match goal {
            Goal::Gap => Way::Here,
            Goal::Left => Way::Left,
            Goal::Right => Way::Right,
            Goal::Bottom => match self.lower.map(|own| own.map(slope)) {
                Some([_, Sign::Negative]) => Way::Right,
                Some([Sign::Positive, _]) => Way::Left,
                _ => Way::Here,
            },
            Goal::Top => match self.upper.map(|own| own.map(slope)) {
                Some([_, Sign::Positive]) => Way::Right,
                Some([Sign::Negative, _]) => Way::Left,
                _ => Way::Here,
            },
        };
        if is_last(way) { Way::Here } else { way }
    }
}

/// Compares the bounds on θ2 of two half-planes at a place.
pub(super) fn compare_at(f: &HalfPlane, g: &HalfPlane, place: &Place) -> Ordering {
    let excess = |h: &HalfPlane| h.b() * &place.denominator - h.a1() * &place.numerator;
    let order = Integer::compare([(&excess(f), &g.a2())], [(&excess(g), &f.a2())]);
    if f.a2().is_negative() == g.a2().is_negative() { order } else { order.reverse() }
}

/// Compares a place with a bound on θ1.
fn compare_with_wall(place: &Place, wall: &HalfPlane) -> Ordering {
    let order = Integer::compare([(&place.numerator, &wall.a1())], [(&wall.b(), &place.denominator)]);
    if wall.a1().is_negative() { order.reverse() } else { order }
}
