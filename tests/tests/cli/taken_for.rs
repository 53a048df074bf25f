//! The detected format of a table, which every command reports: in its document, or else in a note on standard error.

use boundfit_tests::cli::{boundfit, boundfit_with_input, directory_with, unbroken};
use boundfit_tests::program::root;
use serde_json::Value;

const TABLE: &str = "fixtures/guesses/pandas-nonames.csv";
const WORDS: &str = "header in line 1 (else header no)";

/// Commands whose answers have no place for what a table was taken for; `{}` is the table.
const WITHOUT_PLACE: [&str; 13] = [
    "fit {} --x 2 --y 3 --eps 1 --by 3 --format csv",
    "fit {} --x 2 --y 3 --eps 1 --window 4 --format csv",
    "fit {} --x 2 --y 3 --eps 1 --format csv",
    "fit {} --x 2 --y 3 --eps 1 --x-eps 0.1 --format csv",
    "plot {} --x 2 --y 3 --eps 1",
    "plot {} --x 2 --y 3 --eps 1 --eps 2",
    "plot {} --x 2 --y 3 --eps 1 --by 3 --figure fps",
    "plot {} --x 2 --y 3 --eps 1 --x-eps 0.1 --figure fps",
    "reduce {} --x 2 --y 3",
    "convert {} --x 2 --y 3 --eps 1 --to lp --objective theta1-min",
    "status {} --x 2 --y 3 --eps 1 --format csv",
    "range {} --x 2 --y 3 --eps 1 --format csv",
    "linearity {} --x 2 --y 3 --format csv",
];

#[test]
fn an_answer_without_a_place_for_it_has_a_note() {
    for line in WITHOUT_PLACE {
        let run = boundfit(&root(), &line.replace("{}", TABLE));
        let notes: Vec<&str> = run.stderr.lines().filter(|line| line.starts_with("note: ")).collect();
        assert_eq!(notes, [format!("note: {TABLE}: {WORDS}")], "{line}: {}", run.stderr);
        assert!(!run.stdout.contains(WORDS), "{line}");
    }
}

#[test]
fn a_document_with_a_place_for_it_has_no_note() {
    for line in [
        "fit {} --x 2 --y 3 --eps 1",
        "fit {} --x 2 --y 3 --eps 1 --brief",
        "status {} --x 2 --y 3 --eps 1",
        "range {} --x 2 --y 3 --eps 1",
        "outliers {} --x 2 --y 3 --eps 1",
        "predict {} --x 2 --y 3 --eps 1 --at 3",
        "linearity {} --x 2 --y 3",
        "fit {} --x 2 --y 3 --eps 1 --by 3",
        "fit {} --x 2 --y 3 --eps 1 --window 4",
        "check {} --x 2 --y 3 --eps 1 --solver exact-simplex",
    ] {
        let run = boundfit(&root(), &line.replace("{}", TABLE));
        assert!(unbroken(&run.stdout).contains(WORDS), "{line}: {}", run.stdout);
        assert_eq!(run.stderr, "", "{line}");
    }
}

/// Every line of JSON of a command that writes many has the part `input.table` of `fit`.
#[test]
fn documents_of_groups_windows_and_checks_have_what_that_of_a_fit_has() {
    let json = |line: &str| -> Vec<Value> {
        let run =
            boundfit(&root(), &format!("{} --x 2 --y 3 --eps 1 --format json", line.replace("{}", TABLE)));
        assert!(!run.stderr.contains("note: "), "{line}: {}", run.stderr);
        let documents = serde_json::Deserializer::from_str(&run.stdout).into_iter();
        documents.map(|document| document.unwrap()).collect()
    };
    let expected = json("fit {}")[0]["input"]["table"].clone();
    assert_eq!(expected["header"]["open"], true);
    for line in ["fit {} --by 3", "fit {} --window 4", "check {} --solver exact-simplex"] {
        let found = json(line);
        assert!(!found.is_empty(), "{line}");
        assert!(found.iter().all(|document| document["input"]["table"] == expected), "{line}: {found:?}");
    }
}

