//! The numbers of one parameter in a report: the same value looks the same wherever it stands.

use std::collections::HashSet;
use std::fmt::Write as _;

use boundfit_exact::{Interval, Rational, Rounding, fewest_digits};
use boundfit_geometry::{Measure, Vertex};

use crate::document::{Symbol, Text};
use crate::style::{GiveOrTake, Shown, Style};

/// The most digits that are tried.
const MOST_DIGITS: usize = 40;

/// The scale that shows the values of one parameter: with common digits, and with the ends of its range rounded
/// outward everywhere.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Scale<'a> {
    style: Style,
    range: Option<&'a Interval>,
}

/// Returns one scale for each of two parameters. Its digits are those that the ranges take where these are known, and
/// that other intervals and the estimates beside a range take. They tell the vertices apart, too.
pub(crate) fn scales<'a>(
    style: &Style,
    ranges: Option<&'a [Interval; 2]>,
    others: &[&[Interval; 2]],
    estimates: &[&[Rational; 2]],
    vertices: &[Vertex],
) -> [Scale<'a>; 2] {
    let of = |axis: usize, own: Option<&Interval>| {
        let others = others.iter().map(|others| &others[axis]);
        let digits =
            own.into_iter().chain(others).map(|interval| style.resolving(interval).significant()).max();
        let estimates = estimates.iter().map(|estimate| &estimate[axis]);
        digits.map(|digits| own.map_or(digits, |range| fine_enough(digits, range, estimates)))
    };
    let scales = [0, 1].map(|axis| {
        let range = ranges.map(|ranges| &ranges[axis]);
        let digits = if style.digits.is_some() { style.digits } else { of(axis, range) };
        Scale { style: Style { digits, ..*style }, range }
    });
    if style.digits.is_some() || style.exact { scales } else { telling_apart(scales, vertices) }
}

/// Returns so many digits, or as many more as necessary to round no estimate by more than a twentieth of the range's
/// width.
fn fine_enough<'a>(
    digits: usize,
    range: &Interval,
    estimates: impl Iterator<Item = &'a Rational> + Clone,
) -> usize {
    const TWENTY: i64 = 20;
    let Some(width) = range.width().filter(|width| !width.is_zero()) else { return digits };
    let room = width * Rational::ratio(1, TWENTY);
    fewest_digits(digits, |digits| {
        let mut all = estimates.clone();
        all.all(|value| (value - value.rounded(digits, Rounding::Nearest)).abs() <= room)
    })
}

/// These scales with as many more digits as it takes for different vertices to look different; these where that takes too
/// many. Cost: for each number of digits that of showing the vertices up to the first neighbours that look alike.
fn telling_apart<'a>(scales: [Scale<'a>; 2], vertices: &[Vertex]) -> [Scale<'a>; 2] {
    let with_more = |more: usize| {
        scales.map(|scale| Scale {
            style: Style { digits: Some(scale.style.significant() + more), ..scale.style },
            ..scale
        })
    };
    let differ = |scales: &[Scale; 2]| {
        // One text for all vertices: a text of its own for each takes longer than its digits.
        let (mut all, mut places) = (String::new(), Vec::with_capacity(vertices.len()));
        let mut last = 0..0;
        for [x, y] in vertices.iter().map(|vertex| vertex.point().coordinates()) {
            let start = all.len();
            // Writing into a string never fails.
            let _ = write!(all, "{} {}", scales[0].value(&x), scales[1].value(&y));
            if all[last] == all[start..] {
                return false;
            }
            last = start..all.len();
            places.push(last.clone());
        }
        let mut seen = HashSet::with_capacity(places.len());
        places.into_iter().all(|place| seen.insert(&all[place]))
    };
    (0..MOST_DIGITS).map(with_more).find(differ).unwrap_or(scales)
}

/// This style with the digits that show different error bounds or factors on them differently, neighbours being next to each
/// other; itself where that takes too many.
pub(crate) fn with_digits_that_differ<'a>(
    values: impl Iterator<Item = &'a Rational> + Clone,
    style: &Style,
) -> Style {
    if style.digits.is_some() || style.exact {
        return *style;
    }
    let differ = |style: &Style| {
        let shown: Vec<String> = values.clone().map(|value| style.upper(value).to_string()).collect();
        shown.windows(2).all(|pair| pair[0] != pair[1])
    };
    let with_more = |more: usize| Style { digits: Some(style.significant() + more), ..*style };
    (0..MOST_DIGITS).map(with_more).find(differ).unwrap_or(*style)
}

impl Scale<'_> {
    /// A value: one that is an end of the range like this end, any other to nearest.
    pub(crate) fn value<'a>(&self, value: &'a Rational) -> Shown<'a> {
        let is = |end: Option<&Rational>| end == Some(value);
        match self.range {
            Some(range) if is(range.lower().value()) => self.lower(value),
            Some(range) if is(range.upper().value()) => self.upper(value),
            _ => self.style.nearest(value),
        }
    }

    /// A sum over all vertices: as [`Scale::value`].
    pub(crate) fn measure(&self, measure: &Measure) -> Text {
        if self.style.exact {
            return self.style.measure(measure);
        }
        Text::new().number(self.value(&measure.rounding_alike(self.style.significant())))
    }

    /// An estimate and its error bound with the digits of this style, see [`Style::give_or_take`].
    pub(crate) fn give_or_take<'a>(
        &self,
        estimate: &'a Rational,
        error: &'a Rational,
        style: &Style,
    ) -> GiveOrTake<'a> {
        style.give_or_take(estimate, error, &self.style)
    }

    /// A lower end.
    pub(crate) fn lower<'a>(&self, value: &'a Rational) -> Shown<'a> {
        if self.is_single() { self.style.nearest(value) } else { self.style.lower(value) }
    }

    /// An upper end.
    pub(crate) fn upper<'a>(&self, value: &'a Rational) -> Shown<'a> {
        if self.is_single() { self.style.nearest(value) } else { self.style.upper(value) }
    }

    /// An end of the range behind its relation: `>= 1.5`; `about` says where the range is a single number that is rounded.
    pub(crate) fn end(&self, relation: Symbol, value: &Rational) -> Text {
        let is_about = self.is_single() && !self.style.is_shown_exactly(value);
        let text = if is_about { Text::from("about ") } else { Text::new() };
        text.number(if relation == Symbol::AtLeast { self.lower(value) } else { self.upper(value) })
    }

    /// An interval of such values.
    pub(crate) fn interval(&self, interval: &Interval) -> Text {
        self.style.interval(interval)
    }

    /// A union of such intervals; a hyphen when there is none.
    pub(crate) fn union(&self, intervals: &[Interval]) -> Text {
        self.style.union(intervals)
    }

    /// Returns whether the range has no width.
    fn is_single(&self) -> bool {
        self.range.and_then(Interval::ends).is_some_and(|(lower, upper)| lower == upper)
    }
}
