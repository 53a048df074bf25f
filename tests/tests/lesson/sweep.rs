//! The sets over the error bound in a lesson against the family itself.

use boundfit_estimation::{Family, Section};
use boundfit_exact::Rational;
use boundfit_tests::cli::numbers::{exact, rational};
use serde_json::Value;

use crate::document::{Lesson, count, fixtures, generated, items};
use crate::keys::with_intervals;

#[test]
fn each_set_has_the_vertices_of_the_family() {
    for lesson in fixtures().into_iter().chain(generated(6, 120)).chain(with_intervals(8, 30)) {
        let sweep = &lesson.data["sweep"];
        let stops: Vec<Rational> = items(&sweep["breakpoints"]).map(|stop| exact(&stop["s"])).collect();
        let last = stops.last().unwrap();
        assert_eq!(stops[0], Rational::zero());
        assert!(stops.is_sorted() && *last >= Rational::from(2), "{}", lesson.name);
        if sweep["least"].is_object() {
            assert!(stops.contains(&exact(&sweep["least"])), "{}", lesson.name);
        }
        let family = Family::new(&lesson.problem, Rational::zero(), last.clone());
        for (stop, s) in items(&sweep["breakpoints"]).zip(&stops) {
            check(&lesson, stop, s, &family.at(s).unwrap());
        }
        for (piece, ends) in items(&sweep["pieces"]).zip(stops.windows(2)) {
            let s = (&ends[0] + &ends[1]).half();
            check(&lesson, piece, &s, &family.at(&s).unwrap());
        }
    }
}

fn check(lesson: &Lesson, part: &Value, s: &Rational, section: &Section) {
    let number = |function: &Value, key: &str| rational(function[key].as_str().unwrap());
    let at = |function: &Value| number(function, "constant") + number(function, "slope") * s;
    let vertices = items(&part["vertices"]).map(|index| {
        let functions = &lesson.data["sweep"]["vertices"][count(index)];
        [at(&functions[0]), at(&functions[1])]
    });
    let expected: Vec<[Rational; 2]> = section.vertices.iter().map(|vertex| vertex.theta.clone()).collect();
    assert_eq!(vertices.collect::<Vec<_>>(), expected, "{} at {s:?}", lesson.name);
    assert_eq!(part["kind"], section.kind.name());
}
