//! The least total widening: which error bounds must be wider, and by how much.
//!
//! The factors w_i ≥ 1 with |mid y_i - φ_i·θ| ≤ w_i·rad y_i for one θ are to have the least sum. At θ the least
//! factors are max(1, |mid y_i - φ_i·θ| / rad y_i), so the sum is convex and piecewise linear in θ. Some minimiser is
//! a crossing of two of the lines mid y_i - φ_i·θ = ±rad y_i. Conditions, and readings with one bound or no width,
//! hold as they are: nothing of theirs could be multiplied.
//!
//! The method descends from the minimax estimate. It tries the directions along a few lines through θ, of which one
//! descends if any direction does. In that direction it goes to the least sum, past as many lines as necessary. It
//! ends, since the sum becomes less and there are finitely many crossings; a step takes O(n log n), and there are
//! few.
//!
//! Source: N. M. Oskorbin, A. V. Maksimov, S. I. Zhilin, "Construction and analysis of empirical dependencies by the uncertainty
//! centre method" (1998).

use boundfit_estimation::{BoundName, Fit, Measurement, Problem, conditions_by_name, half_planes};
use boundfit_exact::Rational;
use boundfit_geometry::{Direction, Farkas, Inequality, Polyhedron};

use super::descent::{Hard, Local, Soft, line_search, local};
use super::zonotope::combination;

/// The least total widening of the error bounds, with its proof.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Repair {
    /// A θ that meets all bounds once they are wider.
    pub theta: [Rational; 2],
    /// The readings whose factor is above 1, by row.
    pub widened: Vec<Widened>,
    /// The least sum of the factors of all readings that have a width.
    pub total: Rational,
    /// The number of such readings: the sum where nothing has to be wider.
    pub count: usize,
    /// λ_i with |λ_i| ≤ 1 / rad y_i, by row, those that are not 0. With the multipliers of `held` they add up to
    /// nothing: Σ λ_i·φ_i + Σ μ_k·a_k = 0. So no sum of factors is below count - Σ (λ_i·mid y_i + |λ_i|·rad y_i) - Σ
    /// μ_k·b_k, which is `total`.
    pub multipliers: Vec<(usize, Rational)>,
    /// μ_k > 0 of the half-planes a_k·θ ≤ b_k that hold as they are.
    pub held: Vec<(BoundName, Rational)>,
}

/// A reading whose bound must be wider.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Widened {
    /// The data row of the reading.
    pub row: usize,
    /// The factor on the width; more than 1.
    pub factor: Rational,
    /// Half of its width then, which for a reading within ε of y is its error bound.
    pub half_width: Rational,
}

/// The reason why nothing can be repaired.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NoRepair {
    /// Memory does not hold every reading.
    NotInMemory,
    /// The parts that hold as they are contradict each other: at most three half-planes with positive multipliers
    /// whose sum is `0 ≤ negative`.
    Contradiction(Vec<(BoundName, Rational)>),
}

impl Repair {
    /// Returns the least total widening for a problem. Exact. Cost: a few iterations of O(n log n).
    ///
    /// # Errors
    /// When there is none, or not all readings are in memory.
    pub fn of(problem: &Problem, fit: &Fit) -> Result<Self, NoRepair> {
        let all = problem.measurements.all().ok_or(NoRepair::NotInMemory)?;
        let (soft, hard) = terms(all, problem);
        let is_allowed =
            |theta: &[Rational; 2]| hard.iter().all(|own| !own.inequality.slack(theta).is_negative());
        let minimax = fit.minimax.as_ref().map(|minimax| minimax.theta.clone()).filter(is_allowed);
        let mut theta = minimax.map_or_else(|| allowed(&hard), Ok)?;
        let mut here = local(&soft, &hard, &theta);
        if fit.is_empty() {
            while let Some((direction, slope)) = here.descent() {
                theta = line_search(&soft, &hard, &theta, &direction, slope);
                here = local(&soft, &hard, &theta);
            }
            // Where a whole edge is least, to its end: a crossing.
            for _ in 0..2 {
                if let Some(end) = here.flat().iter().find_map(|flat| flat_end(&soft, &hard, &theta, flat)) {
                    theta = end;
                    here = local(&soft, &hard, &theta);
                }
            }
        }
        Ok(answer(&soft, &hard, theta, &here))
    }
}

