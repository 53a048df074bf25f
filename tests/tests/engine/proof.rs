//! Proofs are accepted when they are true, and refused after any change that makes them false.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use boundfit_estimation::fit;
use boundfit_exact::{DecimalMark, Limits};
use boundfit_formats::{AskedDialect, Header, RowRange, TableOptions};
use boundfit_tests::generate::{one_in, seeded, share};
use boundfit_tests::program::root;
use boundfit_tests::proofs::{Question, generated, is_true, questions, sha256, tampered, verdict};
use boundfit_tests::readings::parse_condition;
use boundfit_verify::{DataLimits, Proof};
use rand::RngExt;
use serde_json::Value;

use boundfit_tests::cli::{
    FIT_TRANSDUCER, TRANSDUCER, boundfit, boundfit_with_input, directory_with, files_in,
};

fn value(proof: &str) -> Value {
    serde_json::from_str(proof).unwrap()
}

fn kind(question: &Question) -> &'static str {
    fit(&question.problem().unwrap()).fps.polyhedron().region().kind().name()
}

/// An equation is two half-planes.
fn half_planes_of(condition: &str) -> usize {
    if parse_condition(condition).is_equation() { 2 } else { 1 }
}

fn accepts(question: &Question) -> Value {
    let text = question.proof();
    let proof = Proof::read(text.as_bytes(), &question.options.limits).unwrap();
    let checked = proof.verify(|| Ok(question.data.as_slice()), &DataLimits::default());
    let value = value(&text);
    let rows = [0, 1].map(|end| value["rows"][end].as_u64().unwrap() as usize);
    let half_planes = 2 * (rows[1] - rows[0] + 1)
        + question.conditions.iter().map(|text| half_planes_of(text)).sum::<usize>();
    assert_eq!(checked.unwrap().half_planes, half_planes, "{}: {text}", question.name);
    value
}

#[test]
fn every_fixture_and_every_kind_is_proved() {
    let questions = questions();
    let proofs: Vec<Value> = questions.iter().map(accepts).collect();
    let kinds: BTreeSet<_> = questions.iter().map(kind).collect();
    assert_eq!(kinds.len(), 10, "{kinds:?}");
    for (question, proof) in questions.iter().zip(&proofs) {
        assert!(is_true(proof, &question.data), "{}", question.name);
    }
}

#[test]
fn generated_fits_are_proved() {
    let mut rng = seeded(60);
    let mut kinds: BTreeMap<_, usize> = BTreeMap::new();
    for _ in 0..share(5000) {
        let question = generated(&mut rng);
        accepts(&question);
        *kinds.entry(kind(&question)).or_default() += 1;
    }
    assert!(kinds.len() == 10 && kinds.values().all(|&count| count >= share(5)), "{kinds:?}");
}

/// Changes of these kinds leave a proof true:
/// - another text of the same number (`3/1`);
/// - a name twice or in another place in a set `active`;
/// - another point or ray where nothing bounds, another order of multipliers;
/// - a condition more or less, or another row, column or reading that decides nothing;
/// - other multiples of a contradiction.
///
/// Each is shown to be true by asking again.
#[test]
fn every_change_that_makes_a_proof_false_is_refused() {
    let (mut refused, mut in_other_words, mut still_true) = (0, 0, BTreeMap::<String, usize>::new());
    for question in questions().iter().step_by(one_in()) {
        let proof = value(&question.proof());
        if proof.to_string().len() > 6000 {
            continue;
        }
        for (what, changed) in tampered(&proof) {
            if verdict(changed.to_string().as_bytes(), &question.data) != 0 {
                refused += 1;
                continue;
            }
            let is_proved = is_true(&changed, &question.data);
            assert!(is_proved, "{}: {what}", question.name);
            if what.ends_with("/1\"") {
                in_other_words += 1;
                continue;
            }
            let place = what.split(['/', ':']).nth(1).unwrap().to_owned();
            *still_true.entry(place).or_default() += 1;
        }
    }
    println!(
        "{refused} changes refused, {in_other_words} in other words, still true by field: {still_true:?}"
    );
    assert!(refused >= share(5000) && still_true.values().sum::<usize>() * 25 < refused);
}

