//! Proofs that can be checked by anybody who has the inequalities: `verify` recomputes them from nothing else.

use boundfit_exact::Rational;
use thiserror::Error;

use crate::constructions::value_of;
use crate::point::{Direction, Point};
use crate::system::System;

/// A non-negative multiple of one inequality, in the form in which it was given.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Multiplier {
    /// The index of the inequality.
    pub index: usize,
    /// The number of times that the inequality is taken.
    pub value: Rational,
}

/// The reason why a proof does not hold.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ProofError {
    /// An index beyond the system.
    #[error("there is no inequality with index {0}: the proof is about another system")]
    UnknownInequality(usize),
    /// Multiplying by a negative number turns an inequality around.
    #[error("the multiplier of inequality {0} is not positive")]
    NotPositive(usize),
    /// More multipliers than a proof in the plane needs.
    #[error("{0} multipliers, more than a proof in the plane needs")]
    TooManyMultipliers(usize),
    /// The combination is not about the form that the proof is about.
    #[error("the combined left-hand side is not the one claimed")]
    WrongForm,
    /// The combination does not give the claimed right-hand side.
    #[error("the combined right-hand side is not the one claimed")]
    WrongValue,
    /// The point violates an inequality.
    #[error("the point violates inequality {0}")]
    PointOutside(usize),
    /// The point does not attain the claimed value.
    #[error("the point does not attain the claimed value")]
    NotAttained,
    /// The direction leaves the half-plane.
    #[error("the ray leaves inequality {0}")]
    RayLeaves(usize),
    /// The form does not grow along the ray.
    #[error("the form does not grow along the ray")]
    NotGrowing,
}

/// Proof that a system has no solution (Farkas' lemma): positive multiples of at most three inequalities add up
/// to `0 ≤ b` with `b < 0`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Farkas {
    pub(crate) multipliers: Vec<Multiplier>,
}

impl Farkas {
    /// A certificate from its multipliers; [`Farkas::verify`] tells whether it proves anything.
    pub fn new(multipliers: Vec<Multiplier>) -> Self {
        Farkas { multipliers }
    }

    /// The multipliers, at most three, all positive.
    pub fn multipliers(&self) -> &[Multiplier] {
        &self.multipliers
    }

    /// Recomputes the proof. Exact.
    ///
    /// # Errors
    /// The first statement that is false.
    pub fn verify(&self, system: &System) -> Result<(), ProofError> {
        let (form, value) = combine(system, &self.multipliers, 3)?;
        if form.iter().any(|coefficient| !coefficient.is_zero()) {
            return Err(ProofError::WrongForm);
        }
        if value.is_negative() { Ok(()) } else { Err(ProofError::WrongValue) }
    }
}

/// Proof of `max form·θ = value` (linear programming duality): positive multiples of at most two inequalities
/// add up to `form·θ ≤ value`, and a point of the region attains it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BoundProof {
    /// The linear form that is bounded.
    pub form: [Rational; 2],
    /// The maximum of the form.
    pub value: Rational,
    /// The multipliers, at most two, all positive.
    pub multipliers: Vec<Multiplier>,
    /// The place where the maximum is attained.
    pub attained_at: Point,
}

impl BoundProof {
    /// Recomputes the proof. Exact; one pass over the system.
    ///
    /// # Errors
    /// The first statement that is false.
    pub fn verify(&self, system: &System) -> Result<(), ProofError> {
        let (form, value) = combine(system, &self.multipliers, 2)?;
        if form != self.form {
            return Err(ProofError::WrongForm);
        }
        if value != self.value {
            return Err(ProofError::WrongValue);
        }
        verify_membership(system, &self.attained_at)?;
        if value_of(&self.form, &self.attained_at) == self.value {
            Ok(())
        } else {
            Err(ProofError::NotAttained)
        }
    }
}

/// Proof that a form is unbounded above: a point of the region and a direction that never leaves it, along which
/// the form grows.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnboundedProof {
    /// The linear form that is not bounded.
    pub form: [Rational; 2],
    /// A point of the region.
    pub point: Point,
    /// A recession direction.
    pub ray: Direction,
}

