//! Generated models of linear programs, and their answers by brute force: nothing here uses the polygon engine, the exact
//! simplex or the judge.

use boundfit_exact::Rational;
use boundfit_lp::{Bounds, Model, ModelColumn, ModelRow, ObjectiveSense};
use rand::RngExt;
use rand::seq::SliceRandom;
use rand_chacha::ChaCha8Rng;

use crate::oracle::{self, Row};

/// Returns a model of at most two free columns and up to two fixed ones, degenerate more often than not.
/// - Rows go through one point, repeat, are scaled, parallel or opposite.
/// - Some rows are equations, ranges, or lack coefficients or bounds.
/// - Some bounds cross, and some columns have no rows.
pub fn model(rng: &mut ChaCha8Rng) -> Model {
    let left = [2, 2, 2, 2, 2, 1, 1, 0][rng.random_range(0..8)];
    let fixed = [0, 0, 0, 1, 2][rng.random_range(0..5)];
    let mut kinds = vec![true; left];
    kinds.resize(left + fixed, false);
    kinds.shuffle(rng);
    // Most bounds pass through one point.
    let point: Vec<Rational> = kinds.iter().map(|_| small(rng)).collect();
    let column = |(index, (left, at)): (usize, (&bool, &Rational))| ModelColumn {
        name: format!("x{index}").into(),
        cost: coefficient(rng),
        bounds: if *left { column_bounds(rng, at) } else { equal(at.clone()) },
    };
    let columns = kinds.iter().zip(&point).enumerate().map(column).collect();
    let mut model = Model {
        name: "generated".into(),
        sense: if rng.random_bool(0.5) { ObjectiveSense::Minimize } else { ObjectiveSense::Maximize },
        objective_name: "cost".into(),
        constant: if rng.random_bool(0.3) { small(rng) } else { Rational::zero() },
        columns,
        rows: Vec::new(),
    };
    for index in 0..rng.random_range(0..8) {
        let row = row(rng, &model, &point, index);
        model.rows.push(row);
    }
    aim(rng, &mut model);
    model
}

/// Turns the objective: to nothing, or along a row, so that an edge or a line is optimal.
fn aim(rng: &mut ChaCha8Rng, model: &mut Model) {
    let choice = rng.random_range(0..8);
    let along = model.rows.last().filter(|_| choice < 3).map(|row| row.coefficients.clone());
    if choice > 3 {
        return;
    }
    for column in &mut model.columns {
        column.cost = Rational::zero();
    }
    for (column, value) in along.into_iter().flatten() {
        model.columns[column].cost = if choice == 0 { -value } else { value };
    }
}

fn small(rng: &mut ChaCha8Rng) -> Rational {
    Rational::ratio(rng.random_range(-6..=6), [1, 1, 1, 2, 3][rng.random_range(0..5)])
}

fn coefficient(rng: &mut ChaCha8Rng) -> Rational {
    let size = [1, 1, 2, 5][rng.random_range(0..4)];
    Rational::ratio(rng.random_range(-size..=size), [1, 1, 1, 2][rng.random_range(0..4)])
}

fn equal(value: Rational) -> Bounds {
    Bounds { lower: Some(value.clone()), upper: Some(value) }
}

/// Bounds around a value, most of them active there.
fn bounds_at(rng: &mut ChaCha8Rng, value: &Rational) -> Bounds {
    let mut away = || if rng.random_bool(0.6) { Rational::zero() } else { small(rng).abs().half() };
    let (below, above) = (value - away(), value + away());
    match rng.random_range(0..16) {
        0..5 => Bounds { lower: Some(below), upper: None },
        5..10 => Bounds { lower: None, upper: Some(above) },
        10 | 11 => Bounds { lower: Some(below), upper: Some(above) },
        12 | 13 => equal(value.clone()),
        14 => Bounds::default(),
        // They cross, unless both are active.
        _ => Bounds { lower: Some(above), upper: Some(below) },
    }
}

