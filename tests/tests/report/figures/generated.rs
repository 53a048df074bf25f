//! Every figure of generated readings: most kinds of sets, under bounds around y and under intervals, open ones too.

use std::collections::BTreeSet;

use boundfit_estimation::{Family, Problem};
use boundfit_exact::Rational;
use boundfit_figures::{
    Encoding, Figure, Picture, PictureFormat, PlotOptions, draw, draw_sweep, draw_sweep_of_corridors,
};
use boundfit_tests::generate::{seeded, share};
use boundfit_tests::readings::{in_intervals, problem};
use roxmltree::Document;

/// Checks that a picture is a document of SVG with something in it.
fn check(picture: &Picture, what: &str) {
    let svg =
        picture.encoded_as(PictureFormat::Svg, &Encoding { real_text: true, ..Encoding::default() }).unwrap();
    let svg = String::from_utf8(svg).unwrap();
    let document = Document::parse(&svg).unwrap_or_else(|error| panic!("{what}: {error}"));
    assert!(document.root_element().has_tag_name(("http://www.w3.org/2000/svg", "svg")), "{what}");
    assert!(!["NaN", "\"inf", " inf"].iter().any(|wrong| svg.contains(wrong)), "{what}: {svg}");
}

fn check_figures(problem: &Problem, what: &str) {
    let options = PlotOptions::default();
    let fit = problem.fit();
    for figure in Figure::ALL {
        check(&draw(problem, &fit, figure, &options).unwrap(), &format!("{what}, {}", figure.name()));
    }
    let family = Family::new(problem, Rational::zero(), Rational::from(2));
    let sets = draw_sweep(problem, &family, &options).unwrap();
    let corridors = draw_sweep_of_corridors(problem, &fit, &family, &options).unwrap();
    sets.iter().chain(&corridors).for_each(|picture| check(picture, &format!("{what}, sweep")));
}

#[test]
fn every_figure_of_generated_readings_is_drawn() {
    let mut kinds = BTreeSet::new();
    let mut rng = seeded(2026);
    for index in 0..share(50) {
        let around = problem(&mut rng);
        let between = in_intervals(&around, &mut rng);
        for (problem, bounds) in [(around, "around y"), (between, "intervals")] {
            kinds.insert((problem.fit().fps.polyhedron().region().kind().name(), bounds));
            check_figures(&problem, &format!("problem {index}, {bounds}"));
        }
    }
    assert!(kinds.len() > share(8), "{kinds:?}");
}
