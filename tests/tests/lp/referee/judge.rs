//! The judge: every part of a judgement from its definition, the true ends from the polygon engine.

use boundfit_exact::{Interval, Rational};
use boundfit_geometry::{Polyhedron, Support};
use boundfit_lp::{
    BoundClaim, Claimed, End, Judgement, Multiplier, Printed, RefereeRow, Refutation, RoundedTo, Row,
    ToleranceUnit, Verdict, Violation,
};
use boundfit_tests::lp_cases::system_of;
use boundfit_tests::second_judge::{self, Finding, Said};

/// Rows with what is true about them.
pub struct Judge<'a> {
    rows: &'a [RefereeRow],
    tolerance: &'a Rational,
    polyhedron: Polyhedron,
    ends: Option<[Interval; 2]>,
}

/// The truth about one end.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Truth {
    Empty,
    Unbounded,
    At(Rational),
}

/// A claim without a point.
pub fn claim(claimed: Claimed) -> BoundClaim {
    BoundClaim { claimed, point: None, duals: None }
}

/// A claimed value.
pub fn value(value: &Rational) -> BoundClaim {
    claim(Claimed::Value(value.clone().into()))
}

impl<'a> Judge<'a> {
    pub fn new(rows: &'a [RefereeRow], tolerance: &'a Rational) -> Self {
        let plain: Vec<Row> = rows.iter().map(|row| row.row.clone()).collect();
        let polyhedron = Polyhedron::intersect(system_of(&plain));
        let ends = polyhedron.bounding_box();
        Judge { rows, tolerance, polyhedron, ends }
    }

    pub fn truth(&self, axis: usize, end: End) -> Truth {
        let Some(ends) = &self.ends else { return Truth::Empty };
        let endpoint = match end {
            End::Lower => ends[axis].lower(),
            End::Upper => ends[axis].upper(),
        };
        endpoint.value().map_or(Truth::Unbounded, |value| Truth::At(value.clone()))
    }

    /// The true interval's width, when it is finite.
    pub fn width(&self, axis: usize) -> Option<Rational> {
        let (lower, upper) = self.ends.as_ref()?[axis].ends()?;
        Some(upper - lower)
    }

    /// Compares the judgements about both ends of an interval with what they should be.
    pub fn check(&self, axis: usize, claims: &[BoundClaim; 2], judgements: &[Judgement; 2]) {
        let inverted = match claims {
            [
                BoundClaim { claimed: Claimed::Value(lower), .. },
                BoundClaim { claimed: Claimed::Value(upper), .. },
            ] => {
                let findings = [(End::Lower, lower), (End::Upper, upper)]
                    .map(|(end, claimed)| self.finding(axis, end, claimed));
                second_judge::is_inverted(&said(lower), &said(upper), findings.each_ref().map(Option::as_ref))
            }
            _ => false,
        };
        for (end, (claim, judgement)) in
            [End::Lower, End::Upper].into_iter().zip(claims.iter().zip(judgements))
        {
            let mut expected = self.judge(axis, end, claim);
            if inverted && expected.verdict != Verdict::WrongStatus {
                expected.verdict = Verdict::InvertedInterval;
            }
            let place = || format!("{axis} {end:?} {claim:?}: {judgement:?} of {:?}", self.rows);
            // A finding may have several proofs: the test checks the proof and does not compare it.
            let Judgement { witness, proof, repairable, .. } = judgement.clone();
            let plain = Judgement { witness: None, proof: None, repairable: None, ..judgement.clone() };
            let wanted_witness = expected.witness.take().is_some();
            assert_eq!(plain, expected, "{}", place());
            assert_eq!(proof.is_some(), judgement.verdict == Verdict::WrongStatus, "{}", place());
            assert!(proof.is_none_or(|proof| self.holds(axis, end, &claim.claimed, &proof)), "{}", place());
            assert_eq!(witness.is_some(), wanted_witness, "{}", place());
            if let (Some(witness), Claimed::Value(claimed)) = (witness, &claim.claimed) {
                assert!(self.feasible(&witness), "{}", place());
                let cut_off = match end {
                    End::Lower => witness[axis] < claimed.value,
                    End::Upper => witness[axis] > claimed.value,
                };
                assert!(cut_off, "{}", place());
            }
            assert_eq!(repairable, self.repairable(axis, end, claim), "{}", place());
        }
    }

