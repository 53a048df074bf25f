//! The verdicts of `boundfit verify` on proofs that are true, false or about other questions, and its refusals.

use std::fs;
use std::process::Command;

use boundfit_tests::cli::{boundfit, boundfit_with_input, directory_with};
use boundfit_tests::program::{binary, root};
use serde_json::{Value, json};
use tempfile::TempDir;

const DATA: &str = "x,y,e,lo,up,w\n1,2,1,1.5,2.5,0\n2,3.1,1/2,NA,3.5,1\n3,3.9,0.25,3,,2\n4,5,1,4,6,1\n";

/// A folder with the data and the proof of a fit of them.
fn proved(options: &str) -> TempDir {
    let directory = directory_with(&[("a.csv", DATA.as_bytes())]);
    let run = boundfit(directory.path(), &format!("fit a.csv {options} --no-lp --proof p.json"));
    assert!([0, 3].contains(&run.status), "{options}: {run:?}");
    directory
}

#[test]
fn a_true_proof_is_said_to_answer_this_question() {
    let directory = proved("--x x --y y --eps 0.2 --rows 1,3..4 --where 2*theta1<=1.8");
    let expected = "verified: p.json is true of a.csv\n  \
        model   y = theta1*x + theta2 + e\n  \
        x       column 1 (\"x\")\n  \
        y       column 2 (\"y\")\n  \
        error   |e| <= 1/5 (0.2) in every row\n  \
        where   2*theta1 <= 9/5\n  \
        rows    1 and 3 to 4 of 4\n  \
        read    numbers as written (decimal), commas between cells, a header\n  \
        from    7 half-planes\n  \
        proved  the set, the active bounds of each vertex, both intervals\n  \
        set     bounded, with 3 vertices and 3 sides\n";
    let text = boundfit(directory.path(), "verify p.json a.csv");
    assert!(text.status == 0 && text.stdout.starts_with(expected), "{}", text.stdout);
    let run = boundfit(directory.path(), "verify p.json a.csv --format json");
    let json: Value = serde_json::from_str(&run.stdout).unwrap();
    let (about, set) = (&json["about"], &json["set"]);
    assert_eq!(
        (&json["verified"], &json["falsehood"], &json["differences"]),
        (&json!(true), &Value::Null, &json!([]))
    );
    assert_eq!((&json["proof"], &json["data"]), (&json!("p.json"), &json!("a.csv")));
    assert_eq!((&about["rows"], &about["rows_total"]), (&json!([[1, 1], [3, 4]]), &json!(4)));
    assert_eq!(
        (&about["reading"], &about["header"], &about["delimiter"]),
        (&json!("decimal"), &json!(true), &json!(","))
    );
    assert_eq!((&about["phi1"]["column"], &about["phi1"]["name"]), (&json!(1), &json!("x")));
    assert_eq!(
        (&about["epsilon"]["column"], &about["epsilon"]["times"]["exact"]),
        (&json!(0), &json!("1/5"))
    );
    assert_eq!(
        (&about["conditions"], &about["interval"], &about["law"]),
        (&json!(["2*theta1 <= 9/5"]), &Value::Null, &Value::Null)
    );
    assert_eq!((&set["extent"], &set["vertices"], &set["sides"]), (&json!("bounded"), &json!(3), &json!(3)));
    assert_eq!(set["ranges"][0]["upper"]["exact"], "9/10");
}

