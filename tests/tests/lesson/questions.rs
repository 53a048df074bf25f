//! Questions and answers: plain English for every kind of set, and the right numbers in it.

use std::collections::BTreeSet;

use boundfit_exact::{Rational, Rounding};
use boundfit_tests::cli::{directory_with, printed};
use boundfit_tests::shape::Tally;
use serde_json::{Value, json};

use crate::document::{
    Lesson, count, fixtures, generated, items, norris, steam_generator, strip, transducer,
};

/// The answer to a question, when it is asked.
pub fn answer<'a>(lesson: &'a Lesson, id: &str) -> Option<&'a str> {
    let question = items(&lesson.data["questions"]).find(|question| question["id"] == id)?;
    question["answer"].as_str()
}

pub fn asked<'a>(lesson: &'a Lesson, id: &str) -> &'a Value {
    items(&lesson.data["questions"]).find(|question| question["id"] == id).unwrap()
}

#[test]
fn there_are_six_to_ten_of_them_for_every_kind_of_set() {
    let mut tally = Tally::default();
    for lesson in fixtures().into_iter().chain(generated(51, 300)) {
        let questions = items(&lesson.data["questions"]);
        let ids: Vec<&str> = questions.clone().map(|question| question["id"].as_str().unwrap()).collect();
        assert!((6..=10).contains(&ids.len()), "{}: {ids:?}", lesson.name);
        assert_eq!(ids.iter().collect::<BTreeSet<_>>().len(), ids.len());
        for question in questions {
            check_text(question["question"].as_str().unwrap(), '?');
            check_text(question["answer"].as_str().unwrap(), '.');
            check_show(&lesson, &question["show"]);
        }
        tally.count(lesson.fit.fps.polyhedron().region().kind().name());
    }
    tally.assert_each_kind(1);
}

/// Whole sentences, and words in the number that belongs to them.
fn check_text(text: &str, end: char) {
    assert!(text.ends_with(end), "{text}");
    let first = text.chars().next().unwrap();
    assert!(!first.is_lowercase() || text.starts_with("ε = ") || text.starts_with("s = "), "{text}");
    for wrong in ["  ", "{", "}", "..", " ,", "one readings", " 1 readings", "of the 1 ", "None.", "()"] {
        assert!(!text.contains(wrong), "{wrong:?} in {text}");
    }
    // The text after a full stop begins with a capital letter, a number, a symbol or the name of a solver.
    for rest in text.split(". ").skip(1) {
        let is_solver = ["microlp", "clarabel", "highs"].iter().any(|name| rest.starts_with(name));
        assert!(is_solver || !rest.starts_with(|letter: char| letter.is_ascii_lowercase()), "{text}");
    }
    for (place, plural) in text.match_indices("readings ") {
        let rest = &text[place + plural.len()..];
        let after = rest.trim_start_matches(|letter: char| letter.is_ascii_digit());
        let is_list = after.len() < rest.len();
        assert!(!is_list || after.starts_with(", ") || after.starts_with(" and "), "{text}");
    }
}

fn check_show(lesson: &Lesson, show: &Value) {
    match show["kind"].as_str() {
        None => assert!(show.is_null()),
        Some("vertex") => {
            assert!(count(&show["index"]) < lesson.data["fit"]["fps"]["vertices"].as_array().unwrap().len())
        }
        Some("row") => assert!(items(&lesson.data["readings"]).any(|reading| reading["row"] == show["row"])),
        Some("layer") => assert!(
            ["least-squares", "central", "minimax", "pui", "directions", "lp"]
                .contains(&show["layer"].as_str().unwrap())
        ),
        Some(other) => panic!("{other}"),
    }
}

