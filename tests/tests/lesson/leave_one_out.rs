//! The set without a reading against a fit that never had it.

use boundfit_estimation::{Problem, fit};
use boundfit_exact::{Endpoint, Rational};
use boundfit_tests::readings::with_rows;
use boundfit_tests::shape::{Tally, shape};
use serde_json::Value;

use crate::document::{Lesson, count, fixtures, generated, items, transducer};
use boundfit_tests::cli::numbers::{exact, exact_or_null};
use boundfit_tests::cli::{directory_with, fixture, report};

#[test]
fn each_set_is_that_of_a_fit_without_the_reading() {
    let mut tally = Tally::default();
    for lesson in fixtures().into_iter().chain(generated(41, 200)) {
        let rows = lesson.problem.measurements.kept();
        assert_eq!(items(&lesson.data["leave_one_out"]).count(), rows.len());
        for (position, without) in items(&lesson.data["leave_one_out"]).enumerate() {
            let mut rest = rows.to_vec();
            assert_eq!(count(&without["row"]), rest.remove(position).row);
            check(&lesson, without, &with_rows(&lesson.problem, rest), &mut tally);
        }
    }
    tally.assert_each_kind(3);
    tally.assert_each(10, &["matters", "does not", "moved", "lost", "no longer empty"]);
}

fn check(lesson: &Lesson, without: &Value, rest: &Problem, tally: &mut Tally) {
    let what = format!("{} without {}", lesson.name, without["row"]);
    let fresh = fit(rest);
    let (before, after) = (lesson.fit.fps.polyhedron().region(), fresh.fps.polyhedron().region());
    assert_eq!(lesson.shape(without), shape(after), "{what}");
    assert_eq!(without["matters"], shape(before) != shape(after), "{what}");
    tally.count(after.kind().name());
    tally.count(if without["matters"] == true { "matters" } else { "does not" });
    let intervals = fresh.pui_intervals();
    assert_eq!(without["pui"].is_null(), intervals.is_none(), "{what}");
    let mut expected = Vec::new();
    for (axis, interval) in intervals.iter().flatten().enumerate() {
        for (key, name) in [("lower", "lower"), ("upper", "upper")] {
            let of = |interval: &boundfit_exact::Interval| -> Endpoint {
                if key == "lower" { interval.lower().clone() } else { interval.upper().clone() }
            };
            let new = of(interval).value().cloned();
            assert_eq!(exact_or_null(&without["pui"][axis][key]), new, "{what}");
            let Some(before) = lesson.fit.pui_intervals() else {
                tally.count("no longer empty");
                continue;
            };
            if let Some(old) = of(&before[axis]).value().filter(|old| Some(*old) != new.as_ref()) {
                let by = new.map(|new| if key == "lower" { old - new } else { new - old });
                assert!(by.as_ref().is_none_or(Rational::is_positive), "{what}");
                tally.count(if by.is_some() { "moved" } else { "lost" });
                expected.push((["theta1", "theta2"][axis], name, by));
            }
        }
    }
    let moved: Vec<_> = items(&without["moved"])
        .map(|m| (m["parameter"].as_str().unwrap(), m["end"].as_str().unwrap(), exact_or_null(&m["by"])))
        .collect();
    assert_eq!(moved, expected, "{what}");
}

#[test]
fn the_program_says_the_same_about_a_file_without_the_row() {
    let lesson = transducer();
    let table = fixture("transducer/transducer.csv");
    for without in items(&lesson.data["leave_one_out"]).step_by(4) {
        let row = count(&without["row"]);
        let shorter: String = table
            .lines()
            .enumerate()
            .filter(|(line, _)| *line != row)
            .map(|(_, line)| format!("{line}\n"))
            .collect();
        let directory = directory_with(&[("data.csv", shorter.as_bytes())]);
        let line = "fit data.csv --x Vz --y z --rows 14..35 --eps 0.5e-3";
        let report = report(directory.path(), line, b"");
        for axis in 0..2 {
            for end in ["lower", "upper"] {
                let fresh = &report["pui"][axis][end];
                assert_eq!(exact(&without["pui"][axis][end]), exact(fresh), "without {row}");
            }
        }
        assert_eq!(report["fps"]["kind"], without["kind"]);
    }
}

#[test]
fn six_of_the_transducer_s_readings_matter() {
    let data = transducer().data;
    let mattering = items(&data["leave_one_out"]).filter(|without| without["matters"] == true);
    assert_eq!(mattering.map(|without| count(&without["row"])).collect::<Vec<_>>(), [14, 21, 23, 24, 34, 36]);
}
