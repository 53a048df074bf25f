//! Proofs of linear ranges and outliers, which `verify` and the checker in Python accept.

use std::path::Path;
use std::process::Command;

use boundfit_tests::cli::{TRANSDUCER, boundfit, directory_with};
use boundfit_tests::program::root;
use serde_json::{Value, json};

#[test]
fn proofs_of_ranges_and_outliers_are_verified_by_both_checkers() {
    let directory = tempfile::tempdir().unwrap();
    let file = |name: &str| directory.path().join(name).to_str().unwrap().to_owned();
    let (proof, report) = (file("proof.json"), file("report.txt"));
    for (command, proved) in [
        ("range --eps 0.5e-3", "20 points, 38 contradictions"),
        ("outliers --rows 12..37 --eps 0.5e-3", "at least 2 rows out, one of 3 sets"),
        ("outliers --rows 14..36 --eps 0.5e-3", "at least 0 rows out, one of 1 set"),
    ] {
        let (name, options) = command.split_once(' ').unwrap();
        let line = format!("{name} {TRANSDUCER} --x Vz --y z {options} --proof {proof} -o {report}");
        let run = boundfit(&root(), &line);
        assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{line}");
        let run = boundfit(&root(), &format!("verify {proof} {TRANSDUCER}"));
        assert!(run.status == 0 && run.stdout.contains(proved), "{line}: {run:?}");
        let mut checker = Command::new("python3");
        checker
            .arg(root().join("tests/verify.py"))
            .args([&proof, &root().join(TRANSDUCER).display().to_string()]);
        assert!(checker.output().unwrap().stdout.starts_with(b"verified: "), "{line}");
    }
}

#[test]
fn a_proof_without_a_file_of_its_own_is_refused() {
    for name in ["range", "outliers"] {
        let line = format!("{name} {TRANSDUCER} --x Vz --y z --eps 1 --proof -");
        let run = boundfit(&root(), &line);
        assert!(run.status == 2 && run.stderr.contains("would both go to standard output"), "{run:?}");
    }
}

/// Both checkers refute it, one of them with these words.
fn refuted(directory: &Path, proof: &Value, expected: &str) {
    std::fs::write(directory.join("bad.json"), proof.to_string()).unwrap();
    let run = boundfit(directory, "verify bad.json a.csv");
    assert_eq!(run.status, 4, "{proof}: {run:?}");
    assert!(run.stdout.contains(expected), "{expected}: {}", run.stdout);
    assert_eq!(second_verdict(directory, "bad.json"), Some(4), "{proof}");
}

/// The exit status of the checker in Python.
fn second_verdict(directory: &Path, proof: &str) -> Option<i32> {
    let mut checker = Command::new("python3");
    let checker = checker.arg(root().join("tests/verify.py")).args([proof, "a.csv"]).current_dir(directory);
    checker.output().unwrap().status.code()
}

/// A list of sets is just the list of those that have to be left out, or the proof is none.
#[test]
fn the_sets_of_a_proof_are_shown_to_be_enough() {
    let data = "x,y\n0,0\n1,1\n2,5\n3,3\n4,4\n";
    let directory = directory_with(&[("a.csv", data.as_bytes())]);
    let line = "outliers a.csv --x x --y y --eps 0.5 --proof p.json -o report.txt";
    assert_eq!(boundfit(directory.path(), line).status, 0);
    let proof: Value =
        serde_json::from_slice(&std::fs::read(directory.path().join("p.json")).unwrap()).unwrap();
    assert_eq!(proof["statements"][0]["sets"], json!([[3]]));
    assert_eq!(second_verdict(directory.path(), "p.json"), Some(0));
    let with_sets = |sets: Value| {
        let mut bad = proof.clone();
        bad["statements"][0]["sets"] = sets;
        bad
    };
    let no_rows = "not as many different rows of the scope as \"least\", or there twice";
    for (sets, expected) in [
        (json!([[1], [2], [3]]), "sets: no statement shows that anything is left without 1".to_owned()),
        (json!([[3], [99]]), format!("sets: 99: {no_rows}")),
        (json!([[3, 3, 3]]), format!("sets: 3, 3, 3: {no_rows}")),
        (json!([[3], [3]]), format!("sets: 3: {no_rows}")),
        (json!([[3, 4]]), format!("sets: 3, 4: {no_rows}")),
        (json!([]), "contradictions: none is shown without 3".to_owned()),
    ] {
        refuted(directory.path(), &with_sets(sets), &expected);
    }
    // The statement about what is left is another one.
    let mut bad = proof.clone();
    bad["statements"][1]["without"] = json!([3, 4]);
    refuted(directory.path(), &bad, "sets: no statement shows that anything is left without 3");
    let mut bad = proof.clone();
    bad["statements"] = json!([{"kind": "left out", "least": 0, "contradictions": []}]);
    refuted(directory.path(), &bad, "least: 0 says nothing without sets");
    let mut nothing = proof.clone();
    nothing["statements"] = json!([]);
    std::fs::write(directory.path().join("bad.json"), nothing.to_string()).unwrap();
    let run = boundfit(directory.path(), "verify bad.json a.csv");
    assert!(run.status == 1 && run.stderr.contains("not a proof: it states nothing"), "{run:?}");
    assert_eq!(second_verdict(directory.path(), "bad.json"), Some(1));
}
