//! Exact least squares and its uncertainty intervals.

use std::borrow::Cow;

use boundfit_exact::{
    Count, Endpoint, Integer, Interval, Rational, Scaled, Sum, Unit, WideProducts, WideSum,
};
use boundfit_geometry::Direction;

use crate::grid::Grid;
use crate::meaning::{ErrorBound, Model};
use crate::measurement::{Bounds, Measurement};
use crate::measurements::Measurements;
use crate::moments::{SUM_BITS, Solution, Sums, bits, widest};
use crate::reduction::{NoEui, NoLeastSquares, Reach, Reduction};

/// The least-squares estimate θ̂ = (ΦᵀΦ)⁻¹Φᵀy with its estimate uncertainty intervals.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LeastSquares {
    /// θ̂.
    pub theta: [Rational; 2],
    /// EUI_j = [θ̂_j ∓ Σ_k |A_jk|·ε_k] with A = (ΦᵀΦ)⁻¹Φᵀ: where θ̂_j would lie for any errors within their bounds.
    /// For readings with two bounds of their own, A_j·t lies for all t between these. Then the EUI is the estimate
    /// from their middles ∓ Σ_k |A_jk|·w_k with half the widths w_k, whatever y is.
    ///
    /// It takes a second look at all readings; why there was none, otherwise.
    pub eui: Result<[Interval; 2], NoEui>,
}

impl LeastSquares {
    /// Solves the normal equations; of a line through the origin the one for θ1. Exact. Cost: linear in the number of readings.
    ///
    /// # Errors
    /// When ΦᵀΦ is singular.
    pub fn new(measurements: &Measurements) -> Result<Self, NoLeastSquares> {
        LeastSquares::with_grid(measurements, Grid::new(measurements).as_ref())
    }

    /// Computes as [`LeastSquares::new`] does, on the machine integers of the readings if there are any.
    pub(crate) fn with_grid(
        measurements: &Measurements,
        grid: Option<&Grid>,
    ) -> Result<Self, NoLeastSquares> {
        if measurements.line_form().through_origin {
            return LeastSquares::through_origin(measurements);
        }
        match measurements.reduction() {
            Some(reduction) => LeastSquares::of_reduction(reduction, measurements.error_bound()),
            None => grid
                .and_then(|grid| LeastSquares::on_grid(grid, measurements.error_bound()))
                .or_else(|| LeastSquares::on_wide_grid(measurements))
                .unwrap_or_else(|| LeastSquares::of_rows(measurements.kept())),
        }
    }

