//! Numbers as the page shows them: as reports do, with the usual digits.

use boundfit_exact::Rational;
use boundfit_report::{EndRounding, LONGEST_FRACTION, Number, Reader, Style};

/// The style of numbers.
pub(crate) const STYLE: Style = Style {
    digits: None,
    ends: EndRounding::Outward,
    exact: false,
    reader: Reader::Person,
    longest_fraction: LONGEST_FRACTION,
};

/// Significant digits of decimals.
pub(crate) const DIGITS: usize = 5;

/// A point of the parameter plane, each parameter in its style.
pub(crate) fn point(styles: &[Style; 2], theta: &[Rational; 2]) -> [Number; 2] {
    [0, 1].map(|axis| styles[axis].number(&theta[axis]))
}

/// A number in a sentence: with a minus sign in place of the hyphen.
pub(crate) fn with_minus(number: &str) -> String {
    number.replace('-', "−")
}