#[test]
fn the_transducer_s_answers_are_the_published_facts() {
    let lesson = transducer();
    let expected = [
        (
            "least-squares-feasible",
            "No. It violates one of the 46 bounds: the upper bound of reading 34, by 1.9411e−5 (exactly 296347633/15267741286000).",
        ),
        (
            "upper-end-theta1",
            "Readings 21 and 34. 5000/37871 times the lower bound of reading 21 plus 5000/37871 times the upper bound of reading 34 gives θ₁ ≤ 0.0018484 (exactly 70/37871), so that no feasible θ₁ is larger, and a vertex of the set attains it.",
        ),
        (
            "how-many-matter",
            "Six: the upper bound of reading 14, the lower bound of reading 21, the lower bound of reading 23, the lower bound of reading 24, the upper bound of reading 34 and the lower bound of reading 36.",
        ),
        (
            "remove-a-reading-that-matters",
            "The set is then a polygon with seven vertices, and its area grows from 6.4820e−9",
        ),
        ("smallest-error-bound", "ε = 0.00039444 (exactly 791/2005400). Readings 14, 24 and 34 fix it"),
        (
            "central-or-least-squares",
            "The central estimate guarantees θ₁ = 0.001819636 ± 0.000028745 and θ₂ = 0.02270164 ± 0.00010578, least squares θ₁ = 0.001819424 ± 0.000028957 and θ₂ = 0.02279063 ± 0.00019476.",
        ),
        ("box-full", "53.301 % of its area; the rest are parameter pairs that some reading rules out"),
        ("inner-or-outer", "An inner one."),
    ];
    for (id, part) in expected {
        let text = answer(&lesson, id).unwrap();
        assert!(text.contains(part), "{id}: {text}");
    }
    let slack = lesson.fit.least_squares_slack().unwrap().0;
    assert_eq!(slack.to_string(), "-296347633/15267741286000");
    assert_eq!(
        asked(&lesson, "upper-end-theta1")["question"],
        "Which two readings fix the largest feasible θ₁?"
    );
    assert_eq!(asked(&lesson, "upper-end-theta1")["show"], json!({"kind": "vertex", "index": 4}));
    assert_eq!(asked(&lesson, "remove-a-reading-that-matters")["show"], json!({"kind": "row", "row": 14}));
}

#[test]
fn answers_know_conditions_empty_and_unbounded_sets() {
    let steam = steam_generator();
    assert!(
        asked(&steam, "how-many-matter")["question"]
            .as_str()
            .unwrap()
            .starts_with("Three readings and one condition give seven half-planes.")
    );
    assert!(answer(&steam, "least-squares-feasible").unwrap().starts_with("Yes. "));
    assert!(answer(&steam, "smallest-error-bound").unwrap().starts_with("s = "));
    let norris = norris();
    assert!(
        answer(&norris, "least-squares-feasible").unwrap().ends_with("the feasible parameter set is empty.")
    );
    assert!(answer(&norris, "why-empty").unwrap().starts_with("Three bounds contradict each other."));
    assert!(answer(&norris, "upper-end-theta1").is_none());
    let strip = strip();
    assert!(
        answer(&strip, "least-squares-feasible")
            .unwrap()
            .starts_with("There is no single least-squares estimate")
    );
    assert!(answer(&strip, "upper-end-theta1").unwrap().starts_with("As large as you like."));
    assert!(answer(&strip, "directions-without-end").unwrap().contains("a strip between two parallel lines"));
}

