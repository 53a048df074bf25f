//! Tests of the readings that figures of the data plane show.

use boundfit_estimation::{Problem, fit};
use boundfit_exact::Rational;

use super::drawing;
use super::readings::style_of_fitted;
use crate::drawing::{Drawing, Item};
use crate::figure::{Figure, PlotOptions};
use crate::palette::style;
use crate::samples::problem;

fn figure(problem: &Problem, y_range: Option<[i64; 2]>) -> Drawing {
    let y_range = y_range.map(|ends| ends.map(Rational::from));
    let options = PlotOptions { y_range, ..PlotOptions::default() };
    drawing(problem, &fit(problem), Figure::Data, &options)
}

/// The readings that are marked on the first panel.
fn marked(drawing: &Drawing) -> usize {
    let (_, reading) = style_of_fitted(false);
    let items = drawing.panels[0].items.iter();
    items.filter(|item| matches!(item, Item::Mark { mark, .. } if *mark == reading)).count()
}

#[test]
fn readings_on_the_border_are_drawn_and_those_outside_counted() {
    let rows = ["0 0 0.5", "1 1 0.5", "2 2 0.5", "3 3 0.5"];
    let problem = problem("line", &rows, &[]);
    for (range, expected, note) in [
        (None, 4, None),
        (Some([0, 3]), 4, None),
        (Some([1, 2]), 2, Some("Outside the first panel: 2 of 4 readings.")),
        (
            Some([5, 6]),
            0,
            Some("No reading is in the first panel: they lie from 0 to 3 across and from 0 to 3 up."),
        ),
    ] {
        let drawing = figure(&problem, range);
        assert_eq!(marked(&drawing), expected, "{range:?}");
        let found = drawing.notes.iter().find(|note| note.contains("the first panel"));
        assert_eq!(found.map(String::as_str), note, "{range:?}");
    }
}

#[test]
fn lines_are_above_readings_that_are_as_dense_as_a_wall() {
    let rows: Vec<String> = (0..900).map(|k| format!("{k} {} 1", k % 2)).collect();
    let rows: Vec<&str> = rows.iter().map(String::as_str).collect();
    let figure = figure(&problem("line", &rows, &[]), None);
    for panel in &figure.panels {
        let last_mark = panel.items.iter().rposition(|item| matches!(item, Item::Mark { .. }));
        let is_line =
            |item: &Item| matches!(item, Item::Line { stroke, .. } if *stroke == style::LEAST_SQUARES);
        assert!(panel.items.iter().position(is_line) > last_mark, "{last_mark:?}");
    }
}
