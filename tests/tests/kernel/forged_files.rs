//! Forgeries of whole files about readings and linear programs: a number, a line or a word of the text changed. Coq's toplevel
//! reads each, and of what it accepts the oracle says that it is true.

use std::collections::BTreeMap;
use std::ops::Range;

use boundfit_estimation::fit;
use boundfit_exact::{Rational, Reading};
use boundfit_judge::{Answer, SolveError};
use boundfit_report::{Theory, kernel_fit, kernel_program};
use boundfit_tests::generate::{one_in, seeded, share};
use boundfit_tests::models::model;
use boundfit_tests::oracle::{Row, solve};
use boundfit_tests::proofs::{bounded, generated, questions};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use crate::about_parts::parts_are_true;
use crate::claim::{Generators, cells, changed, ends_of, number, pairs, tampered};
use crate::coq::{accepted, body};

/// Integers below this are not too large for the oracle after a change.
const SMALL: i128 = 1 << 18;

/// The text between two others, the first time that the first one occurs.
pub fn between<'a>(text: &'a str, start: &str, end: &str) -> Option<&'a str> {
    let rest = text.split_once(start)?.1;
    Some(rest.split_once(end)?.0)
}

/// The lines that a definition reads.
fn read(text: &str, definition: &str) -> Option<Vec<Vec<String>>> {
    let lines = between(text, &format!("Definition {definition} "), "\"]%text")?.split_once("read [\"")?.1;
    Some(lines.lines().map(cells).collect())
}

fn pairs_of(text: &str, definition: &str) -> Vec<Vec<String>> {
    text.split_once(&format!("Definition {definition} ")).map_or(Vec::new(), |(_, own)| pairs(own))
}

/// Fractions of Coq in a text.
pub fn fractions(text: &str) -> Vec<String> {
    let parts = text.split('(').filter_map(|part| part.split_once(')')).map(|(own, _)| own);
    parts.filter(|own| own.contains(" # ")).map(|own| own.replace(" # ", "/")).collect()
}

/// The meaning of a cell: empty ones are missing.
fn cell(row: &[String], place: usize) -> Option<Rational> {
    row.get(place).filter(|own| !own.is_empty()).map(|own| number(own))
}

/// The rows and conditions of a file as half-planes, by its definitions.
fn half_planes(text: &str) -> Option<Vec<Row>> {
    let (rows, conditions) = half_planes_by_row(text)?;
    Some(rows.into_iter().flatten().chain(conditions).collect())
}

/// The half-planes of each row, and those of all conditions.
pub fn half_planes_by_row(text: &str) -> Option<(Vec<Vec<Row>>, Vec<Row>)> {
    let form = between(text, "Definition forms : list form := map (fun r => ", ") rows")?;
    let form = form.replace(" r)", "").replace(['(', ')'], "");
    let words: Vec<&str> = form.split(' ').collect();
    let mut rows = Vec::new();
    for row in read(text, "rows")? {
        let mut planes = Vec::new();
        let value = |name: &str| column(text, name, &row);
        let (low, high) = match words[..] {
            ["around", _, _, y, epsilon] => {
                let (y, epsilon) = (value(y)?, value(epsilon)?);
                (Some(&y - &epsilon), Some(&y + &epsilon))
            }
            ["Form", _, _, "None", "Some", own] => (None, Some(value(own)?)),
            ["Form", _, _, least, most] => (value(least), value(most)),
            _ => return None,
        };
        push(&mut planes, [value(words[1])?, value(words[2])?], [low, high])?;
        rows.push(planes);
    }
    let mut planes = Vec::new();
    for row in read(text, "conditions").unwrap_or_default() {
        let [a, b] = [0, 1].map(|place| cell(&row, place).unwrap_or_default());
        push(&mut planes, [a, b], [2, 3].map(|place| cell(&row, place)))?;
    }
    Some((rows, planes))
}

/// The number of a row in a column, by the column's definition.
fn column(text: &str, name: &str, row: &[String]) -> Option<Rational> {
    if name == "1" {
        return Some(Rational::one());
    }
    let body = between(text, &format!("Definition {name} (r : row) : "), ".\n")?;
    match body.split_once(" := ")? {
        ("Q", own) if own.contains('#') => Some(number(&own.replace(['(', ')'], "").replace(" # ", "/"))),
        ("Q", own) => Some(cell(row, own.split(' ').nth(1)?.parse().ok()?).unwrap_or_default()),
        (_, own) => cell(row, own.split(' ').nth(1)?.parse().ok()?),
    }
}

