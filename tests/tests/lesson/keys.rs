//! The keys of the data, their types, and what belongs together.

use std::collections::BTreeSet;

use boundfit_exact::{Rational, Rounding};
use boundfit_geometry::Polyhedron;
use boundfit_tests::generate::seeded;
use boundfit_tests::readings::{in_intervals, problem as random_problem, y_and_epsilon};
use boundfit_tests::shape::{shape, subsystem};
use serde_json::Value;

use crate::document::{Lesson, count, fixtures, generated, items, steam_generator, transducer};
use boundfit_tests::cli::numbers::{exact, pair, rational};
use boundfit_tests::cli::schema::check_schema;

/// The keys that schema `boundfit/lesson/3` promises; the fit has a schema of its own.
const LESSON: &str = r#"{
  "schema": "text", "title": "text", "is_default_title": "flag", "file": "text", "units": {"x?": "text", "y?": "text", "theta1?": "text", "theta2?": "text"},
  "model": {"kind": "text", "y": "text"},
  "epsilon": {"uniform?": "number", "column?": "text"},
  "reading": "text",
  "readings": [{"row": "count", "phi": ["number", "number"], "y": "number",
    "[epsilon]": "number", "[middle]": "number", "[lower]": "number", "[upper]": "number", "[cells]": ["text"]}],
  "others": [{"row": "count", "phi": ["number", "number"], "y": "number", "[cells]": ["text"]}],
  "conditions": [{"number": "count", "text": "text"}],
  "half_planes": [{"name": {"row?": "count", "bound": "text"}, "a": ["text", "text"], "b": "text", "irredundant": "flag"}],
  "points": [["number", "number"]],
  "corridor?": {
    "upper": {"from?": "text", "to?": "text", "nowhere": "flag", "lines": ["count"], "breakpoints": ["text"]},
    "lower": {"from?": "text", "to?": "text", "nowhere": "flag", "lines": ["count"], "breakpoints": ["text"]}},
  "orders": [{"id": "text", "name": "text", "note": "text", "steps": [{
    "half_plane": "count", "kind": "text", "vertices": ["count"], "rays": [["text", "text"]], "lines": [["text", "text"]],
    "boundaries": ["count"], "born": ["count"], "lost": ["count"],
    "redundant?": {"why": "text", "by": [{"half_plane": "count", "multiplier": "number"}], "slack?": "number"}}]}],
  "sweep": {"least?": "number", "vertices": [[{"constant": "text", "slope": "text"}, {"constant": "text", "slope": "text"}]],
    "breakpoints": [{"s": "number", "epsilon?": "number", "kind": "text", "vertices": ["count"],
      "pui?": [{"lower?": "number", "upper?": "number"}, {"lower?": "number", "upper?": "number"}], "area?": "number",
      "entering": [{"row?": "count", "bound": "text"}], "leaving": [{"row?": "count", "bound": "text"}]}],
    "pieces": [{"from": "number", "to": "number", "kind": "text", "vertices": ["count"]}]},
  "layers": {
    "directions": {"count": "count", "inner?": ["count"], "outer?": ["count"], "inner_area?": "number", "outer_area?": "number"},
    "lp": [{"source": "text", "reading": "text", "claims": [{"parameter": "text", "end": "text", "verdict": "text",
      "claimed?": "number", "point?": ["number", "number"], "reason?": "text"}]}]},
  "leave_one_out": [{"row": "count", "matters": "flag", "kind": "text", "vertices": ["count"], "rays": [["text", "text"]],
    "lines": [["text", "text"]], "boundaries": ["count"],
    "pui?": [{"lower?": "number", "upper?": "number"}, {"lower?": "number", "upper?": "number"}],
    "moved": [{"parameter": "text", "end": "text", "by?": "number"}]}],
  "outliers?": {"least": "count", "ways": [["count"]], "complete": "flag"},
  "questions": [{"id": "text", "question": "text", "answer": "text", "show?": {"kind": "text"}}]
}"#;

