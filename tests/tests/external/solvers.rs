//! GLPK on the programs of `boundfit convert`, judged by `boundfit check`: `glpsol` has to be installed.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use boundfit_exact::{Rational, Rounding};
use boundfit_tests::lp_cases::{hard_cases, number};
use boundfit_tests::program::run;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde_json::Value;

/// GLPK prints so many digits.
const DIGITS: usize = 15;

/// The ways in which GLPK is asked.
const WAYS: [(&str, &str, &[&str]); 4] = [
    ("simplex", "mps", &["--freemps"]),
    ("no presolve", "mps", &["--nopresol", "--freemps"]),
    ("exact", "mps", &["--exact", "--freemps"]),
    ("from LP", "lp", &["--lp"]),
];

/// Runs `glpsol` and gives what it says.
fn glpsol(arguments: &[&str]) -> String {
    let mut command = Command::new("glpsol");
    command.args(arguments).stdin(Stdio::null());
    let output = command.output().expect("this test starts glpsol: install GLPK (on Debian glpk-utils)");
    assert!(output.status.success(), "glpsol {arguments:?}: {output:?}");
    String::from_utf8(output.stdout).expect("glpsol speaks ASCII")
}

/// A name and the options of a fit.
fn cases(folder: &Path) -> Vec<(String, String)> {
    let mut cases = vec![
        ("transducer", "fixtures/transducer/transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3"),
        (
            "transducer, one third",
            "fixtures/transducer/transducer.csv --x Vz --y z --rows 14..36 --eps 1/1500",
        ),
        ("norris", "fixtures/norris/norris.csv --x x --y y --eps 5"),
        ("norris, empty", "fixtures/norris/norris.csv --x x --y y --eps 1/2"),
        (
            "steam",
            "fixtures/steam-generator/steam_generator.csv --x x --y y --eps-column eps --where theta1>=0",
        ),
        ("near-parallel", "fixtures/claims/near-parallel.csv --x x --y y --eps 5e-8"),
        ("strip", "fixtures/claims/strip.csv --x x --y y --eps 0.2"),
        ("two regressors", "fixtures/figures/two-regressors.csv --x 1,2 --y 3 --eps 1/4"),
    ]
    .into_iter()
    .map(|(name, options)| (name.to_owned(), options.to_owned()))
    .collect::<Vec<_>>();
    for case in hard_cases() {
        let options = format!("fixtures/hard-lp/{}.csv --x x --y y --eps {}", case.name, case.epsilon);
        cases.push((case.name, options));
    }
    // Few digits and few places: points, segments, strips, ties and empty sets are common.
    let mut rng = ChaCha8Rng::seed_from_u64(6032);
    for index in 0..16 {
        let mut table = "x,y\n".to_owned();
        for _ in 0..rng.random_range(1..8) {
            let (x, y) = (rng.random_range(-2..=2), rng.random_range(-3..=3));
            table.push_str(&format!("{x},{}\n", if index % 2 == 0 { x } else { y }));
        }
        let file = folder.join(format!("{index}.csv"));
        fs::write(&file, table).expect("writable");
        let bound = ["0", "1", "1/2", "2"][index % 4];
        cases.push((format!("generated {index}"), format!("{} --x x --y y --eps {bound}", file.display())));
    }
    cases
}

