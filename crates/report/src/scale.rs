//! The numbers of one parameter in a report: the same value looks the same wherever it stands.

use std::collections::HashSet;
use std::hash::{DefaultHasher, Hash, Hasher};

use boundfit_exact::{Integer, Interval, Rational, Rounding, fewest_digits};
use boundfit_geometry::Measure;

use crate::document::{Symbol, Text};
use crate::style::{GiveOrTake, Shown, Style};

/// The most digits that are tried.
const MOST_DIGITS: usize = 40;

/// The scale that shows the values of one parameter: with common digits, and with the ends of its range rounded
/// outward everywhere.
#[derive(Debug, Clone)]
pub(crate) struct Scale {
    style: Style,
    range: Option<Interval>,
}

/// Returns one scale for each of two parameters. Its digits are those that the ranges take where these are known, and
/// that other intervals and the estimates beside a range take. They tell the vertices apart, too, which are
/// [homogeneous](boundfit_geometry::Polyhedron::homogeneous_vertices).
pub(crate) fn scales<V: Iterator<Item = [Integer; 3]>>(
    style: &Style,
    ranges: Option<&[Interval; 2]>,
    others: &[&[Interval; 2]],
    estimates: &[&[Rational; 2]],
    vertices: impl Fn() -> V,
) -> [Scale; 2] {
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
        Scale { style: Style { digits, ..*style }, range: range.cloned() }
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
/// many. Cost: for each number of digits that of showing the vertices up to the first neighbours that look alike. Memory: 8 bytes a
/// vertex.
fn telling_apart<V: Iterator<Item = [Integer; 3]>>(
    scales: [Scale; 2],
    vertices: impl Fn() -> V,
) -> [Scale; 2] {
    let with_more = |more: usize| {
        scales.each_ref().map(|scale| Scale {
            style: Style { digits: Some(scale.style.significant() + more), ..scale.style },
            range: scale.range.clone(),
        })
    };
    let differ = |scales: &[Scale; 2]| {
        let show = |[x, y, w]: &[Integer; 3], text: &mut String| {
            text.clear();
            // Writing into a string never fails.
            let _ = scales[0].quotient(x, w).write_to(text);
            text.push(' ');
            let _ = scales[1].quotient(y, w).write_to(text);
        };
        let (mut text, mut last, mut hashes) = (String::new(), String::new(), Vec::new());
        for vertex in vertices() {
            show(&vertex, &mut text);
            if text == last {
                return false;
            }
            hashes.push(hash(&text));
            std::mem::swap(&mut text, &mut last);
        }
        hashes.sort_unstable();
        // Only equal hashes leave open what the texts are.
        let mut seen = HashSet::new();
        hashes.windows(2).all(|pair| pair[0] != pair[1])
            || vertices().all(|vertex| {
                show(&vertex, &mut text);
                seen.insert(text.clone())
            })
    };
    (0..MOST_DIGITS).map(with_more).find(differ).unwrap_or(scales)
}

fn hash(text: &str) -> u64 {
    let mut hasher = DefaultHasher::new();
    text.hash(&mut hasher);
    hasher.finish()
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

impl Scale {
    /// A value: one that is an end of the range like this end, any other to nearest.
    pub(crate) fn value<'a>(&self, value: &'a Rational) -> Shown<'a> {
        self.style.shown(value, self.rounding(|end| end == value))
    }

    /// The value `numerator / denominator`, with a positive denominator: as [`Scale::value`] of the number in lowest terms.
    pub(crate) fn quotient<'a>(&self, numerator: &'a Integer, denominator: &'a Integer) -> Shown<'a> {
        let rounding = self.rounding(|end| end.is_quotient(numerator, denominator));
        self.style.quotient(numerator, denominator, rounding)
    }

    /// The rounding of a value, which `is` compares with an end of the range.
    fn rounding(&self, is: impl Fn(&Rational) -> bool) -> Rounding {
        let Some(range) = &self.range else { return Rounding::Nearest };
        let outward = match (range.lower().value(), range.upper().value()) {
            (Some(lower), _) if is(lower) => Rounding::Down,
            (_, Some(upper)) if is(upper) => Rounding::Up,
            _ => return Rounding::Nearest,
        };
        self.directed(outward)
    }

    /// The rounding of an end of the range.
    fn directed(&self, outward: Rounding) -> Rounding {
        if self.is_single() { Rounding::Nearest } else { self.style.directed(outward) }
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
        self.style.shown(value, self.directed(Rounding::Down))
    }

    /// An upper end.
    pub(crate) fn upper<'a>(&self, value: &'a Rational) -> Shown<'a> {
        self.style.shown(value, self.directed(Rounding::Up))
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
        self.range.as_ref().and_then(Interval::ends).is_some_and(|(lower, upper)| lower == upper)
    }
}

