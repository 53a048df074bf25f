//! The reason why no line of a side agrees, as demands of the bounds on the slope.

use boundfit_exact::{Rational, Sign};
use boundfit_geometry::Inequality;

use super::{BoxBound, SideSet};

/// The demand of one or two bounds on θ1.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SlopeDemand {
    /// The bounds: one from above and one from below, or one that is about θ1 alone.
    pub bounds: Vec<BoxBound>,
    /// The joint demand of the bounds.
    pub demand: Demand,
}

/// A demand on θ1.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Demand {
    /// A demand that the slope is not less.
    AtLeast(Rational),
    /// A demand that the slope is not more.
    AtMost(Rational),
    /// A demand that no θ1 meets.
    Impossible,
}

impl SideSet {
    /// Returns, for an empty set, at most three bounds that contradict each other, with positive multipliers whose
    /// sum is `0 ≤ negative`.
    pub fn contradiction(&self) -> Option<Vec<(BoxBound, Rational)>> {
        let multipliers = self.farkas()?.into_iter();
        Some(multipliers.map(|own| (self.names[own.index], own.value)).collect())
    }

    /// Returns the demands on the slope of the bounds that contradict each other, which no slope meets together.
    /// Nothing for a set that is not empty. Exact.
    pub fn slope_demands(&self) -> Vec<SlopeDemand> {
        let indices = self.farkas().unwrap_or_default().into_iter().map(|own| own.index);
        let inequalities = self.polyhedron.system().inequalities();
        let bounds: Vec<(BoxBound, &Inequality)> =
            indices.map(|index| (self.names[index], &inequalities[index])).collect();
        let of_sign = |sign: Sign| bounds.iter().filter(move |(_, own)| own.a[1].sign() == sign);
        let alone = of_sign(Sign::Zero).map(|(name, own)| (vec![*name], own.a[0].clone(), own.b.clone()));
        let pairs = of_sign(Sign::Positive).flat_map(|(upper, above)| {
            of_sign(Sign::Negative).map(move |(lower, below)| {
                // Multiples whose sum is without θ2.
                let times = [-&below.a[1], above.a[1].clone()];
                let sum = |one: &Rational, other: &Rational| one * &times[0] + other * &times[1];
                let mut names = vec![*upper, *lower];
                names.sort_unstable();
                (names, sum(&above.a[0], &below.a[0]), sum(&above.b, &below.b))
            })
        });
        let demand = |(bounds, times, bound): (Vec<BoxBound>, Rational, Rational)| {
            let demand = match (bound.checked_div(&times), times.sign()) {
                (Some(end), Sign::Positive) => Demand::AtMost(end),
                (Some(end), _) => Demand::AtLeast(end),
                (None, _) if bound.is_negative() => Demand::Impossible,
                (None, _) => return None,
            };
            Some(SlopeDemand { bounds, demand })
        };
        alone.chain(pairs).filter_map(demand).collect()
    }
}
