//! Forgeries: a number of a row, vertex, ray, certificate or statement changed; rows and vertices dropped, repeated or exchanged.
//! The checker is run on each, and of what it accepts the oracle says that it is true.

use std::fmt::Write;

use boundfit_exact::{Limits, Rational, Reading};
use boundfit_geometry::Polyhedron;
use boundfit_report::{Theory, kernel_half_planes};
use boundfit_tests::generate::{rational_system, seeded, system, tangents};
use boundfit_tests::oracle::{Row, solve};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

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
    /// `lowest`, `fst` and the bound, if there is one.
    ends: Vec<(String, String, Option<String>)>,
}

fn cells(line: &str) -> Vec<String> {
    line.split(',').map(|cell| cell.trim().to_owned()).collect()
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
        let rays = definition("rays").map_or(Vec::new(), |own| {
            let own = &own[own.find('[').unwrap() + 1..own.find("].").unwrap()];
            own.split("; ")
                .filter(|own| !own.is_empty())
                .map(|own| cells(own.trim_matches(['(', ')'])))
                .collect()
        });
        let mut ends = Vec::new();
        for line in
            text.lines().filter(|line| line.starts_with("Lemma fst_") || line.starts_with("Lemma snd_"))
        {
            let says = line.split_once(" : ").unwrap().1.trim_end_matches('.');
            let mut words = says.splitn(4, ' ');
            let (which, _, form) = (words.next().unwrap(), words.next().unwrap(), words.next().unwrap());
            let bound = words.next().map(|own| own.trim_matches(['(', ')']).replace(" # ", "/"));
            ends.push((which.to_owned(), form.to_owned(), bound));
        }
        let vertices = definition("vertices").map_or(Vec::new(), read);
        Statement { rows: read(text), vertices, rays, kind, numbers, is_list, ends }
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
        for (which, form, bound) in &self.ends {
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
        let answer = solve(&rows);
        if self.kind.is_none() || answer.kind == "empty" {
            return self.kind.is_none() && answer.kind == "empty";
        }
        let points: Vec<[i128; 3]> = self.vertices.iter().map(|own| homogeneous(own)).collect();
        let rays: Vec<[i128; 2]> =
            self.rays.iter().map(|own| homogeneous(own)).map(|[x, y, _]| [x, y]).collect();
        let slack = |[a, b, c]: Row, [x, y, w]: [i128; 3]| c * w - a * x - b * y;
        let are_inside = rows.iter().all(|&row| {
            points.iter().all(|&point| slack(row, point) >= 0)
                && rays.iter().all(|[x, y]| slack(row, [*x, *y, 0]) >= 0)
        });
        let cross = |a: [i128; 2], b: [i128; 2]| a[0] * b[1] - a[1] * b[0];
        let in_cone = |d: [i128; 2]| {
            rays.iter().any(|&r| cross(r, d) == 0 && r[0] * d[0] + r[1] * d[1] > 0)
                || rays
                    .iter()
                    .any(|&r| rays.iter().any(|&s| cross(r, s) > 0 && cross(d, s) >= 0 && cross(r, d) >= 0))
        };
        let is_listed = |vertex: &[i128; 3]| {
            points
                .iter()
                .any(|p| p[0] * vertex[2] == vertex[0] * p[2] && p[1] * vertex[2] == vertex[1] * p[2])
        };
        // Without a vertex, each boundary line of the set has a point.
        let is_reached = |&row: &Row| {
            let [a, b, c] = row;
            let foot = [a * c, b * c, a * a + b * b];
            [a, b] == [0, 0]
                || rows.iter().any(|&other| slack(other, foot) < 0)
                || points.iter().any(|&point| slack(row, point) == 0)
        };
        let opposite = |[x, y]: [i128; 2]| [-x, -y];
        are_inside
            && !points.is_empty()
            && answer.vertices.iter().all(|(vertex, _)| is_listed(vertex))
            && answer.rays.iter().all(|&ray| in_cone(ray))
            && answer.lines.iter().all(|&line| in_cone(line) && in_cone(opposite(line)))
            && (answer.lines.is_empty() || rows.iter().all(is_reached))
            && self.ends.iter().all(|end| is_end(end, &points, &rays))
    }
}

/// Returns whether an end is that of a set of these points and rays.
fn is_end(
    (which, form, bound): &(String, String, Option<String>),
    points: &[[i128; 3]],
    rays: &[[i128; 2]],
) -> bool {
    let place = usize::from(form == "snd");
    let sign = if which.ends_with("lowest") { 1 } else { -1 };
    let goes_on = rays.iter().any(|ray| ray[place] * sign < 0);
    match bound {
        None => goes_on,
        Some(bound) => {
            let [bound, _, w] = homogeneous(&[bound.clone(), "0".to_owned()]);
            let beyond = |p: &[i128; 3]| (p[place] * w - bound * p[2]) * sign;
            !goes_on && points.iter().all(|p| beyond(p) >= 0) && points.iter().any(|p| beyond(p) == 0)
        }
    }
}

fn number(text: &str) -> Rational {
    Reading::Decimal.read(text, &Limits::default()).unwrap()
}

/// A point as integers x, y, w with w > 0.
fn homogeneous(cells: &[String]) -> [i128; 3] {
    let ([x, y], w) = Rational::over_common_denominator([&number(&cells[0]), &number(&cells[1])]);
    [x, y, w].map(|own| own.to_i128().unwrap())
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

fn changed(rng: &mut ChaCha8Rng, text: &mut String) {
    let value = number(text);
    let value = match rng.random_range(0..7) {
        0 => &value + &Rational::one(),
        1 => &value - &Rational::one(),
        2 => &value * &Rational::from(2),
        3 => -value,
        4 => Rational::zero(),
        5 => &value + &Rational::ratio(1, 7),
        _ => &value - &Rational::ratio(1, 1000),
    };
    *text = value.to_string();
}

/// Changes one thing of a list of rows.
fn tampered(rng: &mut ChaCha8Rng, rows: &mut Vec<Vec<String>>) {
    if rows.is_empty() {
        return;
    }
    let (one, other) = (rng.random_range(0..rows.len()), rng.random_range(0..rows.len()));
    match rng.random_range(0..10) {
        0 => drop(rows.remove(one)),
        1 => rows.insert(other, rows[one].clone()),
        2 => rows.swap(one, other),
        _ => {
            let cell = rng.random_range(0..rows[one].len());
            changed(rng, &mut rows[one][cell]);
        }
    }
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
            match &mut forged.ends[end].2 {
                Some(bound) => changed(rng, bound),
                None => forged.ends[end].0 = "no_highest".to_owned(),
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
        let text = kernel_half_planes(&system, &polyhedron, None, Theory::Installed).unwrap();
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
