//! Laws by which data sheets state error bounds: `0.05%*|y| + 2e-3`, `1%*range(y)`, `written`, `+0.2/-0.1`.

use boundfit_exact::{Foreign, Limits, Rational, Reading};

use crate::measurement::{Bounds, Measurement};
use crate::terms::{ParseBoundError, Terms, parse_terms};

/// The largest distance of φ·θ from each y, as a sum of multiples of known quantities of the reading.
///
/// A law that is the same above and below y bounds |e|; `+a/-b` says that φ·θ lies in [y - b, y + a].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Law {
    text: Foreign,
    above: Terms,
    below: Option<Terms>,
}

impl Law {
    /// Reads a law: a sum of numbers and of multiples of four quantities, with `%` for hundredths and `ppm` for millionths.
    /// - `|y|` and `|x|`
    /// - `range(y)`: largest less smallest y of the fitted readings
    /// - `written`: half a unit of the last digit written of y
    ///
    /// The form `+SUM/-SUM` gives other bounds above y than below. Numbers are read as `reading` says, all else is
    /// exact.
    ///
    /// # Errors
    /// With the position where the text stops making sense.
    pub fn parse(text: &str, reading: Reading, limits: &Limits) -> Result<Self, ParseBoundError> {
        let (above, below) = parse_terms(text, reading, limits)?;
        Ok(Law { text: text.trim().into(), above, below })
    }

    /// The law as it was written.
    pub fn text(&self) -> &Foreign {
        &self.text
    }

    /// The name of y, and the law as it was written. If another column has the name `x` or `y`, names of columns stand in place of
    /// x and y: `|U|`.
    pub(crate) fn in_names_of(&self, regressors: &[Foreign], y: &Foreign) -> [Foreign; 2] {
        let is_other = regressors.iter().any(|x| x.raw() == "y") || y.raw() == "x";
        let Some(x) = regressors.first().filter(|_| is_other) else {
            return ["y".into(), self.text.clone()];
        };
        let (mut named, mut rest) = (String::new(), self.text.raw());
        while let Some(own) = rest.chars().next() {
            let quantity = ["|y|", "|x|", "(y)", "(x)"].into_iter().find(|words| rest.starts_with(words));
            let length = quantity.map_or(own.len_utf8(), str::len);
            let (words, after) = rest.split_at(length);
            match quantity {
                None => named.push_str(words),
                Some(_) => named.extend(words.chars().map(|own| match own {
                    'y' => y.raw().to_owned(),
                    'x' => x.raw().to_owned(),
                    other => other.to_string(),
                })),
            }
            rest = after;
        }
        [y.clone(), named.into()]
    }

    /// The law in the only way in which laws that say the same of every reading are written here, with exact numbers:
    /// `1/20*|y| + 1/500`.
    #[cfg(feature = "files")]
    pub(crate) fn formula(&self) -> String {
        match &self.below {
            None => self.above.formula(),
            Some(below) => format!("+({}) -({})", self.above.formula(), below.formula()),
        }
    }

    /// Returns whether half units of last digits are asked for.
    pub fn needs_written(&self) -> bool {
        self.parts().any(|terms| !terms.written.is_zero())
    }

    /// Returns whether the range of y is asked for, which is known when all readings are.
    #[cfg(feature = "files")]
    pub fn needs_range(&self) -> bool {
        self.parts().any(|terms| !terms.of_range.is_zero())
    }

    /// Returns whether |x| is asked for, which two regressors do not have.
    pub fn needs_x(&self) -> bool {
        self.parts().any(|terms| !terms.of_x.is_zero())
    }

    /// Returns whether the bound above y is another one than that below.
    pub fn is_asymmetric(&self) -> bool {
        self.below.is_some()
    }

    /// Returns whether one number bounds all errors.
    pub fn is_uniform(&self) -> bool {
        self.below.is_none()
            && [&self.above.of_y, &self.above.of_x, &self.above.written].into_iter().all(Rational::is_zero)
    }

    /// The bound on all errors when y has this range, of a law that is uniform. Exact.
    pub fn uniform_bound(&self, range: &Rational) -> Rational {
        &self.above.constant + &self.above.of_range * range
    }

    /// Returns how many times the range of y is taken above and below.
    #[cfg(any(feature = "files", test))]
    fn of_range(&self) -> [&Rational; 2] {
        [&self.above.of_range, &self.below.as_ref().unwrap_or(&self.above).of_range]
    }

