//! Outliers against a mixed-integer program and linear programs in scipy: the same number, and ranges the same to 1e-9.

use std::process::{Command, Stdio};

use boundfit_tests::cli::{finish, report};
use boundfit_tests::program::root;
use serde_json::{Value, json};

use crate::tables::python;

/// The largest error of floats, in units of the number.
const TOLERANCE: f64 = 1e-9;

fn check(file: &str, [x, y]: [&str; 2], eps: f64) {
    let exact = report(&root(), &format!("outliers {file} --x {x} --y {y} --eps {eps}"), b"");
    let text = std::fs::read_to_string(root().join(file)).unwrap();
    let mut lines = text.lines();
    let header: Vec<&str> = lines.next().unwrap().split(',').collect();
    let columns = [x, y].map(|name| header.iter().position(|own| *own == name).unwrap());
    let row = |line: &str| {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.trim().parse().unwrap()).collect();
        columns.map(|column| cells[column])
    };
    let rows: Vec<[f64; 2]> = lines.map(row).collect();
    let mut command = Command::new(python());
    command.arg(root().join("tests/tests/external/outliers/outliers.py"));
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let question = json!({"rows": rows, "eps": eps, "sets": exact["sets"]});
    let run = finish(&mut command, question.to_string().as_bytes());
    assert_eq!(run.status, 0, "{}", run.stderr);
    let found: Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!(found["least"], exact["least"], "{file}");
    for (own, region) in found["ranges"].as_array().unwrap().iter().zip(exact["regions"].as_array().unwrap())
    {
        for axis in 0..2 {
            for (place, end) in ["lower", "upper"].into_iter().enumerate() {
                let found = own[axis][place].as_f64().unwrap();
                let exact = region["pui"][axis][end]["value"].as_f64().unwrap();
                assert!(
                    (found - exact).abs() <= TOLERANCE * exact.abs().max(1.0),
                    "{file}: {found} for {exact}"
                );
            }
        }
    }
}

#[test]
fn the_fewest_outliers_are_those_of_a_mixed_integer_program() {
    check("fixtures/transducer/transducer.csv", ["Vz", "z"], 0.5e-3);
    check("fixtures/norris/norris.csv", ["x", "y"], 1.0);
    check("fixtures/worst-line/current.csv", ["U", "I"], 1.5);
}
