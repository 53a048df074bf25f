//! Proofs of answers, multiplied out in the model as it was given: nothing here knows of planes or half-planes.

use boundfit_exact::Rational;
use boundfit_lp::{Bounds, Model, ModelRow, ObjectiveSense};

use crate::answer::{Answer, Item, Prices, SideMultiplier};

impl Answer {
    /// Recomputes the proof from the model alone. Exact. Cost: the size of the model for each point and direction.
    ///
    /// That a face has all optimal points is not proved here, only that all of it is optimal.
    ///
    /// # Errors
    /// The first statement that is false, in words.
    pub fn verify(&self, model: &Model) -> Result<(), &'static str> {
        match self {
            Answer::Optimal { value, face, prices, .. } => {
                for direction in face.rays.iter().chain(&face.lines) {
                    recedes(model, direction)?;
                    is_level(model, direction)?;
                }
                for line in &face.lines {
                    let backwards: Vec<Rational> = line.iter().map(|entry| -entry).collect();
                    recedes(model, &backwards)?;
                }
                proves_optimal(model, value, prices, face.vertices.iter().chain(&face.points))
            }
            Answer::Infeasible { multipliers } => proves_infeasible(model, multipliers),
            Answer::Unbounded { point, ray } => proves_unbounded(model, point, ray),
        }
    }
}

/// Returns whether prices bound the objective by this value, and all of these points, of which there is one, attain it.
pub(crate) fn proves_optimal<'a>(
    model: &Model,
    value: &Rational,
    prices: &Prices,
    points: impl Iterator<Item = &'a Vec<Rational>>,
) -> Result<(), &'static str> {
    if bound_of(model, prices)? != *value {
        return Err("the prices do not prove the optimum");
    }
    let mut any = false;
    for point in points {
        any = true;
        is_feasible(model, point)?;
        if value_of(model, point) != *value {
            return Err("an optimal point does not attain the optimum");
        }
    }
    if any { Ok(()) } else { Err("there is no optimal point") }
}

/// Returns what prices prove of the objective: each times the bound that its sign says.
///
/// # Errors
/// When they do not add up to the costs, or push against a bound that is not there.
pub(crate) fn bound_of(model: &Model, prices: &Prices) -> Result<Rational, &'static str> {
    if prices.rows.len() != model.rows.len() || prices.columns.len() != model.columns.len() {
        return Err("there is not one price for each row and column");
    }
    let mut left: Vec<Rational> = model.columns.iter().map(|column| column.cost.clone()).collect();
    for (left, price) in left.iter_mut().zip(&prices.columns) {
        *left = &*left - price;
    }
    for (row, price) in model.rows.iter().zip(&prices.rows) {
        take(&mut left, row, price)?;
    }
    if left.iter().any(|left| !left.is_zero()) {
        return Err("prices times coefficients do not add up to the costs");
    }
    let sign = sign_of(model.sense);
    let mut bound = model.constant.clone();
    let rows = model.rows.iter().map(|row| &row.bounds).zip(&prices.rows);
    let columns = model.columns.iter().map(|column| &column.bounds).zip(&prices.columns);
    for (bounds, price) in rows.chain(columns).filter(|(_, price)| !price.is_zero()) {
        let active = if (price * &sign).is_positive() { &bounds.lower } else { &bounds.upper };
        bound = bound + price * active.as_ref().ok_or("a price stands for a bound that is not there")?;
    }
    Ok(bound)
}

/// Returns whether the multiplied bounds add up to `0 ≥` something positive.
pub(crate) fn proves_infeasible(model: &Model, multipliers: &[SideMultiplier]) -> Result<(), &'static str> {
    let mut left = vec![Rational::zero(); model.columns.len()];
    let mut total = Rational::zero();
    for SideMultiplier { side, value } in multipliers {
        if !value.is_positive() {
            return Err("a multiplier is not positive");
        }
        let times = value * Rational::from(side.sign());
        let bound = side.bound(model).ok_or("a multiplier stands for a bound that is not there")?;
        total = total + bound * &times;
        match side.item {
            Item::Row(row) => take(&mut left, model.rows.get(row).ok_or("there is no such row")?, &times)?,
            Item::Column(column) => {
                let entry = left.get_mut(column).ok_or("there is no such column")?;
                *entry = &*entry - times;
            }
        }
    }
    if left.iter().any(|left| !left.is_zero()) {
        return Err("the multiplied rows do not add up to nothing");
    }
    if total.is_positive() { Ok(()) } else { Err("the multiplied bounds do not contradict each other") }
}

