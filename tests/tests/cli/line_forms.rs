//! `--through-origin`, `--x-origin`, `--where` with equations and `--eps min`, from outside.

use std::fmt::Write;

use boundfit_tests::cli::{boundfit, directory_with, printed, report, unbroken};
use boundfit_tests::program::root;
use serde_json::{Value, json};
use tempfile::TempDir;

const DATA: &str = "year,level,group\n1979,4.1,a\n1980,5.2,a\n1981,5.9,b\n1983,8.2,b\n";
const SHIFTED: &str = "year,level\n-1,4.1\n0,5.2\n1,5.9\n3,8.2\n";

fn directory() -> TempDir {
    directory_with(&[("data.csv", DATA.as_bytes()), ("shifted.csv", SHIFTED.as_bytes())])
}

/// A report without what tells where its numbers come from.
fn answers(mut report: Value) -> Value {
    report.as_object_mut().unwrap().remove("input");
    report
}

#[test]
fn another_origin_of_x_is_as_good_as_shifted_data() {
    let directory = directory();
    let fit = |line: &str| report(directory.path(), line, b"");
    for options in [
        "--eps 0.3",
        "--eps 0.01",
        "--eps 1.2*min",
        "--eps 2 --through-origin",
        "--eps 1 --where 'theta1 = 1'",
    ] {
        let own = fit(&format!("fit data.csv --x year --y level --x-origin 1980 {options}"));
        let by_hand = fit(&format!("fit shifted.csv --x year --y level {options}"));
        assert_eq!(
            own["input"]["x_origin"],
            json!({"exact": "1980", "decimal": "1980", "value": 1980.0}),
            "{options}"
        );
        assert_eq!(by_hand["input"].get("x_origin"), None, "{options}");
        assert_eq!(answers(own), answers(by_hand), "{options}");
    }
    let text = printed(directory.path(), "fit data.csv --x year --y level --eps 0.3 --x-origin 1980");
    assert!(text.contains("level = theta1*(year - 1980) + theta2 + e\n"), "{text}");
    let program =
        "convert data.csv --x year --y level --eps 0.3 --to lp --objective theta2-min --x-origin=-2.5";
    let program = printed(directory.path(), program);
    assert!(program.contains("model: level = theta1*(year + 2.5) + theta2 + e"), "{program}");
    assert!(program.contains("row2_upper: 1982.5 theta1 + 1 theta2 <= 5.5"), "{program}");
}

#[test]
fn a_line_through_the_origin_has_one_parameter() {
    let directory = directory();
    let fit = |options: &str| {
        report(directory.path(), &format!("fit shifted.csv --x year --y level {options}"), b"")
    };
    let own = fit("--eps 6 --through-origin");
    assert_eq!(own["input"]["model"], "line-through-origin");
    assert_eq!(own["input"]["where"], json!(["theta2 = 0"]));
    assert_eq!(own["least_squares"]["theta"][0]["exact"], "12/5");
    assert_eq!(own["least_squares"]["theta"][1]["exact"], "0");
    assert_eq!(own["least_squares"]["binary64"]["qr"]["theta"][1], 0.0);
    assert_eq!(own["eui"][0]["lower"]["exact"], "-18/55");
    assert_eq!(own["eui"][1]["upper"]["exact"], "0");
    assert_eq!(own["fps"]["kind"], "segment");
    let line = fit("--eps 6 --where 'theta2 = 0'");
    assert_eq!(line["input"]["model"], "line");
    for part in ["fps", "pui", "central", "minimax"] {
        assert_eq!(own[part], line[part], "{part}");
    }
    let all_at_zero = directory_with(&[("zero.csv", b"x,y\n0,1\n0,-1\n")]);
    let report = report(all_at_zero.path(), "fit zero.csv --x x --y y --eps 2 --through-origin", b"");
    assert_eq!(report["least_squares"], Value::Null);
    assert_eq!(
        report["reasons"]["least_squares"],
        "every x is 0, where all lines through the origin are alike"
    );
    assert_eq!(report["fps"]["kind"], "line");
}