    /// Computes the estimate from readings of any size.
    fn of_rows(rows: &[Measurement]) -> Result<Self, NoLeastSquares> {
        let values = |number: fn(&Measurement) -> Option<Cow<'_, Rational>>| {
            rows.iter().map(number).collect::<Option<Vec<_>>>()
        };
        let moments_of = |y: &[Cow<'_, Rational>]| {
            let readings =
                rows.iter().zip(y).map(|(Measurement { regressor: [u, v], .. }, y)| [u, v, y.as_ref()]);
            Sums::of_numbers(readings).total()
        };
        let y = values(Measurement::value).ok_or(NoLeastSquares::NoResponse)?;
        let moments = moments_of(&y);
        let widths = values(Measurement::half_width);
        let reaches = |moments: &Sums| {
            let widths = widths.ok_or(NoEui::OneSided)?;
            if widths.iter().any(|width| width.is_negative()) {
                return Err(NoEui::Crossing);
            }
            let Sums { uu, uv, vv, .. } = moments;
            Ok([reach_of(rows, &widths, vv, &-uv), reach_of(rows, &widths, &-uv, uu)])
        };
        let estimate = LeastSquares::of_moments(&moments, reaches)?;
        if rows.iter().all(|row| matches!(row.bounds, Bounds::Around { .. })) || estimate.eui.is_err() {
            return Ok(estimate);
        }
        let middles = values(Measurement::middle).ok_or(NoLeastSquares::NoResponse)?;
        let Sums { uy, vy, .. } = moments_of(&middles);
        estimate.about_middles(&moments, [uy, vy])
    }

    /// Sets the EUI about the estimate from the middles of the bounds, given by Φᵀm. The estimate itself takes y.
    fn about_middles(self, moments: &Sums, [uy, vy]: [Rational; 2]) -> Result<Self, NoLeastSquares> {
        let middles = Sums { uy, vy, ..moments.clone() };
        let about_middles = LeastSquares::of_moments(&middles, |_| Err(NoEui::NotAsked))?.theta;
        let shifted = |j: usize, eui: &Interval| {
            let shift = &about_middles[j] - &self.theta[j];
            let moved = |end: &Endpoint| Endpoint::from(end.value().map(|value| value + &shift));
            Interval::new(moved(eui.lower()), moved(eui.upper())).ok_or(NoLeastSquares::Singular)
        };
        let eui = match &self.eui {
            Ok([first, second]) => Ok([shifted(0, first)?, shifted(1, second)?]),
            Err(reason) => Err(*reason),
        };
        Ok(LeastSquares { eui, ..self })
    }

    /// The estimate alone, from the sums over all readings. Exact. Cost: constant.
    #[cfg(feature = "files")]
    pub(crate) fn theta_of(sums: &Sums) -> Option<[Rational; 2]> {
        let estimate = LeastSquares::of_moments(sums, |_| Err(NoEui::NotAsked));
        estimate.ok().map(|estimate| estimate.theta)
    }

    /// Computes the estimate from the sums over readings of which most are no longer in memory. Cost: constant.
    fn of_reduction(reduction: &Reduction, error_bound: &ErrorBound) -> Result<Self, NoLeastSquares> {
        let moments = reduction.sums.as_ref().map_err(|reason| *reason)?;
        let reach = reduction.reach_within(error_bound);
        let radii = |_: &_| reach.clone().map(|reach| reach.radii);
        let estimate = LeastSquares::of_moments(moments, radii)?;
        match reach {
            Ok(Reach { middles: Some(middles), .. }) => estimate.about_middles(moments, middles),
            _ => Ok(estimate),
        }
    }

    /// Computes the estimate from moments and from a function that gives Σ_k |A_jk|·ε_k times the determinant. A_jk
    /// times the determinant is p·φ_k1 + q·φ_k2 with (p, q) a row of the adjugate of ΦᵀΦ.
    fn of_moments(
        moments: &Sums,
        reaches: impl FnOnce(&Sums) -> Result<[Rational; 2], NoEui>,
    ) -> Result<Self, NoLeastSquares> {
        let Solution { numerators, determinant } = moments.solution();
        let solved =
            |numerator: &Rational| numerator.checked_div(&determinant).ok_or(NoLeastSquares::Singular);
        let theta = [solved(&numerators[0])?, solved(&numerators[1])?];
        let interval = |j: usize, reach: &Rational| {
            Interval::around(&theta[j], &solved(reach)?).ok_or(NoLeastSquares::Singular)
        };
        let eui = match reaches(moments) {
            Ok([first, second]) => Ok([interval(0, &first)?, interval(1, &second)?]),
            Err(reason) => Err(reason),
        };
        Ok(LeastSquares { theta, eui })
    }

    /// Computes the estimate from machine integers, with every fraction reduced once; `None` when a sum does not fit
    /// into 128 bits.
    pub(crate) fn on_grid(grid: &Grid, error_bound: &ErrorBound) -> Option<Result<Self, NoLeastSquares>> {
        let second = grid.phi2.as_ref();
        let moments =
            Sums::of_integers(grid.phi1.counts(), second.map(Scaled::counts), grid.response.counts())?;
        // With φ = Φ/s and y = Y/t, an estimate in the units of the grid is θ·t/s.
        let per_one = |column: Option<&Scaled<i64>>| column.map_or(Some(Integer::one()), per_one);
        let (epsilon, epsilon_scale) = match error_bound {
            ErrorBound::Uniform(epsilon) => (epsilon.numerator(), epsilon.denominator()),
            ErrorBound::Column(_) | ErrorBound::Interval { .. } | ErrorBound::Law(_) => {
                (Integer::one(), per_one(grid.epsilon.as_ref())?)
            }
        };
        let units = Units {
            regressors: [per_one(Some(&grid.phi1))?, per_one(second)?],
            response: per_one(Some(&grid.response))?,
            epsilon,
            epsilon_scale,
        };
        let Sums { uu, uv, vv, .. } = moments;
        units.estimate(&moments.map(Integer::from).solution(), || {
            Some([reach(grid, (vv, -uv))?, reach(grid, (-uv, uu))?])
        })
    }

    /// Computes as [`LeastSquares::on_grid`] from a line's integers of 128 bits; `None` when these do not reach, or readings have bounds
    /// of their own.
    fn on_wide_grid(measurements: &Measurements) -> Option<Result<Self, NoLeastSquares>> {
        let (Model::Line { .. }, ErrorBound::Uniform(epsilon), true) =
            (measurements.model(), measurements.error_bound(), measurements.is_around_y())
        else {
            return None;
        };
        let rows = measurements.kept();
        let x = Scaled::<i128>::of_numbers(rows.iter().map(|row| &row.regressor[0]))?;
        let y = Scaled::<i128>::of_numbers(rows.iter().map(|row| row.y_and_epsilon().0))?;
        let units = Units {
            regressors: [per_one(&x)?, Integer::one()],
            response: per_one(&y)?,
            epsilon: epsilon.numerator(),
            epsilon_scale: epsilon.denominator(),
        };
        let (x, y) = (x.counts(), y.counts());
        let sum = |numbers: &[i128]| {
            let mut sum = WideSum::default();
            numbers.iter().for_each(|&number| sum.add(number));
            sum.total()
        };
        let products = |numbers: &[i128]| {
            let mut sum = WideProducts::default();
            x.iter().zip(numbers).for_each(|(&x, &number)| sum.add(x, number));
            sum.total()
        };
        let moments = Sums::new(rows.len(), [products(x), sum(x), rows.len().into(), products(y), sum(y)]);
        let reach = |p: &Integer, q: &Integer| {
            let (mut signed_x, mut signs) = (WideSum::default(), 0_i128);
            for &x in x {
                let sign = if (p * &Integer::from(x) + q).is_negative() { -1 } else { 1 };
                signed_x.add(sign * x);
                signs += sign;
            }
            p * signed_x.total() + q * Integer::from(signs)
        };
        let Sums { uu, uv, vv, .. } = &moments;
        let opposite = -uv;
        units.estimate(&moments.solution(), || Some([reach(vv, &opposite), reach(&opposite, uu)]))
    }
}

