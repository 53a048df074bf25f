//! Theorems about predictions, outliers, ranges and statuses: true ones are accepted, and what is accepted is true.

use std::collections::BTreeMap;

use boundfit_estimation::{Problem, fit};
use boundfit_exact::{Rational, Reading};
use boundfit_questions::{FurtherError, LinearRange, Order, OutlierLimits, Outliers, Statuses};
use boundfit_report::{
    AskedValues, Origin, OutliersReport, Prediction, RangeReport, Theory, kernel_outliers, kernel_prediction,
    kernel_range, kernel_status,
};
use boundfit_tests::generate::seeded;
use boundfit_tests::proofs::{bounded, questions};
use boundfit_tests::runs::readings;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use crate::accepted::all_are_accepted;
use crate::forged_files::{
    FILES, FORGERIES, Forger, any, none_is_false, places, with_forgeries, with_other_fraction,
    with_other_hint, with_other_lines, with_other_word,
};

const READING: Reading = Reading::Decimal;
const THEORY: Theory = Theory::Installed;

/// All theorems about a problem, by kind.
fn theorems(problem: &Problem, rng: &mut ChaCha8Rng) -> Vec<(&'static str, String)> {
    let found = fit(problem);
    let mut all = vec![("predict", prediction(problem, rng))];
    let statuses = Statuses::of(problem, &found).unwrap();
    let kind = if found.is_empty() { "status of none" } else { "status" };
    all.push((kind, kernel_status((problem, &found), &statuses, READING, THEORY).unwrap()));
    let mut orders = vec![Order::natural(problem.measurements.model()), Order::Row];
    orders.dedup();
    for order in orders {
        let range = LinearRange::of(problem, order);
        let report = RangeReport { problem, fit: &found, order, range: &range, longest: None };
        all.push((order.name(), kernel_range(&report, READING, THEORY).unwrap()));
    }
    let limits =
        OutlierLimits { sets: if rng.random_bool(0.2) { 1 } else { 1000 }, ..OutlierLimits::default() };
    let outliers = Outliers::new(problem, &limits);
    let kind = match &outliers {
        Err(_) => "outliers of conditions",
        Ok(own) if own.least == 0 => "no outliers",
        Ok(own) if own.is_complete => "all outliers",
        Ok(_) => "some outliers",
    };
    let report = OutliersReport {
        problem,
        fit: &found,
        outliers: outliers.as_ref(),
        growth: &[],
        shows_growth: false,
    };
    // Long searches have none.
    all.extend(kernel_outliers(&report, READING, THEORY).ok().map(|text| (kind, text)));
    all
}

fn prediction(problem: &Problem, rng: &mut ChaCha8Rng) -> String {
    let found = fit(problem);
    let is_line = matches!(problem.measurements.model(), boundfit_estimation::Model::Line { .. });
    let mut number = || Rational::ratio(rng.random_range(-9..=9), rng.random_range(1..=3));
    let values = (0..3).map(|_| [number(), if is_line { Rational::one() } else { number() }]);
    let at: Vec<[Rational; 2]> = values.collect();
    let from = vec![[number(), Rational::zero()]];
    let from = if is_line { from } else { Vec::new() };
    let prediction = Prediction {
        problem,
        fit: &found,
        origin: Origin { file: None, reading: READING, is_stored: false },
        error: FurtherError::of(&problem.measurements),
        given: None,
        at: AskedValues { count: at.len(), values: &|| Box::new(at.iter().cloned()) },
        from: AskedValues { count: from.len(), values: &|| Box::new(from.iter().cloned()) },
    };
    kernel_prediction(&prediction, READING, THEORY).unwrap()
}

#[test]
fn fixtures_and_generated_readings_have_theorems_about_parts() {
    let mut rng = seeded(3107);
    let mut kinds = BTreeMap::<_, usize>::new();
    let mut texts = Vec::new();
    let few = |problem: &Problem| problem.measurements.kept().len() <= 60;
    let given = questions().into_iter().chain(bounded()).map(|question| question.problem().unwrap());
    let mut problems: Vec<Problem> = given.filter(few).collect();
    problems.extend((0..60).map(|_| readings(&mut rng, 12).problem()));
    for problem in &problems {
        for (kind, text) in theorems(problem, &mut rng) {
            *kinds.entry(kind).or_default() += 1;
            texts.push(text);
        }
    }
    assert_eq!(kinds.len(), 9, "{kinds:?}");
    println!("{kinds:?}");
    all_are_accepted("parts", &texts);
}

/// Changes a number in a list of rows, or drops or repeats one.
fn with_other_rows(rng: &mut ChaCha8Rng, text: &str) -> Option<String> {
    let end = any(rng, &places(text, "]%Z"))?.start;
    let start = text[..end].rfind('[')? + 1;
    let mut rows: Vec<String> =
        text[start..end].split("; ").filter(|own| !own.is_empty()).map(ToOwned::to_owned).collect();
    let place = rng.random_range(0..=rows.len());
    match (rng.random_range(0..5), place < rows.len()) {
        (0, true) => drop(rows.remove(place)),
        (1, _) => rows.insert(place, rng.random_range(1..8).to_string()),
        (_, true) => rows[place] = rng.random_range(1..8).to_string(),
        (_, false) => return None,
    }
    Some(format!("{}{}{}", &text[..start], rows.join("; "), &text[end..]))
}

/// Changes a number of rows that the statement names.
fn with_other_count(rng: &mut ChaCha8Rng, text: &str) -> Option<String> {
    let end = any(rng, &places(text, "%nat"))?.start;
    let start = text[..end].rfind(|own: char| !own.is_ascii_digit())? + 1;
    // In one theorem of `(2 <= length out)%nat` the number stands before the relation.
    let (start, end) = if start < end {
        (start, end)
    } else {
        let start = text[..end].rfind('(')? + 1;
        (start, start + text[start..].find(' ')?)
    };
    let old: usize = text[start..end].parse().ok()?;
    let new = if old > 0 && rng.random_bool(0.5) { old - 1 } else { old + 1 };
    let line_end = end + text[end..].find("Qed.")?;
    // Sometimes the proof is changed with it.
    let after = match rng.random_bool(0.5) {
        true => text[end..line_end].replace(&format!(" {old}"), &format!(" {new}")),
        false => text[end..line_end].to_owned(),
    };
    Some(format!("{}{new}{after}{}", &text[..start], &text[line_end..]))
}

/// The kinds of changes, each with its share.
const FORGERS: [(&str, Forger); 10] = [
    ("lines", with_other_lines),
    ("lines", with_other_lines),
    ("rows", with_other_rows),
    ("rows", with_other_rows),
    ("rows", with_other_rows),
    ("rows", with_other_rows),
    ("count", with_other_count),
    ("fraction", with_other_fraction),
    ("hint", with_other_hint),
    ("word", with_other_word),
];

#[test]
fn no_forgery_about_parts_is_accepted_that_is_false() {
    let mut rng = seeded(3108);
    let (mut cases, mut kinds) = (Vec::new(), BTreeMap::<_, usize>::new());
    while cases.len() < FILES * (FORGERIES + 1) {
        let problem = readings(&mut rng, 6).problem();
        for (kind, text) in theorems(&problem, &mut rng) {
            // The kinds are about as frequent as each other.
            let count = kinds.entry(kind).or_default();
            if *count < FILES / 6 && cases.len() < FILES * (FORGERIES + 1) {
                *count += 1;
                cases.extend(with_forgeries(&mut rng, &text, FORGERIES, &FORGERS));
            }
        }
    }
    println!("{kinds:?}");
    none_is_false("parts", &cases);
}