fn column_bounds(rng: &mut ChaCha8Rng, at: &Rational) -> Bounds {
    let zero = Some(Rational::zero());
    match rng.random_range(0..20) {
        0..6 => Bounds::default(),
        6..11 => Bounds { lower: zero, upper: None },
        11 => Bounds { lower: None, upper: zero },
        _ => {
            let bounds = bounds_at(rng, at);
            // A column that is to be left must not be fixed.
            if bounds.fixed().is_some() { Bounds { upper: None, ..bounds } } else { bounds }
        }
    }
}

fn row(rng: &mut ChaCha8Rng, model: &Model, point: &[Rational], index: usize) -> ModelRow {
    let fresh = |rng: &mut ChaCha8Rng| {
        let coefficients = (0..model.columns.len()).map(|column| (column, coefficient(rng)));
        coefficients.filter(|(_, value)| !value.is_zero()).collect::<Vec<_>>()
    };
    let coefficients = match (model.rows.last(), rng.random_range(0..10)) {
        (_, 0) => Vec::new(),
        (Some(last), 1..5) => {
            let times = Rational::ratio([-2, -1, 1, 3][rng.random_range(0..4)], 1);
            last.coefficients.iter().map(|(column, value)| (*column, value * &times)).collect()
        }
        _ => fresh(rng),
    };
    let value: Rational = coefficients.iter().map(|(column, value)| value * &point[*column]).sum();
    let value = if rng.random_bool(0.2) { value + small(rng) } else { value };
    ModelRow { name: format!("r{index}").into(), coefficients, bounds: bounds_at(rng, &value) }
}

/// The truth about a model, in the plane of the columns that bounds do not fix.
#[derive(Debug)]
pub struct Truth {
    /// `optimal`, `infeasible` or `unbounded`.
    pub status: &'static str,
    /// The optimum.
    pub value: Option<Rational>,
    /// All optimal vertices.
    pub vertices: Vec<[Rational; 2]>,
    /// Directions in which the optimal points go on, without lines; coprime.
    pub rays: Vec<[i64; 2]>,
    /// Directions in which they go on both ways; the first entry that is not 0 is positive.
    pub lines: Vec<[i64; 2]>,
    /// The kind of the feasible set.
    pub kind: &'static str,
}

/// A model's columns that bounds do not fix.
pub fn columns_left(model: &Model) -> Vec<usize> {
    (0..model.columns.len()).filter(|&index| !is_fixed(&model.columns[index])).collect()
}

fn is_fixed(column: &ModelColumn) -> bool {
    matches!(&column.bounds, Bounds { lower: Some(lower), upper: Some(upper) } if lower == upper)
}

