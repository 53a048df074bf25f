//! SciPy's linear programs, two for every set, give the leverages and residuals that `boundfit status` gives for all sets at once.

use std::process::Command;

use boundfit_tests::program::{root, run};
use serde_json::Value;

use super::tables::python;

/// File, columns, error bound and rows.
const QUESTIONS: [(&str, &str, &str, &str, usize, usize); 3] = [
    ("fixtures/transducer/transducer.csv", "Vz", "z", "0.5e-3", 14, 36),
    ("fixtures/norris/norris.csv", "x", "y", "2.2", 1, 36),
    ("fixtures/norris/norris.csv", "x", "y", "5", 3, 17),
];

/// The largest error of doubles.
const TOLERANCE: f64 = 1e-9;

#[test]
fn leverages_and_residuals_are_those_of_linear_programs_in_doubles() {
    let script = root().join("tests/tests/external/statuses/statuses.py");
    for (file, x, y, epsilon, first, last) in QUESTIONS {
        let rows = format!("{first}..{last}");
        let line =
            ["status", file, "--x", x, "--y", y, "--eps", epsilon, "--rows", &rows, "--format", "json"];
        let report: Value = serde_json::from_str(&run(&line).stdout).unwrap();
        let [first, last] = [first, last].map(|row| row.to_string());
        let asked = Command::new(python())
            .arg(&script)
            .arg(root().join(file))
            .args([x, y, epsilon, &first, &last])
            .output()
            .unwrap();
        assert!(asked.status.success(), "{}", String::from_utf8_lossy(&asked.stderr));
        let answer = String::from_utf8(asked.stdout).unwrap();
        let found = report["rows"].as_array().unwrap();
        assert_eq!(answer.lines().count(), found.len());
        for (line, row) in answer.lines().zip(found) {
            let mut cells = line.split(' ');
            assert_eq!(cells.next().unwrap(), row["row"].to_string());
            for key in ["leverage", "residual", "without_leverage", "without_residual"] {
                let (exact, double) = (row[key]["value"].as_f64().unwrap(), cells.next().unwrap());
                let off = (exact - double.parse::<f64>().unwrap()).abs();
                assert!(
                    off <= TOLERANCE * exact.abs().max(1.0),
                    "{file}, {key}: {exact} and {double}: {line}"
                );
            }
        }
    }
}
