//! Convex piecewise linear functions of x, and where they are below a value.

use boundfit_estimation::CorridorEdge;
use boundfit_exact::{Interval, Rational};

/// A convex piecewise linear function on an interval, beyond which it is infinite.
#[derive(Debug, Clone)]
pub(super) struct Valley {
    domain: Option<Interval>,
    /// Slope and intercept of each piece, the slopes ascending.
    lines: Vec<[Rational; 2]>,
    /// The places where one piece gives way to the next, and the function there.
    nodes: Vec<[Rational; 2]>,
    /// The number of pieces that fall, and the number that do not rise.
    falling: usize,
    not_rising: usize,
    /// The values of the function at the ends of the domain that exist.
    at_ends: [Option<[Rational; 2]>; 2],
    /// The least value of the function, if it has one.
    least: Option<Rational>,
}

/// An interval of x where a function is too small.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Gap {
    pub(super) from: Option<GapEnd>,
    pub(super) to: Option<GapEnd>,
}

/// The end of a gap.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct GapEnd {
    pub(super) x: Rational,
    /// `true` if the function is too small at this very x, and infinite beyond.
    pub(super) is_in_gap: bool,
}

impl Gap {
    /// The sort key of gaps without a common point.
    pub(super) fn start(&self) -> Option<(&Rational, bool)> {
        self.from.as_ref().map(|end| (&end.x, !end.is_in_gap))
    }
}

impl Valley {
    /// An edge of a corridor, turned upside down if it is the lower one, plus so many times the distance from `zero`.
    pub(super) fn new(edge: &CorridorEdge, is_turned: bool, times: &Rational, zero: &Rational) -> Self {
        let turned = |line: &[Rational; 2]| match is_turned {
            true => line.each_ref().map(|part| -part),
            false => line.clone(),
        };
        let domain = edge.domain().cloned();
        let mut lines: Vec<[Rational; 2]> = edge.lines().iter().map(turned).collect();
        let mut breaks = edge.breakpoints().to_vec();
        if let Some(domain) = domain.as_ref().filter(|_| !times.is_zero()) {
            add_distance(domain, &mut lines, &mut breaks, times, zero);
        }
        let value = |[slope, intercept]: &[Rational; 2], x: &Rational| slope * x + intercept;
        let nodes: Vec<[Rational; 2]> =
            breaks.into_iter().zip(&lines).map(|(x, line)| [x.clone(), value(line, &x)]).collect();
        let end = |x: Option<&Rational>, line: Option<&[Rational; 2]>| Some([x?.clone(), value(line?, x?)]);
        let at_ends = match &domain {
            Some(domain) => {
                [end(domain.lower().value(), lines.first()), end(domain.upper().value(), lines.last())]
            }
            None => [None, None],
        };
        let falling = lines.partition_point(|[slope, _]| slope.is_negative());
        let not_rising = lines.partition_point(|[slope, _]| !slope.is_positive());
        let mut valley = Valley { domain, lines, nodes, falling, not_rising, at_ends, least: None };
        valley.least = valley.lowest();
        valley
    }

    /// The least value; `None` where there is none.
    fn lowest(&self) -> Option<Rational> {
        let of = |point: &Option<[Rational; 2]>| point.as_ref().map(|[_, value]| value.clone());
        match self.falling {
            0 => of(&self.at_ends[0]).or_else(|| {
                let [slope, intercept] = self.lines.first()?;
                slope.is_zero().then(|| intercept.clone())
            }),
            falling if falling == self.lines.len() => of(&self.at_ends[1]),
            falling => self.nodes.get(falling - 1).map(|[_, value]| value.clone()),
        }
    }

    /// Returns the interval where the function is smaller than a value, if any. Exact. Cost: logarithmic.
    pub(super) fn below(&self, value: &Rational) -> Option<Gap> {
        self.domain.as_ref()?;
        if self.least.as_ref().is_some_and(|least| least >= value) {
            return None;
        }
        Some(Gap { from: self.from(value), to: self.to(value) })
    }

    /// Returns the place where the function comes below a value that it is below somewhere.
    fn from(&self, value: &Rational) -> Option<GapEnd> {
        if let Some(end) = end_in_gap(&self.at_ends[0], value) {
            return Some(end);
        }
        let falling = self.nodes.get(..self.falling.min(self.nodes.len())).unwrap_or_default();
        let piece = falling.partition_point(|[_, at_node]| at_node >= value);
        (piece < self.falling).then(|| self.crossing(piece, value)).flatten()
    }

    /// Returns the place where the function is no longer below a value that it is below somewhere.
    fn to(&self, value: &Rational) -> Option<GapEnd> {
        if let Some(end) = end_in_gap(&self.at_ends[1], value) {
            return Some(end);
        }
        let rising = self.nodes.get(self.not_rising..).unwrap_or_default();
        let piece = self.not_rising + rising.partition_point(|[_, at_node]| at_node < value);
        self.crossing(piece, value)
    }

    /// Returns the place where a piece that is not level has a value; `None` where there is no such piece.
    fn crossing(&self, piece: usize, value: &Rational) -> Option<GapEnd> {
        let [slope, intercept] = self.lines.get(piece)?;
        let x = (value - intercept).checked_div(slope)?;
        Some(GapEnd { x, is_in_gap: false })
    }
}

/// An end of the domain where the function is below a value.
fn end_in_gap(end: &Option<[Rational; 2]>, value: &Rational) -> Option<GapEnd> {
    let [x, _] = end.as_ref().filter(|[_, at_end]| at_end < value)?;
    Some(GapEnd { x: x.clone(), is_in_gap: true })
}

/// Adds so many times the distance from `zero` to a piecewise linear function.
fn add_distance(
    domain: &Interval,
    lines: &mut Vec<[Rational; 2]>,
    breaks: &mut Vec<Rational>,
    times: &Rational,
    zero: &Rational,
) {
    let is_within = domain.lower().value().is_none_or(|from| from < zero)
        && domain.upper().value().is_none_or(|to| zero < to);
    let before = breaks.partition_point(|x| x < zero);
    // The number of pieces on the left of zero.
    let left = if is_within && breaks.get(before) != Some(zero) {
        if let Some(line) = lines.get(before).cloned() {
            breaks.insert(before, zero.clone());
            lines.insert(before, line);
        }
        before + 1
    } else if is_within {
        before + 1
    } else if domain.lower().value().is_some_and(|from| from >= zero) {
        0
    } else {
        lines.len()
    };
    let at_zero = times * zero;
    for (position, [slope, intercept]) in lines.iter_mut().enumerate() {
        if position < left {
            *slope = &*slope - times;
            *intercept = &*intercept + &at_zero;
        } else {
            *slope = &*slope + times;
            *intercept = &*intercept - &at_zero;
        }
    }
}
