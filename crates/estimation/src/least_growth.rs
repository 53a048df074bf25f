//! The smallest t for which growing half-planes have a common point: a linear program in three variables, solved
//! exactly with the plane engine.

use boundfit_exact::{Integer, Rational};
use boundfit_geometry::{Inequality, Multiplier, Polyhedron, Support, System};

/// `a·θ ≤ b + t·growth` with `growth ≥ 0`.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct GrowingInequality {
    /// The inequality at t = 0.
    pub at_zero: Inequality,
    /// The growth of its right-hand side; not negative.
    pub growth: Rational,
}

/// The answer for a system of growing half-planes.
#[derive(Debug, Clone, PartialEq, Eq)]
#[allow(clippy::large_enum_variant, reason = "one per fit")]
pub enum LeastGrowth {
    /// The least t from which on there is a common point.
    From {
        /// The least t, at least 0.
        t: Rational,
        /// A common point at the least t; there may be others.
        theta: [Rational; 2],
        /// The multipliers, at most three, that prove the least t, if t > 0: Σ λ·a = 0, Σ λ·growth = 1, Σ λ·b = -t.
        multipliers: Vec<Multiplier>,
    },
    /// The half-planes that do not grow contradict each other.
    Never,
}

/// The smallest t ≥ 0 for which the inequalities have a common point. Exact.
///
/// This is a cutting-plane method. The optimum of the constraints seen so far is tested against all constraints, and
/// the most violated one joins them. Since the old optimum violates that constraint, some new optimum lies on its
/// boundary. On that boundary two variables are left, and the plane engine maximises over them. The optimum never
/// falls and no constraint joins twice, so it ends; in practice after a dozen rounds. Cost of a round: linear in the
/// number of inequalities, plus O(k log k) for k constraints seen.
pub fn least_growth(inequalities: &[GrowingInequality]) -> LeastGrowth {
    let integer_rows: Vec<IntegerRow> = inequalities.iter().map(IntegerRow::new).collect();
    let mut seen: Vec<usize> = Vec::new();
    let mut theta = [Rational::zero(), Rational::zero()];
    let mut t = Rational::zero();
    let mut multipliers = Vec::new();
    while let Some(worst) = most_violated(&integer_rows, &theta, &t) {
        let optimum = if inequalities[worst].growth.is_positive() {
            on_growing_boundary(inequalities, &seen, worst)
        } else {
            on_fixed_boundary(inequalities, &seen, worst)
        };
        let Some((new_theta, new_t, proof)) = optimum else {
            return LeastGrowth::Never;
        };
        (theta, t, multipliers) = (new_theta, new_t, proof);
        seen.push(worst);
    }
    LeastGrowth::From { t, theta, multipliers }
}

type Optimum = ([Rational; 2], Rational, Vec<Multiplier>);

/// The least t on the boundary a·θ = b + t·growth of a half-plane that grows: t follows from θ.
fn on_growing_boundary(inequalities: &[GrowingInequality], seen: &[usize], tight: usize) -> Option<Optimum> {
    let GrowingInequality { at_zero: Inequality { a, b }, growth } = &inequalities[tight];
    let eliminated = |index: &usize| {
        let GrowingInequality { at_zero: other, growth: others_growth } = &inequalities[*index];
        let without_t = |others: &Rational, own: &Rational| others * growth - own * others_growth;
        Inequality::new(without_t(&other.a[0], &a[0]), without_t(&other.a[1], &a[1]), without_t(&other.b, b))
    };
    let t_not_negative = Inequality::new(-&a[0], -&a[1], -b);
    let system: System = seen.iter().map(eliminated).chain([t_not_negative]).collect();
    let Support::Bounded { proof, .. } = Polyhedron::intersect(system).support(&[-&a[0], -&a[1]]) else {
        return None;
    };
    let theta = proof.attained_at.coordinates();
    let t = (-&proof.value - b).checked_div(growth)?;
    // The multipliers of the eliminated rows carry over; that of the tight row makes the combination vanish.
    let mut own = Rational::one();
    let mut multipliers = Vec::new();
    for multiplier in &proof.multipliers {
        match seen.get(multiplier.index) {
            Some(&index) => {
                own = own - &multiplier.value * &inequalities[index].growth;
                multipliers.push(Multiplier { index, value: &multiplier.value * growth });
            }
            None => own = own - &multiplier.value,
        }
    }
    multipliers.push(Multiplier { index: tight, value: own });
    Some((theta, t, normalised(multipliers, inequalities)))
}

