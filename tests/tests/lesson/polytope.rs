//! Half-planes without readings: every word of the answer against definitions, by trying all vertices, pairs and triples.

use boundfit_lesson::{PolytopeOptions, polytope};
use boundfit_tests::cli::schema::check_schema;
use boundfit_tests::generate::{half_planes, seeded, share};
use boundfit_tests::oracle::{Answer, Row, solve};
use boundfit_tests::shape::Tally;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use rand::RngExt;
use serde_json::Value;

use crate::document::{count, items};

/// The keys that schema `boundfit/polytope/1` promises.
const POLYTOPE: &str = r#"{
  "schema": "text",
  "errors": [{"line": "count", "column": "count", "kind": "text", "message": "text"}],
  "half_planes": [{"line": "count", "number": "count", "side?": "text", "text": "text", "a": ["text", "text"], "b": "text",
    "redundant?": {"why": "text", "by": [{"half_plane": "count", "multiplier": "text"}], "slack?": "text"}}],
  "steps": [{"half_plane": "count", "set": {"kind": "text"}, "born": [["text", "text"]], "lost": [["text", "text"]],
    "redundant?": {"why": "text", "by": [{"half_plane": "count", "multiplier": "text"}], "slack?": "text"}}],
  "set?": {"kind": "text",
    "vertices": [{"theta": ["text", "text"], "active": ["count"], "cone": {"kind": "text", "generators": [["text", "text"]]}}],
    "rays": [["text", "text"]], "lines": [["text", "text"]], "boundaries": [["count"]],
    "contradiction?": {"by": [{"half_plane": "count", "multiplier": "text"}], "sum": "text"}, "area?": "text"},
  "objective?": {"form": ["text", "text"], "outcome": "text"},
  "simplex?": {"start": "count", "outcome": "text", "bases": [{"half_planes": ["count", "count"], "vertex?": "count",
    "theta": ["text", "text"], "value": "text", "multipliers": ["text", "text"],
    "pivot?": {"leaving": "count", "direction": ["text", "text"], "entering?": "count", "length?": "text", "degenerate": "flag"}}]}
}"#;

type Number = BigRational;
type Pair = [Number; 2];

fn whole(value: i128) -> Number {
    Number::from_integer(BigInt::from(value))
}

fn number(value: &Value) -> Number {
    value.as_str().unwrap().parse().unwrap()
}

fn pair(value: &Value) -> Pair {
    [number(&value[0]), number(&value[1])]
}

fn dot(u: &Pair, v: &Pair) -> Number {
    &u[0] * &v[0] + &u[1] * &v[1]
}

fn cross(u: &Pair, v: &Pair) -> Number {
    &u[0] * &v[1] - &u[1] * &v[0]
}

fn normal(row: &Row) -> Pair {
    [whole(row[0]), whole(row[1])]
}

fn point(triple: &[i128; 3]) -> Pair {
    [whole(triple[0]) / whole(triple[2]), whole(triple[1]) / whole(triple[2])]
}

fn slack(row: &Row, theta: &Pair) -> Number {
    whole(row[2]) - dot(&normal(row), theta)
}

fn inside(rows: &[Row], theta: &Pair) -> bool {
    rows.iter().all(|row| !slack(row, theta).is_negative())
}

/// Returns the sum of multiples of rows: a form and a right-hand side. Each multiple is positive.
fn sum(rows: &[Row], terms: &Value) -> (Pair, Number) {
    let mut total = ([whole(0), whole(0)], whole(0));
    for term in items(terms) {
        let (row, times) = (&rows[count(&term["half_plane"])], number(&term["multiplier"]));
        assert!(times.is_positive());
        let [a1, a2] = normal(row);
        total = ([&total.0[0] + a1 * &times, &total.0[1] + a2 * &times], &total.1 + whole(row[2]) * &times);
    }
    total
}

fn text_of(rows: &[Row]) -> String {
    rows.iter().map(|[a, b, c]| format!("{a}*x + {b}*y <= {c}\n")).collect()
}

