//! The JSON report of a fit: every key, every number, and every proof recomputed from the file alone.

use std::collections::BTreeSet;

use boundfit_exact::Rational;
use serde_json::{Value, json};

use boundfit_tests::cli::fits::{Case, Measurement, all, published_polygons};
use boundfit_tests::cli::numbers::{
    Direction, check_numbers, exact, exact_or_null, is_rounded, pair, rational, whole,
};
use boundfit_tests::cli::regions::check_region;
use boundfit_tests::cli::schema::{FIT, check_schema};
use boundfit_tests::cli::{FIT_TRANSDUCER, directory_with, report};
use boundfit_tests::program::root;

/// Runs every fit and hands its report to a check.
fn for_each_fit(check: impl Fn(&Case, &Value)) {
    for case in all() {
        println!("{}", case.command_line());
        check(&case, &case.report());
    }
}

#[test]
fn units_follow_from_the_names_of_columns() {
    let directory = directory_with(&[("data.csv", b"U (mV),s [mm],t\n0,0,1\n1,2,2\n2,4,1\n")]);
    for (columns, units) in [
        ("--x 1 --y 2", json!({"x": ["mV"], "y": "mm", "theta1": "mm/mV", "theta2": "mm"})),
        ("--x 3 --y 2", json!({"x": [null], "y": "mm", "theta1": null, "theta2": "mm"})),
        ("--x 1,3 --y 2", json!({"x": ["mV", null], "y": "mm", "theta1": "mm/mV", "theta2": null})),
    ] {
        let found = report(directory.path(), &format!("fit data.csv {columns} --eps 9"), b"");
        assert_eq!(found["input"]["units"], units, "{columns}");
    }
    let found = report(&root(), FIT_TRANSDUCER, b"");
    assert!(found["input"].get("units").is_none());
    assert_eq!(found["program"], json!({"name": "boundfit", "version": env!("CARGO_PKG_VERSION")}));
}

#[test]
fn every_promised_key_is_there_with_its_type() {
    for_each_fit(|case, report| {
        check_schema(report, FIT);
        assert_eq!(report["schema"], "boundfit/fit/2");
        assert_eq!(report["fps"]["kind"], case.kind);
        let input = &report["input"];
        assert_eq!(input["rows"], case.measurements().len());
        assert_eq!(input["rows_total"], case.csv.lines().count() - 1);
        assert_eq!(input["reading"], case.reading.name());
        let hash = input["sha256"].as_str().unwrap();
        assert!(hash.len() == 64 && hash.bytes().all(|byte| b"0123456789abcdef".contains(&byte)), "{hash}");
    });
}

#[test]
fn the_fits_are_of_every_kind() {
    let kinds: BTreeSet<&str> = all().iter().map(|case| case.kind).collect();
    assert_eq!(kinds.len(), 10, "{kinds:?}");
}

#[test]
fn the_hash_is_that_of_the_file() {
    let report = report(&boundfit_tests::program::root(), FIT_TRANSDUCER, b"");
    let expected = "c940e48f1ce2eddb64ae36f5e9af3c036f0dd04934a1137cf509fee7402c81a9";
    assert_eq!(report["input"]["sha256"], expected);
}

#[test]
fn every_decimal_is_the_documented_rounding_of_the_exact_value() {
    for_each_fit(|case, report| {
        let count = check_numbers(report, 5);
        assert!(count >= 3, "{}: {count} numbers", case.kind);
    });
}

#[test]
fn a_wrong_decimal_is_noticed() {
    use Direction::{Down, Nearest, Up};
    for (exact, decimal, direction) in [
        ("1/3", "0.33333", Nearest),
        ("1/3", "0.33333", Down),
        ("1/3", "0.33334", Up),
        ("-2/3", "-0.66667", Down),
        ("20", "20", Up),
        ("1/2000", "5e-4", Down),
        ("123456", "1.2346e5", Up),
        ("246913/2", "1.2346e5", Nearest),
        ("999999/1000000", "1.0000", Up),
        ("0", "0", Nearest),
    ] {
        assert!(is_rounded(exact, decimal, 5, direction), "{exact} {decimal} {direction:?}");
    }
    for (exact, decimal, direction) in [
        ("1/3", "0.33334", Nearest),
        ("1/3", "0.33333", Up),
        ("1/3", "0.33335", Up),
        ("1/3", "0.333", Down),
        ("1/3", "0.333333", Down),
        ("1/2000", "5.0001e-4", Up),
        ("1/2000", "5.0e-4", Up),
        ("20", "21", Up),
        ("200005/2", "1.0000e5", Up),
        ("200005/2", "1.0001e5", Nearest),
    ] {
        assert!(!is_rounded(exact, decimal, 5, direction), "{exact} {decimal} {direction:?}");
    }
}