/// x of each row.
pub fn x_of_rows(text: &str) -> Option<Vec<Rational>> {
    read(text, "rows")?.iter().map(|row| column(text, "x", row)).collect()
}

fn push(planes: &mut Vec<Row>, [a, b]: [Rational; 2], [low, high]: [Option<Rational>; 2]) -> Option<()> {
    let mut whole = |[a, b, c]: [&Rational; 3]| {
        let (numbers, _) = Rational::over_common_denominator([a, b, c]);
        let [a, b, c] = numbers.map(|own| own.to_i128());
        planes.push([a?, b?, c?]);
        Some(())
    };
    if let Some(low) = low {
        whole([&-&a, &-&b, &-low])?;
    }
    if let Some(high) = high {
        whole([&a, &b, &high])?;
    }
    Some(())
}

/// Returns true if the oracle finds all statements of a file true; `None` if it is not written as boundfit writes.
fn is_true(text: &str) -> Option<bool> {
    let mut rows = half_planes(text)?;
    if text.contains("Theorem nothing_is_feasible : forall p, ~ feasible p.") {
        return Some(solve(&rows).kind == "empty" && parts_are_true(text, None)?);
    }
    let set = Generators::new(&read(text, "vertices")?, &pairs_of(text, "rays"));
    let is_set = set.are_the_set_of(&rows)
        && ends_of(text).iter().all(|end| set.has_end(end))
        && parts_are_true(text, Some(&set))?;
    let Some(objective) = between(text, "Definition objective (p : Q * Q) : Q := ", ".\n") else {
        return Some(is_set);
    };
    let objective: [Rational; 3] =
        fractions(objective).iter().map(|own| number(own)).collect::<Vec<_>>().try_into().ok()?;
    if let Some(end) = between(text, "Theorem no_optimum : ", " feasible objective.\n") {
        return Some(is_set && set.has_end_of(&objective, end, None));
    }
    let says = between(text, "Theorem the_optimum : ", "\n")?;
    let (end, value) = (says.split(' ').next()?, fractions(says).pop()?);
    let optimal = Generators::new(&read(text, "optimal_points")?, &pairs_of(text, "optimal_rays"));
    let [a, b, c] = &objective;
    let level = Some(&number(&value) - c);
    push(&mut rows, [a.clone(), b.clone()], [level.clone(), level])?;
    let is_optimum = set.has_end_of(&objective, end, Some(&value));
    Some(is_set && is_optimum && optimal.are_the_set_of(&rows))
}

/// The places where a pattern occurs.
pub fn places(text: &str, pattern: &str) -> Vec<Range<usize>> {
    text.match_indices(pattern).map(|(start, _)| start..start + pattern.len()).collect()
}

pub fn any<'a, T>(rng: &mut ChaCha8Rng, all: &'a [T]) -> Option<&'a T> {
    (!all.is_empty()).then(|| &all[rng.random_range(0..all.len())])
}

/// Changes a text that the file reads: rows, conditions, vertices, points or the sides.
pub fn with_other_lines(rng: &mut ChaCha8Rng, text: &str) -> Option<String> {
    let start = any(rng, &places(text, "read [\""))?.end;
    let end = start + text[start..].find("\"]%text")?;
    let mut rows: Vec<Vec<String>> = text[start..end].lines().map(cells).collect();
    let before = rows.len();
    let is_sides = text[..start].ends_with("number_of (read [\"");
    if is_sides && rng.random_bool(0.5) {
        let side = rng.random_range(0..rows.len());
        rows[side] = vec![rng.random_range(0..=2 * before).to_string()];
    } else if rng.random_bool(0.1) {
        let row = rng.random_range(0..before);
        let cell = rng.random_range(0..rows[row].len());
        rows[row][cell] = String::new();
    } else {
        let missing = |rows: &[Vec<String>]| rows.iter().flatten().filter(|own| own.is_empty()).count();
        // A missing bound becomes a number before it is changed.
        if missing(&rows) > 0 && rng.random_bool(0.2) {
            rows.iter_mut().flatten().filter(|own| own.is_empty()).for_each(|own| *own = "9".to_owned());
        } else {
            let filled: Vec<usize> = (0..before).filter(|&row| missing(&rows[row..=row]) == 0).collect();
            let mut own: Vec<_> = filled.iter().map(|&row| rows[row].clone()).collect();
            tampered(rng, &mut own);
            rows.retain(|row| row.iter().any(String::is_empty));
            own.append(&mut rows);
            rows = own;
        }
    }
    let lines: String = rows.iter().map(|row| row.join(",") + "\n").collect();
    let forged = format!("{}{lines}{}", &text[..start], &text[end..]);
    let is_rows = text[..start].ends_with("Definition rows : list row := read [\"");
    Some(match is_rows {
        // The number of rows is forged as well.
        true => forged.replace(&format!(" = {before}%Z"), &format!(" = {}%Z", rows.len())),
        false => forged,
    })
}

