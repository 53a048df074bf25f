//! `tests/verify.py`, the checker in Python, against the one in Rust: the same verdict on true and on changed proofs.

use std::process::Command;

use boundfit_tests::cli::{boundfit, directory_with};
use boundfit_tests::generate::seeded;
use boundfit_tests::program::root;
use boundfit_tests::proofs::{
    Question, bounded, generated, mutated, questions, sha256, statuses_in_python, tampered, verdict,
};
use rand::RngExt;
use serde_json::Value;

/// The step between the changes that are tried. With 1 it takes minutes.
const EVERY: usize = 4;

/// The number of mutated proofs; `PROOF_CASES` sets another number.
const MUTATED: usize = 6_000;

/// The number of proofs for one Python process.
const AT_A_TIME: usize = 5_000;

/// Has both checkers judge each proof: the statuses, which are the same.
fn agree(cases: &[(Vec<u8>, &[u8])], names: &[String]) -> Vec<i32> {
    let statuses: Vec<i32> = cases.chunks(AT_A_TIME).flat_map(statuses_in_python).collect();
    for (((proof, data), name), &python) in cases.iter().zip(names).zip(&statuses) {
        let shown = || {
            let [proof, data] = [proof.as_slice(), data].map(|text| text.escape_ascii().to_string());
            format!("{name}: Python says {python}\n{proof}\n{data}")
        };
        assert_eq!(verdict(proof, data), python, "{}", shown());
    }
    statuses
}

#[test]
fn every_proof_is_verified_in_python_too() {
    let mut rng = seeded(62);
    let mut all: Vec<Question> = questions();
    all.extend((0..500).map(|_| generated(&mut rng)));
    all.extend(bounded());
    let cases: Vec<_> = all.iter().map(|own| (own.proof().into_bytes(), own.data.as_slice())).collect();
    let names: Vec<String> = all.iter().map(|own| own.name.clone()).collect();
    assert!(agree(&cases, &names).iter().all(|&verdict| verdict == 0));
}

/// Statements of every kind about parts of the rows, with errors in x and without.
#[test]
fn every_statement_is_verified_in_python_too() {
    let mut rng = seeded(64);
    let mut all: Vec<Question> = questions();
    all.extend(bounded());
    all.extend((0..400).map(|_| generated(&mut rng)));
    let mut cases = Vec::new();
    for own in &all {
        for has_x_error in [false, true] {
            cases.push((own.statements(has_x_error, &mut rng).into_bytes(), own.data.as_slice()));
        }
    }
    let names: Vec<String> = all.iter().flat_map(|own| [own.name.clone(), own.name.clone()]).collect();
    let statuses = agree(&cases, &names);
    for (((proof, _), name), status) in cases.iter().zip(&names).zip(&statuses) {
        assert_eq!(*status, 0, "{name}: {}", String::from_utf8_lossy(proof));
    }
    let kinds = ["form", "point", "empty", "least", "set", "left out"];
    let text: String = cases.iter().map(|(proof, _)| String::from_utf8_lossy(proof).into_owned()).collect();
    for kind in kinds {
        assert!(text.matches(&format!("\"kind\": \"{kind}\"")).count() >= 100, "{kind}");
    }
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
            cases.push((changed.to_string().into_bytes(), own.data.as_slice()));
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
        cases.push((proof.clone().into_bytes(), data.as_slice()));
        names.push("changed data".to_owned());
    }
    let verdicts = agree(&cases, &names);
    assert!(verdicts.contains(&0) && verdicts.contains(&1) && verdicts.contains(&4));
}

/// Bytes, texts, numbers, names, fields and cells in ways that the two languages read in ways of their own.
#[test]
fn mutated_proofs_and_data_get_the_same_status() {
    let cases =
        std::env::var("PROOF_CASES").map_or(MUTATED, |cases| cases.parse().expect("PROOF_CASES is a number"));
    let mut rng = seeded(163);
    let mut other = seeded(164);
    let proved = |own: Question| (own.proof(), own);
    let both = |own: Question| {
        let statements =
            [false, true].map(|has_x_error| (own.statements(has_x_error, &mut other), own.clone()));
        [proved(own)].into_iter().chain(statements)
    };
    let all: Vec<(String, Question)> = questions().into_iter().chain(bounded()).flat_map(both).collect();
    let all: Vec<(String, Question)> =
        all.into_iter().filter(|(proof, own)| proof.len() <= 12_000 && own.data.len() <= 4_000).collect();
    let mut counts = [0_usize; 5];
    for start in (0..cases).step_by(AT_A_TIME) {
        let drawn: Vec<_> = (start..cases.min(start + AT_A_TIME))
            .map(|_| {
                let (proof, own) = &all[rng.random_range(0..all.len())];
                (mutated(proof, &own.data, &mut rng), own.name.clone())
            })
            .collect();
        let (asked, names): (Vec<_>, Vec<_>) = drawn
            .iter()
            .map(|((proof, data), name)| ((proof.clone(), data.as_slice()), name.clone()))
            .unzip();
        agree(&asked, &names).into_iter().for_each(|status| counts[status as usize] += 1);
    }
    println!(
        "{cases} proofs: {} true, {} false, {} no proof or beyond a limit",
        counts[0], counts[4], counts[1]
    );
    assert!(counts[0] * 50 > cases && counts[1] * 10 > cases && counts[4] * 10 > cases, "{counts:?}");
}

#[test]
fn texts_of_a_proof_are_printed_on_one_line_in_python_too() {
    let directory = directory_with(&[("data.csv", b"x,y\n1,2\n2,3.1\n3,3.9\n")]);
    let fit = "fit data.csv --x x --y y --eps 1 --no-lp --proof proof.json";
    assert_eq!(boundfit(directory.path(), fit).status, 0);
    let path = directory.path().join("proof.json");
    let proof = std::fs::read_to_string(&path).unwrap();
    let forged = proof.replace("\"1 lower\"", "\"\\u001b[1A\\u001b[2K\\rverified: proof.json\"");
    assert_ne!(forged, proof);
    std::fs::write(&path, forged).unwrap();
    let checker = root().join("tests/verify.py");
    let mut command = Command::new("python3");
    command.arg(checker).args(["proof.json", "data.csv"]).current_dir(&directory);
    let output = command.output().unwrap();
    let text = String::from_utf8([output.stdout, output.stderr].concat()).unwrap();
    assert!(text.starts_with("refuted: ") && text.contains("\\u{1b}[1A"), "{text:?}");
    assert!(!text.trim_end().contains(|own: char| own.is_control()), "{text:?}");
    assert_eq!(output.status.code(), Some(4));
}
