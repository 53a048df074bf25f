//! ε_min, the smallest error bound for which the FPS is not empty, and its minimiser.

use std::collections::HashMap;

use boundfit_exact::Rational;
use boundfit_geometry::{Inequality, Multiplier, RegionKind, System, envelope};

use crate::bound_name::BoundName;
use crate::condition::Condition;
use crate::growing::Growing;
use crate::hulls::{Extremes, Gap, HullMinimum};
use crate::least_growth::{GrowingInequality, LeastGrowth, least_growth};
use crate::meaning::ErrorBound;
use crate::measurements::Measurements;
use crate::sieve::{deciding_least, sample};

/// The least error bound that some θ meets, and such a θ: the minimax (Chebyshev, projection) estimate.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Minimax {
    /// The least bound or factor.
    /// - Uniform error bound: ε_min.
    /// - Error bound per reading: the smallest factor s for which the bounds s·ε_i leave a point.
    /// - Intervals: the smallest factor on their widths, about their middles.
    pub least: Rational,
    /// A minimiser: the only one when `unique`, else a point in the relative interior of all of them.
    pub theta: [Rational; 2],
    /// True if there is no other minimiser.
    pub unique: bool,
    /// The reason why nothing smaller will do; empty when `least` is 0.
    pub proof: MinimaxProof,
}

/// The proof that the least error bound is not smaller: positive multiples λ of at most three half-planes a·θ ≤ b +
/// s·growth. They satisfy Σ λ·a = 0, Σ λ·growth = 1 and Σ λ·b = -least. The growth is 1 for a uniform bound, ε_i for
/// a bound per reading, half the width for an interval, and 0 for conditions and readings with one bound. At any
/// smaller bound they are a Farkas certificate of emptiness.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MinimaxProof {
    /// The half-planes with their multipliers.
    pub multipliers: Vec<(BoundName, Rational)>,
}

impl MinimaxProof {
    /// Recomputes the proof from readings and conditions. Exact.
    pub fn verify(&self, measurements: &Measurements, conditions: &[Condition], least: &Rational) -> bool {
        if self.multipliers.is_empty() {
            return least.is_zero();
        }
        let Ok(rows) = measurements.deciding_minimax() else { return false };
        let is_uniform = measurements.error_bound().is_uniform();
        let growing = Growing::of_rows(rows.iter(), is_uniform).with(conditions);
        let mut form = [Rational::zero(), Rational::zero()];
        let (mut growth, mut value) = (Rational::zero(), Rational::zero());
        for (name, multiplier) in &self.multipliers {
            let Some(index) = growing.names.iter().position(|own| own == name) else { return false };
            let GrowingInequality { at_zero, growth: own } = &growing.inequalities[index];
            form = [&form[0] + &at_zero.a[0] * multiplier, &form[1] + &at_zero.a[1] * multiplier];
            growth = growth + own * multiplier;
            value = value + &at_zero.b * multiplier;
        }
        self.multipliers.len() <= 3
            && self.multipliers.iter().all(|(_, multiplier)| multiplier.is_positive())
            && form.iter().all(Rational::is_zero)
            && growth == Rational::one()
            && value == -least
    }
}

impl Minimax {
    /// Returns the least error bound of readings under conditions. Returns `None` when no bound, however large,
    /// leaves a point, and where every reading has one bound only, so that no bound can be multiplied.
    ///
    /// Exact. A line under a uniform bound without conditions takes the two hulls, O(N log N). Every other problem
    /// takes [`least_growth`], which sees only the readings on the hulls for a line under a uniform bound.
    pub fn new(measurements: &Measurements, conditions: &[Condition]) -> Option<Self> {
        Minimax::with_extremes(measurements, conditions, Extremes::of(measurements).as_ref(), None)
    }

    /// [`Minimax::new`] where the extremes of a line under a uniform bound are known already, or the positions of readings in memory
    /// that decide the set in other models.
    pub(crate) fn with_extremes(
        measurements: &Measurements,
        conditions: &[Condition],
        extremes: Option<&Extremes>,
        deciding: Option<&[usize]>,
    ) -> Option<Self> {
        if !measurements.has_widths() {
            return None;
        }
        match extremes {
            Some(Extremes { widest: Some(widest), corners, .. }) if conditions.is_empty() => {
                Some(Minimax::from_hulls(measurements, widest, corners))
            }
            // The reading that a line misses most is on a hull, and so are all that it misses as much.
            Some(extremes) => {
                let rows = measurements.kept();
                let touching = extremes.touching.iter().map(|touching| &rows[touching.position()]);
                Growing::of_rows(touching, true).with(conditions).minimax()
            }
            None => {
                let (rows, is_uniform) =
                    (measurements.deciding_minimax().ok()?, measurements.error_bound().is_uniform());
                // The readings that decide the least factor may be others than those in memory.
                let some = deciding.filter(|_| rows.len() == measurements.kept_count());
                let some = some.map_or_else(|| sample(rows.len()), <[usize]>::to_vec);
                let deciding = deciding_least(rows, &some, is_uniform, conditions);
                let rows = deciding.iter().map(|&position| &rows[position]);
                Growing::of_rows(rows, is_uniform).with(conditions).minimax()
            }
        }
    }