fn with_other_rays(rng: &mut ChaCha8Rng, text: &str) -> Option<String> {
    let start = any(rng, &places(text, "rays : list (Q * Q) := ["))?.end;
    let end = start + text[start..].find("].")?;
    let mut rays = pairs(&text[start - 1..]);
    tampered(rng, &mut rays);
    let rays: Vec<String> = rays.iter().map(|own| format!("({})", own.join(", "))).collect();
    Some(format!("{}{}{}", &text[..start], rays.join("; "), &text[end..]))
}

/// Changes a number of a certificate or of a column's place.
pub fn with_other_hint(rng: &mut ChaCha8Rng, text: &str) -> Option<String> {
    let mut lines: Vec<String> = text.lines().map(ToOwned::to_owned).collect();
    let is_hint = |line: &&mut String| {
        line.contains("evidence : certificate := ") && !line.contains("read") || line.contains("row) : ")
    };
    let mut hints: Vec<&mut String> = lines.iter_mut().filter(is_hint).collect();
    let hint = rng.random_range(0..hints.len());
    let line = hints.get_mut(hint)?;
    let (head, body) = line.split_once(" := ")?;
    let mut words: Vec<String> = body.split(' ').map(ToOwned::to_owned).collect();
    let is_number = |own: &&mut String| own.trim_end_matches('.').parse::<u32>().is_ok();
    let mut numbers: Vec<&mut String> = words.iter_mut().filter(is_number).collect();
    let (count, which) = (numbers.len(), rng.random_range(0..=numbers.len()));
    let word = numbers.get_mut(which.min(count.checked_sub(1)?))?;
    let end = if word.ends_with('.') { "." } else { "" };
    **word = format!("{}{end}", rng.random_range(0..9));
    **line = format!("{head} := {}", words.join(" "));
    Some(lines.join("\n") + "\n")
}

/// Changes a fraction of a statement: everywhere, or once.
pub fn with_other_fraction(rng: &mut ChaCha8Rng, text: &str) -> Option<String> {
    let all = fractions(text);
    let mut value = any(rng, &all)?.clone();
    let old = format!("({})", value.replace('/', " # "));
    changed(rng, &mut value);
    let value = if value.contains('/') { value } else { format!("{value}/1") };
    let new = format!("({})", value.replace('/', " # "));
    if rng.random_bool(0.7) {
        return Some(text.replace(&old, &new));
    }
    let place = any(rng, &places(text, &old))?.clone();
    Some(format!("{}{new}{}", &text[..place.start], &text[place.end..]))
}

/// Changes a word of a statement, or turns the objective round.
pub fn with_other_word(rng: &mut ChaCha8Rng, text: &str) -> Option<String> {
    const WORDS: [(&str, &str); 16] = [
        ("<=", "<"),
        ("<->", "->"),
        ("->", "<->"),
        ("/\\", "\\/"),
        ("fst p", "snd p"),
        ("snd p", "fst p"),
        ("lowest", "highest"),
        ("highest", "lowest"),
        (" feasible", " ~ feasible"),
        ("~ feasible", "feasible"),
        ("hull ", "hull_and_cone "),
        ("forall", "exists"),
        (" + ", " - "),
        ("at_least", "at_most"),
        ("(y r", "(x r"),
        ("==", "<="),
    ];
    if let Some((before, after)) = text.split_once("Definition objective").filter(|_| rng.random_bool(0.3)) {
        let turned =
            after.replace("lowest", "LOWEST").replace("highest", "lowest").replace("LOWEST", "highest");
        return Some(format!("{before}Definition objective{turned}"));
    }
    let (old, new) = any(rng, &WORDS)?;
    let place = any(rng, &places(text, old))?.clone();
    Some(format!("{}{new}{}", &text[..place.start], &text[place.end..]))
}

