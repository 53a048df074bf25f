//! A linear program as it stands in a file: every number is a decimal, every name one that readers take.

use boundfit_exact::{Integer, Rational};

use super::number::{finite_decimal, has_finite_decimal};
use crate::model::{Bounds, ObjectiveSense};

/// Bounds from this power of ten on are infinite for every reader.
pub(super) const INFINITE: i64 = 30;

/// A program ready to be written.
#[derive(Debug)]
pub(super) struct Written<'a> {
    pub(super) name: &'a str,
    pub(super) sense: ObjectiveSense,
    /// The objective, whose bounds say nothing.
    pub(super) objective: &'a WrittenRow,
    /// What is added to the objective, and its opposite.
    pub(super) constant: [String; 2],
    pub(super) columns: &'a [WrittenColumn],
    pub(super) rows: Vec<&'a WrittenRow>,
    /// What is said at the top.
    pub(super) remarks: Vec<String>,
}

/// A column with its bounds, of which a missing one is infinite.
#[derive(Debug, Clone)]
pub(super) struct WrittenColumn {
    pub(super) name: String,
    pub(super) lower: Option<String>,
    pub(super) upper: Option<String>,
}

/// A row with its bounds, of which a missing one is infinite.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct WrittenRow {
    pub(super) name: String,
    /// By column, in rising order, none of them 0.
    pub(super) coefficients: Vec<(usize, String)>,
    pub(super) lower: Option<String>,
    pub(super) upper: Option<String>,
    /// The upper bound less the lower one, where both are there and differ.
    pub(super) range: Option<String>,
    /// What all numbers were multiplied with, and why.
    scale: Option<Scale>,
    /// Whether all of them are representable in binary64 at least roughly: none overflows or becomes 0.
    is_in_range: bool,
}

impl WrittenRow {
    /// A row of decimals; where a number has none, all of them are multiplied with the least number that makes them whole.
    pub(super) fn new<'a>(
        name: String,
        coefficients: impl IntoIterator<Item = (usize, &'a Rational)>,
        bounds: &Bounds,
    ) -> Self {
        WrittenRow::with_scale(name, coefficients, bounds, |scale| scale)
    }

    /// Such a row where no reader takes a bound for infinite: if one is 10³⁰ or more, all numbers become smaller.
    pub(super) fn with_finite_bounds<'a>(
        name: String,
        coefficients: impl IntoIterator<Item = (usize, &'a Rational)>,
        bounds: &Bounds,
    ) -> Self {
        WrittenRow::with_scale(name, coefficients, bounds, |scale| {
            let by = scale.as_ref().map_or_else(Rational::one, |scale| scale.by.clone());
            let sides = bounds.lower.iter().chain(&bounds.upper);
            let exponent = sides.filter_map(|side| (side * &by).decimal_exponent()).max();
            match exponent.filter(|exponent| *exponent >= INFINITE) {
                None => scale,
                Some(exponent) => Some(Scale {
                    by: by * Rational::scientific(1, INFINITE - 1 - exponent),
                    why: scale.map_or("a bound would be taken for infinite", |scale| scale.why),
                }),
            }
        })
    }

    fn with_scale<'a>(
        name: String,
        coefficients: impl IntoIterator<Item = (usize, &'a Rational)>,
        bounds: &Bounds,
        adapted: impl FnOnce(Option<Scale>) -> Option<Scale>,
    ) -> Self {
        let mut coefficients: Vec<_> =
            coefficients.into_iter().filter(|(_, value)| !value.is_zero()).collect();
        coefficients.sort_by_key(|(column, _)| *column);
        let numbers =
            || coefficients.iter().map(|(_, value)| *value).chain(&bounds.lower).chain(&bounds.upper);
        let scale = adapted(scale_of(numbers()));
        let scaled = |value: &Rational| match &scale {
            Some(scale) => value * &scale.by,
            None => value.clone(),
        };
        let is_in_range = numbers().all(|value| is_in_range(&scaled(value)));
        let text = |value: &Rational| decimal(&scaled(value));
        let range = match (&bounds.lower, &bounds.upper) {
            (Some(lower), Some(upper)) if lower != upper => Some(text(&(upper - lower))),
            _ => None,
        };
        WrittenRow {
            name,
            coefficients: coefficients.iter().map(|(column, value)| (*column, text(value))).collect(),
            lower: bounds.lower.as_ref().map(text),
            upper: bounds.upper.as_ref().map(text),
            range,
            scale,
            is_in_range,
        }
    }

    /// The coefficient of a column.
    pub(super) fn coefficient(&self, column: usize) -> Option<&str> {
        let found = self.coefficients.binary_search_by_key(&column, |(place, _)| *place).ok()?;
        self.coefficients.get(found).map(|(_, text)| text.as_str())
    }

    /// The value that both bounds are.
    pub(super) fn fixed(&self) -> Option<&str> {
        self.lower.as_deref().filter(|_| self.range.is_none() && self.upper.is_some())
    }

    /// What a reader has to know about the numbers.
    pub(super) fn remarks(&self) -> Vec<String> {
        /// The longest that GLPK reads.
        const LONGEST_NUMBER: usize = 255;
        let name = &self.name;
        let texts = self.coefficients.iter().map(|(_, text)| text).chain(&self.lower).chain(&self.upper);
        let longest = texts.map(String::len).max().unwrap_or_default();
        let mut remarks = Vec::new();
        if let Some(Scale { by, why }) = &self.scale {
            remarks.push(format!("{name} is multiplied by {}: {why}", factor(by)));
        }
        if longest > LONGEST_NUMBER {
            remarks.push(format!(
                "{name} has a number of {longest} characters; GLPK reads at most {LONGEST_NUMBER}"
            ));
        }
        if !self.is_in_range {
            remarks.push(format!("{name} has a number that is beyond the range of doubles"));
        }
        remarks
    }
}

/// What all numbers of a row were multiplied with.
#[derive(Debug, Clone, PartialEq, Eq)]
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

/// A factor with all digits if it is whole, as a decimal otherwise.
fn factor(by: &Rational) -> String {
    if by.denominator() == Integer::one() { by.to_string() } else { decimal(by) }
}

/// A finite decimal as text; a fraction where it has none.
pub(super) fn decimal(value: &Rational) -> String {
    finite_decimal(value).unwrap_or_else(|| value.to_string())
}

/// Whether a number and its double are both zero or both not, and the double is finite.
fn is_in_range(value: &Rational) -> bool {
    let double = value.to_f64();
    double.is_finite() && (double != 0.0 || value.is_zero())
}
