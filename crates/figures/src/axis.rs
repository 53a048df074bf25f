//! Axes: where an exact number falls between the ends of a view, and ticks that stay readable however narrow it is.
//!
//! Numbers become floats only as fractions of the view, after its lower end has been taken off exactly, so that a view
//! of width 1e-12 beside 1e6 loses nothing.

use std::ops::Range;

use boundfit_exact::{Fraction, Integer, Rational};
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};

/// A common offset is taken out of the tick labels when that saves at least this many digits.
const DIGITS_WORTH_AN_OFFSET: usize = 4;
/// Tick labels have no power of ten taken out when they need at most this many decimals.
const MOST_DECIMALS: i64 = 4;
/// The number of views beyond which a number is not drawn farther away: a float has no product of such numbers, and
/// lines to infinity have no direction.
const FARTHEST: f64 = 1e100;

/// A mark on an axis.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tick {
    /// Fraction of the view, from 0 to 1.
    pub(crate) at: f64,
    /// The number, without the common offset and power of ten.
    pub(crate) label: String,
}

/// A finite view of the real line with ticks at multiples of 1, 2 or 5 times a power of ten.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Axis {
    lower: Rational,
    width: Rational,
    /// Integers a, b, c so that n/d falls at (n·a − d·b)/(d·c) of the view: what all readings are placed with.
    terms: [Integer; 3],
    ticks: Vec<Tick>,
    scale: String,
    /// Name and unit of what is shown.
    pub(crate) name: String,
}

/// Multiples of 10^`exponent` at which ticks stand.
struct TickGrid {
    exponent: i64,
    multiples: Vec<Integer>,
}

impl Axis {
    /// A view from `lower` to `upper` with about at most `most` steps between ticks, and at least two ticks; a view
    /// without width is widened around its centre.
    pub(crate) fn new(name: String, lower: &Rational, upper: &Rational, most: usize) -> Self {
        let (lower, upper) = widened(lower, upper);
        let fewest = TickGrid::new(&lower, &upper, most);
        // A fifth of the width or less between ticks leaves room for two of them wherever they stand.
        let enough =
            (most..=5).map(|most| TickGrid::new(&lower, &upper, most)).find(TickGrid::tells_the_scale);
        Axis::of_grid(name, lower, &upper, enough.unwrap_or(fewest))
    }

    fn of_grid(name: String, lower: Rational, upper: &Rational, grid: TickGrid) -> Self {
        let width = upper - &lower;
        let (labels, scale) = grid.labels();
        let place = |multiple: &Integer| {
            let value = Rational::from(multiple) * Rational::scientific(1, grid.exponent);
            (value - &lower).checked_div(&width).unwrap_or_default().to_f64()
        };
        let ticks =
            grid.multiples.iter().zip(labels).map(|(m, label)| Tick { at: place(m), label }).collect();
        let (below, part) =
            ((lower.numerator(), lower.denominator()), (width.numerator(), width.denominator()));
        let terms = [&below.1 * &part.1, below.0 * part.1, below.1 * part.0];
        Axis { lower, width, terms, ticks, scale, name }
    }

    /// A view of numbers that count something: ticks stand at integers only. The view is wider than 1.
    pub(crate) fn counting(name: String, lower: &Rational, upper: &Rational, most: usize) -> Self {
        // The number of steps is such that none needs to be shorter than 1.
        let whole = -floor(&(lower - upper));
        let most = whole
            .to_u64()
            .and_then(|whole| usize::try_from(whole).ok())
            .map_or(most, |whole| most.min(whole));
        Axis::of_grid(name, lower.clone(), upper, TickGrid::new(lower, upper, most))
    }

    /// Returns the place of a number: 0 at the lower end of the view, 1 at the upper one. Rounded once; at most
    /// [`FARTHEST`] away.
    pub(crate) fn fraction(&self, value: &Rational) -> f64 {
        let (numerator, denominator) = (value.numerator(), value.denominator());
        let above = &numerator * &self.terms[0] - &denominator * &self.terms[1];
        let fraction = Fraction::new(above, denominator * &self.terms[2]).map_or(0.0, |own| own.to_f64());
        fraction.clamp(-FARTHEST, FARTHEST)
    }