#[test]
fn every_answer_agrees_with_the_definitions() {
    let mut rng = seeded(1808);
    let mut tally = Tally::default();
    for case in 0..share(2_500) {
        let rows = half_planes(&mut rng);
        let form = match rng.random_range(0..6) {
            0 => [0, 0],
            1..=3 => {
                let [a, b, _] = rows[rng.random_range(0..rows.len())];
                [a, b]
            }
            _ => [rng.random_range(-4..=4), rng.random_range(-4..=4)],
        };
        let vertices = solve(&rows).vertices.len();
        let start = (case % 3 == 0 && vertices > 0).then(|| rng.random_range(0..vertices));
        let options = PolytopeOptions { objective: Some(form.map(|c: i128| c.to_string())), start };
        let answer: Value = serde_json::from_str(&polytope(&text_of(&rows), &options).unwrap()).unwrap();
        if case % 10 == 0 {
            check_schema(&answer, POLYTOPE);
        }
        let form = form.map(whole);
        let truth = solve(&rows);
        tally.count(truth.kind);
        check_set(&rows, &truth, &answer["set"]);
        check_cones(&truth, &answer["set"], &mut tally);
        check_steps(&rows, &answer, &mut tally);
        check_redundant(&rows, &truth, &answer, &mut tally);
        let bound = check_objective(&rows, &truth, &form, &answer["objective"], &mut tally);
        check_path(&rows, &truth, &form, bound, &answer["simplex"], start, &mut tally);
    }
    tally.assert_each_kind(15);
    tally.assert_each(
        50,
        &["wedge", "half-plane of normals", "plane of normals", "cut", "dominated", "always"],
    );
    tally.assert_each(50, &["bounded", "unbounded", "unique", "several ways", "one way but not unique"]);
    tally.assert_each(50, &["vertex", "segment face", "ray face", "whole", "optimal", "path without end"]);
    tally.assert_each(50, &["degenerate pivot", "pivot", "same-as", "already-empty"]);
}

fn check_set(rows: &[Row], truth: &Answer, set: &Value) {
    assert_eq!(set["kind"], truth.kind, "{rows:?}");
    let found: Vec<(Pair, Vec<usize>)> = items(&set["vertices"])
        .map(|vertex| (pair(&vertex["theta"]), items(&vertex["active"]).map(count).collect()))
        .collect();
    let mut expected: Vec<(Pair, Vec<usize>)> =
        truth.vertices.iter().map(|(triple, active)| (point(triple), active.clone())).collect();
    assert_eq!(found.len(), expected.len(), "{rows:?}");
    expected.retain(|vertex| !found.contains(vertex));
    assert!(expected.is_empty(), "{rows:?}: {expected:?}");
    let directions = |value: &Value| -> Vec<Pair> { items(value).map(pair).collect() };
    for (found, expected) in [(&set["rays"], &truth.rays), (&set["lines"], &truth.lines)] {
        let found = directions(found);
        assert_eq!(found.len(), expected.len(), "{rows:?}");
        assert!(expected.iter().all(|d| found.contains(&d.map(whole))), "{rows:?}");
    }
    assert_eq!(set["contradiction"].is_null(), truth.kind != "empty");
    if truth.kind == "empty" {
        let (form, value) = sum(rows, &set["contradiction"]["by"]);
        assert!(form.iter().all(Zero::is_zero) && value.is_negative(), "{rows:?}");
        assert_eq!(number(&set["contradiction"]["sum"]), value);
    }
}

