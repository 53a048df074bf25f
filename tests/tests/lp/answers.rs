//! Exact answers to generated models: against meeting every two lines, and every certificate multiplied out here.

use std::fs;

use boundfit_exact::Rational;
use boundfit_judge::{Answer, Basis, BasisStatus, Face, Item, Plane, Prices, SideMultiplier, SolveError};
use boundfit_lp::{
    Bounds, End, ExchangeFormat, Model, ModelColumn, ModelLimits, ModelRow, ObjectiveSense, read_model,
};
use boundfit_tests::generate::{seeded, share};
use boundfit_tests::lp_cases::number;
use boundfit_tests::models::{columns_left, model, truth};
use boundfit_tests::program::root;
use boundfit_tests::shape::Tally;
use serde_json::Value;

const CASES: usize = 24_000;

/// A row's or column's form with an entry per column, and its bounds: rows first.
fn limits(model: &Model) -> Vec<(Vec<Rational>, Bounds)> {
    let width = model.columns.len();
    let row = |ModelRow { coefficients, bounds, .. }: &ModelRow| {
        let mut form = vec![Rational::zero(); width];
        for (column, value) in coefficients {
            form[*column] = value.clone();
        }
        (form, bounds.clone())
    };
    let column = |(index, column): (usize, &ModelColumn)| {
        let form = (0..width).map(|own| Rational::from(i64::from(own == index))).collect();
        (form, column.bounds.clone())
    };
    model.rows.iter().map(row).chain(model.columns.iter().enumerate().map(column)).collect()
}

fn dot(form: &[Rational], point: &[Rational]) -> Rational {
    assert_eq!(form.len(), point.len());
    form.iter().zip(point).map(|(a, b)| a * b).sum()
}

fn costs(model: &Model) -> Vec<Rational> {
    model.columns.iter().map(|column| column.cost.clone()).collect()
}

/// +1 for a minimum, -1 for a maximum.
fn sense(model: &Model) -> Rational {
    Rational::from(if model.sense == ObjectiveSense::Minimize { 1 } else { -1 })
}

fn is_feasible(model: &Model, point: &[Rational]) -> bool {
    limits(model).iter().all(|(form, bounds)| {
        let value = dot(form, point);
        bounds.lower.as_ref().is_none_or(|lower| *lower <= value)
            && bounds.upper.as_ref().is_none_or(|upper| value <= *upper)
    })
}

fn recedes(model: &Model, ray: &[Rational]) -> bool {
    limits(model).iter().all(|(form, bounds)| {
        let change = dot(form, ray);
        (bounds.lower.is_none() || !change.is_negative()) && (bounds.upper.is_none() || !change.is_positive())
    })
}

/// Returns the bound on the objective that prices prove, by the conventions that `Prices` documents.
fn bound_of(model: &Model, prices: &Prices) -> Rational {
    let all: Vec<Rational> = prices.rows.iter().chain(&prices.columns).cloned().collect();
    let limits = limits(model);
    assert_eq!(all.len(), limits.len());
    for (column, cost) in costs(model).iter().enumerate() {
        let sum: Rational = limits.iter().zip(&all).map(|((form, _), price)| &form[column] * price).sum();
        assert_eq!(sum, *cost, "{model:?}");
    }
    let mut bound = model.constant.clone();
    for ((_, bounds), price) in limits.iter().zip(all).filter(|(_, price)| !price.is_zero()) {
        let side = if (&price * sense(model)).is_positive() { &bounds.lower } else { &bounds.upper };
        bound = bound + price * side.as_ref().expect("a price on an infinite bound");
    }
    bound
}

