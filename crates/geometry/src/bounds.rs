//! The two envelopes of a system and the walk along them.
//!
//! A half-plane with `a2 > 0` bounds θ2 from above by a linear function of θ1, one with `a2 < 0` from below, and one
//! with `a2 = 0` bounds θ1. The region lies between the lower envelope of the upper bounds, which is concave, and the
//! upper envelope of the lower bounds, which is convex. Their gap is concave: the θ1 where it is not negative form an
//! interval, and one walk from left to right finds both of its ends. (The two envelopes are dual to the two hulls of
//! Andrew's monotone chain; de Berg et al., *Computational Geometry*, §§ 4.2 and 11.5.)

use std::ops::Range;

use boundfit_exact::{Fraction, Integer, Sign};

use crate::half_plane::HalfPlane;
use crate::predicates::middle_is_implied;

/// A half-plane together with its index.
pub(crate) type Facet<'a> = (usize, &'a HalfPlane);

/// The θ1 where two boundaries meet, unless they are parallel.
fn theta1_of_meeting(f: &HalfPlane, g: &HalfPlane) -> Option<Fraction> {
    Fraction::new(f.b() * g.a2() - g.b() * f.a2(), f.a1() * g.a2() - g.a1() * f.a2())
}

/// The θ1 where a boundary with `a2 = 0` stands.
fn theta1_of_vertical((_, half_plane): &Facet) -> Option<Fraction> {
    Fraction::new(half_plane.b(), half_plane.a1())
}

/// The distance `constant + slope·θ1`, up to a positive factor, from a lower bound of θ2 up to an upper bound.
struct Gap {
    constant: Integer,
    slope: Integer,
}

impl Gap {
    fn between(lower: &HalfPlane, upper: &HalfPlane) -> Self {
        Gap {
            constant: upper.a2() * lower.b() - lower.a2() * upper.b(),
            slope: upper.a1() * lower.a2() - lower.a1() * upper.a2(),
        }
    }

    fn sign_at(&self, theta1: &Fraction) -> Sign {
        let terms = [(&self.constant, theta1.denominator()), (&self.slope, theta1.numerator())];
        Integer::compare(terms, []).into()
    }

    /// The sign for θ1 towards minus infinity.
    fn sign_far_left(&self) -> Sign {
        match self.slope.sign() {
            Sign::Zero => self.constant.sign(),
            Sign::Negative => Sign::Positive,
            Sign::Positive => Sign::Negative,
        }
    }

    /// Returns where the gap closes, unless it is the same everywhere.
    fn root(&self) -> Option<Fraction> {
        Fraction::new(-&self.constant, self.slope.clone())
    }
}

/// One bound of θ2 that is piecewise linear in θ1; its pieces from left to right.
#[derive(Debug, Default)]
struct Envelope<'a> {
    pieces: Vec<Facet<'a>>,
}

impl<'a> Envelope<'a> {
    /// Adds the half-plane that is next by angle; those before it that it makes superfluous go.
    fn push(&mut self, facet: Facet<'a>) {
        while let [.., (_, before), (_, last)] = self.pieces.as_slice()
            && middle_is_implied(before, last, facet.1)
        {
            self.pieces.pop();
        }
        self.pieces.push(facet);
    }

    /// Returns where a piece gives way to the next, unless it is the last.
    fn end_of(&self, piece: usize) -> Option<Fraction> {
        let (_, next) = self.pieces.get(piece + 1)?;
        theta1_of_meeting(self.pieces[piece].1, next)
    }

    /// The piece in force just right of `left`. Cost: logarithmic.
    fn first_after(&self, left: Option<&Fraction>) -> usize {
        let Some(left) = left else { return 0 };
        self.first_not(0, |end| end <= left)
    }

    /// The first piece from this one on whose end fails a test; the last piece where none does. The ends of later pieces must fail
    /// it too. Cost: logarithmic.
    fn first_not(&self, from: usize, passes: impl Fn(&Fraction) -> bool) -> usize {
        let (mut first, mut after) = (from, self.pieces.len().max(1) - 1);
        while first < after {
            let middle = first + (after - first) / 2;
            if self.end_of(middle).is_some_and(|end| passes(&end)) {
                first = middle + 1;
            } else {
                after = middle;
            }
        }
        first
    }