/// The kinds of changes, each with its share.
pub type Forger = fn(&mut ChaCha8Rng, &str) -> Option<String>;
const FORGERS: [(&str, Forger); 8] = [
    ("lines", with_other_lines),
    ("lines", with_other_lines),
    ("lines", with_other_lines),
    ("rays", with_other_rays),
    ("hint", with_other_hint),
    ("fraction", with_other_fraction),
    ("fraction", with_other_fraction),
    ("word", with_other_word),
];

/// A file without its head, and with forgeries of it.
pub fn with_forgeries(
    rng: &mut ChaCha8Rng,
    text: &str,
    count: usize,
    forgers: &[(&'static str, Forger)],
) -> Vec<(&'static str, String)> {
    let body = body(text);
    assert_eq!(is_true(&body), Some(true), "{body}");
    let (about, statements) = body.split_once("*)").unwrap();
    let mut cases = Vec::new();
    while cases.len() < count {
        let (kind, forger) = forgers[rng.random_range(0..forgers.len())];
        // The first comment states nothing.
        match forger(rng, statements).filter(|forged| forged != statements) {
            Some(forged) => cases.push((kind, format!("{about}*){forged}"))),
            None => continue,
        }
    }
    cases.push(("", body));
    cases
}

/// Has Coq read each file and a share of the forgeries of each kind, and the oracle what Coq accepts.
pub fn none_is_false(name: &str, cases: &[(&'static str, String)]) {
    let (own, mut forged): (Vec<_>, Vec<_>) = cases.iter().partition(|(kind, _)| kind.is_empty());
    forged.sort_by_key(|(kind, _)| *kind);
    let cases: Vec<_> = own.into_iter().chain(forged.into_iter().step_by(one_in())).collect();
    let texts: Vec<&str> = cases.iter().map(|(_, text)| text.as_str()).collect();
    // The toplevel keeps every state, so that long runs are slow.
    let verdicts: Vec<bool> = texts.chunks(24).flat_map(|texts| accepted(name, texts)).collect();
    let mut counts = BTreeMap::<_, [usize; 2]>::new();
    for ((kind, text), is_accepted) in cases.into_iter().zip(verdicts) {
        counts.entry(*kind).or_default()[usize::from(is_accepted)] += 1;
        assert!(!is_accepted || is_true(text) == Some(true), "accepted, and false ({kind}):\n{text}");
        assert!(is_accepted || !kind.is_empty(), "refused, and true:\n{text}");
    }
    println!("{name}, refused and accepted: {counts:?}");
    let forgeries = || counts.iter().filter(|(kind, _)| !kind.is_empty()).map(|(_, own)| own);
    let [refused, agreed] = [0, 1].map(|place| forgeries().map(|own| own[place]).sum::<usize>());
    assert_eq!(refused + agreed, share(FILES * FORGERIES));
    assert!(refused > agreed && agreed >= share(16), "{counts:?}");
}

pub const FILES: usize = 30;
pub const FORGERIES: usize = 12;

#[test]
fn no_forgery_about_readings_is_accepted_that_is_false() {
    let mut rng = seeded(3105);
    let mut cases = Vec::new();
    let mut given = questions().into_iter().chain(bounded());
    while cases.len() < FILES * (FORGERIES + 1) {
        let question = given.next().unwrap_or_else(|| generated(&mut rng));
        let Ok(problem) = question.problem() else { continue };
        let text = kernel_fit(&problem, &fit(&problem), Reading::Decimal, None, Theory::Installed).unwrap();
        let rows = half_planes(&text).unwrap();
        if rows.len() <= 24 && rows.iter().flatten().all(|own| own.abs() < SMALL) {
            cases.extend(with_forgeries(&mut rng, &text, FORGERIES, &FORGERS));
        }
    }
    none_is_false("readings", &cases);
}

#[test]
fn no_forgery_about_a_linear_program_is_accepted_that_is_false() -> Result<(), SolveError> {
    let mut rng = seeded(3106);
    let (mut cases, mut empty) = (Vec::new(), 0);
    while cases.len() < FILES * (FORGERIES + 1) {
        let model = model(&mut rng);
        let answer = Answer::of(&model)?;
        let Some(text) = kernel_program(&model, &answer, None, Theory::Installed) else { continue };
        // A fifth of the programs is infeasible.
        let is_empty = matches!(answer, Answer::Infeasible { .. });
        if is_empty && empty == FILES / 5 {
            continue;
        }
        empty += usize::from(is_empty);
        cases.extend(with_forgeries(&mut rng, &text, FORGERIES, &FORGERS));
    }
    none_is_false("programs", &cases);
    Ok(())
}