fn assert_contradiction(model: &Model, multipliers: &[SideMultiplier]) {
    let limits = limits(model);
    let mut sum = vec![Rational::zero(); model.columns.len()];
    let mut total = Rational::zero();
    for SideMultiplier { side, value } in multipliers {
        assert!(value.is_positive());
        let index = match side.item {
            Item::Row(row) => row,
            Item::Column(column) => model.rows.len() + column,
        };
        let (form, bounds) = &limits[index];
        let (times, bound) = match side.end {
            End::Lower => (value.clone(), &bounds.lower),
            End::Upper => (-value, &bounds.upper),
        };
        total = total + &times * bound.as_ref().expect("a bound that is not there");
        sum = sum.iter().zip(form).map(|(sum, entry)| sum + entry * &times).collect();
    }
    assert!(sum.iter().all(Rational::is_zero) && total.is_positive(), "{model:?} {multipliers:?}");
}

/// The basic solution is the first point, prices vanish on what is basic, and signs fit where it is not.
fn assert_basis(model: &Model, basis: &Basis, prices: &Prices, first: &[Rational]) {
    let limits = limits(model);
    let statuses = basis.rows.iter().chain(&basis.columns);
    let prices = prices.rows.iter().chain(&prices.columns);
    let mut held: Vec<Vec<Rational>> = Vec::new();
    for (((form, bounds), status), price) in limits.iter().zip(statuses).zip(prices) {
        let price = price * sense(model);
        let value = dot(form, first);
        match status {
            BasisStatus::Basic => assert!(price.is_zero(), "{model:?}"),
            BasisStatus::AtLower => assert!(bounds.lower == Some(value) && !price.is_negative(), "{model:?}"),
            BasisStatus::AtUpper => assert!(bounds.upper == Some(value) && !price.is_positive(), "{model:?}"),
            BasisStatus::Free => {
                assert!(*bounds == Bounds::default() && value.is_zero() && price.is_zero(), "{model:?}");
            }
        }
        if *status != BasisStatus::Basic {
            held.push(form.clone());
        }
    }
    assert_eq!(held.len(), model.columns.len(), "as many basic ones as rows: {model:?} {basis:?}");
    assert_eq!(rank(held), model.columns.len(), "{model:?} {basis:?}");
}

fn rank(mut rows: Vec<Vec<Rational>>) -> usize {
    let mut rank = 0;
    for column in 0..rows.first().map_or(0, Vec::len) {
        let Some(pivot) = (rank..rows.len()).find(|&row| !rows[row][column].is_zero()) else { continue };
        rows.swap(rank, pivot);
        for row in rank + 1..rows.len() {
            let factor = rows[row][column].checked_div(&rows[rank][column]).expect("a pivot");
            rows[row] = rows[row].iter().zip(&rows[rank]).map(|(own, other)| own - other * &factor).collect();
        }
        rank += 1;
    }
    rank
}

/// The entries of the columns that are left; others have the value that is given.
fn in_plane(model: &Model, vector: &[Rational], is_point: bool) -> Vec<Rational> {
    let left = columns_left(model);
    for (index, (column, value)) in model.columns.iter().zip(vector).enumerate() {
        if !left.contains(&index) {
            let expected =
                if is_point { column.bounds.lower.clone().expect("fixed") } else { Rational::zero() };
            assert_eq!(*value, expected);
        }
    }
    left.iter().map(|&index| vector[index].clone()).collect()
}

fn sorted(mut vectors: Vec<Vec<Rational>>) -> Vec<Vec<Rational>> {
    vectors.sort();
    vectors
}

