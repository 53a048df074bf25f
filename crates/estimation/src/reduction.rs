//! The facts about readings of which not all are kept.

use boundfit_exact::{Rational, Sum};
use thiserror::Error;

use crate::meaning::{ErrorBound, Meaning};
use crate::measurement::{Bounds, Measurement};
use crate::moments::Sums;
use crate::ties::Ties;

/// The facts about readings of which only the deciding ones are kept.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Reduction {
    /// The number of readings there are.
    pub count: usize,
    /// The sums over all readings.
    pub sums: Result<Sums, NoLeastSquares>,
    /// The reach of least squares; for a line under a uniform error bound with 1 as the bound.
    pub reach: Result<Reach, NoEui>,
    /// The readings that decide ε_min.
    pub minimax: DecidingMinimax,
    /// True if a reading has two bounds, whose distance a factor may multiply.
    pub has_widths: bool,
}

impl Reduction {
    /// Reduces readings that stand for others equal to them. Exact. Cost: linear in the different ones.
    pub(crate) fn of_counted(meaning: &Meaning, rows: &[Measurement], ties: &Ties) -> Self {
        let weighted: Vec<(&Measurement, Rational)> =
            rows.iter().map(|reading| (reading, Rational::from(ties.count(reading.row)))).collect();
        let sums = sums(&weighted);
        let reach = match &sums {
            Ok(sums) => reach(&weighted, sums, meaning.error_bound.is_uniform()),
            Err(_) => Err(NoEui::NotAsked),
        };
        Reduction {
            count: rows.iter().map(|reading| ties.count(reading.row)).sum(),
            sums,
            reach,
            minimax: DecidingMinimax::Kept,
            has_widths: rows.is_empty() || rows.iter().any(Measurement::is_two_sided),
        }
    }

    /// Returns how far least squares may move within the error bound of the readings.
    pub(crate) fn reach_within(&self, error_bound: &ErrorBound) -> Result<Reach, NoEui> {
        let reach = self.reach.clone()?;
        match (&self.minimax, error_bound.uniform()) {
            (DecidingMinimax::Kept, Some(epsilon)) => Ok(Reach {
                radii: reach.radii.map(|radius| radius * epsilon),
                absolute: reach.absolute * epsilon,
                ..reach
            }),
            _ => Ok(reach),
        }
    }
}

/// The reach of least squares when the readings move within their bounds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Reach {
    /// Σ_k |A_jk|·ε_k times the determinant of ΦᵀΦ, with A of [`LeastSquares`](crate::LeastSquares).
    pub radii: [Rational; 2],
    /// Σ_k |φ_k1|·ε_k.
    pub absolute: Rational,
    /// Φᵀm with the middles m of all bounds, where these are not y.
    pub middles: Option<[Rational; 2]>,
}

/// The readings that decide ε_min.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum DecidingMinimax {
    /// The same that decide the feasible set: those of a line under a uniform error bound, whatever it is.
    Kept,
    /// The readings that touch where ε_min is reached.
    Own(Vec<Measurement>),
    /// The deciding readings are not known.
    Unknown(NoMinimax),
}

/// The reason why ε_min is not known although there are readings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum NoMinimax {
    /// The question did not ask for ε_min.
    #[error("not asked for")]
    NotAsked,
    /// Readings that cannot be read twice, and more than are kept.
    #[error(
        "standard input has more readings than are kept for a second look at them; a file can be read twice"
    )]
    TooManyOnce,
    /// The data are the result of a reduction under bounds that are fixed.
    #[error(
        "the data are a reduction under bounds that are fixed, which does not say how other bounds would do"
    )]
    Reduced,
}

/// The reason why there is no EUI although there is a least-squares estimate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum NoEui {
    /// The question did not ask for the EUI.
    #[error("not asked for")]
    NotAsked,
    /// Readings that cannot be read twice, and more than are kept.
    #[error(
        "standard input has more readings than are kept for a second look at their x; a file can be read twice"
    )]
    TooManyOnce,
    /// A reading has one bound only.
    #[error("a reading has one bound only, so that nothing limits its error on the other side")]
    OneSided,
    /// The bounds of a reading cross.
    #[error("the bounds of a reading cross, so that it has no error that they allow")]
    Crossing,
    /// The data are the result of a reduction.
    #[error("the data are a reduction, which does not have the x of every reading")]
    Reduced,
}

/// The reason why there is no least-squares estimate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum NoLeastSquares {
    /// ΦᵀΦ has no inverse: all regressors are multiples of one.
    #[error(
        "the regressors are all parallel (for a line: fewer than two distinct x), so the normal equations are singular"
    )]
    Singular,
    /// Every x of a line through the origin is 0.
    #[error("every x is 0, where all lines through the origin are alike")]
    EveryXZero,
    /// A reading with neither y nor both bounds.
    #[error("no column of y was given, and a reading with one bound only has no middle to take instead")]
    NoResponse,
}

fn sums(weighted: &[(&Measurement, Rational)]) -> Result<Sums, NoLeastSquares> {
    let mut totals = Sums::<Sum>::default();
    let mut count = Rational::zero();
    for (reading, times) in weighted {
        let [u, v] = &reading.regressor;
        let y = reading.value().ok_or(NoLeastSquares::NoResponse)?;
        let [times_u, times_v] = [u * times, v * times];
        totals.uu.add_product(u, &times_u);
        totals.uv.add_product(v, &times_u);
        totals.vv.add_product(v, &times_v);
        totals.uy.add_product(&times_u, &y);
        totals.vy.add_product(&times_v, &y);
        count = count + times;
    }
    let count = count.numerator().to_i128().and_then(|count| usize::try_from(count).ok()).unwrap_or_default();
    Ok(Sums { count, ..totals.total() })
}

/// Returns how far least squares may move; under one bound for all with 1 in its place.
fn reach(weighted: &[(&Measurement, Rational)], sums: &Sums, is_uniform: bool) -> Result<Reach, NoEui> {
    if !weighted.iter().all(|(reading, _)| reading.is_two_sided()) {
        return Err(NoEui::OneSided);
    }
    let Sums { uu, uv, vv, .. } = sums;
    let rows_of_adjugate = [[vv.clone(), -uv], [-uv, uu.clone()]];
    let mut radii = [Sum::default(), Sum::default()];
    let mut absolute = Sum::default();
    let mut middles = [Sum::default(), Sum::default()];
    for (reading, times) in weighted {
        let [u, v] = &reading.regressor;
        let width = reading.half_width().unwrap_or_default();
        if width.is_negative() {
            return Err(NoEui::Crossing);
        }
        let width = if is_uniform { times.clone() } else { width.as_ref() * times };
        for (radius, [p, q]) in radii.iter_mut().zip(&rows_of_adjugate) {
            radius.add_product(&(p * u + q * v).abs(), &width);
        }
        absolute.add_product(&u.abs(), &width);
        let middle = reading.middle().unwrap_or_default();
        let middle = middle.as_ref() * times;
        middles[0].add_product(u, &middle);
        middles[1].add_product(v, &middle);
    }
    let is_around_y = weighted.iter().all(|(reading, _)| matches!(reading.bounds, Bounds::Around { .. }));
    Ok(Reach {
        radii: radii.map(|sum| sum.total()),
        absolute: absolute.total(),
        middles: (!is_around_y).then(|| middles.map(|sum| sum.total())),
    })
}
