//! The claims of answers, recomputed from the text: reasons for rows that change nothing, emptiness by conditions,
//! optimisers.

use std::collections::BTreeSet;

use boundfit_check::ProgramRows;
use boundfit_estimation::{Condition, EpsilonColumn, Problem};
use boundfit_exact::Rational;
use boundfit_geometry::{Inequality, Polyhedron};
use boundfit_lp::{ExactOutcome, Program, exact_simplex, spread_objectives};
use boundfit_tests::readings::parse_condition;
use boundfit_tests::shape::Tally;
use serde_json::Value;

use crate::document::{Lesson, fixtures, generated, items, read};
use crate::questions::{answer, asked};
use boundfit_tests::cli::numbers::rational;

/// Readings of a fixture under a uniform error bound and conditions.
fn figure(file: &str, epsilon: Rational, conditions: &[&str]) -> Lesson {
    let problem = read(&format!("figures/{file}"), ["x", "y"], EpsilonColumn::Uniform(epsilon), None);
    let conditions = conditions.iter().map(|text| parse_condition(text)).collect();
    Lesson::of(file, Problem { conditions, ..problem })
}

/// The half-plane with a name in a sentence, and its index.
fn named(lesson: &Lesson, name: &str) -> usize {
    let is_named = |half_plane: &Value| {
        let (row, bound) = (&half_plane["name"]["row"], half_plane["name"]["bound"].as_str().unwrap());
        match bound.strip_prefix("where:") {
            Some(name_of_condition) => {
                let (number, side) = name_of_condition.split_once(' ').unwrap_or((name_of_condition, ""));
                let number: usize = number.parse().unwrap();
                let of = match side {
                    "upper" => "the side ≤ of the",
                    "lower" => "the side ≥ of the",
                    _ => "the",
                };
                name == format!("{of} condition {}", lesson.problem.conditions[number - 1].text())
            }
            None => name == format!("the {bound} bound of reading {row}"),
        }
    };
    items(&lesson.data["half_planes"]).position(is_named).unwrap_or_else(|| panic!("{name}"))
}

/// A sum of half-planes as a sentence has it; `None` when a multiplier is too long to be exact there.
fn sum(lesson: &Lesson, text: &str) -> Option<(Inequality, Vec<usize>)> {
    let system = lesson.system();
    let mut total = [Rational::zero(), Rational::zero(), Rational::zero()];
    let mut indices = Vec::new();
    for term in text.split(" plus ") {
        let (times, name) = term.split_once(" times ").unwrap_or(("1", term));
        if times.starts_with("about") {
            return None;
        }
        let index = named(lesson, name);
        let Inequality { a: [a1, a2], b } = &system.inequalities()[index];
        let times = rational(times);
        assert!(times.is_positive());
        let [t1, t2, t3] = total;
        total = [t1 + a1 * &times, t2 + a2 * &times, t3 + b * &times];
        indices.push(index);
    }
    let [a1, a2, b] = total;
    Some((Inequality::new(a1, a2, b), indices))
}

#[test]
fn reasons_imply_the_bounds_that_change_nothing() {
    let mut tally = Tally::default();
    let on_a_line = figure("on-a-line.csv", Rational::zero(), &[]);
    for lesson in [on_a_line].into_iter().chain(fixtures()).chain(generated(61, 400)) {
        let Some(text) = answer(&lesson, "remove-a-reading-that-does-not-matter") else { continue };
        let row = &asked(&lesson, "remove-a-reading-that-does-not-matter")["show"]["row"];
        if lesson.fit.fps.polyhedron().region().is_empty() {
            assert!(text.starts_with("Nothing: the set is empty without it too, because "), "{text}");
            continue;
        }
        for which in ["upper", "lower"] {
            let own = named(&lesson, &format!("the {which} bound of reading {row}"));
            let system = lesson.system();
            let own = &system.inequalities()[own];
            let start = format!(" Its {which} bound ");
            let (_, reason) = text.split_once(&start).unwrap_or_else(|| panic!("{}: {text}", lesson.name));
            let reason = reason.split(". Its ").next().unwrap().trim_end_matches('.');
            if reason == "holds for every θ" {
                assert!(own.a.iter().all(Rational::is_zero) && !own.b.is_negative());
                tally.count("always");
            } else if let Some(name) = reason.strip_prefix("is the same half-plane as ") {
                assert!(!name.ends_with(&format!("of reading {row}")), "{text}");
                let other = &system.constraints()[named(&lesson, name)];
                assert_eq!(*other, own.constraint(), "{text}");
                tally.count("same");
            } else {
                let (terms, spare) =
                    reason.strip_prefix("follows from ").unwrap().rsplit_once(", with ").unwrap();
                let Some((implied, indices)) = sum(&lesson, terms) else { continue };
                assert_eq!(implied.a, own.a, "{}: {text}", lesson.name);
                let slack = &own.b - &implied.b;
                assert!(!slack.is_negative(), "{}: {text}", lesson.name);
                assert_eq!(slack.is_zero(), spare.starts_with("nothing to spare"), "{text}");
                let rows = indices.iter().map(|&index| &lesson.data["half_planes"][index]["name"]["row"]);
                assert!(rows.into_iter().all(|other| other != row), "{text}");
                tally.count("follows");
            }
        }
    }
    tally.assert_each(10, &["always", "same", "follows"]);
}

