//! The distance of the lines of a bounded set from each other, as a function of x: the support function of its
//! difference body.

use boundfit_estimation::Corridor;
use boundfit_exact::{Endpoint, Interval, Rational};

/// The width of a corridor that is finite everywhere: a convex piecewise linear function, the largest of its pieces.
#[derive(Debug, Clone)]
pub(super) struct Width {
    /// Slope and intercept of each piece, the slopes ascending: the corners of the upper half of the difference body, from its
    /// leftmost to its rightmost one. The lower half is the same, turned around the origin.
    pieces: Vec<[Rational; 2]>,
    /// The x where one piece gives way to the next.
    breaks: Vec<Rational>,
}

impl Width {
    /// The width of a corridor. Cost: linear.
    pub(super) fn of(Corridor { upper, lower }: &Corridor) -> Self {
        let mut own = Width { pieces: Vec::new(), breaks: Vec::new() };
        let (mut above, mut below) = (0, 0);
        while let (Some(high), Some(low)) = (upper.lines().get(above), lower.lines().get(below)) {
            own.pieces.push([&high[0] - &low[0], &high[1] - &low[1]]);
            let ends = [upper.breakpoints().get(above), lower.breakpoints().get(below)];
            let Some(end) = ends.iter().flatten().min() else { break };
            above += usize::from(ends[0] == Some(*end));
            below += usize::from(ends[1] == Some(*end));
            own.breaks.push((*end).clone());
        }
        own
    }

    /// Returns the x where one piece gives way to the next.
    pub(super) fn breaks(&self) -> &[Rational] {
        &self.breaks
    }

    /// The width at x. Exact. Cost: logarithmic.
    pub(super) fn at(&self, x: &Rational) -> Rational {
        let piece = self.pieces.get(self.breaks.partition_point(|end| end < x));
        piece.map_or_else(Rational::zero, |[slope, intercept]| slope * x + intercept)
    }

    /// The x where no piece is above a value; `None` where there are none. Exact. Cost: linear.
    pub(super) fn at_most(&self, most: &Rational) -> Option<Interval> {
        let (mut from, mut to): (Option<Rational>, Option<Rational>) = (None, None);
        for [slope, intercept] in &self.pieces {
            let room = most - intercept;
            match room.checked_div(slope) {
                Some(end) if slope.is_positive() => to = Some(to.map_or(end.clone(), |to| to.min(end))),
                Some(end) => from = Some(from.map_or(end.clone(), |from| from.max(end))),
                None if room.is_negative() => return None,
                None => {}
            }
        }
        Interval::new(Endpoint::from(from), Endpoint::from(to))
    }

    /// The largest coordinate of the points of the difference body where the form (x, 1) is at most `most` in size; somewhere it is
    /// more. Exact. Cost: linear.
    pub(super) fn longest(&self, axis: usize, x: &Rational, most: &Rational) -> Rational {
        let lower_half = self.pieces.iter().map(|point| point.each_ref().map(|part| -part));
        let corners: Vec<[Rational; 2]> = self.pieces.iter().cloned().chain(lower_half).collect();
        let values: Vec<Rational> = corners.iter().map(|[d1, d2]| d1 * x + d2).collect();
        let mut longest = Rational::zero();
        for (position, corner) in corners.iter().enumerate() {
            let next = if position + 1 == corners.len() { 0 } else { position + 1 };
            let ends = [&corner[axis], &corners[next][axis]];
            let [here, there] = [&values[position], &values[next]];
            if here.abs() <= *most {
                longest = longest.max(ends[0].clone());
            }
            for edge in [most.clone(), -most] {
                let share = (&edge - here).checked_div(&(there - here));
                if let Some(share) = share.filter(|share| share.is_positive() && *share < Rational::one()) {
                    longest = longest.max(ends[0] + share * (ends[1] - ends[0]));
                }
            }
        }
        longest
    }
}
