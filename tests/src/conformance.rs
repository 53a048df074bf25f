//! The table of `bench-solvers`: what every LP solver of this build is worth on each case of a folder.

use std::fs;
use std::path::Path;
use std::time::Duration;

use boundfit_check::{CheckOptions, check, source_names};
use boundfit_estimation::Problem;
use boundfit_exact::{Rational, Reading};
use boundfit_judge::{Findings, Plane, Tolerances, Worth};
use boundfit_lp::{ExchangeFormat, Model, ModelLimits, model_text, read_model};

use crate::judged_solvers::{JudgedSolver, judge_solvers};
use crate::lp_cases::hard_case;

/// The time that a solver may work on one program.
const TIME_LIMIT: Duration = Duration::from_secs(60);

/// Returns how far an answer may be off, in widths of an interval or parts of a size.
fn tolerance() -> Rational {
    Rational::ratio(1, 1_000_000)
}

/// A solver with its worst verdict on a case: for the numbers as they are, and for the doubles that it received.
struct Verdicts {
    source: String,
    as_read: String,
    received: String,
    is_refuted: bool,
}

/// Asks every solver about every case of a folder and lists the worst verdict of each, as a Markdown table. A case is a fit,
/// `NAME.csv` with columns x and y and the error bound as text under `"eps"` in `NAME.json`, or a linear program, `NAME.mps`.
///
/// # Panics
/// When the folder has no case, or a case cannot be read.
pub fn conformance_table(folder: &Path) -> String {
    let mut files: Vec<String> = fs::read_dir(folder)
        .unwrap_or_else(|error| panic!("{}: {error}", folder.display()))
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
        .collect();
    files.sort();
    let cases: Vec<(&str, Vec<Verdicts>)> = files
        .iter()
        .filter_map(|file| match file.rsplit_once('.')? {
            (name, "csv") => Some((name, of_fit(&hard_case(folder, name.to_owned()).problem))),
            (name, "mps") => Some((name, of_model(&model(&folder.join(file))))),
            _ => None,
        })
        .collect();
    let [(_, first), ..] = &cases[..] else { panic!("{}: there is no case", folder.display()) };
    let row = |name: &str, cells: Vec<String>| format!("| {name} | {} |\n", cells.join(" | "));
    let mut text = row("case", first.iter().map(|verdicts| verdicts.source.clone()).collect());
    text += &format!("|---|{}\n", "---|".repeat(first.len()));
    for (name, verdicts) in &cases {
        assert_eq!(verdicts.len(), first.len(), "{name}: every solver answers");
        text += &row(&format!("`{name}`"), verdicts.iter().map(Verdicts::cell).collect());
    }
    let right = |solver: usize| cases.iter().filter(|(_, verdicts)| !verdicts[solver].is_refuted).count();
    let totals = (0..first.len()).map(|solver| format!("{} of {}", right(solver), cases.len()));
    text + &row("not refuted", totals.collect())
}

impl Verdicts {
    fn cell(&self) -> String {
        let Verdicts { as_read, received, .. } = self;
        match as_read == received {
            true => as_read.clone(),
            false => format!("{as_read} ({received} for the doubles it received)"),
        }
    }
}

/// A linear program in a file of MPS.
fn model(file: &Path) -> Model {
    let bytes = fs::read(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    let read =
        model_text(&bytes).and_then(|text| read_model(text, ExchangeFormat::Mps, &ModelLimits::default()));
    read.unwrap_or_else(|error| panic!("{}: {error}", file.display()))
}

fn of_fit(problem: &Problem) -> Vec<Verdicts> {
    let options = CheckOptions {
        solvers: source_names(),
        answers: Vec::new(),
        tolerance: tolerance(),
        as_printed: true,
        time_limit: TIME_LIMIT,
        directions: None,
        all_rows: true,
    };
    let answers = check(problem, Reading::Decimal, &options).expect("all solvers are of this build").answers;
    let of = |reading| answers.iter().filter(move |answer| answer.reading == reading);
    let verdicts = of(Reading::Decimal).map(|answer| {
        let received = of(Reading::Binary64).find(|other| other.source == answer.source).unwrap_or(answer);
        Verdicts {
            source: answer.source.to_string(),
            as_read: answer.worst().name().to_owned(),
            received: received.worst().name().to_owned(),
            is_refuted: answer.worst().is_refutation(),
        }
    });
    verdicts.collect()
}

fn of_model(model: &Model) -> Vec<Verdicts> {
    let tolerances = Tolerances { relative: tolerance(), digits_as_printed: true };
    let plane = Plane::new(model).expect("a case has at most two columns");
    let judged = judge_solvers(&plane, TIME_LIMIT, &tolerances).expect("a case can be solved");
    let verdicts = |solver: JudgedSolver| Verdicts {
        source: solver.source.to_string(),
        as_read: worst(&solver.as_read),
        received: worst(&solver.received),
        is_refuted: solver.as_read.is_refuted(),
    };
    judged.into_iter().map(verdicts).collect()
}

/// The worst of all aspects, and which are refuted.
fn worst(findings: &Findings) -> String {
    let refuted = findings.findings.iter().filter(|finding| finding.worth == Worth::Refuted);
    let refuted: Vec<&str> = refuted.map(|finding| finding.aspect.name()).collect();
    let worst = findings.worst().name();
    if refuted.is_empty() { worst.to_owned() } else { format!("{worst}: {}", refuted.join(", ")) }
}