#[test]
fn every_model_and_bound_is_named() {
    for (options, lines) in [
        ("--x x,w --y y --eps 3", &["model   y = theta1*u + theta2*v + e", "v       column 6 (\"w\")"][..]),
        ("--x x --y y --eps-column e", &["error   |e| <= column 3 (\"e\")"]),
        (
            "--x x --lower lo --upper up",
            &[
                "model   lower <= theta1*x + theta2 <= upper",
                "lower   column 4 (\"lo\")",
                "upper   column 5 (\"up\")",
            ],
        ),
        (
            "--x x --y y --eps 10%*|y|+2*written",
            &[
                "model   y - below <= theta1*x + theta2 <= y + above",
                "above   1/10*|column 2| + 2*half a unit of the last digit in column 2",
            ],
        ),
        ("--x x --y y --eps 1 --x-origin 5/2", &["x       column 1 (\"x\"), less 2.5"]),
        ("--x x --y y --eps 1 --through-origin", &["where   theta2 = 0"]),
        ("--x 1 --y 2 --eps 1 --reading binary64", &["read    nearest doubles (binary64), "]),
        ("--x x --y y --eps 0", &["set     empty", "proved  no parameters agree"]),
    ] {
        let directory = proved(options);
        let run = boundfit(directory.path(), "verify p.json a.csv");
        assert_eq!(run.status, 0, "{options}");
        for line in lines {
            assert!(run.stdout.contains(&format!("\n  {line}")), "{options}: {line}: {}", run.stdout);
        }
        let widest = run.stdout.lines().map(|line| line.chars().count()).max();
        assert!(widest <= Some(80), "{options}: {}", run.stdout);
    }
}

/// The very options of the fit ask the question that its proof answers.
#[test]
fn the_options_of_the_fit_ask_the_same_question() {
    for options in [
        "--x x --y y --eps 0.2",
        "--x 1 --y 2 --eps 1/5 --rows 1..3",
        "--x x --y y --eps 0.2 --without 2",
        "--x x --y y --eps 0.2 --rows 2..",
        "--x x --y y --eps 0.2 --where theta1<=0.9 --where theta2=1.3",
        "--x x,w --y y --eps 3",
        "--x x --y y --eps-column e",
        "--x x --lower lo --upper up",
        "--x x --y y --lower lo --upper up --x-origin 2",
        "--x x --y y --eps 10%*|y|+2*written",
        "--x x --y y --eps +0.5/-1%*|x|",
        "--x x --y y --eps 0.1+0.2",
        "--x x --y y --eps 0.2 --reading binary64 --x-origin 0.1",
        "--x x --y y --eps 2 --through-origin --header yes --delimiter comma",
    ] {
        let directory = proved(options);
        let run = boundfit(directory.path(), &format!("verify p.json a.csv {options}"));
        assert_eq!(run.status, 0, "{options}: {}{}", run.stdout, run.stderr);
    }
}

#[test]
fn a_proof_about_another_question_is_refuted() {
    let whole = "--x x --y y --eps 0.2";
    for (fitted, asked, sentence) in [
        ("--x x --y y --eps 5", whole, "eps = 5, not 0.2"),
        ("--x x --y y --eps 5", "--eps 0.2", "eps = 5, not 0.2"),
        ("--x y --y x --eps 0.2", whole, "x = column 2 (\"y\"), not x"),
        ("--x y --y x --eps 0.2", "--y 2", "y = column 1 (\"x\"), not 2"),
        ("--x x --y y --eps 0.2 --where theta1<=0.9", whole, "the conditions 'theta1 <= 9/10', not none"),
        (whole, "--where theta1<=0.9", "the conditions none, not 'theta1 <= 9/10'"),
        ("--x x --y y --eps 0.2 --rows 1..3", whole, "rows 1 to 3 of 4, not all 4"),
        (whole, "--rows 2..", "rows 1 to 4 of 4, not 2.."),
        (whole, "--without 2", "rows 1 to 4 of 4, not all 4 without 2"),
        (whole, "--reading binary64", "the reading decimal, not binary64"),
        (whole, "--header no", "data with a header, not without a header"),
        (whole, "--delimiter tab", "cells between ',', not '\\t'"),
        (whole, "--eps-column e", "eps = 0.2, not column e"),
        (whole, "--lower lo", "eps = 0.2, not values between lo and nothing"),
        (
            "--x x --lower lo --upper up",
            "--upper up",
            "values between column 4 (\"lo\") and column 5 (\"up\"), not ",
        ),
        ("--x x --y y --eps 10%*|y|", "--eps 9%*|y|", "an error bound that is a law, not 9%*|y|"),
        ("--x x,w --y y --eps 3", "--x x", "the second x = column 6 (\"w\"), not a line with an offset"),
        (whole, "--x-origin 1", "x counted from 0, not 1"),
        (whole, "--through-origin", "a line with an offset, not one through the origin"),
    ] {
        let directory = proved(fitted);
        assert_eq!(boundfit(directory.path(), "verify p.json a.csv").status, 0, "{fitted}");
        let run = boundfit(directory.path(), &format!("verify p.json a.csv {asked}"));
        let expected = "refuted: p.json is not true of a.csv as asked\n  the proof is about ";
        assert!(run.status == 4 && run.stdout.starts_with(expected), "{fitted} {asked}: {run:?}");
        assert!(
            run.stdout.contains(&format!("the proof is about {sentence}")),
            "{fitted} {asked}: {}",
            run.stdout
        );
        let run = boundfit(directory.path(), &format!("verify p.json a.csv {asked} --format json"));
        let json: Value = serde_json::from_str(&run.stdout).unwrap();
        assert_eq!((run.status, &json["verified"]), (4, &json!(false)), "{fitted} {asked}");
        assert_eq!(json["falsehood"], json["differences"][0], "{fitted} {asked}");
    }
}

