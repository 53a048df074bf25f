//! `tests/verify.py`, the checker in Python, against the one in Rust: the same verdict on true and on changed proofs.

use std::fs;
use std::process::Command;

use boundfit_tests::generate::seeded;
use boundfit_tests::program::root;
use boundfit_tests::proofs::{Question, generated, questions, sha256, tampered, verdict};
use serde_json::Value;

/// How many proofs one Python process is given.
const AT_A_TIME: usize = 250;

/// Which of the changes are tried: every so manyth. With 1 it takes minutes.
const EVERY: usize = 4;

/// What the checker in Python says about each proof: 0 true, 4 false, 1 no proof.
fn verdicts_in_python(cases: &[(String, &[u8])]) -> Vec<i32> {
    let directory = tempfile::tempdir().unwrap();
    let mut verdicts = Vec::new();
    for (batch, cases) in cases.chunks(AT_A_TIME).enumerate() {
        let mut command = Command::new("python3");
        command.arg(root().join("tests/verify.py"));
        for (index, (proof, data)) in cases.iter().enumerate() {
            let [proof_file, data_file] =
                ["json", "csv"].map(|kind| directory.path().join(format!("{batch}-{index}.{kind}")));
            fs::write(&proof_file, proof).unwrap();
            fs::write(&data_file, data).unwrap();
            command.args([proof_file, data_file]);
        }
        let output = command.output().expect("python3 is needed: install Python 3.11 or newer");
        let text = String::from_utf8(output.stdout).unwrap();
        let verdict = |line: &str| match line.split(':').next() {
            Some("verified") => 0,
            Some("refuted") => 4,
            Some("not a proof") => 1,
            _ => panic!("{line}"),
        };
        let own: Vec<i32> = text.lines().map(verdict).collect();
        let error = String::from_utf8_lossy(&output.stderr);
        assert_eq!(own.len(), cases.len(), "{error}");
        assert_eq!(output.status.code(), own.iter().max().copied(), "{error}");
        verdicts.extend(own);
    }
    verdicts
}

fn agree(cases: &[(String, &[u8])], names: &[String]) -> Vec<i32> {
    let verdicts = verdicts_in_python(cases);
    for (((proof, data), name), &python) in cases.iter().zip(names).zip(&verdicts) {
        // What is no proof in the one may be a false one in the other.
        assert_eq!(python == 0, verdict(proof, data) == 0, "{name}: {proof}");
    }
    verdicts
}

#[test]
fn every_proof_is_verified_in_python_too() {
    let mut rng = seeded(62);
    let mut all: Vec<Question> = questions();
    all.extend((0..500).map(|_| generated(&mut rng)));
    let cases: Vec<(String, &[u8])> = all.iter().map(|own| (own.proof(), own.data.as_slice())).collect();
    let names: Vec<String> = all.iter().map(|own| own.name.clone()).collect();
    assert!(agree(&cases, &names).iter().all(|&verdict| verdict == 0));
}

#[test]
fn changed_proofs_and_data_get_the_same_verdict() {
    let all: Vec<Question> = questions();
    let (mut cases, mut names) = (Vec::new(), Vec::new());
    let mut changed_data: Vec<(String, Vec<u8>)> = Vec::new();
    for own in &all {
        let mut proof: Value = serde_json::from_str(&own.proof()).unwrap();
        if proof.to_string().len() > 6000 {
            continue;
        }
        // The test of the checker in Rust takes them all.
        for (what, changed) in tampered(&proof).into_iter().step_by(EVERY) {
            cases.push((changed.to_string(), own.data.as_slice()));
            names.push(format!("{}: {what}", own.name));
        }
        for position in (0..own.data.len()).step_by(1 + own.data.len() / 5) {
            let mut data = own.data.clone();
            data[position] ^= 1;
            proof["sha256"] = sha256(&data).into();
            changed_data.push((proof.to_string(), data));
        }
    }
    assert!(cases.len() > 1000);
    for (proof, data) in &changed_data {
        cases.push((proof.clone(), data.as_slice()));
        names.push("changed data".to_owned());
    }
    let verdicts = agree(&cases, &names);
    assert!(verdicts.contains(&0) && verdicts.contains(&1) && verdicts.contains(&4));
}