#[test]
fn answers_agree_with_the_engine() {
    let mut tally = Tally::default();
    for lesson in fixtures().into_iter().chain(generated(52, 300)) {
        let what = &lesson.name;
        let region = lesson.fit.fps.polyhedron().region();
        match lesson.fit.least_squares_slack() {
            None => {
                assert!(answer(&lesson, "least-squares-feasible").unwrap().starts_with("There is no single"))
            }
            Some((slack, _)) => {
                let yes = answer(&lesson, "least-squares-feasible").unwrap().starts_with("Yes");
                assert_eq!(yes, !slack.is_negative(), "{what}");
                tally.count(if yes { "feasible" } else { "infeasible" });
            }
        }
        let least = lesson
            .fit
            .minimax
            .as_ref()
            .map(|minimax| minimax.least.to_decimal(5, Rounding::Up).replace('-', "−"));
        let text = answer(&lesson, "smallest-error-bound").unwrap();
        match least {
            None => assert!(text.starts_with("There is none"), "{what}"),
            Some(least) => {
                let starts = ["ε", "s"].map(|symbol| format!("{symbol} = {least}"));
                assert!(starts.iter().any(|start| text.starts_with(start)), "{what}: {text}");
            }
        }
        assert_eq!(answer(&lesson, "why-empty").is_some(), region.is_empty(), "{what}");
        assert_eq!(answer(&lesson, "directions-without-end").is_some(), !region.is_bounded(), "{what}");
        for (id, matters) in
            [("remove-a-reading-that-matters", true), ("remove-a-reading-that-does-not-matter", false)]
        {
            let of_kind = |without: &&Value| without["matters"] == matters;
            let rows: Vec<&Value> =
                items(&lesson.data["leave_one_out"]).filter(of_kind).map(|without| &without["row"]).collect();
            assert_eq!(answer(&lesson, id).is_some(), !rows.is_empty(), "{what}");
            if let Some(text) = answer(&lesson, id) {
                assert!(rows.contains(&&asked(&lesson, id)["show"]["row"]), "{what}");
                assert_eq!(text.starts_with("Nothing"), !matters, "{what}: {text}");
                tally.count(if matters { "matters" } else { "does not" });
            }
        }
        let needed = items(&lesson.data["half_planes"]).filter(|h| h["irredundant"] == true).count();
        let text = answer(&lesson, "how-many-matter").unwrap();
        let start = match needed {
            0 => "None: ".to_owned(),
            _ if needed == lesson.system().len() => "All of them: ".to_owned(),
            1 => "One: ".to_owned(),
            4 => "Four: ".to_owned(),
            11.. => format!("{needed}: "),
            _ => String::new(),
        };
        assert!(text.starts_with(&start), "{what}: {text}");
        if let Some(tightness) = lesson.fit.tightness().filter(|t| t.is_positive() && *t < Rational::one()) {
            let percent = (tightness * Rational::from(100)).to_decimal(5, Rounding::Down).replace('-', "−");
            assert!(answer(&lesson, "box-full").unwrap().starts_with(&format!("{percent} % ")), "{what}");
            tally.count("box");
        }
    }
    tally.assert_each(10, &["feasible", "infeasible", "matters", "does not", "box"]);
}

#[test]
fn why_there_is_no_least_squares_estimate_is_the_true_reason() {
    let folder = directory_with(&[("one-sided.csv", b"x,lo,hi\n0,0,1\n1,1,\n2,,4\n3,2.5,5\n")]);
    let page = printed(folder.path(), "lesson one-sided.csv --x x --lower lo --upper hi");
    let answer = "There is no single least-squares estimate to ask about: no column of y was given, \
        and a reading with one bound only has no middle to take instead.";
    assert!(page.contains(answer));
}

#[test]
fn only_readings_with_two_bounds_are_met_exactly() {
    let folder = directory_with(&[
        ("some.csv", b"x,lo,hi\n1,1,\n2,1.5,2.5\n3,,3.5\n4,3,5\n"),
        ("both.csv", b"x,lo,hi\n2,1.5,2.5\n4,3,5\n"),
    ]);
    let page = |file: &str| printed(folder.path(), &format!("lesson {file} --x x --lower lo --upper hi"));
    let open =
        "passes exactly through every reading with two bounds and keeps every single bound, so nothing";
    let closed = "passes exactly through every reading, so nothing";
    for (file, said, unsaid) in [("some.csv", open, closed), ("both.csv", closed, open)] {
        let page = page(file);
        assert!(page.contains(said) && !page.contains(unsaid), "{file}");
    }
}