/// A proof is compared as `fit` understands the question: errors of x, what is added to y, and columns by the names that mean them.
#[test]
fn nothing_of_the_question_is_left_out() {
    let added = r#"{"schema":"boundfit/proof/2","sha256":"HASH","delimiter":",","header":true,"rows":[1,3],"reading":"decimal",
        "model":[[1,"1"],[0,"1"],[2,"1"],[0,"3/10"]],"response":[[3,"1"]],"conditions":[],
        "statements":[{"kind":"empty","multipliers":[["1 lower","1"],["2 upper","2"],["3 lower","1"]]}]}"#;
    let sum: &[u8] = b"x,y,z\n0,0,9\n1,1,0\n2,2,9\n";
    let hash = "3cb06592cea439625b82d7703bbbec45f7f52e7f333c84f9b1f62bd1a2790792";
    let directory = directory_with(&[
        ("e.csv", b"x,y\n0,1\n1,5\n2,2\n"),
        ("sum.csv", sum),
        ("added.json", added.replace("HASH", hash).as_bytes()),
        ("units.csv", b"U (V),U,y\n0,5,0\n1,1,1\n2,0,2\n"),
        ("twice.csv", b"x,x,y\n0,5,0\n1,1,1\n2,0,2\n"),
        ("numbers.csv", b"time,1,2\n0,5,0\n1,1,1\n2,0,2\n"),
    ]);
    let folder = directory.path();
    for (fit, asked, expected) in [
        (
            "e.csv --x x --y y --eps 0.1 --x-eps 5",
            "",
            Ok("errors in x up to 5, for some x within them, not of 0"),
        ),
        (
            "e.csv --x x --y y --eps 5",
            "--x-eps 0.1",
            Ok("errors in x of 0, not up to 0.1, for some x within them"),
        ),
        (
            "e.csv --x x --y y --eps 5 --x-eps y",
            "--x-eps 5",
            Ok(
                "errors in x up to column 2 (\"y\"), for some x within them, not up to 5, for some x within them",
            ),
        ),
        (
            "e.csv --x x --y y --eps 5 --x-eps 0.1",
            "--x-eps 0.1 --strong",
            Ok("errors in x up to 0.1, for some x within them, not up to 0.1, for every x within them"),
        ),
        ("units.csv --x 1 --y y --eps 1", "--x U", Ok("x = column 1 (\"U (V)\"), not U")),
        ("twice.csv --x 2 --y y --eps 9", "--x x", Err("there are several columns \"x\"")),
        (
            "numbers.csv --x time --y 3 --eps 9",
            "--y 2",
            Err("\"2\" is the name of column 3 and the number of another one"),
        ),
    ] {
        assert!([0, 3].contains(&boundfit(folder, &format!("fit {fit} --proof p.json")).status), "{fit}");
        let data = fit.split(' ').next().unwrap();
        let words: Vec<&str> = fit.split(' ').skip(1).collect();
        // An option that is asked for comes in the place of that of the fit.
        let own: Vec<String> = words
            .chunks(2)
            .filter(|pair| !asked.starts_with(pair[0]) && pair[0] != "--x-eps")
            .map(|pair| pair.join(" "))
            .collect();
        let run = boundfit(folder, &format!("verify p.json {data} {} {asked}", own.join(" ")));
        match expected {
            Ok(difference) => {
                assert_eq!(run.status, 4, "{fit} {asked}: {run:?}");
                let line = format!("  the proof is about {difference}\n");
                assert!(run.stdout.contains(&line), "{fit} {asked}\n{}", run.stdout);
            }
            Err(message) => {
                assert_eq!(run.status, 1, "{fit} {asked}: {run:?}");
                assert!(run.stderr.contains(message), "{fit} {asked}\n{}", run.stderr);
            }
        }
    }
    for question in ["--x-eps y", "--x-eps-column y", "--x-eps y --strong"] {
        let line = format!("e.csv --x x --y y --eps 5 {question}");
        assert!([0, 3].contains(&boundfit(folder, &format!("fit {line} --proof p.json")).status), "{line}");
        assert_eq!(boundfit(folder, &format!("verify p.json {line}")).status, 0, "{line}");
    }
    let run = boundfit(folder, "verify added.json sum.csv --x x --y y --eps 0.3");
    assert_eq!(run.status, 4, "{run:?}");
    let added = "  the proof is about y = column 2 (\"y\") + column 3 (\"z\"), not y\n";
    assert!(run.stdout.contains(added), "{}", run.stdout);
}