/// The least t on the boundary a·θ = b of a half-plane that does not grow: one variable u runs along it.
fn on_fixed_boundary(inequalities: &[GrowingInequality], seen: &[usize], tight: usize) -> Option<Optimum> {
    let Inequality { a, b } = &inequalities[tight].at_zero;
    let squared_length = &a[0] * &a[0] + &a[1] * &a[1];
    let scale = b.checked_div(&squared_length)?;
    let start = [&a[0] * &scale, &a[1] * &scale];
    let along = [-&a[1], a[0].clone()];
    let product = |u: &[Rational; 2], v: &[Rational; 2]| &u[0] * &v[0] + &u[1] * &v[1];
    let restricted = |index: &usize| {
        let GrowingInequality { at_zero, growth } = &inequalities[*index];
        Inequality::new(product(&at_zero.a, &along), -growth, at_zero.slack(&start))
    };
    let t_not_negative = Inequality::new(Rational::zero(), -Rational::one(), Rational::zero());
    let system: System = seen.iter().map(restricted).chain([t_not_negative]).collect();
    let minus_t = [Rational::zero(), -Rational::one()];
    let Support::Bounded { proof, .. } = Polyhedron::intersect(system).support(&minus_t) else {
        return None;
    };
    let [u, t] = proof.attained_at.coordinates();
    let theta = [&start[0] + &along[0] * &u, &start[1] + &along[1] * &u];
    let kept = proof.multipliers.iter().filter(|multiplier| multiplier.index < seen.len());
    let mut multipliers: Vec<Multiplier> =
        kept.map(|m| Multiplier { index: seen[m.index], value: m.value.clone() }).collect();
    // Their combination is orthogonal to the line; a multiple of the tight row cancels it.
    let residue: Rational =
        multipliers.iter().map(|m| product(&inequalities[m.index].at_zero.a, a) * &m.value).sum();
    multipliers.push(Multiplier { index: tight, value: -residue.checked_div(&squared_length)? });
    Some((theta, t, normalised(multipliers, inequalities)))
}

/// Scales multipliers so that Σ λ·growth = 1 and drops those that are zero. Without growth there is nothing to prove:
/// t is 0.
fn normalised(multipliers: Vec<Multiplier>, inequalities: &[GrowingInequality]) -> Vec<Multiplier> {
    let total: Rational = multipliers.iter().map(|m| &m.value * &inequalities[m.index].growth).sum();
    multipliers
        .into_iter()
        .filter(|multiplier| !multiplier.value.is_zero())
        .filter_map(|m| Some(Multiplier { index: m.index, value: m.value.checked_div(&total)? }))
        .collect()
}

/// A growing inequality times the common denominator `scale` of its coefficients.
struct IntegerRow {
    a: [Integer; 2],
    b: Integer,
    growth: Integer,
    scale: Integer,
}

impl IntegerRow {
    fn new(inequality: &GrowingInequality) -> Self {
        let GrowingInequality { at_zero: Inequality { a: [a1, a2], b }, growth } = inequality;
        let ([a1, a2, b, growth], scale) = Rational::over_common_denominator([a1, a2, b, growth]);
        IntegerRow { a: [a1, a2], b, growth, scale }
    }
}

/// The inequality that (θ, t) violates most, in its own units; the first of equals.
fn most_violated(rows: &[IntegerRow], theta: &[Rational; 2], t: &Rational) -> Option<usize> {
    let [theta1, theta2] = theta;
    let ([x, y, time], weight) = Rational::over_common_denominator([theta1, theta2, t]);
    let mut worst: Option<(usize, Integer)> = None;
    for (index, row) in rows.iter().enumerate() {
        let excess = &row.a[0] * &x + &row.a[1] * &y - &row.b * &weight - &row.growth * &time;
        let worse = excess.is_positive()
            && worst
                .as_ref()
                .is_none_or(|(best, largest)| &excess * &rows[*best].scale > largest * &row.scale);
        if worse {
            worst = Some((index, excess));
        }
    }
    worst.map(|(index, _)| index)
}