#[test]
fn every_promised_key_is_there_with_its_type() {
    for lesson in fixtures().into_iter().chain(generated(1, 60)).chain(with_intervals(7, 30)) {
        check_schema(&lesson.data, LESSON);
        assert_eq!(lesson.data["schema"], "boundfit/lesson/3");
    }
}

/// Generated fits of readings that are intervals.
pub(crate) fn with_intervals(seed: u64, count: usize) -> Vec<Lesson> {
    let mut rng = seeded(seed);
    let lesson = |number: usize| {
        let problem = in_intervals(&random_problem(&mut rng), &mut rng);
        Lesson::of(&format!("seed {seed}, {number}"), problem)
    };
    (0..count).map(lesson).collect()
}

/// The bounds that grow are told by a distance from their middle, and the middle where it is not y; the others as they are.
#[test]
fn readings_say_where_their_bounds_are() {
    let mut seen = BTreeSet::new();
    for lesson in with_intervals(8, 40) {
        let rows = lesson.problem.measurements.kept();
        assert_eq!(items(&lesson.data["readings"]).count(), rows.len());
        for (row, reading) in rows.iter().zip(items(&lesson.data["readings"])) {
            let told = |key: &str| reading.get(key).map(exact);
            let (lower, upper) = match (told("epsilon"), told("middle")) {
                (Some(epsilon), middle) => {
                    assert_eq!((told("lower"), told("upper")), (None, None), "{}", lesson.name);
                    assert_ne!(middle, told("y"), "{}", lesson.name);
                    let middle = middle.unwrap_or_else(|| exact(&reading["y"]));
                    (Some(&middle - &epsilon), Some(&middle + &epsilon))
                }
                (None, middle) => {
                    assert_eq!(middle, None, "{}", lesson.name);
                    (told("lower"), told("upper"))
                }
            };
            assert_eq!((lower, upper), (row.lower(), row.upper()), "{}, row {}", lesson.name, row.row);
            let keys = ["epsilon", "middle", "lower", "upper"];
            seen.insert(keys.map(|key| reading.get(key).is_some()));
        }
    }
    let [yes, no] = [true, false];
    let kinds =
        [[yes, no, no, no], [yes, yes, no, no], [no, no, yes, no], [no, no, no, yes], [no, no, yes, yes]];
    assert_eq!(seen, kinds.into());
}

#[test]
fn readings_and_half_planes_are_those_of_the_fit() {
    for lesson in fixtures().into_iter().chain(generated(2, 60)) {
        let Lesson { problem, fit, data, name } = &lesson;
        // The page shows all half-planes, also those that a fit does without.
        let fit = fit.with_every_half_plane(problem);
        let rows = problem.measurements.kept();
        for (row, reading) in rows.iter().zip(items(&data["readings"])) {
            assert_eq!(count(&reading["row"]), row.row);
            assert_eq!(pair(&reading["phi"]), row.regressor);
            assert_eq!(
                (exact(&reading["y"]), exact(&reading["epsilon"])),
                (y_and_epsilon(row).0.clone(), y_and_epsilon(row).1.clone())
            );
        }
        assert_eq!(items(&data["readings"]).count(), rows.len());
        assert_eq!(&lesson.system(), fit.fps.polyhedron().system(), "{name}");
        for (index, half_plane) in items(&data["half_planes"]).enumerate() {
            let bound = match count_or_null(&half_plane["name"]["row"]) {
                Some(row) => format!("{row} {}", half_plane["name"]["bound"].as_str().unwrap()),
                None => half_plane["name"]["bound"].as_str().unwrap().to_owned(),
            };
            assert_eq!(bound, fit.fps.name(index).to_string(), "{name}");
            if index < 2 * rows.len() {
                assert_eq!(count(&half_plane["name"]["row"]), rows[index / 2].row);
                assert_eq!(half_plane["name"]["bound"], if index % 2 == 0 { "upper" } else { "lower" });
            }
        }
    }
}

fn count_or_null(value: &Value) -> Option<usize> {
    (!value.is_null()).then(|| count(value))
}

