//! `fit --sweep`: what it prints is what a fit with the multiplied error bound prints.

use boundfit_exact::Rational;
use boundfit_tests::program::run;
use serde_json::Value;

use boundfit_tests::cli::numbers::{exact, exact_or_null, pair, rational};
use boundfit_tests::cli::refusals::refuses_options;
use boundfit_tests::cli::{FIT_TRANSDUCER, boundfit, directory_with, words};

fn report(line: &str) -> Value {
    let words = words(&format!("{line} --format json"));
    let run = run(&words.iter().map(String::as_str).collect::<Vec<_>>());
    assert_eq!(run.stderr, "", "{line}");
    assert!([0, 3].contains(&run.status), "{line}");
    serde_json::from_str(&run.stdout).unwrap()
}

/// A function of the sweep at s: constant + slope·s + quadratic·s².
fn at(function: &Value, s: &Rational) -> Rational {
    let coefficient =
        |name: &str| function.get(name).map_or_else(Rational::zero, |c| rational(c.as_str().unwrap()));
    coefficient("constant") + coefficient("slope") * s + coefficient("quadratic") * s * s
}

fn at_or_null(function: &Value, s: &Rational) -> Option<Rational> {
    (!function.is_null()).then(|| at(function, s))
}

/// Kind, vertices with their active bounds, ends of the PUI, and area of a set.
type Set = (Value, Vec<([Rational; 2], Value)>, Vec<Option<Rational>>, Option<Rational>);

fn of_fit(fit: &Value) -> Set {
    let fps = &fit["fps"];
    let vertices = fps["vertices"].as_array().unwrap();
    let vertices = vertices.iter().map(|vertex| (pair(&vertex["theta"]), vertex["active"].clone())).collect();
    let ends = fit["pui"].as_array().into_iter().flatten();
    let ends =
        ends.flat_map(|interval| ["lower", "upper"].map(|end| exact_or_null(&interval[end]))).collect();
    (fps["kind"].clone(), vertices, ends, exact_or_null(&fps["area"]))
}

fn of_breakpoint(breakpoint: &Value) -> Set {
    let vertices = breakpoint["vertices"].as_array().unwrap();
    let vertices = vertices.iter().map(|vertex| (pair(&vertex["theta"]), vertex["active"].clone())).collect();
    let ends = breakpoint["pui"].as_array().into_iter().flatten();
    let ends =
        ends.flat_map(|interval| ["lower", "upper"].map(|end| exact_or_null(&interval[end]))).collect();
    (breakpoint["kind"].clone(), vertices, ends, exact_or_null(&breakpoint["area"]))
}

fn of_piece(piece: &Value, s: &Rational) -> Set {
    let vertices = piece["vertices"].as_array().unwrap().iter().map(|vertex| {
        let theta = &vertex["theta"];
        ([at(&theta[0], s), at(&theta[1], s)], vertex["active"].clone())
    });
    let ends = piece["pui"].as_array().into_iter().flatten();
    let ends = ends.flat_map(|interval| ["lower", "upper"].map(|end| at_or_null(&interval[end], s)));
    (piece["kind"].clone(), vertices.collect(), ends.collect(), at_or_null(&piece["area"], s))
}

#[test]
fn every_breakpoint_and_piece_equals_a_fit_with_that_error_bound() {
    let sweep = &report(&format!("{FIT_TRANSDUCER} --sweep 1/2..2"))["sweep"];
    let epsilon = Rational::ratio(1, 2000);
    let fit_at = |s: &Rational| {
        let bound = &epsilon * s;
        report(&FIT_TRANSDUCER.replace("0.5e-3", &bound.to_string()))
    };
    assert_eq!(exact(&sweep["least"]), Rational::ratio(7910, 10027));
    let breakpoints = sweep["breakpoints"].as_array().unwrap();
    let pieces = sweep["pieces"].as_array().unwrap();
    assert_eq!((breakpoints.len(), pieces.len()), (7, 6));
    for breakpoint in breakpoints {
        let s = exact(&breakpoint["s"]);
        assert_eq!(exact(&breakpoint["epsilon"]), &epsilon * &s);
        assert_eq!(of_breakpoint(breakpoint), of_fit(&fit_at(&s)), "s = {s}");
    }
    for piece in pieces {
        let (from, to) = (exact(&piece["from"]), exact(&piece["to"]));
        for part in [1, 3, 8] {
            let s = &from + (&to - &from) * Rational::ratio(part, 9);
            assert_eq!(of_piece(piece, &s), of_fit(&fit_at(&s)), "s = {s}");
        }
    }
}

