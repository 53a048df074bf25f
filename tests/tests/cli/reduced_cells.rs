//! Reductions whose cells are written unusually: the line in front says how, so that the kept rows mean the same.

use std::path::Path;

use boundfit_tests::cli::{boundfit, directory_with};
use serde_json::Value;

/// Runs a fit in JSON; the interval of each parameter.
fn pui(directory: &Path, line: &str) -> Value {
    let run = boundfit(directory, &format!("fit {line} --format json"));
    let report: Value =
        serde_json::from_str(&run.stdout).unwrap_or_else(|_| panic!("{line}: {}", run.stderr));
    let end = |of: usize, end: &str| report["pui"][of][end]["exact"].clone();
    let both = [0, 1].map(|of| [end(of, "lower"), end(of, "upper")]);
    assert!(both[1][0].is_string(), "{line}: {report}");
    serde_json::json!(both)
}

#[test]
fn kept_rows_are_read_with_the_marks_and_words_of_their_table() {
    let directory = directory_with(&[
        ("group.csv", b"x;y;e\n0;1,052;40\n1;1,158;50\n2;1,188;60\n3;1,380;70\n4;1,447;90\n"),
        ("point.csv", b"x;y;e\n0;1.052,5;40\n1;1.158,5;50\n2;1.188;9\n3;1.380;70\n4;1.447;90\n"),
        ("words.csv", b"x,lo,up\n0,1,-999\n1,-999.0,5\n2,2,9\n3,1,-999\n4,-999,8\n0,-5,4\n"),
    ]);
    let run = |line: &str| boundfit(directory.path(), line);
    let marks = "--decimal comma --thousands .";
    for (file, marks, columns, fitted, written) in [
        ("group.csv", "--thousands ,", "--x x --y y", "--eps 60", "\"written\":{\"thousands\":\",\"},"),
        (
            "group.csv",
            "--thousands ,",
            "--x x --y y --eps-column e",
            "",
            "\"written\":{\"thousands\":\",\"},",
        ),
        (
            "point.csv",
            marks,
            "--x x --y y",
            "--eps 60",
            "\"written\":{\"decimal\":\"comma\",\"thousands\":\".\"},",
        ),
        (
            "words.csv",
            "--missing-as -999",
            "--x x --lower lo --upper up",
            "",
            "\"written\":{\"missing\":[\"-999\"]},",
        ),
    ] {
        let reduced = run(&format!("reduce {file} {columns} {marks} -o reduced.csv"));
        assert_eq!((reduced.status, reduced.stderr.as_str()), (0, ""), "{file}");
        let text = std::fs::read_to_string(directory.path().join("reduced.csv")).unwrap();
        assert!(text.lines().next().unwrap().contains(written), "{text}");
        let whole = pui(directory.path(), &format!("{file} {columns} {fitted} {marks}"));
        for marks in ["", marks] {
            assert_eq!(
                pui(directory.path(), &format!("reduced.csv {columns} {fitted} {marks}")),
                whole,
                "{file} {marks}"
            );
        }
        // A reduction of a reduction is itself.
        assert_eq!(run(&format!("reduce reduced.csv {columns}")).stdout, text);
    }
}

#[test]
fn other_marks_than_those_of_the_table_are_refused() {
    let head = |written: &str| {
        format!(
            "# boundfit/reduced/1 {{\"rows\":2,\"kept\":2,\"header\":true,\"reading\":\"decimal\",{written}\"x\":\"x\",\"y\":\"y\",\
             \"epsilon\":null,\"sums\":[\"1\",\"3001\",\"1\",\"2000\"]}}\nx;y\n0;1,001\n1;2,000\n"
        )
    };
    let good = head("\"written\":{\"thousands\":\",\"},");
    let directory = directory_with(&[
        ("good.csv", good.as_bytes()),
        ("both.csv", (good.clone() + &head("")).as_bytes()),
        ("apart.csv", head("\"written\":{\"thousands\":\"'\"},").replace("1,001", "1'001").as_bytes()),
        ("comma.csv", head("\"written\":{\"decimal\":\"komma\"},").as_bytes()),
        ("one.csv", head("\"written\":{\"decimal\":\"comma\",\"thousands\":\",\"},").as_bytes()),
        ("more.csv", head("\"written\":{\"marks\":\",\"},").as_bytes()),
    ]);
    for (line, message) in [
        ("good.csv --decimal comma", "the decimal mark of the reduction is \"point\", not \"comma\""),
        ("apart.csv --thousands ,", "the mark between digits in the reduction is \"'\", not \",\""),
        (
            "both.csv",
            "line 5 on differs from the first one in the stated marks in numbers or words for missing values",
        ),
        ("comma.csv", "is not understood: an unknown decimal mark"),
        ("one.csv", "is not understood: one mark for decimals and between digits"),
        ("more.csv", "is not understood: unknown field `marks`"),
    ] {
        let run = boundfit(directory.path(), &format!("fit {line} --x x --y y --eps 1"));
        assert_eq!((run.status, run.stdout.as_str()), (1, ""), "{line}");
        assert!(run.stderr.contains(message), "{line}\n{}", run.stderr);
    }
    assert_eq!(pui(directory.path(), "good.csv --x x --y y --eps 1")[1], serde_json::json!(["1000", "1002"]));
}

