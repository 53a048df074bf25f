//! A drawing area with axes, and what is drawn on it: exact places become pixels at the last step.

use std::fmt::Write;

use boundfit_exact::{Rational, Rounding};

use crate::number::with_minus;
use crate::texts::{Language, escaped};

const WIDTH: f64 = 640.0;
const HEIGHT: f64 = 420.0;
const LEFT: f64 = 84.0;
const TOP: f64 = 34.0;
const RIGHT: f64 = 14.0;
const BOTTOM: f64 = 52.0;
/// Significant digits of the numbers at the ends of an axis.
const TICK_DIGITS: usize = 6;

/// An interval of an axis, not of width 0.
#[derive(Debug, Clone)]
pub(super) struct Range {
    pub(super) from: Rational,
    pub(super) width: Rational,
}

impl Range {
    /// The range around these numbers, with a share of its width, in percent, on both sides. Numbers that are all the same get as
    /// much room as they are large.
    pub(super) fn around(numbers: &[Rational], margin: i64) -> Range {
        let zero = Rational::zero;
        let least = numbers.iter().min().cloned().unwrap_or_else(zero);
        let greatest = numbers.iter().max().cloned().unwrap_or_else(zero);
        let mut width = &greatest - &least;
        if width.is_zero() {
            width = if least.is_zero() { Rational::one() } else { least.abs() };
        }
        let margin = &width * &Rational::ratio(margin, 100);
        Range { from: &least - &margin, width: &(&greatest - &least) + &(&margin + &margin) }
    }

    pub(super) fn end(&self) -> Rational {
        &self.from + &self.width
    }

    /// Where a number is between 0 and 1.
    pub(super) fn share(&self, value: &Rational) -> f64 {
        (value - &self.from).checked_div(&self.width).map_or(0.0, |share| share.to_f64())
    }
}

/// A picture that grows by what is drawn.
#[derive(Debug)]
pub(super) struct Picture {
    pub(super) ranges: [Range; 2],
    drawn: String,
}

impl Picture {
    pub(super) fn new(ranges: [Range; 2]) -> Self {
        Picture { ranges, drawn: String::new() }
    }

    fn pixel(&self, place: &[Rational; 2]) -> (f64, f64) {
        self.pixel_of([0, 1].map(|axis| self.ranges[axis].share(&place[axis])))
    }

    fn pixel_of(&self, [x, y]: [f64; 2]) -> (f64, f64) {
        let keep = |share: f64| share.clamp(-1.0, 2.0);
        let across = LEFT + keep(x) * (WIDTH - LEFT - RIGHT);
        (across, TOP + (1.0 - keep(y)) * (HEIGHT - TOP - BOTTOM))
    }

    fn add(&mut self, element: std::fmt::Arguments<'_>) {
        // Writing to a string does not fail.
        self.drawn.write_fmt(element).unwrap_or_default();
    }

    /// The path through places, closed or not, with a class.
    pub(super) fn path(&mut self, class: &str, places: &[[Rational; 2]], closed: bool) {
        if places.is_empty() {
            return;
        }
        let points: Vec<String> =
            places.iter().map(|place| self.pixel(place)).map(|(x, y)| format!("{x:.2} {y:.2}")).collect();
        let end = if closed { "Z" } else { "" };
        self.add(format_args!("<path class=\"{class}\" d=\"M{}{end}\"/>", points.join("L")));
    }

    /// The boundary a·θ = b as far as it is seen.
    pub(super) fn line(&mut self, class: &str, a: &[Rational; 2], b: &Rational) {
        let scaled = [0, 1].map(|axis| &a[axis] * &self.ranges[axis].width);
        let largest = scaled.iter().map(Rational::abs).max().unwrap_or_default();
        let at_origin = &(&a[0] * &self.ranges[0].from) + &(&a[1] * &self.ranges[1].from);
        let part = |value: &Rational| value.checked_div(&largest).map(|part| part.to_f64());
        let (Some(p), Some(q), Some(r)) = (part(&scaled[0]), part(&scaled[1]), part(&(b - &at_origin)))
        else {
            return;
        };
        let inside = |share: &f64| (-1e-9..=1.0 + 1e-9).contains(share);
        let mut ends: Vec<[f64; 2]> = Vec::new();
        for side in [0.0, 1.0] {
            ends.extend(Some((r - p * side) / q).filter(inside).map(|v| [side, v]));
            ends.extend(Some((r - q * side) / p).filter(inside).map(|u| [u, side]));
        }
        let far = |one: &[f64; 2], other: &[f64; 2]| (one[0] - other[0]).abs() + (one[1] - other[1]).abs();
        let Some(first) = ends.first().copied() else { return };
        let Some(last) =
            ends.iter().copied().max_by(|one, other| far(one, &first).total_cmp(&far(other, &first)))
        else {
            return;
        };
        let [(x1, y1), (x2, y2)] = [first, last].map(|end| self.pixel_of(end));
        self.add(format_args!(
            "<g class=\"bound {class}\"><path class=\"line\" d=\"M{x1:.2} {y1:.2}L{x2:.2} {y2:.2}\"/></g>"
        ));
    }