    /// The lower end.
    pub(crate) fn lower(&self) -> &Rational {
        &self.lower
    }

    /// The width; positive.
    pub(crate) fn width(&self) -> &Rational {
        &self.width
    }

    /// Returns the factor and the offset of every tick label: `×10⁻⁵ + 0.0018`; empty when there is none.
    pub(crate) fn scale(&self) -> &str {
        &self.scale
    }

    /// The marks, ascending.
    #[cfg(feature = "tikz")]
    pub(crate) fn ticks(&self) -> &[Tick] {
        &self.ticks
    }
}

/// An axis that reaches from 0 to 1 for plotters.
impl Ranged for Axis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        // The ends of a float range that plotters itself maps are inside the panel; the cast saturates.
        (f64::from(limit.0) + value * f64::from(limit.1 - limit.0)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _hint: Hint) -> Vec<f64> {
        self.ticks.iter().map(|tick| tick.at).collect()
    }

    fn range(&self) -> Range<f64> {
        0.0..1.0
    }
}

impl ValueFormatter<f64> for Axis {
    fn format_ext(&self, value: &f64) -> String {
        // Plotters asks for nothing but the key points.
        self.ticks.iter().find(|tick| tick.at == *value).map(|tick| tick.label.clone()).unwrap_or_default()
    }
}

impl TickGrid {
    fn new(lower: &Rational, upper: &Rational, most: usize) -> Self {
        let least_step = (upper - lower).checked_div(&Rational::from(most.max(1))).unwrap_or_default();
        let (digit, exponent) = step_at_least(&least_step);
        let unit = Rational::scientific(1, exponent);
        let step = Rational::from(digit) * &unit;
        let first = -floor(&-(lower.checked_div(&step).unwrap_or_default()));
        let last = floor(&upper.checked_div(&step).unwrap_or_default());
        let mut multiples = Vec::new();
        let mut next = first;
        while next <= last {
            multiples.push(&next * Integer::from(digit));
            next = next + Integer::one();
        }
        TickGrid { exponent, multiples }
    }

    /// Returns whether there are two ticks, without which one cannot tell lengths.
    fn tells_the_scale(&self) -> bool {
        self.multiples.len() >= 2
    }

    /// The labels, and what was taken out of them.
    fn labels(&self) -> (Vec<String>, String) {
        let offset = self.offset();
        let rests: Vec<Integer> = self.multiples.iter().map(|multiple| multiple - &offset).collect();
        let digits = rests.iter().map(digits).max().unwrap_or(1) as i64;
        let leading = self.exponent + digits - 1;
        let plain = (-2..=4).contains(&leading) && -self.exponent <= MOST_DECIMALS;
        let power = if plain { 0 } else { leading };
        let labels = rests.iter().map(|rest| fixed(rest, self.exponent - power)).collect();
        let mut scale = String::new();
        if power != 0 {
            scale = format!("×10{}", superscript(power));
        }
        if !offset.is_zero() {
            let sign = if offset.is_negative() { '−' } else { '+' };
            let space = if scale.is_empty() { "" } else { " " };
            scale = format!("{scale}{space}{sign}{space}{}", offset_text(&offset.abs(), self.exponent));
        }
        (labels, scale)
    }

    /// The common part of all multiples, when leaving it out saves enough digits; else 0.
    fn offset(&self) -> Integer {
        let (Some(first), Some(last)) = (self.multiples.first(), self.multiples.last()) else {
            return Integer::zero();
        };
        let round = Integer::power_of_ten(digits(&(last - first)) as u32);
        let bucket = |value: &Integer| value.div_rem_floor(&round).0;
        let offset = if bucket(first) == bucket(last) {
            bucket(first) * &round
        } else {
            // The multiples straddle one round number: it is nearer to all of them than any other.
            bucket(last) * &round
        };
        let longest = |offset: &Integer| [first, last].map(|end| digits(&(end - offset))).into_iter().max();
        let saved =
            longest(&Integer::zero()).zip(longest(&offset)).map_or(0, |(all, rest)| all.saturating_sub(rest));
        if saved >= DIGITS_WORTH_AN_OFFSET { offset } else { Integer::zero() }
    }
}

