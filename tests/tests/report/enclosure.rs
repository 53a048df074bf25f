//! The enclosure of the exact interval by a printed estimate with its error bound, for any number of digits, in every
//! format.

use std::fs;
use std::path::{Path, PathBuf};

use boundfit_estimation::{Columns, EpsilonColumn, Fit, LineForm, Measurements, Problem, fit};
use boundfit_exact::{Interval, Limits, Rational, Reading};
use boundfit_formats::{ColumnSelector, Source, TableOptions};
use boundfit_report::{InverseLine, Origin, Style, brief_document, fit_csv, fit_json, full_fit_document};
use boundfit_tests::cli::numbers::{check_enclosed, check_numbers};
use boundfit_tests::generate::{one_in, share};
use boundfit_tests::program::root;

/// A number as printed, in plain text, Markdown or LaTeX.
fn printed(text: &str) -> Rational {
    let plain = text
        .replace(r" \cdot 10^{", "e")
        .replace(r" \times 10^{", "e")
        .replace(r"\raggedright", "")
        .replace(r"\tabularnewline", "")
        .replace(['}', '$', '`'], "");
    let plain = plain.trim_matches(|mark: char| mark.is_whitespace() || ",;\\".contains(mark));
    Reading::Decimal.read(plain, &Limits::default()).unwrap_or_else(|error| panic!("{text:?}: {error}"))
}

/// The two cells of a line behind such a label, which may be indented.
fn cells(line: &str, label: &str) -> Option<[String; 2]> {
    let line = line.trim_start_matches(['|', ' ', '~', '\u{a0}']).trim_start_matches(r"\quad").trim_start();
    let line = line.strip_prefix(label)?.trim_end_matches(r"\\");
    let is_marked = line.contains(['|', '&']);
    let parts: Vec<&str> = match is_marked {
        true => line.split(['|', '&']).map(str::trim).collect(),
        false => line.split_whitespace().collect(),
    };
    let mut parts = parts.into_iter().filter(|part| !part.is_empty()).map(str::to_owned);
    Some([parts.next()?, parts.next()?])
}

fn row(document: &str, label: &str) -> [String; 2] {
    let found = document.lines().find_map(|line| cells(line, label));
    found.unwrap_or_else(|| panic!("no row {label:?} in {document}"))
}

fn check_document(document: &str, fit: &Fit) {
    let document =
        document.replace(r"\pm ", "+-").replace(r"\pm", "+-").replace("\u{b1}", "+-").replace("&nbsp;", " ");
    let central = fit.central.as_ref().unwrap();
    let (estimate, bound) = (row(&document, "central"), row(&document, "guaranteed"));
    for axis in [0, 1] {
        let bound = bound[axis].replace("+-", "");
        let shown = [printed(&estimate[axis]), printed(&bound)];
        check_enclosed(&shown, &central.theta[axis], &central.guaranteed_error[axis]);
    }
    let (Ok(own), Some(errors)) = (&fit.least_squares, fit.least_squares_guaranteed_error()) else { return };
    let estimate = row(&document, "least squares");
    let (_, bounds) = document.split_once("guaranteed error").unwrap();
    let bounds: Vec<&str> = bounds.split("+-").skip(1).take(2).collect();
    for axis in [0, 1] {
        let bound = bounds[axis].split(['$', ',', '\n', '|']).next().unwrap();
        check_enclosed(&[printed(&estimate[axis]), printed(bound)], &own.theta[axis], &errors[axis]);
    }
}

/// `theta1  in [..]; central C +-G`, which may go on in the next line.
fn check_brief(document: &str, fit: &Fit, pui: &[Interval; 2]) {
    let central = fit.central.as_ref().unwrap();
    let words: Vec<&str> = document.split_whitespace().collect();
    let text = words.join(" ");
    for (axis, name) in ["theta1", "theta2"].iter().enumerate() {
        let Some((_, own)) = text.split_once(&format!(" {name} in ")) else {
            // A single value is its own middle.
            assert_eq!(pui[axis].width(), Some(Rational::zero()), "{text}");
            continue;
        };
        let (_, own) = own.split_once("central ").unwrap();
        let (estimate, bound) = own.split_once(" +-").unwrap();
        let shown = [printed(estimate), printed(bound.split(' ').next().unwrap())];
        check_enclosed(&shown, &central.theta[axis], &central.guaranteed_error[axis]);
    }
}

/// The doubles of a table.
fn check_csv(table: &str, fit: &Fit) {
    let double = |quantity: &str, parameter: &str| {
        let start = format!("{quantity},{parameter},,,");
        let line = table.lines().find_map(|line| line.strip_prefix(&start)).unwrap();
        Rational::from_f64(line.split(',').next().unwrap().parse().unwrap()).unwrap()
    };
    let central = fit.central.as_ref().unwrap();
    for (axis, name) in ["theta1", "theta2"].iter().enumerate() {
        let shown = [double("central", name), double("guaranteed_error", name)];
        check_enclosed(&shown, &central.theta[axis], &central.guaranteed_error[axis]);
    }
}

/// Checks a table under this bound; whether there is a central estimate.
fn check(path: &Path, [x, y]: [&str; 2], epsilon: &str) -> bool {
    let epsilon = Reading::Decimal.read(epsilon, &Limits::default()).unwrap();
    let columns = Columns {
        first: ColumnSelector::name_or_number(x),
        second: None,
        response: Some(ColumnSelector::name_or_number(y)),
        epsilon: EpsilonColumn::Uniform(epsilon),
        form: LineForm::default(),
    };
    let source = Source::new("data.csv", std::io::Cursor::new(fs::read(path).unwrap()));
    let Ok(measurements) = Measurements::read(source, &columns, &TableOptions::default()) else {
        return false;
    };
    let problem = Problem { measurements, conditions: Vec::new() };
    let fit = fit(&problem);
    if fit.central.is_none() {
        return false;
    }
    let pui = fit.pui_intervals().unwrap();
    let origin = Origin { file: None, reading: Reading::Decimal, is_stored: false };
    for digits in (1..=12).map(Some).chain([None]) {
        let style = Style { digits, ..Style::default() };
        let document = full_fit_document(&problem, &fit, &origin, InverseLine::default(), &style);
        for text in [document.to_text(), document.to_markdown(), document.to_latex()] {
            check_document(&text, &fit);
        }
        check_brief(&brief_document(&problem, &fit, &origin, &style).to_text(), &fit, &pui);
        let json = fit_json(&problem, &fit, None, None, &origin, &style);
        check_numbers(&serde_json::from_str(&json).unwrap(), style.significant());
        check_csv(&fit_csv(&problem, &fit), &fit);
    }
    true
}

fn tables() -> Vec<(PathBuf, [&'static str; 2])> {
    let fixtures = root().join("fixtures");
    let mut all = vec![
        (fixtures.join("transducer/transducer.csv"), ["Vz", "z"]),
        (fixtures.join("worst-line/current.csv"), ["U", "I"]),
    ];
    for folder in ["figures", "claims", "hard-lp", "norris", "steam-generator"] {
        for entry in fs::read_dir(fixtures.join(folder)).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_some_and(|ending| ending == "csv") {
                all.push((path, ["x", "y"]));
            }
        }
    }
    all
}

#[test]
fn estimates_with_their_error_bounds_enclose_what_they_guarantee() {
    let mut seen = 0;
    for (path, columns) in tables().into_iter().step_by(one_in()) {
        for epsilon in ["1e9", "20", "1/3", "0.0101", "1e-3"] {
            seen += usize::from(check(&path, columns, epsilon));
        }
    }
    assert!(seen >= share(20), "{seen} sets");
}