    /// The pieces in force between two abscissas; none of an empty envelope.
    fn between(&self, left: Option<&Fraction>, right: Option<&Fraction>) -> Range<usize> {
        if self.pieces.is_empty() {
            return 0..0;
        }
        let first = self.first_after(left);
        let mut last = self.pieces.len() - 1;
        while last > first
            && let (Some(right), Some(start)) = (right, self.end_of(last - 1))
            && start >= *right
        {
            last -= 1;
        }
        first..last + 1
    }
}

/// The bounds that a system puts on θ2 as a function of θ1, and on θ1 itself.
#[derive(Debug, Default)]
pub(crate) struct Bounds<'a> {
    upper: Envelope<'a>,
    lower: Envelope<'a>,
    left: Option<Facet<'a>>,
    right: Option<Facet<'a>>,
}

/// The pieces of both envelopes between which the region lies.
struct Overlap {
    upper: Range<usize>,
    lower: Range<usize>,
    reaches_left: bool,
    reaches_right: bool,
}

impl<'a> Bounds<'a> {
    /// Adds a half-plane; they must come in angular order, one of each direction.
    pub(crate) fn push(&mut self, facet: Facet<'a>) {
        let (_, half_plane) = facet;
        match (half_plane.a2().sign(), half_plane.a1().is_positive()) {
            (Sign::Positive, _) => self.upper.push(facet),
            (Sign::Negative, _) => self.lower.push(facet),
            (Sign::Zero, true) => self.right = Some(facet),
            (Sign::Zero, false) => self.left = Some(facet),
        }
    }

    /// The half-planes on the boundary of the region in angular order, or `None` when the region is empty. Some may
    /// only touch it in a vertex. Cost: linear.
    pub(crate) fn facets(mut self) -> Option<Vec<Facet<'a>>> {
        // The angular order runs along the upper bounds from right to left.
        self.upper.pieces.reverse();
        let left = self.left.as_ref().and_then(theta1_of_vertical);
        let right = self.right.as_ref().and_then(theta1_of_vertical);
        if let (Some(left), Some(right)) = (&left, &right)
            && left > right
        {
            return None;
        }
        let (upper, lower) = if self.upper.pieces.is_empty() || self.lower.pieces.is_empty() {
            let range = |envelope: &Envelope<'a>| envelope.between(left.as_ref(), right.as_ref());
            (range(&self.upper), range(&self.lower))
        } else {
            let overlap = self.overlap(left, right.as_ref())?;
            self.left = self.left.filter(|_| overlap.reaches_left);
            self.right = self.right.filter(|_| overlap.reaches_right);
            (overlap.upper, overlap.lower)
        };
        // In the memory of the upper envelope, which may have every half-plane.
        let mut facets = self.upper.pieces;
        facets.truncate(upper.end);
        facets.drain(..upper.start);
        facets.extend(self.right);
        facets.reverse();
        facets.extend(self.left.into_iter().chain(self.lower.pieces.drain(lower)));
        Some(facets)
    }

    /// Walks along both envelopes: first to where the gap opens, then to where it closes. The gap is concave, so that a binary
    /// search finds the pieces which the walk would pass.
    fn overlap(&self, left: Option<Fraction>, right: Option<&Fraction>) -> Option<Overlap> {
        let mut walk = Walk::new(self, left.as_ref(), right);
        let mut reaches_left = left.is_some();
        let opens_later =
            |gap: Gap, here: &Fraction| gap.slope.is_positive() && gap.sign_at(here) == Sign::Negative;
        let skipped = walk.skip(&opens_later);
        reaches_left &= skipped.is_none();
        let mut start = skipped.or(left);
        loop {
            let gap = walk.gap();
            let sign = start.as_ref().map_or_else(|| gap.sign_far_left(), |start| gap.sign_at(start));
            if sign != Sign::Negative {
                break;
            }
            if !gap.slope.is_positive() {
                // The gap is concave: it never opens again.
                return None;
            }
            reaches_left = false;
            if walk.end().is_none_or(|end| gap.root().is_some_and(|root| root <= *end)) {
                break;
            }
            start = Some(walk.advance()?);
        }
        let (first_upper, first_lower) = (walk.upper.piece, walk.lower.piece);
        walk.skip(&|gap: Gap, here: &Fraction| gap.sign_at(here) != Sign::Negative);
        let reaches_right = loop {
            let Some(end) = walk.end() else {
                break false;
            };
            if walk.gap().sign_at(end) == Sign::Negative {
                break false;
            }
            if walk.advance().is_none() {
                break true;
            }
        };
        Some(Overlap {
            upper: first_upper..walk.upper.piece + 1,
            lower: first_lower..walk.lower.piece + 1,
            reaches_left,
            reaches_right,
        })
    }
}

