//! Forgeries: a number of a row, vertex, ray, certificate or statement changed; rows and vertices dropped, repeated or exchanged.
//! The checker is run on each, and of what it accepts the oracle says that it is true.

use std::fmt::Write;

use boundfit_exact::Rational;
use boundfit_geometry::Polyhedron;
use boundfit_report::{Theory, kernel_half_planes};
use boundfit_tests::generate::{rational_system, seeded, system, tangents};
use boundfit_tests::oracle::{Row, solve};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use crate::claim::{End, Generators, cells, changed, ends_of, number, pairs, tampered};
use crate::coq::compiled;

/// The statement of a file about half-planes.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Statement {
    rows: Vec<Vec<String>>,
    vertices: Vec<Vec<String>>,
    rays: Vec<Vec<String>>,
    /// `Polygon`, `Segment`, ...; `None` of an empty set.
    kind: Option<String>,
    numbers: Vec<String>,
    /// `true` if the numbers are a list.
    is_list: bool,
    ends: Vec<End>,
}

/// The lines of text that a definition reads.
fn read(text: &str) -> Vec<Vec<String>> {
    let start = text.find("read [\"").unwrap() + "read [\"".len();
    let end = start + text[start..].find("\"]%text").unwrap();
    text[start..end].replace("\";\n\"", "").lines().map(cells).collect()
}

impl Statement {
    fn of(text: &str) -> Self {
        let definition = |name: &str| text.find(&format!("Definition {name} ")).map(|place| &text[place..]);
        let evidence = definition("evidence").unwrap();
        let (head, body) = evidence.split_once(" := ").unwrap();
        let body = &body[..body.find(".\nLemma").unwrap()];
        let is_list = body.contains("read [");
        let kind = (!head.contains("list Z")).then(|| body.split(' ').next().unwrap().to_owned());
        let numbers = match is_list {
            true => read(evidence).concat(),
            false => body.split(' ').skip(1).map(ToOwned::to_owned).collect(),
        };
        let rays = definition("rays").map_or(Vec::new(), pairs);
        let vertices = definition("vertices").map_or(Vec::new(), read);
        Statement { rows: read(text), vertices, rays, kind, numbers, is_list, ends: ends_of(text) }
    }

    /// A computation by the checker, which prints whether it accepts.
    fn computation(&self) -> String {
        let list = |rows: &[Vec<String>]| {
            let text: String = rows.iter().map(|row| row.join(",") + "\n").collect();
            format!("(read [\"{text}\"]%text)")
        };
        let numbers: Vec<_> = self.numbers.iter().map(|own| vec![own.clone()]).collect();
        let numbers = match self.is_list {
            true => format!("(map number_of {})", list(&numbers)),
            false => self.numbers.join(" "),
        };
        let forms = format!(
            "(map (fun r => Form (number 0 r) (number 1 r) None (Some (number 2 r))) {})",
            list(&self.rows)
        );
        let count = format!("(Z.of_nat (length {}) =? {})%Z", list(&self.rows), self.rows.len());
        let Some(kind) = &self.kind else {
            return format!("Eval vm_compute in ({count} && check_empty {forms} {numbers})%bool.\n");
        };
        let (vertices, rays) =
            (format!("(map point {})", list(&self.vertices)), format!("(map point {})", list(&self.rays)));
        let mut text =
            format!("Eval vm_compute in ({count} && check {forms} ({kind} {numbers}) {vertices} {rays}");
        for End { which, form, bound } in &self.ends {
            let bound = bound
                .as_ref()
                .map_or(String::new(), |own| format!("(number 0 (hd [] (read [\"{own}\n\"]%text)))"));
            let _ = write!(text, " && check_{which} {form} {vertices} {rays} {bound}");
        }
        text + ")%bool.\n"
    }

