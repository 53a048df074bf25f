//! ε_min, the smallest error bound for which the FPS is not empty, and its minimiser.

use std::collections::HashMap;

use boundfit_exact::Rational;
use boundfit_geometry::{Inequality, Multiplier, RegionKind, System, envelope};

use crate::bound_name::BoundName;
use crate::condition::Condition;
use crate::fps::{conditions_by_name, growing_half_planes};
use crate::hulls::{Extremes, Gap, HullMinimum};
use crate::least_growth::{GrowingInequality, LeastGrowth, least_growth};
use crate::meaning::ErrorBound;
use crate::measurement::Measurement;
use crate::measurements::Measurements;

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
        let Some(growing) = Growing::new(measurements, conditions) else { return false };
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
        Minimax::with_extremes(measurements, conditions, Extremes::of(measurements).as_ref())
    }

    /// [`Minimax::new`] where the extremes of a line under a uniform bound are known already.
    pub(crate) fn with_extremes(
        measurements: &Measurements,
        conditions: &[Condition],
        extremes: Option<&Extremes>,
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
                let touching = extremes.touching.iter().map(|touching| &rows[touching.position]);
                Growing::of_rows(touching, true).with(conditions).minimax()
            }
            None => Growing::new(measurements, conditions)?.minimax(),
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

/// The half-planes of readings and conditions as functions of the error bound.
pub(crate) struct Growing {
    names: Vec<BoundName>,
    pub(crate) inequalities: Vec<GrowingInequality>,
}

impl Growing {
    /// Collects the readings that decide ε_min; `None` where these are not known.
    fn new(measurements: &Measurements, conditions: &[Condition]) -> Option<Self> {
        let rows = measurements.deciding_minimax().ok()?;
        Some(Growing::of_rows(rows.iter(), measurements.error_bound().is_uniform()).with(conditions))
    }

    pub(crate) fn with(mut self, conditions: &[Condition]) -> Self {
        for (name, at_zero) in conditions_by_name(conditions) {
            self.names.push(name);
            self.inequalities.push(GrowingInequality { at_zero, growth: Rational::zero() });
        }
        self
    }

    /// Collects half-planes that grow; under a uniform bound the factor is the bound itself, so that every reading
    /// grows by 1.
    pub(crate) fn of_rows<'a>(rows: impl Iterator<Item = &'a Measurement>, is_uniform: bool) -> Self {
        let (names, mut inequalities): (_, Vec<GrowingInequality>) =
            rows.flat_map(growing_half_planes).unzip();
        if is_uniform {
            inequalities.iter_mut().for_each(|inequality| inequality.growth = Rational::one());
        }
        Growing { names, inequalities }
    }

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
