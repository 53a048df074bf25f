//! The theorems that `boundfit_report::lean_theorems` writes, without Lean: a small reader of their text adds up the multiplied
//! hypotheses and compares with the goal, and puts the given points in.

use std::collections::BTreeMap;

use boundfit_exact::{Foreign, Rational};
use boundfit_judge::Answer;
use boundfit_lp::Model;
use boundfit_report::lean_theorems;
use boundfit_tests::generate::seeded;
use boundfit_tests::lp_cases::number;
use boundfit_tests::models::model;
use boundfit_tests::shape::Tally;

/// A polynomial of degree one in variables and perhaps `t`; the constant stands under the empty name.
type Form = BTreeMap<String, Rational>;

fn scaled(form: &Form, times: &Rational) -> Form {
    form.iter()
        .map(|(name, value)| (name.clone(), value * times))
        .filter(|(_, value)| !value.is_zero())
        .collect()
}

fn added(mut one: Form, other: &Form) -> Form {
    for (name, value) in other {
        let sum = one.remove(name).unwrap_or_default() + value;
        if !sum.is_zero() {
            one.insert(name.clone(), sum);
        }
    }
    one
}

/// An expression: terms joined by ` + ` and ` - `, each a number, a variable, or a number times a variable or a sum in
/// parentheses; `(number : ℚ)` is the number.
fn form(text: &str) -> Form {
    let mut rest = text.trim().replace(" : ℚ)", ")");
    let mut sum = Form::new();
    let mut sign = Rational::one();
    while !rest.is_empty() {
        if let Some(stripped) = rest.strip_prefix('-') {
            (sign, rest) = (-sign, stripped.to_owned());
        }
        let mut depth = 0;
        let end = rest.char_indices().find(|&(at, character)| {
            depth += i32::from(character == '(') - i32::from(character == ')');
            depth == 0 && (rest[at..].starts_with(" + ") || rest[at..].starts_with(" - "))
        });
        let end = end.map_or(rest.len(), |(at, _)| at);
        sum = added(sum, &scaled(&term(&rest[..end]), &sign));
        sign = Rational::from(if rest[end..].starts_with(" - ") { -1 } else { 1 });
        rest = rest.get(end + 3..).unwrap_or_default().to_owned();
    }
    sum
}

fn term(text: &str) -> Form {
    let whole =
        text.strip_prefix('(').and_then(|inner| inner.strip_suffix(')')).filter(|inner| !inner.contains('('));
    if let Some(inner) = whole {
        return form(inner);
    }
    match text.split_once(" * ") {
        Some((times, rest)) => scaled(&term(rest), &number(times)),
        None if text.starts_with(['x', 't']) => Form::from([(text.to_owned(), Rational::one())]),
        None => scaled(&Form::from([(String::new(), Rational::one())]), &number(text)),
    }
}

/// `right - left` of `left ≤ right`, which is then not negative.
fn gap(statement: &str) -> Form {
    let (left, right) = statement.split_once(" ≤ ").unwrap_or_else(|| panic!("{statement}"));
    added(form(right), &scaled(&form(left), &-Rational::one()))
}

/// What stands between two texts.
fn between<'a>(text: &'a str, before: &str, behind: &str) -> &'a str {
    let (_, rest) = text.split_once(before).unwrap_or_else(|| panic!("{before}: {text}"));
    rest.split_once(behind).unwrap_or_else(|| panic!("{behind}: {text}")).0
}

/// The sum of multiplied hypotheses of a theorem.
fn combination(theorem: &str) -> Form {
    let hypothesis = |line: &str| {
        let (name, says) = line.trim().strip_prefix('(')?.split_once(" : ")?;
        (name.contains("_lower") || name.contains("_upper")).then(|| (name.to_owned(), says.to_owned()))
    };
    let head = theorem.split_once(" := by\n").unwrap().0;
    let hypotheses: BTreeMap<String, String> = head
        .lines()
        .skip(1)
        .filter_map(|line| {
            let line = line.trim_end().trim_end_matches(" :");
            hypothesis(line.strip_suffix(')')?)
        })
        .collect();
    let mut sum = Form::new();
    for step in theorem.split("mul_le_mul_of_nonneg_left ").skip(1) {
        let name = step.split(' ').next().unwrap();
        let times = number(between(step, "(0 : ℚ) ≤ ", ")"));
        assert!(!times.is_negative());
        sum = added(sum, &scaled(&gap(&hypotheses[name]), &times));
    }
    sum
}

