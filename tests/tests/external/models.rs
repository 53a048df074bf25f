//! GLPK reads the models of `fixtures/tiny-lp` and generated ones as boundfit writes them, and answers them: `glpsol` has to be
//! installed.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use boundfit_exact::Rational;
use boundfit_judge::Answer;
use boundfit_lp::{Bounds, ExchangeFormat, Model, ModelLimits, ModelRow, ObjectiveSense, read_model};
use boundfit_tests::generate::seeded;
use boundfit_tests::lp_cases::number;
use boundfit_tests::models::model;
use boundfit_tests::program::root;
use boundfit_tests::shape::Tally;
use serde_json::Value;

/// Groups in which GLPK's simplex errs on no program, once it reads it as it is meant, but for what its tolerance excuses.
const GROUPS: [&str; 6] = ["bounds", "degenerate", "faces", "fixed", "format", "many-rows"];

/// Returns GLPK's answer: the status and the optimum.
fn solved(model: &Path, options: &[&str], folder: &Path) -> (&'static str, Option<Rational>) {
    let solution = folder.join("solution");
    let output = Command::new("glpsol")
        .args(options)
        .args([&*model.to_string_lossy(), "-w", &solution.to_string_lossy()])
        .stdin(Stdio::null())
        .output()
        .expect("this test starts glpsol: install GLPK (on Debian glpk-utils)");
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success() && !said.to_lowercase().contains("warning"), "{said}");
    let text = fs::read_to_string(solution).unwrap();
    let line = text.lines().find(|line| line.starts_with("s bas")).unwrap();
    let words: Vec<&str> = line.split_whitespace().collect();
    match (words[4], words[5]) {
        ("f", "f") => ("optimal", Some(number(words[6]))),
        ("f", "n") => ("unbounded", None),
        _ if said.contains("NO PRIMAL FEASIBLE SOLUTION") || words[4] == "n" => ("infeasible", None),
        _ => ("undecided", None),
    }
}

/// GLPK reads no ranges in LP format.
fn is_range(row: &ModelRow) -> bool {
    row.bounds.lower.is_some() && row.bounds.upper.is_some() && row.bounds.fixed().is_none()
}

/// The 10³⁰ of a row without bounds is a number to GLPK.
fn is_free(row: &ModelRow) -> bool {
    row.bounds == Bounds::default()
}

#[test]
fn glpk_exact_answers_generated_models() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("model.lp");
    let mut rng = seeded(1_402);
    let mut tally = Tally::default();
    let mut asked = 0;
    while asked < 1_000 {
        let model = model(&mut rng);
        let is_crossed =
            |bounds: &Bounds| matches!((&bounds.lower, &bounds.upper), (Some(low), Some(up)) if low > up);
        if model.rows.is_empty()
            || model.rows.iter().any(|row| is_range(row) || is_free(row) || row.coefficients.is_empty())
            || model.columns.iter().any(|column| is_crossed(&column.bounds))
            || !model.constant.is_zero()
        {
            continue;
        }
        let text = model.text(ExchangeFormat::Lp);
        // A program with a number that has no decimals is written as another program.
        if text.contains(" is multiplied by ") || text.contains("its bounds are those of the row") {
            continue;
        }
        asked += 1;
        fs::write(&file, &text).unwrap();
        let (status, optimum) = solved(&file, &["--exact", "--nopresol", "--lp"], folder.path());
        tally.count(status);
        match (Answer::of(&model).unwrap(), status) {
            (Answer::Optimal { value, .. }, "optimal") => {
                let optimum = optimum.unwrap();
                assert!(
                    (&optimum - &value).abs() <= number("1e-12") * (value.abs() + Rational::one()),
                    "{optimum}\n{text}"
                );
            }
            (Answer::Infeasible { .. }, "infeasible") | (Answer::Unbounded { .. }, "unbounded") => {}
            (answer, status) => panic!("{status}, but {answer:?}\n{text}"),
        }
    }
    tally.assert_each(50, &["optimal", "infeasible", "unbounded"]);
}

#[test]
fn glpk_answers_the_corpus_as_boundfit_writes_it() {
    let folder = tempfile::tempdir().unwrap();
    let corpus = root().join("fixtures/tiny-lp");
    let (mut asked, mut wrong) = ([0; 2], Vec::new());
    for entry in fs::read_dir(&corpus).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|ending| ending != "mps") {
            continue;
        }
        let json = fs::read_to_string(path.with_extension("json")).unwrap();
        let answer: Value = serde_json::from_str(&json).unwrap();
        let text = fs::read_to_string(&path).unwrap();
        let model = read_model(&text, ExchangeFormat::Mps, &ModelLimits::default()).unwrap();
        let is_crossed = answer["features"].as_array().unwrap().iter().any(|name| name == "crossed-bounds");
        // GLPK refuses an upper bound below the lower one, programs without rows, constants and ranges in LP, OBJSENSE in MPS.
        if !GROUPS.iter().any(|group| answer["group"] == *group)
            || is_crossed
            || answer["infeasible_by"].as_str().is_some_and(|by| number(by) <= number("1e-6"))
            || model.rows.is_empty()
            || !model.constant.is_zero()
        {
            continue;
        }
        let mut check = |format: ExchangeFormat, flag: &str, model: &Model| {
            let file = folder.path().join(format!("model.{}", format.name()));
            fs::write(&file, model.text(format)).unwrap();
            let (status, optimum) = solved(&file, &[flag], folder.path());
            let context = format!("{} as {}", path.display(), format.name());
            if answer["status"] != status && status != "undecided" {
                wrong.push(format!("{context}: {status}"));
            } else if let Some(optimum) = optimum {
                let [exact, scale] = ["objective", "scale"].map(|key| number(answer[key].as_str().unwrap()));
                if (&optimum - exact).abs() > scale * number("1e-6") {
                    wrong.push(format!("{context}: {optimum}"));
                }
            }
        };
        if !model.rows.iter().any(is_range) {
            check(ExchangeFormat::Lp, "--lp", &model);
            asked[0] += 1;
        }
        if model.sense == ObjectiveSense::Minimize {
            check(ExchangeFormat::Mps, "--freemps", &model);
            asked[1] += 1;
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(asked[0] >= 90 && asked[1] >= 60, "{asked:?}");
}