/// Half-planes that touch the set, or cut it, are kept while they are few. Otherwise the data are read again, with the same verdicts.
#[test]
fn data_are_read_again_only_where_many_half_planes_touch() {
    let verified = |proof: &Value, data: &[u8]| {
        let proof = Proof::read(proof.to_string().as_bytes(), &Limits::default()).unwrap();
        let mut reads = 0;
        let open = || {
            reads += 1;
            Ok(data)
        };
        let verified = proof.verify(open, &DataLimits::default());
        (verified.is_ok(), reads)
    };
    for (count, reads) in [(10, 1), (2_000, 1), (2_100, 2), (4_000, 2)] {
        let [data, cut] = ["2,1\n", "2,9\n"].map(|last| {
            let rows = "1,1\n2,1\n".repeat(count);
            format!("x,y\n{rows}1,1\n{last}").into_bytes()
        });
        let mut proof = value(&Question::line("ties", &data, ["x", "y"], "1").proof());
        assert_eq!(verified(&proof, &data), (true, reads), "{count}");
        let untold = proof["active"].as_array_mut().unwrap().pop().unwrap();
        assert_eq!(verified(&proof, &data), (false, reads), "{count}: without {untold}");
        proof["active"].as_array_mut().unwrap().push(untold);
        proof["sha256"] = sha256(&cut).into();
        assert_eq!(verified(&proof, &cut), (false, reads), "{count}: cut off");
    }
}

/// Returns whether all lines have the same number of commas.
fn is_even(data: &[u8]) -> bool {
    let lines = data.split(|&byte| byte == b'\n').filter(|line| !line.trim_ascii().is_empty());
    let commas = lines.map(|line| line.iter().filter(|&&byte| byte == b',').count());
    commas.collect::<BTreeSet<_>>().len() == 1
}

#[test]
fn changed_data_are_refused() {
    for question in questions().iter().take(12) {
        let text = question.proof();
        let mut proof = value(&text);
        for position in (0..question.data.len()).step_by(1 + question.data.len() / 60) {
            let mut data = question.data.clone();
            data[position] ^= 1;
            assert_eq!(verdict(text.as_bytes(), &data), 4, "{}: byte {position}", question.name);
            // With the hash of the changed data, the other statements are judged.
            proof["sha256"] = sha256(&data).into();
            if verdict(proof.to_string().as_bytes(), &data) == 0 {
                // The program wants as many cells in every row, which proves nothing.
                let is_judged = is_true(&proof, &data) || !is_even(&data);
                assert!(is_judged, "{}: byte {position}", question.name);
            }
        }
    }
}

/// The checker's own reader of tables against that of the program, on tables of cells that are hard to tell apart.
#[test]
fn both_readers_see_the_same_table() {
    let pieces =
        ["1", "2", "-3", "\"4\"", "\"5", "6\"", "\"\"", " ", ",", ",", ",", "\n", "\r\n", "\r", "\t"];
    let mut rng = seeded(61);
    let (mut accepted, mut short) = (0, 0);
    for _ in 0..share(70_000) {
        let count = rng.random_range(3..=14);
        let text: String = (0..count).map(|_| pieces[rng.random_range(0..pieces.len())]).collect();
        let response = if rng.random_bool(0.5) { "2" } else { "3" };
        let mut question = Question::line("pieces", text.as_bytes(), ["1", response], "100");
        let dialect = AskedDialect { delimiter: Some(b','), ..AskedDialect::default() };
        question.options = TableOptions { header: Header::Absent, dialect, ..TableOptions::default() };
        if let Ok(problem) = question.problem() {
            if question.proof_of(&problem).is_none() {
                // Rows without their last cells and commas before decimals are read, and are not plain.
                let notes = problem.measurements.table().unwrap();
                let has_commas = notes.dialect.notation.decimal == DecimalMark::Comma;
                assert!(notes.skipped.short_rows > 0 || has_commas, "{text:?}");
                short += usize::from(!has_commas);
                continue;
            }
            accepts(&question);
            accepted += 1;
            question.options.rows = RowRange::new(1, problem.measurements.rows_total()).into();
            accepts(&question);
        }
    }
    assert!(accepted > share(500) && short > 0, "{accepted}, {short}");
}

#[test]
fn the_program_writes_a_proof_beside_any_report_and_verifies_it() {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("proof.json").to_str().unwrap().to_owned();
    for format in ["text", "json"] {
        let run = boundfit(&root(), &format!("{FIT_TRANSDUCER} --format {format} --proof {path}"));
        assert_eq!((run.status, run.stderr.as_str()), (0, ""));
        assert_eq!(run.stdout, boundfit(&root(), &format!("{FIT_TRANSDUCER} --format {format}")).stdout);
        assert_eq!(files_in(directory.path()), ["proof.json"]);
        let run = boundfit(&root(), &format!("verify {path} {TRANSDUCER} --format json"));
        assert_eq!((run.status, value(&run.stdout)["verified"].clone()), (0, true.into()));
    }
    let data = fs::read(root().join(TRANSDUCER)).unwrap();
    let from_stdin = boundfit_with_input(&root(), &format!("verify {path} -"), &data);
    assert_eq!(from_stdin.status, 0);
    let report = directory.path().join("report").to_str().unwrap().to_owned();
    let run = boundfit(&root(), &format!("{FIT_TRANSDUCER} -o {report} --proof -"));
    assert_eq!((run.status, run.stdout), (0, fs::read_to_string(&path).unwrap()));
    let run = boundfit(&root(), &format!("verify {path} fixtures/norris/norris.csv"));
    assert_eq!(run.status, 4);
    assert!(run.stdout.contains("sha256: is not that of the data"), "{}", run.stdout);
}