#[test]
fn many_readings_are_fitted_as_few() {
    // Far above what is kept in memory, and the same again in few rows: the extreme ones decide.
    let mut many = "x,y\n".to_owned();
    for k in 1..=12_000_i64 {
        writeln!(many, "{k},{}", 2 * k + [0, 3, -3][k as usize % 3]).unwrap();
    }
    let directory = directory_with(&[("many.csv", many.as_bytes())]);
    let fit = |options: &str| report(directory.path(), &format!("fit many.csv --x x --y y {options}"), b"");
    let own = fit("--eps 4 --through-origin");
    // Σx = n(n + 1)/2, Σx² = n(n + 1)(2n + 1)/6: the EUI is 4·3/(2n + 1) to either side of least squares.
    let theta = boundfit_tests::cli::numbers::exact(&own["least_squares"]["theta"][0]);
    let upper = boundfit_tests::cli::numbers::exact(&own["eui"][0]["upper"]);
    assert_eq!(upper - theta, boundfit_exact::Rational::ratio(12, 24_001));
    let shifted = fit("--eps 4 --x-origin 6000");
    let straight = fit("--eps 4");
    assert_eq!(shifted["pui"][0], straight["pui"][0]);
    assert_eq!(shifted["eui"][0], straight["eui"][0]);
    assert_eq!(fit("--eps 2*min")["input"]["epsilon"]["exact"], "6");
}

#[test]
fn a_bound_of_the_readings_own_says_what_it_assumes() {
    let directory = directory();
    let line = "fit data.csv --x year --y level";
    let text = unbroken(&printed(directory.path(), &format!("{line} --eps 1.2*min --no-lp")));
    assert!(
        text.contains(
            "error |e| <= 0.18 assumes that no error is larger than 1.2 times eps_min, 0.15, the least bound"
        ),
        "{text}"
    );
    assert!(text.contains("if one is, the set may miss the true theta."), "{text}");
    let own = report(directory.path(), &format!("{line} --eps 6/5*min"), b"");
    let from_least = &own["input"]["epsilon_from_least"];
    assert_eq!(
        (&from_least["factor"]["exact"], &from_least["epsilon_min"]["exact"]),
        (&json!("6/5"), &json!("3/20"))
    );
    let given = report(directory.path(), &format!("{line} --eps 0.18"), b"");
    assert_eq!(given["input"].get("epsilon_from_least"), None);
    assert_eq!(answers(own), answers(given));
    assert_eq!(report(directory.path(), &format!("{line} --eps min"), b"")["fps"]["kind"], "point");
    assert_eq!(report(directory.path(), &format!("{line} --eps 0.9*min"), b"")["fps"]["kind"], "empty");
    let collinear = unbroken(&printed(directory.path(), &format!("{line} --rows 1..2 --eps min --no-lp")));
    assert!(
        collinear.contains("Here it is 0: the readings fit exactly, and say nothing of their errors."),
        "{collinear}"
    );
    for command in ["check", "plot", "lesson"] {
        let run = boundfit(directory.path(), &format!("{command} data.csv --x year --y level --eps 2*min"));
        assert!([0, 4].contains(&run.status), "{command}: {}", run.stderr);
    }
    let groups = printed(directory.path(), &format!("{line} --by group --eps 2*min"));
    let assumed = "Assumed: no error is larger than 2 times eps_min of its own group, a bound found\nfrom these very readings\n";
    assert!(groups.ends_with(assumed), "{groups}");
}

#[test]
fn groups_are_fitted_by_these_models_too() {
    let directory = directory();
    for options in
        ["--eps 9 --through-origin --x-origin 1980", "--eps 1 --where 'theta1 = 2' --x-origin 1981"]
    {
        let line = format!("fit data.csv --x year --y level --by group {options} --format json");
        let groups = boundfit(directory.path(), &line);
        assert_eq!(groups.status, 0, "{groups:?}");
        for (line, rows) in groups.stdout.lines().zip(["1..2", "3..4"]) {
            let group: Value = serde_json::from_str(line).unwrap();
            let alone = report(
                directory.path(),
                &format!("fit data.csv --x year --y level --rows {rows} {options}"),
                b"",
            );
            for part in ["pui", "central", "eui", "epsilon_min"] {
                assert_eq!(group[part], alone[part], "{options} {part}");
            }
            assert_eq!(group["least_squares"]["theta"], alone["least_squares"]["theta"], "{options}");
        }
    }
}

#[test]
fn proofs_tell_the_origin() {
    let directory = directory();
    for options in
        ["--x-origin 1980", "--x-origin 1/3 --through-origin --reading binary64", "--where 'theta2 = 5'"]
    {
        let line = format!("fit data.csv --x year --y level --eps 700 {options} --proof proof.json --force");
        printed(directory.path(), &line);
        let verdict = printed(directory.path(), "verify proof.json data.csv");
        assert!(verdict.starts_with("verified"), "{options}: {verdict}");
        let path = directory.path().join("proof.json");
        let proof = std::fs::read_to_string(&path).unwrap();
        let other = proof.replace("\"x_origin\": \"1980\"", "\"x_origin\": \"1981\"");
        if other != proof {
            std::fs::write(&path, other).unwrap();
            assert_eq!(boundfit(directory.path(), "verify proof.json data.csv").status, 4);
        }
    }
}