/// A piece of an envelope and where it ends, unless it is the last.
struct Piece<'b, 'a> {
    envelope: &'b Envelope<'a>,
    piece: usize,
    end: Option<Fraction>,
}

impl<'b, 'a> Piece<'b, 'a> {
    fn new(envelope: &'b Envelope<'a>, piece: usize) -> Self {
        Piece { envelope, piece, end: envelope.end_of(piece) }
    }

    /// Goes on to the next piece when this one ends here.
    fn pass(&mut self, here: &Fraction) {
        if self.end.as_ref().is_some_and(|end| end == here) {
            *self = Piece::new(self.envelope, self.piece + 1);
        }
    }
}

/// A place between changes of either envelope.
struct Walk<'b, 'a> {
    upper: Piece<'b, 'a>,
    lower: Piece<'b, 'a>,
    right: Option<&'b Fraction>,
}

impl<'b, 'a> Walk<'b, 'a> {
    fn new(bounds: &'b Bounds<'a>, left: Option<&Fraction>, right: Option<&'b Fraction>) -> Self {
        let from = |envelope: &'b Envelope<'a>| Piece::new(envelope, envelope.first_after(left));
        Walk { upper: from(&bounds.upper), lower: from(&bounds.lower), right }
    }

    fn gap(&self) -> Gap {
        Gap::between(
            self.lower.envelope.pieces[self.lower.piece].1,
            self.upper.envelope.pieces[self.upper.piece].1,
        )
    }

    /// Goes on to behind the last end of a piece at which a test holds, and tells where that is. The test must hold at the ends
    /// before it, too. Cost: O(log² n), none of few pieces.
    fn skip(&mut self, holds: &impl Fn(Gap, &Fraction) -> bool) -> Option<Fraction> {
        /// The number of pieces that are walked along sooner than left out.
        const FEW: usize = 64;
        let [upper, lower] = [&self.upper, &self.lower].map(|own| own.envelope);
        if upper.pieces.len() + lower.pieces.len() <= FEW {
            return None;
        }
        let goes_on = |here: &Fraction| {
            let [of_upper, of_lower] = [upper, lower].map(|own| own.first_after(Some(here)));
            let gap = Gap::between(lower.pieces[of_lower].1, upper.pieces[of_upper].1);
            self.right.is_none_or(|right| here < right) && holds(gap, here)
        };
        let last = |own: &Piece| {
            let first = own.envelope.first_not(own.piece, goes_on);
            first.checked_sub(1).filter(|last| *last >= own.piece).and_then(|last| own.envelope.end_of(last))
        };
        let here = [&self.upper, &self.lower].into_iter().filter_map(last).max()?;
        *self = Walk {
            upper: Piece::new(upper, upper.first_after(Some(&here))),
            lower: Piece::new(lower, lower.first_after(Some(&here))),
            right: self.right,
        };
        Some(here)
    }

    /// Returns where the next piece begins or θ1 ends, whichever comes first.
    fn end(&self) -> Option<&Fraction> {
        let ends = [self.upper.end.as_ref(), self.lower.end.as_ref(), self.right];
        ends.into_iter().flatten().min()
    }

    /// Goes on to the pieces that follow this end, and tells where that is; `None` where θ1 ends.
    fn advance(&mut self) -> Option<Fraction> {
        let end = self.end()?.clone();
        if self.right.is_some_and(|right| end >= *right) {
            return None;
        }
        self.upper.pass(&end);
        self.lower.pass(&end);
        Some(end)
    }
}
