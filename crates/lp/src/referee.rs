//! The referee: compares claimed ends of the parameter uncertainty intervals with the exact ones.

use boundfit_exact::Rational;

use crate::claim::{BoundClaim, Claimed, End, PuiEnd};
use crate::outcome::{ExactOutcome, Multiplier};
use crate::program::{Program, Row};
use crate::simplex::exact_simplex;
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
/// Everything is exact: the truth comes from [`exact_simplex`], and the only tolerance is the one that tells *within
/// tolerance* from *loose* and *infeasible point*. A bound that cuts off feasible parameters by more than rounding is
/// unsafe, however little it cuts off.
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
///     let claim = BoundClaim { claimed: Claimed::Value(value), point: None, duals: None };
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
    /// Solves the four programs exactly. The tolerance is in units of the intervals' widths for bounds, of ε for points.
    pub fn new(rows: Vec<RefereeRow>, tolerance: Rational) -> Self {
        let plain: Vec<Row> = rows.iter().map(|row| row.row.clone()).collect();
        let truths = PuiEnd::each(|end| exact_simplex(&Program { rows: &plain, objective: end.objective() }));
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

    /// Judges what is claimed about both ends of the interval of one parameter: each for itself, and their order.
    ///
    /// # Panics
    /// When `axis` is neither 0 nor 1.
    pub fn judge_interval(&self, axis: usize, claims: &[BoundClaim; 2]) -> [Judgement; 2] {
        let mut judgements =
            [self.judge(axis, End::Lower, &claims[0]), self.judge(axis, End::Upper, &claims[1])];
        if let (Some(lower), Some(upper)) = (&judgements[0].claimed, &judgements[1].claimed)
            && lower > upper
        {
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
            claimed: None,
            excess: None,
            excess_in_widths: None,
            tau: None,
            tau_in_epsilon: None,
            violation: None,
            witness: None,
            proof: None,
            repairable: self.repairable(axis, end, claim.duals.as_deref()),
            reason: None,
        };
        match &claim.claimed {
            Claimed::Nothing(reason) => {
                judgement.verdict = Verdict::NoAnswer;
                judgement.reason = Some(reason.clone());
                return judgement;
            }
            Claimed::Value(value) => judgement.claimed = Some(value.clone()),
            Claimed::Infeasible | Claimed::Unbounded | Claimed::InfeasibleOrUnbounded => {}
        }
        judgement.proof = self.contrary(axis, end, &claim.claimed);
        if judgement.proof.is_some() {
            judgement.verdict = Verdict::WrongStatus;
            return judgement;
        }
        if let Some(value) = judgement.claimed.clone() {
            self.judge_value(axis, end, &value, &mut judgement);
        }
        if let Some(point) = &claim.point {
            self.judge_point(point, &mut judgement);
        }
        judgement
    }

    /// What shows that a claimed status is not the true one, if it is not.
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

    /// Compares a claimed end with the true one.
    fn judge_value(&self, axis: usize, end: End, value: &Rational, judgement: &mut Judgement) {
        let ExactOutcome::Optimal { theta, .. } = self.truth(axis, end) else { return };
        let exact = &theta[axis];
        let excess = match end {
            End::Lower => exact - value,
            End::Upper => value - exact,
        };
        let width = self
            .exact_end(axis, End::Upper)
            .zip(self.exact_end(axis, End::Lower))
            .map(|(upper, lower)| upper - lower);
        judgement.excess_in_widths = width.and_then(|width| excess.checked_div(&width));
        judgement.verdict = if excess.is_zero() {
            Verdict::Exact
        } else if let Some(ulps) = ulps_between(value, exact).filter(|ulps| *ulps <= Verdict::MOST_ULPS) {
            Verdict::Rounded { ulps }
        } else if excess.is_negative() {
            judgement.witness = Some(theta.clone());
            Verdict::Unsafe
        } else if judgement.excess_in_widths.as_ref().is_some_and(|widths| *widths <= self.tolerance) {
            Verdict::WithinTolerance
        } else {
            Verdict::Loose
        };
        judgement.excess = Some(excess);
    }

    /// Tests a claimed point against every row.
    fn judge_point(&self, point: &[Rational; 2], judgement: &mut Judgement) {
        let mut tau = Some(Rational::zero());
        let mut in_epsilon = Some(Rational::zero());
        let mut tolerated = true;
        let mut worst: Option<(Rational, Violation)> = None;
        for (index, RefereeRow { row, epsilon }) in self.rows.iter().enumerate() {
            let by = -row.slack(point);
            if !by.is_positive() {
                continue;
            }
            let relative = epsilon.as_ref().and_then(|epsilon| by.checked_div(epsilon));
            // A condition has no error bound to compare with: its own terms have to do.
            let size = || row.b.abs() + (&row.a[0] * &point[0]).abs() + (&row.a[1] * &point[1]).abs();
            let measure = relative.clone().or_else(|| by.checked_div(&size())).unwrap_or_else(Rational::one);
            tolerated &= measure <= self.tolerance;
            tau = tau.filter(|_| epsilon.is_some()).map(|tau| tau.max(by.clone()));
            in_epsilon = in_epsilon.zip(relative).map(|(largest, relative)| largest.max(relative));
            if worst.as_ref().is_none_or(|(largest, _)| measure > *largest) {
                worst = Some((measure, Violation { row: index, by }));
            }
        }
        let verdict = match &worst {
            None => Verdict::Exact,
            Some(_) if tolerated => Verdict::WithinTolerance,
            Some(_) => Verdict::InfeasiblePoint,
        };
        // A point that is off by rounding does not make a rounded bound any worse.
        let rounded = verdict == Verdict::WithinTolerance && judgement.verdict <= Verdict::WithinTolerance;
        if !rounded {
            judgement.verdict = judgement.verdict.max(verdict);
        }
        judgement.violation = worst.map(|(_, violation)| violation);
        (judgement.tau, judgement.tau_in_epsilon) = (tau, in_epsilon);
    }

    /// Whether the one or two rows with the largest duals prove the true end when their multipliers are recomputed.
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

/// How many steps between neighbouring binary64 numbers lie between the ones nearest to two numbers; `None` when one of
/// them overflows.
fn ulps_between(left: &Rational, right: &Rational) -> Option<u64> {
    let [left, right] = [left.to_f64(), right.to_f64()];
    if !left.is_finite() || !right.is_finite() {
        return None;
    }
    // Binary64 numbers are ordered like their bits, read as sign and magnitude.
    let position = |value: f64| {
        let bits = i128::from(value.to_bits() & (u64::MAX >> 1));
        if value.is_sign_negative() { -bits } else { bits }
    };
    u64::try_from((position(left) - position(right)).abs()).ok()
}

#[cfg(test)]
mod tests;
