//! Where the thresholds of the EUI will lie, guessed from some of the readings, so that of the others only those x need to be
//! kept that are there.
//!
//! A guess that turns out to be wrong is known to be, and costs another look at all x; no answer depends on it.

use std::sync::{Arc, RwLock};

use boundfit_exact::{Column, Count, Rational, Scaled};

use super::spread::{Spread, Thresholds};
use crate::line_form::LineForm;
use crate::moments::Sums;

/// By what part of their standard deviation the mean of all x may differ from that of those seen, at least, and in standard
/// errors of the mean; their variance by twice that part. Of evenly spread x some hundredths are kept then.
const LEAST_PART: f64 = 1.0 / 64.0;
const STANDARD_ERRORS: f64 = 8.0;

/// Where each threshold will lie.
#[derive(Debug, PartialEq)]
pub(crate) struct Brackets {
    brackets: [Bracket; 3],
}

/// From `low` to `high`, or from `top` on.
#[derive(Debug, Clone, PartialEq)]
struct Bracket {
    /// `None` is below all x.
    low: Option<Rational>,
    high: Rational,
    /// `None` is above all x.
    top: Option<Rational>,
}

/// What is kept of x once it is guessed where the thresholds lie.
#[derive(Debug, Default)]
pub(crate) struct Narrowed {
    /// What lies above the upper end of each bracket.
    above: Spread,
    /// Every x within a bracket, and maybe others.
    kept: Vec<Column>,
}

impl Brackets {
    /// Around the thresholds of lines of a form, by the sums over some x counted from the form's origin; `None` without a guess.
    pub(crate) fn of_form(form: &LineForm, sums: &Sums) -> Option<Self> {
        let mean = sums.uv.checked_div(&sums.vv)?;
        let variance = sums.uu.checked_div(&sums.vv)? - &mean * &mean;
        let part = LEAST_PART.max(STANDARD_ERRORS / (sums.count as f64).sqrt());
        let margin = Rational::from_f64(variance.to_f64().sqrt() * part)?;
        let [low, high] = [&mean - &margin, &mean + &margin];
        let times = |factor| Some(&variance * &Rational::from_f64(factor)?);
        let [least, most] = [times((1.0 - 2.0 * part).max(0.0))?, times(1.0 + 2.0 * part)?];
        // Σx²/Σx is mean + variance/mean, which has the sign of the mean and jumps where that is 0.
        let second = if low.is_positive() {
            let [low, high] = [&low + least.checked_div(&high)?, &high + most.checked_div(&low)?];
            Bracket { low: Some(low), high, top: None }
        } else if high.is_negative() {
            let [low, high] = [&low + most.checked_div(&high)?, &high + least.checked_div(&low)?];
            Bracket { low: Some(low), high, top: None }
        } else {
            let beyond = least.checked_div(&(mean.abs() + margin)).unwrap_or_default();
            Bracket { low: None, high: -&beyond, top: Some(beyond) }
        };
        let first = Bracket { low: Some(low), high, top: None };
        let zero = Bracket { low: Some(Rational::zero()), high: Rational::zero(), top: None };
        Some(Brackets { brackets: [first, second, zero].map(|bracket| bracket.moved(&form.x_origin)) })
    }

    /// Returns what is kept of a column of x. Exact. Cost: linear; on machine numbers where they are ones.
    pub(crate) fn narrow(&self, x: &Column) -> Narrowed {
        let kept = match x {
            Column::Narrow(x) => {
                let ends = self.in_units(x).map(|end| end.clamp(i64::MIN.into(), i64::MAX.into()) as i64);
                let counts = x.counts().iter().copied().filter(|count| is_within(&ends, count));
                Column::of_counts(counts.map(i128::from), x.unit())
            }
            Column::Wide(x) => {
                let ends = self.in_units(x);
                Column::of_counts(
                    x.counts().iter().copied().filter(|count| is_within(&ends, count)),
                    x.unit(),
                )
            }
            Column::Doubles(x) => {
                // Rounded, and therefore a little wider.
                let number = |end: End| match end {
                    End::Low(end) | End::Top(end) => end.to_f64().next_down(),
                    End::High(end) => end.to_f64().next_up(),
                };
                let ends = self.ends(f64::NEG_INFINITY, f64::INFINITY, number);
                Column::Doubles(x.iter().copied().filter(|x| is_within(&ends, x)).collect())
            }
            Column::Long(_) => (0..x.len()).map(|k| x.get(k)).filter(|x| self.is_within(x)).collect(),
            Column::Fractions(x) => x.iter().filter(|x| self.is_within(x)).cloned().collect(),
        };
        Narrowed { above: self.upper_ends().of_column(x), kept: vec![kept] }
    }

