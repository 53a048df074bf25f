//! Verdicts on the solutions of GLPK, CBC and HiGHS for all of `fixtures/tiny-lp`. Needs `glpsol`, `cbc` and, in
//! Python, highspy.
//!
//! Right is what `fixtures/tiny-lp/README.md` says: the status, and the optimum within 10⁻⁶ of its scale. Whatever is right must pass,
//! and a wrong status must be refuted, and an optimum that is wrong by more than its printed digits.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use boundfit_exact::Rational;
use boundfit_tests::lp_cases::number;
use boundfit_tests::program::{root, run};
use serde_json::Value;

/// Answers that are right in status and optimum, and wrong in something else.
const RIGHT_BUT: [(&str, &str, &str); 1] = [
    // Its dual is 0 at a row and 1 at a bound that the point does not attain, in proportion.
    ("wide-range", "cbc", "complementary-slackness"),
];

/// Solvers that do not read the sense of a file get it as an option, and the file without it.
fn without_sense(name: &str, folder: &Path) -> PathBuf {
    let text = fs::read_to_string(root().join(format!("fixtures/tiny-lp/{name}.mps"))).unwrap();
    let mut lines = Vec::new();
    let mut is_sense = false;
    for line in text.lines() {
        is_sense = line.starts_with("OBJSENSE") || is_sense && line.starts_with([' ', '\t']);
        if !is_sense {
            lines.push(line);
        }
    }
    let path = folder.join(format!("{name}.mps"));
    fs::write(&path, lines.join("\n") + "\n").unwrap();
    path
}

/// Runs a program, whatever becomes of it.
fn start(program: &str, arguments: &[&str]) {
    let mut command = Command::new(program);
    command.args(arguments).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    let status = command.status();
    status.unwrap_or_else(|error| panic!("{program}: {error}: install glpk-utils, coinor-cbc and Python 3"));
}

/// The files that a solver wrote; none where it refuses a program.
fn solve(solver: &str, name: &str, is_maximum: bool, folder: &Path) -> Option<PathBuf> {
    let output = folder.join(format!("{name}.{solver}.sol"));
    let model = without_sense(name, folder);
    let (model, to) = (model.to_str().unwrap(), output.to_str().unwrap());
    match solver {
        "glpk" => {
            start("glpsol", &["--freemps", model, if is_maximum { "--max" } else { "--min" }, "-w", to])
        }
        "glpk-exact" => {
            let sense = if is_maximum { "--max" } else { "--min" };
            start("glpsol", &["--freemps", "--nopresol", "--exact", model, sense, "-w", to]);
        }
        _ => {
            let sense = if is_maximum { "-max" } else { "-min" };
            start("cbc", &[model, sense, "-solve", "-printi", "all", "-solution", to]);
        }
    }
    output.exists().then_some(output)
}

/// Status and objective of a file, read apart from the program under test.
fn claimed(solver: &str, path: &Path) -> (&'static str, Rational) {
    let text = fs::read_to_string(path).unwrap();
    let (words, objective) = match solver {
        "cbc" => {
            let first = text.lines().next().unwrap();
            let (words, value) = first.split_once(" - objective value ").unwrap();
            (words.to_owned(), value.trim().to_owned())
        }
        "highs" => {
            let status = text.lines().nth(1).unwrap().to_owned();
            let objective = text.lines().find_map(|line| line.strip_prefix("Objective "));
            (status, objective.unwrap_or("0").to_owned())
        }
        _ => {
            let status = text.lines().find_map(|line| line.strip_prefix("c Status:")).unwrap();
            let solution = text.lines().find(|line| line.starts_with("s ")).unwrap();
            (status.trim().to_owned(), solution.split_whitespace().last().unwrap().to_owned())
        }
    };
    let status = match words.to_ascii_lowercase().as_str() {
        words if words.contains("unbounded") && words.contains("infeasible") => "none",
        words if words.starts_with("optimal") => "optimal",
        words if words.starts_with("unbounded") => "unbounded",
        words if words.starts_with("infeasible") && !words.contains("intermediate") => "infeasible",
        _ => "none",
    };
    (status, number(&objective))
}

/// The status and the optimum of a file.
#[derive(PartialEq, Eq)]
enum Truth {
    Right,
    /// Wrong by no more than the printed digits, or no answer.
    Open,
    WrongOptimum,
    WrongStatus,
}