#[test]
fn emptiness_has_its_true_cause() {
    let epsilon = || Rational::ratio(1, 10);
    let conditions = figure("two-readings.csv", epsilon(), &["theta1>=1", "theta1<=0"]);
    let impossible = figure("two-readings.csv", epsilon(), &["0*theta1>=1"]);
    let both = figure("two-readings.csv", epsilon(), &["theta1>=10"]);
    let readings = figure("contradicting.csv", Rational::ratio(1, 2), &["theta1>=-5"]);
    for (lesson, why, least, without) in [
        (
            &conditions,
            "The conditions contradict each other, whatever the readings are. As inequalities in θ, the condition theta1>=1 plus the condition theta1<=0 add up to 0 ≤ −1, which is false for every θ.",
            "There is none: the conditions contradict each other, however large ε is.",
            Some("Nothing: the set is empty without it too, because the conditions contradict each other."),
        ),
        (
            &impossible,
            "Condition 1 (0*theta1>=1) can never hold: it says 0 ≤ −1, whatever θ is.",
            "There is none: condition 1 (0*theta1>=1) can never hold, however large ε is.",
            Some(
                "Nothing: the set is empty without it too, because condition 1 (0*theta1>=1) can never hold.",
            ),
        ),
        (
            &both,
            "Two bounds and one condition contradict each other. ",
            "ε = 4.75. Readings 1 and 2 and the condition theta1>=10 fix it",
            None,
        ),
        (
            &readings,
            "Three bounds contradict each other. ",
            "ε = 1. Readings 1, 2 and 3 fix it",
            Some(
                "Nothing: the set is empty without it too, because the upper bound of reading 1, the lower bound of reading 2 and the upper bound of reading 3 contradict each other.",
            ),
        ),
    ] {
        assert!(answer(lesson, "why-empty").unwrap().starts_with(why), "{:?}", answer(lesson, "why-empty"));
        assert!(answer(lesson, "smallest-error-bound").unwrap().starts_with(least));
        assert_eq!(answer(lesson, "remove-a-reading-that-does-not-matter"), without);
    }
    let needed = |lesson: &Lesson| answer(lesson, "how-many-matter").unwrap().to_owned();
    assert!(needed(&conditions).starts_with("Two: the condition theta1>=1 and the condition theta1<=0. "));
    assert!(needed(&impossible).starts_with("One: the condition 0*theta1>=1. "));
    assert!(answer(&impossible, "least-squares-feasible").unwrap().starts_with(
        "No. It violates one of the five bounds and conditions: the condition 0*theta1>=1, by 1. "
    ));
}

#[test]
fn causes_of_emptiness_agree_with_the_parts_of_the_problem() {
    let mut tally = Tally::default();
    let extra = ["0*theta1>=1", "theta1>=1", "theta1<=0", "theta1+theta2<=-1"];
    for (number, lesson) in generated(62, 600).into_iter().enumerate() {
        let more = &extra[..number % 5];
        let lesson = if number % 3 == 0 {
            lesson.with_conditions(&more[more.len().min(number % 2)..])
        } else {
            lesson
        };
        let Some(text) = answer(&lesson, "why-empty") else { continue };
        let conditions = lesson.problem.conditions.iter().flat_map(Condition::inequalities);
        let of_conditions = Polyhedron::intersect(conditions.collect());
        let starts = text.starts_with("The conditions contradict") || text.starts_with("Condition ");
        assert_eq!(starts, of_conditions.region().is_empty(), "{}: {text}", lesson.name);
        if let Some((_, rest)) = text.split_once(" As inequalities in θ, ") {
            let (terms, _) = rest.split_once(" add up to 0 ≤ −").unwrap();
            if let Some((falsehood, _)) = sum(&lesson, terms) {
                assert!(falsehood.a.iter().all(Rational::is_zero) && falsehood.b.is_negative(), "{text}");
            }
        }
        let least = answer(&lesson, "smallest-error-bound").unwrap();
        assert!(!of_conditions.region().is_empty() || least.starts_with("There is none: "), "{least}");
        if least.contains("no factor changes") {
            let (_, names) = least.split_once(", and ").unwrap();
            for half_plane in items(&lesson.data["half_planes"]) {
                let (row, bound) =
                    (&half_plane["name"]["row"], half_plane["name"]["bound"].as_str().unwrap());
                let reading = items(&lesson.data["readings"]).find(|reading| reading["row"] == *row);
                let is_mentioned = [",", " and", " can", " contradict"]
                    .iter()
                    .any(|end| names.contains(&format!("the {bound} bound of reading {row}{end}")));
                assert!(!is_mentioned || reading.unwrap()["epsilon"]["exact"] == "0", "{least}");
            }
            tally.count("fixed");
        }
        tally.count(if starts { "conditions" } else { "bounds" });
    }
    tally.assert_each(3, &["conditions", "bounds", "fixed"]);
}

