//! `fixtures/tiny-lp`: every file is read as the program of which its answer is true.

use std::fs;

use boundfit_exact::Rational;
use boundfit_lp::{
    Bounds, ExchangeFormat, Model, ModelLimits, ModelRow, ObjectiveSense, model_text, read_model,
};
use boundfit_tests::lp_cases::number;
use boundfit_tests::program::root;
use serde_json::Value;

use super::naive;

/// Each program with its answer.
fn corpus() -> Vec<(String, String, Value)> {
    let folder = root().join("fixtures/tiny-lp");
    let names = fs::read_dir(&folder).unwrap().filter_map(|entry| {
        entry.unwrap().file_name().into_string().unwrap().strip_suffix(".mps").map(str::to_owned)
    });
    let mut names: Vec<String> = names.collect();
    names.sort();
    let read = |name: String| {
        let mps = fs::read(folder.join(format!("{name}.mps"))).unwrap();
        let json = fs::read_to_string(folder.join(format!("{name}.json"))).unwrap();
        let text = model_text(&mps).unwrap().to_owned();
        (name, text, serde_json::from_str(&json).unwrap())
    };
    names.into_iter().map(read).collect()
}

fn vector(value: &Value) -> Vec<Rational> {
    value.as_array().unwrap().iter().map(|text| number(text.as_str().unwrap())).collect()
}

fn vectors(value: &Value) -> Vec<Vec<Rational>> {
    value.as_array().into_iter().flatten().map(vector).collect()
}

fn form(row: &ModelRow, point: &[Rational]) -> Rational {
    row.coefficients.iter().fold(Rational::zero(), |sum, (column, value)| sum + value * &point[*column])
}

/// Returns the bounded quantities with their bounds: rows, then columns.
fn bounded<'a>(model: &'a Model, point: &[Rational]) -> Vec<(Rational, &'a Bounds)> {
    let rows = model.rows.iter().map(|row| (form(row, point), &row.bounds));
    let columns = model.columns.iter().zip(point).map(|(column, value)| (value.clone(), &column.bounds));
    rows.chain(columns).collect()
}

fn is_feasible(model: &Model, point: &[Rational], by: &Rational) -> bool {
    bounded(model, point).iter().all(|(value, bounds)| {
        bounds.lower.as_ref().is_none_or(|lower| value + by >= *lower)
            && bounds.upper.as_ref().is_none_or(|upper| value - by <= *upper)
    })
}

fn recedes(model: &Model, ray: &[Rational]) -> bool {
    bounded(model, ray).iter().all(|(value, bounds)| {
        (bounds.lower.is_none() || !value.is_negative()) && (bounds.upper.is_none() || !value.is_positive())
    })
}

/// The objective without its constant.
fn cost(model: &Model, point: &[Rational]) -> Rational {
    model.columns.iter().zip(point).fold(Rational::zero(), |sum, (column, value)| sum + &column.cost * value)
}

fn improves(model: &Model, ray: &[Rational]) -> bool {
    let change = cost(model, ray);
    let is_better = match model.sense {
        ObjectiveSense::Minimize => change.is_negative(),
        ObjectiveSense::Maximize => change.is_positive(),
    };
    recedes(model, ray) && is_better
}

/// The bound that prices prove.
fn proved(model: &Model, prices: &Value) -> Rational {
    let (rows, reduced) = (vector(&prices["rows"]), vector(&prices["reduced_costs"]));
    assert_eq!((rows.len(), reduced.len()), (model.rows.len(), model.columns.len()));
    for (place, (column, reduced)) in model.columns.iter().zip(&reduced).enumerate() {
        let priced = model.rows.iter().zip(&rows).flat_map(|(row, price)| {
            row.coefficients.iter().filter(|entry| entry.0 == place).map(move |entry| price * &entry.1)
        });
        assert_eq!(priced.fold(reduced.clone(), |sum, part| sum + part), column.cost);
    }
    let bounds =
        model.rows.iter().map(|row| &row.bounds).chain(model.columns.iter().map(|column| &column.bounds));
    let prices = rows.iter().chain(&reduced);
    prices.zip(bounds).filter(|(price, _)| !price.is_zero()).fold(
        model.constant.clone(),
        |sum, (price, bounds)| {
            let takes_lower = price.is_positive() == (model.sense == ObjectiveSense::Minimize);
            let side = if takes_lower { &bounds.lower } else { &bounds.upper };
            sum + price * side.as_ref().expect("a price on a finite side")
        },
    )
}

