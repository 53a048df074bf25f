//! Statements of theorems about parts of the rows and about predictions, and the oracle's judgement of them.

use boundfit_exact::Rational;
use boundfit_tests::oracle::{Row, solve};

use crate::claim::{Generators, number};
use crate::forged_files::{between, fractions, half_planes_by_row, x_of_rows};

/// The rows of a file, each with its half-planes, and the half-planes of all conditions.
struct Parts {
    rows: Vec<Vec<Row>>,
    conditions: Vec<Row>,
}

impl Parts {
    /// The half-planes of the rows whose numbers, from 1, are in a part.
    fn planes(&self, is_in: impl Fn(usize) -> bool) -> Vec<Row> {
        let rows = (1..).zip(&self.rows).filter(|(place, _)| is_in(*place)).flat_map(|(_, own)| own);
        rows.chain(&self.conditions).copied().collect()
    }

    fn leaves(&self, is_in: impl Fn(usize) -> bool) -> bool {
        solve(&self.planes(is_in)).kind != "empty"
    }

    fn places(&self) -> impl Iterator<Item = usize> {
        1..=self.rows.len()
    }

    /// All sets of at most `most` rows that leave something when they are out.
    fn leaving(&self, most: usize) -> Vec<Vec<usize>> {
        let sets = (0_u32..1 << self.rows.len()).filter(|set| set.count_ones() as usize <= most);
        let rows = sets.map(|set| self.places().filter(|place| set >> (place - 1) & 1 == 1).collect());
        rows.filter(|out: &Vec<usize>| self.leaves(|place| !out.contains(&place))).collect()
    }
}

/// Lists of whole numbers, each `[1; 2]%Z`.
fn lists(text: &str) -> Option<Vec<Vec<usize>>> {
    let pieces: Vec<&str> = text.split("]%Z").collect();
    let (_, pieces) = pieces.split_last()?;
    let list = |piece: &&str| -> Option<Vec<usize>> {
        let own = piece.rsplit_once('[')?.1;
        own.split("; ").filter(|own| !own.is_empty()).map(|own| own.parse().ok()).collect()
    };
    pieces.iter().map(list).collect()
}

fn list(text: &str, definition: &str) -> Option<Vec<usize>> {
    let own = between(text, &format!("Definition {definition} : list Z := "), ".\n")?;
    lists(own)?.pop()
}

/// The numbers of natural numbers in a text, `2%nat`, and the one before `<= length out`.
fn naturals(text: &str) -> Vec<usize> {
    let words = text.split([' ', '(', ')', '\n']).map(|own| own.trim_end_matches("%nat"));
    words.filter_map(|own| own.parse().ok()).collect()
}

/// Returns true if the oracle finds the statements of a file that follow the one about its set true. `None` if they are not
/// written as boundfit writes them.
pub fn parts_are_true(text: &str, set: Option<&Generators>) -> Option<bool> {
    let (rows, conditions) = half_planes_by_row(text)?;
    let parts = Parts { rows, conditions };
    let statements = ["the_", "the_real_"];
    let of = |name: &str| {
        statements
            .map(|real| between(text, &format!("Theorem {real}{name} :"), "\nProof."))
            .into_iter()
            .flatten()
    };
    let mut is_true = true;
    for statement in of("outliers") {
        is_true &= outliers(text, statement, &parts)?;
    }
    for _ in of("range") {
        is_true &= range(text, &parts)?;
    }
    for _ in of("outlier_rows") {
        let own = list(text, "outliers")?;
        is_true &= parts.places().all(|place| parts.leaves(|other| other != place) == own.contains(&place));
    }
    for _ in of("deciding_rows") {
        let (own, boundary) = (list(text, "deciding")?, list(text, "boundary")?);
        let is_same = |planes: Vec<Row>| set.is_some_and(|set| set.are_the_set_of(&planes));
        is_true &=
            parts.places().all(|place| is_same(parts.planes(|other| other != place)) != own.contains(&place))
                && is_same(parts.planes(|place| boundary.contains(&place)));
    }
    for statement in of("prediction") {
        is_true &= statement.trim().trim_end_matches('.').split("\n  /\\ ").all(|own| prediction(own, set));
    }
    Some(is_true)
}

fn outliers(text: &str, statement: &str, parts: &Parts) -> Option<bool> {
    let sets = lists(between(text, "Definition sets : list (list Z) := ", ".\n")?)?;
    let (least, size, most) = match naturals(statement)[..] {
        [least, size] => (least, size, None),
        [least, size, most] => (least, size, Some(most)),
        _ => return None,
    };
    let is_least = least == 0 || parts.leaving(least - 1).is_empty();
    let are_sets = sets.iter().all(|own| {
        let is_distinct = own.iter().enumerate().all(|(index, place)| !own[..index].contains(place));
        own.len() == size && is_distinct && parts.leaves(|place| !own.contains(&place))
    });
    let has_one = |out: &Vec<usize>| sets.iter().any(|own| own.iter().all(|place| out.contains(place)));
    Some(is_least && are_sets && most.is_none_or(|most| parts.leaving(most).iter().all(has_one)))
}

fn range(text: &str, parts: &Parts) -> Option<bool> {
    let keys: Vec<Rational> = match between(text, "Definition key (i : Z) (r : row) : Q := ", ".\n")? {
        "x r" => x_of_rows(text)?,
        "inject_Z i" => parts.places().map(Rational::from).collect(),
        _ => return None,
    };
    let ends = fractions(between(text, "Definition runs : list (Q * Q) := ", ".\n")?);
    let ends: Vec<Rational> = ends.iter().map(|own| number(own)).collect();
    let runs: Vec<&[Rational]> = ends.chunks(2).collect();
    let is_run = |[a, b]: [&Rational; 2]| {
        let is_in = |place: usize| *a <= keys[place - 1] && keys[place - 1] <= *b;
        let is_within = |run: &&[Rational]| {
            let mut own = parts.places().filter(|place| is_in(*place));
            own.all(|place| run[0] <= keys[place - 1] && keys[place - 1] <= run[1])
        };
        parts.leaves(is_in) == runs.iter().any(is_within)
    };
    Some(keys.iter().all(|a| keys.iter().filter(|b| a <= *b).all(|b| is_run([a, b]))))
}

/// A clause about the values at one x: a range, or two ends in parentheses.
fn prediction(clause: &str, set: Option<&Generators>) -> bool {
    let Some(set) = set else { return false };
    let numbers = |text: &str| fractions(text).iter().map(|own| number(own)).collect::<Vec<_>>();
    // The numbers of a value stand in its own parentheses.
    let form = |text: &str| {
        let given = numbers(&format!("{})", between(text, "(value ", "))")?));
        let second = given.get(1).cloned().unwrap_or_else(Rational::one);
        Some(([given.first()?.clone(), second, Rational::zero()], given.len()))
    };
    let has_end = |which: &str, form: &[Rational; 3], bound: Option<&Rational>| {
        set.has_end_of(form, which, bound.map(ToString::to_string).as_deref())
    };
    let Some((own, count)) = form(clause) else { return false };
    if clause.starts_with("is_range ") {
        let ends = &numbers(clause)[count..];
        return has_end("lowest", &own, ends.first()) && has_end("highest", &own, ends.last());
    }
    clause.trim_matches(['(', ')']).split(" /\\ ").all(|end| {
        let Some((own, count)) = form(&format!("{end})")) else { return false };
        let which = end.split(' ').next().unwrap_or_default();
        has_end(which, &own, numbers(&format!("{end})")).get(count))
    })
}
