//! The referee: compares claimed ends of the parameter uncertainty intervals with the exact ones.

use boundfit_exact::Rational;
use boundfit_exact::english::counted;

use crate::claim::{BoundClaim, Claimed, End, PuiEnd};
use crate::closeness::{Closeness, Difference, MOST_ULPS, ToleranceUnit, is_below_binary64, ulp};
use crate::outcome::{ExactOutcome, Multiplier};
use crate::printed::Printed;
use crate::program::Row;
use crate::simplex::ExactSimplex;
use crate::verdict::{Judgement, Refutation, Verdict, Violation};

/// A row with the error bound that it contains.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RefereeRow {
    /// The row.
    pub row: Row,
    /// The error bound of the reading behind it; `None` for a condition.
    pub epsilon: Option<Rational>,
}

/// Judges claims about the intervals of θ1 and θ2 over a set of rows.
///
/// Everything is exact: the truth comes from the [`ExactSimplex`], and claims are the numbers that their texts spell.
/// Excuses count in proportion: rounding in units of the last digit, everything else in widths of the interval. With
/// a tolerance of 0 a bound that cuts off feasible parameters by more than rounding is unsafe, however little it cuts
/// off.
///
/// ```
/// use boundfit_exact::Rational;
/// use boundfit_lp::{BoundClaim, Claimed, End, Referee, RefereeRow, Row, Verdict};
///
/// // 0 ≤ θ1 ≤ 1/3, and θ2 as θ1.
/// let rows = [([-1, 0], 0), ([3, 0], 1), ([0, -1], 0), ([0, 3], 1)].map(|(a, b)| {
///     RefereeRow { row: Row { a: a.map(Rational::from), b: Rational::from(b) }, epsilon: None }
/// });
/// let referee = Referee::new(rows.to_vec(), Rational::ratio(1, 1_000_000));
/// let judged = |value: Rational| {
///     let claim = BoundClaim { claimed: Claimed::Value(value.into()), point: None, duals: None };
///     referee.judge(0, End::Upper, &claim).verdict
/// };
/// assert_eq!(judged(Rational::ratio(1, 3)), Verdict::Exact);
/// assert_eq!(judged(Rational::ratio(333, 1000)), Verdict::Unsafe);
/// assert_eq!(judged(Rational::ratio(1, 2)), Verdict::Loose);
/// ```
#[derive(Debug, Clone)]
pub struct Referee {
    rows: Vec<RefereeRow>,
    tolerance: Rational,
    /// The truth about both ends of each parameter.
    truths: [[ExactOutcome; 2]; 2],
}

#[allow(
    clippy::indexing_slicing,
    reason = "parameters are 0 or 1 of arrays of two, and as many duals as rows are asked for before they are looked at"
)]
impl Referee {
    /// Solves the four programs exactly. The tolerance is in units of the intervals' widths for bounds (see
    /// [`ToleranceUnit`] where there is none), of ε for points.
    pub fn new(rows: Vec<RefereeRow>, tolerance: Rational) -> Self {
        let simplex = ExactSimplex::new(rows.iter().map(|row| &row.row));
        let truths = PuiEnd::each(|end| simplex.minimise(&end.objective()));
        Referee { rows, tolerance, truths }
    }

    /// The truth about an end: the program that minimises θ_j (lower end) or -θ_j (upper end), with j = `axis` + 1.
    ///
    /// # Panics
    /// When `axis` is neither 0 nor 1.
    pub fn truth(&self, axis: usize, end: End) -> &ExactOutcome {
        &self.truths[axis][end as usize]
    }

    /// The true end, when there is one. Exact.
    ///
    /// # Panics
    /// When `axis` is neither 0 nor 1.
    pub fn exact_end(&self, axis: usize, end: End) -> Option<Rational> {
        match self.truth(axis, end) {
            ExactOutcome::Optimal { theta, .. } => Some(theta[axis].clone()),
            _ => None,
        }
    }

