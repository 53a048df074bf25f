//! The rows of a program as they stand in a file: every number is a decimal.

use std::fmt::{self, Write};

use boundfit_exact::{Integer, Rational};

use super::number::{decimal, has_finite_decimal, is_short, push_decimal};
use crate::model::Bounds;

/// Bounds from this power of ten on are infinite for every reader.
pub(super) const INFINITE: i64 = 30;

/// Rows, the texts of which stand in one buffer: a program of 10⁶ readings has 8·10⁶ of them.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct WrittenRows {
    /// The name of each row, its coefficients and its bounds, with a line end behind each: neither names nor numbers
    /// contain one.
    pieces: String,
    shapes: Vec<Shape>,
    /// The columns of all coefficients.
    columns: Vec<usize>,
    /// The facts that a reader needs about the numbers of some rows, in their order.
    remarks: Vec<String>,
}

/// The pieces that a row has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Shape {
    coefficients: usize,
    has_lower: bool,
    has_upper: bool,
    has_range: bool,
}

/// A row with its bounds, of which a missing one is infinite.
#[derive(Debug, Clone)]
pub(super) struct WrittenRow<'a> {
    pub(super) name: &'a str,
    columns: &'a [usize],
    /// The coefficients, with a line end behind each.
    coefficients: &'a str,
    pub(super) lower: Option<&'a str>,
    pub(super) upper: Option<&'a str>,
    /// The upper bound less the lower one, where both are there and differ.
    pub(super) range: Option<&'a str>,
}

/// The treatment of bounds that readers would take for infinite.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum LargeBounds {
    /// Bounds stand as they are.
    Kept,
    /// A row with a bound that every reader would take for infinite gets smaller numbers.
    Finite,
    /// So does one with a bound that some reader would take for infinite: CPLEX, Gurobi and HiGHS begin at 10²⁰.
    FiniteForAll,
}

impl LargeBounds {
    /// The power of ten from which on rows get smaller numbers.
    fn exponent(self) -> Option<i64> {
        match self {
            LargeBounds::Kept => None,
            LargeBounds::Finite => Some(INFINITE),
            LargeBounds::FiniteForAll => Some(20),
        }
    }
}

impl WrittenRows {
    /// Adds a row of decimals; where a number has none, all of them are multiplied with the least number that makes them
    /// whole. The coefficients are given by column, in rising order.
    pub(super) fn push(
        &mut self,
        name: impl fmt::Display,
        coefficients: &[(usize, &Rational)],
        bounds: &Bounds,
        large: LargeBounds,
    ) {
        let start = self.pieces.len();
        // Writing to a string cannot fail.
        let _ = writeln!(self.pieces, "{name}");
        let end = self.pieces.len() - 1;
        let numbers =
            || coefficients.iter().map(|(_, value)| *value).chain(&bounds.lower).chain(&bounds.upper);
        let sides = || bounds.lower.iter().chain(&bounds.upper);
        // The exponent of 0 is `None`, which is less than any.
        let are_finite =
            || large.exponent().is_none_or(|most| sides().all(|side| side.decimal_exponent() < Some(most)));
        if numbers().all(is_short) && are_finite() {
            // Neither too long nor beyond the range of doubles.
            self.push_numbers(coefficients, bounds, push_decimal);
            return;
        }
        let scale = scale_of(numbers());
        let scale = match large.exponent() {
            None => scale,
            Some(most) => with_finite_bounds(scale, bounds, most),
        };
        let scaled = |value: &Rational| match &scale {
            Some(scale) => value * &scale.by,
            None => value.clone(),
        };
        let is_in_range = numbers().all(|value| is_in_range(&scaled(value)));
        let longest = numbers().map(|value| decimal(&scaled(value)).len()).max().unwrap_or_default();
        self.push_numbers(coefficients, bounds, |text, value| push_decimal(text, &scaled(value)));
        let name = self.pieces.get(start..end).unwrap_or_default().to_owned();
        self.remark(&name, scale.as_ref(), longest, is_in_range);
    }

    /// Adds the numbers of a row, each of them as it is written.
    fn push_numbers(
        &mut self,
        coefficients: &[(usize, &Rational)],
        bounds: &Bounds,
        write: impl Fn(&mut String, &Rational),
    ) {
        let pieces = &mut self.pieces;
        let mut add = |value: &Rational| {
            write(pieces, value);
            pieces.push('\n');
        };
        let mut used = 0;
        for (column, value) in coefficients.iter().filter(|(_, value)| !value.is_zero()) {
            add(value);
            self.columns.push(*column);
            used += 1;
        }
        let range = match (&bounds.lower, &bounds.upper) {
            (Some(lower), Some(upper)) if lower != upper => Some(upper - lower),
            _ => None,
        };
        bounds.lower.iter().chain(&bounds.upper).chain(&range).for_each(add);
        self.shapes.push(Shape {
            coefficients: used,
            has_lower: bounds.lower.is_some(),
            has_upper: bounds.upper.is_some(),
            has_range: range.is_some(),
        });
    }

