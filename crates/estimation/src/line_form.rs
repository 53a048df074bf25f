//! The form of a line: the x that its offset refers to, and whether it has an offset.

use boundfit_exact::{Foreign, Rational};

use crate::measurement::Measurement;

/// The lines that are fitted: y = θ1·(x - origin) + θ2, with θ2 = 0 for lines through the point (origin, 0).
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct LineForm {
    /// The x at which θ2 is the value of the line.
    pub x_origin: Rational,
    /// True if θ2 is known to be 0, so that least squares has one parameter only. The condition `theta2 = 0` that belongs to
    /// it is one of the problem's: [`Problem::through_origin`](crate::Problem::through_origin) sees to both.
    pub through_origin: bool,
}

impl LineForm {
    /// Returns what x is called when it is counted from the origin: `year`, `year - 1980`, `x + 1/3`.
    pub fn abscissa(&self, x: &Foreign) -> Foreign {
        /// Digits of a decimal that is still easier to read than a fraction.
        const MOST_DIGITS: usize = 40;
        let size = self.x_origin.abs();
        let shown = || {
            size.exact_decimal(MOST_DIGITS).map_or_else(|| size.to_string(), |decimal| decimal.to_string())
        };
        match self.x_origin.is_zero() {
            true => x.clone(),
            false => {
                let sign = if self.x_origin.is_negative() { "+" } else { "-" };
                Foreign::from(format!("{} {sign} {}", x.raw(), shown()))
            }
        }
    }

    /// An x counted from the origin. Exact.
    pub(crate) fn counted(&self, x: Rational) -> Rational {
        if self.x_origin.is_zero() { x } else { x - &self.x_origin }
    }

    /// Counts the x of readings from the origin. Exact.
    pub(crate) fn count_rows(&self, rows: &mut [Measurement]) {
        for row in rows {
            row.regressor[0] = self.counted(std::mem::take(&mut row.regressor[0]));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_abscissa_has_a_name() {
        let named = |numerator, denominator| {
            let x_origin = Rational::ratio(numerator, denominator);
            LineForm { x_origin, through_origin: false }.abscissa(&"x".into())
        };
        for (numerator, denominator, name) in
            [(0, 1, "x"), (1980, 1, "x - 1980"), (-5, 2, "x + 2.5"), (-1, 3, "x + 1/3"), (1, 4, "x - 0.25")]
        {
            assert_eq!(named(numerator, denominator), name);
        }
        let digits = "2.123456789012345678912345678901234567";
        let x_origin = boundfit_exact::Reading::Decimal.read(digits, &Default::default()).unwrap();
        let long = LineForm { x_origin, through_origin: false };
        assert_eq!(long.abscissa(&"x".into()).raw(), format!("x - {digits}"));
    }
}
