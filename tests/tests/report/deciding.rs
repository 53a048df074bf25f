//! Reports of a fit of which only the readings that decide are numbers: those of all readings, byte for byte.

use std::fmt::Write;

use boundfit_estimation::{Fit, Keep, Problem, Question, fit, mending_rows};
use boundfit_exact::Reading;
use boundfit_formats::{ColumnSelector, ScanOptions, Source};
use boundfit_report::{
    InverseLine, Origin, Style, active_names, brief_document, fit_csv, fit_document, fit_json, fit_script,
    h_representation, region_wkt, v_representation, vertices_csv,
};
use boundfit_tests::generate::{seeded, share};
use rand::RngExt;

/// A table, and the error bound that is asked for. Its points are on a coarse grid with many ties, on a fine one, on a line, or
/// on a curve.
fn table(seed: u64) -> (String, String) {
    let mut random = seeded(seed);
    let rows = random.random_range(65..400);
    let kind = random.random_range(0..5);
    let mut text = String::from("x,y\n");
    for row in 0..rows {
        let (x, y) = match kind {
            0 => (random.random_range(-3..=3), random.random_range(-3..=3)),
            1 => {
                let x = random.random_range(-999_999..=999_999);
                (x, 2 * x + random.random_range(-500_000..=500_000))
            }
            2 => (row, 3 * row + random.random_range(-1..=1)),
            3 => (row, row * row),
            _ => (7, random.random_range(-2..=2)),
        };
        writeln!(text, "{x}e-3,{y}e-4").unwrap();
    }
    let bounds = ["0", "1e-4", "2.5e-4", "4e-4", "3", "25", "min", "1.5*min"];
    (text, bounds[random.random_range(0..bounds.len())].to_owned())
}

#[test]
fn the_readings_that_decide_give_the_report_of_all() {
    let mut empty = 0;
    for seed in 0..share(600) as u64 {
        let (text, bound) = table(seed);
        let column = ColumnSelector::name_or_number;
        let question =
            Question::line(column("x"), Some(column("y"))).within(&bound, Reading::Decimal).unwrap();
        let read = |keep: Keep| -> Problem {
            let source = Source::new("data.csv", std::io::Cursor::new(text.clone().into_bytes()));
            question.problem(source, &ScanOptions::default(), keep).unwrap()
        };
        let (few, all) = (read(Keep::DECIDING), read(Keep::default()));
        assert!(all.measurements.whole().is_none());
        let [of_few, of_all] = [&few, &all].map(fit);
        empty += usize::from(of_all.is_empty());
        let origin = Origin { file: None, reading: Reading::Decimal, is_stored: false };
        let style = Style::default();
        let texts = |problem: &Problem, fit: &Fit| {
            let document = fit_document(problem, fit, &origin, InverseLine::default(), &style);
            let brief = brief_document(problem, fit, &origin, &style).to_text();
            let documents = [document.to_text(), document.to_markdown(), document.to_latex(), brief];
            let (set, names) = (fit.fps.polyhedron(), |indices: &[usize]| active_names(fit, indices));
            let of_set = [h_representation(set), v_representation(set), vertices_csv(set, &names, &style)];
            let wkt = region_wkt(set, &style).ok();
            (documents, of_set, [fit_csv(problem, fit), fit_script(problem, fit, &names)], wkt)
        };
        assert_eq!(texts(&few, &of_few), texts(&all, &of_all), "seed {seed}: {bound}\n{text}");
        assert_eq!(mending_rows(&few, &of_few), mending_rows(&all, &of_all), "seed {seed}");
        // Documents that name every reading are made of all.
        let Some(measurements) = few.measurements.whole() else { continue };
        let whole = Problem { measurements, conditions: few.conditions.clone() };
        let json = |problem, fit| fit_json(problem, fit, None, None, &origin, &style);
        assert_eq!(json(&whole, &fit(&whole)), json(&all, &of_all), "seed {seed}: {bound}\n{text}");
    }
    assert!(empty > share(50), "{empty}");
}