/// A direction is in the normal cone of a vertex exactly if no other vertex and no ray is better.
fn check_cones(truth: &Answer, set: &Value, tally: &mut Tally) {
    for vertex in items(&set["vertices"]) {
        let (theta, cone) = (pair(&vertex["theta"]), &vertex["cone"]);
        let ends: Vec<Pair> = items(&cone["generators"]).map(pair).collect();
        for (x, y) in (-3..=3).flat_map(|x| (-3..=3).map(move |y| (x, y))) {
            let form = [whole(x), whole(y)];
            let best =
                truth.vertices.iter().all(|(other, _)| dot(&form, &theta) >= dot(&form, &point(other)))
                    && truth.rays.iter().all(|ray| !dot(&form, &ray.map(whole)).is_positive());
            let within = match cone["kind"].as_str().unwrap() {
                "wedge" => !cross(&ends[0], &form).is_negative() && !cross(&form, &ends[1]).is_negative(),
                "half-plane" => !cross(&ends[0], &form).is_negative(),
                _ => ends.is_empty(),
            };
            assert_eq!(best, within, "{truth:?} {form:?} {cone}");
        }
        tally.count(match cone["kind"].as_str().unwrap() {
            "wedge" => "wedge",
            "half-plane" => "half-plane of normals",
            _ => "plane of normals",
        });
    }
}

fn check_steps(rows: &[Row], answer: &Value, tally: &mut Tally) {
    let mut before = solve(&[]);
    for (index, step) in items(&answer["steps"]).enumerate() {
        assert_eq!(count(&step["half_plane"]), index);
        let so_far = &rows[..=index];
        let after = solve(so_far);
        check_set(so_far, &after, &step["set"]);
        let missing_in = |one: &Answer, other: &Answer| -> Vec<Pair> {
            let others: Vec<[i128; 3]> = other.vertices.iter().map(|(triple, _)| *triple).collect();
            one.vertices
                .iter()
                .map(|(triple, _)| *triple)
                .filter(|own| !others.contains(own))
                .map(|own| point(&own))
                .collect()
        };
        for (key, mut expected) in
            [("born", missing_in(&after, &before)), ("lost", missing_in(&before, &after))]
        {
            let found: Vec<Pair> = items(&step[key]).map(pair).collect();
            assert_eq!(found.len(), expected.len(), "{rows:?} {key}");
            expected.retain(|point| !found.contains(point));
            assert!(expected.is_empty(), "{rows:?} {key}");
        }
        let places = |answer: &Answer| -> Vec<[i128; 3]> {
            answer.vertices.iter().map(|(triple, _)| *triple).collect()
        };
        let changed = before.kind != after.kind
            || places(&before) != places(&after)
            || before.rays != after.rays
            || (after.vertices.is_empty() && step["redundant"].is_null());
        assert_eq!(step["redundant"].is_null(), changed, "{so_far:?}");
        match step["redundant"]["why"].as_str() {
            Some("dominated") => {
                check_dominated(rows, index, &step["redundant"]);
                assert!(items(&step["redundant"]["by"]).all(|term| count(&term["half_plane"]) < index));
            }
            Some("always") => assert!(rows[index][..2] == [0, 0] && rows[index][2] >= 0),
            Some(why) => assert_eq!((why, before.kind), ("already-empty", "empty")),
            None => tally.count("cut"),
        }
        if step["redundant"]["why"] == "already-empty" {
            tally.count("already-empty");
        }
        before = after;
    }
}

/// Multiples of other half-planes add up to this one, with the slack to spare.
fn check_dominated(rows: &[Row], index: usize, redundant: &Value) {
    let (form, value) = sum(rows, &redundant["by"]);
    let slack = number(&redundant["slack"]);
    assert_eq!((form, value + &slack), (normal(&rows[index]), whole(rows[index][2])), "{rows:?} {index}");
    assert!(!slack.is_negative());
}