fn check_optimal(model: &Model, answer: &Value) {
    let optimum = number(answer["objective"].as_str().unwrap());
    let face = &answer["face"];
    let points = [vectors(&face["vertices"]), vectors(&face["points"])].concat();
    assert!(!points.is_empty());
    for point in points {
        assert!(is_feasible(model, &point, &Rational::zero()));
        assert_eq!(&cost(model, &point) + &model.constant, optimum);
    }
    let lines = vectors(&face["lines"]);
    let back = lines.iter().map(|line| line.iter().map(|value| -value).collect());
    for ray in vectors(&face["rays"]).into_iter().chain(lines.clone()).chain(back) {
        assert!(recedes(model, &ray) && cost(model, &ray).is_zero());
    }
    assert_eq!(proved(model, &answer["duals"]), optimum);
}

fn check_infeasible(model: &Model, answer: &Value) {
    let mut normal = vec![Rational::zero(); model.columns.len()];
    let mut total = Rational::zero();
    for part in answer["farkas"].as_array().unwrap() {
        let sign = if part["side"] == "lower" { Rational::one() } else { -Rational::one() };
        let multiplier = number(part["multiplier"].as_str().unwrap()) * sign;
        let bounds = if let Some(name) = part["row"].as_str() {
            let row = model.rows.iter().find(|row| row.name == name).unwrap();
            for (column, value) in &row.coefficients {
                normal[*column] = &normal[*column] + &(&multiplier * value);
            }
            &row.bounds
        } else {
            let place = model.columns.iter().position(|column| part["column"] == column.name.raw()).unwrap();
            normal[place] = &normal[place] + &multiplier;
            &model.columns[place].bounds
        };
        let side = if part["side"] == "lower" { &bounds.lower } else { &bounds.upper };
        total = total + multiplier * side.clone().unwrap();
    }
    let by = number(answer["infeasible_by"].as_str().unwrap());
    assert!(normal.iter().all(Rational::is_zero) && by.is_positive());
    assert_eq!(total, by);
    assert!(is_feasible(model, &vector(&answer["nearest"]), &by));
    match answer.get("dual_feasible") {
        Some(prices) => drop(proved(model, prices)),
        None => assert!(improves(model, &vector(&answer["dual_infeasible_ray"]))),
    }
}

#[test]
fn files_are_the_programs_of_their_answers() {
    let corpus = corpus();
    assert_eq!(corpus.len(), 340);
    for (name, text, answer) in corpus {
        let model = read_model(&text, ExchangeFormat::Mps, &ModelLimits::default())
            .unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(model, naive::read(&text), "{name}");
        let names = |value: &Value| -> Vec<String> {
            value.as_array().unwrap().iter().map(|name| name.as_str().unwrap().to_owned()).collect()
        };
        assert_eq!(model.name.raw(), name);
        assert_eq!(model.rows.iter().map(|row| row.name.raw()).collect::<Vec<_>>(), names(&answer["rows"]));
        let columns: Vec<String> = model.columns.iter().map(|column| column.name.raw().to_owned()).collect();
        assert_eq!(columns, names(&answer["columns"]));
        assert_eq!(answer["sense"] == "max", model.sense == ObjectiveSense::Maximize);
        match answer["status"].as_str().unwrap() {
            "optimal" => check_optimal(&model, &answer),
            "infeasible" => check_infeasible(&model, &answer),
            _ => {
                assert!(is_feasible(&model, &vector(&answer["point"]), &Rational::zero()), "{name}");
                assert!(improves(&model, &vector(&answer["ray"])), "{name}");
            }
        }
    }
}