/// Records have no delimiter and no header, but they are text.
#[test]
fn records_say_how_they_are_encoded() {
    let records = b"[{\"x\":1,\"y\":2,\"Gr\xf6\xdfe\":3},{\"x\":2,\"y\":3},{\"x\":3,\"y\":5}]";
    let lines = records[1..records.len() - 1].split(|&byte| byte == b'{').skip(1);
    let lines = lines.map(|rest| [b"{", rest.strip_suffix(b",").unwrap_or(rest), b"\n"].concat());
    let directory = directory_with(&[
        ("array.json", records.as_slice()),
        ("lines.jsonl", &lines.collect::<Vec<_>>().concat()),
        ("utf-8.json", b"[{\"x\":1,\"y\":2},{\"x\":2,\"y\":3}]".as_slice()),
    ]);
    for (file, encoding) in
        [("array.json", "Windows-1252"), ("lines.jsonl", "Windows-1252"), ("utf-8.json", "UTF-8")]
    {
        let line = format!("fit {file} --x x --y y --eps 1");
        let run = boundfit(directory.path(), &format!("{line} --format json"));
        let document: Value = serde_json::from_str(&run.stdout).unwrap();
        let table = &document["input"]["table"];
        assert_eq!(
            [&table["encoding"], &table["delimiter"]],
            [&Value::from(encoding), &Value::Null],
            "{file}"
        );
        let report = boundfit(directory.path(), &line).stdout;
        assert_eq!(report.contains("  table    Windows-1252\n"), encoding != "UTF-8", "{report}");
        assert_eq!(report.contains("  table "), encoding != "UTF-8", "{report}");
    }
}

#[test]
fn nothing_is_said_of_a_plain_table() {
    let directory = directory_with(&[("plain.csv", b"g,x,y\n7,0,1\n7,1,2\n8,2,3\n8,3,4\n")]);
    for line in WITHOUT_PLACE {
        let run = boundfit(directory.path(), &line.replace("{}", "plain.csv"));
        assert!(!run.stderr.contains("note: "), "{line}: {}", run.stderr);
    }
}

/// A row of units is passed over as asked, which is no guess, but the report says which row that was.
#[test]
fn a_row_of_units_has_its_line_in_the_report() {
    let directory = directory_with(&[("units.csv", b"x,y\nmV,degC\n1,2\n2,3\n3,5\n")]);
    let line = "units.csv --x x --y y --units-row";
    let report = boundfit(directory.path(), &format!("fit {line} --eps 1"));
    assert!(report.stdout.contains("\n  table    units in line 2\n"), "{report:?}");
    assert_eq!(boundfit(directory.path(), &format!("reduce {line}")).stderr, "");
}

#[test]
fn what_was_said_by_an_option_is_no_guess() {
    for header in ["yes", "no"] {
        let run = boundfit(&root(), &format!("reduce {TABLE} --x 2 --y 3 --header {header}"));
        assert!(!run.stderr.contains("else --header"), "{}", run.stderr);
    }
}

#[test]
fn further_tables_are_spoken_of_by_their_own_names() {
    let directory = directory_with(&[
        ("data.csv", b"x,y\n0,1\n1,2\n2,3\n".as_slice()),
        ("bare.csv", b"3,4\n4,9\n".as_slice()),
        ("half.csv", b"1,0,2\n0,1,2\n-1,-1,1\n".as_slice()),
    ]);
    let note =
        |file: &str| format!("note: {file}: no header, the first line is a reading (else header yes)\n");
    for (line, file) in [
        ("predict data.csv --x 1 --y 2 --eps 1 --at bare.csv:1", "bare.csv"),
        ("status data.csv --x 1 --y 2 --eps 1 --new bare.csv", "bare.csv"),
    ] {
        assert_eq!(boundfit(directory.path(), line).stderr, note(file), "{line}");
    }
    // Without names half-planes are a1, a2 and b in this order: nothing is guessed.
    assert_eq!(boundfit(directory.path(), "polygon half.csv").stderr, "");
    let run = boundfit_with_input(directory.path(), "reduce - --x 1 --y 2", b"3,4\n4,9\n");
    assert_eq!(run.stderr, note("standard input"));
}