    /// Judges the claims about both ends of the interval of one parameter, each for itself, and their order. The
    /// order does not matter where both ends are right up to rounding and the tolerance.
    ///
    /// # Panics
    /// When `axis` is neither 0 nor 1.
    pub fn judge_interval(&self, axis: usize, claims: &[BoundClaim; 2]) -> [Judgement; 2] {
        let mut judgements =
            [self.judge(axis, End::Lower, &claims[0]), self.judge(axis, End::Upper, &claims[1])];
        let [lower, upper] = &judgements;
        let is_crossed = lower.claimed.as_ref().zip(upper.claimed.as_ref()).is_some_and(|(l, u)| l > u);
        let is_off = |(end, claim)| {
            self.difference(axis, end, claim).is_none_or(|(found, _)| found.closeness == Closeness::Off)
        };
        if is_crossed && [End::Lower, End::Upper].into_iter().zip(claims).any(is_off) {
            // Where the set is empty, that is the finding: its proof says more than the order of the ends.
            for judgement in
                judgements.iter_mut().filter(|judgement| judgement.verdict != Verdict::WrongStatus)
            {
                judgement.verdict = Verdict::InvertedInterval;
            }
        }
        judgements
    }

    /// Judges what is claimed about one end. Exact. Cost: linear in the rows.
    ///
    /// # Panics
    /// When `axis` is neither 0 nor 1.
    pub fn judge(&self, axis: usize, end: End, claim: &BoundClaim) -> Judgement {
        let mut judgement = Judgement {
            verdict: Verdict::Exact,
            exact: self.exact_end(axis, end),
            is_empty: matches!(self.truth(axis, end), ExactOutcome::Infeasible { .. }),
            claimed: None,
            rounded_to: None,
            excess: None,
            excess_in_ulps: None,
            excess_in_units: None,
            tau: None,
            tau_in_epsilon: None,
            violation: None,
            witness: None,
            proof: None,
            repairable: self.repairable(axis, end, claim.duals.as_deref()),
            reason: claim.duals.as_deref().and_then(|duals| self.unusable(duals)),
        };
        match &claim.claimed {
            Claimed::Nothing(reason) => {
                judgement.verdict = Verdict::NoAnswer;
                judgement.reason = Some(reason.clone());
                return judgement;
            }
            Claimed::Value(value) => judgement.claimed = Some(value.value.clone()),
            Claimed::Infeasible | Claimed::Unbounded | Claimed::InfeasibleOrUnbounded => {}
        }
        judgement.proof = self.contrary(axis, end, &claim.claimed);
        if judgement.proof.is_some() {
            judgement.verdict = Verdict::WrongStatus;
        } else {
            self.judge_value(axis, end, claim, &mut judgement);
        }
        if let Some(point) = &claim.point {
            let is_tolerated = self.judge_point(point, &mut judgement);
            // Who says that there is no feasible point does not claim that this one is feasible.
            let is_claimed = matches!(claim.claimed, Claimed::Value(_) | Claimed::Unbounded);
            if is_claimed && !is_tolerated {
                judgement.verdict = judgement.verdict.max(Verdict::InfeasiblePoint);
            }
        }
        judgement
    }

    /// Returns what shows that a claimed status is not the true one, if it is not.
    fn contrary(&self, axis: usize, end: End, claimed: &Claimed) -> Option<Refutation> {
        let infeasible = matches!(claimed, Claimed::Infeasible | Claimed::InfeasibleOrUnbounded);
        let unbounded = matches!(claimed, Claimed::Unbounded | Claimed::InfeasibleOrUnbounded);
        match self.truth(axis, end) {
            ExactOutcome::Infeasible { multipliers } => {
                (!infeasible).then(|| Refutation::Infeasible(multipliers.clone()))
            }
            ExactOutcome::Unbounded { theta, .. } | ExactOutcome::Optimal { theta, .. }
                if *claimed == Claimed::Infeasible =>
            {
                Some(Refutation::FeasiblePoint(theta.clone()))
            }
            ExactOutcome::Unbounded { theta, ray } => {
                (!unbounded).then(|| Refutation::Ray { theta: theta.clone(), ray: ray.clone() })
            }
            ExactOutcome::Optimal { multipliers, .. } => {
                (infeasible || unbounded).then(|| Refutation::Bound(multipliers.clone()))
            }
        }
    }