/// Coq's kernel accepts a second definition of the rows, and theorems about it.
#[test]
fn a_theorem_about_other_rows_is_none() {
    let directory = directory_with(&[("a.csv", b"x,y\n0,0\n1,1.1\n2,1.9\n3,3.2\n")]);
    let folder = directory.path();
    let theorem = |data: &str, eps: &str| {
        let line = format!("fit {data} --x x --y y --eps {eps} --proof t.v");
        assert_eq!(boundfit_with_input(folder, &line, b"x,y\n0,100\n1,100\n").status, 0);
        fs::read_to_string(folder.join("t.v")).unwrap()
    };
    let (own, other) = (theorem("a.csv", "0.3"), theorem("-", "1"));
    let (before, _) = own.split_once("Definition feasibleR").unwrap();
    let (_, rows) = other.split_once("Definition rows :").unwrap();
    let rows = rows.replace("Definition feasible (", "Definition  feasible (");
    for (forged, refusal) in [
        (
            format!("{before}Module Z.\nDefinition  rows :{rows}End Z. Import Z.\n"),
            "behind what the rows say \"Module Z\" begins a sentence that could change it",
        ),
        (
            format!("{before}Definition  rows :{rows}"),
            "\"rows\" is defined once more behind what the rows say",
        ),
        (
            format!("{own}Lemma\n(* no *) feasible : True. Proof. exact I. Qed.\n"),
            "\"feasible\" is defined once more behind what the rows say",
        ),
        (
            own.replacen(
                "Definition vertices ",
                "Definition is_range (_ : Q * Q -> Prop) (_ _ : option Q) := True.\nDefinition vertices ",
                1,
            ),
            "behind what the rows say \"is_range\" is defined, which boundfit does not do there",
        ),
        (
            format!("{own}#[local] Notation rows := (List.nil).\n"),
            "behind what the rows say \"#[local] Notation ro\" begins a sentence that could change it",
        ),
    ] {
        fs::write(folder.join("t.v"), forged).unwrap();
        let run = boundfit(folder, "verify t.v a.csv --x x --y y --eps 0.3");
        assert_eq!(run.status, 1, "{refusal}: {run:?}");
        assert!(run.stderr.contains(refusal), "{refusal}\n{}", run.stderr);
    }
}

#[test]
fn what_only_the_readings_tell_is_not_compared() {
    let directory = proved("--x x --y y --eps 0.2");
    for (asked, what) in [
        ("--eps min", "'--eps min'"),
        ("--where-row x>1", "'--where-row'"),
        ("--eps 5%*range(y)", "'range(y)'"),
    ] {
        let run = boundfit(directory.path(), &format!("verify p.json a.csv {asked}"));
        assert_eq!((run.status, run.stdout.as_str()), (2, ""), "{asked}");
        assert!(run.stderr.contains(&format!("{what} depends on the readings")), "{asked}: {}", run.stderr);
    }
}