#[test]
fn bounds_of_each_row_are_swept_by_a_common_factor() {
    let line =
        "fit fixtures/steam-generator/steam_generator.csv --x x --y y --eps-column eps --where 'theta1 >= 0'";
    let fit = report(&format!("{line} --sweep 0..3"));
    let sweep = &fit["sweep"];
    assert_eq!(sweep["least"]["exact"], "2/35");
    assert_eq!(sweep["breakpoints"][0]["epsilon"], Value::Null);
    let one = Rational::one();
    let piece = sweep["pieces"].as_array().unwrap().iter();
    let piece = piece.clone().find(|piece| exact(&piece["from"]) < one && one < exact(&piece["to"])).unwrap();
    assert_eq!(of_piece(piece, &one), of_fit(&fit));
}

#[test]
fn readings_with_one_bound_leave_the_same_set_at_every_factor() {
    let fit = report(&format!(
        "{} --sweep 1/2..2",
        FIT_TRANSDUCER.replace("--y z --rows 14..36 --eps 0.5e-3", "--rows 14..36 --lower z")
    ));
    let sweep = &fit["sweep"];
    assert_eq!(exact(&sweep["least"]), Rational::zero());
    let (breakpoints, pieces) =
        (sweep["breakpoints"].as_array().unwrap(), sweep["pieces"].as_array().unwrap());
    assert_eq!((breakpoints.len(), pieces.len()), (2, 1));
    assert_eq!(fit["fps"]["kind"], "unbounded-polygon");
    for set in [&of_breakpoint(&breakpoints[0]), &of_breakpoint(&breakpoints[1])] {
        assert_eq!(*set, of_fit(&fit));
    }
    assert_eq!(of_piece(&pieces[0], &Rational::one()), of_fit(&fit));
}

#[test]
fn a_fit_without_a_sweep_has_none() {
    assert_eq!(report(FIT_TRANSDUCER).get("sweep"), None);
}

#[test]
fn ranges_that_are_none_are_refused() {
    let expected = "expected FROM..TO with numbers 0 <= FROM <= TO, such as 0.5..2";
    let refused = |text: &str, problem: &str| {
        (
            format!("--x Vz --y z --eps 1 --sweep {text}"),
            format!("invalid value '{text}' for '--sweep <FROM..TO>': {problem}"),
        )
    };
    let cases = [
        refused("2..1", expected),
        refused("2", expected),
        refused(
            "a..2",
            &format!("\"a\": not a number: unexpected character 'a' at character 1 ({expected})"),
        ),
        refused("..2", &format!("\"\": not a number: nothing to read at character 1 ({expected})")),
    ];
    for (options, message) in &cases {
        refuses_options(2, &[(options, message)]);
    }
}

/// Readings of a curve have as many pieces as vertices.
#[test]
fn the_sets_of_a_sweep_keep_to_the_memory() {
    let rows: String = (0..300).map(|x| format!("{x},{}\n", x * x)).collect();
    let directory = directory_with(&[("curve.csv", format!("x,y\n{rows}").as_bytes())]);
    let of = |line: &str| {
        boundfit(directory.path(), &format!("{line} curve.csv --x x --y y --eps 12500 --limit memory=5MiB"))
    };
    let run = of("fit --sweep 0..3");
    let message = "error: curve.csv: the sets for all factors take 5.1 MiB of memory, more than 5 MiB (the limit); --limit memory=N \
                   raises it\n";
    assert_eq!((run.status, run.stdout.as_str(), run.stderr.as_str()), (1, "", message));
    let plot = of("plot --sweep 0..3");
    assert_eq!((plot.status, plot.stderr.as_str()), (1, message));
    assert_eq!(of("fit --sweep 2.9..3").status, 0);
}
