//! A linear program as it stands in a file: every number is a decimal, every name one that readers take.

use boundfit_exact::{Integer, Rational};

use super::number::finite_decimal;
use crate::model::{Bounds, ObjectiveSense};

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
    /// What all numbers were multiplied with, where not all are finite decimals.
    scale: Option<Integer>,
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
        let mut coefficients: Vec<_> =
            coefficients.into_iter().filter(|(_, value)| !value.is_zero()).collect();
        coefficients.sort_by_key(|(column, _)| *column);
        let numbers =
            || coefficients.iter().map(|(_, value)| *value).chain(&bounds.lower).chain(&bounds.upper);
        let scale = scale_of(numbers());
        let scaled = |value: &Rational| match &scale {
            Some(scale) => value * &Rational::from(scale),
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
        if let Some(scale) = &self.scale {
            remarks.push(format!("{name} is multiplied by {scale}: its numbers have no finite decimals"));
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

/// The least number with which all of these become whole, unless all of them are finite decimals.
fn scale_of<'a>(numbers: impl Iterator<Item = &'a Rational> + Clone) -> Option<Integer> {
    let has_decimals = numbers.clone().all(|value| finite_decimal(value).is_some());
    (!has_decimals).then(|| numbers.fold(Integer::one(), |scale, value| scale.lcm(&value.denominator())))
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
