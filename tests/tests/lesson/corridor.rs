//! The band of all feasible lines against the set's support function.

use boundfit_exact::Rational;
use boundfit_geometry::Support;
use boundfit_tests::shape::Tally;
use serde_json::Value;

use crate::document::{Lesson, fixtures, generated, items};
use boundfit_tests::cli::numbers::rational;

/// The edge at an abscissa, from the data alone.
fn value(lesson: &Lesson, edge: &Value, x: &Rational) -> Option<Rational> {
    let number = |end: &Value| end.as_str().map(rational);
    let is_beyond =
        number(&edge["from"]).is_some_and(|from| *x < from) || number(&edge["to"]).is_some_and(|to| *x > to);
    if edge["nowhere"] == true || is_beyond {
        return None;
    }
    let breakpoints: Vec<Rational> =
        items(&edge["breakpoints"]).map(|b| rational(b.as_str().unwrap())).collect();
    assert!(breakpoints.is_sorted_by(|left, right| left < right));
    let lines = lesson.points(&edge["lines"]);
    assert_eq!(lines.len(), breakpoints.len() + 1);
    let line = &lines[breakpoints.iter().filter(|breakpoint| *breakpoint < x).count()];
    Some(line.theta1() * x + line.theta2())
}

#[test]
fn the_corridor_is_the_support_function() {
    let mut tally = Tally::default();
    for lesson in fixtures().into_iter().chain(generated(21, 200)) {
        let corridor = &lesson.data["corridor"];
        let polyhedron = lesson.fit.fps.polyhedron();
        let is_line = lesson.data["model"]["kind"] == "line";
        assert_eq!(corridor.is_null(), !is_line || polyhedron.region().is_empty(), "{}", lesson.name);
        if corridor.is_null() {
            continue;
        }
        let mut abscissas: Vec<Rational> =
            lesson.problem.measurements.kept().iter().map(|row| row.regressor[0].clone()).collect();
        for edge in ["upper", "lower"] {
            let breakpoints = items(&corridor[edge]["breakpoints"]);
            abscissas.extend(breakpoints.map(|breakpoint| rational(breakpoint.as_str().unwrap())));
        }
        let further: Vec<Rational> = abscissas.iter().map(|x| x + Rational::ratio(1, 3)).collect();
        for x in abscissas.iter().chain(&further) {
            for (edge, sign) in [("upper", 1), ("lower", -1)] {
                let sign = Rational::from(sign);
                let expected = match polyhedron.support(&[x * &sign, sign.clone()]) {
                    Support::Bounded { proof, .. } => Some(proof.value * &sign),
                    Support::Unbounded(_) => None,
                    Support::Empty(_) => unreachable!("a corridor of nothing"),
                };
                assert_eq!(value(&lesson, &corridor[edge], x), expected, "{} {edge} {x}", lesson.name);
                tally.count(if expected.is_some() { "finite" } else { "infinite" });
            }
        }
    }
    tally.assert_each(100, &["finite", "infinite"]);
}