#[test]
fn the_region_and_its_proofs_follow_from_the_file() {
    for_each_fit(|case, report| {
        check_region(&report["fps"], &case.system());
    });
}

#[test]
fn every_end_of_the_pui_is_the_sum_of_its_proof() {
    for_each_fit(|case, report| {
        if case.kind == "empty" {
            assert!(report["pui"].is_null());
        } else {
            case.system().check_bounds(&report["pui"], &report["fps"]);
        }
    });
}

#[test]
fn the_central_estimate_is_the_middle_of_the_pui() {
    for_each_fit(|_, report| {
        let end = |axis: usize, end: &str| exact_or_null(&report["pui"][axis][end]);
        let middle = |axis: usize| {
            let (lower, upper) = (end(axis, "lower")?, end(axis, "upper")?);
            Some([(&lower + &upper).half(), (upper - lower).half()])
        };
        let expected = middle(0).zip(middle(1));
        assert_eq!(report["central"].is_null(), expected.is_none());
        if let Some(([theta1, error1], [theta2, error2])) = expected {
            assert_eq!(pair(&report["central"]["theta"]), [theta1, theta2]);
            assert_eq!(pair(&report["central"]["guaranteed_error"]), [error1, error2]);
        }
    });
}

/// ΦᵀΦ.
fn gram(rows: &[Measurement]) -> [[Rational; 2]; 2] {
    let entry = |i: usize, j: usize| rows.iter().map(|row| &row.regressor[i] * &row.regressor[j]).sum();
    [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]]
}

#[test]
fn least_squares_solves_the_normal_equations_and_the_eui_is_its_range() {
    for_each_fit(|case, report| {
        let (rows, estimate, eui) = (case.measurements(), &report["least_squares"], &report["eui"]);
        let [[g11, g12], [_, g22]] = gram(&rows);
        let Some(scale) = (&g11 * &g22 - &g12 * &g12).recip() else {
            assert!(estimate.is_null() && eui.is_null());
            return;
        };
        let theta = pair(&estimate["theta"]);
        let inverse = [[&g22 * &scale, -&g12 * &scale], [-&g12 * &scale, &g11 * &scale]];
        for axis in [0, 1] {
            let residual = |row: &Measurement| {
                &row.response - (&row.regressor[0] * &theta[0] + &row.regressor[1] * &theta[1])
            };
            let moment: Rational = rows.iter().map(|row| &row.regressor[axis] * residual(row)).sum();
            assert_eq!(moment, whole(0));
            let influence = |row: &Measurement| {
                &inverse[axis][0] * &row.regressor[0] + &inverse[axis][1] * &row.regressor[1]
            };
            let half_width: Rational = rows.iter().map(|row| influence(row).abs() * &row.epsilon).sum();
            assert_eq!(exact(&eui[axis]["lower"]), &theta[axis] - &half_width);
            assert_eq!(exact(&eui[axis]["upper"]), &theta[axis] + &half_width);
        }
        assert_eq!(estimate["in_fps"], case.system().contains(&theta));
    });
}

/// The minimax estimate meets the least error bound (or factor on the bounds). The proof shows that no smaller bound
/// will do: the half-planes at bound 0 sum to `0 ≤ -least` while their growth sums to 1.
#[test]
fn the_least_error_bound_is_met_and_proved() {
    for_each_fit(|case, report| {
        let minimax = &report["minimax"];
        let least = if case.epsilon.is_some() { &minimax["epsilon"] } else { &minimax["epsilon_factor"] };
        let uniform = if case.epsilon.is_some() { least } else { &Value::Null };
        assert_eq!(&report["epsilon_min"], uniform);
        if minimax.is_null() {
            assert_eq!(
                report["reasons"]["minimax"],
                "no error bound, however large, leaves a feasible parameter"
            );
            return;
        }
        let (least, theta) = (exact(least), pair(&minimax["theta"]));
        let (at_zero, growth) = (case.system_at_zero(), case.growth());
        for (named, growth) in at_zero.0.iter().zip(&growth.0) {
            let slack = named.half_plane.slack(&theta) + &growth.half_plane.b * &least;
            assert!(!slack.is_negative(), "{named:?}");
        }
        if least.is_zero() {
            assert!(minimax["proof"].as_array().unwrap().is_empty());
        } else {
            let sum = at_zero.sum(&minimax["proof"], 3);
            assert!(sum.is_trivial() && sum.b == -&least, "{sum:?}");
            assert_eq!(growth.sum(&minimax["proof"], 3).b, whole(1));
        }
        let in_use = case.epsilon.map_or(whole(1), rational);
        assert_eq!(case.kind == "empty", least > in_use);
    });
}