#[test]
fn reports_of_reductions_name_a_comma_that_was_taken_for_a_decimal_one() {
    let table = b"x;y\n0;1,5\n1;2,75\n2;4,25\n";
    let directory = directory_with(&[("table.csv", table)]);
    assert_eq!(boundfit(directory.path(), "reduce table.csv --x x --y y -o reduced.csv").status, 0);
    for file in ["table.csv", "reduced.csv"] {
        let run = boundfit(directory.path(), &format!("fit {file} --x x --y y --eps 1 --brief"));
        assert!(run.stdout.contains("  table    decimal comma, separated by semicolons\n"), "{}", run.stdout);
    }
}

#[test]
fn headers_and_rows_with_line_ends_are_read_again() {
    let open = "x,y,\"note\n\n(free text)\"\n0,1,q\n1,2,s\n3,1,t\n";
    let used = "\"x\r\n5 m\",y,n\n0,0,\"a\n\nb\"\n1,3,\"c\n\n\n 7\"\n1,3,d\n2,-1,e\n3,0,f\n";
    let directory = directory_with(&[("open.csv", open.as_bytes()), ("used.csv", used.as_bytes())]);
    for (file, x, lines) in [("open.csv", "x", 3), ("used.csv", "1", 2)] {
        let run = |line: &str| boundfit(directory.path(), line);
        let reduced = run(&format!("reduce {file} --x {x} --y y"));
        assert_eq!((reduced.status, reduced.stderr.as_str()), (0, ""), "{file}");
        let head = reduced.stdout.lines().next().unwrap();
        assert!(head.contains(&format!("\"header\":true,\"header_lines\":{lines},")), "{head}");
        std::fs::write(directory.path().join("one.r"), &reduced.stdout).unwrap();
        std::fs::write(directory.path().join("two.r"), reduced.stdout.repeat(2)).unwrap();
        for eps in ["1", "3"] {
            let whole = pui(directory.path(), &format!("{file} --x {x} --y y --eps {eps}0"));
            for reduction in ["one.r", "two.r"] {
                assert_eq!(
                    pui(directory.path(), &format!("{reduction} --x {x} --y y --eps {eps}0")),
                    whole,
                    "{file}"
                );
            }
        }
        // A reduction of a reduction is itself.
        assert_eq!(run(&format!("reduce one.r --x {x} --y y")).stdout, reduced.stdout);
        let other = reduced.stdout.clone() + &reduced.stdout.replacen(",y,", ",z,", 1);
        std::fs::write(directory.path().join("other.r"), other).unwrap();
        let refused = run(&format!("fit other.r --x {x} --y y --eps 9"));
        assert!(refused.stderr.contains("differs from the first one in its header"), "{}", refused.stderr);
    }
}

#[test]
fn a_header_of_many_lines_is_held_within_the_limit_of_a_line() {
    let head = "# boundfit/reduced/1 {\"rows\":1,\"kept\":1,\"header\":true,\"header_lines\":1000000000000,\"reading\":\"decimal\",\
                \"x\":\"x\",\"y\":\"y\",\"epsilon\":null,\"sums\":[\"0\",\"0\",\"0\",\"0\"]}\n";
    let table = head.to_owned() + &"x,y\n".repeat(1000);
    let directory = directory_with(&[("data.r", table.as_bytes())]);
    let run = boundfit(directory.path(), "fit data.r --x x --y y --eps 1 --limit line=300");
    assert_eq!(run.status, 1);
    assert!(run.stderr.contains("its header is longer than a line may be"), "{}", run.stderr);
}