/// Returns whether the point is feasible and the ray stays so and improves.
pub(crate) fn proves_unbounded(
    model: &Model,
    point: &[Rational],
    ray: &[Rational],
) -> Result<(), &'static str> {
    is_feasible(model, point)?;
    recedes(model, ray)?;
    let change = change_along(model, ray) * sign_of(model.sense);
    if change.is_negative() { Ok(()) } else { Err("the objective does not improve along the ray") }
}

/// The form of a row at a point; entries that are missing count as 0.
pub(crate) fn row_value(row: &ModelRow, point: &[Rational]) -> Rational {
    let terms = row.coefficients.iter().filter_map(|(column, value)| Some(value * point.get(*column)?));
    terms.fold(Rational::zero(), |sum, term| sum + term)
}

/// Takes a multiple of a row's form away.
fn take(left: &mut [Rational], row: &ModelRow, times: &Rational) -> Result<(), &'static str> {
    if times.is_zero() {
        return Ok(());
    }
    for (column, coefficient) in &row.coefficients {
        let entry = left.get_mut(*column).ok_or("a row names a column that is not there")?;
        *entry = &*entry - coefficient * times;
    }
    Ok(())
}

fn is_feasible(model: &Model, point: &[Rational]) -> Result<(), &'static str> {
    if point.len() != model.columns.len() {
        return Err("a point has not one value for each column");
    }
    let holds = |bounds: &Bounds, value: &Rational| {
        bounds.lower.as_ref().is_none_or(|lower| lower <= value)
            && bounds.upper.as_ref().is_none_or(|upper| value <= upper)
    };
    let columns = model.columns.iter().zip(point).all(|(column, value)| holds(&column.bounds, value));
    let rows = model.rows.iter().all(|row| holds(&row.bounds, &row_value(row, point)));
    if columns && rows { Ok(()) } else { Err("a point is not feasible") }
}

fn recedes(model: &Model, ray: &[Rational]) -> Result<(), &'static str> {
    if ray.len() != model.columns.len() {
        return Err("a direction has not one entry for each column");
    }
    let stays = |bounds: &Bounds, value: &Rational| {
        !(bounds.lower.is_some() && value.is_negative() || bounds.upper.is_some() && value.is_positive())
    };
    let columns = model.columns.iter().zip(ray).all(|(column, value)| stays(&column.bounds, value));
    let rows = model.rows.iter().all(|row| stays(&row.bounds, &row_value(row, ray)));
    if columns && rows { Ok(()) } else { Err("a direction leaves the feasible set") }
}

/// Returns what the objective gains along a direction.
fn change_along(model: &Model, ray: &[Rational]) -> Rational {
    let terms = model.columns.iter().zip(ray).map(|(column, value)| &column.cost * value);
    terms.fold(Rational::zero(), |sum, term| sum + term)
}

fn is_level(model: &Model, direction: &[Rational]) -> Result<(), &'static str> {
    let change = change_along(model, direction);
    if change.is_zero() { Ok(()) } else { Err("the objective changes along an optimal direction") }
}

/// +1 for a minimum, −1 for a maximum.
pub(crate) fn sign_of(sense: ObjectiveSense) -> Rational {
    match sense {
        ObjectiveSense::Minimize => Rational::one(),
        ObjectiveSense::Maximize => -Rational::one(),
    }
}

/// The objective at a point, its constant included.
pub(crate) fn value_of(model: &Model, point: &[Rational]) -> Rational {
    let terms = model.columns.iter().zip(point).map(|(column, value)| &column.cost * value);
    terms.fold(model.constant.clone(), |sum, term| sum + term)
}
