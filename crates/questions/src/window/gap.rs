//! The place where L - U, the larger lower bound on θ2 less the smaller upper one, is least. It is the heart of the
//! set, or the reason why the set is empty.

use boundfit_exact::Rational;
use boundfit_geometry::constructions::meet;
use boundfit_geometry::{HalfPlane, Point};

use super::chain::{Place, Side};
use super::search::{Both, Found, Goal};
use super::store::Id;

/// The result.
#[derive(Debug)]
pub(super) enum Gap {
    /// These inequalities contradict each other without any other: one that is false, or two bounds on θ1.
    Crossed(Vec<Id>),
    /// L - U is least, or as small as is needed.
    Least {
        /// The least value of the gap; `None` where it has none.
        value: Option<Rational>,
        /// A point of the set in the middle between L and U there, unless it is empty.
        point: Option<Point>,
        /// The half-planes that decide.
        ids: Vec<Id>,
    },
}

impl Gap {
    /// The least value of L - U.
    pub(super) fn value(&self) -> Option<&Rational> {
        match self {
            Gap::Crossed(_) => None,
            Gap::Least { value, .. } => value.as_ref(),
        }
    }

    /// The half-planes that decide.
    pub(super) fn ids(&self) -> Vec<Id> {
        match self {
            Gap::Crossed(ids) | Gap::Least { ids, .. } => ids.clone(),
        }
    }

    /// Returns the gap of the set of two parts. Exact. Cost: a squared logarithm of comparisons.
    pub(super) fn of(both: &Both<'_>) -> Gap {
        let [found] = both.search([Goal::Gap]);
        Gap::at(both, found)
    }

    /// Returns the gap that a search has found.
    pub(super) fn at(both: &Both<'_>, found: Found) -> Gap {
        if let Some(never) = both.parts.iter().find_map(|part| part.never) {
            return Gap::Crossed(vec![never]);
        }
        let walls = both.walls();
        let value_of = |id: &Id| {
            let wall = both.store.half_plane(*id)?;
            Rational::new(wall.b(), wall.a1())
        };
        let left = walls[0].iter().filter_map(value_of).max();
        let right = walls[1].iter().filter_map(value_of).min();
        let walls: Vec<Id> = walls.into_iter().flatten().collect();
        if left.as_ref().zip(right.as_ref()).is_some_and(|(left, right)| left > right) {
            return Gap::Crossed(walls);
        }
        let (theta1, has_least) = lowest(both, &found, &left, &right);
        let bound = |side: Side| {
            let own = match (&found.place, side) {
                (Some(_), Side::Lower) => both.tightest_at(side, &found.lower, &theta1),
                (Some(_), Side::Upper) => both.tightest_at(side, &found.upper, &theta1),
                (None, _) => both.bound_at(side, &theta1),
            }?;
            Rational::new(
                own.b() * &theta1.denominator - own.a1() * &theta1.numerator,
                own.a2() * &theta1.denominator,
            )
        };
        let (lower, upper) = (bound(Side::Lower), bound(Side::Upper));
        let value = lower.as_ref().zip(upper.as_ref()).map(|(lower, upper)| lower - upper);
        let is_empty = value.as_ref().is_some_and(|value| !value.is_negative() && !value.is_zero());
        let theta2 = match (lower, upper) {
            (Some(lower), Some(upper)) => (lower + upper).half(),
            (Some(lower), None) => lower + Rational::one(),
            (None, Some(upper)) => upper - Rational::one(),
            (None, None) => Rational::zero(),
        };
        let theta1 = Rational::new(theta1.numerator, theta1.denominator).unwrap_or_default();
        let point = (!is_empty).then(|| Point::new(&theta1, &theta2));
        let ids = found.lower.into_iter().chain(found.upper).chain(walls).collect();
        Gap::Least { value: value.filter(|_| has_least), point, ids }
    }
}

/// θ1 where L - U is least, and whether it is the least; else some θ1 where it is not positive.
fn lowest(
    both: &Both<'_>,
    found: &Found,
    left: &Option<Rational>,
    right: &Option<Rational>,
) -> (Place, bool) {
    if let Some(place) = &found.place {
        return (place.clone(), true);
    }
    let half_planes =
        |ids: &[Id]| -> Vec<_> { ids.iter().filter_map(|&id| both.store.half_plane(id)).collect() };
    let (lower, upper) = (half_planes(&found.lower), half_planes(&found.upper));
    // Where it can turn, and where its sign can change: both tell how far out is far enough.
    let turns = pairs(&lower).chain(pairs(&upper));
    let crossings = lower.iter().flat_map(|f| upper.iter().filter_map(move |g| meet(f, g)));
    let theta1 = |point: Point| point.theta1();
    let within = |value: &Rational| {
        left.as_ref().is_none_or(|left| left <= value) && right.as_ref().is_none_or(|right| value <= right)
    };
    let turns: Vec<Rational> =
        turns.map(theta1).chain(left.clone()).chain(right.clone()).filter(within).collect();
    let mut places: Vec<Rational> = crossings.map(theta1).chain(turns.iter().cloned()).collect();
    let ends = found.between.iter().flatten();
    places.extend(ends.filter_map(|end| Rational::new(end.numerator.clone(), end.denominator.clone())));
    places.push(Rational::zero());
    let one = Rational::one();
    let furthest = |outermost: Option<Rational>| outermost.unwrap_or_default();
    let far_left = furthest(places.iter().min().cloned()) - &one;
    let far_right = furthest(places.iter().max().cloned()) + &one;
    let value = |place: &Rational| {
        let lower = lower.iter().filter_map(|own| bound(own, place)).max()?;
        let upper = upper.iter().filter_map(|own| bound(own, place)).min()?;
        Some(lower - upper)
    };
    let ends = [left.is_none().then_some(far_left), right.is_none().then_some(far_right)];
    let mut best: Option<(Rational, Option<Rational>)> = None;
    // A turn before an end that is as low: there it has its least value.
    for place in turns.into_iter().chain(ends.iter().flatten().cloned()) {
        let own = value(&place);
        let is_lower = best.as_ref().is_none_or(|(_, best)| match (&own, best) {
            (Some(own), Some(best)) => own < best,
            _ => false,
        });
        if is_lower {
            best = Some((place, own));
        }
    }
    let place = best.map_or_else(|| left.clone().unwrap_or_default(), |(place, _)| place);
    // Further out it is lower still, unless it is level.
    let falls_beyond = |end: &Rational, step: Rational| match (value(end), value(&(end + step))) {
        (Some(own), Some(beyond)) => beyond < own,
        _ => true,
    };
    let is_end = |end: &Option<Rational>| end.as_ref() == Some(&place);
    let has_least =
        !(is_end(&ends[0]) && falls_beyond(&place, -&one) || is_end(&ends[1]) && falls_beyond(&place, one));
    (Place { numerator: place.numerator(), denominator: place.denominator() }, has_least)
}

/// Returns the points where two of some half-planes meet.
fn pairs<'a>(half_planes: &'a [&'a HalfPlane]) -> impl Iterator<Item = Point> + 'a {
    let each = half_planes.iter().enumerate();
    each.flat_map(|(position, f)| half_planes[position + 1..].iter().filter_map(move |g| meet(f, g)))
}

/// The bound on θ2 that a half-plane is at a θ1.
fn bound(half_plane: &HalfPlane, theta1: &Rational) -> Option<Rational> {
    let value = Rational::from(half_plane.b()) - Rational::from(half_plane.a1()) * theta1;
    value.checked_div(&Rational::from(half_plane.a2()))
}
