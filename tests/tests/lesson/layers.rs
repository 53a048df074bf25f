//! The results of linear programs for the data.

use boundfit_check::{CheckOptions, check, source_names};
use boundfit_exact::{Rational, Reading};
use boundfit_geometry::{Inequality, Point, Polyhedron, System};
use serde_json::Value;

use crate::document::{Lesson, fixtures, generated, items, transducer};
use boundfit_tests::cli::numbers::{exact, pair};

/// Twice the area of a polygon.
fn doubled_area(corners: &[Point]) -> Rational {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(p, q)| p.theta1() * q.theta2() - p.theta2() * q.theta1()).sum()
}

#[test]
fn the_set_lies_between_its_approximations() {
    let mut polygons = 0;
    for lesson in fixtures().into_iter().chain(generated(31, 60)) {
        let found = &lesson.data["layers"]["directions"];
        let region = lesson.fit.fps.polyhedron().region();
        assert_eq!(found["count"], 16);
        assert_eq!(found["outer"].is_null(), region.is_empty() || !region.is_bounded(), "{}", lesson.name);
        if let Some(inner) = found["inner"].as_array() {
            for index in inner {
                assert!(
                    lesson.fit.fps.polyhedron().membership(&lesson.point(index).coordinates()).is_inside()
                );
            }
        }
        if lesson.data["fit"]["fps"]["kind"] != "polygon" {
            continue;
        }
        polygons += 1;
        let (inner, outer) = (lesson.points(&found["inner"]), lesson.points(&found["outer"]));
        let [inner_area, outer_area] = ["inner_area", "outer_area"].map(|key| exact(&found[key]));
        assert_eq!(doubled_area(&inner), &inner_area + &inner_area, "{}", lesson.name);
        assert_eq!(doubled_area(&outer), &outer_area + &outer_area, "{}", lesson.name);
        let area = region.area().unwrap();
        assert!(inner_area <= area && area <= outer_area, "{}", lesson.name);
        let hull = polygon(&outer);
        assert!(region.vertices().iter().all(|v| hull.membership(&v.point().coordinates()).is_inside()));
    }
    assert!(polygons > 10);
}

/// A polygon from its corners, counter-clockwise.
fn polygon(corners: &[Point]) -> Polyhedron {
    let next = corners.iter().cycle().skip(1);
    let side = |(p, q): (&Point, &Point)| {
        let (a1, a2) = (q.theta2() - p.theta2(), p.theta1() - q.theta1());
        let b = &a1 * p.theta1() + &a2 * p.theta2();
        Inequality::new(a1, a2, b)
    };
    Polyhedron::intersect(corners.iter().zip(next).map(side).collect::<System>())
}

#[test]
fn verdicts_are_those_of_the_check() {
    for Lesson { problem, data, name, .. } in fixtures() {
        let options = CheckOptions {
            solvers: source_names(),
            answers: Vec::new(),
            tolerance: Rational::ratio(1, 1_000_000),
            as_printed: true,
            time_limit: std::time::Duration::from_secs(60),
            directions: None,
            all_rows: true,
        };
        let check = check(&problem, Reading::Decimal, &options).unwrap();
        let as_read = check.answers.iter().filter(|answer| answer.reading == Reading::Decimal);
        let answers: Vec<&Value> = items(&data["layers"]["lp"]).collect();
        assert_eq!(answers.len(), source_names().len());
        for (expected, answer) in as_read.zip(answers) {
            assert_eq!(answer["source"], expected.source.raw());
            for (position, claim) in items(&answer["claims"]).enumerate() {
                let judgement = &expected.bounds[position / 2][position % 2];
                assert_eq!(claim["parameter"], ["theta1", "theta2"][position / 2]);
                assert_eq!(claim["end"], ["lower", "upper"][position % 2]);
                assert_eq!(claim["verdict"], judgement.verdict.name(), "{name}");
                assert_eq!(claim["claimed"].is_object().then(|| exact(&claim["claimed"])), judgement.claimed);
                assert_eq!(claim["reason"].is_null(), claim["verdict"] == "exact", "{name}: {claim}");
            }
        }
    }
}

#[test]
fn the_exact_simplex_shows_where_the_ends_are() {
    let lesson = transducer();
    let simplex =
        items(&lesson.data["layers"]["lp"]).find(|answer| answer["source"] == "exact-simplex").unwrap();
    for (position, claim) in items(&simplex["claims"]).enumerate() {
        let interval = &lesson.fit.pui_intervals().unwrap()[position / 2];
        let end = [interval.lower(), interval.upper()][position % 2].value().unwrap();
        assert_eq!((&exact(&claim["claimed"]), &pair(&claim["point"])[position / 2]), (end, end));
        assert!(lesson.fit.fps.polyhedron().membership(&pair(&claim["point"])).is_inside());
    }
}
