//! Sensors that are stuck, or give few different numbers: of readings that are told as one there are any number.

use std::path::Path;

use boundfit_tests::cli::{directory_with, printed_with_input, report};
use boundfit_tests::program::run_with_input;
use serde_json::Value;

/// A sensor that is stuck at two readings.
fn stuck(pairs: usize) -> String {
    format!("x,y\n{}", "1,1\n2,1\n".repeat(pairs))
}

/// Sixteen values of x, five of the error: two rows in five are on a hull.
fn quantised(rows: usize) -> String {
    let row = |k: usize| {
        let (x, error) = (k * 7 % 16, k * k % 11 % 5);
        format!("{x},{}\n", 2 * x + error)
    };
    format!("x,y\n{}", (0..rows).map(row).collect::<String>())
}

const FIT: &str = "fit - --x x --y y --eps 1 --threads 1";

/// Returns the number of names in an active list, and the number of readings in all.
fn counts(vertex: &Value) -> (usize, u64) {
    let listed = vertex["active"].as_array().unwrap().len();
    (listed, listed as u64 + vertex["active_more"].as_u64().unwrap_or(0))
}

#[test]
fn active_rows_are_listed_up_to_a_limit_and_counted() {
    let found = report(Path::new("."), FIT, stuck(20_000).as_bytes());
    for vertex in found["fps"]["vertices"].as_array().unwrap() {
        assert_eq!(counts(vertex), (1000, 40_000), "{vertex}");
        let first = &vertex["active"][0];
        assert!(first["row"] == 1 || first["row"] == 2, "{first}");
    }
    // The same of readings that are all in memory.
    let small = report(Path::new("."), FIT, stuck(3000).as_bytes());
    assert!(small["fps"]["vertices"].as_array().unwrap().iter().all(|own| counts(own) == (1000, 6000)));
    let text = printed_with_input(Path::new("."), FIT, stuck(20_000).as_bytes());
    assert!(text.contains("8 upper, and 39992 more"), "{text}");
    let csv = printed_with_input(
        Path::new("."),
        &format!("{FIT} --format csv --vertices"),
        stuck(20_000).as_bytes(),
    );
    assert!(csv.lines().nth(1).unwrap().ends_with("; and 39000 more"));
}

/// Compares tables with more rows than are all kept, and with fewer.
#[test]
fn what_is_counted_is_what_would_be_listed() {
    let (few, many) = (quantised(8_800), quantised(88_000));
    let [few, many] = [few, many].map(|text| report(Path::new("."), FIT, text.as_bytes()));
    // Rows repeat after 176, of which both have a whole number.
    let vertices = |report: &Value| report["fps"]["vertices"].as_array().unwrap().clone();
    assert_eq!(vertices(&few).len(), vertices(&many).len());
    for (one, other) in vertices(&few).iter().zip(&vertices(&many)) {
        assert_eq!(one["theta"], other["theta"]);
        assert_eq!(counts(one).1 * 10, counts(other).1, "{one}");
        let both = counts(one).0.min(counts(other).0);
        let first = |vertex: &Value| vertex["active"].as_array().unwrap()[..both].to_vec();
        assert_eq!(first(one), first(other));
    }
    for key in ["pui", "central", "minimax", "epsilon_min"] {
        assert_eq!(few[key], many[key], "{key}");
    }
}

#[test]
fn a_reduction_has_a_row_for_many_and_says_for_how_many() {
    let reduce = |input: &str| {
        printed_with_input(Path::new("."), "reduce - --x x --y y --threads 1", input.as_bytes())
    };
    let reduced = reduce(&stuck(50_000));
    let (front, rows) = reduced.split_once('\n').unwrap();
    assert!(front.starts_with("# boundfit/reduced/3 {\"rows\":100000,\"kept\":2,"), "{front}");
    assert_eq!(rows, "x,y\n50000 1,1\n50000 2,1\n");
    // Reductions one after the other, and of old formats beside new ones.
    let alone = reduce("x,y\n1,1\n2,1\n");
    assert!(alone.starts_with("# boundfit/reduced/1 "), "{alone}");
    let both = reduce(&format!("{alone}{reduced}{reduced}"));
    assert!(both.ends_with("\nx,y\n100001 1,1\n100001 2,1\n"), "{both}");
    let [whole, of_reduction] = [stuck(100_001), both]
        .map(|text| report(Path::new("."), &format!("{FIT} --no-eui"), text.as_bytes()));
    for key in ["least_squares", "pui", "central", "minimax", "tightness"] {
        assert_eq!(whole[key], of_reduction[key], "{key}");
    }
    let vertices = |report: &Value| report["fps"]["vertices"].as_array().unwrap().clone();
    for (one, other) in vertices(&whole).iter().zip(&vertices(&of_reduction)) {
        assert_eq!((&one["theta"], counts(one).1), (&other["theta"], counts(other).1));
    }
}

#[test]
fn rows_of_reductions_without_counts_or_with_too_many_are_refused() {
    let front = |rows: usize| {
        format!(
            "# boundfit/reduced/3 {{\"rows\":{rows},\"kept\":2,\"header\":true,\"reading\":\"decimal\",\"x\":\"x\",\"y\":\"y\",\
             \"epsilon\":null,\"sums\":[\"5\",\"3\",\"9\",\"5\"]}}\nx,y\n"
        )
    };
    for (rows, lines, message) in [
        (3, "1,1\n2 2,1\n", "line 3 of a reduction does not begin with how many readings it stands for"),
        (3, "-1 1,1\n2 2,1\n", "line 3 of a reduction does not begin"),
        (3, "99999999999999999999 1,1\n2 2,1\n", "line 3 of a reduction does not begin"),
        (3, "0 1,1\n2 2,1\n", "line 3 of a reduction does not begin"),
        (3, "1 1,1\n3 2,1\n", "the reduction from line 1 on has 3 readings, but its rows stand for 4"),
        (3, "1 1,1\n", "announces 2 lines of readings, but 1 follow"),
    ] {
        for command in ["fit - --x x --y y --eps 1", "reduce - --x x --y y"] {
            let line: Vec<&str> = command.split(' ').collect();
            let run = run_with_input(&line, format!("{}{lines}", front(rows)).as_bytes());
            assert_eq!((run.status, run.stdout.as_str()), (1, ""), "{lines}");
            assert!(run.stderr.contains(message), "{lines}: {}", run.stderr);
        }
    }
    // A row of two lines.
    let quoted = format!("{}1 1,1\n2 \"2\n0 \",1\n", front(3).replace("\"kept\":2", "\"kept\":3"));
    let run = run_with_input(&["fit", "-", "--x", "x", "--y", "y", "--eps", "1"], quoted.as_bytes());
    assert_eq!(run.status, 0, "{}", run.stderr);
}

/// Every row that touches is named in a proof, however many there are.
#[test]
fn proofs_name_all() {
    let directory = directory_with(&[("stuck.csv", stuck(6_000).as_bytes())]);
    let fit = "fit stuck.csv --x x --y y --eps 1 --proof p.json --format csv";
    printed_with_input(directory.path(), fit, b"");
    let verified = printed_with_input(directory.path(), "verify p.json stuck.csv", b"");
    assert!(verified.contains("verified"), "{verified}");
    let proof: Value =
        serde_json::from_str(&std::fs::read_to_string(directory.path().join("p.json")).unwrap()).unwrap();
    assert_eq!(proof["active"].as_array().unwrap().len(), 4 * 12_000);
}