/// Converts a fit, lets GLPK solve the four programs, and judges the answers: the bounds as JSON.
fn judged(options: &str, reading: &str, way: (&str, &str, &[&str]), folder: &Path) -> Vec<Value> {
    let (_, format, flags) = way;
    let folder_name = folder.to_str().expect("plain name");
    let words = |line: String| line.split_whitespace().map(ToOwned::to_owned).collect::<Vec<_>>();
    let line = words(format!("convert {options} --reading {reading} --to {format} -o {folder_name}"));
    let made = run(&line.iter().map(String::as_str).collect::<Vec<_>>());
    assert_eq!((made.status, made.stderr.as_str()), (0, ""), "{line:?}");
    for program in ["theta1-min", "theta1-max", "theta2-min", "theta2-max"] {
        let path = |ending: &str| folder.join(format!("{program}.{ending}")).to_string_lossy().into_owned();
        let (program, solution, report) = (path(format), path("sol"), path("txt.log"));
        let said = glpsol(&[flags, &[program.as_str(), "-w", &solution, "-o", &report]].concat());
        assert!(!said.to_lowercase().contains("warning"), "{program}: {said}");
    }
    let line = words(format!("check {options} --reading {reading} --claim {folder_name} --format json"));
    let check = run(&line.iter().map(String::as_str).collect::<Vec<_>>());
    assert!((check.status == 0 || check.status == 4) && check.stderr.is_empty(), "{line:?}: {check:?}");
    let report: Value = serde_json::from_str(&check.stdout).expect("a report is JSON");
    let claims = report["claims"].as_array().expect("claims are a list");
    assert_eq!(claims[0]["reading"], reading);
    assert!(claims[0]["source"].as_str().is_some_and(|source| source.starts_with("GLPK, ")), "{report}");
    claims[0]["bounds"].as_array().expect("bounds are a list").clone()
}

/// Returns whether a bound is the exact one, rounded to the digits that GLPK prints.
fn is_printed_exactly(bound: &Value) -> bool {
    let exact = |key: &str| bound[key]["exact"].as_str().map(number);
    match (exact("exact"), exact("claimed")) {
        (Some(exact), Some(claimed)) => {
            let half_a_unit = claimed == number(&exact.to_decimal(DIGITS, Rounding::Nearest));
            half_a_unit
                || Rational::from_f64(exact.to_f64())
                    .is_some_and(|double| claimed == number(&double.to_decimal(DIGITS, Rounding::Nearest)))
        }
        _ => bound["verdict"] == "exact",
    }
}

/// The worst verdict of four, or that the numbers are right as far as they are printed.
fn summary(bounds: &[Value]) -> String {
    if bounds.iter().all(is_printed_exactly) {
        return "right to 15 digits".to_owned();
    }
    let order = [
        "exact",
        "rounded",
        "within tolerance",
        "no answer",
        "loose",
        "infeasible point",
        "unsafe",
        "inverted interval",
        "wrong status",
    ];
    let rank = |bound: &Value| order.iter().position(|name| bound["verdict"] == *name).expect("a verdict");
    let worst = bounds.iter().filter(|bound| !is_printed_exactly(bound)).map(rank).max();
    order[worst.unwrap_or_default()].to_owned()
}

#[test]
fn what_glpk_makes_of_the_programs() {
    let folder = tempfile::tempdir().expect("a folder");
    let cases = cases(folder.path());
    assert!(cases.len() >= 30);
    let mut tally: BTreeMap<(&str, String), usize> = BTreeMap::new();
    let mut table = String::new();
    for (name, options) in &cases {
        let mut cells = Vec::new();
        for way in WAYS {
            for reading in ["decimal", "binary64"] {
                let own = tempfile::tempdir().expect("a folder");
                let bounds = judged(options, reading, way, own.path());
                let found = summary(&bounds);
                // Whole numbers are what GLPK's exact simplex keeps.
                if way.0 == "exact" && name.starts_with("generated") {
                    assert_eq!(found, "right to 15 digits", "{name} {options} {reading} {bounds:?}");
                }
                if name.starts_with("transducer") || name.starts_with("steam") {
                    let refuted = ["wrong status", "no answer", "infeasible point", "inverted interval"];
                    assert!(!refuted.contains(&found.as_str()), "{name} {} {reading}: {found}", way.0);
                }
                *tally.entry((way.0, found.clone())).or_default() += 1;
                if reading == "decimal" {
                    cells.push(found);
                }
            }
        }
        table.push_str(&format!("| {name} | {} |\n", cells.join(" | ")));
    }
    println!("| case | {} |\n|---|---|---|---|---|\n{table}", WAYS.map(|way| way.0).join(" | "));
    for ((way, verdict), count) in tally {
        println!("{way}: {verdict}: {count}");
    }
}