/// More readings than are kept in memory, with ties along whole edges.
#[test]
fn a_large_file_is_proved() {
    let text =
        (0..30_000).fold("x,y\n".to_owned(), |text, row| text + &format!("{},{}\n", row % 100, row % 7));
    let directory = directory_with(&[("data.csv", text.as_bytes())]);
    for (epsilon, status) in [("4", 0), ("3", 0), ("1", 3)] {
        let line = format!("fit data.csv --x x --y y --eps {epsilon} --no-lp --proof proof.json");
        assert_eq!(boundfit(directory.path(), &line).status, status, "{epsilon}");
        let run = boundfit(directory.path(), "verify proof.json data.csv");
        assert_eq!(run.status, 0, "{epsilon}: {}", run.stdout);
    }
}

#[test]
fn what_cannot_be_proved_or_verified_is_refused() {
    let reduction = boundfit(&root(), &format!("reduce {TRANSDUCER} --x Vz --y z")).stdout;
    let deep = format!("{}{}", "[".repeat(100), "]".repeat(100));
    let long = format!("{{\"schema\": \"{}\"}}", "1".repeat(100_001));
    let directory = directory_with(&[
        ("data.csv", b"x,y,who\n1,2,a\n2,3,b\n"),
        ("reduction.csv", reduction.as_bytes()),
        ("deep.json", deep.as_bytes()),
        ("long.json", long.as_bytes()),
        ("other.json", b"{\"schema\": \"boundfit/fit/1\"}"),
    ]);
    let fit = "fit data.csv --x x --y y --eps 1";
    for (line, status, message) in [
        (format!("{fit} --proof -"), 2, "would both go to standard output"),
        (format!("{fit} --proof - -o -"), 2, "would both go to standard output"),
        (format!("{fit} --proof same -o same"), 2, "name the same file"),
        (format!("{fit} --by who --proof p.json"), 2, "is about one set"),
        ("fit reduction.csv --x Vz --y z --eps 1 --proof p.json".to_owned(), 2, "is a reduction"),
        (format!("{fit} --proof nowhere/p.json"), 1, "cannot write"),
        ("verify - -".to_owned(), 2, "cannot both be standard input"),
        ("verify data.csv data.csv".to_owned(), 1, "not a proof"),
        ("verify other.json data.csv".to_owned(), 1, "boundfit/proof/1"),
        ("verify deep.json data.csv".to_owned(), 1, "64 levels (the limit; --limit nesting=N raises it)"),
        ("verify long.json data.csv".to_owned(), 1, "--limit digits=N raises it"),
        ("verify nowhere.json data.csv".to_owned(), 1, "cannot read"),
    ] {
        let run = boundfit(directory.path(), &line);
        assert_eq!((run.status, run.stdout.as_str()), (status, ""), "{line}");
        assert!(run.stderr.contains(message), "{line}: {}", run.stderr);
    }
    assert!(!files_in(directory.path()).contains(&"p.json".to_owned()));
}

/// Numbers of the data that are beyond a limit say nothing of the proof: no verdict, but the option that raises it.
#[test]
fn numbers_beyond_the_limits_are_refused_without_a_verdict() {
    let digits = format!("x,y\n1,2\n3,{}\n", "7".repeat(10_001));
    let directory =
        directory_with(&[("exponent.csv", b"x,y\n1,2\n3,4e-10001\n"), ("digits.csv", digits.as_bytes())]);
    for (data, name) in [("exponent.csv", "exponent"), ("digits.csv", "digits")] {
        let raised = format!("--limit {name}=11000");
        let fit = format!("fit {data} --x x --y y --eps 1 --no-lp {raised} --proof proof.json");
        assert_eq!(boundfit(directory.path(), &fit).status, 0);
        let run = boundfit(directory.path(), &format!("verify proof.json {data}"));
        assert_eq!((run.status, run.stdout.as_str()), (1, ""), "{data}");
        assert!(run.stderr.contains(&format!("--limit {name}=N raises it")), "{data}: {}", run.stderr);
        let run = boundfit(directory.path(), &format!("verify proof.json {data} {raised}"));
        assert_eq!(run.status, 0, "{data}: {}", run.stderr);
    }
}