impl UnboundedProof {
    /// Recomputes the proof. Exact; one pass over the system.
    ///
    /// # Errors
    /// The first statement that is false.
    pub fn verify(&self, system: &System) -> Result<(), ProofError> {
        verify_membership(system, &self.point)?;
        let along =
            |a: &[Rational; 2]| &a[0] * Rational::from(self.ray.dx()) + &a[1] * Rational::from(self.ray.dy());
        for (index, inequality) in system.inequalities().iter().enumerate() {
            if along(&inequality.a).is_positive() {
                return Err(ProofError::RayLeaves(index));
            }
        }
        if along(&self.form).is_positive() { Ok(()) } else { Err(ProofError::NotGrowing) }
    }
}

/// Checks that a point satisfies every inequality.
///
/// # Errors
/// The first inequality that it violates.
pub fn verify_membership(system: &System, point: &Point) -> Result<(), ProofError> {
    let theta = point.coordinates();
    match system.inequalities().iter().position(|inequality| inequality.slack(&theta).is_negative()) {
        Some(index) => Err(ProofError::PointOutside(index)),
        None => Ok(()),
    }
}

/// The positive combination of at most `most` inequalities: its left-hand and right-hand side.
fn combine(
    system: &System,
    multipliers: &[Multiplier],
    most: usize,
) -> Result<([Rational; 2], Rational), ProofError> {
    if multipliers.len() > most {
        return Err(ProofError::TooManyMultipliers(multipliers.len()));
    }
    let mut form = [Rational::zero(), Rational::zero()];
    let mut value = Rational::zero();
    for Multiplier { index, value: times } in multipliers {
        let inequality = system.inequalities().get(*index).ok_or(ProofError::UnknownInequality(*index))?;
        if !times.is_positive() {
            return Err(ProofError::NotPositive(*index));
        }
        form = [&form[0] + &inequality.a[0] * times, &form[1] + &inequality.a[1] * times];
        value = value + &inequality.b * times;
    }
    Ok((form, value))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Inequality, Polyhedron, Support};

    /// A multiple of a line's inequality takes the way of any other: it must have the same bounds, proved by as much less of each.
    #[test]
    fn bounds_of_lines_are_those_of_their_multiples() {
        let mut seed = 11_u64;
        let mut draw = |below: u64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 33) as i64 % below as i64
        };
        let times = Rational::ratio(3, 7);
        let forms = [[1, 0], [-1, 0], [0, 1], [0, -1], [2, 3], [-1, 5]].map(|form| form.map(Rational::from));
        let mut bounded = 0;
        for round in 0..600 {
            let mut line = || {
                let (x, y) = (draw(9) - 4, draw(7 + round) - 2);
                let side = 1 - 2 * draw(2);
                Inequality::new(Rational::ratio(side * x, 6), side.into(), Rational::ratio(y, 10))
            };
            let lines: Vec<Inequality> = (0..4 + round % 5).map(|_| line()).collect();
            let multiple = |Inequality { a: [a1, a2], b }: &Inequality| {
                Inequality::new(a1 * &times, a2 * &times, b * &times)
            };
            let [set, other] = [lines.clone(), lines.iter().map(multiple).collect()]
                .map(|own| Polyhedron::intersect(System::new(own)));
            for form in &forms {
                let (Support::Bounded { proof, face }, Support::Bounded { proof: long, face: other_face }) =
                    (set.support(form), other.support(form))
                else {
                    continue;
                };
                assert_eq!(proof.verify(set.system()), Ok(()));
                let expected = long.multipliers.iter().map(|own| (own.index, &own.value * &times));
                assert!(expected.eq(proof.multipliers.iter().map(|own| (own.index, own.value.clone()))));
                assert_eq!(
                    (&proof.value, &proof.attained_at, face),
                    (&long.value, &long.attained_at, other_face)
                );
                bounded += 1;
            }
        }
        assert!(bounded > 500, "{bounded}");
    }
}
