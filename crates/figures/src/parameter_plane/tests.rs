//! The content of figures of the parameter plane.

use boundfit_estimation::{Problem, fit};
use boundfit_exact::Rational;

use super::sliver::Sliver;
use crate::drawing::{Drawing, Item, Panel};
use crate::figure::PlotOptions;
use crate::page::Page;
use crate::palette::{Mark, style};
use crate::samples::problem;

fn figure(problem: &Problem) -> Drawing {
    super::fps(problem, &fit(problem), &PlotOptions::default())
}

fn arrows(panel: &Panel) -> usize {
    panel.items.iter().filter(|item| matches!(item, Item::ArrowHead { .. })).count()
}

fn vertices(panel: &Panel) -> usize {
    let Mark { shape, colour, .. } = style::VERTEX;
    let is_vertex = |mark: &Mark| (mark.shape, mark.colour) == (shape, colour);
    panel.items.iter().filter(|item| matches!(item, Item::Mark { mark, .. } if is_vertex(mark))).count()
}

#[test]
fn cut_edges_have_arrows_and_sets_only_their_own_vertices() {
    let free = ["0 0 0 1"];
    let strip = ["2 1 1 0.1"];
    let line = ["2 1 1 0"];
    for (rows, conditions, expected) in [
        (&free[..], &[][..], (0, 4)),
        (&free, &["theta1 + 2*theta2 <= 3"], (0, 3)),
        (&strip, &[], (0, 4)),
        (&strip, &["theta1 >= 0"], (2, 2)),
        (&strip, &["theta1 >= 0", "theta1 <= 1"], (4, 0)),
        (&free, &["theta1 >= 2", "theta2 >= 3"], (1, 2)),
        (&line, &[], (0, 2)),
        (&line, &["theta1 >= 0"], (1, 1)),
        (&line, &["theta1 >= 0", "theta1 <= 1"], (2, 0)),
        (&line, &["theta1 >= 1", "theta1 <= 1"], (1, 0)),
    ] {
        let drawing = figure(&problem("two", rows, conditions));
        let panel = &drawing.panels[0];
        assert_eq!((vertices(panel), arrows(panel)), expected, "{} {conditions:?}", drawing.title);
    }
}

#[test]
fn everything_is_inside_of_its_panel() {
    let problems = [
        problem("line", &["0 0 0.5", "1 3 0.5", "2 1 0.5"], &[]),
        problem("line", &["1e9 1 0.5", "1000000001 3 0.5", "1000000002 4.5 0.5"], &[]),
        problem("two", &["1 2 3 0.1"], &["theta1 >= 0"]),
    ];
    for problem in &problems {
        for panel in figure(problem).panels {
            let inside = |place: &[f64; 2]| place.iter().all(|part| (-1e-9..=1.0 + 1e-9).contains(part));
            for item in &panel.items {
                let holds = match item {
                    Item::Area { outline: places, .. } | Item::Line { points: places, .. } => {
                        places.iter().all(inside)
                    }
                    Item::Mark { at, .. } | Item::Text { at, .. } | Item::ArrowHead { tip: at, .. } => {
                        inside(at)
                    }
                };
                assert!(holds, "{item:?}");
            }
        }
    }
}

#[test]
fn legends_have_what_is_drawn() {
    // A strip across all directions: neither an inner hull nor an outer polygon.
    let problem = problem("line", &["2 1 0.1"], &[]);
    let fit = fit(&problem);
    let options = PlotOptions::default();
    let mut drawing = super::directions(&problem, &fit, &options);
    drawing.keep_legend_of_drawn();
    let texts: Vec<&str> = drawing.legend.iter().map(|entry| entry.text.as_str()).collect();
    assert_eq!(texts, ["exact set"]);
}

#[test]
fn a_thin_set_keeps_its_form_in_principal_axes() {
    // A triangle whose height is 1e-40 of its longest side: in binary64 it would be a segment.
    let least = Rational::ratio(1, 10_000_000_000);
    let least = &least * &least * &least * &least;
    let [zero, one, half] = [Rational::zero(), Rational::one(), Rational::ratio(1, 2)];
    let corners = [[zero.clone(), zero.clone()], [one.clone(), one.clone()], [half.clone(), &half + &least]];
    let sliver = Sliver::of_corners(&corners).unwrap();
    let panel = sliver.panel(0, Page::default());
    let places: Vec<[f64; 2]> = corners.iter().filter_map(|corner| sliver.place(&panel, corner)).collect();
    let margin = 1.0 / 8.0;
    // From the corner (1, 1) the diagonal runs to (0, 0), and the third corner is on its right.
    let expected = [[1.0 - margin, 1.0 - margin], [margin, 1.0 - margin], [0.5, margin]];
    for (place, expected) in places.iter().zip(expected) {
        let close = place.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9);
        assert!(close, "{place:?} {expected:?}");
    }
    let wide = [[zero.clone(), zero.clone()], [one.clone(), zero.clone()], [zero, one]];
    assert!(Sliver::of_corners(&wide).is_none());
}

#[test]
fn a_large_eui_box_gets_a_panel_of_its_own() {
    let rows: Vec<String> = (0..12).map(|k| format!("{k} {} 0.5", f64::from(k % 2) * 0.9)).collect();
    let rows: Vec<&str> = rows.iter().map(String::as_str).collect();
    let drawing = figure(&problem("line", &rows, &[]));
    assert_eq!(drawing.panels.len(), 2);
    assert_eq!(drawing.panels[1].heading, "EUI box");
    let near = figure(&problem("line", &["0 0 1", "1 1 1"], &[]));
    assert_eq!(near.panels.len(), 1);
}
