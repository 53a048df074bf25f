//! The worth of an answer.

use boundfit_exact::Rational;

use crate::closeness::{Closeness, RoundedTo, ToleranceUnit};
use crate::outcome::Multiplier;

/// The worth of a claim, from best to worst. Everything from [`Verdict::Loose`] on refutes it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// The claim is the truth.
    Exact,
    /// The claim is off by rounding: to binary64 numbers, or to the digits that it was printed with.
    Rounded,
    /// The bound is off by no more than the tolerance, to either side.
    WithinTolerance,
    /// Nothing was claimed.
    NoAnswer,
    /// The bound is too wide by more than the tolerance: safe, but not the bound.
    Loose,
    /// The claimed point violates a row by more than the tolerance, and than its own rounding explains.
    InfeasiblePoint,
    /// The bound cuts off feasible parameters, by more than the tolerance.
    Unsafe,
    /// The lower end is above the upper end, and not both are right.
    InvertedInterval,
    /// Another status than the program's: empty claimed feasible, bounded claimed unbounded, and so on.
    WrongStatus,
}

impl Verdict {
    /// The name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Verdict::Exact => "exact",
            Verdict::Rounded => "rounded",
            Verdict::WithinTolerance => "within tolerance",
            Verdict::NoAnswer => "no answer",
            Verdict::Loose => "loose",
            Verdict::InfeasiblePoint => "infeasible point",
            Verdict::Unsafe => "unsafe",
            Verdict::WrongStatus => "wrong status",
            Verdict::InvertedInterval => "inverted interval",
        }
    }

    /// Returns what a bound is worth that differs from the true one like this, to the inside or not.
    pub fn of_bound(closeness: Closeness, is_inside: bool) -> Self {
        match closeness {
            Closeness::Exact => Verdict::Exact,
            Closeness::Rounded(_) => Verdict::Rounded,
            Closeness::WithinTolerance => Verdict::WithinTolerance,
            Closeness::Off if is_inside => Verdict::Unsafe,
            Closeness::Off => Verdict::Loose,
        }
    }

    /// Returns whether the claim is refuted.
    pub fn is_refutation(self) -> bool {
        self >= Verdict::Loose
    }
}

/// A row that a claimed point violates.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Violation {
    /// The row.
    pub row: usize,
    /// The amount of the violation, in the units of its right-hand side.
    pub by: Rational,
}

/// The evidence that a claimed status is wrong.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Refutation {
    /// These rows add up to `0 ≤ negative`: there is no feasible point.
    Infeasible(Vec<Multiplier>),
    /// A feasible point.
    FeasiblePoint([Rational; 2]),
    /// These rows add up to the bound: the program is bounded.
    Bound(Vec<Multiplier>),
    /// The form goes on for ever in this direction from this feasible point.
    Ray {
        /// The point.
        theta: [Rational; 2],
        /// The direction.
        ray: [Rational; 2],
    },
}

/// The referee's finding about one end of one interval.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Judgement {
    /// The worth of the claim.
    pub verdict: Verdict,
    /// The true end; `None` when there is none.
    pub exact: Option<Rational>,
    /// True if there is no true end because no point is feasible.
    pub is_empty: bool,
    /// The claimed end.
    pub claimed: Option<Rational>,
    /// The rounding that explains a rounded claim.
    pub rounded_to: Option<RoundedTo>,
    /// The distance of the claim from the true end, positive outside and negative inside.
    pub excess: Option<Rational>,
    /// The excess in units in the last place of binary64 at the true end.
    pub excess_in_ulps: Option<Rational>,
    /// The excess in the unit of the tolerance, and which one that is. Without its sign it is the smallest tolerance that
    /// excuses the claim.
    pub excess_in_units: Option<(Rational, ToleranceUnit)>,
    /// The smallest τ for which the claimed point lies in FPS(ε + τ). `None` without a point, and when the point
    /// violates a condition, which no τ relaxes.
    pub tau: Option<Rational>,
    /// The smallest factor by which some ε must grow for the claimed point, less 1: τ in units of ε.
    pub tau_in_epsilon: Option<Rational>,
    /// The row that the claimed point violates most, in units of its error bound, or of the size of its own terms where
    /// it has none.
    pub violation: Option<Violation>,
    /// A feasible point that an unsafe bound cuts off.
    pub witness: Option<[Rational; 2]>,
    /// The evidence that a status is wrong.
    pub proof: Option<Refutation>,
    /// `true` if the rows with the largest duals prove the true end: the digits were wrong, the basis was not. `None`
    /// without duals.
    pub repairable: Option<bool>,
    /// The solver's own reason for giving no answer, or why its duals are not looked at.
    pub reason: Option<String>,
}

impl Judgement {
    /// The size of the claim's error in proportion: in the unit of the tolerance where there is one, else as it is. `None`
    /// where there is nothing to compare.
    pub fn error(&self) -> Option<(Rational, Option<ToleranceUnit>)> {
        match &self.excess_in_units {
            Some((units, unit)) => Some((units.abs(), Some(*unit))),
            None => Some((self.excess.as_ref()?.abs(), None)),
        }
    }

    /// The largest of the errors of these judgements, in proportion.
    pub fn largest_error<'a>(
        judgements: impl Iterator<Item = &'a Judgement>,
    ) -> Option<(Rational, Option<ToleranceUnit>)> {
        judgements.filter_map(Judgement::error).max_by(|(left, _), (right, _)| left.cmp(right))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn verdicts_from_best_to_worst() {
        let verdicts = [
            (Verdict::Exact, "exact"),
            (Verdict::Rounded, "rounded"),
            (Verdict::WithinTolerance, "within tolerance"),
            (Verdict::NoAnswer, "no answer"),
            (Verdict::Loose, "loose"),
            (Verdict::InfeasiblePoint, "infeasible point"),
            (Verdict::Unsafe, "unsafe"),
            (Verdict::InvertedInterval, "inverted interval"),
            (Verdict::WrongStatus, "wrong status"),
        ];
        assert!(verdicts.is_sorted_by(|(better, _), (worse, _)| better < worse));
        for (rank, (verdict, name)) in verdicts.into_iter().enumerate() {
            assert_eq!((verdict.name(), verdict.is_refutation()), (name, rank >= 4));
        }
    }
}