    /// The second judge's finding about a value, where there is a true end.
    fn finding(&self, axis: usize, end: End, claimed: &Printed) -> Option<Finding> {
        let Truth::At(exact) = self.truth(axis, end) else { return None };
        let truth = second_judge::Truth {
            end: exact,
            width: self.width(axis),
            epsilon: self.epsilon(),
            tolerance: self.tolerance.clone(),
        };
        Some(second_judge::judge_end(&said(claimed), &truth, end == End::Upper))
    }

    /// Returns the expected remark about duals that are not one for each row, or about the first one that is negative
    /// beyond noise.
    fn about_duals(&self, duals: &[f64]) -> Option<String> {
        let rows = self.rows.len();
        if duals.len() != rows {
            let rows = if rows == 1 { "1 row".to_owned() } else { format!("{rows} rows") };
            return Some(format!(
                "the {} duals are not looked at: the program has {rows}, each with one",
                duals.len()
            ));
        }
        let noise = duals.iter().map(|dual| dual.abs()).max_by(f64::total_cmp)? * 1e-6;
        let (place, dual) = (1..).zip(duals).find(|(_, dual)| **dual < -noise)?;
        Some(format!("dual {place} is {dual}, and none below 0 is looked at: each row says a*theta <= b"))
    }

    /// The smallest error bound that is not 0.
    pub fn epsilon(&self) -> Option<Rational> {
        let epsilons = self.rows.iter().filter_map(|row| row.epsilon.clone());
        epsilons.filter(|epsilon| !epsilon.is_zero()).min()
    }

    fn judge(&self, axis: usize, end: End, claim: &BoundClaim) -> Judgement {
        let truth = self.truth(axis, end);
        let mut found = Judgement {
            verdict: Verdict::Exact,
            exact: None,
            is_empty: truth == Truth::Empty,
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
            repairable: None,
            reason: claim.duals.as_deref().and_then(|duals| self.about_duals(duals)),
        };
        if let Truth::At(exact) = &truth {
            found.exact = Some(exact.clone());
        }
        if let Claimed::Value(value) = &claim.claimed {
            found.claimed = Some(value.value.clone());
        }
        match (&truth, &claim.claimed) {
            (_, Claimed::Nothing(reason)) => {
                found.reason = Some(reason.clone());
                found.verdict = Verdict::NoAnswer;
                return found;
            }
            (Truth::At(exact), Claimed::Value(claimed)) => {
                let outward = if end == End::Upper { &claimed.value - exact } else { exact - &claimed.value };
                let finding = self.finding(axis, end, claimed).unwrap();
                found.verdict = verdict_named(finding.verdict);
                found.rounded_to = finding.rounded_to.map(|digits| match digits {
                    None => RoundedTo::Binary64,
                    Some(digits) => RoundedTo::Digits(digits),
                });
                if found.verdict == Verdict::Unsafe {
                    // The choice of the point does not matter here.
                    found.witness = Some([exact.clone(), exact.clone()]);
                }
                found.excess_in_ulps = ulp(exact).and_then(|ulp| outward.checked_div(&ulp));
                found.excess_in_units =
                    self.unit(axis, exact).map(|(unit, name)| (outward.checked_div(&unit).unwrap(), name));
                found.excess = Some(outward);
            }
            (Truth::Empty, Claimed::Infeasible | Claimed::InfeasibleOrUnbounded)
            | (Truth::Unbounded, Claimed::Unbounded | Claimed::InfeasibleOrUnbounded) => {}
            _ => found.verdict = Verdict::WrongStatus,
        }
        if let Some(point) = &claim.point {
            self.judge_point(point, claim, &mut found);
        }
        found
    }

