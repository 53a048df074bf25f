//! The LP line of `fit`, and writing to a file.

use std::fmt::Write;

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
        writeln!(table, "{},{}.{:05}", row % 1000, row % 1000, row * 7919 % 99_991).unwrap();
    }
    table
}

#[test]
fn a_fit_ends_with_what_the_solver_makes_of_it() {
    let table = "x,y\n0,0\n1,1\n2,2.5\n3,3\n";
    let with = fit("--full", table);
    let line = with.lines().last().unwrap();
    assert_eq!(line, "LP solver      microlp 0.7: right to 5.6e-17 of the width (rounded)");
    let without = fit("--full --no-lp", table);
    assert_eq!(with, format!("{without}{line}\n"));
    assert!(!without.contains("LP solver") && !fit("", table).contains("LP solver"));
    // JSON has no such line.
    assert_eq!(fit("--format json", table), fit("--format json --no-lp", table));
    // Where the solver is wrong, the line says so and where to look.
    let hard = "fit fixtures/hard-lp/tiny-eps-loose.csv --x x --y y --eps 0.000000001 --full";
    let hard = boundfit(hard);
    assert_eq!(hard.status, 0);
    let (_, line) = hard.stdout.rsplit_once("\nLP solver      ").unwrap();
    assert!(line.starts_with("microlp 0.7: ") && line.ends_with(" (see boundfit check)\n"), "{line}");
    let empty = boundfit("fit fixtures/hard-lp/empty-by-1e-9.csv --x x --y y --eps 0.373923265 --full");
    let expected = "LP solver      microlp 0.7: wrong status on theta1 min, theta1 max, theta2 min,\n\
                    \x20              theta2 max (see boundfit check)\n\nNext steps";
    assert!(empty.status == 3 && empty.stdout.contains(expected), "{}", empty.stdout);
}

#[test]
fn a_fit_of_very_many_rows_does_not_wait_for_a_solver() {
    // A very large table is asked about the readings on a hull.
    for count in [1_000, 10_001] {
        let table = readings(count);
        let with = fit("--full", &table);
        let (_, line) = with.split_once("LP solver      microlp 0.7: right ").unwrap();
        let line = line.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(line.ends_with(&format!("of {count} readings that can bound the set")), "{line}");
        assert!(!fit("--full --no-lp", &table).contains("LP solver"));
    }
    // All readings of a parabola are on a hull.
    let parabola = (0..51).fold("x,y\n".to_owned(), |table, x| format!("{table}{x},{}\n", x * x));
    let options = "fit - --x x --y y --eps 1000 --full";
    let of = |options: &str, table: &str| {
        let words: Vec<&str> = options.split_whitespace().collect();
        let run = run_with_input(&words, table.as_bytes());
        assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{options}");
        let (_, line) = run.stdout.rsplit_once("LP solver").unwrap();
        line.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let expected =
        "not asked about more than 50 readings that can bound the set, these are 51 (see boundfit check)";
    assert_eq!(of(options, &parabola), expected);
    // Under other bounds nobody knows beforehand which they are.
    let bounds =
        parabola.lines().skip(1).fold("x,y,e\n".to_owned(), |table, row| format!("{table}{row},1000\n"));
    let expected = "not asked about more than 50 readings (see boundfit check)";
    assert_eq!(of("fit - --x x --y y --eps-column e --full", &bounds), expected);
}

/// Every verdict stays without the readings that cannot bound anything.
#[test]
fn solvers_get_the_readings_that_can_matter_or_all() {
    let table = readings(1_001);
    let check = |options: &str| {
        let words = ["check", "-", "--x", "x", "--y", "y", "--eps", "1"];
        let words: Vec<&str> = words.into_iter().chain(options.split_whitespace()).collect();
        let run = run_with_input(&words, table.as_bytes());
        assert!(matches!(run.status, 0 | 4) && run.stderr.is_empty(), "{options}: {}", run.stderr);
        (run.status, run.stdout)
    };
    let claims =
        "--claim-pui=0.99,1.01,-1,2 --claim-pui=0.5,1.5,-9,9 --claim-pui=1,1,0,0 --solver exact-simplex";
    let json = |options: &str| -> serde_json::Value {
        serde_json::from_str(&check(&format!("{claims} --format json {options}")).1).unwrap()
    };
    let (few, all) = (json(""), json("--all-rows"));
    assert_eq!((&few["claims"], &few["worst"]), (&all["claims"], &all["worst"]));
    assert_eq!(all["readings"], serde_json::json!({"asked": 1001, "fitted": 1001}));
    assert_eq!(few["readings"]["fitted"], 1001);
    let asked = few["readings"]["asked"].as_u64().unwrap();
    assert!(asked < 50, "{asked}");
    let (status, text) = check(claims);
    let about = format!("About the {asked} of 1001 readings that lie on a hull");
    assert!(text.lines().nth(1).is_some_and(|line| line.contains(&about)), "{text}");
    let (status_of_all, text_of_all) = check(&format!("{claims} --all-rows"));
    assert_eq!(status, status_of_all);
    assert!(!text_of_all.contains("on a hull"));
    assert_eq!(
        text.lines().filter(|line| line.contains("theta")).collect::<Vec<_>>(),
        text_of_all.lines().filter(|line| line.contains("theta")).collect::<Vec<_>>()
    );
    // Readings within an edge of a hull have an active bound where the edge has one.
    let level = (0..1_100).fold("x,y\n".to_owned(), |table, x| format!("{table}{x},0\n"));
    let words =
        ["check", "-", "--x", "x", "--y", "y", "--eps", "1", "--solver", "microlp", "--format", "json"];
    let run = run_with_input(&words, level.as_bytes());
    let few: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!(few["readings"], serde_json::json!({"asked": 1100, "fitted": 1100}));
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
    // A report that cannot be written leaves nothing behind, and the program says so.
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
