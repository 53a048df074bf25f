//! Predictions against linear programs and root searches in scipy: the same to 1e-9.

use std::process::{Command, Stdio};

use boundfit_tests::cli::{finish, report};
use boundfit_tests::program::root;
use serde_json::{Value, json};

use crate::tables::python;

/// The largest error of floats, in units of the number.
const TOLERANCE: f64 = 1e-9;

/// The rows of a table of two columns, from `first` to `last`.
fn rows(file: &str, columns: [usize; 2], first: usize, last: usize) -> Vec<[f64; 2]> {
    let text = std::fs::read_to_string(root().join(file)).unwrap();
    let cells = |line: &str| {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.trim().parse().unwrap()).collect();
        columns.map(|column| cells[column])
    };
    text.lines().skip(first).take(last + 1 - first).map(cells).collect()
}

/// Returns scipy's answers to these questions.
fn solved(question: &Value) -> Value {
    let mut command = Command::new(python());
    command.arg(root().join("tests/tests/external/predict/predict.py"));
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let run = finish(&mut command, question.to_string().as_bytes());
    assert_eq!(run.status, 0, "{}", run.stderr);
    serde_json::from_str(&run.stdout).unwrap()
}

fn close(found: &Value, exact: &Value, what: &str) {
    let [found, exact] = [found, &exact["value"]].map(|value| value.as_f64().unwrap());
    assert!((found - exact).abs() <= TOLERANCE * exact.abs().max(1.0), "{what}: {found} for {exact}");
}

/// Asks both about one fit.
fn check(
    file: &str,
    columns: [usize; 2],
    options: &str,
    [first, last]: [usize; 2],
    eps: f64,
    readings: &str,
) {
    let at = ["-5", "-0.5", "0", "3.7", "12"];
    let line = format!("predict {file} {options} --at {} --from {readings}", at.join(","));
    let exact = report(&root(), &line, b"");
    let mut from = Vec::new();
    let mut ends = Vec::new();
    for own in exact["from"].as_array().unwrap() {
        for interval in own["x"].as_array().unwrap() {
            for end in ["lower", "upper"] {
                let is_upper = interval["proof"][end]["line"] == "upper";
                from.push(json!([own["y"]["value"], is_upper, interval[end]["value"]]));
                ends.push(interval[end].clone());
            }
        }
    }
    let at: Vec<f64> = at.iter().map(|x| x.parse().unwrap()).collect();
    let question =
        json!({"rows": rows(file, columns, first, last), "eps": eps, "at": at, "from": from, "width": 3.0});
    let found = solved(&question);
    for (own, solved) in exact["at"].as_array().unwrap().iter().zip(found["at"].as_array().unwrap()) {
        close(&solved[0], &own["line"]["lower"], file);
        close(&solved[1], &own["line"]["upper"], file);
    }
    assert!(ends.len() >= 4);
    for (own, solved) in ends.iter().zip(found["from"].as_array().unwrap()) {
        close(solved, own, file);
    }
}

#[test]
fn intervals_and_sources_are_those_of_linear_programs() {
    let transducer = "--x Vz --y z --rows 14..36 --eps 0.5e-3";
    check("fixtures/transducer/transducer.csv", [1, 0], transducer, [14, 36], 0.5e-3, "0.012,0.03,-0.01");
    // The columns of Norris are y and x.
    let text = std::fs::read_to_string(root().join("fixtures/norris/norris.csv")).unwrap();
    let header: Vec<&str> = text.lines().next().unwrap().split(',').collect();
    let column = |name: &str| header.iter().position(|own| *own == name).unwrap();
    let norris = "--x x --y y --eps 3";
    check("fixtures/norris/norris.csv", [column("x"), column("y")], norris, [1, 36], 3.0, "10,500,900");
}
