//! Proofs of linear ranges and outliers, which `verify` and the checker in Python accept.

use std::process::Command;

use boundfit_tests::cli::{TRANSDUCER, boundfit};
use boundfit_tests::program::root;

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
