//! Numbers as texts spell them, with the precision that their writers gave them.

use boundfit_exact::{Rational, WrittenDigits};

/// A number exactly as a text spells it, and how precisely it was printed.
///
/// ```
/// use boundfit_exact::Rational;
/// use boundfit_lp::{NumberFormat, Printed};
///
/// // 23/7 as HiGHS prints it, down to the 13th decimal.
/// let value = Rational::scientific(32857142857143_i64, -13);
/// let highs = Printed::by_writer("3.2857142857143", value, NumberFormat::HIGHS);
/// let precision = highs.precision.unwrap();
/// assert_eq!((precision.digits, precision.reach), (14, Rational::scientific(5, -14)));
/// // What somebody typed: four digits after the point. Short numbers are meant exactly.
/// let typed = |text, value| Printed::typed(text, value).precision.map(|precision| precision.digits);
/// assert_eq!(typed("1.7909e-3", Rational::scientific(17909, -7)), Some(5));
/// assert_eq!(typed("0.05", Rational::ratio(1, 20)), None);
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Printed {
    /// The number that the text spells.
    pub value: Rational,
    /// The precision of the print; `None` for what is meant exactly: fractions, binary64 numbers, short numbers.
    pub precision: Option<Precision>,
}

/// The precision with which a number was printed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Precision {
    /// The significant digits that its writer prints; zeros dropped at the end count. 0 for a zero.
    pub digits: usize,
    /// The largest distance between the number that was meant and the one that was printed: half a unit of the last digit. For a zero
    /// that stands for all small numbers, how large these may be.
    pub reach: Rational,
}

/// The way in which a program prints its numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NumberFormat {
    /// A number of significant digits, as `%.15g` of C does. Zeros at the end are dropped.
    Significant(usize),
    /// Down to this power of ten, with at most so many significant digits. Zeros at the end are dropped, and what is smaller
    /// is printed as 0.
    DownTo {
        /// The power of ten of the last digit.
        place: i64,
        /// The most significant digits.
        most: usize,
    },
}

impl NumberFormat {
    /// GLPK's solutions for programs (`glp_write_sol`, `%.*g` with `DBL_DIG`) and SCIP's solutions (`%.15g`).
    pub const FIFTEEN: NumberFormat = NumberFormat::Significant(15);
    /// Gurobi's and MIPLIB's solutions, which have all digits of a binary64 number.
    pub const SEVENTEEN: NumberFormat = NumberFormat::Significant(17);
    /// CBC's solutions (`%15.8g`).
    pub const EIGHT: NumberFormat = NumberFormat::Significant(8);
    /// Tables for people of GLPK (`%13.6g`) and HiGHS (`%12g`).
    pub const SIX: NumberFormat = NumberFormat::Significant(6);
    /// HiGHS's solutions: `highsDoubleToString` with a tolerance of 1e-13.
    pub const HIGHS: NumberFormat = NumberFormat::DownTo { place: -13, most: 16 };

    /// The power of ten of the last digit that is printed of a number; `None` where a zero is just that.
    fn last_place(self, value: &Rational) -> Option<i64> {
        let place_of = |digits: usize| {
            let digits = i64::try_from(digits).unwrap_or(i64::MAX);
            value.decimal_exponent().map(|first| first.saturating_sub(digits.saturating_sub(1)))
        };
        match self {
            NumberFormat::Significant(digits) => place_of(digits),
            NumberFormat::DownTo { place, most } => Some(place_of(most).unwrap_or(place).max(place)),
        }
    }
}

impl Printed {
    /// A number that is meant exactly.
    pub fn exact(value: Rational) -> Self {
        Printed { value, precision: None }
    }

    /// Returns the precision of a number that somebody typed, by its text. It is precise to the last digit written,
    /// if the text has a decimal mark or an exponent and at least three significant digits; otherwise it is exact.
    pub fn typed(text: &str, value: Rational) -> Self {
        let digits =
            WrittenDigits::of(text, None).filter(|digits| !digits.is_whole && digits.significant >= 3);
        let precision = digits.map(|digits| Precision::down_to(&value, digits.last_place));
        Printed { value, precision }
    }

    /// Returns the precision of a number in the file of a program that prints its numbers like this. It is precise to
    /// the last digit that the program can print, or to the last one written where that is finer. A fraction is
    /// exact.
    pub fn by_writer(text: &str, value: Rational, format: NumberFormat) -> Self {
        let Some(digits) = WrittenDigits::of(text, None) else { return Printed::exact(value) };
        let place = format.last_place(&value);
        // Without a point a digit may be a zero that fills up.
        let place = place.map(|place| if digits.is_whole { place } else { place.min(digits.last_place) });
        let mut precision = place.map(|place| Precision::down_to(&value, place));
        if let (NumberFormat::DownTo { place, .. }, Some(precision), true) =
            (format, &mut precision, value.is_zero())
        {
            precision.reach = Rational::scientific(1, place);
        }
        Printed { value, precision }
    }

