//! The rows of a program as they stand in a file: every number is a decimal.

use std::fmt::{self, Write};

use boundfit_exact::{Integer, Rational};

use super::number::{decimal, is_short, push_decimal};
use crate::model::Bounds;

/// Bounds from this power of ten on are infinite for every reader.
pub(super) const INFINITE: i64 = 30;

/// Rows, the texts of which stand in one buffer: a program of 10⁶ readings has 8·10⁶ of them.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct WrittenRows {
    /// The name of each row, its coefficients and its bounds, with a line end behind each: neither names nor numbers
    /// contain one.
    pieces: String,
    /// The length of each piece, or [`LONG`]: looking for line ends takes several times longer.
    lengths: Vec<u8>,
    shapes: Vec<Shape>,
    /// The columns of all coefficients.
    columns: Vec<usize>,
    /// The facts that a reader needs about the numbers of some rows, in their order.
    remarks: Vec<String>,
}

/// Stands for the length of any piece from here on.
const LONG: u8 = u8::MAX;

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
    /// The coefficients, and what comes behind them.
    coefficients: Pieces<'a>,
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
        self.lengths.push(stored_length(end - start));
        let numbers =
            || coefficients.iter().map(|(_, value)| *value).chain(&bounds.lower).chain(&bounds.upper);
        if numbers().all(is_short) {
            // Neither too long nor beyond the range of doubles, and a word is less than what readers take for infinite.
            self.push_numbers(coefficients, bounds);
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
        let of_columns: Vec<_> =
            coefficients.iter().map(|(column, value)| (*column, scaled(value))).collect();
        let coefficients: Vec<_> = of_columns.iter().map(|(column, value)| (*column, value)).collect();
        let bounds =
            Bounds { lower: bounds.lower.as_ref().map(scaled), upper: bounds.upper.as_ref().map(scaled) };
        let mut numbers =
            coefficients.iter().map(|(_, value)| *value).chain(&bounds.lower).chain(&bounds.upper);
        let is_in_range = numbers.all(is_in_range);
        let longest = self.push_numbers(&coefficients, &bounds);
        let name = self.pieces.get(start..end).unwrap_or_default().to_owned();
        self.remark(&name, scale.as_ref(), longest, is_in_range);
    }

    /// Adds the numbers of a row. Returns the length of the longest one.
    fn push_numbers(&mut self, coefficients: &[(usize, &Rational)], bounds: &Bounds) -> usize {
        let (pieces, lengths) = (&mut self.pieces, &mut self.lengths);
        let mut add = |value: &Rational| {
            let start = pieces.len();
            push_decimal(pieces, value);
            let length = pieces.len() - start;
            lengths.push(stored_length(length));
            pieces.push('\n');
            length
        };
        let mut longest = 0;
        let mut used = 0;
        for (column, value) in coefficients.iter().filter(|(_, value)| !value.is_zero()) {
            longest = longest.max(add(value));
            self.columns.push(*column);
            used += 1;
        }
        let range = match (&bounds.lower, &bounds.upper) {
            (Some(lower), Some(upper)) if lower != upper => Some(upper - lower),
            _ => None,
        };
        for bound in bounds.lower.iter().chain(&bounds.upper) {
            longest = longest.max(add(bound));
        }
        range.iter().for_each(|range| _ = add(range));
        self.shapes.push(Shape {
            coefficients: used,
            has_lower: bounds.lower.is_some(),
            has_upper: bounds.upper.is_some(),
            has_range: range.is_some(),
        });
        longest
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
        let mut pieces = Pieces { text: &self.pieces, lengths: &self.lengths };
        let mut columns = self.columns.as_slice();
        self.shapes.iter().map(move |shape| {
            let name = pieces.take();
            let coefficients = pieces;
            let (own, others) = columns.split_at_checked(shape.coefficients).unwrap_or_default();
            columns = others;
            own.iter().for_each(|_| _ = pieces.take());
            let [lower, upper, range] = [shape.has_lower, shape.has_upper, shape.has_range]
                .map(|is_there| is_there.then(|| pieces.take()));
            WrittenRow { name, columns: own, coefficients, lower, upper, range }
        })
    }
}

impl<'a> WrittenRow<'a> {
    /// Columns with their coefficients, in rising order, none of them 0.
    pub(super) fn coefficients(&self) -> impl Iterator<Item = (usize, &'a str)> + Clone {
        let mut pieces = self.coefficients;
        self.columns.iter().map(move |&column| (column, pieces.take()))
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

/// Pieces of text, with a line end behind each.
#[derive(Debug, Clone, Copy)]
struct Pieces<'a> {
    text: &'a str,
    lengths: &'a [u8],
}

impl<'a> Pieces<'a> {
    /// Takes the first one off.
    fn take(&mut self) -> &'a str {
        let end = match self.lengths.split_off_first() {
            Some(&length) if length < LONG => usize::from(length),
            _ => self.text.bytes().position(|byte| byte == b'\n').unwrap_or(self.text.len()),
        };
        let (piece, rest) = self.text.split_at_checked(end).unwrap_or_default();
        self.text = rest.get(1..).unwrap_or_default();
        piece
    }
}

/// The length of a piece, as it is stored.
fn stored_length(length: usize) -> u8 {
    u8::try_from(length).unwrap_or(LONG)
}

/// The factor of all numbers of a row.
struct Scale {
    by: Rational,
    why: &'static str,
}

/// The least number with which all of these become whole, unless all of them are finite decimals.
fn scale_of<'a>(numbers: impl Iterator<Item = &'a Rational> + Clone) -> Option<Scale> {
    if numbers.clone().all(Rational::is_finite_decimal) {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_of_any_length_come_back() {
        let mut rows = WrittenRows::default();
        let one = Rational::one();
        let lengths = [1, 2, 253, 254, 255, 256, 300, 3];
        for length in lengths {
            // 10^(length - 1) and a tenth are a number of that many digits and one behind the point.
            let long = Rational::scientific(1, length - 1) + Rational::ratio(1, 10);
            let bounds = Bounds { lower: Some(long), upper: None };
            rows.push("r".repeat(length as usize), &[(0, &one), (1, &one)], &bounds, LargeBounds::Kept);
        }
        assert!(rows.lengths.contains(&LONG) && rows.lengths.contains(&(LONG - 1)));
        for (row, length) in rows.iter().zip(lengths) {
            assert_eq!(row.name.len(), length as usize);
            assert_eq!(row.coefficients().collect::<Vec<_>>(), [(0, "1"), (1, "1")]);
            let lower = row.lower.unwrap();
            assert!(lower.starts_with('1') && lower.ends_with(".1") && lower.len() == length as usize + 2);
            assert_eq!((row.upper, row.range), (None, None));
        }
        assert_eq!(rows.iter().count(), lengths.len());
    }
}
