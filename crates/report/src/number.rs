//! A number of the JSON documents.

use std::fmt;

use boundfit_exact::{PlacedDecimal, Rational, Rounding};
use serde::ser::{Serialize, SerializeStruct, Serializer};

/// A number in JSON: `{"exact": "p/q", "decimal": "1.8194e-3", "value": 0.0018194243326268529}`. The value is the
/// nearest double, and null beyond the largest one. `exact` is null where the fraction is too long to be written, or
/// there is none. Ends of intervals and error bounds have `outward` too, a double that is not inside. A person gets
/// the decimal without powers of ten and no double. It becomes text only where it is written.
#[derive(Debug, Clone, PartialEq)]
pub struct Number {
    /// The number, or one that rounds like it.
    value: Rational,
    is_exact: bool,
    decimal: DecimalForm,
    outward: Option<Outward>,
    reader: Reader,
}

/// The reader of the numbers in JSON.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Reader {
    /// A program: decimals have powers of ten below 0.1, and the nearest double stands beside them.
    #[default]
    Program,
    /// Somebody to whom a page shows the decimals as they are.
    Person,
}

/// The rounding of the decimal.
#[derive(Debug, Clone, PartialEq, Eq)]
enum DecimalForm {
    Digits(usize, Rounding),
    Placed(PlacedDecimal),
}

/// A double that is not inside.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Outward {
    /// The double of a lower end: below.
    Down,
    /// The double of an upper end or an error bound: above.
    Up,
    /// This double.
    At(f64),
}

impl Number {
    /// A number with a decimal of so many significant digits, rounded in this way.
    pub(crate) fn rounded(value: &Rational, digits: usize, rounding: Rounding, reader: Reader) -> Self {
        let decimal = DecimalForm::Digits(digits, rounding);
        Number { value: value.clone(), is_exact: true, decimal, outward: None, reader }
    }

    /// A number with this decimal.
    pub(crate) fn placed(value: &Rational, decimal: PlacedDecimal, reader: Reader) -> Self {
        let decimal = DecimalForm::Placed(decimal);
        Number { value: value.clone(), is_exact: true, decimal, outward: None, reader }
    }

    /// A number that is no fraction that is written, from one that is rounded like it in this way to so many digits and to binary64.
    pub(crate) fn without_fraction(
        alike: Rational,
        digits: usize,
        rounding: Rounding,
        reader: Reader,
    ) -> Self {
        Number { is_exact: false, ..Number::rounded(&alike, digits, rounding, reader) }
    }

    /// This number with a double that is not inside.
    #[must_use]
    pub(crate) fn outward(self, outward: Outward) -> Self {
        Number { outward: Some(outward), ..self }
    }

    /// Returns whether the fraction is too long to be written.
    pub(crate) fn lacks_fraction(&self) -> bool {
        !self.is_exact
    }

    /// The number, unless its fraction is too long to be written.
    pub(crate) fn exact(&self) -> Option<&Rational> {
        self.is_exact.then_some(&self.value)
    }

    /// Writes the decimal.
    pub(crate) fn write_decimal(&self, out: &mut impl fmt::Write) -> fmt::Result {
        match &self.decimal {
            DecimalForm::Digits(digits, rounding) => {
                let decimal = self.value.decimal(*digits, *rounding);
                if self.reader == Reader::Program { decimal.compact() } else { decimal }.write_to(out)
            }
            DecimalForm::Placed(decimal) => decimal.write_to(out),
        }
    }

    /// The nearest double, and the one that is not inside if there is one; infinite where there is none. `None` for a person.
    pub(crate) fn doubles(&self) -> Option<(f64, Option<f64>)> {
        if self.reader == Reader::Person {
            return None;
        }
        let (nearest, side) = self.value.nearest_f64();
        // One that is rounded to the same double may be on its other side.
        let beside = |outward: Outward| match outward {
            Outward::At(double) => double,
            Outward::Down if side.is_gt() || !self.is_exact => nearest.next_down(),
            Outward::Up if side.is_lt() || !self.is_exact => nearest.next_up(),
            Outward::Down | Outward::Up => nearest,
        };
        // Not -0.0 for 0.
        Some((nearest, self.outward.map(|outward| beside(outward) + 0.0)))
    }
}

impl Serialize for Number {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut fields = serializer.serialize_struct("Number", 4)?;
        fields.serialize_field("exact", &self.exact().map(Written))?;
        fields.serialize_field("decimal", &Written(ShownDecimal(self)))?;
        // No double is finite beyond the largest one, and JSON has no other.
        if let Some((value, outward)) = self.doubles() {
            fields.serialize_field("value", &value)?;
            if let Some(outward) = outward {
                fields.serialize_field("outward", &outward)?;
            }
        }
        fields.end()
    }
}

/// The decimal of a number.
struct ShownDecimal<'a>(&'a Number);

impl fmt::Display for ShownDecimal<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.write_decimal(f)
    }
}

/// Something with a text as a string in JSON, without a `String` between.
struct Written<T>(T);

impl<T: fmt::Display> Serialize for Written<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(&self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zero_has_no_sign() {
        let doubles = [Rational::zero().ceil_to_f64(), Rational::zero().floor_to_f64()];
        assert_eq!(doubles.map(f64::is_sign_negative), [false; 2]);
    }

    #[test]
    fn doubles_enclose_the_number() {
        let huge = Rational::scientific(1, 400);
        for value in
            [Rational::ratio(1, 3), Rational::ratio(-1, 3), Rational::ratio(1, 10), huge.clone(), -&huge]
        {
            let (below, above) = (value.floor_to_f64(), value.ceil_to_f64());
            assert!(Rational::from_f64(below).is_none_or(|double| double <= value), "{value}");
            assert!(Rational::from_f64(above).is_none_or(|double| double >= value), "{value}");
            assert!(above == below.next_up(), "{value}: {below} {above}");
        }
        assert_eq!((Rational::ratio(3, 4).floor_to_f64(), Rational::ratio(3, 4).ceil_to_f64()), (0.75, 0.75));
        assert_eq!((huge.floor_to_f64(), huge.ceil_to_f64()), (f64::MAX, f64::INFINITY));
    }

    #[test]
    fn ends_have_a_double_that_is_not_inside() {
        let shown = |number: &Number| serde_json::to_string(number).unwrap();
        let tenth = Number::rounded(&Rational::ratio(1, 3), 3, Rounding::Nearest, Reader::Program);
        assert_eq!(shown(&tenth), r#"{"exact":"1/3","decimal":"0.333","value":0.3333333333333333}"#);
        let upper = tenth.clone().outward(Outward::Up);
        assert!(shown(&upper).ends_with(r#""value":0.3333333333333333,"outward":0.33333333333333337}"#));
        let lower = tenth.clone().outward(Outward::Down);
        assert!(shown(&lower).ends_with(r#""value":0.3333333333333333,"outward":0.3333333333333333}"#));
        assert!(shown(&tenth.outward(Outward::At(0.5))).ends_with(r#""outward":0.5}"#));
        let huge = Number::rounded(&Rational::scientific(1, 400), 3, Rounding::Up, Reader::Program);
        assert!(shown(&huge.outward(Outward::Up)).ends_with(r#""value":null,"outward":null}"#));
    }
}