fn assert_face(model: &Model, value: &Rational, face: &Face) {
    let truth = truth(model);
    let left = columns_left(model).len();
    let cut = |vectors: Vec<[Rational; 2]>| sorted(vectors.into_iter().map(|v| v[..left].to_vec()).collect());
    let whole = |vectors: &[[i64; 2]]| cut(vectors.iter().map(|v| v.map(Rational::from)).collect());
    let flat = |vectors: &[Vec<Rational>], is_point| {
        sorted(vectors.iter().map(|vector| in_plane(model, vector, is_point)).collect())
    };
    assert_eq!(Some(value), truth.value.as_ref(), "{model:?}");
    assert_eq!(flat(&face.vertices, true), cut(truth.vertices), "{model:?}");
    assert_eq!(flat(&face.rays, false), whole(&truth.rays), "{model:?}");
    assert_eq!(flat(&face.lines, false), whole(&truth.lines), "{model:?}");
    let points: Vec<&Vec<Rational>> = face.vertices.iter().chain(&face.points).collect();
    for point in &points {
        assert!(is_feasible(model, point), "{model:?}");
        assert_eq!(dot(&costs(model), point) + &model.constant, *value, "{model:?}");
    }
    let expected = match (face.vertices.is_empty(), truth.kind) {
        (false, _) => 0,
        (true, "strip") if costs_in_plane_vanish(model) => 2,
        (true, _) => 1,
    };
    assert_eq!(face.points.len(), expected, "{model:?}");
    if let [one, other] = &face.points[..] {
        // On the two sides of a strip: what is beyond either of them is not feasible.
        for (from, to) in [(one, other), (other, one)] {
            let beyond: Vec<Rational> = from.iter().zip(to).map(|(from, to)| to + to - from).collect();
            assert!(!is_feasible(model, &beyond), "{model:?}");
        }
    }
}

fn costs_in_plane_vanish(model: &Model) -> bool {
    columns_left(model).iter().all(|&index| model.columns[index].cost.is_zero())
}

fn check(model: &Model) -> &'static str {
    let answer = Answer::of(model).unwrap_or_else(|error| panic!("{error}: {model:?}"));
    assert_eq!(answer.verify(model), Ok(()), "{model:?}");
    let status = match &answer {
        Answer::Optimal { value, face, prices, basis } => {
            assert_face(model, value, face);
            assert_eq!(bound_of(model, prices), *value, "{model:?}");
            assert_basis(model, basis, prices, face.vertices.first().unwrap_or_else(|| &face.points[0]));
            "optimal"
        }
        Answer::Infeasible { multipliers } => {
            assert_contradiction(model, multipliers);
            "infeasible"
        }
        Answer::Unbounded { point, ray } => {
            assert!(is_feasible(model, point) && recedes(model, ray), "{model:?}");
            assert!((dot(&costs(model), ray) * sense(model)).is_negative(), "{model:?}");
            "unbounded"
        }
    };
    assert_eq!(status, truth(model).status, "{model:?}");
    status
}

/// Writes the model in both formats, reads it back, and answers that: rows may have been scaled or split, but the
/// points are the same. Returns how many of the two could be compared. Bounds of columns that have no decimals become
/// rows, after which more columns may be left, and an objective of that kind is scaled.
fn check_in_files(model: &Model) -> usize {
    let answer = Answer::of(model).unwrap();
    let compared = ExchangeFormat::ALL.into_iter().filter(|&format| {
        let text = model.text(format);
        let back = read_model(&text, format, &ModelLimits::default())
            .unwrap_or_else(|error| panic!("{error}\n{text}"));
        let read = match Answer::of(&back) {
            Err(SolveError::TooManyColumns { .. }) if columns_left(&back) != columns_left(model) => {
                return false;
            }
            read => read.unwrap_or_else(|error| panic!("{error}\n{text}")),
        };
        let is_scaled = text.contains("cost is multiplied by");
        match (&answer, read) {
            (Answer::Optimal { value, face, .. }, Answer::Optimal { value: again, face: read, .. }) => {
                assert!(is_scaled || again == *value, "{text}");
                assert_eq!(sorted(read.vertices), sorted(face.vertices.clone()), "{text}");
            }
            (Answer::Infeasible { .. }, Answer::Infeasible { .. })
            | (Answer::Unbounded { .. }, Answer::Unbounded { .. }) => {}
            (answer, read) => panic!("{answer:?}, read back {read:?}\n{text}"),
        }
        !is_scaled
    });
    compared.count()
}