    /// A vertex with its number.
    pub(super) fn vertex(&mut self, number: usize, place: &[Rational; 2]) {
        let (x, y) = self.pixel(place);
        self.add(format_args!(
            "<g class=\"vertex\"><circle class=\"dot\" cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"4\"/></g>\
             <text class=\"vertex-number\" x=\"{:.2}\" y=\"{:.2}\">{number}</text>",
            x + 7.0,
            y - 7.0
        ));
    }

    /// A reading: its bar, and a dot where there is a value.
    pub(super) fn reading(
        &mut self,
        at: &Rational,
        lower: &Rational,
        upper: &Rational,
        dot: Option<&Rational>,
    ) {
        let [(x, bottom), (_, top)] = [lower, upper].map(|end| self.pixel(&[at.clone(), end.clone()]));
        self.add(format_args!(
            "<g class=\"reading\"><path class=\"bar\" d=\"M{x:.2} {top:.2}V{bottom:.2}M{l:.2} {top:.2}H{r:.2}M{l:.2} {bottom:.2}H{r:.2}\"/>",
            l = x - 4.0,
            r = x + 4.0
        ));
        if let Some(dot) = dot {
            let (x, y) = self.pixel(&[at.clone(), dot.clone()]);
            self.add(format_args!("<circle class=\"dot\" cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"3\"/>"));
        }
        self.add(format_args!("</g>"));
    }

    /// The picture in a frame with the names of its axes and the numbers at their ends.
    pub(super) fn svg(self, id: &str, label: &str, names: [&str; 2], language: Language) -> String {
        let (right, bottom) = (WIDTH - RIGHT, HEIGHT - BOTTOM);
        let tick = |value: &Rational| {
            let decimal = with_minus(&value.to_decimal(TICK_DIGITS, Rounding::Nearest));
            decimal.replace('.', language.decimal_mark())
        };
        let text = |class: &str, x: f64, y: f64, anchor: &str, words: &str| {
            format!(
                "<text class=\"{class}\" x=\"{x}\" y=\"{y}\" text-anchor=\"{anchor}\">{}</text>",
                escaped(words)
            )
        };
        let [across, up] = &self.ranges;
        let frame = [
            format!(
                "<rect class=\"frame\" x=\"{LEFT}\" y=\"{TOP}\" width=\"{}\" height=\"{}\"/>",
                right - LEFT,
                bottom - TOP
            ),
            text("tick", LEFT, bottom + 17.0, "middle", &tick(&across.from)),
            text("tick", right, bottom + 17.0, "end", &tick(&across.end())),
            text("tick", LEFT - 6.0, bottom, "end", &tick(&up.from)),
            text("tick", LEFT - 6.0, TOP + 10.0, "end", &tick(&up.end())),
            text("axis", right, bottom + 40.0, "end", names[0]),
            text("axis", 4.0, 18.0, "start", names[1]),
        ]
        .concat();
        format!(
            "<svg class=\"plane\" role=\"img\" aria-label=\"{}\" viewBox=\"0 0 {WIDTH} {HEIGHT}\"><defs><clipPath \
             id=\"{id}\"><rect x=\"{LEFT}\" y=\"{TOP}\" width=\"{}\" height=\"{}\"/></clipPath></defs>{frame}<g \
             clip-path=\"url(#{id})\">{}</g></svg>",
            escaped(label),
            right - LEFT,
            bottom - TOP,
            self.drawn
        )
    }
}