fn gain(theta: &[Rational; 2]) -> Rational {
    theta[0].recip().unwrap()
}

fn offset(theta: &[Rational; 2]) -> Rational {
    (-&theta[1]).checked_div(&theta[0]).unwrap()
}

/// A function of θ.
type OfTheta = fn(&[Rational; 2]) -> Rational;

/// Both parameters of the inverse line with what they are of θ.
const INVERSE: [(&str, OfTheta); 2] = [("gain", gain), ("offset", offset)];

#[test]
fn the_inverse_line_is_that_of_each_estimate() {
    for_each_fit(|case, report| {
        let inverse = &report["inverse"];
        assert_eq!(inverse.is_null(), case.x.contains(','));
        for (name, of) in INVERSE {
            for estimate in ["central", "least_squares"] {
                let theta = &report[estimate]["theta"];
                let exists = !inverse.is_null() && !theta.is_null() && !pair(theta)[0].is_zero();
                let expected = exists.then(|| of(&pair(theta)));
                assert_eq!(exact_or_null(&inverse[name][estimate]), expected, "{name} {estimate}");
            }
            if case.kind == "empty" && !inverse.is_null() {
                let nothing = Value::Array(Vec::new());
                assert_eq!(inverse[name]["exact_range"], nothing);
                assert_eq!(inverse[name]["box_range"], nothing);
            }
        }
    });
}

/// 1/θ1 and -θ2/θ1 are extreme at corners wherever θ1 keeps its sign, as in the published fits.
#[test]
fn the_inverse_line_ranges_over_the_corners() {
    for case in published_polygons() {
        let report = case.report();
        let vertices = report["fps"]["vertices"].as_array().unwrap().iter();
        let corners: Vec<[Rational; 2]> = vertices.map(|vertex| pair(&vertex["theta"])).collect();
        let pui = |axis: usize| ["lower", "upper"].map(|end| exact(&report["pui"][axis][end]));
        let box_corners = pui(0).into_iter().flat_map(|theta1| pui(1).map(|theta2| [theta1.clone(), theta2]));
        let box_corners: Vec<[Rational; 2]> = box_corners.collect();
        for (name, of) in INVERSE {
            let inverse = &report["inverse"][name];
            assert_eq!(ranges(&inverse["exact_range"]), [extremes(corners.iter().map(of))]);
            assert_eq!(ranges(&inverse["box_range"]), [extremes(box_corners.iter().map(of))]);
        }
    }
}

fn extremes(values: impl Iterator<Item = Rational>) -> [Option<Rational>; 2] {
    let values: Vec<Rational> = values.collect();
    [values.iter().min().cloned(), values.iter().max().cloned()]
}

fn ranges(range: &Value) -> Vec<[Option<Rational>; 2]> {
    let ends = |interval: &Value| ["lower", "upper"].map(|end| exact_or_null(&interval[end]));
    range.as_array().unwrap().iter().map(ends).collect()
}

#[test]
fn what_is_null_has_a_reason() {
    let parts = [
        "least_squares",
        "eui",
        "pui",
        "central",
        "slopes",
        "epsilon_min",
        "inverse",
        "minimax",
        "tightness",
    ];
    for_each_fit(|_, report| {
        let reasons = report["reasons"].as_object().unwrap();
        let null: BTreeSet<&str> = parts.into_iter().filter(|part| report[part].is_null()).collect();
        let explained: BTreeSet<&str> = reasons.keys().map(String::as_str).collect();
        assert_eq!(null, explained);
        assert!(reasons.values().all(|reason| !reason.as_str().unwrap().is_empty()));
    });
}
