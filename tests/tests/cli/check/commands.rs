//! The LP line of `fit`, `bench-solvers`, and writing to a file.

use std::fmt::Write;

use boundfit_tests::lp_cases::hard_cases;
use boundfit_tests::program::run_with_input;

use super::{NEAR_PARALLEL, boundfit};

fn fit(options: &str, input: &str) -> String {
    let mut words = vec!["fit", "-", "--x", "x", "--y", "y", "--eps", "1"];
    words.extend(options.split_whitespace());
    let run = run_with_input(&words, input.as_bytes());
    assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{options}");
    run.stdout
}

fn readings(count: usize) -> String {
    let mut table = "x,y\n".to_owned();
    for row in 0..count {
        writeln!(table, "{},{}.{}", row % 1000, row % 1000, row % 7).unwrap();
    }
    table
}

#[test]
fn a_fit_ends_with_what_the_solver_makes_of_it() {
    let table = "x,y\n0,0\n1,1\n2,2.5\n3,3\n";
    let with = fit("", table);
    let line = with.lines().last().unwrap();
    assert_eq!(line, "LP solver      microlp 0.7: right to 5.6e-17 of the width (rounded)");
    let without = fit("--no-lp", table);
    assert_eq!(with, format!("{without}{line}\n"));
    assert!(!without.contains("LP solver"));
    // JSON has no such line.
    assert_eq!(fit("--format json", table), fit("--format json --no-lp", table));
    // Where the solver is wrong, the line says so and where to look.
    let hard = "fit fixtures/hard-lp/tiny-eps-loose.csv --x x --y y --eps 0.000000001";
    let hard = boundfit(hard);
    assert_eq!(hard.status, 0);
    let (_, line) = hard.stdout.rsplit_once("\nLP solver      ").unwrap();
    assert!(line.starts_with("microlp 0.7: ") && line.ends_with(" (see boundfit check)\n"), "{line}");
    let empty = boundfit("fit fixtures/hard-lp/empty-by-1e-9.csv --x x --y y --eps 0.373923265");
    let expected = "LP solver      microlp 0.7: wrong status on theta1 min, theta1 max, theta2 min,\n\
                    \x20              theta2 max (see boundfit check)\n";
    assert!(empty.status == 3 && empty.stdout.ends_with(expected), "{}", empty.stdout);
}

#[test]
fn a_fit_of_very_many_rows_does_not_wait_for_a_solver() {
    let table = readings(10_001);
    let expected = "LP solver      not asked above 10000 rows (see boundfit check)";
    assert_eq!(fit("", &table).lines().last(), Some(expected));
    assert!(!fit("--no-lp", &table).contains("LP solver"));
}

#[test]
fn the_conformance_table_has_a_row_per_case() {
    let run = boundfit("bench-solvers fixtures/hard-lp");
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    let lines: Vec<&str> = run.stdout.lines().collect();
    let names: Vec<String> = hard_cases().into_iter().map(|case| case.name).collect();
    assert_eq!(lines.len(), names.len() + 3, "{}", run.stdout);
    let sources = boundfit_check::source_names().len();
    assert!(lines[0].starts_with("| case | microlp 0.7 | clarabel 0.11 |"), "{}", lines[0]);
    assert!(lines[0].ends_with("| exact-simplex |") && lines[1].starts_with("|---|"));
    let mut right = vec![0; sources];
    for (line, name) in lines[2..].iter().zip(&names) {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        assert_eq!((cells[0], cells.len()), (format!("`{name}`").as_str(), sources + 1), "{line}");
        assert_eq!(cells[sources], "exact", "{line}");
        for (count, cell) in right.iter_mut().zip(&cells[1..]) {
            let verdict = cell.split(" (").next().unwrap();
            *count += usize::from(["exact", "rounded", "within tolerance", "no answer"].contains(&verdict));
        }
    }
    let totals: Vec<String> = right.iter().map(|count| format!("{count} of 12")).collect();
    assert_eq!(*lines.last().unwrap(), format!("| not refuted | {} |", totals.join(" | ")));
    assert_eq!(totals[sources - 1], "12 of 12");
}

#[test]
fn reports_are_written_whole() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("report");
    let claim = "--claim fixtures/claims/near-parallel-highs.json";
    for options in ["--format json", "--format text", "--directions 4"] {
        let printed = boundfit(&format!("{NEAR_PARALLEL} {claim} {options}"));
        let before = "what was there before, and much longer than any report\n".repeat(1000);
        std::fs::write(&file, format!("LP answers about it, judged exactly\n{before}")).unwrap();
        let written = boundfit(&format!("{NEAR_PARALLEL} {claim} {options} -o {}", file.display()));
        assert_eq!((written.status, written.stdout.as_str()), (4, ""), "{options}");
        assert_eq!(std::fs::read_to_string(&file).unwrap(), printed.stdout, "{options}");
    }
    let bench = boundfit(&format!("bench-solvers fixtures/hard-lp -o {}", file.display()));
    assert_eq!((bench.status, bench.stdout.as_str()), (0, ""));
    let printed = boundfit("bench-solvers fixtures/hard-lp").stdout;
    assert_eq!(std::fs::read_to_string(&file).unwrap(), printed);
    // What cannot be written leaves nothing behind, and says so.
    let missing = folder.path().join("none/report");
    let refused = boundfit(&format!("{NEAR_PARALLEL} {claim} -o {}", missing.display()));
    assert_eq!((refused.status, refused.stdout.as_str()), (1, ""));
    assert!(refused.stderr.contains("none/report: cannot write: "), "{}", refused.stderr);
    // Nor does a refusal touch what is there.
    std::fs::write(&file, "kept").unwrap();
    let refused = boundfit(&format!("{NEAR_PARALLEL} --claim none.json -o {}", file.display()));
    assert_eq!(refused.status, 1);
    assert_eq!(std::fs::read_to_string(&file).unwrap(), "kept");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}