#[test]
fn the_irredundant_half_planes_are_enough_and_none_of_them_is_idle() {
    for lesson in fixtures().into_iter().chain(generated(3, 150)) {
        let marked = items(&lesson.data["half_planes"]).enumerate().filter(|(_, h)| h["irredundant"] == true);
        let kept: Vec<usize> = marked.map(|(index, _)| index).collect();
        let all = shape(lesson.fit.fps.polyhedron().region());
        let of =
            |indices: &[usize]| shape(Polyhedron::intersect(subsystem(&lesson.system(), indices)).region());
        assert_eq!(of(&kept), all, "{}", lesson.name);
        for skipped in 0..kept.len() {
            let mut fewer = kept.clone();
            fewer.remove(skipped);
            assert_ne!(of(&fewer), all, "{}: {skipped} of {kept:?}", lesson.name);
        }
    }
}

#[test]
fn every_point_is_there_once() {
    for lesson in fixtures().into_iter().chain(generated(4, 30)) {
        let mut seen = BTreeSet::new();
        for point in items(&lesson.data["points"]) {
            assert!(seen.insert([0, 1].map(|axis| point[axis]["exact"].as_str().unwrap().to_owned())));
        }
    }
}

#[test]
fn decimals_tell_the_ends_of_narrow_intervals_apart() {
    for lesson in fixtures() {
        let pui = lesson.fit.pui_intervals();
        for without in items(&lesson.data["leave_one_out"]) {
            for axis in 0..2 {
                let (lower, upper) = (&without["pui"][axis]["lower"], &without["pui"][axis]["upper"]);
                let is_wide = pui.as_ref().is_some_and(|pui| pui[axis].width() > Some(Rational::zero()));
                if is_wide && lower.is_object() && upper.is_object() {
                    assert_ne!(lower["decimal"], upper["decimal"], "{}", lesson.name);
                    assert!(rational(lower["decimal"].as_str().unwrap()) <= exact(lower));
                    assert!(rational(upper["decimal"].as_str().unwrap()) >= exact(upper));
                }
            }
        }
    }
}

#[test]
fn decimals_tell_the_ends_of_narrow_sets_apart() {
    let mut narrow = 0;
    for lesson in fixtures() {
        let order = &lesson.data["orders"][0];
        let vertices: Vec<&Value> = items(&items(&order["steps"]).last().unwrap()["vertices"])
            .map(|index| &lesson.data["points"][count(index)])
            .collect();
        for axis in 0..2 {
            let of_axis = || vertices.iter().map(|point| &point[axis]);
            let (Some(least), Some(most)) =
                (of_axis().min_by_key(|n| exact(n)), of_axis().max_by_key(|n| exact(n)))
            else {
                continue;
            };
            if exact(least) != exact(most) {
                assert_ne!(least["decimal"], most["decimal"], "{}", lesson.name);
                let five = |number: &Value| exact(number).to_decimal(5, Rounding::Nearest);
                narrow += usize::from(five(least) == five(most));
            }
        }
    }
    assert!(narrow > 0, "five digits would do for all");
}

#[test]
fn units_models_and_conditions_are_told() {
    let data = steam_generator().data;
    assert_eq!(data["model"], serde_json::json!({"kind": "line", "x": "x", "y": "y"}));
    assert_eq!(data["epsilon"], serde_json::json!({"uniform": null, "column": "eps"}));
    assert_eq!(data["conditions"], serde_json::json!([{"number": 1, "text": "theta1 >= 0"}]));
    let data = transducer().data;
    assert_eq!(data["epsilon"]["uniform"], serde_json::json!({"exact": "1/2000", "decimal": "0.0005"}));
    assert_eq!(items(&data["others"]).count(), 23);
    assert!(items(&data["others"]).all(|other| other.get("epsilon").is_none()));
    let two =
        generated(5, 30).into_iter().find(|lesson| lesson.data["model"]["kind"] == "two-regressors").unwrap();
    assert_eq!(
        two.data["model"],
        serde_json::json!({"kind": "two-regressors", "regressors": ["u", "v"], "y": "y"})
    );
    assert!(two.data["corridor"].is_null());
}