/// A false proof whose side has the verdict's own words for a name, after sequences that would wipe out the true one.
#[test]
fn texts_of_a_proof_cannot_be_taken_for_a_verdict() {
    let directory = proved("--x x --y y --eps 0.2");
    let proof = std::fs::read_to_string(directory.path().join("p.json")).unwrap();
    let mut proof: Value = serde_json::from_str(&proof).unwrap();
    let name = "\u{1b}[1A\u{1b}[2K\rverified: p.json is true of a.csv\n  set     \u{202e}bounded\u{9b}";
    proof["sides"][0][0] = name.into();
    std::fs::write(directory.path().join("spoof.json"), proof.to_string()).unwrap();
    let python = Command::new("python3")
        .arg(root().join("tests/verify.py"))
        .args(["spoof.json", "a.csv"])
        .current_dir(directory.path())
        .output()
        .expect("python3 is needed");
    let printed = [
        boundfit(directory.path(), "verify spoof.json a.csv").stdout,
        boundfit(directory.path(), "verify spoof.json a.csv --format json").stdout,
        String::from_utf8(python.stdout).unwrap(),
    ];
    for (text, lines) in printed.iter().zip([2, usize::MAX, 1]) {
        assert!(
            text.lines().count() <= lines && text.contains(r"\u{1b}[1A") || text.contains(r"\\u{1b}[1A"),
            "{text}"
        );
        let is_shown =
            |character: char| character == '\n' || character.is_ascii() && !character.is_ascii_control();
        assert!(text.chars().all(is_shown), "{text:?}");
        assert!(!text.lines().any(|line| line.starts_with("verified")), "{text}");
    }
    assert_eq!(python.status.code(), Some(4));
}

/// A name with a line end is one line of the verdict on a true proof, too.
#[test]
fn names_of_columns_and_files_are_shown_on_one_line() {
    let data = DATA.replacen("x,y", "\"x\n  set     empty\",y", 1);
    let directory = directory_with(&[("a\u{1b}.csv", data.as_bytes())]);
    let fit = [
        "fit",
        "a\u{1b}.csv",
        "--x",
        "1",
        "--y",
        "y",
        "--eps",
        "1",
        "--no-lp",
        "--header",
        "yes",
        "--proof",
        "p.json",
    ];
    let run = |arguments: &[&str]| {
        let output = Command::new(binary()).args(arguments).current_dir(directory.path()).output().unwrap();
        String::from_utf8(output.stdout).unwrap()
    };
    run(&fit);
    let text = run(&["verify", "p.json", "a\u{1b}.csv"]);
    assert!(text.starts_with("verified: p.json is true of a\\u{1b}.csv\n"), "{text}");
    assert!(text.contains("x       column 1 (\"x\\n  set     empty\")\n"), "{text}");
}

/// Data without an end or without line ends are refused before much of them is in memory.
#[cfg(target_os = "linux")]
#[test]
fn endless_data_are_refused_in_bounded_time_and_memory() {
    let directory = proved("--x x --y y --eps 0.2");
    let long = format!("x,y\n1,{}\n", "2".repeat(1 << 25));
    std::fs::write(directory.path().join("long.csv"), long).unwrap();
    let many = format!("x,y\n1{}\n", ",".repeat(200_000));
    std::fs::write(directory.path().join("many.csv"), many).unwrap();
    for (data, option) in
        [("/dev/zero", "--limit line=N"), ("long.csv", "--limit line=N"), ("many.csv", "--limit columns=N")]
    {
        let mut command = Command::new("sh");
        command.args(["-c", "ulimit -t 2 && ulimit -v 400000 && exec \"$0\" \"$@\""]).arg(binary());
        let output = command.args(["verify", "p.json", data]).current_dir(directory.path()).output().unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(1), "{data}: {message}");
        assert!(message.ends_with(&format!("(the limit); {option} raises it\n")), "{data}: {message}");
    }
    let raised = boundfit(directory.path(), "verify p.json long.csv --limit line=100000000");
    assert!(raised.status == 4 && raised.stdout.contains("sha256: is not that of the data"), "{raised:?}");
}