    fn remark(&mut self, name: &str, scale: Option<&Scale>, longest: usize, is_in_range: bool) {
        /// The longest that GLPK reads.
        const LONGEST_NUMBER: usize = 255;
        if let Some(Scale { by, why }) = scale {
            self.remarks.push(format!("{name} is multiplied by {}: {why}", factor(by)));
        }
        if longest > LONGEST_NUMBER {
            self.remarks.push(format!(
                "{name} has a number of {longest} characters; GLPK reads at most {LONGEST_NUMBER}"
            ));
        }
        if !is_in_range {
            self.remarks.push(format!("{name} has a number that is beyond the range of doubles"));
        }
    }

    /// Returns what a reader has to know about the numbers.
    pub(super) fn remarks(&self) -> &[String] {
        &self.remarks
    }

    /// Returns whether a row has two bounds that differ.
    pub(super) fn has_ranges(&self) -> bool {
        self.shapes.iter().any(|shape| shape.has_range)
    }

    /// The rows in their order.
    pub(super) fn iter(&self) -> impl Iterator<Item = WrittenRow<'_>> + Clone {
        let (mut pieces, mut columns) = (self.pieces.as_str(), self.columns.as_slice());
        self.shapes.iter().map(move |shape| {
            let name = first_piece(&mut pieces);
            let coefficients = pieces;
            let (own, others) = columns.split_at_checked(shape.coefficients).unwrap_or_default();
            columns = others;
            own.iter().for_each(|_| _ = first_piece(&mut pieces));
            let [lower, upper, range] = [shape.has_lower, shape.has_upper, shape.has_range]
                .map(|is_there| is_there.then(|| first_piece(&mut pieces)));
            WrittenRow { name, columns: own, coefficients, lower, upper, range }
        })
    }
}

impl<'a> WrittenRow<'a> {
    /// Columns with their coefficients, in rising order, none of them 0.
    pub(super) fn coefficients(&self) -> impl Iterator<Item = (usize, &'a str)> + Clone {
        let mut pieces = self.coefficients;
        self.columns.iter().map(move |&column| (column, first_piece(&mut pieces)))
    }

    /// The coefficient of a column.
    pub(super) fn coefficient(&self, column: usize) -> Option<&'a str> {
        self.coefficients().find(|(place, _)| *place == column).map(|(_, text)| text)
    }

    /// The value that both bounds are.
    pub(super) fn fixed(&self) -> Option<&'a str> {
        self.lower.filter(|_| self.range.is_none() && self.upper.is_some())
    }
}

/// Takes the first piece off a text. Pieces are short: looking at one byte after the other is faster than what is made for long
/// texts.
fn first_piece<'a>(pieces: &mut &'a str) -> &'a str {
    let end = pieces.bytes().position(|byte| byte == b'\n').unwrap_or(pieces.len());
    let (piece, rest) = pieces.split_at_checked(end).unwrap_or_default();
    *pieces = rest.get(1..).unwrap_or_default();
    piece
}

/// The factor of all numbers of a row.
struct Scale {
    by: Rational,
    why: &'static str,
}

/// The least number with which all of these become whole, unless all of them are finite decimals.
fn scale_of<'a>(numbers: impl Iterator<Item = &'a Rational> + Clone) -> Option<Scale> {
    if numbers.clone().all(has_finite_decimal) {
        return None;
    }
    let by = numbers.fold(Integer::one(), |scale, value| scale.lcm(&value.denominator()));
    Some(Scale { by: by.into(), why: "its numbers have no finite decimals" })
}

/// Such a number that makes no bound one that readers take for infinite.
fn with_finite_bounds(scale: Option<Scale>, bounds: &Bounds, most: i64) -> Option<Scale> {
    let by = scale.as_ref().map_or_else(Rational::one, |scale| scale.by.clone());
    let sides = bounds.lower.iter().chain(&bounds.upper);
    let exponent = sides.filter_map(|side| (side * &by).decimal_exponent()).max();
    match exponent.filter(|exponent| *exponent >= most) {
        None => scale,
        Some(exponent) => Some(Scale {
            by: by * Rational::scientific(1, most - 1 - exponent),
            why: scale.map_or("a bound would be taken for infinite", |scale| scale.why),
        }),
    }
}

/// A factor with all digits if it is whole, as a decimal otherwise.
fn factor(by: &Rational) -> String {
    if by.denominator() == Integer::one() { by.to_string() } else { decimal(by) }
}

/// Returns whether a number and its double are both zero or both not, and the double is finite.
fn is_in_range(value: &Rational) -> bool {
    let double = value.to_f64();
    double.is_finite() && (double != 0.0 || value.is_zero())
}
