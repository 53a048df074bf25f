//! The known bound on the error of a further reading.

use boundfit_estimation::{ErrorBound, Law, Measurements};
use boundfit_exact::{Endpoint, Interval, Rational};
use thiserror::Error;

/// The distance that a further reading y may have from φ·θ: φ·θ lies in [y - below, y + above]. Both are sums of a
/// constant, of a multiple of |x| and of a multiple of |y|.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FurtherError {
    above: Terms,
    below: Terms,
    /// The x, as predictions count it, that the law takes for 0.
    zero_of_x: Rational,
}

#[derive(Debug, Clone, PartialEq, Eq, Default)]
struct Terms {
    constant: Rational,
    of_x: Rational,
    of_y: Rational,
}

/// The reason why nothing is known of the error of a further reading.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum NoFurtherError {
    /// Each reading has its own.
    #[error("each reading has an error bound of its own, so a further one has none yet")]
    PerRow,
    /// Readings are intervals.
    #[error("the readings are intervals, and nothing says how wide a further one is")]
    Interval,
    /// Half a unit of the last digit of what is not written.
    #[error("the law asks for the last digit written, and a further reading is not written yet")]
    Written,
    /// The range of all y is not known, since not all readings are kept.
    #[error("the law asks for the range of y, which is not known when not every reading is kept in memory")]
    Range,
    /// A bound that grows as fast as y bounds nothing.
    #[error("the law allows errors of 100 % of |y| or more, which bounds no further reading")]
    TooWide,
}

impl FurtherError {
    /// One bound, which is not negative.
    pub fn within(epsilon: Rational) -> Self {
        let terms = Terms { constant: epsilon, ..Terms::default() };
        FurtherError { above: terms.clone(), below: terms, zero_of_x: Rational::zero() }
    }

    /// The bound that the readings have, where it says something of a further one.
    ///
    /// # Errors
    /// Why it does not.
    pub fn of(measurements: &Measurements) -> Result<Self, NoFurtherError> {
        match measurements.error_bound() {
            ErrorBound::Uniform(epsilon) => Ok(FurtherError::within(epsilon.clone())),
            ErrorBound::Column(_) => Err(NoFurtherError::PerRow),
            ErrorBound::Interval { .. } => Err(NoFurtherError::Interval),
            ErrorBound::Law(law) => FurtherError::by_law(law, measurements),
        }
    }

    /// Takes the error from a law, which may differ from the law of the readings.
    ///
    /// # Errors
    /// When it says nothing of a further reading.
    pub fn by_law(law: &Law, measurements: &Measurements) -> Result<Self, NoFurtherError> {
        if law.needs_written() {
            return Err(NoFurtherError::Written);
        }
        let range = measurements.range_of_response();
        // Where the range has no say it may be any.
        let other = &range + Rational::one();
        if measurements.all().is_none() && law.terms(&range) != law.terms(&other) {
            return Err(NoFurtherError::Range);
        }
        let [above, below] = law.terms(&range).map(|(constant, multiples)| {
            let of = |name: &str| {
                let own = multiples.iter().find(|(own, _)| *own == name);
                own.map_or_else(Rational::zero, |(_, times)| times.clone())
            };
            Terms { constant, of_x: of("x"), of_y: of("y") }
        });
        if above.of_y >= Rational::one() || below.of_y >= Rational::one() {
            return Err(NoFurtherError::TooWide);
        }
        // A law is about x as it is, wherever it is counted from.
        Ok(FurtherError { above, below, zero_of_x: -&measurements.line_form().x_origin })
    }

    /// The bound, if it is one number for every reading.
    pub fn uniform(&self) -> Option<&Rational> {
        let Terms { constant, of_x, of_y } = &self.above;
        (self.above == self.below && of_x.is_zero() && of_y.is_zero()).then_some(constant)
    }

    /// Returns the interval of a further reading at an x where the lines have these values. Exact.
    pub fn around(&self, line: &Interval, x: &Rational) -> Option<Interval> {
        let size = (x - &self.zero_of_x).abs();
        let lower = line.lower().value().map(|value| {
            let Terms { constant, of_x, of_y } = &self.above;
            solved(value - constant - of_x * &size, of_y)
        });
        let upper = line.upper().value().map(|value| {
            let Terms { constant, of_x, of_y } = &self.below;
            -solved(-(value + constant + of_x * &size), of_y)
        });
        Interval::new(Endpoint::from(lower), Endpoint::from(upper))
    }

    /// Returns the distance that φ·θ may have above and below a reading y, without the multiples of |x|. Exact.
    pub(super) fn without_x(&self, y: &Rational) -> [Rational; 2] {
        let size = y.abs();
        [&self.above, &self.below].map(|terms| &terms.constant + &terms.of_y * &size)
    }

    /// Returns the multiples of |x| above and below.
    pub(super) fn of_x(&self) -> [&Rational; 2] {
        [&self.above.of_x, &self.below.of_x]
    }

    pub(super) fn zero_of_x(&self) -> &Rational {
        &self.zero_of_x
    }
}

/// The y where y + times·|y| is this, for times < 1.
fn solved(value: Rational, times: &Rational) -> Rational {
    let one = Rational::one();
    let slope = if value.is_negative() { one - times } else { one + times };
    value.checked_div(&slope).unwrap_or(value)
}