#[test]
fn what_has_no_meaning_is_refused() {
    let at = "fit fixtures/figures/two-regressors.csv --x 1,2 --y 3 --eps 1";
    let line = "fit fixtures/transducer/transducer.csv --x Vz --y z";
    for (line, message) in [
        (
            format!("{at} --through-origin"),
            "'--through-origin' is about a line: with two regressors there is no offset, and the model passes through the \
             origin as it is",
        ),
        (
            format!("{at} --x-origin 3"),
            "'--x-origin' is about a line: with two regressors there is no x to count from an origin",
        ),
        (
            format!("{line} --eps 1 --x-origin year"),
            "invalid value 'year' for '--x-origin <NUM>': not a number: ",
        ),
        (
            format!("{line} --eps=-2*min"),
            "invalid value '-2*min' for '--eps <NUM>': min is the least bound that these very readings allow, and nothing but a positive factor goes with it: 1.2*min",
        ),
        (
            format!("{line} --eps 0*min"),
            "invalid value '0*min' for '--eps <NUM>': min is the least bound that these very readings allow, and nothing but a positive factor goes with it: 1.2*min",
        ),
        (format!("{line} --eps a*min"), "invalid value 'a*min' for '--eps <NUM>': min is the least bound "),
        (format!("{line} --eps *min"), "invalid value '*min' for '--eps <NUM>': min is the least bound "),
    ] {
        let run = boundfit(&root(), &line);
        let says = run.stderr.starts_with(&format!("error: {message}"));
        assert!(run.status == 2 && run.stdout.is_empty() && says, "{line}: {}", run.stderr);
    }
}

#[test]
fn the_error_has_a_name_that_no_column_has() {
    let directory = directory_with(&[("data.csv", b"x,e,error,y\n0,0,1,1\n1,2,1,2\n2,3,1,3\n")]);
    let said = |line: &str| unbroken(&printed(directory.path(), line));
    let two = "data.csv --x x,e --y y --eps 1";
    let fit = said(&format!("fit {two}"));
    assert!(fit.contains(" model y = theta1*x + theta2*e + error error |error| <= 1 data "), "{fit}");
    let further = said(&format!("predict {two} --at '1;1'"));
    assert!(further.contains("the error of a further reading: |error| <= 1 "), "{further}");
    let figure = said(&format!("plot {two} --format tikz"));
    let model =
        r"{y = $\theta _{1}\cdot $x + $\theta _{2}\cdot $e + error{,} $|$error$|$ $\le $ 1{,} 3 rows}";
    assert!(figure.contains(model), "{figure}");
    let program = said(&format!("convert {two} --to lp --objective theta1-max"));
    assert!(program.contains("\\ model: y = theta1*x + theta2*e + error, |error| <= 1 "), "{program}");
    let both = said("fit data.csv --x x --y e --eps-column error");
    assert!(both.contains(" model e = theta1*x + theta2 + noise error |noise| <= error, one "), "{both}");
    let none = said("fit data.csv --x x --y y --eps 1");
    assert!(none.contains(" model y = theta1*x + theta2 + e error |e| <= 1 data "), "{none}");
}

#[test]
fn sentences_of_figures_name_x_of_the_data() {
    let table = "year,y\n1980,1\n1981,2.1\n1982,2.9\n1985,6\n";
    let directory = directory_with(&[("o.csv", table.as_bytes())]);
    let plot = |options: &str| {
        let line = format!("plot o.csv --x year --y y --x-origin 1980 --real-text {options}");
        boundfit(directory.path(), &line).stdout
    };
    let next = plot("--eps 0.3 --figure next");
    assert!(next.contains("At year below 1980 and above 1985 a reading"), "{next}");
    let range = plot("--eps 0.1 --figure range");
    assert!(range.contains("the longest run: year from 1980 to 1985, 4 readings"), "{range}");
}

#[test]
fn bars_about_other_middles_are_no_readings_plus_minus_epsilon() {
    let directory = directory_with(&[("a.csv", b"x,y\n1,1.1\n2,1.9\n3,3.2\n")]);
    let plot = |eps: &str| {
        let line = format!("plot a.csv --x x --y y --eps {eps} --figure data --real-text");
        boundfit(directory.path(), &line).stdout
    };
    let [own, symmetric] = ["+0.2/-0.1", "0.2"].map(plot);
    assert!(own.contains("reading with its bounds") && !own.contains("reading ± ε"));
    assert!(symmetric.contains("reading ± ε"));
}
