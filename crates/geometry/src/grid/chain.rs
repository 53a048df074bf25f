//! The two hulls of sorted points with everything on them (Andrew 1979, the monotone chain).

use std::cmp::Ordering;

/// What a point must tell besides its orientation to others.
pub(super) trait Site {
    /// Whether two points have the same x.
    fn is_above_or_below(&self, other: &Self) -> bool;
}

/// A point that may be there more than once.
pub(super) trait Repeatable: Site {
    /// Whether two points have the same x and y.
    fn coincides(&self, other: &Self) -> bool;
}

/// For points sorted by x, then y: which of them are on the lower or the upper hull. Cost: linear.
pub(super) fn marked<P: Repeatable>(sorted: &[P], orientation: impl Fn(&P, &P, &P) -> Ordering) -> Vec<bool> {
    let mut marks = vec![false; sorted.len()];
    for hull in [Hull::Lower, Hull::Upper] {
        for position in hull.chain(sorted, &orientation) {
            for repeated in hull.repetitions(sorted, position) {
                marks[repeated] = true;
            }
        }
    }
    marks
}

/// One of the two hulls, as the way along which it is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Hull {
    /// From left to right, below all points.
    Lower,
    /// From right to left, above all points.
    Upper,
}

impl Hull {
    /// Positions of the points on the hull in the order of the walk: corners and points within edges, of repeated points
    /// the first that the walk meets. At the ends, only the lowest or the highest point of that x.
    pub(super) fn chain<P: Site>(
        self,
        sorted: &[P],
        orientation: impl Fn(&P, &P, &P) -> Ordering,
    ) -> Vec<usize> {
        match self {
            Hull::Lower => chain(0..sorted.len(), sorted, orientation),
            Hull::Upper => chain((0..sorted.len()).rev(), sorted, orientation),
        }
    }

    /// All positions with the same point, of which the walk meets `first` first, in the order of the walk.
    pub(super) fn repetitions<P: Repeatable>(
        self,
        sorted: &[P],
        first: usize,
    ) -> impl Iterator<Item = usize> {
        let same = move |&position: &usize| sorted[position].coincides(&sorted[first]);
        let (ahead, behind) = match self {
            Hull::Lower => (first..sorted.len(), 0..0),
            Hull::Upper => (0..0, 0..first + 1),
        };
        ahead.chain(behind.rev()).take_while(same)
    }
}

/// The positions where a walk over sorted points keeps turning left or going straight on.
fn chain<P: Site>(
    walk: impl Iterator<Item = usize>,
    sorted: &[P],
    orientation: impl Fn(&P, &P, &P) -> Ordering,
) -> Vec<usize> {
    let mut chain: Vec<usize> = Vec::new();
    for next in walk {
        // Walking forward the first point of each x is its lowest, walking back its highest.
        if chain.last().is_some_and(|&last| sorted[last].is_above_or_below(&sorted[next])) {
            continue;
        }
        while let [.., before, last] = chain.as_slice()
            && orientation(&sorted[*before], &sorted[*last], &sorted[next]) == Ordering::Less
        {
            chain.pop();
        }
        chain.push(next);
    }
    chain
}