fn truth(solver: &str, status: &str, objective: &Rational, answer: &Value) -> Truth {
    if status == "none" {
        return Truth::Open;
    }
    if answer["status"] != status {
        return Truth::WrongStatus;
    }
    let Some(exact) = answer["objective"].as_str().map(number).filter(|_| status == "optimal") else {
        return Truth::Right;
    };
    let scale = answer["scale"].as_str().map_or_else(Rational::one, number);
    let off = (objective - &exact).abs() - Rational::scientific(1, -6) * scale;
    let [places, digits] = if solver == "cbc" { [-8, -7] } else { [-13, -14] };
    if off <= Rational::scientific(1, -14) * exact.abs() {
        Truth::Right
    } else if off <= Rational::scientific(1, places) + Rational::scientific(1, digits) * exact.abs() {
        Truth::Open
    } else {
        Truth::WrongOptimum
    }
}

/// Judges the answers of a solver and gives how many were right and passed, and how many wrong and refuted.
fn compare(solver: &str, solve: impl Fn(&str, bool) -> Option<PathBuf>) -> (usize, usize) {
    let (mut passed, mut refused, mut problems) = (0, 0, Vec::new());
    let mut names: Vec<String> = fs::read_dir(root().join("fixtures/tiny-lp"))
        .unwrap()
        .filter_map(|entry| Some(entry.unwrap().file_name().to_str()?.strip_suffix(".mps")?.to_owned()))
        .collect();
    names.sort();
    for name in &names {
        let answer = fs::read_to_string(root().join(format!("fixtures/tiny-lp/{name}.json"))).unwrap();
        let answer: Value = serde_json::from_str(&answer).unwrap();
        let Some(path) = solve(name, answer["sense"] == "max") else { continue };
        let (status, objective) = claimed(solver, &path);
        let model = format!("fixtures/tiny-lp/{name}.mps");
        let run = run(&["judge", &model, "--solution", path.to_str().unwrap(), "--format", "json"]);
        assert!(run.status == 0 || run.status == 4, "{name} {solver}: {run:?}");
        let report: Value = serde_json::from_str(&run.stdout).unwrap();
        let refuted: Vec<&str> = report["solutions"][0]["findings"]
            .as_array()
            .unwrap()
            .iter()
            .filter(|finding| finding["verdict"] == "refuted")
            .map(|finding| finding["aspect"].as_str().unwrap())
            .collect();
        let is_known = |(other, by, aspect): &(&str, &str, &str)| {
            *other == name.as_str() && *by == solver && refuted.contains(aspect)
        };
        let problem = match truth(solver, status, &objective, &answer) {
            Truth::Right if refuted.is_empty() => {
                passed += 1;
                continue;
            }
            Truth::Right if RIGHT_BUT.iter().any(is_known) => continue,
            Truth::Right => "is right, but refuted",
            Truth::Open => continue,
            Truth::WrongStatus if !refuted.contains(&"status") => "has a wrong status and passes",
            Truth::WrongOptimum if refuted.is_empty() => "has a wrong optimum and passes",
            Truth::WrongStatus | Truth::WrongOptimum => {
                refused += 1;
                continue;
            }
        };
        problems.push(format!("{name} by {solver} {problem}: {refuted:?}"));
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
    (passed, refused)
}

#[test]
fn right_solutions_pass_and_wrong_ones_are_refuted() {
    let folder = tempfile::tempdir().unwrap();
    for solver in ["glpk", "glpk-exact", "cbc"] {
        let (passed, refuted) =
            compare(solver, |name, is_maximum| solve(solver, name, is_maximum, folder.path()));
        assert!(passed >= 200 && refuted >= 10, "{solver}: {passed} passed, {refuted} refuted");
    }
}

#[test]
fn right_solutions_of_highs_pass_and_wrong_ones_are_refuted() {
    let folder = tempfile::tempdir().unwrap();
    let program = "import highspy, pathlib, sys\n\
        for path in sorted(pathlib.Path(sys.argv[1]).glob('*.mps')):\n\
        \x20   solver = highspy.Highs()\n\
        \x20   solver.setOptionValue('output_flag', False)\n\
        \x20   if solver.readModel(str(path)) != highspy.HighsStatus.kError:\n\
        \x20       solver.run()\n\
        \x20       solver.writeSolution(f'{sys.argv[2]}/{path.stem}.highs.sol', 0)\n";
    let mut command = Command::new(super::tables::python());
    command.args(["-c", program]).arg(root().join("fixtures/tiny-lp")).arg(folder.path());
    assert!(command.status().unwrap().success());
    let (passed, refuted) = compare("highs", |name, _| {
        Some(folder.path().join(format!("{name}.highs.sol"))).filter(|path| path.exists())
    });
    assert!(passed >= 250 && refuted >= 10, "{passed} passed, {refuted} refuted");
}