fn check_redundant(rows: &[Row], truth: &Answer, answer: &Value, tally: &mut Tally) {
    let mut kept: Vec<usize> = Vec::new();
    for (index, half_plane) in items(&answer["half_planes"]).enumerate() {
        assert_eq!((count(&half_plane["line"]), count(&half_plane["number"])), (index + 1, index + 1));
        assert_eq!(
            (pair(&half_plane["a"]), number(&half_plane["b"])),
            (normal(&rows[index]), whole(rows[index][2]))
        );
        let redundant = &half_plane["redundant"];
        match redundant["why"].as_str() {
            None => kept.push(index),
            Some("dominated") => {
                check_dominated(rows, index, redundant);
                tally.count("dominated");
            }
            Some("same-as") => {
                let other = &rows[count(&redundant["by"][0]["half_plane"])];
                let (f, g) = (normal(&rows[index]), normal(other));
                assert!(cross(&f, &g).is_zero() && dot(&f, &g).is_positive());
                let scale = if f[0].is_zero() { &f[1] / &g[1] } else { &f[0] / &g[0] };
                assert_eq!(whole(rows[index][2]), whole(other[2]) * scale);
                tally.count("same-as");
            }
            Some("always") => {
                assert!(rows[index][..2] == [0, 0] && rows[index][2] >= 0);
                tally.count("always");
            }
            Some(why) => assert_eq!((why, truth.kind), ("empty-without", "empty")),
        }
    }
    let set = |indices: &[usize]| -> (&'static str, Vec<[i128; 3]>, Vec<[i128; 2]>) {
        let own: Vec<Row> = indices.iter().map(|&index| rows[index]).collect();
        let answer = solve(&own);
        (
            answer.kind,
            answer.vertices.iter().map(|(triple, _)| *triple).collect(),
            answer.rays.into_iter().collect(),
        )
    };
    let all = set(&(0..rows.len()).collect::<Vec<_>>());
    assert_eq!(set(&kept), all, "{rows:?}");
    for index in &kept {
        let without: Vec<usize> = kept.iter().copied().filter(|other| other != index).collect();
        let (kind, vertices, rays) = set(&without);
        // A strip without one side may lack neither vertices nor, as a line, rays: the kind changes.
        assert!((kind, &vertices, &rays) != (all.0, &all.1, &all.2), "{rows:?} {index}");
    }
}

/// Checks the objective: the existence of a greatest value, and the value.
fn check_objective(
    rows: &[Row],
    truth: &Answer,
    form: &Pair,
    objective: &Value,
    tally: &mut Tally,
) -> Option<Number> {
    assert_eq!(pair(&objective["form"]), *form);
    let outcome = objective["outcome"].as_str().unwrap();
    assert_eq!(outcome == "empty", truth.kind == "empty");
    let along = |d: &[i128; 2]| dot(form, &d.map(whole));
    let grows = truth.rays.iter().any(|ray| along(ray).is_positive())
        || truth.lines.iter().any(|line| !along(line).is_zero());
    match outcome {
        "empty" => None,
        "unbounded" => {
            assert!(grows, "{rows:?} {form:?}");
            let (start, ray) = (pair(&objective["point"]), pair(&objective["ray"]));
            assert!(inside(rows, &start) && dot(form, &ray).is_positive());
            assert!(rows.iter().all(|row| !dot(&normal(row), &ray).is_positive()));
            tally.count("unbounded");
            None
        }
        _ => {
            assert!(!grows, "{rows:?} {form:?}");
            let value = number(&objective["value"]);
            assert_eq!(sum(rows, &objective["proof"]), (form.clone(), value.clone()), "{rows:?}");
            check_face(rows, truth, form, &value, &objective["face"], tally);
            check_ways(rows, form, &value, &objective["ways"], tally);
            tally.count("bounded");
            Some(value)
        }
    }
}

fn check_face(rows: &[Row], truth: &Answer, form: &Pair, value: &Number, face: &Value, tally: &mut Tally) {
    let points: Vec<Pair> = items(&face["points"]).map(pair).collect();
    assert!(points.iter().all(|point| inside(rows, point) && dot(form, point) == *value));
    let attaining = truth.vertices.iter().filter(|(triple, _)| dot(form, &point(triple)) == *value).count();
    let goes_on = truth.rays.iter().filter(|ray| dot(form, &ray.map(whole)).is_zero()).count();
    let expected = match (form.iter().all(Zero::is_zero), attaining, goes_on) {
        (true, _, _) => "whole",
        (_, 2, _) => "segment",
        (_, 1, 0) => "vertex",
        (_, 1, _) => "ray",
        _ => "line",
    };
    assert_eq!(face["kind"], expected, "{rows:?} {form:?}");
    if ["ray", "line"].contains(&expected) {
        let direction = pair(&face["direction"]);
        let recedes = |d: &Pair| rows.iter().all(|row| !dot(&normal(row), d).is_positive());
        assert!(recedes(&direction) && dot(form, &direction).is_zero());
    }
    tally.count(match expected {
        "segment" => "segment face",
        "ray" => "ray face",
        "line" => "line face",
        other => other,
    });
}