#[test]
fn data_that_can_be_read_but_once_are_verified_too() {
    let directory = proved("--x x --y y --eps 0.2");
    let run = boundfit_with_input(directory.path(), "verify p.json -", DATA.as_bytes());
    assert!(
        run.status == 0 && run.stdout.starts_with("verified: p.json is true of standard input\n"),
        "{run:?}"
    );
    let other =
        boundfit_with_input(directory.path(), "verify p.json -", DATA.replace("3.9", "3.8").as_bytes());
    assert_eq!(other.status, 4);
}

/// Both checkers refuse within about a second.
#[test]
fn a_proof_with_an_endless_number_is_none() {
    let directory = proved("--x x --y y --eps 0.2");
    let proof = std::fs::read_to_string(directory.path().join("p.json")).unwrap();
    for number in ["1e1000000", "1e-1000000", "0.5", "1/0", "+1", "-", ""] {
        let changed = proof.replacen("\"1/5\"", &format!("\"{number}\""), 1);
        assert_ne!(changed, proof);
        std::fs::write(directory.path().join("other.json"), changed).unwrap();
        let run = boundfit(directory.path(), "verify other.json a.csv");
        assert!(run.status == 1 && run.stderr.contains("other.json: not a proof: "), "{number}: {run:?}");
        let mut command = Command::new("sh");
        command
            .args(["-c", "ulimit -t 2 && exec python3 \"$0\" other.json a.csv"])
            .arg(root().join("tests/verify.py"));
        let output = command.current_dir(directory.path()).output().unwrap();
        assert_eq!(output.status.code(), Some(1), "{number}: {output:?}");
        assert!(output.stdout.starts_with(b"not a proof: "), "{number}: {output:?}");
    }
}

#[test]
fn what_is_no_proof_is_refused_with_its_line_and_text() {
    let directory = proved("--x x --y y --eps 0.2");
    let proof = std::fs::read_to_string(directory.path().join("p.json")).unwrap();
    boundfit(directory.path(), "range a.csv --x x --y y --eps 0.2 --proof r.json");
    let range = std::fs::read_to_string(directory.path().join("r.json")).unwrap();
    let kinds =
        "(expected JSON of schema boundfit/proof/1 or boundfit/proof/2, or a theorem of boundfit for Coq)";
    for (text, problem) in [
        ("\n\nx,y\n1,2\n".to_owned(), format!("line 3 begins with \"x,y\", not with {{ {kinds}")),
        (
            proof.replace("boundfit/proof/1", "boundfit/proof/3"),
            format!("its schema is \"boundfit/proof/3\" {kinds}"),
        ),
        ("{}".to_owned(), format!("not a proof: it has no \"schema\" {kinds}")),
        (proof.replacen('{', "{\"schema\": \"a\", ", 1), "\"schema\" is there twice at line ".to_owned()),
        (
            proof.replacen('{', "{\"scheme\": 1, ", 1),
            format!("there is no field \"scheme\" in a proof {kinds}"),
        ),
        (
            proof.replacen('{', "{\"statements\": [],", 1),
            "the schema \"boundfit/proof/1\" has no field \"statements\"".to_owned(),
        ),
        (
            range.replacen("\"kind\": \"", "\"kind\": \"no ", 1),
            "(expected \"form\", \"point\", \"empty\", \"least\", \"set\" or \"left out\")".to_owned(),
        ),
        (
            range.replacen("\"kind\": ", "\"lower\": [[], [\"0\", \"0\"], [\"0\", \"0\"]], \"kind\": ", 1),
            "not a proof: statement 1: a statement of the kind ".to_owned(),
        ),
    ] {
        let run = boundfit_with_input(directory.path(), "verify - a.csv", text.as_bytes());
        assert!(run.status == 1 && run.stderr.starts_with("error: standard input: not a proof: "), "{run:?}");
        assert!(run.stderr.contains(&problem), "{problem}: {run:?}");
    }
}
