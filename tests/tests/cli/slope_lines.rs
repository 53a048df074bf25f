//! The steepest and the shallowest line in the report of `fit`.

use boundfit_tests::cli::{directory_with, printed, report};
use serde_json::Value;
use tempfile::TempDir;

fn directory() -> TempDir {
    directory_with(&[
        ("rising.csv", b"x,y\n1,-3\n2,-1\n3,2\n"),
        ("falling.csv", b"x,y\n1,2\n2,-1\n3,-3\n"),
        ("level.csv", b"x,y\n1,0\n2,0.1\n3,0\n"),
        ("upright.csv", b"x,y\n1,0\n1,0.1\n"),
        ("exact.csv", b"x,y\n0,1\n1,2\n2,3\n"),
        ("open.csv", b"x,lo,up\n0,0,\n1,,3\n"),
        ("two.csv", b"u,v,y\n1,2,0\n2,1,1\n"),
    ])
}

/// The lines of the report about slopes.
fn said(directory: &TempDir, line: &str) -> Vec<String> {
    let labels = ["slope ", "steepest ", "shallowest ", "rises most ", "falls most "];
    let text = printed(directory.path(), &format!("fit {line} --no-lp"));
    let lines = text.lines().filter(|line| labels.iter().any(|label| line.starts_with(label)));
    lines.map(|line| line.split_whitespace().collect::<Vec<_>>().join(" ")).collect()
}

#[test]
fn lines_at_the_ends_of_the_slopes_are_told_with_their_rows() {
    let directory = directory();
    for (line, expected) in [
        (
            "rising.csv --x x --y y --eps 1",
            vec![
                "steepest y = 3.5*x - 7.5, through 1 lower, 3 upper",
                "shallowest y = 1.5*x - 3.5, through 1 upper, 3 lower",
            ],
        ),
        (
            "falling.csv --x x --y y --eps 1",
            vec![
                "steepest y = -3.5*x + 6.5, through 1 upper, 3 lower",
                "shallowest y = -1.5*x + 2.5, through 1 lower, 3 upper",
            ],
        ),
        (
            "level.csv --x x --y y --eps 1",
            vec![
                "rises most y = x - 2, through 1 lower, 3 upper",
                "falls most y = -x + 2, through 1 upper, 3 lower",
            ],
        ),
        (
            "level.csv --x x --y y --eps 1 --exact --through-origin",
            vec!["rises most y = 1/3*x, through 3 upper", "falls most y = -1/3*x, through 3 lower"],
        ),
        (
            "level.csv --x x --y y --eps 1 --x-origin 3",
            vec![
                "rises most y = (x - 3) + 1, through 1 lower, 3 upper",
                "falls most y = -(x - 3) - 1, through 1 upper, 3 lower",
            ],
        ),
        (
            "level.csv --x x --y y --eps 1 --where 'theta1 >= 0'",
            vec![
                "steepest y = x - 2, through 1 lower, 3 upper",
                "shallowest such as y = -0.9, limited by where:1",
            ],
        ),
        ("exact.csv --x x --y y --eps 0", vec!["slope y = x + 1, through 2 lower, 3 upper"]),
        (
            "upright.csv --x x --y y --eps 1",
            vec!["slope any: there are lines as steep as one likes, both ways"],
        ),
        (
            "open.csv --x x --lower lo --upper up",
            vec![
                "rises most y = 3*x, through 1 lower, 2 upper",
                "falls most none: there are lines as steep as one likes",
            ],
        ),
        ("two.csv --x u,v --y y --eps 1", vec![]),
    ] {
        assert_eq!(said(&directory, line), expected, "{line}");
    }
}

#[test]
fn both_lines_are_a_field_of_the_json() {
    let directory = directory();
    let found = report(directory.path(), "fit falling.csv --x x --y y --eps 1", b"");
    for (name, end) in [("largest", "upper"), ("smallest", "lower")] {
        let line = &found["slopes"][name];
        assert_eq!(line["theta"][0]["exact"], found["pui"][0][end]["exact"]);
        let rows = |terms: &Value| -> Vec<Value> {
            terms.as_array().unwrap().iter().map(|term| term["row"].clone()).collect()
        };
        assert_eq!(rows(&line["active"]), rows(&found["pui"][0][end]["active"]));
        assert_eq!(line.get("side"), None);
    }
    assert_eq!(found["slopes"]["smallest"]["theta"][1]["exact"], "13/2");
    let upright = report(directory.path(), "fit upright.csv --x x --y y --eps 1", b"");
    assert_eq!(upright["slopes"], serde_json::json!({"largest": null, "smallest": null}));
    for (line, reason) in [
        ("fit two.csv --x u,v --y y --eps 1", "the model is not a line"),
        ("fit falling.csv --x x --y y --eps 0", "the FPS is empty"),
    ] {
        let found = report(directory.path(), line, b"");
        assert_eq!((&found["slopes"], &found["reasons"]["slopes"]), (&Value::Null, &reason.into()));
    }
}