/// All rows and pairs of rows with positive multiples that add up to the objective and its value; other sums exist where rows add
/// up to `0 ≤ 0`.
fn check_ways(rows: &[Row], form: &Pair, value: &Number, ways: &Value, tally: &mut Tally) {
    let mut expected = usize::from(form.iter().all(Zero::is_zero));
    for (i, f) in rows.iter().enumerate() {
        let times = if f[0] != 0 {
            Some(&form[0] / whole(f[0]))
        } else {
            (f[1] != 0).then(|| &form[1] / whole(f[1]))
        };
        let single = times.filter(|t| t.is_positive() && cross(&normal(f), form).is_zero());
        expected += usize::from(single.is_some_and(|t| whole(f[2]) * t == *value));
        for g in &rows[i + 1..] {
            let determinant = cross(&normal(f), &normal(g));
            if determinant.is_zero() {
                continue;
            }
            let (s, t) = (cross(form, &normal(g)) / &determinant, cross(&normal(f), form) / &determinant);
            let is_proof =
                s.is_positive() && t.is_positive() && whole(f[2]) * &s + whole(g[2]) * &t == *value;
            expected += usize::from(is_proof);
        }
    }
    assert_eq!(count(&ways["count"]), expected, "{rows:?} {form:?}");
    assert_eq!(items(&ways["first"]).count(), expected.min(12));
    for way in items(&ways["first"]) {
        assert_eq!(sum(rows, way), (form.clone(), value.clone()), "{rows:?} {form:?}");
    }
    let is_unique = expected == 1 && !adds_up_to_nothing(rows);
    assert_eq!(ways["unique"], is_unique, "{rows:?} {form:?}");
    tally.count(match (is_unique, expected) {
        (true, _) => "unique",
        (false, 1) => "one way but not unique",
        _ => "several ways",
    });
}

/// Returns whether positive multiples of two or three rows with normals add up to `0 ≤ 0`.
fn adds_up_to_nothing(rows: &[Row]) -> bool {
    let det = |f: &Row, g: &Row| f[0] * g[1] - f[1] * g[0];
    let rows: Vec<&Row> = rows.iter().filter(|row| row[..2] != [0, 0]).collect();
    let opposite = |f: &Row, g: &Row| {
        let along = f[0] * g[0] + f[1] * g[1];
        det(f, g) == 0 && along < 0 && (f[0] * g[2] == g[0] * f[2] && f[1] * g[2] == g[1] * f[2])
    };
    for (i, f) in rows.iter().enumerate() {
        for (j, g) in rows.iter().enumerate().skip(i + 1) {
            if opposite(f, g) {
                return true;
            }
            for h in &rows[j + 1..] {
                let times = [det(g, h), det(h, f), det(f, g)];
                let one_sign = times.iter().all(|t| *t > 0) || times.iter().all(|t| *t < 0);
                if one_sign && times[0] * f[2] + times[1] * g[2] + times[2] * h[2] == 0 {
                    return true;
                }
            }
        }
    }
    false
}