    /// The 0 of a variable that a program leaves out because it is at most this large.
    pub fn left_out(largest: Rational) -> Self {
        Printed { value: Rational::zero(), precision: Some(Precision { digits: 0, reach: largest }) }
    }

    /// The number alone, meant exactly.
    #[must_use]
    pub fn without_precision(self) -> Self {
        Printed::exact(self.value)
    }

    /// Returns how far the number that was meant may be from the one printed; 0 for what is meant exactly.
    pub fn reach(&self) -> Rational {
        self.precision.as_ref().map(|precision| precision.reach.clone()).unwrap_or_default()
    }
}

impl From<Rational> for Printed {
    fn from(value: Rational) -> Self {
        Printed::exact(value)
    }
}

impl Precision {
    /// Returns the precision of a number whose last digit stands for this power of ten.
    fn down_to(value: &Rational, place: i64) -> Self {
        let digits =
            value.decimal_exponent().map_or(0, |first| first.saturating_sub(place).saturating_add(1));
        Precision {
            digits: usize::try_from(digits).unwrap_or(0),
            reach: Rational::scientific(5, place.saturating_sub(1)),
        }
    }
}

#[cfg(test)]
mod tests {
    use boundfit_exact::{Limits, Reading};

    use super::*;

    fn number(text: &str) -> Rational {
        Reading::Decimal.read(text, &Limits::default()).unwrap()
    }

    fn found(printed: Printed) -> Option<(usize, Rational)> {
        printed.precision.map(|precision| (precision.digits, precision.reach))
    }

    #[test]
    fn typed_texts_are_precise_to_their_last_digit() {
        for (text, digits, reach) in [
            ("1.7909e-3", 5, "5e-8"),
            ("-7.862", 4, "5e-4"),
            ("0.00100", 3, "5e-6"),
            ("100.", 3, "0.5"),
            ("123e4", 3, "5000"),
            ("1.50", 3, "5e-3"),
        ] {
            let printed = Printed::typed(text, number(text));
            assert_eq!(printed.reach(), number(reach), "{text}");
            assert_eq!(found(printed), Some((digits, number(reach))), "{text}");
        }
        for text in ["123", "123456789", "1/15", "-10/3", "0.05", "1.5", "1e-6", "0.000", "0", "2.5e7"] {
            let printed = Printed::typed(text, number(text));
            assert_eq!((printed.reach(), found(printed)), (Rational::zero(), None), "{text}");
        }
    }

    #[test]
    fn files_are_precise_to_the_last_digit_that_their_writer_prints() {
        for (text, format, digits, reach) in [
            ("0.00179089203479447", NumberFormat::FIFTEEN, 15, "5e-18"),
            // Zeros at the end are dropped, and fill up where there is no point.
            ("0.25", NumberFormat::FIFTEEN, 15, "5e-16"),
            ("3", NumberFormat::FIFTEEN, 15, "5e-15"),
            ("-1200", NumberFormat::SIX, 6, "0.005"),
            ("1.5e+20", NumberFormat::FIFTEEN, 15, "500000"),
            ("0.0017908920", NumberFormat::EIGHT, 8, "5e-11"),
            // More digits than expected are not thrown away.
            ("0.1234567890123456789", NumberFormat::FIFTEEN, 19, "5e-20"),
            ("3.2857142857143", NumberFormat::HIGHS, 14, "5e-14"),
            ("3.25", NumberFormat::HIGHS, 14, "5e-14"),
            ("0.0017908920348", NumberFormat::HIGHS, 11, "5e-14"),
            ("123456.1234567891", NumberFormat::HIGHS, 16, "5e-11"),
            ("1e-13", NumberFormat::HIGHS, 1, "5e-14"),
            // A zero stands for all that is smaller than its last digit.
            ("0", NumberFormat::HIGHS, 0, "1e-13"),
        ] {
            let printed = Printed::by_writer(text, number(text), format);
            assert_eq!(found(printed), Some((digits, number(reach))), "{text}");
        }
        for (text, format) in
            [("0", NumberFormat::FIFTEEN), ("-0", NumberFormat::SIX), ("1/3", NumberFormat::HIGHS)]
        {
            assert_eq!(found(Printed::by_writer(text, number(text), format)), None, "{text}");
        }
        let left_out = Printed::left_out(number("1e-9"));
        assert_eq!((left_out.reach(), left_out.value.clone()), (number("1e-9"), Rational::zero()));
        assert_eq!(left_out.without_precision(), Printed::from(Rational::zero()));
    }
}
