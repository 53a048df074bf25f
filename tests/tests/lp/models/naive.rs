//! Another reader of MPS, for files without mistakes, written from the tables of `fixtures/tiny-lp/README.md` alone.

use std::collections::HashMap;

use boundfit_exact::{Limits, Rational, Reading};
use boundfit_lp::{Bounds, Model, ModelColumn, ModelRow, ObjectiveSense};

fn number(text: &str) -> Rational {
    Reading::Decimal.read(text, &Limits::default()).unwrap()
}

/// A bound, unless it is infinite.
fn finite(value: Rational) -> Option<Rational> {
    let limit = number("1e30");
    Some(value).filter(|value| value.abs() < limit)
}

/// The words of each line, under the section that they belong to.
fn cards(text: &str) -> Vec<(String, Vec<String>)> {
    let mut section = String::new();
    let mut cards = Vec::new();
    for line in text.lines().filter(|line| !line.starts_with('*')) {
        let mut words: Vec<String> = line.split_whitespace().map(str::to_owned).collect();
        if !line.starts_with(' ') {
            section = words.remove(0);
        }
        if !words.is_empty() {
            cards.push((section.clone(), words));
        }
    }
    cards
}

/// Returns the entries of a section, as `(vector, row, number)`.
fn entries(cards: &[(String, Vec<String>)], section: &str) -> Vec<(String, String, Rational)> {
    let lines = cards.iter().filter(|(name, _)| name == section);
    lines
        .flat_map(|(_, words)| {
            words[1..].chunks(2).map(|pair| (words[0].clone(), pair[0].clone(), number(&pair[1])))
        })
        .collect()
}

pub(super) fn read(text: &str) -> Model {
    let cards = cards(text);
    let types: Vec<(&str, &str)> = cards
        .iter()
        .filter(|card| card.0 == "ROWS")
        .map(|card| (card.1[0].as_str(), card.1[1].as_str()))
        .collect();
    let objective = types.iter().find(|(kind, _)| *kind == "N").unwrap().1;
    let of_section = |section: &str| -> HashMap<String, Rational> {
        entries(&cards, section).into_iter().map(|(_, row, value)| (row, value)).collect()
    };
    let (sides, ranges) = (of_section("RHS"), of_section("RANGES"));
    let matrix = entries(&cards, "COLUMNS");
    let mut names: Vec<String> = matrix.iter().map(|(column, _, _)| column.clone()).collect();
    names.dedup();
    let coefficient = |row: &str, column: &str| {
        let found = matrix.iter().find(|entry| entry.0 == column && entry.1 == row);
        found.map_or(Rational::zero(), |(_, _, value)| value.clone())
    };
    let row = |(kind, name): &(&str, &str)| {
        let side = sides.get(*name).cloned().unwrap_or_else(Rational::zero);
        let (mut lower, mut upper) = (side.clone(), side.clone());
        match ranges.get(*name) {
            Some(range) if *kind == "L" || *kind == "E" && range.is_negative() => {
                lower = &lower - &range.abs()
            }
            Some(range) => upper = &upper + &range.abs(),
            None => {}
        }
        let is_ranged = ranges.contains_key(*name);
        let bounds = Bounds {
            lower: finite(lower).filter(|_| is_ranged || *kind != "L"),
            upper: finite(upper).filter(|_| is_ranged || *kind != "G"),
        };
        let coefficients = names.iter().enumerate().map(|(place, column)| (place, coefficient(name, column)));
        let coefficients = coefficients.filter(|(_, value)| !value.is_zero()).collect();
        ModelRow { name: (*name).into(), coefficients, bounds }
    };
    let column = |name: &String| {
        let stated = |kinds: &[&str]| {
            let line = cards.iter().find(|(section, words)| {
                section == "BOUNDS" && words[2] == *name && kinds.contains(&words[0].as_str())
            });
            line.map(|(_, words)| words.get(3).and_then(|text| finite(number(text))))
        };
        let upper = stated(&["UP", "FX"]).flatten();
        let is_negative = upper.as_ref().is_some_and(Rational::is_negative);
        let default = (!is_negative).then(Rational::zero);
        let lower = stated(&["LO", "FX", "MI", "FR"]).unwrap_or(default);
        ModelColumn {
            name: name.clone().into(),
            cost: coefficient(objective, name),
            bounds: Bounds { lower, upper },
        }
    };
    let is_maximum =
        cards.iter().any(|(section, words)| section == "OBJSENSE" && words[0].starts_with("MAX"));
    let name = text.lines().find_map(|line| line.strip_prefix("NAME")).unwrap_or_default();
    Model {
        name: name.trim().into(),
        sense: if is_maximum { ObjectiveSense::Maximize } else { ObjectiveSense::Minimize },
        objective_name: objective.into(),
        constant: -sides.get(objective).cloned().unwrap_or_else(Rational::zero),
        columns: names.iter().map(column).collect(),
        rows: types.iter().filter(|(kind, _)| *kind != "N").map(row).collect(),
    }
}