/// Both ends, moved apart when they are equal: half the leading power of ten either way.
fn widened(lower: &Rational, upper: &Rational) -> (Rational, Rational) {
    if lower < upper {
        return (lower.clone(), upper.clone());
    }
    let half = lower
        .decimal_exponent()
        .map_or_else(Rational::one, |exponent| Rational::scientific(1, exponent))
        .half();
    (lower - &half, upper + &half)
}

/// The smallest 1, 2 or 5 times a power of ten that is not below a positive number, as digit and exponent.
fn step_at_least(least: &Rational) -> (i64, i64) {
    let exponent = least.decimal_exponent().unwrap_or(0);
    let digit = [1, 2, 5]
        .into_iter()
        .find(|&digit| Rational::from(digit) * Rational::scientific(1, exponent) >= *least);
    digit.map_or((1, exponent + 1), |digit| (digit, exponent))
}

fn floor(value: &Rational) -> Integer {
    value.numerator().div_rem_floor(&value.denominator()).0
}

/// Number of decimal digits of the absolute value; 1 for 0.
fn digits(value: &Integer) -> usize {
    value.abs().to_string().len()
}

/// `value * 10^exponent` in positional notation, with a true minus sign.
fn fixed(value: &Integer, exponent: i64) -> String {
    let sign = if value.is_negative() { "−" } else { "" };
    let digits = value.abs().to_string();
    if value.is_zero() && exponent >= 0 {
        return "0".to_owned();
    }
    if exponent >= 0 {
        return format!("{sign}{digits}{}", "0".repeat(exponent as usize));
    }
    let decimals = exponent.unsigned_abs() as usize;
    let padded = format!("{digits:0>width$}", width = decimals + 1);
    let (whole, fraction) = padded.split_at(padded.len() - decimals);
    format!("{sign}{whole}.{fraction}")
}

/// The exact value of a positive offset, shortly.
fn offset_text(offset: &Integer, exponent: i64) -> String {
    let digits = offset.to_string();
    let significant = digits.trim_end_matches('0');
    let leading = exponent + digits.len() as i64 - 1;
    let last = leading - significant.len() as i64 + 1;
    if (-3..=10).contains(&leading) && last >= -20 {
        let text = fixed(offset, exponent);
        let shortened = text.trim_end_matches('0').trim_end_matches('.').to_owned();
        return if text.contains('.') { shortened } else { text };
    }
    let (first, rest) = significant.split_at(1);
    let point = if rest.is_empty() { "" } else { "." };
    format!("{first}{point}{rest}×10{}", superscript(leading))
}

