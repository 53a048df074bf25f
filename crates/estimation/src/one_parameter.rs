//! Least squares of y = θ1·x, which has one parameter.

use std::borrow::Cow;

use boundfit_exact::{Interval, Rational, Sum};

use crate::least_squares::LeastSquares;
use crate::measurement::Measurement;
use crate::measurements::Measurements;
use crate::reduction::{NoEui, NoLeastSquares, Reduction};

/// Σx², Σxy with the y of least squares, and what the EUI needs: Σx·m and Σ|x|·w with the middles m and half the widths w of
/// the readings' bounds.
struct Sums {
    xx: Rational,
    xy: Rational,
    about: Result<[Rational; 2], NoEui>,
}

impl LeastSquares {
    /// Returns the estimate of a line through the origin: θ̂1 = Σxy/Σx² with EUI_1 = Σxm/Σx² ∓ Σ|x|·w/Σx². Readings y
    /// ± ε have m = y and w = ε. θ2 is 0, and so is its EUI. Exact. Cost: linear in the number of readings that are
    /// kept.
    pub(crate) fn through_origin(measurements: &Measurements) -> Result<Self, NoLeastSquares> {
        let Sums { xx, xy, about } = match measurements.reduction() {
            Some(reduction) => sums_of_reduction(reduction, measurements)?,
            None => sums_of_rows(measurements.kept())?,
        };
        let solved = |numerator: &Rational| numerator.checked_div(&xx).ok_or(NoLeastSquares::EveryXZero);
        let theta = [solved(&xy)?, Rational::zero()];
        let around = |centre: &Rational, radius: &Rational| {
            Interval::around(centre, radius).ok_or(NoLeastSquares::EveryXZero)
        };
        let eui = match about {
            Ok([centre, radius]) => {
                let zero = Rational::zero();
                Ok([around(&solved(&centre)?, &solved(&radius)?)?, around(&zero, &zero)?])
            }
            Err(reason) => Err(reason),
        };
        Ok(LeastSquares { theta, eui })
    }
}

fn sums_of_rows(rows: &[Measurement]) -> Result<Sums, NoLeastSquares> {
    let sum_with = |numbers: &[Cow<'_, Rational>], sign: fn(&Rational) -> Rational| {
        let mut sum = Sum::default();
        rows.iter().zip(numbers).for_each(|(row, number)| sum.add_product(&sign(&row.regressor[0]), number));
        sum.total()
    };
    let values = |number: fn(&Measurement) -> Option<Cow<'_, Rational>>| {
        rows.iter().map(number).collect::<Option<Vec<_>>>()
    };
    let y = values(Measurement::value).ok_or(NoLeastSquares::NoResponse)?;
    let x: Vec<Cow<'_, Rational>> = rows.iter().map(|row| Cow::Borrowed(&row.regressor[0])).collect();
    let about = match values(Measurement::half_width).zip(values(Measurement::middle)) {
        None => Err(NoEui::OneSided),
        Some((widths, _)) if widths.iter().any(|width| width.is_negative()) => Err(NoEui::Crossing),
        Some((widths, middles)) => {
            Ok([sum_with(&middles, Rational::clone), sum_with(&widths, Rational::abs)])
        }
    };
    Ok(Sums { xx: sum_with(&x, Rational::clone), xy: sum_with(&y, Rational::clone), about })
}

fn sums_of_reduction(reduction: &Reduction, measurements: &Measurements) -> Result<Sums, NoLeastSquares> {
    let sums = reduction.sums.as_ref().map_err(|reason| *reason)?;
    let about = reduction.reach_within(measurements.error_bound()).map(|reach| {
        let xm = reach.middles.map_or_else(|| sums.uy.clone(), |[xm, _]| xm);
        [xm, reach.absolute]
    });
    Ok(Sums { xx: sums.uu.clone(), xy: sums.uy.clone(), about })
}
