//! Theorems about fixtures, every kind of set and generated problems.

use std::collections::BTreeMap;

use boundfit_estimation::{Fit, Problem, fit};
use boundfit_exact::Reading;
use boundfit_geometry::Polyhedron;
use boundfit_judge::{Answer, SolveError};
use boundfit_report::{Theory, kernel_fit, kernel_half_planes, kernel_program};
use boundfit_tests::generate::{one_in, rational_system, seeded, share, system, tangents};
use boundfit_tests::models::{model, truth};
use boundfit_tests::proofs::{Question, bounded, generated, questions};

use crate::coq::{compiled, modules, run, theory};

/// Theorems in a run of `coqc`.
const BATCH: usize = 60;

/// Generated theorems of a kind where all cases are tried.
const ALL: usize = 300;

/// Returns how many of them are generated: where not all are, still enough to meet nearly every kind of set.
fn generated_count() -> usize {
    share(ALL).max(100)
}

pub fn all_are_accepted(name: &str, theorems: &[String]) {
    for (batch, texts) in theorems.chunks(BATCH).enumerate() {
        let output = compiled(&format!("{name}{batch}"), &modules(texts));
        assert!(output.is_ok(), "{name}, batch {batch}: {output:?}");
    }
}

/// The theorem about a question, with the bytes of its data where they are plain.
fn theorem(question: &Question, problem: &Problem, kinds: &mut BTreeMap<&'static str, usize>) -> String {
    let fit = fit(problem);
    *kinds.entry(fit.fps.polyhedron().region().kind().name()).or_default() += 1;
    let (reading, data) = (question.options.reading, &question.data[..]);
    kernel_fit(problem, &fit, reading, Some(data), Theory::Installed).unwrap()
}

/// The number of theorems that the rows are read from bytes.
fn about_bytes(theorems: &[String]) -> usize {
    theorems.iter().filter(|own| own.contains("Theorem the_rows_are_the_bytes")).count()
}

#[test]
fn fixtures_laws_intervals_conditions_and_every_kind_are_theorems() {
    let mut kinds = BTreeMap::new();
    let questions = questions().into_iter().chain(bounded());
    let theorems: Vec<String> =
        questions.map(|question| theorem(&question, &question.problem().unwrap(), &mut kinds)).collect();
    assert_eq!(kinds.len(), 10, "{kinds:?}");
    assert!(about_bytes(&theorems) > 20, "{}", about_bytes(&theorems));
    all_are_accepted("fixtures", &theorems);
}

#[test]
fn generated_fits_are_theorems() {
    let mut rng = seeded(3101);
    let mut kinds = BTreeMap::new();
    let mut theorems = Vec::new();
    while theorems.len() < generated_count() {
        let question = generated(&mut rng);
        if let Ok(problem) = question.problem() {
            theorems.push(theorem(&question, &problem, &mut kinds));
        }
    }
    assert!(kinds.len() >= if one_in() == 1 { 8 } else { 7 }, "{kinds:?}");
    assert!(about_bytes(&theorems) > generated_count() / 3, "{}", about_bytes(&theorems));
    all_are_accepted("fits", &theorems);
}

#[test]
fn generated_half_planes_are_theorems() {
    let mut rng = seeded(3102);
    let mut kinds = BTreeMap::<_, usize>::new();
    let mut theorems = Vec::new();
    while theorems.len() < generated_count() {
        let system = match theorems.len() % 8 {
            0 => system(&tangents(&mut rng, 12)),
            _ => rational_system(&mut rng),
        };
        let polyhedron = Polyhedron::intersect(system.clone());
        *kinds.entry(polyhedron.region().kind().name()).or_default() += 1;
        theorems.push(kernel_half_planes(&system, &polyhedron, None, None, Theory::Installed).unwrap());
    }
    assert!(kinds.len() == 10 || one_in() > 1 && kinds.len() >= 8, "{kinds:?}");
    all_are_accepted("half_planes", &theorems);
}

#[test]
fn generated_linear_programs_are_theorems() -> Result<(), SolveError> {
    let mut rng = seeded(3104);
    let mut statuses = BTreeMap::<_, usize>::new();
    let mut theorems = Vec::new();
    while theorems.len() < generated_count() {
        let model = model(&mut rng);
        let theorem = kernel_program(&model, &Answer::of(&model)?, None, Theory::Installed);
        assert_eq!(theorem.is_some(), model.columns.len() == 2, "{model:?}");
        let Some(theorem) = theorem else { continue };
        let truth = truth(&model);
        // The optimal points: none, one, an edge, a ray, a line, or a set with an area.
        let shape = (truth.status, truth.vertices.len().min(3), truth.rays.len(), truth.lines.len());
        *statuses.entry(shape).or_default() += 1;
        theorems.push(theorem);
    }
    assert!(statuses.len() >= 8, "{statuses:?}");
    all_are_accepted("programs", &theorems);
    Ok(())
}

/// A fit whose set is not empty.
fn answered() -> (Problem, Fit) {
    let problems = questions().into_iter().map(|question| question.problem().unwrap());
    let mut fits = problems.map(|problem| {
        let fit = fit(&problem);
        (problem, fit)
    });
    fits.find(|(_, fit)| !fit.is_empty()).unwrap()
}

#[test]
fn a_file_on_its_own_assumes_nothing_over_the_rational_numbers() {
    let (problem, fit) = answered();
    let text = kernel_fit(&problem, &fit, Reading::Decimal, None, Theory::Included).unwrap()
        + "Print Assumptions the_real_set.\n";
    let directory = tempfile::tempdir().unwrap();
    std::fs::write(directory.path().join("answer.v"), &text).unwrap();
    let output = run(directory.path(), "coqc", &["-q", "answer.v"]).unwrap();
    println!("{output}");
    let (rational, real) = output.split_once("Axioms:\n").unwrap();
    assert_eq!(rational, "Closed under the global context\n");
    let axioms: Vec<&str> = real.lines().filter(|line| !line.starts_with(' ')).collect();
    // The axioms of Coq's own real numbers.
    assert_eq!(
        axioms,
        ["ClassicalDedekindReals.sig_forall_dec", "FunctionalExtensionality.functional_extensionality_dep"]
    );
}

#[test]
fn the_second_kernel_of_coq_accepts_the_theory() {
    let (problem, fit) = answered();
    let text = kernel_fit(&problem, &fit, Reading::Decimal, None, Theory::Installed).unwrap();
    compiled("Checked", &text).unwrap();
    let own =
        ["Reader", "Bytes", "Checker", "Convex", "Sound", "Rationals", "RealNumbers", "Parts", "Checked"];
    let names: Vec<String> = own.iter().map(|name| format!("Boundfit.{name}")).collect();
    let mut arguments = vec!["-silent", "-R", ".", "Boundfit"];
    for name in &names {
        arguments.extend(["-norec", name.as_str()]);
    }
    run(theory(), "coqchk", &arguments).unwrap();
}