/// An integer as a superscript.
pub(crate) fn superscript(value: i64) -> String {
    let raised = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32('⁰' as u32 + u32::from(digit) - u32::from('0')).unwrap_or(digit),
    };
    value.to_string().chars().map(raised).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axis(lower: Rational, upper: Rational, most: usize) -> Axis {
        Axis::new("x".to_owned(), &lower, &upper, most)
    }

    fn labels(axis: &Axis) -> Vec<&str> {
        axis.ticks().iter().map(|tick| tick.label.as_str()).collect()
    }

    #[test]
    fn plain_ranges_have_plain_labels() {
        let unit = axis(Rational::zero(), Rational::one(), 5);
        assert_eq!(labels(&unit), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(unit.scale(), "");
        let tens = axis(Rational::from(-70), Rational::from(80), 8);
        assert_eq!(labels(&tens), ["−60", "−40", "−20", "0", "20", "40", "60", "80"]);
        let thousands = axis(Rational::from(0), Rational::from(30_000), 3);
        assert_eq!(labels(&thousands), ["0", "10000", "20000", "30000"]);
        let millions = axis(Rational::from(0), Rational::from(3_000_000), 3);
        assert_eq!((labels(&millions), millions.scale()), (vec!["0", "1", "2", "3"], "×10⁶"));
    }

    #[test]
    fn a_power_of_ten_comes_out_of_a_range_of_1e_5_around_1_8e_3() {
        let centre = Rational::ratio(18, 10_000);
        let half = Rational::ratio(5, 1_000_000);
        let narrow = axis(&centre - &half, centre + half, 5);
        assert_eq!(labels(&narrow), ["1.796", "1.798", "1.800", "1.802", "1.804"]);
        assert_eq!(narrow.scale(), "×10⁻³");
    }

    #[test]
    fn an_offset_comes_out_of_a_range_of_1e_12_beside_a_million() {
        let lower = Rational::from(1_000_000);
        let width = Rational::scientific(1, -12);
        let narrow = axis(lower.clone(), &lower + &width, 5);
        assert_eq!(labels(&narrow), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(narrow.scale(), "×10⁻¹² + 1000000");
        assert_eq!(narrow.ticks()[1].at, 0.2);
        // Exact before it is a float: a third of a width that binary64 cannot see beside a million.
        let third = &lower + &width * Rational::ratio(1, 3);
        assert_eq!(narrow.fraction(&third), 1.0 / 3.0);
    }

    #[test]
    fn no_number_is_infinitely_far_from_a_view() {
        let narrow = axis(Rational::zero(), Rational::scientific(1, -400), 5);
        assert_eq!(narrow.fraction(&Rational::one()), FARTHEST);
        assert_eq!(narrow.fraction(&Rational::from(-1)), -FARTHEST);
    }

    #[test]
    fn the_offset_of_labels_on_both_sides_of_a_round_number_is_that_number() {
        let around = axis(Rational::ratio(1_999_999, 2), Rational::ratio(2_000_001, 2), 2);
        assert_eq!((labels(&around), around.scale()), (vec!["−0.5", "0.0", "0.5"], "+1000000"));
        let negative = axis(Rational::ratio(-2_000_001, 2), Rational::ratio(-1_999_999, 2), 2);
        assert_eq!((labels(&negative), negative.scale()), (vec!["−0.5", "0.0", "0.5"], "−1000000"));
    }

    #[test]
    fn offsets_are_written_in_full() {
        let lower = Rational::ratio(7_242_136_415_695, 10_000_000_000_000);
        let narrow = axis(lower.clone(), lower + Rational::scientific(1, -14), 5);
        assert_eq!(narrow.scale(), "×10⁻¹⁴ + 0.7242136415695");
        let large = Rational::scientific(1, 30);
        assert_eq!(axis(large.clone(), large + Rational::one(), 1).scale(), "+1×10³⁰");
    }

    #[test]
    fn a_range_without_width_is_widened_around_its_place() {
        let place = Rational::ratio(5, 4);
        let point = axis(place.clone(), place.clone(), 4);
        assert_eq!((point.lower(), point.width()), (&Rational::ratio(3, 4), &Rational::one()));
        assert_eq!(point.fraction(&place), 0.5);
        let zero = axis(Rational::zero(), Rational::zero(), 2);
        assert_eq!(labels(&zero), ["−0.5", "0.0", "0.5"]);
    }

    #[test]
    fn counted_things_have_integer_ticks() {
        for count in 1..200 {
            let upper = Rational::from(count) + Rational::ratio(3, 5);
            let counting = Axis::counting("row".to_owned(), &Rational::ratio(2, 5), &upper, 11);
            assert!(labels(&counting).iter().all(|label| !label.contains('.')), "{count}");
            assert!(!counting.ticks().is_empty(), "{count}");
        }
    }

    #[test]
    fn steps_are_1_2_or_5_times_a_power_of_ten() {
        for (least, step) in [((1, 1), (1, 0)), ((11, 10), (2, 0)), ((21, 10), (5, 0)), ((51, 10), (1, 1))] {
            assert_eq!(step_at_least(&Rational::ratio(least.0, least.1)), step);
        }
        assert_eq!(step_at_least(&Rational::ratio(3, 100_000)), (5, -5));
    }

    #[test]
    fn two_ticks_and_hardly_more_steps_than_asked_for() {
        for lower in -20..20 {
            for width in 1..60 {
                for most in 1..9 {
                    let lower = Rational::ratio(lower, 7);
                    let upper = &lower + Rational::ratio(width, 13);
                    let count = axis(lower, upper, most).ticks().len();
                    assert!((2..=most.max(4) + 1).contains(&count), "{count} ticks for {most} steps");
                }
            }
        }
    }
}