    fn upper_ends(&self) -> Thresholds {
        Thresholds::new(self.brackets.each_ref().map(|bracket| bracket.high.clone()))
    }

    /// The largest numbers of units that are not above the ends.
    fn in_units<I: Count>(&self, x: &Scaled<I>) -> [i128; 9] {
        let unit = x.unit();
        self.ends(i128::MIN, i128::MAX, |end| {
            let (End::Low(end) | End::Top(end) | End::High(end)) = end;
            Thresholds::floor_in_units(end, unit)
        })
    }

    /// Low, high and top of each bracket as numbers of another kind.
    fn ends<N: Copy>(&self, least: N, most: N, number: impl Fn(End) -> N) -> [N; 9] {
        let mut ends = [least; 9];
        for (ends, Bracket { low, high, top }) in ends.as_chunks_mut().0.iter_mut().zip(&self.brackets) {
            let low = low.as_ref().map_or(least, |end| number(End::Low(end)));
            *ends = [low, number(End::High(high)), top.as_ref().map_or(most, |end| number(End::Top(end)))];
        }
        ends
    }

    fn is_within(&self, x: &Rational) -> bool {
        self.brackets.iter().any(|Bracket { low, high, top }| {
            (low.as_ref().is_none_or(|low| x > low) && x <= high) || top.as_ref().is_some_and(|top| x > top)
        })
    }
}