/// The numbers that integers are multiples of: one over each of these.
struct Units {
    regressors: [Integer; 2],
    response: Integer,
    /// The bound on the errors on the unit `1 / epsilon_scale`.
    epsilon: Integer,
    epsilon_scale: Integer,
}

impl Units {
    /// Returns the estimate from its solution in these units and Σ |A_jk|·ε_k times the determinant, with every fraction reduced once.
    fn estimate(
        &self,
        Solution { numerators, determinant }: &Solution<Integer>,
        reaches: impl FnOnce() -> Option<[Integer; 2]>,
    ) -> Option<Result<LeastSquares, NoLeastSquares>> {
        if determinant.is_zero() {
            return Some(Err(NoLeastSquares::Singular));
        }
        let reaches = reaches()?;
        let units = &self.response * &self.epsilon_scale;
        let part = |j: usize| {
            // Common divisors of parts cost less than those of products.
            let unit = Rational::new(self.regressors[j].clone(), units.clone())?;
            let scaled = |numerator: Integer| Some(Rational::new(numerator, determinant.clone())? * &unit);
            let centre = &numerators[j] * &self.epsilon_scale;
            let radius = &reaches[j] * &self.epsilon * &self.response;
            let ends = [scaled(&centre - &radius)?, scaled(&centre + &radius)?].map(Endpoint::Finite);
            let [lower, upper] = ends;
            Some((scaled(centre)?, Interval::new(lower, upper)?))
        };
        let ((theta1, eui1), (theta2, eui2)) = (part(0)?, part(1)?);
        Some(Ok(LeastSquares { theta: [theta1, theta2], eui: Ok([eui1, eui2]) }))
    }
}

/// Returns how many units of a column are 1.
fn per_one<I: Count>(column: &Scaled<I>) -> Option<Integer> {
    Unit::TenTo(0).counted_in(column.unit()).map(Integer::from)
}