/// Every basis is a vertex, every pivot follows Bland's rule, and the end is what the objective's support says.
fn check_path(
    rows: &[Row],
    truth: &Answer,
    form: &Pair,
    bound: Option<Number>,
    path: &Value,
    start: Option<usize>,
    tally: &mut Tally,
) {
    assert_eq!(path.is_null(), truth.vertices.is_empty(), "{rows:?}");
    if path.is_null() {
        return;
    }
    let bases: Vec<&Value> = items(&path["bases"]).collect();
    let least = truth.vertices.iter().map(|(triple, _)| dot(form, &point(triple))).min().unwrap();
    match start {
        Some(start) => assert_eq!(count(&path["start"]), start),
        None => assert_eq!(number(&bases[0]["value"]), least),
    }
    assert_eq!(bases[0]["vertex"], path["start"]);
    assert_eq!(path["outcome"], if bound.is_some() { "optimal" } else { "unbounded" }, "{rows:?}");
    for (at, basis) in bases.iter().enumerate() {
        let theta = pair(&basis["theta"]);
        let [one, other] = [0, 1].map(|k| count(&basis["half_planes"][k]));
        assert!(inside(rows, &theta) && truth.vertices.iter().any(|(triple, _)| point(triple) == theta));
        assert!([one, other].iter().all(|&index| slack(&rows[index], &theta).is_zero()));
        assert_eq!(number(&basis["value"]), dot(form, &theta));
        let times = pair(&basis["multipliers"]);
        let (f, g) = (normal(&rows[one]), normal(&rows[other]));
        assert_eq!([0, 1].map(|k| &f[k] * &times[0] + &g[k] * &times[1]), *form);
        let negative = [one, other].into_iter().zip(&times).filter(|(_, value)| value.is_negative());
        let leaves = negative.map(|(index, _)| index).min();
        let pivot = &basis["pivot"];
        assert_eq!(leaves, (!pivot.is_null()).then(|| count(&pivot["leaving"])));
        if pivot.is_null() {
            assert_eq!((at + 1, Some(number(&basis["value"]))), (bases.len(), bound.clone()), "{rows:?}");
            tally.count("optimal");
            continue;
        }
        let direction = pair(&pivot["direction"]);
        let mut stops: Vec<(Number, usize)> = Vec::new();
        for (index, row) in rows.iter().enumerate() {
            let approach = dot(&normal(row), &direction);
            if approach.is_positive() {
                stops.push((slack(row, &theta) / approach, index));
            }
        }
        let Some((length, entering)) = stops.into_iter().min() else {
            assert!(pivot["entering"].is_null() && pivot["length"].is_null() && at + 1 == bases.len());
            assert!(dot(form, &direction).is_positive() && bound.is_none());
            tally.count("path without end");
            continue;
        };
        assert_eq!(
            (count(&pivot["entering"]), number(&pivot["length"])),
            (entering, length.clone()),
            "{rows:?}"
        );
        assert_eq!(pivot["degenerate"], length.is_zero());
        let next = pair(&bases[at + 1]["theta"]);
        assert_eq!([0, 1].map(|k| &theta[k] + &direction[k] * &length), next);
        tally.count(if length.is_zero() { "degenerate pivot" } else { "pivot" });
    }
}

#[test]
fn lines_that_cannot_be_read_are_all_named_and_nothing_else_is_said() {
    let answer = polytope("x >= 0\nx < 1\n\n2x + + <= 1\n", &PolytopeOptions::default()).unwrap();
    let answer: Value = serde_json::from_str(&answer).unwrap();
    check_schema(&answer, POLYTOPE);
    let errors: Vec<(usize, &str)> = items(&answer["errors"])
        .map(|error| (count(&error["line"]), error["kind"].as_str().unwrap()))
        .collect();
    assert_eq!(errors, [(2, "strict"), (4, "not-a-term")]);
    assert!(answer["set"].is_null() && items(&answer["steps"]).next().is_none());
}

/// Any text of 4 kB is answered at once: the longest numbers that are allowed, on as many half-planes.
#[test]
fn the_longest_numbers_are_answered() {
    let long = |digit: char| digit.to_string().repeat(30);
    let text: String =
        (1..=60).map(|k| format!("{}x + {k}/{}y <= {}e30\n", long('7'), long('9'), k)).collect();
    let options = PolytopeOptions { objective: Some(["1e30".into(), "1/3".into()]), start: None };
    let answer: Value = serde_json::from_str(&polytope(&text, &options).unwrap()).unwrap();
    assert_eq!(
        (items(&answer["steps"]).count(), &answer["objective"]["outcome"]),
        (60, &Value::from("unbounded"))
    );
}