/// The end of the part of a ray along which nothing changes, if it has one.
fn flat_end(soft: &[Soft], hard: &[Hard], theta: &[Rational; 2], flat: &Direction) -> Option<[Rational; 2]> {
    let end = line_search(soft, hard, theta, flat, Rational::zero());
    (end != *theta).then_some(end)
}

/// The bounds that may be wider, and those that hold as they are.
fn terms(all: &[Measurement], problem: &Problem) -> (Vec<Soft>, Vec<Hard>) {
    let (mut soft, mut hard) = (Vec::new(), Vec::new());
    let held = |(name, inequality): (BoundName, Inequality)| Hard { name, inequality };
    for reading in all {
        let half_width = reading.half_width().filter(|half_width| half_width.is_positive());
        match (half_width, reading.middle()) {
            (Some(half_width), Some(middle)) => soft.push(Soft {
                row: reading.row,
                form: reading.regressor.clone(),
                middle: middle.into_owned(),
                half_width: half_width.into_owned(),
            }),
            _ => hard.extend(half_planes(reading).map(held)),
        }
    }
    hard.extend(conditions_by_name(&problem.conditions).map(held));
    (soft, hard)
}

/// A point that meets what holds as it is.
fn allowed(hard: &[Hard]) -> Result<[Rational; 2], NoRepair> {
    let set = Polyhedron::intersect(hard.iter().map(|own| own.inequality.clone()).collect());
    set.region().witness().map(|point| point.coordinates()).ok_or_else(|| {
        let multipliers = set.region().certificate().map(Farkas::multipliers).unwrap_or_default();
        NoRepair::Contradiction(
            multipliers.iter().map(|own| (hard[own.index].name, own.value.clone())).collect(),
        )
    })
}

/// The factors at a minimiser, and the multipliers that prove them.
fn answer(soft: &[Soft], hard: &[Hard], theta: [Rational; 2], here: &Local) -> Repair {
    let (mut total, mut widened) = (Rational::zero(), Vec::new());
    for term in soft {
        let factor = term.factor(&theta);
        if factor > Rational::one() {
            let half_width = &factor * &term.half_width;
            widened.push(Widened { row: term.row, factor: factor.clone(), half_width });
        }
        total = total + factor.max(Rational::one());
    }
    let (mut multipliers, mut held) = (Vec::new(), Vec::new());
    // Where nothing is wider, 0 ≤ 0 proves it.
    if !widened.is_empty() {
        for (term, side) in here.outside(soft) {
            multipliers.push((term.row, side.over(&term.half_width)));
        }
        let vectors: Vec<_> = here.soft_active(soft).map(|(term, side)| term.gradient(side)).collect();
        let limits: Vec<_> = here.hard_active(hard).map(|own| own.inequality.a.clone()).collect();
        let weights = combination(&here.opposite_gradient(), &vectors, &limits).unwrap_or_default();
        let (own, of_limits) = weights.split_at(vectors.len().min(weights.len()));
        for ((term, side), weight) in here.soft_active(soft).zip(own).filter(|(_, weight)| !weight.is_zero())
        {
            multipliers.push((term.row, side.over(&term.half_width) * weight));
        }
        held.extend(
            here.hard_active(hard)
                .zip(of_limits)
                .filter(|(_, weight)| !weight.is_zero())
                .map(|(own, weight)| (own.name, weight.clone())),
        );
    }
    multipliers.sort();
    held.sort();
    Repair { theta, widened, total, count: soft.len(), multipliers, held }
}