    /// The least factor on the error bounds of the readings that leaves something; `None` when none does, which is so where
    /// the bound is 0 and too small. Exact.
    pub fn least_factor(&self, error_bound: &ErrorBound) -> Option<Rational> {
        match error_bound {
            ErrorBound::Column(_) | ErrorBound::Interval { .. } | ErrorBound::Law(_) => {
                Some(self.least.clone())
            }
            ErrorBound::Uniform(_) if self.least.is_zero() => Some(Rational::zero()),
            ErrorBound::Uniform(epsilon) => self.least.checked_div(epsilon),
        }
    }

    fn from_hulls(measurements: &Measurements, widest: &Gap, corners: &[usize]) -> Self {
        let HullMinimum { epsilon, proof, theta } = widest.minimum(measurements);
        let named = |(position, is_lower, multiplier): (usize, bool, Rational)| {
            let row = measurements.kept_at(position).row;
            (if is_lower { BoundName::Lower(row) } else { BoundName::Upper(row) }, multiplier)
        };
        let mut multipliers: Vec<_> = proof.into_iter().map(named).collect();
        multipliers.sort();
        if epsilon.is_zero() {
            multipliers.clear();
        }
        let proof = MinimaxProof { multipliers };
        match theta {
            Some(theta) => Minimax { least: epsilon, theta, unique: true, proof },
            None => {
                let rows = measurements.kept();
                let corners = corners.iter().map(|&position| &rows[position]);
                Growing::of_rows(corners, true).minimisers(epsilon, proof)
            }
        }
    }
}

impl Growing {
    fn minimax(self) -> Option<Minimax> {
        let LeastGrowth::From { t, multipliers, .. } = least_growth(&self.inequalities) else {
            return None;
        };
        let mut minimax = self.minimisers(t, MinimaxProof { multipliers: Vec::new() });
        if !minimax.least.is_zero() {
            minimax.proof.multipliers = self.proof(&minimax, multipliers);
        }
        Some(minimax)
    }

    /// The multipliers that prove a least bound by name. Where more half-planes are tight at all minimisers than a proof needs,
    /// it is the proof from these alone, so that it does not depend on which others were there.
    fn proof(&self, minimax: &Minimax, found: Vec<Multiplier>) -> Vec<(BoundName, Rational)> {
        let is_tight = |index: &usize| {
            let GrowingInequality { at_zero, growth } = &self.inequalities[*index];
            at_zero.slack(&minimax.theta) + growth * &minimax.least == Rational::zero()
        };
        // Among several half-planes that move alike the first one counts.
        let mut first_of: HashMap<&GrowingInequality, usize> = HashMap::new();
        let mut is_first = |index: &usize| {
            let own = *first_of.entry(&self.inequalities[*index]).or_insert(*index);
            own == *index
        };
        let tight: Vec<usize> =
            (0..self.inequalities.len()).filter(is_tight).filter(|index| is_first(index)).collect();
        let is_found = |Multiplier { index, .. }: &Multiplier| tight.binary_search(index).is_ok();
        let multipliers = if tight.len() == found.len() && found.iter().all(is_found) {
            found
        } else {
            let own: Vec<GrowingInequality> =
                tight.iter().map(|&index| self.inequalities[index].clone()).collect();
            match least_growth(&own) {
                LeastGrowth::From { multipliers, .. } => multipliers
                    .into_iter()
                    .map(|Multiplier { index, value }| Multiplier { index: tight[index], value })
                    .collect(),
                LeastGrowth::Never => found,
            }
        };
        let named = |Multiplier { index, value }: Multiplier| (self.names[index], value);
        let mut multipliers: Vec<_> = multipliers.into_iter().map(named).collect();
        multipliers.sort();
        multipliers
    }

    /// The answer for a least bound: all minimisers are the region that it leaves.
    fn minimisers(&self, least: Rational, proof: MinimaxProof) -> Minimax {
        let at_least = |growing: &GrowingInequality| {
            let [a1, a2] = growing.at_zero.a.clone();
            Inequality::new(a1, a2, &growing.at_zero.b + &growing.growth * &least)
        };
        let system: System = self.inequalities.iter().map(at_least).collect();
        let region = envelope::intersect(&system);
        // At its own least bound the set is not empty.
        let theta = region.witness().expect("empty set at the least error bound").coordinates();
        Minimax { least, theta, unique: region.kind() == RegionKind::Point, proof }
    }
}