/// Σ |p·u + q·v|·w over readings (u, v) with these half widths w.
fn reach_of(rows: &[Measurement], widths: &[Cow<'_, Rational>], p: &Rational, q: &Rational) -> Rational {
    // Only the sign of a weight matters, so p and q may be scaled to integers. They are not both 0.
    let Some(scaled) = Direction::from_rational(&[p.clone(), q.clone()]) else {
        return Rational::zero();
    };
    let mut sums = [Sum::default(), Sum::default()];
    for (Measurement { regressor: [u, v], .. }, width) in rows.iter().zip(widths) {
        let weight =
            scaled.dx() * (u.numerator() * v.denominator()) + scaled.dy() * (v.numerator() * u.denominator());
        let signed = if weight.is_negative() { -width.as_ref() } else { width.clone().into_owned() };
        sums[0].add_product(u, &signed);
        sums[1].add_product(v, &signed);
    }
    p * sums[0].total() + q * sums[1].total()
}

/// Σ |p·u + q·v|·ε over the readings (u, v) of a grid, in its units; ε counts as 1 when it is uniform. `None` when one of the
/// sums might not fit.
fn reach(grid: &Grid, (p, q): (i128, i128)) -> Option<Integer> {
    let bits_of = |column: &Option<Scaled<i64>>| column.as_ref().map_or(1, |column| widest(column.counts()));
    let (u_bits, v_bits) = (widest(grid.phi1.counts()), bits_of(&grid.phi2));
    let cross_bits = 1 + (bits(p.unsigned_abs()) + u_bits).max(bits(q.unsigned_abs()) + v_bits);
    let sum_bits = bits_of(&grid.epsilon) + u_bits.max(v_bits) + bits(grid.phi1.counts().len() as u128);
    if cross_bits.max(sum_bits) > SUM_BITS {
        return None;
    }
    // By the bits above none of these can overflow.
    let product = |left: i128, right: i64| left.wrapping_mul(i128::from(right));
    let mut sums = [0_i128, 0];
    for (row, &u) in grid.phi1.counts().iter().enumerate() {
        let at = |column: &Option<Scaled<i64>>| column.as_ref().map_or(1, |column| column.counts()[row]);
        let (v, epsilon) = (at(&grid.phi2), at(&grid.epsilon));
        let cross = product(p, u).wrapping_add(product(q, v));
        let signed = if cross < 0 { epsilon.wrapping_neg() } else { epsilon };
        sums[0] = sums[0].wrapping_add(product(signed.into(), u));
        sums[1] = sums[1].wrapping_add(product(signed.into(), v));
    }
    Some(Integer::from(p) * Integer::from(sums[0]) + Integer::from(q) * Integer::from(sums[1]))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Few values on a fine unit, also a single x, and sums of more than 256 bits.
    #[test]
    fn wide_integers_have_the_estimate_of_fractions() {
        let mut seed = 5_u64;
        let mut draw = |below: u64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 33) % below
        };
        for round in 0..1_000 {
            let far = i128::from(i64::MAX) << (round % 62);
            let mut number = |exponent: i32| {
                let [steps, rest] = [4, 1 + round % 7].map(|below| i128::from(draw(below)));
                Rational::scientific((steps - 2) * far + rest, exponent)
            };
            let epsilon = number(-30).abs();
            let row =
                |row| Measurement::around(row, [number(-19), Rational::one()], number(-21), epsilon.clone());
            let rows: Vec<Measurement> = (1..2 + round as usize % 9).map(row).collect();
            let (x, bound) = (Model::Line { x: "x".into() }, ErrorBound::Uniform(epsilon.clone()));
            let readings = Measurements::new(x, "y".into(), bound, rows);
            let wide = LeastSquares::on_wide_grid(&readings).unwrap();
            assert_eq!(wide, LeastSquares::of_rows(readings.kept()), "{round}");
        }
    }

    /// Ends on units of their own, of one or two regressors, also ends that cross and no end at all.
    #[test]
    fn intervals_on_a_grid_have_the_estimate_of_fractions() {
        let mut seed = 3_u64;
        let mut draw = |below: u64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            i64::try_from((seed >> 33) % below).unwrap()
        };
        let mut on_grid = 0;
        for round in 0..1_000 {
            let mut number = |below: u64| Rational::ratio(draw(below) - 40, 1 + draw(1 + round % 7));
            let row = |row| {
                let second = if round % 2 == 0 { Rational::one() } else { number(90) };
                let (lower, width) = (number(200), number(1_000) + Rational::from(38));
                let upper = (number(4_000) > Rational::from(-40)).then(|| &lower + width);
                Measurement::between(row, [number(90), second], Some(lower), upper)
            };
            let rows: Vec<Measurement> = (1..2 + round as usize % 9).map(row).collect();
            let model = match round % 2 {
                0 => Model::Line { x: "x".into() },
                _ => Model::TwoRegressors { regressors: ["x".into(), "u".into()] },
            };
            let bound = ErrorBound::Interval { lower: Some("a".into()), upper: Some("b".into()) };
            let readings = Measurements::new(model, "y".into(), bound, rows);
            let grid = Grid::new(&readings);
            let found = grid.as_ref().and_then(|grid| LeastSquares::on_grid(grid, readings.error_bound()));
            on_grid += usize::from(found.is_some());
            let expected = LeastSquares::of_rows(readings.kept());
            assert_eq!(found.unwrap_or_else(|| expected.clone()), expected, "{round}");
        }
        assert!((500..1_000).contains(&on_grid), "{on_grid}");
    }
}