fn theorem<'a>(text: &'a str, name: &str) -> &'a str {
    let start = text.find(&format!("theorem {name}")).unwrap_or_else(|| panic!("{name}: {text}"));
    text[start..].split("\n\n").next().unwrap()
}

/// The statements of a conjunction with numbers for variables: each must hold.
fn assert_holds(statements: &str, values: &BTreeMap<String, Rational>) {
    for statement in statements.split('∧') {
        let at = |text: &str| -> Rational {
            form(text)
                .iter()
                .map(|(name, value)| if name.is_empty() { value.clone() } else { value * &values[name] })
                .sum()
        };
        match statement.split_once(" = ") {
            Some((left, right)) => assert_eq!(at(left), at(right), "{statement}"),
            None => {
                let (left, right) = statement.split_once(" ≤ ").unwrap_or_else(|| panic!("{statement}"));
                assert!(at(left) <= at(right), "{statement}");
            }
        }
    }
}

fn check(model: &Model) -> &'static str {
    let answer = Answer::of(model).unwrap();
    let text = lean_theorems(model, &answer, Foreign::of("model.mps"));
    let columns = model.columns.len();
    match answer {
        Answer::Optimal { .. } => {
            let bound = theorem(&text, "optimum_bound");
            let goal = bound.split_once(" :\n    ").unwrap().1.split_once(" := by").unwrap().0;
            // `linarith` has nothing to do but to see that both are the same.
            assert_eq!(combination(bound), gap(goal), "{text}");
            let attained = theorem(&text, "optimum_attained");
            let says = attained.split_once(" :\n    ").unwrap().1.rsplit_once(" :=\n").unwrap().0;
            let (says, values) = if columns == 0 {
                (says, BTreeMap::new())
            } else {
                let point = between(attained, "⟨", ", by norm_num⟩").split(", ").map(number);
                (
                    says.split_once(",\n").unwrap().1,
                    (1..).map(|n: usize| format!("x{n}")).zip(point).collect(),
                )
            };
            assert_eq!(values.len(), columns);
            assert_holds(says, &values);
            "optimal"
        }
        Answer::Infeasible { .. } => {
            let sum = combination(theorem(&text, "infeasible"));
            assert_eq!(sum.keys().collect::<Vec<_>>(), [""], "{text}");
            assert!(sum[""].is_negative(), "{text}");
            "infeasible"
        }
        Answer::Unbounded { .. } => {
            let unbounded = theorem(&text, "unbounded");
            let says = between(unbounded, " :\n    ", " :=\n");
            for statement in says.split('∧') {
                match statement.split_once(" = ") {
                    Some((left, right)) => {
                        assert_eq!(form(left), form(right), "{text}");
                    }
                    // It holds for t = 0, and no less as t grows.
                    None => {
                        assert!(gap(statement.trim()).values().all(|value| !value.is_negative()), "{text}")
                    }
                }
            }
            let says = says.split('∧').next_back().unwrap().split_once(" = ").unwrap().1;
            let change = form(says).remove("t").unwrap();
            assert_eq!(change.is_negative(), model.sense == boundfit_lp::ObjectiveSense::Minimize);
            "unbounded"
        }
    }
}

#[test]
fn the_arithmetic_of_every_theorem_holds() {
    let mut rng = seeded(1_402);
    let mut tally = Tally::default();
    for _ in 0..2_000 {
        tally.count(check(&model(&mut rng)));
    }
    tally.assert_each(200, &["optimal", "infeasible", "unbounded"]);
}

#[test]
fn expressions_are_read_as_they_are_written() {
    let expected = |terms: &[(&str, i64)]| -> Form {
        terms.iter().map(|(name, value)| ((*name).to_owned(), Rational::from(*value))).collect()
    };
    assert_eq!(form("-x1 + 2 * x2 - 3"), expected(&[("", -3), ("x1", -1), ("x2", 2)]));
    assert_eq!(form("(0 : ℚ)"), expected(&[]));
    assert_eq!(form("2 * (1 + -3 * t) - (4 + 0 * t)"), expected(&[("", -2), ("t", -6)]));
    assert_eq!(gap("(-5 : ℚ) ≤ x1"), expected(&[("", 5), ("x1", 1)]));
}