/// The answer by meeting every two lines. For small numbers.
pub fn truth(model: &Model) -> Truth {
    let left = columns_left(model);
    let value_at = |theta: &[Rational; 2]| {
        let part = |(index, column): (usize, &ModelColumn)| match left.iter().position(|own| *own == index) {
            Some(axis) => &column.cost * &theta[axis],
            None => &column.cost * column.bounds.lower.as_ref().expect("fixed"),
        };
        model.columns.iter().enumerate().map(part).sum::<Rational>() + &model.constant
    };
    let zero = [Rational::zero(), Rational::zero()];
    let towards = |direction: &[i128; 2]| {
        let theta = direction.map(|entry| Rational::from(i64::try_from(entry).expect("small")));
        let change = value_at(&theta) - value_at(&zero);
        if model.sense == ObjectiveSense::Maximize { change } else { -change }
    };
    let rows = half_planes(model, &left);
    let set = oracle::solve(&rows);
    let nothing = |status| Truth {
        status,
        value: None,
        vertices: Vec::new(),
        rays: Vec::new(),
        lines: Vec::new(),
        kind: set.kind,
    };
    if set.kind == "empty" {
        return nothing("infeasible");
    }
    let grows = set.rays.iter().any(|ray| towards(ray).is_positive());
    if grows || set.lines.iter().any(|line| !towards(line).is_zero()) {
        return nothing("unbounded");
    }
    let of_triple = |[x, y, w]: &[i128; 3]| {
        let ratio =
            |p: &i128| Rational::ratio((*p).try_into().expect("small"), (*w).try_into().expect("small"));
        [ratio(x), ratio(y)]
    };
    let vertices: Vec<[Rational; 2]> = set.vertices.iter().map(|(point, _)| of_triple(point)).collect();
    // Without a vertex, a point of every line that bounds the set, or any point of the plane.
    let feet = rows
        .iter()
        .filter(|row| row[..2] != [0, 0])
        .map(|&[a, b, c]| of_triple(&[a * c, b * c, a * a + b * b]));
    let is_in = |theta: &[Rational; 2]| {
        rows.iter().all(|row| {
            let [a, b, c] = row.map(|entry| Rational::from(i64::try_from(entry).expect("small")));
            a * &theta[0] + b * &theta[1] <= c
        })
    };
    let starts: Vec<[Rational; 2]> = match (vertices.is_empty(), set.kind) {
        (false, _) => vertices.clone(),
        (true, "plane") => vec![zero.clone()],
        _ => feet.filter(is_in).collect(),
    };
    let values = starts.iter().map(value_at);
    let best = if model.sense == ObjectiveSense::Maximize { values.max() } else { values.min() };
    let best = best.expect("a set that is not empty has a start");
    let small = |direction: &[i128; 2]| direction.map(|entry| i64::try_from(entry).expect("small"));
    // A half-plane's ray is optimal only with no objective; others by what they change.
    let rays = set.rays.iter().filter(|ray| towards(ray).is_zero()).map(small);
    Truth {
        status: "optimal",
        vertices: vertices.into_iter().filter(|theta| value_at(theta) == best).collect(),
        rays: rays.collect(),
        lines: set.lines.iter().map(small).collect(),
        kind: set.kind,
        value: Some(best),
    }
}

/// All bounds as `a1·θ1 + a2·θ2 ≤ b` in whole numbers; coordinates that the model has not are 0.
fn half_planes(model: &Model, left: &[usize]) -> Vec<Row> {
    let mut rows = Vec::new();
    let mut push = |form: [Rational; 2], constant: &Rational, bounds: &Bounds| {
        let [a, b] = form;
        if let Some(upper) = &bounds.upper {
            rows.push(whole([a.clone(), b.clone(), upper - constant]));
        }
        if let Some(lower) = &bounds.lower {
            rows.push(whole([-a, -b, constant - lower]));
        }
    };
    for ModelRow { coefficients, bounds, .. } in &model.rows {
        let mut form = [Rational::zero(), Rational::zero()];
        let mut constant = Rational::zero();
        for (column, value) in coefficients {
            match left.iter().position(|own| own == column) {
                Some(axis) => form[axis] = value.clone(),
                None => {
                    constant = constant + value * model.columns[*column].bounds.lower.as_ref().expect("fixed")
                }
            }
        }
        push(form, &constant, bounds);
    }
    for axis in 0..2 {
        let form = [0, 1].map(|own| Rational::from(i64::from(own == axis)));
        let bounds =
            left.get(axis).map_or(equal(Rational::zero()), |&index| model.columns[index].bounds.clone());
        push(form, &Rational::zero(), &bounds);
    }
    rows
}

/// Times a number that makes all of them whole.
fn whole(numbers: [Rational; 3]) -> Row {
    let common = numbers.iter().fold(1_i64, |common, number| {
        let denominator = number.denominator().to_i64().expect("small");
        common * denominator / gcd(common, denominator)
    });
    numbers.map(|number| {
        let whole = number * Rational::from(common);
        i128::from(whole.numerator().to_i64().expect("small"))
    })
}

fn gcd(a: i64, b: i64) -> i64 {
    if b == 0 { a } else { gcd(b, a % b) }
}
