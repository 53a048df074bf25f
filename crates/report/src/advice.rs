//! Advice: a further reading that would bound an unbounded FPS.

use boundfit_estimation::{Measurements, Model};
use boundfit_exact::{Integer, Rational, Sign};
use boundfit_geometry::{Direction, Polyhedron};

use crate::document::{Operator, Text};
use crate::formula::pair;
use crate::style::Style;

/// A sentence about which further reading would bound an unbounded FPS; `None` when it is bounded.
///
/// A reading confines θ to a strip across its regressor φ, which stops every recession direction d with φ·d ≠ 0. One
/// strip stops a whole pointed cone when φ·d has one sign on all of it.
pub(crate) fn bounding_reading(set: &Polyhedron, measurements: &Measurements, style: &Style) -> Option<Text> {
    let model = measurements.model();
    // As x stands in the data.
    let uncounted = |x: Rational| x + &measurements.line_form().x_origin;
    if set.kind().is_bounded() {
        return None;
    }
    let region = set.region();
    let advice = match (region.rays().as_slice(), region.lines().as_slice()) {
        ([], [line]) => match (model, line_at_zero(line)) {
            (Model::Line { x }, Some(value)) => {
                let at = Text::from("One further reading at any ").given(x).words(" other than ");
                at.number(style.nearest(&uncounted(value))).words(" would bound it.")
            }
            _ => Text::from("One further reading whose regressors are not a multiple of ")
                .then(pair(line.dy(), -line.dx()))
                .words(" would bound it."),
        },
        (rays @ ([_] | [_, _]), []) => {
            let (phi1, phi2) = stopping_regressor(rays)?;
            let example = Text::from("One further reading would bound it, for example ");
            let example = match model {
                Model::Line { x } => {
                    let value = uncounted(Rational::new(phi1, phi2)?);
                    let x = example.words("at ").given(x);
                    x.operator(Operator::Equals).number(style.nearest(&value))
                }
                Model::TwoRegressors { .. } => example.words("with regressors ").then(pair(phi1, phi2)),
            };
            example.words(".")
        }
        _ => match model {
            Model::Line { x } => {
                Text::from("Two further readings at different ").given(x).words(" would bound it.")
            }
            Model::TwoRegressors { .. } => {
                "Two further readings whose regressors are not multiples of each other would bound it.".into()
            }
        },
    };
    Some(advice)
}

/// The x at which (x, 1) is orthogonal to a direction.
fn line_at_zero(line: &Direction) -> Option<Rational> {
    Rational::new(-line.dy(), line.dx().clone())
}

/// A regressor whose products with all directions of a pointed cone have one sign; its second component is not 0.
fn stopping_regressor(rays: &[Direction]) -> Option<(Integer, Integer)> {
    let (first, last) = (rays.first()?, rays.last()?);
    let stops = |(phi1, phi2): &(Integer, Integer)| {
        let signs = [first, last].map(|ray| (phi1 * ray.dx() + phi2 * ray.dy()).sign());
        signs[0] == signs[1] && signs[0] != Sign::Zero && !phi2.is_zero()
    };
    // A round number if one will do. Inner normals of the cone's two sides otherwise: any positive combination of them
    // has positive products with both rays.
    let round = [0, 1, -1, 2, -2, 5, -5, 10, -10, 100, -100].map(|x| (Integer::from(x), Integer::one()));
    let (left, right) = (first.turned_left(), last.turned_right());
    let between = (1..=2).map(|weight| {
        let weight = Integer::from(weight);
        (left.dx() + right.dx() * &weight, left.dy() + right.dy() * &weight)
    });
    round.into_iter().chain(between).find(stops)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_regressor_stops_every_ray() {
        let direction = |x: i64, y: i64| Direction::new(x.into(), y.into()).unwrap();
        for rays in [
            vec![direction(1, 0), direction(0, 1)],
            vec![direction(1, -1000), direction(1, 0)],
            vec![direction(1000, -1), direction(1000, 1)],
            vec![direction(1, 0)],
            vec![direction(0, -1)],
            vec![direction(-3, 7), direction(3, -8)],
        ] {
            let (phi1, phi2) = stopping_regressor(&rays).unwrap();
            let signs: Vec<Sign> =
                rays.iter().map(|ray| (&phi1 * ray.dx() + &phi2 * ray.dy()).sign()).collect();
            assert!(signs.iter().all(|sign| *sign == signs[0] && *sign != Sign::Zero), "{rays:?}");
        }
    }
}