    /// Returns the unit with which errors of an end are compared.
    fn unit(&self, axis: usize, exact: &Rational) -> Option<(Rational, ToleranceUnit)> {
        let width = self.width(axis).map(|width| (width, ToleranceUnit::Width));
        let value = Some((exact.abs(), ToleranceUnit::Value));
        let epsilon = self.epsilon().map(|epsilon| (epsilon, ToleranceUnit::Epsilon));
        [width, value, epsilon].into_iter().flatten().find(|(size, _)| !size.is_zero())
    }

    fn judge_point(&self, printed: &[Printed; 2], claim: &BoundClaim, found: &mut Judgement) {
        let point = &printed.each_ref().map(|coordinate| coordinate.value.clone());
        let excess = |row: &Row| &row.a[0] * &point[0] + &row.a[1] * &point[1] - &row.b;
        let violated: Vec<(usize, Rational, &RefereeRow)> = (self.rows.iter().enumerate())
            .map(|(index, row)| (index, excess(&row.row), row))
            .filter(|(_, excess, _)| excess.is_positive())
            .collect();
        let largest = |values: Option<Vec<Rational>>| {
            values.map(|values| values.into_iter().max().unwrap_or_else(Rational::zero))
        };
        let of_readings =
            |(_, excess, row): &(usize, Rational, &RefereeRow)| row.epsilon.as_ref().map(|_| excess.clone());
        let in_epsilons = |(_, excess, row): &(usize, Rational, &RefereeRow)| {
            row.epsilon.as_ref().and_then(|epsilon| excess.checked_div(epsilon))
        };
        found.tau = largest(violated.iter().map(of_readings).collect());
        found.tau_in_epsilon = largest(violated.iter().map(in_epsilons).collect());
        // Where there is no error bound to compare with, the terms of the row have to do.
        let in_terms = |excess: &Rational, Row { a, b }: &Row| {
            excess.checked_div(&(b.abs() + (&a[0] * &point[0]).abs() + (&a[1] * &point[1]).abs())).unwrap()
        };
        let measures: Vec<Rational> = violated
            .iter()
            .map(|violated| in_epsilons(violated).unwrap_or_else(|| in_terms(&violated.1, &violated.2.row)))
            .collect();
        let Some(most) = measures.iter().max() else { return };
        let first = measures.iter().position(|measure| measure == most).unwrap();
        found.violation = Some(Violation { row: violated[first].0, by: violated[first].1.clone() });
        let said = printed.each_ref().map(said);
        // Who claims that nothing is feasible does not claim that the point is.
        let is_claimed = matches!(claim.claimed, Claimed::Value(_) | Claimed::Unbounded);
        if is_claimed && !self.excuses(&said) {
            found.verdict = found.verdict.max(Verdict::InfeasiblePoint);
        }
    }

    /// Returns whether rounding or the tolerance excuses a point's violations.
    pub fn excuses(&self, point: &[Said; 2]) -> bool {
        let is_excused = |RefereeRow { row, epsilon }: &RefereeRow| {
            second_judge::is_excused(&row.a, &row.b, epsilon.as_ref(), point, self.tolerance)
        };
        self.rows.iter().all(is_excused)
    }

    pub fn feasible(&self, theta: &[Rational; 2]) -> bool {
        let holds = |Row { a, b }: &Row| &a[0] * &theta[0] + &a[1] * &theta[1] <= *b;
        self.rows.iter().all(|row| holds(&row.row))
    }