    /// The difference between a claimed end and the true one, and what its tolerance is relative to; `None` unless there are
    /// both.
    fn difference(
        &self,
        axis: usize,
        end: End,
        claim: &BoundClaim,
    ) -> Option<(Difference, Option<ToleranceUnit>)> {
        let (Claimed::Value(claimed), Some(exact)) = (&claim.claimed, self.exact_end(axis, end)) else {
            return None;
        };
        let ends = self.exact_end(axis, End::Upper).zip(self.exact_end(axis, End::Lower));
        let width = ends.map(|(upper, lower)| upper - lower);
        let epsilons = self.rows.iter().filter_map(|row| row.epsilon.as_ref());
        let epsilon = epsilons.filter(|epsilon| epsilon.is_positive()).min();
        let (unit, size) = ToleranceUnit::choose(width, &exact, epsilon).unzip();
        Some((Difference::new(claimed, &exact, size.as_ref(), &self.tolerance), unit))
    }

    /// Compares a claimed end with the true one, if there are both.
    fn judge_value(&self, axis: usize, end: End, claim: &BoundClaim, judgement: &mut Judgement) {
        let Some((found, unit)) = self.difference(axis, end, claim) else { return };
        let excess = if end == End::Lower { -found.by } else { found.by };
        let is_inside = excess.is_negative();
        let signed = |size: Rational| if is_inside { -size } else { size };
        judgement.verdict = Verdict::of_bound(found.closeness, is_inside);
        if let Closeness::Rounded(to) = found.closeness {
            judgement.rounded_to = Some(to);
        }
        if judgement.verdict == Verdict::Unsafe
            && let ExactOutcome::Optimal { theta, .. } = self.truth(axis, end)
        {
            judgement.witness = Some(theta.clone());
        }
        judgement.excess_in_ulps = found.in_ulps.map(signed);
        judgement.excess_in_units = found.in_units.map(signed).zip(unit);
        judgement.excess = Some(excess);
    }

    /// Measures a claimed point against every row, and says whether rounding or the tolerance excuses what it violates.
    fn judge_point(&self, point: &[Printed; 2], judgement: &mut Judgement) -> bool {
        let mut tau = Some(Rational::zero());
        let mut in_epsilon = Some(Rational::zero());
        let mut tolerated = true;
        let mut worst: Option<(Rational, Violation)> = None;
        let theta = point.each_ref().map(|coordinate| coordinate.value.clone());
        let reach = point.each_ref().map(reach_of_rounding);
        for (index, RefereeRow { row, epsilon }) in self.rows.iter().enumerate() {
            let by = -row.slack(&theta);
            if !by.is_positive() {
                continue;
            }
            let relative = epsilon.as_ref().and_then(|epsilon| by.checked_div(epsilon));
            // A condition has no error bound to compare with: its own terms have to do.
            let size = || row.b.abs() + (&row.a[0] * &theta[0]).abs() + (&row.a[1] * &theta[1]).abs();
            let measure = relative.clone().or_else(|| by.checked_div(&size())).unwrap_or_else(Rational::one);
            let is_rounding = by <= (&row.a[0] * &reach[0]).abs() + (&row.a[1] * &reach[1]).abs();
            tolerated &= is_rounding || measure <= self.tolerance;
            tau = tau.filter(|_| epsilon.is_some()).map(|tau| tau.max(by.clone()));
            in_epsilon = in_epsilon.zip(relative).map(|(largest, relative)| largest.max(relative));
            if worst.as_ref().is_none_or(|(largest, _)| measure > *largest) {
                worst = Some((measure, Violation { row: index, by }));
            }
        }
        judgement.violation = worst.map(|(_, violation)| violation);
        (judgement.tau, judgement.tau_in_epsilon) = (tau, in_epsilon);
        tolerated
    }