#[test]
fn answers_of_generated_models_are_those_of_every_two_lines() {
    let mut rng = seeded(1_401);
    let mut tally = Tally::default();
    let mut in_files = 0;
    for _ in 0..share(CASES) {
        let model = model(&mut rng);
        let status = check(&model);
        in_files += check_in_files(&model);
        let left = columns_left(&model).len();
        tally.count(["none left", "one left", "two left"][left]);
        tally.count(status);
        tally.count(truth(&model).kind);
        if let Ok(Answer::Optimal { face, .. }) = Answer::of(&model) {
            let shape = (face.vertices.len(), face.rays.len(), face.lines.len());
            tally.count(match shape {
                (1, 0, 0) => "optimal: vertex",
                (2, 0, 0) => "optimal: edge",
                (1, 1, 0) => "optimal: ray",
                (0, 0, 1) => "optimal: line",
                _ => "optimal: more",
            });
        }
    }
    let cases = [
        "none left",
        "one left",
        "two left",
        "optimal",
        "infeasible",
        "unbounded",
        "empty",
        "point",
        "segment",
        "ray",
        "line",
        "polygon",
        "unbounded-polygon",
        "strip",
        "half-plane",
        "plane",
        "optimal: vertex",
        "optimal: edge",
        "optimal: ray",
        "optimal: line",
        "optimal: more",
    ];
    tally.assert_each(50, &cases);
    assert!(in_files > share(40_000), "{in_files}");
}

/// The answer files of `fixtures/tiny-lp` have the same status, optimum and optimal points; its prices, certificates and rays
/// need not be those of the answer, which are multiplied out here.
#[test]
fn answers_of_the_corpus_are_those_of_its_files() {
    let folder = root().join("fixtures/tiny-lp");
    let mut tally = Tally::default();
    for entry in fs::read_dir(&folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|ending| ending != "mps") {
            continue;
        }
        let text = fs::read_to_string(&path).unwrap();
        let model = read_model(&text, ExchangeFormat::Mps, &ModelLimits::default()).unwrap();
        let expected: Value =
            serde_json::from_slice(&fs::read(path.with_extension("json")).unwrap()).unwrap();
        let answer = Answer::of(&model).unwrap();
        assert_eq!(answer.verify(&model), Ok(()), "{path:?}");
        let status = match &answer {
            Answer::Optimal { value, face, prices, basis } => {
                assert_eq!(*value, number(expected["objective"].as_str().unwrap()), "{path:?}");
                assert_same_face(face, &expected["face"]);
                assert_eq!(bound_of(&model, prices), *value, "{path:?}");
                let first = face.vertices.first().unwrap_or_else(|| &face.points[0]);
                assert_basis(&model, basis, prices, first);
                "optimal"
            }
            Answer::Infeasible { multipliers } => {
                assert_contradiction(&model, multipliers);
                "infeasible"
            }
            Answer::Unbounded { point, ray } => {
                assert!(is_feasible(&model, point) && recedes(&model, ray), "{path:?}");
                assert!((dot(&costs(&model), ray) * sense(&model)).is_negative(), "{path:?}");
                "unbounded"
            }
        };
        assert_eq!(expected["status"], status, "{path:?}");
        tally.count(status);
    }
    tally.assert_each(30, &["optimal", "infeasible", "unbounded"]);
}

fn assert_same_face(face: &Face, expected: &Value) {
    let vectors = |value: &Value| -> Vec<Vec<Rational>> {
        let vector = |value: &Value| {
            value.as_array().unwrap().iter().map(|text| number(text.as_str().unwrap())).collect()
        };
        value.as_array().into_iter().flatten().map(vector).collect()
    };
    // A line has two directions, and either will do.
    let turned = |lines: Vec<Vec<Rational>>| -> Vec<Vec<Rational>> {
        let turn = |line: Vec<Rational>| {
            let first = line.iter().find(|entry| !entry.is_zero()).expect("a direction");
            if first.is_negative() { line.iter().map(|entry| -entry).collect() } else { line }
        };
        lines.into_iter().map(turn).collect()
    };
    assert_eq!(sorted(face.vertices.clone()), sorted(vectors(&expected["vertices"])));
    assert_eq!(sorted(face.rays.clone()), sorted(vectors(&expected["rays"])));
    assert_eq!(sorted(turned(face.lines.clone())), sorted(turned(vectors(&expected["lines"]))));
    assert_eq!(face.points.len(), vectors(&expected["points"]).len());
}