/// An end of a bracket.
enum End<'a> {
    Low(&'a Rational),
    High(&'a Rational),
    Top(&'a Rational),
}

/// Returns whether an x is within one of three brackets. Without branches: this sees every x.
#[inline]
fn is_within<N: PartialOrd>(ends: &[N; 9], x: &N) -> bool {
    let [a, b, c, d, e, f, g, h, i] = ends;
    ((x > a) & (x <= b)) | (x > c) | ((x > d) & (x <= e)) | (x > f) | ((x > g) & (x <= h)) | (x > i)
}

impl Bracket {
    fn moved(self, by: &Rational) -> Self {
        let Bracket { low, high, top } = self;
        Bracket { low: low.map(|end| end + by), high: high + by, top: top.map(|end| end + by) }
    }
}

impl Narrowed {
    /// Adds what is kept of other x.
    pub(crate) fn merge(&mut self, other: Narrowed) {
        self.above = self.above.merged(&other.above);
        self.kept.extend(other.kept.into_iter().filter(|column| !column.is_empty()));
    }

    /// The columns that are kept.
    pub(crate) fn kept(&self) -> &[Column] {
        &self.kept
    }

    /// Returns what of all x lies above the thresholds; `None` unless each is within its bracket. Exact.
    pub(crate) fn spread(&self, brackets: &Brackets, thresholds: &Thresholds) -> Option<Spread> {
        let kept = |thresholds: &Thresholds| {
            let parts = self.kept.iter().map(|column| thresholds.of_column(column));
            parts.fold(Spread::default(), |total, part| total.merged(&part))
        };
        let (above, beyond_ends) = (kept(thresholds), kept(&brackets.upper_ends()));
        let mut are_on_top = [false; 3];
        for ((is_on_top, bracket), threshold) in
            are_on_top.iter_mut().zip(&brackets.brackets).zip(thresholds.values())
        {
            let Bracket { low, high, top } = bracket;
            *is_on_top = top.as_ref().is_some_and(|top| threshold >= top);
            let is_within = low.as_ref().is_none_or(|low| threshold >= low) && threshold <= high;
            if !*is_on_top && !is_within {
                return None;
            }
        }
        Some(above.with(&self.above, &beyond_ends, are_on_top))
    }
}

/// Brackets that all threads use once there are some.
#[derive(Debug, Default)]
pub(crate) struct SharedBrackets {
    current: RwLock<Option<Arc<Brackets>>>,
}

impl SharedBrackets {
    /// Those that there are.
    pub(crate) fn get(&self) -> Option<Arc<Brackets>> {
        self.current.read().ok()?.clone()
    }

    /// Has all threads use these from now on.
    pub(crate) fn set(&self, brackets: Brackets) -> Arc<Brackets> {
        let brackets = Arc::new(brackets);
        if let Ok(mut current) = self.current.write() {
            *current = Some(Arc::clone(&brackets));
        }
        brackets
    }
}

#[cfg(test)]
mod tests {
    use boundfit_exact::Unit;

    use super::*;

    /// Of x in no order, in each kind of column, and a threshold at 0 within them or far away from them.
    #[test]
    fn what_is_kept_tells_what_lies_above_the_thresholds() {
        let scattered = |k: i128| k * k % 20_011 * 7919 % 10_007;
        for origin in [Rational::zero(), Rational::from(5000), Rational::ratio(1, 3)] {
            let form = LineForm { x_origin: origin, through_origin: false };
            for shift in [0, -5003, -4990, -20_000, 1_000_000_000_000] {
                let parts = |kind: usize| {
                    (0..10).map(move |part: i128| {
                        let counts = (0..2000).map(move |k| scattered(2000 * part + k) + shift);
                        match kind {
                            0 => Column::of_counts(counts, Unit::TenTo(-2)),
                            1 => Column::of_counts(counts.map(|count| count << 64), Unit::OneOver(3 << 64)),
                            2 => Column::Doubles(counts.map(|count| count as f64 / 8.0).collect()),
                            _ => counts.map(|count| Rational::ratio(count as i64, 1 << 60)).collect(),
                        }
                    })
                };
                for kind in 0..4 {
                    let sums = |parts: &[Column]| {
                        let sums = parts.iter().map(|x| Sums::of_columns(x, None, x));
                        sums.reduce(|one, other| one.merged(&other)).unwrap().counted_from(&form.x_origin)
                    };
                    let parts: Vec<Column> = parts(kind).collect();
                    let brackets = Brackets::of_form(&form, &sums(&parts[..4])).unwrap();
                    let thresholds = Thresholds::of_form(&form, &sums(&parts));
                    let mut narrowed = Narrowed::default();
                    parts.iter().for_each(|x| narrowed.merge(brackets.narrow(x)));
                    let expected = parts.iter().map(|x| thresholds.of_column(x));
                    let expected = expected.reduce(|one, other| one.merged(&other));
                    assert_eq!(narrowed.spread(&brackets, &thresholds), expected, "{form:?} {shift} {kind}");
                    let kept: usize = narrowed.kept().iter().map(Column::len).sum();
                    assert!(kept < 6000, "{form:?} {shift} {kind}: {kept}");
                }
            }
        }
    }

    #[test]
    fn a_wrong_guess_is_known_to_be_one() {
        let form = LineForm::default();
        let x = |from: i128| Column::of_counts(from..from + 2000, Unit::TenTo(0));
        let sums = |x: &Column| Sums::of_columns(x, None, x);
        let brackets = Brackets::of_form(&form, &sums(&x(0))).unwrap();
        let narrowed = brackets.narrow(&x(0));
        let is_told = |sums: &Sums| narrowed.spread(&brackets, &Thresholds::of_form(&form, sums)).is_some();
        assert!(is_told(&sums(&x(0))) && is_told(&sums(&x(100))));
        assert!(!is_told(&sums(&x(0)).merged(&sums(&x(2000)))));
    }
}
