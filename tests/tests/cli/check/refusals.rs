//! The input that `check` refuses.

use super::{NEAR_PARALLEL, boundfit};

#[test]
fn claims_files_that_are_none() {
    let form = r#"(expected {"source": "...", "status": "optimal|infeasible|unbounded", "pui": [[LO, HI], [LO, HI]]})"#;
    let statuses = "(expected optimal, infeasible, unbounded or infeasible-or-unbounded)";
    let no_value = "the status is optimal, but there is neither \"pui\" nor \"points\"";
    let cases: [(&[u8], &[&str]); 16] = [
        (b"", &["this is no claim (expected JSON, or a solution as GLPK"]),
        (b"{", &["EOF while parsing", form]),
        (b"theta1 in [0.05, 0.15]", &["this is no claim (expected JSON, or a solution as GLPK"]),
        (b"[[0, 1], [2, 3]]", &[form]),
        (br#"{"pui": [[0, 1], [2, 3]], "eui": null}"#, &["unknown field `eui`", form]),
        (br#"{"status": "solved", "pui": [[0, 1], [2, 3]]}"#, &["\"solved\" is not a status", statuses]),
        (br#"{"pui": [[0, 1], [2]]}"#, &["invalid length 1", form]),
        (br#"{"pui": [[0, 1]]}"#, &["invalid length 1", form]),
        (br#"{"pui": [[0, 1, 2], [3, 4]]}"#, &[form]),
        (br#"{"pui": [[0, 1], [2, true]]}"#, &[form]),
        (br#"{"status": "optimal"}"#, &[no_value]),
        (br#"{"source": "me"}"#, &[no_value]),
        (
            br#"{"pui": [["one", 1], [2, 3]]}"#,
            &["\"one\" is not a number: unexpected character 'o' at character 1"],
        ),
        (br#"{"pui": [["1/0", 1], [2, 3]]}"#, &["\"1/0\" is not a number: zero denominator at character 3"]),
        (br#"{"pui": [[1e999, 1], [2, 3]]}"#, &["number out of range", form]),
        (b"{\"source\": \"\xff\"}", &["this is no text in UTF-8"]),
    ];
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("claim.json");
    let name = file.display().to_string();
    let refused = |file: &str, parts: &[&str]| {
        let run = boundfit(&format!("{NEAR_PARALLEL} --claim {file}"));
        assert_eq!((run.status, run.stdout.as_str()), (1, ""), "{parts:?} {run:?}");
        assert!(run.stderr.starts_with(&format!("error: {file}: ")), "{}", run.stderr);
        assert!(
            run.stderr.lines().count() == 1 && parts.iter().all(|part| run.stderr.contains(part)),
            "{run:?}"
        );
    };
    for (bytes, parts) in cases {
        std::fs::write(&file, bytes).unwrap();
        refused(&name, parts);
    }
    std::fs::write(&file, r#"{"points": [["x", 1], null, null, null]}"#).unwrap();
    refused(&name, &["\"x\" is not a number"]);
    refused(&folder.path().join("none.json").display().to_string(), &["cannot read: "]);
    refused(&folder.path().display().to_string(), &["no solution is in this folder"]);
}

#[test]
fn options_that_make_no_sense() {
    let ends = "'--claim-pui <LO1,HI1,LO2,HI2>'";
    let count = "(expected four: LO1,HI1,LO2,HI2, each a number, inf or -inf)";
    let value =
        |text: &str, option: &str, problem: &str| format!("invalid value '{text}' for {option}: {problem}");
    let cases = [
        ("--claim-pui 1,2,3", value("1,2,3", ends, &format!("3 values {count}"))),
        ("--claim-pui 1,2,3,4,5", value("1,2,3,4,5", ends, &format!("5 values {count}"))),
        ("--claim-pui ''", value("", ends, &format!("1 value {count}"))),
        (
            "--claim-pui 1,2,3,x",
            value("1,2,3,x", ends, "\"x\" is not a number: unexpected character 'x' at character 1"),
        ),
        ("--claim-pui 1,2,,4", value("1,2,,4", ends, "\"\" is not a number: nothing to read at character 1")),
        (
            "--claim-pui 1,nan,2,4",
            value("1,nan,2,4", ends, "\"nan\" is not a number: not a finite number at character 1"),
        ),
        (
            "--tolerance -1",
            value("-1", "'--tolerance <NUM>'", "expected a number that is at least 0, such as 1e-6"),
        ),
        (
            "--tolerance small",
            value(
                "small",
                "'--tolerance <NUM>'",
                "not a number: unexpected character 's' at character 1 (expected a number that is at least 0, such as 1e-6)",
            ),
        ),
    ];
    for (options, message) in cases {
        let run = boundfit(&format!("{NEAR_PARALLEL} {options}"));
        assert_eq!((run.status, run.stdout.as_str()), (2, ""), "{options}");
        assert_eq!(run.stderr.lines().next(), Some(format!("error: {message}").as_str()), "{options}");
    }
    for options in ["--directions 2", "--directions 10001", "--directions x", "--time-limit 0", "--solver"] {
        let run = boundfit(&format!("{NEAR_PARALLEL} {options}"));
        assert_eq!((run.status, run.stdout.as_str()), (2, ""), "{options}");
    }
    let run = boundfit(&format!("{NEAR_PARALLEL} --solver glpk --solver microlp"));
    assert_eq!((run.status, run.stdout.as_str()), (2, ""));
    let names = boundfit_check::source_names().join(", ");
    let message = format!("error: there is no solver \"glpk\" in this build; it has {names}");
    assert_eq!(run.stderr.lines().next(), Some(message.as_str()));
    assert!(names.starts_with("microlp, clarabel") && names.ends_with("exact-simplex"), "{names}");
}

/// A list has no names that say what its numbers are.
#[test]
fn a_claim_is_no_list() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("claim.json");
    let form = r#"(expected {"source": "...", "status": "optimal|infeasible|unbounded", "pui": [[LO, HI], [LO, HI]]})"#;
    for text in ["[]", r#"["me", "optimal", [[0, 1], [2, 3]], null, null]"#] {
        std::fs::write(&file, text).unwrap();
        let run = boundfit(&format!("{NEAR_PARALLEL} --claim {}", file.display()));
        let message = format!("error: {}: a list {form}\n", file.display());
        assert_eq!((run.status, run.stderr), (1, message), "{text}");
    }
}