#[cfg(test)]
mod tests {
    use boundfit_exact::Endpoint;

    use super::*;

    /// Returns the fewest digits from five on with which no two values look alike, by comparing each with each.
    fn fewest(values: &[[Rational; 2]]) -> usize {
        let shown = |digits: usize| -> Vec<String> {
            let decimal = |value: &Rational| value.to_decimal(digits, Rounding::Nearest);
            values.iter().map(|[x, y]| decimal(x) + " " + &decimal(y)).collect()
        };
        let differ = |texts: Vec<String>| (0..texts.len()).all(|own| !texts[..own].contains(&texts[own]));
        (5..5 + MOST_DIGITS).find(|&digits| differ(shown(digits))).unwrap()
    }

    #[test]
    fn digits_tell_vertices_apart_that_are_no_neighbours() {
        let mut seed = 5_u64;
        let mut draw = |below: u64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((seed >> 33) % below) as i64
        };
        let mut most = 0;
        for round in 0..300 {
            let far = 10_i64.pow(round % 9);
            let mut values: Vec<[Rational; 2]> = Vec::new();
            while values.len() < 6 {
                let number = |steps: i64, rest: i64| Rational::ratio(steps * far + rest, 21);
                let value = [number(draw(2), draw(3)), number(draw(2), 0)];
                if !values.contains(&value) {
                    values.push(value);
                }
            }
            let homogeneous = || {
                values.iter().map(|[x, y]| {
                    let ([x, y], w) = Rational::over_common_denominator([x, y]);
                    [x, y, w].map(|number| number * Integer::from(6))
                })
            };
            let style = Style { digits: None, ..Style::default() };
            let own = scales(&style, None, &[], &[], homogeneous);
            let expected = fewest(&values);
            assert_eq!(own.map(|scale| scale.style.significant()), [expected; 2], "{values:?}");
            most = most.max(expected);
        }
        assert!(most > 8, "{most}");
    }

    #[test]
    fn quotients_look_like_the_numbers_in_lowest_terms() {
        let (lower, upper) = (Rational::ratio(-2, 3), Rational::ratio(5, 7));
        let range = Interval::new(Endpoint::Finite(lower.clone()), Endpoint::Finite(upper.clone()));
        for exact in [false, true] {
            let scale = Scale { style: Style { exact, ..Style::default() }, range: range.clone() };
            for value in [&lower, &upper, &Rational::ratio(-1, 3), &Rational::zero()] {
                let [numerator, denominator] =
                    [value.numerator(), value.denominator()].map(|term| term * Integer::from(15));
                let shown = scale.quotient(&numerator, &denominator);
                let mut written = String::new();
                shown.write_to(&mut written).unwrap();
                assert_eq!([written, shown.to_string()], [(); 2].map(|()| scale.value(value).to_string()));
            }
        }
        let scale = Scale { style: Style::default(), range };
        assert_eq!(
            [scale.value(&lower), scale.value(&upper)].map(|own| own.to_string()),
            ["-0.66667", "0.71429"]
        );
    }
}