fn column(name: &str, lower: Option<i64>, upper: Option<i64>) -> ModelColumn {
    let bounds = Bounds { lower: lower.map(Into::into), upper: upper.map(Into::into) };
    ModelColumn { name: name.into(), cost: Rational::one(), bounds }
}

#[test]
fn more_than_two_columns_are_refused_by_name() {
    let columns = ["a", "b", "c", "d", "e"].map(|name| column(name, Some(0), (name == "b").then_some(0)));
    let model = Model { columns: columns.into(), ..Model::default() };
    let error = Answer::of(&model).unwrap_err();
    let expected = "4 columns are not fixed by their bounds, first a, c and d (expected at most two)";
    assert_eq!(error.to_string(), expected);
    assert!(Plane::new(&model).is_err());
}

#[test]
fn a_row_about_no_column_is_refused() {
    let row = ModelRow { name: "r".into(), coefficients: vec![(1, 1.into())], bounds: Bounds::default() };
    let model = Model { columns: vec![column("a", None, None)], rows: vec![row], ..Model::default() };
    assert_eq!(Answer::of(&model), Err(SolveError::NoSuchColumn { row: "r".into() }));
}

#[test]
fn a_false_answer_is_not_verified() {
    let model = Model { columns: vec![column("a", Some(1), None)], ..Model::default() };
    let Ok(Answer::Optimal { value, face, prices, basis }) = Answer::of(&model) else { panic!() };
    let optimal = |value: &Rational, face: &Face, prices: &Prices| Answer::Optimal {
        value: value.clone(),
        face: face.clone(),
        prices: prices.clone(),
        basis: basis.clone(),
    };
    assert_eq!(optimal(&value, &face, &prices).verify(&model), Ok(()));
    let whole = |numbers: &[i64]| numbers.iter().copied().map(Rational::from).collect::<Vec<_>>();
    let none = Face { vertices: Vec::new(), points: Vec::new(), rays: Vec::new(), lines: Vec::new() };
    let at = |point: &[i64]| Face { vertices: vec![whole(point)], ..none.clone() };
    let priced = |price: i64| Prices { rows: Vec::new(), columns: whole(&[price]) };
    let along = |ray: i64| Face { rays: vec![whole(&[ray])], ..face.clone() };
    let refused = [
        (optimal(&2.into(), &face, &prices), "the prices do not prove the optimum"),
        (optimal(&value, &none, &prices), "there is no optimal point"),
        (optimal(&value, &at(&[0]), &prices), "a point is not feasible"),
        (optimal(&value, &at(&[2]), &prices), "an optimal point does not attain the optimum"),
        (optimal(&value, &at(&[]), &prices), "a point has not one value for each column"),
        (optimal(&value, &face, &priced(2)), "prices times coefficients do not add up to the costs"),
        (optimal(&value, &along(-1), &prices), "a direction leaves the feasible set"),
        (optimal(&value, &along(1), &prices), "the objective changes along an optimal direction"),
        (Answer::Unbounded { point: whole(&[0]), ray: whole(&[1]) }, "a point is not feasible"),
        (
            Answer::Unbounded { point: whole(&[1]), ray: whole(&[1]) },
            "the objective does not improve along the ray",
        ),
        (
            Answer::Infeasible { multipliers: Vec::new() },
            "the multiplied bounds do not contradict each other",
        ),
    ];
    for (answer, reason) in refused {
        assert_eq!(answer.verify(&model), Err(reason));
    }
}