    /// Returns what a reading y at x says under this law but for its multiples of the range of y, which [`Law::widen`] adds when all
    /// readings are known. Exact.
    pub(crate) fn bounds(&self, x: &Rational, y: Rational, written: &Rational) -> Bounds {
        let above = self.above.at(x, &y, written);
        match &self.below {
            None => Bounds::Around { response: y, epsilon: above },
            Some(below) => {
                let (lower, upper) = (&y - below.at(x, &y, written), &y + above);
                Bounds::Between { lower: Some(lower), upper: Some(upper), response: Some(y) }
            }
        }
    }

    /// Adds the multiples of the range of y to what readings say. Exact.
    #[cfg(any(feature = "files", test))]
    pub(crate) fn widen(&self, rows: &mut [Measurement], range: &Rational) {
        let [above, below] = self.of_range().map(|times| times * range);
        if above.is_zero() && below.is_zero() {
            return;
        }
        for row in rows {
            match &mut row.bounds {
                Bounds::Around { epsilon, .. } => *epsilon = &*epsilon + &above,
                Bounds::Between { lower, upper, .. } => {
                    *lower = lower.as_ref().map(|lower| lower - &below);
                    *upper = upper.as_ref().map(|upper| upper + &above);
                }
            }
        }
    }

    /// Returns what is taken above y and what below: a constant, when y has this range, and how many times |y|, |x| and `written` are.
    pub fn terms(&self, range: &Rational) -> [(Rational, Vec<(&'static str, Rational)>); 2] {
        [&self.above, self.below.as_ref().unwrap_or(&self.above)].map(|terms| {
            let multiples = [("y", &terms.of_y), ("x", &terms.of_x), ("written", &terms.written)];
            let multiples = multiples.into_iter().filter(|(_, times)| !times.is_zero());
            let constant = &terms.constant + &terms.of_range * range;
            (constant, multiples.map(|(name, times)| (name, times.clone())).collect())
        })
    }

    fn parts(&self) -> impl Iterator<Item = &Terms> {
        [&self.above].into_iter().chain(&self.below)
    }
}

/// The largest less the smallest y of readings; 0 without any. Exact.
pub(crate) fn range_of_y(rows: &[Measurement]) -> Rational {
    let responses = || rows.iter().filter_map(Measurement::response);
    match (responses().max(), responses().min()) {
        (Some(most), Some(least)) => most - least,
        _ => Rational::zero(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lower and upper bound of y = -20 at x = 3 with half a unit of 1/2, and a range of y of 10.
    fn at_a_reading(text: &str) -> [Rational; 2] {
        let law = Law::parse(text, Reading::Decimal, &Limits::default()).unwrap();
        let regressor = [Rational::from(3), Rational::one()];
        let bounds = law.bounds(&regressor[0], Rational::from(-20), &Rational::ratio(1, 2));
        let mut rows = [Measurement { row: 1, regressor, bounds }];
        law.widen(&mut rows, &Rational::from(10));
        [rows[0].lower().unwrap(), rows[0].upper().unwrap()]
    }

    #[test]
    fn laws_are_evaluated_exactly() {
        let ratio = Rational::ratio;
        for (text, below, above) in [
            ("0.05%*|y| + 2e-3", ratio(12, 1000), ratio(12, 1000)),
            ("1/3", ratio(1, 3), ratio(1, 3)),
            ("2%*range(y)", ratio(1, 5), ratio(1, 5)),
            ("35ppm*|y| + 50 ppm*range(y)", ratio(12, 10_000), ratio(12, 10_000)),
            ("written", ratio(1, 2), ratio(1, 2)),
            ("6*written+1%*|y|", ratio(32, 10), ratio(32, 10)),
            ("1/7 * |x| + |x|", ratio(24, 7), ratio(24, 7)),
            ("1e+2%*|y|", ratio(20, 1), ratio(20, 1)),
            ("0", ratio(0, 1), ratio(0, 1)),
            ("+0.2/-0.1", ratio(1, 10), ratio(2, 10)),
            (" + 1/3 / - 1/4 ", ratio(1, 4), ratio(1, 3)),
            ("+0.2+written/-5%*|y| + range(y)", ratio(11, 1), ratio(7, 10)),
            ("+0/-written", ratio(1, 2), ratio(0, 1)),
        ] {
            let y = Rational::from(-20);
            assert_eq!(at_a_reading(text), [&y - below, &y + above], "{text}");
        }
    }
}
