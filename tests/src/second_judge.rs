//! A second judge of claims, written from the table of `docs/verdicts.md` alone. It shares no code with the crate `lp`, and
//! names verdicts as the table does.

use boundfit_exact::Rational;

use crate::lp_cases::ten_to;

/// A claimed number: what its text spells, and where its digits end.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Said {
    /// The number.
    pub value: Rational,
    /// Half a unit of the last digit and the number of digits; `None` for what is meant exactly.
    pub printed: Option<(Rational, usize)>,
}

/// The truth about one end, and what errors are compared with.
#[derive(Debug, Clone)]
pub struct Truth {
    /// The true end.
    pub end: Rational,
    /// The width of the true interval, unless it is infinite.
    pub width: Option<Rational>,
    /// The smallest error bound that is not 0.
    pub epsilon: Option<Rational>,
    /// The tolerance.
    pub tolerance: Rational,
}

/// The verdict on one end, and to what it was rounded if that is what it is: doubles, or so many digits.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// The verdict, as in the table.
    pub verdict: &'static str,
    /// `Some(None)` for doubles.
    pub rounded_to: Option<Option<usize>>,
}

impl Said {
    /// A number that is not printed, such as a double.
    pub fn exactly(value: Rational) -> Self {
        Said { value, printed: None }
    }

    /// Typed text: exact if it is short, whole or a fraction, else precise to its last digit.
    pub fn typed(text: &str, value: Rational) -> Self {
        let text = text.trim().to_ascii_lowercase();
        let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        let is_plain = !text.contains('e') && !text.contains('.');
        let places = digits.split_once('.').map_or(0, |(_, places)| places.len() as i32);
        let significant = digits.replace(['.', '-', '+'], "").trim_start_matches('0').len();
        if text.contains('/') || is_plain || significant < 3 {
            return Said::exactly(value);
        }
        let exponent: i32 = exponent.parse().expect("an exponent is a whole number");
        Said { value, printed: Some((ten_to(exponent - places) * Rational::ratio(1, 2), significant)) }
    }

    /// A number printed by `%.Ng`.
    pub fn general(value: Rational, digits: usize) -> Self {
        let mut first = 0;
        while value.abs() >= ten_to(first + 1) {
            first += 1;
        }
        while !value.is_zero() && value.abs() < ten_to(first) {
            first -= 1;
        }
        let half = ten_to(first + 1 - digits as i32) * Rational::ratio(1, 2);
        Said { printed: (!value.is_zero()).then_some((half, digits)), value }
    }

    /// Returns how far rounding may have moved the number: 4 units in the last place of a double, or half a unit of its last digit.
    fn rounding(&self) -> Rational {
        let ulps = last_place(&self.value).map_or_else(Rational::zero, |ulp| ulp * Rational::from(4));
        let half = self.printed.as_ref().map_or_else(Rational::zero, |(half, _)| half.clone());
        if half > ulps { half } else { ulps }
    }
}

/// The distance from the double next to a number, on the side of 0, to the one after it, away from 0.
fn last_place(value: &Rational) -> Option<Rational> {
    let size = value.abs();
    let mut below = size.to_f64();
    if !below.is_finite() || Rational::from_f64(below)? > size {
        below = below.next_down();
    }
    let above = below.next_up();
    if above.is_finite() {
        return Some(Rational::from_f64(above)? - Rational::from_f64(below)?);
    }
    // Above the largest double, as far as its own steps go.
    let step = Rational::from_f64(below)? - Rational::from_f64(below.next_down())?;
    (size < Rational::from_f64(below)? + &step).then_some(step)
}

/// Returns what a claimed end is worth; `is_upper` says which end it is.
pub fn judge_end(said: &Said, truth: &Truth, is_upper: bool) -> Finding {
    let error = (&said.value - &truth.end).abs();
    let plain = |verdict| Finding { verdict, rounded_to: None };
    if error.is_zero() {
        return plain("exact");
    }
    if last_place(&truth.end).is_some_and(|ulp| error <= ulp * Rational::from(4)) {
        return Finding { verdict: "rounded", rounded_to: Some(None) };
    }
    if let Some((half, digits)) = &said.printed
        && error <= *half
    {
        return Finding { verdict: "rounded", rounded_to: Some(Some(*digits)) };
    }
    // The sizes are the width, then the end itself where the width is 0 or missing, then ε where the end is 0 too.
    let sizes = [truth.width.clone(), Some(truth.end.abs()), truth.epsilon.clone()];
    let unit = sizes.into_iter().flatten().find(|size| !size.is_zero());
    if unit.is_some_and(|unit| error <= unit * &truth.tolerance) {
        return plain("within tolerance");
    }
    let is_outside = if is_upper { said.value > truth.end } else { said.value < truth.end };
    plain(if is_outside { "loose" } else { "unsafe" })
}

/// Returns whether both ends together are an inverted interval: they cross, and one of them is neither exact nor rounded nor within
/// tolerance.
pub fn is_inverted(lower: &Said, upper: &Said, findings: [Option<&Finding>; 2]) -> bool {
    let fine = ["exact", "rounded", "within tolerance"];
    let is_fine = |finding: Option<&Finding>| finding.is_some_and(|finding| fine.contains(&finding.verdict));
    lower.value > upper.value && !findings.into_iter().all(is_fine)
}

/// Returns whether a point may exceed a row by so much. The tolerance excuses it, in units of ε or, where the row has
/// no ε, of the size of the row's own terms. The rounding of the point's coordinates excuses it, too.
pub fn is_excused(
    [a1, a2]: &[Rational; 2],
    b: &Rational,
    epsilon: Option<&Rational>,
    [first, second]: &[Said; 2],
    tolerance: &Rational,
) -> bool {
    let terms = [a1 * &first.value, a2 * &second.value];
    let excess = &terms[0] + &terms[1] - b;
    let unit = epsilon.filter(|epsilon| !epsilon.is_zero()).cloned();
    let unit = unit.unwrap_or_else(|| b.abs() + terms[0].abs() + terms[1].abs());
    !excess.is_positive()
        || excess <= unit * tolerance
        || excess <= a1.abs() * first.rounding() + a2.abs() * second.rounding()
}