    /// Returns the reason why duals are not, or not all, used. Either they are not one for each row, or one of them
    /// is negative by more than a solver's noise, a millionth of the largest one.
    fn unusable(&self, duals: &[f64]) -> Option<String> {
        const NOISE: f64 = 1e-6;
        if duals.len() != self.rows.len() {
            let (given, rows) = (duals.len(), counted(self.rows.len(), "row", "rows"));
            return Some(format!(
                "the {given} duals are not looked at: the program has {rows}, each with one"
            ));
        }
        let largest = duals.iter().fold(0.0_f64, |largest, dual| largest.max(dual.abs()));
        let row = duals.iter().position(|dual| *dual < -NOISE * largest)?;
        let (dual, place) = (duals[row], row + 1);
        Some(format!("dual {place} is {dual}, and none below 0 is looked at: each row says a*theta <= b"))
    }

    /// Returns whether the one or two rows with the largest duals prove the true end when their multipliers are recomputed.
    fn repairable(&self, axis: usize, end: End, duals: Option<&[f64]>) -> Option<bool> {
        let duals = duals.filter(|duals| duals.len() == self.rows.len())?;
        let ExactOutcome::Optimal { value, .. } = self.truth(axis, end) else { return None };
        let mut order: Vec<usize> = (0..duals.len()).filter(|&row| duals[row] > 0.0).collect();
        order.sort_by(|&i, &j| duals[j].total_cmp(&duals[i]));
        let unit = if end == End::Lower { -Rational::one() } else { Rational::one() };
        let form = [0, 1].map(|i| if i == axis { unit.clone() } else { Rational::zero() });
        let singles = order.iter().take(2).filter_map(|&row| self.multiple(row, &form));
        let pair = order.get(1).and_then(|&second| self.combination(order[0], second, &form));
        let proves = |multipliers: Vec<Multiplier>| {
            let bound: Rational = multipliers.iter().map(|m| &self.rows[m.row].row.b * &m.value).sum();
            multipliers.iter().all(|m| !m.value.is_negative()) && bound == -value
        };
        Some(singles.chain(pair).any(proves))
    }

    fn multiple(&self, row: usize, form: &[Rational; 2]) -> Option<Vec<Multiplier>> {
        let a = &self.rows[row].row.a;
        let value = form[0].checked_div(&a[0]).or_else(|| form[1].checked_div(&a[1]))?;
        let same = [0, 1].iter().all(|&i| &a[i] * &value == form[i]);
        same.then(|| vec![Multiplier { row, value }])
    }

    fn combination(&self, first: usize, second: usize, form: &[Rational; 2]) -> Option<Vec<Multiplier>> {
        let minor = |u: &[Rational; 2], v: &[Rational; 2]| &u[0] * &v[1] - &u[1] * &v[0];
        let (f, g) = (&self.rows[first].row.a, &self.rows[second].row.a);
        let determinant = minor(f, g);
        let value = |numerator: Rational| numerator.checked_div(&determinant);
        Some(vec![
            Multiplier { row: first, value: value(minor(form, g))? },
            Multiplier { row: second, value: value(minor(f, form))? },
        ])
    }
}

/// Returns how far rounding may have moved a coordinate: printing, or the computation in binary64.
fn reach_of_rounding(coordinate: &Printed) -> Rational {
    let ulps = ulp(&coordinate.value).filter(|_| !is_below_binary64(&coordinate.value));
    let ulps = ulps.map(|ulp| ulp * Rational::from(MOST_ULPS));
    coordinate.reach().max(ulps.unwrap_or_default())
}

#[cfg(test)]
mod tests;
