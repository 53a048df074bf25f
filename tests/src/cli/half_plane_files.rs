//! Half-planes from a file of rows `a1,a2,b`, worked out without the program.

use serde_json::{Value, json};

use super::numbers::rational;
use super::proofs::{HalfPlane, Named, System};

/// The half-planes of a table with a header; those of the rows in `equations` both ways.
pub fn system(csv: &str, equations: &[usize]) -> System {
    let mut all = Vec::new();
    for (row, line) in (1..).zip(csv.lines().skip(1)) {
        let cells: Vec<_> = line.split(',').map(rational).collect();
        let [a1, a2, b] = [&cells[0], &cells[1], &cells[2]];
        let mut add = |bound: &str, a, b| {
            let in_proofs = json!({"row": row, "bound": bound});
            all.push(Named { in_proofs, in_lists: json!(row), half_plane: HalfPlane { a, b } });
        };
        add("upper", [a1.clone(), a2.clone()], b.clone());
        if equations.contains(&row) {
            add("lower", [-a1, -a2], -b);
        }
    }
    System(all)
}

/// The same half-planes as an H-representation.
pub fn h_representation(csv: &str, equations: &[usize]) -> String {
    let rows: Vec<String> = csv
        .lines()
        .skip(1)
        .map(|line| {
            let cells: Vec<_> = line.split(',').map(rational).collect();
            format!("{} {} {}\n", cells[2], -&cells[0], -&cells[1])
        })
        .collect();
    let listed: String = equations.iter().map(|row| format!(" {row}")).collect();
    let linearity =
        if equations.is_empty() { String::new() } else { format!("linearity {}{listed}\n", equations.len()) };
    format!("H-representation\n{linearity}begin\n{} 3 rational\n{}end\n", rows.len(), rows.concat())
}

/// A table with some of its data rows.
pub fn with_rows(csv: &str, keep: impl Fn(usize) -> bool) -> String {
    let lines = csv.lines().enumerate();
    lines.filter(|(row, _)| *row == 0 || keep(*row)).map(|(_, line)| format!("{line}\n")).collect()
}

/// Returns what a region is as a set: everything but the names of half-planes and what follows from them.
pub fn shape(region: &Value) -> Value {
    let corners: Vec<&Value> =
        region["vertices"].as_array().unwrap().iter().map(|vertex| &vertex["theta"]).collect();
    json!([region["kind"], corners, region["rays"], region["lines"], region["witness"]])
}
