//! Every step of clipping, in every order, against the intersection of the half-planes so far.

use std::collections::BTreeSet;

use boundfit_exact::Rational;
use boundfit_geometry::{Multiplier, Point, Polyhedron, System};
use boundfit_tests::shape::{Tally, combined, shape, subsystem};
use serde_json::Value;

use crate::document::{Lesson, count, fixtures, generated, items, transducer};
use boundfit_tests::cli::numbers::exact;

#[test]
fn every_step_is_the_intersection_so_far() {
    let mut tally = Tally::default();
    for lesson in fixtures().into_iter().chain(generated(11, 200)) {
        let orders = items(&lesson.data["orders"]);
        let ids: Vec<&str> = orders.clone().map(|order| order["id"].as_str().unwrap()).collect();
        assert_eq!(ids, ["given", "slope", "worst"]);
        for order in orders {
            check_order(&lesson, order, &mut tally);
        }
    }
    tally.assert_each_kind(20);
    tally.assert_each(20, &["always", "already-empty", "dominated"]);
}

fn check_order(lesson: &Lesson, order: &Value, tally: &mut Tally) {
    let what = format!("{}: {}", lesson.name, order["id"]);
    let system = lesson.system();
    let mut taken: Vec<usize> = Vec::new();
    let mut before = Polyhedron::intersect(System::default());
    for step in items(&order["steps"]) {
        let index = count(&step["half_plane"]);
        let redundant = &step["redundant"];
        check_proof(&system, &taken, index, redundant, &before, &what);
        taken.push(index);
        let after = Polyhedron::intersect(subsystem(&system, &taken));
        assert_eq!(lesson.shape(step), shape(after.region()), "{what} {taken:?}");
        assert_eq!(!redundant.is_null(), shape(before.region()) == shape(after.region()), "{what} {taken:?}");
        let points = |polyhedron: &Polyhedron| -> Vec<Point> {
            polyhedron.region().vertices().iter().map(|vertex| vertex.point().clone()).collect()
        };
        let (old, new) = (points(&before), points(&after));
        let missing_in = |some: &[Point], others: &[Point]| -> Vec<Point> {
            some.iter().filter(|point| !others.contains(point)).cloned().collect()
        };
        assert_eq!(lesson.points(&step["born"]), missing_in(&new, &old), "{what}");
        assert_eq!(lesson.points(&step["lost"]), missing_in(&old, &new), "{what}");
        tally.count(after.region().kind().name());
        if let Some(why) = redundant["why"].as_str() {
            tally
                .count(["always", "already-empty", "dominated"].into_iter().find(|own| *own == why).unwrap());
        }
        before = after;
    }
    assert_eq!(taken.iter().collect::<BTreeSet<_>>().len(), system.len());
    assert_eq!(taken.len(), system.len(), "{what}");
    assert_eq!(shape(before.region()), shape(lesson.fit.fps.polyhedron().region()), "{what}");
}

/// A dominated half-plane is the sum of multiples of earlier ones, with a right-hand side larger by the slack.
fn check_proof(
    system: &System,
    taken: &[usize],
    index: usize,
    redundant: &Value,
    before: &Polyhedron,
    what: &str,
) {
    match redundant["why"].as_str() {
        None => {}
        Some("already-empty") => assert!(before.region().is_empty(), "{what}"),
        Some("always") => {
            let inequality = &system.inequalities()[index];
            assert!(inequality.a.iter().all(Rational::is_zero) && !inequality.b.is_negative(), "{what}");
        }
        Some("dominated") => {
            let multiplier = |term: &Value| {
                let (index, value) = (count(&term["half_plane"]), exact(&term["multiplier"]));
                assert!(taken.contains(&index) && value.is_positive(), "{what}");
                Multiplier { index, value }
            };
            let by: Vec<Multiplier> = items(&redundant["by"]).map(multiplier).collect();
            let slack = exact(&redundant["slack"]);
            let (sum, own) = (combined(system, &by), &system.inequalities()[index]);
            assert!(by.len() <= 2 && !slack.is_negative(), "{what}");
            assert_eq!((&sum.a, sum.b + slack), (&own.a, own.b.clone()), "{what}");
        }
        Some(other) => panic!("{other}"),
    }
}

#[test]
fn the_last_step_is_the_set_of_the_fit_report() {
    for lesson in fixtures() {
        let fps = &lesson.data["fit"]["fps"];
        for order in items(&lesson.data["orders"]) {
            let last = items(&order["steps"]).last().unwrap();
            assert_eq!(last["kind"], fps["kind"], "{}", lesson.name);
            let shown: Vec<[String; 2]> = items(&last["vertices"])
                .map(|index| {
                    let point = &lesson.data["points"][count(index)];
                    [0, 1].map(|axis| point[axis]["exact"].as_str().unwrap().to_owned())
                })
                .collect();
            let of_fit: Vec<[String; 2]> = items(&fps["vertices"])
                .map(|vertex| [0, 1].map(|axis| vertex["theta"][axis]["exact"].as_str().unwrap().to_owned()))
                .collect();
            assert_eq!(shown, of_fit, "{}", lesson.name);
        }
    }
}

#[test]
fn orders_are_what_their_names_say() {
    let lesson = transducer();
    let system = lesson.system();
    let sequence = |id: &str| -> Vec<usize> {
        let order = items(&lesson.data["orders"]).find(|order| order["id"] == id).unwrap();
        items(&order["steps"]).map(|step| count(&step["half_plane"])).collect()
    };
    assert_eq!(sequence("given"), (0..46).collect::<Vec<_>>());
    // Upper bounds are even: all of them from the largest x to the smallest, then the lower ones likewise.
    let x = |index: usize| lesson.problem.measurements.kept()[index / 2].regressor[0].clone();
    let (upper, lower) = (&sequence("slope")[..23], &sequence("slope")[23..]);
    assert!(upper.iter().all(|index| index % 2 == 0) && lower.iter().all(|index| index % 2 == 1));
    assert!([upper, lower].iter().all(|half| half.is_sorted_by(|&i, &j| x(i) >= x(j))));
    let estimate = &lesson.fit.least_squares.as_ref().unwrap().theta;
    let slack = |index: usize| system.inequalities()[index].slack(estimate);
    let worst = sequence("worst");
    assert!(worst.is_sorted_by(|&i, &j| (slack(i), i) <= (slack(j), j)));
    assert_eq!(
        lesson.data["half_planes"][worst[0]]["name"],
        serde_json::json!({"row": 34, "bound": "upper"})
    );
}

#[test]
fn notes_say_when_the_set_is_final() {
    for lesson in fixtures().into_iter().chain(generated(12, 60)) {
        for order in items(&lesson.data["orders"]) {
            let steps: Vec<&Value> = items(&order["steps"]).collect();
            let note = order["note"].as_str().unwrap();
            let last =
                steps.iter().rposition(|step| step["redundant"].is_null()).map(|position| position + 1);
            let expected = match last {
                None => "No step cuts anything off.".to_owned(),
                Some(last) if steps[steps.len() - 1]["kind"] == "empty" => {
                    format!("Nothing is left after step {last} of {}.", steps.len())
                }
                Some(last) if last == steps.len() => {
                    format!("The set has its final shape only after the last of {last} steps.")
                }
                Some(last) => format!("The set has its final shape after step {last} of {}.", steps.len()),
            };
            assert!(note.ends_with(&expected), "{}: {note}", lesson.name);
        }
    }
}