    /// Returns whether a proof shows that a claim is wrong.
    fn holds(&self, axis: usize, end: End, claimed: &Claimed, proof: &Refutation) -> bool {
        let form = form(axis, end);
        let product = |u: &[Rational; 2], v: &[Rational; 2]| &u[0] * &v[0] + &u[1] * &v[1];
        let sum = |multipliers: &[Multiplier]| {
            assert!(multipliers.iter().all(|multiplier| multiplier.value.is_positive()));
            let total = |part: &dyn Fn(&Row) -> Rational| -> Rational {
                multipliers.iter().map(|m| part(&self.rows[m.row].row) * &m.value).sum()
            };
            ([total(&|row| row.a[0].clone()), total(&|row| row.a[1].clone())], total(&|row| row.b.clone()))
        };
        match proof {
            Refutation::Infeasible(multipliers) => {
                let (left, right) = sum(multipliers);
                left == [Rational::zero(), Rational::zero()] && right.is_negative()
            }
            Refutation::Bound(multipliers) => {
                let (left, right) = sum(multipliers);
                let Truth::At(exact) = self.truth(axis, end) else { return false };
                left == form
                    && right == &form[axis] * exact
                    && matches!(claimed, Claimed::Unbounded | Claimed::InfeasibleOrUnbounded)
            }
            Refutation::FeasiblePoint(theta) => self.feasible(theta) && *claimed == Claimed::Infeasible,
            Refutation::Ray { theta, ray } => {
                self.feasible(theta)
                    && self.rows.iter().all(|row| !product(&row.row.a, ray).is_positive())
                    && product(&form, ray).is_positive()
                    && matches!(claimed, Claimed::Value(_))
            }
        }
    }

    /// Returns whether the two rows with the largest duals alone already bound the end where it is.
    fn repairable(&self, axis: usize, end: End, claim: &BoundClaim) -> Option<bool> {
        let duals = claim.duals.as_ref().filter(|duals| duals.len() == self.rows.len())?;
        let Truth::At(exact) = self.truth(axis, end) else { return None };
        let mut largest: Vec<usize> = (0..duals.len()).filter(|&row| duals[row] > 0.0).collect();
        largest.sort_by(|&i, &j| duals[j].partial_cmp(&duals[i]).unwrap());
        let proves = |rows: &[usize]| {
            let rows: Vec<Row> = rows.iter().map(|&row| self.rows[row].row.clone()).collect();
            let form = form(axis, end);
            match Polyhedron::intersect(system_of(&rows)).support(&form) {
                Support::Bounded { proof, .. } => proof.value == &form[axis] * &exact,
                _ => false,
            }
        };
        Some((1..=2.min(largest.len())).any(|count| proves(&largest[..count])))
    }

    /// A point of the set where an end is attained.
    pub fn attained_at(&self, axis: usize, end: End) -> Option<[Rational; 2]> {
        match self.polyhedron.support(&form(axis, end)) {
            Support::Bounded { proof, .. } => Some(proof.attained_at.coordinates()),
            _ => None,
        }
    }
}

/// Returns the form that is largest at an end: θ at the upper one, -θ at the lower one.
pub fn form(axis: usize, end: End) -> [Rational; 2] {
    let sign = if end == End::Upper { Rational::one() } else { -Rational::one() };
    [0, 1].map(|i| if i == axis { sign.clone() } else { Rational::zero() })
}

/// A claimed number as the second judge takes it.
fn said(printed: &Printed) -> Said {
    let digits = printed.precision.as_ref().map(|precision| (precision.reach.clone(), precision.digits));
    Said { value: printed.value.clone(), printed: digits }
}

/// The verdict of this name.
fn verdict_named(name: &str) -> Verdict {
    let verdicts =
        [Verdict::Exact, Verdict::Rounded, Verdict::WithinTolerance, Verdict::Loose, Verdict::Unsafe];
    *verdicts.iter().find(|verdict| verdict.name() == name).expect("a verdict about a value")
}

/// The distance of neighbouring doubles at a number between two powers of two.
pub fn ulp(value: &Rational) -> Option<Rational> {
    let (mut power, mut exponent) = (Rational::one(), 0);
    let two = Rational::from(2);
    let size = value.abs();
    while power <= size && exponent < 1025 {
        (power, exponent) = (power * &two, exponent + 1);
    }
    while power > size && exponent > -1022 {
        (power, exponent) = (power.half(), exponent - 1);
    }
    (exponent <= 1023).then(|| power * Rational::from_f64(f64::EPSILON).unwrap())
}