    /// Returns whether the statement is true, by the oracle.
    fn is_true(&self) -> bool {
        let Some(rows) = integers(&self.rows, 3) else { return false };
        let rows: Vec<Row> = rows.iter().map(|own| [own[0], own[1], own[2]]).collect();
        let is_empty = solve(&rows).kind == "empty";
        if self.kind.is_none() || is_empty {
            return self.kind.is_none() && is_empty;
        }
        let set = Generators::new(&self.vertices, &self.rays);
        set.are_the_set_of(&rows) && self.ends.iter().all(|end| set.has_end(end))
    }
}

/// Rows as integers, each in units of its own; `None` when a row has other cells.
fn integers(rows: &[Vec<String>], columns: usize) -> Option<Vec<Vec<i128>>> {
    let row = |own: &Vec<String>| {
        let [a, b, c] = own.get(..columns)? else { return None };
        let (numbers, _) = Rational::over_common_denominator([&number(a), &number(b), &number(c)]);
        Some(numbers.iter().map(|own| own.to_i128().unwrap()).collect())
    };
    rows.iter().map(row).collect()
}

fn forged(rng: &mut ChaCha8Rng, truth: &Statement) -> Statement {
    let mut forged = truth.clone();
    match rng.random_range(0..6) {
        0 | 1 => tampered(rng, &mut forged.rows),
        2 => tampered(rng, &mut forged.vertices),
        3 => tampered(rng, &mut forged.rays),
        4 if !forged.numbers.is_empty() => {
            let last = forged.numbers.len();
            let (one, other) = (rng.random_range(0..last), rng.random_range(0..last));
            match rng.random_range(0..4) {
                0 if forged.is_list => drop(forged.numbers.remove(one)),
                1 => forged.numbers.swap(one, other),
                _ => forged.numbers[one] = rng.random_range(0..=forged.rows.len() + 1).to_string(),
            }
        }
        _ if !forged.ends.is_empty() => {
            let end = rng.random_range(0..forged.ends.len());
            match &mut forged.ends[end].bound {
                Some(bound) => changed(rng, bound),
                None => forged.ends[end].which = "no_highest".to_owned(),
            }
        }
        _ => tampered(rng, &mut forged.rows),
    }
    forged
}

#[test]
fn no_forgery_is_accepted_that_is_false() {
    let mut rng = seeded(3103);
    let (mut cases, mut refused, mut accepted) = (Vec::new(), 0, 0);
    for index in 0..120 {
        let system = match index % 10 {
            0 => system(&tangents(&mut rng, 8)),
            _ => rational_system(&mut rng),
        };
        let polyhedron = Polyhedron::intersect(system.clone());
        let text = kernel_half_planes(&system, &polyhedron, None, None, Theory::Installed).unwrap();
        let truth = Statement::of(&text);
        assert!(truth.is_true(), "{text}");
        cases.push((truth.clone(), true));
        // A text without any change is no forgery.
        let forgeries = std::iter::repeat_with(|| forged(&mut rng, &truth)).filter(|own| *own != truth);
        cases.extend(forgeries.take(20).map(|own| (own, false)));
    }
    for (batch, cases) in cases.chunks(630).enumerate() {
        let mut text = String::from(
            "From Boundfit Require Import Reader Checker Convex Sound Rationals.\n\
             From Coq Require Import ZArith QArith List.\nImport ListNotations.\nOpen Scope Q_scope.\n",
        );
        cases.iter().for_each(|(case, _)| text.push_str(&case.computation()));
        let output = compiled(&format!("forged{batch}"), &text).unwrap();
        let verdicts: Vec<bool> = output
            .lines()
            .filter_map(|line| line.trim().strip_prefix("= "))
            .map(|verdict| verdict == "true")
            .collect();
        assert_eq!(verdicts.len(), cases.len());
        for ((case, is_original), verdict) in cases.iter().zip(verdicts) {
            assert!(verdict || !is_original, "{case:?}");
            if verdict {
                assert!(case.is_true(), "accepted, and false: {case:?}");
            }
            *if verdict { &mut accepted } else { &mut refused } += usize::from(!is_original);
        }
    }
    println!("{refused} forgeries refused, {accepted} accepted, which are true");
    assert_eq!(refused + accepted, 2400);
    assert!(refused > 1200, "{refused}");
}