#[test]
fn optimisers_are_counted_once_each() {
    let words = ["no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten"];
    let mut tally = Tally::default();
    for lesson in fixtures().into_iter().chain(generated(63, 200)) {
        let Some(text) = answer(&lesson, "inner-or-outer") else { continue };
        let rows = ProgramRows::new(&lesson.problem).plain();
        let optimisers: BTreeSet<String> = spread_objectives(16)
            .into_iter()
            .map(|objective| match exact_simplex(&Program { rows: &rows, objective }) {
                ExactOutcome::Optimal { theta, .. } => format!("{}, {}", theta[0], theta[1]),
                other => panic!("{other:?}"),
            })
            .collect();
        let expected =
            words.get(optimisers.len()).map_or(optimisers.len().to_string(), |word| (*word).to_owned());
        let question = asked(&lesson, "inner-or-outer")["question"].as_str().unwrap();
        assert!(question.contains(&format!(" end in {expected} different optimisers.")), "{question}");
        let inner = &lesson.data["layers"]["directions"]["inner_area"]["exact"];
        let area = lesson.fit.fps.polyhedron().region().area().unwrap();
        assert_eq!(text.contains("is the set itself, with"), *inner == area.to_string().as_str(), "{text}");
        assert_eq!(text.contains("without area"), inner == "0", "{text}");
        tally.count(if text.contains("is the set itself, with") { "whole" } else { "part" });
    }
    tally.assert_each(3, &["whole", "part"]);
}

#[test]
fn estimates_on_the_boundary_are_said_to_be() {
    let line = figure("on-a-line.csv", Rational::zero(), &[]);
    assert_eq!(
        answer(&line, "least-squares-feasible").unwrap(),
        "Yes. It passes exactly through every reading, so that it meets every error bound of 0 with equality."
    );
    let segment = figure("twice-at-zero.csv", Rational::ratio(1, 10), &[]);
    assert_eq!(
        answer(&segment, "least-squares-feasible").unwrap(),
        "Yes, but with nothing to spare: it satisfies every bound, two of them with equality: the upper bound of reading 1 and the lower bound of reading 2."
    );
    assert_eq!(
        answer(&line, "how-many-matter").unwrap(),
        "Three: the upper bound of reading 1, the lower bound of reading 2 and the upper bound of reading 3. All the others could be left out, and the set would be the same. This is not the only such choice."
    );
}

#[test]
fn there_is_no_central_estimate_without_a_box() {
    for lesson in fixtures().into_iter().chain(generated(64, 200)) {
        let Some(text) = answer(&lesson, "central-or-least-squares") else { continue };
        let exists = lesson.data["fit"]["central"].is_object();
        assert_eq!(text.contains("there is no central estimate"), !exists, "{text}");
        assert_eq!(asked(&lesson, "central-or-least-squares")["show"].is_object(), exists);
        assert!(exists || lesson.fit.least_squares.is_err());
    }
}

#[test]
fn bounds_have_their_article_and_least_squares_no_hyphen_as_a_noun() {
    for lesson in fixtures().into_iter().chain(generated(65, 200)) {
        for question in items(&lesson.data["questions"]) {
            for text in [&question["question"], &question["answer"]].map(|text| text.as_str().unwrap()) {
                for which in ["upper", "lower"] {
                    for (place, _) in text.match_indices(&format!("{which} bound of")) {
                        let before = text[..place].to_lowercase();
                        assert!(before.ends_with("the "), "{text}");
                    }
                }
                for (place, word) in text.to_lowercase().match_indices("least-squares") {
                    let after = &text[place + word.len()..];
                    assert!(after.starts_with(" line") || after.starts_with(" estimate"), "{text}");
                }
            }
        }
    }
}
