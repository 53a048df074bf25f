//! What is known of readings of which equal ones are kept once.

use boundfit_exact::{Rational, Sum};

use super::{DecidingMinimax, NoEui, Reach, Reduction, Sums};
use crate::least_squares::NoLeastSquares;
use crate::meaning::Meaning;
use crate::measurement::{Bounds, Measurement};
use crate::ties::Ties;

impl Reduction {
    /// Of readings that stand for others equal to them. Exact. Cost: linear in the different ones.
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
            has_widths: rows.is_empty() || rows.iter().any(|reading| reading.half_width().is_some()),
        }
    }
}

fn sums(weighted: &[(&Measurement, Rational)]) -> Result<Sums, NoLeastSquares> {
    let mut totals = [(); 5].map(|()| Sum::default());
    let mut count = Rational::zero();
    for (reading, times) in weighted {
        let [u, v] = &reading.regressor;
        let y = reading.value().ok_or(NoLeastSquares::NoResponse)?;
        let [times_u, times_v] = [u * times, v * times];
        let [uu, uv, vv, uy, vy] = &mut totals;
        uu.add_product(u, &times_u);
        uv.add_product(v, &times_u);
        vv.add_product(v, &times_v);
        uy.add_product(&times_u, &y);
        vy.add_product(&times_v, &y);
        count = count + times;
    }
    let [uu, uv, vv, uy, vy] = totals.map(|sum| sum.total());
    let count = count.numerator().to_i128().and_then(|count| usize::try_from(count).ok()).unwrap_or_default();
    Ok(Sums { count, uu, uv, vv, uy, vy })
}

/// How far least squares may move; under one bound for all with 1 in its place.
fn reach(weighted: &[(&Measurement, Rational)], sums: &Sums, is_uniform: bool) -> Result<Reach, NoEui> {
    if weighted.iter().any(|(reading, _)| reading.half_width().is_none()) {
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
